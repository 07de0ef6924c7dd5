//! Study 7: bodies of very different stiffness, and nearly incompressible ones.

use std::f64::consts::PI;

use stickslip_fem_core::mesh::ElementKind;

use super::context::{Context, ELEMENTS, Found};
use super::history::Stages;
use super::joint::{Joint, set};
use super::methods::methods;
use super::row::Row;
use crate::publish::TaskError;

const RATIO: &str = "stiffness ratio, friction 0.3";
const HERTZ: &str = "stiffness ratio against Hertz, frictionless";
const LOCKING: &str = "incompressibility against Hertz";
const YOUNG: f64 = 73_100.0;
const POISSON: f64 = 0.33;
const RADIUS: f64 = 50.0;
/// Half-width of contact by Hertz `[mm]`.
const HALF_WIDTH: f64 = 0.88;
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

    fn joint(&self, element: ElementKind, spacing: &str, mu: f64) -> Result<Joint, TaskError> {
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
        let changes = set(&[
            ("materials.aluminium", material(self.young[1])),
            ("materials.other", material(self.young[0])),
            ("bodies.upper.material", "other".into()),
            ("mesh.element", element.name().into()),
            ("mesh.spacing", spacing.into()),
            ("contacts.0.friction.coulomb.mu", mu.to_string()),
            ("loads.0.force.steps", format!("[{}]", steps.join(", "))),
        ]);
        Joint::of_scene("hertz-cylinder", &changes)
    }

    /// Relative error of the peak pressure at the full load.
    fn error(&self, element: ElementKind, spacing: &str) -> Result<Option<f64>, TaskError> {
        let joint = self.joint(element, spacing, 0.0)?;
        let stages = Stages::follow(&joint.problem()?, &joint.loads[..3]);
        let peak = stages.peak(2);
        Ok(peak.map(|peak| (peak / self.peak() - 1.0).abs()))
    }
}

pub(super) fn run(context: &Context) -> Result<Found, TaskError> {
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
            let error = materials.error(element, spacing)?;
            rows.push(Row::of_error(HERTZ, ratio, element.name(), error));
        }
        Ok(rows)
    })?;
    let all = [
        0.4, 0.2, 0.1, 0.03, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8,
    ];
    let remainders: &[f64] = context.sized(&[0.4, 1e-2, 1e-6], &all);
    let jobs = ELEMENTS.map(|element| remainders.iter().map(move |&own| (own, element)));
    let jobs: Vec<(f64, ElementKind)> = jobs.into_iter().flatten().collect();
    let locking = context.rows_of(&jobs, |&(remainder, element)| {
        let materials = Materials {
            young: [YOUNG; 2],
            poisson: 0.5 * (1.0 - remainder),
        };
        let error = materials.error(element, spacing)?;
        Ok(vec![Row::of_error(
            LOCKING,
            remainder,
            element.name(),
            error,
        )])
    })?;
    rows.sort_by_key(|row| row.case == HERTZ);
    rows.extend(locking);
    Ok(Found::of("value", rows))
}
