//! The finite rotation of the specimen, taken off each field before anything else is done with it.

use stickslip_hybrid::data::{Measurement, Places, Rotation};

use super::Scope;
use crate::finding::{FieldFinding, Finding, LineFinding};

/// A rotation of fringes `[rad]` that is kept, as loads alone make it: it strains the field by half of its square, 5e-7, a tenth of what moves
/// friction out of its interval.
const OF_STRAINS: f64 = 1e-3;

/// A rotation of a table that is kept `[rad]`: it changes strains by 1e-5 of them, and taking it off would mix errors of both components.
const NONE: f64 = 1e-5;

/// A rotation that was taken off.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TakenOff {
    /// Whether it is that of the null field.
    pub of_null: bool,
    /// The rotation about the middle of the hole.
    pub rotation: Rotation,
    /// Displacements that are masked, because a rotation mixes both components and the other one is not known.
    pub masked: usize,
}

impl TakenOff {
    /// Angle and standard deviation `[deg]`.
    pub fn degrees(&self) -> [f64; 2] {
        [self.rotation.angle, self.rotation.deviation].map(f64::to_degrees)
    }

    /// What was done, where a reader should know.
    pub(super) fn finding(&self) -> Option<Finding> {
        let [degrees, deviation_degrees] = self.degrees();
        let is_small = self.rotation.angle.abs() <= OF_STRAINS;
        (self.masked > 0 || !is_small).then_some(Finding::Field(FieldFinding::RotationTakenOff {
            degrees,
            deviation_degrees,
            masked: self.masked,
        }))
    }
}

/// Displacements of material points in the frame of the specimen; as they are where a component is missing or nothing has turned.
pub(super) fn of_material(scope: &Scope<'_>, data: Measurement) -> (Measurement, Option<TakenOff>) {
    match data.rotation(Places::Reference) {
        Some(rotation) if rotation.angle.abs() > NONE => {
            taken_off(scope, &data, rotation, Places::Reference)
        }
        _ => (data, None),
    }
}

/// Displacements at places of a picture, which are those after the deformation, where the specimen has turned by more than loads turn it.
pub(super) fn of_picture(scope: &Scope<'_>, data: Measurement) -> (Measurement, Option<TakenOff>) {
    match data.rotation(Places::Deformed) {
        Some(rotation) if rotation.angle.abs() > OF_STRAINS => {
            taken_off(scope, &data, rotation, Places::Deformed)
        }
        _ => (data, None),
    }
}

fn taken_off(
    scope: &Scope<'_>,
    data: &Measurement,
    rotation: Rotation,
    places: Places,
) -> (Measurement, Option<TakenOff>) {
    let centre = scope.experiment.specimen.hole.centre;
    let (turned, masked) = data.turned_back(rotation.angle, centre, places);
    let taken = TakenOff {
        of_null: false,
        rotation,
        masked,
    };
    (turned, Some(taken))
}

/// The rotation of fringe lines of a specimen that has turned: their orders are interpolated along lines, and stay as they are.
pub(super) fn of_lines(data: &Measurement) -> Option<Finding> {
    let angle = data.rotation(Places::Deformed)?.angle;
    let kept = LineFinding::RotationKept {
        degrees: angle.to_degrees(),
        strain: 0.5 * angle * angle,
    };
    (angle.abs() > OF_STRAINS).then_some(Finding::Line(kept))
}
