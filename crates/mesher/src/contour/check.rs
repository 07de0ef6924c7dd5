//! The checks of a contour, and its exact curves.

use std::collections::BTreeSet;
use std::f64::consts::{FRAC_PI_3, PI, TAU};

use stickslip_fem_core::mesh::Point;

use super::inside::{apart, cutouts, inside};
use super::{Contour, Hole, Loop};
use crate::curve::Track;
use crate::meet;
use crate::outline::Outline;
use crate::vector::distance;
use crate::{ContourError, Course, SplineFlaw};

/// Distance below which points coincide, in units of the body's extent.
pub(crate) const TOLERANCE: f64 = 1e-9;

/// Distance from a shared corner, in units of the shorter piece, within which neighbours may meet: rounding moves the
/// point of contact of tangent curves by the root of its own size.
const CORNER: f64 = 1e-6;

/// Least angle inside and outside the body at a corner `[rad]`.
const CUSP: f64 = 0.01;

/// Most points between the ends of a spline, whose parts are compared with each other.
const MOST_POINTS: usize = 1000;

/// Pieces whose directions differ by less than half a degree are meant to be smooth `[rad]`.
const KINK: f64 = 0.5 * PI / 180.0;

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

    /// Corners of the outline and of cut-outs at which the body reaches over more than 180.5°, each with its inner angle `[rad]`; none of a
    /// contour whose pieces make no loops. Stress in an elastic body has no limit there (Williams, J. Appl. Mech. 19 (1952) 526–528).
    pub fn reentrant_corners(&self) -> Vec<(Point, f64)> {
        let Ok(outline) = resolved(self) else {
            return Vec::new();
        };
        let pieces = 0..outline.tracks.len();
        let corners = pieces.map(|k| (outline.tracks[k].from, outline.angle(k)));
        corners.filter(|own| own.1 > PI + KINK).collect()
    }
}

/// Checks a contour and resolves its pieces.
pub(crate) fn checked(contour: &Contour) -> Result<Outline, ContourError> {
    if let Some(short) = contour.loops().find(|own| own.pieces.len() < 2) {
        return Err(ContourError::TooFewPieces {
            cutout: short.name(),
            count: short.pieces.len(),
        });
    }
    numbers(contour)?;
    names(contour)?;
    let outline = resolved(contour)?;
    crossings(&outline)?;
    directions(contour, &outline)?;
    corners(&outline)?;
    cutouts(contour, &outline)?;
    for (k, hole) in contour.holes.iter().enumerate() {
        angles(hole)?;
        inside(hole, &outline)?;
        apart(hole, &contour.holes[..k], outline.tolerance)?;
    }
    Ok(outline)
}

/// Every loop is listed counter-clockwise.
fn directions(contour: &Contour, outline: &Outline) -> Result<(), ContourError> {
    for (k, own) in contour.loops().enumerate() {
        // A cut-out is walked against its list.
        let area = outline.area(k) * if own.cutout.is_some() { -1.0 } else { 1.0 };
        if area <= 0.0 {
            let cutout = own.name();
            return Err(ContourError::Clockwise { cutout, area });
        }
    }
    Ok(())
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
    for own in contour.loops() {
        let of = || match own.cutout {
            Some(name) => format!("start of cut-out '{name}'"),
            None => "start of the outline".into(),
        };
        finite(&of, own.start)?;
    }
    for piece in contour.loops().flat_map(|own| own.pieces) {
        let name = &piece.name;
        finite(&|| format!("end of edge '{name}'"), piece.to)?;
        let (what, points) = piece.course.points();
        for &at in points {
            finite(&|| format!("{what} '{name}'"), at)?;
        }
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
    let pieces = contour.loops().flat_map(|own| own.pieces);
    let pieces = pieces.map(|piece| ("edge", &piece.name));
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
    let mut seen = BTreeSet::new();
    let holes = contour.holes.iter().map(|hole| &hole.name);
    let mut all = contour.loops().flat_map(runs).chain(holes);
    match all.find(|name| !seen.insert(name.as_str())) {
        Some(name) => Err(ContourError::DuplicateName { name: name.clone() }),
        None => Ok(()),
    }
}

/// The names of runs of neighbouring pieces with one name.
fn runs(own: Loop<'_>) -> Vec<&String> {
    let count = own.pieces.len();
    let name = |k: usize| &own.pieces[k % count].name;
    let begins = (0..count).filter(|&k| name(k) != name(k + count - 1));
    let names: Vec<&String> = begins.map(name).collect();
    if names.is_empty() {
        vec![name(0)]
    } else {
        names
    }
}

/// The curves of closed loops of pieces with a length.
fn resolved(contour: &Contour) -> Result<Outline, ContourError> {
    let [low, high] = contour.bounds();
    let extent = (high[0] - low[0]).max(high[1] - low[1]);
    let mut outline = Outline::within([low, high], TOLERANCE * extent);
    for own in contour.loops() {
        let tracks = closed(own, outline.tolerance)?;
        outline.add(tracks);
    }
    Ok(outline)
}

/// The named tracks of a loop, with a length each and the first beginning where the last ends.
fn closed(own: Loop<'_>, tolerance: f64) -> Result<Vec<(String, Track)>, ContourError> {
    let mut tracks = Vec::new();
    for (piece, chord, track) in own.tracks() {
        if chord.length() <= tolerance {
            return Err(ContourError::ZeroLength {
                piece: piece.name.clone(),
                at: piece.to,
            });
        }
        if let Course::Spline(own) = &piece.course
            && own.points.len() > MOST_POINTS
        {
            let (count, most) = (own.points.len(), MOST_POINTS);
            return Err(ContourError::Spline {
                piece: piece.name.clone(),
                flaw: SplineFlaw::TooManyPoints { count, most },
            });
        }
        let track = track.map_err(|cause| cause.of(&piece.name))?;
        tracks.push((piece.name.clone(), track));
    }
    // There are at least two pieces.
    let last = &own.pieces[own.pieces.len() - 1];
    let gap = distance(last.to, own.start);
    if gap > tolerance {
        return Err(ContourError::Open {
            cutout: own.name(),
            piece: last.name.clone(),
            end: last.to,
            start: own.start,
            gap,
        });
    }
    Ok(tracks)
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
        let crossing = a.run().and_then(|run| meet::itself(run, outline.tolerance));
        if let Some(at) = crossing {
            return Err(ContourError::Spline {
                piece: outline.names[i].clone(),
                flaw: SplineFlaw::Meets { at },
            });
        }
        for (j, b) in tracks.iter().enumerate().skip(i + 1) {
            let near = CORNER * a.length().min(b.length());
            let mut shared = Vec::new();
            if outline.before(j) == i {
                shared.push(b.from);
            }
            if outline.before(i) == j {
                shared.push(a.from);
            }
            let free = |p: &Point| shared.iter().all(|&corner| distance(corner, *p) > near);
            let meeting = if a.run().is_some() || b.run().is_some() {
                let joints = [outline.before(j) == i, outline.before(i) == j];
                meet::tracks([a, b], joints, outline.tolerance, |p| free(&p))
            } else {
                let meetings = a.meetings(b, outline.tolerance);
                meetings.into_iter().find(free)
            };
            if let Some(at) = meeting {
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
