//! Friction laws for plane contact, each a plug-in behind one trait.
//!
//! A law answers two questions about a contact point under pressure `p ≥ 0`: what shear can it carry
//! without slipping, and what shear does it carry while it slips?
//!
//! ```text
//! |λ_t| ≤ F_stick                                 Δs = 0 while it sticks
//!  λ_t  = −F_slip sign(Δs)                        Δs ≠ 0, it slips
//!
//! F_stick = μ_stick(p, history, place) · p
//! F_slip  = μ_slip (p, Δs, history, place) · p  ≤  F_stick
//! ```
//!
//! | symbol  | meaning                                           | dimension     |
//! |---------|---------------------------------------------------|---------------|
//! | `p`     | contact pressure, positive in compression         | `[stress]`    |
//! | `λ_t`   | shear traction on the first body                  | `[stress]`    |
//! | `Δs`    | slip of the first body relative to the second since the last committed step | `[length]` |
//! | `F`     | friction bound                                    | `[stress]`    |
//! | `μ`     | coefficient of friction                           | dimensionless |
//!
//! ```
//! use stickslip_friction::{Coulomb, FrictionLaw, History, Place};
//!
//! # fn main() -> Result<(), stickslip_friction::FrictionError> {
//! let law = Coulomb::new(0.3)?;
//! let place = Place { position: [0.0, 0.0], tangent: [1.0, 0.0], material_angle: 0.0 };
//! let bound = law.bound(80.0, 0.0, &place, &History::default());
//! assert_eq!([bound.stick, bound.slip], [24.0, 24.0]);
//! assert_eq!(bound.slip_dp, 0.3);
//! # Ok(())
//! # }
//! ```
//!
//! The crate is unit-free: any consistent set of units works. It knows no mesh, no matrix and no solver.
//!
//! # Contents
//!
//! | module             | holds                                                                     |
//! |--------------------|---------------------------------------------------------------------------|
//! | [`law`]            | the trait [`FrictionLaw`], its answer [`Bound`], the [`Place`] of a point, the [`Mirror`] of half models |
//! | [`history`]        | what a point remembers: [`History`], changed only by [`History::commit`]  |
//! | [`coulomb`]        | `coulomb`: μ constant                                                     |
//! | [`static_dynamic`] | `static_dynamic`: μs before slip, μd during it                            |
//! | [`slip_power`]     | `slip_power`: a continuous transition from μs to μd along the slip path   |
//! | [`pressure_power`] | `pressure_power`: μ falls with pressure                                   |
//! | [`fibre_coverage`] | `fibre_coverage`: two laws mixed by the fibres that the surface exposes   |
//! | [`registry`]       | names, parameters and dimensions of all laws that are linked in           |
//! | [`contract`]       | what every law must fulfil, as a check that a new law calls in its tests  |
//! | [`error`]          | why parameters are refused                                                |
//!
//! A law is named in a file by an external tag, `friction.coulomb = { mu = 0.3 }`; [`law`] shows how another crate adds one.

pub mod contract;
pub mod coulomb;
pub mod error;
pub mod fibre_coverage;
pub mod history;
pub mod law;
pub mod pressure_power;
pub mod registry;
pub mod slip_power;
pub mod static_dynamic;

pub use coulomb::Coulomb;
pub use error::{FrictionError, Interval};
pub use fibre_coverage::{FibreCoverage, Kernel, PlyFraction};
pub use history::{Direction, History, PointStatus};
pub use law::{Bound, FrictionLaw, Mirror, Place};
pub use pressure_power::PressurePower;
pub use registry::{Dimension, LawInfo, ParameterInfo, laws};
pub use slip_power::{SlipPath, SlipPower};
pub use static_dynamic::{StaticDynamic, Transition};

/// The crate behind [`registry`], by which a law elsewhere registers its parameters. Its `#[typetag::serde]` needs dependencies on `typetag` and `serde`.
pub use inventory;
