//! The load history of a scene as an experiment names its states.

use super::plan::{Direction, Source, State};
use crate::scene::Scene;
use crate::scene::schema::{Load, LoadKind};

/// The first load that changes.
pub(super) struct History<'a> {
    steps: usize,
    load: Option<&'a Load>,
}

impl<'a> History<'a> {
    pub(super) fn of(scene: &'a Scene) -> Self {
        let changes = |load: &&Load| {
            let values = load.kind.steps();
            values.iter().any(|value| *value != values[0])
        };
        let load = scene.loads.iter().find(changes);
        Self {
            steps: scene.steps(),
            load: load.or(scene.loads.first()),
        }
    }

    pub(super) fn steps(&self) -> usize {
        self.steps
    }

    /// The force `[N]` at a step, if the load is one.
    pub(super) fn load(&self, step: usize) -> Option<f64> {
        match &self.load?.kind {
            LoadKind::Force { steps, .. } | LoadKind::Bearing { steps, .. } => {
                steps.get(step).copied()
            }
            _ => None,
        }
    }

    /// Whether the load falls towards a step.
    pub(super) fn direction(&self, step: usize) -> Direction {
        let values = self.load.map_or(&[][..], |load| load.kind.steps());
        let at = |step: usize| values.get(step).map(|value| value.abs());
        match (step.checked_sub(1).and_then(at), at(step)) {
            (Some(before), Some(now)) if now < before => Direction::Unloading,
            _ => Direction::Loading,
        }
    }

    /// The state at a step, named after it.
    pub(super) fn state(&self, step: usize) -> State {
        let width = self.steps.to_string().len();
        State {
            name: format!("step-{:0width$}", step + 1),
            direction: self.direction(step),
            load: self.load(step),
            source: Source::Step(step),
            null: None,
            back: None,
        }
    }
}
