//! Places the data do not cover, masks, and bad settings.

use proptest::prelude::*;
use stickslip_hybrid::data::{Field, Measurement};
use stickslip_hybrid::reduce::{LocalPolynomial, Reason, ReduceError, Reduction};

use super::{Point, all, measured, methods, nodes, polynomial, ring, scattered};

#[test]
fn nodes_without_data_are_named_with_their_place() {
    // A plate with a hole of radius 0.3, into which triangles would reach from all sides.
    let grid: Vec<Point> = (0..=20)
        .flat_map(|i| (0..=20).map(move |j| [f64::from(i) / 20.0, f64::from(j) / 20.0]))
        .filter(|[x, y]| (x - 0.5).hypot(y - 0.5) > 0.3)
        .collect();
    let m = measured(grid, |[x, y]| [x, y]);
    let places = vec![
        [0.5, 0.5],
        [0.1, 0.1],
        [1.2, 0.5],
        [0.5, 0.15],
        [1.0, 0.333],
    ];
    let wanted = all(&places);
    let linear = Reduction::linear(&m, &places, &wanted, Some(0.15)).unwrap();
    assert_eq!(linear.nodes(), [1, 3, 4]);
    assert!(matches!(linear.uncovered()[0].reason, Reason::Gap { .. }));
    assert_eq!(linear.uncovered()[1].reason, Reason::Outside);
    let words = linear.complete().unwrap_err().to_string();
    for part in [
        "2 of 5 nodes",
        "node 0 at (0.5, 0.5), U: in a gap",
        "node 2 at (1.2, 0.5), U: outside the data",
    ] {
        assert!(words.contains(part), "{part}: {words}");
    }

    let fit = LocalPolynomial {
        largest_radius: 0.2,
        ..polynomial(2)
    };
    let local = Reduction::polynomial(&m, &places, &wanted, &fit).unwrap();
    assert_eq!(local.nodes(), [1, 3, 4]);
    assert!(matches!(
        local.uncovered()[0].reason,
        Reason::Sparse { neighbours: 12, .. }
    ));
    let near_edge = vec![[1.02, 0.5]];
    let local = Reduction::polynomial(&m, &near_edge, &[0], &fit).unwrap();
    assert!(matches!(
        local.uncovered()[0].reason,
        Reason::OneSided { .. }
    ));
    let beyond = LocalPolynomial {
        extrapolate: true,
        ..fit
    };
    let found = Reduction::polynomial(&m, &near_edge, &[0], &beyond)
        .unwrap()
        .displacements(&m)
        .unwrap();
    assert!((found.values[0] - 1.02).abs() < 1e-12);

    let lines = [
        ring(20, 2.0, |_| 0.0, 1, Field::U),
        ring(20, 2.0, |_| 0.0, 1, Field::V),
    ];
    let reduction = Reduction::along_lines(
        [&lines[0], &lines[1]],
        &[[2.0, 0.0], [2.5, 0.0]],
        &[0, 1],
        0.01,
    )
    .unwrap();
    assert!(matches!(
        reduction.uncovered()[0].reason,
        Reason::OffLines { .. }
    ));
    let swapped = Reduction::along_lines([&lines[1], &lines[0]], &[[2.0, 0.0]], &[0], 0.01);
    assert!(matches!(swapped, Err(ReduceError::Field { .. })));
}

#[test]
fn masked_places_take_no_part() {
    let field = |[x, y]: Point| [x + 2.0 * y, x - y];
    let mut m = measured(scattered(12, 6), field);
    let full = methods(&m, &nodes());
    m.mask(Field::U, |k| k % 3 == 0);
    m.mask(Field::V, |k| k % 4 == 0);
    for reduction in methods(&m, &nodes()) {
        for k in 0..nodes().len() {
            for field in Field::BOTH {
                let mut stencil = reduction.stencil(k, field).unwrap().iter();
                assert!(stencil.all(|&(index, _)| m.valid[field.component()][index]));
            }
        }
        let values = reduction.displacements(&m).unwrap().values;
        assert!(
            values
                .iter()
                .enumerate()
                .all(|(i, u)| (u - field(nodes()[i / 2])[i % 2]).abs() < 1e-12)
        );
    }
    // A reduction made for other data says what is missing.
    assert!(matches!(
        full[0].displacements(&m),
        Err(ReduceError::Masked { .. })
    ));
    let fewer = measured(scattered(3, 1), field);
    assert!(matches!(
        full[0].displacements(&fewer),
        Err(ReduceError::Size {
            found: 16,
            needed: 169,
            ..
        })
    ));
}

#[test]
fn bad_settings_and_data_are_refused() {
    let good = measured(scattered(4, 1), |_| [0.0; 2]);
    let place = [[0.5, 0.5]];
    assert!(matches!(
        Reduction::linear(&good, &place, &[1], Some(1.0)),
        Err(ReduceError::NoSuchNode { node: 1, count: 1 })
    ));
    assert!(matches!(
        Reduction::linear(&good, &[[f64::NAN, 0.0]], &[0], Some(1.0)),
        Err(ReduceError::NotFinite { .. })
    ));
    assert!(matches!(
        Reduction::linear(&good, &place, &[0], Some(f64::NAN)),
        Err(ReduceError::Setting { .. })
    ));
    let row = measured(vec![[0.0, 0.0], [1.0, 1.0], [2.0, 2.0]], |_| [0.0; 2]);
    let twice = measured(vec![[0.0, 0.0], [1.0, 1.0], [1.0, 1.0], [0.0, 1.0]], |_| {
        [0.0; 2]
    });
    for (m, words) in [
        (&row, "all 3 places lie on one line"),
        (&twice, "only 3 of 4 places are distinct"),
    ] {
        let error = Reduction::linear(m, &place, &[0], Some(1.0)).unwrap_err();
        assert!(error.to_string().ends_with(words), "{error}");
    }
    let fit = |order, neighbours| LocalPolynomial {
        neighbours,
        ..LocalPolynomial {
            order,
            ..polynomial(1)
        }
    };
    let error = |m: &Measurement, fit| Reduction::polynomial(m, &place, &[0], &fit).unwrap_err();
    assert_eq!(error(&good, fit(4, 20)), ReduceError::Order(4));
    assert!(matches!(
        error(&good, fit(2, 5)),
        ReduceError::Neighbours { needed: 6, .. }
    ));
    assert!(matches!(
        error(&good, fit(1, 26)),
        ReduceError::TooFew { valid: 25, .. }
    ));
    let line = Reduction::polynomial(&row, &[[1.0, 1.0]], &[0], &fit(1, 3)).unwrap();
    assert_eq!(line.uncovered()[0].reason, Reason::Degenerate);
    let mut broken = good.clone();
    broken.valid[1].pop();
    assert!(matches!(
        Reduction::linear(&broken, &place, &[0], Some(1.0)),
        Err(ReduceError::Data(_))
    ));
    let mut infinite = good;
    infinite.displacements[0][3] = f64::INFINITY;
    assert!(matches!(
        Reduction::linear(&infinite, &place, &[0], Some(1.0)),
        Err(ReduceError::Data(_))
    ));
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn no_places_panic(
        data in proptest::collection::vec((any::<f64>(), any::<f64>(), any::<bool>(), any::<bool>()), 0..14),
        coarse in proptest::collection::vec((0..4_u8, 0..4_u8), 0..14),
        node in (any::<f64>(), -1.0..5.0_f64),
    ) {
        let wild: Vec<Point> = data.iter().map(|&(x, y, ..)| [x, y]).collect();
        let small: Vec<Point> = coarse.iter().map(|&(x, y)| [f64::from(x), f64::from(y)]).collect();
        let nodes = [[node.0, node.1], [node.1, node.1], [1.0, 2.0]];
        for places in [wild, small] {
            let mut m = measured(places, |_| [1.0, 2.0]);
            m.mask(Field::U, |k| data.get(k).is_some_and(|entry| !entry.2));
            m.mask(Field::V, |k| data.get(k).is_some_and(|entry| !entry.3));
            let fit = LocalPolynomial { neighbours: 4, extrapolate: true, ..polynomial(1) };
            for reduction in [
                Reduction::linear(&m, &nodes, &[0, 1, 2], Some(f64::INFINITY)),
                Reduction::polynomial(&m, &nodes, &[0, 1, 2], &fit),
            ].into_iter().flatten() {
                let found = reduction.displacements(&m).unwrap();
                // A constant comes back: the weights of every node sum to 1, whatever the places.
                for pair in found.values.chunks(2) {
                    prop_assert!((pair[0] - 1.0).abs() < 1e-6 && (pair[1] - 2.0).abs() < 1e-6, "{pair:?}");
                }
            }
        }
    }
}
