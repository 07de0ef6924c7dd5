//! What laboratories are made of.

use serde_json::{Value, json};

use super::truth::{Friction, Medium};
use crate::torture::draw::{Draw, digits};
use crate::torture::quantity::{deg, mm, mpa, text};

/// The plate, and the load that it is made for.
pub(super) struct Plate {
    pub(super) radius: f64,
    pub(super) thickness: f64,
    pub(super) material: Value,
    pub(super) name: &'static str,
    /// Modulus `[MPa]`.
    pub(super) young: f64,
    /// Bearing stress over the modulus.
    pub(super) strain: f64,
    /// Largest load `[N]`.
    pub(super) load: f64,
}

impl Plate {
    pub(super) fn new(draw: &mut Draw) -> Self {
        let radius = draw.between(3.0, 12.0);
        let thickness = draw.between(1.0, 4.0);
        let (material, young, name) = material(draw);
        let bearing = young * draw.magnitude(0.8e-3, 3e-3);
        Self {
            radius,
            thickness,
            material,
            name,
            young,
            strain: bearing / young,
            load: digits(2.0 * radius * thickness * bearing, 4),
        }
    }

    /// Loads of all steps, up and down again `[N]`.
    pub(super) fn loads(&self) -> Vec<f64> {
        let parts = [0.08, 0.4, 0.7, 1.0, 0.72, 0.42, 0.2];
        (parts.iter())
            .map(|part| digits(part * self.load, 4))
            .collect()
    }

    pub(super) fn named(&self) -> String {
        format!("material {}", self.name)
    }
}

/// The pin.
pub(super) struct Pin {
    pub(super) radius: f64,
    /// Modulus `[MPa]`.
    pub(super) young: f64,
}

impl Pin {
    pub(super) fn new(draw: &mut Draw, plate: &Plate) -> Self {
        let clearance = plate.radius * draw.magnitude(1e-4, 1.5e-3);
        Self {
            radius: plate.radius - clearance,
            young: draw.weighted(&[(0.5, plate.young), (0.5, 2.1e5)]),
        }
    }
}

/// Dilation that a picture adds.
pub(super) fn dilation(draw: &mut Draw) -> f64 {
    let sign = [(0.5, 1.0), (0.5, -1.0)];
    digits(draw.magnitude(2e-5, 2e-4) * draw.weighted(&sign), 3)
}

/// Rotation of the specimen `[rad]`, of pictures a small one.
pub(super) fn rotation(draw: &mut Draw, pictures: bool) -> f64 {
    let turns = draw.chance(0.5);
    let rotation = draw.between(-1.5, 1.5).to_radians();
    match (turns, pictures) {
        (false, _) => 0.0,
        (true, false) => rotation,
        (true, true) => 0.02 * rotation,
    }
}

/// The scene with the mesh of the model.
pub(super) fn scene(
    draw: &mut Draw,
    plate: &Plate,
    pin: &Pin,
    friction: &Friction,
    loads: &[f64],
) -> Value {
    let spacing = draw.between(4.5, 6.0);
    json!({
        "version": 1,
        "materials": { "plate": plate.material, "pin": { "isotropic": {
            "young": mpa(pin.young), "poisson": 0.3 } } },
        "bodies": {
            "plate": { "material": "plate", "thickness": mm(plate.thickness), "shape": { "plate_with_hole": {
                "hole_radius": mm(plate.radius),
                "outline": { "strip": {
                    "half_width": mm(digits(plate.radius * draw.between(2.5, 4.0), 4)),
                    "left": mm(digits(plate.radius * draw.between(7.0, 12.0), 4)),
                    "right": mm(digits(plate.radius * draw.between(2.5, 5.0), 4)),
                } },
            } } },
            "pin": { "material": "pin", "thickness": mm(plate.thickness),
                "shape": { "disk": { "radius": mm(digits(pin.radius, 8)) } } },
        },
        "mesh": { "element": "Q8", "spacing": deg(spacing), "fine_to": "110 deg", "coarse_spacing": "10 deg" },
        "contacts": [{ "name": "pin", "first": "plate.hole", "second": "pin.rim", "friction": friction.law }],
        "supports": [{ "on": "pin.centre", "fix": ["x", "y"] }],
        "loads": [{ "on": "plate.left", "force": {
            "direction": [-1, 0], "steps": loads.iter().map(|own| text(*own, "N")).collect::<Vec<_>>() } }],
    })
}

pub(super) fn medium(draw: &mut Draw, plate: &Plate, pictures: bool, fine: bool) -> Medium {
    if pictures {
        // Some ten fringes; their gradients, up to four times the mean strain, stay below the carrier.
        let frequency = digits(draw.between(2.5, 4.0) / (plate.radius * plate.strain), 3);
        let carrier = digits(5.6 * frequency * plate.strain * draw.between(1.0, 1.2), 3);
        return Medium::Pictures {
            frequency,
            carrier,
            pixel: digits(1.0 / (4.8 * carrier), 3),
            falloff: draw.between(0.0, 0.4),
        };
    }
    let count = if fine { 38.0 } else { draw.between(13.0, 24.0) };
    Medium::Table {
        spacing: digits(plate.radius / count, 4),
        reach: draw.weighted(&[(0.5, 1), (0.3, 2), (0.2, 3)]),
    }
}

pub(super) fn noise(draw: &mut Draw, plate: &Plate, pictures: bool, fine: bool) -> f64 {
    let part = match (pictures, fine) {
        (true, _) => return draw.between(0.02, 0.25),
        (false, true) => draw.magnitude(2e-4, 2e-3),
        (false, false) => draw.magnitude(5e-4, 2e-2),
    };
    digits(plate.radius * plate.strain * part, 3)
}

/// Whether the load has not fallen towards a step, from 1.
pub(super) fn is_loading(step: usize) -> bool {
    step < 5
}

pub(super) fn material(draw: &mut Draw) -> (Value, f64, &'static str) {
    match draw.weighted(&[(0.6, 0), (0.25, 1), (0.15, 2)]) {
        0 => {
            let young = draw.magnitude(5e4, 2e5);
            let poisson = draw.between(0.2, 0.4);
            (
                json!({ "isotropic": { "young": mpa(young), "poisson": poisson } }),
                young,
                "isotropic",
            )
        }
        // Quasi-isotropic carbon and epoxy, and one with more fibres along the load.
        1 => (
            json!({ "orthotropic": { "e1": "54000 MPa", "e2": "54000 MPa", "g12": "20500 MPa", "nu12": 0.31 } }),
            5.4e4,
            "quasi-isotropic",
        ),
        _ => (
            json!({ "orthotropic": { "e1": "85000 MPa", "e2": "37000 MPa", "g12": "18000 MPa", "nu12": 0.4 } }),
            5.5e4,
            "orthotropic",
        ),
    }
}

/// The law of the truth; `size` is that of displacements `[mm]`.
pub(super) fn friction(draw: &mut Draw, size: f64, fine: bool) -> Friction {
    let mu = draw.between(if fine { 0.2 } else { 0.08 }, 0.45);
    let lower = digits(mu * draw.between(if fine { 0.3 } else { 0.5 }, 0.9), 4);
    let scale = digits(size * draw.magnitude(0.05, 0.3), 4);
    let kind = draw.weighted(&[
        (0.6, "coulomb"),
        (0.1, ""),
        (0.15, "static_dynamic"),
        (0.15, "slip_power"),
    ]);
    let (kind, fixed, moving, law) = match kind {
        "coulomb" => (kind, mu, mu, json!({ "coulomb": { "mu": mu } })),
        "" => ("coulomb", 0.0, 0.0, json!({ "coulomb": { "mu": 0.0 } })),
        "static_dynamic" => (
            kind,
            mu,
            lower,
            json!({ "static_dynamic": { "static": mu, "dynamic": lower } }),
        ),
        _ => (
            kind,
            mu,
            lower,
            json!({ "slip_power": { "static": mu, "dynamic": lower, "slip_scale": mm(scale), "exponent": 1.0 } }),
        ),
    };
    Friction {
        kind,
        fixed,
        moving,
        scale,
        law,
    }
}

/// The laws that are compared: that of the truth among them.
pub(super) fn laws(friction: &Friction) -> Value {
    let mut laws = vec![
        json!({ "name": "Coulomb", "friction": { "coulomb": { "mu": 0.25 } }, "free": { "mu": [0.0, 1.0] } }),
        json!({ "name": "static and dynamic", "friction": { "static_dynamic": { "static": 0.35, "dynamic": 0.25 } },
            "free": { "static": [0.0, 1.0], "dynamic": [0.0, 1.0] } }),
    ];
    if friction.kind == "slip_power" {
        laws.push(json!({ "name": "slip power",
            "friction": { "slip_power": { "static": 0.35, "dynamic": 0.25, "slip_scale": mm(friction.scale), "exponent": 1.0 } },
            "free": { "static": [0.0, 1.0], "dynamic": [0.0, 1.0],
                "slip_scale": [mm(digits(0.02 * friction.scale, 4)), mm(digits(50.0 * friction.scale, 4))] } }));
    }
    laws.into()
}

pub(super) fn region(draw: &mut Draw, radius: f64, is_wide: bool, fine: bool) -> Value {
    let cell = if fine { 2.4 } else { draw.between(2.5, 4.0) };
    let [from, to] = if is_wide {
        let half = draw.between(108.0, 140.0);
        [-half, half]
    } else {
        [-8.0, 108.0]
    };
    let along = ((to - from) / cell).round() as usize;
    let across = if fine { 12 } else { draw.whole(6, 9) };
    let smoothing = if draw.chance(0.7) {
        json!({ "order": 2, "share": 0.4 })
    } else {
        json!({ "order": 2, "share": 1.0 })
    };
    json!({
        "sector": { "angles": [deg(from), deg(to)], "outer": mm(digits(radius * draw.between(1.28, 1.42), 4)),
            "cells": [along, across], "growth": 2.0 },
        "smoothing": smoothing,
    })
}

pub(super) fn masks(draw: &mut Draw, radius: f64) -> Value {
    let count = draw.weighted(&[(0.5, 0), (0.3, 1), (0.2, 2)]);
    let mask = |_| {
        let angle = draw.between(-180.0, 180.0).to_radians();
        let from = radius * draw.between(1.1, 1.4);
        let centre = [from * angle.cos(), from * angle.sin()].map(|x| mm(digits(x, 4)));
        json!({ "centre": centre, "radius": mm(digits(radius * draw.between(0.03, 0.1), 4)) })
    };
    (0..count).map(mask).collect::<Vec<_>>().into()
}

/// The experiment without its states.
pub(super) fn asked(
    seed: u64,
    region: &Value,
    masks: &Value,
    is_free: bool,
    laws: Option<Value>,
) -> Value {
    let mut experiment = json!({
        "version": 1,
        "specimen": { "scene": "scene.json", "body": "plate", "edge": "hole" },
        "region": region,
        "reduce": { "mask": masks },
        "identify": { "samples": 20, "seed": seed % 1000 },
    });
    if is_free {
        experiment["reduce"]["free"] = json!(["dilation"]);
    }
    if let Some(laws) = laws {
        experiment["laws"] = laws;
    }
    experiment
}

/// What the truth has otherwise than the model, where that is a key of the scene.
pub(super) fn error_of(name: &str, pin: &Pin, loads: &[f64], draw: &mut Draw) -> Option<String> {
    let sign = draw.weighted(&[(0.5, 1.0), (0.5, -1.0)]);
    match name {
        "clearance" => Some(format!(
            "bodies.pin.shape.disk.radius=\"{} mm\"",
            pin.radius - 0.001
        )),
        "load" => {
            let all = loads
                .iter()
                .map(|own| format!("'{} N'", own * (1.0 + 0.03 * sign)));
            let all: Vec<String> = all.collect();
            Some(format!("loads.0.force.steps=[{}]", all.join(",")))
        }
        "modulus" => Some(format!(
            "materials.pin.isotropic.young=\"{} MPa\"",
            pin.young * (1.0 + 0.1 * sign)
        )),
        _ => None,
    }
}
