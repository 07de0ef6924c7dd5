//! Displacements inside the bodies, by which every step's balance is audited, and stresses for the steps that ask for them.

use stickslip_fem_core::body::{BodyBalance, BodyLoad};
use stickslip_fem_core::material::Material;
use stickslip_fem_core::stress::{ElasticField, StressError};

use super::Solved;
use crate::model::Model;
use crate::results::BodyFields;
use crate::scene::Scene;
use crate::scene::schema::LoadKind;

/// Displacements and balance of all bodies at the end of one load step.
#[derive(Debug, Default)]
pub(super) struct Recovered {
    /// Displacements per body, interleaved; empty for a rigid one.
    pub(super) displacement: Vec<Vec<f64>>,
    /// Balance per body; `None` for a rigid one.
    pub(super) balance: Vec<Option<BodyBalance>>,
    pub(super) multipliers: Vec<f64>,
}

impl Recovered {
    /// The worst unbalanced force or moment of any body.
    pub(super) fn imbalance(&self) -> f64 {
        let bodies = self.balance.iter().flatten();
        bodies.fold(0.0, |worst: f64, body| {
            worst.max(body.force).max(body.moment).max(body.nodal)
        })
    }
}

/// Recovers the displacements of all bodies at the end of every load step, and audits their balance: one pass over each
/// body's factor and one over its cells, for all steps together.
pub(super) fn recover(solved: &Solved) -> Vec<Recovered> {
    let records = &solved.records;
    let mut all: Vec<Recovered> = records
        .iter()
        .map(|record| Recovered {
            multipliers: record.state.multipliers.clone(),
            ..Recovered::default()
        })
        .collect();
    for (index, operator) in solved.operators.iter().enumerate() {
        let Some(body) = operator.elastic() else {
            for step in &mut all {
                step.displacement.push(Vec::new());
                step.balance.push(None);
            }
            continue;
        };
        let count = body.interface_nodes().len();
        let modes = solved.problem.body_modes(index);
        let forces: Vec<Vec<f64>> = records
            .iter()
            .map(|record| {
                solved
                    .problem
                    .forces_on_body(index, count, &record.state.forces)
            })
            .collect();
        let states: Vec<BodyLoad<'_>> = records
            .iter()
            .zip(&forces)
            .map(|(record, forces)| BodyLoad {
                forces,
                multipliers: &record.state.multipliers,
                motions: &record.state.rigid.as_slice()[modes.clone()],
            })
            .collect();
        let displacements = body.displacements_of(&states);
        let residuals = body.residual_forces_of(&displacements, &states);
        let balances = body.balances_of(&residuals, &states);
        for (step, (u, balance)) in all.iter_mut().zip(displacements.into_iter().zip(balances)) {
            step.displacement.push(u);
            step.balance.push(Some(balance));
        }
    }
    all
}

/// Fields of all bodies that were recovered, with stresses by patch recovery.
pub(super) fn with_stresses(
    scene: &Scene,
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
        let nodal =
            ElasticField::new(elastic.mesh(), &materials, &displacement, initial)?.patch_recovery();
        let heating = heating(scene, &body.name, &recovered.multipliers);
        fields.push(BodyFields {
            body: index,
            stress: nodal.averaged(),
            thickness_stress: nodal
                .averaged_of(|block, stress| materials[block].thickness_stress(stress, heating)),
            displacement,
        });
    }
    Ok(fields)
}

/// Temperature rise `[K]` of body `name`; the first load cases are the scene's loads.
pub(super) fn heating(scene: &Scene, name: &str, multipliers: &[f64]) -> f64 {
    let loads = scene.loads.iter().zip(multipliers);
    let heats = loads.filter(
        |(load, _)| matches!(&load.kind, LoadKind::Temperature { body, .. } if body == name),
    );
    heats.map(|(_, degrees)| degrees).sum()
}
