//! How supports and a platen constrain each node.

use super::error::BodyError;
use crate::mesh::Mesh;
use crate::support::{Platen, Support};

/// How a node may move: its own orthogonal axes, and which of the two are held at which displacement.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct NodeConstraint {
    /// First axis of the node's frame; the second is this turned by +90°.
    pub(super) axis: [f64; 2],
    pub(super) held: [bool; 2],
    pub(super) displacement: [f64; 2],
}

impl NodeConstraint {
    const FREE: Self = Self {
        axis: [1.0, 0.0],
        held: [false; 2],
        displacement: [0.0; 2],
    };

    pub(super) fn axes(&self) -> [[f64; 2]; 2] {
        [self.axis, [-self.axis[1], self.axis[0]]]
    }

    /// Unit vectors along which the node is held.
    pub(super) fn holds(&self) -> Vec<[f64; 2]> {
        let axes = self.axes().into_iter().zip(self.held);
        axes.filter_map(|(axis, is_held)| is_held.then_some(axis))
            .collect()
    }

    /// Whether nothing but the platen's own hold acts on the node: no displacement, and no hold where the platen is free.
    fn moves_with(&self, platen: &Platen) -> bool {
        (0..2).filter(|&k| self.held[k]).all(|k| {
            let axis = self.axes()[k];
            self.displacement[k] == 0.0
                && (0..2).all(|i| !platen.free[i] || axis[i].abs() < PARALLEL)
        })
    }

    pub(super) fn is_turned(&self) -> bool {
        self.axis != [1.0, 0.0]
    }

    /// Components of an xy vector along the node's axes.
    pub(super) fn to_local(self, v: [f64; 2]) -> [f64; 2] {
        self.axes().map(|axis| axis[0] * v[0] + axis[1] * v[1])
    }

    /// The xy vector with these components along the node's axes.
    pub(super) fn to_global(self, v: [f64; 2]) -> [f64; 2] {
        let [first, second] = self.axes();
        [
            first[0] * v[0] + second[0] * v[1],
            first[1] * v[0] + second[1] * v[1],
        ]
    }
}

/// One constraint per node from a body's supports and platen, both of which may hold a node where they agree.
pub(super) fn node_constraints(
    mesh: &Mesh,
    supports: &[Support],
    platen: Option<&Platen>,
) -> Result<Vec<NodeConstraint>, BodyError> {
    let mut constraints = vec![NodeConstraint::FREE; mesh.nodes().len()];
    for (index, support) in supports.iter().enumerate() {
        let [x, y] = support.direction.unit();
        if !(x.is_finite() && y.is_finite() && support.displacement.is_finite()) {
            return Err(BodyError::SupportNotFinite { support: index });
        }
        for &node in &support.nodes {
            let slot = constraints
                .get_mut(node)
                .ok_or(BodyError::NoSuchNode { node })?;
            *slot = hold(*slot, support.direction.unit(), support.displacement)
                .ok_or(BodyError::ContradictingSupports { node })?;
        }
    }
    if let Some(platen) = platen {
        for &node in &platen.nodes {
            let slot = constraints
                .get_mut(node)
                .ok_or(BodyError::NoSuchNode { node })?;
            if !slot.moves_with(platen) {
                return Err(BodyError::ContradictingSupports { node });
            }
            *slot = NodeConstraint {
                held: [true; 2],
                ..NodeConstraint::FREE
            };
        }
    }
    Ok(constraints)
}

/// Sine or cosine of an angle that counts as zero.
const PARALLEL: f64 = 1e-9;

/// Adds a held direction to what a node has already; `None` if that contradicts it.
fn hold(now: NodeConstraint, direction: [f64; 2], displacement: f64) -> Option<NodeConstraint> {
    let local = now.to_local(direction);
    match now.held {
        [false, false] => {
            let along_y = direction == [0.0, 1.0];
            Some(NodeConstraint {
                axis: if along_y { [1.0, 0.0] } else { direction },
                held: [!along_y, along_y],
                displacement: if along_y {
                    [0.0, displacement]
                } else {
                    [displacement, 0.0]
                },
            })
        }
        [true, true] => {
            let implied = local[0] * now.displacement[0] + local[1] * now.displacement[1];
            let scale = implied.abs().max(displacement.abs());
            ((implied - displacement).abs() <= PARALLEL * scale).then_some(now)
        }
        held => {
            let (old, new) = if held[0] { (0, 1) } else { (1, 0) };
            if local[new].abs() < PARALLEL {
                let implied = local[old] * now.displacement[old];
                return ((implied - displacement).abs() <= PARALLEL * displacement.abs())
                    .then_some(now);
            }
            let mut result = NodeConstraint {
                held: [true; 2],
                ..now
            };
            result.displacement[new] =
                (displacement - local[old] * now.displacement[old]) / local[new];
            Some(result)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::support::HeldDirection;

    fn global_displacement(constraint: NodeConstraint) -> [f64; 2] {
        constraint.to_global(constraint.displacement)
    }

    #[test]
    fn two_skew_supports_fix_the_node_where_both_are_met() {
        let first = hold(NodeConstraint::FREE, HeldDirection::Angle(0.3).unit(), 0.2).unwrap();
        let both = hold(first, HeldDirection::Angle(1.4).unit(), -0.1).unwrap();
        let u = global_displacement(both);
        for (angle, value) in [(0.3_f64, 0.2), (1.4, -0.1)] {
            assert!((u[0] * angle.cos() + u[1] * angle.sin() - value).abs() < 1e-14);
        }
    }

    #[test]
    fn a_repeated_support_is_one_and_a_contradiction_is_refused() {
        let once = hold(NodeConstraint::FREE, [0.0, 1.0], 0.0).unwrap();
        assert_eq!(hold(once, [0.0, 1.0], 0.0), Some(once));
        assert_eq!(hold(once, [0.0, 1.0], 0.5), None);
        let fixed = hold(once, [1.0, 0.0], 0.0).unwrap();
        assert_eq!(hold(fixed, HeldDirection::Angle(0.7).unit(), 1.0), None);
    }
}
