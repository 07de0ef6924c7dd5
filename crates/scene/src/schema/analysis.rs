//! How a scene is solved.

use serde::{Deserialize, Serialize};
use stickslip_fem_core::material::PlaneState;

use super::demand::{Accuracy, Budget, Memory};

/// How the model is solved: `[analysis]`, whose keys its fields are.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Analysis {
    /// Plane stress or plane strain.
    pub plane: PlaneState,
    /// Half or whole model.
    pub model: ModelChoice,
    /// On which geometry contact is found, where the scene says so.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub kinematics: Option<KinematicsChoice>,
    /// How the compliance of a body is held, where the scene says so.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub compliance: Option<ComplianceChoice>,
    /// Solver of the contact problem.
    #[serde(with = "solver_name")]
    pub solver: SolverChoice,
    /// Whether solvers may be used whose answers may be inexact.
    // Left out where it is false, so that it is no part of other scenes.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub experimental: bool,
    /// Equal sub-steps from one load step to the next, at least 1; `None` where they are left to the program.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub substeps: Option<usize>,
    /// How the load grows within the first step; `None` where it is left to the program.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ramp: Option<Ramp>,
    /// Largest errors that are asked for; [`Accuracy::DEFAULT`] where no mesh is given.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub accuracy: Option<Accuracy>,
    /// Time within which the accuracy is to be reached.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub budget: Option<Budget>,
    /// Memory that finer models may take; [`Memory::DEFAULT`] where none is given.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub memory: Option<Memory>,
    /// Nodes on half of each contact circle of bodies by series.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub contact_nodes: Option<usize>,
}

impl Default for Analysis {
    fn default() -> Self {
        Self {
            plane: PlaneState::Stress,
            model: ModelChoice::Auto,
            kinematics: None,
            compliance: None,
            solver: SolverChoice::Auto,
            experimental: false,
            substeps: None,
            ramp: None,
            accuracy: None,
            budget: None,
            memory: None,
            contact_nodes: None,
        }
    }
}

impl Analysis {
    /// Sub-steps of a load step, where they are left to the program those that it begins with.
    pub fn substeps(&self) -> usize {
        self.substeps.unwrap_or(1)
    }

    /// How the load grows within the first step.
    pub fn ramp(&self) -> Ramp {
        self.ramp.unwrap_or(Ramp::Linear)
    }
}

/// How much of the bodies is modelled.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum ModelChoice {
    /// Half where shapes, materials, friction laws, supports and loads are symmetric about the x axis, otherwise whole.
    Auto,
    /// The half y ≥ 0.
    Half,
    /// The whole.
    Whole,
}

/// On which geometry contact is found.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum KinematicsChoice {
    /// The undeformed one.
    Small,
    /// The deformed one, between linear bodies.
    DeformedGaps,
    /// The deformed one where that matters to the accuracy that is asked for.
    Auto,
}

/// How the compliance of a body with contact on several edges is held.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum ComplianceChoice {
    /// As one matrix up to a size, in blocks beyond.
    Auto,
    /// As one matrix.
    Matrix,
    /// As a matrix for each edge, and few shapes of forces by which edges act on each other.
    Blocks,
}

pub use stickslip_contact::SolverKind as SolverChoice;

/// How the load P grows over the n sub-steps k of the first step, and of later ones that begin with all points open.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Ramp {
    /// P k/n.
    Linear,
    /// P (k/n)²: small steps while contact spreads fast.
    Quadratic,
}

/// A solver by its name in the list of the contact crate.
mod solver_name {
    use std::fmt;

    use serde::de::{
        Deserialize, Deserializer, EnumAccess, Error as _, VariantAccess as _, Visitor,
    };
    use serde::ser::Serializer;

    use super::SolverChoice;

    #[expect(
        clippy::trivially_copy_pass_by_ref,
        reason = "serde hands over references"
    )]
    pub(super) fn serialize<S: Serializer>(
        solver: &SolverChoice,
        serializer: S,
    ) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(solver.info().name)
    }

    pub(super) fn deserialize<'de, D: Deserializer<'de>>(
        deserializer: D,
    ) -> Result<SolverChoice, D::Error> {
        deserializer.deserialize_enum("SolverChoice", &SolverChoice::NAMES, Names)
    }

    struct Names;

    impl<'de> Visitor<'de> for Names {
        type Value = SolverChoice;

        fn expecting(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
            formatter.write_str("enum SolverChoice")
        }

        fn visit_enum<A: EnumAccess<'de>>(self, data: A) -> Result<SolverChoice, A::Error> {
            let (Name(solver), variant) = data.variant()?;
            variant.unit_variant()?;
            Ok(solver)
        }
    }

    struct Name(SolverChoice);

    impl<'de> Deserialize<'de> for Name {
        fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
            let name = String::deserialize(deserializer)?;
            let solver = SolverChoice::named(&name);
            let unknown = || D::Error::unknown_variant(&name, &SolverChoice::NAMES);
            solver.map(Self).ok_or_else(unknown)
        }
    }
}
