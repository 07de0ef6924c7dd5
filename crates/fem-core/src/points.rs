//! The quadrature points of a whole mesh, where materials with history live.
//!
//! ```text
//! ε_q = B_q u,     f_int = t Σ_q w_q det J_q B_qᵀ σ_q
//! ```
//!
//! Points are numbered cell by cell in the mesh's order, within a cell as in [`Element::QUADRATURE`].

use std::ops::Range;

use crate::element::{
    Element, KindVisitor, PhysicalGradients, gather, physical_gradients, with_element,
};
use crate::mesh::{ElementBlock, Mesh, Point};
use crate::parallel;

/// Where the quadrature points of a mesh are.
#[derive(Clone, Debug, PartialEq)]
pub struct QuadraturePoints {
    /// First point of each cell, and their number at the end.
    first: Vec<usize>,
    position: Vec<Point>,
    area: Vec<f64>,
}

impl QuadraturePoints {
    /// The points of `mesh`.
    pub fn of(mesh: &Mesh) -> Self {
        let mut points = Self {
            first: vec![0],
            position: Vec::new(),
            area: Vec::new(),
        };
        for block in mesh.blocks() {
            let visit = Locate {
                mesh,
                block,
                points: &mut points,
            };
            with_element(block.kind, visit);
        }
        points
    }

    /// Number of points.
    pub fn count(&self) -> usize {
        self.position.len()
    }

    /// Number of cells.
    pub fn cell_count(&self) -> usize {
        self.first.len() - 1
    }

    /// Points of cell `cell`, a global index of the mesh.
    pub fn of_cell(&self, cell: usize) -> Range<usize> {
        self.first[cell]..self.first[cell + 1]
    }

    /// Cell of point `point`, which is less than [`count`](Self::count).
    pub fn cell(&self, point: usize) -> usize {
        // The offsets start at 0, so at least one is not greater.
        self.first.partition_point(|&first| first <= point) - 1
    }

    /// Place of each point `[length]`.
    pub fn positions(&self) -> &[Point] {
        &self.position
    }

    /// Area that each point stands for `[length²]`: weight times det J.
    pub fn areas(&self) -> &[f64] {
        &self.area
    }

    /// Area of cell `cell` `[length²]`.
    pub fn cell_area(&self, cell: usize) -> f64 {
        self.area[self.of_cell(cell)].iter().sum()
    }
}

struct Locate<'a> {
    mesh: &'a Mesh,
    block: &'a ElementBlock,
    points: &'a mut QuadraturePoints,
}

impl KindVisitor for Locate<'_> {
    type Output = ();

    fn visit<const N: usize, E: Element<N>>(self) {
        for cell in self.block.connectivity.chunks_exact(N) {
            let x: [Point; N] = gather(self.mesh.nodes(), cell);
            for point in E::QUADRATURE {
                let det = physical_gradients::<N, E>(&x, point.at).det;
                let shape = E::shape(point.at);
                let at = x.iter().zip(shape).fold([0.0; 2], |[px, py], (node, n)| {
                    [px + n * node[0], py + n * node[1]]
                });
                self.points.position.push(at);
                self.points.area.push(point.weight * det);
            }
            self.points.first.push(self.points.position.len());
        }
    }
}

/// Strains (ε_xx, ε_yy, γ_xy) `[1]` at all quadrature points of `mesh` under the nodal displacements `u` `[length]`, interleaved,
/// 2 × nodes.
pub fn strains(mesh: &Mesh, u: &[f64]) -> Vec<[f64; 3]> {
    let mut all = Vec::new();
    for block in mesh.blocks() {
        all.extend(with_element(block.kind, Strain { mesh, block, u }));
    }
    all
}

struct Strain<'a> {
    mesh: &'a Mesh,
    block: &'a ElementBlock,
    u: &'a [f64],
}

impl KindVisitor for Strain<'_> {
    type Output = Vec<[f64; 3]>;

    fn visit<const N: usize, E: Element<N>>(self) -> Self::Output {
        let (mesh, u) = (self.mesh, self.u);
        let mut strains = vec![[0.0; 3]; self.block.connectivity.len() / N * E::QUADRATURE.len()];
        parallel::for_each_chunk(&mut strains, E::QUADRATURE.len(), |k, strains| {
            let cell = &self.block.connectivity[k * N..(k + 1) * N];
            let x: [Point; N] = gather(mesh.nodes(), cell);
            let moved: [[f64; 2]; N] = cell_values(u, cell);
            for (strain, point) in strains.iter_mut().zip(E::QUADRATURE) {
                *strain = physical_gradients::<N, E>(&x, point.at).strain(&moved);
            }
        });
        strains
    }
}

fn cell_values<const N: usize>(u: &[f64], cell: &[usize]) -> [[f64; 2]; N] {
    std::array::from_fn(|a| [u[2 * cell[a]], u[2 * cell[a] + 1]])
}

/// Nodal forces `[force]`, interleaved, 2 × nodes, that hold the stresses `stress` `[stress]`, one (σ_xx, σ_yy, τ_xy) per
/// quadrature point, in a body of `thickness` `[length]`. They balance themselves.
pub fn internal_forces(mesh: &Mesh, thickness: f64, stress: &[[f64; 3]]) -> Vec<f64> {
    let mut forces = vec![0.0; 2 * mesh.nodes().len()];
    let mut rest = stress;
    for block in mesh.blocks() {
        let visit = Divergence {
            mesh,
            block,
            thickness,
            stress: rest,
            forces: &mut forces,
        };
        let used = with_element(block.kind, visit);
        rest = rest.get(used..).unwrap_or_default();
    }
    forces
}

struct Divergence<'a> {
    mesh: &'a Mesh,
    block: &'a ElementBlock,
    thickness: f64,
    stress: &'a [[f64; 3]],
    forces: &'a mut [f64],
}

impl KindVisitor for Divergence<'_> {
    /// Points used.
    type Output = usize;

    fn visit<const N: usize, E: Element<N>>(self) -> usize {
        let per_cell = E::QUADRATURE.len();
        let (mesh, thickness) = (self.mesh, self.thickness);
        let cells = (self.block.connectivity.len() / N).min(self.stress.len() / per_cell);
        let local: Vec<[[f64; 2]; N]> = parallel::map_range(0..cells, |k| {
            let cell = &self.block.connectivity[k * N..(k + 1) * N];
            let stress = &self.stress[k * per_cell..(k + 1) * per_cell];
            let x: [Point; N] = gather(mesh.nodes(), cell);
            let mut forces = [[0.0; 2]; N];
            for (s, point) in stress.iter().zip(E::QUADRATURE) {
                let PhysicalGradients { det, gradients } = physical_gradients::<N, E>(&x, point.at);
                let weight = point.weight * det * thickness;
                for (force, [gx, gy]) in forces.iter_mut().zip(gradients) {
                    force[0] += weight * (gx * s[0] + gy * s[2]);
                    force[1] += weight * (gy * s[1] + gx * s[2]);
                }
            }
            forces
        });
        // The sum in mesh order, so that it does not depend on the threads.
        for (cell, forces) in self.block.connectivity.chunks_exact(N).zip(&local) {
            for (&node, force) in cell.iter().zip(forces) {
                self.forces[2 * node] += force[0];
                self.forces[2 * node + 1] += force[1];
            }
        }
        self.block.connectivity.len() / N * per_cell
    }
}
