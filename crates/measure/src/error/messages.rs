//! Causes in the words of an experiment: places with their angle, lengths with the unit of results.

use stickslip_fem_core::mesh::Point;
use stickslip_hybrid::data::Field;
use stickslip_hybrid::reduce::{ReduceError, Uncovered};
use stickslip_hybrid::region::RegionError;

use stickslip_experiment::Experiment;

/// Nodes that are named.
const SHOWN: usize = 3;

/// Why a region, or the fit of its boundary, fails.
pub(crate) fn of_region(experiment: &Experiment, cause: &RegionError) -> String {
    match cause {
        RegionError::NotDetermined { place } => format!(
            "the data do not determine the displacement of the region's node at {}: no measurement is near enough",
            at(experiment, *place)
        ),
        _ => cause.to_string(),
    }
}

/// Why displacements of nodes cannot be found.
pub(crate) fn of_reduction(experiment: &Experiment, cause: &ReduceError) -> String {
    let ReduceError::Uncovered { wanted, nodes } = cause else {
        return cause.to_string();
    };
    let mut shown: Vec<String> = nodes
        .iter()
        .take(SHOWN)
        .map(|node| uncovered(experiment, node))
        .collect();
    if nodes.len() > SHOWN {
        shown.push(format!("and {} more", nodes.len() - SHOWN));
    }
    format!(
        "{} of {wanted} nodes are not covered by the data: {}",
        nodes.len(),
        shown.join("; ")
    )
}

fn uncovered(experiment: &Experiment, node: &Uncovered) -> String {
    let length = |value: f64| experiment.display.length.show(value);
    format!(
        "{} at {}: {}",
        Field::BOTH[node.component].name(),
        at(experiment, node.place),
        node.reason.describe(&length)
    )
}

/// A place with its angle around the hole.
pub(crate) fn at(experiment: &Experiment, [x, y]: Point) -> String {
    let length = experiment.display.length;
    let centre = experiment.specimen.hole.centre;
    format!(
        "({}, {}), θ = {:.1}°",
        length.show(x),
        length.show(y),
        (y - centre[1]).atan2(x - centre[0]).to_degrees()
    )
}

/// What to do about a region that cannot be analysed.
pub(super) fn remedy_of_region(cause: &RegionError) -> &'static str {
    match cause {
        RegionError::Body(_) | RegionError::Mesh(_) | RegionError::Generate(_) => {
            "correct region.sector or the file of region.mesh"
        }
        RegionError::NoData { .. } => {
            "check scale, origin and y_axis of the data, or put the region where they are"
        }
        RegionError::Deviation(_) => {
            "state the standard deviation that the measurement has: deviation = \"0.5 um\" in its table, in fringes in its lines"
        }
        RegionError::NotCovariance { .. } | RegionError::Eigenvalues { .. } => {
            "the weights of the data differ too much for double precision: take fewer cells, or state another amount of region.smoothing"
        }
        RegionError::SmoothingOrder(_) | RegionError::SmoothingAmount(_) => {
            "correct region.smoothing"
        }
        _ => {
            "make the region smaller, its cells fewer or the areas of `interior` smaller, or measure where it has no data"
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_cause_has_a_remedy_of_its_own() {
        let causes = [
            (RegionError::NoData { places: 3 }, "origin"),
            (RegionError::Deviation(0.0), "deviation = \"0.5 um\""),
            (RegionError::NotCovariance { row: 1 }, "fewer cells"),
            (RegionError::Eigenvalues { order: 8 }, "region.smoothing"),
            (RegionError::SmoothingOrder(7), "correct region.smoothing"),
            (
                RegionError::NotDetermined { place: [0.0; 2] },
                "measure where",
            ),
        ];
        for (cause, part) in causes {
            let remedy = remedy_of_region(&cause);
            assert!(remedy.contains(part), "{cause}: {remedy}");
        }
    }
}
