//! Holes without contact: hoop stress at the edge.
//!
//! ```text
//! σ_θ/S = (E_θ/E₁) [−k cos²θ + (1 + n) sin²θ],   k = √(E₁/E₂),   n = √(2(k − ν₁₂) + E₁/G₁₂)
//! 1/E_θ = sin⁴θ/E₁ + (1/G₁₂ − 2ν₁₂/E₁) sin²θ cos²θ + cos⁴θ/E₂
//! ```
//!
//! for an infinite orthotropic plate under tension S along its 1-axis (Lekhnitskii 1968); with E_θ along the edge's tangent.

use super::check::Tolerance::Relative;
use super::check::{Check, Checks, percent};
use super::laboratory::{KSI, Laboratory, Worst};
use super::rigid_pin::stresses;
use crate::publish::TaskError;

/// Allowed error.
const BOUND: f64 = 1e-3;
/// Howland's problem at d/W = 0.5: largest hoop stress over the remote stress.
const HOWLAND: f64 = 4.34760;

pub(super) fn checks(laboratory: &Laboratory) -> Result<Vec<Check>, TaskError> {
    let mut checks = Checks::against("Howland's problem solved anew, 6 digits");
    let results = laboratory.run("open-hole", &[])?;
    let (tension, [_, hoop, _]) = (100.0, stresses(&results, 0, 90.0)?);
    checks.near(
        "strip d/W = 0.5: σ_θ/S at 90°",
        [hoop / tension, HOWLAND],
        Relative(BOUND, ""),
    );

    checks.now_against("Lekhnitskii 1968, closed form");
    let results = laboratory.run("validation/open-hole-orthotropic", &[])?;
    // 10 times the tension of 1 ksi in the table.
    let tension = 10.0 * KSI;
    for angle in [0.0, 45.0, 90.0] {
        checks.near(
            format!("orthotropic plate: σ_θ/S at {angle}°"),
            [
                stresses(&results, 0, angle)?[1] / tension,
                lekhnitskii(angle.to_radians()),
            ],
            Relative(BOUND, ""),
        );
    }
    let peak = lekhnitskii(std::f64::consts::FRAC_PI_2);
    let mut worst = Worst::default();
    let (geometry, edge) = (&results.edges[0], &results.steps[0].edges[0]);
    for (row, &theta) in edge.rows.iter().zip(&geometry.parameter) {
        let error = (row.sigma_tangential / tension - lekhnitskii(theta)).abs() / peak;
        worst.meet(error, || {
            format!(
                "worst of {} nodes at {:.2}°",
                edge.rows.len(),
                theta.to_degrees()
            )
        });
    }
    checks.error_below("orthotropic plate: σ_θ, of its peak", worst, BOUND);
    checks.show(
        "orthotropic plate: force on the idle pin, of S R t",
        "0",
        percent(edge.normal_force / (tension * 25.4 * 25.4)),
    );
    Ok(checks.into_list())
}

fn lekhnitskii(theta: f64) -> f64 {
    let (e1, e2, g12, nu12): (f64, f64, f64, f64) = (12400.0, 3730.0, 3210.0, 0.66);
    let (s, c) = theta.sin_cos();
    let k = (e1 / e2).sqrt();
    let n = (2.0 * (k - nu12) + e1 / g12).sqrt();
    let compliance =
        s.powi(4) / e1 + (1.0 / g12 - 2.0 * nu12 / e1) * s * s * c * c + c.powi(4) / e2;
    (-k * c * c + (1.0 + n) * s * s) / (e1 * compliance)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Values of the complex potentials, 7 decimals.
    #[test]
    fn the_closed_form_agrees_with_the_potentials() {
        for (degrees, expected) in [
            (0.0_f64, -0.5484582),
            (45.0, 0.4847828),
            (60.0, 1.7321202),
            (90.0, 3.4878734),
        ] {
            assert!((lekhnitskii(degrees.to_radians()) - expected).abs() < 6e-8);
        }
    }
}
