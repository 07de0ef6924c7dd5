//! What a law did wrong.

use std::fmt;

use thiserror::Error;

use super::sample::State;
use crate::law::Bound;

/// A law that does not keep the contract.
#[derive(Debug, Clone, PartialEq, Error)]
#[error("friction law '{law}' breaks the contract: {breach}")]
pub struct ContractViolation {
    /// Name of the law.
    pub law: &'static str,
    /// The property it breaks, and the numbers.
    pub breach: Box<Breach>,
}

/// One of the numbers of a [`Bound`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Quantity {
    /// `stick`
    Stick,
    /// `stick_dp`
    StickDp,
    /// `slip`
    Slip,
    /// `slip_dp`
    SlipDp,
    /// `slip_ds`
    SlipDs,
}

impl Quantity {
    /// All of them.
    pub const ALL: [Self; 5] = [
        Self::Stick,
        Self::StickDp,
        Self::Slip,
        Self::SlipDp,
        Self::SlipDs,
    ];

    /// This number of `bound`, in the unit of that field.
    pub fn of(self, bound: &Bound) -> f64 {
        match self {
            Self::Stick => bound.stick,
            Self::StickDp => bound.stick_dp,
            Self::Slip => bound.slip,
            Self::SlipDp => bound.slip_dp,
            Self::SlipDs => bound.slip_ds,
        }
    }
}

impl fmt::Display for Quantity {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.pad(match self {
            Self::Stick => "stick",
            Self::StickDp => "stick_dp",
            Self::Slip => "slip",
            Self::SlipDp => "slip_dp",
            Self::SlipDs => "slip_ds",
        })
    }
}

/// How a copy of a law came about.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Copied {
    /// By `box_clone`.
    Cloned,
    /// By writing it and reading it again.
    Read,
}

impl fmt::Display for Copied {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.pad(match self {
            Self::Cloned => "box_clone",
            Self::Read => "writing and reading",
        })
    }
}

/// The property that is broken. Numbers are in the units of the sample.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum Breach {
    /// Not the law's fault: the sample tests nothing.
    #[error("it cannot be tested, because the sample is of no use: {fault}")]
    UselessSample {
        /// What is wrong with the sample.
        fault: &'static str,
    },
    /// A value or derivative is infinite or NaN.
    #[error("{quantity} = {value} is not finite at {at}")]
    NotFinite {
        /// Which number.
        quantity: Quantity,
        /// The number, in the unit of `quantity`.
        value: f64,
        /// Where.
        at: State,
    },
    /// A bound is negative.
    #[error("{quantity} = {value} is negative at {at}")]
    Negative {
        /// Which number.
        quantity: Quantity,
        /// The number, in the unit of `quantity`.
        value: f64,
        /// Where.
        at: State,
    },
    /// Shear is carried without pressure, or slip matters without pressure.
    #[error("{quantity} = {value} is not zero at {at}")]
    NotZeroWithoutPressure {
        /// Which number.
        quantity: Quantity,
        /// The number, in the unit of `quantity`.
        value: f64,
        /// Where.
        at: State,
    },
    /// The bound under a negative pressure is not that under none.
    #[error(
        "the bound under negative pressure, {negative:?}, is not that under none, {none:?}, at {at}"
    )]
    NegativePressureMatters {
        /// Bound under negative pressure.
        negative: Bound,
        /// Bound under no pressure.
        none: Bound,
        /// Where; the pressure is the negative one.
        at: State,
    },
    /// The stick bound depends on the slip of the step in progress.
    #[error("stick = {value}, but {without} without slip, at {at}")]
    StickDependsOnSlip {
        /// `stick` at the state `[stress]`.
        value: f64,
        /// `stick` there without slip increment `[stress]`.
        without: f64,
        /// Where.
        at: State,
    },
    /// Slip strengthens the contact, and the law does not say so.
    #[error(
        "slip = {slip} exceeds stick = {stick}, and the law does not declare that it strengthens, at {at}"
    )]
    SlipAboveStick {
        /// Traction of a slipping point `[stress]`.
        slip: f64,
        /// Bound of a sticking point `[stress]`.
        stick: f64,
        /// Where.
        at: State,
    },
    /// A derivative is not that of the value.
    #[error(
        "{quantity} = {stated}, but central differences give {difference} (± {tolerance:e}) at {at}"
    )]
    WrongDerivative {
        /// Which derivative.
        quantity: Quantity,
        /// The derivative that the law gives, in the unit of `quantity`.
        stated: f64,
        /// Central difference of the value, in the unit of `quantity`.
        difference: f64,
        /// Largest accepted distance between the two, in the unit of `quantity`.
        tolerance: f64,
        /// Where.
        at: State,
    },
    /// `is_linear` is true, but the bound is not `μ p` with one μ.
    #[error("is_linear, but {bound:?} is not of the form μ p with μ = {coefficient} at {at}")]
    NotLinear {
        /// The bound.
        bound: Bound,
        /// μ (dimensionless) at the same place and past under another pressure.
        coefficient: f64,
        /// Where.
        at: State,
    },
    /// The same question has two answers.
    #[error("evaluated twice, it gives {first:?} and {second:?} at {at}")]
    NotPure {
        /// First answer.
        first: Bound,
        /// A later one.
        second: Bound,
        /// Where.
        at: State,
    },
    /// The law claims a symmetry that it does not have.
    #[error(
        "it claims to be symmetric about the line at {line} rad from the x axis, but answers {mirrored:?} at the mirror image of \
         where it answers {own:?}, {at}"
    )]
    NotSymmetric {
        /// Bound at the state.
        own: Bound,
        /// Bound at its mirror image, with the slip reversed.
        mirrored: Bound,
        /// Angle of the line from the x axis `[rad]`.
        line: f64,
        /// Where.
        at: State,
    },
    /// Friction does work instead of taking it up.
    #[error(
        "friction dissipates {dissipation} per area in step {step} of a random history, at {at}"
    )]
    NegativeDissipation {
        /// Number of the step, from 0.
        step: usize,
        /// `−λ_t Δs` of the step `[stress·length]`.
        dissipation: f64,
        /// Where.
        at: State,
    },
    /// A copy of the law is not the law.
    #[error("{copied} gives the law '{name}' with {copy:?} instead of {original:?} at {at}")]
    CopyDiffers {
        /// How the copy came about.
        copied: Copied,
        /// Name of the copy.
        name: &'static str,
        /// Bound of the law.
        original: Bound,
        /// Bound of the copy.
        copy: Bound,
        /// Where.
        at: State,
    },
    /// The law cannot be written, or what was written cannot be read.
    #[error("it cannot be written and read again: {message}")]
    NotSerialisable {
        /// What serde says.
        message: String,
    },
    /// An unknown parameter is not refused.
    #[error("it reads {written} without complaint (deny_unknown_fields is missing)")]
    UnknownParameterAccepted {
        /// What it read.
        written: String,
    },
}
