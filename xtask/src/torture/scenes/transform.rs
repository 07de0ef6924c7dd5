//! Scenes seen another way: mirrored, turned, larger, stiffer, listed otherwise, without friction.

mod angles;
mod spin;

use serde_json::{Value, json};

use angles::{materials, mirror_angles, negated_layup};
pub(super) use spin::spun;

use super::quantity::{change, deg, list_mut, split, text, with_histories};

/// The mirror image about the x axis of round bodies, about the y axis of a line contact.
pub(super) fn mirrored(scene: &Value, round: bool) -> Value {
    let mut scene = scene.clone();
    let across = usize::from(round);
    let sides = if round {
        ["top", "bottom"]
    } else {
        ["left", "right"]
    };
    materials(&mut scene, &|angle| -angle, &negated_layup);
    for table in meshes(&scene) {
        let angles = scene.pointer_mut(&format!("/{table}/angles"));
        if let Some(Value::Array(angles)) = angles {
            mirror_angles(angles);
        }
    }
    for name in ["supports", "platens", "loads", "edges"] {
        for entry in list_mut(&mut scene, name) {
            swap(entry, sides);
        }
    }
    for body in scene["bodies"]
        .as_object_mut()
        .into_iter()
        .flat_map(|bodies| bodies.values_mut())
    {
        negate(body.get_mut("angle"));
        if let Some(outline) = body["shape"].get_mut("outline") {
            mirror_outline(outline, across, sides);
        }
    }
    for support in list_mut(&mut scene, "supports") {
        let axis = ["x", "y"][across];
        let fixes = support.get("fix").and_then(Value::as_array);
        if fixes.is_some_and(|axes| axes.contains(&axis.into())) {
            negate(support.get_mut("displacement"));
        }
        // The image of a direction at a is at −a about the x axis; at 180° − a about y, which holds the other way round.
        negate(support.get_mut("normal"));
        if !round && support.get("normal").is_some() {
            negate(support.get_mut("displacement"));
        }
    }
    for load in list_mut(&mut scene, "loads") {
        for kind in ["force", "bearing"] {
            if let Some(part) = load.pointer_mut(&format!("/{kind}/direction/{across}")) {
                *part = json!(-part.as_f64().unwrap_or(0.0));
            }
        }
    }
    scene
}

/// The image of an outline, counter-clockwise again; edges on swapped sides have their names.
fn mirror_outline(outline: &mut Value, across: usize, sides: [&str; 2]) {
    let mirror = |point: &mut Value| negate(point.get_mut(across));
    mirror(&mut outline["start"]);
    let start = outline["start"].clone();
    let mut edges: Vec<Value> = list_mut(outline, "edges").map(Value::take).collect();
    let mut begin = start.clone();
    for edge in &mut edges {
        for key in ["to", "through"] {
            edge.get_mut(key).map(mirror);
        }
        if let Some(side) = sides.iter().position(|side| edge["name"] == **side) {
            edge["name"] = sides[1 - side].into();
        }
        // Walked the other way, an edge ends where it began.
        let end = edge.get("to").cloned();
        edge["to"] = std::mem::replace(&mut begin, end.unwrap_or_else(|| start.clone()));
    }
    edges.reverse();
    outline["edges"] = edges.into();
    for hole in outline
        .get_mut("holes")
        .and_then(Value::as_object_mut)
        .into_iter()
        .flat_map(|holes| holes.values_mut())
    {
        mirror(&mut hole["centre"]);
    }
}

/// Turned counter-clockwise by `quarters` of a turn.
pub(super) fn turned(scene: &Value, quarters: u8) -> Value {
    let mut scene = scene.clone();
    let degrees = 90.0 * f64::from(quarters);
    materials(&mut scene, &|angle| angle + degrees, &str::to_owned);
    // A laminate turns with its own `angle`, and so do the plies of a law that are counted from its axis.
    for support in list_mut(&mut scene, "supports") {
        turn_support(support, quarters);
    }
    for platen in list_mut(&mut scene, "platens") {
        swap_axes(platen, "free", quarters);
    }
    for load in list_mut(&mut scene, "loads") {
        for kind in ["force", "bearing"] {
            let Some(direction) = load.pointer_mut(&format!("/{kind}/direction")) else {
                continue;
            };
            for _ in 0..quarters {
                let [x, y] = [0, 1].map(|axis| direction[axis].as_f64().unwrap_or(0.0));
                *direction = json!([0.0 - y, x]);
            }
        }
    }
    scene
}

fn turn_support(support: &mut Value, quarters: u8) {
    if let Some(normal) = support.get_mut("normal") {
        if let Some((angle, _)) = normal.as_str().and_then(split) {
            *normal = deg(angle + 90.0 * f64::from(quarters));
        }
        return;
    }
    let along_y = support.pointer("/fix/0").and_then(Value::as_str) == Some("y");
    swap_axes(support, "fix", quarters);
    // +x goes to +y, −x, −y; +y to −x, −y, +x.
    let reversed = if along_y {
        [false, true, true, false]
    } else {
        [false, false, true, true]
    };
    if reversed[usize::from(quarters % 4)] {
        negate(support.get_mut("displacement"));
    }
}

fn swap_axes(entry: &mut Value, key: &str, quarters: u8) {
    if quarters.is_multiple_of(2) {
        return;
    }
    if let Some(Value::Array(axes)) = entry.get_mut(key) {
        for axis in axes {
            *axis = if *axis == "x" { "y" } else { "x" }.into();
        }
    }
}

/// Lengths times `length`, and moduli and stresses times `stress`.
pub(super) fn scaled(scene: &Value, length: f64, stress: f64) -> Value {
    let mut scene = scene.clone();
    change(&mut scene, &|number, unit| {
        let factor = match unit {
            "mm" => length,
            "MPa" => stress,
            "N" => stress * length * length,
            "kJ/m2" => stress * length,
            _ => return None,
        };
        Some(text(number * factor, unit))
    });
    for load in list_mut(&mut scene, "loads") {
        if let Some(Value::Array(steps)) = load.pointer_mut("/polar_traction/steps") {
            for step in steps {
                *step = json!(step.as_f64().unwrap_or(0.0) * stress);
            }
        }
    }
    scene
}

/// The same quantities in inches, pounds and pounds per square inch, shown in other units too.
pub(super) fn in_inches(scene: &Value) -> Value {
    // 1 in = 25.4 mm and 1 lbf = 4.4482216152605 N exactly (NIST SP 811, 2008).
    const INCH: f64 = 25.4;
    const POUND: f64 = 4.448_221_615_260_5;
    let mut scene = scene.clone();
    change(&mut scene, &|number, unit| {
        let (number, unit) = match unit {
            "mm" => (number / INCH, "in"),
            "MPa" => (number * INCH * INCH / POUND, "psi"),
            "N" => (number / POUND, "lbf"),
            "deg" => (number.to_radians(), "rad"),
            _ => return None,
        };
        Some(text(number, unit))
    });
    scene["units"] = json!({ "length": "mil", "force": "kip", "stress": "ksi" });
    scene
}

/// Every contact frictionless.
pub(super) fn frictionless(scene: &Value) -> Value {
    let mut scene = scene.clone();
    for contact in list_mut(&mut scene, "contacts") {
        contact["friction"] = json!({ "coulomb": { "mu": 0.0 } });
    }
    scene
}

/// The last load step alone.
pub(super) fn last_step(scene: &Value) -> Value {
    with_histories(scene, |steps| {
        steps.drain(..steps.len().saturating_sub(1));
    })
}

/// Bodies named so that they come in another order, and lists the other way round.
pub(super) fn renamed(scene: &Value) -> Value {
    let mut scene = scene.clone();
    let Some(bodies) = scene.get("bodies").and_then(Value::as_object).cloned() else {
        return scene;
    };
    let last = bodies.len();
    let names: Vec<(String, String)> = bodies
        .keys()
        .enumerate()
        .map(|(index, name)| (name.clone(), format!("z{}-{name}", last - index)))
        .collect();
    let new = |old: &str| {
        let (body, set) = old.split_at(old.find('.').unwrap_or(old.len()));
        let (_, name) = names.iter().find(|(own, _)| own == body)?;
        Some(format!("{name}{set}"))
    };
    scene["bodies"] = bodies
        .into_iter()
        .map(|(name, body)| (new(&name).unwrap_or(name), body))
        .collect();
    for (list, keys) in [
        ("contacts", &["first", "second"][..]),
        ("supports", &["on"]),
        ("platens", &["on"]),
        ("loads", &["on"]),
        ("edges", &["on"]),
    ] {
        for entry in list_mut(&mut scene, list) {
            for key in keys {
                if let Some(name) = entry.get(*key).and_then(Value::as_str).and_then(new) {
                    entry[*key] = name.into();
                }
            }
        }
    }
    if let Some(Value::Array(bodies)) = scene.pointer_mut("/failure/bodies") {
        for body in bodies {
            if let Some(name) = body.as_str().and_then(new) {
                *body = name.into();
            }
        }
    }
    for list in ["contacts", "supports", "loads"] {
        if let Some(Value::Array(entries)) = scene.get_mut(list) {
            entries.reverse();
        }
    }
    scene
}

/// Half the spacing of nodes.
pub(super) fn refined(scene: &Value) -> Option<Value> {
    let mut scene = scene.clone();
    for table in meshes(&scene) {
        let settings = scene.pointer_mut(&format!("/{table}"))?;
        if settings.get("angles").is_some() {
            return None;
        }
        for key in ["spacing", "coarse_spacing"] {
            if let Some(value) = settings.get_mut(key) {
                let (number, unit) = value.as_str().and_then(split)?;
                *value = text(0.5 * number, unit);
            }
        }
        if let Some(layers) = settings.get_mut("layers") {
            *layers = json!(2 * layers.as_u64()?);
        }
    }
    Some(scene)
}

/// Pointers to the settings of meshes, those of bodies with their own included, without the first slash.
fn meshes(scene: &Value) -> Vec<String> {
    let bodies = super::quantity::table(scene, "bodies");
    let own = bodies.filter(|(_, body)| body.get("mesh").is_some());
    let own = own.map(|(name, _)| format!("bodies/{name}/mesh"));
    std::iter::once("mesh".to_owned()).chain(own).collect()
}

fn swap(entry: &mut Value, sides: [&str; 2]) {
    let Some((body, set)) = entry["on"].as_str().and_then(|on| on.split_once('.')) else {
        return;
    };
    let other = match sides.iter().position(|side| *side == set) {
        Some(0) => sides[1],
        Some(_) => sides[0],
        None => return,
    };
    entry["on"] = format!("{body}.{other}").into();
}

fn negate(value: Option<&mut Value>) {
    if let Some(value) = value
        && let Some((number, unit)) = value.as_str().and_then(split)
    {
        *value = text(0.0 - number, unit);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_mirrors_and_four_quarters_give_the_scene_back() {
        for seed in 0..200 {
            let scene = super::super::random::scene(seed);
            let round = scene["bodies"].as_object().unwrap().values().all(|body| {
                body["shape"]
                    .get("plate_with_hole")
                    .or(body["shape"].get("disk"))
                    .is_some()
            });
            let once = mirrored(&scene, round);
            let thrice = mirrored(&mirrored(&once, round), round);
            // The first image writes angles and lay-ups out that may be left out.
            assert_eq!(once, thrice, "seed {seed}");
        }
    }
}
