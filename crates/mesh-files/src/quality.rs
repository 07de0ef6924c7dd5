//! Shape of cells, between straight lines through their corners.
//!
//! | measure | noted | refused |
//! | --- | --- | --- |
//! | angle of a corner, from 0° or from 180° | below 10° | below 0.5° |
//! | longest side, by the shortest | above 20 | above 1000 |
//!
//! Whether a curved cell folds is checked by its Jacobian, not here.

use std::fmt;

use stickslip_fem_core::mesh::{ElementBlock, Point};

/// Corners nearer to 0° or 180° are noted, and refused `[deg]`.
const ANGLES: [f64; 2] = [10.0, 0.5];
/// Longer sides, by the shortest one of the cell, are noted, and refused.
const SIDES: [f64; 2] = [20.0, 1000.0];

/// A bad shape of a cell; as text, how bad it is and what is accepted.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Flaw {
    /// A corner of this angle is nearly closed or straight `[deg]`.
    Corner(f64),
    /// Its longest side is so many times as long as its shortest `[1]`.
    Sides(f64),
}

impl fmt::Display for Flaw {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        let ([_, angle], [_, ratio]) = (ANGLES, SIDES);
        match self {
            Self::Corner(own) => {
                let most = 180.0 - angle;
                write!(
                    out,
                    "has a corner of {own:.2}°, and {angle}° to {most}° are accepted"
                )
            }
            Self::Sides(own) => {
                write!(
                    out,
                    "has a side {own:.1} times as long as another, and {ratio} times are accepted"
                )
            }
        }
    }
}

impl Flaw {
    /// How bad it is, ascending.
    fn badness(self) -> f64 {
        match self {
            Self::Corner(angle) => -angle.min(180.0 - angle),
            Self::Sides(ratio) => ratio,
        }
    }

    fn is_beyond(self, angle: f64, ratio: f64) -> bool {
        match self {
            Self::Corner(_) => self.badness() > -angle,
            Self::Sides(_) => self.badness() > ratio,
        }
    }

    /// Whether cells with it are refused.
    pub(crate) fn is_refused(self) -> bool {
        self.is_beyond(ANGLES[1], SIDES[1])
    }

    /// What is said of `count` cells of which `worst` has this flaw.
    pub(crate) fn write_note(
        self,
        out: &mut fmt::Formatter<'_>,
        count: usize,
        worst: u64,
    ) -> fmt::Result {
        let ([angle, _], [ratio, _]) = (ANGLES, SIDES);
        let have = match count {
            1 => "1 element has".to_owned(),
            more => format!("{more} elements have"),
        };
        match self {
            Self::Corner(own) => write!(
                out,
                "{have} corners below {angle}° or above {}°, the worst is element {worst} with {own:.2}°",
                180.0 - angle
            ),
            Self::Sides(own) => write!(
                out,
                "{have} sides more than {ratio} times as long as others, the worst is element {worst} with {own:.1} times"
            ),
        }?;
        out.write_str("; stresses there depend on the mesh, which is better with even cells")
    }
}

/// The worst corner and the sides of a cell.
fn flaws(corners: &[Point]) -> [Flaw; 2] {
    let count = corners.len();
    let to = |from: usize, other: usize| {
        let ([x, y], [to_x, to_y]) = (corners[from], corners[other % count]);
        [to_x - x, to_y - y]
    };
    let angle = |corner: usize| {
        let ([a, b], [c, d]) = (to(corner, corner + 1), to(corner, corner + count - 1));
        let turn = (a * d - b * c).atan2(a * c + b * d).to_degrees();
        // Beyond 180° where the corner points inwards.
        Flaw::Corner(turn.rem_euclid(360.0))
    };
    let worse = |a: Flaw, b: Flaw| if b.badness() > a.badness() { b } else { a };
    let corner = (1..count).map(angle).fold(angle(0), worse);
    let sides = (0..count).map(|side| {
        let [x, y] = to(side, side + 1);
        x.hypot(y)
    });
    let longest = sides.clone().fold(0.0, f64::max);
    let shortest = sides.fold(f64::INFINITY, f64::min);
    [corner, Flaw::Sides(longest / shortest)]
}

/// Worst corner and sides of each cell of `blocks`, in their order.
pub(crate) fn of_cells(
    nodes: &[Point],
    blocks: &[ElementBlock],
) -> impl Iterator<Item = [Flaw; 2]> {
    blocks.iter().flat_map(move |block| {
        let cells = block.connectivity.chunks_exact(block.kind.nodes());
        cells.map(move |own| {
            let mut corners = [[0.0; 2]; 4];
            let count = block.kind.corners();
            for (place, &node) in corners.iter_mut().zip(&own[..count]) {
                *place = nodes[node];
            }
            flaws(&corners[..count])
        })
    })
}

/// Of the cells of `blocks` with bad corners, and of those with bad sides: how many, the number of the worst, and what is bad with it.
/// `numbers` are the file's of the cells.
pub(crate) fn worst(
    nodes: &[Point],
    blocks: &[ElementBlock],
    numbers: &[u64],
) -> impl Iterator<Item = (usize, u64, Flaw)> {
    let mut found: [Option<(usize, u64, Flaw)>; 2] = [None; 2];
    for (flaws, &number) in of_cells(nodes, blocks).zip(numbers) {
        for (place, flaw) in found.iter_mut().zip(flaws) {
            if !flaw.is_beyond(ANGLES[0], SIDES[0]) {
                continue;
            }
            *place = Some(match *place {
                Some((count, worst, before)) if before.badness() >= flaw.badness() => {
                    (count + 1, worst, before)
                }
                Some((count, ..)) => (count + 1, number, flaw),
                None => (1, number, flaw),
            });
        }
    }
    found.into_iter().flatten()
}
