//! Finite rotation of a specimen between two pictures.
//!
//! ```text
//! x = c + t + R(φ) (X − c + w),      u = x − X
//! w = Rᵀ (X − c + u − t) − (X − c)                 places X before the deformation
//! w = (Rᵀ − 1)(x − c) + u,   X − c = Rᵀ (x − c)    places x after it, t in u
//! ```
//!
//! w is the displacement that loads make, in the frame of the specimen. In small-strain theory a rotation strains nothing, but the
//! displacement of a finite rotation includes the contraction cos φ − 1 along both axes, 6e-6 at 0.2°, and turns w against its places.
//!
//! The angle is that of the polar decomposition F = R U of the mean deformation gradient: of 1 + ∇u of the planes of least squares through
//! both components over X, of (1 − ∇u)⁻¹ over x. It includes the mean rotation due to the loads, of the order of the strains, which no data
//! separate from a rigid one and no stress depends on. A rotation of all data adds to it exactly, so that w stays as it is.

use stickslip_fem_core::mesh::Point;

use super::{Measurement, Places};
use crate::least_squares::Plane;

/// Part of its standard deviation by which a displacement may be wrong where the other component of its place is not known.
const NEGLIGIBLE: f64 = 0.1;

/// Part of the largest second moment of the places that the smallest must be.
const FLAT: f64 = 1e-9;

/// A rotation, counter-clockwise.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rotation {
    /// Its angle φ `[rad]`.
    pub angle: f64,
    /// Standard deviation of the angle by independent errors of the data `[rad]`.
    pub deviation: f64,
}

impl Measurement {
    /// Mean rotation of the displacements at places `moved`; `None` where a component is missing or its places lie on a line.
    pub fn rotation(&self, moved: Places) -> Option<Rotation> {
        let [u, v] = [self.plane(0)?, self.plane(1)?];
        let sign = match moved {
            Places::Reference => 1.0,
            Places::Deformed => -1.0,
        };
        let sine = v.gradient[0] - u.gradient[1];
        let cosine = 2.0 + sign * (u.gradient[0] + v.gradient[1]);
        let variance =
            self.deviation[0].powi(2) * u.inverse[1] + self.deviation[1].powi(2) * v.inverse[0];
        Some(Rotation {
            angle: sine.atan2(cosine),
            deviation: variance.sqrt() / sine.hypot(cosine),
        })
    }

    /// Displacements in the frame of a specimen that has turned by `angle` `[rad]` about `centre` `[length]`, whose translation is kept;
    /// and how many displacements are masked for it.
    ///
    /// Places before the deformation stay, and displacements turn back. Where one component alone is valid, the other one is taken from
    /// its plane; the displacement is masked where that may be wrong by more than a tenth of its standard deviation. Places after the
    /// deformation turn back themselves.
    #[must_use]
    pub fn turned_back(&self, angle: f64, centre: Point, moved: Places) -> (Self, usize) {
        let (sine, cosine) = angle.sin_cos();
        // cos φ − 1 without the loss of its digits.
        let less = -2.0 * (0.5 * angle).sin().powi(2);
        // Rᵀ − 1.
        let change = |[x, y]: [f64; 2]| [less * x + sine * y, less * y - sine * x];
        let mut turned = self.clone();
        if moved == Places::Deformed {
            for (k, place) in turned.places.iter_mut().enumerate() {
                let added = change([place[0] - centre[0], place[1] - centre[1]]);
                for c in 0..2 {
                    turned.displacements[c][k] += added[c];
                    place[c] += added[c];
                }
            }
            return (turned, 0);
        }
        let planes = [self.plane(0), self.plane(1)];
        let at = |c: usize, place: Point| planes[c].as_ref().map(|plane| plane.at(place));
        let kept = [0, 1].map(|c| at(c, centre).unwrap_or(0.0));
        let mut masked = 0;
        for (k, &place) in self.places.iter().enumerate() {
            let valid = [self.valid[0][k], self.valid[1][k]];
            let moved = std::array::from_fn(|c| {
                let value = Some(self.displacements[c][k]).filter(|_| valid[c]);
                value.or_else(|| at(c, place)).unwrap_or(f64::NAN) - kept[c]
            });
            let by_place = change([place[0] - centre[0], place[1] - centre[1]]);
            let by_motion = change(moved);
            for c in (0..2).filter(|&c| valid[c]) {
                let unknown = planes[1 - c].as_ref().map_or(f64::INFINITY, |own| own.left);
                if valid[1 - c] || sine.abs() * unknown <= NEGLIGIBLE * self.deviation[c] {
                    turned.displacements[c][k] += by_place[c] + by_motion[c];
                } else {
                    turned.valid[c][k] = false;
                    turned.displacements[c][k] = f64::NAN;
                    masked += 1;
                }
            }
        }
        let [u, v] = self.deviation;
        if u > 0.0 && v > 0.0 {
            turned.deviation = [(cosine * u).hypot(sine * v), (cosine * v).hypot(sine * u)];
        }
        (turned, masked)
    }

    fn plane(&self, component: usize) -> Option<Plane> {
        let valid = (0..self.places.len()).filter(|&k| self.valid[component][k]);
        let data = valid.map(|k| (self.places[k], self.displacements[component][k]));
        Plane::fit(data, FLAT)
    }
}
