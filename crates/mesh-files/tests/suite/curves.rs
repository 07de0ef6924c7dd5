//! Lines and circles recognised in chains of nodes.

use std::f64::consts::TAU;

use proptest::prelude::*;
use stickslip_fem_core::mesh::{Curve, Point};
use stickslip_mesh_files::{Recognised, nearly_circle, recognise};

fn on_circle(centre: Point, radius: f64, angles: impl Iterator<Item = f64>) -> Vec<Point> {
    angles
        .map(|a| [centre[0] + radius * a.cos(), centre[1] + radius * a.sin()])
        .collect()
}

/// `count` points of an arc, its ends among them.
fn arc(centre: Point, radius: f64, from: f64, turn: f64, count: usize) -> Vec<Point> {
    let step = turn / (count - 1) as f64;
    on_circle(centre, radius, (0..count).map(|k| from + step * k as f64))
}

fn found(points: &[Point], closed: bool, order: usize) -> Option<Recognised> {
    let walk: Vec<usize> = (0..points.len()).collect();
    recognise(points, &walk, closed, order)
}

fn assert_circle(found: Option<Recognised>, centre: Point, radius: f64, tolerance: f64) {
    let Some(Recognised {
        curve: Curve::Arc {
            centre: c,
            radius: r,
        },
        ..
    }) = found
    else {
        panic!("{found:?} is no circle");
    };
    let off = (c[0] - centre[0])
        .hypot(c[1] - centre[1])
        .max((r - radius).abs());
    assert!(off <= tolerance * radius, "{off}");
}

/// Puts the middles of chords between the points.
fn with_middles(corners: &[Point], closed: bool) -> Vec<Point> {
    let mut points = Vec::new();
    for (k, &a) in corners.iter().enumerate() {
        points.push(a);
        if closed || k + 1 < corners.len() {
            let b = corners[(k + 1) % corners.len()];
            points.push([0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])]);
        }
    }
    points
}

/// Corners of squares and hexagons lie on circles that nobody means; those of octagons may be off theirs by a twentieth.
#[test]
fn declared_circles_have_eight_corners_near_them() {
    let polygon = |corners: i32, off: f64| {
        let points = (0..corners).map(|k| {
            let angle = TAU * f64::from(k) / f64::from(corners);
            let radius = if k % 2 == 0 {
                2.0 + 2.0 * off
            } else {
                2.0 - 2.0 * off
            };
            [1.0 + radius * angle.cos(), radius * angle.sin()]
        });
        nearly_circle(&points.collect::<Vec<_>>())
    };
    assert_eq!(polygon(4, 0.0), None);
    assert_eq!(polygon(6, 0.0), None);
    assert_circle(polygon(8, 0.0), [1.0, 0.0], 2.0, 1e-12);
    assert_circle(polygon(8, 0.049), [1.0, 0.0], 2.0, 1e-12);
    assert_eq!(polygon(8, 0.051), None);
}

#[test]
fn circles_of_any_number_of_nodes() {
    for count in [8, 9, 10, 17, 64, 1000] {
        let angles = (0..count).map(|k| -TAU * f64::from(k) / f64::from(count));
        let points = on_circle([3.0, -2.0], 0.5, angles);
        // Rounding of coordinates of size 3.
        assert_circle(found(&points, true, 1), [3.0, -2.0], 0.5, 1e-14);
        assert_circle(
            found(&with_middles(&points, true), true, 2),
            [3.0, -2.0],
            0.5,
            1e-14,
        );
        if count % 2 == 0 {
            assert_circle(found(&points, true, 2), [3.0, -2.0], 0.5, 1e-14);
        }
    }
}

#[test]
fn short_arcs() {
    for degrees in [1.1_f64, 5.0, 30.0, 180.0, 270.0] {
        let turn = degrees.to_radians();
        let points = arc([0.0, 0.0], 10.0, 0.3, turn, 9);
        // Rounding ε of places moves the centre by about ε / turn².
        let tolerance = 1e-14 + 1e-14 / turn.powi(2);
        assert_circle(found(&points, false, 1), [0.0, 0.0], 10.0, tolerance);
        assert_circle(found(&points, false, 2), [0.0, 0.0], 10.0, tolerance);
    }
    assert_eq!(
        found(
            &arc([0.0, 0.0], 10.0, 0.3, 0.5_f64.to_radians(), 9),
            false,
            1
        ),
        None
    );
    assert_eq!(found(&arc([0.0, 0.0], 10.0, 0.3, 1.0, 3), false, 1), None);
}

#[test]
fn lines_and_what_is_neither() {
    let line: Vec<Point> = (0..7)
        .map(|k| [0.1 * f64::from(k), 3.0 - 0.2 * f64::from(k)])
        .collect();
    let curve = |points: &[Point], order| found(points, false, order).map(|found| found.curve);
    assert_eq!(curve(&line, 1), Some(Curve::Line));
    assert_eq!(curve(&line, 2), Some(Curve::Line));
    assert_eq!(curve(&line[..2], 1), Some(Curve::Line));
    let mut bent = line.clone();
    bent[3][0] += 1e-4;
    assert_eq!(curve(&bent, 1), None);
    // A mid node off the line makes its edge no exact one.
    let mut bulged = line.clone();
    bulged[3][0] += 1e-4;
    assert_eq!(curve(&bulged, 2), None);

    for aspect in [1.001, 1.1, 2.0] {
        let ellipse = on_circle([0.0, 0.0], 1.0, (0..40).map(|k| TAU * f64::from(k) / 40.0));
        let ellipse: Vec<Point> = ellipse.iter().map(|p| [aspect * p[0], p[1]]).collect();
        assert_eq!(found(&ellipse, true, 1), None, "{aspect}");
    }
    let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    assert_eq!(found(&square, true, 1), None);
    assert_eq!(found(&with_middles(&square, true), true, 2), None);
    // Points of a circle in no order around it.
    let angles = [0.0, 1.0, 0.5, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 5.7];
    assert_eq!(
        found(&on_circle([0.0; 2], 1.0, angles.into_iter()), true, 1),
        None
    );
}

#[test]
fn mid_nodes_must_be_on_chord_or_circle() {
    let corners = on_circle([0.0; 2], 1.0, (0..16).map(|k| TAU * f64::from(k) / 16.0));
    let mut points = with_middles(&corners, true);
    points[5] = points[5].map(|x| 1.005 * x);
    assert_eq!(found(&points, true, 2), None);
}

#[test]
fn input_that_fits_no_chain_is_nothing() {
    let points = [[0.0, 0.0], [1.0, 0.0]];
    assert_eq!(recognise(&points, &[0, 7], false, 1), None);
    assert_eq!(recognise(&points, &[], false, 1), None);
    assert_eq!(recognise(&points, &[], true, 1), None);
    assert_eq!(recognise(&points, &[0, 1], false, 0), None);
    assert_eq!(recognise(&points, &[0, 1], false, 2), None);
    assert_eq!(recognise(&points, &[0, 0, 0], true, 1), None);
    assert_eq!(
        recognise(&[[f64::NAN, 0.0], [1.0, 0.0]], &[0, 1], false, 1),
        None
    );
    assert_eq!(
        recognise(
            &[[1e308, 0.0], [-1e308, 0.0], [0.0, 1e308]],
            &[0, 1, 2],
            true,
            1
        ),
        None
    );
}

proptest! {
    #[test]
    fn noise_up_to_the_tolerance_is_borne(
        noise in prop::collection::vec(-1.0..1.0_f64, 48),
        size in prop::sample::select(vec![1e-6, 1e-4]),
        scale in 1e-3..1e3_f64,
    ) {
        let angles = (0..48).map(|k| TAU * f64::from(k) / 48.0);
        let rim = on_circle([5.0 * scale, 0.0], scale, angles.clone());
        let points: Vec<Point> = rim.iter().zip(angles).zip(&noise).map(|((p, a), noise)| {
            let off = size * scale * noise;
            [p[0] + off * a.cos(), p[1] + off * a.sin()]
        }).collect();
        let spread = noise.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        if size < 1e-5 {
            assert_circle(found(&points, true, 1), [5.0 * scale, 0.0], scale, 1e-5);
        } else if spread > 0.5 {
            // Three unknowns fit no 48 values of noise this large to a tenth of them.
            prop_assert_eq!(found(&points, true, 1), None);
        }
    }
}
