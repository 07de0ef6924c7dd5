//! Outlines of straight edges around a hole, and the points on them where tractions are fitted.

use std::f64::consts::{PI, TAU};

use nalgebra::Complex;
use stickslip_fem_core::mesh::Point;

use crate::circle::Circle;
use crate::error::SeriesError;
use crate::nodes::Nodes;

type C64 = Complex<f64>;

/// Part of an outline's size up to which two places are one.
const SAME: f64 = 1e-9;

/// The outer edge of a plate: a closed polygon, counter-clockwise, of which the hole's centre sees every point. Edge k goes from vertex k to the next.
///
/// ```
/// use stickslip_series::Outline;
///
/// // A strip from x = −1.5 to 5.5, 3 wide: edges 0 below, 1 at the right, 2 above, 3 at the left.
/// let strip = Outline::strip(1.5, 5.5, 1.5);
/// assert_eq!(strip.edge(3), [[-1.5, 1.5], [-1.5, -1.5]]);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Outline {
    vertices: Vec<Point>,
}

impl Outline {
    /// The outline with `vertices` `[length]`; whether a hole fits is seen where a plate is made of it.
    pub fn new(vertices: Vec<Point>) -> Self {
        Self { vertices }
    }

    /// The rectangle from −`left` to `right` along x and from −`half_width` to `half_width` along y `[length]`: edge 0 is the lower one, 1 the right,
    /// 2 the upper, 3 the left one.
    pub fn strip(left: f64, right: f64, half_width: f64) -> Self {
        Self::new(vec![
            [-left, -half_width],
            [right, -half_width],
            [right, half_width],
            [-left, half_width],
        ])
    }

    /// The vertices `[length]`.
    pub fn vertices(&self) -> &[Point] {
        &self.vertices
    }

    /// Number of edges.
    pub fn edges(&self) -> usize {
        self.vertices.len()
    }

    /// Start and end of edge `edge` `[length]`, an index below [`edges`](Self::edges).
    pub fn edge(&self, edge: usize) -> [Point; 2] {
        [
            self.vertices[edge],
            self.vertices[(edge + 1) % self.vertices.len()],
        ]
    }
}

/// An edge seen from the hole's centre, in radii.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Side {
    /// Start.
    start: C64,
    /// Unit tangent, counter-clockwise.
    tangent: C64,
    /// Length.
    pub(crate) length: f64,
}

impl Side {
    /// Outward unit normal.
    pub(crate) fn normal(&self) -> C64 {
        self.tangent * C64::new(0.0, -1.0)
    }

    /// Distance of its line from the centre.
    fn distance(&self) -> f64 {
        (self.normal().conj() * self.start).re
    }

    /// Length from the start to the point next to the centre.
    fn foot(&self) -> f64 {
        -(self.tangent.conj() * self.start).re
    }

    fn at(&self, along: f64) -> C64 {
        self.start + self.tangent * along
    }

    /// Distance of the edge from the centre.
    fn clearance(&self) -> f64 {
        self.at(self.foot().clamp(0.0, self.length)).norm()
    }
}

/// An outline around a circle, in radii about its centre.
#[derive(Clone, Debug)]
pub(crate) struct Surrounding {
    pub(crate) sides: Vec<Side>,
    /// Edge of which each is the mirror image in the x axis, if the outline is symmetric.
    pub(crate) images: Option<Vec<usize>>,
    /// Distance of the outline from the centre.
    pub(crate) distance: f64,
}

impl Surrounding {
    /// # Errors
    /// [`SeriesError::Outline`] for fewer than three vertices, a place that is not finite, an edge without length or one that the centre does not see from
    /// inside; [`SeriesError::HoleOutside`] where the hole reaches the outline.
    pub(crate) fn new(outline: &Outline, circle: Circle) -> Result<Self, SeriesError> {
        let place =
            |[x, y]: Point| C64::new(x - circle.centre[0], y - circle.centre[1]) / circle.radius;
        let count = outline.edges();
        if count < 3 {
            return Err(SeriesError::Outline {
                edge: count,
                what: "is missing: an outline has at least three",
            });
        }
        let mut sides = Vec::with_capacity(count);
        let mut turned = 0.0;
        for edge in 0..count {
            let [start, end] = outline.edge(edge).map(place);
            let length = (end - start).norm();
            let refuse = |what| Err(SeriesError::Outline { edge, what });
            if !(length.is_finite() && start.norm().is_finite()) {
                return refuse("is not finite");
            }
            if length <= SAME * start.norm() {
                return refuse("has no length");
            }
            let tangent = (end - start) / length;
            let side = Side {
                start,
                tangent,
                length,
            };
            if side.distance() <= SAME * start.norm() {
                return refuse(
                    "does not face the hole's centre: the outline must run counter-clockwise and in its sight",
                );
            }
            turned += (end * start.conj()).arg();
            sides.push(side);
        }
        if (turned - TAU).abs() > 1.0 {
            return Err(SeriesError::Outline {
                edge: 0,
                what: "starts an outline that does not go around the hole once",
            });
        }
        let distance = sides
            .iter()
            .map(Side::clearance)
            .fold(f64::INFINITY, f64::min);
        if distance <= 1.0 {
            return Err(SeriesError::HoleOutside {
                distance: distance * circle.radius,
                radius: circle.radius,
            });
        }
        Ok(Self {
            images: images(&sides),
            sides,
            distance,
        })
    }

    /// The same if it has the symmetry of `nodes`.
    pub(crate) fn fitting(self, nodes: &Nodes) -> Result<Self, SeriesError> {
        if nodes.is_mirrored() && self.images.is_none() {
            return Err(SeriesError::NotMirrored);
        }
        Ok(self)
    }

    /// Whether `place` is on the inner side of the outline, or on it.
    pub(crate) fn contains(&self, place: C64) -> bool {
        let faces = |side: &&Side| {
            let [start, end] = [side.start, side.at(side.length)];
            (start.conj() * place).im >= 0.0 && (place.conj() * end).im >= 0.0
        };
        let inside =
            |side: &Side| (side.normal().conj() * place).re <= side.distance() * (1.0 + SAME);
        self.sides.iter().filter(faces).any(inside)
    }

    /// The corners, of a symmetric outline those that are not below the x axis.
    pub(crate) fn corners(&self) -> impl Iterator<Item = C64> {
        let all = self.sides.iter().map(|side| side.start);
        let halves = self.images.is_some();
        all.filter(move |corner| !halves || corner.im >= -SAME * corner.norm())
    }

    /// About `count` points for a fit, and about half as many to check it, on the outline, or on its half above the x axis if it is symmetric.
    pub(crate) fn points(&self, count: usize) -> [Vec<EdgePoint>; 2] {
        let pieces: Vec<Piece> = (0..self.sides.len())
            .flat_map(|edge| self.pieces(edge))
            .collect();
        let total: f64 = pieces.iter().map(Piece::share).sum();
        let [mut fitted, mut checked] = [Vec::new(), Vec::new()];
        for piece in pieces {
            let part = (count as f64 * piece.share() / total).ceil().max(4.0) as usize;
            let side = self.sides[piece.edge];
            let point = |t: f64| EdgePoint {
                edge: piece.edge,
                place: side.at(piece.along(t)),
                normal: side.normal(),
            };
            let step = 1.0 / part as f64;
            fitted.extend((0..part).map(|k| point((k as f64 + 0.5) * step)));
            // Between points of the fit, every second gap, and close to both ends.
            let between = (1..part).step_by(2).map(|k| k as f64 * step);
            let ends = [0.2 * step, 1.0 - 0.2 * step];
            checked.extend(between.chain(ends).map(point));
        }
        [fitted, checked]
    }

    /// The parts of edge `edge` that points are spread over.
    fn pieces(&self, edge: usize) -> Vec<Piece> {
        let side = &self.sides[edge];
        let crossing = -side.start.im / side.tangent.im;
        let mut cuts = vec![(0.0, true), (side.length, true)];
        let inside = |at: f64| at > SAME * side.length && at < (1.0 - SAME) * side.length;
        if inside(side.foot()) {
            cuts.push((side.foot(), false));
        }
        if self.images.is_some() && inside(crossing) {
            cuts.push((crossing, false));
        }
        cuts.sort_by(|a, b| a.0.total_cmp(&b.0));
        cuts.dedup_by(|a, b| (a.0 - b.0).abs() < SAME * side.length);
        let pieces = cuts.windows(2).map(|ends| Piece {
            edge,
            foot: side.foot(),
            scale: (side.distance() - 1.0).max(0.1),
            ends: [ends[0].0, ends[1].0],
            corners: [ends[0].1, ends[1].1],
        });
        let upper = |piece: &Piece| {
            let middle = side.at(0.5 * (piece.ends[0] + piece.ends[1]));
            self.images.is_none() || middle.im > 0.0
        };
        pieces.filter(upper).collect()
    }
}

/// The mirror image of each side, if all have one.
fn images(sides: &[Side]) -> Option<Vec<usize>> {
    let image = |side: &Side| {
        let end = side.at(side.length).conj();
        let same = |other: &Side| {
            let far =
                (other.start - end).norm() + (other.at(other.length) - side.start.conj()).norm();
            far < SAME * side.start.norm()
        };
        sides.iter().position(same)
    };
    sides.iter().map(image).collect()
}

/// A point of an outline, in radii about the hole's centre.
#[derive(Clone, Copy, Debug)]
pub(crate) struct EdgePoint {
    pub(crate) edge: usize,
    pub(crate) place: C64,
    pub(crate) normal: C64,
}

/// Part of an edge. Points cluster where it is next to the hole, as s = foot + scale · sinh u, and towards corners, as the cosine does.
struct Piece {
    edge: usize,
    foot: f64,
    scale: f64,
    ends: [f64; 2],
    corners: [bool; 2],
}

impl Piece {
    fn stretched(&self) -> [f64; 2] {
        self.ends
            .map(|end| ((end - self.foot) / self.scale).asinh())
    }

    fn share(&self) -> f64 {
        const CORNER: f64 = 0.7;
        let [from, to] = self.stretched();
        let corners = self.corners.iter().filter(|corner| **corner).count();
        to - from + CORNER * corners as f64
    }

    /// Length along the edge for t on 0 to 1.
    fn along(&self, t: f64) -> f64 {
        let clustered = match self.corners {
            [true, true] => 0.5 * (1.0 - (PI * t).cos()),
            [true, false] => 1.0 - (0.5 * PI * t).cos(),
            [false, true] => (0.5 * PI * t).sin(),
            [false, false] => t,
        };
        let [from, to] = self.stretched();
        let stretched = from + (to - from) * clustered;
        (self.foot + self.scale * stretched.sinh()).clamp(self.ends[0], self.ends[1])
    }
}

/// φ′, φ″ and ψ′ of a corner's term at `z`. In the corner itself they have no bound and what they add to displacements and stresses has one, so
/// they are taken within rounding of it.
pub(crate) fn corner(place: C64, z: C64) -> [C64; 3] {
    let i = C64::new(0.0, 1.0);
    let slope = -i / apart(place - z, place);
    [i * corner_log(place, z), slope, -place.conj() * slope]
}

/// ln(1 − z/c) of the corner c, finite in the corner itself.
pub(crate) fn corner_log(place: C64, z: C64) -> C64 {
    apart(1.0 - z / place, C64::new(1.0, 0.0)).ln()
}

/// `difference`, or rounding of `size` where there is none.
fn apart(difference: C64, size: C64) -> C64 {
    if difference.norm_sqr() > 0.0 {
        difference
    } else {
        size * f64::EPSILON
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn displacements_are_continuous_in_a_corner() {
        // (c − z) conj ln(1 − z/c), which vanishes there.
        let place = C64::new(-4.0, 3.0);
        let [own, slope, other] = corner(place, place);
        let moved = -place * own.conj() + place * own.conj();
        assert!(own.is_finite() && slope.is_finite() && moved.norm() < 1e-13);
        assert!((place.conj() * slope + other).norm() <= 1e-15 * other.norm());
    }
}
