//! What compliances in blocks leave out of an answer.

use nalgebra::DVector;
use stickslip_contact::StepRecord;

use super::fields::Recovered;
use super::solved::Solved;
use crate::results::BlockError;

/// The error of the step in which the compliances in blocks leave out most. Its tractions are the change of contact forces by
/// the displacements that are left out, with the statuses of the answer. These displacements are measured, against fields that are recovered
/// by the whole factor.
pub(super) fn error(solved: &Solved, recovered: &[Recovered]) -> Option<BlockError> {
    let ranks = (solved.operators.iter())
        .filter_map(|operator| Some(operator.interface().blocks()?.rank()));
    let rank = ranks.max()?;
    let size = |step: &Recovered| {
        let all = step.left_out.iter().flatten();
        all.fold(0.0, |most: f64, part| most.max(part.abs()))
    };
    let steps = recovered.iter().zip(&solved.records);
    let (step, record) = steps.max_by(|a, b| size(a.0).total_cmp(&size(b.0)))?;
    let motion = motion(solved, step);
    let change = solved.interface.traction_change(&record.state, &motion)?;
    let peak = peak_pressure(solved, record);
    Some(BlockError {
        rank,
        tractions: if peak > 0.0 { change / peak } else { 0.0 },
        displacement: size(step),
    })
}

/// Relative motion of the contact points by what is left out of the displacements of the bodies.
fn motion(solved: &Solved, step: &Recovered) -> DVector<f64> {
    let contacts = solved.interface.contacts();
    let mut motion = DVector::zeros(2 * contacts.points().len());
    for (body, left_out) in step.left_out.iter().enumerate() {
        if left_out.is_empty() {
            continue;
        }
        let left_out = DVector::from_column_slice(left_out);
        for row in contacts.body_rows(body) {
            let mut target = motion.fixed_rows_mut::<2>(2 * row.point);
            for (node, weight) in &row.terms {
                target += weight * left_out.fixed_rows::<2>(2 * node);
            }
        }
    }
    motion
}

fn peak_pressure(solved: &Solved, record: &StepRecord) -> f64 {
    let points = solved.interface.contacts().points().iter().enumerate();
    let pressures = points.map(|(k, point)| record.state.normal_force(k) / point.area);
    pressures.fold(0.0, f64::max)
}
