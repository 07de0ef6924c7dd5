//! Hypotheses on stresses at a distance from the hole.
//!
//! ```text
//! point stress           failure when a ply fails at (R + R_t, ±90°): net tension, or at (R + R_c, 0°): bearing
//! characteristic curve   failure when a ply fails on  r_c(θ) = R + R_t + (R_c − R_t) cos θ,  −90° ≤ θ ≤ 90°
//!                        mode by the place: |θ| ≤ 15° bearing, 30° to 60° shear-out, 75° to 90° net tension, between them mixed
//! ```
//!
//! Stresses at the edge itself are too local to break a joint; R_t and R_c are material constants, measured on notched and bolted
//! coupons. θ counts from the bearing point here. Sources: Whitney & Nuismer, J. Compos. Mater. 8 (1974) 253, for the point; Chang, Scott & Springer, J. Compos.
//! Mater. 16 (1982) 470, for the curve and its modes.

use std::f64::consts::FRAC_PI_2;

use stickslip_fem_core::mesh::Point;

use crate::results::{ContactFrame, JointMode};
use stickslip_scene::schema::Characteristic;

/// Steps of the curve from one end to the bearing point.
const INTERVALS: u16 = 90;

/// The hole that distances are measured from.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Region {
    pub(crate) centre: Point,
    pub(crate) radius: f64,
}

impl Region {
    fn at(&self, radius: f64, theta: f64) -> Point {
        let (s, c) = theta.sin_cos();
        [self.centre[0] + radius * c, self.centre[1] + radius * s]
    }
}

/// Angles from the bearing point `[rad]` and places of the characteristic curve, one per degree, from −90° or, of a half model, from
/// 0° to 90° or −90°, on the modelled side. The first or middle one is the bearing point, the last one the net section.
pub(crate) fn curve(
    hole: Region,
    distances: Characteristic,
    half: bool,
    frame: ContactFrame,
) -> Vec<(f64, Point)> {
    let Characteristic {
        tension,
        compression,
    } = distances;
    let first = if half { 0 } else { -i32::from(INTERVALS) };
    let bearing = frame.bearing.unwrap_or(0.0);
    let side = if half && bearing.abs() > FRAC_PI_2 {
        -1.0
    } else {
        1.0
    };
    (first..=i32::from(INTERVALS))
        .map(|k| {
            let theta = side * FRAC_PI_2 * f64::from(k) / f64::from(INTERVALS);
            // cos 90° is zero, which the end of the curve must not miss by rounding.
            let cosine = if k.abs() == i32::from(INTERVALS) {
                0.0
            } else {
                theta.cos()
            };
            let distance = tension + (compression - tension) * cosine;
            (theta, hole.at(hole.radius + distance, bearing + theta))
        })
        .collect()
}

/// The mode of a joint that fails at the angle `theta` `[rad]` of its characteristic curve.
pub(crate) fn joint_mode(theta: f64) -> JointMode {
    // Places are whole degrees; half of one keeps the bounds on their own side.
    let degrees = theta.to_degrees().abs().round();
    match degrees {
        ..=15.0 => JointMode::Bearing,
        ..30.0 => JointMode::BearingAndShearOut,
        ..=60.0 => JointMode::ShearOut,
        ..75.0 => JointMode::ShearOutAndNetTension,
        _ => JointMode::NetTension,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_curve_starts_at_the_bearing_point_and_ends_at_the_net_section() {
        let hole = Region {
            centre: [1.0, 0.0],
            radius: 5.0,
        };
        let distances = Characteristic {
            tension: 0.5,
            compression: 2.0,
        };
        let places = curve(hole, distances, true, ContactFrame::NONE);
        assert_eq!(places.len(), 91);
        assert_eq!(places[0].1, [1.0 + 7.0, 0.0]);
        let [x, y] = places[90].1;
        // One rounding of cos 90°.
        assert!((x - 1.0).abs() < 1e-14 && (y - 5.5).abs() < 1e-14);
        // 60° is where the cosine is one half.
        let [x, y] = places[60].1;
        assert!(((x - 1.0).hypot(y) - 6.25).abs() < 1e-12);
        let whole = curve(hole, distances, false, ContactFrame::NONE);
        assert_eq!(whole.len(), 181);
        assert_eq!(whole[90].1, places[0].1);
    }

    #[test]
    fn the_curve_turns_with_the_bearing_point() {
        let hole = Region {
            centre: [0.0, 0.0],
            radius: 5.0,
        };
        let distances = Characteristic {
            tension: 0.5,
            compression: 2.0,
        };
        let bearing_at = |degrees: f64| ContactFrame {
            bearing: Some(degrees.to_radians()),
            ..ContactFrame::NONE
        };
        let near = |[x, y]: Point, to: Point| {
            assert!((x - to[0]).hypot(y - to[1]) < 1e-13, "{x} {y} {to:?}");
        };
        let up = curve(hole, distances, false, bearing_at(90.0));
        near(up[90].1, [0.0, 7.0]);
        near(up[180].1, [-5.5, 0.0]);
        // A half model has y ≥ 0: the net section beside a bearing point at 180° is at −90° from it.
        let back = curve(hole, distances, true, bearing_at(180.0));
        near(back[0].1, [-7.0, 0.0]);
        near(back[90].1, [0.0, 5.5]);
        assert_eq!(back[90].0, -FRAC_PI_2);
    }

    #[test]
    fn modes_by_angle() {
        let modes = [
            (0.0, JointMode::Bearing),
            (-15.0, JointMode::Bearing),
            (16.0, JointMode::BearingAndShearOut),
            (30.0, JointMode::ShearOut),
            (-60.0, JointMode::ShearOut),
            (61.0, JointMode::ShearOutAndNetTension),
            (75.0, JointMode::NetTension),
            (-90.0, JointMode::NetTension),
        ];
        for (degrees, mode) in modes {
            assert_eq!(joint_mode(f64::to_radians(degrees)), mode, "{degrees}");
        }
    }
}
