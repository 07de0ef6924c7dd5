//! Materials and bodies.

use std::collections::BTreeMap;
use std::io;
use std::path::Path;
use std::sync::Arc;

use stickslip_fem_core::material::{MaterialError, PlaneState};
use stickslip_fem_core::mesh::Point;
use stickslip_laminate::Ply;

use super::{Builder, Materials};
use crate::diagnostic::SceneProblem;
use crate::document::{Part, child};
use crate::format::SceneFormat;
use crate::limits::Content;
use crate::material::{MaterialFormat, OrthotropicFormat};
use crate::schema::{Body, Contact, Material, SetRef, Substance};
use crate::shape::{Shape, Sizes};
use crate::units::{Angle, Length, Quantity};

impl Builder<'_> {
    pub(super) fn materials(
        &mut self,
        format: &SceneFormat,
        plies: &BTreeMap<String, Ply>,
        plane: PlaneState,
    ) -> Materials {
        let mut materials = Materials::new();
        for (name, material) in &format.materials {
            self.name("materials", name);
            let table = child("materials", name);
            let (kind, material) = match material {
                MaterialFormat::Isotropic(given) => ("isotropic", given.material()),
                MaterialFormat::Orthotropic(given) => {
                    ("orthotropic", self.orthotropic(&table, given, plane))
                }
                MaterialFormat::Laminate(given) => {
                    if let Some(sheet) = self.laminate(&table, name, given, plies, plane) {
                        let material = Material::Laminate(Arc::new(sheet));
                        materials.insert(name.clone(), material);
                    }
                    continue;
                }
            };
            // Constants that are wrong each for itself need no second message.
            if !self.is_refused(&table)
                && let Err(cause) = material.in_plane(plane)
            {
                self.bad_material(&child(&table, kind), name, cause);
            }
            materials.insert(name.clone(), material);
        }
        materials
    }

    fn orthotropic(
        &mut self,
        table: &str,
        given: &OrthotropicFormat,
        plane: PlaneState,
    ) -> Material {
        let table = child(table, "orthotropic");
        if plane == PlaneState::Strain {
            for name in given.missing_out_of_plane() {
                self.missing(&table, name);
            }
        }
        given.material()
    }

    fn bad_material(&mut self, table: &str, name: &str, cause: MaterialError) {
        let key = match &cause {
            MaterialError::Poisson { .. } => child(table, "poisson"),
            MaterialError::OrthotropicPoisson { name, .. } => child(table, name),
            _ => table.to_owned(),
        };
        self.report(
            &key,
            Part::Value,
            SceneProblem::Material {
                material: name.to_owned(),
                cause,
            },
        );
    }

    pub(super) fn bodies(&mut self, format: &SceneFormat, materials: &Materials) {
        if format.bodies.is_empty() {
            self.missing("", "bodies");
        }
        for (name, body) in &format.bodies {
            self.name("bodies", name);
            let table = child("bodies", name);
            let material = body.material.as_ref().filter(|_| !body.rigid);
            let substance = self.substance(&table, material, body.thickness.as_ref(), materials);
            let shape = body.shape.read(&child(&table, "shape"), self);
            let shape = self.turned(&table, shape, body.angle.as_ref());
            let position = self.position(&table, &shape, body.position.as_ref());
            let body = body.body(substance, shape, position);
            self.bodies.insert(name.clone(), body);
        }
    }

    /// `shape` turned by `angle`, which only shapes without an axis can be.
    fn turned(&mut self, table: &str, shape: Shape, angle: Option<&Quantity<Angle>>) -> Shape {
        let Some(angle) = angle.filter(|angle| angle.value() != 0.0) else {
            return shape;
        };
        shape.turned(angle.value()).unwrap_or_else(|| {
            let message = format!("a {} is not turned", shape.name());
            let remedy = "leave out `angle`, or draw the body as shape.outline";
            self.conflict(&child(table, "angle"), message, remedy);
            shape
        })
    }

    /// Where the origin of a body stands.
    fn position(
        &mut self,
        table: &str,
        shape: &Shape,
        given: Option<&[Quantity<Length>; 2]>,
    ) -> Point {
        let at = given.map_or([0.0; 2], |given| [given[0].value(), given[1].value()]);
        if at != [0.0; 2] && shape.mirror().is_some() {
            let message = format!("a {} stands at the origin or in a hole", shape.name());
            let remedy = "leave out `position`, or draw the body as shape.outline";
            self.conflict(&child(table, "position"), message, remedy);
            return [0.0; 2];
        }
        at
    }

    /// Refuses positions of bodies that a contact puts into a hole.
    pub(super) fn stand_once(&mut self, contacts: &[Contact]) {
        let circle = |bodies: &BTreeMap<String, Body>, set: &SetRef| {
            bodies
                .get(&set.body)
                .is_some_and(|body| body.shape.circle(&set.set).is_some())
        };
        for contact in contacts {
            let is_round = [&contact.first, &contact.second]
                .iter()
                .all(|set| circle(&self.bodies, set));
            let inner = &contact.second.body;
            let is_placed = self
                .bodies
                .get(inner)
                .is_some_and(|body| body.position != [0.0; 2]);
            if is_round && is_placed {
                let message = format!(
                    "contact '{}' puts '{inner}' into {}",
                    contact.name, contact.first
                );
                let remedy = "leave out `position`";
                self.conflict(&format!("bodies.{inner}.position"), message, remedy);
            }
        }
    }

    fn substance(
        &mut self,
        table: &str,
        material: Option<&String>,
        given: Option<&Quantity<Length>>,
        materials: &Materials,
    ) -> Substance {
        // A material and `rigid`, or none of both, has been reported.
        let Some(material) = material else {
            return Substance::Rigid;
        };
        // A laminate that was refused for itself needs no second message.
        let written = self.document.get(&child("materials", material)).is_some();
        if !materials.contains_key(material) && !written {
            let known = materials.keys().cloned().collect();
            self.undefined(&child(table, "material"), "material", material, known);
        }
        let thickness = match materials.get(material) {
            Some(Material::Laminate(sheet)) => {
                self.laminate_thickness(table, material, given, sheet)
            }
            found => {
                if given.is_none() && (found.is_some() || !written) {
                    self.missing(table, "thickness");
                }
                given.map_or(1.0, Quantity::value)
            }
        };
        Substance::Elastic {
            material: material.clone(),
            thickness,
        }
    }
}

impl Sizes for Builder<'_> {
    fn refuse(&mut self, key: &str, size: &Quantity<Length>, allowed: &str) {
        self.out_of_range(key, size.text(), allowed);
    }

    fn file(&self, path: &Path, included: Option<&str>) -> io::Result<String> {
        let (host, path) = (self.document.host, self.base.join(path));
        match included {
            None => host.read_text(&path, Content::Table),
            Some(name) => host.read_included(&path, name, Content::Table),
        }
    }

    fn bad_file(&mut self, key: &str, path: &str, cause: String, remedy: String) {
        let path = path.to_owned();
        let problem = SceneProblem::DataFile {
            path,
            cause,
            remedy,
        };
        self.report(key, Part::Value, problem);
    }

    fn conflict(&mut self, key: &str, message: String, remedy: &str) {
        Builder::conflict(self, key, message, remedy);
    }
}
