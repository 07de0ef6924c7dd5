//! How much the errors of a state exceed their stated deviation, by fits that know of no friction law.

use super::Known;
use crate::experiment::analysed::scale::IN_A_BLOCK;

/// By what the variance of a state was multiplied.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scale {
    /// The factor, never less than 1: where residuals say less than was stated, the statement holds.
    pub factor: f64,
    /// What says so.
    pub source: ScaleSource,
}

/// Whose residuals a variance is measured by.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ScaleSource {
    /// Nobody's: the deviation as it was stated or measured.
    Stated,
    /// The localized analysis.
    Localized,
    /// The analysis of the whole plate.
    WholePlate,
}

impl ScaleSource {
    /// In words.
    pub const fn words(self) -> &'static str {
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
    /// Places that are farther apart than blocks of neighbours have errors of their own, whose variance is that of single residuals.
    /// Nearer ones go together, and count by the means of blocks.
    pub(super) fn of(state: usize, known: Known<'_>, kept: usize, all: usize) -> Self {
        let apart = kept as f64 * IN_A_BLOCK <= all as f64;
        let scale = |residual: f64, data: usize, parameters: f64, blocks: f64| {
            let single = residual / (data as f64 - parameters).max(1.0);
            if apart { single } else { single.max(blocks) }
        };
        let analysed = known.analysed.iter().find(|own| own.state == state);
        let localized = analysed.and_then(|own| {
            let fit = own.fit?;
            let factor = scale(fit.residual, fit.data, fit.parameters, own.scale);
            Some((factor, ScaleSource::Localized))
        });
        let plate = known.plates.iter().find(|own| own.state == state);
        let plate = plate.map(|own| {
            let (residual, data, parameters) = own.solution.fit;
            let factor = scale(residual, data, parameters, own.solution.scale);
            (factor, ScaleSource::WholePlate)
        });
        let least = localized.into_iter().chain(plate);
        let least = least.min_by(|(a, _), (b, _)| a.total_cmp(b));
        match least {
            Some((factor, source)) if factor > 1.0 => Self { factor, source },
            Some((_, source)) => Self {
                factor: 1.0,
                source,
            },
            None => Self {
                factor: 1.0,
                source: ScaleSource::Stated,
            },
        }
    }
}
