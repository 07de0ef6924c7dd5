//! What can be wrong with plies, laminates and questions about their failure, each with its remedy.

use miette::Diagnostic;
use stickslip_laminate::degradation::DegradationError;
use stickslip_laminate::laminate::LaminateError;
use stickslip_laminate::layup::LayupError;
use stickslip_laminate::ply::PlyError;
use stickslip_laminate::progressive::ProgressiveError;
use stickslip_laminate::{FailureError, Strength};
use thiserror::Error;

use super::remedy::material_remedy;

/// One thing wrong with a laminate or with what is asked of it.
#[derive(Debug, Clone, PartialEq, Error, Diagnostic)]
#[non_exhaustive]
pub enum LaminateProblem {
    /// A ply that cannot exist.
    #[error("{cause}")]
    #[diagnostic(code(scene::ply), help("{}", ply_remedy(cause)))]
    Ply {
        /// Its name and what is wrong.
        cause: PlyError,
    },
    /// A text that is no lay-up.
    #[error("material '{material}': {cause}")]
    #[diagnostic(
        code(scene::layup),
        help(
            "write angles in degrees between slashes, as in \"[0/±45/90]s\" or \"[0_2/60_2/-60_2]s\"; `stickslip list layups` shows more"
        )
    )]
    Layup {
        /// Name of the material.
        material: String,
        /// What is wrong, and where.
        cause: LayupError,
    },
    /// Plies that make no laminate, or none that may be used in its plane.
    #[error("material '{material}': {cause}")]
    #[diagnostic(code(scene::laminate), help("{}", laminate_remedy(cause)))]
    Laminate {
        /// Name of the material.
        material: String,
        /// What is wrong.
        cause: LaminateError,
    },
    /// A laminate where nothing may deform across the thickness.
    #[error("material '{material}' is a laminate, which is a thin plate, but plane = \"strain\"")]
    #[diagnostic(
        code(scene::laminate_plane),
        help("say plane = \"stress\", or give orthotropic constants with e3, nu13 and nu23")
    )]
    PlaneStrain {
        /// Name of the material.
        material: String,
    },
    /// A body's thickness that is not that of its laminate.
    #[error(
        "thickness = {given} contradicts the lay-up of '{material}', which is {laminate} thick"
    )]
    #[diagnostic(
        code(scene::laminate_thickness),
        help("leave thickness out, or change the lay-up or the thickness of its plies")
    )]
    Thickness {
        /// Name of the material.
        material: String,
        /// The thickness as written.
        given: String,
        /// The laminate's, with its unit.
        laminate: String,
    },
    /// A failure question that cannot be answered.
    #[error("{cause}")]
    #[diagnostic(code(scene::failure), help("{}", failure_remedy(cause)))]
    Failure {
        /// What is missing.
        cause: FailureError,
    },
    /// Factors of failed plies that do not soften.
    #[error("{cause}")]
    #[diagnostic(
        code(scene::degradation),
        help("0.01 to 0.1 are usual for both: what a failed ply still carries")
    )]
    Degradation {
        /// Which, and its value.
        cause: DegradationError,
    },
    /// A failure question about a body that has no plies.
    #[error("body '{body}' has no plies: its material is no laminate")]
    #[diagnostic(
        code(scene::failure_body),
        help(
            "name bodies of a laminate: {}; or give materials.NAME.laminate",
            super::remedy::listed(laminates)
        )
    )]
    NoPlies {
        /// The body.
        body: String,
        /// Bodies that have plies.
        laminates: Vec<String>,
    },
    /// A question about failure in a scene without laminates.
    #[error("[failure] needs a laminate, but no body of this scene is made of a laminate")]
    #[diagnostic(
        code(scene::failure_bodies),
        help("give a body a material with [materials.NAME.laminate], or remove [failure]")
    )]
    NoLaminates,
    /// A model of progressive failure that the plies do not allow.
    #[error("{cause}")]
    #[diagnostic(code(scene::progressive), help("{}", progressive_remedy(cause)))]
    Progressive {
        /// What is missing.
        cause: ProgressiveError,
    },
    /// Parameters that a point model refuses.
    #[error("point model '{model}': {message}")]
    #[diagnostic(
        code(scene::point_model),
        help("`stickslip list models` shows the parameters of '{model}' and their ranges")
    )]
    PointModel {
        /// Name of the model.
        model: String,
        /// What the parameters refuse, with the value.
        message: String,
    },
    /// Progressive failure without a pin.
    #[error(
        "progressive failure of '{body}' follows the load of one pin in its hole, and 0 contacts touch it"
    )]
    #[diagnostic(
        code(scene::progressive_pin),
        help("give one contact with first = \"{body}.hole\"")
    )]
    NoPin {
        /// The body.
        body: String,
    },
    /// Characteristic distances without a hole.
    #[error(
        "characteristic distances are measured from a single hole, and body '{body}' has {}",
        several(holes)
    )]
    #[diagnostic(
        code(scene::characteristic),
        help("leave '{body}' out of failure.bodies, or remove [failure.characteristic]")
    )]
    NoHole {
        /// The body.
        body: String,
        /// Names of its holes, none or several.
        holes: Vec<String>,
    },
}

fn several(holes: &[String]) -> String {
    match holes {
        [] => "none".to_owned(),
        _ => format!("the holes {}", holes.join(", ")),
    }
}

fn ply_remedy(cause: &PlyError) -> String {
    match cause {
        PlyError::Constant { cause, .. } => material_remedy(cause),
        PlyError::Thickness { .. } => {
            "give the thickness of one cured ply, such as \"0.125 mm\"".to_owned()
        }
        _ => "give a positive number, in compression too; leave out a strength that is not known"
            .to_owned(),
    }
}

fn laminate_remedy(cause: &LaminateError) -> String {
    match cause {
        LaminateError::BendingExtension { .. } => {
            "end the lay-up in s, or say held_flat = true where something holds the plate flat, such as a second one that mirrors it"
                .to_owned()
        }
        LaminateError::UnknownPly { .. } => {
            "give it as [plies.NAME], or correct the name after the colon".to_owned()
        }
        _ => "`stickslip list layups` shows how lay-ups are written".to_owned(),
    }
}

fn progressive_remedy(cause: &ProgressiveError) -> String {
    match cause {
        ProgressiveError::Failure(cause) => failure_remedy(cause),
        ProgressiveError::OpenYieldSurface { ply, limit, .. } => {
            format!(
                "give [plies.{ply}.strengths] yt and yc below {limit}, or choose model.ply_discount"
            )
        }
        _ => "choose another model: model.ply_discount = { fibre = 0.01, matrix = 0.1 }".to_owned(),
    }
}

fn failure_remedy(cause: &FailureError) -> String {
    match cause {
        FailureError::MissingStrength { strength, ply, .. } => {
            let example = if strength.name().starts_with("strain") {
                format!(
                    "{strength} = 0.01, or linear_strain_limits = true for strength over modulus"
                )
            } else {
                format!("{strength} = \"50 MPa\"")
            };
            format!(
                "add to [plies.{ply}.strengths] for example {example}; or choose other criteria"
            )
        }
        FailureError::NoStrengths { ply, .. } => {
            let all = [
                Strength::Xt,
                Strength::Xc,
                Strength::Yt,
                Strength::Yc,
                Strength::S12,
            ];
            let names = all.map(Strength::name).join(", ");
            format!("add [plies.{ply}.strengths] with {names}, positive magnitudes")
        }
        FailureError::Directions { .. } => "180 directions make a smooth curve".to_owned(),
        FailureError::OpenSurface { .. } => {
            "give tsai_wu_interaction between -1 and 1, as a multiple of sqrt(F11 F22)".to_owned()
        }
        _ => "`stickslip list criteria` shows the criteria and what they need".to_owned(),
    }
}
