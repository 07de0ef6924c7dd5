//! Slopes of displacements along a line of fringe centres.

use stickslip_fem_core::mesh::Point;

use super::FringeLine;
use crate::moire::Grating;

/// Slope of a displacement along a line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slope {
    /// Middle between two fringe centres `[length]`.
    pub place: Point,
    /// Derivative of the displacement along the line `[1]`.
    pub value: f64,
}

impl FringeLine {
    /// Computes the slope `[1]` of the displacement along the line, (1/f) ΔN/Δs (Post & Reddy 1988, part I, Eqs 3–5), one value per step
    /// between neighbouring fringe centres.
    ///
    /// Along a line in x the slope of the U field is ε_x, along one in y that of the V field is ε_y; the other two slopes sum to
    /// γ_xy. The distance Δs is that along the line (an arc on a circle), and the value is second-order accurate at its place.
    pub fn slopes(&self, grating: &Grating) -> Vec<Slope> {
        self.steps()
            .map(|step| Slope {
                place: step.middle,
                value: (step.orders[1] - step.orders[0]) / (grating.frequency() * step.length),
            })
            .collect()
    }
}
