//! How a contact is projected.

use std::fmt;

use stickslip_fem_core::mesh::Point;

/// The functions that contact forces are made of.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Multipliers {
    /// The shape functions of the first edge.
    #[default]
    Standard,
    /// Functions biorthogonal to them: on a straight edge each point stands on one node of the first body alone.
    Dual,
}

/// Distance between the undeformed edges.
#[derive(Clone, Copy)]
pub enum InitialGap<'a> {
    /// Exact gap `[length]` at a parameter.
    Exact(&'a dyn Fn(f64) -> f64),
    /// Between the meshes as they are: positions `[length]` of the contact points of the first and of the second body.
    Faceted(&'a [Point], &'a [Point]),
}

impl fmt::Debug for InitialGap<'_> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(match self {
            Self::Exact(_) => "Exact",
            Self::Faceted(..) => "Faceted",
        })
    }
}

/// What a projection needs beside the edges.
#[derive(Clone, Copy)]
pub struct Projection<'a> {
    /// Functions of the contact forces.
    pub multipliers: Multipliers,
    /// Length `[length]` of the contact per unit of the parameter: 1 for arc length, the radius for an angle.
    pub length: f64,
    /// Thickness `[length]` of the contact.
    pub thickness: f64,
    /// Unit normal e_n `[1]` from the second body into the first at a parameter.
    pub normal: &'a dyn Fn(f64) -> [f64; 2],
    /// Initial gap.
    pub gap: InitialGap<'a>,
    /// Angle of the first body's 1-axis from x `[rad]`.
    pub material_angle: f64,
    /// Whether the first edge starts, and ends, on a line of symmetry. Shear is odd there, so the multiplier of that node
    /// has no tangential part.
    pub symmetry: [bool; 2],
}

impl fmt::Debug for Projection<'_> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter
            .debug_struct("Projection")
            .field("multipliers", &self.multipliers)
            .field("length", &self.length)
            .field("thickness", &self.thickness)
            .field("gap", &self.gap)
            .field("material_angle", &self.material_angle)
            .field("symmetry", &self.symmetry)
            .finish_non_exhaustive()
    }
}
