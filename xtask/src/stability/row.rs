//! One line of the atlas.

use stickslip_contact::solver::Work;

use toml::Table;

use super::outcome::{Outcome, regularised};
use crate::study::record::fields;

/// What one method did at one value of what a study varies.
#[derive(Clone, Debug, Default)]
pub(crate) struct Row {
    /// The problem.
    pub(crate) case: String,
    /// What is varied, as it is written on the axis.
    pub(crate) value: f64,
    pub(crate) method: &'static str,
    pub(crate) outcome: Outcome,
    /// Steps solved or proved impossible, of how many.
    pub(crate) solved: usize,
    pub(crate) steps: usize,
    /// Largest error of the contact forces (or what the study says) over the largest of the answer.
    pub(crate) error: Option<f64>,
    /// Largest violation of the conditions; of a failure that of its best state.
    pub(crate) violation: Option<f64>,
    pub(crate) work: Work,
    /// Whether the bodies are supported, so that a solution exists whatever the friction.
    pub(crate) coercive: bool,
    pub(crate) note: String,
    /// What pictures and sentences need besides.
    pub(crate) more: Table,
}

impl Row {
    /// The row of an answer that is off by `error`, or of none.
    pub(crate) fn of_error(
        case: impl Into<String>,
        value: f64,
        method: &'static str,
        error: Option<f64>,
    ) -> Self {
        Self {
            case: case.into(),
            value,
            method,
            outcome: error.map_or(Outcome::Unresolved, |error| regularised(Some(error), error)),
            solved: usize::from(error.is_some()),
            steps: 1,
            error,
            ..Self::default()
        }
    }

    /// Solves, pivots, sweeps and updates together.
    pub(crate) fn iterations(&self) -> usize {
        self.work.solves + self.work.pivots + self.work.sweeps + self.work.updates
    }

    /// The row as a record; `varied` names the value. What depends on the machine is not in it.
    pub(crate) fn record(&self, varied: &str) -> Table {
        let count = |count: usize| (count as i64).into();
        let mut record = self.more.clone();
        record.extend(fields([
            ("case", self.case.as_str().into()),
            (varied, self.value.into()),
            ("method", self.method.into()),
            ("outcome", self.outcome.name().into()),
            ("steps_solved", count(self.solved)),
            ("steps", count(self.steps)),
            ("iterations", count(self.iterations())),
            ("factorisations", count(self.work.factorisations)),
            ("operations", (self.work.operations as i64).into()),
            ("note", self.note.as_str().into()),
        ]));
        let errors = [("error", self.error), ("violation", self.violation)];
        let given = errors
            .into_iter()
            .filter_map(|(key, value)| Some((key, value?)));
        record.extend(given.map(|(key, value)| (key.to_owned(), value.into())));
        record
    }

    /// The row of the same method with its steps taken together: the worst outcome counts.
    pub(crate) fn of_steps(case: &str, value: f64, coercive: bool, steps: &[Self]) -> Self {
        let mut whole = Self {
            case: case.to_owned(),
            value,
            coercive,
            steps: steps.len(),
            method: steps.first().map_or("", |row| row.method),
            ..Self::default()
        };
        for (index, step) in steps.iter().enumerate() {
            whole.solved +=
                usize::from(step.outcome.is_answer() || step.outcome == Outcome::Certified);
            whole.error = largest(whole.error, step.error);
            whole.violation = largest(whole.violation, step.violation);
            whole.work += step.work;
            if step.outcome > whole.outcome || (index == 0 && whole.note.is_empty()) {
                whole.outcome = whole.outcome.max(step.outcome);
                whole.note = match step.note.as_str() {
                    "" => String::new(),
                    note => format!("step {}: {note}", index + 1),
                };
            }
        }
        whole
    }
}

fn largest(a: Option<f64>, b: Option<f64>) -> Option<f64> {
    match (a, b) {
        (Some(a), Some(b)) => Some(if b > a || b.is_nan() { b } else { a }),
        (a, b) => a.or(b),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_worst_step_decides_and_is_named() {
        let step = |outcome, note: &str| Row {
            method: "a method",
            outcome,
            note: note.into(),
            error: Some(0.5),
            ..Row::default()
        };
        let steps = [
            step(Outcome::Solved, ""),
            step(Outcome::Cycled, "period 2"),
            step(Outcome::Certified, "no balance"),
        ];
        let whole = Row::of_steps("pin", 0.3, false, &steps);
        assert_eq!(
            (whole.outcome, whole.solved, whole.steps),
            (Outcome::Cycled, 2, 3)
        );
        assert_eq!(whole.note, "step 2: period 2");
    }
}
