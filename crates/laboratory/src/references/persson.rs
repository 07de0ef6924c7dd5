//! Frictionless pin of the plate's own material in an infinite plate.
//!
//! ```text
//! p R t/Q = 2√(b² − y²) / (π√(1 + b²)(1 + y²)) + L(y) / (2π b²(1 + b²)),   b = tan ε/2,  y = tan φ/2
//! L(y) = ln[(√(1 + b²) + √(b² − y²)) / (√(1 + b²) − √(b² − y²))]
//! σ_θ = −p + 2 a₀ + (3 − ν)/2 · Q/(π R t) cos θ,   a₀ = (1/2π) ∮ p dφ
//! ```
//!
//! for the contact half-angle ε (Persson 1964; Ciavarella & Decuzzi 2001).

use std::f64::consts::PI;

/// Contact half-angles `[deg]` of the steps of `scenes/pin-infinite-plate.toml`, and the load factors Q/(Rt) `[MPa]` that
/// belong to them.
pub const STEPS: [(f64, f64); 3] = [
    (25.0, 0.0582353975),
    (45.0, 0.247952509),
    (65.0, 0.94350039),
];

/// Pressure p R t/Q `[1]` at the angle `phi` `[rad]` from the bearing point, for the contact half-angle `epsilon` `[rad]`.
pub fn pressure(epsilon: f64, phi: f64) -> f64 {
    let (b, y) = ((epsilon / 2.0).tan(), (phi / 2.0).tan());
    if y.abs() >= b {
        return 0.0;
    }
    let (whole, rest) = ((1.0 + b * b).sqrt(), (b * b - y * y).sqrt());
    let logarithm = ((whole + rest) / (whole - rest)).ln();
    2.0 * rest / (PI * whole * (1.0 + y * y)) + logarithm / (2.0 * PI * b * b * (1.0 + b * b))
}

/// Hoop stress σ_θ R t/Q `[1]` at the net section, θ = 90°, for the contact half-angle `epsilon` `[rad]`, where the pin does not touch: 2 a₀, to nine digits or more. The pressure ends like a
/// root, which the midpoint rule in φ = ε sin t integrates with exponential accuracy.
pub fn hoop_at_net_section(epsilon: f64) -> f64 {
    const POINTS: u32 = 400;
    let step = PI / 2.0 / f64::from(POINTS);
    let half: f64 = (0..POINTS)
        .map(|k| {
            let t = (f64::from(k) + 0.5) * step;
            pressure(epsilon, epsilon * t.sin()) * epsilon * t.cos() * step
        })
        .sum();
    2.0 * half / PI
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Values of an independent evaluation (Chebyshev collocation of the contact equation agrees to 1e-13), 7 digits.
    #[test]
    fn the_closed_form_gives_tabulated_pressures() {
        for (half_angle, part, expected) in [
            (25.0_f64, 0.0, 1.495362),
            (25.0, 0.5, 1.294082),
            (45.0, 0.9, 0.3758761),
            (65.0, 0.3, 0.6394607),
        ] {
            let epsilon = half_angle.to_radians();
            let error = pressure(epsilon, part * epsilon) / expected - 1.0;
            assert!(error.abs() < 5e-7, "{half_angle}°, {part}: {error:e}");
        }
    }

    /// From the same evaluation, 6 digits.
    #[test]
    fn the_hoop_stress_is_the_tabulated_one() {
        for (half_angle, expected) in [(25.0_f64, 0.326001), (45.0, 0.343982), (65.0, 0.373824)] {
            let error = hoop_at_net_section(half_angle.to_radians()) / expected - 1.0;
            assert!(error.abs() < 2e-6, "{half_angle}°: {error:e}");
        }
    }
}
