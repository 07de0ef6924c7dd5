//! Displacements inside the bodies, by which every step's balance is audited, and stresses for the steps that ask for them.

use stickslip_contact::StepRecord;
use stickslip_fem_core::body::{BodyBalance, BodyLoad};
use stickslip_fem_core::material::Material;
use stickslip_fem_core::stress::{ElasticField, StressError};

use super::{Operator, Solved};
use crate::model::Model;
use crate::results::BodyFields;
use crate::scene::Scene;
use crate::scene::schema::LoadKind;

/// Displacements and balance of all bodies at the end of one load step.
#[derive(Debug, Default)]
pub(super) struct Recovered {
    /// Displacements per body, interleaved, without the free rigid motions, which make no strain and beside which those that do
    /// may be rounding; empty for a rigid body.
    pub(super) displacement: Vec<Vec<f64>>,
    /// Amounts of each body's free rigid motions.
    motions: Vec<Vec<f64>>,
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
            motions: motions(solved, record),
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
        let forces = forces_on(solved, index, body.interface_nodes().len());
        let states = loads_on(solved, &forces);
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

/// Recovers the displacements of the bodies with the indices `wanted` alone, without an audit.
pub(super) fn recover_some(solved: &Solved, wanted: &[usize]) -> Vec<Recovered> {
    let records = &solved.records;
    let mut all: Vec<Recovered> = records
        .iter()
        .map(|record| Recovered {
            multipliers: record.state.multipliers.clone(),
            motions: motions(solved, record),
            displacement: vec![Vec::new(); solved.operators.len()],
            balance: vec![None; solved.operators.len()],
        })
        .collect();
    for &index in wanted {
        let Some(body) = solved.operators.get(index).and_then(Operator::elastic) else {
            continue;
        };
        let forces = forces_on(solved, index, body.interface_nodes().len());
        let displacements = body.displacements_of(&loads_on(solved, &forces));
        for (step, u) in all.iter_mut().zip(displacements) {
            step.displacement[index] = u;
        }
    }
    all
}

/// Contact forces on the body `index` with `count` contact points, for each load step.
fn forces_on(solved: &Solved, index: usize, count: usize) -> Vec<Vec<f64>> {
    let problem = &solved.problem;
    let of_step = |record: &StepRecord| problem.forces_on_body(index, count, &record.state.forces);
    solved.records.iter().map(of_step).collect()
}

/// Amounts of the rigid motions of each body at the end of a load step.
fn motions(solved: &Solved, record: &StepRecord) -> Vec<Vec<f64>> {
    let amounts = record.state.rigid.as_slice();
    let of_body = |body| amounts[solved.problem.body_modes(body)].to_vec();
    (0..solved.operators.len()).map(of_body).collect()
}

/// Everything that acts on the body `index` and strains it, for each load step.
fn loads_on<'a>(solved: &'a Solved, forces: &'a [Vec<f64>]) -> Vec<BodyLoad<'a>> {
    let of_step = |(record, forces): (&'a StepRecord, &'a Vec<f64>)| BodyLoad {
        forces,
        multipliers: &record.state.multipliers,
        motions: &[],
    };
    solved.records.iter().zip(forces).map(of_step).collect()
}

/// Displacements of the elastic body `index` with its rigid motions, interleaved; empty where they were not recovered.
pub(super) fn moved(operators: &[Operator], recovered: &Recovered, index: usize) -> Vec<f64> {
    let mut displacement = recovered.displacement[index].clone();
    if let Some(body) = operators[index].elastic() {
        let rigid = body.rigid_displacements(&recovered.motions[index]);
        let both = displacement.iter_mut().zip(rigid);
        both.for_each(|(sum, part)| *sum += part);
    }
    displacement
}

/// Fields of all bodies that were recovered, with stresses by patch recovery.
pub(super) fn with_stresses(
    scene: &Scene,
    model: &Model,
    operators: &[Operator],
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
        let initial = (!strain.is_empty()).then_some(strain.as_slice());
        let strained = &recovered.displacement[index];
        let nodal =
            ElasticField::new(elastic.mesh(), &materials, strained, initial)?.patch_recovery();
        let heating = heating(scene, &body.name, &recovered.multipliers);
        fields.push(BodyFields {
            body: index,
            stress: nodal.averaged(),
            thickness_stress: nodal
                .averaged_of(|block, stress| materials[block].thickness_stress(stress, heating)),
            displacement: moved(operators, recovered, index),
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
