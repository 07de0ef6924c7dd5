//! The origin from which places on an edge are measured: its bearing point.
//!
//! ```text
//! circle   θ    counter-clockwise from +x about the circle's centre
//!          θ_b  direction of the contact force on the first body in the step in which that force is largest
//!          φ = θ − θ_b, in (−π, π]
//! line     x, whatever the bearing point x_b = ∫p x dA / ∫p dA, the centre of pressure
//! ```
//!
//! Half of a symmetric circle that bears at θ_b = π is read clockwise, φ = π − θ, which is its mirror image: the signs of shear and slip
//! turn with it.

use std::f64::consts::{PI, TAU};

/// Angles `[rad]` up to this are rounding.
const ROUNDING: f64 = 1e-9;

/// The frame that the places of an edge are measured in.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactFrame {
    /// Place of the bearing point as in [`EdgeGeometry::parameter`](super::EdgeGeometry::parameter): θ_b `[rad]` or x_b `[mm]`; `None`
    /// where nothing bears, and angles are counted from +x.
    pub bearing: Option<f64>,
    /// How it was found.
    pub found: BearingSource,
    /// Whether angles along a modelled half ascend clockwise.
    pub clockwise: bool,
}

/// How a bearing point was found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BearingSource {
    /// Nothing bears: no force, or pressures that balance each other.
    Nowhere,
    /// From the contact force in this load step, counted from 0, in which it is largest.
    Contact {
        /// The step.
        step: usize,
    },
    /// From the direction of a bearing load of the scene.
    Load,
}

impl ContactFrame {
    /// The frame of an edge on which nothing bears.
    pub const NONE: Self = Self {
        bearing: None,
        found: BearingSource::Nowhere,
        clockwise: false,
    };

    /// What an angle from here is called: φ from a bearing point, θ from +x.
    pub const fn symbol(&self) -> &'static str {
        if self.bearing.is_some() { "φ" } else { "θ" }
    }

    /// The angle φ `[rad]` of a place at the angle `theta` `[rad]` from +x.
    pub fn angle(&self, theta: f64) -> f64 {
        if self.clockwise {
            wrapped(self.bearing.unwrap_or(0.0) - theta)
        } else {
            self.turned(theta)
        }
    }

    /// The same `[rad]`, counter-clockwise also where a half is read clockwise.
    pub fn turned(&self, theta: f64) -> f64 {
        wrapped(theta - self.bearing.unwrap_or(0.0))
    }

    /// φ of both ends of a zone of the whole circle `[rad]`; one across ±π starts before π and ends beyond it.
    pub fn range(&self, [start, end]: [f64; 2]) -> [f64; 2] {
        let from = self.turned(start);
        let from = if from > PI - ROUNDING {
            from - TAU
        } else {
            from
        };
        [from, end + (from - start)]
    }
}

/// `angle` `[rad]` in (−π, π]; what is rounding beside zero is zero.
pub fn wrapped(angle: f64) -> f64 {
    let turns = ((angle - PI - ROUNDING) / TAU).ceil();
    let within = angle - turns * TAU;
    if within.abs() < ROUNDING { 0.0 } else { within }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn frame(bearing: f64, clockwise: bool) -> ContactFrame {
        ContactFrame {
            bearing: Some(bearing),
            found: BearingSource::Load,
            clockwise,
        }
    }

    #[test]
    fn angles_count_from_the_bearing_point() {
        let close = |a: f64, b: f64| assert!((a - b).abs() < 1e-12, "{a} {b}");
        assert_eq!(frame(0.0, false).angle(0.3), 0.3);
        assert_eq!(frame(0.0, false).angle(-PI), PI);
        close(frame(3.0, false).angle(-3.0), TAU - 6.0);
        close(frame(PI, false).angle(PI - 0.2), -0.2);
        close(frame(PI, true).angle(PI - 0.2), 0.2);
        assert_eq!(frame(0.5, false).angle(0.5 + 1e-13), 0.0);
    }

    #[test]
    fn a_zone_keeps_its_length() {
        let close = |a: [f64; 2], b: [f64; 2]| {
            assert!(
                (a[0] - b[0]).abs() < 1e-12 && (a[1] - b[1]).abs() < 1e-12,
                "{a:?} {b:?}"
            );
        };
        assert_eq!(frame(0.0, false).range([-PI, 0.5]), [-PI, 0.5]);
        assert_eq!(frame(0.0, false).range([3.0, 3.5]), [3.0, 3.5]);
        close(frame(PI, true).range([3.0, 3.5]), [3.0 - PI, 3.5 - PI]);
        close(frame(-1.0, false).range([2.0, 2.5]), [3.0, 3.5]);
        close(frame(-2.0, false).range([2.0, 2.5]), [4.0 - TAU, 4.5 - TAU]);
    }
}
