//! What the parameters of a point model must fulfil, so that a file can name the model.

use std::sync::Arc;

use serde_json::Value;

use super::breach::{ParametersBreach, PointViolation};
use super::{PointSample, check_point_model};
use crate::failure::FailureCriterion;
use crate::laminate::Laminate;
use crate::progressive::{PointModelParameters, point_models};

/// Tests `parameters` and the model that they make of `laminate` and `criterion`: their name is registered with every parameter, they are
/// written and read again without loss, an unknown parameter is refused, and the model that was read passes
/// [`check_point_model`] along `sample`.
///
/// # Errors
/// The first property that is broken, with the numbers.
pub fn check_parameters(
    parameters: &dyn PointModelParameters,
    laminate: &Laminate,
    criterion: &Arc<dyn FailureCriterion>,
    sample: &PointSample,
) -> Result<(), PointViolation> {
    let broken = |breach: ParametersBreach| PointViolation {
        breach: Box::new(breach.into()),
    };
    let copy = written_and_read(parameters).map_err(broken)?;
    let model = copy.model(laminate.clone(), criterion);
    let model = model.map_err(|cause| broken(ParametersBreach::NoModel { cause }))?;
    check_point_model(model.as_ref(), sample)
}

fn written_and_read(
    parameters: &dyn PointModelParameters,
) -> Result<Box<dyn PointModelParameters>, ParametersBreach> {
    let name = parameters.name();
    let info = point_models()
        .find(|info| info.name == name)
        .ok_or(ParametersBreach::NotRegistered { name })?;
    let mut written = serde_json::to_value(parameters).map_err(|error| failed(&error))?;
    let copy = read(&written).map_err(|error| failed(&error))?;
    let again = serde_json::to_value(copy.as_ref()).map_err(|error| failed(&error))?;
    if written != again {
        return Err(ParametersBreach::CopyDiffers {
            first: written.to_string(),
            second: again.to_string(),
        });
    }
    // Parameters without a table, such as those of a unit struct, have no place for an unknown one.
    if let Some(Value::Object(table)) = written.get_mut(name) {
        let described = |key: &str| {
            let mut paths = info.parameters.iter().map(|parameter| parameter.path);
            paths.any(|path| path.split(['.', '[']).next() == Some(key))
        };
        if let Some(parameter) = table.keys().find(|key| !described(key)) {
            let parameter = parameter.clone();
            return Err(ParametersBreach::NotDescribed { parameter });
        }
        table.insert("no such parameter".to_owned(), Value::from(1.0));
        if read(&written).is_ok() {
            return Err(ParametersBreach::UnknownParameterAccepted {
                written: written.to_string(),
            });
        }
    }
    Ok(copy)
}

/// From a tree of values rather than text: what is tested is the model, not the digits of a format.
fn read(written: &Value) -> Result<Box<dyn PointModelParameters>, serde_json::Error> {
    serde_json::from_value(written.clone())
}

fn failed(error: &serde_json::Error) -> ParametersBreach {
    ParametersBreach::NotSerialisable {
        message: error.to_string(),
    }
}
