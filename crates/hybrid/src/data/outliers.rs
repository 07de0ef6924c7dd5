//! Gross outliers: displacements that do not fit those of their neighbours.
//!
//! ```text
//! r₀ = |u₀ − p(x₀)| / (1 + h),   m = max(median |uᵢ − p(xᵢ)|, upper third of rᵢ),   ε = max(σ, median of all r / 0.6745)
//! r₀ / (m + ε) > threshold
//! ```
//!
//! The normalised median test of Westerweel & Scarano (2005), Experiments in Fluids 39, 1096–1100. In place of the neighbours' median
//! stands a plane p through the nearest ones, fitted with Huber's weights, so that gradients of displacements do not count as outliers. The
//! leverage h of x₀ on the plane does the same for places at the rim of the data, where p is extrapolated. Errors alone would need the
//! factor √(1 + h); 1 + h is larger, by 4 % amid neighbours and by more at a rim, where the curvature of the field is extrapolated too.
//! Where the field bends, m grows by what the plane leaves of the neighbours, and by what each of them is off the plane through its own.
//! Outliers are excluded as neighbours and the test is repeated until nothing changes: neighbouring outliers do not hide each other, and a
//! good place among them is kept.

use stickslip_fem_core::mesh::Point;
use stickslip_fem_core::parallel;

use super::format::positive;
use super::{DataError, Field, Measurement};
use crate::neighbours::Neighbours;
use crate::order_statistics::{NORMAL_MEDIAN, above, median};

/// Neighbours of a place: on a grid, all within two spacings.
const NEIGHBOURS: usize = 12;
/// Fewer neighbours say nothing.
const LEAST: usize = 8;
/// Most neighbours, where the nearest lie on one line and do not make a plane.
const MOST: usize = 48;
/// Narrowest extent of neighbours, squared, over their widest.
const FLAT: f64 = 0.01;
/// Part of the neighbours that are less off than what counts as usual.
const UPPER: f64 = 0.67;
/// Most rounds; flags that still come and go then stay as they are.
const ROUNDS: usize = 10;
/// Most rounds of a robust fit, and the change of its residuals' median that ends it.
const FITS: (usize, f64) = (30, 1e-3);

/// A displacement that does not go with those of its neighbours.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Outlier {
    /// Index of the place.
    pub place: usize,
    /// Component.
    pub field: Field,
    /// What was measured `[length]`.
    pub value: f64,
    /// What its neighbours say `[length]`.
    pub expected: f64,
    /// How far it is off, over what is usual `[1]`; infinite where neighbours agree to the last digit.
    pub ratio: f64,
}

impl Measurement {
    /// Displacements that are off those of their neighbours by more than `threshold` `[1]` times what is usual there, by place and
    /// component; at least [`Measurement::deviation`] counts as usual. A component with fewer than nine valid places has none.
    ///
    /// With a threshold of 8, no place of a smooth field is found, free of noise or with normal or uniform noise of its standard deviation,
    /// at the rim of a hole or of the data either; values that are off by 100 standard deviations are, alone or one in a hundred. In noise,
    /// half of those that are off by 20 standard deviations are found, hardly any that are off by 12.
    ///
    /// # Errors
    /// [`DataError::Setting`] for a threshold that is not positive, and as [`check`](Self::check).
    pub fn outliers(&self, threshold: f64) -> Result<Vec<Outlier>, DataError> {
        positive("the threshold of outliers", threshold)?;
        self.check()?;
        let mut found = Vec::new();
        for field in Field::BOTH {
            if self.count(field) > LEAST {
                found.extend(self.outliers_of(field, threshold));
            }
        }
        found.sort_by_key(|one| one.place);
        Ok(found)
    }

    fn outliers_of(&self, field: Field, threshold: f64) -> Vec<Outlier> {
        let c = field.component();
        let values = &self.displacements[c];
        let asked: Vec<usize> = (0..self.places.len())
            .filter(|&k| self.valid[c][k])
            .collect();
        let mut good = self.valid[c].clone();
        let mut changed = good.clone();
        let mut said = vec![Verdict::default(); self.places.len()];
        let mut ratios = vec![0.0; self.places.len()];
        for _ in 0..ROUNDS {
            let tree = Neighbours::new(&self.places, &good);
            let news = Neighbours::new(&self.places, &changed);
            let again = parallel::map(&asked, |&k| {
                let nearest = news.nearest(self.places[k], 1);
                let touched = nearest.first().is_some_and(|near| near.0 <= said[k].reach);
                touched.then(|| verdict(&tree, &self.places, values, k))
            });
            for (&k, verdict) in asked.iter().zip(again) {
                if let Some(verdict) = verdict {
                    said[k] = verdict;
                }
            }
            let all = asked.iter().filter(|&&k| good[k]).map(|&k| said[k].off);
            let usual = self.deviation[c].max(median(all.collect()).unwrap_or(0.0) / NORMAL_MEDIAN);
            changed.fill(false);
            for &k in &asked {
                let around = said[k].neighbours.iter().map(|&near| said[near].off);
                let around = above(around.collect(), UPPER).unwrap_or(0.0);
                ratios[k] = ratio(said[k].off, said[k].scatter.max(around) + usual);
                let is_good = ratios[k] <= threshold;
                changed[k] = is_good != good[k];
                good[k] = is_good;
            }
            if !changed.contains(&true) {
                break;
            }
        }
        let bad = asked.into_iter().filter(|&k| !good[k]);
        bad.map(|k| Outlier {
            place: k,
            field,
            value: values[k],
            expected: said[k].expected,
            ratio: ratios[k],
        })
        .collect()
    }
}

/// What neighbours say of a place.
#[derive(Clone, Debug)]
struct Verdict {
    expected: f64,
    /// r.
    off: f64,
    /// m.
    scatter: f64,
    /// Distance of the farthest neighbour.
    reach: f64,
    neighbours: Vec<usize>,
}

impl Default for Verdict {
    /// Of a place that was not asked yet, which all others concern.
    fn default() -> Self {
        Self {
            expected: f64::NAN,
            off: 0.0,
            scatter: 0.0,
            reach: f64::INFINITY,
            neighbours: Vec::new(),
        }
    }
}

/// How far off over what is usual; nothing where neither is.
fn ratio(off: f64, usual: f64) -> f64 {
    if off > 0.0 { off / usual } else { 0.0 }
}

fn verdict(tree: &Neighbours, places: &[Point], values: &[f64], own: usize) -> Verdict {
    let at = places[own];
    let mut count = NEIGHBOURS;
    let near = loop {
        let mut near = tree.nearest(at, count + 1);
        near.retain(|&(_, k)| k != own);
        near.truncate(count);
        if count >= MOST || near.len() < count || flatness(places, &near) > FLAT {
            break near;
        }
        count *= 2;
    };
    let reach = near.last().map_or(f64::INFINITY, |&(distance, _)| distance);
    if near.len() < LEAST || reach <= 0.0 {
        return Verdict::default();
    }
    let points: Vec<[f64; 3]> = (near.iter())
        .map(|&(_, k)| {
            let [x, y] = [0, 1].map(|axis| (places[k][axis] - at[axis]) / reach);
            [x, y, values[k]]
        })
        .collect();
    let fit = plane(&points);
    Verdict {
        expected: fit.value,
        off: (values[own] - fit.value).abs() / (1.0 + fit.leverage),
        scatter: fit.scatter,
        reach,
        neighbours: near.into_iter().map(|(_, k)| k).collect(),
    }
}

/// A plane through values around the origin: its value there, the leverage of the origin, and the median of the residuals.
struct Fit {
    value: f64,
    leverage: f64,
    scatter: f64,
}

/// The plane with Huber's weights min(1, m/|r|), m the median of |r|: residuals below it count by their squares, others by their
/// magnitudes.
fn plane(points: &[[f64; 3]]) -> Fit {
    let mut weights = vec![1.0; points.len()];
    let mut before = f64::INFINITY;
    let mut rounds = 0;
    loop {
        let (fit, residuals) = weighted(points, &weights);
        rounds += 1;
        if rounds == FITS.0 || fit.scatter >= (1.0 - FITS.1) * before {
            return fit;
        }
        before = fit.scatter;
        for (weight, residual) in weights.iter_mut().zip(residuals) {
            *weight = if residual > fit.scatter {
                fit.scatter / residual
            } else {
                1.0
            };
        }
    }
}

/// The plane of weighted least squares, and what it leaves of each value.
fn weighted(points: &[[f64; 3]], weights: &[f64]) -> (Fit, Vec<f64>) {
    let all: f64 = weights.iter().sum();
    let mean = |part: usize| {
        let sum: f64 = points.iter().zip(weights).map(|(p, w)| w * p[part]).sum();
        sum / all
    };
    let centre = [mean(0), mean(1), mean(2)];
    let moment = |a: usize, b: usize| -> f64 {
        let pairs = points.iter().zip(weights);
        pairs
            .map(|(p, w)| w * (p[a] - centre[a]) * (p[b] - centre[b]))
            .sum()
    };
    let spread = [moment(0, 0), moment(0, 1), moment(1, 1)];
    let slope = solved(spread, [moment(0, 2), moment(1, 2)]);
    let turned = solved(spread, [centre[0], centre[1]]);
    let at = |x: f64, y: f64| centre[2] + slope[0] * (x - centre[0]) + slope[1] * (y - centre[1]);
    let residuals: Vec<f64> = points
        .iter()
        .map(|&[x, y, u]| (u - at(x, y)).abs())
        .collect();
    let fit = Fit {
        value: at(0.0, 0.0),
        leverage: 1.0 / all + turned[0] * centre[0] + turned[1] * centre[1],
        scatter: median(residuals.clone()).unwrap_or(0.0),
    };
    (fit, residuals)
}

/// The vector that a symmetric matrix (xx, xy, yy) takes to `right`; along its main direction alone where it has but one.
fn solved(matrix: [f64; 3], right: [f64; 2]) -> [f64; 2] {
    const SINGULAR: f64 = 1e-12;
    let [xx, xy, yy] = matrix;
    let [narrow, wide] = extents(matrix);
    if narrow > SINGULAR * wide {
        let determinant = xx * yy - xy * xy;
        return [
            (yy * right[0] - xy * right[1]) / determinant,
            (xx * right[1] - xy * right[0]) / determinant,
        ];
    }
    let (sin, cos) = (0.5 * (2.0 * xy).atan2(xx - yy)).sin_cos();
    let along = if wide > 0.0 {
        (right[0] * cos + right[1] * sin) / wide
    } else {
        0.0
    };
    [along * cos, along * sin]
}

/// Eigenvalues of a symmetric matrix (xx, xy, yy), the smaller one first.
fn extents([xx, xy, yy]: [f64; 3]) -> [f64; 2] {
    let (middle, half) = (0.5 * (xx + yy), (0.5 * (xx - yy)).hypot(xy));
    [middle - half, middle + half]
}

/// How far neighbours are from lying on one line.
fn flatness(places: &[Point], near: &[(f64, usize)]) -> f64 {
    let mean = [0, 1].map(|axis| {
        let sum: f64 = near.iter().map(|&(_, k)| places[k][axis]).sum();
        sum / near.len() as f64
    });
    let moment = |a: usize, b: usize| -> f64 {
        let each = near.iter();
        each.map(|&(_, k)| (places[k][a] - mean[a]) * (places[k][b] - mean[b]))
            .sum()
    };
    let [narrow, wide] = extents([moment(0, 0), moment(0, 1), moment(1, 1)]);
    narrow / wide
}
