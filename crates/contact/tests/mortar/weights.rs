//! What holds of the weights for any two divisions.

use std::f64::consts::{PI, TAU};

use proptest::prelude::*;
use stickslip_contact::mortar::Projected;
use stickslip_contact::{EdgeSide, InitialGap, Multipliers, Projection, Stencil, mortar};

use crate::{BOTH, resultant};

/// Sums of at most some hundred products of numbers of order one, through 3 × 3 inverses of condition below 10³.
const ROUNDING: f64 = 1e-12;

/// A chain from `start` whose edges have the lengths `steps`.
fn chain(start: f64, steps: &[f64], order: usize) -> EdgeSide {
    let mut parameter = vec![start];
    for step in steps {
        let at = parameter[parameter.len() - 1];
        if order == 2 {
            parameter.push(at + 0.5 * step);
        }
        parameter.push(at + step);
    }
    EdgeSide::open((0..parameter.len()).collect(), parameter, order).unwrap()
}

fn flat(multipliers: Multipliers, gap: InitialGap<'_>) -> Projection<'_> {
    Projection {
        multipliers,
        length: 2.0,
        thickness: 0.5,
        normal: &|_| [0.6, 0.8],
        gap,
        material_angle: 0.1,
        symmetry: [false; 2],
    }
}

/// Σ w f(node) of a stencil's normal weights.
fn mean(stencil: &Stencil, value: impl Fn(usize) -> f64) -> f64 {
    let terms = stencil.terms().iter();
    terms
        .map(|term| term.weights[0][0] * value(term.node))
        .sum()
}

fn edges() -> impl Strategy<Value = Vec<f64>> {
    prop::collection::vec(0.1..1.0_f64, 1..7)
}

proptest! {
    #[test]
    fn constants_and_linear_fields_are_reproduced(
        one in edges(), two in edges(), shift in -0.9..0.9_f64, orders in (1..=2_usize, 1..=2_usize),
    ) {
        let (first, second) = (chain(0.0, &one, orders.0), chain(shift, &two, orders.1));
        let end = |side: &EdgeSide| side.parameter()[side.parameter().len() - 1];
        let overlap = end(&first).min(end(&second)) - shift.max(0.0);
        prop_assume!(overlap > 0.01);
        for multipliers in BOTH {
            let gap = |at: f64| 3.0 - 2.0 * at;
            let made = mortar::project(&first, &second, &flat(multipliers, InitialGap::Exact(&gap))).unwrap();
            for point in &made.points {
                prop_assert!(point.area > 0.0);
                let dual = multipliers == Multipliers::Dual;
                // Dual functions of a sliver of an edge are large; a double then keeps its digits less the sliver's.
                let rounding = if dual { 1e-8 } else { ROUNDING };
                for side in [(&point.first, &first), (&point.second, &second)] {
                    prop_assert!((mean(side.0, |_| 1.0) - 1.0).abs() < rounding);
                }
                let [a, b] = [(&point.first, &first), (&point.second, &second)]
                    .map(|(stencil, side)| mean(stencil, |node| side.parameter()[node]));
                prop_assert!((a - b).abs() < rounding, "{a} {b}");
                prop_assert!((point.gap - gap(a)).abs() < 2.0 * rounding);
            }
            let area: f64 = made.points.iter().map(|point| point.area).sum();
            prop_assert!((area - overlap).abs() < ROUNDING, "2 · 0.5 · {overlap} is not {area}");
        }
    }
}

#[test]
fn dual_points_of_equal_straight_edges_are_pairs_of_nodes() {
    for order in [1, 2] {
        let side = chain(0.2, &[0.5, 0.3, 0.9, 0.4], order);
        let made = mortar::project(
            &side,
            &side,
            &flat(Multipliers::Dual, InitialGap::Exact(&|_| 0.25)),
        )
        .unwrap();
        for (point, &node) in made.points.iter().zip(&made.nodes) {
            for stencil in [&point.first, &point.second] {
                let [term] = stencil.terms() else {
                    panic!("{stencil:?}")
                };
                assert_eq!(term.node, node);
                for (i, row) in term.weights.iter().enumerate() {
                    for (j, weight) in row.iter().enumerate() {
                        assert!((weight - f64::from(u8::from(i == j))).abs() < ROUNDING);
                    }
                }
            }
            assert!((point.gap - 0.25).abs() < ROUNDING);
        }
    }
}

#[test]
fn areas_of_whole_edges_are_the_consistent_weights() {
    for multipliers in BOTH {
        let (first, second) = (chain(0.0, &[0.6, 0.3], 2), chain(0.0, &[0.1, 0.5, 0.3], 1));
        let made = mortar::project(
            &first,
            &second,
            &flat(multipliers, InitialGap::Exact(&|_| 0.0)),
        )
        .unwrap();
        let expected = [0.1, 0.4, 0.15, 0.2, 0.05];
        for (point, area) in made.points.iter().zip(expected) {
            assert!(
                (point.area - area).abs() < ROUNDING,
                "{} {area}",
                point.area
            );
        }
    }
}

#[test]
fn nodes_that_face_nothing_get_no_point() {
    let first = chain(0.0, &[1.0; 6], 1);
    let second = chain(2.0, &[0.7, 0.8], 1);
    let made = mortar::project(
        &first,
        &second,
        &flat(Multipliers::Standard, InitialGap::Exact(&|_| 0.0)),
    )
    .unwrap();
    assert_eq!(made.nodes, [2, 3, 4]);
}

fn circle(count: usize, order: usize, start: f64) -> EdgeSide {
    let nodes = count * order;
    let parameter = (0..nodes)
        .map(|k| start + TAU * k as f64 / nodes as f64)
        .collect();
    EdgeSide::closed((0..nodes).collect(), parameter, order, TAU).unwrap()
}

fn places(side: &EdgeSide, radius: f64) -> Vec<[f64; 2]> {
    let place = |angle: &f64| [radius * angle.cos(), radius * angle.sin()];
    side.parameter().iter().map(place).collect()
}

fn radial(multipliers: Multipliers, gap: InitialGap<'_>) -> Projection<'_> {
    Projection {
        multipliers,
        length: 1.5,
        thickness: 1.0,
        normal: &|angle| [angle.cos(), angle.sin()],
        gap,
        material_angle: 0.0,
        symmetry: [false; 2],
    }
}

/// Forces on both sides of a circle under p = 1 + cos 2θ and q = 1 + sin θ.
fn forces_on_circles(made: &Projected, sides: [&EdgeSide; 2]) -> [Vec<f64>; 2] {
    let mut forces = sides.map(|side| vec![0.0; 2 * side.nodes().len()]);
    for (point, &node) in made.points.iter().zip(&made.nodes) {
        let at = sides[0].parameter()[node];
        let traction = [1.0 + (2.0 * at).cos(), 1.0 + at.sin()].map(|value| value * point.area);
        let [nx, ny] = point.normal;
        for (sum, (stencil, sign)) in forces
            .iter_mut()
            .zip([(&point.first, 1.0), (&point.second, -1.0)])
        {
            for term in stencil.terms() {
                let in_frame: [f64; 2] = std::array::from_fn(|j| {
                    (0..2)
                        .map(|i| sign * traction[i] * term.weights[i][j])
                        .sum()
                });
                sum[2 * term.node] += in_frame[0] * nx - in_frame[1] * ny;
                sum[2 * term.node + 1] += in_frame[0] * ny + in_frame[1] * nx;
            }
        }
    }
    forces
}

/// Forces balance exactly; moments to the distance of the facets, which falls with the square of the spacing (order 1) or
/// its fourth power (order 2).
#[test]
fn both_sides_of_a_circle_get_equal_and_opposite_forces() {
    for multipliers in BOTH {
        for order in [1, 2] {
            let moment = |count: usize| {
                let (first, second) =
                    (circle(3 * count, order, 0.0), circle(2 * count, order, 0.1));
                let gap = InitialGap::Exact(&|_| 0.0);
                let made = mortar::project(&first, &second, &radial(multipliers, gap)).unwrap();
                assert_eq!(made.points.len(), first.nodes().len());
                let [on_first, on_second] = forces_on_circles(&made, [&first, &second]);
                let a = resultant(&places(&first, 1.5), &on_first);
                let b = resultant(&places(&second, 1.5), &on_second);
                for i in 0..2 {
                    assert!((a[i] + b[i]).abs() < 30.0 * ROUNDING, "{a:?} {b:?}");
                }
                (a[2] + b[2]).abs() / a[2]
            };
            let (coarse, fine) = (moment(8), moment(16));
            let rate = (coarse / fine).log2();
            let expected = 2.0 * order as f64;
            assert!(
                rate > expected - 0.2,
                "{multipliers:?}, order {order}: {coarse:.2e} {fine:.2e}, rate {rate}"
            );
        }
    }
}

/// A translation of either body moves every point by the mean of its component along the turning normal.
#[test]
fn translations_of_a_circle_are_seen_alike_from_both_sides() {
    for multipliers in BOTH {
        let (first, second) = (circle(20, 2, 0.0), circle(13, 1, -0.3));
        let made = mortar::project(
            &first,
            &second,
            &radial(multipliers, InitialGap::Exact(&f64::cos)),
        )
        .unwrap();
        for point in &made.points {
            let [nx, ny] = point.normal;
            let along = |stencil: &Stencil| -> f64 {
                stencil
                    .terms()
                    .iter()
                    .map(|term| term.weights[0][0] * nx - term.weights[0][1] * ny)
                    .sum()
            };
            assert!((along(&point.first) - along(&point.second)).abs() < ROUNDING);
            assert!((along(&point.first) - point.gap).abs() < ROUNDING);
        }
    }
}

/// The half circle with its lines of symmetry against the whole one, under displacements symmetric about y = 0.
#[test]
fn half_a_circle_is_as_the_whole_one() {
    let half = |count: usize, order: usize| {
        let nodes = count * order + 1;
        let parameter = (0..nodes)
            .map(|k| PI * k as f64 / (nodes - 1) as f64)
            .collect();
        EdgeSide::open((0..nodes).collect(), parameter, order).unwrap()
    };
    // u_x even and u_y odd in θ, and in no way linear.
    let field = |at: f64, second: bool| {
        let stretch = if second { 0.3 } else { 1.0 };
        [
            stretch * (3.0 * at).cos() + at.cos(),
            (2.0 * at).sin() - stretch * at.sin(),
        ]
    };
    let motion = |made: &Projected, k: usize, sides: [&EdgeSide; 2]| -> [f64; 2] {
        let point = &made.points[k];
        let [nx, ny] = point.normal;
        let mut sum = [0.0; 2];
        for (stencil, second, sign) in [(&point.first, false, 1.0), (&point.second, true, -1.0)] {
            for term in stencil.terms() {
                let [ux, uy] = field(sides[usize::from(second)].parameter()[term.node], second);
                let u = [nx * ux + ny * uy, nx * uy - ny * ux];
                for (i, row) in term.weights.iter().enumerate() {
                    sum[i] += sign * (row[0] * u[0] + row[1] * u[1]);
                }
            }
        }
        sum
    };
    for (order, multipliers) in [1, 2]
        .into_iter()
        .flat_map(|order| BOTH.map(|m| (order, m)))
    {
        let gap = |at: f64| 1.0 - at.cos();
        let whole = [circle(18, order, 0.0), circle(14, order, 0.0)];
        let part = [half(9, order), half(7, order)];
        let exact = radial(multipliers, InitialGap::Exact(&gap));
        let symmetric = Projection {
            symmetry: [true; 2],
            ..exact
        };
        let all = mortar::project(&whole[0], &whole[1], &exact).unwrap();
        let cut = mortar::project(&part[0], &part[1], &symmetric).unwrap();
        let last = cut.points.len() - 1;
        for k in 0..=last {
            let (a, b) = (
                motion(&all, k, [&whole[0], &whole[1]]),
                motion(&cut, k, [&part[0], &part[1]]),
            );
            assert!(
                (0..2).all(|i| (a[i] - b[i]).abs() < ROUNDING),
                "{k}: {a:?} {b:?}"
            );
            assert!((all.points[k].gap - cut.points[k].gap).abs() < ROUNDING);
            let share = if k == 0 || k == last { 2.0 } else { 1.0 };
            assert!((all.points[k].area - share * cut.points[k].area).abs() < ROUNDING);
        }
        for end in [0, last] {
            let terms = cut.points[end].second.terms();
            assert!(terms.iter().all(|term| term.weights[1] == [0.0; 2]));
        }
    }
}
