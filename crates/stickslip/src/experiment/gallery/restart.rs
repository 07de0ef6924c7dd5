//! An experiment file that reads synthetic pictures back as a user would read measured ones.

use std::path::Path;

use serde_json::{Map, Value, json};
use stickslip_hybrid::data::Field;

use super::{FOLDER, letter};
use crate::experiment::plan::{Experiment, Fringes, Source};
use crate::experiment::synthesis::{Camera, Shot, file_names};

/// The text of the file, which stands in the result folder.
pub(super) fn text(experiment: &Experiment, camera: &Camera<'_>) -> String {
    let mut root = experiment.spelled();
    root.remove("fringes");
    root.insert(
        "title".to_owned(),
        format!("{}, from its pictures", experiment.title).into(),
    );
    absolute_scene(experiment, &mut root);
    let synthetic = |state: &usize| matches!(experiment.states[*state].source, Source::Step(_));
    let states = (0..experiment.states.len()).filter(synthetic);
    let states = states.map(|state| entry(experiment, camera, state));
    root.insert("states".to_owned(), states.collect());
    let comment = "# The pictures in the folder 'fringes', read as measured ones: `stickslip reduce measured.toml`.\n";
    // The tree came from a file and holds no null, so TOML can spell it.
    let body = toml::to_string(&Value::Object(root)).unwrap_or_default();
    format!("{comment}{body}")
}

/// The result folder may stand anywhere, so the scene is named by its whole path.
fn absolute_scene(experiment: &Experiment, root: &mut Map<String, Value>) {
    let Some(specimen) = root.get_mut("specimen").and_then(Value::as_object_mut) else {
        return;
    };
    if let Some(own) = &experiment.specimen.scene {
        let path = Path::new(&own.scene.source_name);
        let whole = std::path::absolute(path).unwrap_or_else(|_| path.to_owned());
        specimen.insert("scene".to_owned(), whole.display().to_string().into());
    }
}

fn entry(experiment: &Experiment, camera: &Camera<'_>, state: usize) -> Value {
    let plan = &experiment.states[state];
    let mut entry = json!({
        "name": plan.name,
        "direction": plan.direction.name(),
    });
    if let Some(load) = plan.load {
        entry["load"] = format!("{load} N").into();
    }
    let own = pictures(experiment, camera, state, Shot::State);
    entry["pictures"] = own;
    for (key, shot, source) in [
        ("null", Shot::Null, &plan.null),
        ("back", Shot::Back, &plan.back),
    ] {
        if matches!(source, Some(Source::Step(_))) {
            entry[key] = json!({ "pictures": pictures(experiment, camera, state, shot) });
        }
    }
    entry
}

fn pictures(experiment: &Experiment, camera: &Camera<'_>, state: usize, shot: Shot) -> Value {
    let Fringes {
        window,
        pixel,
        carrier,
        ..
    } = camera.fringes();
    let names = |field: Field| {
        let names: Vec<Value> = file_names(experiment, state, shot, field)
            .into_iter()
            .map(|name| format!("{FOLDER}/{name}").into())
            .collect();
        match &names[..] {
            [only] => only.clone(),
            _ => Value::Array(names),
        }
    };
    let per_length = |gradient: [f64; 2]| gradient.map(|value| format!("{value} 1/mm"));
    json!({
        letter(Field::U): names(Field::U),
        letter(Field::V): names(Field::V),
        "pixel": format!("{pixel} mm"),
        "top_left": [format!("{} mm", window[0][0]), format!("{} mm", window[1][1])],
        "y_axis": "up",
        "carrier": { "u": per_length(carrier[0]), "v": per_length(carrier[1]) },
        "dark": 0.0,
    })
}
