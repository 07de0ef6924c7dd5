//! How a joint was followed, as text.

use super::subject::Subject;
use crate::model::Request;
use stickslip_scene::schema::Control;

/// How plies lose stiffness.
pub(super) fn model(subject: &Subject<'_>, request: &Request) -> String {
    let model = &subject.asked.model;
    let stress = |value: f64| request.units.stress.show(value);
    let described = (model.parameters).describe(model.criterion.name(), &stress);
    match subject.asked.crack_band {
        Some(_) => format!("{described}, strengths by fracture energies"),
        None => described,
    }
}

/// What is raised.
pub(super) fn control(subject: &Subject<'_>, request: &Request) -> String {
    match &subject.asked.control {
        Control::Loads { .. } => "the scene's loads".to_owned(),
        Control::Displacement { on, axis, end, .. } => {
            let names = request.loads.names();
            let replaced: Vec<String> = names.map(|name| format!("'{name}'")).collect();
            let replaced = if replaced.is_empty() {
                String::new()
            } else {
                format!(", in place of {}", replaced.join(", "))
            };
            format!(
                "{on} driven along {} to {}{replaced}",
                axis.name(),
                request.units.length.show(*end)
            )
        }
    }
}
