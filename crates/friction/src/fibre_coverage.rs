//! Friction of a laminate's edge: two laws mixed by the fraction of the surface that fibres cover (after the observation of
//! Post & Reddy 1988, part I, 6.3).
//!
//! ```text
//! F     = c F_fibre + (1 − c) F_matrix              values and derivatives
//! c     = Σ_k h_k c_k
//!
//! cos ψ_k = |e_t · f_k|                             on a hole at θ: |sin(θ − φ_k)|
//!
//! swept     c_k = min( c_max, V_f (1 + κ cos ψ_k) )
//! tangent   c_k = V_f + (c_max − V_f) exp(−(ψ_k/ψ_w)²)
//!
//! c_max = sqrt(2√3 V_f/π),   V_f ≤ π/(2√3)          hexagonal packing, a cut through fibre centres
//! ```
//!
//! | symbol  | meaning                                                                   | dimension     |
//! |---------|---------------------------------------------------------------------------|---------------|
//! | `h_k`   | fraction of the thickness of ply k, Σ h_k = 1                             | dimensionless |
//! | `φ_k`   | fibre angle of ply k from the body's 1-axis, counter-clockwise; `f_k` its direction | `[rad]` |
//! | `ψ_k`   | angle between the fibre and the tangent `e_t` of the edge, in [0, π/2]    | `[rad]`       |
//! | `V_f`   | volume fraction of fibres                                                 | dimensionless |
//! | `κ`     | `4δ/(π d)`: fibre diameter d, depth δ of surface material that is worn or touched | dimensionless |
//! | `ψ_w`   | angle within which tangent fibres lie bare                                | `[rad]`       |
//! | `c`     | fraction of the surface covered by fibres                                 | dimensionless |
//!
//! *Swept*: a fibre that meets the surface at ψ leaves an ellipse of area `πd²/(4 sin ψ)`, and the material within the depth δ
//! adds a strip of length `δ cot ψ` and width d; times the `V_f sin ψ/(πd²/4)` fibres per area this is `V_f (1 + κ cos ψ)`.
//! No cut covers more than one through the centres of a row of packed fibres, c_max.
//!
//! The kernels are even in ψ, so the law mirrors about a line where the plies are balanced about it, as many at α from it as at −α,
//! and both component laws mirror.
//!
//! A smooth kernel like `cos² ψ` would not do: over equal plies at 0°, 60° and −60° it sums to a constant.

use std::f64::consts::{FRAC_PI_2, PI};

use serde::{Deserialize, Serialize};

use crate::error::{FrictionError, Interval};
use crate::history::History;
use crate::law::{Bound, FrictionLaw, Mirror, Place};
use crate::registry::{LawInfo, ParameterInfo};

const NAME: &str = "fibre_coverage";
const SQRT_3: f64 = 1.732_050_807_568_877_2;

/// Largest volume fraction of parallel round fibres, π/(2√3): hexagonal packing. Dimensionless.
pub const MAXIMUM_FIBRE_FRACTION: f64 = FRAC_PI_2 / SQRT_3;

/// How far the thickness fractions of all plies together may be from 1, dimensionless.
pub const FRACTION_SUM_TOLERANCE: f64 = 1e-9;

/// Angles of fibres `[rad]` and thickness fractions that differ by less are equal: rounding of units and turns.
const SAME: f64 = 1e-12;

/// One ply, or all plies of one angle.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PlyFraction {
    /// Fibre angle from the body's 1-axis, counter-clockwise `[rad]`.
    pub angle: f64,
    /// Fraction of the laminate's thickness, in [0, 1], dimensionless.
    pub fraction: f64,
}

/// How much of the surface the fibres of one ply cover.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum Kernel {
    /// Cut fibres and the strips they are bare of matrix in.
    Swept {
        /// `4δ/(π d)` ≥ 0, dimensionless.
        kappa: f64,
    },
    /// Fibres lie bare where they are nearly tangent to the surface.
    Tangent {
        /// Angle ψ_w > 0 `[rad]`.
        width: f64,
    },
}

impl Kernel {
    /// Covered fraction of a ply (dimensionless), its fibres at the angle `psi` in [0, π/2] `[rad]` to the surface's tangent, for
    /// the volume fraction `fibre_fraction` of fibres.
    pub fn covered_fraction(self, fibre_fraction: f64, psi: f64) -> f64 {
        let maximum = maximum_coverage(fibre_fraction);
        match self {
            Self::Swept { kappa } => maximum.min(fibre_fraction * (1.0 + kappa * psi.cos())),
            Self::Tangent { width } => {
                let relative = psi / width;
                fibre_fraction + (maximum - fibre_fraction) * (-relative * relative).exp()
            }
        }
    }

    fn check(self) -> Result<(), FrictionError> {
        match self {
            Self::Swept { kappa } => {
                Interval::NON_NEGATIVE.check(NAME, "kernel.swept.kappa", kappa)
            }
            Self::Tangent { width } => {
                Interval::POSITIVE.check(NAME, "kernel.tangent.width", width)
            }
        }
        .map(|_| ())
    }
}

/// Largest fraction of a plane that fibres of volume fraction `fibre_fraction` in hexagonal packing cover: a cut through the
/// centres of a row, `sqrt(2√3 V_f/π)`. Dimensionless.
pub fn maximum_coverage(fibre_fraction: f64) -> f64 {
    (fibre_fraction * (2.0 * SQRT_3 / PI)).sqrt()
}

/// Mixture of a law for fibres and a law for matrix along the edge of a laminate. In files
///
/// ```toml
/// [friction.fibre_coverage]
/// plies = [{ angle = 0.0, fraction = 0.5 }, { angle = 1.5707963267948966, fraction = 0.5 }]
/// fibre_fraction = 0.6
/// kernel.swept = { kappa = 0.5 }
/// fibre.coulomb = { mu = 0.15 }
/// matrix.coulomb = { mu = 0.35 }
/// ```
#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(try_from = "RawFibreCoverage")]
pub struct FibreCoverage {
    plies: Vec<PlyFraction>,
    fibre_fraction: f64,
    kernel: Kernel,
    fibre: Box<dyn FrictionLaw>,
    matrix: Box<dyn FrictionLaw>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct RawFibreCoverage {
    plies: Vec<PlyFraction>,
    fibre_fraction: f64,
    kernel: Kernel,
    fibre: Box<dyn FrictionLaw>,
    matrix: Box<dyn FrictionLaw>,
}

impl FibreCoverage {
    /// The mixture of the laws `fibre` and `matrix` for a laminate of `plies` with the volume fraction `fibre_fraction` in
    /// [0, π/(2√3)] of fibres (dimensionless).
    ///
    /// # Errors
    /// [`FrictionError::NoPlies`], [`FrictionError::OutOfRange`] if an angle is not finite, a fraction is outside [0, 1], the
    /// fibre fraction above its maximum or a parameter of the kernel outside its range, and [`FrictionError::FractionSum`] if the
    /// plies' fractions do not sum to 1 within [`FRACTION_SUM_TOLERANCE`].
    pub fn new(
        plies: Vec<PlyFraction>,
        fibre_fraction: f64,
        kernel: Kernel,
        fibre: Box<dyn FrictionLaw>,
        matrix: Box<dyn FrictionLaw>,
    ) -> Result<Self, FrictionError> {
        check_plies(&plies)?;
        Interval::closed(0.0, MAXIMUM_FIBRE_FRACTION).check(
            NAME,
            "fibre_fraction",
            fibre_fraction,
        )?;
        kernel.check()?;
        Ok(Self {
            plies,
            fibre_fraction,
            kernel,
            fibre,
            matrix,
        })
    }

    /// Fraction of the surface at `place` that fibres cover, in [0, 1], dimensionless.
    pub fn coverage(&self, place: &Place) -> f64 {
        let covered: f64 = self
            .plies
            .iter()
            .map(|ply| {
                let psi = angle_to_fibre(place, ply.angle);
                ply.fraction * self.kernel.covered_fraction(self.fibre_fraction, psi)
            })
            .sum();
        // The fractions may sum to a little more than 1, and at V_f = π/(2√3) every c_k may be 1.
        covered.min(1.0)
    }
}

/// Angle in [0, π/2] between the tangent at `place` and a fibre at `angle` from the body's 1-axis.
fn angle_to_fibre(place: &Place, angle: f64) -> f64 {
    let (sine, cosine) = (place.material_angle + angle).sin_cos();
    let [tangent_x, tangent_y] = place.tangent;
    let along = tangent_x * cosine + tangent_y * sine;
    let across = tangent_x * sine - tangent_y * cosine;
    across.abs().atan2(along.abs())
}

/// Whether the plies are their own mirror image about a line at `line` `[rad]` from the 1-axis: as much at every angle as at its
/// reflection, 2 `line` less the angle, both up to half turns.
fn is_balanced(plies: &[PlyFraction], line: f64) -> bool {
    let fraction_at = |angle: f64| -> f64 {
        let there = plies
            .iter()
            .filter(|ply| (ply.angle - angle).sin().abs() <= SAME);
        there.map(|ply| ply.fraction).sum()
    };
    plies
        .iter()
        .all(|ply| (fraction_at(ply.angle) - fraction_at(2.0 * line - ply.angle)).abs() <= SAME)
}

fn check_plies(plies: &[PlyFraction]) -> Result<(), FrictionError> {
    if plies.is_empty() {
        return Err(FrictionError::NoPlies { law: NAME });
    }
    for (index, ply) in plies.iter().enumerate() {
        Interval::FINITE.check(NAME, &format!("plies[{index}].angle"), ply.angle)?;
        Interval::closed(0.0, 1.0).check(
            NAME,
            &format!("plies[{index}].fraction"),
            ply.fraction,
        )?;
    }
    let sum: f64 = plies.iter().map(|ply| ply.fraction).sum();
    if (sum - 1.0).abs() > FRACTION_SUM_TOLERANCE {
        return Err(FrictionError::FractionSum {
            law: NAME,
            plies: plies.len(),
            sum,
            tolerance: FRACTION_SUM_TOLERANCE,
        });
    }
    Ok(())
}

impl TryFrom<RawFibreCoverage> for FibreCoverage {
    type Error = FrictionError;

    fn try_from(raw: RawFibreCoverage) -> Result<Self, FrictionError> {
        Self::new(
            raw.plies,
            raw.fibre_fraction,
            raw.kernel,
            raw.fibre,
            raw.matrix,
        )
    }
}

#[typetag::serde(name = "fibre_coverage")]
impl FrictionLaw for FibreCoverage {
    fn bound(&self, pressure: f64, slip_increment: f64, place: &Place, past: &History) -> Bound {
        let fibre = self.fibre.bound(pressure, slip_increment, place, past);
        let matrix = self.matrix.bound(pressure, slip_increment, place, past);
        fibre.mixed(self.coverage(place), matrix)
    }

    fn is_linear(&self) -> bool {
        self.fibre.is_linear() && self.matrix.is_linear()
    }

    fn strengthens(&self) -> bool {
        self.fibre.strengthens() || self.matrix.strengthens()
    }

    fn is_symmetric(&self, mirror: &Mirror) -> bool {
        is_balanced(&self.plies, mirror.line - mirror.material_angle)
            && self.fibre.is_symmetric(mirror)
            && self.matrix.is_symmetric(mirror)
    }

    fn box_clone(&self) -> Box<dyn FrictionLaw> {
        Box::new(self.clone())
    }
}

inventory::submit! {
    LawInfo {
        name: NAME,
        summary: "two laws mixed by the fibres that the edge of a laminate exposes",
        parameters: &[
            ParameterInfo::angle("plies[].angle", "fibre angle of the ply from the body's 1-axis, counter-clockwise"),
            ParameterInfo::number(
                "plies[].fraction",
                "fraction of the laminate's thickness, in [0, 1]; all of them sum to 1",
            ),
            ParameterInfo::number("fibre_fraction", "volume fraction of fibres, in [0, π/(2√3)]"),
            ParameterInfo::number(
                "kernel.swept.kappa",
                "4δ/(π d) ≥ 0: depth δ of worn surface, fibre diameter d (one kernel must be given)",
            ),
            ParameterInfo::angle(
                "kernel.tangent.width",
                "angle to the edge within which fibres lie bare, > 0 (one kernel must be given)",
            ),
            ParameterInfo::law("fibre", "friction law of the fibres"),
            ParameterInfo::law("matrix", "friction law of the matrix"),
        ],
    }
}
