//! Localized hybrid analysis of a region, with the covariance of all that follows.
