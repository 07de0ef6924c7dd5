//! A commented experiment to start from.

use stickslip_scene::templates::Template;

/// All templates of experiments.
pub const TEMPLATES: [Template; 1] = [Template {
    name: "experiment",
    summary: "measured displacements around a hole, from a table of your own, with a sample",
    text: include_str!("templates/experiment.toml"),
    data: &[("experiment.csv", include_str!("templates/experiment.csv"))],
}];
