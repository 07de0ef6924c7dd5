//! Fields of bodies for pictures and files: displacements with rigid motions, stresses at nodes.

use stickslip_fem_core::material::Material;
use stickslip_fem_core::stress::{ElasticField, StressError};

use super::fields::Recovered;
use super::solved::{Operator, Solved};
use crate::model::{Model, ModelBodyKind};
use crate::results::BodyFields;

/// Displacements of the elastic body `index` with its rigid motions, interleaved; empty where they were not recovered.
pub(super) fn moved(
    model: &Model,
    operators: &[Operator],
    recovered: &Recovered,
    index: usize,
) -> Vec<f64> {
    let mut displacement = recovered.displacement[index].clone();
    let motions = &recovered.motions[index];
    let rigid = match (&operators[index], model.bodies[index].elastic()) {
        (Operator::Elastic(body), _) => body.rigid_displacements(motions),
        (Operator::Series(body), Some(own)) => {
            body.rigid_displacements(motions, own.mesh().nodes())
        }
        _ => Vec::new(),
    };
    let both = displacement.iter_mut().zip(rigid);
    both.for_each(|(sum, part)| *sum += part);
    displacement
}

/// Fields of all bodies that were recovered, with stresses by patch recovery.
pub(super) fn with_stresses(
    model: &Model,
    solved: &Solved,
    recovered: &Recovered,
    step: usize,
) -> Result<Vec<BodyFields>, StressError> {
    let operators = &solved.operators;
    let mut fields = Vec::new();
    for (index, body) in model.bodies.iter().enumerate() {
        let (ModelBodyKind::Elastic(elastic), false) =
            (&body.kind, recovered.displacement[index].is_empty())
        else {
            continue;
        };
        let materials: Vec<&dyn Material> = elastic.materials().iter().map(AsRef::as_ref).collect();
        if let Some(series) = operators[index].series() {
            let forces = solved.forces_on_body(&solved.records[step], index);
            let places = elastic.mesh().nodes();
            let stress = series.stresses(&solved.records[step], &forces, places);
            let heating = model.request.loads.heating(index, &recovered.multipliers);
            let across = |own: &[f64; 3]| materials[0].thickness_stress(*own, heating);
            fields.push(BodyFields {
                body: index,
                thickness_stress: stress.iter().map(across).collect(),
                stress,
                displacement: moved(model, operators, recovered, index),
            });
            continue;
        }
        let strain = elastic.initial_strain(&recovered.multipliers);
        let initial = (!strain.is_empty()).then_some(strain.as_slice());
        let strained = &recovered.displacement[index];
        let nodal =
            ElasticField::new(elastic.mesh(), &materials, strained, initial)?.patch_recovery();
        let heating = model.request.loads.heating(index, &recovered.multipliers);
        fields.push(BodyFields {
            body: index,
            stress: nodal.averaged(),
            thickness_stress: nodal
                .averaged_of(|block, stress| materials[block].thickness_stress(stress, heating)),
            displacement: moved(model, operators, recovered, index),
        });
    }
    Ok(fields)
}
