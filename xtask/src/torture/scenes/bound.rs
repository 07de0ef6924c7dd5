//! Friction bounds of a scene's law, computed again from its text.
//!
//! Laws that remember give a range, because what a point remembers is not among the results: a static coefficient before slip,
//! a dynamic one after it, or anything between.

use std::f64::consts::{FRAC_PI_2, PI};

use serde_json::Value;

use super::quantity::number;

/// What a point may carry `[MPa]`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Bound {
    /// Most while it sticks.
    pub(super) stick: f64,
    /// Least and most while it slips.
    pub(super) slip: [f64; 2],
}

/// The bound of `law` under `pressure` `[MPa]` where the edge's tangent stands at `tangent` `[rad]` from the axis that plies are
/// counted from; `plies` (angle `[rad]`, fraction) are those of the laminate, for laws that do not name theirs.
///
/// # Errors
/// In words, for a law or a choice of it that is not known here.
pub(super) fn bound(
    law: &Value,
    pressure: f64,
    tangent: f64,
    plies: &[(f64, f64)],
) -> Result<Bound, String> {
    let parts = law.as_object().and_then(|law| law.iter().next());
    let (name, given) = parts.ok_or_else(|| format!("no law: {law}"))?;
    let needed = |key: &str, own: Option<f64>| own.ok_or_else(|| format!("no {key}: {law}"));
    let coefficient = |key: &str| needed(key, given.get(key).and_then(Value::as_f64));
    let between = |least: f64, most: f64| Bound {
        stick: most * pressure,
        slip: [least * pressure, most * pressure],
    };
    match name.as_str() {
        "coulomb" => {
            let mu = coefficient("mu")?;
            Ok(between(mu, mu))
        }
        "static_dynamic" => {
            let (most, least) = (coefficient("static")?, coefficient("dynamic")?);
            let mut bound = between(least, most);
            match given.get("transition").and_then(Value::as_str) {
                Some("lagged") => {}
                None | Some("drop") => bound.slip[1] = least * pressure,
                Some(other) => return Err(format!("the transition '{other}' has no bound here")),
            }
            Ok(bound)
        }
        "slip_power" => Ok(between(coefficient("dynamic")?, coefficient("static")?)),
        "pressure_power" => {
            let reference = number(given, "/reference_pressure");
            let reference = needed("reference_pressure", reference)?;
            let power = (pressure / reference).powf(coefficient("exponent")?);
            let most = coefficient("mu")? * reference * power;
            Ok(Bound {
                stick: most,
                slip: [most; 2],
            })
        }
        "fibre_coverage" => {
            let covered = needed("coverage", coverage(given, tangent, plies))?;
            let [fibre, matrix] =
                ["fibre", "matrix"].map(|part| bound(&given[part], pressure, tangent, plies));
            let (fibre, matrix) = (fibre?, matrix?);
            let mix = |a: f64, b: f64| covered * a + (1.0 - covered) * b;
            Ok(Bound {
                stick: mix(fibre.stick, matrix.stick),
                slip: [0, 1].map(|end| mix(fibre.slip[end], matrix.slip[end])),
            })
        }
        other => Err(format!("the law '{other}' has no bound here")),
    }
}

/// Fraction of the surface that fibres cover, as the documentation of the law gives it.
fn coverage(law: &Value, tangent: f64, laminate: &[(f64, f64)]) -> Option<f64> {
    let fibres = law["fibre_fraction"].as_f64()?;
    let packed = (2.0 * 3.0_f64.sqrt() * fibres / PI).sqrt();
    let own: Option<Vec<(f64, f64)>> = law.get("plies").and_then(Value::as_array).map(|plies| {
        let ply = |ply: &Value| {
            let angle = number(ply, "/angle").map(f64::to_radians)?;
            Some((angle, ply["fraction"].as_f64()?))
        };
        plies.iter().filter_map(ply).collect()
    });
    let plies = own.as_deref().unwrap_or(laminate);
    let kappa = law.pointer("/kernel/swept/kappa").and_then(Value::as_f64);
    let width = number(law, "/kernel/tangent/width").map(f64::to_radians);
    // One of both kernels is given.
    kappa.or(width)?;
    let sum = plies.iter().map(|(angle, share)| {
        // From the fibre to the tangent, in [0, π/2].
        let turn = (tangent - angle).rem_euclid(PI);
        let apart = FRAC_PI_2 - (turn - FRAC_PI_2).abs();
        let covered = match (kappa, width) {
            (Some(kappa), _) => packed.min(fibres * (1.0 + kappa * apart.cos())),
            (None, width) => {
                let width = width.unwrap_or(f64::NAN);
                fibres + (packed - fibres) * (-(apart / width).powi(2)).exp()
            }
        };
        share * covered
    });
    Some(sum.sum::<f64>().min(1.0))
}

/// Angle `[rad]` from +x of the axis that the plies of a law on the edge of `body` are counted from, and the laminate's plies about it.
pub(super) fn axis_and_plies(scene: &Value, body: &str) -> (f64, Vec<(f64, f64)>) {
    let name = scene["bodies"][body]["material"]
        .as_str()
        .unwrap_or_default();
    let material = &scene["materials"][name];
    let angle = ["/orthotropic/angle", "/laminate/angle"]
        .iter()
        .find_map(|key| number(material, key));
    let layup = material.pointer("/laminate/layup").and_then(Value::as_str);
    (
        angle.unwrap_or(0.0).to_radians(),
        layup.map_or_else(Vec::new, plies_of),
    )
}

/// Angles `[rad]` and equal fractions of the plies of a lay-up like `[0_2/±45/90]s`; the mirrored half has the same.
fn plies_of(layup: &str) -> Vec<(f64, f64)> {
    let inside = layup
        .trim_start_matches('[')
        .split(']')
        .next()
        .unwrap_or_default();
    let mut angles = Vec::new();
    for ply in inside.split('/') {
        let (angle, count) = ply.split_once('_').unwrap_or((ply, "1"));
        let count: usize = count.parse().unwrap_or(1);
        let both = angle.strip_prefix('±');
        let Ok(value) = both.unwrap_or(angle).parse::<f64>() else {
            continue;
        };
        for _ in 0..count {
            angles.push(value.to_radians());
            if both.is_some() {
                angles.push(-value.to_radians());
            }
        }
    }
    let share = 1.0 / angles.len().max(1) as f64;
    angles.into_iter().map(|angle| (angle, share)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;
    use stickslip_friction::{FrictionLaw, History, Place};

    /// A law that scenes may name and this check does not know would go unchecked.
    #[test]
    fn every_registered_law_is_known() {
        for law in stickslip_friction::registry::laws() {
            let found = bound(&json!({ law.name: {} }), 1.0, 0.0, &[]);
            let unknown = format!("the law '{}' has no bound here", law.name);
            assert_ne!(found.err(), Some(unknown));
        }
    }

    #[test]
    fn bounds_are_those_of_the_laws() {
        let laws = [
            json!({ "coulomb": { "mu": 0.3 } }),
            json!({ "static_dynamic": { "static": 0.4, "dynamic": 0.25 } }),
            json!({ "fibre_coverage": {
                "plies": [{ "angle": "20 deg", "fraction": 0.7 }, { "angle": "-50 deg", "fraction": 0.3 }],
                "fibre_fraction": 0.5, "kernel": { "tangent": { "width": "25 deg" } },
                "fibre": { "coulomb": { "mu": 0.1 } }, "matrix": { "coulomb": { "mu": 0.8 } },
            } }),
        ];
        for law in laws {
            let mut plain = law.clone();
            super::super::quantity::change(&mut plain, &|number, _| {
                Some(json!(number.to_radians()))
            });
            let real: Box<dyn FrictionLaw> = serde_json::from_value(plain).unwrap();
            for degrees in [-170.0_f64, -70.0, 0.0, 33.0, 110.0] {
                let tangent = degrees.to_radians();
                let place = Place {
                    position: [0.0; 2],
                    tangent: [tangent.cos(), tangent.sin()],
                    material_angle: 0.0,
                };
                let exact = real.bound(7.0, 0.0, &place, &History::default());
                let found = bound(&law, 7.0, tangent, &[]).unwrap();
                assert!((found.stick - exact.stick).abs() < 1e-12, "{law}");
                assert!((found.slip[0] - exact.slip).abs() < 1e-12, "{law}");
            }
        }
    }
}
