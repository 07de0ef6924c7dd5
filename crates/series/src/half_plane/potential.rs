//! The potential of tractions that are linear between nodes.
//!
//! ```text
//! element a to b, h = b − a, w_a = a − z, w_b = b − z, Λ = ln(w_b/w_a), N rising from a to b or falling:
//! ∫ N/(ξ − z)  = 1 − w_a Λ/h,  w_b Λ/h − 1;      ∫ N/(ξ − z)² = Λ/h − 1/w_b,  1/w_a − Λ/h
//! ```
//!
//! Farther away than some lengths of an element, where these cancel, Gauss's rule has all digits.

use std::f64::consts::PI;

use nalgebra::{Complex, DMatrix};
use stickslip_fem_core::mesh::Point;

use crate::error::SeriesError;
use crate::gauss::Rules;

type C64 = Complex<f64>;

/// Distance in lengths of an element from which on Gauss's rules have all digits and closed forms lose some.
const FAR: f64 = 2.5;
/// Part of the length of the edge up to which a place is on the edge.
const ON_EDGE: f64 = 1e-12;

/// What a field is made of besides its tractions.
#[derive(Clone, Copy, Debug)]
pub(super) struct Constants {
    /// 1 below the axis, −1 above it.
    pub(super) outward: f64,
    pub(super) kappa: f64,
    /// 1/2G.
    pub(super) unit: f64,
    /// ℓ.
    pub(super) reference: f64,
    /// Rigid motion along x and y.
    pub(super) motion: [f64; 2],
}

/// Stresses and displacements anywhere in a half-plane.
#[derive(Clone, Debug)]
pub struct HalfPlaneField {
    knots: Vec<f64>,
    /// q at each of the knots `[stress]`.
    tractions: Vec<C64>,
    rules: Rules,
    of: Constants,
}

/// Φ, φ and Φ′ at a place.
#[derive(Clone, Copy, Default)]
struct Potential {
    value: C64,
    integral: C64,
    slope: C64,
}

impl HalfPlaneField {
    pub(super) fn new(knots: &[f64], tractions: &[[f64; 2]], of: Constants) -> Self {
        Self {
            knots: knots.to_vec(),
            tractions: tractions.iter().map(|&[x, y]| C64::new(x, y)).collect(),
            rules: Rules::new(),
            of,
        }
    }

    /// Stress (xx, yy, xy) `[stress]` at `point` `[length]`.
    ///
    /// # Errors
    /// [`SeriesError::OutsideBody`] for a point that the body does not have.
    pub fn stress(&self, point: Point) -> Result<[f64; 3], SeriesError> {
        let z = self.inside(point)?;
        if z.im == 0.0 {
            return Ok(self.on_edge(z.re));
        }
        let own = self.potential(z, self.of.outward, false);
        let image = self.potential(z.conj(), -self.of.outward, false);
        let normal = own.value - image.value + (z - z.conj()) * own.slope.conj();
        Ok([4.0 * own.value.re - normal.re, normal.re, -normal.im])
    }

    /// Displacement along x and y `[length]` at `point` `[length]`, counted as those of the operator.
    ///
    /// # Errors
    /// [`SeriesError::OutsideBody`] for a point that the body does not have.
    pub fn displacement(&self, point: Point) -> Result<[f64; 2], SeriesError> {
        let z = self.inside(point)?;
        let own = self.potential(z, self.of.outward, true);
        let image = self.potential(z.conj(), -self.of.outward, true);
        let turn = if z.im == 0.0 {
            C64::default()
        } else {
            (z - z.conj()) * own.value.conj()
        };
        // ℓ is that of L: (κ + 1) ln ℓ of the net force.
        let moved = self.of.kappa * own.integral + image.integral - turn
            + self.total() * ((self.of.kappa + 1.0) * self.of.reference.ln() / (2.0 * PI));
        let moved = moved * self.of.unit;
        Ok([moved.re + self.of.motion[0], moved.im + self.of.motion[1]])
    }

    /// A point of the body, of the edge without an imaginary part.
    fn inside(&self, point: Point) -> Result<C64, SeriesError> {
        let [x, y] = point;
        let near = ON_EDGE * (self.knots[self.knots.len() - 1] - self.knots[0]);
        if self.of.outward * y > near {
            return Err(SeriesError::OutsideBody { point });
        }
        Ok(C64::new(x, if y.abs() <= near { 0.0 } else { y }))
    }

    fn on_edge(&self, x: f64) -> [f64; 3] {
        let along: f64 = (edge_kernel(&self.knots, &[x]).iter())
            .zip(&self.tractions)
            .map(|(kernel, q)| kernel * q.re)
            .sum();
        let pairs: Vec<[f64; 2]> = self.tractions.iter().map(|q| [q.re, q.im]).collect();
        let [shear, normal] = between(&self.knots, &pairs, x).map(|q| self.of.outward * q);
        [normal + 2.0 / PI * along, normal, shear]
    }

    /// Net traction.
    fn total(&self) -> C64 {
        let parts = self.knots.windows(2).zip(self.tractions.windows(2));
        parts
            .map(|(ends, q)| (q[0] + q[1]) * (0.5 * (ends[1] - ends[0])))
            .sum()
    }

    /// Φ and Φ′, or Φ and φ if `integrated`, at `z`, on the side of the axis with the `outward` direction of a body there. On the edge φ alone.
    fn potential(&self, z: C64, outward: f64, integrated: bool) -> Potential {
        let mut sum = Potential::default();
        // ln(±i(z − ξ)) has its cut on the other side.
        let turned = C64::new(0.0, outward);
        let log = |w: C64| {
            let w = -turned * w;
            C64::new(0.5 * w.norm_sqr().ln(), w.im.atan2(w.re))
        };
        for (ends, q) in self.knots.windows(2).zip(self.tractions.windows(2)) {
            if q.iter().all(|q| q.norm_sqr() == 0.0) {
                continue;
            }
            let length = ends[1] - ends[0];
            let [from, to] = [ends[0] - z, ends[1] - z];
            let slope = (q[1] - q[0]) / length;
            let distance = from.norm_sqr().min(to.norm_sqr()).sqrt() / length;
            if distance > FAR {
                for [part, weight] in self.rules.at(distance) {
                    let w = from + part * length;
                    let q = (q[0] + slope * (part * length)) * (weight * length);
                    let quotient = q * w.conj() / w.norm_sqr();
                    sum.value += quotient;
                    if integrated {
                        sum.integral -= q * log(w);
                    } else {
                        sum.slope += quotient * w.conj() / w.norm_sqr();
                    }
                }
                continue;
            }
            // q = c + s w over w from w_a to w_b: ∫ ln w = w ln w − w, ∫ w ln w = w²(ln w)/2 − w²/4.
            let constant = q[0] - slope * from;
            let primitives = |w: C64| {
                if w.norm_sqr() == 0.0 {
                    return [C64::default(); 2];
                }
                let log = log(w);
                [w * log - w, w * w * (0.5 * log - 0.25)]
            };
            if integrated {
                let ([a0, a1], [b0, b1]) = (primitives(from), primitives(to));
                sum.integral -= constant * (b0 - a0) + slope * (b1 - a1);
            }
            if z.im == 0.0 {
                continue;
            }
            let logs = (to / from).ln();
            sum.value += constant * logs + slope * length;
            sum.slope += constant * (1.0 / from - 1.0 / to) + slope * logs;
        }
        let unit = 1.0 / (2.0 * PI);
        Potential {
            value: sum.value * unit,
            integral: sum.integral * unit,
            slope: sum.slope * unit,
        }
    }
}

/// Values linear between `knots` at `place`, zero beyond.
pub(super) fn between(knots: &[f64], values: &[[f64; 2]], place: f64) -> [f64; 2] {
    let after = knots.partition_point(|knot| *knot < place);
    if after < knots.len() && knots[after] == place {
        return values[after];
    }
    if after == 0 || after == knots.len() {
        return [0.0; 2];
    }
    let part = (place - knots[after - 1]) / (knots[after] - knots[after - 1]);
    [0, 1].map(|axis| (1.0 - part) * values[after - 1][axis] + part * values[after][axis])
}

/// PV∫ N_j/(ξ − x) dξ at each of `places` x, by place and knot.
pub(super) fn edge_kernel(knots: &[f64], places: &[f64]) -> DMatrix<f64> {
    let rules = Rules::new();
    let mut kernel = DMatrix::zeros(places.len(), knots.len());
    for (first, ends) in knots.windows(2).enumerate() {
        let length = ends[1] - ends[0];
        for (row, &place) in places.iter().enumerate() {
            let [from, to] = [ends[0] - place, ends[1] - place];
            let distance = from.abs().min(to.abs()) / length;
            let [falling, rising] = if distance > FAR && from * to > 0.0 {
                let mut sums = [0.0; 2];
                for [part, weight] in rules.at(distance) {
                    let value = weight * length / (from + part * length);
                    sums[0] += (1.0 - part) * value;
                    sums[1] += part * value;
                }
                sums
            } else {
                // At a knot the logarithms of both elements beside it cancel.
                let log = |w: f64| if w == 0.0 { 0.0 } else { w.abs().ln() };
                let logs = log(to) - log(from);
                [to * logs / length - 1.0, 1.0 - from * logs / length]
            };
            kernel[(row, first)] += falling;
            kernel[(row, first + 1)] += rising;
        }
    }
    kernel
}
