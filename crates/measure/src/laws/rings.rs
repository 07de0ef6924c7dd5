//! Data near the edge, gathered by angle: what one law leaves unexplained there is systematic, and shows in the means.

use super::LawStage;
use stickslip_experiment::Hole;

/// Data nearer to the edge than this part of its radius are gathered.
const REACH: f64 = 0.3;
/// Angles that are gathered together `[deg]`.
const WIDTH: f64 = 5.0;
const BINS: usize = 72;

/// Means of one component of one state near the edge.
#[derive(Clone, Debug, PartialEq)]
pub struct Ring {
    /// Middle of each bin with data `[deg]`, ascending from −180.
    pub angle: Vec<f64>,
    /// Mean of the measured displacements less the fitted rigid motion's place in them `[mm]`.
    pub measured: Vec<f64>,
    /// Mean of the predicted ones `[mm]`, per law.
    pub predicted: Vec<Vec<f64>>,
}

impl Ring {
    /// The means of component `axis` in observation `observation`; the places of `hole` give the angles.
    pub fn of(stage: &LawStage, hole: Hole, observation: usize, axis: usize) -> Self {
        let own = &stage.observations[observation];
        let laws = stage.comparison.fits.len();
        let mut sums = vec![vec![0.0; laws + 1]; BINS];
        let mut counts = vec![0.0; BINS];
        for (datum, &(_, component)) in own.components.iter().enumerate() {
            let place = stage.place(observation, datum);
            let [x, y] = [place[0] - hole.centre[0], place[1] - hole.centre[1]];
            if component != axis || x.hypot(y) > (1.0 + REACH) * hole.radius {
                continue;
            }
            let turned = y.atan2(x).to_degrees() + 180.0;
            let bin = ((turned / WIDTH) as usize).min(BINS - 1);
            counts[bin] += 1.0;
            sums[bin][laws] += own.values[datum];
            for (law, fit) in stage.comparison.fits.iter().enumerate() {
                sums[bin][law] += fit.states[observation].predicted[datum];
            }
        }
        let mut ring = Self {
            angle: Vec::new(),
            measured: Vec::new(),
            predicted: vec![Vec::new(); laws],
        };
        for (bin, (sum, count)) in sums.iter().zip(counts).enumerate() {
            if count > 0.0 {
                ring.angle.push((bin as f64 + 0.5) * WIDTH - 180.0);
                ring.measured.push(sum[laws] / count);
                for (law, values) in ring.predicted.iter_mut().enumerate() {
                    values.push(sum[law] / count);
                }
            }
        }
        ring
    }
}
