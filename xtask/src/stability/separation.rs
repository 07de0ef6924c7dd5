//! Study 4: contact that begins, ends and begins again.

use super::context::{Context, Found};
use super::history::Stages;
use super::joint::{Joint, set};
use super::judge::judge;
use super::methods::{CHAIN, methods};
use super::outcome::Outcome;
use super::row::Row;
use crate::publish::TaskError;

/// Loads of the plate `[lbf]`: first contact, growth, release, the other side, and back.
const PULLS: [f64; 12] = [
    1.0, 20.0, 520.0, 1240.0, 210.0, 0.0, -20.0, -1240.0, -40.0, 0.0, 20.0, 1240.0,
];
/// Loads of the cylinder `[N]`.
const PRESSES: [f64; 8] = [1.0, 50.0, 500.0, 40.0, 0.0, 50.0, 500.0, -1.0];

pub(super) fn run(context: &Context) -> Result<Found, TaskError> {
    let spacing = context.sized("18 deg", "9 deg");
    let steps = |loads: &[f64], unit: &str| {
        let steps: Vec<String> = loads
            .iter()
            .map(|load| format!("\"{load} {unit}\""))
            .collect();
        ("loads.0.force.steps", format!("[{}]", steps.join(", ")))
    };
    let friction = |mu: f64| ("contacts.0.friction.coulomb.mu", mu.to_string());
    let pin = |model: &str, mu: f64| {
        let (model, spacing) = (
            ("analysis.model", model.into()),
            ("mesh.spacing", spacing.into()),
        );
        let changes = set(&[spacing, model, friction(mu), steps(&PULLS, "lbf")]);
        Joint::of_scene("pin-benchmark", &changes)
    };
    let cylinder = |mu: f64| {
        let spacing = ("mesh.spacing", context.sized("0.4 mm", "0.1 mm").into());
        let changes = set(&[spacing, friction(mu), steps(&PRESSES, "N")]);
        Joint::of_scene("hertz-cylinder", &changes)
    };
    let cases = [
        ("floating plate, whole, frictionless", pin("whole", 0.0)?),
        ("floating plate, whole, friction 0.25", pin("whole", 0.25)?),
        ("floating plate, half, friction 0.25", pin("half", 0.25)?),
        ("floating cylinder, frictionless", cylinder(0.0)?),
        ("floating cylinder, friction 0.4", cylinder(0.4)?),
    ];
    let rows = context.rows_of(&cases, |(name, joint)| {
        let stages = Stages::follow(&joint.problem()?, &joint.loads);
        let methods = methods();
        let mut rows = Vec::new();
        for (index, stage) in stages.list.iter().enumerate() {
            for method in &methods {
                let row = judge(method, &stage.given, stage.answer.as_ref());
                let step = (index + 1) as f64;
                rows.push(Row::of_steps(name, step, stages.coercive, &[row]));
            }
        }
        Ok(rows)
    })?;
    let certified = |row: &&Row| row.method == CHAIN && row.outcome == Outcome::Certified;
    let pulled = |row: &&Row| row.case.contains("cylinder") && row.value as usize == PRESSES.len();
    let proofs = rows.iter().filter(certified).filter(pulled).count();
    let others = rows.iter().filter(certified).count() - proofs;
    let mut failures = Vec::new();
    if (proofs, others) != (2, 0) {
        failures.push(format!(
            "pulling the cylinder off was proved impossible in {proofs} of 2 cases, and {others} steps that can be balanced"
        ));
    }
    Ok(Found {
        failures,
        ..Found::of("step", rows)
    })
}
