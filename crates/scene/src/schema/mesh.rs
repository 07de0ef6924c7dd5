//! How finely bodies are divided.

use std::f64::consts::PI;
use std::fmt;

use stickslip_fem_core::mesh::ElementKind;
use stickslip_text::short;

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
