//! The loads of a history in display units, each with the body that it acts on.

use stickslip_contact::interface::groups;

use super::plan::{Placed, Plan};
use crate::results::LoadValue;
use stickslip_scene::Scene;
use stickslip_scene::schema::{DisplayUnits, Load, LoadKind, Ramp};

/// Loads of a scene and their values, in the order of its load cases.
#[derive(Clone, Debug)]
pub struct LoadTable {
    units: DisplayUnits,
    /// How the first step grows.
    ramp: Ramp,
    loads: Vec<TableLoad>,
}

/// One of them.
#[derive(Clone, Debug)]
struct TableLoad {
    name: String,
    body: usize,
    kind: Kind,
    /// Its value in base units at the end of each step.
    steps: Vec<f64>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    Force,
    Stress,
    Factor,
    Temperature,
}

impl LoadTable {
    /// The loads of `scene`.
    pub fn of(scene: &Scene) -> Self {
        Self::of_plan(&Plan::of(scene), scene.display)
    }

    /// Those loads of `scene` that act on the bodies that contact links to its contact with the index `contact`.
    pub fn of_contact(scene: &Scene, contact: usize) -> Self {
        let plan = Plan::of(scene);
        let held = |body: usize| plan.is_rigid(body) && plan.free_axes(body) == [false; 2];
        let links: Vec<bool> = (0..plan.bodies.len()).map(|body| !held(body)).collect();
        let together: Vec<&[usize]> = (plan.fasteners.iter())
            .map(|fastener| fastener.slices.as_slice())
            .collect();
        let mut groups = groups(&links, &plan.pairs(), &together).into_iter();
        let linked = groups.find(|group| group.pairs.contains(&contact));
        let bodies = linked.map_or_else(Vec::new, |group| group.bodies);
        let mut table = Self::of_plan(&plan, scene.display);
        table.loads.retain(|load| bodies.contains(&load.body));
        table
    }

    pub(super) fn of_plan(plan: &Plan<'_>, units: DisplayUnits) -> Self {
        Self {
            units,
            ramp: plan.analysis.ramp(),
            loads: plan.loads.iter().map(TableLoad::of).collect(),
        }
    }

    /// Number of load steps; 1 without loads.
    pub fn steps(&self) -> usize {
        self.loads.first().map_or(1, |load| load.steps.len())
    }

    /// Names of the loads.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        self.loads.iter().map(|load| load.name.as_str())
    }

    /// Indices of the loads that act on one of `bodies`.
    pub fn acting_on(&self, bodies: &[usize]) -> Vec<usize> {
        let loads = self.loads.iter().enumerate();
        let own = loads.filter(|(_, load)| bodies.contains(&load.body));
        own.map(|(index, _)| index).collect()
    }

    /// The loads at the end of the step `step`.
    pub fn at_step(&self, step: usize) -> Vec<LoadValue> {
        let shown = |load: &TableLoad| load.shown(load.at(step), &self.units);
        self.loads.iter().map(shown).collect()
    }

    /// The loads where the history came to an end, at the part `reached` `[1]` of its step `step`.
    pub fn reached(&self, step: usize, reached: f64) -> Vec<LoadValue> {
        let part = if step == 0 && self.ramp != Ramp::Linear {
            reached * reached
        } else {
            reached
        };
        let shown = |load: &TableLoad| {
            let from = step.checked_sub(1).map_or(0.0, |before| load.at(before));
            load.shown(from + part * (load.at(step) - from), &self.units)
        };
        self.loads.iter().map(shown).collect()
    }

    /// Temperature rise `[K]` of a body under `multipliers`, of which the first are those of the loads.
    pub(crate) fn heating(&self, body: usize, multipliers: &[f64]) -> f64 {
        let loads = self.loads.iter().zip(multipliers);
        let heats = |load: &TableLoad| load.kind == Kind::Temperature && load.body == body;
        let own = loads.filter(|(load, _)| heats(load));
        own.map(|(_, degrees)| degrees).sum()
    }
}

impl TableLoad {
    fn of(load: &Placed<'_, Load>) -> Self {
        Self {
            name: load.of.name.clone(),
            body: load.body,
            kind: match load.of.kind {
                LoadKind::Force { .. } | LoadKind::Bearing { .. } => Kind::Force,
                LoadKind::Pressure { .. } => Kind::Stress,
                LoadKind::PolarTraction { .. } => Kind::Factor,
                LoadKind::Temperature { .. } => Kind::Temperature,
            },
            steps: load.of.kind.steps().to_vec(),
        }
    }

    fn at(&self, step: usize) -> f64 {
        self.steps.get(step).copied().unwrap_or(0.0)
    }

    /// A value in display units.
    fn shown(&self, value: f64, units: &DisplayUnits) -> LoadValue {
        let (value, unit) = match self.kind {
            Kind::Force => (units.force.from_base(value), units.force.name),
            Kind::Stress => (units.stress.from_base(value), units.stress.name),
            Kind::Factor => (value, "1"),
            Kind::Temperature => (value, "K"),
        };
        LoadValue {
            name: self.name.clone(),
            value,
            unit: unit.to_owned(),
        }
    }
}
