//! Hole with an assumed cosine pressure in an infinite orthotropic plate, by complex potentials.
//!
//! ```text
//! p(θ) = 4P/(π D t) cos θ,  |θ| ≤ 90°;   σ_x = 2 Re Σ μ_k² φ_k'(z_k),  σ_y = 2 Re Σ φ_k'(z_k),  τ_xy = −2 Re Σ μ_k φ_k'(z_k)
//! z_k = x + μ_k y = (R/2) [(1 − i μ_k) ζ_k + (1 + i μ_k)/ζ_k],   μ⁴/E₁ + (1/G₁₂ − 2ν₁₂/E₁) μ² + 1/E₂ = 0,  Im μ_k > 0
//! ```
//!
//! with ψ_k = dφ_k/dθ on the edge |ζ| = 1. The traction p e_r on the plate gives
//!
//! ```text
//! 2 Re (ψ₁ + ψ₂) = R p sin θ,   2 Re (μ₁ψ₁ + μ₂ψ₂) = −R p cos θ
//! ```
//!
//! whose solutions outside the unit circle are Schwarz integrals of trigonometric polynomials over half a circle: in closed form, with one
//! logarithm. Their two imaginary constants follow from single-valued displacements. The force P is balanced at infinity by stresses
//! that fall like 1/r; there is no remote stress besides.
//!
//! In an isotropic plate σ_θ D t/P = −(4/π) cos⁺θ + 8/π² + (3 − ν)/π cos θ, which is 8/π² = 0.811 at ±90° whatever ν.
//!
//! Source: Lekhnitskii, *Anisotropic Plates* (1968), chapter 6; Savin, *Stress Distribution around Holes* (1961).

use std::f64::consts::{FRAC_PI_2, PI};

use nalgebra::{Complex, Matrix2, Vector2};

type C = Complex<f64>;
const I: C = C::new(0.0, 1.0);

/// Roots closer than this, relatively, leave too few digits.
const DISTINCT: f64 = 1e-6;

/// Elastic constants of a plate whose 1-axis is the load axis x.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plate {
    /// Young's modulus along x `[stress]`.
    pub e1: f64,
    /// Young's modulus along y `[stress]`.
    pub e2: f64,
    /// Shear modulus `[stress]`.
    pub g12: f64,
    /// Poisson's ratio −ε_y/ε_x for stress along x `[1]`.
    pub nu12: f64,
}

/// The solution for one plate. Lengths are over R, stresses over P/(D t).
#[derive(Clone, Debug)]
pub struct LoadedHole {
    /// μ₁, μ₂.
    roots: [C; 2],
    /// The imaginary constants of ψ₁ + ψ₂ and μ₁ψ₁ + μ₂ψ₂.
    constants: [f64; 2],
}

impl LoadedHole {
    /// The solution for `plate`; `None` for constants without positive strain energy, and for an isotropic plate, whose roots
    /// are equal: [`isotropic_hoop`] has that.
    pub fn new(plate: Plate) -> Option<Self> {
        let Plate { e1, e2, g12, nu12 } = plate;
        let positive = [e1, e2, g12].iter().all(|m| m.is_finite() && *m > 0.0);
        let stable = nu12 * nu12 < e1 / e2;
        if !(positive && stable) {
            return None;
        }
        // Halves of the coefficients over 1/E₁: μ⁴ + 2b μ² + c = 0.
        let (b, c) = (0.5 * e1 / g12 - nu12, e1 / e2);
        let root = C::from(b * b - c).sqrt();
        let roots = [root - b, -root - b].map(|square| {
            let mu = square.sqrt();
            if mu.im < 0.0 { -mu } else { mu }
        });
        if (roots[0] - roots[1]).norm() < DISTINCT * roots[0].norm() {
            return None;
        }
        let mut solution = Self {
            roots,
            constants: [0.0; 2],
        };
        solution.constants = solution.single_valued(plate)?;
        Some(solution)
    }

    /// Constants for which the displacements 2 Re Σ p_k φ_k and 2 Re Σ q_k φ_k return to themselves around the hole: the mean of
    /// dφ_k/dθ over the edge is its value at infinity.
    fn single_valued(&self, plate: Plate) -> Option<[f64; 2]> {
        let Plate { e1, e2, nu12, .. } = plate;
        let growth = |sums: [C; 2]| {
            let psi = self.split(sums);
            let total = |factor: &dyn Fn(C) -> C| -> f64 {
                let of = |k: usize| (factor(self.roots[k]) * psi[k]).re;
                of(0) + of(1)
            };
            // p = μ²/E₁ − ν₁₂/E₁ and q = −ν₁₂ μ/E₁ + 1/(E₂ μ), both times E₁.
            Vector2::new(
                total(&|mu| mu * mu - nu12),
                total(&|mu| mu * -nu12 + mu.inv() * (e1 / e2)),
            )
        };
        // Half of the mean of −R p cos θ, with P/t = D = 2.
        let resultant = C::from(-0.5 / PI);
        let matrix = Matrix2::from_columns(&[growth([I, C::from(0.0)]), growth([C::from(0.0), I])]);
        let constants = matrix.lu().solve(&-growth([C::from(0.0), resultant]))?;
        Some([constants[0], constants[1]])
    }

    /// ψ₁ and ψ₂ from ψ₁ + ψ₂ and μ₁ψ₁ + μ₂ψ₂.
    fn split(&self, [plain, weighted]: [C; 2]) -> [C; 2] {
        let [first, second] = self.roots;
        let difference = first - second;
        [
            (weighted - second * plain) / difference,
            (first * plain - weighted) / difference,
        ]
    }

    /// Stresses (σ_r, σ_θ, τ_rθ) D t/P `[1]` at the radius `r` ≥ 1, over R `[1]`, and the angle `theta` `[rad]` from the bearing point.
    pub fn polar_stresses(&self, r: f64, theta: f64) -> [f64; 3] {
        let (s, c) = theta.sin_cos();
        let [x, y, xy] = self.stresses([r * c, r * s]);
        [
            x * c * c + y * s * s + 2.0 * xy * s * c,
            x * s * s + y * c * c - 2.0 * xy * s * c,
            (y - x) * s * c + xy * (c * c - s * s),
        ]
    }

    /// Stresses (σ_x, σ_y, τ_xy) D t/P `[1]` at the place `[x, y]`, over R `[1]`, on or outside the edge.
    pub fn stresses(&self, [x, y]: [f64; 2]) -> [f64; 3] {
        let mut total = [0.0; 3];
        for (k, &mu) in self.roots.iter().enumerate() {
            let z = x + mu * y;
            let zeta = outside(z, mu);
            let psi = self.split(self.sums(zeta))[k];
            // dz/dζ, with R = 1.
            let stretch = ((1.0 - I * mu) - (1.0 + I * mu) / (zeta * zeta)) * 0.5;
            let slope = psi / (I * zeta * stretch);
            total[0] += 2.0 * (mu * mu * slope).re;
            total[1] += 2.0 * slope.re;
            total[2] -= 2.0 * (mu * slope).re;
        }
        total
    }

    /// ψ₁ + ψ₂ and μ₁ψ₁ + μ₂ψ₂ at `zeta`.
    fn sums(&self, zeta: C) -> [C; 2] {
        let [minus, zero, plus] = schwarz(zeta);
        // R p sin θ = (s² − s⁻²)/(iπ) and −R p cos θ = −(2 + s² + s⁻²)/π with s = e^{iθ}, R = 1 and P/t = D.
        [
            (plus - minus) / (I * PI) + I * self.constants[0],
            (zero * 2.0 + plus + minus) / -PI + I * self.constants[1],
        ]
    }
}

/// The point ζ, |ζ| ≥ 1, that is mapped to `z`.
fn outside(z: C, mu: C) -> C {
    let root = (z * z - 1.0 - mu * mu).sqrt();
    let larger = if (z + root).norm() >= (z - root).norm() {
        z + root
    } else {
        z - root
    };
    larger / (1.0 - I * mu)
}

/// (1/2π) ∫ sⁿ (1/2 + s/(ζ − s)) dt over |t| ≤ 90° with s = e^{it}, for n = −2, 0, 2. From one power to the next,
/// ∫ sⁿ⁺¹/(ζ − s) dt = ζ ∫ sⁿ/(ζ − s) dt − ∫ sⁿ dt.
fn schwarz(zeta: C) -> [C; 3] {
    // ∫ sⁿ dt for n = −2 … 2.
    let plain = [0.0, 2.0, PI, 2.0, 0.0];
    let logarithm = principal(1.0 + I / zeta) - principal(1.0 - I / zeta);
    let zero = -I * logarithm;
    let plus = (zero * zeta - plain[3]) * zeta - plain[4];
    let minus = ((zero + plain[2]) / zeta + plain[1]) / zeta;
    [
        minus + 0.5 * plain[0],
        zero + 0.5 * plain[2],
        plus + 0.5 * plain[4],
    ]
    .map(|integral| integral / (2.0 * PI))
}

/// The logarithm, and 0 at 0: at the ends of the pressure its factor vanishes.
fn principal(value: C) -> C {
    if value.norm() > 0.0 {
        value.ln()
    } else {
        C::from(0.0)
    }
}

/// Pressure D t/P `[1]` at `theta` `[rad]`.
pub fn pressure(theta: f64) -> f64 {
    if theta.abs() < FRAC_PI_2 {
        4.0 / PI * theta.cos()
    } else {
        0.0
    }
}

/// Hoop stress σ_θ D t/P `[1]` on the edge in an isotropic plate with Poisson's ratio `poisson` `[1]`, at `theta` `[rad]` in [−π, π].
pub fn isotropic_hoop(poisson: f64, theta: f64) -> f64 {
    8.0 / (PI * PI) + (3.0 - poisson) / PI * theta.cos() - pressure(theta)
}

#[cfg(test)]
mod tests {
    use super::*;

    const PLATES: [Plate; 3] = [
        Plate {
            e1: 12_400.0,
            e2: 3_730.0,
            g12: 3_210.0,
            nu12: 0.66,
        },
        // Roots off the imaginary axis: E₁/(2G₁₂) − ν₁₂ < √(E₁/E₂).
        Plate {
            e1: 22.0,
            e2: 22.0,
            g12: 34.0,
            nu12: 0.75,
        },
        Plate {
            e1: 140.0,
            e2: 10.0,
            g12: 5.0,
            nu12: 0.3,
        },
    ];

    fn plates() -> impl Iterator<Item = LoadedHole> {
        PLATES
            .into_iter()
            .map(|plate| LoadedHole::new(plate).unwrap())
    }

    #[test]
    fn tractions_on_the_edge_are_recovered() {
        for hole in plates() {
            for degrees in -179..=180 {
                let theta = f64::from(degrees).to_radians();
                let [radial, _, shear] = hole.polar_stresses(1.0, theta);
                let error = (radial + pressure(theta)).abs().max(shear.abs());
                assert!(error < 1e-10, "{degrees}°: {error:e}");
            }
        }
    }

    #[test]
    fn every_circle_balances_the_force() {
        const POINTS: u32 = 4000;
        for hole in plates() {
            for r in [1.5, 4.0, 12.0] {
                let mut force = [0.0; 3];
                for k in 0..POINTS {
                    let theta = 2.0 * PI * f64::from(k) / f64::from(POINTS);
                    let (s, c) = theta.sin_cos();
                    let [x, y, xy] = hole.stresses([r * c, r * s]);
                    let share = 2.0 * PI * r / f64::from(POINTS);
                    let traction = [x * c + xy * s, xy * c + y * s];
                    force[0] += share * traction[0];
                    force[1] += share * traction[1];
                    force[2] += share * r * (c * traction[1] - s * traction[0]);
                }
                // The traction of what lies outside carries −P, and P/t = D = 2.
                assert!((force[0] + 2.0).abs() < 1e-10, "{r}: {force:?}");
                assert!(
                    force[1].abs() < 1e-10 && force[2].abs() < 1e-10,
                    "{r}: {force:?}"
                );
            }
        }
    }

    /// du = ε_x dx + (γ_xy/2 − ω) dy, dv = (γ_xy/2 + ω) dx + ε_y dy with the rotation dω = (γ_xy,x/2 − ε_x,y) dx + (ε_y,x − γ_xy,y/2) dy,
    /// gradients by central differences, integrated once around the hole.
    #[test]
    fn displacements_return_around_the_hole() {
        const POINTS: u32 = 20_000;
        const STEP: f64 = 1e-5;
        for (hole, plate) in plates().zip(PLATES) {
            let strain = |[x, y]: [f64; 2]| {
                let [sx, sy, xy] = hole.stresses([x, y]);
                [
                    sx - plate.nu12 * sy,
                    sy * plate.e1 / plate.e2 - plate.nu12 * sx,
                    xy * plate.e1 / plate.g12,
                ]
            };
            let slope = |at: [f64; 2], axis: usize| {
                let mut ends = [at, at];
                ends[0][axis] -= STEP;
                ends[1][axis] += STEP;
                let [low, high] = ends.map(strain);
                [0, 1, 2].map(|i| (high[i] - low[i]) / (2.0 * STEP))
            };
            let (mut rotation, mut last, mut displacement, r) = (0.0, 0.0, [0.0; 2], 2.0);
            let step = 2.0 * PI / f64::from(POINTS);
            for k in 0..POINTS {
                let (s, c) = (f64::from(k) * step).sin_cos();
                let at = [r * c, r * s];
                let along = [-r * s * step, r * c * step];
                let (by_x, by_y) = (slope(at, 0), slope(at, 1));
                let turn =
                    along[0] * (0.5 * by_x[2] - by_y[0]) + along[1] * (by_x[1] - 0.5 * by_y[2]);
                // The trapezoidal rule; its error falls with the square of the step.
                rotation += 0.5 * (last + turn);
                last = turn;
                let [ex, ey, gamma] = strain(at);
                displacement[0] += ex * along[0] + (0.5 * gamma - rotation) * along[1];
                displacement[1] += (0.5 * gamma + rotation) * along[0] + ey * along[1];
            }
            rotation += 0.5 * last;
            let size = strain([r, 0.0])[0].abs();
            let largest = displacement
                .iter()
                .fold(rotation, |m: f64, v| m.abs().max(v.abs()));
            assert!(
                largest < 1e-6 * size,
                "{rotation:e} {displacement:?} {size}"
            );
        }
    }

    #[test]
    fn a_nearly_isotropic_plate_has_the_isotropic_hoop_stress() {
        // Roots i (1 ± δ): the plate differs from an isotropic one by δ².
        let delta: f64 = 1e-4;
        for poisson in [0.0, 0.3, 0.45] {
            let b = (2.0 * delta).cosh();
            let plate = Plate {
                e1: 1.0,
                e2: 1.0,
                g12: 0.5 / (b + poisson),
                nu12: poisson,
            };
            let hole = LoadedHole::new(plate).unwrap();
            for degrees in -180..=180 {
                let theta = f64::from(degrees).to_radians();
                let error = hole.polar_stresses(1.0, theta)[1] - isotropic_hoop(poisson, theta);
                assert!(error.abs() < 1e-7, "{poisson} {degrees}°: {error:e}");
            }
        }
    }

    #[test]
    fn the_net_section_of_an_isotropic_plate_is_known() {
        assert!((isotropic_hoop(0.3, FRAC_PI_2) - 8.0 / (PI * PI)).abs() < 1e-15);
        assert!((isotropic_hoop(0.1, -FRAC_PI_2) - 0.810_569).abs() < 1e-6);
    }

    #[test]
    fn impossible_and_isotropic_plates_are_refused() {
        let good = PLATES[0];
        for bad in [
            Plate { e1: 0.0, ..good },
            Plate {
                g12: f64::NAN,
                ..good
            },
            Plate { nu12: 2.0, ..good },
            Plate {
                e1: 1.0,
                e2: 1.0,
                g12: 0.5 / 1.3,
                nu12: 0.3,
            },
        ] {
            assert!(LoadedHole::new(bad).is_none(), "{bad:?}");
        }
    }
}
