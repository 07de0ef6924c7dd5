//! Cylinder on a block of the same material: Hertz, and Cattaneo–Mindlin partial slip over a cycle.
//!
//! ```text
//! a² = 4PR/(πE*),   p₀ = 2P/(πa),   p = p₀ √(1 − x²/a²),   c = a √(1 − k),   k = Q/(μP)
//! q = μp₀ [√(1 − x²/a²) − (c/a) √(1 − x²/c²)]                                    Q = kμP
//! q = μp₀ [r(a) − r(c) − 2 (r(a) − r(c'))],   r(b) = (b/a) √(1 − x²/b²),  c' = a √(1 − k/2)     back at Q = 0
//! ```
//!
//! for half-planes (Hertz 1882; Cattaneo 1938; Mindlin 1949; Mindlin & Deresiewicz 1953). The numbers are those of
//! `scenes/hertz-cylinder.toml` (R = 50 mm, P = 500 N/mm) and `scenes/cattaneo-mindlin.toml` (R = 500 mm, P = 50 N/mm), which
//! have the same half-width.

/// Contact half-width a `[mm]`.
pub const HALF_WIDTH: f64 = 0.88093648;
/// Peak pressure p₀ `[MPa]` with R = 50 mm; with R = 500 mm it is a tenth.
pub const PEAK: f64 = 361.33126;
/// Coefficient of friction of the cycle `[1]`.
pub const FRICTION: f64 = 0.4;
/// Stick half-width c `[mm]` at Q = 0.5 μP.
pub const STICK: f64 = 0.62291616;
/// Work lost in a full cycle between ±0.5 μP, R = 500 mm `[N·mm/mm]`.
pub const CYCLE: f64 = 3.5296463e-4;

/// Stick half-width c' `[mm]` of the reversed slip, back at Q = 0.
pub fn reversed_stick() -> f64 {
    HALF_WIDTH * 0.75_f64.sqrt()
}

/// Pressure p/p₀ `[1]` at `x` `[mm]`.
pub fn pressure(x: f64) -> f64 {
    root(HALF_WIDTH, x)
}

/// Shear q/(μp₀) `[1]` at `x` `[mm]`, Q = 0.5 μP.
pub fn shear_loaded(x: f64) -> f64 {
    root(HALF_WIDTH, x) - root(STICK, x)
}

/// Shear q/(μp₀) `[1]` at `x` `[mm]`, back at Q = 0.
pub fn shear_returned(x: f64) -> f64 {
    shear_loaded(x) - 2.0 * (root(HALF_WIDTH, x) - root(reversed_stick(), x))
}

/// (b/a) √(1 − x²/b²), zero beyond b.
fn root(b: f64, x: f64) -> f64 {
    (b * b - x * x).max(0.0).sqrt() / HALF_WIDTH
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn resultants_are_the_loads() {
        // ∫ p dx = P = 500 N/mm; ∫ q dx = 0.5 μP of its own P = 50 N/mm, and 0 on return.
        let integral = |f: fn(f64) -> f64| -> f64 {
            let (count, step) = (200_000, 2.0 * HALF_WIDTH / 200_000.0);
            (0..count)
                .map(|k| f(-HALF_WIDTH + (f64::from(k) + 0.5) * step) * step)
                .sum()
        };
        let force = PEAK * integral(pressure);
        assert!((force / 500.0 - 1.0).abs() < 1e-6, "{force}");
        let shear = 0.1 * FRICTION * PEAK * integral(shear_loaded);
        assert!((shear / (0.5 * FRICTION * 50.0) - 1.0).abs() < 1e-6);
        assert!(integral(shear_returned).abs() < 1e-6);
    }
}
