//! The curves that face each other in a contact.

use stickslip_contact::deformed::CurveShape;
use stickslip_contact::gap;
use stickslip_fem_core::mesh::Point;

use super::open::OpenPair;
use crate::model::plan::{ContactPlan, Plan};
use stickslip_scene::schema::GapKind;
use stickslip_scene::shape::Touch;

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
    Open(OpenPair),
}

impl Geometry {
    pub(super) fn of(plan: &Plan<'_>, contact: &ContactPlan<'_>) -> Option<Self> {
        let [first, second] = &contact.sides;
        let touch = first.edge.as_ref()?.touches(second.edge.as_ref()?)?;
        Some(match touch {
            Touch::Circles {
                radii: [radius, inner],
            } => Self::Circles {
                radius,
                clearance: radius - inner,
                offset: contact.offset,
            },
            Touch::Cylinder { radius } => Self::Cylinder { radius },
            Touch::Open => Self::Open(OpenPair::of(plan, contact)?),
        })
    }

    /// The second curve, where the centre of the first one's circle or arc is `centre`; `None` of open edges.
    pub(super) fn second(&self, centre: Point) -> Option<CurveShape> {
        Some(match self {
            Self::Circles {
                radius,
                clearance,
                offset,
            } => CurveShape::Circle {
                centre: [centre[0] + offset[0], centre[1] + offset[1]],
                radius: radius - clearance,
            },
            Self::Cylinder { radius } => CurveShape::Level {
                level: centre[1] - radius,
            },
            Self::Open(_) => return None,
        })
    }

    /// Length `[mm]` of the contact per unit of the parameter, an angle or a length.
    pub(super) fn length(&self) -> f64 {
        match self {
            Self::Circles { radius, .. } => *radius,
            Self::Cylinder { .. } | Self::Open(_) => 1.0,
        }
    }

    /// Initial gap; `None` for a faceted one. A place of an open edge that faces nothing never touches.
    pub(super) fn gap(&self, kind: GapKind, at: f64) -> Option<f64> {
        match (self, kind) {
            (_, GapKind::Faceted) => None,
            (Self::Open(pair), _) => Some(pair.gap(at).unwrap_or_else(|| pair.never())),
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
