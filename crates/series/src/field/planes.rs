//! Potentials of an anisotropic plate around a hole.
//!
//! ```text
//! φ_k = (L⁻¹ [T_0 + Σ_{n ≥ 1} T_n ζ_k^−n])_k dθ/dw_k + φ_k0(w_k)
//! Φ_k = (L⁻¹ [−i T_0 ln ζ_k + Σ_{n ≥ 1} i T_n ζ_k^−n/n])_k + Φ_k0(w_k)
//! ```
//!
//! φ_k0 are polynomials and terms of corners, whose own tractions on the hole are among the modes. Φ_k0 has no mean on the circle.

use nalgebra::Complex;

use super::hats::{Hats, wrapped};
use super::outside::Outside;
use super::state::State;
use crate::lekhnitskii::Planes;

type C64 = Complex<f64>;

/// σ_rr + σ_θθ at the angle `theta` of the circle.
pub(super) fn sum_on_edge(planes: &Planes, outside: &Outside, hats: &Hats, theta: f64) -> f64 {
    let direction = C64::from_polar(1.0, theta);
    let [mut positive, mut negative] = hats.on_edge(theta, C64::from(1.0));
    let mut power = direction;
    for [above, below] in &outside.modes {
        positive += above * power;
        negative += below * power.conj();
        power *= direction;
    }
    let [a, b] = planes.factors(direction);
    let phi = [0, 1].map(|plane| {
        let outer = outside.outer_planes.iter();
        outer.map(|outer| outer.phi(plane, direction)).sum::<C64>()
    });
    let modes = (a * negative + b * positive.conj()).re;
    modes + planes.mean_on_edge(hats.mean, direction) + planes.stress(phi).0
}

/// The state at a place of the plate.
pub(super) fn at(planes: &Planes, outside: &Outside, hats: &Hats, place: C64) -> State {
    let i = C64::new(0.0, 1.0);
    let [mut phi, mut integral] = [[C64::new(0.0, 0.0); 2]; 2];
    let even = planes.mean(hats.mean);
    for plane in 0..2 {
        let zeta = planes.exterior(plane, place);
        let [positive, negative] = outside.sums(hats, zeta.conj().inv());
        let [x, y] = Planes::both(positive[1], negative[1]);
        let stress = [x + even[0], y + even[1]];
        phi[plane] = planes.split(stress)[plane] / planes.slope(plane, zeta);
        let falling = Planes::both(positive[2], negative[2]);
        // The turn of all logarithms together moves nothing.
        let log = C64::new(zeta.norm().ln(), wrapped(zeta.arg() - place.arg()));
        integral[plane] = i * planes.split(falling)[plane] - i * log * planes.split(even)[plane];
        for outer in &outside.outer_planes {
            let [own, integrated] = outer.both(plane, place);
            phi[plane] += own;
            integral[plane] += integrated;
        }
    }
    let (sum, difference) = planes.stress(phi);
    State {
        sum,
        difference,
        motion: planes.motion(integral),
    }
}
