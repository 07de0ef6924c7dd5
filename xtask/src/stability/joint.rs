//! Scenes condensed once, and then given any friction law, load history or gap.

use std::path::Path;
use std::sync::Arc;

use stickslip::host::HOST;
use stickslip::model::{Model, ModelBodyKind};
use stickslip::run::Operator;
use stickslip::scene::Scene;
use stickslip_contact::{ContactPair, InterfaceProblem};
use stickslip_fem_core::InterfaceOperator;
use stickslip_friction::{Coulomb, FrictionLaw};

use crate::publish::TaskError;

/// Condensed bodies with their contact pairs.
#[derive(Debug)]
pub(crate) struct Joint {
    pub(crate) operators: Vec<Operator>,
    pub(crate) pairs: Vec<ContactPair>,
    /// Multipliers of the scene's load steps.
    pub(crate) loads: Vec<Vec<f64>>,
}

impl Joint {
    /// Condenses `scenes/{name}.toml` with `overrides`.
    pub(crate) fn of_scene(name: &str, overrides: &[String]) -> Result<Self, TaskError> {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("../scenes/{name}.toml"));
        let scene = Scene::from_file(&path, overrides, HOST)?;
        let model = Model::build(&scene)?;
        let operators = model
            .bodies
            .iter()
            .map(|body| match &body.kind {
                ModelBodyKind::Rigid(rigid) => Ok(Operator::Rigid(rigid.clone())),
                ModelBodyKind::Elastic(elastic) => elastic
                    .condense(&body.interface)
                    .map(|condensed| Operator::Elastic(Arc::new(condensed))),
            })
            .collect::<Result<Vec<_>, _>>()?;
        Ok(Self {
            operators,
            pairs: model.pairs,
            loads: model.history.steps().to_vec(),
        })
    }

    /// The interface problem with the scene's own friction.
    pub(crate) fn problem(&self) -> Result<InterfaceProblem, TaskError> {
        let faces: Vec<&dyn InterfaceOperator> =
            self.operators.iter().map(Operator::interface).collect();
        Ok(InterfaceProblem::new(&faces, self.pairs.clone())?)
    }

    /// The interface problem with friction `law` in every contact.
    pub(crate) fn problem_with(
        &self,
        law: &Arc<dyn FrictionLaw>,
    ) -> Result<InterfaceProblem, TaskError> {
        let faces: Vec<&dyn InterfaceOperator> =
            self.operators.iter().map(Operator::interface).collect();
        let mut pairs = self.pairs.clone();
        for pair in &mut pairs {
            pair.law = Arc::clone(law);
        }
        Ok(InterfaceProblem::new(&faces, pairs)?)
    }
}

/// Coulomb's law with coefficient `mu`.
pub(crate) fn coulomb(mu: f64) -> Result<Arc<dyn FrictionLaw>, TaskError> {
    Ok(Arc::new(Coulomb::new(mu)?))
}

/// `--set` overrides from key and value.
pub(crate) fn set(pairs: &[(&str, String)]) -> Vec<String> {
    pairs
        .iter()
        .map(|(key, value)| format!("{key}={value}"))
        .collect()
}
