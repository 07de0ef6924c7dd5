//! Potentials of a disk.
//!
//! ```text
//! φ′ = Σ_{m ≥ 2} t_{1+m} ζ^m + Re t_1/2 + α_1 ζ + a/ζ,
//! ψ′ = Σ_{m ≥ 2} [(1 − m) t_{1+m} − conj t_{1−m}] ζ^{m−2} − κ conj a/ζ + i Im t_1/ζ²
//! centre:  a = t_0/(1 + κ),  α_1 = t_2 − 2 conj a          area:  a = 0,  α_1 = t_2 − conj t_0/κ,  and 2G u/R = (κ − 1)/κ t_0 |ζ|²
//! ```

use nalgebra::Complex;

use super::hats::Hats;
use super::kink::{Kink, mode};
use super::state::Local;

type C64 = Complex<f64>;

/// A disk's potentials beside its hats.
#[derive(Clone, Debug)]
pub(crate) struct Inside {
    /// Whether the net force is balanced at the centre.
    centred: bool,
    /// t_0, t_1 and t_2.
    modes: [C64; 3],
}

impl Inside {
    /// Those of hats, of symmetric ones if they are `mirrored`.
    pub(crate) fn new(hats: &Hats, mirrored: bool, centred: bool) -> Self {
        Self::of(hats.mean, &hats.kinks, mirrored, centred)
    }

    /// The same of a traction with the mean `t0` and kinks.
    pub(super) fn of(t0: C64, kinks: &[Kink], mirrored: bool, centred: bool) -> Self {
        let mut modes = [t0, mode(kinks, 1), mode(kinks, 2)];
        if mirrored {
            // A moment of rounding would show near the centre.
            modes = modes.map(|t| t.re.into());
        }
        Self { centred, modes }
    }

    /// What is to be added to the motion of the potentials, so that displacements count as in the operator: translation in units of R/2G, and turn.
    pub(crate) fn rigid(&self, kappa: f64, [coupling, mean]: [f64; 2]) -> (C64, f64) {
        let [t0, t1, t2] = self.modes;
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
            self.modes[0] / (1.0 + kappa)
        } else {
            C64::new(0.0, 0.0)
        }
    }

    /// α_1.
    fn linear(&self, kappa: f64) -> C64 {
        self.modes[2] - self.coupling(kappa) * self.modes[0].conj()
    }

    /// Part of conj t_0 that α_1 is less than t_2.
    fn coupling(&self, kappa: f64) -> f64 {
        if self.centred {
            2.0 / (1.0 + kappa)
        } else {
            1.0 / kappa
        }
    }

    /// σ_rr + σ_θθ on the circle.
    pub(super) fn sum_on_edge(&self, hats: &Hats, theta: f64, kappa: f64) -> f64 {
        let direction = C64::from_polar(1.0, theta);
        let [positive, _] = hats.on_edge(theta, direction.conj());
        4.0 * positive.re + self.low_sum_on_edge(direction, kappa)
    }

    /// What t_0 and t_1 add to σ_rr + σ_θθ on the circle beside the sum over all positive modes.
    pub(crate) fn low_sum_on_edge(&self, direction: C64, kappa: f64) -> f64 {
        let [t0, t1, _] = self.modes;
        let spread = if self.centred { 0.0 } else { 1.0 / kappa };
        let of_force = self.source(kappa) + (spread - self.coupling(kappa)) * t0;
        4.0 * (of_force * direction.conj()).re - 2.0 * t1.re
    }

    pub(super) fn at(&self, hats: &Hats, zeta: C64, kappa: f64) -> Local {
        let mut local = match hats.enough(zeta) {
            Some(count) => near(hats, count, zeta, kappa),
            None => self.far(hats, zeta, kappa),
        };
        let [t0, t1, _] = self.modes;
        let linear = self.linear(kappa);
        local.phi += 0.5 * t1.re + linear * zeta;
        local.slope += linear;
        local.motion += kappa * (0.5 * t1.re * zeta + 0.5 * linear * zeta * zeta);
        // At the centre its mean over a small circle counts, which is none: a disk that is free to turn has a moment of rounding.
        if t1.im != 0.0 && zeta.norm_sqr() > 0.0 {
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

    /// The sums over m ≥ 2, in closed form.
    fn far(&self, hats: &Hats, zeta: C64, kappa: f64) -> Local {
        let [_, t1, t2] = self.modes;
        let [positive, negative] = hats.sums(zeta);
        let [rising, sum, falling] = positive;
        let [_, other, other_falling] = negative;
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

/// The sums over m ≥ 2, by modes.
fn near(hats: &Hats, count: usize, zeta: C64, kappa: f64) -> Local {
    let mut local = Local::default();
    let [mut phi, mut psi] = [C64::new(0.0, 0.0); 2];
    // ζ^{m−2}.
    let mut power = C64::new(1.0, 0.0);
    let mut m = 2.0;
    let pairs = || hats.modes(count + 3);
    for ([own, _], [_, other]) in pairs().skip(2).zip(pairs()) {
        let beta = (1.0 - m) * own - other.conj();
        let raised = power * zeta;
        let value = own * raised;
        local.psi += beta * power;
        psi += beta * raised / (m - 1.0);
        local.slope += value * m;
        local.phi += value * zeta;
        phi += value * zeta * zeta / (m + 1.0);
        power = raised;
        m += 1.0;
    }
    local.motion = kappa * phi - psi.conj();
    local
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::nodes::Nodes;

    #[test]
    fn a_moment_leaves_no_trace_at_the_centre() {
        let nodes = Nodes::circle((0..20).map(|k| 0.31 * f64::from(k)).collect()).unwrap();
        let values: Vec<C64> = (0..20)
            .map(|k| C64::new(f64::from(k).sin(), f64::from(3 * k).cos()))
            .collect();
        let hats = Hats::new(&nodes, &values);
        let inside = Inside::new(&hats, false, false);
        assert_ne!(inside.modes[1].im, 0.0);
        let centre = inside.at(&hats, C64::new(0.0, 0.0), 2.0).motion;
        let around =
            (0..8).map(|k| C64::from_polar(1e-6, f64::from(k) * std::f64::consts::FRAC_PI_4));
        let mean = around
            .map(|zeta| inside.at(&hats, zeta, 2.0).motion)
            .sum::<C64>()
            / 8.0;
        assert!((centre - mean).norm() < 1e-8, "{centre} {mean}");
    }

    #[test]
    fn both_ways_agree_where_they_meet() {
        let nodes = Nodes::circle((0..20).map(|k| 0.31 * f64::from(k)).collect()).unwrap();
        let values: Vec<C64> = (0..20)
            .map(|k| C64::new(f64::from(k * k % 7) - 2.5, f64::from(k * k % 5)))
            .collect();
        let hats = Hats::new(&nodes, &values);
        let inside = Inside::new(&hats, false, false);
        for k in 0..12 {
            let zeta = C64::from_polar(0.49, 0.5 * f64::from(k));
            let (near, far) = (near(&hats, 54, zeta, 2.0), inside.far(&hats, zeta, 2.0));
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
