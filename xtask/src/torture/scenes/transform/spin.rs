//! Scenes of outlines and the pins in them turned by any angle.

use serde_json::{Value, json};

use super::angles::materials;
use crate::torture::scenes::quantity::{deg, list_mut, split, table, text};

/// `scene` turned counter-clockwise by `degrees`; `None` of shapes that have a direction, and of what holds along axes alone.
pub(in crate::torture::scenes) fn spun(scene: &Value, degrees: f64) -> Option<Value> {
    let mut scene = scene.clone();
    let has_platens = list_mut(&mut scene, "platens").next().is_some();
    if has_platens || scene.get("failure").is_some() {
        return None;
    }
    let (sin, cos) = degrees.to_radians().sin_cos();
    let turned = |[x, y]: [f64; 2]| [cos * x - sin * y, sin * x + cos * y];
    let names: Vec<String> = table(&scene, "bodies")
        .map(|(name, _)| name.clone())
        .collect();
    for name in names {
        let body = &mut scene["bodies"][&name];
        let is_outline = body["shape"].get("outline").is_some();
        if !is_outline && body["shape"].get("disk").is_none() {
            return None;
        }
        if is_outline {
            let own = body.get("angle").and_then(Value::as_str).and_then(split);
            body["angle"] = deg(own.map_or(0.0, |(angle, _)| angle) + degrees);
        }
        if let Some(Value::Array(position)) = body.get_mut("position") {
            let parts: Vec<(f64, &str)> = (position.iter())
                .filter_map(|part| part.as_str().and_then(split))
                .collect();
            let [(x, unit), (y, _)] = parts[..] else {
                return None;
            };
            *position = turned([x, y]).map(|part| text(part, unit)).to_vec();
        }
    }
    materials(&mut scene, &|angle| angle + degrees, &str::to_owned);
    for support in list_mut(&mut scene, "supports") {
        let axes = support.get("fix").and_then(Value::as_array).map(Vec::len);
        if axes == Some(1) || (axes.is_some() && support.get("displacement").is_some()) {
            return None;
        }
        if let Some((angle, _)) = support
            .get("normal")
            .and_then(Value::as_str)
            .and_then(split)
        {
            support["normal"] = deg(angle + degrees);
        }
    }
    for load in list_mut(&mut scene, "loads") {
        if load.get("polar_traction").is_some() {
            return None;
        }
        for kind in ["force", "bearing"] {
            if let Some(direction) = load.pointer_mut(&format!("/{kind}/direction")) {
                let parts = [0, 1].map(|axis| direction[axis].as_f64().unwrap_or(0.0));
                *direction = json!(turned(parts));
            }
        }
    }
    Some(scene)
}
