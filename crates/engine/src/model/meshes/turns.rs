//! Nodes of circles turn with the body that the scene turns, and with them all that touch it along circles: a turned scene has the
//! turned mesh.

use stickslip_fem_core::generate::{Generate, GenerateError, MeshEstimate, unit_vector};
use stickslip_fem_core::mesh::{Mesh, Point};

use crate::model::plan::Plan;

/// The angle from which each body's nodes on circles count `[rad]`, by index: by which the scene turns the first body with a hole of those that touch along
/// circles; zero where one of them is a series or has a direction of its own.
pub(super) fn of(plan: &Plan<'_>) -> Vec<f64> {
    let count = plan.bodies.len();
    let round = || plan.contacts.iter().filter(|own| own.radii().is_some());
    let mut group: Vec<usize> = (0..count).collect();
    for contact in round() {
        let [one, other] = [0, 1].map(|side| group[contact.sides[side].body]);
        for own in &mut group {
            if *own == other {
                *own = one;
            }
        }
    }
    let has_hole = |body: usize| round().any(|contact| contact.sides[0].body == body);
    let is_fixed = |body: usize| {
        let own = &plan.bodies[body];
        own.series.is_some() || !(own.shape.is_placed() || own.shape.turns_freely())
    };
    let turn = |body: usize| {
        let members = || (0..count).filter(|&other| group[other] == group[body]);
        let alone = members().count() == 1;
        let is_turned =
            |&other: &usize| plan.bodies[other].shape.is_placed() && (alone || has_hole(other));
        let turned = members().find(is_turned);
        let turned = turned.filter(|_| !members().any(is_fixed));
        turned.map_or(0.0, |other| plan.bodies[other].shape.turn())
    };
    (0..count).map(turn).collect()
}

/// A mesh turned about its origin, which stands at `centre`.
pub(super) struct Turned {
    pub(super) generator: Box<dyn Generate<Output = Mesh>>,
    pub(super) turn: f64,
    pub(super) centre: Point,
}

impl Generate for Turned {
    type Output = Mesh;

    fn estimate(&self) -> Result<MeshEstimate, GenerateError> {
        self.generator.estimate()
    }

    fn generate_within(&self, limit: usize) -> Result<Mesh, GenerateError> {
        let [cos, sin] = unit_vector(self.turn);
        let place = |[x, y]: Point| {
            [
                self.centre[0] + cos * x - sin * y,
                self.centre[1] + sin * x + cos * y,
            ]
        };
        let mesh = self.generator.generate_within(limit);
        let turned = mesh.map_err(|why| why.placed(place))?.turned([cos, sin])?;
        Ok(turned.translated(self.centre)?)
    }
}
