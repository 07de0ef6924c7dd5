//! Yamada & Sun: fibres and shear alone.
//!
//! ```text
//! (σ₁/X)² + (τ₁₂/S₁₂)²,     X = X_t for σ₁ ≥ 0, X_c for σ₁ < 0
//! ```
//!
//! The criterion that Chang, Scott & Springer (1982) use on the characteristic curve: just before a laminate breaks, every ply has
//! cracked along its fibres, and stress across them counts no more. S₁₂ is then the shear strength of a ply within a laminate, which
//! is more than that of a single ply. Source: Yamada & Sun, J. Compos. Mater. 12 (1978) 275.

use super::criterion::{Assessment, FailureCriterion, PlyLoading};
use super::error::FailureError;
use super::needed::needed_strength;
use super::registry::CriterionInfo;
use crate::failure_mode::FailureMode;
use crate::ply::Ply;
use crate::strengths::Strength;

/// Yamada and Sun's criterion: fibres and shear alone, once all cracks along the fibres have formed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct YamadaSun;

/// The strengths, one of X_t and X_c by the sign of σ₁.
#[derive(Clone, Copy)]
struct Strengths {
    tension: f64,
    compression: f64,
    shear: f64,
}

impl Strengths {
    fn along(&self, sigma: f64) -> f64 {
        if sigma >= 0.0 {
            self.tension
        } else {
            self.compression
        }
    }

    fn index(&self, [sigma, _, tau]: [f64; 3]) -> f64 {
        (sigma / self.along(sigma)).powi(2) + (tau / self.shear).powi(2)
    }

    fn mode(&self, [sigma, _, tau]: [f64; 3]) -> FailureMode {
        if tau.abs() / self.shear > sigma.abs() / self.along(sigma) {
            FailureMode::Shear
        } else if sigma >= 0.0 {
            FailureMode::FibreTension
        } else {
            FailureMode::FibreCompression
        }
    }

    /// The smallest multiple at which the index is 1: a root of one quadratic before σ₁ changes sign, of another behind.
    fn reserve_factor(&self, loading: &PlyLoading) -> f64 {
        if self.index(loading.held) >= 1.0 {
            return 0.0;
        }
        let change = -loading.held[0] / loading.applied[0];
        let change = if change > 0.0 { change } else { f64::INFINITY };
        let before = self.exit(
            loading,
            if change.is_finite() {
                0.5 * change
            } else {
                1.0
            },
        );
        if before <= change {
            before
        } else {
            self.exit(loading, 2.0 * change + 1.0)
        }
    }

    /// Where the quadratic that holds at the multiple `inside` grows past 1: a r² + b r + c = 1 with c < 1.
    fn exit(&self, loading: &PlyLoading, inside: f64) -> f64 {
        let (held, applied) = (loading.held, loading.applied);
        let x = self.along(loading.at(inside)[0]);
        let scaled = |stress: [f64; 3]| [stress[0] / x, stress[2] / self.shear];
        let ([h1, h2], [d1, d2]) = (scaled(held), scaled(applied));
        let (a, b) = (d1 * d1 + d2 * d2, 2.0 * (h1 * d1 + h2 * d2));
        let rest = 1.0 - (h1 * h1 + h2 * h2);
        if a == 0.0 {
            return f64::INFINITY;
        }
        let root = (b * b + 4.0 * a * rest).max(0.0).sqrt();
        // Of the two forms of the larger root the one without cancellation.
        if b > 0.0 {
            2.0 * rest / (b + root)
        } else {
            (root - b) / (2.0 * a)
        }
    }
}

impl FailureCriterion for YamadaSun {
    fn name(&self) -> &'static str {
        "yamada_sun"
    }

    fn title(&self) -> String {
        "Yamada–Sun".to_owned()
    }

    fn is_ultimate(&self) -> bool {
        true
    }

    fn required(&self) -> &'static [Strength] {
        &[Strength::Xt, Strength::Xc, Strength::S12]
    }

    fn assess(&self, ply: &Ply, loading: &PlyLoading) -> Result<Assessment, FailureError> {
        loading.check_finite()?;
        let needed = |strength| needed_strength(self.name(), ply, strength);
        let strengths = Strengths {
            tension: needed(Strength::Xt)?,
            compression: needed(Strength::Xc)?,
            shear: needed(Strength::S12)?,
        };
        let reserve_factor = strengths.reserve_factor(loading);
        let failing = if reserve_factor.is_finite() {
            loading.at(reserve_factor)
        } else {
            loading.at(1.0)
        };
        Ok(Assessment {
            criterion: self.name(),
            index: strengths.index(loading.at(1.0)),
            reserve_factor,
            mode: strengths.mode(failing),
        })
    }
}

inventory::submit! {
    CriterionInfo {
        name: "yamada_sun",
        summary: "fibres and shear alone, once all cracks have formed; Yamada & Sun (1978)",
        make: || Box::new(YamadaSun),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ply::PlyConstants;
    use crate::strengths::Strengths;

    fn ply() -> Ply {
        let constants = PlyConstants {
            e1: 140e3,
            e2: 10e3,
            g12: 5e3,
            nu12: 0.3,
            alpha1: 0.0,
            alpha2: 0.0,
            thickness: 0.125,
        };
        let strengths = Strengths::in_plane(1500.0, 1200.0, 50.0, 200.0, 100.0);
        Ply::new("carbon", constants, strengths).unwrap()
    }

    fn assessed(held: [f64; 3], applied: [f64; 3]) -> Assessment {
        YamadaSun
            .assess(&ply(), &PlyLoading { held, applied })
            .unwrap()
    }

    #[test]
    fn simple_stresses_reach_their_strengths() {
        let tension = assessed([0.0; 3], [750.0, 40.0, 0.0]);
        assert_eq!((tension.reserve_factor, tension.index), (2.0, 0.25));
        assert_eq!(tension.mode, FailureMode::FibreTension);
        let compression = assessed([0.0; 3], [-600.0, 0.0, 0.0]);
        assert_eq!(compression.reserve_factor, 2.0);
        assert_eq!(compression.mode, FailureMode::FibreCompression);
        let shear = assessed([0.0; 3], [0.0, -500.0, -50.0]);
        assert_eq!(
            (shear.reserve_factor, shear.mode),
            (2.0, FailureMode::Shear)
        );
        assert_eq!(
            assessed([0.0; 3], [0.0, 10.0, 0.0]).reserve_factor,
            f64::INFINITY
        );
        assert_eq!(
            assessed([0.0, 0.0, 101.0], [1.0, 0.0, 0.0]).reserve_factor,
            0.0
        );
    }

    #[test]
    fn the_index_is_one_at_the_reserve_factor_also_across_a_change_of_sign() {
        for held in [[-400.0, 10.0, 30.0], [500.0, 0.0, -60.0], [0.0; 3]] {
            for applied in [[900.0, 0.0, 5.0], [-300.0, 7.0, 80.0], [20.0, 0.0, -3.0]] {
                let found = assessed(held, applied);
                let loading = PlyLoading { held, applied };
                let there = assessed([0.0; 3], loading.at(found.reserve_factor));
                assert!(
                    (there.index - 1.0).abs() < 1e-12,
                    "{held:?} {applied:?} {found:?}"
                );
                // No smaller multiple fails.
                for k in 0..100 {
                    let before = loading.at(found.reserve_factor * f64::from(k) / 100.0);
                    assert!(assessed([0.0; 3], before).index < 1.0);
                }
            }
        }
    }
}
