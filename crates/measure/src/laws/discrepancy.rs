//! The error due to the mesh of the fitted model, where the truth is known.
//!
//! ```text
//! d_k = u_model(x_k) − u_truth(x_k) − Z b,     both with the friction of their own scene,     χ² = |L⁻¹ d|²
//! ```
//!
//! A measurement cannot show this error: the distance of the true law on the model's mesh from the data.

use std::sync::Arc;

use stickslip_hybrid::calibrate::{Block, Data};

use super::observation::root_mean_square;
use super::{ContactModel, LawsError, Observation};
use crate::truth::Truth;

/// How far the model with the friction of its scene is from the truth at the data of a state.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Discrepancy {
    /// Root of the mean square, less what is free of the state `[mm]`.
    pub rms: f64,
    /// The largest `[mm]`.
    pub largest: f64,
    /// χ² of data without any error `[1]`.
    pub chi_squared: f64,
}

/// The discrepancy at the data of each of `observations`; `None` for those that are no load steps of `truth`.
///
/// # Errors
/// [`LawsError`] of the places and the contact solves.
pub fn discrepancies(
    model: &ContactModel,
    truth: &Truth,
    observations: &[Observation],
) -> Result<Vec<Option<Discrepancy>>, LawsError> {
    let states = model.states(Arc::clone(model.own_law()), model.steps())?;
    (observations.iter())
        .map(|own| {
            let view = model.view(&own.places)?;
            let sampling = truth.sampled(&own.places);
            let mut difference = vec![0.0; 2 * own.places.len()];
            for (step, sign) in [(Some(own.step), 1.0), (own.null, -1.0)] {
                let Some(step) = step else { continue };
                let Some(state) = states.get(step) else {
                    return Ok(None);
                };
                let seen = view.displacements(state);
                for axis in 0..2 {
                    let exact = truth.component(&sampling, step, axis);
                    for (place, exact) in exact.into_iter().enumerate() {
                        // A place beside the coarser of two polygons counts as one without a difference.
                        let exact = exact.unwrap_or(seen[2 * place + axis]);
                        difference[2 * place + axis] += sign * (seen[2 * place + axis] - exact);
                    }
                }
            }
            of_differences(own, &difference).map(Some)
        })
        .collect()
}

/// `difference`: x and y of each place of the observation in turn.
fn of_differences(own: &Observation, difference: &[f64]) -> Result<Discrepancy, LawsError> {
    let at = |&(place, axis): &(usize, usize)| difference[2 * place + axis];
    let values: Vec<f64> = own.components.iter().map(at).collect();
    let none = vec![0.0; values.len()];
    let block = Block {
        values: values.clone(),
        ..own.block()
    };
    let left = own.left_of(values)?;
    Ok(Discrepancy {
        rms: root_mean_square(&left),
        largest: left.iter().fold(0.0, |most: f64, own| most.max(own.abs())),
        chi_squared: Data::new(vec![block])
            .map_err(LawsError::Data)?
            .chi_squared(&none),
    })
}
