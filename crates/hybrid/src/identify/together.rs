//! Tractions of several zones as one list, for one coefficient of all of them.

use std::ops::Range;

use super::{IdentifyError, Tractions};

impl Tractions {
    /// The tractions of `zones` one after the other, each with its shear turned along friction: along +shear where true. One
    /// coefficient of all is that of [`slip`](Self::slip) with `positive`.
    ///
    /// # Errors
    /// As [`slip`](Self::slip).
    pub fn of_zones(&self, zones: &[(Range<usize>, bool)]) -> Result<Self, IdentifyError> {
        for (zone, _) in zones {
            self.check(zone)?;
        }
        let places: Vec<(usize, f64)> = (zones.iter())
            .flat_map(|(zone, positive)| {
                let sign = if *positive { 1.0 } else { -1.0 };
                zone.clone().map(move |place| (place, sign))
            })
            .collect();
        Ok(self.at(&places))
    }

    /// The places of all `parts` one after the other; errors of different parts are independent.
    ///
    /// # Errors
    /// [`IdentifyError::Lengths`] for a part whose lists do not fit.
    pub fn together(parts: &[Self]) -> Result<Self, IdentifyError> {
        let all: usize = parts.iter().map(|part| part.pressure.len()).sum();
        let mut joined = Self {
            covariance: vec![0.0; 4 * all * all],
            ..Self::default()
        };
        for part in parts {
            let (first, own) = (joined.pressure.len(), part.pressure.len());
            part.check(&(0..own))?;
            let at = |k: usize| {
                if k < own {
                    first + k
                } else {
                    all + first + k - own
                }
            };
            for i in 0..2 * own {
                for j in 0..2 * own {
                    joined.covariance[at(i) * 2 * all + at(j)] = part.covariance[i * 2 * own + j];
                }
            }
            joined.pressure.extend_from_slice(&part.pressure);
            joined.shear.extend_from_slice(&part.shear);
        }
        Ok(joined)
    }
}
