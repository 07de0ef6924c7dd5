//! What holds bodies: supports, springs and platens.

use serde::{Deserialize, Serialize};

use super::SetRef;

/// A coordinate axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Axis {
    /// The load axis.
    X,
    /// The other.
    Y,
}

impl Axis {
    /// As scenes write it.
    pub fn name(self) -> &'static str {
        match self {
            Self::X => "x",
            Self::Y => "y",
        }
    }
}

/// Some of the axes.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Axes {
    /// Whether x is among them.
    pub x: bool,
    /// Whether y is among them.
    pub y: bool,
}

impl Axes {
    /// Their unit vectors.
    pub fn directions(self) -> Vec<[f64; 2]> {
        let all = [(self.x, [1.0, 0.0]), (self.y, [0.0, 1.0])];
        let among = all.into_iter().filter(|(is_among, _)| *is_among);
        among.map(|(_, direction)| direction).collect()
    }

    /// Those that are not among them.
    #[must_use]
    pub fn others(self) -> Self {
        Self {
            x: !self.x,
            y: !self.y,
        }
    }
}

/// Nodes whose displacement is given.
#[derive(Debug, Clone, PartialEq)]
pub struct Support {
    /// Its number among the supports of the scene, springs among them.
    pub index: usize,
    /// Where.
    pub on: SetRef,
    /// In which directions.
    pub hold: Hold,
    /// Displacement in each of them `[mm]`.
    pub displacement: f64,
}

/// Springs between a set and the ground.
#[derive(Debug, Clone, PartialEq)]
pub struct SpringSupport {
    /// Its number among the supports of the scene.
    pub index: usize,
    /// Where.
    pub on: SetRef,
    /// In which directions they act.
    pub hold: Hold,
    /// How stiff they are in each of them.
    pub stiffness: SpringSize,
}

/// How stiff springs are.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum SpringSize {
    /// All together `[N/mm]`.
    Whole(f64),
    /// Per area `[N/mm³]`.
    Bed(f64),
}

/// Directions in which a support holds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Hold {
    /// Along axes, at least one.
    Axes(Axes),
    /// Along the direction at this angle `[rad]` from +x.
    Direction(f64),
}

impl Hold {
    /// The unit vectors along which it holds, one or two.
    pub fn directions(self) -> Vec<[f64; 2]> {
        match self {
            Self::Axes(axes) => axes.directions(),
            Self::Direction(angle) => vec![[angle.cos(), angle.sin()]],
        }
    }
}

/// A rigid plate that an edge is glued to. It does not rotate.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Platen {
    /// The edge.
    pub on: SetRef,
    /// Axes along which it moves freely; along the others it is held.
    pub free: Axes,
}
