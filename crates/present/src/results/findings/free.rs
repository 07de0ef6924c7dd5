//! Bodies that nothing holds, as sentences.

use stickslip_results::{FreeBody, FreeMotion};

/// That a body moves without resistance, with slip in `contacts`.
pub(super) fn body(free: &FreeBody, contacts: &str) -> String {
    let (verb, motion) = match free.motion {
        FreeMotion::Rotation => ("turn", "rotation"),
        FreeMotion::Translation => ("slide", "translation"),
    };
    format!(
        "Body '{}' can {verb} freely: its {motion} and CSLIP1 on {contacts} are not unique.",
        free.body
    )
}

/// That bodies move together without resistance.
pub(super) fn together(bodies: &str, motions: &[FreeMotion]) -> String {
    let motion = match motions {
        [FreeMotion::Rotation] => "turning",
        [FreeMotion::Translation] => "sliding",
        _ => "turning and sliding",
    };
    format!(
        "Nothing holds {bodies} against {motion} together, as one rigid body: displacements hold up to that motion, which changes no stress and no slip."
    )
}
