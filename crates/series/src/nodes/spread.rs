//! Forces on other nodes of the same circle.

use std::f64::consts::TAU;

use super::Nodes;
use crate::gauss::rule;

impl Nodes {
    /// The forces on these nodes of the tractions that `forces`, x and y of each node in turn, are on `other` nodes of the same circle, in the unit of these: f_i = Σ_k f_k ∫ N_i N_k dθ / w_k.
    /// Their sum and, all around a circle, their moment are kept where both reach over the same arc; on the axis of a half model no node has a force along y.
    ///
    /// # Panics
    /// If `forces` are not those of as many nodes as `other` has.
    pub fn spread(&self, other: &Self, forces: &[f64]) -> Vec<f64> {
        assert_eq!(forces.len(), 2 * other.len(), "two components a node");
        let weights = other.weights();
        let mut spread = vec![0.0; 2 * self.len()];
        let points = rule(2);
        for ends in self.common_parts(other).windows(2) {
            let length = ends[1] - ends[0];
            for [x, weight] in &points {
                let angle = ends[0] + x * length;
                let (Some(own), Some(theirs)) = (self.hats(angle), other.hats(angle)) else {
                    continue;
                };
                for i in 0..2 {
                    let parts = theirs.map(|(k, value)| value * forces[2 * k + i] / weights[k]);
                    let traction = parts[0] + parts[1];
                    for (k, value) in own {
                        spread[2 * k + i] += weight * length * value * traction;
                    }
                }
            }
        }
        for node in (0..self.len()).filter(|&node| self.on_axis(node)) {
            spread[2 * node + 1] = 0.0;
        }
        if self.is_closed() {
            let lost = other.moment(forces) - self.moment(&spread);
            self.turn_by(&mut spread, lost);
        }
        spread
    }

    /// The moment of `forces` about the centre, in their unit times the radius.
    fn moment(&self, forces: &[f64]) -> f64 {
        let arms = self.places().into_iter().zip(forces.chunks_exact(2));
        arms.map(|([x, y], force)| x * force[1] - y * force[0])
            .sum()
    }

    /// Adds the moment `moment` to `forces` by an even traction along the circle, which has no resultant: the mean places differ by the square of the spacing from the circle.
    fn turn_by(&self, forces: &mut [f64], moment: f64) {
        let places = self.places();
        let weights = self.weights();
        let whole: f64 = (places.iter().zip(&weights))
            .map(|([x, y], weight)| weight * (x * x + y * y))
            .sum();
        for ((force, [x, y]), weight) in forces.chunks_exact_mut(2).zip(&places).zip(&weights) {
            force[0] -= weight * y * moment / whole;
            force[1] += weight * x * moment / whole;
        }
    }

    /// Ascending angles between which the hats of both are linear, from the first own one on.
    fn common_parts(&self, other: &Self) -> Vec<f64> {
        let first = self.angles[0];
        let within = |angle: &f64| {
            if self.mirrored {
                *angle
            } else {
                first + (angle - first).rem_euclid(TAU)
            }
        };
        let mut parts: Vec<f64> = self
            .angles
            .iter()
            .chain(&other.angles)
            .map(within)
            .collect();
        parts.sort_by(f64::total_cmp);
        if self.is_closed() {
            parts.push(first + TAU);
        }
        parts
    }

    /// Whether hats go all around.
    fn is_closed(&self) -> bool {
        !self.mirrored && self.elements.len() == self.angles.len()
    }

    /// The two nodes between which `angle` lies, with the values of their hats.
    fn hats(&self, angle: f64) -> Option<[(usize, f64); 2]> {
        let (first, last) = (self.angles[0], self.len() - 1);
        let at = if self.mirrored {
            angle
        } else {
            first + (angle - first).rem_euclid(TAU)
        };
        let after = self.angles.partition_point(|own| *own <= at);
        let [from, to] = match after {
            0 => return None,
            after if after <= last => [after - 1, after],
            _ if self.is_closed() => [last, 0],
            _ => return None,
        };
        let width = (self.angles[to] - self.angles[from]).rem_euclid(TAU);
        let part = (at - self.angles[from]) / width;
        Some([(from, 1.0 - part), (to, part)])
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use super::*;

    fn sum(forces: &[f64], i: usize) -> f64 {
        forces.iter().skip(i).step_by(2).sum()
    }

    fn forces(nodes: &Nodes, traction: impl Fn(f64) -> [f64; 2]) -> Vec<f64> {
        let all = nodes.angles().iter().zip(nodes.weights());
        all.flat_map(|(&angle, weight)| traction(angle).map(|own| weight * own))
            .collect()
    }

    /// Nodes all around that are unequally far, shifted against each other.
    fn around(shift: f64) -> Nodes {
        let angle = |k: usize| TAU * (k as f64 / 90.0) - 3.0;
        let angles = (0..90).map(|k| shift + angle(k) + 0.3 * (2.0 * angle(k)).sin() / 10.0);
        Nodes::circle(angles.collect()).unwrap()
    }

    #[test]
    fn a_uniform_traction_stays_uniform_and_no_force_is_lost() {
        let (own, other) = (around(0.0), around(0.05));
        let uniform = forces(&other, |_| [2.0, -1.0]);
        let expected = forces(&own, |_| [2.0, -1.0]);
        let found = own.spread(&other, &uniform);
        assert!((found.iter().zip(&expected)).all(|(a, b)| (a - b).abs() < 1e-14));
        let rough: Vec<f64> = (0..180).map(|k| f64::from(k * k % 17)).collect();
        let spread = own.spread(&other, &rough);
        for i in 0..2 {
            assert!((sum(&spread, i) - sum(&rough, i)).abs() < 1e-12 * sum(&rough, i));
        }
        let [found, given] = [own.moment(&spread), other.moment(&rough)];
        assert!(
            (found - given).abs() < 1e-12 * sum(&rough, 0),
            "{found} {given}"
        );
    }

    /// The error of a smooth traction falls with the square of the spacing.
    #[test]
    fn a_smooth_traction_is_kept() {
        let half = |count: usize, shift: f64| {
            let angle = |k: usize| PI * k as f64 / count as f64;
            let angles = (0..=count).map(|k| angle(k) + shift * angle(k).sin());
            Nodes::mirrored(angles.collect()).unwrap()
        };
        let apart = |count: usize| {
            let (own, other) = (half(count, 0.0), half(count, 0.02));
            let traction = |angle: f64| [(3.0 * angle).cos(), (2.0 * angle).sin()];
            let found = own.spread(&other, &forces(&other, traction));
            let expected = forces(&own, traction);
            let both = found.iter().zip(&expected);
            let largest = both.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            largest * count as f64
        };
        let ratio = apart(40) / apart(80);
        assert!((3.5..4.5).contains(&ratio), "{ratio}");
    }
}
