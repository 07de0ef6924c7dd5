//! How far the edge moves when friction changes.

use stickslip::experiment::laws::sensitivity;

use crate::common::{FREQUENCY, aluminium, candidate};

#[test]
fn the_static_coefficient_hardly_moves_the_edge_and_both_together_do() {
    let model = aluminium(1.125);
    let law = candidate(
        "drop",
        r#"{ "static_dynamic": { "static": 0.35, "dynamic": 0.25 } }"#,
        &[("static", [0.0, 1.0]), ("dynamic", [0.0, 1.0])],
    );
    let changes = [vec![0.30, 0.25], vec![0.37, 0.27]];
    let found = sensitivity(&model, &law, &[0.35, 0.25], &changes, FREQUENCY).unwrap();
    for own in &found {
        println!(
            "{:?}: {:.3?}, deformation {:.3?}",
            own.values, own.whole, own.deformation
        );
    }
    let largest = |values: &[f64]| values.iter().copied().fold(0.0, f64::max);
    // A tenth of a fringe at some loads, nothing at others.
    assert!(largest(&found[0].whole) < 0.15);
    assert!(
        found[0]
            .whole
            .iter()
            .filter(|change| **change < 0.01)
            .count()
            >= 6
    );
    // Both up by 0.02: more than a fringe of deformation at the largest loads.
    assert!((1.0..1.5).contains(&largest(&found[1].deformation)));
}
