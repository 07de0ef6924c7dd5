//! The finite-element system itself, for those who do not want it condensed.
//!
//! ```text
//! K u = f + Bᵀ λ        u_c = B u + u_s + R α
//! ```
//!
//! with the unknowns u that supports (and isostatic holds of a floating body) leave, the forces λ on the contact points, their
//! displacements u_c, the part u_s of these that supports prescribe, and the rigid motions R α.

use super::condensed::CondensedBody;

/// An unknown of the finite-element system that moves a contact point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct InterfaceUnknown {
    /// Index of the unknown.
    pub unknown: usize,
    /// Index of the contact point.
    pub point: usize,
    /// Unit vector `[1]` along which the unknown moves it.
    pub axis: [f64; 2],
}

impl CondensedBody {
    /// Nodal forces f `[force]` on the unknowns by load cases times `multipliers`.
    pub fn load_on_unknowns(&self, multipliers: &[f64]) -> Vec<f64> {
        self.right_hand_side(&[], multipliers)
    }

    /// The unknowns that move contact points: the rows of Bᵀ that are not zero.
    pub fn interface_unknowns(&self) -> Vec<InterfaceUnknown> {
        let structure = self.structure();
        (structure.interface_axes().into_iter())
            .zip(structure.interface_equations())
            .map(|((point, axis), unknown)| InterfaceUnknown {
                unknown,
                point,
                axis,
            })
            .collect()
    }

    /// Displacements u_s `[length]` of the contact points, xy interleaved, that supports prescribe under load cases times
    /// `multipliers`, one per load case `[1]`.
    pub fn prescribed_motion(&self, multipliers: &[f64]) -> Vec<f64> {
        let structure = self.structure();
        let cases = self.body().load_cases().iter().zip(multipliers);
        let scale: f64 = cases
            .filter(|(case, _)| case.moves_supports)
            .map(|(_, factor)| factor)
            .sum();
        (structure.interface.iter())
            .flat_map(|&node| {
                let constraint = structure.constraints[node];
                constraint.to_global(constraint.displacement)
            })
            .map(|displacement| scale * displacement)
            .collect()
    }
}
