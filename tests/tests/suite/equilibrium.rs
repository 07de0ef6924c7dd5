//! Equilibrium of random small scenes, each time by sums that the library did not make.

mod joints;
mod lines;

use stickslip_contact::StepRecord;
use stickslip_tests::Solution;
use stickslip_tests::balance::{internal_forces, load_forces};

/// Largest force that may be left on a node that nothing holds, relative to the largest force of the scene. Rounding of a
/// factorisation of a few thousand unknowns with displacements of the order of the bodies' give stays below 1e-12.
const NODAL: f64 = 1e-10;

/// Forces `[N]` that nothing accounts for on each node of a body: the reactions of its supports, otherwise zero.
fn unaccounted(solution: &Solution, body: usize, record: &StepRecord) -> Vec<f64> {
    let elastic = solution.elastic(body).expect("an elastic body");
    let mut forces = internal_forces(elastic, &solution.displacement(body, record));
    for (sum, load) in forces
        .iter_mut()
        .zip(load_forces(elastic, &record.state.multipliers))
    {
        *sum -= load;
    }
    let contact = solution.contact_forces(body, record);
    for (force, &node) in contact
        .chunks_exact(2)
        .zip(&solution.model.bodies[body].interface)
    {
        forces[2 * node] -= force[0];
        forces[2 * node + 1] -= force[1];
    }
    forces
}

/// The same at the nodes that no support set of the body holds, the largest in magnitude; and the sum over those held.
fn residual_and_reaction(
    solution: &Solution,
    body: usize,
    record: &StepRecord,
    held: &[(&str, [bool; 2])],
) -> (f64, [f64; 2]) {
    let mut forces = unaccounted(solution, body, record);
    let mesh = solution.elastic(body).expect("an elastic body").mesh();
    let mut reaction = [0.0; 2];
    for (set, directions) in held {
        for &node in mesh.node_set(set).expect("a set of the generator") {
            for axis in (0..2).filter(|&axis| directions[axis]) {
                reaction[axis] += std::mem::take(&mut forces[2 * node + axis]);
            }
        }
    }
    let largest = forces
        .iter()
        .fold(0.0, |worst: f64, force| worst.max(force.abs()));
    (largest, reaction)
}

/// A displacement that varies from node to node and vanishes where the sets `held` say so.
fn virtual_displacement(solution: &Solution, body: usize, held: &[(&str, [bool; 2])]) -> Vec<f64> {
    let mesh = solution.elastic(body).expect("an elastic body").mesh();
    let mut v: Vec<f64> = (0..2 * mesh.nodes().len())
        .map(|k| (1.0 + 12.9898 * k as f64 + 78.233 * body as f64).sin())
        .collect();
    for (set, directions) in held {
        for &node in mesh.node_set(set).expect("a set of the generator") {
            for axis in (0..2).filter(|&axis| directions[axis]) {
                v[2 * node + axis] = 0.0;
            }
        }
    }
    v
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
