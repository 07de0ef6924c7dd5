//! The second edge of a pair as a curve through its displaced nodes.

use std::f64::consts::TAU;

use stickslip_fem_core::mesh::Point;
use stickslip_fem_core::vector::dot;
use thiserror::Error;

use super::slopes::slopes;

/// Why nodes make no curve.
#[derive(Clone, Copy, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum CurveError {
    /// Nodes and parameters differ in number.
    #[error("{parameters} parameters for {nodes} nodes")]
    Parameters {
        /// Number of parameters.
        parameters: usize,
        /// Number of nodes.
        nodes: usize,
    },
    /// The nodes do not fill cells.
    #[error("{nodes} nodes make no cells of order {order}")]
    Cells {
        /// Number of nodes.
        nodes: usize,
        /// Polynomial order of the cells.
        order: usize,
    },
    /// A parameter is not above the one before it, or beyond the period.
    #[error(
        "the parameter goes from {from} to {to} after node {node} of the curve; it must ascend"
    )]
    NotAscending {
        /// Position of the node along the curve, from 0.
        node: usize,
        /// Parameter there, in the unit given.
        from: f64,
        /// Parameter at the next node, or where the period ends, in the unit given.
        to: f64,
    },
}

/// An undeformed edge with the nodes at which its displacements are known.
#[derive(Clone, Debug, PartialEq)]
pub struct Curve {
    shape: CurveShape,
    nodes: Vec<usize>,
    parameter: Vec<f64>,
    ends: CurveEnds,
    /// For each node the weights of nodes, by their positions along the edge, in the derivative of the displacement by the parameter.
    slopes: Vec<Vec<(usize, f64)>>,
    /// The same of the derivative that is skew with the areas of the nodes, by which forces move.
    skew: Vec<Vec<(usize, f64)>>,
}

/// The shape of an undeformed edge.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum CurveShape {
    /// X(s) = centre + radius e_r(s), s an angle `[rad]`; its body lies inside.
    Circle {
        /// Centre `[length]`.
        centre: Point,
        /// Radius `[length]`.
        radius: f64,
    },
    /// X(s) = (s, level), s a length; its body lies below.
    Level {
        /// Coordinate y of the edge `[length]`.
        level: f64,
    },
}

/// How an edge continues at its ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CurveEnds {
    /// It is closed, with the period 2π.
    Closed,
    /// It ends there.
    Open {
        /// Whether its first and its last node lie on a line of symmetry.
        mirrored: [bool; 2],
    },
}

/// A place on the displaced curve, with the derivatives by the parameter.
#[derive(Clone, Copy, Debug)]
pub(super) struct Local {
    pub(super) place: Point,
    pub(super) tangent: Point,
    curvature: Point,
}

/// Iterations in search of a closest point.
const ITERATIONS: usize = 40;

impl Curve {
    /// The edge through `nodes`, indices among the contact points of its body, at `parameter` (s of `shape`, `[rad]` or `[length]`), ascending, in cells of the polynomial order
    /// `order`. A closed one begins at a corner node.
    ///
    /// # Errors
    /// [`CurveError`], where nodes and parameters differ in number, make no whole cells, or the parameter does not ascend within its period.
    pub fn new(
        shape: CurveShape,
        nodes: Vec<usize>,
        parameter: Vec<f64>,
        order: usize,
        ends: CurveEnds,
    ) -> Result<Self, CurveError> {
        let count = nodes.len();
        if parameter.len() != count {
            return Err(CurveError::Parameters {
                parameters: parameter.len(),
                nodes: count,
            });
        }
        let cells = match ends {
            CurveEnds::Closed => count,
            CurveEnds::Open { .. } => count.saturating_sub(1),
        };
        if order == 0 || cells == 0 || !cells.is_multiple_of(order) {
            return Err(CurveError::Cells {
                nodes: count,
                order,
            });
        }
        let end = parameter[0] + TAU;
        let closed = ends == CurveEnds::Closed;
        let closing = closed.then_some(&end);
        let next = parameter[1..].iter().chain(closing);
        for (node, (&from, &to)) in parameter.iter().zip(next).enumerate() {
            let ascends = from < to;
            if !ascends {
                return Err(CurveError::NotAscending { node, from, to });
            }
        }
        Ok(Self {
            slopes: slopes(&parameter, order, closed, order == 1),
            skew: slopes(&parameter, order, closed, false),
            shape,
            nodes,
            parameter,
            ends,
        })
    }

    /// The same where the displacements that belong to nodes are those at the parameters `places` (`[rad]` or `[length]`) instead, as those of means over hats of unequal widths are. By how much
    /// forces move along the edge remains a matter of the nodes, whose distances are their areas.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn standing_at(self, places: Vec<f64>) -> Result<Self, CurveError> {
        let own = Self::new(self.shape, self.nodes, places, 1, self.ends)?;
        Ok(Self {
            skew: self.skew,
            ..own
        })
    }

    /// The curve through fewer `nodes`, linear cells at `parameter`, whose displacements are those at `places`.
    pub(crate) fn thinned(
        &self,
        nodes: Vec<usize>,
        parameter: Vec<f64>,
        places: Vec<f64>,
    ) -> Result<Self, CurveError> {
        Self::new(self.shape, nodes, parameter, 1, self.ends)?.standing_at(places)
    }

    /// The parameters to which the displacements of its nodes belong, in the unit given.
    pub fn places(&self) -> &[f64] {
        &self.parameter
    }

    /// After which parameter it begins again, if it is closed.
    pub(crate) fn period(&self) -> Option<f64> {
        (self.ends == CurveEnds::Closed).then_some(TAU)
    }

    /// The nodes of the curve along its parameter, at least 2, as indices among the contact points of its body.
    pub fn nodes(&self) -> &[usize] {
        &self.nodes
    }

    /// Centre of its circle.
    pub(crate) fn centre(&self) -> Option<Point> {
        match self.shape {
            CurveShape::Circle { centre, .. } => Some(centre),
            CurveShape::Level { .. } => None,
        }
    }

    /// Whether the node at `position` stands on a line of symmetry.
    pub(super) fn is_mirrored(&self, position: usize) -> bool {
        let last = self.nodes.len() - 1;
        match self.ends {
            CurveEnds::Closed => false,
            CurveEnds::Open { mirrored } => {
                (mirrored[0] && position == 0) || (mirrored[1] && position == last)
            }
        }
    }

    /// From where its places are seen: the centre of its circle, so that rounding is relative to the radius wherever the circle stands.
    pub(super) fn origin(&self) -> Point {
        self.centre().unwrap_or_default()
    }

    /// X, X′ and X″ of the undeformed curve, X seen from its [`origin`](Self::origin).
    fn undeformed(&self, s: f64) -> [Point; 3] {
        match self.shape {
            CurveShape::Circle { radius, .. } => {
                let (sine, cosine) = s.sin_cos();
                let [along, up] = [radius * cosine, radius * sine];
                [[along, up], [-up, along], [-along, -up]]
            }
            CurveShape::Level { level } => [[s, level], [1.0, 0.0], [0.0, 0.0]],
        }
    }

    /// Unit normal out of the body, where the tangent x′ is `tangent`.
    pub(super) fn normal(&self, [x, y]: Point) -> Point {
        let length = x.hypot(y);
        match self.shape {
            CurveShape::Circle { .. } => [y / length, -x / length],
            CurveShape::Level { .. } => [-y / length, x / length],
        }
    }

    /// Weights of nodes, by their positions, in the derivative of the displacement at the node `position`.
    pub(super) fn slope(&self, position: usize) -> &[(usize, f64)] {
        &self.slopes[position]
    }

    /// The same of the skew derivative.
    pub(super) fn skew(&self, position: usize) -> &[(usize, f64)] {
        &self.skew[position]
    }

    /// The place `by` beyond the node at `position` of the curve whose nodes are displaced by `moved`, seen from its [`origin`](Self::origin).
    pub(super) fn local(&self, moved: &[Point], position: usize, by: f64) -> Local {
        let [mut place, mut tangent, curvature] = self.undeformed(self.parameter[position] + by);
        let own = moved[position];
        place = [place[0] + own[0], place[1] + own[1]];
        for &(node, weight) in &self.slopes[position] {
            for i in 0..2 {
                let slope = weight * moved[node][i];
                place[i] += by * slope;
                tangent[i] += slope;
            }
        }
        Local {
            place,
            tangent,
            curvature,
        }
    }

    /// How far beyond the node at `position` the place nearest to `to`, seen from its [`origin`](Self::origin), lies on the curve whose nodes are
    /// displaced by `moved`; `None` where the search does not end.
    pub(super) fn nearest(&self, moved: &[Point], to: Point, position: usize) -> Option<f64> {
        let close = 1e-14 * (self.parameter[self.parameter.len() - 1] - self.parameter[0]);
        let mut by = 0.0;
        for _ in 0..ITERATIONS {
            let Local {
                place,
                tangent,
                curvature,
            } = self.local(moved, position, by);
            let away = [to[0] - place[0], to[1] - place[1]];
            let slope = dot(away, curvature) - dot(tangent, tangent);
            let step = dot(away, tangent) / slope;
            if !step.is_finite() {
                return None;
            }
            by -= step;
            if step.abs() <= close {
                return Some(by);
            }
        }
        None
    }

    /// The displacement at the parameter `s`, within its ends, where its nodes are displaced by `moved`: cubic between neighbours, with their derivatives.
    pub(crate) fn displacement(&self, moved: &[Point], s: f64) -> Point {
        let count = self.parameter.len();
        let first = self.parameter[0];
        let at = self
            .period()
            .map_or(s, |period| first + (s - first).rem_euclid(period));
        let after = self.parameter.partition_point(|own| *own <= at);
        let (from, to) = match (after, self.period()) {
            (after, _) if after < count => (after.saturating_sub(1), after.max(1)),
            (_, Some(_)) => (count - 1, 0),
            (_, None) => (count - 2, count - 1),
        };
        let apart = self.parameter[to] - self.parameter[from];
        let width = self
            .period()
            .map_or(apart, |period| apart.rem_euclid(period));
        let x = (at - self.parameter[from]) / width;
        let slope = |position: usize, i: usize| -> f64 {
            let terms = self.slopes[position].iter();
            width
                * terms
                    .map(|&(node, weight)| weight * moved[node][i])
                    .sum::<f64>()
        };
        [0, 1].map(|i| {
            let [a, b] = [from, to].map(|position| moved[position][i]);
            let [rise, fall] = [slope(from, i) - (b - a), (b - a) - slope(to, i)];
            a + x * (b - a) + x * (1.0 - x) * ((1.0 - x) * rise + x * fall)
        })
    }

    /// Second derivative of the displacements `moved` at the node `position`.
    pub(super) fn bend(&self, moved: &[Point], position: usize) -> Point {
        let mut bend = [0.0; 2];
        for &(node, weight) in &self.slopes[position] {
            for &(further, second) in &self.slopes[node] {
                for i in 0..2 {
                    bend[i] += weight * second * moved[further][i];
                }
            }
        }
        bend
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn closed(cells: usize, order: usize) -> Curve {
        let count = cells * order;
        let parameter = (0..count).map(|k| TAU * (k as f64 / count as f64) - 3.0);
        let shape = CurveShape::Circle {
            centre: [0.3, -0.2],
            radius: 2.0,
        };
        let parameter = parameter.collect();
        Curve::new(
            shape,
            (0..count).collect(),
            parameter,
            order,
            CurveEnds::Closed,
        )
        .unwrap()
    }

    fn level(parameter: &[f64], order: usize) -> Result<Curve, CurveError> {
        let ends = CurveEnds::Open {
            mirrored: [true, false],
        };
        let nodes = (0..parameter.len()).collect();
        let shape = CurveShape::Level { level: 0.0 };
        Curve::new(shape, nodes, parameter.to_vec(), order, ends)
    }

    fn values(slope: &[(usize, f64)], of: impl Fn(usize) -> f64) -> f64 {
        slope.iter().map(|&(node, weight)| weight * of(node)).sum()
    }

    /// Parabolas in quadratic cells of uneven length, and their derivatives.
    #[test]
    fn slopes_are_those_of_the_cells() {
        let at = [0.0, 0.5, 1.0, 1.2, 1.4, 2.1, 2.8];
        let curve = level(&at, 2).unwrap();
        for (position, &s) in at.iter().enumerate() {
            let slope = values(curve.slope(position), |k| {
                0.2 - 0.7 * at[k] + 0.3 * at[k] * at[k]
            });
            assert!((slope - (0.6 * s - 0.7)).abs() < 1e-13, "{position}");
        }
        let uniform = closed(6, 2);
        let ratio: Vec<f64> = (uniform.slope(2).iter())
            .map(|(_, weight)| weight * TAU / 12.0)
            .collect();
        let expected = [0.25, -1.0, 1.0, -0.25];
        assert!((ratio.iter().zip(expected)).all(|(found, wanted)| (found - wanted).abs() < 1e-13));
    }

    /// Uniform pressure stays uniform when it moves along a closed edge: Σ_k A_k D_kj = 0, with the areas A of the nodes in their cells.
    #[test]
    fn uniform_pressure_moves_along_as_uniform_pressure() {
        for (order, areas) in [(1, [1.0, 1.0]), (2, [1.0, 2.0])] {
            let curve = closed(8, order);
            let mut sums = vec![0.0; curve.nodes().len()];
            for k in 0..sums.len() {
                for &(node, weight) in curve.skew(k) {
                    sums[node] += areas[k % order] * weight;
                }
            }
            assert!(sums.iter().all(|sum| sum.abs() < 1e-12), "{order} {sums:?}");
        }
    }

    /// Of linear cells of uneven length one derivative is exact for parabolas, the other one skew.
    #[test]
    fn linear_cells_have_two_derivatives() {
        let at = [0.0, 0.5, 1.0, 1.2, 1.3, 2.1, 2.8];
        let curve = level(&at, 1).unwrap();
        for (position, &s) in at.iter().enumerate().take(6).skip(1) {
            let slope = values(curve.slope(position), |k| 0.3 * at[k] * at[k] - 0.7 * at[k]);
            assert!((slope - (0.6 * s - 0.7)).abs() < 1e-13, "{position}");
            let area = 0.5 * (at[position + 1] - at[position - 1]);
            for &(node, weight) in curve.skew(position) {
                let sign = (node as f64 - position as f64).signum();
                assert!((weight * area - 0.5 * sign).abs() < 1e-13, "{position}");
            }
        }
    }

    /// A circle that is shifted and blown up is a circle, on which the nearest place is known. Slopes are those of the node: 0.01 rad beyond it
    /// the normal misses 0.01 of the growth over the radius, 5e-5.
    #[test]
    fn the_nearest_place_on_a_circle_is_along_its_radius() {
        let curve = closed(60, 2);
        let (shift, growth) = ([0.02, -0.01], 0.01);
        let away = |s: f64| [s.cos(), s.sin()];
        let moved: Vec<Point> = (curve.parameter.iter())
            .map(|&s| std::array::from_fn(|i| shift[i] + growth * away(s)[i]))
            .collect();
        for position in [0, 7, 40, 90, 119] {
            let angle = curve.parameter[position] + 0.01;
            let to = std::array::from_fn(|i| shift[i] + 2.1 * away(angle)[i]);
            let by = curve.nearest(&moved, to, position).unwrap();
            assert!((by - 0.01).abs() < 1e-5, "{by}");
            let normal = curve.normal(curve.local(&moved, position, by).tangent);
            assert!((0..2).all(|i| (normal[i] - away(angle)[i]).abs() < 7e-5));
        }
    }

    /// Cubic between nodes: parabolas are exact on an open edge, and modes around a closed one are off by h³.
    #[test]
    fn displacements_are_read_between_nodes() {
        let at = [0.0, 0.5, 1.0, 1.2, 1.3, 2.1, 2.8];
        let parabola = |s: f64| [0.2 - 0.7 * s + 0.3 * s * s, s];
        let moved = at.map(parabola);
        let curve = level(&at, 1).unwrap();
        for s in [0.6, 1.0, 1.27, 2.05] {
            let [found, along] = curve.displacement(&moved, s);
            assert!(
                (found - parabola(s)[0]).abs() < 1e-14 && (along - s).abs() < 1e-14,
                "{s}"
            );
        }
        let off = |cells: usize| {
            let curve = closed(cells, 1);
            let mode = |s: f64| [(3.0 * s).cos(), (2.0 * s).sin()];
            let moved: Vec<Point> = curve.parameter.iter().map(|&s| mode(s)).collect();
            let off = |s: f64| {
                let found = curve.displacement(&moved, s);
                (0..2)
                    .map(|i| (found[i] - mode(s)[i]).abs())
                    .fold(0.0, f64::max)
            };
            (0..500)
                .map(|k| off(0.0137 * f64::from(k)))
                .fold(0.0, f64::max)
        };
        assert!(off(40) / off(80) > 7.0 && off(80) < 3e-4);
    }

    #[test]
    fn nodes_that_make_no_cells_are_refused() {
        assert!(level(&[0.0, 0.5, 1.0, 1.5], 2).is_err());
        let stays = level(&[0.0, 0.5, 0.5], 2).unwrap_err();
        let expected = CurveError::NotAscending {
            node: 1,
            from: 0.5,
            to: 0.5,
        };
        assert_eq!(stays, expected);
        assert!(stays.to_string().contains("from 0.5 to 0.5 after node 1"));
        assert!(level(&[0.0, 0.5, 1.0], 0).is_err());
    }
}
