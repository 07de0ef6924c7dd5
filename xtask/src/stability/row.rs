//! One line of the atlas, and the tables made of them.

use std::fmt::Write as _;

use stickslip_contact::solver::Work;
use stickslip_fem_core::mesh::ElementKind;

use super::outcome::Outcome;

/// What one method did at one value of what a study varies.
#[derive(Clone, Debug)]
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
}

impl Default for Row {
    fn default() -> Self {
        Self {
            case: String::new(),
            value: 0.0,
            method: "",
            outcome: Outcome::Solved,
            solved: 0,
            steps: 1,
            error: None,
            violation: None,
            work: Work::default(),
            coercive: false,
            note: String::new(),
        }
    }
}

impl Row {
    /// Solves, pivots, sweeps and updates together.
    pub(crate) fn iterations(&self) -> usize {
        self.work.solves + self.work.pivots + self.work.sweeps + self.work.updates
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

/// Name of an element, which stands for the method where meshes are studied.
pub(crate) fn element_name(kind: ElementKind) -> &'static str {
    match kind {
        ElementKind::T3 => "T3",
        ElementKind::T6 => "T6",
        ElementKind::Q4 => "Q4",
        ElementKind::Q8 => "Q8",
        ElementKind::Q9 => "Q9",
    }
}

fn largest(a: Option<f64>, b: Option<f64>) -> Option<f64> {
    match (a, b) {
        (Some(a), Some(b)) => Some(if b > a || b.is_nan() { b } else { a }),
        (a, b) => a.or(b),
    }
}

/// The rows as comma-separated values; `varied` names the column of values. What depends on the machine is not in it.
pub(crate) fn csv(varied: &str, rows: &[Row]) -> String {
    let mut text = format!(
        "case,{varied},method,outcome,steps_solved,steps,error,violation,iterations,factorisations,operations,note\n"
    );
    for row in rows {
        // Writing into a string does not fail.
        let _ = writeln!(
            text,
            "{},{},{},{},{},{},{},{},{},{},{},{}",
            quoted(&row.case),
            row.value,
            quoted(row.method),
            row.outcome.name(),
            row.solved,
            row.steps,
            exponent(row.error),
            exponent(row.violation),
            row.iterations(),
            row.work.factorisations,
            row.work.operations,
            quoted(&row.note),
        );
    }
    text
}

fn exponent(value: Option<f64>) -> String {
    value.map_or_else(String::new, |value| format!("{value:.2e}"))
}

fn quoted(text: &str) -> String {
    if text.contains([',', '"', '\n']) {
        format!("\"{}\"", text.replace('"', "\"\""))
    } else {
        text.to_owned()
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

    #[test]
    fn texts_with_commas_are_quoted() {
        let row = Row {
            case: "a, b".into(),
            method: "m",
            ..Row::default()
        };
        let text = csv("mu", &[row]);
        assert!(
            text.ends_with("\"a, b\",0,m,solved,0,1,,,0,0,0,\n"),
            "{text}"
        );
    }
}
