//! Tables of measured displacements and of fringe centres: what is read, what is masked, what is refused and in which words.

use std::collections::BTreeMap;
use std::f64::consts::{PI, TAU};

use proptest::prelude::*;
use stickslip_hybrid::data::{
    DataError, Field, Format, FringeLine, FringeLines, LineReading, Measurement, NullField, Places,
    Reading, Track, YAxis,
};
use stickslip_hybrid::moire::{Grating, MoireError};

/// Head of a DICe file, shortened; the numbers are made up.
const DICE: &str = "***\n*** Digital Image Correlation Engine (DICe)\n\
    *** Coordinates given with (0,0) as upper left corner of image, x positive right, y positive down\n***\n\
    SUBSET_ID,COORDINATE_X,COORDINATE_Y,DISPLACEMENT_X,DISPLACEMENT_Y,SIGMA,GAMMA\n\
    0,4.0E+01,3.0E+02,-8.0E-02,-6.0E-01,1.1E-02,2.4E-03\n\
    1,4.0E+01,3.1E+02,0.0E+00,0.0E+00,-1.0E+00,-1.0E+00\n\
    2,5.0E+01,3.0E+02,nan,-5.0E-01,1.2E-02,2.0E-03\n";

fn pixels(scale: f64) -> Reading {
    Reading {
        scale: Some(scale),
        ..Reading::default()
    }
}

fn read(text: &str, format: &Format, reading: &Reading) -> Result<Measurement, DataError> {
    Measurement::read(text.as_bytes(), "test.csv", format, reading)
}

fn plain(text: &str) -> Result<Measurement, DataError> {
    read(text, &Format::plain(), &Reading::default())
}

fn refusal(text: &str) -> String {
    plain(text).unwrap_err().to_string()
}

#[test]
fn dice_is_read_in_pixels_with_failed_subsets_masked() {
    let m = read(DICE, &Format::dice(), &pixels(0.5)).unwrap();
    assert_eq!(m.places, [[20.0, 150.0], [20.0, 155.0], [25.0, 150.0]]);
    assert_eq!(
        m.valid,
        [[true, false, false], [true, false, true]].map(Vec::from)
    );
    assert_eq!(
        (m.displacements[0][0], m.displacements[1][2]),
        (-0.04, -0.25)
    );
    // What failed is no silent zero.
    assert!(m.displacements[0][1].is_nan() && m.displacements[0][2].is_nan());
}

#[test]
fn y_turns_only_when_told() {
    let down = Reading {
        y_axis: YAxis::Down,
        deviation: [0.01, 0.02],
        ..pixels(0.5)
    };
    let m = read(DICE, &Format::dice(), &down).unwrap();
    assert_eq!(m.places[0], [20.0, -150.0]);
    assert_eq!([m.displacements[0][0], m.displacements[1][0]], [-0.04, 0.3]);
    assert_eq!(m.deviation, [0.01, 0.02]);
    let turned = Reading {
        reversed: [true, false],
        displacement_scale: Some(2.0),
        ..down
    };
    let m = read(DICE, &Format::dice(), &turned).unwrap();
    assert_eq!([m.displacements[0][0], m.displacements[1][0]], [0.16, 1.2]);
}

#[test]
fn mudic_places_go_back_to_the_reference_state() {
    let text = "id,x,y,ux,uy\n0,11.5,20.25,1.5,0.25\n1,30,20,nan,nan\n2,nan,nan,nan,nan\n";
    let m = read(text, &Format::mudic(), &pixels(2.0)).unwrap();
    assert_eq!(m.places, [[20.0, 40.0], [60.0, 40.0]]);
    assert_eq!(m.valid[0], [true, false]);
}

#[test]
fn a_table_of_ones_own_is_read_by_column_names_alone() {
    let format = Format {
        flag: Some("ok".into()),
        ..Format::columns(["Pos X", "pos y"], ["du", "dv"])
    };
    for text in [
        "# camera 2\nPos X;Pos Y;du;dv;ok\n1;2;3;4;0\n",
        "\u{feff}\"Pos X\"\t\"Pos Y\"\tdu\tdv\tok\r\n1\t2\t3\t4\t0\r\n",
    ] {
        let m = read(text, &format, &Reading::default()).unwrap();
        assert_eq!((m.places[0], m.displacements[1][0]), ([1.0, 2.0], 4.0));
    }
    let blanks = plain("  x  y   u v\n\n 1  2 3   4\n").unwrap();
    assert_eq!(blanks.places, [[1.0, 2.0]]);
    let one_field = Format {
        displacements: [None, Some("v".into())],
        ..Format::plain()
    };
    let m = read("x,y,v\n1,2,4\n", &one_field, &Reading::default()).unwrap();
    assert_eq!((m.count(Field::U), m.count(Field::V)), (0, 1));
}

#[test]
fn refusals_name_file_line_column_value_and_remedy() {
    assert_eq!(
        refusal("x,y,U,w\n1,2,3,4\n"),
        "test.csv: line 1 names no column 'v'; it has x, y, U, w; state which of them holds it"
    );
    assert_eq!(
        refusal("*\n\nx,y,u,v\n1,2,3,4\n1,3,a1,4\n"),
        "test.csv: line 5, column 'u': 'a1' is not a number; write a number with a decimal point, or NaN where nothing was measured"
    );
    assert_eq!(
        refusal("x,y,u,v\n1,2,3,4\n\n# again\n1,2,5,6\n"),
        "test.csv: lines 2 and 5 are both at (1, 2); keep one of them"
    );
    assert_eq!(
        refusal("x,y,u,v\n,2,3,4\n"),
        "test.csv: line 2, column 'x': '' is no place for a displacement; give the place, or NaN for the displacement"
    );
    assert_eq!(
        refusal("x,y,u,v\n1,2,3\n"),
        "test.csv: line 2 has 3 fields, the header has 4; complete the row or remove it"
    );
    assert!(refusal("x,y,u,v\n1,2,inf,4\n").contains("'inf' is not finite"));
    assert!(refusal("x,y,u,v,U\n1,2,3,4,5\n").contains("names column 'u' 2 times"));
    assert!(
        refusal("x,y,u,v\n1,2,nan,\n1,3,,NaN\n")
            .contains("none of 2 points has a valid displacement")
    );
    for text in ["", "\n# nothing\n", "x,y,u,v\n"] {
        assert!(refusal(text).contains("there are no data"));
    }
    let no_scale = read(DICE, &Format::dice(), &Reading::default()).unwrap_err();
    assert_eq!(
        no_scale.to_string(),
        "test.csv: the numbers are in pixels and no scale is given; state the length of one pixel"
    );
    for scale in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let wrong = read(DICE, &Format::dice(), &pixels(scale)).unwrap_err();
        assert!(
            matches!(
                wrong,
                DataError::Setting {
                    what: "the scale",
                    ..
                }
            ),
            "{wrong}"
        );
    }
    let binary = Measurement::read(
        &b"x,y,u,v\n1,2,\xff,4\n"[..],
        "b.csv",
        &Format::plain(),
        &Reading::default(),
    );
    assert!(
        binary
            .unwrap_err()
            .to_string()
            .starts_with("b.csv: line 2 is no row of a table: it is not UTF-8")
    );
    let overflow = read("x,y,u,v\n1e300,2,3,4\n", &Format::plain(), &pixels(1e300)).unwrap_err();
    assert!(
        overflow.to_string().contains("overflows with the scale"),
        "{overflow}"
    );
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn no_text_panics(text in "[-0-9a-zA-Z,;. \t\"\n#*µ]{0,200}", down: bool) {
        let reading = Reading { y_axis: if down { YAxis::Down } else { YAxis::Up }, ..pixels(2.0) };
        for format in [Format::plain(), Format::dice(), Format::mudic()] {
            let _ = read(&text, &format, &reading);
        }
        let _ = FringeLines::read(text.as_bytes(), "t", Field::U, &LineReading::new(1.0, 1.0));
    }

    #[test]
    fn no_numbers_panic(rows in proptest::collection::vec((any::<f64>(), any::<f64>(), any::<f64>(), 0..3_u8), 0..12)) {
        let mut text = String::from("x,y,u,v\n");
        let mut centres = String::from("line,x,y,order\n");
        for (x, y, u, k) in &rows {
            text.push_str(&[*x, *y, *u, f64::from(*k) - 1.0].map(|number| number.to_string()).join(","));
            text.push('\n');
            centres.push_str(&[f64::from(*k), *x, *y, *u].map(|number| number.to_string()).join(","));
            centres.push('\n');
        }
        if let Ok(m) = plain(&text) {
            prop_assert!(m.check().is_ok());
            for how in [NullField::SamePlaces { tolerance: 0.0 }, NullField::Interpolated { longest_side: f64::INFINITY }] {
                if let Ok(zero) = m.minus(&m, how) {
                    prop_assert!(zero.displacements[0].iter().all(|u| u.is_nan() || u.abs() < 1e300));
                }
            }
        }
        for track in [Track::Straight, Track::Drawn, Track::Circle { centre: [0.0; 2], closed: true }] {
            let reading = LineReading { track, ..LineReading::new(1.0, f64::INFINITY) };
            if let Ok(lines) = FringeLines::read(centres.as_bytes(), "t", Field::V, &reading) {
                for line in &lines.lines {
                    prop_assert!(line.steps().all(|step| step.length > 0.0));
                    let _ = line.symmetry(line, 0.25, true);
                }
                let _ = lines.minus(&lines);
            }
        }
    }
}

const CENTRES: &str =
    "line,x,y,order\nedge,3,0,30\nedge,1,0,10\nhole,0,1,2\nedge,2,0,20\nhole,-1,0,3\nhole,1,0,1\n";

fn hole(closed: bool) -> Track {
    Track::Circle {
        centre: [0.0; 2],
        closed,
    }
}

fn lines(text: &str, reading: &LineReading) -> Result<FringeLines, DataError> {
    FringeLines::read(text.as_bytes(), "u.csv", Field::U, reading)
}

fn with_hole(closed: bool) -> LineReading {
    LineReading {
        tracks: BTreeMap::from([("hole".to_owned(), hole(closed))]),
        ..LineReading::new(1.0, 1e-6)
    }
}

#[test]
fn fringe_centres_are_sorted_along_their_track() {
    let found = lines(CENTRES, &with_hole(false)).unwrap();
    let [edge, circle] = &found.lines[..] else {
        panic!("two lines")
    };
    assert_eq!(edge.orders(), [30.0, 20.0, 10.0]);
    assert_eq!(circle.orders(), [1.0, 2.0, 3.0]);
    assert_eq!(edge.order_at([1.25, 0.5]), Some(12.5));
    assert_eq!(edge.order_at([3.25, 0.0]), None);
    let at = |degrees: f64| [degrees.to_radians().cos(), degrees.to_radians().sin()];
    assert!((circle.order_at(at(45.0)).unwrap() - 1.5).abs() < 1e-12);
    // The ends themselves belong to the line, whatever rounding does to them.
    for end in [0.0, 180.0, -180.0, 360.0] {
        assert!(circle.order_at(at(end)).is_some());
    }
    assert_eq!(circle.order_at(at(-90.0)), None);
    let closed = lines(CENTRES, &with_hole(true)).unwrap();
    assert!((closed.lines[1].order_at(at(-90.0)).unwrap() - 2.0).abs() < 1e-12);
    assert_eq!(closed.lines[1].steps().count(), 3);
}

#[test]
fn picture_coordinates_turn_places_and_orders_of_the_v_field() {
    let reading = LineReading {
        y_axis: YAxis::Down,
        ..LineReading::new(0.1, 1e-6)
    };
    let text = "line,x,y,order\na,0,10,1\na,0,20,2\n";
    let v = FringeLines::read(text.as_bytes(), "v.csv", Field::V, &reading).unwrap();
    assert_eq!(
        (v.lines[0].places()[1], v.lines[0].orders()[1]),
        ([0.0, -2.0], -2.0)
    );
    let u = lines(text, &reading).unwrap();
    assert_eq!(u.line("a").unwrap().orders()[1], 2.0);
}

#[test]
fn fringe_lines_are_refused_with_the_place() {
    let straight = LineReading::new(1.0, 1e-6);
    let drawn = LineReading {
        track: Track::Drawn,
        ..straight.clone()
    };
    let error = |text: &str, reading: &LineReading| lines(text, reading).unwrap_err().to_string();
    assert_eq!(
        error("line,x,y,order\na,0,0,1\na,2,0,3\na,1,0,2\n", &drawn),
        "u.csv: line 'a' turns back by 180° at its fringe centre (2, 0); put the centres in order along the line, or state a \
         straight or circular track, on which they are sorted"
    );
    assert!(
        error("line,x,y,order\na,0,0,1\na,1,0,2\na,1,0,3\n", &straight)
            .contains("orders 2 and 3 at one place (1, 0)")
    );
    assert!(error("line,x,y,order\na,0,0,1\n", &straight).contains("has 1 fringe centre(s)"));
    assert!(error(CENTRES, &straight).contains("off line 'hole'"));
    let typo = LineReading {
        tracks: BTreeMap::from([("hoel".to_owned(), hole(false))]),
        ..straight.clone()
    };
    assert_eq!(
        error(CENTRES, &typo),
        "u.csv: there is no line 'hoel'; the lines are edge, hole"
    );
    assert!(
        error("line,x,y,order\na,0,0,\n", &straight)
            .contains("line 2, column 'order': '' is not a number")
    );
}

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

#[test]
fn the_reports_grating() {
    // Post & Reddy (1988), part I, 2.2 and 4.2: 2400 lines/mm, 514.5 nm, a quarter fringe is about 1e-4 mm. In mm:
    let grating = Grating::new(2400.0).unwrap();
    let angle = grating.angle(514.5e-6).unwrap();
    // sin α = ½ · 2400 · 514.5e-6 = 0.6174.
    assert!((angle.sin() - 0.6174).abs() < 1e-12 && (angle.to_degrees() - 38.126).abs() < 1e-3);
    assert!((Grating::from_beams(514.5e-6, angle).unwrap().frequency() - 2400.0).abs() < 1e-9);
    // 1/9600 mm.
    assert!((grating.displacement(0.25) - 1.0416666666666667e-4).abs() < 1e-18);
    assert!((grating.order(1e-4) - 0.24).abs() < 1e-12);
    // 2400 lines/mm are the report's 60 960 lines/in.
    assert_eq!(grating.frequency() * 25.4, 60_960.0);
    // The specimen grating: 1200 lines/mm of light of 413 nm.
    let specimen = Grating::new(1200.0).unwrap().angle(413e-6).unwrap();
    assert!((specimen.to_degrees() - 14.348).abs() < 1e-3);
    assert!(matches!(
        grating.angle(1e-3),
        Err(MoireError::TooFine { .. })
    ));
    for frequency in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(Grating::new(frequency).is_err());
    }
    assert!(Grating::from_beams(f64::NAN, 0.5).is_err() && Grating::from_beams(1.0, 0.0).is_err());
}

#[test]
fn strains_are_derivatives_of_orders() {
    let grating = Grating::new(100.0).unwrap();
    let gradients = [[1.0, 2.0], [3.0, 4.0]];
    assert_eq!(grating.strains(gradients), [0.01, 0.04, 0.05]);
    // N = s³ along a straight line and along a circle: slopes of steps are second-order accurate at their middles.
    for track in [Track::Straight, hole(false)] {
        let error = |count: i32| {
            let centres: Vec<_> = (0..=count)
                .map(|k| {
                    let s = f64::from(k) / f64::from(count);
                    let place = if track == Track::Straight {
                        [s, 0.0]
                    } else {
                        [s.cos(), s.sin()]
                    };
                    (place, s.powi(3))
                })
                .collect();
            let line = FringeLine::new("t", "a", track, &centres, 1e-9).unwrap();
            grating.slopes(&line).iter().fold(0.0, |worst: f64, slope| {
                let [x, y] = slope.place;
                let s = if track == Track::Straight {
                    x
                } else {
                    y.atan2(x)
                };
                worst.max((slope.value - 0.01 * 3.0 * s * s).abs())
            })
        };
        // (s+d)³−(s−d)³ = 2d(3s² + d²): the error is d²/f exactly, d half a step.
        for count in [10, 20] {
            let exact = 0.01 * (0.5 / f64::from(count)).powi(2);
            assert!((error(count) - exact).abs() < 1e-12);
        }
    }
}

#[test]
fn deformed_places_may_be_stated_for_any_table() {
    let format = Format {
        moved: Places::Deformed,
        ..Format::plain()
    };
    let m = read("x,y,u,v\n5,6,1,2\n", &format, &Reading::default()).unwrap();
    assert_eq!(m.places, [[4.0, 4.0]]);
}
