//! Fringe centres along lines.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use stickslip_hybrid::data::{DataError, Field, FringeLines, LineReading, Track, YAxis};

use super::hole;

const CENTRES: &str =
    "line,x,y,order\nedge,3,0,30\nedge,1,0,10\nhole,0,1,2\nedge,2,0,20\nhole,-1,0,3\nhole,1,0,1\n";

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
    let error = |text: &str, reading: &LineReading| lines(text, reading).unwrap_err();
    let is_at = |file: &str, own: &str, name: &str| file == "u.csv" && own == name;
    let back = error("line,x,y,order\na,0,0,1\na,2,0,3\na,1,0,2\n", &drawn);
    let text = back.to_string();
    for part in [
        "by 180° at its fringe centre (2, 0)",
        "in order along the line",
    ] {
        assert!(text.contains(part), "{part} in {text}");
    }
    assert!(matches!(
        back,
        DataError::TurnsBack { file, row: Some(3), name, place: [2.0, 0.0], angle } if is_at(&file, &name, "a") && (angle - 180.0).abs() < 1e-9
    ));
    assert!(matches!(
        error("line,x,y,order\na,0,0,1\n\na,1,0,2\nb,3,0,1\n", &straight),
        DataError::ShortLine { file, row: Some(5), name, centres: 1 } if is_at(&file, &name, "b")
    ));
    let typo = LineReading {
        tracks: BTreeMap::from([("hoel".to_owned(), hole(false))]),
        ..straight.clone()
    };
    assert!(matches!(
        error(CENTRES, &typo),
        DataError::NoSuchLine { file, name, available } if is_at(&file, &name, "hoel") && available == "edge, hole"
    ));
    assert!(matches!(
        error("line,x,y,order\na,0,0,\n", &straight),
        DataError::NotANumber { line: 2, column, value, .. } if column == "order" && value.is_empty()
    ));
}

/// A table in pixels of 0.01, y down: errors are reported in pixels, as in the file.
#[test]
fn faults_of_fringe_centres_are_reported_by_the_numbers_of_their_rows() {
    let pixels = LineReading {
        y_axis: YAxis::Down,
        ..LineReading::new(0.01, 0.1)
    };
    let error = |text: &str, reading: &LineReading| lines(text, reading).unwrap_err().to_string();
    // Symmetric centres do not turn the line of least squares, which has their mean y, 20.
    assert_eq!(
        error(
            "line,x,y,order\na,0,0,1\na,100,40,2\na,200,40,3\na,300,0,4\n",
            &pixels
        ),
        "u.csv: line 2: the fringe centre (0, 0) of order 1 lies 20 off fringe line 'a', more than the tolerance of 10, in the table's \
         own unit; correct it, or state another track"
    );
    assert!(matches!(
        lines(
            "# pixels\nline,x,y,order\na,100,20,1\na,300,20,2\na,100,20,-3\n",
            &pixels
        ),
        Err(DataError::RepeatedCentre { rows: Some([3, 5]), places, orders: [1.0, -3.0], .. }) if places == [[100.0, 20.0]; 2]
    ));
    let around = LineReading {
        track: hole(false),
        ..pixels
    };
    assert!(
        error("line,x,y,order\na,1,0,1\na,2,0,2\n", &around)
            .contains("at one place along it, (1, 0) and (2, 0)")
    );
    // At the centre of the circle, with zeros of both signs.
    assert!(
        error("line,x,y,order\na,0,0,1\na,-0,-0,2\n", &around).contains("at one place along it")
    );
}

/// A half circle of radius 10 whose track was forgotten is read as a straight line. Its centroid lies 10 · 2/π above the ends, near 6.
#[test]
fn centres_on_an_arc_are_doubted_on_a_straight_track() {
    let mut text = "line,x,y,order\n".to_owned();
    for k in 0..=18 {
        let (sine, cosine) = (f64::from(k) * 10.0_f64.to_radians()).sin_cos();
        writeln!(text, "arc,{},{},{k}", 10.0 * cosine, 10.0 * sine).unwrap();
    }
    for k in 0..=4 {
        writeln!(text, "straight,{k},{},{k}", 0.3 * f64::from(k % 2)).unwrap();
    }
    let doubts = |reading: &LineReading| {
        let read = FringeLines::read_with_doubts(text.as_bytes(), "u.csv", Field::U, reading);
        read.unwrap().1
    };
    let forgotten = LineReading::new(0.5, f64::INFINITY);
    let [arc] = &doubts(&forgotten)[..] else {
        panic!("one of the two lines is doubted")
    };
    assert_eq!((arc.name.as_str(), arc.centres[1]), ("arc", 19));
    // The ends are the farthest: 0.5 · 6.03 off, the mean of the 19 sines being 0.6015.
    assert!([2, 20].contains(&arc.row), "{arc:?}");
    assert!((arc.distance - 0.5 * 6.015).abs() < 5e-3, "{arc:?}");
    // The median step of the 18 along x is the mean of those at 40 and 50 degrees or one of them: 10 (cos 40° − cos 50°) = 1.232.
    assert!((arc.spacing - 0.5 * 1.232).abs() < 0.05, "{arc:?}");
    // What the file says is not doubted: the track, or how far off centres may be.
    let tracks = BTreeMap::from([("arc".to_owned(), hole(false))]);
    assert!(
        doubts(&LineReading {
            tracks,
            ..forgotten.clone()
        })
        .is_empty()
    );
    assert!(
        doubts(&LineReading {
            tolerance: 4.0,
            ..forgotten
        })
        .is_empty()
    );
}
