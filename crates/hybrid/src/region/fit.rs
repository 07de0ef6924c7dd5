//! Boundary displacements of a region fitted to all data, with equilibrium inside and declared smoothing along the boundary.
//!
//! With H = N T the displacements at the measured places by those of the boundary, d, through shape functions and equilibrium, and
//! W the inverse variances of the data m,
//!
//! ```text
//! min (m − H d)ᵀ W (m − H d) + α μ dᵀ R d,     dᵀ R d = Σ ∫ |∂ᵏd/∂sᵏ|² ds over the smooth pieces of the boundary,
//! M d = Hᵀ W m,   M = G + α μ R,   G = Hᵀ W H,   μ = tr G / tr R,
//! cov d = M⁻¹ G M⁻¹,     bias ≈ −α μ M⁻¹ R d.
//! ```
//!
//! The amount α is given, or minimises the generalised cross-validation n ‖residual‖²/(n − tr A)², A = H M⁻¹ Hᵀ W (Golub, Heath &
//! Wahba 1979). G + μ R = L Lᵀ and L⁻¹ μR L⁻ᵀ = Q diag(s) Qᵀ make every α cost no more than the number of boundary unknowns.
//!
//! Equilibrium alone gains little at the edge: displacements of short wave length there do not reach the data inside.

mod penalty;

use faer::Mat;
use stickslip_fem_core::mesh::Point;

use self::penalty::penalty;
use super::checks::{Points, measured_rows};
use super::dense::{by_rows, cholesky, eigen, multiply, sandwich, solve_lower, solve_lower_transposed};
use super::{Region, RegionError};
use crate::data::{Measurement, NodalDisplacements};

/// How much to smooth.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Amount {
    /// α, dimensionless; 0 for equilibrium alone.
    Given(f64),
    /// The α of the least generalised cross-validation.
    CrossValidated,
}

/// Declared smoothing along the boundary.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Smoothing {
    /// Order k of the differences that are kept small: 2 or 3.
    pub order: usize,
    /// How much.
    pub amount: Amount,
}

/// Fitted boundary displacements.
#[derive(Clone, Debug, PartialEq)]
pub struct Fit {
    /// Displacements of the prescribed nodes with the covariance that the noise of the data makes. Components that are not
    /// prescribed are zero, without variance, and no region reads them.
    pub displacements: NodalDisplacements,
    /// Estimated bias of the prescribed displacements by the smoothing `[length]`, in their order.
    pub bias: Vec<f64>,
    /// The amount α of smoothing.
    pub amount: f64,
    /// Effective number of fitted parameters, tr A.
    pub parameters: f64,
    /// Number of data.
    pub data: usize,
    /// Sum of the squared residuals in units of the data's variances; about `data − parameters` where the model holds.
    pub residual: f64,
}

/// Modes whose share of the data is below this are not determined by them.
const UNDETERMINED: f64 = 1e-11;

impl Region {
    /// Fits the prescribed displacements to all valid data in the region.
    ///
    /// # Errors
    /// [`RegionError::SmoothingOrder`], [`RegionError::SmoothingAmount`]; a measurement whose arrays do not fit or are not finite, or without a
    /// deviation; [`RegionError::NoData`]; [`RegionError::NotDetermined`] where a piece of the boundary has no data near.
    pub fn fit(&self, data: &Measurement, smoothing: Smoothing) -> Result<Fit, RegionError> {
        if ![2, 3].contains(&smoothing.order) {
            return Err(RegionError::SmoothingOrder(smoothing.order));
        }
        if let Amount::Given(amount) = smoothing.amount
            && !(amount >= 0.0 && amount.is_finite())
        {
            return Err(RegionError::SmoothingAmount(amount));
        }
        let points = measured_rows(self, data)?;
        self.check_coverage(data, &points)?;
        let system = System::new(self, data, &points, smoothing.order)?;
        let amount = match smoothing.amount {
            Amount::Given(amount) => amount,
            Amount::CrossValidated => system.cross_validated(),
        };
        if amount == 0.0 && let Some(place) = system.undetermined(self) {
            return Err(RegionError::NotDetermined { place });
        }
        Ok(system.fit(self, amount))
    }

    /// Refuses a prescribed node farther from any datum than three times the spacing of the data.
    fn check_coverage(&self, data: &Measurement, points: &Points) -> Result<(), RegionError> {
        const SPACINGS: f64 = 3.0;
        let [low, high] = self.mesh().bounding_box();
        let area = (high[0] - low[0]) * (high[1] - low[1]);
        for axis in 0..2 {
            let own = points.places.iter().filter(|(_, component)| *component == axis);
            let places: Vec<Point> = own.map(|&(index, _)| data.places[index]).collect();
            let reach = SPACINGS * (area / places.len().max(1) as f64).sqrt();
            for dof in self.prescribed().iter().filter(|dof| *dof % 2 == axis) {
                let [x, y] = self.mesh().nodes()[dof / 2];
                if !places.iter().any(|[u, v]| (u - x).hypot(v - y) <= reach) {
                    return Err(RegionError::NotDetermined { place: [x, y] });
                }
            }
        }
        Ok(())
    }
}

/// The normal equations in the basis in which data and smoothing are both diagonal.
struct System {
    /// Share of the smoothing in each mode, from 0 to 1; that of the data is one less it.
    smoothing: Vec<f64>,
    /// Data in each mode.
    loads: Vec<f64>,
    /// Modes, one per column: L⁻ᵀ Q.
    modes: Mat<f64>,
    data: usize,
    /// mᵀ W m.
    square: f64,
}

impl System {
    fn new(
        region: &Region,
        data: &Measurement,
        points: &Points,
        order: usize,
    ) -> Result<Self, RegionError> {
        let mut rows = region.transfer(&points.rows).matrix;
        let (count, size) = (rows.nrows(), rows.ncols());
        let mut weighted = Mat::zeros(count, 1);
        for (i, &(index, axis)) in points.places.iter().enumerate() {
            let weight = 1.0 / data.deviation[axis];
            (0..size).for_each(|j| rows[(i, j)] *= weight);
            weighted[(i, 0)] = weight * data.displacements[axis][index];
        }
        let gram = multiply(rows.transpose(), rows.as_ref());
        let mut loads = multiply(rows.transpose(), weighted.as_ref());
        let roughness = penalty(region, order);
        let trace = |matrix: &Mat<f64>| (0..size).map(|k| matrix[(k, k)]).sum::<f64>();
        let scale = match trace(&roughness) {
            0.0 => 0.0,
            rough => trace(&gram) / rough,
        };
        let both = Mat::from_fn(size, size, |i, j| gram[(i, j)] + scale * roughness[(i, j)]);
        let lower = cholesky(both).map_err(|row| RegionError::NotDetermined {
            place: place_of(region, row),
        })?;
        let mut share = Mat::from_fn(size, size, |i, j| scale * roughness[(i, j)]);
        solve_lower(&lower, &mut share);
        let mut share = share.transpose().to_owned();
        solve_lower(&lower, &mut share);
        let symmetric = Mat::from_fn(size, size, |i, j| f64::midpoint(share[(i, j)], share[(j, i)]));
        let (smoothing, turned) =
            eigen(&symmetric).ok_or(RegionError::Eigenvalues { order: size })?;
        let mut modes = turned;
        solve_lower_transposed(&lower, &mut modes);
        loads = multiply(modes.transpose(), loads.as_ref());
        Ok(Self {
            smoothing: smoothing.into_iter().map(|s| s.clamp(0.0, 1.0)).collect(),
            loads: (0..size).map(|k| loads[(k, 0)]).collect(),
            modes,
            data: count,
            square: (0..count).map(|k| weighted[(k, 0)].powi(2)).sum(),
        })
    }

    /// Stiffness of each mode: (1 − s) + α s.
    fn denominators(&self, amount: f64) -> Vec<f64> {
        self.smoothing.iter().map(|s| (1.0 - s) + amount * s).collect()
    }

    /// Where on the boundary the mode lives that the data do not determine, if there is one.
    fn undetermined(&self, region: &Region) -> Option<Point> {
        let mode = self.smoothing.iter().position(|s| 1.0 - s < UNDETERMINED)?;
        let size = |k: &usize| self.modes[(*k, mode)].abs();
        let largest = (0..self.modes.nrows()).max_by(|a, b| size(a).total_cmp(&size(b)))?;
        Some(place_of(region, largest))
    }

    fn residual(&self, amount: f64) -> f64 {
        let modes = self.denominators(amount).into_iter().zip(&self.loads).zip(&self.smoothing);
        modes.fold(self.square, |sum, ((e, z), s)| sum - z * z / e * (2.0 - (1.0 - s) / e))
    }

    fn parameters(&self, amount: f64) -> f64 {
        let modes = self.denominators(amount).into_iter().zip(&self.smoothing);
        modes.map(|(e, s)| (1.0 - s) / e).sum()
    }

    /// The amount, of twenty per decade, with the least generalised cross-validation.
    fn cross_validated(&self) -> f64 {
        let score = |amount: f64| {
            let left = self.data as f64 - self.parameters(amount);
            self.residual(amount).max(0.0) / (left * left)
        };
        let amounts = (-360..=80).map(|k| 10.0_f64.powf(f64::from(k) / 20.0));
        amounts
            .map(|amount| (score(amount), amount))
            .filter(|(score, _)| score.is_finite())
            .min_by(|a, b| a.0.total_cmp(&b.0))
            .map_or(1.0, |(_, amount)| amount)
    }

    fn fit(&self, region: &Region, amount: f64) -> Fit {
        let size = self.loads.len();
        let stiffness = self.denominators(amount);
        let combine = |weight: &dyn Fn(usize) -> f64| {
            let weights = Mat::from_fn(size, 1, |k, _| weight(k));
            by_rows(&multiply(self.modes.as_ref(), weights.as_ref()))
        };
        let values = combine(&|k| self.loads[k] / stiffness[k]);
        let bias = combine(&|k| -amount * self.smoothing[k] * self.loads[k] / stiffness[k].powi(2));
        let variances = Mat::from_fn(size, size, |i, j| {
            let share = (1.0 - self.smoothing[i]) / stiffness[i].powi(2);
            if i == j { share } else { 0.0 }
        });
        let covariance = sandwich(self.modes.as_ref(), variances.as_ref());
        Fit {
            displacements: spread(region, &values, &covariance),
            bias,
            amount,
            parameters: self.parameters(amount),
            data: self.data,
            residual: self.residual(amount),
        }
    }
}

fn place_of(region: &Region, position: usize) -> Point {
    region.mesh().nodes()[region.prescribed()[position] / 2]
}

/// Values of the prescribed degrees of freedom as displacements of nodes.
fn spread(region: &Region, values: &[f64], covariance: &Mat<f64>) -> NodalDisplacements {
    let nodes = region.prescribed_nodes();
    let size = 2 * nodes.len();
    let positions: Vec<usize> = (region.prescribed().iter())
        .map(|dof| 2 * nodes.partition_point(|&node| node < dof / 2) + dof % 2)
        .collect();
    let mut spread = NodalDisplacements {
        nodes,
        values: vec![0.0; size],
        covariance: vec![0.0; size * size],
    };
    for (i, &row) in positions.iter().enumerate() {
        spread.values[row] = values[i];
        for (j, &column) in positions.iter().enumerate() {
            spread.covariance[row * size + column] = covariance[(i, j)];
        }
    }
    spread
}
