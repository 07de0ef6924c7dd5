//! The mesh of a file on the lines, circles and arcs that its edges approximate.

use stickslip_fem_core::mesh::{self, Mesh, MeshError, MeshParts};
use stickslip_mesh_files::{CurveError, put_on_circles, recognise_set, snap, snap_pieces};
use thiserror::Error;

use crate::shape::note::{FileCurve, FileNote};
use crate::shape::outline::CircleFit;

/// Why the edges of a file cannot be put on their curves.
#[derive(Debug, Error)]
#[error(transparent)]
pub(super) enum PlacedError {
    Curve(#[from] CurveError),
    Mesh(#[from] MeshError),
}

/// The mesh of a file with the known curves of its edges but `splines`, and its mid nodes on them; `notes` get what was moved.
pub(super) fn placed(
    mut parts: MeshParts,
    splines: &[String],
    notes: &mut Vec<FileNote>,
) -> Result<Mesh, PlacedError> {
    let names: Vec<String> = parts.edge_sets.keys().cloned().collect();
    for name in &names {
        match recognise_set(&parts, name).map(|found| found.curve) {
            Ok(mesh::Curve::Arc { radius, .. }) => {
                let moved = snap(&mut parts, name)?;
                if moved > 0 {
                    notes.push(FileNote::MidNodes {
                        edge: name.clone(),
                        moved,
                        onto: FileCurve::Circle(radius),
                    });
                }
            }
            Ok(curve @ mesh::Curve::Line) => {
                if let Some(set) = parts.edge_sets.get_mut(name) {
                    set.curve = Some(curve);
                }
            }
            Err(_) if splines.contains(name) => {}
            Err(_) => {
                let moved = snap_pieces(&mut parts, name).unwrap_or_default();
                if moved > 0 {
                    notes.push(FileNote::MidNodes {
                        edge: name.clone(),
                        moved,
                        onto: FileCurve::Arcs,
                    });
                }
            }
        }
    }
    Ok(Mesh::new(parts)?)
}

/// Puts the edges `circles`, of coordinates in mm, onto their best circles, or onto those of the known `radii`; `notes` get what was moved. Returns how they were
/// fitted.
///
/// # Errors
/// The key that is wrong, what is wrong with an edge, and what to do.
pub(super) fn on_circles(
    parts: &mut MeshParts,
    circles: &[String],
    radii: &[f64],
    notes: &mut Vec<FileNote>,
) -> Result<Vec<(String, CircleFit)>, [String; 3]> {
    let put = put_on_circles(parts, circles, radii).map_err(|cause| {
        let known: Vec<&str> = parts.edge_sets.keys().map(String::as_str).collect();
        let (key, remedy) = match &cause {
            CurveError::MissingSet { .. } => {
                ("circles", format!("edges of the file: {}", known.join(", ")))
            }
            CurveError::NoChain { .. } => {
                ("circles", "give each closed edge a name of its own".to_owned())
            }
            CurveError::Open { set } => ("circles", format!("name '{set}' in `splines` instead")),
            CurveError::Twice { .. } => ("circles", "name it once".to_owned()),
            CurveError::Radii { .. } => (
                "radii",
                "give one radius for each circle, in the order of `circles`".to_owned(),
            ),
            CurveError::OtherRadius { found, given, .. } => (
                "radii",
                format!("the file has {found:.6} mm, and {given:.6} mm is given: correct `radii`, or the `unit` of either"),
            ),
            CurveError::NoCircle { radius, .. } if radius.is_finite() => (
                "circles",
                format!("its best circle has a radius of {radius:.6} mm: leave it out of `circles`, or make the mesh again with the circle"),
            ),
            CurveError::Squeezed { .. } if !radii.is_empty() => (
                "radii",
                "correct `radii`, or make the mesh again with circles of these radii".to_owned(),
            ),
            _ => (
                "circles",
                "leave it out of `circles`, or make the mesh again with the circle".to_owned(),
            ),
        };
        [key.to_owned(), cause.to_string(), remedy]
    })?;
    let mut fitted = Vec::new();
    for (k, (name, put)) in circles.iter().zip(put).enumerate() {
        let fit = CircleFit {
            fitted: put.fitted,
            scatter: put.scatter,
            given: radii.get(k).copied(),
        };
        fitted.push((name.clone(), fit));
        let (found, moved) = (put.circle, put.moved);
        if let (mesh::Curve::Arc { radius, .. }, 1..) = (found.curve, moved) {
            notes.push(FileNote::DeclaredCircle {
                edge: name.clone(),
                moved,
                radius,
                residual: found.residual,
            });
        }
    }
    Ok(fitted)
}
