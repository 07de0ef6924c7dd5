//! Parameters of any model fitted to measured data by weighted least squares, with intervals and the comparison of models.
//!
//! ```text
//! r(θ) = L⁻¹ (m − h(θ) − Z b),   Σ = L Lᵀ,     χ²(θ) = min over b of |r|²,     θ̂ = argmin χ²(θ) within the ranges,
//! profile:   χ²ⱼ(t) = min over all other θ of χ²,   θⱼ = t;     interval:   χ²ⱼ(t) − χ²(θ̂) ≤ z²,   P(|x| ≤ z) = confidence,
//! AIC = χ² + 2k,     AICc = AIC + 2k(k + 1)/(n − k − 1),     BIC = χ² + k ln n,     k: parameters and nuisances together.
//! ```
//!
//! m are the data with covariance Σ, h the model's prediction, and Z b what nobody can predict and no one asks for: the rigid motion
//! of a grating, whole fringe orders, what is left of a carrier. It is projected out before anything is weighed.
//!
//! Models with contact inside are smooth only as long as no point changes its status, and refuse parameters that make no law. So the
//! search starts on a coarse grid, goes on from its best minima by Levenberg's and Marquardt's method within the ranges, and ends with
//! trial steps that need no derivative. A refused place is a place without prediction, no failure; refusals are counted.
//!
//! An interval is that of the profile of the likelihood, which need not be symmetric and need not end: where it reaches an end of the
//! range it is one-sided, and where it reaches both the data say nothing. Nor is it an end by the data where the model refuses to go on,
//! as a static coefficient that cannot fall below the dynamic one. Sources: Levenberg (1944), Marquardt (1963), Akaike (1974),
//! Schwarz (1978), Hurvich & Tsai (1989), Venzon & Moolgavkar (1988).
//!
//! ```
//! use stickslip_hybrid::calibrate::{Block, Data, Noise, Parameter, Settings, calibrate};
//!
//! let times = [0.0, 1.0, 2.0, 3.0, 4.0];
//! let measured = times.map(|t: f64| 3.0 * (-0.5 * t).exp() + 7.0);
//! let data = Data::new(vec![Block {
//!     values: measured.to_vec(),
//!     noise: Noise::Independent(vec![0.01; 5]),
//!     nuisance: vec![vec![1.0; 5]], // an offset that nobody knows
//! }])?;
//! let decay = |at: &[f64]| -> Result<Vec<f64>, String> {
//!     Ok(times.iter().map(|t| at[0] * (-at[1] * t).exp()).collect())
//! };
//! let parameters = [Parameter::new("height", [0.0, 10.0]), Parameter::new("rate", [0.0, 5.0])];
//! let found = calibrate(&decay, &parameters, &data, &Settings::default())?;
//! assert!((found.estimates[1].value - 0.5).abs() < 1e-5);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod data;
mod information;
mod profile;
mod search;

use thiserror::Error;

pub use data::{Block, Data, Noise};

use crate::identify::{Bounds, chi_squared_of_one};
use information::Information;
use search::Search;

/// Most parameters that a fit may have; the grid of starts grows with their number's power.
pub const MOST_PARAMETERS: usize = 4;

/// A profile that finds something better starts the search anew from there, at most so often.
const ROUNDS: usize = 6;

/// Why nothing can be fitted.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum CalibrateError {
    /// Too few or too many parameters.
    #[error("{0} parameters cannot be fitted; from 1 to {MOST_PARAMETERS} can")]
    Parameters(usize),
    /// A range that is none.
    #[error("the range of '{name}' from {} to {} is none{}", range[0], range[1], if *logarithmic { ": it must increase and be positive, being logarithmic" } else { ": it must increase" })]
    Range {
        /// Name of the parameter.
        name: String,
        /// The range.
        range: [f64; 2],
        /// Whether it is divided evenly in the logarithm.
        logarithmic: bool,
    },
    /// A confidence that is none.
    #[error("the confidence {0} is not between 0 and 1")]
    Confidence(f64),
    /// Blocks of data that do not fit their noise or nuisances.
    #[error("{what} of block {block} has {found} entries, expected {expected}")]
    Length {
        /// Which array.
        what: &'static str,
        /// Index of the block.
        block: usize,
        /// Entries needed.
        expected: usize,
        /// Entries given.
        found: usize,
    },
    /// A number that is infinite or none, or a deviation that is not positive.
    #[error("{what} {index} of block {block} is {value}")]
    Value {
        /// What it is.
        what: &'static str,
        /// Index of the block.
        block: usize,
        /// Index in it.
        index: usize,
        /// The number.
        value: f64,
    },
    /// A covariance that is none.
    #[error("the covariance of block {block} is not positive definite, at row {row}")]
    Covariance {
        /// Index of the block.
        block: usize,
        /// Row in which this shows.
        row: usize,
    },
    /// Not more data than unknowns.
    #[error(
        "{data} data cannot determine {parameters} parameters and {nuisances} nuisances: more data than unknowns are needed"
    )]
    TooFew {
        /// Number of data.
        data: usize,
        /// Number of parameters.
        parameters: usize,
        /// Number of independent nuisances.
        nuisances: usize,
    },
    /// A prediction of another length than the data.
    #[error("the model predicts {found} numbers for {expected} data")]
    Prediction {
        /// Number of data.
        expected: usize,
        /// Numbers predicted.
        found: usize,
    },
    /// The model predicts nothing wherever it is asked.
    #[error(
        "the model predicts nothing at any of {tried} places in the ranges; the first reason: {first}"
    )]
    NoPrediction {
        /// Places tried.
        tried: usize,
        /// What the model said at the first.
        first: String,
    },
}

/// A parameter and where to look for it.
#[derive(Clone, Debug, PartialEq)]
pub struct Parameter {
    /// Name for results.
    pub name: String,
    /// Least and greatest value that is looked at, both of them allowed.
    pub range: [f64; 2],
    /// Whether the range is divided evenly in the logarithm, as that of a length of unknown order.
    pub logarithmic: bool,
}

impl Parameter {
    /// A parameter whose range is divided evenly.
    pub fn new(name: impl Into<String>, range: [f64; 2]) -> Self {
        Self {
            name: name.into(),
            range,
            logarithmic: false,
        }
    }

    /// The same with a range that is divided evenly in the logarithm.
    #[must_use]
    pub fn logarithmic(mut self) -> Self {
        self.logarithmic = true;
        self
    }

    fn check(&self) -> Result<(), CalibrateError> {
        let [low, high] = self.range;
        let increases = low < high && low.is_finite() && high.is_finite();
        if increases && !(self.logarithmic && low <= 0.0) {
            return Ok(());
        }
        Err(CalibrateError::Range {
            name: self.name.clone(),
            range: self.range,
            logarithmic: self.logarithmic,
        })
    }

    /// The value at the part `part` of the range, from 0 to 1.
    fn at(&self, part: f64) -> f64 {
        let [low, high] = self.range;
        let value = if self.logarithmic {
            low * (high / low).powf(part)
        } else {
            low + part * (high - low)
        };
        value.clamp(low, high)
    }

    /// How fast the value grows with the part.
    fn slope(&self, part: f64) -> f64 {
        let [low, high] = self.range;
        if self.logarithmic {
            self.at(part) * (high / low).ln()
        } else {
            high - low
        }
    }
}

/// How to search.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// Probability with which an interval is to cover the truth, between 0 and 1.
    pub confidence: f64,
    /// Grid points per parameter for 1, 2, 3 and 4 parameters, at least 2.
    pub grid: [usize; MOST_PARAMETERS],
    /// How many of the grid's minima are followed.
    pub starts: usize,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            confidence: 0.95,
            grid: [21, 11, 7, 5],
            starts: 3,
        }
    }
}

/// What the data say of one parameter.
#[derive(Clone, Debug, PartialEq)]
pub struct Estimate {
    /// Its name.
    pub name: String,
    /// The value that fits best.
    pub value: f64,
    /// Standard deviation by the curvature of χ² there; `None` where χ² has none along it.
    pub deviation: Option<f64>,
    /// Interval of the profile. It ends where the profile passes its limit, and has no end where the range or the model ends before.
    pub bounds: Bounds,
    /// The profile: values, ascending, and what χ² is above its least.
    pub profile: Vec<(f64, f64)>,
}

/// A fitted model.
#[derive(Clone, Debug, PartialEq)]
pub struct Calibration {
    /// One per parameter, in their order.
    pub estimates: Vec<Estimate>,
    /// Covariance of the parameters by the curvature of χ², square, row by row; empty unless all of them have a deviation.
    pub covariance: Vec<f64>,
    /// The least χ².
    pub chi_squared: f64,
    /// Number of data.
    pub data: usize,
    /// Number of independent nuisances.
    pub nuisances: usize,
    /// Prediction there, the fitted nuisances added, in the order of the data.
    pub fitted: Vec<f64>,
    /// How often the model was asked.
    pub evaluations: usize,
    /// How often it refused.
    pub refusals: usize,
    /// What it said first when it did.
    pub first_refusal: Option<String>,
}

impl Calibration {
    /// Number of parameters and nuisances together.
    fn unknowns(&self) -> f64 {
        (self.estimates.len() + self.nuisances) as f64
    }

    /// Degrees of freedom of χ²: data less parameters less nuisances.
    pub fn degrees(&self) -> usize {
        // `calibrate` refuses fewer data.
        self.data
            .saturating_sub(self.estimates.len() + self.nuisances)
    }

    /// χ² per degree of freedom; about 1 where model and deviations hold.
    pub fn reduced(&self) -> f64 {
        self.chi_squared / self.degrees().max(1) as f64
    }

    /// Akaike's criterion, up to a constant of the data.
    pub fn aic(&self) -> f64 {
        self.chi_squared + 2.0 * self.unknowns()
    }

    /// Akaike's criterion corrected for few data, up to a constant of the data; infinite where there are too few for it.
    pub fn aicc(&self) -> f64 {
        let k = self.unknowns();
        let left = self.data as f64 - k - 1.0;
        if left > 0.0 {
            self.aic() + 2.0 * k * (k + 1.0) / left
        } else {
            f64::INFINITY
        }
    }

    /// Schwarz's criterion, up to a constant of the data.
    pub fn bic(&self) -> f64 {
        self.chi_squared + self.unknowns() * (self.data as f64).ln()
    }

    /// By how many standard deviations χ² lies above what it should be if the model holds, by the cube root that makes it nearly normal
    /// (Wilson & Hilferty 1931). Above 3 the model does not explain the data, or their deviations are too small.
    pub fn excess(&self) -> f64 {
        let spread = 2.0 / (9.0 * self.degrees().max(1) as f64);
        (self.reduced().cbrt() - (1.0 - spread)) / spread.sqrt()
    }

    /// Values of the parameters.
    pub fn values(&self) -> Vec<f64> {
        self.estimates.iter().map(|own| own.value).collect()
    }
}

/// Fits `parameters` of `model` to `data`.
///
/// `model` takes the parameters in their order and predicts the data, block after block. Where it returns an error it has no
/// prediction, and the search goes round the place.
///
/// # Errors
/// [`CalibrateError`]: parameters, ranges or settings that are none, not more data than unknowns, predictions of another length, a model
/// that predicts nothing anywhere.
pub fn calibrate<E: std::fmt::Display>(
    model: &(impl Fn(&[f64]) -> Result<Vec<f64>, E> + Sync),
    parameters: &[Parameter],
    data: &Data,
    settings: &Settings,
) -> Result<Calibration, CalibrateError> {
    check(parameters, data, settings)?;
    let predict = |at: &[f64]| model(at).map_err(|error| error.to_string());
    let mut search = Search::new(&predict, parameters, data);
    let grid = search.grid(settings.grid[parameters.len() - 1].max(2))?;
    let mut best = search.best_of(&grid, settings.starts.max(1))?;
    let limit = chi_squared_of_one(settings.confidence);
    let mut estimates = Vec::new();
    for round in 1..=ROUNDS {
        match search.estimates(&best, &grid, limit, round == ROUNDS)? {
            Profiles::All(found) => {
                estimates = found;
                break;
            }
            Profiles::Better(found) => best = search.refined(found, &[])?,
        }
    }
    let information = search.information(&best)?;
    let values: Vec<f64> = search.values(&best.parts);
    let predicted = predict(&values).unwrap_or_default();
    Ok(Calibration {
        covariance: information.covariance(parameters, &best.parts),
        chi_squared: best.chi_squared,
        data: data.count(),
        nuisances: data.nuisances(),
        fitted: data.fitted(&predicted),
        estimates,
        evaluations: search.evaluations,
        refusals: search.refusals,
        first_refusal: search.first_refusal,
    })
}

/// Estimates of all parameters, or a point that a profile found better.
enum Profiles {
    All(Vec<Estimate>),
    Better(search::Point),
}

impl Search<'_> {
    fn estimates(
        &mut self,
        best: &search::Point,
        grid: &[search::Point],
        limit: f64,
        last: bool,
    ) -> Result<Profiles, CalibrateError> {
        let information = self.information(best)?;
        let mut estimates = Vec::new();
        for (axis, parameter) in self.parameters().iter().enumerate() {
            let way = (axis, information.scale(axis));
            match self.profile(best, grid, way, limit, last)? {
                profile::Outcome::Better(found) => return Ok(Profiles::Better(found)),
                profile::Outcome::Profile { bounds, points } => {
                    let part = best.parts[axis];
                    let slope = parameter.slope(part);
                    estimates.push(Estimate {
                        name: parameter.name.clone(),
                        value: parameter.at(part),
                        deviation: information.deviation(axis).map(|own| own * slope),
                        bounds,
                        profile: points,
                    });
                }
            }
        }
        Ok(Profiles::All(estimates))
    }
}

fn check(parameters: &[Parameter], data: &Data, settings: &Settings) -> Result<(), CalibrateError> {
    if !(1..=MOST_PARAMETERS).contains(&parameters.len()) {
        return Err(CalibrateError::Parameters(parameters.len()));
    }
    parameters.iter().try_for_each(Parameter::check)?;
    if !(settings.confidence > 0.0 && settings.confidence < 1.0) {
        return Err(CalibrateError::Confidence(settings.confidence));
    }
    if data.count() <= parameters.len() + data.nuisances() {
        return Err(CalibrateError::TooFew {
            data: data.count(),
            parameters: parameters.len(),
            nuisances: data.nuisances(),
        });
    }
    Ok(())
}
