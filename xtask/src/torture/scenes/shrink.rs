//! Small scenes of large ones: what is not needed for a failure is deleted, rounded or made coarser as long as the failure stays.

use std::collections::BTreeSet;
use std::time::{Duration, Instant};

use serde_json::{Value, json};
use stickslip::scene::keys;
use stickslip_friction::registry;

use super::draw::digits;
use super::quantity::{histories, number, paths, split, text, with_histories};

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
    found.extend(fewer_steps(scene));
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

/// Histories that end earlier, and those without one of their steps.
fn fewer_steps(scene: &Value) -> Vec<Value> {
    let paths = histories(scene);
    let lists = paths
        .iter()
        .filter_map(|path| scene.pointer(path)?.as_array());
    let length = lists.map(Vec::len).max().unwrap_or(0);
    let shorter = (1..length).map(|count| with_histories(scene, |steps| steps.truncate(count)));
    let without = (0..length).filter(|_| length > 1).map(|index| {
        with_histories(scene, |steps| {
            if index < steps.len() {
                steps.remove(index);
            }
        })
    });
    shorter.chain(without).collect()
}

/// A joint whose pin stands in the plate itself.
fn without_bushing(scene: &Value) -> Option<Value> {
    let contacts = scene.get("contacts")?.as_array()?;
    let set = |index: usize, side: &str| contacts[index][side].as_str()?.split_once('.');
    let of = |side: &str, wanted: &dyn Fn((&str, &str)) -> bool| {
        (0..contacts.len()).find(|&index| set(index, side).is_some_and(wanted))
    };
    let outer = of("second", &|(_, edge)| edge == "outer")?;
    let (bush, _) = set(outer, "second")?;
    let inner = of("first", &|own| own == (bush, "hole"))?;
    let (plate, _) = set(outer, "first")?;
    let (pin, _) = set(inner, "second")?;
    let hole = |body: &str| {
        number(
            scene,
            &format!("/bodies/{body}/shape/plate_with_hole/hole_radius"),
        )
    };
    let place = format!("/bodies/{pin}/shape/disk/radius");
    let radius = hole(plate)? * number(scene, &place)? / hole(bush)?;
    let mut smaller = scene.clone();
    *smaller.pointer_mut(&place)? = text(digits(radius, 9), "mm");
    smaller["contacts"][inner]["first"] = contacts[outer]["first"].clone();
    smaller["contacts"].as_array_mut()?.remove(outer);
    for table in ["bodies", "materials"] {
        smaller[table].as_object_mut()?.remove(bush);
    }
    let elsewhere = |load: &Value| {
        let on = load["on"].as_str().and_then(|on| on.split('.').next());
        on.is_some_and(|body| body != bush)
    };
    smaller["loads"].as_array_mut()?.retain(elsewhere);
    Some(smaller)
}

/// Each contact with Coulomb's law, or with a part of its own.
fn simpler_laws(scene: &Value) -> Vec<Value> {
    let mut found = Vec::new();
    for (index, contact) in super::quantity::list(scene, "contacts").enumerate() {
        let own = &contact["friction"];
        let mut laws = vec![json!({ "coulomb": { "mu": 0.0 } })];
        if own.get("coulomb").is_none() {
            laws.push(json!({ "coulomb": { "mu": 0.3 } }));
        }
        let parts = ["fibre", "matrix"].map(|part| own["fibre_coverage"].get(part).cloned());
        laws.extend(parts.into_iter().flatten());
        for law in laws {
            let mut smaller = scene.clone();
            smaller["contacts"][index]["friction"] = law;
            found.push(smaller);
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

/// Paths of keys that have defaults, by the declarations of scenes and laws.
fn optional(scene: &Value) -> Vec<String> {
    let declared = keys::tables().flat_map(|table| table.keys);
    let own = declared
        .filter(|key| !key.is_required())
        .map(|key| key.name);
    let laws = registry::laws().flat_map(|law| law.parameters);
    let of_laws = laws
        .filter(|parameter| parameter.default.is_some())
        .filter_map(|parameter| parameter.path.split('.').next());
    let optional: BTreeSet<&str> = own.chain(of_laws).collect();
    let mut found = paths(scene);
    found.retain(|path| {
        let (parent, key) = path.rsplit_once('/').unwrap_or(("", path));
        optional.contains(key) && !parent.is_empty() || path == "/plies"
    });
    found
}

/// Every number of at least one more digit rounded to `places`, all at once and one at a time.
fn rounded(scene: &Value, places: i32) -> Vec<Value> {
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
    let (mut all, mut found) = (scene.clone(), Vec::new());
    for path in &paths(scene) {
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
