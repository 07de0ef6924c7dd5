//! Criteria with one quadratic polynomial for all modes, in plane stress.
//!
//! ```text
//! Tsai–Hill   (σ₁/X)² − σ₁σ₂/X² + (σ₂/Y)² + (τ₁₂/S₁₂)²,   X, Y by the signs of σ₁, σ₂
//! Hoffman     σ₁²/(X_t X_c) − σ₁σ₂/(X_t X_c) + σ₂²/(Y_t Y_c) + (1/X_t − 1/X_c) σ₁ + (1/Y_t − 1/Y_c) σ₂ + (τ₁₂/S₁₂)²
//! Tsai–Wu     the same with 2 F₁₂ σ₁σ₂ for the second term
//! ```
//!
//! Interactive criteria do not distinguish modes: the reported mode is that of the stress nearest to its own strength. Strengths for
//! which a polynomial is no closed ellipse are refused: Tsai–Hill needs Y < 2X, Hoffman Y_t Y_c < 4 X_t X_c, Tsai–Wu |F₁₂| < √(F₁₁F₂₂).
//!
//! Sources: Azzi & Tsai, Exp. Mech. 5 (1965) 283; Hoffman, J. Compos. Mater. 1 (1967) 200; Tsai & Wu, J. Compos. Mater. 5 (1971) 58.

use super::criterion::{Assessment, FailureCriterion, PlyLoading};
use super::error::FailureError;
use super::needed::{IN_PLANE, InPlane, in_plane};
use super::ray::{Branch, Surface};
use super::registry::CriterionInfo;
use crate::ply::Ply;
use crate::strengths::Strength;

/// How near to the limit an interaction may come: nearer, the surface is open but for rounding.
const CLOSED: f64 = 1.0 - 1e-12;

/// Tsai–Hill in plane stress, strengths by the signs of the stresses (Azzi & Tsai 1965):
/// (σ₁/X)² − σ₁σ₂/X² + (σ₂/Y)² + (τ₁₂/S₁₂)².
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TsaiHill;

/// Hoffman in plane stress, for a ply that is alike in 2 and 3 (Hoffman 1967):
/// σ₁²/(X_t X_c) − σ₁σ₂/(X_t X_c) + σ₂²/(Y_t Y_c) + (1/X_t − 1/X_c) σ₁ + (1/Y_t − 1/Y_c) σ₂ + (τ₁₂/S₁₂)².
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Hoffman;

/// Tsai–Wu in plane stress (Tsai & Wu 1971): [`Hoffman`] with 2 F₁₂ σ₁σ₂ for the second term.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct TsaiWu {
    /// The interaction of σ₁ and σ₂.
    pub interaction: Interaction,
}

/// F₁₂ of Tsai–Wu, which only a biaxial test gives.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Interaction {
    /// F₁₂ as a multiple of √(F₁₁F₂₂) = 1/√(X_t X_c Y_t Y_c), dimensionless, in (−1, 1); usually −0.5.
    Normalised(f64),
    /// F₁₂ itself `[1/stress²]`.
    Coefficient(f64),
}

impl Default for Interaction {
    fn default() -> Self {
        Self::Normalised(-0.5)
    }
}

impl FailureCriterion for TsaiHill {
    fn name(&self) -> &'static str {
        "tsai_hill"
    }

    fn title(&self) -> String {
        "Tsai–Hill".to_owned()
    }

    fn required(&self) -> &'static [Strength] {
        &IN_PLANE
    }

    fn assess(&self, ply: &Ply, loading: &PlyLoading) -> Result<Assessment, FailureError> {
        let strengths = in_plane(self.name(), ply)?;
        let polynomial = |[along, across]: [bool; 2]| {
            let x = if along { strengths.xt } else { strengths.xc };
            let y = if across { strengths.yt } else { strengths.yc };
            let direct = 1.0 / (x * x);
            Polynomial {
                linear: [0.0; 2],
                direct: [direct, 1.0 / (y * y)],
                interaction: -0.5 * direct,
            }
        };
        assess(self.name(), ply, strengths, loading, polynomial)
    }
}

impl FailureCriterion for Hoffman {
    fn name(&self) -> &'static str {
        "hoffman"
    }

    fn title(&self) -> String {
        "Hoffman".to_owned()
    }

    fn required(&self) -> &'static [Strength] {
        &IN_PLANE
    }

    fn assess(&self, ply: &Ply, loading: &PlyLoading) -> Result<Assessment, FailureError> {
        let strengths = in_plane(self.name(), ply)?;
        let polynomial = Polynomial::of_uniaxial(&strengths, -0.5 / (strengths.xt * strengths.xc));
        assess(self.name(), ply, strengths, loading, |_| polynomial)
    }
}

impl FailureCriterion for TsaiWu {
    fn name(&self) -> &'static str {
        "tsai_wu"
    }

    fn title(&self) -> String {
        "Tsai–Wu".to_owned()
    }

    fn required(&self) -> &'static [Strength] {
        &IN_PLANE
    }

    fn assess(&self, ply: &Ply, loading: &PlyLoading) -> Result<Assessment, FailureError> {
        let strengths = in_plane(self.name(), ply)?;
        let InPlane { xt, xc, yt, yc, .. } = strengths;
        let f12 = match self.interaction {
            Interaction::Normalised(factor) => factor / (xt * xc * yt * yc).sqrt(),
            Interaction::Coefficient(f12) => f12,
        };
        let polynomial = Polynomial::of_uniaxial(&strengths, f12);
        assess(self.name(), ply, strengths, loading, |_| polynomial)
    }
}

/// Coefficients of σ₁ and σ₂; `interaction` is that of 2 σ₁σ₂.
#[derive(Clone, Copy)]
pub(super) struct Polynomial {
    pub linear: [f64; 2],
    pub direct: [f64; 2],
    pub interaction: f64,
}

impl Polynomial {
    /// The one that is 1 at the four uniaxial strengths.
    fn of_uniaxial(strengths: &InPlane, interaction: f64) -> Self {
        let InPlane { xt, xc, yt, yc, .. } = *strengths;
        Self {
            linear: [1.0 / xt - 1.0 / xc, 1.0 / yt - 1.0 / yc],
            direct: [1.0 / (xt * xc), 1.0 / (yt * yc)],
            interaction,
        }
    }
}

/// Index, reserve factor and mode by the polynomial for the signs of σ₁ and σ₂, to which (τ₁₂/S₁₂)² is added.
pub(super) fn assess(
    criterion: &'static str,
    ply: &Ply,
    strengths: InPlane,
    loading: &PlyLoading,
    polynomial: impl Fn([bool; 2]) -> Polynomial,
) -> Result<Assessment, FailureError> {
    for quadrant in [[true, true], [true, false], [false, true], [false, false]] {
        closed(criterion, ply, &polynomial(quadrant))?;
    }
    let shear = 1.0 / (strengths.s12 * strengths.s12);
    let surface = Surface {
        criterion,
        branches: |[along, across, _]: [bool; 3]| {
            let Polynomial {
                linear: [l1, l2],
                direct: [q11, q22],
                interaction: q12,
            } = polynomial([along, across]);
            let branch = Branch {
                mode: None,
                linear: [l1, l2, 0.0],
                quadratic: [[q11, q12, 0.0], [q12, q22, 0.0], [0.0, 0.0, shear]],
            };
            [Some(branch), None, None]
        },
        dominant: |stress: &[f64; 3]| strengths.dominant(stress),
    };
    surface.assess(&loading.held, &loading.applied)
}

/// Whether the polynomial is a closed ellipse.
fn closed(criterion: &'static str, ply: &Ply, given: &Polynomial) -> Result<(), FailureError> {
    let interaction = given.interaction;
    let limit = (given.direct[0] * given.direct[1]).sqrt();
    if interaction.abs() < CLOSED * limit {
        Ok(())
    } else {
        Err(FailureError::OpenSurface {
            criterion,
            ply: ply.name().to_owned(),
            interaction,
            limit,
        })
    }
}

inventory::submit! {
    CriterionInfo {
        name: "tsai_hill",
        summary: "one quadratic form, strengths by sign; Azzi & Tsai (1965)",
        make: || Box::new(TsaiHill),
    }
}

inventory::submit! {
    CriterionInfo {
        name: "hoffman",
        summary: "with linear terms for unequal strengths; Hoffman (1967)",
        make: || Box::new(Hoffman),
    }
}

inventory::submit! {
    CriterionInfo {
        name: "tsai_wu",
        summary: "tensor polynomial, F12 by tsai_wu_interaction; Tsai & Wu (1971)",
        make: || Box::new(TsaiWu::default()),
    }
}
