//! Edges that are refused.

use std::f64::consts::TAU;

use stickslip_contact::{EdgeSide, InitialGap, MortarError, Multipliers, Projection, mortar};

#[test]
fn malformed_edges_are_refused() {
    let open = |parameter: &[f64], order| {
        EdgeSide::open((0..parameter.len()).collect(), parameter.to_vec(), order).unwrap_err()
    };
    assert_eq!(open(&[0.0, 1.0], 9), MortarError::Order(9));
    assert_eq!(open(&[0.0, 1.0], 0), MortarError::Order(0));
    let folded = open(&[0.0, 0.8, 0.9, 1.0], 3);
    assert_eq!(folded, MortarError::Folded { edge: 0 });
    assert_eq!(
        open(&[0.0, 1.0], 2),
        MortarError::Nodes { nodes: 2, order: 2 }
    );
    assert_eq!(open(&[], 1), MortarError::Nodes { nodes: 0, order: 1 });
    assert_eq!(open(&[0.0], 1), MortarError::Nodes { nodes: 1, order: 1 });
    let backwards = MortarError::NotAscending {
        node: 1,
        from: 1.0,
        to: 0.5,
    };
    assert_eq!(open(&[0.0, 1.0, 0.5], 1), backwards);
    assert!(matches!(
        open(&[0.0, f64::NAN], 1),
        MortarError::NotAscending { node: 0, .. }
    ));
    assert!(matches!(
        open(&[0.0, f64::INFINITY], 1),
        MortarError::NotAscending { node: 0, .. }
    ));
    let folded = MortarError::MidSide {
        node: 1,
        fraction: 0.2,
    };
    assert_eq!(open(&[0.0, 0.2, 1.0], 2), folded);
    let short = EdgeSide::open(vec![0, 1], vec![0.0], 1).unwrap_err();
    assert_eq!(
        short,
        MortarError::Parameters {
            parameters: 1,
            nodes: 2
        }
    );
    let round = EdgeSide::closed(vec![0, 1, 2], vec![0.0, 3.0, TAU], 1, TAU).unwrap_err();
    assert_eq!(
        round,
        MortarError::Period {
            span: TAU,
            period: TAU
        }
    );
}

#[test]
fn edges_that_cannot_be_projected_are_refused() {
    let line = |from: f64| EdgeSide::open(vec![0, 1], vec![from, from + 1.0], 1).unwrap();
    let projection = Projection {
        multipliers: Multipliers::Dual,
        length: 1.0,
        thickness: 1.0,
        normal: &|_| [0.0, 1.0],
        gap: InitialGap::Exact(&|_| 0.0),
        material_angle: 0.0,
        symmetry: [false; 2],
    };
    let refusal =
        |first, second, projection| mortar::project(&first, &second, &projection).unwrap_err();
    assert_eq!(
        refusal(line(0.0), line(1.0), projection),
        MortarError::NoOverlap
    );
    let thin = Projection {
        thickness: -1.0,
        ..projection
    };
    assert_eq!(
        refusal(line(0.0), line(0.5), thin),
        MortarError::NotPositive {
            what: "thickness",
            value: -1.0
        }
    );
    let places = [[0.0, 0.0]];
    let faceted = Projection {
        gap: InitialGap::Faceted(&places, &places),
        ..projection
    };
    assert_eq!(
        refusal(line(0.0), line(0.5), faceted),
        MortarError::NoPosition { node: 1, count: 1 }
    );
    let closed = EdgeSide::closed(vec![0, 1], vec![0.0, 0.5], 1, 1.0).unwrap();
    let long = EdgeSide::open(vec![0, 1], vec![0.0, 1.5], 1).unwrap();
    assert_eq!(
        refusal(closed, long, projection),
        MortarError::Period {
            span: 1.5,
            period: 1.0
        }
    );
}

/// Facets of 4 and 8 chords about one circle: at a common node they touch, under a facet's middle they part by its sagitta.
#[test]
fn a_faceted_gap_is_the_mean_distance_of_the_meshes() {
    let ring = |count: u32| {
        let angles: Vec<f64> = (0..count)
            .map(|k| TAU * f64::from(k) / f64::from(count))
            .collect();
        let places: Vec<[f64; 2]> = angles.iter().map(|a| [a.cos(), a.sin()]).collect();
        let side = EdgeSide::closed((0..angles.len()).collect(), angles, 1, TAU).unwrap();
        (side, places)
    };
    let ((outer, far), (inner, near)) = (ring(8), ring(4));
    let projection = Projection {
        multipliers: Multipliers::Standard,
        length: 1.0,
        thickness: 1.0,
        normal: &|at| [at.cos(), at.sin()],
        gap: InitialGap::Faceted(&far, &near),
        material_angle: 0.0,
        symmetry: [false; 2],
    };
    let made = mortar::project(&outer, &inner, &projection).unwrap();
    // Between θ = 0 and π/4, t = 4θ/π, distance along e_r of the two interpolated curves.
    let distance = |t: f64| {
        let angle = t * TAU / 8.0;
        let on_outer = [1.0 - t + t * (TAU / 8.0).cos(), t * (TAU / 8.0).sin()];
        let on_inner = [1.0 - t / 2.0, t / 2.0];
        (on_outer[0] - on_inner[0]) * angle.cos() + (on_outer[1] - on_inner[1]) * angle.sin()
    };
    let steps = 4000;
    let means = (0..steps).fold([0.0; 2], |[at_node, at_middle], k| {
        let t = (f64::from(k) + 0.5) / f64::from(steps);
        let part = 2.0 * distance(t) / f64::from(steps);
        [at_node + (1.0 - t) * part, at_middle + t * part]
    });
    for (k, point) in made.points.iter().enumerate() {
        // The midpoint rule with 4000 steps is good to some 1e-8.
        assert!(
            (point.gap - means[k % 2]).abs() < 1e-7,
            "{k}: {} {means:?}",
            point.gap
        );
    }
}
