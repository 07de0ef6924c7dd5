//! The state at a point: of the potentials of an isotropic body, and of any.

use nalgebra::Complex;

type C64 = Complex<f64>;

/// Potentials at a point, in radii.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Local {
    /// φ′.
    pub(super) phi: C64,
    /// φ″.
    pub(super) slope: C64,
    /// ψ′.
    pub(super) psi: C64,
    /// κφ − conj ψ, without −ζ conj φ′.
    pub(super) motion: C64,
    /// σ_xx + σ_yy and σ_yy − σ_xx + 2iσ_xy of a force spread over the area.
    pub(super) spread: (f64, C64),
}

impl Local {
    pub(super) fn state(&self, zeta: C64) -> State {
        State {
            sum: 4.0 * self.phi.re + self.spread.0,
            difference: 2.0 * (zeta.conj() * self.slope + self.psi) + self.spread.1,
            motion: self.motion - zeta * self.phi.conj(),
        }
    }
}

/// State at a point.
pub(super) struct State {
    /// σ_xx + σ_yy.
    pub(super) sum: f64,
    /// σ_yy − σ_xx + 2iσ_xy.
    pub(super) difference: C64,
    /// Displacement by the potentials in their unit.
    pub(super) motion: C64,
}
