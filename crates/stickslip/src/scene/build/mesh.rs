//! Division of the bodies.

use std::f64::consts::TAU;

use super::Builder;
use crate::diagnostic::SceneProblem;
use crate::scene::document::Part;
use crate::scene::format::{MeshFormat, SceneFormat};
use crate::scene::schema::{Division, Grading, MeshSettings};
use crate::units::{AngleOrLength, Dimension, Expected, Quantity, UnitError};

impl Builder<'_> {
    pub(super) fn mesh(&mut self, format: &SceneFormat) -> MeshSettings {
        let given = &format.mesh;
        if given.layers == Some(0) {
            self.out_of_range("mesh.layers", "0", "at least 1");
        }
        MeshSettings {
            element: given.element,
            division: self.division(given),
            layers: given.layers,
        }
    }

    fn division(&mut self, given: &MeshFormat) -> Division {
        let others = [
            ("fine_to", &given.fine_to),
            ("coarse_spacing", &given.coarse_spacing),
        ];
        match (&given.spacing, &given.angles) {
            (None, Some(angles)) => {
                let angles: Vec<f64> = angles.iter().map(Quantity::value).collect();
                self.angles(given, &angles);
                for (name, _) in others.iter().filter(|(_, value)| value.is_some()) {
                    let message = format!("mesh.{name} has no meaning beside mesh.angles");
                    self.conflict(
                        &format!("mesh.{name}"),
                        message,
                        "give the angles themselves, or spacing instead",
                    );
                }
                self.fits_shapes("mesh.angles", "a list of angles", Dimension::Angle);
                Division::AngleList(angles)
            }
            (Some(spacing), None) => self.graded(spacing, others),
            (spacing, _) => {
                let found = if spacing.is_some() { "both" } else { "none" };
                let problem = SceneProblem::OneOf {
                    table: "mesh".to_owned(),
                    choices: "spacing = \"2 deg\", angles = [\"0 deg\", …]".to_owned(),
                    found: found.to_owned(),
                };
                self.report("mesh", Part::Key, problem);
                Division::AngleList(Vec::new())
            }
        }
    }

    fn angles(&mut self, given: &MeshFormat, angles: &[f64]) {
        let texts: Vec<_> = given.angles.iter().flatten().map(Quantity::text).collect();
        if angles.len() < 2 {
            let found = format!("{} angles", angles.len());
            self.out_of_range(
                "mesh.angles",
                &found,
                "at least two, from 0 deg to 180 deg for a half model",
            );
            return;
        }
        for (index, pair) in angles.windows(2).enumerate() {
            if pair[1] <= pair[0] {
                let allowed = format!("greater than the angle before it, {}", texts[index]);
                self.out_of_range(
                    &format!("mesh.angles.{}", index + 1),
                    texts[index + 1],
                    allowed,
                );
            }
        }
        if angles[0] != 0.0 {
            self.out_of_range("mesh.angles.0", texts[0], "0 deg, the bearing point");
        }
        let last = angles.len() - 1;
        // Half an ulp of 2π more than the sum of a table in degrees can miss.
        if angles[last] > TAU * (1.0 + f64::EPSILON) {
            self.out_of_range(
                &format!("mesh.angles.{last}"),
                texts[last],
                "at most 360 deg",
            );
        }
    }

    fn graded(
        &mut self,
        spacing: &Quantity<AngleOrLength>,
        others: [(&str, &Option<Quantity<AngleOrLength>>); 2],
    ) -> Division {
        let dimension = spacing.dimension();
        self.fits_shapes("mesh.spacing", spacing.text(), dimension);
        let fine = self.positive("mesh", "spacing", spacing);
        if dimension == Dimension::Angle && fine > TAU / 8.0 {
            self.out_of_range("mesh.spacing", spacing.text(), "at most 45 deg");
        }
        let [fine_to, coarse_spacing] = others.map(|(name, other)| {
            let other = other.as_ref()?;
            let value = self.positive("mesh", name, other);
            if other.dimension() != dimension {
                let problem = UnitError::WrongDimension {
                    text: other.text().to_owned(),
                    expected: Expected::one(dimension),
                    found: other.dimension(),
                };
                self.report(&format!("mesh.{name}"), Part::Value, problem.into());
            } else if value < fine {
                let allowed = format!("at least mesh.spacing, {}", spacing.text());
                self.out_of_range(&format!("mesh.{name}"), other.text(), allowed);
            }
            Some(value)
        });
        if coarse_spacing.is_some() && fine_to.is_none() {
            self.conflict(
                "mesh.coarse_spacing",
                "mesh.coarse_spacing needs mesh.fine_to, which says from where it holds".to_owned(),
                "add mesh.fine_to, for example fine_to = \"100 deg\"",
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

    /// Round shapes are divided by angles, the others by lengths.
    fn fits_shapes(&mut self, key: &str, text: &str, dimension: Dimension) {
        let wanted = |round: bool| {
            if round {
                Dimension::Angle
            } else {
                Dimension::Length
            }
        };
        let misfit = self
            .bodies
            .iter()
            .find(|(_, body)| wanted(body.shape.is_round()) != dimension);
        let Some((name, body)) = misfit else {
            return;
        };
        let expected = wanted(body.shape.is_round());
        let (name, shape) = (name.clone(), body.shape.name());
        let remedy = match expected {
            Dimension::Angle => {
                "give the spacing of corner nodes on the circle, for example spacing = \"2 deg\""
            }
            _ => {
                "give the spacing of corner nodes on the contact edge, for example spacing = \"0.05 mm\""
            }
        };
        let message = format!(
            "body '{name}' ({shape}) is divided by {}, but {key} = {text} is {}",
            if expected == Dimension::Angle {
                "angles"
            } else {
                "lengths"
            },
            if key == "mesh.angles" {
                "angles"
            } else {
                dimension.with_article()
            },
        );
        self.conflict(key, message, remedy);
    }
}
