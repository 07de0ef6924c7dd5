//! Fringe centres along lines.

use std::collections::BTreeMap;

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
