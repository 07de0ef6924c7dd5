//! A line that would do for each required key; in backticks where words follow it.

use crate::declaration::Key;
use crate::keys::declared;

/// What to write for the missing `key`, given in full: `bodies.plate.thickness`.
pub(super) fn example(key: &str) -> String {
    let name = key.rsplit('.').next().unwrap_or(key);
    if let Some(line) = declared(key).and_then(Key::assignment) {
        return line;
    }
    let value = match name {
        // Tables of scenes that have keys of their own.
        "bodies" => return "`[bodies.plate]` with its shape, thickness and material".to_owned(),
        "mesh" => return "`[mesh]` with spacing = \"2 deg\"".to_owned(),
        // Keys of experiments.
        "radius" => "\"5 mm\"",
        "element" => "\"Q8\"",
        "free" => "[\"x\", \"y\"]",
        "file" => "\"data/ring.csv\"",
        "scale" => {
            return "`scale = \"1 mm\"`, the length of one unit of the table's places (of one pixel, say)"
                .to_owned();
        }
        "y_axis" => {
            return "`y_axis = \"up\"`; \"down\" flips y and v of a table, as of images".to_owned();
        }
        "pixel" => "\"0.02 mm\"",
        "top_left" | "centre" => "[\"-2 mm\", \"20 mm\"]",
        "window" => "[[\"-2 mm\", \"-2 mm\"], [\"20 mm\", \"20 mm\"]]",
        "name" => "\"up\"",
        "specimen" => {
            return "`specimen = { scene = \"scene.toml\" }`, or its material, thickness and hole"
                .to_owned();
        }
        "friction" => "{ coulomb = { mu = 0.3 } }",
        "angles" => "[\"-90 deg\", \"90 deg\"]",
        "outer" => "\"15 mm\"",
        "cells" => "[24, 6]",
        _ => return format!("{name} = …"),
    };
    format!("{name} = {value}")
}
