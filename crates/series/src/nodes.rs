//! Nodes on a circle, and the hats on them.
//!
//! ```text
//! q(θ) = Σ_i q_i N_i(θ),     w_i = ∫ N_i dθ,     ⟨f⟩_i = (1/w_i) ∫ N_i f dθ
//! ```
//!
//! N_i is 1 at node i, 0 at its neighbours and linear in between. The traction q is a vector along x and y, so a nodal force is its whole
//! resultant: λ_i = R t w_i q_i, acting at the mean place ⟨x⟩_i, which lies inside of the circle by a twelfth of the squared spacing.
//! The displacement of a node is the mean ⟨u⟩_i, which is the one that λ_i works on.

mod element;
mod parts;
mod spread;

pub(crate) use element::{Element, Knot};
use std::f64::consts::{PI, TAU};

use nalgebra::Complex;
use stickslip_fem_core::mesh::Point;

use crate::error::SeriesError;
use crate::gauss::rule;
use parts::{LEAST_SPACING, chain, check, element, half_hats, own_knots, spacing, spacing_below};

/// Nodes on a circle, in the order of their angles.
///
/// ```
/// use stickslip_series::Nodes;
///
/// let half = Nodes::uniform_half(61)?;
/// assert!((half.angles()[20] - 1.0_f64.to_radians() * 60.0).abs() < 1e-15);
/// // Half of a hat stands on the axis.
/// assert!((half.weights()[0] / half.weights()[1] - 0.5).abs() < 1e-12);
/// # Ok::<(), stickslip_series::SeriesError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Nodes {
    angles: Vec<f64>,
    mirrored: bool,
    /// Nodes of the whole circle: those of the operator first, in their order, then images.
    knots: Vec<Knot>,
    elements: Vec<Element>,
    /// Spacing `[rad]` where all knots of a closed circle are equally far.
    step: Option<f64>,
}

impl Nodes {
    /// Nodes all around a circle, at strictly increasing angles `[rad]` within one turn.
    ///
    /// # Errors
    /// [`SeriesError::Angle`] for an angle that is not finite, [`SeriesError::Spacing`] where neighbours are closer
    /// than 1e-7 or farther than an eighth of a turn, [`SeriesError::Count`] for fewer than two nodes.
    pub fn circle(angles: Vec<f64>) -> Result<Self, SeriesError> {
        check(&angles)?;
        let last = angles.len() - 1;
        spacing(last, angles[0] + TAU - angles[last])?;
        let mut elements = chain(&angles, 0);
        elements.push(element([last, 0], [angles[last], angles[0] + TAU]));
        let knots = own_knots(&angles);
        Ok(Self::of(angles, false, knots, elements, true))
    }

    /// `count` nodes all around a circle with equal spacing, the first at θ = 0.
    ///
    /// # Errors
    /// As [`Nodes::circle`].
    pub fn uniform_circle(count: usize) -> Result<Self, SeriesError> {
        Self::circle((0..count).map(|k| TAU * k as f64 / count as f64).collect())
    }

    /// Nodes on a part of a circle, at strictly increasing angles `[rad]` over less than one turn. The ends have half a hat, so that a
    /// traction may jump to zero there.
    ///
    /// # Errors
    /// As [`Nodes::circle`].
    pub fn arc(angles: Vec<f64>) -> Result<Self, SeriesError> {
        check(&angles)?;
        let last = angles.len() - 1;
        if angles[0] + TAU - angles[last] < LEAST_SPACING {
            spacing(last, angles[0] + TAU - angles[last])?;
        }
        let (knots, elements) = (own_knots(&angles), chain(&angles, 0));
        Ok(Self::of(angles, false, knots, elements, false))
    }

    /// The half 0 ≤ θ ≤ π of a body and of loads that mirror each other in the x axis, at strictly increasing angles `[rad]`. Forces are
    /// those on the half, as in a half model of finite elements; their images act on the other half. A node at 0 or at π moves along x only.
    ///
    /// # Errors
    /// As [`Nodes::circle`], and [`SeriesError::Angle`] for an angle outside of 0 to π.
    pub fn mirrored(mut angles: Vec<f64>) -> Result<Self, SeriesError> {
        check(&angles)?;
        let last = angles.len() - 1;
        if (angles[last] - PI).abs() < LEAST_SPACING {
            angles[last] = PI;
        }
        if let Some(&angle) = angles.iter().find(|angle| !(0.0..=PI).contains(*angle)) {
            return Err(SeriesError::Angle { angle });
        }
        let [at_start, at_end] = [angles[0] == 0.0, angles[last] == PI];
        if !at_start {
            spacing_below(0, 2.0 * angles[0])?;
        }
        if !at_end {
            spacing_below(last, 2.0 * (PI - angles[last]))?;
        }
        let mut knots = own_knots(&angles);
        let images: Vec<usize> = (0..=last)
            .rev()
            .filter(|&k| !(k == last && at_end || k == 0 && at_start))
            .collect();
        for &node in &images {
            knots[node].image = knots.len();
            let knot = Knot {
                angle: TAU - angles[node],
                image: node,
                ..knots[node]
            };
            knots.push(knot);
        }
        let all: Vec<f64> = knots.iter().map(|knot| knot.angle).collect();
        let own = angles.len();
        let mut elements = chain(&all[..own], 0);
        elements.extend(chain(&all[own..], own));
        if at_end {
            elements.push(element([last, own], [PI, all[own]]));
        }
        if at_start {
            let before = all.len() - 1;
            elements.push(element([before, 0], [all[before], TAU]));
        }
        // Angles near a turn have fewer digits than those near 0: an image is as long as its own element.
        for index in last..elements.len() {
            let [a, b] = elements[index].knots.map(|knot| knots[knot].node);
            if a.abs_diff(b) == 1 {
                elements[index].length = elements[a.min(b)].length;
            }
        }
        Ok(Self::of(angles, true, knots, elements, at_start && at_end))
    }

    /// `count` nodes from 0 to π with equal spacing, of a body and of loads that mirror each other in the x axis.
    ///
    /// # Errors
    /// As [`Nodes::mirrored`].
    pub fn uniform_half(count: usize) -> Result<Self, SeriesError> {
        let last = count.max(2) - 1;
        Self::mirrored((0..count).map(|k| PI * k as f64 / last as f64).collect())
    }

    fn of(
        angles: Vec<f64>,
        mirrored: bool,
        mut knots: Vec<Knot>,
        elements: Vec<Element>,
        closed: bool,
    ) -> Self {
        for part in &elements {
            for knot in part.knots {
                knots[knot].weight += 0.5 * part.length;
            }
        }
        let step = TAU / knots.len() as f64;
        let even = |(k, knot): (usize, &Knot)| {
            (knot.angle - knots[0].angle - k as f64 * step).abs() < 4.0 * f64::EPSILON * TAU
        };
        let uniform = closed && knots.iter().enumerate().all(even);
        Self {
            step: uniform.then_some(step),
            angles,
            mirrored,
            knots,
            elements,
        }
    }

    /// Angles `[rad]`.
    pub fn angles(&self) -> &[f64] {
        &self.angles
    }

    /// Number of nodes n.
    pub fn len(&self) -> usize {
        self.angles.len()
    }

    /// Whether there is no node; never.
    pub fn is_empty(&self) -> bool {
        self.angles.is_empty()
    }

    /// Whether the nodes are one half of a body that mirrors itself in the x axis.
    pub fn is_mirrored(&self) -> bool {
        self.mirrored
    }

    /// Weights w_i = ∫ N_i dθ `[rad]`, n; in a half model over the half. The area that node i stands for is R t w_i.
    pub fn weights(&self) -> Vec<f64> {
        let half = |node: usize| if self.on_axis(node) { 0.5 } else { 1.0 };
        (0..self.len())
            .map(|node| half(node) * self.knots[node].weight)
            .collect()
    }

    /// Angles `[rad]` of the mean places of the hats, where nodal forces act, n: those of the nodes themselves where both neighbours are equally far
    /// or a half model ends.
    pub fn mean_angles(&self) -> Vec<f64> {
        let means = self.places().into_iter().zip(&self.angles);
        means
            .map(|([x, y], angle)| {
                let [cos, sin] = [angle.cos(), angle.sin()];
                angle + (y * cos - x * sin).atan2(x * cos + y * sin)
            })
            .collect()
    }

    /// Mean ⟨f⟩_i of the function `f` of the angle `[rad]` over each hat, n, in the unit of `f`; in a half model over the half of it. Exact for
    /// polynomials of degree 14 on each side of a node.
    pub fn mean(&self, mut f: impl FnMut(f64) -> f64) -> Vec<f64> {
        let points = rule(8);
        let mut sums = vec![0.0; self.len()];
        let weights = self.weights();
        // Elements of own knots only are those of the operator's part of the circle.
        let own = |knot: usize| knot < self.len();
        let parts = (self.elements.iter()).filter(|part| part.knots.iter().all(|&k| own(k)));
        for part in parts {
            for [x, w] in &points {
                let value = w * part.length * f(part.start + x * part.length);
                sums[part.knots[0]] += (1.0 - x) * value;
                sums[part.knots[1]] += x * value;
            }
        }
        for (sum, weight) in sums.iter_mut().zip(weights) {
            *sum /= weight;
        }
        sums
    }

    /// Mean places ⟨x⟩_i of the hats on the unit circle about the origin, n: where nodal forces act.
    pub(crate) fn places(&self) -> Vec<Point> {
        let means = self.mode_means(1);
        let place = |node: usize| {
            let mean = means[node];
            [mean.re, if self.on_axis(node) { 0.0 } else { mean.im }]
        };
        (0..self.len()).map(place).collect()
    }

    /// Whether the node stands on the axis of symmetry, where it moves along x only.
    pub(crate) fn on_axis(&self, node: usize) -> bool {
        self.mirrored && self.knots[node].image == node
    }

    pub(crate) fn knots(&self) -> &[Knot] {
        &self.knots
    }

    pub(crate) fn elements(&self) -> &[Element] {
        &self.elements
    }

    /// Knots where hats begin, 1, or end, −1, instead of going on.
    pub(crate) fn ends(&self) -> Vec<(usize, f64)> {
        let mut signs = vec![0.0; self.knots.len()];
        for element in &self.elements {
            signs[element.knots[0]] += 1.0;
            signs[element.knots[1]] -= 1.0;
        }
        let all = signs.into_iter().enumerate();
        all.filter(|(_, sign)| *sign != 0.0).collect()
    }

    pub(crate) fn step(&self) -> Option<f64> {
        self.step
    }

    /// Means of e^{iKθ} over the whole hats of the nodes, n.
    pub(crate) fn mode_means(&self, order: i64) -> Vec<Complex<f64>> {
        let k = order as f64;
        let phase = |angle: f64| Complex::from_polar(1.0, k * angle);
        if let Some(step) = self.step {
            let half = 0.5 * k * step;
            let part = if half == 0.0 { 1.0 } else { half.sin() / half };
            let own = self.angles.iter();
            return own.map(|&angle| phase(angle) * (part * part)).collect();
        }
        let mut sums = vec![Complex::new(0.0, 0.0); self.len()];
        for part in &self.elements {
            let [first, second] = half_hats(k * part.length);
            let start = phase(part.start) * part.length;
            for (knot, value) in part.knots.into_iter().zip([first, second]) {
                if knot < self.len() {
                    sums[knot] += start * value;
                }
            }
        }
        for (sum, knot) in sums.iter_mut().zip(&self.knots) {
            *sum /= knot.weight;
        }
        sums
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn means_of_modes_are_integrals_over_hats() {
        let graded = vec![0.0, 1e-4, 0.05, 0.3, 0.9, 1.6, 2.3, 2.8, PI];
        for nodes in [
            Nodes::uniform_half(17).unwrap(),
            Nodes::mirrored(graded.clone()).unwrap(),
            Nodes::arc(graded).unwrap(),
        ] {
            for order in [-6, -1, 0, 1, 2, 5] {
                let k = order as f64;
                let [real, imaginary] =
                    [f64::cos, f64::sin].map(|f| nodes.mean(|angle| f(k * angle)));
                for (node, mean) in nodes.mode_means(order).into_iter().enumerate() {
                    // 8 points per element of Kh = 4.2.
                    assert!((mean.re - real[node]).abs() < 1e-8, "{order} {node}");
                    if !nodes.on_axis(node) {
                        assert!((mean.im - imaginary[node]).abs() < 1e-8);
                    }
                }
            }
        }
    }

    #[test]
    fn even_nodes_and_others_agree() {
        let even = Nodes::uniform_half(31).unwrap();
        let mut other = even.clone();
        other.step = None;
        for order in [-3, 0, 1, 40] {
            let pairs = even.mode_means(order).into_iter();
            for (a, b) in pairs.zip(other.mode_means(order)) {
                assert!((a - b).norm() < 1e-13);
            }
        }
        assert!((even.weights().iter().sum::<f64>() - PI).abs() < 1e-14);
    }

    #[test]
    fn nodes_that_no_hats_stand_on_are_refused() {
        let error = Nodes::circle(vec![0.0, 1.0]).unwrap_err();
        let apart = SeriesError::Spacing {
            node: 0,
            spacing: 1.0,
        };
        assert_eq!(error, apart);
        assert_eq!(
            error.to_string(),
            "nodes 1 and 2 are 1 rad apart: 1e-7 to 0.785 are possible"
        );
        assert!(matches!(
            Nodes::arc(vec![0.0, f64::NAN]),
            Err(SeriesError::Angle { angle }) if angle.is_nan()
        ));
        let angle = Nodes::mirrored(vec![-0.1, 0.1]).unwrap_err();
        assert_eq!(angle, SeriesError::Angle { angle: -0.1 });
        let one = Nodes::arc(vec![0.0]).unwrap_err();
        assert_eq!(one.to_string(), "1 node; at least 2 are needed");
        assert!(Nodes::arc(vec![0.0, 0.0]).is_err());
        assert!(Nodes::circle(vec![0.0, 0.5, 1.0, 1.5]).is_err());
    }
}
