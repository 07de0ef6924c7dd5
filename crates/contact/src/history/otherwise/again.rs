//! A load step walked again.

use std::cell::OnceCell;

use super::found::{Difference, Missing};
use crate::history::course::{Course, Means};
use crate::history::stages::Stages;
use crate::history::{LoadHistory, Ramp, StepRecord};
use crate::problem::InterfaceProblem;
use crate::solver::{InterfaceSolver, Pivoting, SemismoothNewton};

/// Part of the largest motion up to which a difference of slips is rounding.
const ROUNDING: f64 = 1e-9;
/// Number of increments up to which a step that was cut back is walked again in twice as many.
const MANY: usize = 32;
/// Number of increments from which on a load step with friction is not compared with a finer one.
const DIVIDED: usize = 8;
/// Cosine of the turn of the load path from which on increments before count for the next step too.
const STRAIGHT: f64 = 0.99;
/// Part of the normal forces that points open before bear from which on a step bears anew.
const ANEW: f64 = 0.5;

/// A load step to be walked again, of one part of the interface.
pub(super) struct Again<'a> {
    history: &'a LoadHistory,
    course: &'a Course<'a>,
    stages: &'a Stages<'a>,
    part: usize,
    index: usize,
    records: &'a [StepRecord],
    start: OnceCell<StepRecord>,
}

impl<'a> Again<'a> {
    /// The step `index` of `records`.
    pub(super) fn new(
        history: &'a LoadHistory,
        stages: &'a Stages<'a>,
        part: usize,
        index: usize,
        records: &'a [StepRecord],
    ) -> Self {
        Self {
            history,
            course: &stages.courses(index)[part],
            stages,
            part,
            index,
            records,
            start: OnceCell::new(),
        }
    }

    /// How it was walked first.
    pub(super) fn record(&self) -> &'a StepRecord {
        self.records[self.index].part(self.part)
    }

    /// Where it began then.
    pub(super) fn start(&self) -> &StepRecord {
        let before = &self.records[..self.index];
        self.start
            .get_or_init(|| self.stages.start(self.index, self.part, before))
    }

    pub(super) fn problem(&self) -> &'a InterfaceProblem {
        self.course.problem
    }

    /// Whether friction acts at its end.
    pub(super) fn rubs(&self) -> bool {
        self.record().coefficient > 0.0
    }

    /// Whether it was cut back under friction into few increments.
    pub(super) fn was_cut_back(&self) -> bool {
        let record = self.record();
        self.rubs() && record.cutbacks > 0 && record.increments <= MANY
    }

    /// Whether it depends on the path and divides too little of it.
    pub(super) fn is_coarse(&self) -> bool {
        let is_few = self.rubs() && !self.was_cut_back() && self.record().increments < DIVIDED;
        is_few && (self.turns() || self.bears_anew())
    }

    /// By pivoting, or by Newton where pivoting found the step, unless that would take more than `effort`, which is reduced by what it
    /// takes.
    pub(super) fn by_another(&self, effort: &mut f64) -> Result<Difference, Missing> {
        let ends = self.ends(1, self.history.substeps[self.index]);
        let (newton, pivoting) = (SemismoothNewton::default(), Pivoting::default());
        if self.record().solvers.contains(&pivoting.name()) {
            let found = self.by(&newton, newton.name(), &ends);
            return found.ok_or(Missing::Answer);
        }
        // Of order three times the number of points, with about two pivots per unknown.
        let order = 3.0 * self.problem().points().len() as f64;
        let cost = 4.0 * order.powi(3) * ends.len() as f64;
        if cost > *effort {
            return Err(Missing::Effort);
        }
        *effort -= cost;
        let found = self.by(&pivoting, pivoting.name(), &ends);
        found.ok_or(Missing::Answer)
    }

    /// Where increments end, in parts of the step, that divide `equal` ones `times`, or those of the record where these end as points close and open.
    pub(super) fn ends(&self, times: usize, equal: usize) -> Vec<f64> {
        let equal = || (1..=equal).map(|part| part as f64 / equal as f64).collect();
        let ends = match self.history.ramp {
            Ramp::Contact => self.record().ends.clone(),
            Ramp::Linear | Ramp::Quadratic => equal(),
        };
        let starts = std::iter::once(0.0).chain(ends.iter().copied());
        let divided = starts.zip(&ends).flat_map(|(from, &to)| {
            let parts = (1..times).map(move |part| part as f64 / times as f64);
            let within = parts.map(move |part| from + part * (to - from));
            within.chain(std::iter::once(to))
        });
        divided.collect()
    }

    /// By `solver` in increments with these `ends`.
    pub(super) fn by(
        &self,
        solver: &dyn InterfaceSolver,
        name: &'static str,
        ends: &[f64],
    ) -> Option<Difference> {
        let walk = self.walked(solver, self.start().at_its_end(), ends)?;
        Some(self.difference(&walk, name, ends.len()))
    }

    /// The step from `walk`, the end of the step before, in increments with these `ends`.
    pub(super) fn walked(
        &self,
        solver: &dyn InterfaceSolver,
        mut walk: StepRecord,
        ends: &[f64],
    ) -> Option<StepRecord> {
        let target = &self.history.steps[self.index];
        for &part in ends {
            let start = &self.start().state;
            let multipliers = self.history.multipliers(self.index, start, target, part);
            let advanced = (self.course).advance(&mut walk, solver, Means::All, &multipliers);
            advanced.ok()?;
        }
        Some(walk)
    }

    /// Whether the path of the loads that act on the problem begins with this step, or goes on in another direction; each load is measured by its
    /// largest change in a step.
    fn turns(&self) -> bool {
        let (steps, index) = (&self.history.steps, self.index);
        let change = |step: usize, case: usize| {
            let before = step
                .checked_sub(1)
                .map_or(0.0, |before| steps[before][case]);
            steps[step][case] - before
        };
        let (mut product, mut own, mut before) = (0.0, 0.0, 0.0);
        let cases = 0..steps[index].len();
        for case in cases.filter(|&case| self.problem().is_moved_by(case)) {
            let changes = (0..steps.len()).map(|step| change(step, case).abs());
            let largest = changes.fold(0.0, f64::max);
            if largest == 0.0 {
                continue;
            }
            let now = change(index, case) / largest;
            let last = index
                .checked_sub(1)
                .map_or(0.0, |last| change(last, case) / largest);
            product += now * last;
            own += now * now;
            before += last * last;
        }
        own > 0.0 && product <= STRAIGHT * (own * before).sqrt()
    }

    /// Whether points that were open before bear most of the load at the end.
    fn bears_anew(&self) -> bool {
        let (start, end) = (&self.start().state, &self.record().state);
        let force = |k: usize| end.normal_force(k);
        let points = 0..end.status.len();
        let was_open = |&k: &usize| !start.status[k].touches();
        let anew: f64 = points.clone().filter(was_open).map(force).sum();
        anew > ANEW * points.map(force).sum::<f64>()
    }

    /// How the end `walk` of the step differs.
    pub(super) fn difference(
        &self,
        walk: &StepRecord,
        solver: &'static str,
        increments: usize,
    ) -> Difference {
        let (state, other) = (&self.record().state, &walk.state);
        let points = self.problem().points().iter().enumerate();
        let (mut peak, mut other_peak, mut traction) = (0.0_f64, 0.0_f64, 0.0_f64);
        for (k, point) in points {
            peak = peak.max(state.normal_force(k) / point.area);
            other_peak = other_peak.max(other.normal_force(k) / point.area);
            let normal = other.normal_force(k) - state.normal_force(k);
            let tangential = other.tangential_force(k) - state.tangential_force(k);
            traction = traction.max(normal.abs().max(tangential.abs()) / point.area);
        }
        let over = |value: f64, whole: f64| if whole > 0.0 { value / whole } else { 0.0 };
        let (slip, other_slip) = (&self.record().slip, &walk.slip);
        let (work, other_work) = (self.record().dissipation(), walk.dissipation());
        let length = ROUNDING * state.motion.amax();
        let beyond = |value: f64, least: f64| if value.abs() > least { value } else { 0.0 };
        let slipped = beyond((other_slip - slip).amax(), length);
        let worked = beyond(other_work - work, length * state.forces.lp_norm(1));
        Difference {
            solver,
            increments,
            peak_pressure: over(other_peak - peak, peak),
            traction: over(traction, peak),
            slip: over(slipped, slip.amax().max(other_slip.amax())),
            dissipation: over(worked, work.max(other_work)),
            work: work.max(other_work),
        }
    }
}
