//! Walks along edges: places on them, names beside them, and arrows.

use stickslip_fem_core::mesh::Point;

/// Width of a letter, and distance of names from their edges `[px]`.
const LETTER: f64 = 7.0;
const AWAY: f64 = 11.0;
/// Height of a line of names, and size of a cross `[px]`.
const HEIGHT: f64 = 13.0;
const CROSS: [f64; 2] = [8.0; 2];

/// The name of a set inside its body beside the middle of its edge, of a closed one beside its top; none where the edge is shorter than its name.
pub(super) fn beside(places: &[Point], name: &str, per_pixel: f64) -> Option<(Point, String)> {
    let width = LETTER * name.chars().count() as f64 * per_pixel;
    let extent = |axis: usize| {
        let values = || places.iter().map(|place| place[axis]);
        values().fold(f64::NEG_INFINITY, f64::max) - values().fold(f64::INFINITY, f64::min)
    };
    if extent(0).max(extent(1)) < width {
        return None;
    }
    let closed = places.len() > 3 && places.first() == places.last();
    let (at, [x, y]) = if closed {
        let top = places
            .iter()
            .copied()
            .max_by(|a, b| a[1].total_cmp(&b[1]))?;
        let up = if turned(places) > 0.0 { -1.0 } else { 1.0 };
        (top, [0.0, up])
    } else {
        (*along(places, 3).get(1)?, inwards(places)?)
    };
    let shift = [
        x * (AWAY * per_pixel + 0.5 * width * x.abs()),
        y * AWAY * per_pixel,
    ];
    Some(([at[0] + shift[0], at[1] + shift[1]], name.to_owned()))
}

/// Drops names that would be written over one another or over `crosses`, the later ones of `texts`.
pub(super) fn keep_apart<'a>(
    texts: impl Iterator<Item = &'a mut Vec<(Point, String)>>,
    crosses: &[Point],
    per_pixel: f64,
) {
    let around = |at: Point, size: [f64; 2]| {
        let half = size.map(|pixels| 0.5 * pixels * per_pixel);
        [
            [0, 1].map(|k| at[k] - half[k]),
            [0, 1].map(|k| at[k] + half[k]),
        ]
    };
    let mut taken: Vec<[Point; 2]> = crosses.iter().map(|&at| around(at, CROSS)).collect();
    for texts in texts {
        texts.retain(|(at, name)| {
            let [low, high] = around(*at, [LETTER * name.chars().count() as f64, HEIGHT]);
            let meets =
                |[less, more]: &[Point; 2]| (0..2).all(|k| low[k] < more[k] && less[k] < high[k]);
            let is_free = !taken.iter().any(meets);
            if is_free {
                taken.push([low, high]);
            }
            is_free
        });
    }
}

/// Twice the area that a walk goes around, counter-clockwise positive.
fn turned(walk: &[Point]) -> f64 {
    let pairs = walk.windows(2);
    pairs
        .map(|pair| pair[0][0] * pair[1][1] - pair[0][1] * pair[1][0])
        .sum()
}

/// `count` places at equal distances along a walk, its ends included.
pub(super) fn along(walk: &[Point], count: usize) -> Vec<Point> {
    let mut lengths = vec![0.0];
    for pair in walk.windows(2) {
        let step = (pair[1][0] - pair[0][0]).hypot(pair[1][1] - pair[0][1]);
        lengths.push(lengths[lengths.len() - 1] + step);
    }
    let total = lengths[lengths.len() - 1];
    let place = |k: usize| {
        let wanted = total * k as f64 / (count - 1) as f64;
        let to = lengths.partition_point(|length| *length < wanted).max(1);
        let (from, to) = (to - 1, to.min(walk.len() - 1));
        let width = lengths[to] - lengths[from];
        let part = if width > 0.0 {
            (wanted - lengths[from]) / width
        } else {
            0.0
        };
        [0, 1].map(|axis| (1.0 - part) * walk[from][axis] + part * walk[to][axis])
    };
    if walk.len() < 2 {
        return walk.to_vec();
    }
    (0..count).map(place).collect()
}

fn unit([x, y]: Point) -> Option<Point> {
    let size = x.hypot(y);
    (size > 0.0).then(|| [x / size, y / size])
}

/// The unit normal into the body in the middle of a walk with the body on the left.
pub(super) fn inwards(places: &[Point]) -> Option<Point> {
    let middle = places.len() / 2;
    let (from, to) = (places.get(middle.checked_sub(1)?)?, places.get(middle)?);
    unit([from[1] - to[1], to[0] - from[0]])
}

pub(super) fn ahead(at: Point, [x, y]: Point, by: f64) -> Point {
    [at[0] + by * x, at[1] + by * y]
}

/// A shaft of `length` from `start`, and two strokes of its head.
pub(super) fn arrow(start: Point, direction: Point, length: f64) -> Vec<Vec<Point>> {
    let end = ahead(start, direction, length);
    let [x, y] = direction;
    let stroke = |side: f64| {
        let back = ahead(end, direction, -0.3 * length);
        vec![ahead(back, [-y * side, x * side], 0.15 * length), end]
    };
    vec![vec![start, end], stroke(1.0), stroke(-1.0)]
}
