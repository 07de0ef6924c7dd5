//! The weakest ply and place of every load step, and the load at which the first ply fails on the way.

use std::sync::Arc;

use stickslip_fem_core::parallel;
use stickslip_laminate::{Assessment, FailureCriterion, FailureError, PlyLoading};

use super::plies::{PlyStresses, Sites};
use crate::results::{FailurePoint, FirstPly};

/// Reserve factors closer than this, relatively, are equal: places and plies alike by symmetry differ by what solvers leave.
const TIE: f64 = 1e-6;

/// Follows the plies at the places of one body through the load history, with one criterion.
#[derive(Debug)]
pub(crate) struct Tracker<'a> {
    plies: &'a PlyStresses,
    criterion: Arc<dyn FailureCriterion>,
    /// Position of each site `[mm]`.
    positions: &'a [[f64; 2]],
    previous: Option<&'a Sites>,
    steps: Vec<FailurePoint>,
    reached: Option<FirstPly>,
}

/// A ply at a place with what the criterion says of it.
#[derive(Clone, Copy, Debug)]
struct Candidate {
    site: usize,
    group: usize,
    assessment: Assessment,
}

/// Sites that are asked one after the other.
const PART: usize = 256;

/// What [`PART`] sites leave.
struct Part {
    /// Those of which one may be the weakest.
    least: Vec<Candidate>,
    failing: Vec<Candidate>,
}

/// The candidates of which [`weakest`] chooses: those with the smallest reserve factor, to within [`TIE`]. Where that is 0 or infinite,
/// all have failed without load or none fails at any, and the first one with the largest index stands for them.
fn shortlist(candidates: &[Candidate]) -> Vec<Candidate> {
    let factor = |candidate: &Candidate| candidate.assessment.reserve_factor;
    let Some(least) = candidates.iter().map(factor).reduce(f64::min) else {
        return Vec::new();
    };
    if least == 0.0 || least.is_infinite() {
        let equal = candidates
            .iter()
            .filter(|candidate| factor(candidate) == least);
        let index = |candidate: &&Candidate| candidate.assessment.index;
        // The first of equal ones, which `max_by` would not give.
        let largest = equal.rev().max_by(|a, b| index(a).total_cmp(&index(b)));
        return largest.into_iter().copied().collect();
    }
    let near = |candidate: &&Candidate| factor(candidate) <= least * (1.0 + TIE);
    candidates.iter().filter(near).copied().collect()
}

/// The weakest of candidates: of equal ones the place on the positive side and the lowest ply.
fn weakest(positions: &[[f64; 2]], candidates: &[Candidate]) -> Option<Candidate> {
    let key = |candidate: &Candidate| {
        let [x, y] = positions[candidate.site];
        (y < 0.0, x < 0.0, candidate.group, candidate.site)
    };
    shortlist(candidates).into_iter().min_by_key(key)
}

impl<'a> Tracker<'a> {
    pub(crate) fn new(
        plies: &'a PlyStresses,
        criterion: Arc<dyn FailureCriterion>,
        positions: &'a [[f64; 2]],
    ) -> Self {
        Self {
            plies,
            criterion,
            positions,
            previous: None,
            steps: Vec::new(),
            reached: None,
        }
    }

    /// Takes the next load step; returns the weakest place of it.
    ///
    /// # Errors
    /// As [`FailureCriterion::assess`].
    pub(crate) fn follow(&mut self, sites: &'a Sites) -> Result<(), FailureError> {
        let seek = self.reached.is_none();
        let parts = parallel::map_range(0..sites.stress.len().div_ceil(PART), |part| {
            self.part(sites, part * PART, seek)
        });
        let parts: Vec<Part> = parts.into_iter().collect::<Result<_, _>>()?;
        let mut least = Vec::new();
        let mut failing = Vec::new();
        for part in parts {
            least.extend(part.least);
            failing.extend(part.failing);
        }
        let Some(weakest) = weakest(self.positions, &least) else {
            return Ok(());
        };
        if seek && weakest.assessment.fails() {
            self.reached = self.crossing(sites, &failing)?;
        }
        self.steps.push(self.point(sites, weakest));
        self.previous = Some(sites);
        Ok(())
    }

    /// All plies at the [`PART`] sites from `first` on.
    fn part(&self, sites: &Sites, first: usize, seek: bool) -> Result<Part, FailureError> {
        let mut all = Vec::with_capacity(PART * self.plies.shown().len());
        let means = sites.stress.iter().enumerate().skip(first).take(PART);
        for (site, &mean) in means {
            for group in 0..self.plies.shown().len() {
                let loading = self.plies.loading(group, mean, sites.heating);
                all.push(Candidate {
                    site,
                    group,
                    assessment: self.criterion.assess(self.plies.ply(group), &loading)?,
                });
            }
        }
        let fails = |candidate: &&Candidate| seek && candidate.assessment.fails();
        Ok(Part {
            failing: all.iter().filter(fails).copied().collect(),
            least: shortlist(&all),
        })
    }

    /// Where the surface is crossed on the straight way from the last step to this one.
    fn crossing(
        &self,
        sites: &Sites,
        failing: &[Candidate],
    ) -> Result<Option<FirstPly>, FailureError> {
        let mut crossing = Vec::new();
        for candidate in failing {
            let (site, group) = (candidate.site, candidate.group);
            let before = self.previous.map_or([0.0; 3], |previous| {
                self.plies
                    .applied(group, previous.stress[site], previous.heating)
            });
            let after = self.plies.applied(group, sites.stress[site], sites.heating);
            let held = self.plies.held(group);
            let loading = PlyLoading {
                held: [0, 1, 2].map(|i| held[i] + before[i]),
                applied: [0, 1, 2].map(|i| after[i] - before[i]),
            };
            let assessment = self.criterion.assess(self.plies.ply(group), &loading)?;
            crossing.push(Candidate {
                assessment,
                ..*candidate
            });
        }
        let first = weakest(self.positions, &crossing).filter(|first| first.assessment.fails());
        Ok(first.map(|first| {
            let mut at = self.point(sites, first);
            let part = first.assessment.reserve_factor;
            let (site, group) = (first.site, first.group);
            let before = self.previous.map_or(self.plies.held(group), |previous| {
                self.plies
                    .loading(group, previous.stress[site], previous.heating)
                    .at(1.0)
            });
            at.stress = [0, 1, 2].map(|i| before[i] + part * (at.stress[i] - before[i]));
            at.index = 1.0;
            at.reserve_factor = 1.0;
            FirstPly {
                step: self.steps.len(),
                reached: true,
                factor: part,
                load: None,
                load_error: None,
                at,
            }
        }))
    }

    fn point(&self, sites: &Sites, candidate: Candidate) -> FailurePoint {
        let Candidate {
            site,
            group,
            assessment,
        } = candidate;
        FailurePoint {
            criterion: assessment.criterion,
            ply: group,
            position: self.positions[site],
            stress: self
                .plies
                .loading(group, sites.stress[site], sites.heating)
                .at(1.0),
            index: assessment.index,
            reserve_factor: assessment.reserve_factor,
            mode: assessment.mode,
            errors: None,
        }
    }

    /// The weakest point of every step, and first-ply failure: on the way, or beyond the weakest step; `None` if no load of any
    /// step fails a ply.
    pub(crate) fn finish(self) -> (Vec<FailurePoint>, Option<FirstPly>) {
        let projected = || {
            let steps = self.steps.iter().enumerate();
            let (step, at) = steps
                .min_by(|(_, a), (_, b)| a.reserve_factor.total_cmp(&b.reserve_factor))
                .filter(|(_, at)| at.reserve_factor.is_finite())?;
            let residual = self.plies.held(at.ply);
            let factor = at.reserve_factor;
            let stress = [0, 1, 2].map(|i| residual[i] + factor * (at.stress[i] - residual[i]));
            Some(FirstPly {
                step,
                reached: false,
                factor,
                load: None,
                load_error: None,
                at: FailurePoint {
                    stress,
                    index: 1.0,
                    reserve_factor: 1.0,
                    ..at.clone()
                },
            })
        };
        let first = self.reached.clone().or_else(projected);
        (self.steps, first)
    }
}
