//! How much of static friction the displacements could show.
//!
//! Static friction that drops to the dynamic value has no length scale: it decides where the edge sticks, and hardly changes displacements.
//! Contact solves of the scene give the change in fringes.

use stickslip_friction::{StaticDynamic, Transition};
use stickslip_hybrid::identify::{Bounds, SlipFit};

use crate::laws::{Candidate, ContactModel, LawsError, sensitivity};
use stickslip_experiment::Experiment;

/// Static over dynamic coefficient, and what it is changed to `[1]`.
pub const RATIOS: [f64; 2] = [1.4, 1.2];

/// The most that the hole's edge deforms in any load step of the scene when static friction is 1.2 instead of 1.4 times the dynamic one
/// `[fringes]`; `None` without a scene, a grating, or a coefficient with two ends.
///
/// # Errors
/// [`LawsError`] of the contact solves.
pub fn moves(experiment: &Experiment, dynamic: Option<&SlipFit>) -> Option<Result<f64, LawsError>> {
    let own = experiment.specimen.model.as_ref()?;
    let grating = experiment.grating?;
    let fit = dynamic.filter(|fit| matches!(fit.bounds, Bounds::Between(..)))?;
    let [from, to] = RATIOS.map(|ratio| ratio * fit.mu);
    let law = StaticDynamic::new(from, fit.mu, Transition::Drop).ok()?;
    let law = Candidate::of_law("drop", &law, &[("static", [0.0, 2.0 * from])]).ok()?;
    let moved = || -> Result<f64, LawsError> {
        let model = ContactModel::new(own)?;
        let found = sensitivity(&model, &law, &[from], &[vec![to]], grating.frequency())?;
        let steps = found.iter().flat_map(|own| &own.deformation);
        Ok(steps.copied().fold(0.0, f64::max))
    };
    Some(moved())
}
