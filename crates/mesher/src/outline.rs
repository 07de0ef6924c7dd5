//! The exact outline of a body.

use std::f64::consts::PI;

use stickslip_fem_core::mesh::Point;

use crate::curve::Track;
use crate::vector::{cross, dot};

/// A closed outline with the body on its left.
#[derive(Debug)]
pub(crate) struct Outline {
    pub(crate) names: Vec<String>,
    pub(crate) tracks: Vec<Track>,
    pub(crate) bounds: [Point; 2],
    /// Distance below which points coincide `[length]`.
    pub(crate) tolerance: f64,
}

impl Outline {
    /// At least two tracks, each beginning where the one before ends, the first where the last does.
    pub(crate) fn new(
        names: Vec<String>,
        tracks: Vec<Track>,
        bounds: [Point; 2],
        tolerance: f64,
    ) -> Self {
        Self {
            names,
            tracks,
            bounds,
            tolerance,
        }
    }

    /// Index of the piece before `k`.
    pub(crate) fn before(&self, k: usize) -> usize {
        let count = self.tracks.len();
        (k + count - 1) % count
    }

    /// Signed area `[length²]`.
    pub(crate) fn area(&self) -> f64 {
        let origin = self.bounds[0];
        self.tracks.iter().map(|track| track.area(origin)).sum()
    }

    /// Angle inside the body where piece `k` begins `[rad]`.
    pub(crate) fn angle(&self, k: usize) -> f64 {
        let arrives = self.tracks[self.before(k)].tangents()[1];
        let leaves = self.tracks[k].tangents()[0];
        PI - cross(arrives, leaves).atan2(dot(arrives, leaves))
    }

    /// Whether a point that is not on the outline lies inside.
    pub(crate) fn contains(&self, point: Point) -> bool {
        let winding: f64 = self.tracks.iter().map(|track| track.winding(point)).sum();
        winding > PI
    }

    /// Distance to the outline `[length]`.
    pub(crate) fn distance(&self, point: Point) -> f64 {
        let distances = self.tracks.iter().map(|track| track.distance(point));
        distances.fold(f64::INFINITY, f64::min)
    }
}
