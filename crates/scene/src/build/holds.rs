//! Supports and platens, and whether they hold everything.

use std::collections::BTreeMap;

use serde_json::Value;

use super::idle::spans;
use super::{Builder, Fits};
use crate::diagnostic::SceneProblem;
use crate::document::Part;
use crate::format::SceneFormat;
use crate::schema::{
    Axes, Contact, Fastener, Hold, Platen, SetRef, SpringSize, SpringSupport, Substance, Support,
    SupportFormat,
};
use crate::units::Quantity;

impl Builder<'_> {
    pub(super) fn supports(&mut self, format: &SceneFormat) -> (Vec<Support>, Vec<SpringSupport>) {
        let (mut supports, mut springs) = (Vec::new(), Vec::new());
        for (index, given) in format.supports.iter().enumerate() {
            let key = format!("supports.{index}");
            let on = self.set(&format!("{key}.on"), &given.on, Fits::EdgesAndPoints);
            let twice = given
                .fix
                .as_deref()
                .filter(|fix| matches!(fix, [one, other] if one == other));
            if twice.is_some() {
                let message = "one direction is named twice";
                self.conflict(
                    &format!("{key}.fix"),
                    message,
                    "write [\"x\"], [\"y\"] or [\"x\", \"y\"]",
                );
            }
            let hold = given.hold();
            if given.stiffness.is_some() || given.bed.is_some() {
                let size = self.spring_size(&key, given, on.as_ref());
                if let (Some(on), Some(hold), Some(stiffness)) = (on, hold, size) {
                    springs.push(SpringSupport {
                        index,
                        on,
                        hold,
                        stiffness,
                    });
                }
                continue;
            }
            let displacement = given.displacement.as_ref().map_or(0.0, Quantity::value);
            if displacement != 0.0 && matches!(hold, Some(Hold::Axes(Axes { x: true, y: true }))) {
                let message = "one displacement is given, but two directions are fixed";
                let remedy = "write one support for x and one for y, each with its displacement";
                self.conflict(&format!("{key}.displacement"), message, remedy);
            }
            let body = on.as_ref().and_then(|on| self.bodies.get(&on.body));
            let is_area = body.zip(on.as_ref());
            let is_area = is_area.is_some_and(|(body, on)| body.shape.is_area(&on.set));
            if is_area && matches!(hold, Some(Hold::Direction(_))) {
                let message = "the mean displacement of an area is held along x and y, not along a direction between them";
                let remedy = "write fix = [\"x\", \"y\"], or hold an edge or a point";
                self.conflict(&format!("{key}.normal"), message, remedy);
            }
            if let (Some(on), Some(hold), true) = (&on, hold, is_area) {
                self.contradicts(&key, &supports, on, hold, displacement);
            }
            if let (Some(on), Some(hold)) = (on, hold) {
                supports.push(given.support(index, on, hold));
            }
        }
        self.springs_act(&supports, &springs);
        (supports, springs)
    }

    /// How stiff the springs of a support are; refuses what they do not have.
    fn spring_size(
        &mut self,
        key: &str,
        given: &SupportFormat,
        on: Option<&SetRef>,
    ) -> Option<SpringSize> {
        if given.displacement.is_some() {
            let message =
                "springs lead to the ground, which is at rest, and a displacement is given";
            let remedy = "remove the displacement, or the stiffness";
            self.conflict(&format!("{key}.displacement"), message, remedy);
        }
        let size = match (&given.stiffness, &given.bed) {
            (Some(stiffness), None) => SpringSize::Whole(stiffness.value()),
            (None, Some(bed)) => SpringSize::Bed(bed.value()),
            _ => {
                let message = "the stiffness of the whole and that per area are both given";
                self.conflict(key, message, "keep stiffness or bed");
                return None;
            }
        };
        let on = on?;
        let body = self.bodies.get(&on.body)?;
        if body.substance == Substance::Rigid {
            let message = format!("{on} belongs to a rigid body, and springs carry elastic ones");
            self.conflict(&format!("{key}.on"), message, "give the body a material");
            return None;
        }
        let is_edge = body.shape.edge(&on.set).is_some();
        if body.shape.is_area(&on.set) {
            let message = format!("{on} is an area, and springs are on an edge or a point");
            self.conflict(&format!("{key}.on"), message, "name an edge or a point");
            return None;
        }
        if !is_edge && self.has_several_nodes(key, on) {
            return None;
        }
        if !is_edge && matches!(size, SpringSize::Bed(_)) {
            let message = format!("{on} is a point, which has no area for a bed");
            self.conflict(
                &format!("{key}.bed"),
                message,
                "give stiffness = \"500 N/mm\"",
            );
            return None;
        }
        Some(size)
    }

    /// Refuses a force or a spring on a point that is a set of several nodes, over which neither is shared.
    pub(super) fn has_several_nodes(&mut self, key: &str, on: &SetRef) -> bool {
        let shape = self.bodies.get(&on.body).map(|body| &body.shape);
        let is_point =
            shape.is_some_and(|shape| shape.edge(&on.set).is_none() && !shape.is_area(&on.set));
        let count = shape.map_or(1, |shape| shape.nodes_of_point(&on.set));
        let several = is_point && count > 1;
        if several {
            let message = format!(
                "{on} is a set of {count} nodes, and forces and springs are on an edge, an area or one node"
            );
            self.conflict(&format!("{key}.on"), message, "name one node, or an edge");
        }
        several
    }

    /// Refuses springs where a support holds the same set along the same axis, which then carries all.
    fn springs_act(&mut self, supports: &[Support], springs: &[SpringSupport]) {
        for own in springs {
            let at_rest = |other: &&Support| other.on == own.on && other.displacement == 0.0;
            let held = supports.iter().filter(at_rest);
            let held: Vec<[f64; 2]> = held.flat_map(|other| other.hold.directions()).collect();
            if own
                .hold
                .directions()
                .iter()
                .any(|direction| spans(&held, *direction))
            {
                let message = format!(
                    "{} is held along the springs, which therefore carry nothing",
                    own.on
                );
                let remedy = "remove the support or the springs, or give them different axes";
                self.conflict(&format!("supports.{}.on", own.index), message, remedy);
            }
        }
    }

    /// Refuses a second displacement of an area along an axis.
    fn contradicts(
        &mut self,
        key: &str,
        others: &[Support],
        on: &SetRef,
        hold: Hold,
        displacement: f64,
    ) {
        let along = |hold: Hold| match hold {
            Hold::Axes(axes) => [axes.x, axes.y],
            Hold::Direction(_) => [false; 2],
        };
        let shares =
            |other: &&Support| (0..2).any(|axis| along(hold)[axis] && along(other.hold)[axis]);
        let mut others = others.iter().filter(|other| other.on == *on);
        let differs = |other: &Support| other.displacement != displacement;
        if others.by_ref().filter(shares).any(differs) {
            let message =
                format!("another support moves {on} along the same axis by another displacement");
            self.conflict(key, message, "keep one of the two");
        }
    }

    pub(super) fn platens(&mut self, format: &SceneFormat, contacts: &[Contact]) -> Vec<Platen> {
        let mut platens: Vec<Platen> = Vec::new();
        for (index, given) in format.platens.iter().enumerate() {
            let key = format!("platens.{index}.on");
            let Some(on) = self.set(&key, &given.on, Fits::Edges) else {
                continue;
            };
            if let Some(other) = platens.iter().find(|other| other.on.body == on.body) {
                let message = format!(
                    "'{}' has a platen on {} already, and a body has room for one",
                    on.body, other.on
                );
                let remedy = format!(
                    "remove one of them, or hold {on} by a support: [[supports]] on = \"{on}\", fix = [\"x\", \"y\"]"
                );
                self.conflict(&key, message, remedy);
            }
            let touches = |contact: &&Contact| contact.first == on || contact.second == on;
            if let Some(contact) = contacts.iter().find(touches) {
                let message = format!(
                    "{on} is an edge of a contact, '{}', and cannot be glued to a platen too",
                    contact.name
                );
                self.conflict(&key, message, "glue another edge of the body to the platen");
            }
            platens.push(given.platen(on));
        }
        platens
    }

    /// Bodies that touch or are slices of one fastener, directly or through others, form a group; each group needs something that holds it, on
    /// one of the sets `held`.
    pub(super) fn everything_is_held(
        &mut self,
        contacts: &[Contact],
        fasteners: &[Fastener],
        held: &[&SetRef],
    ) {
        // A fastener, contact or support that could not be read has been reported; what it holds is not known.
        let joined = self.document.get("fasteners").and_then(Value::as_object);
        if joined.map_or(0, serde_json::Map::len) != fasteners.len()
            || self.written("supports") + self.written("platens") != held.len()
        {
            return;
        }
        let slices = fasteners
            .iter()
            .flat_map(|fastener| fastener.slices.windows(2));
        let slices = slices.map(|pair| [pair[0].as_str(), pair[1].as_str()]);
        let Some(Some(pairs)) = self.document.get("contacts").map(|list| list.as_array()) else {
            return self.groups_are_held(slices, held);
        };
        if pairs.len() == contacts.len() {
            let touching = contacts.iter();
            let touching = touching.map(|own| [own.first.body.as_str(), own.second.body.as_str()]);
            self.groups_are_held(touching.chain(slices), held);
        }
    }

    fn groups_are_held<'b>(
        &mut self,
        pairs: impl IntoIterator<Item = [&'b str; 2]>,
        held: &[&SetRef],
    ) {
        let mut group: BTreeMap<String, usize> = self.bodies.keys().cloned().zip(0..).collect();
        // Every set has been looked up among the bodies, so its body has a group.
        for [one, other] in pairs {
            let (own, other) = (group[one], group[other]);
            group
                .values_mut()
                .filter(|id| **id == other)
                .for_each(|id| *id = own);
        }
        let held: Vec<usize> = held.iter().map(|on| group[&on.body]).collect();
        let mut loose: BTreeMap<usize, Vec<String>> = BTreeMap::new();
        for (body, id) in group.into_iter().filter(|(_, id)| !held.contains(id)) {
            loose.entry(id).or_default().push(body);
        }
        for bodies in loose.into_values() {
            let first = &bodies[0];
            let body = self.bodies.get(first);
            let set = body.and_then(|body| body.shape.edges().pop());
            let quoted: Vec<_> = bodies.iter().map(|body| format!("'{body}'")).collect();
            let problem = SceneProblem::UnsupportedBody {
                bodies: quoted.join(" and "),
                example: format!("{first}.{}", set.map_or("edge".into(), |edge| edge.name)),
            };
            self.report(&format!("bodies.{first}"), Part::Key, problem);
        }
    }
}
