//! Tractions and stresses at nodes of an edge, beside those of a finer division.

use stickslip::results::{EdgeGeometry, EdgeResults, RowErrors};

use super::Number;

/// Nodes of each step that are compared.
const NODES: usize = 12;

const NAMES: [&str; 3] = [
    "pressure at a node",
    "friction traction at a node",
    "tangential stress at a node",
];

/// The numbers of some nodes of an edge in the step `step`, `unloading` or not, beside those of `truth`.
pub(super) fn numbers(
    found: (&EdgeGeometry, &EdgeResults),
    truth: (&EdgeGeometry, &EdgeResults),
    (step, unloading): (usize, bool),
) -> Vec<Number> {
    let (geometry, edge) = found;
    let count = edge.row_errors.len();
    let chosen = (0..count).step_by(count.div_ceil(NODES).max(1));
    let numbers = chosen.flat_map(|k| {
        let place = geometry.parameter[k];
        let row = &edge.rows[k];
        let own = [row.pressure, row.shear, row.sigma_tangential];
        let exact = truth.0.values_at(&truth.1.rows, place);
        let [errors, doubt] = [errors(&edge.row_errors[k]), doubt(truth, place)];
        (0..NAMES.len()).map(move |number| Number {
            name: NAMES[number],
            step,
            unloading,
            values: [own[number], exact[number]],
            errors: Some([errors[number], doubt[number]]),
        })
    });
    numbers.collect()
}

/// The larger errors of the nodes on both sides of a place.
fn doubt((geometry, edge): (&EdgeGeometry, &EdgeResults), place: f64) -> [f64; 3] {
    let to = geometry.parameter.partition_point(|own| *own < place);
    let to = to.clamp(1, geometry.parameter.len() - 1);
    let [one, other] = [to - 1, to].map(|k| errors(&edge.row_errors[k]));
    std::array::from_fn(|number| one[number].max(other[number]))
}

fn errors(of: &RowErrors) -> [f64; 3] {
    [of.pressure, of.shear, of.sigma_tangential]
}
