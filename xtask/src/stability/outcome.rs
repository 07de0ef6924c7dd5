//! What comes of trials.

/// Largest error of a regularised answer that is of use.
const USEFUL: f64 = 1e-2;

/// What came of a trial. The order is that of the legend.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Outcome {
    /// An answer that meets all conditions.
    #[default]
    Solved,
    /// An answer that meets all conditions, and is not the one that it is compared with: the nearest to the last state, or where
    /// not all solutions are known the default chain's.
    Other,
    /// A proof that there is no solution.
    Certified,
    /// A regularised or discrete answer, off by no more than 1 %.
    Approximate,
    /// A regularised or discrete answer, off by more.
    Inaccurate,
    /// Not tried: the problem is too large for the method.
    NotTried,
    /// The input was refused, with a reason.
    Refused,
    /// Statuses repeated; said so.
    Cycled,
    /// Limit, singular matrix, ray or divergence; said so.
    Stopped,
    /// The chain ended without solution or proof; said so.
    Unresolved,
    /// Claimed an answer that is not a solution, or a proof of a false statement.
    Wrong,
}

impl Outcome {
    pub(crate) const ALL: [Self; 11] = [
        Self::Solved,
        Self::Other,
        Self::Certified,
        Self::Approximate,
        Self::Inaccurate,
        Self::NotTried,
        Self::Refused,
        Self::Cycled,
        Self::Stopped,
        Self::Unresolved,
        Self::Wrong,
    ];

    /// Name in tables.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Solved => "solved",
            Self::Other => "another solution",
            Self::Certified => "certified",
            Self::Approximate => "approximate",
            Self::Inaccurate => "inaccurate",
            Self::NotTried => "not tried",
            Self::Refused => "refused",
            Self::Cycled => "cycled",
            Self::Stopped => "stopped",
            Self::Unresolved => "unresolved",
            Self::Wrong => "wrong",
        }
    }

    /// Whether the default chain may end so on a supported problem.
    pub(crate) fn is_answer(self) -> bool {
        matches!(self, Self::Solved | Self::Other)
    }
}

/// A regularised answer is judged by its error, or where nothing is known by what it violates.
pub(crate) fn regularised(error: Option<f64>, violation: f64) -> Outcome {
    if error.unwrap_or(violation) <= USEFUL {
        Outcome::Approximate
    } else {
        Outcome::Inaccurate
    }
}
