//! A displacement on a mesh, and its stress at given points of every cell: σ = D (B u − ε₀).

use std::ops::Range;

use super::{StressError, length};
use crate::element::{
    Element, KindVisitor, PhysicalGradients, gather, physical_gradients, with_element,
};
use crate::material::{Material, apply};
use crate::mesh::{ElementBlock, Mesh, Point};

/// A displacement on a mesh with its materials; checked, so that recovering stress from it cannot fail.
#[derive(Clone, Copy, Debug)]
pub struct ElasticField<'a> {
    pub(super) mesh: &'a Mesh,
    materials: &'a [&'a dyn Material],
    displacement: &'a [f64],
    initial_strain: Option<&'a [[f64; 3]]>,
}

/// Stresses at the quadrature points of every cell.
#[derive(Clone, Debug, PartialEq)]
pub struct GaussStresses {
    /// Start of each cell's values, and their number at the end.
    first: Vec<usize>,
    values: Vec<[f64; 3]>,
}

impl GaussStresses {
    /// Stresses of cell `element` (a global index of the mesh), in the order of its
    /// [`QUADRATURE`](Element::QUADRATURE) `[stress]`.
    pub fn of(&self, element: usize) -> &[[f64; 3]] {
        &self.values[self.first[element]..self.first[element + 1]]
    }

    /// All stresses, one cell after the other `[stress]`.
    pub fn values(&self) -> &[[f64; 3]] {
        &self.values
    }

    /// Number of cells.
    pub fn element_count(&self) -> usize {
        self.first.len() - 1
    }
}

/// Which of an element's points to sample.
#[derive(Clone, Copy, Debug)]
pub(super) enum Points {
    Quadrature,
    Superconvergent,
}

/// Stress and place of the sampled points of one block, the same number in every cell.
#[derive(Clone, Debug)]
pub(super) struct Samples {
    pub(super) per_cell: usize,
    pub(super) at: Vec<Point>,
    pub(super) stress: Vec<[f64; 3]>,
}

impl Samples {
    pub(super) fn of(&self, cell: usize) -> Range<usize> {
        cell * self.per_cell..(cell + 1) * self.per_cell
    }
}

impl<'a> ElasticField<'a> {
    /// Joins `mesh` with one of `materials` per block, the nodal `displacement` (u₀, v₀, u₁, v₁, …) `[length]` and, if there
    /// is one, the initial strain (ε_xx, ε_yy, γ_xy) of each block, for example [`Material::thermal_strain`].
    ///
    /// # Errors
    /// [`StressError::Length`] if an array does not fit the mesh.
    pub fn new(
        mesh: &'a Mesh,
        materials: &'a [&'a dyn Material],
        displacement: &'a [f64],
        initial_strain: Option<&'a [[f64; 3]]>,
    ) -> Result<Self, StressError> {
        let blocks = mesh.blocks().len();
        length("materials", blocks, materials.len())?;
        length("displacement", 2 * mesh.nodes().len(), displacement.len())?;
        if let Some(strains) = initial_strain {
            length("initial_strain", blocks, strains.len())?;
        }
        Ok(Self {
            mesh,
            materials,
            displacement,
            initial_strain,
        })
    }

    /// Stress at every quadrature point of every cell.
    pub fn gauss_stresses(&self) -> GaussStresses {
        let mut first = vec![0];
        let mut values = Vec::new();
        for block in 0..self.mesh.blocks().len() {
            let samples = self.sample(block, Points::Quadrature);
            let start = values.len();
            first.extend(
                (start..=start + samples.stress.len())
                    .step_by(samples.per_cell)
                    .skip(1),
            );
            values.extend(samples.stress);
        }
        GaussStresses { first, values }
    }

    pub(super) fn sample(&self, block: usize, points: Points) -> Samples {
        let cells = &self.mesh.blocks()[block];
        with_element(
            cells.kind,
            Sampling {
                field: self,
                block,
                cells,
                points,
            },
        )
    }
}

struct Sampling<'f, 'a> {
    field: &'f ElasticField<'a>,
    block: usize,
    cells: &'a ElementBlock,
    points: Points,
}

impl KindVisitor for Sampling<'_, '_> {
    type Output = Samples;

    fn visit<const N: usize, E: Element<N>>(self) -> Samples {
        let points: Vec<Point> = match self.points {
            Points::Quadrature => E::QUADRATURE.iter().map(|point| point.at).collect(),
            Points::Superconvergent => E::SUPERCONVERGENT.to_vec(),
        };
        let stiffness = self.field.materials[self.block].stiffness();
        let initial = self
            .field
            .initial_strain
            .map_or([0.0; 3], |strains| strains[self.block]);
        let u = self.field.displacement;
        let count = self.cells.connectivity.len() / N * points.len();
        let mut at = Vec::with_capacity(count);
        let mut stress = Vec::with_capacity(count);
        for nodes in self.cells.connectivity.chunks_exact(N) {
            let x: [Point; N] = gather(self.field.mesh.nodes(), nodes);
            let moved: [[f64; 2]; N] =
                std::array::from_fn(|a| [u[2 * nodes[a]], u[2 * nodes[a] + 1]]);
            for &xi in &points {
                let here: PhysicalGradients<N> = physical_gradients::<N, E>(&x, xi);
                let strain = here.strain(&moved);
                let elastic = [0, 1, 2].map(|i| strain[i] - initial[i]);
                stress.push(apply(&stiffness, elastic));
                at.push(interpolate(&x, &E::shape(xi)));
            }
        }
        Samples {
            per_cell: points.len(),
            at,
            stress,
        }
    }
}

fn interpolate<const N: usize>(x: &[Point; N], shape: &[f64; N]) -> Point {
    x.iter()
        .zip(shape)
        .fold([0.0; 2], |[px, py], (p, n)| [px + n * p[0], py + n * p[1]])
}
