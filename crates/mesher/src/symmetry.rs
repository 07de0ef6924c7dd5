//! Bodies that are their own mirror image are triangulated on one side and unfolded, so that their triangles are too.
//!
//! Mirrors are the axes of the frame; turns without a mirror are not looked for.

use std::collections::BTreeMap;
use std::f64::consts::{PI, TAU};

use stickslip_fem_core::mesh::Point;

use crate::curve::Track;
use crate::edges::{Link, Origin, Segment};
use crate::plan::Plan;
use crate::ring::Ring;
use crate::triangulate::Triangles;
use crate::vector::distance;

/// Distance below which a point of the unit frame lies on an axis.
const NEAR: f64 = 1e-9;

/// Least angle inside the body of a corner that a mirror halves `[rad]`: sharper ones would leave cells that are worse than unlike halves.
const LEAST_HALVED: f64 = 36.0 * PI / 180.0;

/// A mirror through the middle of the frame.
pub(crate) struct Mirror {
    /// The coordinate that changes its sign.
    across: usize,
    /// The mirror image of each track.
    tracks: Vec<usize>,
    /// The mirror image of each ring, and of its rays.
    rings: Vec<(usize, Vec<usize>)>,
}

impl Mirror {
    /// The mirrors of a body in its frame, with the chains that bound it on their positive sides.
    pub(crate) fn all(plan: &Plan, refined: &BTreeMap<usize, f64>) -> (Vec<Self>, Vec<Vec<Link>>) {
        let mut chains = Link::loops(plan);
        let mut mirrors = Vec::new();
        for across in [0, 1] {
            let found = Self::new(plan, refined, across).and_then(|mirror| {
                let half = half(plan, &chains, across)?;
                Some((mirror, half))
            });
            if let Some((mirror, half)) = found {
                mirrors.push(mirror);
                chains = half;
            }
        }
        (mirrors, chains)
    }

    fn new(plan: &Plan, refined: &BTreeMap<usize, f64>, across: usize) -> Option<Self> {
        let outline = &plan.outline;
        let is_halved = |k: &usize| outline.tracks[*k].from[across].abs() < NEAR;
        let mut halved = (0..outline.tracks.len()).filter(is_halved);
        if halved.any(|k| outline.angle(k) < LEAST_HALVED) {
            return None;
        }
        let shape = |track: &Track| [track.from, track.at(track.length() / 2.0), track.to];
        let shapes: Vec<[Point; 3]> = outline.tracks.iter().map(shape).collect();
        let image = |k: usize| {
            let [from, halfway, to] = shapes[k].map(|p| mirrored(p, across));
            let fine = |track: usize| refined.get(&outline.numbers[track]);
            let is_image = |own: &usize| {
                let points = shapes[*own].into_iter();
                let mut pairs = points.zip([to, halfway, from]);
                pairs.all(|(one, other)| distance(one, other) < NEAR)
                    && are_images([*own, k].map(|k| &outline.tracks[k]), across)
                    && fine(*own) == fine(k)
            };
            (0..outline.tracks.len()).find(is_image)
        };
        Some(Self {
            across,
            tracks: (0..outline.tracks.len())
                .map(image)
                .collect::<Option<_>>()?,
            rings: plan
                .rings
                .iter()
                .map(|ring| mirror_ring(&plan.rings, ring, across))
                .collect::<Option<_>>()?,
        })
    }

    /// Whether a point lies on the side that is a copy.
    pub(crate) fn copies(&self, point: Point) -> bool {
        point[self.across] < 0.0
    }

    /// Adds the other side to the triangles of the positive one.
    pub(crate) fn unfold(&self, half: Triangles, plan: &Plan) -> Triangles {
        let Triangles {
            mut points,
            mut cells,
            segments,
        } = half;
        let is_axis = |s: &&Segment| s.origin.is_axis(self.across);
        let mut image: Vec<Option<usize>> = vec![None; points.len()];
        for node in segments.iter().filter(is_axis).flat_map(|s| s.ends) {
            image[node] = Some(node);
        }
        let count = points.len();
        let mut image_of = Vec::with_capacity(count);
        for (node, own) in image.into_iter().enumerate() {
            image_of.push(own.unwrap_or_else(|| {
                points.push(mirrored(points[node], self.across));
                points.len() - 1
            }));
        }
        for k in 0..cells.len() {
            let [a, b, c] = cells[k].map(|node| image_of[node]);
            cells.push([a, c, b]);
        }
        let kept = segments.into_iter().filter(|s| !is_axis(&s));
        let both = kept.flat_map(|segment| {
            let [from, to] = segment.ends.map(|node| image_of[node]);
            let origin = self.origin(segment.origin, plan);
            let ends = [to, from];
            [segment, Segment { ends, origin }]
        });
        Triangles {
            points,
            cells,
            segments: both.collect(),
        }
    }

    fn origin(&self, origin: Origin, plan: &Plan) -> Origin {
        match origin {
            Origin::Piece {
                piece,
                from,
                to,
                open,
            } => {
                let length = plan.outline.tracks[piece].length();
                Origin::Piece {
                    piece: self.tracks[piece],
                    from: length - to,
                    to: length - from,
                    open,
                }
            }
            Origin::Ring { ring, ray } => {
                let (image, rays) = &self.rings[ring];
                Origin::Ring {
                    ring: *image,
                    ray: rays[(ray + 1) % rays.len()],
                }
            }
            axis @ Origin::Axis { .. } => axis,
        }
    }
}

fn mirrored(mut point: Point, across: usize) -> Point {
    // Adding zero leaves no negative one.
    point[across] = 0.0 - point[across];
    point
}

/// Whether both are splines and mirror images, each walked against the other, or neither is a spline.
fn are_images([one, other]: [&Track; 2], across: usize) -> bool {
    let points = |track: &Track| -> Vec<Point> {
        let parts = track.cubics();
        parts.flat_map(|own| own.0).collect()
    };
    let [one, other] = [points(one), points(other)];
    let pairs = one.iter().zip(other.iter().rev());
    one.len() == other.len()
        && pairs
            .into_iter()
            .all(|(own, at)| distance(*own, mirrored(*at, across)) < NEAR)
}

/// The mirror image of a ring among all, and of its rays.
fn mirror_ring(rings: &[Ring], ring: &Ring, across: usize) -> Option<(usize, Vec<usize>)> {
    let centre = mirrored(ring.centre, across);
    let same = |other: &Ring| {
        distance(other.centre, centre) < NEAR
            && (other.radius - ring.radius).abs() < NEAR
            && other.angles.len() == ring.angles.len()
            && other.rows.len() == ring.rows.len()
    };
    let image = rings.iter().position(same)?;
    let angles = &rings[image].angles;
    let ray = |&angle: &f64| {
        let wanted = if across == 0 { PI - angle } else { -angle };
        let away = |a: f64| {
            let turn = (a - wanted).rem_euclid(TAU);
            turn.min(TAU - turn)
        };
        let nearest =
            (0..angles.len()).min_by(|&a, &b| away(angles[a]).total_cmp(&away(angles[b])));
        nearest.filter(|&k| away(angles[k]) < NEAR)
    };
    let rays: Option<Vec<usize>> = ring.angles.iter().map(ray).collect();
    Some((image, rays?))
}

/// The chains around the part of a body on the positive side of an axis; none if the axis runs along an edge or between nodes of a ring.
fn half(plan: &Plan, loops: &[Vec<Link>], across: usize) -> Option<Vec<Vec<Link>>> {
    let mut whole = Vec::new();
    let mut chains: Vec<Vec<Link>> = Vec::new();
    for own in loops {
        let mut parts = Vec::new();
        for link in own {
            parts.extend(link.cut(plan, across)?);
        }
        let sides: Option<Vec<bool>> = parts.iter().map(|part| part.side(plan, across)).collect();
        let sides = sides?;
        let count = parts.len();
        let begins = |k: usize| sides[k] && !sides[(k + count - 1) % count];
        let Some(first) = (0..count).find(|&k| begins(k)) else {
            if sides.iter().all(|&side| side) {
                whole.push(parts);
            }
            continue;
        };
        for k in (first..first + count).map(|k| k % count) {
            if begins(k) {
                chains.push(Vec::new());
            }
            if let (true, Some(chain)) = (sides[k], chains.last_mut()) {
                chain.push(parts[k].clone());
            }
        }
    }
    whole.extend(joined(chains, across)?);
    Some(whole)
}

/// Chains between points of an axis, closed along it with the body on the left.
fn joined(chains: Vec<Vec<Link>>, across: usize) -> Option<Vec<Vec<Link>>> {
    let ahead = |point: Point| if across == 0 { -point[1] } else { point[0] };
    let begin = |chain: &Vec<Link>| ahead(chain[0].ends[0]);
    let end = |chain: &Vec<Link>| ahead(chain[chain.len() - 1].ends[1]);
    let places = chains.iter().enumerate();
    let mut places: Vec<(f64, Option<usize>, Option<usize>)> = places
        .flat_map(|(k, chain)| [(begin(chain), Some(k), None), (end(chain), None, Some(k))])
        .collect();
    places.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut next = vec![None; chains.len()];
    for pair in places.chunks(2) {
        let [(from, None, Some(ends)), (to, Some(begins), None)] = *pair else {
            return None;
        };
        if to - from < NEAR {
            return None;
        }
        next[ends] = Some(begins);
    }
    let mut chains: Vec<Option<Vec<Link>>> = chains.into_iter().map(Some).collect();
    let mut closed = Vec::new();
    for first in 0..chains.len() {
        let mut own: Vec<Link> = Vec::new();
        let mut k = first;
        while let Some(chain) = chains[k].take() {
            if let Some(last) = own.last() {
                own.push(Link::axis([last.ends[1], chain[0].ends[0]], across));
            }
            own.extend(chain);
            k = next[k]?;
        }
        if let [begin, .., last] = &own[..] {
            own.push(Link::axis([last.ends[1], begin.ends[0]], across));
            closed.push(own);
        } else if let [only] = &own[..] {
            let ends = [only.ends[1], only.ends[0]];
            own.push(Link::axis(ends, across));
            closed.push(own);
        }
    }
    Some(closed)
}

impl Link {
    /// Its parts between the points where it crosses an axis, whose ends on the axis lie there exactly.
    fn cut(&self, plan: &Plan, across: usize) -> Option<Vec<Self>> {
        let mut direction = [0.0; 2];
        direction[1 - across] = 1.0;
        let (track, [from, to]) = self.track(plan);
        let crossings = track.crossings([0.0; 2], direction, NEAR).into_iter();
        let mut places: Vec<f64> = crossings
            .map(|(_, s)| s)
            .filter(|&s| s > from + NEAR && s < to - NEAR)
            .collect();
        places.sort_by(f64::total_cmp);
        places.dedup_by(|a, b| *a - *b < NEAR);
        if matches!(self.origin, Origin::Ring { .. }) && !places.is_empty() {
            return None;
        }
        Some(
            self.divided(plan, &places)
                .into_iter()
                .map(|part| part.snapped(across))
                .collect(),
        )
    }

    fn snapped(mut self, across: usize) -> Self {
        for end in &mut self.ends {
            if end[across].abs() < NEAR {
                end[across] = 0.0;
            }
        }
        self
    }

    /// Whether it lies on the positive side of an axis; none if it runs along it.
    fn side(&self, plan: &Plan, across: usize) -> Option<bool> {
        let (track, [from, to]) = self.track(plan);
        let halfway = track.at(f64::midpoint(from, to));
        (halfway[across].abs() > NEAR).then_some(halfway[across] > 0.0)
    }
}
