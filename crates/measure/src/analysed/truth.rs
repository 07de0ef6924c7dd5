//! What a synthetic state's edge really carries.

use crate::truth::Truth;
use stickslip_engine::results::EdgeKind;
use stickslip_experiment::{Experiment, Source};

/// Stresses of the scene's solution at a place of the edge.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TruePlace {
    /// Angle `[rad]`.
    pub angle: f64,
    /// Pressure, shear τ_rθ and hoop stress `[MPa]`.
    pub stresses: [f64; 3],
}

/// The true edge of a synthetic state, ascending in angle; nothing of a measured one, or of an edge that the scene does not report.
pub fn true_edge(experiment: &Experiment, truth: Option<&Truth>, state: usize) -> Vec<TruePlace> {
    let (Some(truth), Source::Step(step)) = (truth, &experiment.states[state].source) else {
        return Vec::new();
    };
    let Some(own) = &experiment.specimen.scene else {
        return Vec::new();
    };
    let radius = experiment.specimen.hole.radius;
    let is_hole = |kind: &EdgeKind| match kind {
        EdgeKind::Circle { radius: found, .. } => (found / radius - 1.0).abs() < 1e-9,
        EdgeKind::Line | EdgeKind::Path => false,
    };
    let edges = &truth.results.edges;
    let index = edges
        .iter()
        .position(|edge| Some(edge.body) == own.index() && is_hole(&edge.kind));
    let (Some(index), Some(found)) = (index, truth.results.steps.get(*step)) else {
        return Vec::new();
    };
    let rows = edges[index].parameter.iter().zip(&found.edges[index].rows);
    let mut places: Vec<TruePlace> = rows
        .map(|(&angle, row)| TruePlace {
            angle,
            stresses: [-row.sigma_normal, row.tau, row.sigma_tangential],
        })
        .collect();
    if edges[index].half {
        let mirrored: Vec<TruePlace> = (places.iter())
            .filter(|place| place.angle > 0.0)
            .map(|place| TruePlace {
                angle: -place.angle,
                stresses: [place.stresses[0], -place.stresses[1], place.stresses[2]],
            })
            .collect();
        places.extend(mirrored);
        places.sort_by(|a, b| a.angle.total_cmp(&b.angle));
    }
    places
}
