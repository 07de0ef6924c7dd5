//! Division of the bodies.

use std::f64::consts::TAU;

use serde_json::Value;

use super::Builder;
use crate::document::{Part, child};
use crate::format::SceneFormat;
use crate::schema::mesh::{DEFAULT_ELEMENT, merged};
use crate::schema::{Body, Division, Grading, MeshFormat, MeshSettings, Substance};
use crate::shape::Shape;
use crate::units::{AngleOrLength, Dimension, Expected, Quantity, UnitError};

/// Cells along the shorter side of a body that is divided equally, of the coarsest division that is tried.
const ALONG: f64 = 32.0;
/// Fewest such cells of a body with smaller ones where it touches.
const FEWEST: f64 = 4.0;

/// A table of mesh settings and the bodies that it divides.
struct Scope<'a> {
    table: &'a str,
    bodies: &'a [&'a str],
}

impl Scope<'_> {
    fn key(&self, name: &str) -> String {
        child(self.table, name)
    }
}

impl Builder<'_> {
    /// The division of the bodies, and of those that are not round where that is another one.
    pub(super) fn mesh(
        &mut self,
        format: &mut SceneFormat,
    ) -> (MeshSettings, Option<MeshSettings>) {
        let Some(given) = format.mesh.as_mut() else {
            return self.undivided();
        };
        given.element.get_or_insert(DEFAULT_ELEMENT);
        let given = given.clone();
        let divided = |name: &&String| {
            let own = format.bodies[*name].mesh.as_ref();
            !own.is_some_and(|own| own.spacing.is_some() || own.angles.is_some())
        };
        let names = format.bodies.keys().filter(divided);
        let bodies: Vec<&str> = names.map(String::as_str).collect();
        let scope = Scope {
            table: "mesh",
            bodies: &bodies,
        };
        let settings = self.settings(&scope, &given, None);
        self.unused("mesh", |_| true);
        (settings, None)
    }

    /// Where the scene gives no mesh: the coarsest division that is tried.
    fn undivided(&mut self) -> (MeshSettings, Option<MeshSettings>) {
        let elastic = self.bodies.values();
        let elastic = elastic.filter(|body| body.substance != Substance::Rigid);
        let (given, elastic): (Vec<_>, Vec<_>) =
            elastic.partition(|body| body.shape.has_own_mesh());
        let (round, others): (Vec<&Shape>, Vec<&Shape>) = (elastic.iter())
            .map(|body| &body.shape)
            .partition(|shape| shape.is_round());
        let division = |make: fn(Grading) -> Division, spacing| MeshSettings {
            element: DEFAULT_ELEMENT,
            division: make(Grading {
                spacing,
                fine_to: None,
                coarse_spacing: None,
            }),
            layers: None,
            fineness: 1.0,
        };
        let lengths = others.iter().map(|shape| coarsest(shape));
        let by_lengths = (lengths.reduce(f64::min)).map(|least| division(Division::Linear, least));
        let by_angles = division(Division::Angular, TAU / 120.0);
        let is_mixed = !round.is_empty();
        let needs_mesh = !given.is_empty() && !elastic.is_empty();
        if needs_mesh && !self.is_refused("mesh") {
            let undivided = self
                .bodies
                .iter()
                .find(|(_, body)| body.substance != Substance::Rigid && !body.shape.has_own_mesh());
            let table = undivided.map_or(String::new(), |(name, _)| format!("bodies.{name}"));
            self.missing(&table, "mesh");
        }
        match by_lengths {
            Some(own) if is_mixed => (by_angles, Some(own)),
            Some(own) => (own, None),
            None => (by_angles, None),
        }
    }

    /// The settings of bodies that have their own.
    pub(super) fn body_meshes(&mut self, format: &SceneFormat, whole: &MeshSettings) {
        let whole_format = format.mesh.clone().unwrap_or_default();
        for (name, body) in &format.bodies {
            let Some(own) = &body.mesh else {
                continue;
            };
            let table = child(&child("bodies", name), "mesh");
            let rigid = |body: &Body| body.substance == Substance::Rigid;
            if self.bodies.get(name).is_some_and(rigid) {
                let message = format!("the rigid body '{name}' is not divided");
                let remedy = "remove its mesh, or give the body a material";
                self.conflict(&table, message, remedy);
                continue;
            }
            let scope = Scope {
                table: &table,
                bodies: &[name],
            };
            let given = merged(own, &whole_format);
            let inherited = (!own.divides()).then(|| whole.division.clone());
            let settings = self.settings(&scope, &given, inherited);
            self.unused(&table, |other| other == name);
            if let Some(body) = self.bodies.get_mut(name) {
                body.mesh = Some(settings);
            }
        }
    }

    fn settings(
        &mut self,
        scope: &Scope<'_>,
        given: &MeshFormat,
        inherited: Option<Division>,
    ) -> MeshSettings {
        let division = inherited.unwrap_or_else(|| self.division(scope, given));
        given.settings(division)
    }

    /// Refuses the keys written in a table of mesh settings that the shape of none of its bodies uses.
    fn unused(&mut self, table: &str, holds_for: impl Fn(&str) -> bool) {
        let bodies = self.bodies.iter().filter(|(name, _)| holds_for(name));
        let shapes: Vec<Shape> = bodies
            .filter(|(_, body)| body.substance != Substance::Rigid)
            .map(|(_, body)| body.shape.clone())
            .collect();
        let Some(Value::Object(written)) = self.document.get(table) else {
            return;
        };
        let used = |key: &str| shapes.iter().any(|own| own.mesh_keys().contains(&key));
        for name in written.keys().filter(|name| *name != "element") {
            let key = child(table, name);
            if used(name) || shapes.is_empty() || self.is_refused(&key) {
                continue;
            }
            let mut names: Vec<&str> = shapes.iter().map(|shape| shape.name()).collect();
            names.sort_unstable();
            names.dedup();
            let message = format!(
                "{key} has no effect: nothing in the mesh of a {} depends on it",
                names.join(" or a ")
            );
            self.conflict(&key, message, format!("remove {name}"));
        }
    }

    fn division(&mut self, scope: &Scope<'_>, given: &MeshFormat) -> Division {
        let others = [
            ("fine_to", &given.fine_to),
            ("coarse_spacing", &given.coarse_spacing),
        ];
        match (&given.spacing, &given.angles) {
            (None, Some(angles)) => {
                let angles: Vec<f64> = angles.iter().map(Quantity::value).collect();
                self.angles(scope, given, &angles);
                for (name, _) in others.iter().filter(|(_, value)| value.is_some()) {
                    let (key, angles) = (scope.key(name), scope.key("angles"));
                    let message = format!("{key} has no meaning beside {angles}");
                    let remedy = "give the angles themselves, or spacing instead";
                    self.conflict(&key, message, remedy);
                }
                self.fits_shapes(scope, "angles", "a list of angles", Dimension::Angle);
                Division::AngleList(angles)
            }
            (Some(spacing), None) => self.graded(scope, spacing, others),
            // Both or none has been reported.
            _ => Division::AngleList(Vec::new()),
        }
    }

    fn angles(&mut self, scope: &Scope<'_>, given: &MeshFormat, angles: &[f64]) {
        let texts: Vec<_> = given.angles.iter().flatten().map(Quantity::text).collect();
        if angles.len() < 2 {
            let found = format!("{} angles", angles.len());
            let allowed = "at least two, from 0 deg to 180 deg for a half model";
            self.out_of_range(&scope.key("angles"), &found, allowed);
            return;
        }
        for (index, pair) in angles.windows(2).enumerate() {
            if pair[1] <= pair[0] {
                let allowed = format!("greater than the angle before it, {}", texts[index]);
                self.out_of_range(
                    &scope.key(&format!("angles.{}", index + 1)),
                    texts[index + 1],
                    allowed,
                );
            }
        }
        if angles[0] != 0.0 {
            self.out_of_range(&scope.key("angles.0"), texts[0], "0 deg, the bearing point");
        }
        let last = angles.len() - 1;
        // Half an ulp of 2π more than the sum of a table in degrees can miss.
        if angles[last] > TAU * (1.0 + f64::EPSILON) {
            let allowed = "at most 360 deg";
            self.out_of_range(&scope.key(&format!("angles.{last}")), texts[last], allowed);
        }
    }

    fn graded(
        &mut self,
        scope: &Scope<'_>,
        spacing: &Quantity<AngleOrLength>,
        others: [(&str, &Option<Quantity<AngleOrLength>>); 2],
    ) -> Division {
        let dimension = spacing.dimension();
        self.fits_shapes(scope, "spacing", spacing.text(), dimension);
        let fine = spacing.value();
        if dimension == Dimension::Angle && fine > TAU / 8.0 {
            self.out_of_range(&scope.key("spacing"), spacing.text(), "at most 45 deg");
        }
        let [fine_to, coarse_spacing] = others.map(|(name, other)| {
            let other = other.as_ref()?;
            let value = other.value();
            if other.dimension() != dimension {
                let problem = UnitError::WrongDimension {
                    text: other.text().to_owned(),
                    expected: Expected::one(dimension),
                    found: other.dimension(),
                };
                self.report(&scope.key(name), Part::Value, problem.into());
            } else if value < fine {
                self.below_spacing(scope, spacing.text(), name, other.text());
            }
            Some(value)
        });
        if coarse_spacing.is_some() && fine_to.is_none() {
            let (key, fine_to) = (scope.key("coarse_spacing"), scope.key("fine_to"));
            let message = format!("{key} needs {fine_to}, which says from where it holds");
            let remedy = format!("add {fine_to}, for example fine_to = \"100 deg\"");
            self.conflict(&key, message, remedy);
        }
        let grading = Grading {
            spacing: fine,
            fine_to,
            coarse_spacing,
        };
        if dimension == Dimension::Angle {
            Division::Angular(grading)
        } else {
            Division::Linear(grading)
        }
    }

    /// `name` is less than the spacing. Of two keys that do not fit the more particular one is shown: that of a body before that of the
    /// scene, an override before the file, otherwise `name`. What the scene's table says by itself is reported there alone.
    fn below_spacing(&mut self, scope: &Scope<'_>, spacing: &str, name: &str, other: &str) {
        let written = |name: &str| {
            let own = scope.key(name);
            let is_own = self.document.get(&own).is_some();
            let key = if is_own { own } else { child("mesh", name) };
            let particular = (is_own, self.document.is_overridden(&key));
            (key, particular)
        };
        let ((fine, first), (key, second)) = (written("spacing"), written(name));
        if scope.table != "mesh" && !first.0 && !second.0 {
            return;
        }
        if first > second {
            self.out_of_range(&fine, spacing, format!("at most {key}, {other}"));
        } else {
            self.out_of_range(&key, other, format!("at least {fine}, {spacing}"));
        }
    }

    /// Round shapes are divided by angles, the others by lengths.
    fn fits_shapes(&mut self, scope: &Scope<'_>, name: &str, text: &str, dimension: Dimension) {
        let wanted = |shape: &Shape| {
            if shape.is_round() {
                Dimension::Angle
            } else {
                Dimension::Length
            }
        };
        let shapes = scope
            .bodies
            .iter()
            .copied()
            .filter_map(|body| Some((body, self.bodies.get(body)?.shape.clone())));
        let mut misfits =
            shapes.filter(|(_, shape)| !shape.has_own_mesh() && wanted(shape) != dimension);
        let Some((body, shape)) = misfits.next() else {
            return;
        };
        let key = scope.key(name);
        let (divided, remedy) = if shape.is_round() {
            (
                "angles",
                "give the spacing of corner nodes on the circle, for example spacing = \"2 deg\"",
            )
        } else {
            (
                "lengths",
                "give the spacing of corner nodes on the contact edge, for example spacing = \"0.05 mm\"",
            )
        };
        let found = match name {
            "angles" => "angles",
            _ => dimension.with_article(),
        };
        let shape = shape.name();
        let message = format!(
            "body '{body}' ({shape}) is divided by {divided}, but {key} = {text} is {found}"
        );
        self.conflict(&key, message, remedy);
    }
}

/// The largest cells `[mm]` of the coarsest division of `shape` that is tried: [`ALONG`] along its shorter side, fewer where edges have smaller ones.
fn coarsest(shape: &Shape) -> f64 {
    let [low, high] = shape.bounds();
    let least = (high[0] - low[0]).min(high[1] - low[1]);
    least / ALONG * shape.refinement().min(ALONG / FEWEST)
}
