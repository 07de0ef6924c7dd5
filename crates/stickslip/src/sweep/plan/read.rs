//! From the text of a sweep file to a checked sweep.

use std::path::Path;

use miette::Diagnostic as _;
use serde_json::Value;

use super::problem::{conflict, unknown};
use super::{Base, Sweep, VERSION, joint};
use crate::sweep::axis::{Axis, AxisKey, between};
use crate::sweep::format::{AxisFormat, MapFormat, SweepFormat};
use stickslip_engine::model::LoadTable;
use stickslip_engine::results::LoadScale;
use stickslip_scene::diagnostic::{SceneError, SceneProblem, SourceText};
use stickslip_scene::digest::sha256;
use stickslip_scene::document::{Document, Part};
use stickslip_scene::host::Host;
use stickslip_scene::limits::Content;
use stickslip_scene::units::Dimension;
use stickslip_scene::{Format, open};

/// Most values of an axis given by its ends, and most cases.
const LONGEST_AXIS: usize = 10_000;
const MOST_CASES: usize = 1_000_000;

pub(super) fn sweep(
    source: SourceText,
    format: Format,
    folder: &Path,
    overrides: Vec<String>,
    host: Host,
) -> Result<Sweep, SceneError> {
    let source_name = source.name.clone();
    let none: [&str; 0] = [];
    let document = open::document(source, format, &none, host)?;
    open::check_version(&document, "sweep", VERSION)?;
    let read: SweepFormat = open::keys(&document)?;
    let base = base(&document, &read.scene, folder, overrides)?;
    let scene = base.scene(&[])?;
    joint::follows_nothing(&scene, &document, "scene")?;
    let axes = axes(&document, &read.axes)?;
    let contact = joint::contact(&scene, &read.joint, &document)?;
    let criterion = joint::criterion(&scene, &read.joint, &document)?;
    let pair = &scene.contacts[contact];
    let loads = LoadTable::of_contact(&scene, contact);
    let steps: Vec<_> = (0..loads.steps()).map(|step| loads.at_step(step)).collect();
    let unit = LoadScale::unit_of(&steps, scene.display);
    let sweep = Sweep {
        title: read.title.unwrap_or_else(|| open::stem(&source_name)),
        description: read.description,
        map: map(&document, &read.map, &axes)?,
        hash: hash(&scene.hash, &axes, contact, criterion.as_deref()),
        plate_index: scene
            .bodies
            .keys()
            .position(|name| *name == pair.first.body),
        plate: pair.first.body.clone(),
        pin: pair.second.body.clone(),
        source_name,
        axes,
        contact,
        load_unit: unit.unwrap_or_else(|| scene.display.force.name.to_owned()),
        criterion,
        scene,
        base,
        document,
    };
    check(&sweep)?;
    Ok(sweep)
}

fn base(
    document: &Document,
    scene: &str,
    folder: &Path,
    overrides: Vec<String>,
) -> Result<Base, SceneError> {
    let path = folder.join(scene);
    let name = path.display().to_string();
    let text = document.host.read_text(&path, Content::Document);
    let text = text.map_err(|error| {
        let message = format!("the scene file '{name}' cannot be read: {error}");
        let remedy = "the path is relative to the folder of the sweep file";
        conflict(document, "scene", message, remedy)
    })?;
    Ok(Base {
        text,
        format: Format::of_path(&path),
        folder: path.parent().unwrap_or(Path::new("")).to_owned(),
        name,
        overrides,
        host: document.host,
    })
}

fn axes(document: &Document, given: &[AxisFormat]) -> Result<Vec<Axis>, SceneError> {
    if given.is_empty() {
        let problem = SceneProblem::MissingKey {
            key: "axes".to_owned(),
            table: "the sweep".to_owned(),
            example: "[[axes]] key = \"e_over_d\", values = [1.5, 2, 3]".to_owned(),
        };
        return Err(document.error("", Part::Key, problem));
    }
    let mut axes: Vec<Axis> = Vec::new();
    for (index, axis) in given.iter().enumerate() {
        let key = format!("axes.{index}");
        let name = &axis.key;
        if axes.iter().any(|other| other.key.name() == name) {
            let message = format!("there are two axes '{name}'");
            let remedy = "put the values of both into one";
            return Err(conflict(document, &format!("{key}.key"), message, remedy));
        }
        // Keys of a scene that can vary lie in one of its tables.
        if matches!(AxisKey::named(name), AxisKey::Scene(_)) && !name.contains('.') {
            let what = "an axis of a joint, nor a key of the scene (which has a dot)";
            let key = format!("{key}.key");
            return Err(unknown(document, &key, what, name, AxisKey::NAMES));
        }
        let values = values(document, &key, axis)?;
        let axis = Axis::new(AxisKey::named(name), axis.label.clone(), values);
        check_values(document, &key, &axis)?;
        axes.push(axis);
    }
    let cases = axes
        .iter()
        .try_fold(1_usize, |cases, axis| cases.checked_mul(axis.values.len()));
    if cases.is_none_or(|cases| cases > MOST_CASES) {
        let problem = SceneProblem::Conflict {
            message: format!("the product of all axes has more than {MOST_CASES} cases"),
            remedy: "give shorter axes, or several sweeps".to_owned(),
        };
        return Err(document.error("axes", Part::Key, problem));
    }
    Ok(axes)
}

fn values(document: &Document, key: &str, axis: &AxisFormat) -> Result<Vec<Value>, SceneError> {
    let ends = [axis.from.is_some(), axis.to.is_some(), axis.count.is_some()];
    match (&axis.values, &axis.from, &axis.to, axis.count) {
        (Some(values), None, None, None) if values.is_empty() => Err(out_of_range(
            document,
            key,
            "values",
            "[]",
            "at least one value",
        )),
        (Some(values), None, None, None) => Ok(values.clone()),
        (None, Some(from), Some(to), Some(count)) => {
            if !(2..=LONGEST_AXIS).contains(&count) {
                let allowed = format!("from 2 to {LONGEST_AXIS}, or values = [{from}]");
                return Err(out_of_range(
                    document,
                    key,
                    "count",
                    &count.to_string(),
                    &allowed,
                ));
            }
            between(from, to, count).ok_or_else(|| {
                conflict(
                    document,
                    &format!("{key}.from"),
                    format!("there are no steps from {from} to {to}"),
                    "give two numbers, or two quantities of one dimension such as \"0.01 mm\"",
                )
            })
        }
        _ => {
            let names = ["from", "to", "count"].into_iter().zip(ends);
            let given = names.filter(|(_, given)| *given).map(|(name, _)| name);
            let values = axis.values.is_some().then_some("values");
            let found: Vec<&str> = values.into_iter().chain(given).collect();
            let problem = SceneProblem::OneOf {
                table: key.to_owned(),
                choices: "'values' or 'from', 'to' and 'count'".to_owned(),
                found: if found.is_empty() {
                    "none".to_owned()
                } else {
                    found.join(", ")
                },
            };
            Err(document.error(key, Part::Key, problem))
        }
    }
}

fn out_of_range(
    document: &Document,
    table: &str,
    key: &str,
    value: &str,
    allowed: &str,
) -> SceneError {
    let problem = SceneProblem::OutOfRange {
        key: key.to_owned(),
        value: value.to_owned(),
        allowed: allowed.to_owned(),
    };
    document.error(&format!("{table}.{key}"), Part::Value, problem)
}

/// Refuses two axes of which one would overwrite what the other sets.
fn apart(sweep: &Sweep) -> Result<(), SceneError> {
    let chosen: Vec<(usize, usize)> = (0..sweep.axes.len()).map(|axis| (axis, 0)).collect();
    // What is wrong with the values is said of each of them later.
    let Ok(overrides) = sweep.overrides_of(&chosen) else {
        return Ok(());
    };
    let key = |text: &str| format!("{}.", text.split('=').next().unwrap_or(text));
    let keys: Vec<(usize, String)> = (overrides.iter())
        .map(|(axis, text)| (*axis, key(text)))
        .collect();
    for (one, own) in &keys {
        let others = keys.iter().filter(|(axis, _)| axis > one);
        for (other, theirs) in others {
            if own.starts_with(theirs.as_str()) || theirs.starts_with(own.as_str()) {
                let names = [one, other].map(|axis| sweep.axes[*axis].key.name());
                let message = format!(
                    "the axes '{}' and '{}' both set {}",
                    names[0],
                    names[1],
                    own.trim_end_matches('.')
                );
                let remedy = "leave one of them out";
                let place = format!("axes.{other}.key");
                return Err(conflict(&sweep.document, &place, message, remedy));
            }
        }
    }
    Ok(())
}

/// Named axes have values of their own kind; those of scene keys are the scene's matter.
fn check_values(document: &Document, key: &str, axis: &Axis) -> Result<(), SceneError> {
    let (allowed, least) = match axis.key {
        AxisKey::EndDistance => (
            "a number of more than 0.5, where the end is at the hole's edge",
            0.5,
        ),
        AxisKey::Width => (
            "a number of more than 1, where the sides are at the hole's edge",
            1.0,
        ),
        AxisKey::Friction => ("a number of at least 0", f64::NEG_INFINITY),
        AxisKey::Clearance => ("a length, such as \"0.01 mm\"", f64::NEG_INFINITY),
        AxisKey::LayUp | AxisKey::Scene(_) => return Ok(()),
    };
    let lengths = axis.key == AxisKey::Clearance;
    for (index, value) in axis.values.iter().enumerate() {
        // Each value by itself, so that the one that is wrong is shown.
        let alone = Axis::new(axis.key.clone(), None, vec![value.clone()]);
        let number = alone.numbers.as_ref().and_then(|numbers| numbers.first());
        let dimension = alone.unit.map(|unit| unit.dimension);
        let kind = dimension == lengths.then_some(Dimension::Length);
        if !(kind && number.is_some_and(|number| *number > least)) {
            let problem = SceneProblem::OutOfRange {
                key: axis.key.name().to_owned(),
                value: value.to_string(),
                allowed: allowed.to_owned(),
            };
            let place = place_of(document, key, index);
            return Err(document.error(&place, Part::Value, problem));
        }
    }
    Ok(())
}

/// Where a value of an axis stands: in its list, or between its ends.
fn place_of(document: &Document, axis: &str, index: usize) -> String {
    let own = format!("{axis}.values.{index}");
    if document.places.contains_key(&own) {
        own
    } else {
        format!("{axis}.from")
    }
}

fn map(
    document: &Document,
    given: &MapFormat,
    axes: &[Axis],
) -> Result<[Option<usize>; 2], SceneError> {
    let known = axes.iter().map(|axis| axis.key.name());
    let named = |name: &Option<String>, key: &str| {
        let found = name.as_ref().map(|name| {
            let found = known.clone().position(|axis| axis == name);
            let what = "an axis of the sweep";
            found.ok_or_else(|| unknown(document, key, what, name, known.clone()))
        });
        found.transpose()
    };
    let (x, y) = (named(&given.x, "map.x")?, named(&given.y, "map.y")?);
    let other = |taken: Option<usize>| (0..axes.len()).find(|axis| Some(*axis) != taken);
    if x.is_some() && x == y {
        let message = "a map has two different axes";
        let remedy = "leave one of the two out";
        return Err(conflict(document, "map.y", message, remedy));
    }
    let x = x.or_else(|| other(y));
    Ok([x, y.or_else(|| other(x))])
}

/// Every value must give a scene, alone or with the first or last values of the other axes.
fn check(sweep: &Sweep) -> Result<(), SceneError> {
    apart(sweep)?;
    for (index, axis) in sweep.axes.iter().enumerate() {
        for value in 0..axis.values.len() {
            let alone = match sweep.scene_with(&[(index, value)]) {
                Ok(scene) => {
                    let place = place_of(&sweep.document, &format!("axes.{index}"), value);
                    joint::follows_nothing(&scene, &sweep.document, &place)?;
                    continue;
                }
                Err(alone) => alone,
            };
            let with = |others: fn(usize) -> usize| {
                let chosen = sweep.axes.iter().enumerate().map(|(other, axis)| {
                    let at = if other == index {
                        value
                    } else {
                        others(axis.values.len())
                    };
                    (other, at)
                });
                sweep.scene_with(&chosen.collect::<Vec<_>>()).is_ok()
            };
            if with(|_| 0) || with(|count| count - 1) {
                continue;
            }
            return Err(refused(sweep, index, value, &alone));
        }
    }
    Ok(())
}

/// What the scene says of a value, at the value.
fn refused(sweep: &Sweep, axis: usize, value: usize, error: &SceneError) -> SceneError {
    let finding = error.findings().first();
    let words = finding.map_or_else(|| error.to_string(), ToString::to_string);
    let help = finding.and_then(|finding| finding.problem.help());
    let problem = SceneProblem::Model {
        message: format!(
            "the scene '{}' refuses {}: {words}",
            sweep.base.name,
            sweep.axes[axis].assignment(value)
        ),
        remedy: help.map_or_else(
            || "`stickslip check` prints every key that a scene has".to_owned(),
            |help| help.to_string(),
        ),
    };
    let document = &sweep.document;
    let key = format!("axes.{axis}");
    let unknown = finding.is_some_and(|finding| {
        matches!(
            finding.problem,
            SceneProblem::UnknownKey { .. }
                | SceneProblem::OverridePath { .. }
                | SceneProblem::OverrideIndex { .. }
        )
    });
    let place = if unknown {
        format!("{key}.key")
    } else {
        place_of(document, &key, value)
    };
    document.error(&place, Part::Value, problem)
}

fn hash(scene: &str, axes: &[Axis], contact: usize, criterion: Option<&str>) -> String {
    let axis = |axis: &Axis| {
        let values = Value::Array(axis.values.clone());
        format!("{}\n{values}\n", axis.key.name())
    };
    let axes: Vec<String> = axes.iter().map(axis).collect();
    sha256(format!(
        "{scene}\n{contact}\n{criterion:?}\n{}",
        axes.concat()
    ))
}
