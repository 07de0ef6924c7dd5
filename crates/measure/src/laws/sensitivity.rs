//! How far the edge moves when a parameter of the friction law does.
//!
//! ```text
//! ΔN_k = f max over the edge of |u_k(θ + Δθ) − u_k(θ) − Z b|,     Z b: the rigid motion that fits best
//! ```

use std::sync::Arc;

use stickslip_fem_core::mesh::Point;

use super::observation::left;
use super::{Candidate, ContactModel, LawsError, Nuisance};

/// The largest change of the edge's displacements in each load step.
#[derive(Clone, Debug, PartialEq)]
pub struct Sensitivity {
    /// Changed values of the parameters, in their order and units.
    pub values: Vec<f64>,
    /// Largest change of either component along the edge at each load step `[fringes]`.
    pub whole: Vec<f64>,
    /// The same after the rigid motion that fits best `[fringes]`.
    pub deformation: Vec<f64>,
}

/// Changes when the parameters of `law` go from `from` to each of `to`, with a grating of `frequency` `[1/mm]`.
///
/// # Errors
/// [`LawsError`] of the law, the places and the contact solves.
pub fn sensitivity(
    model: &ContactModel,
    law: &Candidate,
    from: &[f64],
    to: &[Vec<f64>],
    frequency: f64,
) -> Result<Vec<Sensitivity>, LawsError> {
    let places: Vec<Point> = model.edge().iter().map(|(_, place)| *place).collect();
    let view = model.view(&places)?;
    let history = |values: &[f64]| -> Result<Vec<Vec<f64>>, LawsError> {
        let states = model.states(Arc::from(law.law(values)?), model.steps())?;
        let seen = states.iter().map(|state| view.displacements(state));
        Ok(seen.map(|u| u.as_slice().to_vec()).collect())
    };
    let base = history(from)?;
    let largest = |values: &[f64]| values.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
    (to.iter())
        .map(|values| {
            let changed = history(values)?;
            let (mut whole, mut deformation) = (Vec::new(), Vec::new());
            for (changed, base) in changed.iter().zip(&base) {
                let change: Vec<f64> = (changed.iter().zip(base))
                    .map(|(new, old)| frequency * (new - old))
                    .collect();
                whole.push(largest(&change));
                deformation.push(largest(&without_rigid_motion(
                    &places,
                    change,
                    model.is_half(),
                )));
            }
            Ok(Sensitivity {
                values: values.clone(),
                whole,
                deformation,
            })
        })
        .collect()
}

/// `change`, x and y of each place in turn, less the rigid motion that fits best; of a symmetric half that is one along x.
fn without_rigid_motion(places: &[Point], change: Vec<f64>, half: bool) -> Vec<f64> {
    let components: Vec<(usize, usize)> = (0..change.len()).map(|k| (k / 2, k % 2)).collect();
    let mut motions = Nuisance::Rigid.columns(places, &components);
    if half {
        motions.truncate(1);
    }
    // Unit standard deviations and independent columns are always accepted.
    left(motions, change.clone()).unwrap_or(change)
}
