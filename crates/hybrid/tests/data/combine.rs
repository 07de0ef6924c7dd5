//! The initial load taken off; front against back.

use std::f64::consts::{PI, TAU};

use stickslip_hybrid::data::{
    DataError, Field, FringeLine, FringeLines, Measurement, NullField, Track,
};
use stickslip_hybrid::moire::Grating;

use super::hole;

#[test]
fn a_null_field_comes_off_at_common_places_or_interpolated() {
    let grid = |shift: f64, slope: f64| {
        let places: Vec<[f64; 2]> = (0..25)
            .map(|k| [f64::from(k % 5) + shift, f64::from(k / 5) + shift])
            .collect();
        let u: Vec<f64> = places.iter().map(|p| slope * p[0] + 2.0 * p[1]).collect();
        Measurement {
            displacements: [u.clone(), u],
            valid: [vec![true; 25], vec![true; 25]],
            deviation: [3.0, 0.0],
            places,
        }
    };
    let mut null = Measurement {
        deviation: [4.0, 1.0],
        ..grid(0.0, 1.0)
    };
    null.mask(Field::V, |k| k == 6);
    let loaded = grid(0.0, 5.0);
    let same = loaded
        .minus(&null, NullField::SamePlaces { tolerance: 1e-9 })
        .unwrap();
    assert_eq!(same.deviation, [5.0, 1.0]);
    assert_eq!((same.count(Field::U), same.count(Field::V)), (25, 24));
    assert!((0..25).all(|k| (same.displacements[0][k] - 4.0 * same.places[k][0]).abs() < 1e-12));

    // Shifted by 0.6 of a step: linear fields are exact, and the last row and column lie outside the null field.
    let how = NullField::Interpolated { longest_side: 1.5 };
    let between = grid(0.6, 5.0).minus(&null, how).unwrap();
    assert_eq!(between.count(Field::U), 16);
    assert!((0..25).all(|k| {
        let off = between.displacements[0][k] - 4.0 * between.places[k][0];
        !between.valid[0][k] || off.abs() < 1e-12
    }));
    // The place at (1, 1), masked, leaves a gap in the null field's triangles.
    assert!(between.count(Field::V) < 16);
    let far = grid(100.0, 1.0).minus(&null, how).unwrap_err();
    assert!(matches!(far, DataError::AllMasked { rows: 25, .. }));
}

#[test]
fn a_null_field_comes_off_fringe_lines_where_it_is_known() {
    let line = |name: &str, centres: &[(f64, f64)]| {
        let centres: Vec<_> = centres
            .iter()
            .map(|&(x, order)| ([x, 0.0], order))
            .collect();
        FringeLine::new("t", name, Track::Straight, &centres, 1e-9).unwrap()
    };
    let field = |lines| FringeLines {
        field: Field::U,
        lines,
    };
    let loaded = field(vec![line(
        "a",
        &[(0.0, 0.0), (1.0, 10.0), (2.0, 20.0), (3.0, 30.0)],
    )]);
    let null = field(vec![line("a", &[(0.0, 0.0), (2.5, 5.0)])]);
    let difference = loaded.minus(&null).unwrap();
    assert_eq!(difference.lines.lines[0].orders(), [0.0, 8.0, 16.0]);
    assert_eq!(difference.left_out, [("a".to_owned(), [3.0, 0.0])]);
    let other = field(vec![line("b", &[(0.0, 0.0), (2.5, 5.0)])]);
    assert!(matches!(
        loaded.minus(&other),
        Err(DataError::NoSuchLine { .. })
    ));
    let wrong = FringeLines {
        field: Field::V,
        ..null
    };
    assert!(matches!(
        loaded.minus(&wrong),
        Err(DataError::Fields { .. })
    ));
}

#[test]
fn front_and_back_are_compared_within_a_quarter_fringe() {
    let circle = |offset: f64, bump: f64, count: i32| {
        let centres: Vec<_> = (0..count)
            .map(|k| {
                let t = TAU * f64::from(k) / f64::from(count);
                let order = offset
                    + 10.0 * t.cos()
                    + if (t - PI / 2.0).abs() < 1e-9 {
                        bump
                    } else {
                        0.0
                    };
                ([t.cos(), t.sin()], order)
            })
            .collect();
        FringeLine::new("t", "hole", hole(true), &centres, 1e-9).unwrap()
    };
    let front = circle(0.0, 0.0, 40);
    let back = circle(3.0, 0.2, 40);
    let raw = front.symmetry(&back, 0.25, false).unwrap();
    assert!(!raw.symmetric && (raw.largest - 3.2).abs() < 1e-12 && raw.compared == 80);
    assert!((raw.place[1] - 1.0).abs() < 1e-9, "{:?}", raw.place);
    let free = front.symmetry(&back, 0.25, true).unwrap();
    assert!(
        free.symmetric && (free.largest - 0.1).abs() < 1e-12 && (free.offset + 3.1).abs() < 1e-12
    );
    let bad = front.symmetry(&circle(0.0, 0.6, 40), 0.25, true).unwrap();
    assert!(!bad.symmetric && (bad.largest - 0.3).abs() < 1e-12);
}

#[test]
fn full_fields_are_compared_along_a_chosen_line() {
    let grating = Grating::new(2400.0).unwrap();
    let side = |bump: f64| {
        let places: Vec<[f64; 2]> = (0..36)
            .map(|k| [f64::from(k % 6), f64::from(k / 6)])
            .collect();
        let v: Vec<f64> = (0..36)
            .map(|k| if k == 14 { bump } else { 0.01 * f64::from(k) })
            .collect();
        Measurement {
            displacements: [v.clone(), v],
            valid: [vec![false; 36], vec![true; 36]],
            deviation: [0.0; 2],
            places,
        }
    };
    let chosen: Vec<[f64; 2]> = (0..=10).map(|k| [f64::from(k) / 2.0, 2.0]).collect();
    let along = |m: &Measurement, field| m.along("middle", field, &chosen, 1.5, &grating);
    let [front, back] = [0.14, 0.14 + 1e-4].map(|bump| along(&side(bump), Field::V).unwrap());
    let found = front.symmetry(&back, 0.25, false).unwrap();
    // 1e-4 mm at 2400 lines/mm.
    assert!(found.symmetric && (found.largest - 0.24).abs() < 1e-9 && found.place == [2.0, 2.0]);
    assert!(matches!(
        along(&side(0.0), Field::U),
        Err(DataError::Triangulation { component: 0, .. })
    ));
    let outside = side(0.0)
        .along("edge", Field::V, &[[0.0, 0.0], [7.0, 0.0]], 1.5, &grating)
        .unwrap_err();
    assert!(
        outside
            .to_string()
            .starts_with("line 'edge' leaves the data at (7, 0)"),
        "{outside}"
    );
}
