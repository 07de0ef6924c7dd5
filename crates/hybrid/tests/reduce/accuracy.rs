//! Polynomials and smooth fields; the same bits for any number of threads.

use super::{Point, all, measured, methods, nodes, polynomial, scattered};
use stickslip_hybrid::reduce::Reduction;

#[test]
fn polynomials_come_back_to_rounding() {
    let places = nodes();
    for (k, order) in [1, 1, 2, 3].into_iter().enumerate() {
        let field = |[x, y]: Point| {
            let s = 1.0 + 2.0 * x - y;
            [s.powi(order), (3.0 - x - 0.5 * y).powi(order)]
        };
        let m = measured(scattered(12, 1), field);
        let found = methods(&m, &places)[k].displacements(&m).unwrap();
        assert_eq!(found.nodes, all(&places));
        for (n, &place) in places.iter().enumerate() {
            for c in 0..2 {
                // Values are at most 27; weights of one sign cannot amplify rounding, others by their sum of sizes, below 10 here.
                assert!(
                    (found.values[2 * n + c] - field(place)[c]).abs() < 1e-12,
                    "method {k}, node {n}"
                );
            }
        }
    }
}

#[test]
fn smooth_fields_converge_at_the_order_of_the_method() {
    let places = nodes();
    let field = |[x, y]: Point| [(3.0 * x + y).sin(), (x - 2.0 * y).exp()];
    let errors: Vec<Vec<f64>> = [24, 48, 96]
        .iter()
        .map(|&n| {
            let m = measured(scattered(n, 2), field);
            methods(&m, &places)
                .iter()
                .map(|reduction| {
                    let values = reduction.displacements(&m).unwrap().values;
                    let square: f64 = values
                        .chunks(2)
                        .zip(&places)
                        .flat_map(|(u, &place)| [0, 1].map(|c| (u[c] - field(place)[c]).powi(2)))
                        .sum();
                    (square / values.len() as f64).sqrt()
                })
                .collect()
        })
        .collect();
    for (k, order) in [2.0, 2.0, 3.0, 4.0].into_iter().enumerate() {
        let slope = (errors[0][k] / errors[2][k]).log2() / 2.0;
        println!(
            "method {k}: errors {:.1e} {:.1e} {:.1e}, slope {slope:.2}",
            errors[0][k], errors[1][k], errors[2][k]
        );
        // Scattered places: the mean over 80 values leaves a scatter of the slope; less than the order by 0.3 is a lost order.
        assert!(slope > order - 0.3, "method {k}: slope {slope}");
    }
}

#[test]
fn extreme_coordinates_are_no_trouble() {
    for scale in [1e-150, 1e-12, 1e12, 1e150] {
        let places: Vec<Point> = scattered(6, 9)
            .iter()
            .map(|place| place.map(|x| scale * x))
            .collect();
        let m = measured(places, |[x, y]| [x / scale, y / scale]);
        let node = [[0.45 * scale, 0.55 * scale], [1e300, 0.0]];
        for reduction in [
            Reduction::linear(&m, &node, &[0, 1], Some(f64::INFINITY)).unwrap(),
            Reduction::polynomial(&m, &node, &[0, 1], &polynomial(2)).unwrap(),
        ] {
            assert_eq!(reduction.nodes(), [0]);
            assert!((reduction.displacements(&m).unwrap().values[1] - 0.55).abs() < 1e-12);
        }
    }
}

#[test]
fn same_data_same_bits_for_any_number_of_threads() {
    let m = measured(scattered(20, 8), |[x, y]| [x * y, y.sin()]);
    let reduce = |threads| {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .unwrap();
        pool.install(|| {
            Reduction::polynomial(&m, &nodes(), &all(&nodes()), &polynomial(3)).unwrap()
        })
    };
    assert_eq!(reduce(1), reduce(3));
}
