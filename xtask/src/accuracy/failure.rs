//! Loads and indices of failing plies, beside those of a finer division.

use stickslip::results::{BodyFailure, FirstPly};

use super::Number;

/// The numbers of a body beside those of `truth`; `unloading` says so of a step.
pub(super) fn numbers(
    found: &BodyFailure,
    truth: &BodyFailure,
    unloading: impl Fn(usize) -> bool,
) -> Vec<Number> {
    let firsts = |of: &BodyFailure| -> [Vec<Option<FirstPly>>; 2] {
        let curve = of.characteristic.iter().flat_map(|own| &own.curve);
        let joints = curve.map(|joint| joint.as_ref().map(|joint| joint.first.clone()));
        [of.first_ply.clone(), joints.collect()]
    };
    let names = ["load of first-ply failure", "load of failure on the curve"];
    let loads = names
        .into_iter()
        .zip(firsts(found).into_iter().zip(firsts(truth)));
    let loads = loads.flat_map(|(name, (own, exact))| {
        let pairs = own.into_iter().zip(exact);
        pairs.filter_map(move |(own, exact)| {
            let (own, exact) = (own?, exact?);
            Some(Number {
                name,
                step: own.step + 1,
                unloading: false,
                values: [own.load.as_ref()?.value, exact.load.as_ref()?.value],
                errors: own.load_error.zip(exact.load_error).map(Into::into),
            })
        })
    });
    let steps = found.steps.iter().zip(&truth.steps).enumerate();
    let indices = steps.flat_map(|(step, (own, exact))| {
        let unloading = unloading(step);
        own.iter().zip(exact).map(move |(own, exact)| {
            let [error, doubt] = [own, exact].map(|point| point.errors?.index);
            Number {
                name: "failure index",
                step: step + 1,
                unloading,
                values: [own.index, exact.index],
                errors: error.zip(doubt).map(Into::into),
            }
        })
    });
    loads.chain(indices).collect()
}
