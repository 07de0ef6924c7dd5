//! The mesh of a file on the lines, circles and arcs that its edges approximate.

use stickslip_fem_core::mesh::{self, Mesh, MeshParts};
use stickslip_mesh_files::{recognise_set, snap, snap_pieces};

/// The mesh of a file in mm, with the known curves of its edges but `splines`, and its mid nodes on them; `notes` get what was moved.
pub(super) fn placed(
    mut parts: MeshParts,
    splines: &[String],
    scale: f64,
    notes: &mut Vec<String>,
) -> Result<Mesh, String> {
    for node in &mut parts.nodes {
        *node = node.map(|x| scale * x);
    }
    let names: Vec<String> = parts.edge_sets.keys().cloned().collect();
    for name in &names {
        match recognise_set(&parts, name).map(|found| found.curve) {
            Ok(mesh::Curve::Arc { radius, .. }) => {
                let moved = snap(&mut parts, name).map_err(|cause| cause.to_string())?;
                if moved > 0 {
                    notes.push(format!(
                        "{moved} mid nodes of '{name}' were put from chords onto its circle of radius {radius:.6} mm"
                    ));
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
                    notes.push(format!(
                        "{moved} mid nodes of '{name}' were put from chords onto its arcs"
                    ));
                }
            }
        }
    }
    Mesh::new(parts).map_err(|cause| cause.to_string())
}
