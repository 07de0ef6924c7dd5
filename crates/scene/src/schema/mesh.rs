//! How finely bodies are divided.

use std::f64::consts::PI;
use std::fmt;

use serde::{Deserialize, Serialize};
use stickslip_fem_core::mesh::ElementKind;
use stickslip_text::short;

use crate::declaration::choices::quoted;
use crate::declaration::{
    Key, NONE, POSITIVE, Range, Table, angles, integer, names, numbers, spacing, with_default,
};
use crate::units::{Angle, AngleOrLength, Quantity};

/// How finely the bodies are divided.
#[derive(Debug, Clone, PartialEq)]
pub struct MeshSettings {
    /// Element of the cells.
    pub element: ElementKind,
    /// Division along the contact edges.
    pub division: Division,
    /// Radial layers, or layers in depth; chosen from the division where it is `None`.
    pub layers: Option<usize>,
    /// By how many times cells of a general outline that no division of edges rules are smaller than usual `[1]`.
    pub fineness: f64,
}

impl MeshSettings {
    /// The settings with corner nodes twice as close.
    #[must_use]
    pub fn finer(&self) -> Self {
        let Self {
            element,
            division,
            layers,
            fineness,
        } = self;
        Self {
            element: *element,
            division: division.finer(),
            layers: layers.map(|layers| 2 * layers),
            fineness: 2.0 * fineness,
        }
    }

    /// The settings with corner nodes twice as far apart.
    #[must_use]
    pub fn coarser(&self) -> Self {
        let Self {
            element,
            division,
            layers,
            fineness,
        } = self;
        Self {
            element: *element,
            division: division.coarser(),
            layers: layers.map(|layers| layers.div_ceil(2)),
            fineness: fineness / 2.0,
        }
    }
}

/// Where the corner nodes of a contact edge lie.
#[derive(Debug, Clone, PartialEq)]
pub enum Division {
    /// At these angles `[rad]`, strictly increasing from 0 to at most 2π.
    AngleList(Vec<f64>),
    /// By angles `[rad]` from the bearing point θ = 0.
    Angular(Grading),
    /// By lengths `[mm]` from the point of first contact.
    Linear(Grading),
    /// At these places x `[mm]` along a line contact, strictly increasing, from one end of the edge to the other or from 0 to the end of a half.
    Places(Vec<f64>),
}

impl fmt::Display for Division {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::AngleList(angles) => write!(formatter, "{} angles", angles.len()),
            Self::Angular(grading) => {
                let degrees = grading.spacing.to_degrees();
                write!(formatter, "spacing {} deg", short(degrees))
            }
            Self::Linear(grading) => write!(formatter, "spacing {} mm", short(grading.spacing)),
            Self::Places(places) => write!(formatter, "{} places", places.len()),
        }
    }
}

impl Division {
    fn finer(&self) -> Self {
        match self {
            Self::AngleList(angles) => Self::AngleList(halved(angles)),
            Self::Places(places) => Self::Places(halved(places)),
            Self::Angular(grading) => Self::Angular(grading.scaled(0.5)),
            Self::Linear(grading) => Self::Linear(grading.scaled(0.5)),
        }
    }

    fn coarser(&self) -> Self {
        match self {
            Self::AngleList(angles) => {
                let mut kept: Vec<f64> = angles.iter().step_by(2).copied().collect();
                // A list ends at π, or goes around with an even number of angles.
                let goes_around = angles.last().is_some_and(|last| *last > PI + 1e-9);
                let is_odd = !kept.len().is_multiple_of(2);
                let ends = if goes_around {
                    is_odd
                } else {
                    angles.len().is_multiple_of(2)
                };
                kept.extend(angles.last().filter(|_| ends));
                Self::AngleList(kept)
            }
            Self::Angular(grading) => Self::Angular(grading.scaled(2.0)),
            Self::Linear(grading) => Self::Linear(grading.scaled(2.0)),
            Self::Places(places) => {
                let inner = places.iter().step_by(2).copied();
                let end = places.last().filter(|_| places.len().is_multiple_of(2));
                Self::Places(inner.chain(end.copied()).collect())
            }
        }
    }
}

/// `values` with their midpoints.
fn halved(values: &[f64]) -> Vec<f64> {
    let pairs = values.windows(2);
    let between = pairs.flat_map(|pair| [pair[0], f64::midpoint(pair[0], pair[1])]);
    between.chain(values.last().copied()).collect()
}

/// Equal spacing, and optionally coarser beyond some distance.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Grading {
    /// Spacing of corner nodes `[rad or mm]`.
    pub spacing: f64,
    /// Up to where, measured from the bearing point `[rad or mm]`; everywhere if `None`.
    pub fine_to: Option<f64>,
    /// Spacing that it grows to beyond `[rad or mm]`; chosen by the generator if `None`.
    pub coarse_spacing: Option<f64>,
}

impl Grading {
    /// Spacings times `factor`.
    fn scaled(self, factor: f64) -> Self {
        let Self {
            spacing,
            fine_to,
            coarse_spacing,
        } = self;
        Self {
            spacing: factor * spacing,
            fine_to,
            coarse_spacing: coarse_spacing.map(|spacing| factor * spacing),
        }
    }
}

/// `[mesh]`, or what differs from it in `[bodies.NAME.mesh]`.
#[derive(Debug, Clone, Default, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct MeshFormat {
    pub(crate) element: Option<ElementKind>,
    pub(crate) spacing: Option<Quantity<AngleOrLength>>,
    pub(crate) angles: Option<Vec<Quantity<Angle>>>,
    pub(crate) fine_to: Option<Quantity<AngleOrLength>>,
    pub(crate) coarse_spacing: Option<Quantity<AngleOrLength>>,
    pub(crate) layers: Option<usize>,
}

impl MeshFormat {
    /// The settings of this division.
    pub(crate) fn settings(&self, division: Division) -> MeshSettings {
        // The keys that are named `_` make the division.
        let Self {
            element,
            spacing: _,
            angles: _,
            fine_to: _,
            coarse_spacing: _,
            layers,
        } = *self;
        MeshSettings {
            element: element.unwrap_or(DEFAULT_ELEMENT),
            division,
            layers,
            fineness: 1.0,
        }
    }
}

/// Element of cells where the scene names none.
pub(crate) const DEFAULT_ELEMENT: ElementKind = ElementKind::Q8;

/// `[mesh]`.
#[rustfmt::skip]
const MESH: [Key; 6] = [
    names("element", elements, r#"`"Q8"`"#, r#""Q4""#, "element of the cells"),
    spacing("spacing", "required, or `angles`", r#""2 deg""#,
        "spacing of nodes: round shapes, an angle on the contact circle at θ = 0; cylinder and block, a length at the contact \
        point; rectangle, a length everywhere; an angle is at most 45 deg").range(POSITIVE),
    angles("angles", NONE, r#"["0 deg", "30 deg", "60 deg", "90 deg", "120 deg", "150 deg", "180 deg"]"#,
        "the nodes of the contact circle themselves, increasing from 0 deg: to 180 deg, mirrored in a whole model; or around \
        to below 360 deg, for whole models only; a strip needs nodes near the directions of its corners"),
    spacing("fine_to", "everywhere; line contact: half_length/8", r#""100 deg""#,
        "distance from θ = 0 or from the contact point, to both sides, up to which `spacing` holds; beyond it the spacing \
        grows from cell to cell by 15 % on circles and 12 % in line contacts; not of rectangles").range(POSITIVE),
    spacing("coarse_spacing", "4 × `spacing`", r#""9 deg""#,
        "on circles the spacing that it grows to; needs `fine_to`").range(POSITIVE),
    integer("layers", "by the number of angles and the width of a ring, for cells about as deep as wide", "24",
        "layers of cells around the hole of a plate or ring; other shapes choose their own").range(FROM_ONE),
];

/// `[bodies.NAME.mesh]`: what differs from there.
const OWN_MESH: &[Key] = &with_default(MESH, "of the scene");

const DIVISIONS: &[&[&str]] = &[&["spacing", "fine_to", "coarse_spacing"], &["angles"]];
const DIVISION_CHOICES: &str = r#"spacing = "2 deg", angles = ["0 deg", …]"#;
const FROM_ONE: Range = numbers(" ≥ 1", "at least 1", |value| value >= 1.0);

#[rustfmt::skip]
pub(crate) const TABLES: &[Table] = &[
    Table::new("bodies.NAME.mesh", OWN_MESH).at_most_one_of(DIVISIONS, DIVISION_CHOICES),
    Table::new("mesh", &MESH).one_of(DIVISIONS, DIVISION_CHOICES),
];

/// The names of the elements.
fn elements() -> String {
    quoted(ElementKind::ALL.iter().map(|kind| kind.name()))
}

impl MeshFormat {
    /// Whether it has a key of the division.
    pub(crate) fn divides(&self) -> bool {
        let Self {
            element: _,
            spacing,
            angles,
            fine_to,
            coarse_spacing,
            layers: _,
        } = self;
        spacing.is_some() || angles.is_some() || fine_to.is_some() || coarse_spacing.is_some()
    }
}

/// What a body's own settings and those of the scene make together. A spacing of its own keeps the fine zone of the scene where
/// that is possible; a list of angles says everything.
pub(crate) fn merged(own: &MeshFormat, whole: &MeshFormat) -> MeshFormat {
    let divides = own.spacing.is_some() || own.angles.is_some();
    let fits = |fine_to: &Quantity<AngleOrLength>| match (&own.spacing, &own.angles) {
        (Some(spacing), None) => {
            fine_to.dimension() == spacing.dimension() && fine_to.value() >= spacing.value()
        }
        (None, None) => true,
        (_, Some(_)) => false,
    };
    // Without `..` on either side, so that a new key is neither lost here nor kept by chance.
    let MeshFormat {
        element,
        spacing,
        angles,
        fine_to,
        coarse_spacing,
        layers,
    } = whole.clone();
    let own = own.clone();
    MeshFormat {
        element: own.element.or(element),
        spacing: own.spacing.or(spacing.filter(|_| !divides)),
        angles: own.angles.or(angles.filter(|_| !divides)),
        fine_to: own.fine_to.or(fine_to.filter(fits)),
        coarse_spacing: own.coarse_spacing.or(coarse_spacing.filter(|_| !divides)),
        layers: own.layers.or(layers),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Round bodies have an even number of angles all around, and lists of a half end at π.
    #[test]
    fn coarser_lists_of_angles_make_meshes_too() {
        for count in [340, 342, 360, 362] {
            let step = 2.0 * PI / f64::from(count);
            let around = Division::AngleList((0..count).map(|k| step * f64::from(k)).collect());
            let Division::AngleList(kept) = around.coarser() else {
                unreachable!();
            };
            assert!(kept.len().is_multiple_of(2) && kept.len() < 200, "{count}");
        }
        for count in [30, 31] {
            let step = PI / f64::from(count);
            let half = Division::AngleList((0..=count).map(|k| step * f64::from(k)).collect());
            let Division::AngleList(kept) = half.coarser() else {
                unreachable!();
            };
            assert!((kept[kept.len() - 1] - PI).abs() < 1e-12 && kept.len() < 20);
        }
    }
}
