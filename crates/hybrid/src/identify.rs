//! Friction coefficients from the tractions on an edge.
//!
//! ```text
//! r(μ) = s τ − μ p,     C(μ) = μ² Σ_pp − μ s (Σ_pτ + Σ_τp) + Σ_ττ,     χ²(μ) = rᵀ C⁻¹ r
//! ```
//!
//! Where an edge slips, the shear is μ times the pressure, in the direction s of friction. Pressures are as uncertain as shears, and errors
//! of neighbouring places are correlated; a least-squares fit of τ over p would bias μ towards zero. χ² includes the covariance of both,
//! and μ minimises it. The interval holds all μ at which χ² stays within a bound of its minimum (Fieller 1954); it may be unbounded. Where
//! the data exclude no μ, the result says so.
//!
//! A zone that slips goes on inwards until it sticks, where |τ| < μ p. χ² of many places hardly sees the first of them, so that the inner
//! parts of a zone are fitted with a coefficient of their own: if χ² falls by much with one that is less, the zone is too long.

mod bounds;
mod confidence;
mod error;
mod misfit;
mod simulate;
mod simultaneous;
mod together;

use std::ops::Range;

pub use bounds::Bounds;
use confidence::CHI_SQUARED_95;
pub(crate) use confidence::excess;
pub use confidence::{chi_squared_of_one, normal_quantile};
pub use error::IdentifyError;
use misfit::Misfit;
pub use simultaneous::simultaneous_quantile;

/// Parts of a zone at its inner end that may not have a lesser coefficient of their own.
const INNER_PARTS: [f64; 2] = [0.5, 0.25];
/// By so much χ² may fall with such a coefficient, that of 1.4 standard deviations: rather is a zone too short than that it holds places
/// which stick.
const LARGEST_FALL: f64 = 2.0;
/// Coefficients that are looked at: a grid that is fine where coefficients usually lie.
const LARGEST: f64 = 100.0;
const GRID: usize = 400;
/// Part of the first step of the grid over which the slope of χ² is taken where there is no friction.
const AT_NONE: f64 = 1e-3;

/// Tractions at places along an edge, with their covariance.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Tractions {
    /// Pressure, positive in compression `[stress]`.
    pub pressure: Vec<f64>,
    /// Shear `[stress]`.
    pub shear: Vec<f64>,
    /// Covariance of all pressures, then all shears `[stress²]`: square, row by row.
    pub covariance: Vec<f64>,
}

/// Friction of a zone that slips.
#[derive(Clone, Debug, PartialEq)]
pub struct SlipFit {
    /// The coefficient `[1]` that fits best, at least 0.
    pub mu: f64,
    /// What the data leave of it.
    pub bounds: Bounds,
    /// χ² of the best fit `[1]`.
    pub chi_squared: f64,
    /// Degrees of freedom of χ²: places less one.
    pub degrees: usize,
}

impl SlipFit {
    /// Whether one coefficient for the whole zone explains the data: χ² within `deviations` `[1]` standard deviations of what it should be,
    /// by the cube root that makes it nearly normal.
    pub fn is_consistent(&self, deviations: f64) -> bool {
        let n = self.degrees as f64;
        self.degrees == 0 || excess(self.chi_squared / n, n) <= deviations
    }
}

impl Tractions {
    /// The coefficient at which all of `zone` slips, where friction acts along +shear if `positive`; bounds with a confidence of 95 %.
    ///
    /// # Errors
    /// [`IdentifyError`] for lists and zones that do not fit, values that are not finite, an invalid covariance matrix.
    pub fn slip(&self, zone: Range<usize>, positive: bool) -> Result<SlipFit, IdentifyError> {
        self.slip_within(zone, positive, CHI_SQUARED_95)
    }

    /// The coefficient as by [`slip`](Self::slip), with bounds where χ² has risen by `rise` `[1]` above its least value, see [`chi_squared_of_one`].
    ///
    /// # Errors
    /// As [`slip`](Self::slip).
    pub fn slip_within(
        &self,
        zone: Range<usize>,
        positive: bool,
        rise: f64,
    ) -> Result<SlipFit, IdentifyError> {
        let misfit = self.misfit(zone, positive)?;
        let grid: Vec<f64> = (0..=GRID)
            .map(|k| coefficient(k as f64 / GRID as f64))
            .collect();
        let values = (grid.iter())
            .map(|mu| misfit.at(*mu))
            .collect::<Result<Vec<f64>, IdentifyError>>()?;
        let best =
            (0..values.len()).fold(0, |best, k| if values[k] < values[best] { k } else { best });
        let low = grid[best.saturating_sub(1)];
        let high = grid[(best + 1).min(GRID)];
        let mu = misfit.least(low, high)?;
        let chi_squared = misfit.at(mu)?;
        let limit = chi_squared + rise;
        // Where χ² still falls towards coefficients below 0, which there are none, the data point to an impossible value; an interval of
        // the rest would be the narrower the less they hold. So χ² counts less its slope there, as if it were least at 0 itself.
        let slope = if best == 0 {
            let step = AT_NONE * grid[1];
            ((misfit.at(step)? - misfit.at(0.0)?) / step).max(0.0)
        } else {
            0.0
        };
        let limit_at = |mu: f64| limit + slope * mu;
        // An interval may lie between two coefficients of the grid, so the least one need not be within.
        let below = (0..=best)
            .rev()
            .find(|&k| grid[k] < mu && values[k] > limit);
        let above = (best..=GRID).find(|&k| grid[k] > mu && values[k] > limit_at(grid[k]));
        let low = below
            .map(|k| misfit.crossing(grid[k], mu, &|_| limit))
            .transpose()?;
        let high = above
            .map(|k| misfit.crossing(grid[k], mu, &limit_at))
            .transpose()?;
        Ok(SlipFit {
            mu,
            bounds: Bounds::of([low, high]),
            chi_squared,
            degrees: misfit.places() - 1,
        })
    }

    /// The longest zone from place `end` inwards, towards `towards`, that one coefficient explains to `deviations` `[1]` standard deviations, with its fit, and
    /// whose inner half and quarter do not fit a lower one better. Slip starts at the end of contact, so `end` is the last place that
    /// bears pressure.
    ///
    /// # Errors
    /// As [`slip`](Self::slip).
    pub fn slip_zone(
        &self,
        end: usize,
        towards: usize,
        positive: bool,
        deviations: f64,
    ) -> Result<(Range<usize>, SlipFit), IdentifyError> {
        let zone = |last: usize| end.min(last)..end.max(last) + 1;
        let mut found = (zone(end), self.slip(zone(end), positive)?);
        let steps = end.abs_diff(towards);
        for step in 1..=steps {
            let last = if towards > end {
                end + step
            } else {
                end - step
            };
            let fit = self.slip(zone(last), positive)?;
            if fit.is_consistent(deviations) && !self.sticks(zone(last), last, positive, fit.mu)? {
                found = (zone(last), fit);
            }
        }
        Ok(found)
    }

    /// Whether an inner part of `zone`, at its end `last`, has a lesser coefficient than the rest beyond doubt.
    fn sticks(
        &self,
        zone: Range<usize>,
        last: usize,
        positive: bool,
        mu: f64,
    ) -> Result<bool, IdentifyError> {
        let misfit = self.misfit(zone.clone(), positive)?;
        let factor = misfit.factor(mu)?;
        for part in INNER_PARTS {
            let count = (part * zone.len() as f64).round() as usize;
            let inner = if last == zone.start {
                0..count
            } else {
                zone.len() - count..zone.len()
            };
            if misfit.fall(&factor, &inner) > LARGEST_FALL {
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// Standard deviation `[stress]` of the pressure (`part` 0) or of the shear (`part` 1) at `place`.
    pub fn deviation(&self, part: usize, place: usize) -> f64 {
        let count = self.pressure.len();
        let row = part * count + place;
        self.covariance[row * 2 * count + row].max(0.0).sqrt()
    }

    /// τ/p `[1]` at `place` and its standard deviation `[1]`, to first order.
    pub fn ratio(&self, place: usize) -> (f64, f64) {
        let (n, all) = (self.pressure.len(), 2 * self.pressure.len());
        let (pressure, shear) = (self.pressure[place], self.shear[place]);
        let ratio = shear / pressure;
        let entry = |i: usize, j: usize| self.covariance[i * all + j];
        let variance = entry(n + place, n + place) - 2.0 * ratio * entry(place, n + place)
            + ratio * ratio * entry(place, place);
        (ratio, variance.max(0.0).sqrt() / pressure.abs())
    }

    /// The tractions at `places`, indices below their number, each with the factor of its shear, ±1 `[1]`; covariances go with them.
    #[must_use]
    pub fn at(&self, places: &[(usize, f64)]) -> Self {
        let (own, all) = (places.len(), self.pressure.len());
        let entry = |k: usize| {
            let (place, sign) = places[k % own];
            if k < own {
                (place, 1.0)
            } else {
                (all + place, sign)
            }
        };
        let mut covariance = vec![0.0; 4 * own * own];
        for i in 0..2 * own {
            for j in 0..2 * own {
                let ((row, a), (column, b)) = (entry(i), entry(j));
                covariance[i * 2 * own + j] = a * b * self.covariance[row * 2 * all + column];
            }
        }
        let pressure = places.iter().map(|(place, _)| self.pressure[*place]);
        let shear = (places.iter()).map(|(place, sign)| sign * self.shear[*place]);
        Self {
            pressure: pressure.collect(),
            shear: shear.collect(),
            covariance,
        }
    }

    /// χ² of a zone in which friction is `positive` or not.
    fn misfit(&self, zone: Range<usize>, positive: bool) -> Result<Misfit, IdentifyError> {
        let own = self.of_zones(&[(zone, positive)])?;
        Ok(Misfit::new(own.pressure, own.shear, &own.covariance))
    }

    fn check(&self, zone: &Range<usize>) -> Result<(), IdentifyError> {
        let [pressures, shears] = [&self.pressure, &self.shear].map(Vec::len);
        if pressures != shears || self.covariance.len() != 4 * pressures * pressures {
            return Err(IdentifyError::Lengths {
                pressures,
                shears,
                entries: self.covariance.len(),
            });
        }
        if zone.is_empty() || zone.end > pressures {
            return Err(IdentifyError::Zone {
                zone: zone.clone(),
                places: pressures,
            });
        }
        let finite =
            |place: &usize| self.pressure[*place].is_finite() && self.shear[*place].is_finite();
        match zone.clone().find(|place| !finite(place)) {
            Some(place) => Err(IdentifyError::NotFinite { place }),
            None => Ok(()),
        }
    }
}

/// Coefficients from 0 to [`LARGEST`], evenly spread at first.
fn coefficient(part: f64) -> f64 {
    (part * (1.0 + LARGEST).ln()).exp_m1()
}
