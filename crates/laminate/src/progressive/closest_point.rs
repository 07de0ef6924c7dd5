//! The Tsai–Hill quadratic as Hill's yield function, and the closest-point projection on it.
//!
//! ```text
//! φ²(σ) = σ · P σ = (σ₁/X)² − σ₁σ₂/(X_t X_c) + (σ₂/Y)² + (τ₁₂/S₁₂)²,     X, Y by the signs of σ₁, σ₂
//! yield         φ(σ) = 1 + H λ
//! flow          dε^p = dλ ∂φ/∂σ = (dλ/φ) P σ,     σ · dε^p = φ dλ
//!
//! step          S σ + μ P σ = ε* ,   μ = Δλ/φ,   φ (1 − H μ) = 1 + H λ_n
//! tangent       R − (R n)(R n)ᵀ / (n · R n + H φ²/(1 − H μ)),     R = (S + μ P)⁻¹,  n = P σ
//! ```
//!
//! ε* is the trial elastic strain, λ `[stress]` the hardening variable, H ≥ 0 `[1/stress]` the hardening: the plastic modulus in
//! a uniaxial test with strength X is H X². ε* is projected along the metric of S, so the plastic strain is normal to the surface at
//! the end of the step.
//!
//! *Interaction.* The criterion takes X of σ₁'s sign in the second term too, so its surface has a corner at σ₁ = 0, re-entrant for one sign of σ₂,
//! where no closest point is defined. Here the second term has 1/(X_t X_c) for both signs: the gradient is then continuous and the
//! surface convex. Both agree for X_t = X_c and in uniaxial stress, and differ by |1/X² − 1/(X_t X_c)| |σ₁σ₂| elsewhere.
//!
//! *Solution.* For given μ, σ is linear in ε* on each quadrant of (σ₁, σ₂) and exactly one quadrant contains its own σ, because
//! S + μ P belongs to a convex function. What is left is one equation for μ, written as
//!
//! ```text
//! (1 + H λ_n)/φ(μ) − (1 − H μ) = 0
//! ```
//!
//! whose left side increases and is concave on each quadrant, so Newton from μ = 0 rises to the root without overshoot; a bracket guards
//! the changes of quadrant.
//!
//! Sources: Hill (1950), chapter XII; Simo & Hughes, *Computational Inelasticity* (1998), 3.3 and 3.4 for plane stress.

use stickslip_fem_core::material::{PlaneStiffness, apply};

use super::error::ProgressiveError;
use crate::failure::needed_strength;
use crate::ply::Ply;
use crate::strengths::Strength;

const ITERATIONS: usize = 60;

/// Distance from the surface, relative to the yield stress, that is rounding: a few dozen operations in double precision.
const ROUNDING: f64 = 1e-14;

/// Distance accepted where rounding stops the iteration early.
const ACCEPTED: f64 = 1e-11;

/// The Tsai–Hill quadratic φ of one ply as yield function (Hill 1950, chapter XII), with its elastic compliance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct YieldSurface {
    compliance: PlaneStiffness,
    /// 1/X² for σ₁ negative and positive.
    along: [f64; 2],
    /// 1/Y² for σ₂ negative and positive.
    across: [f64; 2],
    /// Entry P₁₂.
    interaction: f64,
    shear: f64,
    hardening: f64,
}

/// Where a step of plasticity ends.
#[derive(Clone, Debug, PartialEq)]
pub struct ClosestPoint {
    /// Stress (σ₁, σ₂, τ₁₂) `[stress]`.
    pub stress: [f64; 3],
    /// Increment of the plastic strain (ε₁, ε₂, γ₁₂), dimensionless.
    pub plastic_increment: [f64; 3],
    /// Δλ `[stress]`, zero in an elastic step.
    pub hardening_increment: f64,
    /// ∂σ/∂ε* `[stress]`, symmetric.
    pub tangent: PlaneStiffness,
    /// |φ (1 − H μ)/(1 + H λ_n) − 1| after each iteration, dimensionless: empty in an elastic step, else falling quadratically.
    pub residuals: Vec<f64>,
}

/// σ for a given μ.
struct Point {
    stress: [f64; 3],
    /// R.
    tangent: PlaneStiffness,
    /// P σ.
    normal: [f64; 3],
    value: f64,
}

impl YieldSurface {
    /// Makes the surface of `ply` with yield stresses equal to its strengths, hardening by `hardening` = H `[1/stress]`.
    ///
    /// # Errors
    /// [`ProgressiveError::Failure`] without X_t, X_c, Y_t, Y_c and S₁₂; [`ProgressiveError::OpenYieldSurface`] unless
    /// Y < 2 min(X_t, X_c); [`ProgressiveError::Hardening`] unless H is finite and not negative.
    pub fn new(ply: &Ply, hardening: f64) -> Result<Self, ProgressiveError> {
        if !hardening.is_finite() || hardening < 0.0 {
            return Err(ProgressiveError::Hardening { value: hardening });
        }
        let strength = |strength: Strength| needed_strength("tsai_hill", ply, strength);
        let [xt, xc] = [strength(Strength::Xt)?, strength(Strength::Xc)?];
        let [yt, yc] = [strength(Strength::Yt)?, strength(Strength::Yc)?];
        let s12 = strength(Strength::S12)?;
        // 1/(X² Y²) > 1/(2 X_t X_c)² on every quadrant.
        let (larger, limit) = (yt.max(yc), 2.0 * xt.min(xc));
        if larger >= limit {
            return Err(ProgressiveError::OpenYieldSurface {
                ply: ply.name().to_owned(),
                across: larger,
                xt,
                xc,
                limit,
            });
        }
        let inverse_square = |value: f64| 1.0 / (value * value);
        Ok(Self {
            compliance: *ply.compliance(),
            along: [xc, xt].map(inverse_square),
            across: [yc, yt].map(inverse_square),
            interaction: -0.5 / (xt * xc),
            shear: inverse_square(s12),
            hardening,
        })
    }

    /// Computes φ at a stress (σ₁, σ₂, τ₁₂) `[stress]` in material axes, dimensionless and of degree 1: yield without hardening is at 1.
    pub fn value(&self, stress: [f64; 3]) -> f64 {
        dot(stress, self.gradient(stress)).sqrt()
    }

    /// P σ `[1/stress]`, in the quadrant of `stress`.
    fn gradient(&self, stress: [f64; 3]) -> [f64; 3] {
        apply(&self.matrix([stress[0] >= 0.0, stress[1] >= 0.0]), stress)
    }

    fn matrix(&self, [along, across]: [bool; 2]) -> PlaneStiffness {
        let q = self.interaction;
        [
            [self.along[usize::from(along)], q, 0.0],
            [q, self.across[usize::from(across)], 0.0],
            [0.0, 0.0, self.shear],
        ]
    }

    /// σ with S σ + μ P σ = `trial`: of the four quadrants the one that contains its own σ, or comes nearest to in rounding.
    fn point(&self, trial: [f64; 3], mu: f64) -> Point {
        let mut best: Option<(f64, Point)> = None;
        for quadrant in [[true, true], [true, false], [false, true], [false, false]] {
            let p = self.matrix(quadrant);
            let tangent = inverse_in_material_axes(&self.compliance, &p, mu);
            let stress = apply(&tangent, trial);
            let outside = |positive: bool, value: f64, weight: f64| {
                let depth = if positive { -value } else { value };
                depth.max(0.0) * weight.sqrt()
            };
            let violation =
                outside(quadrant[0], stress[0], p[0][0]) + outside(quadrant[1], stress[1], p[1][1]);
            if best.as_ref().is_none_or(|(known, _)| violation < *known) {
                let normal = apply(&p, stress);
                let value = dot(stress, normal).max(0.0).sqrt();
                best = Some((
                    violation,
                    Point {
                        stress,
                        tangent,
                        normal,
                        value,
                    },
                ));
            }
            if violation == 0.0 {
                break;
            }
        }
        // Four quadrants have been tried, so one is the best.
        best.map_or_else(|| self.elastic_point(trial), |(_, point)| point)
    }

    fn elastic_point(&self, trial: [f64; 3]) -> Point {
        let tangent = inverse_in_material_axes(&self.compliance, &[[0.0; 3]; 3], 0.0);
        let stress = apply(&tangent, trial);
        Point {
            stress,
            tangent,
            normal: self.gradient(stress),
            value: self.value(stress),
        }
    }

    /// Computes the end of a step from the hardening variable `hardening` = λ_n `[stress]` with the trial elastic strain `trial`, in material
    /// axes:
    ///
    /// ```text
    /// S σ + μ P σ = ε*,     μ = Δλ/φ,     φ (1 − H μ) = 1 + H λ_n
    /// ```
    ///
    /// with the compliance S, φ² = σ · P σ and the hardening H. Source: Simo & Hughes, *Computational Inelasticity* (1998), 3.4.
    ///
    /// # Errors
    /// The distance from the surface, relative to the yield stress, and the iterations, if the iteration fails; for finite input of
    /// sane magnitude it does not.
    pub fn closest_point(
        &self,
        trial: [f64; 3],
        hardening: f64,
    ) -> Result<ClosestPoint, (f64, usize)> {
        let level = 1.0 + self.hardening * hardening;
        let mut point = self.elastic_point(trial);
        if point.value <= level {
            return Ok(ClosestPoint {
                stress: point.stress,
                plastic_increment: [0.0; 3],
                hardening_increment: 0.0,
                tangent: point.tangent,
                residuals: Vec::new(),
            });
        }
        let (mut mu, mut low, mut high) = (0.0, 0.0, f64::INFINITY);
        let mut residuals = Vec::new();
        let mut distance = f64::INFINITY;
        while residuals.len() < ITERATIONS {
            let curvature = dot(point.normal, apply(&point.tangent, point.normal));
            let residual = level / point.value - (1.0 - self.hardening * mu);
            let slope = level * curvature / point.value.powi(3) + self.hardening;
            let newton = mu - residual / slope;
            let inside = newton > low && newton < high;
            if !inside && distance <= ACCEPTED {
                // Newton's step is rounding.
                return Ok(self.end(&point, mu, residuals));
            }
            let next = if inside {
                newton
            } else {
                0.5 * (low + high.min(2.0 * low + 1.0 / slope))
            };
            point = self.point(trial, next);
            mu = next;
            let last = distance;
            let signed = point.value * (1.0 - self.hardening * mu) / level - 1.0;
            distance = signed.abs();
            residuals.push(distance);
            // Rounding keeps the distance from falling further.
            if distance <= ROUNDING || (distance <= ACCEPTED && distance >= last) {
                return Ok(self.end(&point, mu, residuals));
            }
            if signed > 0.0 { low = mu } else { high = mu }
        }
        Err((distance, residuals.len()))
    }

    fn end(&self, point: &Point, mu: f64, residuals: Vec<f64>) -> ClosestPoint {
        let flow = apply(&point.tangent, point.normal);
        let hardening = self.hardening * point.value * point.value / (1.0 - self.hardening * mu);
        let denominator = dot(point.normal, flow) + hardening;
        let tangent = std::array::from_fn(|i| {
            std::array::from_fn(|j| point.tangent[i][j] - flow[i] * flow[j] / denominator)
        });
        ClosestPoint {
            stress: point.stress,
            plastic_increment: point.normal.map(|n| mu * n),
            hardening_increment: mu * point.value,
            tangent,
            residuals,
        }
    }
}

/// (S + μ P)⁻¹ for matrices without coupling of normal and shear terms.
fn inverse_in_material_axes(s: &PlaneStiffness, p: &PlaneStiffness, mu: f64) -> PlaneStiffness {
    let entry = |i: usize, j: usize| s[i][j] + mu * p[i][j];
    let (m11, m12, m22) = (entry(0, 0), entry(0, 1), entry(1, 1));
    let determinant = m11 * m22 - m12 * m12;
    [
        [m22 / determinant, -m12 / determinant, 0.0],
        [-m12 / determinant, m11 / determinant, 0.0],
        [0.0, 0.0, 1.0 / entry(2, 2)],
    ]
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}
