//! Initial gaps from the true geometry, never from the facets of a mesh.
//!
//! Conforming circles, hole radius R, pin radius R − c (c: radial clearance), pin's centre displaced by e from the hole's:
//!
//! ```text
//! g₀(θ) = R − [e·e_r + √((R − c)² − |e|² + (e·e_r)²)]
//! ```
//!
//! First contact at θ = 0 is e = (c, 0); to first order in c/R that is c (1 − cos θ). Interference (c < 0) starts
//! concentric, e = 0. A cylinder of radius R on a plane: g₀(x) = R − √(R² − x²) ≈ x²/2R.

/// Gap `[length]` along the radius at angle `theta` `[rad]` between a hole of `radius` and a pin smaller by `clearance` (both `[length]`), whose
/// centre lies at `offset` from the hole's. NaN if the radius at `theta` misses the pin.
pub fn circles(radius: f64, clearance: f64, offset: [f64; 2], theta: f64) -> f64 {
    let pin = radius - clearance;
    let along = offset[0] * theta.cos() + offset[1] * theta.sin();
    // |e|² − (e·e_r)² is the square of the part of e across the radius.
    let across = offset[1] * theta.cos() - offset[0] * theta.sin();
    clearance - along + across * across / (pin + (pin * pin - across * across).sqrt())
}

/// The same gap `[length]` to first order in the clearance: c − e·e_r.
pub fn circles_linearised(clearance: f64, offset: [f64; 2], theta: f64) -> f64 {
    clearance - offset[0] * theta.cos() - offset[1] * theta.sin()
}

/// Gap `[length]` at `x` between a plane and a cylinder of `radius` `[length]` that touches it at x = 0. NaN beyond the radius.
pub fn cylinder(radius: f64, x: f64) -> f64 {
    x * x / (radius + (radius * radius - x * x).sqrt())
}

/// The same gap to second order, x²/2R `[length]`.
pub fn cylinder_linearised(radius: f64, x: f64) -> f64 {
    x * x / (2.0 * radius)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn circles_agree_with_the_direct_formula() {
        let (radius, clearance): (f64, f64) = (0.375, 0.02);
        for k in 0..=36 {
            let theta = f64::from(k) * std::f64::consts::PI / 36.0;
            let pin = radius - clearance;
            let direct = radius
                - (clearance * theta.cos()
                    + (pin * pin - (clearance * theta.sin()).powi(2)).sqrt());
            assert!((circles(radius, clearance, [clearance, 0.0], theta) - direct).abs() < 1e-15);
        }
        assert_eq!(circles(radius, clearance, [clearance, 0.0], 0.0), 0.0);
        assert!((circles(radius, -clearance, [0.0, 0.0], 1.2) + clearance).abs() < 1e-16);
    }

    #[test]
    fn the_exact_gap_approaches_the_linearised_one_with_the_square_of_the_clearance() {
        let error = |clearance: f64| {
            let exact = circles(1.0, clearance, [clearance, 0.0], 1.0);
            (exact - circles_linearised(clearance, [clearance, 0.0], 1.0)).abs()
        };
        assert!((error(1e-3) / error(5e-4) - 4.0).abs() < 1e-2);
        let cylinder_error = |x: f64| (cylinder(2.0, x) - cylinder_linearised(2.0, x)).abs();
        assert!((cylinder_error(1e-1) / cylinder_error(5e-2) - 16.0).abs() < 0.1);
    }

    #[test]
    fn tiny_clearances_keep_their_digits() {
        let clearance = 1e-12;
        let gap = circles(1.0, clearance, [clearance, 0.0], 1.0);
        assert!((gap / (clearance * (1.0 - 1.0_f64.cos())) - 1.0).abs() < 1e-11);
    }
}
