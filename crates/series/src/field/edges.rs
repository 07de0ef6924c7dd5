//! Stresses of many states at the same places of a circle.
//!
//! ```text
//! σ_rr + σ_θθ = −4 Re e^{−iθ} Σ_J [D_J Li_2(e^{±i(θ − θ_J)}) ± i j_J Li_1(e^{±i(θ − θ_J)})] + …     (+: disk, −: hole)
//! ```
//!
//! In an anisotropic plate −4 e^{−iθ} is −a, and −b conj D_J is added. The sum over the jumps of slope D_J is a product of a matrix of places and knots, which no state changes, with a matrix of knots and states. An image's
//! D is the conjugate of its own, so knots of a half model are enough. Of nodes with equal spacings Li_2 depends on differences alone.

use nalgebra::{Complex, DMatrix};

use super::hats::{Parts, mean, on_edge_of_jumps, wrapped};
use super::inside::Inside;
use super::kink::Kink;
use super::polylog::Polylogarithms;
use super::{PolarStress, values};
use crate::circle::Circle;
use crate::lekhnitskii::Planes;
use crate::nodes::Nodes;

type C64 = Complex<f64>;

/// Places that are treated together, so that their matrix stays in the processor's cache.
const TOGETHER: usize = 32;

/// Places on a circle.
pub(crate) struct Edge<'a> {
    pub(crate) nodes: &'a Nodes,
    pub(crate) circle: Circle,
    /// The body on it.
    pub(crate) of: EdgeOf<'a>,
    /// Angles `[rad]`.
    pub(crate) angles: &'a [f64],
}

/// What body has the circle.
#[derive(Clone, Copy)]
pub(crate) enum EdgeOf<'a> {
    /// A disk.
    Disk,
    /// A plate.
    Plate,
    /// An anisotropic plate.
    Planes(&'a Planes),
}

impl EdgeOf<'_> {
    /// Factors (a, b) of the sum over negative modes e^{−ikθ}, of a disk of that over positive modes, and of the conjugate of the other one, in σ_rr + σ_θθ.
    fn factors(self, direction: C64) -> [C64; 2] {
        match self {
            Self::Disk | Self::Plate => [4.0 * direction.conj(), C64::new(0.0, 0.0)],
            Self::Planes(planes) => planes.factors(direction),
        }
    }

    fn is_disk(self) -> bool {
        matches!(self, Self::Disk)
    }
}

/// Tractions of a state.
pub(crate) struct Load {
    values: Vec<C64>,
    kinks: Vec<Kink>,
    /// t_0.
    pub(crate) mean: C64,
}

impl Load {
    /// What is further needed of a disk under these tractions, of symmetric ones if they are `mirrored`.
    pub(crate) fn inside(&self, mirrored: bool, centred: bool) -> Inside {
        Inside::of(self.mean, &self.kinks, mirrored, centred)
    }
}

impl Edge<'_> {
    /// The tractions by nodal forces `[force]`, 2n × states.
    pub(crate) fn loads(&self, forces: &DMatrix<f64>) -> Vec<Load> {
        let sign = if self.of.is_disk() { 1.0 } else { -1.0 };
        let load = |forces: &[f64]| {
            let values = values(self.nodes, self.circle, forces, sign);
            Load {
                kinks: Kink::all(self.nodes, &values),
                mean: mean(self.nodes, &values),
                values,
            }
        };
        (forces.column_iter())
            .map(|column| load(column.as_slice()))
            .collect()
    }

    /// e^{iθ} of the places.
    pub(crate) fn directions(&self) -> Vec<C64> {
        let angles = self.angles.iter();
        angles.map(|&angle| C64::from_polar(1.0, angle)).collect()
    }

    /// Stresses by state and place, of `loads` and of what adds `further` to σ_rr + σ_θθ, places × states.
    pub(crate) fn stresses(&self, loads: &[Load], further: &DMatrix<f64>) -> Vec<Vec<PolarStress>> {
        let sums = self.sums(loads);
        let parts = Parts::of(self.nodes);
        let directions = self.directions();
        let ends: Vec<usize> = self
            .nodes
            .ends()
            .into_iter()
            .map(|(knot, _)| knot)
            .collect();
        let side = usize::from(!self.of.is_disk());
        let of_state = |(state, load): (usize, &Load)| {
            let jumps: Vec<Kink> = ends.iter().map(|&knot| load.kinks[knot]).collect();
            let at = |(place, &theta): (usize, &f64)| {
                let inverse = directions[place].conj();
                let traction = parts.interpolated(&load.values, theta) * inverse;
                let [a, b] = self.of.factors(directions[place]);
                let mut of_jumps = on_edge_of_jumps(&jumps, theta, a)[side].re;
                if b != C64::new(0.0, 0.0) {
                    of_jumps += on_edge_of_jumps(&jumps, theta, b.conj())[1 - side].re;
                }
                let sum = sums[(state, place)] + of_jumps + further[(place, state)];
                PolarStress {
                    radial: traction.re,
                    hoop: sum - traction.re,
                    shear: traction.im,
                }
            };
            self.angles.iter().enumerate().map(at).collect()
        };
        loads.iter().enumerate().map(of_state).collect()
    }

    /// The parts of the jumps of slope in σ_rr + σ_θθ, states × places.
    fn sums(&self, loads: &[Load]) -> DMatrix<f64> {
        let count = self.nodes.len();
        let slopes = DMatrix::from_fn(loads.len(), 2 * count, |state, column| {
            let slope = loads[state].kinks[column / 2].slope;
            if column % 2 == 0 { slope.re } else { slope.im }
        });
        let kernel = Kernel::new(self);
        let mut sums = DMatrix::zeros(loads.len(), self.angles.len());
        let mut matrix = DMatrix::zeros(2 * count, TOGETHER);
        for (block, angles) in self.angles.chunks(TOGETHER).enumerate() {
            for (&theta, mut column) in angles.iter().zip(matrix.column_iter_mut()) {
                kernel.fill(theta, column.as_mut_slice());
            }
            let mut sums = sums.columns_mut(block * TOGETHER, angles.len());
            sums.gemm(1.0, &slopes, &matrix.columns(0, angles.len()), 0.0);
        }
        sums
    }
}

/// σ_rr + σ_θθ at a place by the jumps of slope, real and imaginary part of each, of the nodes.
struct Kernel<'a> {
    nodes: &'a Nodes,
    of: EdgeOf<'a>,
    polylogarithms: Polylogarithms,
    /// Li_2(e^{iα}) at differences of knots, in steps, where spacings are equal.
    even: Vec<C64>,
}

impl<'a> Kernel<'a> {
    fn new(edge: &Edge<'a>) -> Self {
        let polylogarithms = Polylogarithms::new();
        let count = edge.nodes.knots().len();
        let even = edge.nodes.step().map_or_else(Vec::new, |step| {
            let at = |k: usize| polylogarithms.second_on_circle(wrapped(k as f64 * step));
            (0..count).map(at).collect()
        });
        Self {
            nodes: edge.nodes,
            of: edge.of,
            even,
            polylogarithms,
        }
    }

    fn fill(&self, theta: f64, column: &mut [f64]) {
        let knots = self.nodes.knots();
        let [a, b] = self.of.factors(C64::from_polar(1.0, theta));
        let (along, across) = (-(a + b), C64::new(0.0, -1.0) * (a - b));
        let here = self.knot(theta);
        let at = |knot: usize| {
            let li = match here {
                // Knots are in the order of their angles.
                Some(here) => {
                    self.even[if here < knot {
                        here + knots.len() - knot
                    } else {
                        here - knot
                    }]
                }
                None => (self.polylogarithms).second_on_circle(wrapped(theta - knots[knot].angle)),
            };
            if self.of.is_disk() { li } else { li.conj() }
        };
        for (node, parts) in column.chunks_exact_mut(2).enumerate() {
            let own = at(node);
            parts[0] = (along * own).re;
            parts[1] = (across * own).re;
            let image = knots[node].image;
            if image != node {
                let other = at(image);
                parts[0] += (along * other).re;
                parts[1] -= (across * other).re;
            }
        }
    }

    /// The knot at `theta`, of knots with equal spacings.
    fn knot(&self, theta: f64) -> Option<usize> {
        const SAME: f64 = 1e-15;
        let (step, knots) = (self.nodes.step()?, self.nodes.knots());
        let steps = (theta - knots[0].angle) / step;
        let nearest = steps.round();
        let same = (steps - nearest).abs() * step < SAME * theta.abs().max(1.0);
        same.then(|| nearest.rem_euclid(knots.len() as f64) as usize)
    }
}
