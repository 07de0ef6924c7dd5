//! Displacements and stresses inside the bodies, for the steps that ask for them.

use stickslip_contact::StepRecord;
use stickslip_fem_core::material::Material;
use stickslip_fem_core::stress::{ElasticField, StressError};

use super::Solved;
use crate::model::Model;
use crate::results::BodyFields;

/// Displacements of the bodies of one step; empty for a body that nothing asks for.
#[derive(Debug, Default)]
pub(super) struct Recovered {
    pub(super) displacement: Vec<Vec<f64>>,
    pub(super) multipliers: Vec<f64>,
    /// Largest unbalanced force on a free node relative to the largest force on the body.
    pub(super) imbalance: f64,
}

/// Recovers displacements where fields or an edge without contact want them: one pair of triangular solves per body.
pub(super) fn recover(
    model: &Model,
    solved: &Solved,
    record: &StepRecord,
    everywhere: bool,
) -> Recovered {
    let mut recovered = Recovered {
        multipliers: record.state.multipliers.clone(),
        ..Recovered::default()
    };
    for (index, operator) in solved.operators.iter().enumerate() {
        let asked = everywhere
            || model
                .edges
                .iter()
                .any(|edge| edge.body == index && edge.pair.is_none());
        let Some(body) = operator.elastic().filter(|_| asked) else {
            recovered.displacement.push(Vec::new());
            continue;
        };
        let forces = solved.problem.forces_on_body(
            index,
            body.interface_nodes().len(),
            &record.state.forces,
        );
        let motions = record
            .state
            .rigid
            .rows_range(solved.problem.body_modes(index));
        let u = body.displacements(&forces, &record.state.multipliers, motions.as_slice());
        let residual = body.residual_forces(&u, &forces, &record.state.multipliers);
        recovered.imbalance = recovered.imbalance.max(body.relative_imbalance(
            &residual,
            &forces,
            &record.state.multipliers,
        ));
        recovered.displacement.push(u);
    }
    recovered
}

/// Fields of all bodies that were recovered, with stresses by patch recovery.
pub(super) fn with_stresses(
    model: &Model,
    recovered: &Recovered,
) -> Result<Vec<BodyFields>, StressError> {
    let mut fields = Vec::new();
    for (index, body) in model.bodies.iter().enumerate() {
        let (crate::model::ModelBodyKind::Elastic(elastic), false) =
            (&body.kind, recovered.displacement[index].is_empty())
        else {
            continue;
        };
        let materials: Vec<&dyn Material> = elastic.materials().iter().map(AsRef::as_ref).collect();
        let strain = elastic.initial_strain(&recovered.multipliers);
        let displacement = recovered.displacement[index].clone();
        let initial = (!strain.is_empty()).then_some(strain.as_slice());
        let stress = ElasticField::new(elastic.mesh(), &materials, &displacement, initial)?
            .patch_recovery()
            .averaged();
        fields.push(BodyFields {
            body: index,
            displacement,
            stress,
        });
    }
    Ok(fields)
}
