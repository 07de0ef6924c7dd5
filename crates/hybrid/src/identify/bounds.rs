//! Bounds of coefficients.

/// What data say of a coefficient, with a confidence of 95 % where no other is said.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Bounds {
    /// It lies between these, in its unit.
    Between(f64, f64),
    /// It is at most this, in its unit; there may be no friction at all.
    AtMost(f64),
    /// It is at least this, in its unit.
    AtLeast(f64),
    /// Not identifiable: no coefficient is ruled out.
    Nothing,
}

impl Bounds {
    /// Bounds with these ends, lower and upper, in the unit of the quantity; `None` where there is none.
    pub fn of(ends: [Option<f64>; 2]) -> Self {
        match ends {
            [Some(low), Some(high)] => Self::Between(low, high),
            [None, Some(high)] => Self::AtMost(high),
            [Some(low), None] => Self::AtLeast(low),
            [None, None] => Self::Nothing,
        }
    }

    /// The lower and the upper end, in the unit of the quantity; `None` where there is none.
    pub fn ends(self) -> [Option<f64>; 2] {
        match self {
            Self::Between(low, high) => [Some(low), Some(high)],
            Self::AtMost(high) => [None, Some(high)],
            Self::AtLeast(low) => [Some(low), None],
            Self::Nothing => [None; 2],
        }
    }

    /// Whether `mu`, in the unit of the bounds, lies within.
    pub fn contain(self, mu: f64) -> bool {
        let [low, high] = self.ends();
        low.is_none_or(|low| mu >= low) && high.is_none_or(|high| mu <= high)
    }

    /// The same with ends whose distances from `best` hold a further error `by` of the value, squares added; all in one unit. An end at or below `least`, the
    /// least possible value, is left out.
    #[must_use]
    pub fn widened(self, best: f64, by: f64, least: f64) -> Self {
        let [low, high] = self.ends();
        let low = low.map(|low| best - (best - low).hypot(by));
        let high = high.map(|high| best + (high - best).hypot(by));
        Self::of([low.filter(|low| *low > least), high])
    }
}
