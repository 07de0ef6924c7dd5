//! Tables of displacements, and no text or number that panics.

use proptest::prelude::*;
use stickslip_hybrid::data::{
    DataError, Field, Format, FringeLines, LineReading, Measurement, NullField, Places, Reading,
    Track, YAxis,
};

use super::{pixels, plain, read};

/// Head of a DICe file, shortened; the numbers are made up.
const DICE: &str = "***\n*** Digital Image Correlation Engine (DICe)\n\
    *** Coordinates given with (0,0) as upper left corner of image, x positive right, y positive down\n***\n\
    SUBSET_ID,COORDINATE_X,COORDINATE_Y,DISPLACEMENT_X,DISPLACEMENT_Y,SIGMA,GAMMA\n\
    0,4.0E+01,3.0E+02,-8.0E-02,-6.0E-01,1.1E-02,2.4E-03\n\
    1,4.0E+01,3.1E+02,0.0E+00,0.0E+00,-1.0E+00,-1.0E+00\n\
    2,5.0E+01,3.0E+02,nan,-5.0E-01,1.2E-02,2.0E-03\n";

fn refusal(text: &str) -> DataError {
    plain(text).unwrap_err()
}

#[track_caller]
fn says(error: &DataError, parts: &[&str]) {
    let said = error.to_string();
    for part in parts {
        assert!(said.contains(part), "{part} in {said}");
    }
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
fn y_turns_only_on_request() {
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

/// Numbers of the table, not those that scale and axis make of them.
#[test]
fn two_rows_at_one_place_are_named_by_the_tables_own_numbers() {
    let pixels = Reading {
        scale: Some(0.05),
        y_axis: YAxis::Down,
        ..Reading::default()
    };
    let refused = |text: &str, format: &Format| read(text, format, &pixels).unwrap_err();
    let twice = |places| DataError::DuplicatedPoint {
        file: "test.csv".to_owned(),
        first: 2,
        second: 3,
        places,
    };
    assert_eq!(
        refused("x,y,u,v\n300.5,200,0,0\n300.50,2e2,1,1\n", &Format::plain()),
        twice([[300.5, 200.0]; 2])
    );
    let moved = refused(
        "x,y,ux,uy\n300.5,200,0.5,0\n301,200,1,0\n",
        &Format::mudic(),
    );
    assert_eq!(moved, twice([[300.5, 200.0], [301.0, 200.0]]));
    says(
        &moved,
        &["before the deformation", "less their displacements"],
    );
}

/// The words themselves, of two common errors.
#[test]
fn refusals_name_file_line_column_value_and_remedy() {
    assert_eq!(
        refusal("x,y,U,w\n1,2,3,4\n").to_string(),
        "test.csv: line 1 names no column 'v'; it has x, y, U, w; state which of them holds it"
    );
    assert_eq!(
        refusal("*\n\nx,y,u,v\n1,2,3,4\n1,3,a1,4\n").to_string(),
        "test.csv: line 5, column 'u': 'a1' is not a number; write a number with a decimal point, or NaN where nothing was measured; begin the line with # \
         if it is no data"
    );
}

#[test]
fn bad_tables_are_refused() {
    assert!(matches!(
        refusal("x,y,u,v\n1,2,3,4\n\n# again\n1,2,5,6\n"),
        DataError::DuplicatedPoint { first: 2, second: 5, places, .. } if places == [[1.0, 2.0]; 2]
    ));
    assert!(matches!(
        refusal("x,y,u,v\n,2,3,4\n"),
        DataError::NotANumber { line: 2, column, value, remedy, .. }
            if column == "x" && value.is_empty() && remedy.contains("NaN for the displacement")
    ));
    let short = refusal("x,y,u,v\n1,2,3\n");
    assert!(matches!(
        short,
        DataError::RowLength {
            line: 2,
            fields: 3,
            columns: 4,
            all: false,
            ..
        }
    ));
    says(
        &short,
        &[
            "3 fields, the header has 4",
            "complete the row or remove it",
        ],
    );
    says(&refusal("x,y,u,v\n1,2,inf,4\n"), &["'inf' is not finite"]);
    let repeated = refusal("x,y,u,v,U\n1,2,3,4,5\n");
    says(&repeated, &["line 1 names column 'u' 2 times", "rename"]);
    assert!(matches!(
        repeated,
        DataError::RepeatedColumn { column, times: 2, .. } if column == "u"
    ));
    let masked = refusal("x,y,u,v\n1,2,nan,\n1,3,,NaN\n");
    says(&masked, &["none of 2 points", "look at the flag column"]);
    assert!(matches!(masked, DataError::AllMasked { rows: 2, .. }));
    for text in ["", "\n# nothing\n", "x,y,u,v\n"] {
        assert!(matches!(refusal(text), DataError::Empty { .. }));
    }
    let no_scale = read(DICE, &Format::dice(), &Reading::default()).unwrap_err();
    assert!(matches!(no_scale, DataError::NoScale { .. }), "{no_scale}");
    says(&no_scale, &["in pixels", "state the length of one pixel"]);
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
    assert!(matches!(
        binary.unwrap_err(),
        DataError::Malformed { file, line: 2, cause } if file == "b.csv" && cause.starts_with("it is not UTF-8")
    ));
    let overflow = read("x,y,u,v\n1e300,2,3,4\n", &Format::plain(), &pixels(1e300)).unwrap_err();
    assert!(
        overflow.to_string().contains("overflows with the scale"),
        "{overflow}"
    );
}

/// What spreadsheets and other programs write for the same numbers.
#[test]
fn tables_of_other_tools_are_read_as_they_are_meant() {
    let expected = plain("x,y,u,v\n1.5,2,0.001,-3\n2.5,2,,-4\n").unwrap();
    for text in [
        "x,y,u,v,\n1.5,2,0.001,-3\n2.5,2,,-4\n",
        "x,y,u,v,,\n1.5,2,0.001,-3,,\n2.5,2,,-4,,\n",
        "x,y,u,v\n1.5,2,0.001,-3,\n2.5,2,,-4,\n",
        "x, \"y\", u, \"v\"\n1.5, \"2\", 0.001, \"-3\"\n2.5 , \"2\" , ,-4\n",
        "\"x\" \"y\"  \"u\" \"v\"\n1.5  2 0.001 -3\n2.5 \"2\" nan   \"-4\"\n",
        "x;y;u;v\n1,5;2;0,001;-3\n2,5;2;;-4\n",
        "x;y;u;v;\n1,5;2,0;0,001;-3e0;\n2,5;2,0;;-4;\n",
        "x\ty\tu\tv\n1,5\t2\t0,001\t-3\n2,5\t2\t\t\"-4\"\n",
        "x,y,u,v\n\"1,5\",2,\"0,001\",-3\n\"2,5\",2,,-4\n",
        "x,y,u,v\n[mm],[mm],[um],[um]\n1.5,2,0.001,-3\n2.5,2,,-4\n",
        "x;y;u;v\n(mm);(mm);µm;µm\n1,5;2;0,001;-3\n2,5;2;;-4\n",
        "x y u v\nmm mm um um\n1.5 2 0.001 -3\n2.5 2 nan -4\n",
    ] {
        let found = plain(text).unwrap_or_else(|error| panic!("{error}\n{text}"));
        assert_eq!(
            (&found.places, &found.valid),
            (&expected.places, &expected.valid),
            "{text}"
        );
        for (own, other) in found.displacements.iter().zip(&expected.displacements) {
            for (a, b) in own.iter().zip(other) {
                assert!(a == b || a.is_nan() && b.is_nan(), "{text}");
            }
        }
    }
    let (_, rows) = Measurement::read_rows(
        &b"# by hand\nx,y,u,v\n[mm],[mm],[um],(um)\n1,2,3.25,4\n"[..],
        "t",
        &Format::plain(),
        &Reading::default(),
    )
    .unwrap();
    let units: Vec<_> = rows
        .units
        .iter()
        .map(|own| (own.column.as_str(), own.unit.as_str(), own.of_place))
        .collect();
    assert_eq!(
        units,
        [
            ("x", "mm", true),
            ("y", "mm", true),
            ("u", "um", false),
            ("v", "um", false)
        ]
    );
    assert_eq!((rows.units[0].line, &rows.lines[..]), (3, &[4][..]));
}

/// Each with the line, the value, and a remedy that helps.
#[test]
fn tables_that_may_mean_two_things_are_refused_with_a_remedy_that_helps() {
    let headless = "1.5,2,0.001,-3,7\n2.5,2,0.002,-4,8\n";
    let error = refusal(headless);
    assert!(
        matches!(&error, DataError::NoHeader { line: 1, numbers, columns: 5, .. } if numbers == "1.5,2,0.001,-3,7"),
        "{error}"
    );
    says(&error, &["5 columns, such as 'x,y,u,v,c5'"]);
    let whole = plain(&format!("x,y,u,v,c5\n{headless}")).unwrap();
    assert_eq!(whole.places.len(), 2);
    for (text, commas, parts) in [
        (
            "x;y;u;v\n1,5;2;0.001;3\n",
            "1,5",
            ["'0.001' in line 2 a decimal point", "has a decimal comma"],
        ),
        (
            "x;y;u;v\n1,500;2;12,250;3\n",
            "1,500",
            ["a decimal comma or thousands", "may have"],
        ),
    ] {
        let error = refusal(text);
        assert!(
            matches!(&error, DataError::DecimalComma { line: 2, column, value, .. } if column == "x" && value == commas),
            "{error}"
        );
        says(&error, &parts);
        assert!(plain(&text.replace(',', ".")).is_ok());
    }
    // A comma for everything.
    let error = refusal("x,y,u,v\n1,5,2,0,0,001,3,0\n2,5,2,0,0,002,4,0\n");
    assert!(matches!(
        error,
        DataError::RowLength {
            line: 2,
            fields: 8,
            columns: 4,
            all: true,
            ..
        }
    ));
    says(&error, &["so have all rows", "semicolons"]);
    assert!(plain("x;y;u;v\n1,5;2,0;0,001;3,0\n2,5;2,0;0,002;4,0\n").is_ok());
    let error = refusal("x,y,u,v\n0,1,2,3,4\n1,2,2,3,4\n");
    says(&error, &["name every column in the header"]);
    // Units are for displacements; of fringe centres the scale alone says what they are.
    let centres = "line,x,y,order\n-,mm,mm,-\na,0,0,1\na,1,0,2\n";
    let read =
        |text: &str| FringeLines::read(text.as_bytes(), "t", Field::U, &LineReading::new(1.0, 1.0));
    let error = read(centres).unwrap_err();
    assert!(matches!(&error, DataError::Units { line: 2, unit, .. } if unit == "mm"));
    says(&error, &["#"]);
    assert!(read(&centres.replace("-,mm", "#-,mm")).is_ok());
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

#[test]
fn deformed_places_may_be_stated_for_any_table() {
    let format = Format {
        moved: Places::Deformed,
        ..Format::plain()
    };
    let m = read("x,y,u,v\n5,6,1,2\n", &format, &Reading::default()).unwrap();
    assert_eq!(m.places, [[4.0, 4.0]]);
}

/// The step of last digits, by any way of writing numbers, and the line of each place.
#[test]
fn rows_know_their_lines_and_the_step_of_their_digits() {
    let rows = |text: &str, reading: &Reading| {
        let read = Measurement::read_rows(text.as_bytes(), "t", &Format::plain(), reading);
        read.unwrap().1
    };
    let text = "# made\nx,y,u,v\n0,0,0.125,0\n\n1,0,0.5,-3.25e-3\n2,0,1.025,4.5E-4\n3,0,,1.25e-3\n";
    let found = rows(text, &Reading::default());
    assert_eq!(found.lines, [3, 5, 6, 7]);
    for (step, expected) in found.step.into_iter().zip([1e-3, 1e-5]) {
        assert!((step - expected).abs() < 1e-12 * expected, "{step}");
    }
    let scaled = Reading {
        scale: Some(2.0),
        displacement_scale: Some(0.5),
        reversed: [true, false],
        ..Reading::default()
    };
    assert!((rows(text, &scaled).step[0] - 5e-4).abs() < 1e-15);
    // Digits beyond double precision are ignored.
    let all = "x,y,u,v\n0,0,0.30000000000000004441,0\n";
    let [u, v] = rows(all, &Reading::default()).step;
    assert!((u / (0.3 * f64::EPSILON) - 1.0).abs() < 1e-12 && v == 0.0);
}
