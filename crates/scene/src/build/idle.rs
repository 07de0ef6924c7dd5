//! Loads that act only where something holds against them.

use super::{Builder, Surroundings};
use crate::schema::{LoadKind, SetRef, Substance};

impl Builder<'_> {
    /// Refuses loads that supports and platens of the same edge, or of a rigid body, take whole.
    pub(super) fn loads_act(&mut self, around: &Surroundings<'_>) {
        for (number, load) in around.numbers.iter().zip(around.loads) {
            let (on, all) = match &load.kind {
                LoadKind::Force { on, direction, .. } => (on, vec![*direction]),
                LoadKind::Bearing { on, .. }
                | LoadKind::Pressure { on, .. }
                | LoadKind::PolarTraction { on, .. } => (on, vec![[1.0, 0.0], [0.0, 1.0]]),
                LoadKind::Temperature { .. } => continue,
            };
            let held = self.held(on, around);
            if all.iter().all(|direction| spans(&held, *direction)) {
                let message = format!(
                    "'{}' is held against load '{}', which therefore changes nothing",
                    on, load.name
                );
                let remedy = "load another edge, free this one in the direction of the load, or delete the load";
                self.conflict(&format!("loads.{number}.on"), message, remedy);
            }
        }
    }

    /// Directions in which the edge `on` cannot move, or all of a rigid body.
    fn held(&self, on: &SetRef, around: &Surroundings<'_>) -> Vec<[f64; 2]> {
        let body = self.bodies.get(&on.body);
        let rigid = body.is_some_and(|body| matches!(body.substance, Substance::Rigid));
        let here = |other: &SetRef| other == on || (rigid && other.body == on.body);
        let supports = around.supports.iter().filter(|own| here(&own.on));
        let platens = around.platens.iter().filter(|own| here(&own.on));
        supports
            .flat_map(|support| support.hold.directions())
            .chain(platens.flat_map(|platen| platen.free.others().directions()))
            .collect()
    }
}

/// Whether `direction` is a combination of the unit vectors `held`.
pub(super) fn spans(held: &[[f64; 2]], direction: [f64; 2]) -> bool {
    let parallel =
        |one: [f64; 2], other: [f64; 2]| (one[0] * other[1] - one[1] * other[0]).abs() < 1e-9;
    held.iter()
        .any(|one| parallel(*one, direction) || !parallel(*one, held[0]))
}
