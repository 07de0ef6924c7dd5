//! How much the errors of a state exceed their stated standard deviation, by fits that know of no friction law.

use std::collections::HashSet;

use stickslip_fem_core::mesh::Point;
use stickslip_hybrid::calibrate::{Correlation, Residual};

use super::{Known, Observation};

/// By what the variance of a state was multiplied.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scale {
    /// The factor, never less than 1 `[1]`: where residuals say less than was stated, the statement holds.
    pub factor: f64,
    /// What says so.
    pub source: ScaleSource,
}

/// Whose residuals a variance is measured by.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ScaleSource {
    /// Nobody's: the standard deviation as it was stated or measured.
    Stated,
    /// The localized analysis.
    Localized,
    /// The analysis of the whole plate.
    WholePlate,
}

impl ScaleSource {
    /// In words.
    pub const fn describe(self) -> &'static str {
        match self {
            Self::Stated => "the deviation as stated",
            Self::Localized => "residuals of the localized analysis",
            Self::WholePlate => "residuals of the whole plate",
        }
    }
}

impl Scale {
    /// That of state `state`, of which `kept` of `all` places are compared.
    ///
    /// What a fit cannot follow adds to its residuals, and nothing takes away from them but its parameters, which are allowed for. So the
    /// smaller of two fits is nearer to the errors.
    ///
    /// It is the variance of single data. That errors of neighbours are correlated is counted by [`Correlation`].
    pub(super) fn of(state: usize, known: Known<'_>) -> Self {
        let scale = |residual: f64, data: usize, parameters: f64| {
            residual / (data as f64 - parameters).max(1.0)
        };
        let analysed = known.analysed.iter().find(|own| own.state == state);
        let localized = analysed.and_then(|own| {
            let fit = own.fit?;
            let factor = scale(fit.residual, fit.data, fit.parameters);
            Some((factor, ScaleSource::Localized))
        });
        let plate = known.plates.iter().find(|own| own.state == state);
        let plate = plate.map(|own| {
            let (residual, data, parameters) = own.solution.fit;
            (scale(residual, data, parameters), ScaleSource::WholePlate)
        });
        let least = localized.into_iter().chain(plate);
        let least = least.min_by(|(a, _), (b, _)| a.total_cmp(b));
        let (factor, source) = least.unwrap_or((1.0, ScaleSource::Stated));
        Self {
            factor: factor.max(1.0),
            source,
        }
    }
}

/// By how much χ² scatters more than that of independent data, by the residuals that the localized analysis leaves at the compared places:
/// they know of no law, whose errors would pass for correlation.
pub(super) fn squares(observations: &[Observation], states: &[usize], known: Known<'_>) -> f64 {
    let mut all: Vec<Residual> = Vec::new();
    for (index, (own, &state)) in observations.iter().zip(states).enumerate() {
        let Some(found) = known.analysed.iter().find(|found| found.state == state) else {
            continue;
        };
        let key = |place: Point| place.map(f64::to_bits);
        let compared: HashSet<[u64; 2]> = own.places.iter().map(|&place| key(place)).collect();
        let residuals = found.residuals.iter();
        all.extend(
            (residuals.filter(|left| compared.contains(&key(left.place)))).map(|left| Residual {
                place: left.place,
                field: 2 * index + left.axis,
                value: left.value,
            }),
        );
    }
    Correlation::of(&all).squares
}
