//! Where cut-outs and holes lie in a body.

use super::{Contour, Hole};
use crate::ContourError;
use crate::outline::Outline;
use crate::vector::distance;

/// Cut-outs that cross nothing lie in the outline and in no other one.
pub(super) fn cutouts(contour: &Contour, outline: &Outline) -> Result<(), ContourError> {
    for (k, own) in contour.cutouts.iter().enumerate() {
        if !outline.is_within(0, own.start) {
            return Err(ContourError::CutoutOutside {
                cutout: own.name.clone(),
                at: own.start,
            });
        }
        let mut others = contour.cutouts.iter().enumerate();
        let around =
            others.find(|&(other, _)| other != k && outline.is_within(other + 1, own.start));
        if let Some((_, outer)) = around {
            return Err(ContourError::CutoutInside {
                inner: own.name.clone(),
                outer: outer.name.clone(),
            });
        }
    }
    Ok(())
}

/// A hole lies in the body, apart from its edges.
pub(super) fn inside(hole: &Hole, outline: &Outline) -> Result<(), ContourError> {
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
pub(super) fn apart(hole: &Hole, others: &[Hole], tolerance: f64) -> Result<(), ContourError> {
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
