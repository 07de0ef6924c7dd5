//! What an experiment says, and whether its data are there and cover its region.

use stickslip_hybrid::data::Field;

use super::findings::line;
use super::measured::signs;
use stickslip_experiment::{Experiment, RegionShape, Source};
use stickslip_measure::ExperimentError;
use stickslip_measure::analysed::Workbench;
use stickslip_measure::finding::{Level, Located, ignored_keys};
use stickslip_measure::measured::{self, Measured};
use stickslip_measure::synthesis::Shots;
use stickslip_text::short;

/// What an experiment says.
#[derive(Clone, Debug, PartialEq)]
pub struct Checked {
    /// Lines for a reader, each a name and a text.
    pub lines: Vec<(&'static str, String)>,
    /// Findings on the data; the warnings among them are lines too.
    pub findings: Vec<Located>,
}

/// Reads all data that are files, and meshes the region. Synthetic states are not solved.
///
/// # Errors
/// [`ExperimentError`]: files that cannot be read, invalid data or data that do not cover the region, a region that cannot be analysed.
pub fn check(experiment: &Experiment) -> Result<Checked, ExperimentError> {
    let mut lines = vec![
        (
            "experiment",
            format!("{} – {}", experiment.source_name, experiment.title),
        ),
        ("specimen", specimen(experiment)),
    ];
    let mut findings = ignored_keys(experiment);
    let mut fields = Vec::new();
    for (index, state) in experiment.states.iter().enumerate() {
        let mut sources = [&state.null, &state.back].into_iter().flatten();
        let is_synthetic = |source: &Source| matches!(source, Source::Step(_));
        if is_synthetic(&state.source) || sources.any(is_synthetic) {
            let text = format!(
                "{}: synthetic pictures of the scene, not made here",
                state.name
            );
            lines.push(("state", text));
            continue;
        }
        let found = measured::state(experiment, index, &Shots::default())?;
        lines.push(("state", of_state(experiment, &found)));
        findings.extend(found.located(experiment));
        fields.push(found);
    }
    findings.extend(measured::repeated(experiment, &fields));
    let signs = signs(experiment).into_iter();
    lines.extend(signs.map(|(names, signs)| ("signs", format!("{names}: {signs}"))));
    if let Some(region) = &experiment.region {
        Workbench::new(experiment)?;
        let text = match &region.shape {
            RegionShape::Sector(sector) => format!(
                "sector of {} x {} cells from {} to {} deg, out to {}",
                sector.cells[0],
                sector.cells[1],
                short(sector.angles[0].to_degrees()),
                short(sector.angles[1].to_degrees()),
                experiment.display.length.show(sector.outer)
            ),
            RegionShape::Mesh(mesh) => format!("mesh '{}'", mesh.file.display()),
        };
        lines.push(("region", text));
    }
    let warnings = findings
        .iter()
        .filter(|own| own.finding.level() == Level::Warning);
    lines.extend(warnings.map(|own| ("warning", line(experiment, own))));
    lines.push(("next", next(experiment)));
    lines.push(("hash", experiment.hash.clone()));
    Ok(Checked { lines, findings })
}

fn specimen(experiment: &Experiment) -> String {
    let (own, length) = (&experiment.specimen, experiment.display.length);
    let hole = own.hole;
    let of_scene = own.scene.as_ref().map_or_else(String::new, |scene| {
        format!("body '{}' of '{}', ", scene.body, scene.scene.source_name)
    });
    format!(
        "{of_scene}{} thick, hole of radius {} around ({}, {})",
        length.show(own.thickness),
        length.show(hole.radius),
        length.show(hole.centre[0]),
        length.show(hole.centre[1])
    )
}

fn of_state(experiment: &Experiment, found: &Measured) -> String {
    let state = &experiment.states[found.state];
    let names: Vec<String> = (state.source.files().iter())
        .map(|file| format!("'{}'", file.display()))
        .collect();
    let data = &found.measurement;
    let unit = experiment.display.length;
    let shown = |value: f64| format!("{} {}", short(unit.from_base(value)), unit.name);
    let fields = Field::BOTH.map(|field| match data.count(field) {
        0 => format!("no {}", field.name()),
        count => format!(
            "{} valid at {count}, ± {}",
            field.name(),
            shown(data.deviation[field.component()])
        ),
    });
    let null = if state.null.is_some() {
        ", the null field taken off"
    } else {
        ""
    };
    format!(
        "{} ({}): {}: {} places, {}, {}{null}",
        state.name,
        state.direction.name(),
        names.join(", "),
        data.places.len(),
        fields[0],
        fields[1]
    )
}

fn next(experiment: &Experiment) -> String {
    let file = &experiment.source_name;
    if experiment.region.is_some() {
        format!(
            "`stickslip hybrid {file}` for edge stresses, `stickslip identify {file}` for friction"
        )
    } else {
        format!("`stickslip reduce {file}` for measured fields; edge stresses need a [region]")
    }
}
