//! Progressive failure of a joint as a reader wants it: what failed first, what the joint bore, how it failed and why.

pub(super) mod csv_files;
pub(super) mod figures;
mod maps;
mod reasons;
pub(super) mod summary;
pub(super) mod tables;

pub(super) use maps::damage_map;

use super::failure::FailureView;
use super::findings::joint_sentence;
use stickslip_results::{PlyLoss, ProgressiveFailure};
use stickslip_text::significant;

/// A followed joint with what a reader needs around it.
#[derive(Clone, Copy)]
pub(super) struct ProgressiveView<'a> {
    pub(super) progressive: &'a ProgressiveFailure,
    pub(super) failure: FailureView<'a>,
}

impl<'a> ProgressiveView<'a> {
    /// That of a body, if the scene asks for it.
    pub(super) fn of(failure: FailureView<'a>) -> Option<Self> {
        let progressive = failure.failure.progressive.as_ref()?;
        Some(Self {
            progressive,
            failure,
        })
    }

    pub(super) fn force(&self, force: f64) -> f64 {
        self.failure.results.units.force.from_base(force)
    }

    /// "812 lbf".
    fn load_text(&self, load: f64) -> String {
        let load = significant(self.force(load), 4);
        format!("{load} {}", self.force_unit())
    }

    pub(super) fn force_unit(&self) -> &'static str {
        self.failure.results.units.force.name
    }

    pub(super) fn length_unit(&self) -> &'static str {
        self.failure.results.units.length.name
    }

    /// What the scene asks for and the joint has less of, as sentences.
    fn notes(&self) -> Vec<String> {
        let findings = self.progressive.findings.iter();
        findings
            .map(|finding| joint_sentence(finding, self.failure.results.units))
            .collect()
    }

    /// Angle `[degree]` from the bearing point of the joint and radius in display units of a place about the hole.
    fn polar(&self, position: [f64; 2]) -> Option<[f64; 2]> {
        let (angle, radius) = self.failure.failure.polar_from_x(position)?;
        let angle = self.progressive.frame.turned(angle);
        Some([angle.to_degrees(), self.failure.length(radius)])
    }
}

/// "matrix, tension", or that it flows.
fn mode_name(loss: &PlyLoss) -> String {
    loss.mode
        .map_or_else(|| "flows".to_owned(), |mode| mode.to_string())
}
