//! Angles of materials, lay-ups, plies of laws and nodes.

use serde_json::Value;

use crate::torture::scenes::quantity::{deg, list_mut, split, table};

/// Changes the angles of materials and lay-ups. Plies of friction laws are counted from the material's axis: they mirror like it and
/// do not turn.
pub(super) fn materials(
    scene: &mut Value,
    angle: &dyn Fn(f64) -> f64,
    layup: &dyn Fn(&str) -> String,
) {
    let Some(Value::Object(all)) = scene.get_mut("materials") else {
        return;
    };
    for material in all.values_mut() {
        for kind in ["orthotropic", "laminate"] {
            let Some(constants) = material.get_mut(kind) else {
                continue;
            };
            let own = constants
                .get("angle")
                .and_then(Value::as_str)
                .and_then(split);
            constants["angle"] = deg(angle(own.map_or(0.0, |(own, _)| own)));
            if let Some(text) = constants.get("layup").and_then(Value::as_str) {
                constants["layup"] = layup(text).into();
            }
        }
    }
    let mirrors = angle(1.0) < 0.0;
    let isotropic: Vec<String> = table(scene, "materials")
        .filter(|(_, material)| material.get("isotropic").is_some())
        .map(|(name, _)| name.clone())
        .collect();
    let bodies = scene.get("bodies").cloned().unwrap_or_default();
    for contact in list_mut(scene, "contacts") {
        let first = contact["first"]
            .as_str()
            .and_then(|set| set.split_once('.'));
        let material = first.and_then(|(body, _)| bodies[body]["material"].as_str());
        // An isotropic body has no axis that could turn: its law's plies are counted from x.
        let from_x = material.is_some_and(|name| isotropic.iter().any(|own| own == name));
        let Some(Value::Array(plies)) = contact.pointer_mut("/friction/fibre_coverage/plies")
        else {
            continue;
        };
        for ply in plies {
            if let Some((own, _)) = ply["angle"].as_str().and_then(split)
                && (mirrors || from_x)
            {
                ply["angle"] = deg(angle(own));
            }
        }
    }
}

/// The lay-up with every angle negated.
pub(super) fn negated_layup(layup: &str) -> String {
    let mut result = String::new();
    let mut rest = layup.chars().peekable();
    let mut counts = false;
    while let Some(mark) = rest.next() {
        let sign = matches!(mark, '±' | '-');
        if !sign && !mark.is_ascii_digit() || counts {
            counts = mark == '_' || (counts && mark.is_ascii_digit());
            result.push(mark);
            continue;
        }
        let mut number = if sign {
            String::new()
        } else {
            mark.to_string()
        };
        while let Some(digit) = rest.next_if(|next| next.is_ascii_digit() || *next == '.') {
            number.push(digit);
        }
        let negated = match mark {
            '±' => format!("-{number}/{number}"),
            '-' => number,
            _ if number == "0" => number,
            _ => format!("-{number}"),
        };
        result.push_str(&negated);
    }
    result
}

/// Nodes at these angles, counted the other way round; a list to 180° is its own mirror image in a whole model.
pub(super) fn mirror_angles(angles: &mut Vec<Value>) {
    let degrees: Vec<f64> = angles
        .iter()
        .filter_map(|angle| split(angle.as_str()?))
        .map(|(angle, _)| angle)
        .collect();
    if degrees.last().is_none_or(|last| *last <= 180.0) {
        return;
    }
    let turned = degrees[1..].iter().rev().map(|angle| deg(360.0 - angle));
    *angles = std::iter::once(deg(0.0)).chain(turned).collect();
}

#[cfg(test)]
mod tests {
    use super::negated_layup;

    #[test]
    fn lay_ups_are_negated_angle_by_angle() {
        for (layup, expected) in [
            ("[0/45/-45/90]s", "[0/-45/45/-90]s"),
            ("[±30]s", "[-30/30]s"),
            ("[0_2/±45/90]s", "[0_2/-45/45/-90]s"),
            ("[-37/86]s", "[37/-86]s"),
            ("[25_12/7.5]s", "[-25_12/-7.5]s"),
        ] {
            assert_eq!(negated_layup(layup), expected);
        }
    }
}
