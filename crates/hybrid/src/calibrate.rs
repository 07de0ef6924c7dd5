//! Parameters of any model fitted to measured data by weighted least squares, with intervals and the comparison of models.
//!
//! ```text
//! r(θ) = L⁻¹ (m − h(θ) − Z b),   Σ = L Lᵀ,     χ²(θ) = min over b of |r|²,     θ̂ = argmin χ²(θ) within the ranges,
//! profile:   χ²ⱼ(t) = min over all other θ of χ²,   θⱼ = t;     interval:   χ²ⱼ(t) − χ²(θ̂) ≤ z²,   P(|x| ≤ z) = confidence,
//! AIC = χ² + 2k,     AICc = AIC + 2k(k + 1)/(n − k − 1),     BIC = χ² + k ln n,     k: parameters and nuisances together.
//! ```
//!
//! Where errors of neighbouring data are correlated ([`Correlation`]), criteria take χ² and n over the inflation v of their variance, and
//! intervals z² times v.
//!
//! m are the data with covariance Σ, h the model's prediction, and Z b the nuisances: the rigid motion of a grating, whole fringe orders,
//! the remainder of a carrier. They are projected out before the data are weighted. An error of known shape d and of roughly known size, as
//! that of a mesh, adds d dᵀ to Σ ([`Data::with_shapes`]).
//!
//! Models with contact are smooth only as long as no point changes its status, and refuse parameters that do not define a law. So the
//! search starts on a coarse grid, continues from its best minima by the Levenberg–Marquardt method within the ranges, and ends with trial
//! steps that need no derivative. Refused parameters have no prediction; refusals are counted and are not errors.
//!
//! Intervals are those of the profile likelihood. They may be asymmetric and unbounded: an interval that reaches one end of the range is
//! one-sided, and where it reaches both ends the data do not determine the parameter. An end at which the model refuses further values,
//! such as a static coefficient below the dynamic one, is not an end by the data. Sources: Levenberg (1944), Marquardt (1963), Akaike
//! (1974), Schwarz (1978), Hurvich & Tsai (1989), Venzon & Moolgavkar (1988).
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

mod correlation;
mod data;
mod error;
mod information;
mod parameter;
mod profile;
mod result;
mod search;

pub use correlation::{Correlation, Residual};
pub use data::{Amount, Block, Data, Noise};
pub use error::CalibrateError;
pub use parameter::{MOST_PARAMETERS, Parameter};
pub use result::{Calibration, Estimate, Least};

use crate::identify::chi_squared_of_one;
use search::{Point, Search};

/// A profile that finds something better starts the search anew from there, at most so often.
const ROUNDS: usize = 6;

/// How to search.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// Probability with which an interval is to cover the truth `[1]`, between 0 and 1.
    pub confidence: f64,
    /// Grid points per parameter for 1, 2, 3 and 4 parameters, at least 2.
    pub grid: [usize; MOST_PARAMETERS],
    /// How many of the grid's minima are followed.
    pub starts: usize,
    /// Correlation of the errors of the data although they are stated to be independent. Intervals widen by the root of its inflation, and
    /// criteria count fewer data.
    pub correlation: Correlation,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            confidence: 0.95,
            grid: [21, 11, 7, 5],
            starts: 3,
            correlation: Correlation::NONE,
        }
    }
}

/// Fits `parameters` of `model` to `data`.
///
/// `model` takes the parameters in their order and units and predicts the data, block after block, in theirs. Where it returns an error it has no
/// prediction, and the search goes round the place.
///
/// # Errors
/// [`CalibrateError`]: invalid parameters, ranges or settings, not more data than unknowns, predictions of another length, a model
/// that predicts nothing anywhere.
pub fn calibrate<E: std::fmt::Display>(
    model: &(impl Fn(&[f64]) -> Result<Vec<f64>, E> + Sync),
    parameters: &[Parameter],
    data: &Data,
    settings: &Settings,
) -> Result<Calibration, CalibrateError> {
    let predict = |at: &[f64]| model(at).map_err(|error| error.to_string());
    let mut search = Search::new(&predict, parameters, data);
    let (mut best, grid) = search.first(settings)?;
    let inflation = settings.correlation.inflation.max(1.0);
    let limit = inflation * chi_squared_of_one(settings.confidence);
    let mut estimates = Vec::new();
    for round in 1..=ROUNDS {
        match search.estimates(&best, &grid, limit, round == ROUNDS)? {
            Profiles::All(found) => {
                estimates = found;
                for own in &mut estimates {
                    own.inflate(inflation);
                }
                break;
            }
            Profiles::Better(found) => best = search.refined(found, &[])?,
        }
    }
    let information = search.information(&best)?;
    let values: Vec<f64> = search.values(&best.parts);
    let predicted = predict(&values).unwrap_or_default();
    let mut covariance = information.covariance(parameters, &best.parts);
    for entry in &mut covariance {
        *entry *= inflation;
    }
    Ok(Calibration {
        covariance,
        correlation: settings.correlation,
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

/// The best fit alone, without intervals; a small part of the evaluations of [`calibrate`].
///
/// # Errors
/// Those of [`calibrate`].
pub fn least<E: std::fmt::Display>(
    model: &(impl Fn(&[f64]) -> Result<Vec<f64>, E> + Sync),
    parameters: &[Parameter],
    data: &Data,
    settings: &Settings,
) -> Result<Least, CalibrateError> {
    let predict = |at: &[f64]| model(at).map_err(|error| error.to_string());
    let mut search = Search::new(&predict, parameters, data);
    let (best, _) = search.first(settings)?;
    let unknowns = parameters.len() + data.nuisances();
    Ok(Least {
        values: search.values(&best.parts),
        chi_squared: best.chi_squared,
        aicc: result::aicc(best.chi_squared, unknowns, data.count() as f64),
        evaluations: search.evaluations,
    })
}

/// Estimates of all parameters, or a point that a profile found better.
enum Profiles {
    All(Vec<Estimate>),
    Better(Point),
}

impl Search<'_> {
    /// The best point without a profile, and the grid that it was found from, of parameters, data and settings that can be searched.
    fn first(&mut self, settings: &Settings) -> Result<(Point, Vec<Point>), CalibrateError> {
        check(self.parameters(), self.data(), settings)?;
        let count = settings.grid[self.parameters().len() - 1].max(2);
        let grid = self.grid(count)?;
        let best = self.best_of(&grid, settings.starts.max(1))?;
        Ok((best, grid))
    }

    fn estimates(
        &mut self,
        best: &Point,
        grid: &[Point],
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
    parameters.iter().try_for_each(check_range)?;
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

/// Refuses a range that does not increase, or is not positive although it is logarithmic.
fn check_range(parameter: &Parameter) -> Result<(), CalibrateError> {
    let [low, high] = parameter.range;
    let increases = low < high && low.is_finite() && high.is_finite();
    if increases && !(parameter.logarithmic && low <= 0.0) {
        return Ok(());
    }
    Err(CalibrateError::Range {
        name: parameter.name.clone(),
        range: parameter.range,
        logarithmic: parameter.logarithmic,
    })
}
