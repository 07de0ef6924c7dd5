//! How a joint was followed, as text.

use super::Subject;
use stickslip_scene::Scene;
use stickslip_scene::schema::{Control, Progressive};

/// How plies lose stiffness.
pub(super) fn model(subject: &Subject<'_>, scene: &Scene) -> String {
    let model = &subject.asked.model;
    let stress = |value: f64| scene.display.stress.show(value);
    let described = (model.parameters).describe(model.criterion.name(), &stress);
    match subject.asked.crack_band {
        Some(_) => format!("{described}, strengths by fracture energies"),
        None => described,
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
