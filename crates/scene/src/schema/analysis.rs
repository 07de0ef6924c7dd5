//! How a scene is solved.

use serde::{Deserialize, Serialize};
use stickslip_contact::solver::SOLVERS;
use stickslip_fem_core::material::PlaneState;

use super::demand::{Accuracy, Budget, Memory};
use crate::declaration::choices::quoted;
use crate::declaration::{Table, counts, described, flag, integer, names};

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
    /// Half where shapes, materials, friction laws, supports and loads are symmetric about the shapes' axis, otherwise whole.
    Auto,
    /// The half y ≥ 0 of round shapes, x ≥ 0 of a line contact.
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
    /// The same, and sub-steps with friction are divided where points close or open.
    Contact,
}

#[rustfmt::skip]
pub(crate) const TABLES: &[Table] = &[
    Table::new("analysis", &[
        described("plane", r#"`"stress"`, `"strain"`"#, r#"`"stress"`"#, r#""strain""#, "plane stress or plane strain"),
        described("model", r#"`"auto"`, `"half"`, `"whole"`"#, r#"`"auto"`"#, r#""whole""#,
            "half: y ≥ 0 of round shapes, x ≥ 0 of a line contact; auto takes it where shapes, materials, supports, platens, \
            loads and friction laws are symmetric and it has all `edges`; half is refused where they are not; a rectangle has \
            no half"),
        described("kinematics", r#"`"small"`, `"deformed-gaps"`, `"auto"`"#, r#"`"small"` with a mesh or fasteners, `"auto"` without"#, r#""deformed-gaps""#,
            "small: contact is found on the undeformed geometry; deformed-gaps: gaps, normals and closest points follow the displacement, \
            between linear bodies, for exact gaps and matching meshes; not for progressive failure and experiments; auto: deformed-gaps where it \
            changes more than three tenths of the accuracy, otherwise small with the change among the errors"),
        described("compliance", r#"`"auto"`, `"matrix"`, `"blocks"`"#, r#"`"auto"`"#, r#""blocks""#,
            "how the compliance of a body with contact on several edges is held: matrix: as one; blocks: as a matrix for each edge and few shapes \
            of forces, harmonics on a hole, by which edges act on each other, with the error in tractions among the choices; auto: blocks beyond \
            4000 components where solver and kinematics allow them"),
        names("solver", solvers,
            r#"`"auto"`"#, r#""pivoting""#,
            "auto and newton: semismooth Newton, then pivoting where it fails; status: iteration of statuses before these \
            two; the others alone. All but experimental ones ask first for a proof that the load cannot be balanced, and stop \
            at stated work"),
        flag("experimental", "`false`", "true",
            "allows solvers whose answers may be inexact (penalty) or that are limited to few points or to small friction \
            (enumeration, Tresca)"),
        integer("substeps", "`1`; by the accuracy where one is sought", "4",
            "equal sub-steps of every load step; one that fails is halved by itself").range(counts(1, 100_000)),
        described("ramp", r#"`"linear"`, `"quadratic"`, `"contact"`"#, r#"`"linear"`, `"contact"` where the program chooses sub-steps"#, r#""contact""#,
            "load at sub-step k of n in the first load step, from nothing to its value P: P k/n, or P (k/n)², finer where \
            contact spreads fastest; the same of what a later step adds if it begins with all points open; others are linear; \
            with `\"contact\"` sub-steps with friction also end wherever a point is about to close or to open, so that hardly \
            any error of sub-steps is left"),
        described("accuracy", "percentage or number, 1e-8 to 0.5, or a table of these", "`\"1 %\"` without a mesh", r#"{ peak_pressure = "0.1 %" }"#,
            "largest relative error that is asked for; bodies and steps are divided until the estimated errors of peak pressure, peak \
            tangential stress, extent of contact and friction force, or of displacements in a scene without edges, are below it; or those of the numbers that a table names, each \
            with its own: `peak_pressure`, `peak_hoop`, `contact_extent`, `stick_extent`, `friction_force`, `normal_force`, \
            `hoop_at_bearing`, `displacement` and `stiffness` of what is loaded, `tangent_stiffness`, `reaction`"),
        described("budget", "time", r#"`"60 s"` without `accuracy`, no limit with it"#, r#""10 s""#,
            "time after which no finer model is tried, and one that is not ready is given up; the result then states the error that it has; needs `accuracy`"),
        described("memory", "memory", r#"`"4 GB"`"#, r#""16 GB""#,
            "estimated memory above which no finer model of elements is tried; the result then states the error that it has; for scenes whose mesh is left to the program"),
        integer("contact_nodes", "by the accuracy", "61",
            "nodes on half of each contact circle of bodies by series; pins them").range(counts(9, 2049)),
    ]),
];

/// The names of the contact solvers.
fn solvers() -> String {
    let of = |experimental: bool| {
        let own = SOLVERS
            .iter()
            .filter(|own| own.experimental == experimental);
        quoted(own.map(|own| own.name))
    };
    format!("{}; experimental {}", of(false), of(true))
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
