//! A body whose material is not linear, linearised about a displacement u_k.
//!
//! ```text
//! f_int(u) = f + Bᵀ λ,    f_int(u) ≈ f_int(u_k) + K_t (u − u_k)
//! K_t u = f + Bᵀ λ + [K_t u_k − f_int(u_k)],    K_t = t Σ_q w_q Bᵀ D_q B,    K_t u_k − f_int(u_k) = t Σ_q w_q Bᵀ (D_q ε_q − σ_q)
//! ```
//!
//! The term in brackets balances itself, so the linearised body is an ordinary [`InterfaceOperator`] with one load case more than
//! the body has; its multiplier is 1. Where the material is linear it vanishes to rounding of the stress.

use std::sync::Arc;

use nalgebra::{DMatrix, DVector};

use super::assembly::{CountPoints, assemble_tangents};
use super::condensed::{BodyLoad, CondensedBody};
use super::elastic::ElasticBody;
use super::equations::{BodyStructure, HELD};
use super::error::BodyError;
use crate::element::with_element;
use crate::interface::InterfaceOperator;
use crate::material::{PlaneStiffness, apply};
use crate::mesh::Point;
use crate::points::internal_forces;

/// A body condensed with one tangent per quadrature point.
#[derive(Clone, Debug)]
pub struct TangentBody {
    condensed: CondensedBody,
    tangents: Vec<PlaneStiffness>,
    no_load: DVector<f64>,
}

impl TangentBody {
    /// Condenses `body` with `tangents` `[stress]`, symmetric, one per quadrature point of its mesh, in place of its materials: one
    /// numeric factorisation. `structure` is what [`ElasticBody::analyse`] made.
    ///
    /// # Errors
    /// [`BodyError::PointCount`]; [`BodyError::LoadCase`] if a load case has an initial strain, which is the material's affair
    /// here; [`BodyError::Factor`] if K_t is not positive definite; otherwise as [`CondensedBody::new`].
    pub fn new(
        body: Arc<ElasticBody>,
        structure: Arc<BodyStructure>,
        tangents: Vec<PlaneStiffness>,
    ) -> Result<Self, BodyError> {
        structure.check_made_for(&body)?;
        check_count(&body, "tangents", tangents.len())?;
        let strained = |case: &super::LoadCase| !case.initial_strain.is_empty();
        if let Some(case) = body.cases.iter().position(strained) {
            return Err(BodyError::LoadCase {
                case,
                what: "an initial strain is the affair of a material with history",
            });
        }
        let assembled = assemble_tangents(&body, &structure, &tangents);
        let condensed = CondensedBody::of_matrix(body, structure, assembled)?;
        let no_load = DVector::zeros(condensed.modes().ncols());
        Ok(Self {
            condensed,
            tangents,
            no_load,
        })
    }

    /// The body, condensed.
    pub fn condensed(&self) -> &CondensedBody {
        &self.condensed
    }

    /// Tangent of each quadrature point `[stress]`.
    pub fn tangents(&self) -> &[PlaneStiffness] {
        &self.tangents
    }

    /// Linearises about the state with the strains `strains` `[1]` and stresses `stresses` `[stress]`, one per quadrature point: a pass over
    /// the cells and half a sparse solve.
    ///
    /// # Errors
    /// [`BodyError::PointCount`].
    pub fn about(
        self: &Arc<Self>,
        strains: &[[f64; 3]],
        stresses: &[[f64; 3]],
    ) -> Result<Linearised, BodyError> {
        let body = self.condensed.body();
        check_count(body, "strains", strains.len())?;
        check_count(body, "stresses", stresses.len())?;
        let excess: Vec<[f64; 3]> = (self.tangents.iter())
            .zip(strains.iter().zip(stresses))
            .map(|(tangent, (strain, stress))| {
                let linear = apply(tangent, *strain);
                [0, 1, 2].map(|i| linear[i] - stress[i])
            })
            .collect();
        let nodal = internal_forces(&body.mesh, body.thickness, &excess);
        let (response, correction) = self.condensed.response_to(&nodal);
        Ok(Linearised {
            tangent: Arc::clone(self),
            correction,
            response,
        })
    }
}

fn check_count(body: &ElasticBody, what: &'static str, found: usize) -> Result<(), BodyError> {
    let cells = |block: &crate::mesh::ElementBlock| block.connectivity.len() / block.kind.nodes();
    let expected = (body.mesh.blocks().iter())
        .map(|block| cells(block) * with_element(block.kind, CountPoints))
        .sum();
    if found == expected {
        Ok(())
    } else {
        Err(BodyError::PointCount {
            what,
            expected,
            found,
        })
    }
}

/// A body as it is near one state: the operator that contact sees in one iteration. Its last load case is the correction, with the
/// multiplier 1.
#[derive(Clone, Debug)]
pub struct Linearised {
    tangent: Arc<TangentBody>,
    /// Forces of the correction on the unknowns.
    correction: Vec<f64>,
    response: DVector<f64>,
}

impl Linearised {
    /// Displacements of all nodes `[length]`, interleaved, under interface forces `forces` (2n) `[force]`, the body's load cases times
    /// `multipliers`, the correction, and rigid motions `motions` (f) `[length]`: one pair of sparse triangular solves.
    pub fn displacements(&self, forces: &[f64], multipliers: &[f64], motions: &[f64]) -> Vec<f64> {
        let state = BodyLoad {
            forces,
            multipliers,
            motions,
        };
        let condensed = &self.tangent.condensed;
        condensed.displacements_with(&state, &self.correction)
    }
}

impl InterfaceOperator for Linearised {
    fn points(&self) -> &[Point] {
        self.tangent.condensed.points()
    }

    fn compliance(&self) -> Option<&DMatrix<f64>> {
        self.tangent.condensed.compliance()
    }

    fn modes(&self) -> &DMatrix<f64> {
        self.tangent.condensed.modes()
    }

    fn load_cases(&self) -> usize {
        self.tangent.condensed.load_cases() + 1
    }

    fn load_response(&self, case: usize) -> Option<&DVector<f64>> {
        if case == self.tangent.condensed.load_cases() {
            Some(&self.response)
        } else {
            self.tangent.condensed.load_response(case)
        }
    }

    fn mode_load(&self, case: usize) -> &DVector<f64> {
        if case == self.tangent.condensed.load_cases() {
            &self.tangent.no_load
        } else {
            self.tangent.condensed.mode_load(case)
        }
    }
}

impl BodyStructure {
    /// The largest component `[force]` of nodal forces (interleaved, 2 × nodes) along an unknown: what of them no support takes.
    pub fn largest_on_unknowns(&self, nodal: &[f64]) -> f64 {
        let unknowns = self.to_unknowns(nodal);
        unknowns
            .iter()
            .fold(0.0, |largest, force| largest.max(force.abs()))
    }

    /// Displacements `[length]` of all nodes, interleaved, 2 × nodes, that the supports prescribe for a multiplier of 1; zero
    /// where nothing is prescribed.
    pub fn support_motion(&self) -> Vec<f64> {
        let mut motion = vec![0.0; 2 * self.equations.len()];
        for (node, constraint) in self.constraints.iter().enumerate() {
            let held = std::array::from_fn(|axis| {
                if self.equations[node][axis] == HELD {
                    constraint.displacement[axis]
                } else {
                    0.0
                }
            });
            motion[2 * node..2 * node + 2].copy_from_slice(&constraint.to_global(held));
        }
        motion
    }
}
