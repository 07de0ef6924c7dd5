//! Random friction laws.

use serde_json::{Value, json};

use crate::torture::scenes::draw::{Draw, digits};
use crate::torture::scenes::quantity::{deg, mm, mpa};

/// A law for a contact whose pressures are about `stress` `[MPa]` and slips about `slip` `[mm]`; of a laminate's edge if `plies`.
pub(super) fn law(draw: &mut Draw, stress: f64, slip: f64, plies: bool) -> Value {
    if !draw.chance(0.14) {
        return simple(draw, stress, slip);
    }
    let mut law = json!({
        "fibre_fraction": draw.between(0.1, 0.7),
        "fibre": simple(draw, stress, slip),
        "matrix": simple(draw, stress, slip),
    });
    law["kernel"] = if draw.chance(0.6) {
        json!({ "tangent": { "width": deg(draw.between(5.0, 50.0)) } })
    } else {
        json!({ "swept": { "kappa": draw.between(0.1, 1.5) } })
    };
    if !plies || draw.chance(0.3) {
        let share = draw.between(0.2, 0.8);
        let angle = draw.between(-85.0, 85.0).round();
        law["plies"] = match draw.weighted(&[(0.3, 0), (0.3, 1), (0.4, 2)]) {
            0 => json!([{ "angle": deg(angle), "fraction": 1.0 }]),
            1 => json!([
                { "angle": deg(angle), "fraction": 0.5 },
                { "angle": deg(-angle), "fraction": 0.5 },
            ]),
            _ => json!([
                { "angle": deg(angle), "fraction": share },
                { "angle": deg(0.0), "fraction": digits(1.0 - share, 6) },
            ]),
        };
    }
    json!({ "fibre_coverage": law })
}

fn coefficient(draw: &mut Draw) -> f64 {
    match draw.weighted(&[(0.86, 0), (0.08, 1), (0.04, 2), (0.02, 3)]) {
        0 => draw.between(0.03, 0.6),
        1 => draw.between(0.6, 1.5),
        2 => 1e-6,
        _ => 2.0,
    }
}

fn simple(draw: &mut Draw, stress: f64, slip: f64) -> Value {
    let most = coefficient(draw);
    let least = digits(most * draw.between(0.3, 1.0), 4);
    match draw.weighted(&[(0.16, 0), (0.34, 1), (0.18, 2), (0.18, 3), (0.14, 4)]) {
        0 => json!({ "coulomb": { "mu": 0.0 } }),
        1 => json!({ "coulomb": { "mu": most } }),
        2 => {
            let mut law = json!({ "static": most, "dynamic": least });
            if draw.chance(0.4) {
                law["transition"] = json!("lagged");
            }
            json!({ "static_dynamic": law })
        }
        3 => {
            let mut law = json!({
                "static": most,
                "dynamic": least,
                "slip_scale": mm(digits(slip * draw.magnitude(0.05, 20.0), 4)),
                "exponent": draw.between(0.4, 3.0),
            });
            if draw.chance(0.4) {
                law["path"] = json!("current");
            }
            json!({ "slip_power": law })
        }
        _ => json!({ "pressure_power": {
            "mu": most,
            "reference_pressure": mpa(digits(stress * draw.magnitude(0.1, 10.0), 4)),
            "exponent": draw.between(0.5, 1.0),
        } }),
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::law;
    use crate::torture::draw::Draw;

    #[test]
    fn every_registered_law_is_drawn() {
        let mut draw = Draw::seeded(1);
        let drawn = (0..500).filter_map(|_| {
            let law = law(&mut draw, 100.0, 1e-3, true);
            law.as_object()?.keys().next().cloned()
        });
        let drawn: BTreeSet<String> = drawn.collect();
        let registered = stickslip_friction::laws().map(|law| law.name.to_owned());
        assert_eq!(drawn, registered.collect());
    }
}
