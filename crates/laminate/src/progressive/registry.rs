//! The point models that are linked into the program, by the name that a file gives them.

use std::fmt::Debug;
use std::sync::Arc;

pub use stickslip_friction::{Dimension, ParameterInfo};

use super::error::ProgressiveError;
use super::model::PointModel;
use crate::degradation::Degradation;
use crate::failure::FailureCriterion;
use crate::laminate::Laminate;

/// The parameters of a point model as a file gives them, checked, and the model that they make of a laminate.
///
/// A file names a model by an external tag, `model.plasticity = { hardening = "500 MPa" }`, and its table is read as one of these through
/// `typetag`; numbers are in the units of the laminate. Three things make a model of another crate: the trait [`PointModel`], its
/// parameters with a name for `typetag`, and a [`PointModelInfo`] that says which parameters have dimensions. `examples/custom-law` of the
/// workspace shows all three.
#[typetag::serde]
pub trait PointModelParameters: Debug + Send + Sync {
    /// Name of the model in files.
    fn name(&self) -> &'static str {
        self.typetag_name()
    }

    /// Name of the failure criterion that the parameters ask for; `None` if any does, or none is needed.
    fn criterion(&self) -> Option<&str> {
        None
    }

    /// What failed plies keep of their stiffness; `None` for a model whose plies lose none at once. Strengths can be scaled by fracture
    /// energies where it is given.
    fn degradation(&self) -> Option<Degradation> {
        None
    }

    /// Makes the model of `laminate`, whose plies fail by `criterion` if the model needs one.
    ///
    /// # Errors
    /// What the model says of the laminate: [`ProgressiveError::Failure`] for a missing strength, and others of its own.
    fn model(
        &self,
        laminate: Laminate,
        criterion: &Arc<dyn FailureCriterion>,
    ) -> Result<Arc<dyn PointModel>, ProgressiveError>;

    /// Describes the model in a phrase for a report, such as "Tsai–Hill plasticity, plastic shear modulus 500 MPa": `criterion` is the
    /// name of the criterion in use, and `stress` writes a number `[stress]` with its unit.
    fn describe(&self, criterion: &str, stress: &dyn Fn(f64) -> String) -> String {
        let _ = (criterion, stress);
        self.name().to_owned()
    }
}

/// Describes a point model that a file can name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PointModelInfo {
    /// Name of the model in files, the same as that given to `typetag`.
    pub name: &'static str,
    /// The model in one line.
    pub summary: &'static str,
    /// Its parameters; every value that a file may hold below the model's name has an entry.
    pub parameters: &'static [ParameterInfo],
}

inventory::collect!(PointModelInfo);

/// Lists all registered point models by name, those of other crates included.
pub fn point_models() -> impl Iterator<Item = &'static PointModelInfo> {
    let mut sorted: Vec<_> = inventory::iter::<PointModelInfo>.into_iter().collect();
    // The order of registration is the linker's.
    sorted.sort_by_key(|info| info.name);
    sorted.into_iter()
}
