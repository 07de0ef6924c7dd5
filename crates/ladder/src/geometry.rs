//! What a ladder finds out about the geometry on which contact is found.

use super::along::Along;
use super::motions::Motions;
use super::numbers::{Estimates, Numbers, Table, difference, zipped};
use stickslip_engine::model::ModelError;
use stickslip_engine::results::{Bounded, Choice, Results};
use stickslip_engine::run::RunError;
use stickslip_scene::Scene;
use stickslip_scene::schema::KinematicsChoice;

/// The difference on one model is off by this factor at most.
const FACTOR: f64 = 1.5;

/// The geometry that was chosen, where it was left to the program.
#[derive(Default)]
pub(super) struct Geometry {
    /// What the deformed geometry would change, where contact is found on the undeformed one.
    pub(super) errors: Estimates,
    /// The same at the nodes of edges.
    pub(super) along: Along,
    /// Why it was chosen, as the reason of a choice; empty where the scene chose.
    pub(super) reason: String,
    /// Whether the deformed one was chosen.
    pub(super) is_chosen_deformed: bool,
    /// Why nothing is known of the deformed one, which has a model.
    pub(super) failed: Option<String>,
    /// Why the deformed one has no model.
    pub(super) left_out: Option<String>,
}

impl Geometry {
    /// The undeformed geometry, because of `why` nothing is known of the deformed one.
    pub(super) fn unknown(why: &RunError) -> Self {
        let fails =
            why.contact().is_some() || matches!(why, RunError::Model(ModelError::Generate { .. }));
        Self {
            reason: format!("no error states what deformed gaps would change: {why}"),
            failed: fails.then(|| why.to_string()),
            left_out: (!fails).then(|| why.to_string()),
            ..Self::default()
        }
    }

    /// The geometry that is not the program's choice: errors leave out what deformed gaps would change where `scene` does not say so itself.
    pub(super) fn given(scene: &Scene) -> Self {
        let is_said = scene.analysis.kinematics.is_some();
        if is_said || scene.kinematics() != KinematicsChoice::Small {
            return Self::default();
        }
        let why = if scene.fasteners.is_empty() {
            "analysis.kinematics is \"small\" where a mesh is given; say \"auto\" for errors that contain it, or \"small\" to leave it out"
        } else {
            "with fasteners contact is found on the undeformed geometry; say analysis.kinematics = \"small\" to leave it out"
        };
        Self {
            left_out: Some(why.into()),
            ..Self::default()
        }
    }

    /// What deformed gaps may change, by the difference that they make on one model.
    pub(super) fn renew(&mut self, small: &Numbers, deformed: &Numbers) {
        let difference = difference(deformed, small);
        self.errors = Estimates {
            numbers: zipped(&difference, &Table::new(), |error, _| Some(FACTOR * error?)),
            sets: Motions::between(&small.sets, &deformed.sets).times(FACTOR),
        };
        self.along = Along::between(small, deformed).times(FACTOR);
    }

    /// Why a geometry is chosen, by the largest change that the deformed one makes.
    pub(super) fn reason(worst: Option<(f64, Bounded)>, matters: bool) -> String {
        let Some((error, number)) = worst else {
            return "deformed gaps change no number that an accuracy bounds".into();
        };
        let changes = format!(
            "deformed gaps change the {} by {:.2} %",
            number.describe(),
            100.0 * error
        );
        if matters {
            format!("{changes}, which matters to the accuracy")
        } else {
            format!("{changes}, which the stated errors contain")
        }
    }

    /// Puts the reason among the choices of `found`.
    pub(super) fn explain(&self, found: &mut Results) {
        let mut choices = found.choices.iter_mut();
        let choice = choices.find(|choice| choice.what == Choice::KINEMATICS);
        if let Some(choice) = choice.filter(|_| !self.reason.is_empty()) {
            choice.reason.clone_from(&self.reason);
        }
    }
}
