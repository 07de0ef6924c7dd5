//! Fasteners: disks in several layers that springs couple.

/// A fastener through several plates, in each of which one of its slices stands.
#[derive(Debug, Clone, PartialEq)]
pub struct Fastener {
    /// Name in results.
    pub name: String,
    /// Its slices, disks in the order of the layers.
    pub slices: Vec<String>,
    /// What couples them.
    pub springs: Springs,
}

/// What couples the slices of a fastener.
#[derive(Debug, Clone, PartialEq)]
pub enum Springs {
    /// They move and turn as one.
    Rigid,
    /// The shank as a beam of the slices' material, loaded evenly along the thickness of each plate.
    Beam {
        /// Whether head and nut, at the outer faces of the first and of the last slice, keep it from tilting.
        clamped: [bool; 2],
    },
    /// Given compliances between adjacent slices, which turn as one.
    Given {
        /// Displacement per force between each slice and the next `[mm/N]`.
        compliance: Vec<f64>,
    },
}
