//! Shape of cells: slender and flat ones are noted, and worse ones refused, by the file's own numbers.

use std::fmt::Write as _;

use stickslip_fem_core::mesh::ElementKind;
use stickslip_mesh_files::{Flaw, Format, Note, ReadError};

use super::{imported, refused};

/// A strip of rectangles of height 1 between the places `at` along x, numbered from 11.
fn strip(at: &[f64]) -> String {
    let mut text = "*NODE\n".to_owned();
    for (k, x) in at.iter().enumerate() {
        // Writing into a text does not fail.
        let _ = writeln!(text, "{}, {x}, 0\n{}, {x}, 1", 2 * k + 1, 2 * k + 2);
    }
    text += "*ELEMENT, TYPE=CPS4\n";
    for k in 1..at.len() {
        let first = 2 * k - 1;
        let [second, third, fourth] = [first + 2, first + 3, first + 1];
        let _ = writeln!(text, "{}, {first}, {second}, {third}, {fourth}", 10 + k);
    }
    text
}

/// A triangle of base 1 whose apex stands at `apex`, with mid nodes on its straight sides if it is quadratic.
fn triangle(kind: ElementKind, apex: [f64; 2]) -> String {
    let [x, y] = apex;
    let corners = format!("*NODE\n1, 0, 0\n2, 1, 0\n3, {x}, {y}\n");
    if kind == ElementKind::T3 {
        return corners + "*ELEMENT, TYPE=CPS3\n7, 1, 2, 3\n";
    }
    let (half, high) = (x / 2.0, y / 2.0);
    format!(
        "{corners}4, 0.5, 0\n5, {}, {high}\n6, {half}, {high}\n*ELEMENT, TYPE=CPS6\n7, 1, 2, 3, 4, 5, 6\n",
        half + 0.5
    )
}

fn flawed(text: &str) -> Vec<(usize, u64, Flaw)> {
    let file = imported(text, Format::Abaqus);
    let notes = file.notes.iter();
    let flawed = notes.filter_map(|note| match note {
        Note::Flawed { count, worst, flaw } => Some((*count, *worst, *flaw)),
        _ => None,
    });
    flawed.collect()
}

#[test]
fn slender_cells_are_counted_and_the_worst_is_named() {
    assert_eq!(flawed(&strip(&[0.0, 1.0, 1.051])), []);
    // Widths 1/25, 1, 1/50 and 1/25.
    let text = strip(&[0.0, 0.04, 1.04, 1.06, 1.1]);
    let [(count, worst, Flaw::Sides(ratio))] = flawed(&text)[..] else {
        panic!("{:?}", flawed(&text));
    };
    assert_eq!((count, worst), (3, 13));
    // 0.02 is a difference of numbers near 1.
    assert!((ratio - 50.0).abs() < 1e-10, "{ratio}");
    let file = imported(&text, Format::Abaqus);
    assert_eq!(
        file.notes[0].to_string(),
        "3 elements have sides more than 20 times as long as others, the worst is element 13 with 50.0 times; \
         stresses there depend on the mesh, which is better with even cells"
    );
}

#[test]
fn cells_without_width_are_refused() {
    let text = strip(&[0.0, 2.5, 2.500_01, 5.0]);
    let error = refused(&text, Format::Abaqus);
    assert!(matches!(
        error,
        ReadError::Flawed {
            element: 12,
            flaw: Flaw::Sides(_),
            ..
        }
    ));
    let shown = error.to_string();
    assert_eq!(
        shown,
        "line 12: element 12 has a side 100000.0 times as long as another, and 1000 times are accepted; \
         move its nodes or mesh again with even cells"
    );
    assert_eq!(flawed(&strip(&[0.0, 0.001_01, 1.0])).len(), 1);
}

#[test]
fn nearly_closed_and_straight_corners_are_measured_on_triangles_of_either_order() {
    for kind in [ElementKind::T3, ElementKind::T6] {
        let angle = |height: f64| flawed(&triangle(kind, [0.5, height]));
        assert_eq!(angle(0.5), [], "{kind:?}");
        // Corners of 5° at the base and of 170° at the apex: the sharper one is named.
        let height = 0.5 * 5f64.to_radians().tan();
        let [(1, 7, Flaw::Corner(least))] = angle(height)[..] else {
            panic!("{kind:?}: {:?}", angle(height));
        };
        assert!((least - 5.0).abs() < 1e-9, "{kind:?}: {least}");
        let text = triangle(kind, [0.5, 0.5 * 0.4f64.to_radians().tan()]);
        let error = refused(&text, Format::Abaqus);
        let ReadError::Flawed {
            element: 7,
            flaw: Flaw::Corner(least),
            ..
        } = error
        else {
            panic!("{kind:?}: {error}");
        };
        assert!((least - 0.4).abs() < 1e-9, "{kind:?}: {least}");
        assert!(error.to_string().contains("0.5° to 179.5° are accepted"));
    }
}

#[test]
fn straight_corners_of_quadrilaterals_count_as_closed_ones() {
    let square =
        |x: f64| format!("*NODE\n1,0,0\n2,1,0\n3,{x},{x}\n4,0,1\n*ELEMENT,TYPE=CPS4\n9,1,2,3,4\n");
    // The third corner is at 180° where x is a half.
    let [(1, 9, Flaw::Corner(angle))] = flawed(&square(0.52))[..] else {
        panic!("{:?}", flawed(&square(0.52)));
    };
    let half = (0.48f64 / 0.52).atan().to_degrees();
    assert!((angle - (90.0 + 2.0 * half)).abs() < 1e-9, "{angle}");
    let shown = refused(&square(0.501), Format::Abaqus).to_string();
    assert!(
        shown.contains("element 9 has a corner of 179.77°"),
        "{shown}"
    );
}

#[test]
fn of_a_body_of_several_its_own_cells_are_noted() {
    let text = strip(&[0.0, 0.04, 1.04, 1.06, 2.0])
        + "*ELSET, ELSET=even\n12, 14\n*ELSET, ELSET=ends\n11, 14\n";
    let file = imported(&text, Format::Abaqus);
    let notes = |set: &str| file.only(set).expect("the set").notes;
    assert!(notes("even").is_empty());
    let [
        Note::Flawed {
            count: 1,
            worst: 11,
            ..
        },
    ] = notes("ends")[..]
    else {
        panic!("{:?}", notes("ends"));
    };
}
