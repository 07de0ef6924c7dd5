//! The bodies of a model as the interface problem sees them.

use std::sync::Arc;

use stickslip_contact::Interface;
use stickslip_fem_core::{InterfaceOperator, parallel};

use super::error::RunError;
use super::follow::Progress;
use super::solved::Operator;
use crate::model::{Model, ModelBody, ModelBodyKind};

/// The condensed bodies of a model and their interface problem, ready for any history of loads.
#[derive(Clone, Debug)]
pub struct Assembled {
    /// One operator per body.
    pub operators: Vec<Operator>,
    /// All contacts, in independent parts.
    pub interface: Interface,
    /// Wall time of the condensation and of the interface problem `[s]`.
    pub phases: [(&'static str, f64); 2],
}

impl Assembled {
    /// Condenses the bodies of `model` and puts its contacts between them.
    ///
    /// # Errors
    /// [`RunError::Body`], [`RunError::Contact`].
    pub fn of(model: &Model, progress: &mut dyn FnMut(Progress)) -> Result<Self, RunError> {
        progress(Progress::Phase("factorisation"));
        let start = model.host.seconds();
        let operators = condense(model)?;
        let condensed = model.host.seconds() - start;
        let interface = interface(model, &operators)?;
        let assembled = model.host.seconds() - start;
        let phases = [
            ("factorisation", condensed),
            ("interface", assembled - condensed),
        ];
        Ok(Self {
            operators,
            interface,
            phases,
        })
    }

    /// The same bodies with those by series of `model`, which differs from their own model in nothing else that operators depend on.
    ///
    /// # Errors
    /// [`RunError::Contact`].
    pub fn with_series_of(self, model: &Model) -> Result<Self, RunError> {
        let is_kept = |(operator, body): (&Operator, &ModelBody)| match (operator, &body.series) {
            (Operator::Series(own), Some(series)) => Arc::ptr_eq(own, series),
            _ => true,
        };
        if self.operators.iter().zip(&model.bodies).all(is_kept) {
            return Ok(self);
        }
        let renewed = self.operators.into_iter().zip(&model.bodies);
        let renewed = renewed.map(|(operator, body)| match &body.series {
            Some(series) => Operator::Series(Arc::clone(series)),
            None => operator,
        });
        let operators: Vec<Operator> = renewed.collect();
        let interface = interface(model, &operators)?;
        Ok(Self {
            operators,
            interface,
            ..self
        })
    }
}

fn interface(model: &Model, operators: &[Operator]) -> Result<Interface, RunError> {
    let faces: Vec<&dyn InterfaceOperator> = operators.iter().map(Operator::interface).collect();
    Ok(model.interface(&faces)?)
}

/// Condenses all bodies, in parallel; the result does not depend on the number of threads.
///
/// # Errors
/// [`RunError::Body`].
pub fn condense(model: &Model) -> Result<Vec<Operator>, RunError> {
    let operators = parallel::map(&model.bodies, |body| match (&body.kind, &body.series) {
        (_, Some(series)) => Ok(Operator::Series(Arc::clone(series))),
        (ModelBodyKind::Rigid(rigid), None) => Ok(Operator::Rigid(rigid.clone())),
        (ModelBodyKind::Elastic(elastic), None) => body
            .condense(elastic)
            .map(|condensed| Operator::Elastic(Arc::new(condensed)))
            .map_err(|cause| RunError::Body {
                body: body.name.clone(),
                cause,
            }),
    });
    operators.into_iter().collect()
}
