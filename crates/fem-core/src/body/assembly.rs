//! Assembly of the stiffness matrix: cells in parallel, the sum in one fixed order.

use std::array;

use super::constraints::NodeConstraint;
use super::elastic::ElasticBody;
use super::equations::{BodyStructure, HELD};
use super::springs::SpringCell;
use crate::element::{Element, KindVisitor, gather, stiffness, tangent_stiffness, with_element};
use crate::linalg::LowerMatrix;
use crate::material::PlaneStiffness;
use crate::mesh::Mesh;
use crate::parallel;

/// Cells whose matrices are held at once; bounds the memory beside the matrix.
const CHUNK: usize = 2048;
/// Nodal forces of cells that are held at once \[numbers\].
const HELD_FORCES: usize = 1 << 20;

/// The assembled matrix, and the forces that unit movement of the supports exerts on the unknowns.
pub(super) struct Assembled {
    pub(super) matrix: LowerMatrix,
    /// −K_fh u_h for the prescribed displacements u_h, one per unknown.
    pub(super) support_forces: Vec<f64>,
}

pub(super) fn assemble(body: &ElasticBody, structure: &BodyStructure) -> Assembled {
    let stiffnesses = body.stiffnesses();
    assemble_blocks(body, structure, |block| {
        BlockStiffness::Uniform(&stiffnesses[block])
    })
}

/// With one tangent per quadrature point of the mesh.
pub(super) fn assemble_tangents(
    body: &ElasticBody,
    structure: &BodyStructure,
    tangents: &[PlaneStiffness],
) -> Assembled {
    let mut first = vec![0];
    for block in body.mesh.blocks() {
        let cells = block.connectivity.len() / block.kind.nodes();
        let last = first[first.len() - 1];
        first.push(last + cells * with_element(block.kind, CountPoints));
    }
    assemble_blocks(body, structure, |block| {
        BlockStiffness::Points(&tangents[first[block]..first[block + 1]])
    })
}

fn assemble_blocks<'a>(
    body: &'a ElasticBody,
    structure: &'a BodyStructure,
    stiffness: impl Fn(usize) -> BlockStiffness<'a>,
) -> Assembled {
    let mut assembled = Assembled {
        matrix: structure.pattern.clone(),
        support_forces: vec![0.0; structure.unknowns],
    };
    for (index, block) in body.mesh.blocks().iter().enumerate() {
        let visit = AssembleBlock {
            mesh: &body.mesh,
            connectivity: &block.connectivity,
            stiffness: stiffness(index),
            thickness: body.thickness,
            structure,
            assembled: &mut assembled,
        };
        with_element(block.kind, visit);
    }
    for SpringCell { nodes, mut matrix } in body.spring_cells() {
        turn_to_node_axes(&mut matrix, &nodes, &structure.constraints);
        scatter(&matrix, &nodes, structure, &mut assembled);
    }
    assembled
}

/// The material of a block of cells `[stress]`.
#[derive(Clone, Copy)]
enum BlockStiffness<'a> {
    /// The same everywhere.
    Uniform(&'a PlaneStiffness),
    /// One matrix per quadrature point, cell by cell.
    Points(&'a [PlaneStiffness]),
}

/// Quadrature points of a cell.
pub(super) struct CountPoints;

impl KindVisitor for CountPoints {
    type Output = usize;

    fn visit<const N: usize, E: Element<N>>(self) -> usize {
        E::QUADRATURE.len()
    }
}

struct AssembleBlock<'a> {
    mesh: &'a Mesh,
    connectivity: &'a [usize],
    stiffness: BlockStiffness<'a>,
    thickness: f64,
    structure: &'a BodyStructure,
    assembled: &'a mut Assembled,
}

impl KindVisitor for AssembleBlock<'_> {
    type Output = ();

    fn visit<const N: usize, E: Element<N>>(self) {
        let size = 4 * N * N;
        let mut buffer = vec![0.0; CHUNK.min(self.connectivity.len() / N) * size];
        let per_cell = E::QUADRATURE.len();
        for (chunk, cells) in self.connectivity.chunks(CHUNK * N).enumerate() {
            let count = cells.len() / N;
            parallel::for_each_chunk(&mut buffer[..count * size], size, |index, local| {
                let cell = &cells[index * N..(index + 1) * N];
                let x = gather::<N>(self.mesh.nodes(), cell);
                match self.stiffness {
                    BlockStiffness::Uniform(material) => {
                        stiffness::<N, E>(&x, material, self.thickness, local);
                    }
                    BlockStiffness::Points(tangents) => {
                        let first = (chunk * CHUNK + index) * per_cell;
                        let own = &tangents[first..first + per_cell];
                        tangent_stiffness::<N, E>(&x, own, self.thickness, local);
                    }
                }
                turn_to_node_axes(local, cell, &self.structure.constraints);
            });
            for (local, cell) in buffer.chunks_exact(size).zip(cells.chunks_exact(N)) {
                scatter(local, cell, self.structure, self.assembled);
            }
        }
    }
}

/// Turns the rows and columns of nodes whose axes are not x and y.
fn turn_to_node_axes(local: &mut [f64], cell: &[usize], constraints: &[NodeConstraint]) {
    let width = 2 * cell.len();
    for (a, &node) in cell.iter().enumerate() {
        let constraint = constraints[node];
        if !constraint.is_turned() {
            continue;
        }
        for k in 0..width {
            let row =
                constraint.to_local([local[2 * a * width + k], local[(2 * a + 1) * width + k]]);
            local[2 * a * width + k] = row[0];
            local[(2 * a + 1) * width + k] = row[1];
        }
        for row in local.chunks_exact_mut(width) {
            let turned = constraint.to_local([row[2 * a], row[2 * a + 1]]);
            row[2 * a] = turned[0];
            row[2 * a + 1] = turned[1];
        }
    }
}

fn scatter(local: &[f64], cell: &[usize], structure: &BodyStructure, assembled: &mut Assembled) {
    let width = 2 * cell.len();
    let matrix = &mut assembled.matrix;
    for (b, &node_b) in cell.iter().enumerate() {
        for j in 0..2 {
            let column = structure.equations[node_b][j];
            let prescribed = structure.constraints[node_b].displacement[j];
            if column == HELD && prescribed == 0.0 {
                continue;
            }
            for (a, &node_a) in cell.iter().enumerate() {
                for i in 0..2 {
                    let row = structure.equations[node_a][i];
                    if row == HELD {
                        continue;
                    }
                    let value = local[(2 * a + i) * width + 2 * b + j];
                    if column == HELD {
                        assembled.support_forces[row as usize] -= value * prescribed;
                    } else if row >= column {
                        let (start, end) = (
                            matrix.column_start[column as usize],
                            matrix.column_start[column as usize + 1],
                        );
                        // The pattern was made from the same cells, so the row is there.
                        let offset = matrix.rows[start..end].partition_point(|&r| r < row as usize);
                        matrix.values[start + offset] += value;
                    }
                }
            }
        }
    }
}

/// Nodal forces K u `[force]`, interleaved, that hold the body in the displacements `u` `[length]`; supports and springs are ignored.
pub fn internal_forces(body: &ElasticBody, u: &[f64]) -> Vec<f64> {
    internal_forces_of(body, &[u.to_vec()]).swap_remove(0)
}

/// Nodal forces K u `[force]`, interleaved, that hold the body in each of the displacements `u` `[length]`; supports and
/// springs are ignored. Each cell's matrix is computed once.
pub(super) fn internal_forces_of(body: &ElasticBody, u: &[Vec<f64>]) -> Vec<Vec<f64>> {
    struct Visit<'a> {
        body: &'a ElasticBody,
        connectivity: &'a [usize],
        stiffness: &'a PlaneStiffness,
        u: &'a [Vec<f64>],
        forces: &'a mut [Vec<f64>],
    }
    impl KindVisitor for Visit<'_> {
        type Output = ();
        fn visit<const N: usize, E: Element<N>>(self) {
            let size = 2 * N * self.u.len();
            let count = (HELD_FORCES / size).clamp(1, CHUNK);
            let mut buffer = vec![0.0; count.min(self.connectivity.len() / N) * size];
            for cells in self.connectivity.chunks(count * N) {
                let buffer = &mut buffer[..cells.len() / N * size];
                parallel::for_each_chunk(buffer, size, |index, sums| {
                    self.of_cell::<N, E>(&cells[index * N..(index + 1) * N], sums);
                });
                for (sums, cell) in buffer.chunks_exact(size).zip(cells.chunks_exact(N)) {
                    for (sums, forces) in sums.chunks_exact(2 * N).zip(self.forces.iter_mut()) {
                        for (pair, &node) in sums.chunks_exact(2).zip(cell) {
                            forces[2 * node] += pair[0];
                            forces[2 * node + 1] += pair[1];
                        }
                    }
                }
            }
        }
    }
    impl Visit<'_> {
        /// The forces of one cell, `sums`, state by state.
        fn of_cell<const N: usize, E: Element<N>>(&self, cell: &[usize], sums: &mut [f64]) {
            let mut local = vec![0.0; 4 * N * N];
            let x = gather::<N>(self.body.mesh.nodes(), cell);
            stiffness::<N, E>(&x, self.stiffness, self.body.thickness, &mut local);
            for (u, sums) in self.u.iter().zip(sums.chunks_exact_mut(2 * N)) {
                let held: [[f64; 2]; N] = array::from_fn(|k| [u[2 * cell[k]], u[2 * cell[k] + 1]]);
                for (line, sum) in local.chunks_exact(2 * N).zip(sums) {
                    let pairs = line.chunks_exact(2).zip(&held);
                    *sum = pairs.map(|(k, u)| k[0] * u[0] + k[1] * u[1]).sum();
                }
            }
        }
    }
    let mut forces: Vec<Vec<f64>> = u.iter().map(|u| vec![0.0; u.len()]).collect();
    if u.is_empty() {
        return forces;
    }
    for (block, stiffness) in body.mesh.blocks().iter().zip(&body.stiffnesses()) {
        let visit = Visit {
            body,
            connectivity: &block.connectivity,
            stiffness,
            u,
            forces: &mut forces,
        };
        with_element(block.kind, visit);
    }
    forces
}
