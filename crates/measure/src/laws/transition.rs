//! The coefficient along the slip path, for laws in which it changes from one value to another.
//!
//! ```text
//! μ(s) = |τ|/p of a slipping point with slip path s,     band: μ(s; θ̂) ± z √(gᵀ C g),   g = ∂μ/∂θ
//! ```
//!
//! C is the covariance of the parameters by the curvature of χ²: parameters that compensate each other widen their own intervals, but
//! not the band.

use stickslip_friction::{FrictionLaw, History, Place, PointStatus};
use stickslip_hybrid::identify::chi_squared_of_one;

use super::Fit;
use stickslip_experiment::SpecimenScene;

/// Computes the coefficient |τ|/p `[1]` of a slipping point with slip path `slip` `[mm]`; `None` where it depends on the pressure as
/// well, or is not finite.
pub fn coefficient(law: &dyn FrictionLaw, slip: f64) -> Option<f64> {
    /// Pressures `[MPa]` at which a coefficient of the slip path alone is the same.
    const PRESSURES: [f64; 2] = [1.0, 100.0];
    let place = Place {
        position: [0.0; 2],
        tangent: [0.0, 1.0],
        material_angle: 0.0,
    };
    let past = History::default().commit(PointStatus::Slip, slip);
    let [low, high] = PRESSURES.map(|p| law.bound(p, 0.0, &place, &past).slip / p);
    (low.is_finite() && (low - high).abs() <= 1e-9 * low.abs()).then_some(low)
}

/// Whether the coefficient of `law` changes along a slip path of `slip` `[mm]`.
pub fn passes(law: &dyn FrictionLaw, slip: f64) -> bool {
    match [0.0, slip].map(|slip| coefficient(law, slip)) {
        [Some(first), Some(last)] => (first - last).abs() > 1e-9,
        _ => false,
    }
}

/// Half the width `[1]` of the band of the coefficient of `fit` at the slip path `slip` `[mm]`, for the probability `confidence` `[1]`; `None` where not all parameters have a standard deviation, and where χ² rejects the model.
pub fn half_width(fit: &Fit, slip: f64, confidence: f64) -> Option<f64> {
    /// Parts of the values by which they are changed.
    const CHANGE: f64 = 1e-4;
    let values = fit.calibration.values();
    let covariance = &fit.calibration.covariance;
    if covariance.is_empty() || !fit.explains() {
        return None;
    }
    let mut gradient = Vec::new();
    for (k, &value) in values.iter().enumerate() {
        let step = CHANGE * value.abs().max(CHANGE);
        let at = |sign: f64| {
            let mut moved = values.clone();
            moved[k] += sign * step;
            coefficient(fit.law.law(&moved).ok()?.as_ref(), slip)
        };
        gradient.push((at(1.0)? - at(-1.0)?) / (2.0 * step));
    }
    let size = gradient.len();
    let product = |i: usize| -> f64 {
        (0..size)
            .map(|j| covariance[i * size + j] * gradient[j])
            .sum()
    };
    let variance: f64 = (0..size).map(|i| gradient[i] * product(i)).sum();
    Some((chi_squared_of_one(confidence) * variance.max(0.0)).sqrt())
}

/// The law of the scene at the edge of `own`.
pub fn law_of(own: &SpecimenScene) -> Option<&dyn FrictionLaw> {
    let contact = own.contact()?;
    Some(own.scene.contacts[contact].law.as_ref())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn law(text: &str) -> Box<dyn FrictionLaw> {
        serde_json::from_str(text).unwrap()
    }

    #[test]
    fn a_coefficient_is_that_of_the_slip_path_alone() {
        let text = r#"{ "slip_power": { "static": 0.4, "dynamic": 0.2, "slip_scale": 0.002, "exponent": 2.0 } }"#;
        let transition = law(text);
        assert_eq!(coefficient(transition.as_ref(), 0.0), Some(0.4));
        let after = coefficient(transition.as_ref(), 0.002).unwrap();
        assert!((after - 0.25).abs() < 1e-12, "{after}");
        assert!(passes(transition.as_ref(), 0.001));
        let constant = law(r#"{ "coulomb": { "mu": 0.3 } }"#);
        assert!(!passes(constant.as_ref(), 1.0));
        let text =
            r#"{ "pressure_power": { "mu": 0.3, "reference_pressure": 100.0, "exponent": 0.8 } }"#;
        assert_eq!(coefficient(law(text).as_ref(), 0.0), None);
    }
}
