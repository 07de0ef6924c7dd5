//! What information criteria say of laws beside each other.

use stickslip_hybrid::calibrate::Calibration;

/// Criteria that differ by less do not decide (Burnham & Anderson 2002).
pub(super) const DECIDES: f64 = 2.0;
/// A law whose criterion is worse by as much has next to no support.
const RULED_OUT: f64 = 10.0;

/// What the data say of a law beside the others.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// There is no other law to compare it with.
    Only,
    /// The least AICc, and the next law is clearly worse.
    Preferred,
    /// Not clearly worse than the best.
    AsGood,
    /// Worse, yet not ruled out.
    Weaker,
    /// Next to no support.
    RuledOut,
    /// Too few data for the criterion, which is not finite.
    Undecided,
    /// The best law, beside another one whose further parameters the mesh does not resolve.
    Sufficient,
    /// A lesser AICc than the best law, by displacements that a coarser mesh does not show.
    Unresolved,
}

impl Verdict {
    /// The verdict in words, as tables show it.
    pub const fn describe(self) -> &'static str {
        match self {
            Self::Only => "the only law",
            Self::Preferred => "preferred",
            Self::AsGood => "as good as the best",
            Self::Weaker => "weaker",
            Self::RuledOut => "ruled out",
            Self::Undecided => "too few data to compare it",
            Self::Sufficient => "sufficient: what a further parameter gains is not resolved",
            Self::Unresolved => {
                "not preferred: what its further parameters gain has the size of the model's mesh"
            }
        }
    }
}

/// What criteria say of one fit beside the others.
pub(super) struct Judgement {
    /// AICc above that of the best.
    pub(super) distance: f64,
    /// BIC above the least.
    pub(super) bic_distance: f64,
    pub(super) verdict: Verdict,
}

/// The index of the best of `fits`, and what the criteria say of each.
///
/// The best is the one with the least AICc, or the least χ² where none has a finite one, of those that none with fewer parameters
/// replaces: `prefers(complex, simple)` says whether what the former explains more is resolved.
pub(super) fn judge(
    fits: &[&Calibration],
    prefers: impl Fn(usize, usize) -> bool,
) -> (usize, Vec<Judgement>) {
    let aicc: Vec<f64> = fits.iter().map(|fit| fit.aicc()).collect();
    let bic: Vec<f64> = fits.iter().map(|fit| fit.bic()).collect();
    let least_bic = bic.iter().copied().fold(f64::INFINITY, f64::min);
    let size = |k: usize| fits[k].estimates.len();
    let order = |a: usize, b: usize| {
        let chi_squared = |k: usize| fits[k].chi_squared;
        (aicc[a].total_cmp(&aicc[b])).then(chi_squared(a).total_cmp(&chi_squared(b)))
    };
    let mut ranked: Vec<usize> = (0..fits.len()).collect();
    ranked.sort_by(|&a, &b| order(a, b));
    let replaced = |&own: &usize, others: &[usize]| {
        let mut simpler = others.iter().filter(|&&other| size(other) < size(own));
        simpler.any(|&other| !prefers(own, other))
    };
    let mut unresolved = Vec::new();
    while ranked.len() > 1 && replaced(&ranked[0], &ranked[1..]) {
        unresolved.push(ranked.remove(0));
    }
    let best = ranked.first().copied().unwrap_or(0);
    let verdicts = verdicts(&aicc, best, &unresolved).into_iter();
    let judgement = |(k, verdict): (usize, Verdict)| Judgement {
        distance: distance(aicc[k], aicc[best]),
        bic_distance: bic[k] - least_bic,
        verdict,
    };
    (best, verdicts.enumerate().map(judgement).collect())
}

/// How far a criterion lies above the least; infinite where it is not finite itself.
fn distance(own: f64, least: f64) -> f64 {
    if own.is_finite() {
        own - least
    } else {
        f64::INFINITY
    }
}

/// What the criteria say, that of `best` being the least but for those of `unresolved` laws.
fn verdicts(aicc: &[f64], best: usize, unresolved: &[usize]) -> Vec<Verdict> {
    let near = |k: usize| distance(aicc[k], aicc[best]) < DECIDES;
    let alone = (0..aicc.len()).all(|k| k == best || unresolved.contains(&k) || !near(k));
    let verdict = |k: usize| match distance(aicc[k], aicc[best]) {
        _ if aicc.len() == 1 => Verdict::Only,
        _ if !aicc[k].is_finite() => Verdict::Undecided,
        _ if unresolved.contains(&k) => Verdict::Unresolved,
        _ if k == best && alone && !unresolved.is_empty() => Verdict::Sufficient,
        _ if k == best && alone => Verdict::Preferred,
        far if far < DECIDES => Verdict::AsGood,
        far if far < RULED_OUT => Verdict::Weaker,
        _ => Verdict::RuledOut,
    };
    (0..aicc.len()).map(verdict).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_lone_law_is_compared_with_nothing() {
        assert_eq!(verdicts(&[12.0], 0, &[]), [Verdict::Only]);
        assert_eq!(verdicts(&[f64::INFINITY], 0, &[]), [Verdict::Only]);
    }

    #[test]
    fn criteria_decide_by_their_distance_from_the_least() {
        let found = verdicts(&[15.0, 10.0, 30.0, f64::INFINITY], 1, &[]);
        let expected = [
            Verdict::Weaker,
            Verdict::Preferred,
            Verdict::RuledOut,
            Verdict::Undecided,
        ];
        assert_eq!(found, expected);
        assert_eq!(verdicts(&[1.0, 2.5], 0, &[]), [Verdict::AsGood; 2]);
    }

    #[test]
    fn a_law_that_the_mesh_does_not_resolve_is_not_preferred() {
        let found = verdicts(&[15.0, 6.5, 30.0], 0, &[1]);
        let expected = [Verdict::Sufficient, Verdict::Unresolved, Verdict::RuledOut];
        assert_eq!(found, expected);
        // Another law as good as the best still is.
        assert_eq!(verdicts(&[15.0, 6.5, 16.0], 0, &[1])[2], Verdict::AsGood);
    }

    #[test]
    fn criteria_that_are_not_finite_decide_nothing() {
        let none = [f64::INFINITY; 2];
        assert_eq!(verdicts(&none, 0, &[]), [Verdict::Undecided; 2]);
        assert!(distance(none[1], none[0]).is_infinite());
    }
}
