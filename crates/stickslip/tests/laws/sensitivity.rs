//! How far the edge moves when friction changes.

use stickslip::experiment::laws::sensitivity;

use crate::common::{FREQUENCY, aluminium, candidate};

#[test]
fn the_static_coefficient_hardly_moves_the_edge_and_both_together_do() {
    let model = aluminium(2.25);
    let law = candidate(
        "drop",
        r#"{ "static_dynamic": { "static": 0.35, "dynamic": 0.25 } }"#,
        &[("static", [0.0, 1.0]), ("dynamic", [0.0, 1.0])],
    );
    let changes = [vec![0.30, 0.25], vec![0.37, 0.27], vec![0.35, 0.27]];
    let found = sensitivity(&model, &law, &[0.35, 0.25], &changes, FREQUENCY).unwrap();
    for own in &found {
        println!(
            "{:?}: {:.3?} deformation {:.3?}",
            own.values, own.whole, own.deformation
        );
    }
}
