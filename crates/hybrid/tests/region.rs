//! The localized hybrid analysis of a region: exactness, covariance, checks, direct interpolation, fit.

mod region {
    mod checks;
    mod covariance;
    mod fit;
    mod refusals;
    mod solution;
    pub(crate) mod support;
}
