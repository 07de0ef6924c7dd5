//! Localized hybrid analysis of a region, with the covariance of all that follows.
//!
//! A region of finite elements whose prescribed nodes (its whole boundary, and chosen nodes inside) move as measured, Δ¹, and
//! whose other nodes carry the known forces F², mostly none, has
//!
//! ```text
//! Δ² = K₂₂⁻¹ (F² − K₂₁ Δ¹),     F¹ = (K₁₁ − K₁₂ K₂₂⁻¹ K₂₁) Δ¹ + K₁₂ K₂₂⁻¹ F².
//! ```
//!
//! All its results, stresses on an edge, forces through an arc, displacements elsewhere, are linear in the displacements,
//! y = A Δ, so that the covariance Σ of Δ¹ goes over exactly,
//!
//! ```text
//! T = ∂y/∂Δ¹ = A₁ − A₂ K₂₂⁻¹ K₂₁,     Σ_y = T Σ Tᵀ.
//! ```
//!
//! Source: Post & Reddy, *Friction Phenomenon in Contact Stress Problems* (1988), part I, 4.1, Eqs 13–15; the print of Eq. 15
//! lacks a factor.
//!
//! | module | subject |
//! | --- | --- |
//! | [`outline`] | which nodes and chains of edges bound a mesh |
//! | [`sector`] | meshes of arc sectors around a hole, at a distance from bad data |
//! | [`outputs`] | stresses on an edge, resultants, displacements at places, as rows of A |
//! | [`transfer`] | T, Σ_y, and a Monte Carlo simulation to confirm them |
//! | [`checks`] | misfit at unused points, tractions on a free edge, balance on arcs |
//! | [`direct`] | measured displacements differentiated by the elements alone, without equilibrium |
//! | [`fit`] | boundary displacements fitted to all data with equilibrium, smoothed as declared |
//! | [`locate`] | in which cell a place lies |

pub mod checks;
pub mod direct;
pub mod fit;
pub mod locate;
pub mod outline;
pub mod outputs;
pub mod sector;
pub mod transfer;

use std::sync::Arc;

use stickslip_fem_core::body::{PartitionedBody, SparseRow};
use stickslip_fem_core::generate::GenerateError;
use stickslip_fem_core::linalg::Matrix;
use stickslip_fem_core::mesh::{Mesh, MeshError, Point};
use stickslip_fem_core::{BodyError, ElasticBody};
use thiserror::Error;

use crate::data::NodalDisplacements;

/// Why a region cannot be made or analysed.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum RegionError {
    /// The body is not one that can be solved.
    #[error(transparent)]
    Body(#[from] BodyError),
    /// The mesh lacks what is requested of it.
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// The sector cannot be meshed.
    #[error(transparent)]
    Generate(#[from] GenerateError),
    /// An array of the wrong length.
    #[error("{name} has {found} entries, expected {expected}")]
    Length {
        /// Which array.
        name: &'static str,
        /// Entries needed.
        expected: usize,
        /// Entries given.
        found: usize,
    },
    /// A node has two displacements.
    #[error("node {node} has two displacements")]
    RepeatedNode {
        /// Index of the node.
        node: usize,
    },
    /// A node whose displacement is needed has none.
    #[error("no displacement is given for node {node} at ({}, {})", place[0], place[1])]
    MissingNode {
        /// Index of the node.
        node: usize,
        /// Where it is `[length]`.
        place: Point,
    },
    /// A number that is infinite or none.
    #[error("{what} {index} is not finite")]
    NotFinite {
        /// What it is.
        what: &'static str,
        /// Which of them.
        index: usize,
    },
    /// The covariance of the displacements is needed and not known.
    #[error("the displacements have no covariance: no standard deviation follows from them")]
    NoCovariance,
    /// A covariance that no random numbers have.
    #[error("the covariance of the displacements is not positive semidefinite (row {row})")]
    NotCovariance {
        /// Row in which this shows.
        row: usize,
    },
    /// A measurement without a positive standard deviation `[length]` cannot be weighed.
    #[error("the standard deviation {0} of the measurement is not positive")]
    Deviation(f64),
    /// A place outside of the region.
    #[error("place {index} at ({}, {}) is not in the region", place[0], place[1])]
    Outside {
        /// Which place.
        index: usize,
        /// Where it is `[length]`.
        place: Point,
    },
    /// No measured point lies in the region.
    #[error("none of the {places} measured places lies in the region and is valid")]
    NoData {
        /// Number of places.
        places: usize,
    },
    /// The data do not determine the fit.
    #[error(
        "the data do not determine the displacement of the region's node at ({}, {}): no measurement is near enough",
        place[0], place[1]
    )]
    NotDetermined {
        /// Where `[length]`.
        place: Point,
    },
    /// The order of the smoothed differences is neither 2 nor 3.
    #[error("differences of order {0} cannot be smoothed; 2 and 3 can")]
    SmoothingOrder(usize),
    /// The amount of smoothing `[1]` is negative or not a number.
    #[error(
        "{0} is not a valid amount or share of smoothing: give a finite number that is not negative"
    )]
    SmoothingAmount(f64),
    /// An eigenvalue decomposition did not converge.
    #[error("the eigenvalues of a {order} × {order} matrix were not found")]
    Eigenvalues {
        /// Number of rows.
        order: usize,
    },
}

/// A region with its factorised stiffness, for any number of measured states.
#[derive(Clone, Debug)]
pub struct Region {
    stiffness: PartitionedBody,
}

/// Displacements and forces of a region.
#[derive(Clone, Debug, PartialEq)]
pub struct RegionSolution {
    /// Displacements of all nodes `[length]`, x and y of each in turn.
    pub displacements: Vec<f64>,
    /// Force F¹ `[force]` that acts on the region at each prescribed degree of freedom, in their order.
    pub reactions: Vec<f64>,
}

impl RegionSolution {
    /// Computes the outputs y = A Δ of the rows A, which are those of the same mesh; one number per row, `[row · length]`.
    pub fn outputs(&self, rows: &[SparseRow]) -> Vec<f64> {
        rows.iter()
            .map(|row| product(row, &self.displacements))
            .collect()
    }
}

impl Region {
    /// Prescribes both displacements of all boundary nodes of `body` and of the nodes `interior`. One factorisation.
    ///
    /// # Errors
    /// [`RegionError::Body`].
    pub fn new(body: &Arc<ElasticBody>, interior: &[usize]) -> Result<Self, RegionError> {
        let mut nodes = outline::boundary_nodes(body.mesh());
        nodes.extend_from_slice(interior);
        nodes.sort_unstable();
        nodes.dedup();
        let dofs: Vec<usize> = nodes
            .iter()
            .flat_map(|&node| [2 * node, 2 * node + 1])
            .collect();
        Self::with_dofs(body, &dofs)
    }

    /// Prescribes the degrees of freedom `dofs` (2·node + axis) only; what the body's supports hold stays at zero.
    ///
    /// # Errors
    /// [`RegionError::Body`].
    pub fn with_dofs(body: &Arc<ElasticBody>, dofs: &[usize]) -> Result<Self, RegionError> {
        let stiffness = PartitionedBody::new(body, dofs)?;
        Ok(Self { stiffness })
    }

    /// The body of the region, with its mesh, materials and thickness.
    pub fn body(&self) -> &Arc<ElasticBody> {
        self.stiffness.body()
    }

    /// The mesh of [`body`](Self::body).
    pub fn mesh(&self) -> &Mesh {
        self.body().mesh()
    }

    /// Prescribed degrees of freedom (2·node + axis), in the order of all lists of prescribed displacements.
    pub fn prescribed(&self) -> &[usize] {
        self.stiffness.prescribed()
    }

    /// The nodes that have a prescribed degree of freedom, ascending.
    pub fn prescribed_nodes(&self) -> Vec<usize> {
        let mut nodes: Vec<usize> = self.prescribed().iter().map(|dof| dof / 2).collect();
        nodes.sort_unstable();
        nodes.dedup();
        nodes
    }

    /// Number of unknowns.
    pub fn unknowns(&self) -> usize {
        self.stiffness.unknowns()
    }

    /// Solves with `measured` at the prescribed nodes; further nodes in it are not used. One pair of triangular solves.
    ///
    /// # Errors
    /// Arrays that do not fit, a node twice, a prescribed node missing, or a number that is not finite.
    pub fn solve(&self, measured: &NodalDisplacements) -> Result<RegionSolution, RegionError> {
        self.solve_loaded(measured, &[])
    }

    /// As [`solve`](Self::solve), with known forces F² `[force]` on the nodes, x and y of each node of the mesh in turn, such as
    /// the remote load on a plate.
    ///
    /// # Errors
    /// As [`solve`](Self::solve).
    pub fn solve_loaded(
        &self,
        measured: &NodalDisplacements,
        forces: &[f64],
    ) -> Result<RegionSolution, RegionError> {
        let all = 2 * self.mesh().nodes().len();
        if ![0, all].contains(&forces.len()) {
            return Err(length("the vector of forces", all, forces.len()));
        }
        all_finite("force", forces)?;
        let values = self.values(measured)?;
        let displacements = self.stiffness.solve(&values, forces).displacements(0);
        let applied = |dof: &usize| forces.get(*dof).copied().unwrap_or(0.0);
        let reactions = (self.prescribed().iter().zip(self.stiffness.reaction_rows()))
            .map(|(dof, row)| product(row, &displacements) - applied(dof))
            .collect();
        Ok(RegionSolution {
            displacements,
            reactions,
        })
    }

    /// Values of the prescribed degrees of freedom among `measured`, in their order `[length]`.
    ///
    /// # Errors
    /// As [`solve`](Self::solve).
    pub fn values(&self, measured: &NodalDisplacements) -> Result<Vec<f64>, RegionError> {
        let positions = positions(measured, self.mesh(), self.prescribed())?;
        Ok(positions.iter().map(|&k| measured.values[k]).collect())
    }

    /// Covariance of [`values`](Self::values) `[length²]`.
    pub(crate) fn covariance(&self, measured: &NodalDisplacements) -> Result<Matrix, RegionError> {
        let positions = positions(measured, self.mesh(), self.prescribed())?;
        submatrix(measured, &positions)
    }
}

/// The part of the covariance that belongs to the entries `positions` of the values.
fn submatrix(measured: &NodalDisplacements, positions: &[usize]) -> Result<Matrix, RegionError> {
    let size = measured.values.len();
    if measured.covariance.is_empty() {
        return Err(RegionError::NoCovariance);
    }
    if measured.covariance.len() != size * size {
        let name = "the covariance of the displacements";
        return Err(length(name, size * size, measured.covariance.len()));
    }
    let part = Matrix::from_fn(positions.len(), positions.len(), |i, j| {
        measured.covariance[positions[i] * size + positions[j]]
    });
    match (0..positions.len()).find(|&i| (0..positions.len()).any(|j| !part[(i, j)].is_finite())) {
        Some(index) => Err(RegionError::NotFinite {
            what: "covariance of displacement",
            index,
        }),
        None => Ok(part),
    }
}

/// Where the degrees of freedom `dofs` stand in the values of `measured`; those values are finite.
fn positions(
    measured: &NodalDisplacements,
    mesh: &Mesh,
    dofs: &[usize],
) -> Result<Vec<usize>, RegionError> {
    let expected = 2 * measured.nodes.len();
    if measured.values.len() != expected {
        return Err(length(
            "the vector of displacements",
            expected,
            measured.values.len(),
        ));
    }
    let mut place = vec![usize::MAX; mesh.nodes().len()];
    for (k, &node) in measured.nodes.iter().enumerate() {
        let slot = place.get_mut(node).ok_or(BodyError::NoSuchNode { node })?;
        if std::mem::replace(slot, k) != usize::MAX {
            return Err(RegionError::RepeatedNode { node });
        }
    }
    let mut positions = Vec::with_capacity(dofs.len());
    for &dof in dofs {
        let node = dof / 2;
        if place[node] == usize::MAX {
            let place = mesh.nodes()[node];
            return Err(RegionError::MissingNode { node, place });
        }
        let position = 2 * place[node] + dof % 2;
        if !measured.values[position].is_finite() {
            let what = "displacement of node";
            return Err(RegionError::NotFinite { what, index: node });
        }
        positions.push(position);
    }
    Ok(positions)
}

/// Covariance `[length²]`, row by row, of the displacements of `nodes` nodes that are independent with the standard deviations
/// `deviation` `[length]` along x and y.
pub fn independent_covariance(nodes: usize, deviation: [f64; 2]) -> Vec<f64> {
    let size = 2 * nodes;
    let mut covariance = vec![0.0; size * size];
    for k in 0..size {
        covariance[k * size + k] = deviation[k % 2].powi(2);
    }
    covariance
}

fn length(name: &'static str, expected: usize, found: usize) -> RegionError {
    RegionError::Length {
        name,
        expected,
        found,
    }
}

fn all_finite(what: &'static str, values: &[f64]) -> Result<(), RegionError> {
    match values.iter().position(|value| !value.is_finite()) {
        Some(index) => Err(RegionError::NotFinite { what, index }),
        None => Ok(()),
    }
}

/// Refuses rows over nodes that the mesh does not have.
fn check_rows(mesh: &Mesh, rows: &[SparseRow]) -> Result<(), RegionError> {
    let nodes = mesh.nodes().len();
    match rows.iter().flatten().find(|(dof, _)| dof / 2 >= nodes) {
        Some((dof, _)) => Err(BodyError::NoSuchNode { node: dof / 2 }.into()),
        None => Ok(()),
    }
}

/// A row of A times all displacements.
fn product(row: &[(usize, f64)], displacements: &[f64]) -> f64 {
    row.iter()
        .map(|&(dof, weight)| weight * displacements[dof])
        .sum()
}
