//! Shapes of bodies and the names of their edges.

/// A shape and its place. The centre of a hole or disk is the origin, unless another hole holds it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Shape {
    /// A plate around a circular hole.
    PlateWithHole {
        /// Radius of the hole `[mm]`.
        hole_radius: f64,
        /// Outer edge.
        outline: Outline,
    },
    /// A disk.
    Disk {
        /// Radius `[mm]`.
        radius: f64,
    },
    /// x in [−width/2, width/2], y in [−height, 0].
    Rectangle {
        /// `[mm]`
        width: f64,
        /// `[mm]`
        height: f64,
    },
    /// x in [−half_length, half_length], y in [−depth, 0]; stands for the half-plane y ≤ 0.
    Block {
        /// `[mm]`
        half_length: f64,
        /// `[mm]`
        depth: f64,
    },
    /// Above an arc that touches the origin from above, y = R − √(R² − x²), up to y = depth, for |x| ≤ half_length.
    Cylinder {
        /// Radius R of the arc `[mm]`.
        radius: f64,
        /// `[mm]`, less than the radius.
        half_length: f64,
        /// `[mm]`, above the ends of the arc.
        depth: f64,
    },
}

/// Outer edge of a plate with a hole.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Outline {
    /// x in [−left, right], |y| ≤ half_width.
    Strip {
        /// `[mm]`
        half_width: f64,
        /// `[mm]`
        left: f64,
        /// `[mm]`
        right: f64,
    },
    /// A circle around the hole.
    Ring {
        /// `[mm]`
        radius: f64,
    },
}

impl Shape {
    /// Name in scenes.
    pub const fn name(&self) -> &'static str {
        match self {
            Self::PlateWithHole { .. } => "plate_with_hole",
            Self::Disk { .. } => "disk",
            Self::Rectangle { .. } => "rectangle",
            Self::Block { .. } => "block",
            Self::Cylinder { .. } => "cylinder",
        }
    }

    /// Its edges, by name.
    pub const fn edges(&self) -> &'static [&'static str] {
        match self {
            Self::PlateWithHole {
                outline: Outline::Strip { .. },
                ..
            } => &["hole", "left", "right", "top", "bottom"],
            Self::PlateWithHole {
                outline: Outline::Ring { .. },
                ..
            } => &["hole", "outer"],
            Self::Disk { .. } => &["rim"],
            Self::Rectangle { .. } => &["left", "right", "bottom", "top"],
            Self::Block { .. } => &["contact", "bottom", "left", "right"],
            Self::Cylinder { .. } => &["contact", "top"],
        }
    }

    /// Its named points that are no edges.
    pub const fn points(&self) -> &'static [&'static str] {
        match self {
            Self::Disk { .. } => &["centre"],
            _ => &[],
        }
    }

    /// Whether its mesh is divided by angles, not by lengths.
    pub const fn is_round(&self) -> bool {
        matches!(self, Self::PlateWithHole { .. } | Self::Disk { .. })
    }

    /// Radius `[mm]` of a circular edge around the origin.
    pub fn circle(&self, edge: &str) -> Option<f64> {
        match (self, edge) {
            (Self::PlateWithHole { hole_radius, .. }, "hole") => Some(*hole_radius),
            (
                Self::PlateWithHole {
                    outline: Outline::Ring { radius },
                    ..
                },
                "outer",
            )
            | (Self::Disk { radius }, "rim") => Some(*radius),
            _ => None,
        }
    }
}
