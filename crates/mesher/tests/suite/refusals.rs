//! Every error.

use std::collections::BTreeMap;

use stickslip_fem_core::generate::{Generate, GenerateError};
use stickslip_fem_core::mesh::ElementKind;
use stickslip_mesher::{Contour, ContourError, ContourMesh, Course, Cutout, Division};

use crate::shapes::{arc, cutout, hole, line, polygon, rectangle, slot, strip};

fn refused(contour: &Contour) -> ContourError {
    contour.check().expect_err("a refusal")
}

fn divided(change: impl Fn(&mut Division)) -> ContourError {
    let mut division = Division::default();
    change(&mut division);
    let contour = strip();
    ContourMesh { contour, division }
        .check()
        .expect_err("a refusal")
}

#[test]
fn numbers() {
    let mut contour = strip();
    contour.pieces[1].to[0] = f64::NAN;
    assert!(
        matches!(refused(&contour), ContourError::NotFinite { what, .. } if what.contains("right"))
    );
    let mut contour = strip();
    contour.holes[0].radius = -1.0;
    assert!(matches!(
        refused(&contour),
        ContourError::NotPositive { value: -1.0, .. }
    ));
    let mut contour = strip();
    contour.pieces.truncate(1);
    assert_eq!(
        refused(&contour),
        ContourError::TooFewPieces {
            cutout: None,
            count: 1
        }
    );
}

#[test]
fn names() {
    let mut contour = strip();
    contour.pieces[2].name = " ".into();
    assert_eq!(
        refused(&contour),
        ContourError::EmptyName {
            what: "edge 3".into()
        }
    );
    let mut contour = strip();
    contour.holes[0].name = String::new();
    assert_eq!(
        refused(&contour),
        ContourError::EmptyName {
            what: "hole 1".into()
        }
    );
    let duplicate = |name: &str| ContourError::DuplicateName { name: name.into() };
    let mut contour = strip();
    contour.pieces[2].name = "bottom".into();
    assert_eq!(refused(&contour), duplicate("bottom"));
    let mut contour = strip();
    contour.holes[0].name = "left".into();
    assert_eq!(refused(&contour), duplicate("left"));
}

#[test]
fn lengths_and_closure() {
    let mut contour = strip();
    contour.pieces[3].to = [0.0, 0.5];
    assert!(matches!(refused(&contour), ContourError::Open { gap, .. } if gap == 0.5));
    let mut contour = strip();
    contour.pieces[1].to = contour.pieces[0].to;
    assert!(
        matches!(refused(&contour), ContourError::ZeroLength { piece, .. } if piece == "right")
    );
    for through in [[8.0, 1.0], [8.0, 0.0], [8.0, 3.0]] {
        let mut contour = strip();
        contour.pieces[1].course = Course::Arc(through);
        assert!(
            matches!(refused(&contour), ContourError::StraightArc { piece } if piece == "right")
        );
    }
}

#[test]
fn directions_and_crossings() {
    let clockwise = polygon(&[[0.0, 0.0], [0.0, 1.0], [1.0, 1.0], [1.0, 0.0]]);
    assert_eq!(
        refused(&clockwise),
        ContourError::Clockwise {
            cutout: None,
            area: -1.0
        }
    );
    let bow = polygon(&[[0.0, 0.0], [3.0, 0.0], [3.0, 2.0], [2.0, -0.5], [0.0, 2.0]]);
    let ContourError::Crossing { first, second, at } = refused(&bow) else {
        panic!("a crossing");
    };
    assert_eq!([first, second], ["edge 0", "edge 2"].map(String::from));
    assert!((at[0] - 2.2).abs() < 1e-12 && at[1].abs() < 1e-12, "{at:?}");
    // An arc that bulges through the opposite side.
    let mut bulging = rectangle(4.0, 1.0, Vec::new());
    bulging.pieces[2] = arc("top", [2.0, -0.1], [0.0, 1.0]);
    assert!(matches!(refused(&bulging), ContourError::Crossing { .. }));
    // A corner that touches another side.
    let touching = polygon(&[[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [1.0, 0.0], [0.0, 2.0]]);
    assert!(matches!(refused(&touching), ContourError::Crossing { .. }));
}

/// The strip of 8 by 3 with a hole at (6, 1.5), and cut-outs.
fn cut(cutouts: Vec<Cutout>) -> ContourError {
    refused(&Contour { cutouts, ..strip() })
}

/// A rectangle between two corners.
fn window(name: &str, [left, low]: [f64; 2], [right, high]: [f64; 2]) -> Cutout {
    let corners = [[right, low], [right, high], [left, high], [left, low]];
    let side = |(k, to): (usize, &[f64; 2])| line(&format!("{name} {k}"), *to);
    cutout(
        name,
        [left, low],
        corners.iter().enumerate().map(side).collect(),
    )
}

#[test]
fn cutouts_are_closed_loops_of_names() {
    let good = window("a", [1.0, 1.0], [2.0, 2.0]);
    let change = |how: &dyn Fn(&mut Cutout)| {
        let mut own = good.clone();
        how(&mut own);
        cut(vec![own])
    };
    let of = || Some("a".to_owned());
    let short = change(&|own| own.pieces.truncate(1));
    assert_eq!(
        short,
        ContourError::TooFewPieces {
            cutout: of(),
            count: 1
        }
    );
    let open = change(&|own| own.pieces[3].to = [1.0, 1.25]);
    assert!(
        matches!(&open, ContourError::Open { cutout: which, piece, gap: 0.25, .. } if *which == of() && piece == "a 3")
    );
    let clockwise = change(&|own| {
        own.pieces.swap(0, 2);
    });
    assert_eq!(
        clockwise,
        ContourError::Clockwise {
            cutout: of(),
            area: -1.0
        }
    );
    let bow = change(&|own| own.pieces.swap(0, 1));
    assert!(matches!(bow, ContourError::Crossing { .. }), "{bow:?}");
    let nowhere = change(&|own| own.start[1] = f64::NAN);
    assert!(
        matches!(nowhere, ContourError::NotFinite { what, .. } if what == "start of cut-out 'a'")
    );
    let twice = change(&|own| own.pieces[1].name = "left".into());
    assert_eq!(
        twice,
        ContourError::DuplicateName {
            name: "left".into()
        }
    );
    let refined = Division {
        refined: BTreeMap::from([(8, 2.0)]),
        ..Division::default()
    };
    let contour = Contour {
        cutouts: vec![good],
        ..strip()
    };
    let mesh = ContourMesh {
        contour,
        division: refined,
    };
    assert!(matches!(
        mesh.check(),
        Err(ContourError::Refined {
            piece: 8,
            count: 8,
            ..
        })
    ));
}

#[test]
fn cutouts_lie_apart_in_the_body() {
    let inner = window("inner", [1.25, 1.25], [1.75, 1.75]);
    let outer = window("outer", [1.0, 1.0], [2.0, 2.0]);
    assert_eq!(
        cut(vec![inner.clone(), outer.clone()]),
        ContourError::CutoutInside {
            inner: "inner".into(),
            outer: "outer".into()
        }
    );
    assert_eq!(
        cut(vec![window("a", [9.0, 1.0], [10.0, 2.0])]),
        ContourError::CutoutOutside {
            cutout: "a".into(),
            at: [9.0, 1.0]
        }
    );
    let around = window("a", [-1.0, -1.0], [9.0, 4.0]);
    assert!(matches!(
        cut(vec![around]),
        ContourError::CutoutOutside { .. }
    ));
    let across = window("a", [7.0, 1.0], [9.0, 2.0]);
    assert!(matches!(cut(vec![across]), ContourError::Crossing { first, .. } if first == "right"));
    let beside = window("b", [1.5, 1.0], [2.5, 2.0]);
    assert!(matches!(
        cut(vec![outer, beside]),
        ContourError::Crossing { .. }
    ));
    let on_the_hole = slot("slot", [5.0, 1.5], 1.0, 0.25);
    assert!(matches!(
        cut(vec![on_the_hole]),
        ContourError::HoleCrosses { hole, .. } if hole == "hole"
    ));
    let around_the_hole = window("a", [5.0, 0.5], [7.0, 2.5]);
    assert!(matches!(
        cut(vec![around_the_hole]),
        ContourError::HoleOutside { .. }
    ));
    let in_the_hole = window("a", [5.9, 1.4], [6.1, 1.6]);
    assert!(matches!(
        cut(vec![in_the_hole]),
        ContourError::HoleCrosses { .. }
    ));
}

#[test]
fn cusps() {
    let spike = polygon(&[
        [0.0, 0.0],
        [2.0, 0.0],
        [2.0, 1.0],
        [4.0, 1.001],
        [2.0, 1.002],
        [0.0, 2.0],
    ]);
    assert!(matches!(refused(&spike), ContourError::Cusp { angle, .. } if angle < 0.01));
    // A line tangent to an arc of 3/4 of a circle, walked back along it.
    let tangent = Contour {
        start: [0.0, 0.0],
        pieces: vec![
            line("line", [2.0, 0.0]),
            arc("arc", [1.5, 0.25], [1.0, 1.0]),
            line("back", [0.0, 0.0]),
        ],
        cutouts: Vec::new(),
        holes: Vec::new(),
    };
    assert!(tangent.check().is_ok());
    let folded = Contour {
        start: [0.0, 0.0],
        pieces: vec![
            line("line", [2.0, 0.0]),
            arc(
                "arc",
                [2.0 - 0.5_f64.sqrt(), 1.0 - 0.5_f64.sqrt()],
                [1.0, 1.0],
            ),
            line("back", [0.0, 0.0]),
        ],
        cutouts: Vec::new(),
        holes: Vec::new(),
    };
    assert!(matches!(refused(&folded), ContourError::Cusp { first, .. } if first == "line"));
}

#[test]
fn holes() {
    let with = |holes| refused(&rectangle(8.0, 3.0, holes));
    let outside = with(vec![hole("a", [10.0, 1.5], 0.5, 16)]);
    assert!(matches!(
        outside,
        ContourError::HoleOutside { distance: 2.0, .. }
    ));
    let crossing = with(vec![hole("a", [7.75, 1.5], 0.5, 16)]);
    assert!(
        matches!(&crossing, ContourError::HoleCrosses { piece, distance, .. } if piece == "right" && *distance == 0.25)
    );
    let around = with(vec![hole("a", [4.0, 1.5], 20.0, 16)]);
    assert!(matches!(around, ContourError::HoleCrosses { .. }));
    let overlapping = with(vec![
        hole("a", [2.0, 1.5], 0.5, 16),
        hole("b", [2.75, 1.5], 0.5, 16),
    ]);
    assert!(matches!(
        overlapping,
        ContourError::HolesOverlap {
            distance: 0.75,
            radii: 1.0,
            ..
        }
    ));
}

#[test]
fn angles() {
    let with = |change: &dyn Fn(&mut Vec<f64>)| {
        let mut contour = strip();
        change(&mut contour.holes[0].angles);
        refused(&contour)
    };
    let few = with(&|angles| angles.truncate(7));
    assert!(matches!(
        few,
        ContourError::TooFewAngles {
            count: 7,
            needed: 8,
            ..
        }
    ));
    let swapped = with(&|angles| angles.swap(3, 4));
    assert!(matches!(swapped, ContourError::Angles { index: 4, .. }));
    let negative = with(&|angles| angles[0] = -0.01);
    assert!(matches!(
        negative,
        ContourError::Angles {
            index: 0,
            value: -0.01,
            ..
        }
    ));
    let wound = with(&|angles| angles.push(6.3));
    assert!(matches!(wound, ContourError::Angles { index: 72, .. }));
    let unknown = with(&|angles| angles[5] = f64::NAN);
    assert!(matches!(unknown, ContourError::Angles { index: 5, .. }));
    let gap = with(&|angles| drop(angles.drain(40..60)));
    assert!(
        matches!(gap, ContourError::AngleGap { width, .. } if (width - 21.0 * std::f64::consts::TAU / 72.0).abs() < 1e-12)
    );
}

#[test]
fn divisions() {
    let kind = ElementKind::Q8;
    assert_eq!(divided(|d| d.kind = kind), ContourError::Kind { kind });
    for value in [0.0, -1.0, 1.5, f64::NAN] {
        assert!(matches!(
            divided(|d| d.growth = value),
            ContourError::Growth { .. }
        ));
    }
    assert!(matches!(
        divided(|d| d.spacing = Some(0.0)),
        ContourError::NotPositive { .. }
    ));
    assert!(matches!(
        divided(|d| d.spacing = Some(f64::NAN)),
        ContourError::NotFinite { .. }
    ));
    assert!(matches!(
        divided(|d| d.centre[1] = f64::INFINITY),
        ContourError::NotFinite { .. }
    ));
    for (piece, times) in [(3, 0.5), (3, f64::NAN), (4, 2.0)] {
        let refused = divided(|d| d.refined = BTreeMap::from([(piece, times)]));
        assert!(
            matches!(refused, ContourError::Refined { count: 4, .. }),
            "{refused}"
        );
    }
}

/// Holes of 8 nodes nearly touch: no cell between them can have good angles.
#[test]
fn hopeless_gaps() {
    let holes = vec![
        hole("a", [2.0, 1.5], 0.5, 8),
        hole("b", [3.002, 1.5], 0.5, 8),
    ];
    let contour = rectangle(8.0, 3.0, holes);
    let mesh = ContourMesh {
        contour,
        division: Division::default(),
    };
    let error = mesh.mesh(100_000).expect_err("flat cells");
    let ContourError::Incomplete { angle, at, .. } = error else {
        panic!("{error}");
    };
    assert!(angle.to_degrees() < 5.0);
    assert!(
        (at[0] - 2.5).abs() < 0.3 && (at[1] - 1.5).abs() < 0.3,
        "{at:?}"
    );
}

/// Coordinates beyond the range of exact predicates, which see the unit frame alone, and beyond that of products.
#[test]
fn extremes() {
    let sized = |width: f64| ContourMesh {
        contour: rectangle(width, 3.0 / 8.0 * width, Vec::new()),
        division: Division::default(),
    };
    let nodes = |width: f64| sized(width).mesh(100_000).map(|mesh| mesh.nodes().len());
    assert_eq!(nodes(8e70), nodes(8.0));
    let error = nodes(8e200).expect_err("areas overflow");
    assert!(!error.to_string().is_empty());
}

/// Through the trait of generators, errors keep their text.
#[test]
fn through_the_trait() {
    let mut contour = strip();
    contour.pieces[3].to = [0.0, 0.5];
    let text = refused(&contour).to_string();
    let mesh = ContourMesh {
        contour,
        division: Division::default(),
    };
    for error in [mesh.generate().map(|_| ()), mesh.estimate().map(|_| ())] {
        let expected = GenerateError::Contour {
            reason: text.clone(),
            at: None,
        };
        assert_eq!(error, Err(expected));
    }
    assert!(text.contains("edge 'left' ends at (0, 0.5)"), "{text}");
}
