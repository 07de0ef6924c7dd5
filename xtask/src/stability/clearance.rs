//! Study 3: the clearance between pin and hole, from interference through a neat fit to a tenth of the radius.

use super::context::{Context, Found};
use super::history::Stages;
use super::joint::{Joint, set};
use super::methods::methods;
use super::row::Row;
use crate::publish::TaskError;

const HOLE_IN: f64 = 0.375;
const METHODS: &str = "gap of the true circles";
const GAPS: &str = "peak pressure against four times finer mesh";
const KINDS: [(&str, &str); 3] = [
    ("gap of the circles", "exact"),
    ("linearised gap", "linearised"),
    ("gap between nodes", "faceted"),
];

pub(super) fn run(context: &Context) -> Result<Found, TaskError> {
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
            rows.push(Row::of_error(GAPS, clearance, name, error));
        }
        Ok(rows)
    })?;
    rows.sort_by_key(|row| row.case == GAPS);
    Ok(Found::of("clearance_over_radius", rows))
}

fn joint(clearance: f64, spacing: &str, gap: &str) -> Result<Joint, TaskError> {
    let radius = HOLE_IN * (1.0 - clearance);
    let changes = set(&[
        ("mesh.spacing", spacing.into()),
        (
            "bodies.pin.shape.disk.radius",
            format!("\"{radius:.17} in\""),
        ),
        ("contacts.0.interference", (clearance < 0.0).to_string()),
        ("contacts.0.gap", format!("\"{gap}\"")),
    ]);
    Joint::of_scene("pin-benchmark", &changes)
}

/// Largest pressure at 1240 lbf while loading; `None` if that is not reached.
fn peaks(clearance: f64, spacing: &str, gap: &str) -> Result<Option<f64>, TaskError> {
    let joint = joint(clearance, spacing, gap)?;
    let problem = joint.problem()?;
    Ok(Stages::follow(&problem, &joint.loads[..4]).peak(3))
}
