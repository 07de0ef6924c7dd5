//! Bodies of the tests, and what is measured on their meshes.

use std::f64::consts::PI;

use stickslip_fem_core::generate::{Extent, uniform_angles};
use stickslip_fem_core::mesh::{ElementKind, Mesh, Point};
use stickslip_mesher::{Contour, ContourMesh, Course, Cutout, Division, Hole, Piece, Spline};

pub(crate) fn line(name: &str, to: Point) -> Piece {
    Piece {
        name: name.into(),
        to,
        course: Course::Line,
    }
}

pub(crate) fn arc(name: &str, through: Point, to: Point) -> Piece {
    Piece {
        name: name.into(),
        to,
        course: Course::Arc(through),
    }
}

pub(crate) fn spline(name: &str, points: &[Point], to: Point) -> Piece {
    Piece {
        name: name.into(),
        to,
        course: Course::Spline(Spline {
            points: points.to_vec(),
            ..Spline::default()
        }),
    }
}

pub(crate) fn hole(name: &str, centre: Point, radius: f64, count: usize) -> Hole {
    Hole {
        name: name.into(),
        centre,
        radius,
        angles: uniform_angles(Extent::Whole, count),
        layers: None,
    }
}

pub(crate) fn cutout(name: &str, start: Point, pieces: Vec<Piece>) -> Cutout {
    Cutout {
        name: name.into(),
        start,
        pieces,
    }
}

/// A slot along x with round ends, of half the length `half` between their centres; pieces are its name with a side.
pub(crate) fn slot(name: &str, [x, y]: Point, half: f64, radius: f64) -> Cutout {
    let side = |own: &str| format!("{name} {own}");
    let pieces = vec![
        line(&side("below"), [x + half, y - radius]),
        arc(
            &side("right"),
            [x + half + radius, y],
            [x + half, y + radius],
        ),
        line(&side("above"), [x - half, y + radius]),
        arc(
            &side("left"),
            [x - half - radius, y],
            [x - half, y - radius],
        ),
    ];
    cutout(name, [x - half, y - radius], pieces)
}

/// A circle of `count` equal arcs of one name.
pub(crate) fn circle(name: &str, [x, y]: Point, radius: f64, count: usize) -> Cutout {
    let at = |turn: f64| {
        let (sin, cos) = (2.0 * PI * turn / count as f64).sin_cos();
        [x + radius * cos, y + radius * sin]
    };
    let pieces = (0..count).map(|k| {
        let from = k as f64;
        let to = if k + 1 == count { 0.0 } else { from + 1.0 };
        arc(name, at(from + 0.5), at(to))
    });
    cutout(name, at(0.0), pieces.collect())
}

/// The rectangle from the origin to (width, height).
pub(crate) fn rectangle(width: f64, height: f64, holes: Vec<Hole>) -> Contour {
    Contour {
        start: [0.0, 0.0],
        pieces: vec![
            line("bottom", [width, 0.0]),
            line("right", [width, height]),
            line("top", [0.0, height]),
            line("left", [0.0, 0.0]),
        ],
        cutouts: Vec::new(),
        holes,
    }
}

pub(crate) fn polygon(corners: &[Point]) -> Contour {
    let ends = corners.iter().cycle().skip(1).take(corners.len());
    let pieces = ends
        .enumerate()
        .map(|(k, &to)| line(&format!("edge {k}"), to));
    Contour {
        start: corners[0],
        pieces: pieces.collect(),
        cutouts: Vec::new(),
        holes: Vec::new(),
    }
}

pub(crate) fn strip() -> Contour {
    rectangle(8.0, 3.0, vec![hole("hole", [6.0, 1.5], 0.5, 72)])
}

pub(crate) fn row_of_five() -> Contour {
    let holes = (0..5).map(|k| {
        hole(
            &format!("hole {k}"),
            [1.0 + 1.5 * f64::from(k), 1.0],
            0.25,
            48,
        )
    });
    rectangle(8.0, 2.0, holes.collect())
}

pub(crate) fn pattern() -> Contour {
    let places = (0..6).map(|k| [2.0 + 2.0 * f64::from(k % 3), 1.0 + 1.5 * f64::from(k / 3)]);
    let holes = places.enumerate();
    rectangle(
        8.0,
        3.5,
        holes
            .map(|(k, at)| hole(&format!("hole {k}"), at, 0.3, 60))
            .collect(),
    )
}

pub(crate) fn eccentric() -> Contour {
    rectangle(6.0, 3.0, vec![hole("hole", [4.5, 0.75], 0.5, 72)])
}

/// A lug with a round end of radius 1 about the origin, in which the hole is.
pub(crate) fn lug(count: usize) -> Contour {
    Contour {
        start: [0.0, -1.0],
        pieces: vec![
            arc("end", [1.0, 0.0], [0.0, 1.0]),
            line("top", [-4.0, 1.0]),
            line("clamped", [-4.0, -1.0]),
            line("bottom", [0.0, -1.0]),
        ],
        cutouts: Vec::new(),
        holes: vec![hole("hole", [0.0, 0.0], 0.5, count)],
    }
}

/// A plate of 10 by 6 with corners of radius 0.5 and a hole.
pub(crate) fn rounded() -> Contour {
    let (w, h, r) = (10.0, 6.0, 0.5);
    let d = r * (1.0 - 0.5_f64.sqrt());
    Contour {
        start: [r, 0.0],
        pieces: vec![
            line("bottom", [w - r, 0.0]),
            arc("corner 1", [w - d, d], [w, r]),
            line("right", [w, h - r]),
            arc("corner 2", [w - d, h - d], [w - r, h]),
            line("top", [r, h]),
            arc("corner 3", [d, h - d], [0.0, h - r]),
            line("left", [0.0, r]),
            arc("corner 4", [d, d], [r, 0.0]),
        ],
        cutouts: Vec::new(),
        holes: vec![hole("hole", [5.0, 3.0], 1.0, 60)],
    }
}

pub(crate) fn angle_plate() -> Contour {
    polygon(&[
        [0.0, 0.0],
        [4.0, 0.0],
        [4.0, 1.0],
        [1.0, 1.0],
        [1.0, 4.0],
        [0.0, 4.0],
    ])
}

/// A triangle with an acute corner of 20° at the origin.
pub(crate) fn acute() -> Contour {
    let (sin, cos) = (PI / 9.0).sin_cos();
    polygon(&[[0.0, 0.0], [4.0, 0.0], [4.0 * cos, 4.0 * sin]])
}

/// A plate with a round notch in its upper edge.
pub(crate) fn notched() -> Contour {
    Contour {
        start: [0.0, 0.0],
        pieces: vec![
            line("bottom", [4.0, 0.0]),
            line("right", [4.0, 2.0]),
            line("top right", [2.5, 2.0]),
            arc("notch", [2.0, 1.5], [1.5, 2.0]),
            line("top left", [0.0, 2.0]),
            line("left", [0.0, 0.0]),
        ],
        cutouts: Vec::new(),
        holes: vec![hole("hole", [2.0, 0.75], 0.4, 48)],
    }
}

/// A plate with a slot beside a hole, a window with sharp corners close to its edge, and a circle of two arcs.
pub(crate) fn slotted() -> Contour {
    let window = [[7.5, 0.5], [7.5, 2.0], [6.0, 2.0], [6.0, 0.5]];
    let sides = window.iter().enumerate();
    let sides = sides.map(|(k, to)| line(&format!("window {k}"), *to));
    Contour {
        cutouts: vec![
            slot("slot", [2.5, 2.0], 0.75, 0.375),
            cutout("window", window[3], sides.collect()),
            circle("round", [6.5, 3.0], 0.5, 2),
        ],
        ..rectangle(8.0, 4.0, vec![hole("hole", [4.5, 2.0], 0.5, 48)])
    }
}

/// A disk of two arcs of one name.
pub(crate) fn disk() -> Contour {
    Contour {
        start: [1.0, 0.0],
        pieces: vec![
            arc("rim", [0.0, 1.0], [-1.0, 0.0]),
            arc("rim", [0.0, -1.0], [1.0, 0.0]),
        ],
        cutouts: Vec::new(),
        holes: Vec::new(),
    }
}

/// A block of 8 by 3 with a crown above it that goes on smoothly from its flat ends, and a cut-out that is an egg of two splines.
pub(crate) fn crowned() -> Contour {
    let egg = |k: f64| {
        let (sin, cos) = (PI * k / 4.0).sin_cos();
        [4.0 + 1.2 * cos + 0.2 * sin * sin, 1.25 + 0.5 * sin]
    };
    let smooth = |name: &str, points: Vec<Point>, to: Point, ends: [f64; 2]| Piece {
        name: name.into(),
        to,
        course: Course::Spline(Spline {
            points,
            leaves: Some(ends[0]),
            arrives: Some(ends[1]),
        }),
    };
    Contour {
        start: [0.0, 0.0],
        pieces: vec![
            line("bottom", [8.0, 0.0]),
            line("right", [8.0, 2.0]),
            line("flat right", [7.0, 2.0]),
            smooth(
                "crown",
                vec![[5.5, 2.5], [4.0, 3.0], [2.5, 2.5]],
                [1.0, 2.0],
                [PI, PI],
            ),
            line("flat left", [0.0, 2.0]),
            line("left", [0.0, 0.0]),
        ],
        cutouts: vec![cutout(
            "egg",
            egg(0.0),
            vec![
                smooth(
                    "above",
                    [1.0, 2.0, 3.0].map(egg).to_vec(),
                    egg(4.0),
                    [0.5 * PI, 1.5 * PI],
                ),
                smooth(
                    "below",
                    [5.0, 6.0, 7.0].map(egg).to_vec(),
                    egg(0.0),
                    [-0.5 * PI, 0.5 * PI],
                ),
            ],
        )],
        holes: Vec::new(),
    }
}

/// All bodies without acute corners, by name.
pub(crate) fn all() -> Vec<(&'static str, Contour)> {
    vec![
        ("strip", strip()),
        ("row of five", row_of_five()),
        ("pattern", pattern()),
        ("eccentric", eccentric()),
        ("lug", lug(72)),
        ("rounded", rounded()),
        ("angle plate", angle_plate()),
        ("notched", notched()),
        ("slotted", slotted()),
        ("disk", disk()),
        ("crowned", crowned()),
    ]
}

pub(crate) fn of_kind(contour: Contour, kind: ElementKind) -> ContourMesh {
    let division = Division {
        kind,
        ..Division::default()
    };
    ContourMesh { contour, division }
}

pub(crate) fn meshed(contour: Contour, kind: ElementKind) -> Mesh {
    of_kind(contour, kind)
        .mesh(1_000_000)
        .unwrap_or_else(|error| panic!("{error}"))
}
