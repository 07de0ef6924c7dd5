//! Where a place lies: on the path of which mode, and how far along it.

use stickslip_fem_core::mesh::Point;

use super::Hole;

/// Radii within which the angle decides.
const NEAR: f64 = 1.5;

impl Hole {
    /// A position in radii, first component towards the bearing point, second away from the bearing line.
    pub(super) fn local(&self, position: Point) -> [f64; 2] {
        let arm = [0, 1].map(|i| (position[i] - self.centre[i]) / self.radius);
        let [bx, by] = self.bearing;
        [arm[0] * bx + arm[1] * by, (arm[1] * bx - arm[0] * by).abs()]
    }

    /// How far along the path of a mode a place lies, from 0 at the hole to 1.
    pub(super) fn reach(&self, mode: usize, [ahead, aside]: [f64; 2]) -> f64 {
        let [end, side] = [self.end_distance, self.side_distance].map(|d| d / self.radius);
        let part = match mode {
            0 => (ahead - 1.0) / (end - 1.0),
            // The plug's sides start where shear-out does, at about 60°.
            1 => (ahead - 0.5) / (end - 0.5),
            _ => (aside - 1.0) / (side - 1.0),
        };
        part.clamp(0.0, 1.0)
    }
}

/// How much of a place belongs to each of [`JointMode::PURE`].
pub(super) fn zone_weights([ahead, aside]: [f64; 2]) -> [f64; 3] {
    if ahead.hypot(aside) <= NEAR {
        let angle = aside.atan2(ahead).to_degrees();
        let rise = |from: f64, to: f64| ((angle - from) / (to - from)).clamp(0.0, 1.0);
        let [shear, tension, behind] = [rise(35.0, 45.0), rise(75.0, 85.0), rise(105.0, 115.0)];
        return [1.0 - shear, shear - tension, tension - behind];
    }
    if ahead.abs() <= 0.5 * aside {
        return [0.0, 0.0, 1.0];
    }
    match (ahead > 0.0, aside) {
        (true, aside) if aside < 0.6 => [1.0, 0.0, 0.0],
        (true, aside) if aside <= 1.6 => [0.0, 1.0, 0.0],
        _ => [0.0; 3],
    }
}
