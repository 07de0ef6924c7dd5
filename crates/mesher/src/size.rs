//! The size of cells: h(x) = min over sources of (h_s + g |x − x_s|), at most a cap.

use std::f64::consts::{FRAC_PI_3, PI};

use stickslip_fem_core::mesh::Point;

use crate::Division;
use crate::contour::Hole;
use crate::curve::{Track, gap};
use crate::outline::Outline;
use crate::ring::Ring;
use crate::vector::{NOWHERE, distance, grown, middle};

/// Cells across the narrower side of the body.
const ACROSS_BODY: f64 = 10.0;

/// Cells across a gap.
const ACROSS_GAP: f64 = 4.0;

/// Places along each piece of a cut-out at which the gap beside it is measured.
const WALL_SAMPLES: u8 = 16;

/// Cells across a gap between pieces that are no neighbours, seen from a corner.
const ACROSS_NECK: f64 = 3.0;

/// Size at a sharp or re-entrant corner over the shorter of its edges.
const CORNER_SHARE: f64 = 0.25;

/// Angle of an arc or a spline per cell `[rad]`.
const ARC_STEP: f64 = PI / 12.0;

/// Inner angles below this are sharp `[rad]`.
pub(crate) const SHARP: f64 = FRAC_PI_3 - 1e-6;

/// Inner angles above this are re-entrant `[rad]`.
const REENTRANT: f64 = PI + 0.15;

/// Points with sizes, near each other.
#[derive(Debug)]
struct Cluster {
    centre: Point,
    radius: f64,
    least: f64,
    points: Vec<(Point, f64)>,
}

/// The size function.
#[derive(Debug)]
pub(crate) struct Size {
    cap: f64,
    growth: f64,
    clusters: Vec<Cluster>,
    tracks: Vec<(Track, f64)>,
}

impl Size {
    /// The sources of a checked contour.
    pub(crate) fn new(
        holes: &[Hole],
        division: &Division,
        outline: &Outline,
        rings: &[Ring],
    ) -> Self {
        let [low, high] = outline.bounds;
        let narrow = (high[0] - low[0]).min(high[1] - low[1]);
        let fineness = division.fineness;
        let usual = narrow / (fineness * ACROSS_BODY);
        let cap = division.spacing.unwrap_or(usual);
        let tracks = outline.numbers.iter().zip(&outline.tracks);
        let tracks = tracks
            .map(|(piece, track)| {
                let arc = track.radius().map(|radius| ARC_STEP * radius);
                let own = arc.map_or(track.length(), |arc| arc.min(track.length()));
                let refined = division.refined.get(piece).map(|times| cap / times);
                let sizes = [Some(own / fineness), refined].into_iter().flatten();
                (track.clone(), sizes.fold(f64::INFINITY, f64::min))
            })
            .filter(|&(_, size)| size < cap)
            .collect();
        let corners = (0..outline.tracks.len()).flat_map(|k| corner(outline, k));
        let bends = outline.tracks.iter().filter_map(bends);
        let drawn = corners.chain(bends).chain([walls(outline)]).map(|own| {
            let sizes = own.into_iter().map(|(at, size)| (at, size / fineness));
            sizes.filter(|&(_, size)| size < cap).collect()
        });
        let given = rings.iter().map(around);
        let given = given.chain(gaps(holes, outline, rings, fineness));
        let sources: Vec<Vec<(Point, f64)>> = drawn.chain(given).collect();
        Self {
            cap,
            growth: division.growth / fineness,
            clusters: (sources.into_iter().filter(|own| !own.is_empty()))
                .map(Cluster::new)
                .collect(),
            tracks,
        }
    }

    /// The largest size `[length]`.
    pub(crate) fn cap(&self) -> f64 {
        self.cap
    }

    /// Adds sources of one size.
    pub(crate) fn add(&mut self, points: &[Point], size: f64) {
        let points = points.iter().map(|&point| (point, size)).collect();
        self.clusters.push(Cluster::new(points));
    }

    /// Size at a point `[length]`.
    pub(crate) fn at(&self, point: Point) -> f64 {
        let mut size = self.cap;
        for (track, least) in &self.tracks {
            if *least < size {
                size = size.min(least + self.growth * track.distance(point));
            }
        }
        for cluster in &self.clusters {
            let away = (distance(cluster.centre, point) - cluster.radius).max(0.0);
            if cluster.least + self.growth * away >= size {
                continue;
            }
            for &(source, least) in &cluster.points {
                size = size.min(least + self.growth * distance(source, point));
            }
        }
        size
    }
}

impl Cluster {
    fn new(points: Vec<(Point, f64)>) -> Self {
        let [low, high] = points.iter().fold(NOWHERE, |all, &(p, _)| grown(all, p));
        let centre = middle(low, high);
        let reach = points.iter().map(|&(p, _)| distance(p, centre));
        Self {
            centre,
            radius: reach.fold(0.0, f64::max),
            least: points.iter().map(|p| p.1).fold(f64::INFINITY, f64::min),
            points,
        }
    }
}

/// The outermost nodes around a hole with the mean lengths of their edges.
fn around(ring: &Ring) -> Vec<(Point, f64)> {
    let row = ring.outer();
    let count = row.len();
    let chord = |k: usize| distance(row[k % count], row[(k + 1) % count]);
    (0..count)
        .map(|k| (row[k], f64::midpoint(chord(k), chord(k + count - 1))))
        .collect()
}

/// The sources of the corner where piece `k` begins.
fn corner(outline: &Outline, k: usize) -> Vec<Vec<(Point, f64)>> {
    let (before, after) = (&outline.tracks[outline.before(k)], &outline.tracks[k]);
    let angle = outline.angle(k);
    let at = after.from;
    let mut sources = Vec::new();
    if !(SHARP..=REENTRANT).contains(&angle) {
        let shorter = before.length().min(after.length());
        sources.push((at, CORNER_SHARE * shorter));
    }
    let others = outline.tracks.iter().enumerate();
    let others = others.filter(|&(other, _)| other != k && other != outline.before(k));
    let necks = others.map(|(_, track)| track.distance(at) / ACROSS_NECK);
    sources.push((at, necks.fold(f64::INFINITY, f64::min)));
    sources.into_iter().map(|source| vec![source]).collect()
}

/// Sources along a spline, by its curvature.
fn bends(track: &Track) -> Option<Vec<(Point, f64)>> {
    let radii = track.run()?.radii();
    Some(radii.map(|(at, radius)| (at, ARC_STEP * radius)).collect())
}

/// Sources in the gaps between each hole and what is nearest to it, with cells so many times smaller than usual.
fn gaps(
    holes: &[Hole],
    outline: &Outline,
    rings: &[Ring],
    fineness: f64,
) -> impl Iterator<Item = Vec<(Point, f64)>> {
    let across = fineness * ACROSS_GAP;
    rings.iter().enumerate().map(move |(k, ring)| {
        let hole_nodes = &ring.rows[0];
        let count = hole_nodes.len();
        let points = (0..count).filter_map(|n| {
            let point = hole_nodes[n];
            let chord = distance(point, hole_nodes[(n + 1) % count]);
            let pieces = outline.tracks.iter().map(|track| gap(track, point));
            let others = holes.iter().enumerate();
            let holes = others.filter(|&(other, _)| other != k).map(|(_, other)| {
                let reach = distance(point, other.centre);
                let t = other.radius / reach;
                let near = [0, 1].map(|c| other.centre[c] + t * (point[c] - other.centre[c]));
                (middle(near, point), reach - other.radius)
            });
            let (at, width) = pieces.chain(holes).min_by(|a, b| a.1.total_cmp(&b.1))?;
            // Edges on the hole are given: cells much smaller than them beside them are flat.
            let size = (width / across).max(chord / 2.0);
            (width < 2.0 * across * chord).then_some((at, size))
        });
        points.collect()
    })
}

/// Sources between each cut-out and the nearest piece of the outline or of another one.
fn walls(outline: &Outline) -> Vec<(Point, f64)> {
    let mut points = Vec::new();
    for (own, pieces) in outline.loops.iter().enumerate().skip(1) {
        let others = (0..outline.tracks.len()).filter(|&other| outline.loop_of(other) != own);
        let others: Vec<&Track> = others.map(|other| &outline.tracks[other]).collect();
        for track in &outline.tracks[pieces.clone()] {
            for k in 0..WALL_SAMPLES {
                let part = (f64::from(k) + 0.5) / f64::from(WALL_SAMPLES);
                let point = track.at(part * track.length());
                let gaps = others.iter().map(|other| gap(other, point));
                let nearest = gaps.min_by(|a, b| a.1.total_cmp(&b.1));
                points.extend(nearest.map(|(at, width)| (at, width / ACROSS_GAP)));
            }
        }
    }
    points
}
