//! How a joint was followed, in words.

use super::Subject;
use crate::scene::Scene;
use crate::scene::schema::{Control, Progressive, ProgressiveModel};

/// How plies lose stiffness.
pub(super) fn model(subject: &Subject<'_>, scene: &Scene) -> String {
    match &subject.asked.model {
        ProgressiveModel::PlyDiscount {
            criterion,
            degradation,
        } => format!(
            "ply discount by {}, failed plies keep {} (fibre) and {} (matrix){}",
            criterion.name(),
            degradation.fibre(),
            degradation.matrix(),
            subject
                .asked
                .crack_band
                .map_or("", |_| ", strengths by fracture energies")
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

/// What is raised.
pub(super) fn control(asked: &Progressive, scene: &Scene) -> String {
    match &asked.control {
        Control::Loads { .. } => "the scene's loads".to_owned(),
        Control::Displacement { on, axis, end, .. } => {
            let replaced: Vec<String> = (scene.loads.iter())
                .map(|load| format!("'{}'", load.name))
                .collect();
            let replaced = if replaced.is_empty() {
                String::new()
            } else {
                format!(", in place of {}", replaced.join(", "))
            };
            format!(
                "{on} driven along {} to {}{replaced}",
                axis.name(),
                scene.display.length.show(*end)
            )
        }
    }
}
