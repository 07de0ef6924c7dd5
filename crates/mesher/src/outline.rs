//! The exact outline of a body.

use std::f64::consts::PI;
use std::ops::Range;

use stickslip_fem_core::mesh::Point;

use crate::curve::Track;
use crate::vector::{cross, dot, grown};

/// A closed outline and the cut-outs in it, with the body on the left of all of them.
#[derive(Clone, Debug)]
pub(crate) struct Outline {
    pub(crate) names: Vec<String>,
    pub(crate) tracks: Vec<Track>,
    /// Number of each track's piece as the contour lists them, those of the outline first.
    pub(crate) numbers: Vec<usize>,
    /// The tracks of the outline, then those of each cut-out.
    pub(crate) loops: Vec<Range<usize>>,
    pub(crate) bounds: [Point; 2],
    /// Distance below which points coincide `[length]`.
    pub(crate) tolerance: f64,
}

impl Outline {
    /// Nothing yet, in a box.
    pub(crate) fn within(bounds: [Point; 2], tolerance: f64) -> Self {
        Self {
            names: Vec::new(),
            tracks: Vec::new(),
            numbers: Vec::new(),
            loops: Vec::new(),
            bounds,
            tolerance,
        }
    }

    /// Adds a loop of named tracks, each beginning where the one before ends, the first where the last does; a cut-out is walked the other way.
    pub(crate) fn add(&mut self, mut own: Vec<(String, Track)>) {
        let first = self.tracks.len();
        let mut numbers: Vec<usize> = (first..first + own.len()).collect();
        if first > 0 {
            own.reverse();
            numbers.reverse();
            for (_, track) in &mut own {
                track.reverse();
            }
        }
        self.loops.push(first..first + own.len());
        self.numbers.extend(numbers);
        let (names, tracks): (Vec<_>, Vec<_>) = own.into_iter().unzip();
        self.names.extend(names);
        self.tracks.extend(tracks);
    }

    /// Turned about the origin, so that what lay along x lies along `direction`.
    pub(crate) fn turned(&self, direction: Point) -> Self {
        if direction == [1.0, 0.0] {
            return self.clone();
        }
        let tracks = self.tracks.iter().map(|track| track.turned(direction));
        let tracks: Vec<Track> = tracks.collect();
        Self {
            bounds: bounds(&tracks),
            tracks,
            ..self.clone()
        }
    }

    /// Index of the loop of piece `k`.
    pub(crate) fn loop_of(&self, k: usize) -> usize {
        self.loops.partition_point(|own| own.end <= k)
    }

    /// Index of the piece before `k`.
    pub(crate) fn before(&self, k: usize) -> usize {
        let own = &self.loops[self.loop_of(k)];
        if k == own.start { own.end - 1 } else { k - 1 }
    }

    /// Signed area inside the loop `own` `[length²]`, of a cut-out negative.
    pub(crate) fn area(&self, own: usize) -> f64 {
        let origin = self.bounds[0];
        let tracks = &self.tracks[self.loops[own].clone()];
        tracks.iter().map(|track| track.area(origin)).sum()
    }

    /// Angle inside the body where piece `k` begins `[rad]`.
    pub(crate) fn angle(&self, k: usize) -> f64 {
        let arrives = self.tracks[self.before(k)].tangents()[1];
        let leaves = self.tracks[k].tangents()[0];
        PI - cross(arrives, leaves).atan2(dot(arrives, leaves))
    }

    /// Whether a point that is on no track lies in the body, holes apart.
    pub(crate) fn contains(&self, point: Point) -> bool {
        winding(&self.tracks, point) > PI
    }

    /// Whether a point that is not on the loop `own` lies inside it.
    pub(crate) fn is_within(&self, own: usize, point: Point) -> bool {
        winding(&self.tracks[self.loops[own].clone()], point).abs() > PI
    }

    /// Distance to the nearest track `[length]`.
    pub(crate) fn distance(&self, point: Point) -> f64 {
        let distances = self.tracks.iter().map(|track| track.distance(point));
        distances.fold(f64::INFINITY, f64::min)
    }
}

/// Box around tracks.
pub(crate) fn bounds(tracks: &[Track]) -> [Point; 2] {
    let all = tracks.iter().map(Track::bounds);
    let all = all.reduce(|all, [low, high]| grown(grown(all, low), high));
    all.unwrap_or_default()
}

/// Angle by which the direction from `point` turns along all of `tracks` `[rad]`.
fn winding(tracks: &[Track], point: Point) -> f64 {
    tracks.iter().map(|track| track.winding(point)).sum()
}
