//! The curves that face each other in a contact.

use stickslip_contact::gap;
use stickslip_fem_core::mesh::Point;

use crate::model::placement;
use crate::scene::Scene;
use crate::scene::schema::{Contact, GapKind, SetRef, Shape};

/// The two curves that face each other.
pub(super) enum Geometry {
    Circles {
        radius: f64,
        clearance: f64,
        offset: Point,
    },
    Cylinder {
        radius: f64,
    },
}

impl Geometry {
    pub(super) fn of(scene: &Scene, contact: &Contact) -> Option<Self> {
        let shape = |set: &SetRef| scene.bodies.get(&set.body).map(|body| body.shape);
        match (shape(&contact.first)?, shape(&contact.second)?) {
            (Shape::PlateWithHole { .. }, Shape::Disk { .. } | Shape::PlateWithHole { .. })
                if contact.first.set == "hole" && contact.second.set != "hole" =>
            {
                let radii @ [radius, inner] = placement::radii(scene, contact)?;
                Some(Self::Circles {
                    radius,
                    clearance: radius - inner,
                    offset: placement::offset(radii),
                })
            }
            (Shape::Cylinder { radius, .. }, Shape::Block { .. })
                if contact.first.set == "contact" && contact.second.set == "contact" =>
            {
                Some(Self::Cylinder { radius })
            }
            _ => None,
        }
    }

    /// Length `[mm]` of the contact per unit of the parameter, an angle or a length.
    pub(super) fn length(&self) -> f64 {
        match self {
            Self::Circles { radius, .. } => *radius,
            Self::Cylinder { .. } => 1.0,
        }
    }

    /// Initial gap; `None` for a faceted one.
    pub(super) fn gap(&self, kind: GapKind, at: f64) -> Option<f64> {
        match (self, kind) {
            (_, GapKind::Faceted) => None,
            (
                Self::Circles {
                    radius,
                    clearance,
                    offset,
                },
                GapKind::Exact,
            ) => Some(gap::circles(*radius, *clearance, *offset, at)),
            (
                Self::Circles {
                    clearance, offset, ..
                },
                GapKind::Linearised,
            ) => Some(gap::circles_linearised(*clearance, *offset, at)),
            (Self::Cylinder { radius }, GapKind::Exact) => Some(gap::cylinder(*radius, at)),
            (Self::Cylinder { radius }, GapKind::Linearised) => {
                Some(gap::cylinder_linearised(*radius, at))
            }
        }
    }
}
