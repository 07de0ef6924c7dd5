//! What a contact pair must meet.

use stickslip_fem_core::InterfaceOperator;

use super::{ContactPair, ContactPoint, Stencil};
use crate::error::ContactError;

/// Checks `pairs` and `bodies`; the number of load cases that these have in common.
pub(crate) fn all(
    pairs: &[ContactPair],
    bodies: &[&dyn InterfaceOperator],
) -> Result<usize, ContactError> {
    let cases = bodies.first().map_or(0, |body| body.load_cases());
    if let Some(other) = bodies.iter().find(|body| body.load_cases() != cases) {
        return Err(ContactError::LoadCases {
            first: cases,
            other: other.load_cases(),
        });
    }
    pairs.iter().try_for_each(|one| pair(one, bodies))?;
    Ok(cases)
}

fn pair(pair: &ContactPair, bodies: &[&dyn InterfaceOperator]) -> Result<(), ContactError> {
    let refuse = |point: usize, what: String| ContactError::InvalidPair {
        pair: pair.name.clone(),
        point,
        what,
    };
    for body in [pair.first, pair.second] {
        if body >= bodies.len() {
            let what = format!("body {body} of {} does not exist", bodies.len());
            return Err(refuse(0, what));
        }
    }
    for (k, point) in pair.points.iter().enumerate() {
        for (body, side) in [(pair.first, &point.first), (pair.second, &point.second)] {
            stencil(side, body, bodies[body].points().len()).map_err(|what| refuse(k, what))?;
        }
        numbers(point).map_err(|what| refuse(k, what))?;
    }
    Ok(())
}

fn stencil(stencil: &Stencil, body: usize, count: usize) -> Result<(), String> {
    if stencil.terms().is_empty() {
        return Err(format!("no node of body {body}"));
    }
    for term in stencil.terms() {
        if term.node >= count {
            let node = term.node;
            return Err(format!(
                "contact node {node} of body {body}, which has {count}"
            ));
        }
        if !term
            .weights
            .iter()
            .flatten()
            .all(|weight| weight.is_finite())
        {
            return Err(format!(
                "the weights {:?} of node {}",
                term.weights, term.node
            ));
        }
    }
    Ok(())
}

fn numbers(point: &ContactPoint) -> Result<(), String> {
    let length = point.normal[0].hypot(point.normal[1]);
    if length.is_nan() || (length - 1.0).abs() >= 1e-9 {
        return Err(format!("the normal has length {length}, not 1"));
    }
    if !point.gap.is_finite() {
        return Err(format!("the initial gap is {}", point.gap));
    }
    if !(point.area > 0.0 && point.area.is_finite()) {
        return Err(format!("the contact area is {}", point.area));
    }
    Ok(())
}
