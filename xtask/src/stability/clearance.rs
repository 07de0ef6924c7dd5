//! Study 3: the clearance between pin and hole, from interference through a neat fit to a tenth of the radius.

use stickslip_report::axis::Axis;
use stickslip_report::chart::{LineChart, Series, SeriesStyle};

use super::history::Stages;
use super::joint::{Joint, set};
use super::methods::{CHAIN, methods};
use super::outcome::{Outcome, regularised};
use super::picture::{Legend, map, power};
use super::row::{Row, csv};
use super::{Context, Findings, Study, Trouble};

pub(super) const STUDY: Study = Study {
    name: "03-clearance",
    title: "Clearance",
    varied: "clearance over radius c/R from −10⁻³ (interference) through 0 and 10⁻⁸ to 10⁻¹, pin in a plate with friction 0.25",
    expectation: "The answer changes continuously through the neat fit, however small the clearance. A gap taken from the nodes of \
                  the mesh instead of the true circles is wrong by about c²/R, which shows only for large clearances where nodes \
                  face each other.",
    run,
};

const HOLE_IN: f64 = 0.375;
const METHODS: &str = "gap of the true circles";
const GAPS: &str = "peak pressure against four times finer mesh";
const KINDS: [(&str, &str); 3] = [
    ("gap of the circles", "exact"),
    ("linearised gap", "linearised"),
    ("gap between nodes", "faceted"),
];

fn run(context: &Context) -> Result<Findings, Trouble> {
    let values: &[f64] = context.sized(
        &[-1e-3, 0.0, 1e-8, 1e-4, 1e-2],
        &[
            -1e-3, -1e-4, -1e-5, -1e-6, -1e-8, 0.0, 1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 1e-1,
        ],
    );
    let [coarse, fine] = context.sized(["9 deg", "4.5 deg"], ["4.5 deg", "1.125 deg"]);
    let mut rows = context.rows_of(values, |&clearance| {
        let joint = joint(clearance, coarse, "exact")?;
        let stages = Stages::follow(&joint.problem()?, &joint.loads);
        let mut rows = stages.rows(METHODS, clearance, &methods());
        let reference = peaks(clearance, fine, "exact")?;
        for (name, kind) in KINDS {
            let error = peaks(clearance, coarse, kind)?
                .zip(reference)
                .map(|(own, fine)| (own / fine - 1.0).abs());
            rows.push(Row {
                case: GAPS.into(),
                value: clearance,
                method: name,
                outcome: error.map_or(Outcome::Unresolved, |error| regularised(Some(error), error)),
                solved: usize::from(error.is_some()),
                error,
                ..Row::default()
            });
        }
        Ok(rows)
    })?;
    rows.sort_by_key(|row| row.case == GAPS);
    let picture = map(
        &rows,
        &Legend {
            title: "Clearance from interference to a tenth of the radius",
            subtitle: "Pin in a plate, friction 0.25, loaded and unloaded in 14 steps.",
            varied: "clearance over radius c/R [1]",
            label: &power,
            dividers: &[],
        },
    )?;
    let chart = chart(&rows)?;
    let error = |kind: &str, at: f64| {
        let own = rows
            .iter()
            .find(|row| row.method == kind && row.value == at);
        100.0 * own.and_then(|row| row.error).unwrap_or(f64::NAN)
    };
    let largest = values[values.len() - 1];
    let remarks = vec![
        format!(
            "At c/R = {} the peak pressure at 1240 lbf is off by {:.2} % with the gap of the circles, {:.2} % with the linearised one \
         and {:.2} % with that between nodes; at 10⁻⁴ by {:.2} %, {:.2} % and {:.2} %.",
            power(largest),
            error(KINDS[0].0, largest),
            error(KINDS[1].0, largest),
            error(KINDS[2].0, largest),
            error(KINDS[0].0, 1e-4),
            error(KINDS[1].0, 1e-4),
            error(KINDS[2].0, 1e-4),
        ),
        neat_fit(&rows),
    ];
    Ok(Findings {
        tables: vec![("", csv("clearance_over_radius", &rows))],
        pictures: vec![
            (
                "",
                picture,
                "Outcome of each method over the clearance".into(),
            ),
            (
                "-gap",
                chart,
                "Error of the peak pressure over the clearance for three gaps".into(),
            ),
        ],
        remarks,
        rows,
        ..Findings::default()
    })
}

fn joint(clearance: f64, spacing: &str, gap: &str) -> Result<Joint, Trouble> {
    let radius = HOLE_IN * (1.0 - clearance);
    Joint::of_scene(
        "pin-benchmark",
        &set(&[
            ("mesh.spacing", spacing.into()),
            (
                "bodies.pin.shape.disk.radius",
                format!("\"{radius:.17} in\""),
            ),
            ("contacts.0.interference", (clearance < 0.0).to_string()),
            ("contacts.0.gap", format!("\"{gap}\"")),
        ]),
    )
}

/// Largest pressure at 1240 lbf while loading; `None` if that is not reached.
fn peaks(clearance: f64, spacing: &str, gap: &str) -> Result<Option<f64>, Trouble> {
    let joint = joint(clearance, spacing, gap)?;
    let problem = joint.problem()?;
    let stages = Stages::follow(&problem, &joint.loads[..4]);
    let answer = stages.list.get(3).and_then(|stage| stage.answer.as_ref());
    Ok(answer.map(|trial| {
        let pressure = |k: usize| trial.forces[2 * k] / problem.points()[k].area;
        (0..problem.points().len())
            .map(pressure)
            .fold(0.0, f64::max)
    }))
}

fn neat_fit(rows: &[Row]) -> String {
    let near = |row: &&Row| row.case == METHODS && row.value.abs() <= 1e-6 && row.method != CHAIN;
    let failed: Vec<&str> = rows
        .iter()
        .filter(near)
        .filter(|row| {
            matches!(
                row.outcome,
                Outcome::Cycled | Outcome::Stopped | Outcome::Wrong
            )
        })
        .map(|row| row.method)
        .collect();
    let mut names = failed.clone();
    names.dedup();
    names.sort_unstable();
    names.dedup();
    if names.is_empty() {
        "At and near the neat fit no method fails.".into()
    } else {
        format!(
            "At and near the neat fit (|c|/R ≤ 10⁻⁶) fail: {}.",
            names.join(", ")
        )
    }
}

fn chart(rows: &[Row]) -> Result<stickslip_report::svg::Svg, Trouble> {
    let mut chart = LineChart::new(
        "What the gap's geometry costs",
        Axis::log("clearance over radius c/R [1]"),
        Axis::log("error of the peak pressure at 1240 lbf [1]"),
    )
    .subtitle("Against the true circles on a four times finer mesh. Where nodes face each other, the linearised gap is that between them.");
    for (name, _) in KINDS {
        let own = rows
            .iter()
            .filter(|row| row.method == name && row.value > 0.0);
        let points = own
            .filter_map(|row| Some([row.value, row.error?]))
            .collect();
        chart = chart.with(Series::new(name, points).style(SeriesStyle::Both));
    }
    Ok(chart.render()?)
}
