//! The checks of a contour, and its exact curves.

use std::collections::BTreeSet;
use std::f64::consts::{FRAC_PI_3, TAU};

use stickslip_fem_core::mesh::Point;

use super::{Contour, Hole};
use crate::ContourError;
use crate::outline::Outline;
use crate::vector::distance;

/// Distance below which points coincide, in units of the body's extent.
const TOLERANCE: f64 = 1e-9;

/// Distance from a shared corner, in units of the shorter piece, within which neighbours may meet: rounding moves the
/// point of contact of tangent curves by the root of its own size.
const CORNER: f64 = 1e-6;

/// Least angle inside and outside the body at a corner `[rad]`.
const CUSP: f64 = 0.01;

/// Fewest angles of a hole.
const FEWEST_ANGLES: usize = 8;

/// Widest interval between angles of a hole `[rad]`: T6 cells with angles above 28.2° beside it are not folded.
const WIDEST_INTERVAL: f64 = FRAC_PI_3 + 1e-9;

impl Contour {
    /// Refuses what does not bound a body.
    ///
    /// # Errors
    /// The first defect found, of [`ContourError`]: numbers, names, lengths, closure, direction, crossings, cusps, holes.
    pub fn check(&self) -> Result<(), ContourError> {
        checked(self).map(|_| ())
    }
}

/// Checks a contour and resolves its pieces.
pub(crate) fn checked(contour: &Contour) -> Result<Outline, ContourError> {
    let count = contour.pieces.len();
    if count < 2 {
        return Err(ContourError::TooFewPieces { count });
    }
    numbers(contour)?;
    names(contour)?;
    let outline = resolved(contour)?;
    crossings(&outline)?;
    let area = outline.area();
    if area <= 0.0 {
        return Err(ContourError::Clockwise { area });
    }
    corners(&outline)?;
    for (k, hole) in contour.holes.iter().enumerate() {
        angles(hole)?;
        inside(hole, &outline)?;
        apart(hole, &contour.holes[..k], outline.tolerance)?;
    }
    Ok(outline)
}

/// Coordinates and radii are finite, radii positive.
fn numbers(contour: &Contour) -> Result<(), ContourError> {
    let finite = |what: &dyn Fn() -> String, point: Point| {
        let wrong = point.into_iter().find(|c| !c.is_finite());
        wrong.map_or(Ok(()), |value| {
            Err(ContourError::NotFinite {
                what: what(),
                value,
            })
        })
    };
    finite(&|| "start of the outline".into(), contour.start)?;
    for piece in &contour.pieces {
        let name = &piece.name;
        finite(&|| format!("end of edge '{name}'"), piece.to)?;
        let through = piece.through.unwrap_or(piece.to);
        finite(&|| format!("point on arc '{name}'"), through)?;
    }
    for hole in &contour.holes {
        let name = &hole.name;
        finite(&|| format!("centre of hole '{name}'"), hole.centre)?;
        finite(&|| format!("radius of hole '{name}'"), [hole.radius; 2])?;
        if hole.radius <= 0.0 {
            return Err(ContourError::NotPositive {
                what: format!("radius of hole '{name}'"),
                value: hole.radius,
            });
        }
    }
    Ok(())
}

/// Everything has a name; runs of neighbouring pieces share one, nothing else does.
fn names(contour: &Contour) -> Result<(), ContourError> {
    let pieces = contour.pieces.iter().map(|piece| ("edge", &piece.name));
    let holes = contour.holes.iter().map(|hole| ("hole", &hole.name));
    for (family, list) in [
        ("edge", pieces.collect::<Vec<_>>()),
        ("hole", holes.collect()),
    ] {
        if let Some(k) = list.iter().position(|(_, name)| name.trim().is_empty()) {
            let what = format!("{family} {}", k + 1);
            return Err(ContourError::EmptyName { what });
        }
    }
    let count = contour.pieces.len();
    let name = |k: usize| &contour.pieces[k % count].name;
    let mut seen = BTreeSet::new();
    let runs = (0..count).filter(|&k| name(k) != name(k + count - 1));
    let holes = contour.holes.iter().map(|hole| &hole.name);
    let one = (0..1).filter(|_| (0..count).all(|k| name(k) == name(0)));
    let mut all = runs.chain(one).map(name).chain(holes);
    match all.find(|name| !seen.insert(name.as_str())) {
        Some(name) => Err(ContourError::DuplicateName { name: name.clone() }),
        None => Ok(()),
    }
}

/// The curves of a closed outline of pieces with a length.
fn resolved(contour: &Contour) -> Result<Outline, ContourError> {
    let [low, high] = contour.bounds();
    let extent = (high[0] - low[0]).max(high[1] - low[1]);
    let tolerance = TOLERANCE * extent;
    let mut tracks = Vec::new();
    for (piece, track) in contour.tracks() {
        // A track as its own error is a line that stands for an arc.
        let chord = track.as_ref().unwrap_or_else(|line| line);
        if distance(chord.from, chord.to) <= tolerance {
            return Err(ContourError::ZeroLength {
                piece: piece.name.clone(),
                at: piece.to,
            });
        }
        tracks.push(track.map_err(|_| ContourError::StraightArc {
            piece: piece.name.clone(),
        })?);
    }
    let pieces = &contour.pieces;
    // There are at least two pieces.
    let last = &pieces[pieces.len() - 1];
    let gap = distance(last.to, contour.start);
    if gap > tolerance {
        return Err(ContourError::Open {
            piece: last.name.clone(),
            end: last.to,
            start: contour.start,
            gap,
        });
    }
    let names = pieces.iter().map(|piece| piece.name.clone()).collect();
    Ok(Outline::new(names, tracks, [low, high], tolerance))
}

/// No corner is a cusp.
fn corners(outline: &Outline) -> Result<(), ContourError> {
    for k in 0..outline.tracks.len() {
        let angle = outline.angle(k);
        if (CUSP..=TAU - CUSP).contains(&angle) {
            continue;
        }
        return Err(ContourError::Cusp {
            first: outline.names[outline.before(k)].clone(),
            second: outline.names[k].clone(),
            angle,
            at: outline.tracks[k].from,
        });
    }
    Ok(())
}

/// Pieces meet at shared corners only.
fn crossings(outline: &Outline) -> Result<(), ContourError> {
    let tracks = &outline.tracks;
    for (i, a) in tracks.iter().enumerate() {
        for (j, b) in tracks.iter().enumerate().skip(i + 1) {
            let near = CORNER * a.length().min(b.length());
            let mut shared = Vec::new();
            if outline.before(j) == i {
                shared.push(b.from);
            }
            if outline.before(i) == j {
                shared.push(a.from);
            }
            let meetings = a.meetings(b, outline.tolerance);
            let free = |p: &Point| shared.iter().all(|&corner| distance(corner, *p) > near);
            if let Some(at) = meetings.into_iter().find(free) {
                return Err(ContourError::Crossing {
                    first: outline.names[i].clone(),
                    second: outline.names[j].clone(),
                    at,
                });
            }
        }
    }
    Ok(())
}

/// Angles of a hole increase within one turn and leave no wide interval.
fn angles(hole: &Hole) -> Result<(), ContourError> {
    let name = || hole.name.clone();
    let list = &hole.angles;
    if list.len() < FEWEST_ANGLES {
        return Err(ContourError::TooFewAngles {
            hole: name(),
            count: list.len(),
            needed: FEWEST_ANGLES,
        });
    }
    let mut before = -f64::MIN_POSITIVE;
    for (index, &value) in list.iter().enumerate() {
        if !(value > before && (0.0..TAU).contains(&value)) {
            return Err(ContourError::Angles {
                hole: name(),
                index,
                value,
            });
        }
        before = value;
    }
    let next = list.iter().skip(1).copied().chain([list[0] + TAU]);
    let mut intervals = list.iter().zip(next);
    match intervals.find(|(a, b)| b - *a > WIDEST_INTERVAL) {
        Some((&after, next)) => Err(ContourError::AngleGap {
            hole: name(),
            after,
            width: next - after,
            widest: FRAC_PI_3,
        }),
        None => Ok(()),
    }
}

/// A hole lies inside the outline, apart from it.
fn inside(hole: &Hole, outline: &Outline) -> Result<(), ContourError> {
    let distances = outline
        .tracks
        .iter()
        .map(|track| track.distance(hole.centre));
    let (nearest, distance) = distances
        .enumerate()
        .min_by(|a, b| a.1.total_cmp(&b.1))
        // There are at least two pieces.
        .unwrap_or((0, f64::INFINITY));
    if distance <= hole.radius + outline.tolerance {
        return Err(ContourError::HoleCrosses {
            hole: hole.name.clone(),
            piece: outline.names[nearest].clone(),
            distance,
            radius: hole.radius,
        });
    }
    if outline.contains(hole.centre) {
        Ok(())
    } else {
        Err(ContourError::HoleOutside {
            hole: hole.name.clone(),
            distance,
        })
    }
}

/// A hole lies apart from those before it.
fn apart(hole: &Hole, others: &[Hole], tolerance: f64) -> Result<(), ContourError> {
    let reach = |other: &Hole| {
        let radii = other.radius + hole.radius;
        (distance(other.centre, hole.centre), radii)
    };
    let overlapping = others.iter().find(|other| {
        let (distance, radii) = reach(other);
        distance <= radii + tolerance
    });
    match overlapping {
        Some(other) => {
            let (distance, radii) = reach(other);
            Err(ContourError::HolesOverlap {
                first: other.name.clone(),
                second: hole.name.clone(),
                distance,
                radii,
            })
        }
        None => Ok(()),
    }
}
