//! Tractions and stresses at nodes of an edge, beside those of a finer division.

use stickslip::results::{EdgeGeometry, EdgeResults, RowErrors};

use super::{At, Number};

/// Nodes of each step that are compared.
const NODES: usize = 12;

const NAMES: [&str; 3] = [
    "pressure at a node",
    "friction traction at a node",
    "tangential stress at a node",
];

/// The numbers of some nodes of an edge in a step beside those of `truth`.
pub(super) fn numbers(
    found: (&EdgeGeometry, &EdgeResults),
    truth: (&EdgeGeometry, &EdgeResults),
    At { step, unloading }: At,
) -> Vec<Number> {
    let (geometry, edge) = found;
    let count = edge.row_errors.len();
    let chosen = (0..count).step_by(count.div_ceil(NODES).max(1));
    let numbers = chosen.filter_map(|k| {
        let place = geometry.parameter[k];
        let row = &edge.rows[k];
        let own = [row.pressure, row.shear, row.sigma_tangential];
        let exact = truth.0.values_at(&truth.1.rows, place);
        let errors = errors(&edge.row_errors[k]);
        let doubt = truth.0.errors_at(&truth.1.row_errors, place)?;
        Some((0..NAMES.len()).map(move |number| Number {
            name: NAMES[number],
            step,
            unloading,
            values: [own[number], exact[number]],
            errors: Some([errors[number], doubt[number]]),
        }))
    });
    numbers.flatten().collect()
}

fn errors(of: &RowErrors) -> [f64; 3] {
    [of.pressure, of.shear, of.sigma_tangential]
}
