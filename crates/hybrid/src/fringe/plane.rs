//! Carrier and rigid-body motion: planes; and constants from known orders.

use stickslip_fem_core::mesh::Point;

use super::{FringeError, PixelMap, Unwrapped};
use crate::least_squares;

/// Orders linear in the place: a carrier, a rigid-body motion, or both.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Plane {
    /// Gradient (k_x, k_y) `[fringes/length]`.
    pub gradient: [f64; 2],
    /// Order at the origin `[fringes]`.
    pub constant: f64,
}

/// A plane of least squares.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlaneFit {
    /// The plane.
    pub plane: Plane,
    /// Pixels that it was fitted to.
    pub pixels: usize,
    /// Root mean square of what remains there `[fringes]`.
    pub remainder: f64,
}

impl Plane {
    /// Order at a place `[fringes]`.
    pub fn at(&self, place: Point) -> f64 {
        self.gradient[0] * place[0] + self.gradient[1] * place[1] + self.constant
    }

    /// Orders less the plane: a known carrier, or a fitted rigid-body motion, subtracted.
    ///
    /// # Errors
    ///
    /// A plane that is not finite.
    pub fn removed_from(&self, orders: &PixelMap) -> Result<PixelMap, FringeError> {
        orders.mapped(|pixel, order| order - self.at(orders.frame().place(pixel)))
    }

    /// Plane of least squares to the orders `[fringes]` of a region of places `[length]`.
    ///
    /// # Errors
    ///
    /// A region whose pixels do not span a plane.
    pub fn fit(orders: &PixelMap, region: impl Fn(Point) -> bool) -> Result<PlaneFit, FringeError> {
        /// One row of pixels leaves rounding in the determinant; two rows of a million columns leave 1e-12 of the product of moments.
        const FLAT: f64 = 1e-14;
        let frame = orders.frame();
        let data = orders
            .present()
            .map(|(pixel, order)| (frame.place(pixel), order))
            .filter(|(place, _)| region(*place));
        let data: Vec<(Point, f64)> = data.collect();
        let pixels = data.len();
        let fit = least_squares::Plane::fit(data.into_iter(), FLAT).filter(|_| pixels >= 3);
        let fit = fit.ok_or(FringeError::NoPlane { pixels })?;
        Ok(PlaneFit {
            plane: Self {
                gradient: fit.gradient,
                constant: fit.at([0.0; 2]),
            },
            pixels,
            remainder: fit.left,
        })
    }
}

/// A place whose order is known.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct KnownOrder {
    /// The place `[length]`.
    pub place: Point,
    /// Its order `[fringes]`.
    pub order: f64,
}

/// What a constant may be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Constant {
    /// Whole numbers: parts of a fringe are measured absolutely.
    Whole,
    /// Any number: the phase of the picture has no zero.
    Any,
}

impl Unwrapped {
    /// Orders whose constant, in each region, is the one that known orders in it ask for (their mean; between pixels orders are
    /// interpolated bilinearly, at a rim the nearest of the four counts). Regions without a known order are missing.
    ///
    /// # Errors
    ///
    /// A known order at a place without pixels; known orders of a region that differ by half a fringe or more; none at all.
    pub fn fixed(&self, known: &[KnownOrder], constant: Constant) -> Result<PixelMap, FringeError> {
        let mut shifts: Vec<Vec<(f64, Point)>> = vec![Vec::new(); self.regions.len()];
        for entry in known {
            let (region, order) = self
                .order_at(entry.place)
                .ok_or(FringeError::NoOrderAt { place: entry.place })?;
            let shift = entry.order - order;
            if let Some(&(first, place)) = shifts[region].first() {
                let difference = shift - first;
                if difference.is_nan() || difference.abs() >= 0.5 {
                    return Err(FringeError::KnownOrders {
                        first: place,
                        second: entry.place,
                        difference,
                    });
                }
            }
            shifts[region].push((shift, entry.place));
        }
        let mean = |found: &Vec<(f64, Point)>| {
            let mean = found.iter().map(|(shift, _)| shift).sum::<f64>() / found.len() as f64;
            (!found.is_empty()).then(|| {
                if constant == Constant::Whole {
                    mean.round()
                } else {
                    mean
                }
            })
        };
        let shifts: Vec<_> = shifts.iter().map(mean).collect();
        let shift_of =
            |pixel: usize| self.region_of[pixel].and_then(|region| shifts[region as usize]);
        let values = self
            .orders
            .values()
            .iter()
            .enumerate()
            .map(|(pixel, order)| order + shift_of(pixel).unwrap_or(f64::NAN));
        let valid = (0..self.region_of.len())
            .map(|pixel| shift_of(pixel).is_some())
            .collect();
        PixelMap::new(*self.orders.frame(), values.collect(), valid)
    }

    /// Region and order at a place among pixels.
    fn order_at(&self, place: Point) -> Option<(usize, f64)> {
        let frame = self.orders.frame();
        let position = frame.position(place);
        let sizes = [frame.columns(), frame.rows()];
        let inside =
            (0..2).all(|axis| position[axis] >= -0.5 && position[axis] <= sizes[axis] as f64 - 0.5);
        if !inside {
            return None;
        }
        let base = [0, 1].map(|axis| {
            (position[axis].max(0.0).floor() as usize).min(sizes[axis].saturating_sub(2))
        });
        let corner = |shift: [usize; 2]| {
            let [column, row] = [base[0] + shift[0], base[1] + shift[1]];
            let pixel = row * sizes[0] + column;
            let region = if column < sizes[0] && row < sizes[1] {
                self.region_of[pixel]?
            } else {
                return None;
            };
            Some((
                region,
                self.orders.values()[pixel],
                [
                    (position[0] - column as f64).abs(),
                    (position[1] - row as f64).abs(),
                ],
            ))
        };
        let corners = [[0, 0], [1, 0], [0, 1], [1, 1]].map(corner);
        let found = || corners.iter().flatten();
        let nearest =
            found().min_by(|a, b| a.2[0].hypot(a.2[1]).total_cmp(&b.2[0].hypot(b.2[1])))?;
        let region = nearest.0;
        let rim = found()
            .filter(|entry| entry.0 == region && entry.2.iter().all(|&away| away <= 1.0))
            .count()
            < 4;
        let bilinear = || {
            found()
                .map(|entry| entry.1 * (1.0 - entry.2[0]) * (1.0 - entry.2[1]))
                .sum()
        };
        Some((region as usize, if rim { nearest.1 } else { bilinear() }))
    }
}
