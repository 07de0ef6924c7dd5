//! What a contact point remembers between load steps.
//!
//! ```text
//! s ← s + |Δs|    when a step is accepted in which the point slipped
//! ```
//!
//! All laws at a point share one record, so that composed laws agree on the past. A record never changes: [`History::commit`]
//! makes the next one. A step that is rejected is simply not committed, and leaves no trace.

use std::fmt;

/// State of a contact point at the end of an accepted load step.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash)]
pub enum PointStatus {
    /// No contact.
    #[default]
    Open,
    /// Contact without relative tangential motion during the step.
    Stick,
    /// Contact with relative tangential motion during the step.
    Slip,
}

impl fmt::Display for PointStatus {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.pad(match self {
            Self::Open => "open",
            Self::Stick => "stick",
            Self::Slip => "slip",
        })
    }
}

/// Direction of slip along the unit tangent of the contact frame: first body relative to the second.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash)]
#[repr(i8)]
pub enum Direction {
    /// Against the unit tangent.
    Negative = -1,
    /// The point has never slipped.
    #[default]
    None = 0,
    /// Along the unit tangent.
    Positive = 1,
}

impl Direction {
    /// Direction of a slip increment `[length]`; `None` for zero (and for NaN).
    pub fn of(slip_increment: f64) -> Self {
        if slip_increment > 0.0 {
            Self::Positive
        } else if slip_increment < 0.0 {
            Self::Negative
        } else {
            Self::None
        }
    }

    /// −1, 0 or +1, dimensionless.
    pub fn sign(self) -> f64 {
        f64::from(self as i8)
    }
}

/// The committed past of one contact point. The default is a point that was never in contact.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct History {
    slip_path: f64,
    status: PointStatus,
    direction: Direction,
}

impl History {
    /// Accumulated |Δs| of all steps in which the point slipped `[length]`, ≥ 0.
    ///
    /// Opening does not reset it: the surface has been slid over and stays so.
    pub fn slip_path(&self) -> f64 {
        self.slip_path
    }

    /// Status at the end of the last accepted step.
    pub fn status(&self) -> PointStatus {
        self.status
    }

    /// Direction of the last slip; sticking and opening keep it.
    pub fn direction(&self) -> Direction {
        self.direction
    }

    /// The record of the point that mirrors this one: it slipped as far, in the other direction along its own tangent.
    #[must_use = "a record is never changed in place"]
    pub fn mirrored(&self) -> Self {
        Self {
            direction: match self.direction {
                Direction::Negative => Direction::Positive,
                Direction::None => Direction::None,
                Direction::Positive => Direction::Negative,
            },
            ..*self
        }
    }

    /// The record of a point between this one and `other`, `part` (dimensionless, in [0, 1]) of the way there: its slip path lies between, the rest is that of the nearer one.
    #[must_use = "a record is never changed in place"]
    pub fn between(&self, other: &Self, part: f64) -> Self {
        let nearer = if part > 0.5 { other } else { self };
        Self {
            slip_path: (1.0 - part) * self.slip_path + part * other.slip_path,
            ..*nearer
        }
    }

    /// The record after an accepted step that ended with `status` and moved the point by the signed `slip_increment`
    /// `[length]`, first body relative to the second along the unit tangent.
    ///
    /// The increment counts only when the point slipped. An open point does not rub, and what is left of Δs at a sticking one
    /// is rounding, or the elastic give of a penalty, which unloading takes back. A NaN increment of a slipping point stays in
    /// the slip path, so that it shows instead of passing for a rest.
    #[must_use = "a record is never changed in place"]
    pub fn commit(&self, status: PointStatus, slip_increment: f64) -> Self {
        match status {
            PointStatus::Open | PointStatus::Stick => Self { status, ..*self },
            PointStatus::Slip => Self {
                slip_path: self.slip_path + slip_increment.abs(),
                status,
                direction: match Direction::of(slip_increment) {
                    Direction::None => self.direction,
                    direction => direction,
                },
            },
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn default_never_touched() {
        let past = History::default();
        assert_eq!(past.slip_path(), 0.0);
        assert_eq!(past.status(), PointStatus::Open);
        assert_eq!(past.direction(), Direction::None);
    }

    #[test]
    fn between_two_points_the_path_is_linear_and_the_rest_that_of_the_nearer() {
        let one = History::default().commit(PointStatus::Slip, 1.0);
        let other = History::default()
            .commit(PointStatus::Slip, -3.0)
            .commit(PointStatus::Stick, 0.0);
        let near = one.between(&other, 0.25);
        assert_eq!(near.slip_path(), 1.5);
        assert_eq!(near.status(), PointStatus::Slip);
        let far = one.between(&other, 0.75);
        assert_eq!(far.slip_path(), 2.5);
        assert_eq!(far.direction(), Direction::Negative);
        assert_eq!(one.between(&other, 0.0), one);
        assert_eq!(one.between(&other, 1.0), other);
    }

    #[test]
    fn path_counts_slip_of_either_sign_and_nothing_else() {
        // Dyadic increments: the sums are exact.
        let past = History::default()
            .commit(PointStatus::Stick, 0.0)
            .commit(PointStatus::Slip, 0.5)
            .commit(PointStatus::Slip, -0.25)
            .commit(PointStatus::Stick, 1e-18)
            .commit(PointStatus::Open, 8.0);
        assert_eq!(past.slip_path(), 0.75);
        assert_eq!(past.status(), PointStatus::Open);
        assert_eq!(past.direction(), Direction::Negative);
    }

    #[test]
    fn slip_of_zero_length_keeps_the_direction() {
        let past = History::default()
            .commit(PointStatus::Slip, 1.0)
            .commit(PointStatus::Slip, -0.0);
        assert_eq!(past.direction(), Direction::Positive);
        assert_eq!(past.direction().sign(), 1.0);
    }

    #[test]
    fn nan_slip_shows() {
        let past = History::default().commit(PointStatus::Slip, f64::NAN);
        assert!(past.slip_path().is_nan());
    }

    #[test]
    fn names_of_status_are_those_of_the_output() {
        let names = [PointStatus::Open, PointStatus::Stick, PointStatus::Slip];
        assert_eq!(
            names.map(|status| status.to_string()),
            ["open", "stick", "slip"]
        );
    }

    fn any_status() -> impl Strategy<Value = PointStatus> {
        prop_oneof![
            Just(PointStatus::Open),
            Just(PointStatus::Stick),
            Just(PointStatus::Slip)
        ]
    }

    proptest! {
        #[test]
        fn path_never_falls_and_commit_is_pure(steps in prop::collection::vec((any_status(), -1e3..1e3), 0..60)) {
            let mut past = History::default();
            for (status, increment) in steps {
                let before = past;
                let rejected = past.commit(PointStatus::Slip, 2.0 * increment);
                prop_assert!(rejected.slip_path() >= before.slip_path());
                prop_assert_eq!(past, before);
                past = past.commit(status, increment);
                prop_assert!(past.slip_path() >= before.slip_path());
                prop_assert_eq!(past.status(), status);
            }
        }
    }
}
