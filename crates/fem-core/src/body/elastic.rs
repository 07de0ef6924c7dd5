//! A linear elastic body with its supports and unit loads.

use std::sync::Arc;

use super::error::BodyError;
use crate::material::{Material, PlaneStiffness};
use crate::mesh::Mesh;
use crate::support::{Platen, SectionHold, Spring, Support};

/// One unit load on a body; a load history multiplies it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LoadCase {
    /// Nodal forces `[force]`, interleaved, 2 × nodes; empty for none.
    pub forces: Vec<f64>,
    /// Initial (thermal) strain (ε_xx, ε_yy, γ_xy) `[1]` per element block; empty for none. Its nodal forces are *not* in
    /// `forces`.
    pub initial_strain: Vec<[f64; 3]>,
    /// Whether this case drives the displacements of the supports.
    pub moves_supports: bool,
}

/// A linear elastic body: mesh, one material per block, thickness, supports, springs and unit loads, checked when it is built.
#[derive(Clone, Debug)]
pub struct ElasticBody {
    pub(super) mesh: Arc<Mesh>,
    pub(super) materials: Vec<Arc<dyn Material>>,
    pub(super) thickness: f64,
    pub(super) supports: Vec<Support>,
    pub(super) springs: Vec<Spring>,
    pub(super) platen: Option<Platen>,
    pub(super) section: Option<SectionHold>,
    pub(super) carried: Option<f64>,
    pub(super) cases: Vec<LoadCase>,
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
            springs: Vec::new(),
            platen: None,
            section: None,
            carried: None,
            cases: Vec::new(),
        })
    }

    /// Adds supports.
    #[must_use]
    pub fn with_supports(mut self, supports: impl IntoIterator<Item = Support>) -> Self {
        self.supports.extend(supports);
        self
    }

    /// Adds springs to the ground.
    #[must_use]
    pub fn with_springs(mut self, springs: impl IntoIterator<Item = Spring>) -> Self {
        self.springs.extend(springs);
        self
    }

    /// Whether springs lead to the ground.
    pub fn is_sprung(&self) -> bool {
        !self.springs.is_empty()
    }

    /// Glues nodes to a rigid platen.
    #[must_use]
    pub fn with_platen(mut self, platen: Platen) -> Self {
        self.platen = Some(platen);
        self
    }

    /// Holds the mean displacement over the area. Of points with history ([`Linearised`](crate::Linearised)) it is not held.
    #[must_use]
    pub fn with_section_hold(mut self, hold: SectionHold) -> Self {
        self.section = Some(hold);
        self
    }

    /// Makes the mean displacement over the area and its mean turn, times `length` `[length]`, the amounts of the body's rigid motions, and spreads
    /// the forces in them evenly over the area, as those of a fastener on one of its slices. For a body without supports and without
    /// [`SectionHold`].
    #[must_use]
    pub fn with_carried_section(mut self, length: f64) -> Self {
        self.carried = Some(length);
        self
    }

    /// Whether the mean displacement over the area is held, or carries the body.
    pub fn has_section(&self) -> bool {
        self.section.is_some() || self.carried.is_some()
    }

    /// What holds the mean displacement over the area.
    pub fn section_hold(&self) -> Option<SectionHold> {
        self.section
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

    /// Computes the initial strain (ε_xx, ε_yy, γ_xy) `[1]` per block of a combination of load cases, Σ m_k ε_k with one multiplier per
    /// case `[1]`; empty where no case has any.
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

    /// Plane stiffness `[stress]` of each block's material.
    pub(super) fn stiffnesses(&self) -> Vec<PlaneStiffness> {
        self.materials
            .iter()
            .map(|material| material.stiffness())
            .collect()
    }
}
