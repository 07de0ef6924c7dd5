//! What is asked of the accuracy, and models of bodies that contradict the rest of the scene.

use super::Builder;
use crate::document::child;
use crate::format::SceneFormat;
use crate::schema::{Accuracy, Analysis, BodyModel, KinematicsChoice, RelativeError, Substance};
use crate::shape::Role;

impl Builder<'_> {
    /// Refuses an accuracy that no run can have, and a budget without one.
    pub(super) fn demand(&mut self, analysis: &Analysis) {
        const KEY: &str = "analysis.accuracy";
        match analysis.accuracy {
            Some(Accuracy::Overall(error)) => self.askable(KEY, error),
            Some(Accuracy::Named(bounds)) => {
                if bounds.entries().next().is_none() {
                    let message = "the table accuracy names no number";
                    let remedy =
                        "name one, for example peak_pressure = \"0.1 %\", or remove accuracy";
                    self.conflict(KEY, message, remedy);
                }
                for (name, error) in bounds.entries() {
                    self.askable(&child(KEY, name), error);
                }
            }
            None => {}
        }
        let Some(budget) = analysis.budget else {
            return;
        };
        if budget.seconds() <= 0.0 {
            let allowed = "a time above 0 s";
            self.out_of_range("analysis.budget", &format!("\"{budget}\""), allowed);
        } else if analysis.accuracy.is_none() {
            let message = "a budget ends the search for an accuracy, and none is asked for";
            let remedy = "add analysis.accuracy, for example accuracy = \"1 %\", or remove budget";
            self.conflict("analysis.budget", message, remedy);
        }
    }

    /// Refuses a memory that bounds nothing, at the key that prescribes the model.
    fn bound_memory(&mut self, format: &SceneFormat) {
        let Some(memory) = format.analysis.memory else {
            return;
        };
        if memory.bytes() <= 0.0 {
            let allowed = "an amount of memory above 0 GB";
            self.out_of_range("analysis.memory", &format!("\"{memory}\""), allowed);
            return;
        }
        let mut bodies = self.bodies.iter();
        let own = bodies.find(|(_, body)| body.mesh.is_some() || body.shape.has_own_mesh());
        let key = match own {
            _ if format.mesh.is_some() => "mesh".to_owned(),
            _ if format.analysis.contact_nodes.is_some() => "analysis.contact_nodes".to_owned(),
            Some((name, body)) => {
                let key = if body.mesh.is_some() { "mesh" } else { "shape" };
                child(&child("bodies", name), key)
            }
            None => return,
        };
        let message = format!("analysis.memory bounds finer models, and {key} prescribes this one");
        self.conflict(&key, message, "remove one of the two");
    }

    fn askable(&mut self, key: &str, error: RelativeError) {
        if !error.is_in_range() {
            let allowed = "a relative error of at least 1e-8 and at most 50 %";
            self.out_of_range(key, &format!("\"{error}\""), allowed);
        }
    }

    /// Refuses models of bodies that nothing can have, and pins that hold nothing.
    pub(super) fn models(&mut self, format: &SceneFormat) {
        let series: Vec<String> = (self.bodies.iter())
            .filter(|(_, body)| body.model == BodyModel::Series)
            .map(|(name, _)| name.clone())
            .collect();
        let elastic = |name: &String| self.bodies[name].substance != Substance::Rigid;
        let meshed: Vec<&String> = (self.bodies.keys())
            .filter(|name| elastic(name) && !series.contains(name))
            .collect();
        let idle_mesh = format.mesh.is_some() && !series.is_empty() && meshed.is_empty();
        let rigid: Vec<String> = (self.bodies.iter())
            .filter(|(_, body)| body.substance == Substance::Rigid && body.model != BodyModel::Auto)
            .map(|(name, _)| child(&child("bodies", name), "model"))
            .collect();
        for key in rigid {
            let message = format!("{key} says how a body deforms, and this one is rigid");
            self.conflict(&key, message, "remove model, or give the body a material");
        }
        if idle_mesh {
            let message = "no body of the scene is divided: model = \"series\" needs no mesh";
            let remedy = "remove the table mesh, or say model = \"elements\"";
            self.conflict("mesh", message, remedy);
        }
        self.given_meshes(format);
        self.bound_memory(format);
        self.half_planes(format);
        for name in &series {
            let (own, model) = (child("bodies", name), "model = \"series\"");
            if format.bodies[name].mesh.is_some() {
                let key = child(&own, "mesh");
                let message = format!("{key} divides a body that {model} leaves whole");
                self.conflict(&key, message, "remove one of the two");
            }
        }
    }

    /// Refuses an accuracy beside a mesh that cannot be made finer, and settings that would divide it.
    fn given_meshes(&mut self, format: &SceneFormat) {
        let own = self.bodies.iter();
        let own = own.filter(|(_, body)| body.shape.has_own_mesh());
        let names: Vec<String> = own.map(|(name, _)| name.clone()).collect();
        let Some(first) = names.first() else {
            return;
        };
        if format.analysis.accuracy.is_some() {
            let message = format!(
                "the mesh of '{first}' is given by a file, so nothing is known of its error"
            );
            let remedy = "remove accuracy, and compare with a finer file";
            self.conflict("analysis.accuracy", message, remedy);
        }
        for name in names {
            if format.bodies[&name].mesh.is_some() {
                let key = child(&child("bodies", &name), "mesh");
                let message = format!("{key} divides a body whose mesh is given by a file");
                self.conflict(&key, message, "remove one of the two");
            }
        }
    }

    /// Refuses half-planes of shapes that stand for none, and of a geometry that half-planes do not have.
    fn half_planes(&mut self, format: &SceneFormat) {
        let asked = self.bodies.iter();
        let asked = asked.filter(|(_, body)| body.model == BodyModel::HalfPlane);
        let asked: Vec<_> = asked
            .map(|(name, body)| (name.clone(), body.shape.clone()))
            .collect();
        for (name, shape) in &asked {
            let is_line = [Role::Cap, Role::Surface].map(|role| shape.edge_with(role).is_some());
            if !is_line.contains(&true) {
                let key = child(&child("bodies", name), "model");
                let message = format!(
                    "{key} = \"half-plane\" is for a block or a cylinder, and '{name}' is a {}",
                    shape.name()
                );
                self.conflict(&key, message, "say model = \"elements\" or \"auto\"");
            }
        }
        let follows = format.analysis.kinematics == Some(KinematicsChoice::DeformedGaps);
        if follows && !asked.is_empty() {
            let key = "analysis.kinematics";
            let message = "half-planes touch on the undeformed geometry, as Hertz has it, and \"deformed-gaps\" follows the displacement";
            self.conflict(
                key,
                message,
                "say kinematics = \"small\", or model = \"elements\"",
            );
        }
    }
}
