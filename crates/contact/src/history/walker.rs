//! Follows a load path in increments, for everything that is loaded step by step.
//!
//! ```text
//! refused     the increment is halved, down to a smallest part, or until the work that refusals may cost is spent; if it was close, it is then tried once more as the smallest
//! accepted    the next one may be twice as long, up to a whole one, if the path says so
//! ```
//!
//! The walker knows no contact, no body and no law. The [`LoadPath`] defines what an increment is and when the next one may grow.

/// Part of an increment by which it may be stretched to end where the walk ends.
const ROUNDING: f64 = 1e-9;

/// The sizes of increments, and what refusals may cost.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Walker {
    /// A whole increment, as a part of the load step `[1]`: the largest that is tried.
    pub whole: f64,
    /// Smallest part of a whole increment `[1]` to which cut-back goes, in (0, 1].
    pub smallest_part: f64,
    /// Floating-point operations that refused attempts of one walk may cost before it is cut back no further, or twice those of the
    /// most expensive attempt where that is more; `None` without a limit.
    pub effort: Option<u64>,
}

/// An increment to be tried. Places are parts of the load step, 0 at its start and 1 at its end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LoadIncrement {
    /// Where it begins `[1]`.
    pub from: f64,
    /// Where it ends `[1]`.
    pub to: f64,
    /// Whether a refusal ends the walk, because cut-back goes no further.
    pub smallest: bool,
    /// Attempts that were refused since the last accepted increment.
    pub refusals: usize,
    /// Increments accepted at once, one after the other, just before this one.
    pub steady: usize,
    /// Its size, but for what is stretched or cut off at the end of the walk.
    size: f64,
    whole: f64,
}

impl LoadIncrement {
    /// Whether it is longer than the part `part` `[1]` of a whole increment.
    pub fn exceeds(&self, part: f64) -> bool {
        self.size > self.whole * part
    }

    /// Whether it is neither a whole increment nor the smallest: whether there is a solution is asked thoroughly at both ends of
    /// cut-back, and quickly on the way.
    pub fn is_between(&self) -> bool {
        const NEARLY_WHOLE: f64 = 0.999;
        self.size < NEARLY_WHOLE * self.whole && !self.smallest
    }
}

/// What follows an accepted increment.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Progress<E> {
    /// The next may be twice as long.
    Grow,
    /// The next is as long.
    Keep,
    /// The walk ends here.
    End(E),
}

/// What a [`Walker`] leads along a load step.
pub trait LoadPath {
    /// With what an accepted increment may end the walk.
    type End;
    /// Why an increment is refused.
    type Refusal;

    /// Tries `increment`. Accepted, its end is where the next one begins.
    ///
    /// # Errors
    /// A refusal, which leaves no trace: the next attempt begins where this one did.
    fn attempt(&mut self, increment: &LoadIncrement) -> Result<Progress<Self::End>, Self::Refusal>;

    /// Floating-point operations that a refused attempt cost.
    fn cost(refusal: &Self::Refusal) -> u64;

    /// Whether no shorter increment is worth a try after `refusal`.
    fn is_final(_refusal: &Self::Refusal) -> bool {
        false
    }

    /// Whether after `refusal` the same increment is worth another try as the smallest, where there are no shorter ones.
    fn was_close(_refusal: &Self::Refusal) -> bool {
        false
    }

    /// Takes note of a `refusal` after which a shorter increment is tried.
    fn cut_back(&mut self, refusal: Self::Refusal);
}

/// Where a walk came to its end before the end of the load step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Blocked<R> {
    /// Part of the load step that was reached `[1]`.
    pub reached: f64,
    /// Why the last attempt was refused.
    pub refusal: R,
    /// What ended cut-back before its smallest part, if that was its work.
    pub effort: Option<Effort>,
}

/// Work that refused attempts cost, and what they may cost, in floating-point operations.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Effort {
    /// Operations done.
    pub operations: u64,
    /// Operations allowed.
    pub limit: u64,
}

impl Walker {
    /// Walks from the part `from` of the load step to the part `to` `[1]`; returns with what `path` ended the walk, if it did before.
    ///
    /// # Errors
    /// [`Blocked`] if the smallest increment is refused, or if refusals cost more than they may.
    pub fn walk<P: LoadPath>(
        &self,
        [from, to]: [f64; 2],
        path: &mut P,
    ) -> Result<Option<P::End>, Blocked<P::Refusal>> {
        let fits = |left: f64, size: f64| left <= size * (1.0 + ROUNDING);
        let mut reached = from;
        let mut size = if fits(to - from, self.whole) {
            to - from
        } else {
            self.whole
        };
        let (mut refusals, mut steady) = (0, 0);
        let (mut spent, mut largest) = (0, 0);
        while reached < to {
            let left = to - reached;
            let increment = LoadIncrement {
                from: reached,
                to: if fits(left, size) { to } else { reached + size },
                smallest: size <= self.whole * self.smallest_part,
                refusals,
                steady,
                size,
                whole: self.whole,
            };
            let mut attempt = path.attempt(&increment);
            let mut effort = None;
            if let Err(refusal) = attempt {
                if !increment.smallest {
                    let cost = P::cost(&refusal);
                    (spent, largest) = (spent + cost, largest.max(cost));
                    effort = self.exceeded(spent, largest);
                }
                attempt = if effort.is_some() && P::was_close(&refusal) {
                    path.cut_back(refusal);
                    path.attempt(&LoadIncrement {
                        smallest: true,
                        ..increment
                    })
                } else {
                    Err(refusal)
                };
            }
            match attempt {
                Ok(progress) => {
                    reached = increment.to;
                    steady = if refusals == 0 { steady + 1 } else { 0 };
                    refusals = 0;
                    match progress {
                        Progress::Grow => size = self.whole.min(2.0 * size),
                        Progress::Keep => {}
                        Progress::End(end) => return Ok(Some(end)),
                    }
                }
                Err(refusal) => {
                    if increment.smallest || effort.is_some() || P::is_final(&refusal) {
                        return Err(Blocked {
                            reached,
                            refusal,
                            effort,
                        });
                    }
                    path.cut_back(refusal);
                    // Half of what was tried, which is less than `size` where little was left.
                    size = 0.5 * if fits(size, left) { size } else { left };
                    (refusals, steady) = (refusals + 1, 0);
                }
            }
        }
        Ok(None)
    }

    /// What refusals cost, if that is more than they may.
    fn exceeded(&self, operations: u64, largest: u64) -> Option<Effort> {
        let limit = self.effort?.max(2 * largest);
        (operations > limit).then_some(Effort { operations, limit })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Refuses increments beyond `from` that are longer than `longest` of the load step, up to `until`.
    #[derive(Debug)]
    struct Rough {
        from: f64,
        until: f64,
        longest: f64,
        ends: Vec<f64>,
        refused: usize,
    }

    impl LoadPath for Rough {
        type End = ();
        type Refusal = u64;

        fn attempt(&mut self, increment: &LoadIncrement) -> Result<Progress<()>, u64> {
            let crosses = increment.to > self.from && increment.from < self.until;
            if crosses && increment.to - increment.from > self.longest {
                return Err(7);
            }
            self.ends.push(increment.to);
            Ok(if increment.refusals == 0 && increment.steady > 0 {
                Progress::Grow
            } else {
                Progress::Keep
            })
        }

        fn cost(refusal: &u64) -> u64 {
            *refusal
        }

        fn cut_back(&mut self, _refusal: u64) {
            self.refused += 1;
        }
    }

    fn rough(from: f64, until: f64, longest: f64) -> Rough {
        let (ends, refused) = (Vec::new(), 0);
        Rough {
            from,
            until,
            longest,
            ends,
            refused,
        }
    }

    const WHOLE: Walker = Walker {
        whole: 1.0,
        smallest_part: 1.0 / 1024.0,
        effort: None,
    };

    /// Two increments of each size on the way up: far fewer than the thousand without growth.
    #[test]
    fn increments_grow_again_after_a_rough_place() {
        let mut path = rough(0.0, 0.01, 1.0 / 1024.0);
        assert_eq!(WHOLE.walk([0.0, 1.0], &mut path), Ok(None));
        assert_eq!(path.ends.last(), Some(&1.0));
        assert!(path.refused >= 10 && path.ends.len() < 60, "{path:?}");
        assert!(path.ends.windows(2).all(|two| two[0] < two[1]));
        let longest = path.ends.windows(2).map(|two| two[1] - two[0]);
        assert!(longest.fold(0.0, f64::max) > 0.2, "{path:?}");
    }

    /// Where each increment but the first of its size is refused, growth changes nothing: the walk closes in on a limit.
    #[test]
    fn a_limit_is_approached_by_halves() {
        let mut path = rough(1.0 / 3.0, 2.0, 0.0);
        let blocked = WHOLE.walk([0.0, 1.0], &mut path).unwrap_err();
        assert_eq!((blocked.refusal, blocked.effort), (7, None));
        assert_eq!(blocked.reached, 341.0 / 1024.0);
        assert_eq!(
            path.ends,
            [0.25, 0.3125, 0.328125, 0.33203125, blocked.reached]
        );
    }

    #[test]
    fn refusals_cost_no_more_than_they_may() {
        let walker = Walker {
            effort: Some(20),
            ..WHOLE
        };
        let mut path = rough(0.0, 1.0, 0.0);
        let blocked = walker.walk([0.0, 1.0], &mut path).unwrap_err();
        let effort = Effort {
            operations: 21,
            limit: 20,
        };
        assert_eq!((blocked.reached, blocked.effort), (0.0, Some(effort)));
        assert_eq!(path.refused, 2);
    }

    /// Where refusals have cost what they may, the increment is tried once more as the smallest, which is accepted here.
    #[test]
    fn what_would_be_the_end_is_tried_as_the_smallest() {
        struct Lenient(Vec<f64>);
        impl LoadPath for Lenient {
            type End = ();
            type Refusal = ();

            fn attempt(&mut self, increment: &LoadIncrement) -> Result<Progress<()>, ()> {
                self.0.push(increment.to - increment.from);
                increment.smallest.then_some(Progress::Keep).ok_or(())
            }

            fn cost((): &()) -> u64 {
                7
            }

            fn was_close((): &()) -> bool {
                true
            }

            fn cut_back(&mut self, (): ()) {}
        }
        let walker = Walker {
            whole: 0.5,
            effort: Some(20),
            ..WHOLE
        };
        let mut path = Lenient(Vec::new());
        assert_eq!(walker.walk([0.0, 0.25], &mut path), Ok(None));
        assert_eq!(path.0[..4], [0.25, 0.125, 0.0625, 0.0625]);
    }

    /// The end of a walk is met exactly, whatever the sum of its increments.
    #[test]
    fn whole_increments_end_where_the_walk_ends() {
        let walker = Walker {
            whole: 1.0 / 49.0,
            ..WHOLE
        };
        let mut path = rough(2.0, 2.0, 0.0);
        assert_eq!(walker.walk([0.0, 1.0], &mut path), Ok(None));
        assert_eq!((path.ends.len(), path.ends.last()), (49, Some(&1.0)));
    }
}
