//! Division of the bodies.

use std::f64::consts::TAU;

use stickslip_fem_core::mesh::ElementKind;

use super::Builder;
use crate::document::{Part, child};
use crate::format::{MeshFormat, SceneFormat};
use crate::schema::{Body, Division, Grading, MeshSettings, Substance};
use crate::units::{AngleOrLength, Dimension, Expected, Quantity, UnitError};

const DEFAULT_ELEMENT: ElementKind = ElementKind::Q8;

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
    pub(super) fn mesh(&mut self, format: &mut SceneFormat) -> MeshSettings {
        format.mesh.element.get_or_insert(DEFAULT_ELEMENT);
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
        self.settings(&scope, &format.mesh, None)
    }

    /// The settings of bodies that have their own.
    pub(super) fn body_meshes(&mut self, format: &SceneFormat, whole: &MeshSettings) {
        for (name, body) in &format.bodies {
            let Some(own) = &body.mesh else {
                continue;
            };
            let table = child(&child("bodies", name), "mesh");
            let rigid = |body: &Body| body.substance == Substance::Rigid;
            if self.bodies.get(name).is_some_and(rigid) {
                self.conflict(
                    &table,
                    format!("the rigid body '{name}' is not divided"),
                    "remove its mesh, or give the body a material",
                );
                continue;
            }
            let scope = Scope {
                table: &table,
                bodies: &[name],
            };
            let divides = own.spacing.is_some()
                || own.angles.is_some()
                || own.fine_to.is_some()
                || own.coarse_spacing.is_some();
            let given = merged(own, &format.mesh);
            let inherited = (!divides).then(|| whole.division.clone());
            let settings = self.settings(&scope, &given, inherited);
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
        MeshSettings {
            element: given.element.unwrap_or(DEFAULT_ELEMENT),
            division: inherited.unwrap_or_else(|| self.division(scope, given)),
            layers: given.layers,
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
                    self.conflict(
                        &key,
                        message,
                        "give the angles themselves, or spacing instead",
                    );
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
            self.out_of_range(
                &scope.key("angles"),
                &found,
                "at least two, from 0 deg to 180 deg for a half model",
            );
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
            self.out_of_range(
                &scope.key(&format!("angles.{last}")),
                texts[last],
                "at most 360 deg",
            );
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
            self.conflict(
                &key,
                format!("{key} needs {fine_to}, which says from where it holds"),
                format!("add {fine_to}, for example fine_to = \"100 deg\""),
            );
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
        let wanted = |round: bool| {
            if round {
                Dimension::Angle
            } else {
                Dimension::Length
            }
        };
        let shapes = scope.bodies.iter().copied().filter_map(|body| {
            let shape = self.bodies.get(body)?.shape;
            Some((body, shape))
        });
        let mut misfits = shapes.filter(|(_, shape)| wanted(shape.is_round()) != dimension);
        let Some((body, shape)) = misfits.next() else {
            return;
        };
        let key = scope.key(name);
        let expected = wanted(shape.is_round());
        let shape = shape.name();
        let remedy = match expected {
            Dimension::Angle => {
                "give the spacing of corner nodes on the circle, for example spacing = \"2 deg\""
            }
            _ => {
                "give the spacing of corner nodes on the contact edge, for example spacing = \"0.05 mm\""
            }
        };
        let message = format!(
            "body '{body}' ({shape}) is divided by {}, but {key} = {text} is {}",
            if expected == Dimension::Angle {
                "angles"
            } else {
                "lengths"
            },
            if name == "angles" {
                "angles"
            } else {
                dimension.with_article()
            },
        );
        self.conflict(&key, message, remedy);
    }
}

/// What a body's own settings and those of the scene make together. A spacing of its own keeps the fine zone of the scene where
/// that is possible; a list of angles says everything.
fn merged(own: &MeshFormat, whole: &MeshFormat) -> MeshFormat {
    let divides = own.spacing.is_some() || own.angles.is_some();
    let fits = |fine_to: &&Quantity<AngleOrLength>| match (&own.spacing, &own.angles) {
        (Some(spacing), None) => {
            fine_to.dimension() == spacing.dimension() && fine_to.value() >= spacing.value()
        }
        (None, None) => true,
        (_, Some(_)) => false,
    };
    let kept = || whole.fine_to.as_ref().filter(fits).cloned();
    let coarse = || whole.coarse_spacing.clone().filter(|_| !divides);
    MeshFormat {
        element: own.element.or(whole.element),
        spacing: own
            .spacing
            .clone()
            .or_else(|| whole.spacing.clone().filter(|_| !divides)),
        angles: own
            .angles
            .clone()
            .or_else(|| whole.angles.clone().filter(|_| !divides)),
        fine_to: own.fine_to.clone().or_else(kept),
        coarse_spacing: own.coarse_spacing.clone().or_else(coarse),
        layers: own.layers.or(whole.layers),
    }
}
