//! MSH 4.1 of Gmsh, as text.
//!
//! Gmsh knows sets as physical groups of entities, and an entity may be in several: nodes, edges and cells that are in the same sets make
//! one entity.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use stickslip_fem_core::mesh::{Mesh, Point};

use super::check_names;
use crate::error::WriteError;
use crate::gmsh::number_of;

/// A point, line or cell with its type and its nodes.
struct Element {
    kind: u64,
    nodes: Vec<usize>,
    number: usize,
}

/// Elements that are in the same groups.
#[derive(Default)]
struct Entity {
    groups: Vec<usize>,
    elements: Vec<Element>,
}

/// Groups and entities of one dimension.
#[derive(Default)]
struct Level {
    names: Vec<String>,
    entities: Vec<Entity>,
}

/// Writes a mesh in Gmsh's format MSH 4.1 as text.
///
/// Node sets are physical points, edge sets physical curves, element sets and blocks physical surfaces. Nodes are numbered from 1 in the order
/// of the mesh, cells likewise; elements of edges and points follow. Cells of order 1 and 2 only; curves of edge sets are not written.
///
/// # Errors
/// [`WriteError::Kind`] for cells of order 3 and above, [`WriteError::Name`] for names that the format cannot hold.
pub fn write_msh(mesh: &Mesh) -> Result<String, WriteError> {
    check_names(mesh)?;
    let mut next = mesh.element_count() + 1;
    let surfaces = surfaces(mesh)?;
    let curves = curves(mesh, &mut next);
    let points = points(mesh, &mut next);
    let levels = [points, curves, surfaces];

    let mut out = String::from("$MeshFormat\n4.1 0 8\n$EndMeshFormat\n");
    let _ = names(&mut out, &levels);
    let _ = entities(&mut out, &levels, mesh);
    let _ = nodes(&mut out, mesh);
    let _ = elements(&mut out, &levels, next - 1);
    Ok(out)
}

/// Sorts members into entities: `sets` has the names of groups and the keys of their members, `element` makes the element of a key.
fn level<K: Ord + Copy>(
    sets: Vec<(String, Vec<K>)>,
    mut element: impl FnMut(K) -> Element,
) -> Level {
    let mut groups_of = BTreeMap::<K, Vec<usize>>::new();
    let mut level = Level::default();
    for (k, (name, members)) in sets.into_iter().enumerate() {
        level.names.push(name);
        for member in members {
            groups_of.entry(member).or_default().push(k);
        }
    }
    // The key begins with the type: an entity may have several, a block of elements one.
    let mut entities = BTreeMap::<(Vec<usize>, u64), Entity>::new();
    for (key, groups) in groups_of {
        let element = element(key);
        let entity = entities.entry((groups.clone(), element.kind)).or_default();
        entity.groups = groups;
        entity.elements.push(element);
    }
    level.entities = entities.into_values().collect();
    level
}

fn surfaces(mesh: &Mesh) -> Result<Level, WriteError> {
    let mut sets = Vec::<(String, Vec<usize>)>::new();
    for (b, block) in mesh.blocks().iter().enumerate() {
        if number_of(block.kind).is_none() {
            return Err(WriteError::Kind {
                format: "Gmsh",
                kind: block.kind,
                block: block.name.clone(),
                instead: "T3, T6, Q4, Q8 or Q9",
            });
        }
        let first = mesh.first_element(b);
        let count = block.connectivity.len() / block.kind.nodes();
        let cells = first..first + count;
        let name = block_name(mesh, b);
        match sets.iter_mut().find(|(other, _)| *other == name) {
            Some((_, members)) => members.extend(cells),
            None => sets.push((name, cells.collect())),
        }
    }
    for name in mesh.element_set_names() {
        let cells = mesh.element_set(name).unwrap_or_default().to_vec();
        if !sets.iter().any(|(other, _)| other == name) {
            sets.push((name.to_owned(), cells));
        }
    }
    Ok(level(sets, |cell| {
        let (kind, nodes, _) = mesh.element(cell);
        Element {
            // Kinds without a number were refused above.
            kind: number_of(kind).unwrap_or_default(),
            nodes: nodes.to_vec(),
            number: cell + 1,
        }
    }))
}

/// The name of a block's group: another one than that of a set with other cells.
fn block_name(mesh: &Mesh, b: usize) -> String {
    // `b` is the index of a block.
    let name = &mesh.blocks()[b].name;
    let own = || {
        let blocks = mesh.blocks().iter().enumerate();
        blocks
            .filter(|(_, block)| block.name == *name)
            .flat_map(|(k, block)| {
                let first = mesh.first_element(k);
                first..first + block.connectivity.len() / block.kind.nodes()
            })
    };
    let is_other = |name: &str| {
        mesh.element_set(name).is_ok_and(|set| {
            let mut set = set.to_vec();
            set.sort_unstable();
            !set.into_iter().eq(own())
        })
    };
    let mut free = name.clone();
    while is_other(&free) {
        free.push_str("-block");
    }
    free
}

fn curves(mesh: &Mesh, next: &mut usize) -> Level {
    let sets = mesh.edge_set_names().map(|name| {
        let set = mesh.edge_set(name).into_iter();
        let edges = set.flat_map(|set| set.edges.iter().copied());
        (name.to_owned(), edges.collect())
    });
    level(sets.collect(), |edge| {
        let nodes: Vec<usize> = mesh.edge_nodes(edge).all().collect();
        Element {
            // Cells of higher order were refused above.
            kind: if nodes.len() == 2 { 1 } else { 8 },
            nodes,
            number: count(next),
        }
    })
}

fn points(mesh: &Mesh, next: &mut usize) -> Level {
    let sets = mesh.node_set_names().map(|name| {
        let nodes = mesh.node_set(name).unwrap_or_default();
        (name.to_owned(), nodes.to_vec())
    });
    level(sets.collect(), |node| Element {
        kind: 15,
        nodes: vec![node],
        number: count(next),
    })
}

fn count(next: &mut usize) -> usize {
    *next += 1;
    *next - 1
}

// Text takes everything: the results of writing below are those of the trait only.

fn names(out: &mut String, levels: &[Level]) -> std::fmt::Result {
    let count: usize = levels.iter().map(|level| level.names.len()).sum();
    writeln!(out, "$PhysicalNames\n{count}")?;
    for (dimension, level) in levels.iter().enumerate() {
        for (k, name) in level.names.iter().enumerate() {
            writeln!(out, "{dimension} {} \"{name}\"", k + 1)?;
        }
    }
    writeln!(out, "$EndPhysicalNames")
}

fn entities(out: &mut String, levels: &[Level], mesh: &Mesh) -> std::fmt::Result {
    writeln!(out, "$Entities")?;
    let counts: Vec<String> = levels
        .iter()
        .map(|level| level.entities.len().to_string())
        .collect();
    writeln!(out, "{} 0", counts.join(" "))?;
    for (dimension, level) in levels.iter().enumerate() {
        for (k, entity) in level.entities.iter().enumerate() {
            let [low, high] = extent(entity, mesh.nodes());
            write!(out, "{} {:?} {:?} 0 ", k + 1, low[0], low[1])?;
            if dimension > 0 {
                write!(out, "{:?} {:?} 0 ", high[0], high[1])?;
            }
            write!(out, "{}", entity.groups.len())?;
            for group in &entity.groups {
                write!(out, " {}", group + 1)?;
            }
            writeln!(out, "{}", if dimension > 0 { " 0" } else { "" })?;
        }
    }
    writeln!(out, "$EndEntities")
}

/// The corners of the box around an entity.
fn extent(entity: &Entity, nodes: &[Point]) -> [Point; 2] {
    let all = entity.elements.iter().flat_map(|element| &element.nodes);
    let mut extent = [[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]];
    // Nodes of cells are positions in the mesh's list.
    for point in all.map(|&node| nodes[node]) {
        for i in 0..2 {
            extent[0][i] = extent[0][i].min(point[i]);
            extent[1][i] = extent[1][i].max(point[i]);
        }
    }
    extent
}

/// All nodes, on the first surface.
fn nodes(out: &mut String, mesh: &Mesh) -> std::fmt::Result {
    let count = mesh.nodes().len();
    writeln!(out, "$Nodes\n1 {count} 1 {count}\n2 1 0 {count}")?;
    for number in 1..=count {
        writeln!(out, "{number}")?;
    }
    for [x, y] in mesh.nodes() {
        writeln!(out, "{x:?} {y:?} 0")?;
    }
    writeln!(out, "$EndNodes")
}

fn elements(out: &mut String, levels: &[Level], count: usize) -> std::fmt::Result {
    let blocks: usize = levels.iter().map(|level| level.entities.len()).sum();
    writeln!(out, "$Elements\n{blocks} {count} 1 {count}")?;
    for (dimension, level) in levels.iter().enumerate() {
        for (k, entity) in level.entities.iter().enumerate() {
            let kind = entity.elements.first().map_or(0, |element| element.kind);
            writeln!(
                out,
                "{dimension} {} {kind} {}",
                k + 1,
                entity.elements.len()
            )?;
            for element in &entity.elements {
                write!(out, "{}", element.number)?;
                for node in &element.nodes {
                    write!(out, " {}", node + 1)?;
                }
                writeln!(out)?;
            }
        }
    }
    writeln!(out, "$EndElements")
}
