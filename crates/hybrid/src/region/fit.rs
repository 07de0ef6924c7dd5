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

mod modes;
mod penalty;

use std::collections::BTreeMap;

use stickslip_fem_core::linalg::Matrix;
use stickslip_fem_core::mesh::Point;

use self::modes::{Modes, place_of};
use super::checks::{Points, measured_rows};
use super::{Region, RegionError};
use crate::data::{Measurement, NodalDisplacements};
use crate::neighbours::Neighbours;

/// How much to smooth.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Amount {
    /// α, dimensionless; 0 for equilibrium alone.
    Given(f64),
    /// A share of the α with the least generalised cross-validation, above 0. A share of 1 is best for displacements; stresses are
    /// derivatives, and 0.4 kept their bias below half of their noise on the dense fields of the tests.
    CrossValidated {
        /// The share `[1]`.
        share: f64,
    },
}

impl Amount {
    fn check(self) -> Result<(), RegionError> {
        let (Self::Given(value) | Self::CrossValidated { share: value }) = self;
        let positive = value > 0.0 || (value == 0.0 && matches!(self, Self::Given(_)));
        if positive && value.is_finite() {
            Ok(())
        } else {
            Err(RegionError::SmoothingAmount(value))
        }
    }
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
    /// The amount α of smoothing `[1]`.
    pub amount: f64,
    /// Effective number of fitted parameters, tr A `[1]`.
    pub parameters: f64,
    /// Diagonal of M⁻¹ G `[1]`, in the order of the prescribed displacements: the part of each that the data at its own place decide, and not
    /// the smoothing with its neighbours; of single ones, as at corners, it may lie beyond 0 and 1. Its sum is
    /// [`parameters`](Self::parameters).
    pub kept: Vec<f64>,
    /// Number of data.
    pub data: usize,
    /// Sum of the squared residuals in units of the data's variances; about `data − parameters` where the model holds.
    pub residual: f64,
}

/// Modes whose share of the data is below this are not determined by them.
const UNDETERMINED: f64 = 1e-11;

impl Region {
    /// Fits the prescribed displacements to all valid data in the region: [`Fitter::new`] and [`Fitter::fit`] in one.
    ///
    /// # Errors
    /// [`RegionError`]: as [`Fitter::new`] and [`Fitter::fit`].
    pub fn fit(&self, data: &Measurement, smoothing: Smoothing) -> Result<Fit, RegionError> {
        smoothing.amount.check()?;
        Fitter::new(self, data, smoothing.order)?.fit(&data.displacements, smoothing.amount)
    }

    /// Refuses a prescribed node on the boundary farther from any datum than six times the distance of neighbouring data, or than the
    /// cells are long there, and one inside, which no smoothing holds, farther than twice that distance.
    fn check_coverage(&self, data: &Measurement, points: &Points) -> Result<(), RegionError> {
        const SPACINGS: f64 = 6.0;
        const SPACINGS_INSIDE: f64 = 2.0;
        let lengths = self.boundary_lengths();
        for axis in 0..2 {
            let mut used = vec![false; data.places.len()];
            for &(index, component) in &points.places {
                used[index] |= component == axis;
            }
            let near = Neighbours::new(&data.places, &used);
            let spacing = near.spacing();
            for dof in self.prescribed().iter().filter(|dof| *dof % 2 == axis) {
                let place = self.mesh().nodes()[dof / 2];
                let reach = match lengths.get(&(dof / 2)) {
                    Some(length) => length.max(SPACINGS * spacing),
                    None => SPACINGS_INSIDE * spacing,
                };
                let nearest = near.nearest(place, 1);
                let distance = nearest.first().map_or(f64::INFINITY, |found| found.0);
                if distance > reach {
                    return Err(RegionError::NotDetermined { place });
                }
            }
        }
        Ok(())
    }

    /// Length of the longest edge on the boundary that has a node `[length]`.
    fn boundary_lengths(&self) -> BTreeMap<usize, f64> {
        let mesh = self.mesh();
        let mut lengths = BTreeMap::new();
        for edge in mesh.boundary_edges() {
            let nodes = mesh.edge_nodes(edge);
            let [a, b] = nodes.ends.map(|node| mesh.nodes()[node]);
            let length = (a[0] - b[0]).hypot(a[1] - b[1]);
            for node in nodes.all() {
                let longest: &mut f64 = lengths.entry(node).or_default();
                *longest = longest.max(length);
            }
        }
        lengths
    }
}

/// The fit of one region to data at the same places, ready for any number of measured states.
///
/// It holds the normal equations in the basis in which data and smoothing are both diagonal.
#[derive(Clone, Debug)]
pub struct Fitter<'a> {
    region: &'a Region,
    /// Place and component of each datum.
    places: Vec<(usize, usize)>,
    /// Inverse standard deviation along x and y.
    weight: [f64; 2],
    /// H times the inverse standard deviations, data × prescribed.
    rows: Matrix,
    modes: Modes,
}

/// Data of one state as the modes see them.
struct Loads {
    modes: Vec<f64>,
    /// mᵀ W m.
    square: f64,
}

impl<'a> Fitter<'a> {
    /// Prepares the fit to data at the places of `data` that are valid and lie in the region, with differences of order `order`
    /// smoothed.
    ///
    /// # Errors
    /// [`RegionError::SmoothingOrder`]; a measurement whose arrays do not fit or are not finite, or without a standard deviation;
    /// [`RegionError::NoData`]; [`RegionError::NotDetermined`] where a piece of the boundary has no data near.
    pub fn new(region: &'a Region, data: &Measurement, order: usize) -> Result<Self, RegionError> {
        if ![2, 3].contains(&order) {
            return Err(RegionError::SmoothingOrder(order));
        }
        let points = measured_rows(region, data)?;
        region.check_coverage(data, &points)?;
        let weight = data.deviation.map(|deviation| 1.0 / deviation);
        let mut rows = region.transfer(&points.rows)?.matrix;
        for (i, &(_, axis)) in points.places.iter().enumerate() {
            (0..rows.columns()).for_each(|j| rows[(i, j)] *= weight[axis]);
        }
        let modes = Modes::new(region, &rows, order)?;
        Ok(Self {
            region,
            places: points.places,
            weight,
            rows,
            modes,
        })
    }

    /// Fits the prescribed displacements to the displacements x and y `[length]` of a state, one per place of the measurement.
    ///
    /// # Errors
    /// [`RegionError::SmoothingAmount`]; displacements that are too few or not finite; [`RegionError::NotDetermined`] without
    /// smoothing where the data leave a displacement open.
    pub fn fit(&self, state: &[Vec<f64>; 2], amount: Amount) -> Result<Fit, RegionError> {
        amount.check()?;
        let loads = self.loads(state)?;
        let amount = match amount {
            Amount::Given(amount) => self.determined(amount)?,
            Amount::CrossValidated { share } => share * self.least_score(&loads),
        };
        let size = loads.modes.len();
        let stiffness = self.denominators(amount);
        let bias =
            |k: usize| -amount * self.modes.smoothing[k] * loads.modes[k] / stiffness[k].powi(2);
        let variances = Matrix::from_fn(size, size, |i, j| {
            let share = (1.0 - self.modes.smoothing[i]) / stiffness[i].powi(2);
            if i == j { share } else { 0.0 }
        });
        let covariance = self.modes.basis.propagate_covariance(&variances);
        let values = self.combine(|k| loads.modes[k] / stiffness[k]);
        Ok(Fit {
            displacements: spread(self.region, &values, &covariance),
            bias: self.combine(bias),
            amount,
            parameters: self.parameters(amount),
            kept: self.kept(&stiffness),
            data: self.places.len(),
            residual: self.residual(&loads, amount),
        })
    }

    /// Prescribed displacements `[length]` fitted with the amount α `amount` `[1]`: those of [`fit`](Self::fit), without covariance and
    /// so at a small part of its cost.
    ///
    /// # Errors
    /// As [`fit`](Self::fit).
    pub fn values(&self, state: &[Vec<f64>; 2], amount: f64) -> Result<Vec<f64>, RegionError> {
        Amount::Given(amount).check()?;
        let loads = self.loads(state)?;
        let stiffness = self.denominators(self.determined(amount)?);
        Ok(self.combine(|k| loads.modes[k] / stiffness[k]))
    }

    /// The amount α `[1]`, of twenty per decade, with the least generalised cross-validation for a state, displacements x and y `[length]`.
    ///
    /// # Errors
    /// Displacements that are too few or not finite.
    pub fn cross_validated(&self, state: &[Vec<f64>; 2]) -> Result<f64, RegionError> {
        Ok(self.least_score(&self.loads(state)?))
    }

    /// The amount, unless the data alone leave something open and it is zero.
    fn determined(&self, amount: f64) -> Result<f64, RegionError> {
        match self.undetermined() {
            Some(place) if amount == 0.0 => Err(RegionError::NotDetermined { place }),
            _ => Ok(amount),
        }
    }

    fn loads(&self, state: &[Vec<f64>; 2]) -> Result<Loads, RegionError> {
        let mut weighted = Matrix::zeros(self.places.len(), 1);
        for (i, &(index, axis)) in self.places.iter().enumerate() {
            let value = state[axis].get(index).copied().unwrap_or(f64::NAN);
            if !value.is_finite() {
                let what = "measured displacement";
                return Err(RegionError::NotFinite { what, index });
            }
            weighted[(i, 0)] = self.weight[axis] * value;
        }
        let sums = self.rows.transpose_multiply(&weighted);
        Ok(Loads {
            modes: self.modes.basis.transpose_multiply(&sums).to_row_major(),
            square: (0..self.places.len())
                .map(|k| weighted[(k, 0)].powi(2))
                .sum(),
        })
    }

    /// Sum of the modes times weights.
    fn combine(&self, weight: impl Fn(usize) -> f64) -> Vec<f64> {
        let weights = Matrix::from_fn(self.modes.smoothing.len(), 1, |k, _| weight(k));
        self.modes.basis.multiply(&weights).to_row_major()
    }

    /// Stiffness of each mode: (1 − s) + α s.
    fn denominators(&self, amount: f64) -> Vec<f64> {
        self.modes
            .smoothing
            .iter()
            .map(|s| (1.0 - s) + amount * s)
            .collect()
    }

    /// Where on the boundary the mode lives that the data do not determine, if there is one.
    fn undetermined(&self) -> Option<Point> {
        let mode = self
            .modes
            .smoothing
            .iter()
            .position(|s| 1.0 - s < UNDETERMINED)?;
        let size = |k: &usize| self.modes.basis[(*k, mode)].abs();
        let largest = (0..self.modes.basis.rows()).max_by(|a, b| size(a).total_cmp(&size(b)))?;
        Some(place_of(self.region, largest))
    }

    fn residual(&self, loads: &Loads, amount: f64) -> f64 {
        let modes = self
            .denominators(amount)
            .into_iter()
            .zip(&loads.modes)
            .zip(&self.modes.smoothing);
        modes.fold(loads.square, |sum, ((e, z), s)| {
            sum - z * z / e * (2.0 - (1.0 - s) / e)
        })
    }

    fn parameters(&self, amount: f64) -> f64 {
        let modes = self
            .denominators(amount)
            .into_iter()
            .zip(&self.modes.smoothing);
        modes.map(|(e, s)| (1.0 - s) / e).sum()
    }

    fn kept(&self, stiffness: &[f64]) -> Vec<f64> {
        let part = |k: usize| (1.0 - self.modes.smoothing[k]) / stiffness[k];
        let of_mode =
            |i: usize, k: usize| self.modes.basis[(i, k)] * self.modes.dual[(i, k)] * part(k);
        let size = stiffness.len();
        (0..size)
            .map(|i| (0..size).map(|k| of_mode(i, k)).sum())
            .collect()
    }

    /// The amount with the least score, of those that leave a tenth of the data to judge by: as many parameters as data leave no
    /// residual, whatever they fit.
    fn least_score(&self, loads: &Loads) -> f64 {
        const LEFT: f64 = 0.1;
        let data = self.places.len() as f64;
        let score = |amount: f64| {
            let left = data - self.parameters(amount);
            if left < LEFT * data {
                return f64::INFINITY;
            }
            self.residual(loads, amount).max(0.0) / (left * left)
        };
        let amounts = (-200..=200).map(|k| 10.0_f64.powf(f64::from(k) / 20.0));
        amounts
            .map(|amount| (score(amount), amount))
            .filter(|(score, _)| score.is_finite())
            .min_by(|a, b| a.0.total_cmp(&b.0))
            .map_or(1.0, |(_, amount)| amount)
    }
}

/// Values of the prescribed degrees of freedom as displacements of nodes.
fn spread(region: &Region, values: &[f64], covariance: &Matrix) -> NodalDisplacements {
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
