//! What holds bodies: supports, springs and platens.

use super::SetRef;
use crate::declaration::{
    NONE, POSITIVE, REQUIRED, Table, angle, bed_stiffness, described, filled, length, set,
    spring_stiffness,
};
use crate::units::{Angle, BedStiffness, Length, Quantity, SpringStiffness};
use serde::{Deserialize, Serialize};

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
    /// Those in `list`.
    pub(crate) fn of(list: &[Axis]) -> Self {
        Self {
            x: list.contains(&Axis::X),
            y: list.contains(&Axis::Y),
        }
    }

    /// Their unit vectors `[1]`.
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
    /// The unit vectors `[1]` along which it holds, one or two.
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

/// `[[supports]]`.
#[derive(Debug, Clone, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct SupportFormat {
    pub(crate) on: String,
    pub(crate) fix: Option<Vec<Axis>>,
    pub(crate) normal: Option<Quantity<Angle>>,
    pub(crate) displacement: Option<Quantity<Length>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) stiffness: Option<Quantity<SpringStiffness>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) bed: Option<Quantity<BedStiffness>>,
}

impl SupportFormat {
    /// What it holds; `None` where that has been reported.
    pub(crate) fn hold(&self) -> Option<Hold> {
        match (self.fix.as_deref(), &self.normal) {
            (Some(list), None) if !list.is_empty() => Some(Hold::Axes(Axes::of(list))),
            (None, Some(normal)) => Some(Hold::Direction(normal.value())),
            _ => None,
        }
    }

    /// The support that stands at `index` of its list.
    pub(crate) fn support(&self, index: usize, on: SetRef, hold: Hold) -> Support {
        // What is named `_` makes where and how it holds, and springs.
        let Self {
            on: _,
            fix: _,
            normal: _,
            displacement,
            stiffness: _,
            bed: _,
        } = self;
        let displacement = displacement.as_ref();
        Support {
            index,
            on,
            hold,
            displacement: displacement.map_or(0.0, Quantity::value),
        }
    }
}

/// `[[platens]]`.
#[derive(Debug, Clone, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct PlatenFormat {
    pub(crate) on: String,
    pub(crate) free: Vec<Axis>,
}

impl PlatenFormat {
    pub(crate) fn platen(&self, on: SetRef) -> Platen {
        let Self { on: _, free } = self;
        Platen {
            on,
            free: Axes::of(free),
        }
    }
}

#[rustfmt::skip]
pub(crate) const TABLES: &[Table] = &[
    Table::new("supports", &[
        set("on", REQUIRED, r#""plate.left""#, "edge, point, or area, whose mean displacement is held by a reaction that is spread evenly over it"),
        described("fix", r#"list of `"x"`, `"y"`"#, "required, or `normal`", r#"["x"]"#,
            "axes along which the nodes are held").range(filled(r#"["x"], ["y"] or ["x", "y"]"#)),
        angle("normal", NONE, r#""30 deg""#, "one direction, from +x, along which the nodes are held; across it they slide"),
        length("displacement", "0", r#""0.01 mm""#,
            "displacement along that one axis or direction, reached at the end of the first load step and kept"),
        spring_stiffness("stiffness", NONE, r#""500 N/mm""#,
            "springs to the ground instead, along each axis or direction: of the whole edge, over which it is spread evenly, or of a point").range(POSITIVE),
        bed_stiffness("bed", NONE, r#""20 MPa/mm""#, "the same of an edge, per area").range(POSITIVE),
    ]).one_of(&[&["fix"], &["normal"]], r#"fix = ["x", "y"], normal = "30 deg""#),
    Table::new("platens", &[
        set("on", REQUIRED, r#""plate.left""#, "the edge"),
        described("free", r#"list of `"x"`, `"y"`"#, REQUIRED, r#"["x", "y"]"#,
            "axes along which it moves freely; along the others it is held, `[]` holds it"),
    ]),
];
