//! Moved, turned and mirrored bodies.

use stickslip_fem_core::mesh::{Curve, ElementKind, Mesh, Point};
use stickslip_mesher::{Contour, ContourMesh, Course, Division, Piece, quality};

use crate::area::area;
use crate::shapes::{all, disk, lug, meshed};

/// The contour with all its points mapped; `angle` maps angles of holes.
fn mapped(
    contour: &Contour,
    point: impl Fn(Point) -> Point,
    angle: impl Fn(f64) -> f64,
) -> Contour {
    let mut contour = contour.clone();
    contour.start = point(contour.start);
    let mut pieces: Vec<&mut Piece> = contour.pieces.iter_mut().collect();
    for own in &mut contour.cutouts {
        own.start = point(own.start);
        pieces.extend(&mut own.pieces);
    }
    for piece in pieces {
        piece.to = point(piece.to);
        piece.course = piece.course.mapped(&point, &angle);
    }
    for hole in &mut contour.holes {
        hole.centre = point(hole.centre);
        hole.angles = hole
            .angles
            .iter()
            .map(|&a| angle(a).rem_euclid(std::f64::consts::TAU))
            .collect();
        hole.angles.sort_by(f64::total_cmp);
    }
    contour
}

/// A loop walked the other way: its start and its pieces.
fn turned_back(start: Point, pieces: &[Piece]) -> (Point, Vec<Piece>) {
    let count = pieces.len();
    let back = (0..count).rev().map(|k| Piece {
        to: if k == 0 { start } else { pieces[k - 1].to },
        course: pieces[k].course.reversed(),
        ..pieces[k].clone()
    });
    (pieces[count - 1].to, back.collect())
}

/// The contour walked the other way.
fn reversed(contour: &Contour) -> Contour {
    let (start, pieces) = turned_back(contour.start, &contour.pieces);
    let mut own = Contour {
        start,
        pieces,
        ..contour.clone()
    };
    for cutout in &mut own.cutouts {
        (cutout.start, cutout.pieces) = turned_back(cutout.start, &cutout.pieces);
    }
    own
}

#[test]
fn moved_turned_and_mirrored_bodies_have_like_meshes() {
    let turn = 0.7_f64;
    let (sin, cos) = turn.sin_cos();
    for (name, contour) in all() {
        let mesh = meshed(contour.clone(), ElementKind::T6);
        let moved = mapped(&contour, |p| [p[0] + 1000.0, p[1] - 300.0], |a| a);
        let turned = mapped(
            &contour,
            |p| [cos * p[0] - sin * p[1], sin * p[0] + cos * p[1]],
            |a| a + turn,
        );
        let mirrored = reversed(&mapped(
            &contour,
            |p| [-p[0], p[1]],
            |a| std::f64::consts::PI - a,
        ));
        for (motion, other) in [("moved", moved), ("turned", turned), ("mirrored", mirrored)] {
            let other = meshed(other, ElementKind::T6);
            let least = quality(&other).least_angle.to_degrees();
            assert!(least > 25.0, "{name} {motion}: {least}");
            // Coordinates of 1000 are known to 1e-13, areas of 1 to 1e-10 of products of both.
            assert!(
                (area(&other) / area(&mesh) - 1.0).abs() < 1e-6,
                "{name} {motion}"
            );
            let nodes = [&mesh, &other].map(|mesh| mesh.nodes().len() as f64);
            assert!(
                (nodes[1] / nodes[0] - 1.0).abs() < 0.03,
                "{name} {motion}: {nodes:?}"
            );
        }
    }
}

/// The nodes of a mesh, sorted, and its triangles by their sorted middles; after `place`.
fn drawn(mesh: &Mesh, place: impl Fn(Point) -> Point) -> Vec<[i64; 2]> {
    let nodes: Vec<Point> = mesh.nodes().iter().map(|&node| place(node)).collect();
    let middles = mesh.blocks().iter().flat_map(|block| {
        let cells = block.connectivity.chunks(block.kind.nodes());
        let middle = |cell: &[usize]| {
            [0, 1].map(|c| cell[..3].iter().map(|&n| nodes[n][c]).sum::<f64>() / 3.0)
        };
        cells.map(middle).collect::<Vec<_>>()
    });
    let all = middles.chain(nodes.iter().copied());
    let mut all: Vec<[i64; 2]> = all
        .map(|point| point.map(|c| (c * 1e8).round() as i64))
        .collect();
    all.sort_unstable();
    all
}

/// Whether two lists of points on a grid of 1e-8 are the same, to 2e-8.
fn alike(a: &[[i64; 2]], b: &[[i64; 2]]) -> bool {
    // Points that differ in a last digit may be sorted otherwise.
    let near = |p: &[i64; 2]| {
        let first = b.partition_point(|q| q[0] < p[0] - 2);
        let candidates = b[first..].iter().take_while(|q| q[0] <= p[0] + 2);
        candidates.into_iter().any(|q| (q[1] - p[1]).abs() <= 2)
    };
    a.len() == b.len() && a.iter().all(near)
}

/// The same triangles, to rounding: in other units, elsewhere, turned, mirrored, and drawn from another corner.
#[test]
fn triangles_do_not_depend_on_how_a_body_is_drawn() {
    let (inch, quarter) = (25.4, std::f64::consts::FRAC_PI_2);
    for (name, contour) in all() {
        let reference = drawn(&meshed(contour.clone(), ElementKind::T6), |p| p);
        let check = |how: &str, other: Contour, back: &dyn Fn(Point) -> Point| {
            let other = drawn(&meshed(other, ElementKind::T6), back);
            assert!(alike(&reference, &other), "{name} {how}");
        };
        let mut scaled = mapped(&contour, |p| p.map(|c| c / inch), |a| a);
        for hole in &mut scaled.holes {
            hole.radius /= inch;
        }
        check("in inches", scaled, &|p| p.map(|c| c * inch));
        let moved = mapped(&contour, |[x, y]| [x + 0.1, y - 3.7], |a| a);
        check("moved", moved, &|[x, y]| [x - 0.1, y + 3.7]);
        for turn in [quarter, 0.7, -0.3] {
            let (sin, cos) = f64::sin_cos(turn);
            let place = |[x, y]: Point| [cos * x - sin * y, sin * x + cos * y];
            let back = |[x, y]: Point| [cos * x + sin * y, cos * y - sin * x];
            let turned = mapped(&contour, place, |a| a + turn);
            check(&format!("turned by {turn}"), turned, &back);
        }
        let mirrored = mapped(&contour, |[x, y]| [-x, y], |a| 2.0 * quarter - a);
        check("mirrored", reversed(&mirrored), &|[x, y]| [-x, y]);
        let mut rotated = contour.clone();
        rotated.start = contour.pieces[0].to;
        rotated.pieces.rotate_left(1);
        check("from another corner", rotated, &|p| p);
    }
}

/// Edges that are to be finer belong to what is drawn.
#[test]
fn fine_edges_turn_with_their_body() {
    let nodes = |turned: bool| {
        let contour = all().swap_remove(0).1;
        let contour = if turned {
            mapped(&contour, |[x, y]| [-x, -y], |a| a + std::f64::consts::PI)
        } else {
            contour
        };
        let division = Division {
            refined: [(0, 6.0)].into(),
            ..Division::default()
        };
        let mesh = ContourMesh { contour, division }
            .mesh(100_000)
            .expect("a mesh");
        mesh.nodes().len()
    };
    assert_eq!(nodes(false), nodes(true));
}

/// Bodies that are their own mirror images have such triangles.
#[test]
fn triangles_of_symmetric_bodies_are_symmetric() {
    let upside_down = |[x, y]: Point| [x, -y];
    let wide = |width: f64| move |[x, y]: Point| [width - x, y];
    for (contour, other) in [
        (disk(), &upside_down as &dyn Fn(Point) -> Point),
        (disk(), &wide(0.0)),
        (lug(72), &upside_down),
        (acute_kite(), &upside_down),
        (acute_kite(), &wide(0.0)),
    ] {
        let mesh = meshed(contour, ElementKind::T6);
        assert!(quality(&mesh).least_angle.to_degrees() > 18.0);
        let (own, image) = (drawn(&mesh, |p| p), drawn(&mesh, other));
        assert!(alike(&own, &image));
    }
}

/// Corners of 40° and 140° on both axes.
fn acute_kite() -> Contour {
    let line = |name: &str, to| Piece {
        name: name.into(),
        to,
        course: Course::Line,
    };
    let half = (20.0_f64).to_radians().tan();
    Contour {
        start: [1.0, 0.0],
        pieces: vec![
            line("a", [0.0, half]),
            line("b", [-1.0, 0.0]),
            line("c", [0.0, -half]),
            line("d", [1.0, 0.0]),
        ],
        cutouts: Vec::new(),
        holes: Vec::new(),
    }
}

/// Units of length and far origins do not matter.
#[test]
fn scaled_bodies_have_like_meshes() {
    let reference = meshed(lug(72), ElementKind::T6);
    for (scale, away) in [(1e-6, 0.0), (1e6, 0.0), (1e-12, 0.0), (1.0, 1e7)] {
        let mut contour = mapped(&lug(72), |p| p.map(|c| scale * c + away), |a| a);
        contour.holes[0].radius *= scale;
        let mesh = meshed(contour, ElementKind::T6);
        assert!(quality(&mesh).least_angle.to_degrees() > 25.0);
        let nodes = [&reference, &mesh].map(|mesh| mesh.nodes().len() as f64);
        assert!(
            (nodes[1] / nodes[0] - 1.0).abs() < 0.03,
            "{scale} {away}: {nodes:?}"
        );
    }
}

#[test]
fn the_centre_moves_everything() {
    let by = [12.5, -3.25];
    let still = meshed(lug(48), ElementKind::T6);
    let division = Division {
        centre: by,
        ..Division::default()
    };
    let contour = lug(48);
    let moved = ContourMesh { contour, division }
        .mesh(100_000)
        .expect("a mesh");
    assert_eq!(still.nodes().len(), moved.nodes().len());
    for (a, b) in still.nodes().iter().zip(moved.nodes()) {
        assert_eq!([a[0] + by[0], a[1] + by[1]], *b);
    }
    let curve = moved.edge_set("hole").expect("a set").curve;
    assert_eq!(
        curve,
        Some(Curve::Arc {
            centre: by,
            radius: 0.5
        })
    );
}
