//! Potentials of a disk.
//!
//! ```text
//! φ′ = Σ_{m ≥ 2} t_{1+m} ζ^m + Re t_1/2 + α_1 ζ + a/ζ,
//! ψ′ = Σ_{m ≥ 2} [(1 − m) t_{1+m} − conj t_{1−m}] ζ^{m−2} − κ conj a/ζ + i Im t_1/ζ²
//! centre:  a = t_0/(1 + κ),  α_1 = t_2 − 2 conj a          area:  a = 0,  α_1 = t_2 − conj t_0/κ,  and 2G u/R = (κ − 1)/κ t_0 |ζ|²
//! ```

use nalgebra::Complex;

use super::Local;
use super::hats::Hats;

type C64 = Complex<f64>;

/// Modes that are kept for points near the centre, and how near: 0.5^54 is below rounding.
const MODES: i64 = 54;
const NEAR: f64 = 0.5;

/// A disk's potentials beside its hats.
#[derive(Clone, Debug)]
pub(crate) struct Inside {
    /// Whether the net force is balanced at the centre.
    centred: bool,
    /// t_K, K = −MODES to MODES.
    modes: Vec<C64>,
}

impl Inside {
    pub(crate) fn new(hats: &Hats, centred: bool) -> Self {
        Self {
            centred,
            modes: (-MODES..=MODES).map(|order| hats.mode(order)).collect(),
        }
    }

    pub(crate) fn mode(&self, order: i64) -> C64 {
        self.modes[(order + MODES) as usize]
    }

    /// What is to be added to the motion of the potentials, so that displacements count as in the operator: translation in units of R/2G, and turn.
    pub(crate) fn rigid(&self, kappa: f64, [coupling, mean]: [f64; 2]) -> (C64, f64) {
        let [t0, t1, t2] = [0, 1, 2].map(|order| self.mode(order));
        let spread = if self.centred {
            C64::new(0.0, 0.0)
        } else {
            t0 * (kappa - 1.0) / kappa
        };
        let of_potentials = spread - self.linear(kappa).conj();
        let wanted = mean * t0 - coupling * t2.conj();
        (wanted - of_potentials, t1.im)
    }

    /// a.
    fn source(&self, kappa: f64) -> C64 {
        if self.centred {
            self.mode(0) / (1.0 + kappa)
        } else {
            C64::new(0.0, 0.0)
        }
    }

    /// α_1.
    fn linear(&self, kappa: f64) -> C64 {
        let t0 = self.mode(0).conj();
        let factor = if self.centred {
            2.0 / (1.0 + kappa)
        } else {
            1.0 / kappa
        };
        self.mode(2) - factor * t0
    }

    pub(super) fn at(&self, hats: &Hats, zeta: C64, kappa: f64) -> Local {
        let mut local = if zeta.norm() < NEAR {
            self.near(zeta, kappa)
        } else {
            self.far(hats, zeta, kappa)
        };
        let (t0, t1) = (self.mode(0), self.mode(1));
        let linear = self.linear(kappa);
        local.phi += 0.5 * t1.re + linear * zeta;
        local.slope += linear;
        local.motion += kappa * (0.5 * t1.re * zeta + 0.5 * linear * zeta * zeta);
        if t1.im != 0.0 {
            let turn = C64::new(0.0, t1.im);
            local.psi += turn / (zeta * zeta);
            local.motion += (turn / zeta).conj();
        }
        if self.centred {
            let a = self.source(kappa);
            if a != C64::new(0.0, 0.0) {
                local.phi += a / zeta;
                local.slope -= a / (zeta * zeta);
                local.psi -= kappa * a.conj() / zeta;
                local.motion += 2.0 * kappa * a * zeta.norm().ln();
            }
        } else {
            local.motion += t0 * ((kappa - 1.0) / kappa * zeta.norm_sqr());
            let sum = 4.0 / kappa * (t0 * zeta.conj()).re;
            let difference = -2.0 * (kappa - 1.0) / kappa * t0.conj() * zeta.conj();
            local.spread = (sum, difference);
        }
        local
    }

    /// The sums over m ≥ 2, by modes.
    fn near(&self, zeta: C64, kappa: f64) -> Local {
        let mut local = Local::default();
        let [mut phi, mut psi] = [C64::new(0.0, 0.0); 2];
        // ζ^{m−2}.
        let mut power = C64::new(1.0, 0.0);
        for order in 2..MODES {
            let m = order as f64;
            let (own, other) = (self.mode(1 + order), self.mode(1 - order).conj());
            let beta = (1.0 - m) * own - other;
            local.psi += beta * power;
            psi += beta * power * zeta / (m - 1.0);
            local.slope += m * own * power * zeta;
            local.phi += own * power * zeta * zeta;
            phi += own * power * zeta * zeta * zeta / (m + 1.0);
            power *= zeta;
        }
        local.motion = kappa * phi - psi.conj();
        local
    }

    /// The sums over m ≥ 2, in closed form.
    fn far(&self, hats: &Hats, zeta: C64, kappa: f64) -> Local {
        let (t1, t2) = (self.mode(1), self.mode(2));
        let [rising, sum, falling] = hats.positive(zeta);
        let [_, other, other_falling] = hats.negative(zeta.conj());
        let square = zeta * zeta;
        let phi = falling - t1 * zeta - 0.5 * t2 * square;
        let psi = -(sum - t1 * zeta) / square + t2 - other_falling.conj();
        Local {
            phi: sum / zeta - t1 - t2 * zeta,
            slope: (rising - sum) / square - t2,
            psi: ((2.0 * sum - rising) / zeta - t1) / square - other.conj() / zeta,
            motion: kappa * phi - psi.conj(),
            spread: (0.0, C64::new(0.0, 0.0)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::nodes::Nodes;

    #[test]
    fn both_ways_agree_where_they_meet() {
        let nodes = Nodes::circle((0..20).map(|k| 0.31 * f64::from(k)).collect()).unwrap();
        let values: Vec<C64> = (0..20)
            .map(|k| C64::new(f64::from(k * k % 7) - 2.5, f64::from(k * k % 5)))
            .collect();
        let hats = Hats::new(&nodes, &values);
        let inside = Inside::new(&hats, false);
        for k in 0..12 {
            let zeta = C64::from_polar(0.49, 0.5 * f64::from(k));
            let (near, far) = (inside.near(zeta, 2.0), inside.far(&hats, zeta, 2.0));
            let differences = [
                near.phi - far.phi,
                near.slope - far.slope,
                near.psi - far.psi,
                near.motion - far.motion,
            ];
            let largest = differences.iter().map(|d| d.norm()).fold(0.0, f64::max);
            assert!(largest < 1e-12, "{largest:e}");
        }
    }
}
