//! Pairs of edges in contact.

use super::{Builder, Fits};
use crate::diagnostic::SceneProblem;
use crate::scene::document::Part;
use crate::scene::format::{ContactFormat, SceneFormat};
use crate::scene::friction;
use crate::scene::schema::{Contact, SetRef, Shape};

impl Builder<'_> {
    pub(super) fn contacts(&mut self, format: &mut SceneFormat) -> Vec<Contact> {
        let mut contacts: Vec<Contact> = Vec::new();
        for (index, given) in format.contacts.iter_mut().enumerate() {
            // The second edge is that of the pin or of the block.
            let second = given
                .second
                .split('.')
                .next()
                .unwrap_or_default()
                .to_owned();
            let name = given.name.get_or_insert(second).clone();
            let key = format!("contacts.{index}");
            if contacts.iter().any(|other| other.name == name) {
                let message = format!("two contacts are called '{name}'");
                self.conflict(
                    &format!("{key}.name"),
                    message,
                    "give each contact a name of its own",
                );
            }
            contacts.extend(self.contact(&key, name, given));
        }
        contacts
    }

    fn contact(&mut self, key: &str, name: String, given: &mut ContactFormat) -> Option<Contact> {
        let first = self.set(&format!("{key}.first"), &given.first, Fits::Edges);
        let second = self.set(&format!("{key}.second"), &given.second, Fits::Edges);
        let law_key = format!("{key}.friction");
        let law = match &given.friction {
            None => {
                self.report(
                    key,
                    Part::Key,
                    SceneProblem::MissingFriction {
                        contact: name.clone(),
                    },
                );
                None
            }
            Some(table) => match friction::read(self.document, &law_key, table) {
                Ok(read) => {
                    given.friction = Some(read.shown);
                    Some(read.law)
                }
                Err(finding) => {
                    self.findings.push(*finding);
                    None
                }
            },
        };
        let (first, second) = (first?, second?);
        self.pair(key, given, &first, &second);
        let (gap, interference) = (given.gap, given.interference);
        Some(Contact {
            name,
            first,
            second,
            gap,
            interference,
            law: law?,
        })
    }

    fn pair(&mut self, key: &str, given: &ContactFormat, first: &SetRef, second: &SetRef) {
        let shapes = (self.shape_of(first), self.shape_of(second));
        match shapes {
            (Some(Shape::PlateWithHole { hole_radius, .. }), Some(Shape::Disk { radius }))
                if first.set == "hole" =>
            {
                if radius > hole_radius && !given.interference {
                    self.pin_too_large(first, second, radius - hole_radius);
                }
            }
            (
                Some(Shape::Cylinder {
                    half_length, depth, ..
                }),
                Some(Shape::Block {
                    half_length: other_length,
                    depth: other_depth,
                }),
            ) if first.set == "contact" && second.set == "contact" => {
                if (half_length, depth) != (other_length, other_depth) {
                    let message = format!(
                        "'{}' and '{}' are divided together, but their half_length or depth differ \
                         ({half_length} and {other_length} mm, {depth} and {other_depth} mm)",
                        first.body, second.body
                    );
                    self.conflict(
                        key,
                        message,
                        "give both bodies the same half_length and depth",
                    );
                }
            }
            _ => self.no_pair(key, first, second),
        }
    }

    fn shape_of(&self, set: &SetRef) -> Option<Shape> {
        self.bodies.get(&set.body).map(|body| body.shape)
    }

    fn no_pair(&mut self, key: &str, first: &SetRef, second: &SetRef) {
        let swapped = matches!(
            (self.shape_of(first), self.shape_of(second)),
            (Some(Shape::Disk { .. }), Some(Shape::PlateWithHole { .. }))
                | (Some(Shape::Block { .. }), Some(Shape::Cylinder { .. }))
        ) && ["hole", "contact"].contains(&second.set.as_str());
        let remedy = if swapped {
            format!("swap them: first = \"{second}\", second = \"{first}\"")
        } else {
            "first is the hole of a plate_with_hole and second the rim of a disk, or first the contact edge of a \
             cylinder and second that of a block"
                .to_owned()
        };
        let problem = SceneProblem::ContactPair {
            first: first.to_string(),
            second: second.to_string(),
            remedy,
        };
        self.report(key, Part::Key, problem);
    }

    fn pin_too_large(&mut self, hole: &SetRef, pin: &SetRef, overlap: f64) {
        let radius_key = format!("bodies.{}.shape.disk.radius", pin.body);
        let hole_key = format!("bodies.{}.shape.plate_with_hole.hole_radius", hole.body);
        let text = |key: &str| {
            let value = self.document.get(key).and_then(serde_json::Value::as_str);
            value.unwrap_or_default().to_owned()
        };
        let pin_text = text(&radius_key);
        // The overlap is told in the unit that the pin's radius is written in.
        let unit = crate::units::unit_of(&pin_text);
        let problem = SceneProblem::PinTooLarge {
            hole: text(&hole_key),
            overlap: unit.map_or_else(|| format!("{overlap} mm"), |unit| unit.show(overlap)),
            pin: pin_text,
        };
        self.report(&radius_key, Part::Value, problem);
    }
}
