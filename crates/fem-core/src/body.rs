//! A linear elastic body and its condensation.

mod assembly;
mod condensed;
mod equations;
mod partitioned;
mod parts;
mod tangent;
mod whole;

use std::sync::Arc;

use thiserror::Error;

pub use assembly::internal_forces;
pub use condensed::{BodyBalance, BodyLoad, CondensedBody};
pub use equations::BodyStructure;
pub use partitioned::{PartitionedBody, PartitionedStates, SparseRow};
pub use tangent::{Linearised, TangentBody};
pub use whole::InterfaceUnknown;

use crate::linalg::FactorError;
use crate::material::{Material, PlaneStiffness};
use crate::mesh::Mesh;
use crate::support::{Platen, Support};

/// Why a body cannot be made or condensed.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum BodyError {
    /// The number of materials is not the number of element blocks.
    #[error("{materials} materials for {blocks} element blocks: each block needs one")]
    MaterialCount {
        /// Materials given.
        materials: usize,
        /// Blocks of the mesh.
        blocks: usize,
    },
    /// The thickness is not a positive number.
    #[error("thickness {0} is not positive")]
    Thickness(f64),
    /// A support, platen or interface names a node that the mesh does not have.
    #[error("node {node} does not exist")]
    NoSuchNode {
        /// Index of the node.
        node: usize,
    },
    /// An interface names a node twice.
    #[error("node {node} appears twice in the interface")]
    RepeatedNode {
        /// Index of the node.
        node: usize,
    },
    /// Two supports ask different displacements of a node in one direction, or a support holds or moves a node of a platen
    /// in a way that the platen does not.
    #[error("the supports of node {node} contradict each other")]
    ContradictingSupports {
        /// Index of the node.
        node: usize,
    },
    /// A support has a direction or displacement that is not a finite number.
    #[error("support {support}: its direction or displacement is not a finite number")]
    SupportNotFinite {
        /// Index of the support.
        support: usize,
    },
    /// A platen is free along an axis in which supports elsewhere hold the body.
    #[error(
        "the platen is free in {free} translations, but supports leave the body only {left}: hold the platen there too"
    )]
    PlatenResisted {
        /// Translations that the platen is free to make.
        free: usize,
        /// Translations that the supports leave.
        left: usize,
    },
    /// A part of the mesh that shares no node with the rest, or is all of it, has a rigid motion that nothing prevents.
    #[error(
        "the part of the mesh joined to node {node} can move freely in {motions} of its 3 rigid motions: nothing holds it"
    )]
    LoosePart {
        /// A node of the part.
        node: usize,
        /// Number of rigid motions that nothing prevents.
        motions: usize,
    },
    /// A load case has a vector of the wrong length, or a number that is not finite.
    #[error("load case {case}: {what}")]
    LoadCase {
        /// Index of the case.
        case: usize,
        /// What is wrong.
        what: &'static str,
    },
    /// A body was given to a structure made for another mesh.
    #[error(
        "the structure was made for another mesh: it has {expected} nodes, this body's has {found}"
    )]
    OtherStructure {
        /// Nodes of the structure's mesh.
        expected: usize,
        /// Nodes of the body's mesh.
        found: usize,
    },
    /// A body was given to a structure made for other supports or another platen.
    #[error("the structure was made for other supports")]
    OtherSupports,
    /// There is not one value per quadrature point.
    #[error("{found} {what} for {expected} quadrature points")]
    PointCount {
        /// What is counted.
        what: &'static str,
        /// Quadrature points of the mesh.
        expected: usize,
        /// Values given.
        found: usize,
    },
    /// The factorisation failed.
    #[error(transparent)]
    Factor(#[from] FactorError),
}

/// One unit load on a body; a load history multiplies it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LoadCase {
    /// Nodal forces `[force]`, interleaved, 2 × nodes; empty for none.
    pub forces: Vec<f64>,
    /// Initial (thermal) strain (ε_xx, ε_yy, γ_xy) per element block; empty for none. Its nodal forces are *not* in
    /// `forces`.
    pub initial_strain: Vec<[f64; 3]>,
    /// Whether this case drives the displacements of the supports.
    pub moves_supports: bool,
}

/// A linear elastic body: mesh, one material per block, thickness, supports and unit loads, checked when it is built.
#[derive(Clone, Debug)]
pub struct ElasticBody {
    mesh: Arc<Mesh>,
    materials: Vec<Arc<dyn Material>>,
    thickness: f64,
    supports: Vec<Support>,
    platen: Option<Platen>,
    cases: Vec<LoadCase>,
}

impl ElasticBody {
    /// A body of `thickness` `[length]` with one material per element block, neither supported nor loaded yet.
    ///
    /// # Errors
    /// [`BodyError::MaterialCount`], [`BodyError::Thickness`].
    pub fn new(
        mesh: Arc<Mesh>,
        materials: Vec<Arc<dyn Material>>,
        thickness: f64,
    ) -> Result<Self, BodyError> {
        let blocks = mesh.blocks().len();
        if materials.len() != blocks {
            return Err(BodyError::MaterialCount {
                materials: materials.len(),
                blocks,
            });
        }
        if !(thickness > 0.0 && thickness.is_finite()) {
            return Err(BodyError::Thickness(thickness));
        }
        Ok(Self {
            mesh,
            materials,
            thickness,
            supports: Vec::new(),
            platen: None,
            cases: Vec::new(),
        })
    }

    /// Adds supports.
    #[must_use]
    pub fn with_supports(mut self, supports: impl IntoIterator<Item = Support>) -> Self {
        self.supports.extend(supports);
        self
    }

    /// Glues nodes to a rigid platen.
    #[must_use]
    pub fn with_platen(mut self, platen: Platen) -> Self {
        self.platen = Some(platen);
        self
    }

    /// Adds unit loads; their order is the order of the multipliers.
    ///
    /// # Errors
    /// [`BodyError::LoadCase`] for a vector of the wrong length or a number that is not finite.
    pub fn with_load_cases(mut self, cases: Vec<LoadCase>) -> Result<Self, BodyError> {
        for (case, load) in cases.iter().enumerate() {
            let refuse = |what| Err(BodyError::LoadCase { case, what });
            if ![0, 2 * self.mesh.nodes().len()].contains(&load.forces.len()) {
                return refuse("the force vector does not have two numbers per node");
            }
            if ![0, self.mesh.blocks().len()].contains(&load.initial_strain.len()) {
                return refuse("there is not one initial strain per element block");
            }
            if !load
                .forces
                .iter()
                .chain(load.initial_strain.iter().flatten())
                .all(|value| value.is_finite())
            {
                return refuse("a number is not finite");
            }
        }
        self.cases.extend(cases);
        Ok(self)
    }

    /// The mesh.
    pub fn mesh(&self) -> &Arc<Mesh> {
        &self.mesh
    }

    /// The material of each element block.
    pub fn materials(&self) -> &[Arc<dyn Material>] {
        &self.materials
    }

    /// Thickness `[length]`.
    pub fn thickness(&self) -> f64 {
        self.thickness
    }

    /// Unit loads.
    pub fn load_cases(&self) -> &[LoadCase] {
        &self.cases
    }

    /// Initial strain per block of a combination of load cases; empty where no case has any.
    pub fn initial_strain(&self, multipliers: &[f64]) -> Vec<[f64; 3]> {
        let mut strain = Vec::new();
        for (case, &factor) in self.cases.iter().zip(multipliers) {
            if !case.initial_strain.is_empty() {
                strain.resize(self.mesh.blocks().len(), [0.0; 3]);
                for (sum, part) in strain.iter_mut().zip(&case.initial_strain) {
                    *sum = std::array::from_fn(|i| sum[i] + factor * part[i]);
                }
            }
        }
        strain
    }

    /// Numbers the equations with the nodes of `interface` last and analyses the stiffness matrix's structure.
    ///
    /// # Errors
    /// A node that does not exist or appears twice, supports that are not finite or contradict each other or the platen, a
    /// part of the mesh that is neither joined nor held, or a structure too large for memory.
    pub fn analyse(&self, interface: &[usize]) -> Result<Arc<BodyStructure>, BodyError> {
        BodyStructure::new(self, interface).map(Arc::new)
    }

    /// Condenses the body to the nodes of `interface`, in that order: one factorisation.
    ///
    /// # Errors
    /// As [`analyse`](Self::analyse); [`BodyError::Factor`] if the stiffness matrix is not positive definite, as where two
    /// parts share a single node about which they can turn.
    pub fn condense(self: &Arc<Self>, interface: &[usize]) -> Result<CondensedBody, BodyError> {
        CondensedBody::new(Arc::clone(self), self.analyse(interface)?)
    }

    fn stiffnesses(&self) -> Vec<PlaneStiffness> {
        self.materials
            .iter()
            .map(|material| material.stiffness())
            .collect()
    }
}
