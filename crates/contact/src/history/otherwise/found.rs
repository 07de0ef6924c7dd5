//! What other ways to the end of a load step found.

/// How the end of a load step differs where it is reached another way.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Difference {
    /// Solver of the other way.
    pub solver: &'static str,
    /// Increments of the other way.
    pub increments: usize,
    /// Change of the largest pressure `[1]`, relative to the largest pressure of the answer.
    pub peak_pressure: f64,
    /// Largest change of a pressure or tangential traction `[1]`, relative to the largest pressure of the answer.
    pub traction: f64,
    /// Largest change of the slip of a point in the step `[1]`, relative to the largest slip in it either way; 0 if it is rounding of motions.
    pub slip: f64,
    /// Change of the work of friction in the step `[1]`, relative to the larger one; 0 if it is rounding.
    pub dissipation: f64,
    /// The larger work of friction in the step `[force·length]`.
    pub work: f64,
}

impl Difference {
    /// Differences beyond this part `[1]` are more than rounding; of tractions, another answer.
    pub const DISTINCT: f64 = 1e-6;

    /// Whether the other way ends at another answer.
    pub fn is_distinct(&self) -> bool {
        self.traction > Self::DISTINCT
    }

    /// Whether slip or its work differ, as they do where points close and slip from then on.
    pub fn differs_in_slip(&self) -> bool {
        self.slip.max(self.dissipation.abs()) > Self::DISTINCT
    }

    /// The largest of each number, and the change of the whole work, of two parts of an interface; the other way is that whose tractions differ more.
    pub(super) fn or_worse(self, other: Self) -> Self {
        let larger = |one: f64, other: f64| if other.abs() > one.abs() { other } else { one };
        let work = self.work + other.work;
        let changed = self.dissipation * self.work + other.dissipation * other.work;
        let way = if other.traction > self.traction {
            other
        } else {
            self
        };
        Self {
            peak_pressure: larger(self.peak_pressure, other.peak_pressure),
            traction: larger(self.traction, other.traction),
            slip: larger(self.slip, other.slip),
            dissipation: if work > 0.0 { changed / work } else { 0.0 },
            work,
            ..way
        }
    }
}

/// Why a step that may have several solutions was not compared with another solver's answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Missing {
    /// The comparisons of the history would take more work than they may.
    Effort,
    /// The other solver found no answer.
    Answer,
}

/// A load step's answer beside those of other ways to it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Otherwise {
    /// By another solver in the increments that the history asks for: where the step may have several solutions, or was cut back.
    pub other_solver: Option<Difference>,
    /// Why that is missing where it was called for.
    pub missing: Option<Missing>,
    /// By the same solver in twice as many increments: where the step was cut back under friction into few of them.
    pub finer: Option<Difference>,
    /// By the same solver where the history is walked in [`FINER`](Self::FINER) times as many increments: in steps of few increments with friction in which the load path
    /// begins or turns or contact bears anew, and in as many in those that follow. `None` before the first of them.
    pub path: Option<Difference>,
    /// Why that is missing where friction acts.
    pub path_missing: Option<Missing>,
}

impl Otherwise {
    /// Number of floating-point operations `[1]` of pivoting that all comparisons of one problem's history may take.
    pub const EFFORT: f64 = 1e9;
    /// How many times as many increments steps are compared with that have few.
    pub const FINER: usize = 4;

    /// Of both, what differs more.
    pub(super) fn or_worse(self, other: Self) -> Self {
        let more = |one: Option<Difference>, other: Option<Difference>| {
            one.into_iter().chain(other).reduce(Difference::or_worse)
        };
        Self {
            other_solver: more(self.other_solver, other.other_solver),
            missing: self.missing.or(other.missing),
            finer: more(self.finer, other.finer),
            path: more(self.path, other.path),
            path_missing: self.path_missing.or(other.path_missing),
        }
    }
}
