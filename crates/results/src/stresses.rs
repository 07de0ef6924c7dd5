//! The largest stresses of a body, at its nodes.
//!
//! ```text
//! σ_vM = √(½ [(σ_xx − σ_yy)² + (σ_yy − σ_zz)² + (σ_zz − σ_xx)²] + 3 τ_xy²),   σ_1,2 = ½ (σ_xx + σ_yy) ± √(¼ (σ_xx − σ_yy)² + τ_xy²)
//! ```
//!
//! Von Mises (1913) with τ_xz = τ_yz = 0; σ_zz is zero in plane stress and holds ε_zz = 0 in plane strain.

/// A stress and its place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StressPeak {
    /// `[MPa]`
    pub stress: f64,
    /// Place x, y `[mm]`.
    pub at: [f64; 2],
    /// By how much it is larger at nodes of cells that are left out in part, where stresses have no bound `[MPa]`.
    pub beyond: f64,
    /// Estimated error `[MPa]`, where an accuracy was sought and the stress has a limit.
    pub error: Option<f64>,
}

/// The largest stresses of a body at the end of a load step. Places within two fifths of the body's smaller side of a held point, and within a twentieth of the end
/// of a supported edge or platen, are left out: stresses have no bound there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BodyStresses {
    /// Index of the body in [`Results::bodies`](super::Results::bodies).
    pub body: usize,
    /// The largest von Mises stress.
    pub von_mises: StressPeak,
    /// The largest principal stress in the plane, tension positive.
    pub largest_principal: StressPeak,
    /// The least principal stress in the plane, the largest compression.
    pub least_principal: StressPeak,
}

/// The von Mises stress `[stress]` of (σ_xx, σ_yy, τ_xy) and σ_zz `[stress]`, √(½ Σ (σ_i − σ_j)² + 3 τ_xy²).
pub fn von_mises([xx, yy, xy]: [f64; 3], zz: f64) -> f64 {
    let differences = [xx - yy, yy - zz, zz - xx];
    let normal: f64 = differences.iter().map(|d| d * d).sum();
    (0.5 * normal + 3.0 * xy * xy).sqrt()
}

/// The principal stresses `[stress]` in the plane of (σ_xx, σ_yy, τ_xy) `[stress]`, the larger first (Mohr's circle).
pub fn principal([xx, yy, xy]: [f64; 3]) -> [f64; 2] {
    let (mean, half) = (0.5 * (xx + yy), 0.5 * (xx - yy));
    let radius = half.hypot(xy);
    [mean + radius, mean - radius]
}

#[cfg(test)]
mod tests {
    use super::{principal, von_mises};

    #[test]
    fn von_mises_of_tension_shear_and_pressure() {
        assert_eq!(von_mises([100.0, 0.0, 0.0], 0.0), 100.0);
        // Pure shear yields at 1/√3 of the tension; two roundings.
        assert!((von_mises([0.0, 0.0, 1.0], 0.0) - 3_f64.sqrt()).abs() < 1e-15);
        assert_eq!(von_mises([-7.0, -7.0, 0.0], -7.0), 0.0);
        // Uniaxial tension 100 in plane strain, ν = 0.3: 100 √(1 − ν + ν²) = 88.88.
        let held = von_mises([100.0, 0.0, 0.0], 30.0);
        assert!((held - 100.0 * 0.79_f64.sqrt()).abs() < 1e-12);
    }

    #[test]
    fn principal_stresses_of_shear_and_tension() {
        assert_eq!(principal([0.0, 0.0, 3.0]), [3.0, -3.0]);
        assert_eq!(principal([0.0, 5.0, 0.0]), [5.0, 0.0]);
    }
}
