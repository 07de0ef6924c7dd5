//! The quantity by which tables and figures count the load steps.
//!
//! Steps are counted by the load that distinguishes them, among the loads on the bodies that contact links to what is shown; by the
//! contact force where several loads take turns; by the step's number where there is neither.

use std::collections::BTreeSet;

use crate::{LoadValue, ResultPart, Results};
use stickslip_scene::schema::DisplayUnits;
use stickslip_text::short;

/// One number per load step that says how much load there is.
#[derive(Clone, Debug, PartialEq)]
pub struct LoadScale {
    /// "pull", "contact force" or "step".
    pub name: String,
    /// Unit of the values: of the load, "1" for a factor, empty for the step's number.
    pub unit: String,
    /// One value per step, in `unit`.
    pub values: Vec<f64>,
}

impl LoadScale {
    /// The measure of the main edge of `results`, which are consistent; without edges that of all loads.
    pub fn of(results: &Results) -> Self {
        match results.main_edge() {
            Some(edge) => Self::of_edge(results, edge),
            None => Self::of_part(results, None),
        }
    }

    /// The measure for the edge with the index `edge`; of all loads where no part has it.
    pub fn of_edge(results: &Results, edge: usize) -> Self {
        let mut parts = results.parts.iter();
        Self::of_part(results, parts.find(|part| part.edges.contains(&edge)))
    }

    /// The measure for the elastic body with the index `body`.
    pub fn of_body(results: &Results, body: usize) -> Self {
        let mut parts = results.parts.iter();
        Self::of_part(results, parts.find(|part| part.bodies.contains(&body)))
    }

    /// The steps of the largest load on each part, ascending.
    pub fn peak_steps(results: &Results) -> Vec<usize> {
        let loaded = results.parts.iter().filter(|part| !part.loads.is_empty());
        let peaks = loaded.filter_map(|part| Self::of_part(results, Some(part)).peak_step());
        let peaks: BTreeSet<usize> = peaks.collect();
        if peaks.is_empty() {
            return Self::of(results).peak_step().into_iter().collect();
        }
        peaks.into_iter().collect()
    }

    /// Unit of the measure, among `units`, for what the loads `steps` of all steps act on, before anything is solved; `None` where steps
    /// have a number only.
    pub fn unit_of(steps: &[Vec<LoadValue>], units: DisplayUnits) -> Option<String> {
        let steps: Vec<&[LoadValue]> = steps.iter().map(Vec::as_slice).collect();
        let force = || {
            Some(Self {
                name: CONTACT_FORCE.into(),
                unit: units.force.name.into(),
                values: Vec::new(),
            })
        };
        Self::chosen(&histories(&steps, |_| true), force).map(|load| load.unit)
    }

    fn of_part(results: &Results, part: Option<&ResultPart>) -> Self {
        let steps: Vec<&[LoadValue]> = (results.steps.iter())
            .map(|step| step.loads.as_slice())
            .collect();
        let acts = |index: &usize| part.is_none_or(|part| part.loads.contains(index));
        let force = || contact_force(results, part);
        Self::chosen(&histories(&steps, acts), force).unwrap_or_else(|| Self {
            name: "step".into(),
            unit: String::new(),
            values: (1..=results.steps.len()).map(|step| step as f64).collect(),
        })
    }

    /// Which of the loads `histories` distinguishes the steps, or the contact force.
    fn chosen(histories: &[Self], contact_force: impl FnOnce() -> Option<Self>) -> Option<Self> {
        let changing: Vec<&Self> = histories.iter().filter(|load| load.changes()).collect();
        let rests_while_another_acts = |load: &Self| {
            let steps = 0..load.values.len();
            steps
                .filter(|&step| load.values[step] == 0.0)
                .any(|step| changing.iter().any(|other| other.values[step] != 0.0))
        };
        match changing.first() {
            Some(first) if rests_while_another_acts(first) => contact_force(),
            Some(first) => Some((*first).clone()),
            None => histories.first().cloned(),
        }
    }

    /// Whether the steps differ in it.
    pub fn changes(&self) -> bool {
        self.values.iter().any(|value| *value != self.values[0])
    }

    /// Whether it is a load or a force, not the step's number.
    pub fn is_load(&self) -> bool {
        !self.unit.is_empty()
    }

    /// Name and unit for an axis.
    pub fn label(&self) -> String {
        match self.unit.as_str() {
            "" => "Load step [–]".into(),
            "1" => format!("Load factor '{}' [–]", self.name),
            unit if self.name == CONTACT_FORCE => format!("Contact force [{unit}]"),
            unit => format!("Load '{}' [{unit}]", self.name),
        }
    }

    /// The load of a step with its unit: "1240 lbf".
    pub fn text(&self, step: usize) -> String {
        let value = short(self.values[step]);
        match self.unit.as_str() {
            "" => format!("step {value}"),
            "1" => format!("factor {value}"),
            unit => format!("{value} {unit}"),
        }
    }

    /// "1980 lbf, step 7 of 14".
    pub fn step_text(&self, step: usize) -> String {
        let place = format!("step {} of {}", step + 1, self.values.len());
        if self.is_load() {
            format!("{}, {place}", self.text(step))
        } else {
            place
        }
    }

    /// The load of a ply failure: a part `factor` `[1]` of the way to `step`, or beyond it that multiple of its load. Only loads and forces
    /// have one.
    pub fn at_failure(&self, step: usize, factor: f64, reached: bool) -> Option<LoadValue> {
        let end = self.values.get(step).filter(|_| self.is_load())?;
        let value = if reached {
            let before = step
                .checked_sub(1)
                .map_or(0.0, |before| self.values[before]);
            before + factor * (end - before)
        } else {
            factor * end
        };
        Some(LoadValue {
            name: self.name.clone(),
            value,
            unit: self.unit.clone(),
        })
    }

    /// Whether each step's value is smaller in magnitude than the one before.
    pub fn unloading(&self) -> Vec<bool> {
        let values = &self.values;
        (0..values.len())
            .map(|k| k > 0 && values[k].abs() < values[k - 1].abs())
            .collect()
    }

    /// The step with the largest magnitude, of equal ones the first; `None` without steps.
    pub fn peak_step(&self) -> Option<usize> {
        let magnitude = |step: usize| self.values[step].abs();
        (0..self.values.len())
            .rev()
            .max_by(|&a, &b| magnitude(a).total_cmp(&magnitude(b)))
    }
}

const CONTACT_FORCE: &str = "contact force";

/// Of the loads `steps` of all steps, those whose index `acts` takes.
fn histories(steps: &[&[LoadValue]], acts: impl Fn(&usize) -> bool) -> Vec<LoadScale> {
    let loads = steps.first().copied().unwrap_or_default();
    let history = |(index, load): (usize, &LoadValue)| LoadScale {
        name: load.name.clone(),
        unit: load.unit.clone(),
        values: steps.iter().map(|loads| loads[index].value).collect(),
    };
    let own = loads.iter().enumerate().filter(|(index, _)| acts(index));
    own.map(history).collect()
}

/// Magnitude of the resultant of the first contact of `part`; without one, of all.
fn contact_force(results: &Results, part: Option<&ResultPart>) -> Option<LoadScale> {
    let own = |index: usize| part.is_none_or(|part| part.edges.contains(&index));
    let edge = (0..results.edges.len()).find(|&edge| own(edge) && results.edges[edge].contact)?;
    let force = results.units.force;
    let magnitude = |step: usize| {
        let [x, y] = results.steps[step].edges[edge].resultant;
        force.from_base(x.hypot(y))
    };
    Some(LoadScale {
        name: CONTACT_FORCE.into(),
        unit: force.name.into(),
        values: (0..results.steps.len()).map(magnitude).collect(),
    })
}

#[cfg(test)]
mod tests {
    use super::LoadScale;

    fn scale(unit: &str, values: &[f64]) -> LoadScale {
        LoadScale {
            name: "pull".into(),
            unit: unit.into(),
            values: values.to_vec(),
        }
    }

    #[test]
    fn a_load_is_named_with_its_unit() {
        let load = scale("lbf", &[20.0, 1980.0, -1980.0, 40.0]);
        assert_eq!(load.label(), "Load 'pull' [lbf]");
        assert_eq!(load.step_text(1), "1980 lbf, step 2 of 4");
        assert_eq!(load.peak_step(), Some(1));
        assert_eq!(load.unloading(), [false, false, false, true]);
        assert_eq!(scale("1", &[0.5]).text(0), "factor 0.5");
        let steps = LoadScale {
            name: "step".into(),
            ..scale("", &[1.0, 2.0])
        };
        assert_eq!(steps.step_text(1), "step 2 of 2");
        assert_eq!(scale("N", &[]).peak_step(), None);
    }
}
