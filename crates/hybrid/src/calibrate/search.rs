//! Finds the least χ² within the ranges: a grid, descent by the Levenberg–Marquardt method, trial steps.
//!
//! ```text
//! (JᵀJ + λ diag JᵀJ) Δz = −Jᵀ r,   z ← clamp(z + Δz, 0, 1),     J by central differences,   z: parts of the ranges
//! ```

use stickslip_fem_core::linalg::{DenseCholesky, Matrix};
use stickslip_fem_core::parallel;

use super::information::Information;
use super::{CalibrateError, Data, Parameter};

/// Half the difference of parts over which derivatives are taken: wide enough to see past the jumps of single contact points.
const DIFFERENCE: f64 = 5e-4;
/// Descents take at most this many steps.
const STEPS: usize = 40;
/// Trials of one step, with growing damping.
const TRIALS: usize = 12;
/// Descents end where a step gains less of χ²; differences of 1 begin to mean something.
pub(super) const ROUGHLY: f64 = 1e-3;
const EXACTLY: f64 = 1e-9;
/// Parts that differ by less are the same.
const SAME: f64 = 1e-8;

type Predict<'a> = dyn Fn(&[f64]) -> Result<Vec<f64>, String> + Sync + 'a;

/// A place at which the model predicts.
#[derive(Clone, Debug)]
pub(super) struct Point {
    /// Parts of the ranges, from 0 to 1.
    pub(super) parts: Vec<f64>,
    pub(super) residual: Vec<f64>,
    pub(super) chi_squared: f64,
}

pub(super) struct Search<'a> {
    predict: &'a Predict<'a>,
    parameters: &'a [Parameter],
    data: &'a Data,
    pub(super) evaluations: usize,
    pub(super) refusals: usize,
    pub(super) first_refusal: Option<String>,
}

impl<'a> Search<'a> {
    pub(super) fn new(
        predict: &'a Predict<'a>,
        parameters: &'a [Parameter],
        data: &'a Data,
    ) -> Self {
        Self {
            predict,
            parameters,
            data,
            evaluations: 0,
            refusals: 0,
            first_refusal: None,
        }
    }

    pub(super) fn parameters(&self) -> &'a [Parameter] {
        self.parameters
    }

    pub(super) fn data(&self) -> &'a Data {
        self.data
    }

    pub(super) fn values(&self, parts: &[f64]) -> Vec<f64> {
        let both = self.parameters.iter().zip(parts);
        both.map(|(parameter, part)| parameter.at(*part)).collect()
    }

    /// The point at `parts`; `None` where the model refuses.
    pub(super) fn at(&mut self, parts: &[f64]) -> Result<Option<Point>, CalibrateError> {
        let answer = (self.predict)(&self.values(parts));
        self.taken(parts, answer)
    }

    fn taken(
        &mut self,
        parts: &[f64],
        answer: Result<Vec<f64>, String>,
    ) -> Result<Option<Point>, CalibrateError> {
        self.evaluations += 1;
        let finite = |predicted: Vec<f64>| {
            let index = predicted.iter().position(|value| !value.is_finite());
            index.map_or(Ok(predicted), |k| {
                Err(format!("its prediction {k} is not finite"))
            })
        };
        match answer.and_then(finite) {
            Ok(predicted) if predicted.len() == self.data.count() => {
                let residual = self.data.residual(&predicted);
                Ok(Some(Point {
                    parts: parts.to_vec(),
                    chi_squared: residual.iter().map(|r| r * r).sum(),
                    residual,
                }))
            }
            Ok(predicted) => Err(CalibrateError::Prediction {
                expected: self.data.count(),
                found: predicted.len(),
            }),
            Err(reason) => {
                self.refusals += 1;
                self.first_refusal.get_or_insert(reason);
                Ok(None)
            }
        }
    }

    /// All points of a grid with `count` per parameter at which the model predicts, the best first.
    pub(super) fn grid(&mut self, count: usize) -> Result<Vec<Point>, CalibrateError> {
        let axes = self.parameters.len();
        let total = count.pow(axes as u32);
        let parts_of = |mut index: usize| -> Vec<f64> {
            let part = |_| {
                let k = index % count;
                index /= count;
                k as f64 / (count - 1) as f64
            };
            (0..axes).map(part).collect()
        };
        let places: Vec<Vec<f64>> = (0..total).map(parts_of).collect();
        let predict = self.predict;
        let values: Vec<Vec<f64>> = places.iter().map(|parts| self.values(parts)).collect();
        let answers = parallel::map(&values, |at| predict(at));
        let mut points = Vec::new();
        for (parts, answer) in places.iter().zip(answers) {
            points.extend(self.taken(parts, answer)?);
        }
        if points.is_empty() {
            return Err(CalibrateError::NoPrediction {
                tried: total,
                first: self.first_refusal.clone().unwrap_or_default(),
            });
        }
        points.sort_by(|a, b| a.chi_squared.total_cmp(&b.chi_squared));
        Ok(points)
    }

    /// The best of the descents from the `starts` best points of `grid` that are no neighbours of each other.
    pub(super) fn best_of(
        &mut self,
        grid: &[Point],
        starts: usize,
    ) -> Result<Point, CalibrateError> {
        let spacing = |a: &Point, b: &Point| {
            let both = a.parts.iter().zip(&b.parts);
            both.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
        };
        let step = (grid.iter().skip(1))
            .flat_map(|point| point.parts.iter().copied())
            .filter(|part| *part > 0.0)
            .fold(1.0, f64::min);
        let mut chosen: Vec<&Point> = Vec::new();
        for point in grid {
            if chosen.len() < starts && chosen.iter().all(|own| spacing(own, point) > 1.5 * step) {
                chosen.push(point);
            }
        }
        let mut best = grid[0].clone();
        for start in chosen {
            let end = self.descend(start.clone(), &[], ROUGHLY)?;
            if end.chi_squared < best.chi_squared {
                best = end;
            }
        }
        self.refined(best, &[])
    }

    /// Descent, trial steps, and descent again where these found something; the parts `fixed` stay.
    pub(super) fn refined(
        &mut self,
        start: Point,
        fixed: &[usize],
    ) -> Result<Point, CalibrateError> {
        let low = self.descend(start, fixed, EXACTLY)?;
        let tried = self.trial_steps(low.clone(), fixed)?;
        if tried.chi_squared < low.chi_squared {
            self.descend(tried, fixed, EXACTLY)
        } else {
            Ok(tried)
        }
    }

    /// Steps along single parameters, halved where none helps.
    fn trial_steps(&mut self, start: Point, fixed: &[usize]) -> Result<Point, CalibrateError> {
        const SIZES: [f64; 7] = [1e-2, 5e-3, 2e-3, 1e-3, 5e-4, 2e-4, 1e-4];
        let mut best = start;
        for size in SIZES {
            for axis in (0..best.parts.len()).filter(|axis| !fixed.contains(axis)) {
                for step in [size, -size] {
                    let mut parts = best.parts.clone();
                    parts[axis] = (parts[axis] + step).clamp(0.0, 1.0);
                    if parts == best.parts {
                        continue;
                    }
                    let found = self.at(&parts)?;
                    best = found
                        .filter(|found| found.chi_squared < best.chi_squared)
                        .unwrap_or(best);
                }
            }
        }
        Ok(best)
    }

    /// Levenberg's and Marquardt's descent from `start` until a step gains less than `enough` of χ²; the parts `fixed` stay.
    pub(super) fn descend(
        &mut self,
        start: Point,
        fixed: &[usize],
        enough: f64,
    ) -> Result<Point, CalibrateError> {
        let free: Vec<usize> = (0..start.parts.len())
            .filter(|axis| !fixed.contains(axis))
            .collect();
        let mut point = start;
        let mut damping = 1e-3;
        for _ in 0..if free.is_empty() { 0 } else { STEPS } {
            let jacobian = self.jacobian(&point, &free)?;
            let gradient = jacobian.transpose_multiply(&Matrix::column(&point.residual));
            let inwards = |k: &usize| {
                let (part, slope) = (point.parts[free[*k]], gradient[(*k, 0)]);
                !(part <= 0.0 && slope > 0.0 || part >= 1.0 && slope < 0.0)
            };
            let active: Vec<usize> = (0..free.len()).filter(inwards).collect();
            let gram = jacobian.transpose_multiply(&jacobian);
            let mut next = None;
            for _ in 0..TRIALS {
                let Some(step) = damped(&gram, &gradient, &active, damping) else {
                    return Ok(point);
                };
                let mut parts = point.parts.clone();
                for (&k, step) in active.iter().zip(step) {
                    parts[free[k]] = (parts[free[k]] + step).clamp(0.0, 1.0);
                }
                let moved = (parts.iter().zip(&point.parts))
                    .map(|(a, b)| (a - b).abs())
                    .fold(0.0, f64::max);
                if moved < SAME {
                    return Ok(point);
                }
                let found = self.at(&parts)?;
                if let Some(found) = found.filter(|own| own.chi_squared < point.chi_squared) {
                    damping = (0.1 * damping).max(1e-9);
                    next = Some(found);
                    break;
                }
                damping *= 5.0;
            }
            let Some(next) = next else {
                return Ok(point);
            };
            let gained = point.chi_squared - next.chi_squared;
            point = next;
            if gained < enough {
                return Ok(point);
            }
        }
        Ok(point)
    }

    /// ∂r/∂z of the parts `free`: central differences, one-sided at the ends of the ranges and beside refused places, and zero
    /// between two of these.
    fn jacobian(&mut self, point: &Point, free: &[usize]) -> Result<Matrix, CalibrateError> {
        let mut jacobian = Matrix::zeros(point.residual.len(), free.len());
        for (k, &axis) in free.iter().enumerate() {
            let mut side = |sign: f64| {
                let mut parts = point.parts.clone();
                parts[axis] = (parts[axis] + sign * DIFFERENCE).clamp(0.0, 1.0);
                if parts == point.parts {
                    return Ok(None);
                }
                self.at(&parts)
            };
            let [below, above] = [side(-1.0)?, side(1.0)?];
            let [low, high] = [below.as_ref(), above.as_ref()].map(|side| side.unwrap_or(point));
            let width = high.parts[axis] - low.parts[axis];
            if width > 0.0 {
                for i in 0..point.residual.len() {
                    jacobian[(i, k)] = (high.residual[i] - low.residual[i]) / width;
                }
            }
        }
        Ok(jacobian)
    }

    /// Curvature of χ² in all parameters.
    pub(super) fn information(&mut self, point: &Point) -> Result<Information, CalibrateError> {
        let all: Vec<usize> = (0..point.parts.len()).collect();
        Ok(Information::of(&self.jacobian(point, &all)?))
    }
}

/// Damped step of the `active` entries; `None` where nothing has an influence.
fn damped(gram: &Matrix, gradient: &Matrix, active: &[usize], damping: f64) -> Option<Vec<f64>> {
    let size = active.len();
    let largest = active.iter().map(|&k| gram[(k, k)]).fold(0.0, f64::max);
    if largest <= 0.0 {
        return None;
    }
    // A parameter without influence keeps its place.
    let floor = 1e-12 * largest;
    let matrix = Matrix::from_fn(size, size, |i, j| {
        let entry = gram[(active[i], active[j])];
        if i == j {
            entry + damping * entry.max(floor) + floor
        } else {
            entry
        }
    });
    let factor = DenseCholesky::new(matrix).ok()?;
    let mut step = Matrix::from_fn(size, 1, |i, _| -gradient[(active[i], 0)]);
    factor.solve_lower(&mut step);
    factor.solve_lower_transposed(&mut step);
    Some(step.to_row_major())
}
