//! An experiment file that reads synthetic pictures back as a user would read measured ones.

use std::path::Path;

use serde_json::{Map, Value, json};
use stickslip_hybrid::data::Field;

use super::{FOLDER, letter};
use stickslip_experiment::{Experiment, Fringes, RegionShape, Source};
use stickslip_measure::synthesis::{Camera, Shot, file_names};
use stickslip_scene::host::System;

/// The text of the file, which will stand in the result folder `folder`.
///
/// # Errors
/// What TOML cannot spell.
pub(super) fn text(
    experiment: &Experiment,
    camera: &Camera<'_>,
    folder: &Path,
) -> Result<String, toml::ser::Error> {
    let mut root = experiment.spelled();
    root.remove("fringes");
    root.insert(
        "title".to_owned(),
        format!("{}, from its pictures", experiment.title).into(),
    );
    paths(experiment, folder, &mut root);
    // Absent where every load step is a state.
    let spelled = root.remove("states").unwrap_or_default();
    let states = (0..experiment.states.len()).map(|state| {
        let spelled = spelled.get(state).cloned().unwrap_or_default();
        entry(experiment, camera, folder, state, &spelled)
    });
    root.insert("states".to_owned(), states.collect());
    let comment = "# The pictures in the folder 'fringes', read as measured ones: `stickslip reduce measured.toml`. What was measured before is\n\
                   # read from where it is.\n";
    let body = toml::to_string(&Value::Object(root))?;
    Ok(format!("{comment}{body}"))
}

/// Files that the experiment names, as they are found from the result folder: all may be moved together.
fn paths(experiment: &Experiment, folder: &Path, root: &mut Map<String, Value>) {
    let mut name = |keys: [&str; 2], file: Option<&str>, path: &Path| {
        let mut table = root.get_mut(keys[0]).and_then(Value::as_object_mut);
        if let Some(file) = file {
            table = table
                .and_then(|table| table.get_mut(file))
                .and_then(Value::as_object_mut);
        }
        if let Some(table) = table {
            let seen = seen_from(experiment.host().system, folder, path);
            table.insert(keys[1].to_owned(), seen.into());
        }
    };
    if let Some(own) = &experiment.specimen.scene {
        name(
            ["specimen", "scene"],
            None,
            Path::new(&own.scene.source_name),
        );
    }
    let shape = experiment.region.as_ref().map(|region| &region.shape);
    if let Some(RegionShape::Mesh(mesh)) = shape {
        name(["region", "file"], Some("mesh"), &mesh.file);
    }
}

/// A path as it is found from a folder: over the folders that both are in, with slashes, or whole where there is none.
fn seen_from(system: &dyn System, folder: &Path, path: &Path) -> String {
    let whole = |path: &Path| {
        let whole = system.whole_path(path);
        whole.unwrap_or_else(|_| path.to_owned())
    };
    let (folder, path) = (whole(folder), whole(path));
    let [from, to] = [&folder, &path].map(|path| path.components().collect::<Vec<_>>());
    let common = from.iter().zip(&to).take_while(|(a, b)| a == b).count();
    // An absolute path begins with its root: without a common one, as of drives, there is no way between them.
    if common == 0 {
        return path.display().to_string();
    }
    let up = from[common..].iter().map(|_| "..".to_owned());
    let down = to[common..]
        .iter()
        .map(|part| part.as_os_str().to_string_lossy().into_owned());
    up.chain(down).collect::<Vec<_>>().join("/")
}

/// A state: its synthetic pictures by their files, all else as it was spelled.
fn entry(
    experiment: &Experiment,
    camera: &Camera<'_>,
    folder: &Path,
    state: usize,
    spelled: &Value,
) -> Value {
    let plan = &experiment.states[state];
    let mut entry = if plan.source.is_synthetic() {
        let mut entry = json!({
            "name": plan.name,
            "direction": plan.direction.name(),
        });
        if let Some(load) = plan.load {
            entry["load"] = format!("{load} N").into();
        }
        for (axis, force) in ["x", "y"].into_iter().zip(plan.edge_force) {
            if let Some(force) = force {
                entry["edge_force"][axis] = format!("{force} N").into();
            }
        }
        entry["pictures"] = pictures(experiment, camera, state, Shot::State);
        entry
    } else {
        moved(experiment, folder, spelled)
    };
    for (key, shot, source) in [
        ("null", Shot::Null, &plan.null),
        ("back", Shot::Back, &plan.back),
    ] {
        match source {
            Some(Source::Step(_)) => {
                entry[key] = json!({ "pictures": pictures(experiment, camera, state, shot) });
            }
            Some(_) => entry[key] = moved(experiment, folder, &spelled[key]),
            None => (),
        }
    }
    entry
}

/// Data as they were spelled, their files named from the result folder.
fn moved(experiment: &Experiment, folder: &Path, spelled: &Value) -> Value {
    let name = |value: &mut Value| {
        if let Some(file) = value.as_str() {
            let path = experiment.folder.join(file);
            *value = seen_from(experiment.host().system, folder, &path).into();
        }
    };
    let mut data = spelled.clone();
    for (way, key) in [
        ("table", "file"),
        ("pictures", "u"),
        ("pictures", "v"),
        ("lines", "u"),
        ("lines", "v"),
    ] {
        match data.get_mut(way).and_then(|data| data.get_mut(key)) {
            Some(Value::Array(files)) => files.iter_mut().for_each(name),
            Some(file) => name(file),
            None => (),
        }
    }
    data
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

#[cfg(test)]
mod tests {
    use super::*;
    use stickslip_scene::host::Host;

    #[test]
    fn paths_lead_from_the_folder_to_the_file() {
        for (folder, path, expected) in [
            ("/a/b/results", "/a/b/scene.toml", "../scene.toml"),
            (
                "/a/b/results",
                "/a/scenes/pin/scene.toml",
                "../../scenes/pin/scene.toml",
            ),
            ("/a/results", "/a/results/scene.toml", "scene.toml"),
        ] {
            let system = Host::NONE.system;
            let found = seen_from(system, Path::new(folder), Path::new(path));
            assert_eq!(found, expected);
        }
    }
}
