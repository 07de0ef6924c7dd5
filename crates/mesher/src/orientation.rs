//! Directions along which a body may lie, whatever way it is drawn: those of its longest pieces, and halfway between two of them, where
//! the mirror of a body may be that none of them lies along.

use std::f64::consts::FRAC_PI_2;

use stickslip_fem_core::generate::unit_vector;
use stickslip_fem_core::mesh::Point;

use crate::outline::Outline;
use crate::vector::{distance, minus};

/// Part by which pieces are as long as the longest.
const AS_LONG: f64 = 1e-9;
/// Angle below which directions are one `[rad]`.
const SAME: f64 = 1e-9;
/// Sine below which a direction lies along an axis, but for rounding.
const ON_AXIS: f64 = 1e-13;
/// Most pieces that are compared in pairs: those of regular outlines lie along their mirrors or across.
const MOST_PAIRED: usize = 8;
/// Most directions that are tried: more are those of regular outlines, which look the same along each.
const MOST: usize = 16;

/// Unit vectors within 45° of x, one at least; right angles do not distinguish them.
pub(crate) fn directions(outline: &Outline) -> Vec<Point> {
    let tracks = outline.tracks[outline.loops[0].clone()].iter();
    let chords = tracks.map(|track| (distance(track.from, track.to), minus(track.to, track.from)));
    let chords: Vec<(f64, Point)> = chords.collect();
    let longest = chords.iter().map(|own| own.0).fold(0.0, f64::max);
    let long = chords
        .into_iter()
        .filter(|own| own.0 >= (1.0 - AS_LONG) * longest);
    let angles: Vec<f64> = long.map(|(_, [x, y])| y.atan2(x)).collect();
    let mut all = angles.clone();
    if angles.len() <= MOST_PAIRED {
        for (k, one) in angles.iter().enumerate() {
            all.extend(angles[..k].iter().map(|other| f64::midpoint(*one, *other)));
        }
    }
    let mut found: Vec<f64> = Vec::new();
    for angle in all.into_iter().map(within_half_a_right_angle) {
        let is_known = |own: &f64| within_half_a_right_angle(own - angle).abs() < SAME;
        if !found.iter().any(is_known) {
            found.push(angle);
        }
    }
    found.into_iter().take(MOST).map(direction).collect()
}

fn direction(angle: f64) -> Point {
    let [cos, sin] = unit_vector(angle);
    if sin.abs() < ON_AXIS {
        [1.0, 0.0]
    } else {
        [cos, sin]
    }
}

/// An angle less right angles, from −45° to 45°.
fn within_half_a_right_angle(angle: f64) -> f64 {
    angle - FRAC_PI_2 * (angle / FRAC_PI_2).round()
}
