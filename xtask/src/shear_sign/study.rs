//! All that was solved.

use super::case::{ALUMINIUM, CLEARANCE, Case, Phase, Plate, Row, Step, solve, solve_alike};
use super::curve::Pattern;
use super::depth::{self, Arc, Joint};
use super::plan::{COULOMB, FITS, Plan, USUAL, usual_coverage};
use super::plies::{self, Curve, Question};
use crate::publish::{Trouble, side_by_side};

/// Angles of the report within which a change of sign counts as the one that it saw at about 30° `[degree]`.
pub(crate) const SEEN: [f64; 2] = [20.0, 40.0];

/// Most cases that share their bodies: few enough for all cores to have work to the end.
const TOGETHER: usize = 12;

/// A case solved again with a finer mesh or more load steps.
pub(crate) struct Refined {
    pub(crate) what: &'static str,
    pub(crate) coarse: Row,
    pub(crate) fine: Row,
}

pub(crate) struct Study {
    pub(crate) plan: Plan,
    pub(crate) rows: Vec<Row>,
    pub(crate) refined: Vec<Refined>,
    pub(crate) arcs: Vec<Arc>,
    pub(crate) curves: Vec<Curve>,
}

/// The report's angle of |θ|, and back `[degree]`.
pub(crate) fn of_report(angle: f64) -> f64 {
    90.0 - angle
}

impl Study {
    /// Solves everything in `plan`.
    pub(crate) fn of(plan: Plan) -> Result<Self, Trouble> {
        let alike = plan.cases.chunk_by(Case::has_the_bodies_of);
        let groups: Vec<&[Case]> = alike.flat_map(|alike| alike.chunks(TOGETHER)).collect();
        let rows = side_by_side(&groups, |group| solve_alike(group, plan.spacing))?.concat();
        let joints = [0.0005, 0.0015].map(|clearance| {
            [0.05, 0.2].map(|friction| Joint {
                friction,
                clearance,
            })
        });
        let arcs = side_by_side(joints.as_flattened(), |&joint| {
            depth::look(joint, plan.spacing)
        })?;
        let curves = side_by_side(&questions(), |question| plies::ask(question, plan.spacing))?;
        let mut study = Self {
            plan,
            rows,
            refined: Vec::new(),
            arcs: arcs.concat(),
            curves: curves.concat(),
        };
        study.refined = study.again()?;
        Ok(study)
    }

    /// The usual joint on half the spacing, and it and the joint with the furthest reach with twice the load steps.
    fn again(&self) -> Result<Vec<Refined>, Trouble> {
        let mut refined = Vec::new();
        if let Some(row) = self.usual() {
            refined.push(Refined {
                what: "half the spacing",
                coarse: row.clone(),
                fine: solve(&row.case, 0.5 * self.plan.spacing)?,
            });
        }
        let furthest = self.furthest(|row| row.case.family == FITS);
        for row in self.usual().into_iter().chain(furthest.map(|(row, _)| row)) {
            let loads = doubled(&row.case.loads);
            refined.push(Refined {
                what: "twice the load steps",
                coarse: row.clone(),
                fine: solve(
                    &Case {
                        loads,
                        ..row.case.clone()
                    },
                    self.plan.spacing,
                )?,
            });
        }
        Ok(refined)
    }

    fn usual(&self) -> Option<&Row> {
        let mut rows = self.rows.iter();
        rows.find(|row| row.case.family == COULOMB && row.case.law == USUAL)
    }

    /// The row and load step of loading with the furthest reach among the rows that `wanted` takes.
    pub(crate) fn furthest(&self, wanted: impl Fn(&Row) -> bool) -> Option<(&Row, &Step)> {
        let rows = self.rows.iter().filter(|row| wanted(row));
        let furthest = rows.filter_map(|row| Some((row, row.furthest()?)));
        let reach = |step: &Step| step.reading.reach().unwrap_or(0.0);
        furthest.max_by(|a, b| reach(a.1).total_cmp(&reach(b.1)))
    }
}

fn questions() -> Vec<Question> {
    let mut questions = Vec::new();
    for cure in [0.0, -150.0] {
        questions.push(Question::new("Coulomb", USUAL.to_owned(), cure));
        questions.push(Question::new("fibre coverage", usual_coverage(), cure));
        for clearance in [0.001, 0.0015, 0.002] {
            questions.push(Question {
                clearance,
                ..Question::new("Coulomb", USUAL.to_owned(), cure)
            });
        }
    }
    questions
}

/// The history with a step more in the middle of each.
fn doubled(loads: &[f64]) -> Vec<f64> {
    let before = std::iter::once(0.0).chain(loads.iter().copied());
    before
        .zip(loads)
        .flat_map(|(last, &load)| [0.5 * (last + load), load])
        .collect()
}

impl Row {
    /// Whether plate, pin and clearance are the report's.
    pub(crate) fn is_of_the_report(&self) -> bool {
        let plate = !matches!(self.case.plate, Plate::Layup(_));
        plate && self.case.pin == ALUMINIUM && self.case.clearance == CLEARANCE
    }

    /// Load steps of loading.
    pub(crate) fn loading(&self) -> impl Iterator<Item = &Step> {
        self.steps
            .iter()
            .filter(|step| step.phase == Phase::Loading)
    }

    /// The step of loading in which the shear is reversed furthest from the bearing point, with shear that is not beyond.
    pub(crate) fn furthest(&self) -> Option<&Step> {
        let reached = self
            .loading()
            .filter_map(|step| Some((step.reading.reach()?, step)));
        reached
            .max_by(|a, b| a.0.total_cmp(&b.0))
            .map(|(_, step)| step)
    }

    /// The step of loading in which the reversed shear is the largest part of the peak.
    pub(crate) fn most_reversed(&self) -> Option<&Step> {
        let part = |step: &Step| {
            step.reading
                .reversal
                .map_or(0.0, |reversal| reversal.of_peak)
        };
        let reversed = self
            .loading()
            .filter(|step| step.reading.reversal.is_some());
        reversed.max_by(|a, b| part(a).total_cmp(&part(b)))
    }

    /// The step of a phase at a load.
    pub(crate) fn at(&self, phase: Phase, load: f64) -> Option<&Step> {
        self.steps
            .iter()
            .find(|step| step.phase == phase && step.load == load)
    }
}

impl Step {
    /// Whether the shear is forward below about 30° of the report and reversed above.
    pub(crate) fn is_as_seen(&self) -> bool {
        self.reading
            .reach()
            .is_some_and(|reach| (SEEN[0]..=SEEN[1]).contains(&of_report(reach)))
    }

    /// Whether the shear is reversed anywhere.
    pub(crate) fn is_reversed(&self) -> bool {
        !matches!(self.reading.pattern, Pattern::None | Pattern::Forward)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_doubled_history_passes_the_same_loads() {
        assert_eq!(
            doubled(&[20.0, 100.0, 40.0]),
            [10.0, 20.0, 60.0, 100.0, 70.0, 40.0]
        );
    }
}
