//! Small scenes of large ones: what is not needed for a failure is deleted, rounded or made coarser as long as the failure stays.

use std::time::{Duration, Instant};

use serde_json::{Value, json};

use super::draw::digits;
use super::quantity::{split, text};

/// The smallest scene found for which `fails` still says so, within `time` and `tries` questions.
pub(super) fn shrink(
    scene: &Value,
    time: Duration,
    tries: usize,
    fails: &mut dyn FnMut(&Value) -> bool,
) -> Value {
    let start = Instant::now();
    let (mut best, mut asked) = (scene.clone(), 0);
    loop {
        let mut smaller = None;
        for candidate in candidates(&best) {
            if asked >= tries || start.elapsed() > time {
                return best;
            }
            asked += 1;
            if fails(&candidate) {
                smaller = Some(candidate);
                break;
            }
        }
        match smaller {
            Some(candidate) => best = candidate,
            None => return best,
        }
    }
}

/// Scenes that are simpler than `scene` by one change each, the largest changes first.
fn candidates(scene: &Value) -> Vec<Value> {
    let mut found = Vec::new();
    for count in [1, 2] {
        found.extend(fewer_steps(scene, count));
    }
    found.extend(without_bushing(scene));
    for key in ["failure", "edges", "output", "title", "analysis", "units"] {
        found.extend(without(scene, &format!("/{key}")));
    }
    for list in ["loads", "supports", "platens", "contacts", "edges"] {
        let length = scene
            .get(list)
            .and_then(Value::as_array)
            .map_or(0, Vec::len);
        for index in 0..length {
            found.extend(without(scene, &format!("/{list}/{index}")));
        }
    }
    found.extend(simpler_laws(scene));
    found.extend(simpler_mesh(scene));
    for path in optional(scene) {
        found.extend(without(scene, &path));
    }
    found.extend(plain_materials(scene));
    for places in [1, 2, 3] {
        found.extend(rounded(scene, places));
    }
    found.retain(|candidate| candidate != scene);
    found
}

/// The scene without what stands at `path`.
fn without(scene: &Value, path: &str) -> Option<Value> {
    let (parent, last) = path.rsplit_once('/')?;
    let mut smaller = scene.clone();
    match smaller.pointer_mut(parent)? {
        Value::Object(map) => map.remove(last).is_some(),
        Value::Array(list) => {
            let index: usize = last.parse().ok()?;
            (index < list.len()).then(|| list.remove(index)).is_some()
        }
        _ => false,
    }
    .then_some(smaller)
}

/// Histories without one of their steps (`count` 1), or with one step alone (2).
fn fewer_steps(scene: &Value, count: usize) -> Vec<Value> {
    let lists = |scene: &mut Value, change: &dyn Fn(&mut Vec<Value>)| {
        for load in super::quantity::list_mut(scene, "loads") {
            let kinds = load
                .as_object_mut()
                .into_iter()
                .flat_map(serde_json::Map::values_mut);
            for kind in kinds {
                if let Some(Value::Array(steps)) = kind.get_mut("steps") {
                    change(steps);
                }
            }
        }
    };
    let mut length = 0;
    for load in super::quantity::list(scene, "loads") {
        let kinds = load
            .as_object()
            .into_iter()
            .flat_map(serde_json::Map::values);
        length = kinds
            .filter_map(|kind| kind.get("steps")?.as_array())
            .map(Vec::len)
            .max()
            .unwrap_or(length);
    }
    if length < 2 {
        return Vec::new();
    }
    (0..length)
        .map(|index| {
            let mut smaller = scene.clone();
            lists(&mut smaller, &|steps| {
                if count == 1 {
                    steps.truncate(index.max(1));
                } else if index < steps.len() {
                    steps.remove(index);
                }
            });
            smaller
        })
        .collect()
}

/// A joint whose pin stands in the plate itself.
fn without_bushing(scene: &Value) -> Option<Value> {
    let contacts = scene.get("contacts")?.as_array()?;
    let outer = contacts.iter().position(|contact| {
        contact["second"]
            .as_str()
            .is_some_and(|set| set.split('.').next_back() == Some("outer"))
    })?;
    let bush = contacts[outer]["second"]
        .as_str()?
        .split('.')
        .next()?
        .to_owned();
    let inner = contacts
        .iter()
        .position(|contact| contact["first"].as_str() == Some(&format!("{bush}.hole")))?;
    let hole = contacts[outer]["first"].clone();
    let radius = |scene: &Value, set: &Value, key: &str| {
        let body = set.as_str()?.split('.').next()?.to_owned();
        Some((
            format!("/bodies/{body}/shape/{key}"),
            scene["bodies"][&body]["shape"]
                .pointer(&format!("/{key}"))?
                .clone(),
        ))
    };
    let (_, plate) = radius(scene, &hole, "plate_with_hole/hole_radius")?;
    let (_, own) = radius(
        scene,
        &contacts[inner]["first"],
        "plate_with_hole/hole_radius",
    )?;
    let (place, pin) = radius(scene, &contacts[inner]["second"], "disk/radius")?;
    let [plate, own, pin] = [plate, own, pin]
        .map(|radius| split(radius.as_str().unwrap_or_default()).map(|(value, _)| value));
    let mut smaller = scene.clone();
    *smaller.pointer_mut(&place)? = text(digits(plate? * pin? / own?, 9), "mm");
    smaller["contacts"][inner]["first"] = hole;
    smaller["contacts"].as_array_mut()?.remove(outer);
    smaller["bodies"].as_object_mut()?.remove(&bush);
    smaller["materials"].as_object_mut()?.remove(&bush);
    let elsewhere = |load: &Value| {
        load["on"]
            .as_str()
            .is_some_and(|on| on.split('.').next() != Some(&bush))
    };
    smaller["loads"].as_array_mut()?.retain(elsewhere);
    Some(smaller)
}

fn simpler_laws(scene: &Value) -> Vec<Value> {
    let mut found = Vec::new();
    let count = scene
        .get("contacts")
        .and_then(Value::as_array)
        .map_or(0, Vec::len);
    for index in 0..count {
        for law in [
            json!({ "coulomb": { "mu": 0.0 } }),
            json!({ "coulomb": { "mu": 0.3 } }),
        ] {
            let coulomb = scene["contacts"][index]["friction"]
                .get("coulomb")
                .is_some();
            if coulomb && law["coulomb"]["mu"] != 0.0 {
                continue;
            }
            let mut smaller = scene.clone();
            smaller["contacts"][index]["friction"] = law;
            found.push(smaller);
        }
        for part in ["fibre", "matrix"] {
            let path = format!("/contacts/{index}/friction/fibre_coverage/{part}");
            if let Some(law) = scene.pointer(&path) {
                let mut smaller = scene.clone();
                smaller["contacts"][index]["friction"] = law.clone();
                found.push(smaller);
            }
        }
    }
    found
}

fn simpler_mesh(scene: &Value) -> Vec<Value> {
    let mut found = Vec::new();
    for (key, values) in [
        ("element", &["Q4", "Q8"][..]),
        ("spacing", &["45 deg", "30 deg", "15 deg", "10 deg"]),
    ] {
        for value in values {
            let mut smaller = scene.clone();
            let Some(own) = smaller["mesh"].get(key).and_then(Value::as_str) else {
                continue;
            };
            let coarser = match (split(own), split(value)) {
                (Some((own, "deg")), Some((new, "deg"))) => new > own,
                (Some(_), _) => false,
                (None, _) => true,
            };
            if coarser {
                smaller["mesh"][key] = json!(value);
                found.push(smaller);
            }
        }
    }
    found
}

/// Every material isotropic, one at a time.
fn plain_materials(scene: &Value) -> Vec<Value> {
    let own = super::quantity::table(scene, "materials");
    own.filter(|(_, material)| material.get("isotropic").is_none())
        .map(|(name, material)| {
            let mut smaller = scene.clone();
            smaller["materials"][name] = json!({ "isotropic": { "young": "70000 MPa", "poisson": 0.3, "expansion": "2e-5 1/K" } });
            if material.get("laminate").is_some() {
                let bodies = smaller["bodies"].as_object_mut().into_iter().flat_map(|bodies| bodies.values_mut());
                for body in bodies.filter(|body| body["material"] == name.as_str()) {
                    body["thickness"] = text(1.0, "mm");
                }
            }
            smaller
        })
        .collect()
}

/// Paths of keys that have defaults.
fn optional(scene: &Value) -> Vec<String> {
    const KEYS: [&str; 22] = [
        "fine_to",
        "coarse_spacing",
        "layers",
        "mesh",
        "gap",
        "projection",
        "expansion",
        "expansion1",
        "expansion2",
        "cure",
        "angle",
        "plane",
        "model",
        "solver",
        "substeps",
        "ramp",
        "displacement",
        "path",
        "transition",
        "strengths",
        "plies",
        "name",
    ];
    fn walk(value: &Value, path: &str, found: &mut Vec<String>) {
        match value {
            Value::Object(map) => {
                for (key, entry) in map {
                    let here = format!("{path}/{key}");
                    if KEYS.contains(&key.as_str()) && !path.is_empty() || here == "/plies" {
                        found.push(here.clone());
                    }
                    walk(entry, &here, found);
                }
            }
            Value::Array(list) => {
                for (index, entry) in list.iter().enumerate() {
                    walk(entry, &format!("{path}/{index}"), found);
                }
            }
            _ => {}
        }
    }
    let mut found = Vec::new();
    walk(scene, "", &mut found);
    found
}

/// Every number of at least one more digit rounded to `places`, all at once and one at a time.
fn rounded(scene: &Value, places: i32) -> Vec<Value> {
    fn numbers(value: &Value, path: &str, found: &mut Vec<String>) {
        match value {
            Value::Object(map) => map
                .iter()
                .for_each(|(key, entry)| numbers(entry, &format!("{path}/{key}"), found)),
            Value::Array(list) => {
                list.iter()
                    .enumerate()
                    .for_each(|(index, entry)| numbers(entry, &format!("{path}/{index}"), found));
            }
            Value::Number(_) | Value::String(_) => found.push(path.to_owned()),
            _ => {}
        }
    }
    let shorter = |value: &Value| match value {
        Value::Number(number) => number
            .as_f64()
            .filter(|_| number.is_f64())
            .map(|number| json!(digits(number, places))),
        Value::String(quantity) => {
            split(quantity).map(|(number, unit)| text(digits(number, places), unit))
        }
        _ => None,
    };
    let mut paths = Vec::new();
    numbers(scene, "", &mut paths);
    let (mut all, mut found) = (scene.clone(), Vec::new());
    for path in &paths {
        let Some(new) = scene.pointer(path).and_then(shorter) else {
            continue;
        };
        if scene.pointer(path) == Some(&new) {
            continue;
        }
        if let Some(place) = all.pointer_mut(path) {
            *place = new.clone();
        }
        let mut one = scene.clone();
        if let Some(place) = one.pointer_mut(path) {
            *place = new;
        }
        found.push(one);
    }
    found.insert(0, all);
    found
}
