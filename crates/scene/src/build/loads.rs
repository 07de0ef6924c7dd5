//! Loads and their histories.

use std::path::Path;

use super::{Builder, Fits, Materials};
use crate::diagnostic::SceneProblem;
use crate::document::{Part, child};
use crate::format::SceneFormat;
use crate::schema::loads::{BearingFormat, PolarTractionFormat};
use crate::schema::{Load, LoadFormat, LoadKind, SetRef, Substance};
use crate::shape::Role;
use crate::table;

impl Builder<'_> {
    /// The loads that could be read, with their numbers in the scene.
    pub(super) fn loads(
        &mut self,
        format: &SceneFormat,
        materials: &Materials,
        base: &Path,
    ) -> Vec<(usize, Load)> {
        let mut loads: Vec<(usize, Load)> = Vec::new();
        for (index, given) in format.loads.iter().enumerate() {
            let key = format!("loads.{index}");
            let Some(kind) = self.kind(&key, given, materials, base) else {
                continue;
            };
            let load = given.load(index, kind);
            self.history(&key, &load, loads.first().map(|(_, first)| first));
            loads.push((index, load));
        }
        loads
    }

    fn history(&mut self, key: &str, Load { name, kind }: &Load, first: Option<&Load>) {
        let key = child(&child(key, key_of(kind)), "steps");
        let steps = kind.steps().len();
        if steps == 0 {
            self.out_of_range(&key, "[]", "a list of at least one value");
        }
        if let Some(first) = first
            && first.kind.steps().len() != steps
        {
            let problem = SceneProblem::UnequalSteps {
                load: name.clone(),
                steps,
                other: first.name.clone(),
                other_steps: first.kind.steps().len(),
            };
            self.report(&key, Part::Value, problem);
        }
    }

    fn kind(
        &mut self,
        key: &str,
        given: &LoadFormat,
        materials: &Materials,
        base: &Path,
    ) -> Option<LoadKind> {
        // Several kinds or none have been reported.
        if self.is_refused_at(key) {
            return None;
        }
        if let Some(temperature) = &given.temperature {
            return Some(temperature.kind(self.heated(key, &given.on, materials)?));
        }
        let fits = match given.force {
            Some(_) => Fits::EdgesAndPoints,
            None => Fits::Edges,
        };
        let on = self.set(&child(key, "on"), &given.on, fits)?;
        if let Some(force) = &given.force {
            if self.has_several_nodes(key, &on) {
                return None;
            }
            let direction = self.direction(&child(key, "force.direction"), &force.direction)?;
            return Some(force.kind(on, direction));
        }
        if let Some(bearing) = &given.bearing {
            return self.bearing(key, on, bearing);
        }
        if let Some(pressure) = &given.pressure {
            return Some(pressure.kind(on));
        }
        self.polar(key, on, given.polar_traction.as_ref()?, base)
    }

    /// The unit vector of a direction given at `key`.
    fn direction(&mut self, key: &str, given: &[f64]) -> Option<[f64; 2]> {
        let numbers: Vec<_> = given.iter().map(f64::to_string).collect();
        let shown = format!("[{}]", numbers.join(", "));
        let &[x, y] = given else {
            let allowed = "two numbers, x and y, such as [-1, 0]";
            self.out_of_range(key, &shown, allowed);
            return None;
        };
        let length = x.hypot(y);
        if !(length.is_finite() && length > 0.0) {
            let allowed = "a vector other than zero, such as [-1, 0]";
            self.out_of_range(key, &shown, allowed);
            return None;
        }
        Some([x / length, y / length])
    }

    fn bearing(&mut self, key: &str, on: SetRef, bearing: &BearingFormat) -> Option<LoadKind> {
        if self.edge_of(&on).is_none_or(|edge| edge.role != Role::Hole) {
            let message = format!("'{on}' is no hole, and a bearing load stands for a pin in one");
            let remedy = "put it on the hole of a plate_with_hole, such as plate.hole; other edges take a force or a pressure";
            self.conflict(&child(key, "on"), message, remedy);
            return None;
        }
        let direction = self.direction(&child(key, "bearing.direction"), &bearing.direction)?;
        Some(bearing.kind(on, direction))
    }

    fn heated(&mut self, key: &str, name: &str, materials: &Materials) -> Option<String> {
        let key = child(key, "on");
        let known = self.bodies.keys().cloned().collect();
        let Some(body) = self.bodies.get(name) else {
            self.undefined(&key, "body", name, known);
            return None;
        };
        let material = match &body.substance {
            Substance::Elastic { material, .. } => materials
                .get(material)
                .map(|found| (material.clone(), found)),
            Substance::Rigid => None,
        };
        match material {
            Some((_, material)) if material.expands() => {}
            Some((material, _)) => {
                let message = format!(
                    "a temperature does nothing to '{name}': material '{material}' has no expansion"
                );
                let remedy = format!(
                    "add materials.{material}: expansion = \"2.3e-5 1/K\", or remove the load"
                );
                self.conflict(&key, message, remedy);
            }
            None => {
                let message = format!("a temperature does nothing to '{name}', which is rigid");
                let remedy = "give the body a material, or remove the load";
                self.conflict(&key, message, remedy);
            }
        }
        Some(name.to_owned())
    }

    fn polar(
        &mut self,
        key: &str,
        on: SetRef,
        given: &PolarTractionFormat,
        base: &Path,
    ) -> Option<LoadKind> {
        let shape = self.bodies.get(&on.body)?.shape.clone();
        if shape.circle(&on.set).is_none() {
            let edges = shape.edges().into_iter();
            let circles = edges.filter(|edge| edge.circle().is_some());
            let remedy = circles
                .map(|edge| format!("{}.{}", on.body, edge.name))
                .collect::<Vec<_>>();
            let message = format!("'{on}' is no circle, and polar_traction needs one");
            let remedy = format!("circles of this body: {}", remedy.join(", "));
            self.conflict(&child(key, "on"), message, remedy);
            return None;
        }
        let key = child(key, "polar_traction");
        let file = base.join(&given.file);
        let columns = [&given.theta, &given.radial, &given.shear].map(String::as_str);
        let read = table::read(&file, columns, self.document.host)
            .and_then(|columns| table::check_angles(&columns[0]).map(|()| columns));
        match read {
            Ok(columns) => Some(given.kind(on, file, columns)),
            Err(error) => {
                let path = file.display().to_string();
                let problem = SceneProblem::DataFile {
                    path,
                    cause: error.cause,
                    remedy: error.remedy,
                };
                self.report(&child(&key, "file"), Part::Value, problem);
                None
            }
        }
    }
}

fn key_of(kind: &LoadKind) -> &'static str {
    match kind {
        LoadKind::Force { .. } => "force",
        LoadKind::Bearing { .. } => "bearing",
        LoadKind::Pressure { .. } => "pressure",
        LoadKind::PolarTraction { .. } => "polar_traction",
        LoadKind::Temperature { .. } => "temperature",
    }
}
