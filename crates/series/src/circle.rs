//! The circle of a body, its material, and the closed-form part of its compliance.
//!
//! ```text
//! u(θ) = (R/2G) Σ_K g_K q_K e^{iKθ}     tractions q = Σ q_K e^{iKθ} on the body, u and q as x + iy
//! hole: g_K = 1/K,  g_−K = κ/K          disk: g_K = κ/K,  g_−K = 1/K  (K ≥ 1), but for the modes that balance alone
//! C_ij = (1/4πGt) [a −b; b a],          a = (1 + κ) L_ij,  b = ±(1 − κ) S_ij  (+: hole)
//! ```
//!
//! In x and y instead of r and θ the response of mode K has that mode alone, so C depends on differences of angles only. G is the shear
//! modulus, κ = (3 − ν)/(1 + ν) in plane stress and 3 − 4ν in plane strain.

use std::f64::consts::PI;

use nalgebra::{DMatrix, DVector};
use stickslip_fem_core::interface::rigid_motions;
use stickslip_fem_core::material::{Isotropic, PlaneState};
use stickslip_fem_core::mesh::Point;

use crate::error::SeriesError;
use crate::kernel::Means;
use crate::nodes::Nodes;

/// A circle in a body, and the body's thickness.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Circle {
    /// Its centre `[length]`.
    pub centre: Point,
    /// Its radius R `[length]`.
    pub radius: f64,
    /// Thickness t of the body `[length]`.
    pub thickness: f64,
}

impl Circle {
    /// # Errors
    /// [`SeriesError::Length`] unless radius and thickness are positive and finite, and the centre is finite.
    pub(crate) fn checked(self) -> Result<Self, SeriesError> {
        for (what, value) in [("radius", self.radius), ("thickness", self.thickness)] {
            positive(what, value)?;
        }
        let finite = self.centre.into_iter().find(|value| !value.is_finite());
        finite.map_or(Ok(self), |value| {
            Err(SeriesError::Length {
                what: "centre's coordinate",
                value,
            })
        })
    }

    /// Where the nodal forces of `nodes` act `[length]`.
    pub(crate) fn places(&self, nodes: &Nodes) -> Vec<Point> {
        let unit = nodes.places().into_iter();
        unit.map(|[x, y]| {
            [
                self.centre[0] + self.radius * x,
                self.centre[1] + self.radius * y,
            ]
        })
        .collect()
    }

    /// Translations along x and y, and the turn about the centre divided by the radius, of the nodes at `places`; of a half model the
    /// translation along x.
    pub(crate) fn motions(&self, nodes: &Nodes, places: &[Point]) -> DMatrix<f64> {
        let motions = rigid_motions(places, self.centre, self.radius);
        if nodes.is_mirrored() {
            motions.columns(0, 1).into_owned()
        } else {
            motions
        }
    }

    /// Resultants of a `force` `[force]` through the centre and a `moment` `[force·length]` in all [`motions`](Self::motions); those on the half
    /// of a half model.
    pub(crate) fn resultants(&self, nodes: &Nodes, force: [f64; 2], moment: f64) -> DVector<f64> {
        if nodes.is_mirrored() {
            DVector::from_element(1, 0.5 * force[0])
        } else {
            DVector::from_vec(vec![force[0], force[1], moment / self.radius])
        }
    }
}

/// Checks numbers of a load: name, value, whether it breaks the symmetry of a half model.
pub(crate) fn check_load(
    case: usize,
    mirrored: bool,
    values: &[(&'static str, f64, bool)],
) -> Result<(), SeriesError> {
    for &(what, value, skew) in values {
        if !value.is_finite() {
            return Err(SeriesError::LoadNotFinite { case, what, value });
        }
        if mirrored && skew && value != 0.0 {
            return Err(SeriesError::NotSymmetric { case, what, value });
        }
    }
    Ok(())
}

pub(crate) fn positive(what: &'static str, value: f64) -> Result<f64, SeriesError> {
    if value > 0.0 && value.is_finite() {
        Ok(value)
    } else {
        Err(SeriesError::Length { what, value })
    }
}

/// Kolosov's constants of an isotropic body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Kolosov {
    /// Shear modulus G `[stress]`.
    pub(crate) shear: f64,
    /// κ.
    pub(crate) kappa: f64,
}

impl From<&Isotropic> for Kolosov {
    fn from(material: &Isotropic) -> Self {
        let nu = material.poisson();
        let kappa = match material.state() {
            PlaneState::Stress => (3.0 - nu) / (1.0 + nu),
            PlaneState::Strain => 3.0 - 4.0 * nu,
        };
        Self {
            shear: material.shear(),
            kappa,
        }
    }
}

/// Which side of the circle the body is on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Side {
    /// Outside: a hole.
    Outside,
    /// Inside: a disk.
    Inside,
}

/// How a circle's edge gives: u(θ) = (R/π) ∫ (A L − B S) q dφ with the symmetric matrix A and B = [0 odd; −odd 0] `[1/stress]`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Surface {
    /// A.
    pub(crate) log: [[f64; 2]; 2],
    /// The entry xy of B.
    pub(crate) odd: f64,
}

impl Surface {
    /// That of an isotropic body, A = (1 + κ)/4G, B = ±(1 − κ)/4G.
    pub(crate) fn new(material: Kolosov, side: Side) -> Self {
        let kappa = material.kappa;
        let unit = 0.25 / material.shear;
        let log = unit * (1.0 + kappa);
        let odd = match side {
            Side::Outside => unit * (1.0 - kappa),
            Side::Inside => unit * (kappa - 1.0),
        };
        Self {
            log: [[log, 0.0], [0.0, log]],
            odd,
        }
    }

    /// u by a unit traction from the means L and S, times π.
    pub(crate) fn at(&self, [log, odd]: [f64; 2]) -> [[f64; 2]; 2] {
        let [[a, b], [c, d]] = self.log.map(|row| row.map(|value| value * log));
        let turn = self.odd * odd;
        [[a, b - turn], [c + turn, d]]
    }
}

/// The compliance `[length/force]` of the kernels L and S, 2n × 2n.
pub(crate) fn compliance(nodes: &Nodes, surface: Surface, thickness: f64) -> DMatrix<f64> {
    let means = Means::new(nodes);
    let symmetry = Symmetry {
        mirrored: nodes.is_mirrored(),
        across: 1,
    };
    symmetry.assembled(
        nodes.len(),
        1.0 / (PI * thickness),
        |node| nodes.on_axis(node),
        |row, column, of_image| {
            let knot = if of_image {
                nodes.knots()[column].image
            } else {
                column
            };
            surface.at(means.at(row, knot))
        },
    )
}

/// How a half model stands for the whole.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Symmetry {
    pub(crate) mirrored: bool,
    /// The axis across the line of symmetry, 0 for x and 1 for y.
    pub(crate) across: usize,
}

impl Symmetry {
    /// The compliance of `count` nodes whose blocks are `unit` times `block(row, column, false)`, of a half model with those of the images of the columns.
    pub(crate) fn assembled(
        self,
        count: usize,
        unit: f64,
        on_axis: impl Fn(usize) -> bool,
        block: impl Fn(usize, usize, bool) -> [[f64; 2]; 2],
    ) -> DMatrix<f64> {
        let Self { mirrored, across } = self;
        let mut matrix = DMatrix::zeros(2 * count, 2 * count);
        for j in 0..count {
            for i in 0..count {
                let mut entries = block(i, j, false);
                if mirrored {
                    // A force on the half has its image on the other half, reversed across; both are one place on the axis.
                    for (row, image) in entries.iter_mut().zip(block(i, j, true)) {
                        row[1 - across] += image[1 - across];
                        row[across] -= image[across];
                    }
                    if on_axis(i) {
                        entries[across] = [0.0; 2];
                    }
                    if on_axis(j) {
                        entries[0][across] = 0.0;
                        entries[1][across] = 0.0;
                    }
                }
                for row in 0..2 {
                    for column in 0..2 {
                        matrix[(2 * i + row, 2 * j + column)] = unit * entries[row][column];
                    }
                }
            }
        }
        matrix
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::channel::{Channel, Unit, channels, hat_means, sides};

    /// Σ_K V g_K Vᵀ up to an order whose rest is below 4/(hn)⁴ of the smallest weight.
    fn by_modes(nodes: &Nodes, material: Kolosov, side: Side) -> DMatrix<f64> {
        const ORDERS: i64 = 3000;
        let orders = (-ORDERS..=ORDERS).filter(|order| *order != 0);
        let channels = channels(nodes, orders);
        let means = hat_means(nodes, &channels);
        let mut weighted = means.clone();
        for (column, Channel { order, .. }) in channels.iter().enumerate() {
            let first = (*order > 0) == (side == Side::Outside);
            let factor = if first { 1.0 } else { material.kappa };
            weighted
                .column_mut(column)
                .scale_mut(factor / order.unsigned_abs() as f64);
        }
        let unit = sides(nodes) / (4.0 * PI * material.shear);
        weighted * means.transpose() * unit
    }

    #[test]
    fn the_closed_form_is_the_sum_of_modes() {
        let material = Kolosov {
            shear: 0.7,
            kappa: 2.1,
        };
        let angles = vec![0.0, 0.4, 0.7, 0.9, 1.5, 2.2, 2.6, PI];
        for nodes in [
            Nodes::uniform_half(12).unwrap(),
            Nodes::uniform_circle(11).unwrap(),
            Nodes::mirrored(angles).unwrap(),
        ] {
            for side in [Side::Outside, Side::Inside] {
                let found = compliance(&nodes, Surface::new(material, side), 1.0);
                let expected = by_modes(&nodes, material, side);
                let error = (&found - expected).amax() / found.amax();
                assert!(error < 1e-9, "{side:?} {error:e}");
            }
        }
        assert_eq!(Unit::of(&Nodes::uniform_circle(9).unwrap()).len(), 2);
    }

    #[test]
    fn a_body_without_size_is_refused() {
        let circle = Circle {
            centre: [0.0, 0.0],
            radius: 0.0,
            thickness: 1.0,
        };
        let error = |circle: Circle| circle.checked().unwrap_err();
        assert_eq!(
            error(circle).to_string(),
            "the radius is 0, not a positive length"
        );
        let nowhere = Circle {
            centre: [f64::NAN, 0.0],
            radius: 1.0,
            ..circle
        };
        assert!(matches!(
            error(nowhere),
            SeriesError::Length { what: "centre's coordinate", value } if value.is_nan()
        ));
    }
}
