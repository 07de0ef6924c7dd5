//! How a joint was followed, in words.

use stickslip_fem_core::QuadraturePoints;

use super::{Subject, crack_band};
use crate::model::Model;
use crate::scene::Scene;
use crate::scene::schema::{Axis, Control, Progressive, ProgressiveModel};

/// How plies lose stiffness.
pub(super) fn model(subject: &Subject<'_>, scene: &Scene, model: &Model) -> String {
    match &subject.asked.model {
        ProgressiveModel::PlyDiscount {
            criterion,
            degradation,
        } => format!(
            "ply discount by {}, failed plies keep {} (fibre) and {} (matrix){}",
            criterion.name(),
            degradation.fibre(),
            degradation.matrix(),
            bands(subject, scene, model).unwrap_or_default()
        ),
        ProgressiveModel::Plasticity { hardening } => {
            let layers = subject.sheet.laminate.layers();
            let shear = layers.first().and_then(|layer| layer.ply().strengths().s12);
            let modulus = hardening * shear.map_or(0.0, |shear| shear * shear);
            format!(
                "Tsai–Hill plasticity, plastic shear modulus {}",
                scene.display.stress.show(modulus)
            )
        }
    }
}

/// Crack bands, and where they are cut off.
fn bands(subject: &Subject<'_>, scene: &Scene, model: &Model) -> Option<String> {
    let ProgressiveModel::PlyDiscount { degradation, .. } = &subject.asked.model else {
        return None;
    };
    let mesh = subject.mesh(model)?;
    let band = crack_band(subject.asked.crack_band?, *degradation, mesh).ok()?;
    let plies = subject.sheet.laminate.layers().iter();
    let own = plies.map(|layer| band.own_length(layer.ply()));
    let own = own.fold(0.0, f64::max);
    let points = QuadraturePoints::of(mesh);
    let cells = points.cell_count();
    let small = (0..cells).filter(|&cell| band.width() * points.cell_area(cell).sqrt() < own);
    let small = small.count();
    Some(if small == 0 {
        ", strengths by fracture energies".to_owned()
    } else {
        format!(
            ", strengths by fracture energies (in {small} of {cells} cells a row is thinner than {}: there some keep the ply's own, and a crack takes \
             less energy)",
            scene.display.length.show(own)
        )
    })
}

/// What is raised.
pub(super) fn control(asked: &Progressive, scene: &Scene) -> String {
    match &asked.control {
        Control::Loads { .. } => "the scene's loads".to_owned(),
        Control::Displacement { on, axis, end, .. } => {
            let axis = match axis {
                Axis::X => "x",
                Axis::Y => "y",
            };
            format!(
                "{on} driven along {axis} to {}",
                scene.display.length.show(*end)
            )
        }
    }
}
