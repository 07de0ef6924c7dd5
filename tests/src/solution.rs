//! A solved model: what a run computes before it is reduced to tables.

use stickslip::model::{Model, ModelBodyKind};
use stickslip::run::{self, Solved};
use stickslip::scene::Scene;
use stickslip_contact::StepRecord;
use stickslip_fem_core::ElasticBody;
use stickslip_fem_core::stress::ElasticField;

/// A model and the history that it went through.
#[derive(Debug)]
pub struct Solution {
    /// Bodies, pairs, loads.
    pub model: Model,
    /// Operators and accepted steps.
    pub solved: Solved,
}

impl Solution {
    /// Builds and solves the model of `scene` with the scene's own solver.
    pub fn of(scene: &Scene) -> Self {
        let model =
            Model::build(scene).unwrap_or_else(|error| panic!("{error} in\n{}", scene.resolved()));
        let solver = run::solver(scene.analysis.solver);
        let solved = run::solve(&model, solver.as_ref(), &mut |_| {})
            .unwrap_or_else(|error| panic!("{error} in\n{}", scene.resolved()));
        Self { model, solved }
    }

    /// The accepted steps.
    pub fn records(&self) -> &[StepRecord] {
        &self.solved.records
    }

    /// Index of the body `name`.
    pub fn body(&self, name: &str) -> usize {
        let found = self.model.bodies.iter().position(|body| body.name == name);
        found.unwrap_or_else(|| panic!("no body '{name}'"))
    }

    /// The elastic body with this index, if it is elastic.
    pub fn elastic(&self, body: usize) -> Option<&ElasticBody> {
        match &self.model.bodies[body].kind {
            ModelBodyKind::Elastic(elastic) => Some(elastic),
            ModelBodyKind::Rigid(_) => None,
        }
    }

    /// Contact forces `[N]` on the contact points of a body, interleaved, in the order of its interface.
    pub fn contact_forces(&self, body: usize, record: &StepRecord) -> Vec<f64> {
        self.solved.forces_on_body(record, body)
    }

    /// Displacements of all nodes of an elastic body `[mm]`, interleaved.
    pub fn displacement(&self, body: usize, record: &StepRecord) -> Vec<f64> {
        let condensed = self.solved.operators[body]
            .elastic()
            .expect("an elastic body");
        let motions = record
            .state
            .rigid
            .rows_range(self.solved.interface.body_modes(body));
        condensed.displacements(
            &self.contact_forces(body, record),
            &record.state.multipliers,
            motions.as_slice(),
        )
    }

    /// Stresses at the nodes of an elastic body `[MPa]` by patch recovery.
    pub fn nodal_stress(&self, body: usize, record: &StepRecord) -> Vec<[f64; 3]> {
        let elastic = self.elastic(body).expect("an elastic body");
        let materials: Vec<_> = elastic.materials().iter().map(AsRef::as_ref).collect();
        let displacement = self.displacement(body, record);
        ElasticField::new(elastic.mesh(), &materials, &displacement, None)
            .expect("one material per block and two displacements per node")
            .patch_recovery()
            .averaged()
    }
}
