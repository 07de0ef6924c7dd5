//! Failure envelopes of a body's laminate.

use stickslip_laminate::FailureCriterion;
use stickslip_laminate::failure::{EnvelopeEvent, EnvelopePlane as ForcePlane, failure_envelope};

use super::{RunError, Subject};
use crate::results::{Envelope, EnvelopePoint, PlyGroup};
use stickslip_scene::schema::{EnvelopePlane, Envelopes};

impl Subject<'_> {
    pub(super) fn envelopes(&self, asked: &Envelopes) -> Result<Vec<Envelope>, RunError> {
        let events = std::iter::once((false, EnvelopeEvent::First)).chain(
            asked
                .last_ply
                .map(|degradation| (true, EnvelopeEvent::Last(degradation))),
        );
        let mut found = Vec::new();
        for (last_ply, event) in events {
            for &plane in &asked.planes {
                for criterion in self.criteria() {
                    found.push(self.envelope(
                        plane,
                        criterion,
                        asked.directions,
                        event,
                        last_ply,
                    )?);
                }
            }
        }
        Ok(found)
    }

    fn envelope(
        &self,
        plane: EnvelopePlane,
        criterion: &dyn FailureCriterion,
        directions: usize,
        event: EnvelopeEvent,
        last_ply: bool,
    ) -> Result<Envelope, RunError> {
        let forces = match plane {
            EnvelopePlane::Normal => ForcePlane::NormalNormal,
            EnvelopePlane::Shear => ForcePlane::NormalShear,
        };
        let laminate = &self.sheet.laminate;
        let points = failure_envelope(
            laminate,
            forces,
            directions,
            self.sheet.cure,
            criterion,
            event,
        )
        .map_err(|cause| self.asked(cause))?;
        let group = |layer: usize| {
            let holds = |group: &PlyGroup| group.layers.contains(&layer);
            // Every layer belongs to one group.
            self.plies.shown().iter().position(holds).unwrap_or(0)
        };
        Ok(Envelope {
            plane,
            criterion: criterion.name(),
            last_ply,
            points: points
                .into_iter()
                .map(|point| EnvelopePoint {
                    stress: point.force.map(|force| force / laminate.thickness()),
                    ply: group(point.ply.layer),
                    mode: point.ply.assessment.mode,
                })
                .collect(),
        })
    }
}
