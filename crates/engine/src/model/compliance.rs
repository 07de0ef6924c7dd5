//! How the compliance of a body is held: one matrix for all its edges in contact, or a block for each.

use stickslip_scene::Scene;
use stickslip_scene::schema::{ComplianceChoice, KinematicsChoice};

use super::{ModelBody, ModelBodyKind, ModelError};
use crate::results::Choice;

const KEY: &str = "analysis.compliance";
/// Components of the contact nodes of a body up to which its compliance is one matrix: 128 MB.
const LARGEST_MATRIX: usize = 4000;

/// Gives `bodies`, whose contact nodes have edges with the ends `ends`, the ends of the edges for which they are to have blocks.
///
/// # Errors
/// [`ModelError::Unsupported`] if the scene asks for blocks where there are none.
pub(super) fn choose(
    scene: &Scene,
    bodies: &mut [ModelBody],
    ends: Vec<Vec<usize>>,
    choices: &mut Vec<Choice>,
) -> Result<(), ModelError> {
    let asked = scene.analysis.compliance.unwrap_or(ComplianceChoice::Auto);
    if asked == ComplianceChoice::Matrix {
        return Ok(());
    }
    if let Some(why) = obstacle(scene) {
        return match asked {
            ComplianceChoice::Blocks => Err(refused(&why)),
            ComplianceChoice::Auto | ComplianceChoice::Matrix => Ok(()),
        };
    }
    let mut names = Vec::new();
    for (body, ends) in bodies.iter_mut().zip(ends) {
        let large = asked == ComplianceChoice::Blocks || 2 * body.interface.len() > LARGEST_MATRIX;
        if large && ends.len() > 1 && can_have_blocks(body) {
            names.push(format!("'{}'", body.name));
            body.ends = ends;
        }
    }
    if names.is_empty() {
        return match asked {
            ComplianceChoice::Blocks => Err(refused(
                "no body of finite elements has contact on several edges",
            )),
            ComplianceChoice::Auto | ComplianceChoice::Matrix => Ok(()),
        };
    }
    choices.push(Choice {
        what: "compliance".into(),
        value: format!("a block for each edge of {}", names.join(", ")),
        reason: "edges act on each other by few shapes of forces, on a hole its lowest harmonics; one matrix of all would take more memory \
                 and time"
            .into(),
    });
    Ok(())
}

/// What in the scene needs one matrix.
fn obstacle(scene: &Scene) -> Option<String> {
    let analysis = &scene.analysis;
    let solver = analysis.solver.info();
    if !solver.on_blocks {
        return Some(format!("solver = \"{}\" works on one matrix", solver.name));
    }
    if analysis.kinematics == Some(KinematicsChoice::DeformedGaps) {
        return Some(
            "kinematics = \"deformed-gaps\" changes the compliance of single nodes".into(),
        );
    }
    scene
        .seeks_accuracy()
        .then(|| "an accuracy is sought on nodes that differ from step to step".into())
}

/// A body that is held by its section has one matrix, which that changes as a whole.
fn can_have_blocks(body: &ModelBody) -> bool {
    match &body.kind {
        ModelBodyKind::Elastic(elastic) => {
            body.series.is_none() && elastic.section_hold().is_none()
        }
        ModelBodyKind::Rigid(_) => false,
    }
}

fn refused(why: &str) -> ModelError {
    ModelError::Unsupported {
        key: KEY.into(),
        what: format!(
            "{KEY} = \"blocks\" cannot be had: {why}; leave it out, or say compliance = \"matrix\""
        ),
    }
}
