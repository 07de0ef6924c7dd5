//! Climbs from model to model, and states the errors of the last one.

mod increments;

use stickslip_contact::InterfaceSolver;
use stickslip_scene::Scene;
use stickslip_scene::schema::{Accuracy, Budget, KinematicsChoice, Memory};

use crate::along::Along;
use crate::before::{Asked, before};
use crate::geometry::Geometry;
use crate::grading::Grading;
use crate::level::Level;
use crate::models::{Division, Models, slowness};
use crate::motions::Motions;
use crate::numbers::{Estimates, Numbers, above_rounding, drop_unresolved, sum, zipped};
use crate::path::{Left, larger};
use crate::stresses::Limits;
use crate::worst::{Worst, unstated, worst};
use crate::{division, failure, places, stated, stresses, unseen};
use stickslip_engine::model::obstacle_to_half;
use stickslip_engine::results::{
    Bounded, Errors, Finding, Ladder, LadderEnd, Results, Rung, Stated,
};
use stickslip_engine::run::{Progress, RunError, numbers_with_errors, results, run_with};

/// Where the load path leaves too much, no finer division is tried for other errors of less than this part of that.
const SMALL: f64 = 0.5;
/// The undeformed geometry may take this part of what is asked.
const GEOMETRY_SHARE: f64 = 0.3;
/// Budget of a scene that asks for no accuracy `[s]`.
const PATIENCE: f64 = 60.0;
/// Times that nodes of a line contact are moved closer to it, each time by about thirty, until it has some.
const ZOOMS: usize = 8;
/// A finer model takes about so many times as long, and as much memory, as the last one.
const GROWTH: f64 = 4.0;

/// Climbs until the accuracy of `scene` is met, and returns the results of the last model.
///
/// # Errors
/// [`RunError`] of the first models; a finer model that cannot be made leaves the answer of the last one.
pub(crate) fn climb(
    scene: &Scene,
    solver: &dyn InterfaceSolver,
    progress: &mut dyn FnMut(Progress),
) -> Result<Results, RunError> {
    let models = Models::new(scene, solver)?;
    let asked = scene
        .analysis
        .accuracy
        .or(models.is_free().then_some(Accuracy::DEFAULT));
    let mut climb = Climb {
        asked,
        start: scene.host().seconds(),
        rungs: Vec::new(),
        ran_out: false,
        scene,
        models,
    };
    let (base, mut model) = climb.kinematics(progress)?;
    let (base, mut path) = match climb.increments(base, progress) {
        Err(why) if model.is_chosen_deformed => {
            model = Geometry::unknown(&why);
            climb.models.kinematics = KinematicsChoice::Small;
            let substeps = vec![scene.analysis.substeps(); scene.steps()];
            let base = climb.models.level(1, &substeps, progress)?;
            climb.increments(base, progress)?
        }
        found => found?,
    };
    let coarse = (climb.models).level(base.rung - 1, &base.substeps, progress);
    let mut levels: Vec<Level> = coarse.into_iter().chain([base]).collect();
    loop {
        let errors = climb.errors(&levels, &path, &model);
        let end = climb.end(&levels, &errors, &path);
        let seating = climb.models.seating();
        let next = match (end, levels.last()) {
            (None, Some(last)) => {
                let rung = last.rung + 1;
                climb.models.grade(last, rung);
                climb.models.seat(last);
                let next = climb.level_in_time(rung, &last.substeps, progress);
                next.ok().flatten()
            }
            _ => None,
        };
        let Some(level) = next else {
            climb.models.sit_as(seating);
            let end = end.unwrap_or(if climb.ran_out {
                LadderEnd::Budget
            } else {
                LadderEnd::Finest
            });
            let ends = climb.checked((&mut levels, &mut path, &model), (errors, end), progress);
            // Finer nodes may make up for what increments leave.
            let Some((errors, end)) = ends else {
                continue;
            };
            return climb.finish(levels, errors, &path, &model, end);
        };
        if let Some(last) = levels.last_mut() {
            last.solved.own = None;
        }
        levels.push(level);
        climb.renew(&levels, &mut model, progress);
    }
}

struct Climb<'a> {
    scene: &'a Scene,
    models: Models<'a>,
    asked: Option<Accuracy>,
    start: f64,
    rungs: Vec<Rung>,
    /// Whether the budget ended the increments before they were fine enough, or a model.
    ran_out: bool,
}

impl Climb<'_> {
    /// All errors of the last of `levels`.
    fn errors(&self, levels: &[Level], path: &Left, geometry: &Geometry) -> Estimates {
        let [_, .., last] = levels else {
            // Of the division nothing is known.
            return Estimates::default();
        };
        let mut divided = division::errors(&numbers(levels), self.models.spaced());
        let friction = |edge, pressure| last.friction(edge, pressure);
        unseen::widen(&mut divided, &last.numbers, friction);
        let mut all = sum(&sum(&divided, &path.numbers), &geometry.errors.numbers);
        places::widen(&mut all, &last.numbers);
        above_rounding(&mut all, &last.numbers);
        drop_unresolved(&mut all, &last.numbers);
        Estimates {
            numbers: all,
            sets: self.errors_of_sets(levels, last, path, geometry),
        }
    }

    /// Those of sets of `last`, the last of `levels`.
    fn errors_of_sets(
        &self,
        levels: &[Level],
        last: &Level,
        path: &Left,
        geometry: &Geometry,
    ) -> Motions {
        let sets: Vec<&Motions> = levels.iter().map(|level| &level.numbers.sets).collect();
        let divided = Motions::of_division(&sets, self.models.spaced().rate());
        let divided = divided.times(slowness(&last.model));
        let all = divided.and(&path.sets).and(&geometry.errors.sets);
        let all = all.above_rounding(&last.numbers.sets);
        all.only(&self.sets_with_errors(last))
    }

    /// Which numbers of sets can have an error.
    fn sets_with_errors(&self, level: &Level) -> Vec<[bool; 4]> {
        let forces = level.numbers.sets.forces();
        let uneven = self.models.uneven(&level.model);
        numbers_with_errors(&level.model, &level.solved, &forces, &uneven)
    }

    /// Renews what deformed gaps may change by the last of `levels`, which was just solved, if its operators make that cheap: those of elements, whose first
    /// model may have three nodes in contact.
    fn renew(
        &mut self,
        levels: &[Level],
        geometry: &mut Geometry,
        progress: &mut dyn FnMut(Progress),
    ) {
        let last = levels.last().filter(|_| !self.models.is_graded());
        let Some(last) = last.filter(|_| !geometry.errors.numbers.is_empty()) else {
            return;
        };
        if let Ok(deformed) = self.deformed(last, progress) {
            geometry.renew(&last.numbers, &deformed.numbers);
            let worst = worst(&last.numbers, &geometry.errors, self.bounds());
            geometry.reason = Geometry::reason(worst.map(Worst::named), false);
        }
    }

    /// The model of `small` with deformed gaps.
    fn deformed(
        &mut self,
        small: &Level,
        progress: &mut dyn FnMut(Progress),
    ) -> Result<Level, RunError> {
        self.models.kinematics = KinematicsChoice::DeformedGaps;
        let deformed = self.models.level(small.rung, &small.substeps, progress);
        self.models.kinematics = KinematicsChoice::Small;
        deformed
    }

    /// The first model, on the geometry that the accuracy needs.
    fn kinematics(
        &mut self,
        progress: &mut dyn FnMut(Progress),
    ) -> Result<(Level, Geometry), RunError> {
        let substeps = &vec![self.scene.analysis.substeps(); self.scene.steps()];
        let is_auto = self.models.kinematics == KinematicsChoice::Auto;
        if is_auto {
            self.models.kinematics = KinematicsChoice::Small;
        }
        if self.models.is_graded() {
            let mut coarse = self.models.level(0, substeps, progress)?;
            for _ in 0..ZOOMS {
                self.models.grade(&coarse, 0);
                coarse = self.models.level(0, substeps, progress)?;
                if Grading::resolves(&coarse.numbers) {
                    break;
                }
            }
            self.models.grade(&coarse, 1);
        }
        let mut small = self.models.level(1, substeps, progress)?;
        self.record(&small, None);
        self.seat(&mut small, progress);
        if !is_auto || small.model.pairs.is_empty() {
            let geometry = if small.model.pairs.is_empty() {
                Geometry::default()
            } else {
                Geometry::given(self.scene)
            };
            return Ok((small, geometry));
        }
        let deformed = match self.deformed(&small, progress) {
            Ok(deformed) => deformed,
            Err(why) => return Ok((small, Geometry::unknown(&why))),
        };
        self.record(&deformed, None);
        let mut geometry = Geometry::default();
        geometry.renew(&small.numbers, &deformed.numbers);
        let worst = worst(&small.numbers, &geometry.errors, self.bounds());
        let matters = worst.is_some_and(|worst| worst.part > GEOMETRY_SHARE);
        let reason = Geometry::reason(worst.map(Worst::named), matters);
        if matters {
            self.models.kinematics = KinematicsChoice::DeformedGaps;
            geometry = Geometry {
                is_chosen_deformed: true,
                ..Geometry::default()
            };
        }
        let mut base = if matters { deformed } else { small };
        self.seat(&mut base, progress);
        Ok((base, Geometry { reason, ..geometry }))
    }

    /// Solves `level` again where its bodies sit, if nodes of elements were paired too far apart in it.
    fn seat(&mut self, level: &mut Level, progress: &mut dyn FnMut(Progress)) {
        if self.models.seat(level)
            && let Ok(seated) = self.models.level(level.rung, &level.substeps, progress)
        {
            self.record(&seated, None);
            *level = seated;
        }
    }

    /// As [`Models::level`], but given up when the budget is spent, which is recorded; none is returned then.
    fn level_in_time(
        &mut self,
        rung: usize,
        substeps: &[usize],
        progress: &mut dyn FnMut(Progress),
    ) -> Result<Option<Level>, RunError> {
        let start = self.scene.host().seconds();
        self.models.until = self.until();
        let found = self.models.level(rung, substeps, progress);
        self.models.until = None;
        if found.is_ok() || !self.models.stopped {
            return found.map(Some);
        }
        self.ran_out = true;
        self.rungs.push(Rung {
            model: self.models.division_of(rung),
            increments: substeps.to_vec(),
            error: None,
            seconds: self.scene.host().seconds() - start,
            stopped: true,
        });
        Ok(None)
    }

    /// What bounds the errors that are compared.
    fn bounds(&self) -> Accuracy {
        self.asked.unwrap_or(Accuracy::DEFAULT)
    }

    fn record(&mut self, level: &Level, error: Option<(f64, Bounded)>) {
        self.rungs.push(Rung {
            model: level.division.clone(),
            increments: level.substeps.clone(),
            error,
            seconds: level.seconds,
            stopped: false,
        });
    }

    /// Records the last of `levels` with its `errors`, and says why the climb ends there, if it does; no finer division makes those that the
    /// load path `left` smaller.
    fn end(&mut self, levels: &[Level], errors: &Estimates, left: &Left) -> Option<LadderEnd> {
        let last = levels.last()?;
        let worst_of = |errors: &Estimates| worst(&last.numbers, errors, self.bounds());
        let worst = worst_of(errors);
        let (left, others) = left.part_of(errors);
        let part = |worst: Option<Worst>| worst.map_or(0.0, |worst| worst.part);
        let [left, others] = [left, others].map(|errors| part(worst_of(&errors)));
        let is_pinned = self.scene.analysis.substeps.is_some();
        let is_left = !is_pinned && left > 1.0 && others < SMALL * left;
        let error = worst.map(Worst::named);
        let is_known =
            |rung: &Rung| (&rung.model, &rung.increments) == (&last.division, &last.substeps);
        match self.rungs.iter_mut().rev().find(|rung| is_known(rung)) {
            Some(rung) => rung.error = error,
            None => self.record(last, error),
        }
        let is_met = levels.len() > 1
            && worst.is_none_or(|worst| worst.part <= 1.0)
            && !self.is_unresolved(&last.numbers);
        let reached = self.asked.is_some() && is_met;
        if reached && unstated(&last.numbers, errors, self.bounds()).is_empty() {
            Some(LadderEnd::Reached)
        } else if reached {
            Some(LadderEnd::Unstated)
        } else if self.ran_out {
            Some(LadderEnd::Budget)
        } else if self.models.division() == Division::Pinned {
            Some(LadderEnd::Pinned)
        } else if is_left && self.asked.is_some() {
            Some(LadderEnd::LoadPath)
        } else if self.is_spent(last) {
            Some(LadderEnd::Budget)
        } else if self.models.is_finest(last.rung) {
            let is_of_path = is_pinned && left > 1.0 && left > others;
            Some(if is_of_path {
                LadderEnd::LoadPath
            } else {
                LadderEnd::Finest
            })
        } else {
            self.is_too_large_next(last).then_some(LadderEnd::Memory)
        }
    }

    /// Whether a largest pressure that is asked for rests on too few nodes.
    fn is_unresolved(&self, numbers: &Numbers) -> bool {
        let is_asked = Bounded::from(Stated::PeakPressure)
            .bound(self.bounds())
            .is_some();
        let edges = numbers.geometries.iter().enumerate();
        let mut contacts = edges.filter(|(_, edge)| edge.contact);
        let steps = 0..numbers.steps.len();
        let is_any = |edge: usize| steps.clone().any(|step| numbers.is_unresolved(step, edge));
        is_asked && contacts.any(|(edge, _)| is_any(edge))
    }

    /// When the budget is spent, on the clock of the scene's host `[s]`.
    fn until(&self) -> Option<f64> {
        let analysis = &self.scene.analysis;
        let patience = analysis.accuracy.is_none().then_some(PATIENCE);
        let budget = analysis.budget.map(Budget::seconds).or(patience);
        budget.map(|budget| self.start + budget)
    }

    /// Whether a model finer than `last` would exceed the budget.
    fn is_spent(&self, last: &Level) -> bool {
        let then = self.scene.host().seconds() + GROWTH * last.seconds_anew;
        self.until().is_some_and(|until| then > until)
    }

    /// Whether a model finer than `last` would take more memory than it may.
    fn is_too_large_next(&self, last: &Level) -> bool {
        let memory = self.scene.analysis.memory.unwrap_or(Memory::DEFAULT);
        GROWTH * last.bytes() > memory.bytes()
    }

    /// The results of the last level, with their errors.
    fn finish(
        mut self,
        mut levels: Vec<Level>,
        mut errors: Estimates,
        path: &Left,
        geometry: &Geometry,
        mut end: LadderEnd,
    ) -> Result<Results, RunError> {
        let along = Along::of_division(&numbers(&levels), self.models.spaced());
        let along = along.and(&path.along).and(&geometry.along);
        let Some(last) = levels.pop() else {
            return run_with(self.scene, self.models.solver(), &mut |_| {});
        };
        let along = along.floored(&last.numbers);
        let mut along = along.into_steps(&last.numbers.geometries);
        let unlimited = division::findings(&last.numbers, &errors.numbers);
        if geometry.failed.is_some() {
            end = LadderEnd::Unchecked;
            along.clear();
            errors.sets = Motions::default();
            for rung in &mut self.rungs {
                rung.error = None;
            }
            for own in errors.numbers.iter_mut().flatten() {
                *own = Errors::default();
            }
        }
        let worst = worst(&last.numbers, &errors, self.bounds());
        let missed = self.missed(worst, end);
        let unstated = self.unstated(&last.numbers, &errors, end);
        let mut found = results(&last.model, self.models.solver(), last.solved)?;
        let uneven = self.models.uneven(&last.model);
        let bodies: Vec<String> = (uneven.iter())
            .map(|&body| last.model.bodies[body].name.clone())
            .collect();
        let has_uneven = !bodies.is_empty();
        (found.findings).extend(has_uneven.then_some(Finding::SetsWithoutErrors { bodies }));
        found.findings.retain(|finding| !finding.is_within_errors());
        found.findings.extend(unlimited);
        found.findings.extend(missed.into_iter().chain(unstated));
        let unchecked = geometry.failed.clone();
        (found.findings).extend(unchecked.map(|why| Finding::GeometryUnchecked { why }));
        let left_out = geometry.left_out.clone();
        (found.findings).extend(left_out.map(|why| Finding::GeometryLeftOut { why }));
        let asked = Asked {
            failure: last.model.request.failure.is_some(),
            stresses: found.steps.iter().any(|step| !step.stresses.is_empty()),
        };
        if geometry.failed.is_none() {
            let mut left = sum(&path.numbers, &geometry.errors.numbers);
            // The change of two models alone may vanish by chance.
            if self.models.is_graded() && levels.len() == 1 {
                left = zipped(&left, &errors.numbers, larger);
            }
            let parts = failure::parts(&last.numbers, &left);
            let before = before(levels, self.models.solver(), asked);
            let is_whole = !last.model.half && obstacle_to_half(self.scene).is_none();
            let mirror = |body| is_whole.then(|| last.model.across(body)).flatten();
            failure::estimate_all(&mut found.failure, &before, &parts, mirror);
            let limits = Limits {
                model: &last.model,
                numbers: &last.numbers,
                uneven: &uneven,
                is_graded: self.models.is_graded(),
            };
            stresses::estimate_all(&mut found, &before, &parts, &limits);
        }
        stated::put(
            &mut found,
            last.numbers.steps,
            errors.numbers,
            along,
            last.model.origin,
        );
        errors.sets.put(&mut found);
        geometry.explain(&mut found);
        found.ladder = Some(Ladder {
            asked: self.asked,
            rungs: self.rungs,
            end,
        });
        Ok(found)
    }

    /// The numbers whose accuracy is asked for and that have no error.
    fn unstated(&self, numbers: &Numbers, errors: &Estimates, end: LadderEnd) -> Option<Finding> {
        // Of one model alone no number has an error.
        let is_said =
            self.asked.is_some() && end != LadderEnd::Unchecked && !errors.numbers.is_empty();
        let found = unstated(numbers, errors, self.bounds());
        let numbers: Vec<_> = found.into_iter().map(Bounded::describe).collect();
        (is_said && !numbers.is_empty()).then_some(Finding::AccuracyUnstated { numbers })
    }

    /// That the accuracy asked for is not reached, where it is not.
    fn missed(&self, worst: Option<Worst>, end: LadderEnd) -> Option<Finding> {
        let (error, number) = worst?.named();
        let is_missed = self.asked.is_some() && worst?.part > 1.0 && end != LadderEnd::Reached;
        is_missed.then(|| Finding::AccuracyMissed {
            number: number.describe(),
            error,
            end,
        })
    }
}

fn numbers(levels: &[Level]) -> Vec<&Numbers> {
    levels.iter().map(|level| &level.numbers).collect()
}
