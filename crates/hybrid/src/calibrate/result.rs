//! What a fit says: parameters with their intervals, and the criteria by which models are compared.

use super::Correlation;
use crate::identify::{Bounds, excess};

/// What the data say of one parameter.
#[derive(Clone, Debug, PartialEq)]
pub struct Estimate {
    /// Its name.
    pub name: String,
    /// The value that fits best, in the unit of the parameter.
    pub value: f64,
    /// Standard deviation by the curvature of χ² there, in the unit of the parameter; `None` where χ² has none along it.
    pub deviation: Option<f64>,
    /// Interval of the profile. It ends where the profile passes its limit, and has no end where the range or the model ends before.
    pub bounds: Bounds,
    /// The profile: values in the unit of the parameter, ascending, and what χ² over the inflation of its variance is above its least `[1]`.
    pub profile: Vec<(f64, f64)>,
}

impl Estimate {
    /// Widens what is known of independent data to those whose variance is `inflation` times as large; the interval has its width.
    pub(super) fn inflate(&mut self, inflation: f64) {
        self.deviation = self.deviation.map(|own| own * inflation.sqrt());
        for (_, increase) in &mut self.profile {
            *increase /= inflation;
        }
    }
}

/// The best fit of a model, without what the data say of it.
#[derive(Clone, Debug, PartialEq)]
pub struct Least {
    /// Values of the parameters, in their order and units.
    pub values: Vec<f64>,
    /// The least χ² `[1]`.
    pub chi_squared: f64,
    /// Akaike's criterion corrected for few data `[1]`, as [`Calibration::aicc`].
    pub aicc: f64,
    /// How often the model was asked.
    pub evaluations: usize,
}

/// Akaike's criterion corrected for few data; infinite where there are too few for it.
pub(super) fn aicc(chi_squared: f64, unknowns: usize, data: f64) -> f64 {
    let k = unknowns as f64;
    let left = data - k - 1.0;
    if left > 0.0 {
        chi_squared + 2.0 * k + 2.0 * k * (k + 1.0) / left
    } else {
        f64::INFINITY
    }
}

/// A fitted model.
#[derive(Clone, Debug, PartialEq)]
pub struct Calibration {
    /// One per parameter, in their order.
    pub estimates: Vec<Estimate>,
    /// Covariance of the parameters by the curvature of χ², square, row by row, in products of their units; empty unless all of them have a standard deviation.
    pub covariance: Vec<f64>,
    /// The least χ² `[1]`, of data with their stated standard deviations.
    pub chi_squared: f64,
    /// Correlation of the errors of the data.
    pub correlation: Correlation,
    /// Number of data.
    pub data: usize,
    /// Number of independent nuisances.
    pub nuisances: usize,
    /// Prediction there, the fitted nuisances added, in the order and units of the data.
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

    /// Counts the degrees of freedom of χ²: data less parameters less nuisances.
    pub fn degrees(&self) -> usize {
        // `calibrate` refuses fewer data.
        self.data
            .saturating_sub(self.estimates.len() + self.nuisances)
    }

    /// χ² per degree of freedom `[1]`; about 1 where model and standard deviations hold.
    pub fn reduced(&self) -> f64 {
        self.chi_squared / self.degrees().max(1) as f64
    }

    /// Number of independent data that would say as much `[1]`.
    pub fn effective_data(&self) -> f64 {
        self.data as f64 / self.inflation()
    }

    fn inflation(&self) -> f64 {
        self.correlation.inflation.max(1.0)
    }

    /// χ² over the inflation of its variance.
    fn deviance(&self) -> f64 {
        self.chi_squared / self.inflation()
    }

    /// Akaike's criterion `[1]`, up to a constant of the data (Akaike 1974).
    pub fn aic(&self) -> f64 {
        self.deviance() + 2.0 * self.unknowns()
    }

    /// Akaike's criterion corrected for few data `[1]`, up to a constant of the data (Hurvich & Tsai 1989); infinite where there are too few
    /// for it.
    pub fn aicc(&self) -> f64 {
        let unknowns = self.estimates.len() + self.nuisances;
        aicc(self.deviance(), unknowns, self.effective_data())
    }

    /// Schwarz's criterion `[1]`, up to a constant of the data (Schwarz 1978).
    pub fn bic(&self) -> f64 {
        self.deviance() + self.unknowns() * self.effective_data().ln()
    }

    /// Number of standard deviations `[1]` by which χ² lies above what it should be if the model holds, by the cube root that makes it nearly normal
    /// (Wilson & Hilferty 1931), of as many degrees of freedom as the correlation leaves. Above 3 the model does not explain the data, or
    /// their standard deviations are too small.
    pub fn excess(&self) -> f64 {
        let degrees = self.degrees().max(1) as f64 / self.correlation.squares.max(1.0);
        excess(self.reduced(), degrees)
    }

    /// Lists the fitted values of the parameters, in their order and units.
    pub fn values(&self) -> Vec<f64> {
        self.estimates.iter().map(|own| own.value).collect()
    }
}
