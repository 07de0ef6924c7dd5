//! Kinks of a piecewise linear traction, and its modes.

use std::f64::consts::TAU;

use nalgebra::Complex;

use crate::nodes::{Knot, Nodes};

type C64 = Complex<f64>;

/// Where the slope of the traction, or the traction itself, jumps.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Kink {
    /// θ.
    pub(super) angle: f64,
    /// D and j over 2π.
    pub(super) slope: C64,
    pub(super) jump: C64,
}

impl Kink {
    /// The kinks at all knots of `nodes` under the tractions `values` of the knots.
    pub(super) fn all(nodes: &Nodes, values: &[C64]) -> Vec<Self> {
        let zero = C64::new(0.0, 0.0);
        let kink = |knot: &Knot| Self {
            angle: knot.angle,
            slope: zero,
            jump: zero,
        };
        let mut kinks: Vec<Self> = nodes.knots().iter().map(kink).collect();
        for element in nodes.elements() {
            let [a, b] = element.knots;
            let slope = (values[b] - values[a]) / (element.length * TAU);
            kinks[a].slope += slope;
            kinks[b].slope -= slope;
        }
        for (knot, sign) in nodes.ends() {
            kinks[knot].jump = values[knot] * (sign / TAU);
        }
        kinks
    }
}

/// t_K of kinks, K ≥ 1.
pub(super) fn mode(kinks: &[Kink], order: u32) -> C64 {
    let (k, i) = (f64::from(order), C64::new(0.0, 1.0));
    let term = |kink: &Kink| {
        let phase = C64::from_polar(1.0, -k * kink.angle);
        (-kink.slope / (k * k) - i * kink.jump / k) * phase
    };
    kinks.iter().map(term).sum()
}
