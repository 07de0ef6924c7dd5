//! A region's mesh from a file of Gmsh (format 4.1, text or binary).
//!
//! Its cells are all triangles and quadrilaterals of the file, linear or quadratic, in the plane z = constant; groups do not matter.
//! Points and lines of any order, which Gmsh saves where groups mark corners and edges, are passed over; cells of all other kinds are
//! refused, since without them the region would have gaps. Stresses are computed on the edges whose ends lie on the hole.

use std::collections::BTreeMap;

use mshio::{ElementBlock as Elements, ElementType, MshFile, parse_msh_bytes};
use stickslip_fem_core::mesh::{
    Curve, EdgeRef, EdgeSet, ElementBlock, ElementKind, Mesh, MeshParts, Point,
};
use thiserror::Error;

use crate::error::ExperimentError;
use stickslip_engine::model::BYTES_PER_NODE;
use stickslip_experiment::{Hole, MeshPlan};
use stickslip_scene::host::Host;
use stickslip_scene::limits::Content;

/// Part of the radius by which a node may be off the hole.
const ON_HOLE: f64 = 1e-3;

/// Whether every header is one of format 4.1 that [`parse_msh_bytes`] reads: it panics where numbers have other sizes than 4 or 8 bytes.
fn has_header(bytes: &[u8]) -> bool {
    const BEGIN: &[u8] = b"$MeshFormat";
    let after = |place: usize| &bytes[place + BEGIN.len()..];
    let is_read = |rest: &[u8]| {
        let words = rest.split(u8::is_ascii_whitespace);
        let mut words = words.filter(|word| !word.is_empty());
        words.next().is_some()
            && matches!(words.next(), Some(b"0" | b"1"))
            && matches!(words.next(), Some(b"4" | b"8"))
    };
    let mut headers = bytes
        .windows(BEGIN.len())
        .enumerate()
        .filter(|(_, found)| *found == BEGIN)
        .map(|(place, _)| after(place));
    headers.all(is_read)
}

/// The mesh of `plan`, its edges on `hole` in the set `edge`.
///
/// # Errors
/// [`ExperimentError::File`] for a file that cannot be read or makes no mesh, [`ExperimentError::Missing`] for one without cells, with
/// cells of other kinds, or without an edge on the hole.
pub(super) fn mesh(
    plan: &MeshPlan,
    hole: &Hole,
    edge: &str,
    host: Host,
) -> Result<Mesh, ExperimentError> {
    let unreadable = |cause: String| ExperimentError::File {
        key: "region.mesh.file".to_owned(),
        path: plan.file.display().to_string(),
        cause,
    };
    let bytes = host.read(&plan.file, Content::Table);
    let bytes = bytes.map_err(|cause| unreadable(cause.to_string()))?;
    let other = || unreadable("it is not a mesh in Gmsh's format 4.1".to_owned());
    if !has_header(&bytes) {
        return Err(other());
    }
    let file = parse_msh_bytes(&bytes).map_err(|_| other())?;
    check_kinds(&file)?;
    let parts = parts(&file, plan.scale).map_err(|cause| unreadable(cause.to_string()))?;
    let memory = parts.nodes.len() as f64 * BYTES_PER_NODE;
    host.limits
        .check(memory)
        .map_err(|cause| ExperimentError::Memory {
            key: "region.mesh.file".to_owned(),
            what: format!("the mesh has {} nodes", parts.nodes.len()),
            cause,
        })?;
    if parts.blocks.is_empty() {
        return Err(ExperimentError::missing(
            "region.mesh",
            "the mesh has no triangles and no quadrilaterals of one or two orders",
            "mesh the surface, and save it with its elements",
        ));
    }
    let plain = Mesh::new(parts).map_err(|cause| unreadable(cause.to_string()))?;
    let edges = on_hole(&plain, hole);
    if edges.is_empty() {
        return Err(ExperimentError::missing(
            "region.mesh",
            format!(
                "no edge of the mesh lies on the hole; the nearest node is {:.6} mm off its edge",
                nearest(&plain, hole)
            ),
            "check region.mesh.scale, and that the hole's centre and radius are those of the mesh",
        ));
    }
    let mut parts = plain.into_parts();
    let curve = Some(Curve::Arc {
        centre: hole.centre,
        radius: hole.radius,
    });
    parts
        .edge_sets
        .insert(edge.to_owned(), EdgeSet { edges, curve });
    Mesh::new(parts).map_err(|cause| unreadable(cause.to_string()))
}

fn kind_of(kind: ElementType) -> Option<ElementKind> {
    match kind {
        ElementType::Tri3 => Some(ElementKind::T3),
        ElementType::Tri6 => Some(ElementKind::T6),
        ElementType::Qua4 => Some(ElementKind::Q4),
        ElementType::Qua8 => Some(ElementKind::Q8),
        ElementType::Qua9 => Some(ElementKind::Q9),
        _ => None,
    }
}

/// Whether elements of `kind` only mark corners and edges.
fn marks_boundaries(kind: ElementType) -> bool {
    use ElementType::{
        Lin1, Lin2, Lin3, Lin4, Lin5, Lin6, Lin7, Lin8, Lin9, Lin10, Lin11, LinB, LinC, Pnt,
    };
    matches!(
        kind,
        Pnt | Lin1
            | Lin2
            | Lin3
            | Lin4
            | Lin5
            | Lin6
            | Lin7
            | Lin8
            | Lin9
            | Lin10
            | Lin11
            | LinB
            | LinC
    )
}

fn blocks(file: &MshFile<u64, i32, f64>) -> impl Iterator<Item = &Elements<u64, i32>> {
    let elements = file.data.elements.iter();
    elements.flat_map(|all| &all.element_blocks)
}

/// Refuses cells that are no part of a plane mesh of one or two orders.
fn check_kinds(file: &MshFile<u64, i32, f64>) -> Result<(), ExperimentError> {
    let mut others: BTreeMap<String, usize> = BTreeMap::new();
    for block in blocks(file) {
        let kind = block.element_type;
        if kind_of(kind).is_none() && !marks_boundaries(kind) && !block.elements.is_empty() {
            *others.entry(format!("{kind:?}")).or_default() += block.elements.len();
        }
    }
    if others.is_empty() {
        return Ok(());
    }
    let counted: Vec<String> = (others.iter())
        .map(|(kind, count)| format!("{count} of Gmsh's kind {kind}"))
        .collect();
    Err(ExperimentError::missing(
        "region.mesh",
        format!(
            "the mesh has cells that are not read: {}; its cells are triangles and quadrilaterals of one or two orders (Tri3, Tri6, Qua4, \
             Qua8, Qua9)",
            counted.join(", ")
        ),
        "mesh the surface with Mesh.ElementOrder = 1 or 2, and save its elements without those of volumes",
    ))
}

/// A cell of a node that the file does not have, both by their tags.
#[derive(Debug, Error)]
#[error("element {element} names node {node}, which does not exist")]
struct NoNode {
    element: u64,
    node: u64,
}

/// Nodes that cells use, and the cells, counter-clockwise.
fn parts(file: &MshFile<u64, i32, f64>, scale: f64) -> Result<MeshParts, NoNode> {
    let places = places(file, scale);
    let mut parts = MeshParts::default();
    let mut indices: BTreeMap<u64, usize> = BTreeMap::new();
    for block in blocks(file) {
        let Some(kind) = kind_of(block.element_type) else {
            continue;
        };
        let mut connectivity = Vec::with_capacity(block.elements.len() * kind.nodes());
        for element in &block.elements {
            let mut cell = Vec::with_capacity(kind.nodes());
            for tag in &element.nodes {
                let place = places.get(tag).ok_or(NoNode {
                    element: element.element_tag,
                    node: *tag,
                })?;
                cell.push(*indices.entry(*tag).or_insert_with(|| {
                    parts.nodes.push(*place);
                    parts.nodes.len() - 1
                }));
            }
            if area(&parts.nodes, &cell[..kind.edges()]) < 0.0 {
                reverse(&mut cell, kind);
            }
            connectivity.extend(cell);
        }
        parts.blocks.push(ElementBlock {
            name: format!("{kind:?}-{}", block.entity_tag),
            kind,
            connectivity,
        });
    }
    Ok(parts)
}

/// Place of each node by its tag `[mm]`.
fn places(file: &MshFile<u64, i32, f64>, scale: f64) -> BTreeMap<u64, Point> {
    let mut places = BTreeMap::new();
    let blocks = file.data.nodes.iter().flat_map(|all| &all.node_blocks);
    // Without a map, tags go up by one from block to block.
    let mut next = file.data.nodes.as_ref().map_or(1, |all| all.min_node_tag);
    for block in blocks {
        let by_index: BTreeMap<usize, u64> = (block.node_tags.iter().flatten())
            .map(|(tag, index)| (*index, *tag))
            .collect();
        for (index, node) in block.nodes.iter().enumerate() {
            let tag = by_index.get(&index).copied().unwrap_or(next);
            next = tag + 1;
            places.insert(tag, [scale * node.x, scale * node.y]);
        }
    }
    places
}

/// Twice the area of a polygon, positive counter-clockwise.
fn area(nodes: &[Point], corners: &[usize]) -> f64 {
    let next = corners.iter().cycle().skip(1);
    (corners.iter().zip(next))
        .map(|(&a, &b)| nodes[a][0] * nodes[b][1] - nodes[b][0] * nodes[a][1])
        .sum()
}

/// Walks a cell the other way: its first corner stays, and the mid-side nodes go with their edges.
fn reverse(cell: &mut [usize], kind: ElementKind) {
    let corners = kind.edges();
    cell[1..corners].reverse();
    if cell.len() >= 2 * corners {
        cell[corners..2 * corners].reverse();
    }
}

fn off(hole: &Hole, place: Point) -> f64 {
    (hole.from_centre(place) - hole.radius).abs()
}

/// Boundary edges with both ends on the hole.
fn on_hole(mesh: &Mesh, hole: &Hole) -> Vec<EdgeRef> {
    let near = |node: usize| off(hole, mesh.nodes()[node]) <= ON_HOLE * hole.radius;
    mesh.boundary_edges()
        .into_iter()
        .filter(|&edge| mesh.edge_nodes(edge).ends.into_iter().all(near))
        .collect()
}

fn nearest(mesh: &Mesh, hole: &Hole) -> f64 {
    let distances = mesh.nodes().iter().map(|place| off(hole, *place));
    distances.fold(f64::INFINITY, f64::min)
}

#[cfg(test)]
mod tests;
