//! Fields for ParaView: one VTU file per body and step, and `results.pvd` with the step number as time.
//!
//! Coordinates and values are in display units, and each name says its unit. A half model stays half.

use std::borrow::Cow;

use stickslip_fem_core::mesh::{Mesh, Point};
use stickslip_fem_core::stress::polar;
use stickslip_fem_core::vtk::{Field, PvdEntry, write_pvd, write_vtu};

use super::failure::plain_name;
use super::names::{FileNames, step_name};
use super::{File, FileNote, OutputError};
use stickslip_results::{BodyFields, EdgeKind, Results, von_mises};

/// All VTU files and their collection; nothing if no step has fields.
pub(super) fn files(results: &Results) -> Result<(Vec<File>, Vec<FileNote>), OutputError> {
    let mut names = FileNames::default();
    let stems: Vec<String> = results
        .bodies
        .iter()
        .map(|body| names.unique(&body.name))
        .collect();
    let mut meshes: Vec<Option<Mesh>> = vec![None; results.bodies.len()];
    let mut files = Vec::new();
    let mut entries = Vec::new();
    for (index, step) in results.steps.iter().enumerate() {
        for fields in &step.fields {
            let body = &results.bodies[fields.body];
            let Some(mesh) = &body.mesh else { continue };
            if meshes[fields.body].is_none() {
                let scaled = in_display_units(mesh, results);
                meshes[fields.body] = Some(scaled.map_err(|cause| OutputError::Mesh {
                    body: body.name.clone(),
                    cause,
                })?);
            }
            let Some(shown) = &meshes[fields.body] else {
                continue;
            };
            let file = format!(
                "fields/{}.vtu",
                step_name(&stems[fields.body], index, results)
            );
            let indices = failure_indices(results, index, fields.body, mesh.nodes().len());
            let bytes =
                grid(results, mesh, shown, fields, indices).map_err(|cause| OutputError::Vtk {
                    file: file.clone(),
                    cause,
                })?;
            entries.push(PvdEntry {
                time: (index + 1) as f64,
                part: fields.body,
                file: file.clone(),
            });
            files.push((file, bytes));
        }
    }
    if entries.is_empty() {
        return Ok((files, Vec::new()));
    }
    let mut collection = Vec::new();
    write_pvd(&entries, &mut collection).map_err(|cause| OutputError::Vtk {
        file: "results.pvd".into(),
        cause,
    })?;
    files.push(("results.pvd".into(), collection));
    let note = "displacements and stresses of every body for ParaView; time is the number of the load step";
    Ok((
        files,
        vec![FileNote::new("results.pvd, fields/*.vtu", note)],
    ))
}

/// The mesh with its coordinates in the display unit.
pub(super) fn in_display_units(
    mesh: &Mesh,
    results: &Results,
) -> Result<Mesh, stickslip_fem_core::mesh::MeshError> {
    let mut parts = mesh.clone().into_parts();
    for node in &mut parts.nodes {
        *node = node.map(|coordinate| results.units.length.from_base(coordinate));
    }
    // The sets' curves are in the old unit.
    for set in parts.edge_sets.values_mut() {
        set.curve = None;
    }
    Mesh::new(parts)
}

fn grid(
    results: &Results,
    mesh: &Mesh,
    shown: &Mesh,
    fields: &BodyFields,
    indices: Vec<(String, Vec<f64>)>,
) -> Result<Vec<u8>, stickslip_fem_core::vtk::VtkError> {
    let units = results.units;
    let displacement: Vec<f64> = (fields.displacement.chunks(2))
        .flat_map(|u| [u[0], u[1], 0.0].map(|u| units.length.from_base(u)))
        .collect();
    let stress = units.stress.name;
    let mut data: Vec<(Cow<'_, str>, usize, Vec<f64>)> = vec![(
        format!("displacement [{}]", units.length.name).into(),
        3,
        displacement,
    )];
    for (name, values) in stresses(results, mesh, fields) {
        let values = values
            .into_iter()
            .map(|value| units.stress.from_base(value))
            .collect();
        data.push((format!("{name} [{stress}]").into(), 1, values));
    }
    data.extend(
        indices
            .into_iter()
            .map(|(name, values)| (name.into(), 1, values)),
    );
    let fields: Vec<Field<'_>> = data
        .iter()
        .map(|(name, components, values)| Field {
            name,
            components: *components,
            values,
        })
        .collect();
    let mut bytes = Vec::new();
    write_vtu(shown, &fields, &[], &mut bytes)?;
    Ok(bytes)
}

/// Failure index of the first criterion in every ply of a laminated body, by name, at the mesh's own nodes.
fn failure_indices(
    results: &Results,
    step: usize,
    body: usize,
    nodes: usize,
) -> Vec<(String, Vec<f64>)> {
    let mut named = Vec::new();
    for failure in results
        .failure
        .iter()
        .filter(|failure| failure.body == body)
    {
        let criterion = failure.criteria.first().copied().unwrap_or_default();
        for map in failure.maps.iter().filter(|map| map.step == step) {
            for (group, values) in map.index.iter().enumerate() {
                let ply = plain_name(&failure.ply_name(group));
                let own = values.iter().take(nodes).copied().collect();
                named.push((format!("index {criterion} {ply} [-]"), own));
            }
        }
    }
    named
}

/// Nodal stresses by name `[MPa]`: Cartesian, across the thickness, von Mises, and polar if an edge is a circle.
fn stresses(results: &Results, mesh: &Mesh, fields: &BodyFields) -> Vec<(&'static str, Vec<f64>)> {
    let component = |k: usize| {
        fields
            .stress
            .iter()
            .map(|stress| stress[k])
            .collect::<Vec<f64>>()
    };
    let mut named = vec![
        ("stress_xx", component(0)),
        ("stress_yy", component(1)),
        ("stress_xy", component(2)),
        ("stress_zz", fields.thickness_stress.clone()),
        ("von_mises", von_mises_stresses(fields)),
    ];
    if let Some(centre) = polar_centre(results) {
        let turned = polar_stresses(mesh, fields, centre);
        let component = |k: usize| turned.iter().map(|stress| stress[k]).collect::<Vec<f64>>();
        named.push(("sigma_r", component(0)));
        named.push(("sigma_theta", component(1)));
        named.push(("tau_rtheta", component(2)));
    }
    named
}

/// (σ_r, σ_θ, τ_rθ) about `centre` at every node `[MPa]`.
pub(super) fn polar_stresses(mesh: &Mesh, fields: &BodyFields, centre: Point) -> Vec<[f64; 3]> {
    let angle = |node: &Point| (node[1] - centre[1]).atan2(node[0] - centre[0]);
    mesh.nodes()
        .iter()
        .zip(&fields.stress)
        .map(|(node, &stress)| polar(stress, angle(node)))
        .collect()
}

/// Centre of the first circular edge `[mm]`.
pub(super) fn polar_centre(results: &Results) -> Option<Point> {
    results.edges.iter().find_map(|edge| match edge.kind {
        EdgeKind::Circle { centre, .. } => Some(centre),
        EdgeKind::Line | EdgeKind::Path => None,
    })
}

/// Von Mises stress at every node `[MPa]`.
pub(super) fn von_mises_stresses(fields: &BodyFields) -> Vec<f64> {
    let nodes = fields.stress.iter().zip(&fields.thickness_stress);
    nodes.map(|(&stress, &zz)| von_mises(stress, zz)).collect()
}
