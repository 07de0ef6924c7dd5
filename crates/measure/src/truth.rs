//! The solution of a scene, as a synthetic experiment looks at it.

use std::sync::Arc;

use stickslip_fem_core::mesh::{Mesh, Point};
use stickslip_fem_core::parallel;
use stickslip_hybrid::region::locate::Locator;

use super::error::ExperimentError;
use stickslip_engine::model::Model;
use stickslip_engine::results::Results;
use stickslip_engine::run::{
    Progress, RunError, displacements_of, results_without_audit, solve, solver,
};
use stickslip_experiment::SpecimenScene;
use stickslip_scene::schema::FieldOutput;

/// A solved scene: what the specimen's edge carries, and how every point of it moves.
#[derive(Debug)]
pub struct Truth {
    /// Edges of all load steps; no fields.
    pub results: Results,
    mesh: Arc<Mesh>,
    /// One vector per load step, x and y of each node in turn `[mm]`.
    displacements: Vec<Vec<f64>>,
    half: bool,
}

impl Truth {
    /// Solves the scene of a specimen over all its load steps.
    ///
    /// # Errors
    /// [`ExperimentError::Run`].
    pub fn solve(
        own: &SpecimenScene,
        progress: &mut dyn FnMut(Progress),
    ) -> Result<Self, ExperimentError> {
        let mut scene = (*own.scene).clone();
        scene.failure = None;
        scene.output.fields = FieldOutput::None;
        let model = Model::build(&scene).map_err(RunError::from)?;
        let chain = solver(scene.analysis.solver);
        let solved = solve(&model, chain.as_ref(), progress)?;
        let missing = || ExperimentError::Missing {
            key: "specimen.body".to_owned(),
            what: format!("body '{}' is not an elastic body of the model", own.body),
            remedy: "name an elastic body".to_owned(),
        };
        let index = own.index().ok_or_else(missing)?;
        let elastic = solved.operators[index].elastic().ok_or_else(missing)?;
        let mesh = model.placed(&own.body, elastic.body().mesh());
        let mesh = mesh.map_err(RunError::from)?;
        let displacements = displacements_of(&model, &solved, index);
        let results = results_without_audit(&model, chain.as_ref(), solved, &[index])?;
        Ok(Self {
            results,
            mesh,
            displacements,
            half: model.half,
        })
    }

    /// Mesh of the specimen; the half y ≥ 0 where [`is_half`](Self::is_half) says so.
    pub fn mesh(&self) -> &Mesh {
        &self.mesh
    }

    /// Whether only the half y ≥ 0 was modelled.
    pub fn is_half(&self) -> bool {
        self.half
    }

    /// Displacements `[mm]` of the mesh's nodes at a load step, x and y of each in turn.
    pub fn displacements(&self, step: usize) -> &[f64] {
        self.displacements.get(step).map_or(&[], Vec::as_slice)
    }

    /// Where `places` `[mm]` lie in the mesh, for displacements of any load step.
    pub fn sampled(&self, places: &[Point]) -> Sampling {
        let locator = Locator::new(&self.mesh);
        let nodes = (0..self.mesh.element_count())
            .map(|cell| self.mesh.element(cell).1.len())
            .max()
            .unwrap_or(0);
        let mut weights = vec![0.0; nodes * places.len()];
        let mut cells = vec![OUTSIDE; places.len()];
        let found = parallel::map(places, |&place| {
            let mirrored = self.half && place[1] < 0.0;
            locator.locate(if mirrored {
                [place[0], -place[1]]
            } else {
                place
            })
        });
        let rows = weights.chunks_mut(nodes.max(1)).zip(&mut cells);
        for ((weights, cell), found) in rows.zip(found) {
            if let Some(found) = found {
                *cell = found.cell as u32;
                for (weight, (_, value)) in weights.iter_mut().zip(&found.shape) {
                    *weight = *value;
                }
            }
        }
        let below = places.iter().map(|place| self.half && place[1] < 0.0);
        Sampling {
            nodes,
            cells,
            weights,
            mirrored: below.collect(),
        }
    }

    /// Component `axis` of the displacement `[mm]` at each sampled place; none outside of the body, or of a step that there is not.
    pub fn component(&self, sampling: &Sampling, step: usize, axis: usize) -> Vec<Option<f64>> {
        let displacements = self.displacements(step);
        let value = |k: usize| {
            let cell = sampling.cells[k];
            if cell == OUTSIDE || displacements.is_empty() {
                return None;
            }
            let (_, nodes, _) = self.mesh.element(cell as usize);
            let weights = &sampling.weights[k * sampling.nodes..];
            let sum: f64 = nodes
                .iter()
                .zip(weights)
                .map(|(&node, weight)| weight * displacements[2 * node + axis])
                .sum();
            // The mirror image of a symmetric body moves alike along x and oppositely along y.
            let sign = if axis == 1 && sampling.mirrored[k] {
                -1.0
            } else {
                1.0
            };
            Some(sign * sum)
        };
        parallel::map_range(0..sampling.cells.len(), value)
    }
}

const OUTSIDE: u32 = u32::MAX;

/// Places found in a mesh, for values there of any nodal field.
#[derive(Clone, Debug)]
pub struct Sampling {
    /// Most nodes of a cell, the stride of the weights.
    nodes: usize,
    cells: Vec<u32>,
    /// Shape functions `[1]` of the cell at each place, `nodes` of them for each.
    weights: Vec<f64>,
    mirrored: Vec<bool>,
}
