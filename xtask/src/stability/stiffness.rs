//! Study 7: bodies of very different stiffness, and nearly incompressible ones.

use std::f64::consts::PI;

use stickslip_fem_core::mesh::ElementKind;
use stickslip_report::axis::Axis;
use stickslip_report::chart::{LineChart, Panels, Series, SeriesStyle};

use super::history::Stages;
use super::joint::{Joint, set};
use super::methods::{CHAIN, methods};
use super::outcome::{Outcome, regularised};
use super::picture::{Legend, map, power};
use super::row::{Row, csv, element_name};
use super::{Context, Findings, Study, Trouble};

pub(super) const STUDY: Study = Study {
    name: "07-stiffness",
    title: "Stiffness ratio and incompressibility",
    varied: "Young's modulus of the cylinder over the block's from 10⁻⁸ to 10⁸; Poisson's ratio of both towards 0.5 in plane \
             strain, 1 − 2ν from 0.4 to 10⁻⁸; the load always for the same contact by Hertz's formula",
    expectation: "Every ratio is solved, and the answer stays Hertz's. Towards incompressibility fully integrated elements lock, \
                  linear ones soon and quadratic ones late.",
    run,
};

const RATIO: &str = "stiffness ratio, friction 0.3";
const HERTZ: &str = "stiffness ratio against Hertz, frictionless";
const LOCKING: &str = "incompressibility against Hertz";
const YOUNG: f64 = 73_100.0;
const POISSON: f64 = 0.33;
const RADIUS: f64 = 50.0;
/// Half-width of contact by Hertz `[mm]`.
const HALF_WIDTH: f64 = 0.88;
const ELEMENTS: [ElementKind; 5] = [
    ElementKind::T3,
    ElementKind::Q4,
    ElementKind::T6,
    ElementKind::Q8,
    ElementKind::Q9,
];

/// Two materials: Young's moduli `[MPa]` and Poisson's ratios of cylinder and block.
#[derive(Clone, Copy)]
struct Materials {
    young: [f64; 2],
    poisson: f64,
}

impl Materials {
    /// 1/E* = Σ (1 − ν²)/E.
    fn reduced_modulus(&self) -> f64 {
        let share = 1.0 - self.poisson * self.poisson;
        1.0 / (share / self.young[0] + share / self.young[1])
    }

    /// P = π E* a²/(4R) per mm of thickness.
    fn load(&self) -> f64 {
        PI * self.reduced_modulus() * HALF_WIDTH * HALF_WIDTH / (4.0 * RADIUS)
    }

    /// p₀ = 2P/(πa).
    fn peak(&self) -> f64 {
        2.0 * self.load() / (PI * HALF_WIDTH)
    }

    fn joint(&self, element: ElementKind, spacing: &str, mu: f64) -> Result<Joint, Trouble> {
        let load = self.load();
        let steps: Vec<String> = [0.1, 0.5, 1.0, 0.4]
            .map(|share| format!("\"{:e} N\"", share * load))
            .to_vec();
        let material = |young: f64| {
            format!(
                "{{ isotropic = {{ young = \"{young:e} MPa\", poisson = {} }} }}",
                self.poisson
            )
        };
        Joint::of_scene(
            "hertz-cylinder",
            &set(&[
                ("materials.aluminium", material(self.young[1])),
                ("materials.other", material(self.young[0])),
                ("bodies.upper.material", "other".into()),
                ("mesh.element", element_name(element).into()),
                ("mesh.spacing", spacing.into()),
                ("contacts.0.friction.coulomb.mu", mu.to_string()),
                ("loads.0.force.steps", format!("[{}]", steps.join(", "))),
            ]),
        )
    }

    /// Relative error of the peak pressure at the full load.
    fn error(&self, element: ElementKind, spacing: &str) -> Result<Option<f64>, Trouble> {
        let joint = self.joint(element, spacing, 0.0)?;
        let problem = joint.problem()?;
        let stages = Stages::follow(&problem, &joint.loads[..3]);
        let answer = stages.list.get(2).and_then(|stage| stage.answer.as_ref());
        Ok(answer.map(|trial| {
            let pressure = |k: usize| trial.forces[2 * k] / problem.points()[k].area;
            let peak = (0..problem.points().len())
                .map(pressure)
                .fold(0.0, f64::max);
            (peak / self.peak() - 1.0).abs()
        }))
    }
}

fn run(context: &Context) -> Result<Findings, Trouble> {
    let spacing = context.sized("0.2 mm", "0.08 mm");
    let exponents: Vec<i32> = (-8..=8).step_by(context.sized(4, 1)).collect();
    let mut rows = context.rows_of(&exponents, |&exponent| {
        let ratio = 10.0_f64.powi(exponent);
        let materials = Materials {
            young: [ratio * YOUNG, YOUNG],
            poisson: POISSON,
        };
        let joint = materials.joint(ElementKind::Q8, context.sized("0.4 mm", "0.16 mm"), 0.3)?;
        let mut rows =
            Stages::follow(&joint.problem()?, &joint.loads).rows(RATIO, ratio, &methods());
        for element in [ElementKind::Q4, ElementKind::Q8] {
            rows.push(row(
                HERTZ,
                ratio,
                element,
                materials.error(element, spacing)?,
            ));
        }
        Ok(rows)
    })?;
    let all = [
        0.4, 0.2, 0.1, 0.03, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8,
    ];
    let remainders: &[f64] = context.sized(&[0.4, 1e-2, 1e-6], &all);
    let jobs: Vec<(f64, ElementKind)> = ELEMENTS
        .iter()
        .flat_map(|&element| {
            remainders
                .iter()
                .map(move |&remainder| (remainder, element))
        })
        .collect();
    let locking = context.rows_of(&jobs, |&(remainder, element)| {
        let materials = Materials {
            young: [YOUNG; 2],
            poisson: 0.5 * (1.0 - remainder),
        };
        Ok(vec![row(
            LOCKING,
            remainder,
            element,
            materials.error(element, spacing)?,
        )])
    })?;
    rows.sort_by_key(|row| row.case == HERTZ);
    let picture = map(
        &rows,
        &Legend {
            title: "Stiffness ratio from 10⁻⁸ to 10⁸",
            subtitle: "Cylinder on a block, pressed in three steps and half unloaded.",
            varied: "Young's modulus of the cylinder over the block's [1]",
            label: &power,
            dividers: &[],
        },
    )?;
    rows.extend(locking);
    let chart = curves(&rows)?;
    Ok(Findings {
        remarks: remarks(&rows),
        tables: vec![("", csv("value", &rows))],
        pictures: vec![
            (
                "",
                picture,
                "Outcome of each method over the stiffness ratio".into(),
            ),
            (
                "-locking",
                chart,
                "Error of the peak pressure over stiffness ratio and compressibility".into(),
            ),
        ],
        rows,
        ..Findings::default()
    })
}

fn row(case: &str, value: f64, element: ElementKind, error: Option<f64>) -> Row {
    Row {
        case: case.into(),
        value,
        method: element_name(element),
        outcome: error.map_or(Outcome::Unresolved, |error| regularised(Some(error), error)),
        solved: usize::from(error.is_some()),
        error,
        ..Row::default()
    }
}

/// Width of a panel `[px]`, and its aspect.
const PANEL: f64 = 480.0;
const ASPECT: f64 = 0.8;

fn curves(rows: &[Row]) -> Result<stickslip_report::svg::Svg, Trouble> {
    let error = || Axis::log("error of the peak pressure against Hertz [1]");
    let chart = |title: &str, case: &str, x: Axis| {
        let mut chart = LineChart::new(title, x, error()).size(PANEL, ASPECT);
        for element in ELEMENTS {
            let own = rows
                .iter()
                .filter(|row| row.case == case && row.method == element_name(element));
            let points: Vec<[f64; 2]> = own
                .filter_map(|row| Some([row.value, row.error?]))
                .collect();
            chart = chart.with(Series::new(element_name(element), points).style(SeriesStyle::Both));
        }
        chart
    };
    let ratio = Axis::log("Young's modulus of the cylinder over the block's [1]");
    let remainder = Axis::log("1 − 2ν, plane strain [1]");
    let charts = vec![
        chart("Towards incompressibility", LOCKING, remainder),
        chart("Stiffness ratio", HERTZ, ratio),
    ];
    Ok(
        Panels::new("Stiffness ratio and incompressibility", 2, charts)
            .common_legend()
            .render()?,
    )
}

fn remarks(rows: &[Row]) -> Vec<String> {
    let hertz = rows
        .iter()
        .filter(|row| row.case == HERTZ && row.method == element_name(ElementKind::Q8));
    let worst = hertz.filter_map(|row| row.error).fold(0.0, f64::max);
    let mut remarks = vec![format!(
        "With Q8 the peak pressure is within {:.2} % of Hertz's at every ratio.",
        100.0 * worst
    )];
    for element in ELEMENTS {
        let mut own: Vec<&Row> = rows
            .iter()
            .filter(|row| row.case == LOCKING && row.method == element_name(element))
            .collect();
        own.sort_by(|a, b| b.value.total_cmp(&a.value));
        let useful = own
            .iter()
            .take_while(|row| row.error.is_some_and(|error| error <= 0.05))
            .last()
            .map(|row| row.value);
        if let (Some(first), Some(last)) = (
            own.first().and_then(|row| row.error),
            own.last().and_then(|row| row.error),
        ) {
            remarks.push(format!(
                "{}: off by {:.1} % at ν = 0.3 and by {:.1} % at 1 − 2ν = {}{}.",
                element_name(element),
                100.0 * first,
                100.0 * last,
                power(own.last().map_or(0.0, |row| row.value)),
                useful.map_or_else(String::new, |remainder| format!(
                    "; within 5 % down to {}",
                    power(remainder)
                ))
            ));
        }
    }
    let chain = rows
        .iter()
        .filter(|row| row.method == CHAIN && !row.outcome.is_answer())
        .count();
    if chain > 0 {
        remarks.push(format!(
            "The default chain leaves {chain} ratios without an answer."
        ));
    }
    remarks
}
