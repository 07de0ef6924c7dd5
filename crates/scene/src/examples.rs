//! A line that would do for each required key; in backticks where words follow it.

/// What to write for the missing `key`, given in full: `bodies.plate.thickness`.
pub(super) fn example(key: &str) -> String {
    let name = key.rsplit('.').next().unwrap_or(key);
    let value = match name {
        "young" => "\"70 GPa\"",
        "poisson" | "nu12" | "nu13" => "0.3",
        "e1" => "\"140 GPa\"",
        "e2" | "e3" => "\"9 GPa\"",
        "g12" => "\"5 GPa\"",
        "nu23" => "0.4",
        "ply" => "\"carbon\"",
        "layup" => "\"[0/±45/90]s\"",
        "criteria" => "[\"max_stress\", \"tsai_wu\"]",
        "xt" => "\"1500 MPa\"",
        "tension" | "compression" => "\"1.8 mm\"",
        "fibre" | "matrix" => "0.1",
        "model" => return "model.ply_discount = { fibre = 0.01, matrix = 0.1 }".to_owned(),
        "hardening" => "\"500 MPa\"",
        "end" => "\"-0.4 mm\"",
        "body" => "\"plate\"",
        "material" => "\"aluminium\"",
        "bodies" => return "`[bodies.plate]` with its shape, thickness and material".to_owned(),
        "mesh" => return "[mesh] spacing = \"2 deg\"".to_owned(),
        "thickness" => "\"1.5 mm\"",
        "shape" => return "shape.disk = { radius = \"5 mm\" }".to_owned(),
        "outline" => {
            return "outline.strip = { half_width = \"40 mm\", left = \"180 mm\", right = \"40 mm\" }".to_owned();
        }
        "hole_radius" | "radius" => "\"5 mm\"",
        "half_width" | "left" | "right" | "width" | "height" | "half_length" | "depth" => {
            "\"40 mm\""
        }
        "element" => "\"Q8\"",
        "spacing" => "\"2 deg\"",
        "first" => "\"plate.hole\"",
        "second" => "\"pin.rim\"",
        "on" => "\"plate.left\"",
        "free" => "[\"x\", \"y\"]",
        "direction" => "[-1, 0]",
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
        "stress" => "\"MPa\"",
        "steps" => match key.rsplit('.').nth(1) {
            Some("force") => "[\"1 kN\"]",
            Some("pressure") => "[\"1 MPa\"]",
            Some("temperature") => "[\"-100 K\"]",
            _ => "[1.0]",
        },
        _ => return format!("{name} = …"),
    };
    format!("{name} = {value}")
}
