//! What a fit is asked for, and what its terms do.

use nalgebra::{Complex, DMatrix};

use crate::channel::{Channel, Unit};
use crate::elasticity::Elasticity;
use crate::outline::Surrounding;

type C64 = Complex<f64>;

/// What the fit is asked for.
pub(crate) struct Task<'a> {
    pub(crate) surrounding: &'a Surrounding,
    pub(crate) units: &'a [Unit],
    /// Largest |K| of the hole's modes.
    pub(crate) orders: i64,
    /// These modes.
    pub(crate) channels: &'a [Channel],
    pub(crate) elasticity: &'a Elasticity,
    /// Tractions on each edge by load case `[stress]`, x + iy.
    pub(crate) tractions: &'a [Vec<C64>],
    /// Tractions t on the hole that balance each load case, by channels.
    pub(crate) reactions: &'a DMatrix<f64>,
}

/// What terms do.
pub(super) struct Drawn {
    /// Tractions at the points of the fit and at those that check it, of the hole's modes with unit tractions on the hole, 2 points × channels.
    pub(super) hole: [DMatrix<f64>; 2],
    /// The same of the terms without the series that keep the hole free, 2 points × terms.
    pub(super) terms: [DMatrix<f64>; 2],
    /// Tractions t on the hole of unit terms' own series, channels × terms.
    pub(super) answers: DMatrix<f64>,
    /// Displacements of the hole's edge by unit terms, channels × terms.
    pub(super) displacements: DMatrix<f64>,
}

/// Real and imaginary part of `value` in two rows of each point.
pub(super) fn rows(
    points: usize,
    columns: usize,
    mut value: impl FnMut(usize, usize) -> C64,
) -> DMatrix<f64> {
    let mut matrix = DMatrix::zeros(2 * points, columns);
    for column in 0..columns {
        for point in 0..points {
            let z = value(point, column);
            matrix[(2 * point, column)] = z.re;
            matrix[(2 * point + 1, column)] = z.im;
        }
    }
    matrix
}
