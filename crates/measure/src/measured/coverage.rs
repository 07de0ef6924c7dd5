//! Whether data reach every part of the region's boundary.

use std::collections::HashMap;

use stickslip_fem_core::mesh::{Mesh, Point};
use stickslip_hybrid::data::Field;
use stickslip_hybrid::region::outline::boundary_nodes;

use super::elsewhere::extent;
use super::{Measured, Scope};
use crate::error::{ExperimentError, at};
use crate::region_mesh::meshed;
use stickslip_experiment::{Method, Source};

/// Data nearer than this many of their spacings cover a node.
const SPACINGS: f64 = 3.0;

/// Refuses a state without one of the components or its standard deviation, or that leaves a node of the region's boundary without data
/// near it. Fringe lines along which nodes are interpolated cover what is near a line, and that is asked when the nodes' displacements are
/// made.
pub(super) fn check(scope: &Scope<'_>, measured: &Measured) -> Result<(), ExperimentError> {
    let region = &scope.experiment.region;
    if region.is_some() || !scope.experiment.laws.is_empty() {
        for field in Field::BOTH {
            let data = &measured.measurement;
            if data.count(field) > 0 && data.deviation[field.component()] <= 0.0 {
                return Err(without_deviation(scope, field));
            }
        }
    }
    let Some(region) = region else {
        return Ok(());
    };
    for field in Field::BOTH {
        if measured.measurement.count(field) == 0 {
            return Err(lacking(scope, field));
        }
    }
    if matches!(scope.experiment.reduce.method, Method::Lines { .. }) {
        return Ok(());
    }
    let hole = scope.experiment.specimen.hole;
    let Ok((mesh, _)) = meshed(region, &hole, scope.experiment.host()) else {
        // The hybrid analysis says why there is no such mesh.
        return Ok(());
    };
    for field in Field::BOTH {
        let bare = uncovered(scope, measured, field, &mesh);
        if let Some(&first) = bare.first() {
            let all = boundary_nodes(&mesh).len();
            return Err(ExperimentError::Missing {
                key: "region".to_owned(),
                what: format!(
                    "state '{}': the {} data do not cover the region: {} of {all} nodes of its boundary have none near, the first at {}; \
                     the data are {}",
                    scope.name(),
                    field.name(),
                    bare.len(),
                    at(scope.experiment, first),
                    extent(scope, &measured.measurement)
                ),
                remedy: "check scale, origin and y_axis of the data; or make the region smaller, give it a stand-off, mask less, or \
                         measure there"
                    .to_owned(),
            });
        }
    }
    Ok(())
}

/// A state without any displacement of one component, of which a region needs both.
fn lacking(scope: &Scope<'_>, field: Field) -> ExperimentError {
    let name = field.name();
    ExperimentError::Missing {
        key: scope.key.clone(),
        what: format!(
            "state '{}': there is no valid {name} displacement, and the analysis of a region needs U and V",
            scope.name()
        ),
        remedy: format!(
            "give the {name} field too, or mask less of it; without [region], `stickslip reduce` shows the other field alone"
        ),
    }
}

/// A component whose neighbours agree to the last digit, as of a table that is zero everywhere, with nothing to weigh it by.
fn without_deviation(scope: &Scope<'_>, field: Field) -> ExperimentError {
    let name = field.name();
    let (part, remedy) = match &scope.experiment.states[scope.state].source {
        Source::Table(_) => (
            ".table",
            "state the standard deviation that a measurement has: table = { …, deviation = \"0.5 um\" }",
        ),
        Source::Pictures(_) => (
            ".pictures",
            "none can be stated of pictures: look whether they are photographs; or give displacements as a table with their deviation, \
             for example measured-STATE.csv of `stickslip reduce`",
        ),
        Source::Step(_) => (
            "",
            "give the synthetic pictures noise: [fringes] order_error = 0.25, or camera_noise = 0.01",
        ),
        Source::Lines(_) => (
            ".lines",
            "state the standard deviation of an order: lines = { …, deviation = 0.144 }",
        ),
    };
    ExperimentError::Missing {
        key: format!("{}{part}", scope.key),
        what: format!(
            "state '{}': the {name} data do not scatter at all, as with zeros everywhere, and give no standard deviation to weight them by",
            scope.name()
        ),
        remedy: remedy.to_owned(),
    }
}

fn uncovered(scope: &Scope<'_>, measured: &Measured, field: Field, mesh: &Mesh) -> Vec<Point> {
    let c = field.component();
    let [low, high] = mesh.bounding_box();
    let data = &measured.measurement;
    let inside = |place: &Point| (0..2).all(|axis| (low[axis]..=high[axis]).contains(&place[axis]));
    let valid = (0..data.places.len()).filter(|&k| data.valid[c][k]);
    let places: Vec<Point> = valid.map(|k| data.places[k]).collect();
    let count = places.iter().filter(|place| inside(place)).count().max(1);
    let area = (high[0] - low[0]) * (high[1] - low[1]);
    let resolved = measured.pictures[c]
        .as_ref()
        .map_or(0.0, |own| own.resolution);
    let margin = scope.experiment.reduce.margin.unwrap_or(resolved);
    let reach = SPACINGS * (area / count as f64).sqrt() + margin;
    let cell = |place: Point| [0, 1].map(|axis| (place[axis] / reach).floor() as i64);
    let mut boxes: HashMap<[i64; 2], Vec<Point>> = HashMap::new();
    for place in places {
        boxes.entry(cell(place)).or_default().push(place);
    }
    let near = |node: Point| {
        let [i, j] = cell(node);
        let around = (-1..=1).flat_map(|di| (-1..=1).map(move |dj| [i + di, j + dj]));
        around
            .filter_map(|key| boxes.get(&key))
            .flatten()
            .any(|place| (place[0] - node[0]).hypot(place[1] - node[1]) <= reach)
    };
    let nodes = boundary_nodes(mesh).into_iter();
    let places = nodes.map(|node| mesh.nodes()[node]);
    places.filter(|&node| !near(node)).collect()
}
