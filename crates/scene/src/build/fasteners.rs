//! Fasteners, and whether their slices make one.

use std::collections::BTreeMap;

use super::{BesideSlices, Builder, Materials};
use crate::document::child;
use crate::format::SceneFormat;
use crate::schema::fastener::{EndFormat, FastenerFormat, SpringsFormat};
use crate::schema::{Contact, Fastener, KinematicsChoice, Material, SetRef, Springs, Substance};
use crate::shape::{Curve, Role};
use crate::units::Quantity;

/// Part of a thickness or a radius by which equal ones may differ.
const EQUAL: f64 = 1e-9;

/// A slice in its plate.
pub(super) struct Slice<'a> {
    pub(super) body: &'a str,
    pub(super) radius: f64,
    pub(super) plate: &'a str,
    centre: [f64; 2],
}

impl Builder<'_> {
    pub(super) fn fasteners(
        &mut self,
        format: &SceneFormat,
        beside: &BesideSlices<'_>,
    ) -> Vec<Fastener> {
        let mut fasteners: Vec<Fastener> = Vec::new();
        let mut layers: Vec<(String, Vec<String>)> = Vec::new();
        if !format.fasteners.is_empty() {
            self.fits_fasteners(format);
        }
        for (name, given) in &format.fasteners {
            self.name("fasteners", name);
            let table = child("fasteners", name);
            let FastenerFormat { slices, springs } = given;
            self.slices_are_single(&table, slices, &fasteners);
            let found: Option<Vec<Slice<'_>>> = (slices.iter().enumerate())
                .map(|(index, body)| self.slice(&format!("{table}.slices.{index}"), body, beside))
                .collect();
            let Some(found) = found.filter(|found| !found.is_empty()) else {
                continue;
            };
            self.is_straight(&table, &found);
            let key = child(&table, "springs");
            let springs = match springs {
                SpringsFormat::Lumped(lumped) => {
                    self.has_one_shank(&child(&key, "lumped"), &found, beside.materials);
                    self.lumped(&table, lumped, &found, beside.materials)
                }
                others => self.springs(&table, others, slices.len()),
            };
            if matches!(springs, Springs::Beam { .. }) {
                self.has_one_shank(&child(&key, "beam"), &found, beside.materials);
            }
            let plates: Vec<String> = found.iter().map(|slice| slice.plate.to_owned()).collect();
            self.layers_agree(&table, name, &plates, &layers);
            self.layers_do_not_touch(format, &plates, beside.contacts);
            layers.push((name.clone(), plates));
            fasteners.push(Fastener {
                name: name.clone(),
                slices: slices.clone(),
                springs,
            });
        }
        fasteners
    }

    /// Refuses what does not know of fasteners.
    fn fits_fasteners(&mut self, format: &SceneFormat) {
        let kinematics = format.analysis.kinematics;
        if kinematics.is_some_and(|own| own != KinematicsChoice::Small) {
            let message = "with fasteners contact is found on the undeformed geometry";
            self.conflict(
                "analysis.kinematics",
                message,
                "write kinematics = \"small\"",
            );
        }
        let failure = format.failure.as_ref();
        if failure.is_some_and(|failure| failure.progressive.is_some()) {
            let message = "the failure of plies is not followed where fasteners join layers";
            let remedy = "remove failure.progressive, or model one plate with its pins held";
            self.conflict("failure.progressive", message, remedy);
        }
    }

    fn slices_are_single(&mut self, table: &str, slices: &[String], others: &[Fastener]) {
        if let [] | [_] = slices {
            let message = match slices {
                [only] => format!("the fastener has the single slice '{only}'"),
                _ => "the fastener has no slices".to_owned(),
            };
            let pin = slices.first().map_or("pin", String::as_str);
            let remedy = format!(
                "name a disk in each of its plates, or hold the pin itself: [[supports]] on = \"{pin}.section\", fix = [\"x\", \"y\"]"
            );
            self.conflict(&child(table, "slices"), message, remedy);
        }
        for (index, body) in slices.iter().enumerate() {
            let before = slices[..index].contains(body);
            let other = others.iter().find(|other| other.slices.contains(body));
            let message = match other {
                _ if before => format!("'{body}' is named twice"),
                Some(other) => format!("'{body}' is a slice of fastener '{}' already", other.name),
                None => continue,
            };
            let remedy = "each slice is a disk of its own, in one layer of one fastener";
            self.conflict(&format!("{table}.slices.{index}"), message, remedy);
        }
    }

    /// The disk `body` in the hole of its plate; `None` where it cannot be a slice, which has been reported.
    fn slice<'b>(
        &mut self,
        key: &str,
        body: &'b str,
        beside: &BesideSlices<'b>,
    ) -> Option<Slice<'b>> {
        let Some(own) = self.bodies.get(body) else {
            let known = self.bodies.keys().cloned().collect();
            self.undefined(key, "body", body, known);
            return None;
        };
        let rim = own
            .shape
            .edge_with(Role::Rim)
            .filter(|_| own.shape.is_area("section"));
        let Some(Curve::Circle { radius, .. }) = rim.map(|edge| edge.curve) else {
            let message = format!("'{body}' is a {}, and slices are disks", own.shape.name());
            self.conflict(
                key,
                message,
                "give it shape.disk.radius, or name another body",
            );
            return None;
        };
        let Substance::Elastic { thickness, .. } = own.substance else {
            let message = format!("'{body}' is rigid, and slices are elastic disks");
            self.conflict(key, message, "give it a material and a thickness");
            return None;
        };
        let supports = beside.supports.iter().map(|support| &support.on);
        let supports = supports.chain(beside.springs.iter().map(|own| &own.on));
        let mut holds = supports.chain(beside.platens.iter().map(|platen| &platen.on));
        if let Some(on) = holds.find(|on| on.body == body) {
            let message = format!("{on} is held, and what carries a slice are the other slices");
            self.conflict(
                key,
                message,
                "hold the plates instead, or take the slice out",
            );
            return None;
        }
        let Some(contact) = beside.contacts.iter().find(|own| own.second.body == body) else {
            // A contact that could not be read has been reported.
            if self.written("contacts") == beside.contacts.len() {
                let message = format!("'{body}' stands in no hole");
                let remedy = format!(
                    "add the contact with its plate: [[contacts]] first = \"plate.hole\", second = \"{body}.rim\""
                );
                self.conflict(key, message, remedy);
            }
            return None;
        };
        self.in_plate(
            key,
            (body, radius, thickness),
            &contact.first,
            beside.contacts,
        )
    }

    fn in_plate<'b>(
        &mut self,
        key: &str,
        (body, radius, thickness): (&'b str, f64, f64),
        hole: &'b SetRef,
        contacts: &[Contact],
    ) -> Option<Slice<'b>> {
        let stands_in = |own: &&Contact| {
            let outer = self.edge_of(&own.second);
            own.second.body == hole.body && outer.is_some_and(|edge| edge.role == Role::Rim)
        };
        if let Some(outer) = contacts.iter().find(stands_in) {
            let message = format!(
                "'{body}' stands in '{}', which stands in '{}': slices stand in plates",
                hole.body, outer.first.body
            );
            let remedy = "leave the bushing out, or hold its pin without a fastener";
            self.conflict(key, message, remedy);
            return None;
        }
        let plate = self.bodies.get(&hole.body)?;
        let circle = plate.shape.edge(&hole.set).map(|own| own.curve);
        let position = plate.position;
        if let Substance::Elastic {
            thickness: other, ..
        } = plate.substance
            && (other - thickness).abs() > EQUAL * other
        {
            let message = format!(
                "'{body}' is {thickness} mm thick, and its plate '{}' {other} mm",
                hole.body
            );
            let remedy = format!("give it the thickness of the plate: \"{other} mm\"");
            self.conflict(&format!("bodies.{body}.thickness"), message, remedy);
        }
        let Some(Curve::Circle { centre, .. }) = circle else {
            return None;
        };
        Some(Slice {
            body,
            radius,
            plate: &hole.body,
            centre: [0, 1].map(|axis| centre[axis] + position[axis]),
        })
    }

    fn springs(&mut self, table: &str, given: &SpringsFormat, slices: usize) -> Springs {
        match given {
            SpringsFormat::Rigid(_) | SpringsFormat::Lumped(_) => Springs::Rigid,
            SpringsFormat::Beam(beam) => {
                let clamped = [beam.head, beam.nut].map(|end| end == EndFormat::Clamped);
                if slices == 2 && clamped == [false; 2] {
                    let message = "two forces in different layers tilt a shank whose ends are free";
                    let remedy = "write head = \"clamped\", nut = \"clamped\" or both, or springs.rigid = {}";
                    self.conflict(&child(table, "springs.beam"), message, remedy);
                }
                Springs::Beam { clamped }
            }
            SpringsFormat::Given(given) => {
                let found = given.displacements.len();
                if found + 1 != slices {
                    let message =
                        format!("{found} displacements are given between {slices} slices");
                    let remedy = "give one for each slice and the next";
                    self.conflict(
                        &child(table, "springs.given.displacements"),
                        message,
                        remedy,
                    );
                }
                let force = given.force.value();
                let compliance = given.displacements.iter().map(Quantity::value);
                Springs::Given {
                    compliance: compliance.map(|moved| moved / force).collect(),
                }
            }
        }
    }

    /// The holes of a fastener lie above each other, each in a plate of its own.
    fn is_straight(&mut self, table: &str, slices: &[Slice<'_>]) {
        let key = child(table, "slices");
        for (index, slice) in slices.iter().enumerate() {
            let [first, own] = [slices[0].centre, slice.centre];
            let apart = (own[0] - first[0]).hypot(own[1] - first[1]);
            if apart > EQUAL * slice.radius {
                let message = format!(
                    "the hole of '{}' lies at ({}, {}) mm in '{}', that of '{}' at ({}, {}) mm in '{}'",
                    slice.body,
                    own[0],
                    own[1],
                    slice.plate,
                    slices[0].body,
                    first[0],
                    first[1],
                    slices[0].plate
                );
                let remedy = "a fastener is straight: put the holes at the same place";
                self.conflict(&key, message, remedy);
            }
            let before = slices[..index]
                .iter()
                .find(|other| other.plate == slice.plate);
            if let Some(before) = before {
                let message = format!(
                    "'{}' and '{}' both stand in '{}'",
                    before.body, slice.body, slice.plate
                );
                let remedy =
                    "a plate lies in one layer: let each slice stand in a plate of its own";
                self.conflict(&key, message, remedy);
            }
        }
    }

    /// The shank of a beam, and of a formula, has one radius and one isotropic material.
    fn has_one_shank(&mut self, key: &str, slices: &[Slice<'_>], materials: &Materials) {
        let material = |slice: &Slice<'_>| match &self.bodies.get(slice.body)?.substance {
            Substance::Elastic { material, .. } => Some(material.clone()),
            Substance::Rigid => None,
        };
        let first = material(&slices[0]);
        let other = slices.iter().find(|slice| material(slice) != first);
        let radius = slices[0].radius;
        let uneven = |slice: &&Slice<'_>| (slice.radius - radius).abs() > EQUAL * radius;
        let message = if let Some(other) = other {
            format!(
                "'{}' and '{}' differ in material",
                slices[0].body, other.body
            )
        } else if let Some(other) = slices.iter().find(uneven) {
            format!(
                "'{}' has the radius {} mm and '{}' {radius} mm",
                other.body, other.radius, slices[0].body
            )
        } else if let Some(name) = first
            && let Some(Material::Orthotropic { .. } | Material::Laminate(_)) = materials.get(&name)
        {
            format!("the material '{name}' of the slices is not isotropic")
        } else {
            return;
        };
        let remedy = "beams and formulas have one radius and one isotropic material: say springs.given or springs.rigid of others";
        self.conflict(key, message, remedy);
    }

    /// Refuses contacts between `plates` that lie above each other.
    fn layers_do_not_touch(
        &mut self,
        format: &SceneFormat,
        plates: &[String],
        contacts: &[Contact],
    ) {
        let lies = |set: &SetRef| plates.contains(&set.body);
        for contact in contacts {
            let name = Some(&contact.name);
            let own = format
                .contacts
                .iter()
                .position(|own| own.name.as_ref() == name);
            let key = child("contacts", own.unwrap_or_default());
            if !(lies(&contact.first) && lies(&contact.second)) || self.is_refused_at(&key) {
                continue;
            }
            let message = format!(
                "contact '{}' is between '{}' and '{}', which lie in different layers",
                contact.name, contact.first.body, contact.second.body
            );
            let remedy = "remove it: friction between plates that lie on each other is not modelled, and clamping neither; fasteners join them by their slices";
            self.conflict(&key, message, remedy);
        }
    }

    /// Plates lie above each other in the same order in all fasteners.
    fn layers_agree(
        &mut self,
        table: &str,
        name: &str,
        plates: &[String],
        others: &[(String, Vec<String>)],
    ) {
        for (other, order) in others {
            let place: BTreeMap<&String, usize> = order.iter().zip(0..).collect();
            let known: Vec<(&String, usize)> = (plates.iter())
                .filter_map(|plate| Some((plate, *place.get(plate)?)))
                .collect();
            let crossed = known.windows(2).find(|pair| pair[0].1 > pair[1].1);
            if let Some([(below, _), (above, _)]) = crossed {
                let message = format!(
                    "'{below}' lies below '{above}' in fastener '{name}' and above it in '{other}'"
                );
                let remedy = "name the slices of all fasteners in the order of the layers";
                self.conflict(&child(table, "slices"), message, remedy);
            }
        }
    }
}
