//! The trait behind which all friction laws stand.
//!
//! ```text
//! bound: (p, |Δs|, place, history)  ↦  F_stick, ∂F_stick/∂p,  F_slip, ∂F_slip/∂p, ∂F_slip/∂|Δs|
//! ```
//!
//! A law is a pure function. Everything it may depend on is an argument, and what the point remembers is in its [`History`],
//! which only the solver advances, and only when it accepts a step.
//!
//! # Writing a law
//!
//! Three things make a law: the trait, a name, and an entry in the [`registry`](crate::registry) that says which parameters
//! have dimensions. Another crate needs nothing else, and its law is read from files like those of this one.
//!
//! This law has a coefficient that falls with pressure like that of a soft surface film of shear strength `τ₀`:
//! `F = min(μ p, τ₀)` made smooth, `F = τ₀ tanh(μ p / τ₀)`.
//!
//! ```
//! use serde::{Deserialize, Serialize};
//! use stickslip_friction::{
//!     Bound, FrictionError, FrictionLaw, History, Interval, LawInfo, Mirror, ParameterInfo, Place, contract,
//! };
//!
//! #[derive(Debug, Clone, Serialize, Deserialize)]
//! #[serde(try_from = "RawSoftFilm")] // the ranges are checked here, once
//! struct SoftFilm {
//!     mu: f64,
//!     shear_strength: f64,
//! }
//!
//! #[derive(Deserialize)]
//! #[serde(deny_unknown_fields)]
//! struct RawSoftFilm {
//!     mu: f64,
//!     shear_strength: f64,
//! }
//!
//! impl TryFrom<RawSoftFilm> for SoftFilm {
//!     type Error = FrictionError;
//!     fn try_from(raw: RawSoftFilm) -> Result<Self, FrictionError> {
//!         Ok(Self {
//!             mu: Interval::NON_NEGATIVE.check("soft_film", "mu", raw.mu)?,
//!             shear_strength: Interval::POSITIVE.check("soft_film", "shear_strength", raw.shear_strength)?,
//!         })
//!     }
//! }
//!
//! #[typetag::serde(name = "soft_film")]
//! impl FrictionLaw for SoftFilm {
//!     fn bound(&self, pressure: f64, _slip_increment: f64, _place: &Place, _past: &History) -> Bound {
//!         let capacity = (self.mu * pressure.max(0.0) / self.shear_strength).tanh();
//!         Bound::single(self.shear_strength * capacity, self.mu * (1.0 - capacity * capacity))
//!     }
//!
//!     // Neither the place nor the direction of slip enters; without this claim no half model is made of a contact.
//!     fn is_symmetric(&self, _mirror: &Mirror) -> bool {
//!         true
//!     }
//!
//!     fn box_clone(&self) -> Box<dyn FrictionLaw> {
//!         Box::new(self.clone())
//!     }
//! }
//!
//! stickslip_friction::inventory::submit! {
//!     LawInfo {
//!         name: "soft_film",
//!         summary: "shear limited by the strength of a surface film",
//!         parameters: &[
//!             ParameterInfo::number("mu", "coefficient of friction at low pressure, ≥ 0"),
//!             ParameterInfo::stress("shear_strength", "shear strength of the film, > 0"),
//!         ],
//!     }
//! }
//!
//! // A file names it, and one line tests it at the pressures and slips of the problem at hand.
//! let law: Box<dyn FrictionLaw> = serde_json::from_str(r#"{ "soft_film": { "mu": 0.2, "shear_strength": 30.0 } }"#)?;
//! contract::check(law.as_ref(), &contract::Sample::default_for(100.0, 1e-3))?;
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use std::fmt::Debug;

use crate::history::History;

/// Where a contact point lies.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Place {
    /// Coordinates x, y `[length]`.
    pub position: [f64; 2],
    /// Unit tangent e_t of the contact frame, dimensionless; slip is positive along it.
    pub tangent: [f64; 2],
    /// Angle of the body's 1-axis from the x axis, counter-clockwise `[rad]`.
    pub material_angle: f64,
}

impl Place {
    /// This place turned about the origin by `angle` `[rad]`, counter-clockwise, in a body that stays as it is.
    pub(crate) fn turned(&self, angle: f64) -> Self {
        let (sine, cosine) = angle.sin_cos();
        let turn = |[x, y]: [f64; 2]| [cosine * x - sine * y, sine * x + cosine * y];
        Self {
            position: turn(self.position),
            tangent: turn(self.tangent),
            ..*self
        }
    }
}

/// A line through the origin about which contact and body are their own mirror images, so that half of them may stand for the whole.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Mirror {
    /// Angle of the line from the x axis, counter-clockwise `[rad]`.
    pub line: f64,
    /// Angle of the body's 1-axis from the x axis, counter-clockwise `[rad]`; there is one body, so it holds on both sides.
    pub material_angle: f64,
}

impl Mirror {
    /// The place that mirrors `place`: position and normal are reflected. The tangent is e_n turned by +90° on both sides, so it is
    /// reflected and reversed, and slip along it has the other sign.
    pub fn image(&self, place: &Place) -> Place {
        let (sine, cosine) = (2.0 * self.line).sin_cos();
        let reflect = |[x, y]: [f64; 2]| [cosine * x + sine * y, sine * x - cosine * y];
        Place {
            position: reflect(place.position),
            tangent: reflect(place.tangent).map(|component| -component),
            ..*place
        }
    }
}

/// What shear a contact point can carry: values `[stress]` and their derivatives.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Bound {
    /// Largest shear of a sticking point `[stress]`, ≥ 0. It does not depend on Δs, because a sticking point has none.
    pub stick: f64,
    /// Derivative of `stick` in the pressure, dimensionless.
    pub stick_dp: f64,
    /// Magnitude of the shear of a slipping point `[stress]`, ≥ 0; it acts against the slip.
    pub slip: f64,
    /// Derivative of `slip` in the pressure, dimensionless.
    pub slip_dp: f64,
    /// Derivative of `slip` in |Δs| of the step in progress `[stress/length]`.
    pub slip_ds: f64,
}

impl Bound {
    /// The bound `μ p` with one coefficient (dimensionless) for sticking and one for slipping points under `pressure`
    /// `[stress]`. Without pressure it is zero and its derivatives are those at 0+.
    pub fn proportional(stick_coefficient: f64, slip_coefficient: f64, pressure: f64) -> Self {
        let pressure = compression(pressure);
        Self {
            stick: stick_coefficient * pressure,
            stick_dp: stick_coefficient,
            slip: slip_coefficient * pressure,
            slip_dp: slip_coefficient,
            slip_ds: 0.0,
        }
    }

    /// The same `value` `[stress]` and `derivative` in pressure (dimensionless) for sticking and slipping points.
    pub fn single(value: f64, derivative: f64) -> Self {
        Self {
            stick: value,
            stick_dp: derivative,
            slip: value,
            slip_dp: derivative,
            slip_ds: 0.0,
        }
    }

    /// `weight · self + (1 − weight) · other`, values and derivatives; `weight` is dimensionless.
    #[must_use]
    pub fn mixed(self, weight: f64, other: Self) -> Self {
        let mix = |own: f64, others: f64| weight * own + (1.0 - weight) * others;
        Self {
            stick: mix(self.stick, other.stick),
            stick_dp: mix(self.stick_dp, other.stick_dp),
            slip: mix(self.slip, other.slip),
            slip_dp: mix(self.slip_dp, other.slip_dp),
            slip_ds: mix(self.slip_ds, other.slip_ds),
        }
    }
}

/// The pressure if it presses, else zero. Unlike `f64::max` it lets a NaN through, so that a failed trial shows.
pub(crate) fn compression(pressure: f64) -> f64 {
    if pressure <= 0.0 { 0.0 } else { pressure }
}

/// A friction law of Coulomb's type: it bounds the shear of a contact point.
///
/// Object-safe, and read and written by name through `typetag`. The [module](self) shows how to write one, and
/// [`contract::check`](crate::contract::check) tests one.
#[typetag::serde]
pub trait FrictionLaw: Debug + Send + Sync {
    /// What the point at `place` with the committed `past` can carry under `pressure` `[stress]`, when the step in progress
    /// has moved it by `slip_increment` = |Δs| ≥ 0 `[length]`.
    ///
    /// Under no pressure, or a negative one, the values are zero and the derivatives are those at 0+. Equal arguments give
    /// equal answers, however often and in whatever order they are asked.
    fn bound(&self, pressure: f64, slip_increment: f64, place: &Place, past: &History) -> Bound;

    /// Whether `F_stick = F_slip = μ p` with a μ that place and past determine, so that it is fixed within a step and the step
    /// is one linear complementarity problem.
    fn is_linear(&self) -> bool {
        false
    }

    /// Whether slip can make the contact stronger, `F_slip > F_stick`. A law that says so is excused from `F_slip ≤ F_stick`.
    fn strengthens(&self) -> bool {
        false
    }

    /// Whether slip at mirrored places is mirrored: for every `place` in a body with the material angle of `mirror`, the bound at
    /// [`mirror.image(place)`](Mirror::image) and [`past.mirrored()`](History::mirrored) is that at `place` and `past`.
    ///
    /// A model of half a contact needs this claim, and without it the whole is modelled. A law that depends neither on the place nor on
    /// the direction of past slip claims it for every line. [`contract::check`](crate::contract::check) tests the claim.
    fn is_symmetric(&self, _mirror: &Mirror) -> bool {
        false
    }

    /// Name of the law in files.
    fn name(&self) -> &'static str {
        self.typetag_name()
    }

    /// A copy; in every law `Box::new(self.clone())`.
    fn box_clone(&self) -> Box<dyn FrictionLaw>;
}

impl Clone for Box<dyn FrictionLaw> {
    fn clone(&self) -> Self {
        self.box_clone()
    }
}
