//! The two complex planes of an anisotropic plate.
//!
//! ```text
//! w_k = (x + μ_k y)/R = ½[(1 − iμ_k) ζ_k + (1 + iμ_k)/ζ_k],     |ζ_k| ≥ 1 outside of the hole, ζ_k = e^{iθ} on it
//! dF/ds = σ n = 2 Re Σ (μ_k, −1) φ_k dw_k/ds,     du/ds = 2 Re Σ (p_k, q_k) φ_k dw_k/ds       φ_k = Φ_k′, n to the right of ds
//! stress σ e_r on the circle t(θ) = 2 Re Σ_{n ≥ 0} T_n e^{−inθ}:     φ_k dw_k/dθ = (L⁻¹ Σ T_n ζ_k^−n)_k,     L = [μ_1, μ_2; −1, −1]
//! ```
//!
//! A mean stress t_0, the hole's net force, has T_0 = t_0/2 + is with Re M T_0 = 0, so that displacements have one value.
//!
//! Source: Lekhnitskii, *Anisotropic Plates* (1968), §§ 8, 27.

use nalgebra::{Complex, Matrix3, Vector4};
use stickslip_fem_core::material::PlaneStiffness;

use super::{Lekhnitskii, roots};

type C64 = Complex<f64>;

/// The planes of a plate whose roots differ.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Planes {
    /// μ_k.
    mu: [C64; 2],
    /// (p_k, q_k).
    moving: [[C64; 2]; 2],
    matrix: Lekhnitskii,
}

impl Planes {
    /// Those of the compliance `compliance` `[1/stress]`; `None` if it is that of no stable material, or of an isotropic one.
    pub(crate) fn new(compliance: &PlaneStiffness) -> Option<Self> {
        /// Distance of the roots below which too many digits are lost between the planes.
        const EQUAL: f64 = 1e-6;
        let [[a11, a12, a16], [_, a22, a26], _] = *compliance;
        let (sum, product) = roots(compliance)?;
        let root = (sum * sum - 4.0 * product).sqrt();
        let mu = [0.5 * (sum + root), 0.5 * (sum - root)];
        let moving = mu.map(|mu| [a11 * mu * mu + a12 - a16 * mu, a12 * mu + a22 / mu - a26]);
        let matrix = Lekhnitskii::new(compliance)?;
        (root.norm() > EQUAL * sum.norm()).then_some(Self { mu, moving, matrix })
    }

    pub(crate) fn matrix(&self) -> &Lekhnitskii {
        &self.matrix
    }

    /// w_k of a place, or dw_k of a step.
    pub(crate) fn at(&self, plane: usize, place: C64) -> C64 {
        place.re + self.mu[plane] * place.im
    }

    /// ζ_k of a place outside of the hole.
    pub(crate) fn exterior(&self, plane: usize, place: C64) -> C64 {
        let [falling, rising] = self.halves(plane);
        let w = self.at(plane, place);
        let root = (w * w - 4.0 * falling * rising).sqrt();
        let both = [w + root, w - root].map(|twice| twice / (2.0 * rising));
        if both[0].norm_sqr() >= both[1].norm_sqr() {
            both[0]
        } else {
            both[1]
        }
    }

    /// dw_k/dθ at ζ_k.
    pub(crate) fn slope(&self, plane: usize, zeta: C64) -> C64 {
        let [falling, rising] = self.halves(plane);
        C64::new(0.0, 1.0) * (rising * zeta - falling / zeta)
    }

    /// ½(1 + iμ_k) and ½(1 − iμ_k).
    fn halves(&self, plane: usize) -> [C64; 2] {
        let turned = C64::new(0.0, 0.5) * self.mu[plane];
        [0.5 + turned, 0.5 - turned]
    }

    /// L⁻¹ T.
    pub(crate) fn split(&self, [x, y]: [C64; 2]) -> [C64; 2] {
        let [one, two] = self.mu;
        let unit = (two - one).inv();
        [-(x + two * y) * unit, (x + one * y) * unit]
    }

    /// T_0 of the mean stress `t0`.
    pub(crate) fn mean(&self, t0: C64) -> [C64; 2] {
        let half = [0.5 * t0.re, 0.5 * t0.im];
        let [x, y] = self.matrix.apply(half.map(C64::from));
        let [[a, b], [c, d]] = self.matrix.imaginary();
        let unit = (a * d - b * c).recip();
        [
            C64::new(half[0], (d * x.re - b * y.re) * unit),
            C64::new(half[1], (a * y.re - c * x.re) * unit),
        ]
    }

    /// 2 Re Σ (μ_k, −1) v_k as x + iy: σ n of v_k = φ_k dw_k/ds.
    pub(crate) fn resultant(&self, [one, two]: [C64; 2]) -> C64 {
        let along = self.mu[0] * one + self.mu[1] * two;
        C64::new(2.0 * along.re, -2.0 * (one + two).re)
    }

    /// 2 Re Σ (p_k, q_k) v_k as x + iy.
    pub(crate) fn motion(&self, v: [C64; 2]) -> C64 {
        let [x, y] = [0, 1].map(|axis| {
            let sum = self.moving[0][axis] * v[0] + self.moving[1][axis] * v[1];
            2.0 * sum.re
        });
        C64::new(x, y)
    }

    /// σ_xx + σ_yy and σ_yy − σ_xx + 2iσ_xy of φ_k.
    pub(crate) fn stress(&self, phi: [C64; 2]) -> (f64, C64) {
        let sum = |factor: fn(C64) -> C64| {
            2.0 * (factor(self.mu[0]) * phi[0] + factor(self.mu[1]) * phi[1]).re
        };
        let [xx, yy, xy] = [sum(|mu| mu * mu), sum(|_| C64::from(1.0)), sum(|mu| -mu)];
        (xx + yy, C64::new(yy - xx, 2.0 * xy))
    }

    /// Factors (a, b) of Σ_{n ≥ 1} t_−n e^{−inθ} and of conj Σ_{n ≥ 1} t_n e^{inθ} in σ_rr + σ_θθ = Re(a … + b …) at the place e^{iθ} of the circle.
    pub(crate) fn factors(&self, direction: C64) -> [C64; 2] {
        let [x, y] = [[1.0, 0.0], [0.0, 1.0]].map(|unit| {
            let parts = self.split(unit.map(C64::from));
            let of = |plane: usize| {
                let mu = self.mu[plane];
                (1.0 + mu * mu) * parts[plane] / self.slope(plane, direction)
            };
            of(0) + of(1)
        });
        let i = C64::new(0.0, 1.0);
        [x - i * y, x + i * y]
    }

    /// σ_rr + σ_θθ at the place e^{iθ} of the circle by the mean stress `t0`.
    pub(crate) fn mean_on_edge(&self, t0: C64, direction: C64) -> f64 {
        let parts = self.split(self.mean(t0));
        let phi = [0, 1].map(|plane| parts[plane] / self.slope(plane, direction));
        self.stress(phi).0
    }

    /// T_n of the mode t e^{iKθ}, n = |K| ≥ 1.
    pub(crate) fn mode(order: i64, t: C64) -> [C64; 2] {
        let half_i = C64::new(0.0, 0.5);
        if order < 0 {
            [0.5 * t, -half_i * t]
        } else {
            [0.5 * t.conj(), half_i * t.conj()]
        }
    }

    /// T of the sums Σ t_n and Σ t_−n, the second of ζ^−n and the first of its conjugate.
    pub(crate) fn both(positive: C64, negative: C64) -> [C64; 2] {
        let [x, y] = Self::mode(1, positive);
        let [of_x, of_y] = Self::mode(-1, negative);
        [x + of_x, y + of_y]
    }

    /// A_k of the terms φ_k = A_k ln(1 − w_k/c_k), whose stress is even along each ray from a corner: that of ln r itself vanishes.
    pub(crate) fn corner(&self) -> [C64; 2] {
        let rows = [[C64::from(1.0); 2], self.mu, self.mu.map(|mu| mu * mu)]
            .map(|[one, two]| [one.re, -one.im, two.re, -two.im]);
        // The vector at right angles to all rows.
        let mut found = Vector4::from_fn(|axis, _| {
            let others: Vec<usize> = (0..4).filter(|&other| other != axis).collect();
            let minor = Matrix3::from_fn(|row, column| rows[row][others[column]]);
            let sign = if axis % 2 == 0 { 1.0 } else { -1.0 };
            sign * minor.determinant()
        });
        found.normalize_mut();
        [C64::new(found[0], found[1]), C64::new(found[2], found[3])]
    }

    /// Whether the plate is symmetric about the x axis.
    pub(crate) fn is_symmetric(&self) -> bool {
        const SAME: f64 = 1e-10;
        let image = self.image(0);
        let mirrored = -self.mu[0].conj();
        (self.mu[image] - mirrored).norm() < SAME * mirrored.norm()
    }

    /// The plane in which plane `plane` is after reflection in the x axis of a plate that is symmetric about it, w → conj w.
    pub(crate) fn image(&self, plane: usize) -> usize {
        let mirrored = -self.mu[plane].conj();
        let far = |other: usize| (self.mu[other] - mirrored).norm();
        if far(plane) <= far(1 - plane) {
            plane
        } else {
            1 - plane
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use stickslip_fem_core::material::{Material, Orthotropic, OrthotropicConstants};

    fn planes(angle: f64) -> Planes {
        let constants = OrthotropicConstants {
            e1: 140.0,
            e2: 9.0,
            g12: 5.0,
            nu12: 0.3,
        };
        let material = Orthotropic::new(constants, angle).unwrap();
        Planes::new(&material.compliance()).unwrap()
    }

    #[test]
    fn places_of_the_circle_have_one_parameter() {
        for angle in [0.0, 0.5, std::f64::consts::FRAC_PI_4] {
            let planes = planes(angle);
            for k in 0..20 {
                let direction = C64::from_polar(1.0, 0.3 * f64::from(k));
                for plane in 0..2 {
                    let outside = planes.exterior(plane, direction * (1.0 + 1e-9));
                    assert!((outside - direction).norm() < 1e-7, "{angle} {k} {plane}");
                    let turned = direction * C64::new(0.0, 1.0);
                    let slope = planes.slope(plane, direction);
                    assert!((planes.at(plane, turned) - slope).norm() < 1e-14);
                }
            }
        }
    }

    #[test]
    fn modes_give_back_their_stress_and_motion() {
        let planes = planes(0.5);
        let t = C64::new(0.3, -0.8);
        for (order, theta) in [(-3_i64, 0.4), (2, 1.9), (1, -2.0)] {
            let direction = C64::from_polar(1.0, theta);
            let power = direction.powi(-(order.abs() as i32));
            let turned = Planes::mode(order, t).map(|part| part * power);
            let found = planes.resultant(planes.split(turned));
            assert!((found - t * direction.powi(order as i32)).norm() < 1e-13);
            let [x, y] = planes.matrix.apply(turned).map(|part| 2.0 * part.re);
            let moved = planes.motion(planes.split(turned));
            assert!((moved - C64::new(x, y)).norm() < 1e-13 * moved.norm());
        }
        let even = planes.split(planes.mean(t));
        assert!((planes.resultant(even) - t).norm() < 1e-14);
        assert!(planes.motion(even).norm() < 1e-14 * planes.moving[0][0].norm());
    }
}
