//! Planes of least squares, and vectors without what others explain of them.

use stickslip_fem_core::mesh::Point;

/// The plane of least squares through values at places.
pub(crate) struct Plane {
    /// Mean of the places `[length]`.
    pub(crate) middle: Point,
    /// Mean of the values, in their unit.
    pub(crate) mean: f64,
    /// Gradient `[value/length]`.
    pub(crate) gradient: [f64; 2],
    /// Diagonal of the inverse of the places' second moments `[1/length²]`.
    pub(crate) inverse: [f64; 2],
    /// Root mean square of what the plane leaves.
    pub(crate) left: f64,
}

impl Plane {
    /// The plane through `data`, places and values; `None` where the places lie on a line: where the determinant of their second moments is
    /// at most the part `flat` of the square of the largest one.
    pub(crate) fn fit(data: impl Iterator<Item = (Point, f64)> + Clone, flat: f64) -> Option<Self> {
        let count = data.clone().count() as f64;
        let (mut middle, mut mean) = ([0.0; 2], 0.0);
        for (place, value) in data.clone() {
            middle = [middle[0] + place[0] / count, middle[1] + place[1] / count];
            mean += value / count;
        }
        let [mut xx, mut xy, mut yy, mut xu, mut yu] = [0.0; 5];
        for ([x, y], value) in data.clone() {
            let (x, y, u) = (x - middle[0], y - middle[1], value - mean);
            xx += x * x;
            xy += x * y;
            yy += y * y;
            xu += x * u;
            yu += y * u;
        }
        let determinant = xx * yy - xy * xy;
        let largest = xx.max(yy);
        if !determinant.is_finite() || determinant <= flat * largest * largest {
            return None;
        }
        let mut plane = Self {
            middle,
            mean,
            gradient: [
                (yy * xu - xy * yu) / determinant,
                (xx * yu - xy * xu) / determinant,
            ],
            inverse: [yy / determinant, xx / determinant],
            left: 0.0,
        };
        let squares = data.map(|(place, value)| (value - plane.at(place)).powi(2));
        plane.left = (squares.sum::<f64>() / count).sqrt();
        Some(plane)
    }

    /// The plane's value at `place` `[length]`.
    pub(crate) fn at(&self, place: Point) -> f64 {
        let from = [0, 1].map(|axis| place[axis] - self.middle[axis]);
        self.mean + self.gradient[0] * from[0] + self.gradient[1] * from[1]
    }
}

/// The inner product of two vectors.
pub(crate) fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// Takes off `vector` its components along the orthonormal `columns`, twice, so that rounding leaves none; what was taken.
pub(crate) fn orthogonalise(vector: &mut [f64], columns: &[Vec<f64>]) -> Vec<f64> {
    let mut taken = vec![0.0; columns.len()];
    for _ in 0..2 {
        for (column, taken) in columns.iter().zip(&mut taken) {
            let amount = dot(column, vector);
            *taken += amount;
            for (x, q) in vector.iter_mut().zip(column) {
                *x -= amount * q;
            }
        }
    }
    taken
}
