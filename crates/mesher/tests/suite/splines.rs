//! Splines: the curve, its mesh, and what is refused.

use std::f64::consts::{FRAC_PI_2, PI};

use stickslip_fem_core::mesh::{ElementKind, Mesh, Point};
use stickslip_mesher::{
    Contour, ContourError, ContourMesh, Course, Division, Path, Piece, Spline, SplineFlaw, Stretch,
    quality,
};

use crate::area::area;
use crate::shapes::{crowned, line, meshed, rectangle, spline};

fn distance(a: Point, b: Point) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

/// The spline through all of `points` with these directions at its ends.
fn path(points: &[Point], [leaves, arrives]: [Option<f64>; 2]) -> Path {
    let [from, inner @ .., to] = points else {
        panic!("three points");
    };
    Path::new(&[Stretch {
        ends: [*from, *to],
        course: Course::Spline(Spline {
            points: inner.to_vec(),
            leaves,
            arrives,
        }),
    }])
    .expect("a curve")
}

const POINTS: [Point; 5] = [[0.0, 0.0], [1.0, 0.5], [2.5, 0.4], [3.0, -0.5], [4.5, -0.2]];

/// Length, middle and direction there from a solution in truncated powers with Gauss points in 64 parts of each span.
#[test]
fn splines_are_those_of_truncated_powers() {
    for (points, ends, length, middle, direction) in [
        (
            &POINTS[..],
            [None, None],
            5.603_849_010_267_4,
            [2.573_464_518_322_376, 0.321_518_011_145_310_6],
            [0.636_867_785_222_696_8, -0.770_973_037_236_411_1],
        ),
        (
            &POINTS,
            [Some(0.3), Some(-0.2)],
            5.330_054_690_142_256,
            [2.460_462_105_846_537_5, 0.444_017_854_062_554_3],
            [0.700_028_348_187_244_1, -0.714_115_054_969_602_7],
        ),
        (
            &POINTS,
            [None, Some(0.5)],
            5.354_497_794_155_464,
            [2.475_226_992_601_945_2, 0.428_073_972_772_335_7],
            [0.683_084_194_112_025, -0.730_339_635_891_634_5],
        ),
        (
            &POINTS[..3],
            [None, None],
            2.650_879_660_664_696,
            [1.194_922_151_577_973_8, 0.538_659_499_334_212],
            [0.988_292_366_962_764_8, 0.152_571_941_729_584_66],
        ),
    ] {
        let path = path(points, ends);
        assert!((path.length() - length).abs() < 1e-12, "{}", path.length());
        let half = 0.5 * path.length();
        assert!(
            distance(path.at(half), middle) < 1e-12,
            "{:?}",
            path.at(half)
        );
        assert!(distance(path.tangent(half), direction) < 1e-12);
        for (point, s) in points.iter().zip([0.0, f64::NAN]) {
            assert!(s.is_nan() || distance(path.at(s), *point) == 0.0);
        }
        for point in points {
            assert!(distance(path.at(path.nearest(*point)), *point) < 1e-14);
        }
    }
}

/// Points of the upper half of a circle about the origin from angle 0, over `turn`.
fn round(count: usize, turn: f64, radius: f64) -> Vec<Point> {
    let at = |k: usize| {
        let (sin, cos) = (turn * k as f64 / (count - 1) as f64).sin_cos();
        [radius * cos, radius * sin]
    };
    (0..count).map(at).collect()
}

/// Largest distance of a spline from the circle, over the radius, and the error of its length.
fn off_circle(count: usize, turn: f64, has_ends: bool) -> [f64; 2] {
    let ends = if has_ends {
        [Some(FRAC_PI_2), Some(FRAC_PI_2 + turn)]
    } else {
        [None, None]
    };
    let path = path(&round(count, turn, 2.0), ends);
    let places = (0..=4000).map(|k| path.at(path.length() * f64::from(k) / 4000.0));
    let off = places.map(|at| (at[0].hypot(at[1]) / 2.0 - 1.0).abs());
    [
        off.fold(0.0, f64::max),
        (path.length() / (2.0 * turn) - 1.0).abs(),
    ]
}

#[test]
fn a_spline_approaches_a_circle_with_the_fourth_power() {
    for (turn, has_ends) in [
        (PI, true),
        (PI, false),
        (FRAC_PI_2, true),
        (FRAC_PI_2, false),
    ] {
        let [coarse, middle, fine] = [5, 9, 17].map(|count| off_circle(count, turn, has_ends));
        for k in 0..2 {
            // Twice as many points: 2⁴ times nearer, which coarse splines with free ends have not reached.
            assert!(
                coarse[k] / middle[k] > 11.0,
                "{turn} {has_ends} {coarse:?} {middle:?}"
            );
            assert!(
                middle[k] / fine[k] > 14.0,
                "{turn} {has_ends} {middle:?} {fine:?}"
            );
        }
        let bound = if has_ends { 1e-5 } else { 5e-5 };
        assert!(fine[0] < bound, "{fine:?}");
    }
}

#[test]
fn places_lines_and_motions_are_those_of_the_curve() {
    let own = path(&POINTS, [None, None]);
    for k in 0..=50 {
        let s = own.length() * f64::from(k) / 50.0;
        let (at, left) = (own.at(s), own.left(s));
        for side in [-0.05, 0.05] {
            let beside = [0, 1].map(|axis| at[axis] + side * left[axis]);
            assert!((own.nearest(beside) - s).abs() < 1e-12, "{s}");
            let found = own.crossings(beside, left.map(|part| -side.signum() * part));
            let best = found.min_by(|a, b| a.0.abs().total_cmp(&b.0.abs()));
            let (way, place) = best.expect("a crossing");
            assert!(
                (way - 0.05).abs() < 1e-13 && (place - s).abs() < 1e-12,
                "{s} {way}"
            );
        }
        // A gap of 1e-12 has the digits that coordinates of 4.5 leave, which are known to 9e-16.
        let beside = [0, 1].map(|axis| at[axis] + 1e-12 * left[axis]);
        let found = own.crossings(beside, left.map(|part| -part));
        let best = found.min_by(|a, b| a.0.abs().total_cmp(&b.0.abs()));
        assert!((best.expect("a crossing").0 / 1e-12 - 1.0).abs() < 5e-3);
    }
    let there = own.moved([5.0, -1.0]);
    let [at, beside] = [own.at(2.0), there.at(2.0)];
    assert!(distance(beside, [at[0] + 5.0, at[1] - 1.0]) < 1e-14);
    // Walked the other way, and turned.
    let back: Vec<Point> = POINTS.iter().rev().copied().collect();
    let back = path(&back, [None, None]);
    assert!((back.length() - own.length()).abs() < 1e-14);
    assert!(distance(back.at(1.5), own.at(own.length() - 1.5)) < 1e-13);
    let (sin, cos) = 0.7_f64.sin_cos();
    let turn = |[x, y]: Point| [cos * x - sin * y, sin * x + cos * y];
    let turned = path(&POINTS.map(turn), [None, None]);
    assert!(distance(turned.at(1.5), turn(own.at(1.5))) < 1e-13);
    let [low, high] = own.bounds();
    let walked = (0..=20_000).map(|k| own.at(own.length() * f64::from(k) / 20_000.0));
    let found = walked.fold([f64::INFINITY, f64::NEG_INFINITY], |[least, most], at| {
        [least.min(at[1]), most.max(at[1])]
    });
    assert!((found[0] - low[1]).abs() < 1e-7 && (found[1] - high[1]).abs() < 1e-7);
}

/// Distances of the nodes of a set from a curve, and the largest angle by which an edge turns.
fn off_curve(mesh: &Mesh, set: &str, path: &Path) -> [f64; 2] {
    let mut worst = [0.0_f64; 2];
    for &edge in &mesh.edge_set(set).expect("a set").edges {
        let nodes: Vec<Point> = (mesh.edge_nodes(edge).walk())
            .map(|node| mesh.nodes()[node])
            .collect();
        let places: Vec<f64> = nodes.iter().map(|at| path.nearest(*at)).collect();
        for (at, s) in nodes.iter().zip(&places) {
            worst[0] = worst[0].max(distance(path.at(*s), *at));
        }
        let [u, v] = [places[0], places[places.len() - 1]].map(|s| path.tangent(s));
        worst[1] = worst[1].max(
            (u[0] * v[1] - u[1] * v[0])
                .atan2(u[0] * v[0] + u[1] * v[1])
                .abs(),
        );
        if let [a, m, b] = places[..] {
            assert!((m - f64::midpoint(a, b)).abs() < 1e-9, "{places:?}");
        }
    }
    worst
}

fn curve_of(contour: &Contour, name: &str) -> Path {
    let cut = contour.cutouts.iter().map(|own| (own.start, &own.pieces));
    let loops = std::iter::once((contour.start, &contour.pieces)).chain(cut);
    for (start, pieces) in loops {
        let mut from = start;
        for piece in pieces {
            if piece.name == name {
                let ends = [from, piece.to];
                let course = piece.course.clone();
                return Path::new(&[Stretch { ends, course }]).expect("a curve");
            }
            from = piece.to;
        }
    }
    panic!("no piece {name}");
}

#[test]
fn boundary_nodes_lie_on_the_true_curve() {
    let contour = crowned();
    let exact = area(&meshed_finely(&contour));
    for kind in [ElementKind::T3, ElementKind::T6] {
        let mesh = meshed(contour.clone(), kind);
        for name in ["crown", "above", "below"] {
            let [off, turn] = off_curve(&mesh, name, &curve_of(&contour, name));
            assert!(off < 1e-14 * 8.0, "{name} {off}");
            // Cells of 15° by the curvature in their middle.
            assert!(turn < 0.3, "{name} {turn}");
        }
        let bound = if kind == ElementKind::T6 { 2e-6 } else { 5e-3 };
        assert!(
            (area(&mesh) / exact - 1.0).abs() < bound,
            "{}",
            area(&mesh) / exact - 1.0
        );
        assert_eq!(mesh, meshed(contour.clone(), kind));
    }
}

fn meshed_finely(contour: &Contour) -> Mesh {
    let division = Division {
        refined: [(3, 40.0), (6, 40.0), (7, 40.0)].into_iter().collect(),
        ..Division::default()
    };
    let contour = contour.clone();
    ContourMesh { contour, division }
        .mesh(1_000_000)
        .expect("a mesh")
}

#[test]
fn refined_splines_have_small_cells_on_the_curve() {
    let contour = crowned();
    let mesh = meshed_finely(&contour);
    assert!(quality(&mesh).least_angle.to_degrees() > 25.0);
    for name in ["crown", "above", "below"] {
        let [off, turn] = off_curve(&mesh, name, &curve_of(&contour, name));
        assert!(off < 1e-14 * 8.0 && turn < 0.05, "{name} {off} {turn}");
    }
    let longest = mesh
        .edge_set("crown")
        .expect("a set")
        .edges
        .iter()
        .map(|&edge| {
            let [a, b] = mesh.edge_nodes(edge).ends.map(|node| mesh.nodes()[node]);
            distance(a, b)
        });
    // The largest cells are a tenth of the narrower side.
    let longest = longest.fold(0.0, f64::max);
    assert!(longest < 1.2 * 0.3 / 40.0, "{longest}");
}

/// An acute corner between a line and a spline has equal first edges by their chords.
#[test]
fn acute_corners_are_cut_along_splines() {
    let contour = Contour {
        start: [0.0, 0.0],
        pieces: vec![
            line("bottom", [4.0, 0.0]),
            line("right", [4.0, 2.5]),
            spline("top", &[[3.0, 1.2], [2.0, 0.8], [1.0, 0.55]], [0.0, 0.0]),
        ],
        cutouts: Vec::new(),
        holes: Vec::new(),
    };
    let mesh = meshed(contour.clone(), ElementKind::T6);
    let [off, _] = off_curve(&mesh, "top", &curve_of(&contour, "top"));
    assert!(off < 1e-14, "{off}");
}

/// A rectangle of 4 by 2 with another course along its upper edge.
fn topped(points: &[Point]) -> Contour {
    let mut contour = rectangle(4.0, 2.0, Vec::new());
    contour.pieces[2] = spline("top", points, [0.0, 2.0]);
    contour
}

fn flaw(points: &[Point]) -> SplineFlaw {
    match topped(points).check().expect_err("a refusal") {
        ContourError::Spline { piece, flaw } if piece == "top" => flaw,
        other => panic!("{other}"),
    }
}

#[test]
fn points_without_a_curve_are_refused() {
    assert_eq!(flaw(&[]), SplineFlaw::NoPoint);
    let many: Vec<Point> = (1..=1001)
        .map(|k| [4.0 - 4.0 * f64::from(k) / 1002.0, 2.0])
        .collect();
    assert_eq!(
        flaw(&many),
        SplineFlaw::TooManyPoints {
            count: 1001,
            most: 1000
        }
    );
    assert!(topped(&many[1..]).check().is_ok());
    for twice in [
        vec![[3.0, 2.2], [3.0, 2.2], [1.0, 2.2]],
        vec![[4.0, 2.0], [1.0, 2.2]],
        vec![[2.0, 2.2], [0.0, 2.0]],
    ] {
        assert!(matches!(flaw(&twice), SplineFlaw::RepeatedPoint { .. }));
    }
    let hook = [[3.0, 2.2], [1.0, 2.3], [1.01, 2.31], [1.0, 2.5], [0.5, 2.2]];
    assert!(
        matches!(flaw(&hook), SplineFlaw::Tight { .. }),
        "{:?}",
        flaw(&hook)
    );
    let knot = [[3.0, 3.0], [1.0, 4.0], [1.0, 2.5], [3.0, 3.5], [1.0, 4.5]];
    let SplineFlaw::Meets { at } = flaw(&knot) else {
        panic!("{:?}", flaw(&knot));
    };
    assert!(at[0] > 1.0 && at[0] < 3.0 && at[1] > 2.5, "{at:?}");
    let mut contour = topped(&[[2.0, f64::NAN]]);
    assert!(
        matches!(contour.check(), Err(ContourError::NotFinite { what, .. }) if what == "point on spline 'top'")
    );
    // A free direction of an end that leads back over the piece before.
    contour = topped(&[[2.0, 2.2]]);
    if let Course::Spline(own) = &mut contour.pieces[2].course {
        own.leaves = Some(-FRAC_PI_2);
    }
    assert!(contour.check().is_err());
}

#[test]
fn splines_that_cross_other_edges_are_refused() {
    let crossing = |points: &[Point]| match topped(points).check() {
        Err(ContourError::Crossing { first, second, at }) => (first, second, at),
        other => panic!("{other:?}"),
    };
    let (first, second, at) = crossing(&[[3.0, 1.0], [2.0, -0.2], [1.0, 1.0]]);
    assert_eq!([first.as_str(), second.as_str()], ["bottom", "top"]);
    assert!(at[1].abs() < 1e-8 && at[0] > 1.0 && at[0] < 3.0, "{at:?}");
    // Beside a corner that they share.
    let (first, second, _) = crossing(&[[4.3, 1.5], [3.7, 1.0], [2.0, 1.5], [1.0, 1.9]]);
    assert_eq!([first.as_str(), second.as_str()], ["right", "top"]);
    // Two splines, and a spline with an arc.
    let mut both = topped(&[[3.0, 0.7], [2.0, 0.5], [1.0, 0.7]]);
    assert!(both.check().is_ok());
    both.pieces[0] = spline("bottom", &[[1.0, 0.8], [3.0, 0.3]], [4.0, 0.0]);
    assert!(matches!(both.check(), Err(ContourError::Crossing { .. })));
    both.pieces[0].course = Course::Arc([2.0, 0.6]);
    assert!(matches!(both.check(), Err(ContourError::Crossing { .. })));
    both.pieces[0].course = Course::Arc([2.0, 0.4]);
    assert!(both.check().is_ok(), "{:?}", both.check());
}

/// Joints with the direction, and with the curvature, of the neighbour are no crossings.
#[test]
fn smooth_joints_are_accepted() {
    let (sin, cos) = 0.4_f64.sin_cos();
    for scale in [1e-3, 1.0, 1e3] {
        let place = |[x, y]: Point| [scale * (cos * x - sin * y), scale * (sin * x + cos * y)];
        let circle = |angle: f64| place([2.0 + 2.0 * angle.cos(), 2.0 + 2.0 * angle.sin()]);
        let arc = |name: &str, from: f64, to: f64| Piece {
            name: name.into(),
            to: circle(to),
            course: Course::Arc(circle(f64::midpoint(from, to))),
        };
        let smooth = |name: &str, from: f64, to: f64, ends: [Option<f64>; 2]| Piece {
            name: name.into(),
            to: circle(to),
            course: Course::Spline(Spline {
                points: (1..8)
                    .map(|k| circle(from + (to - from) * f64::from(k) / 8.0))
                    .collect(),
                leaves: ends[0],
                arrives: ends[1],
            }),
        };
        let turned = |angle: f64| Some(angle + FRAC_PI_2 + 0.4);
        for ends in [[None, None], [turned(0.0), turned(2.0)]] {
            let contour = Contour {
                start: circle(0.0),
                pieces: vec![
                    smooth("one", 0.0, 2.0, ends),
                    arc("two", 2.0, 3.0),
                    smooth("three", 3.0, 5.0, [turned(3.0), turned(5.0)]),
                    smooth("four", 5.0, 2.0 * PI, [turned(5.0), turned(2.0 * PI)]),
                ],
                cutouts: Vec::new(),
                holes: Vec::new(),
            };
            assert!(contour.check().is_ok(), "{scale} {:?}", contour.check());
            let mesh = meshed(contour, ElementKind::T6);
            let exact = PI * 4.0 * scale * scale;
            assert!(
                (area(&mesh) / exact - 1.0).abs() < 2e-5,
                "{}",
                area(&mesh) / exact
            );
        }
    }
}
