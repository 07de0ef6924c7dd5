//! The load history of a scene as an experiment names its states.

use serde::Serialize;
use thiserror::Error;

use super::{Direction, Source, State};
use stickslip_scene::Scene;
use stickslip_scene::schema::{Load, LoadKind};
use stickslip_scene::units::Unit;

/// The load steps of a scene that a state is compared with.
#[derive(Debug, PartialEq)]
pub struct Tied {
    /// That of the state.
    pub step: usize,
    /// That of its null field, if it has one.
    pub null: Option<usize>,
    /// Whether that of the null field is assumed: the field was measured, and its load is not known.
    pub assumed: bool,
}

/// Why a state is no load step of the scene.
#[derive(Clone, Debug, Error, PartialEq, Serialize)]
#[serde(tag = "reason", rename_all = "snake_case")]
pub enum Untied {
    /// It has no load.
    #[error("its load is not given")]
    NoLoad,
    /// No load step has its load and its direction.
    #[error("no load step of the scene has {} in {}", .unit.show(*.load), .direction.name())]
    NoSuchStep {
        /// Its load `[N]`.
        load: f64,
        /// Whether the load was growing or falling.
        direction: Direction,
        /// What the load is shown in.
        #[serde(skip)]
        unit: &'static Unit,
    },
    /// Its null field was measured, and no load step comes before its own.
    #[error("its null field was measured, and the scene has no load step before step {step}")]
    NoStepBefore {
        /// Its load step, counted from 1.
        step: usize,
    },
}

/// The first load that changes.
#[derive(Clone, Copy, Debug)]
pub struct History<'a> {
    steps: usize,
    load: Option<&'a Load>,
    /// What forces are shown in.
    force: &'static Unit,
}

impl<'a> History<'a> {
    /// That of `scene`.
    pub fn of(scene: &'a Scene) -> Self {
        let changes = |load: &&Load| {
            let values = load.kind.steps();
            values.iter().any(|value| *value != values[0])
        };
        let load = scene.loads.iter().find(changes);
        Self {
            steps: scene.steps(),
            load: load.or(scene.loads.first()),
            force: scene.display.force,
        }
    }

    /// Number of load steps.
    pub fn steps(&self) -> usize {
        self.steps
    }

    /// The force `[N]` at a step, if the load is one.
    pub fn load(&self, step: usize) -> Option<f64> {
        match &self.load?.kind {
            LoadKind::Force { steps, .. } | LoadKind::Bearing { steps, .. } => {
                steps.get(step).copied()
            }
            _ => None,
        }
    }

    /// A force `[N]` as text in the unit of results.
    pub fn shown(&self, force: f64) -> String {
        self.force.show(force)
    }

    /// Whether the load falls towards a step.
    pub fn direction(&self, step: usize) -> Direction {
        let values = self.load.map_or(&[][..], |load| load.kind.steps());
        let at = |step: usize| values.get(step).map(|value| value.abs());
        match (step.checked_sub(1).and_then(at), at(step)) {
            (Some(before), Some(now)) if now < before => Direction::Unloading,
            _ => Direction::Loading,
        }
    }

    /// The load steps of a state.
    ///
    /// # Errors
    /// [`Untied`]: why the state is no load step.
    pub fn tied(&self, state: &State) -> Result<Tied, Untied> {
        let step = match &state.source {
            Source::Step(step) => *step,
            _ => self.step_of(state)?,
        };
        let (null, assumed) = match &state.null {
            None => (None, false),
            Some(Source::Step(null)) => (Some(*null), false),
            Some(_) => (Some(self.smallest_before(step)?), true),
        };
        Ok(Tied {
            step,
            null,
            assumed,
        })
    }

    /// The first of the steps with the smallest load that come before `step`.
    fn smallest_before(&self, step: usize) -> Result<usize, Untied> {
        let values = self.load.map_or(&[][..], |load| load.kind.steps());
        let before = values.iter().take(step).enumerate();
        before
            .min_by(|(_, a), (_, b)| a.abs().total_cmp(&b.abs()))
            .map(|(null, _)| null)
            .ok_or(Untied::NoStepBefore { step: step + 1 })
    }

    /// The load step with the load and the direction of a state.
    fn step_of(&self, state: &State) -> Result<usize, Untied> {
        /// Loads that differ by less, in parts, are the same.
        const SAME: f64 = 1e-3;
        let load = state.load.ok_or(Untied::NoLoad)?;
        let same = |step: &usize| {
            let close = |own: f64| (own - load).abs() <= SAME * load.abs();
            self.load(*step).is_some_and(close) && self.direction(*step) == state.direction
        };
        (0..self.steps).find(same).ok_or(Untied::NoSuchStep {
            load,
            direction: state.direction,
            unit: self.force,
        })
    }

    /// The state at a step, named after it.
    pub fn state(&self, step: usize) -> State {
        let width = self.steps.to_string().len();
        State {
            name: format!("step-{:0width$}", step + 1),
            direction: self.direction(step),
            load: self.load(step),
            edge_force: [None; 2],
            source: Source::Step(step),
            null: None,
            back: None,
        }
    }
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;
    use crate::Experiment;
    use stickslip_scene::Format;
    use stickslip_scene::host::{Host, MemoryFiles};

    #[test]
    fn forces_are_reported_in_the_units_of_the_experiment() {
        let text = r#"
            version = 1
            units = { length = "in", force = "lbf", stress = "psi" }
            [specimen]
            scene = "pin-loaded-aluminium.toml"
            body = "plate"
            [[states]]
            name = "up"
            load = "1250 lbf"
            table = { file = "up.csv", scale = "1 mm", y_axis = "up" }
        "#;
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes");
        let scene = folder.join("pin-loaded-aluminium.toml");
        let text_of_scene = std::fs::read_to_string(&scene).unwrap();
        let host = Host::of(MemoryFiles::from_iter([(scene, text_of_scene)]));
        for units in ["\"lbf\"", "\"kN\""] {
            let text = text.replace("\"lbf\"", units);
            let none: [&str; 0] = [];
            let own =
                Experiment::from_text(&text, Format::Toml, "e.toml", &folder, &none, host).unwrap();
            let history = History::of(&own.specimen.model.as_ref().unwrap().scene);
            let state = State {
                load: Some(1e5),
                ..own.states[0].clone()
            };
            let words = history.tied(&state).unwrap_err().to_string();
            let expected = own.display.force.show(1e5);
            assert!(
                words.contains(&format!("has {expected} in loading")),
                "{words}"
            );
        }
    }
}
