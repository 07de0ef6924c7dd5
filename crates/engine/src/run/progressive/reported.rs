//! What is reported of a joint that was followed.

use stickslip_fem_core::mesh::Mesh;
use stickslip_joint::{Ending, Hole, JointHistory, PlyEventKind};

use super::subject::Subject;
use super::{description, findings};
use crate::model::Model;
use crate::results::{ContactFrame, CurvePoint, PlyLoss, ProgressiveEnd, ProgressiveFailure};

impl Subject<'_> {
    /// What is reported of the joint that was followed on `followed`, instead of the scene's own `model`.
    pub(super) fn reported(
        &self,
        model: &Model,
        followed: &Model,
        history: &JointHistory,
        hole: &Hole,
    ) -> ProgressiveFailure {
        // Energies are those of the modelled part.
        let both = if followed.half { 2.0 } else { 1.0 };
        let curve = history.records.iter().map(|record| CurvePoint {
            step: record.step,
            reached: record.reached,
            displacement: record.displacement,
            load: record.load,
            work: both * record.energy.external,
            dissipated: both * (record.energy.dissipated + record.energy.released),
        });
        let cells = self.mesh(followed).map_or(0, Mesh::element_count);
        ProgressiveFailure {
            model: description::model(self, &model.request),
            control: description::control(self, &model.request),
            curve: curve.collect(),
            peak: history.peak(),
            strength: history.strength(),
            end: match &history.ending {
                Ending::Completed => ProgressiveEnd::Completed,
                Ending::LoadDropped { .. } => ProgressiveEnd::Dropped,
                Ending::Severed { .. } => ProgressiveEnd::Severed,
                Ending::NoEquilibrium { cause, .. } => {
                    ProgressiveEnd::NoEquilibrium(cause.to_string())
                }
            },
            losses: self.losses(history),
            mode: history.mode(self.found.body, hole),
            linear: None,
            edge: Vec::new(),
            cells,
            half: followed.half,
            frame: ContactFrame::NONE,
            free_travel: 0.0,
            findings: findings::of(self, model, followed, &history.records),
        }
    }

    fn losses(&self, history: &JointHistory) -> Vec<PlyLoss> {
        let group = |layer: usize| {
            let mut groups = self.found.plies.iter();
            // Every layer belongs to one group.
            groups
                .position(|group| group.layers.contains(&layer))
                .unwrap_or(0)
        };
        let records = history.records.iter().enumerate();
        let events = records.flat_map(|(increment, record)| {
            let own = record.events.iter();
            own.filter(|event| event.body == self.found.body)
                .map(move |event| (increment, event))
        });
        events
            .map(|(increment, event)| PlyLoss {
                increment,
                ply: group(event.layer),
                layer: event.layer,
                mode: match event.kind {
                    PlyEventKind::Failure(mode) => Some(mode),
                    PlyEventKind::Yield => None,
                },
                position: event.position,
                cell: event.cell,
                load: event.load,
                displacement: event.displacement,
            })
            .collect()
    }
}
