//! Nodes and elements of MSH 2: one node and one element a line.

use super::groups::Groups;
use super::types;
use super::words::Words;
use super::words::place;
use crate::error::ReadError;
use crate::raw::{Raw, Shape};

/// `$Nodes`: the count, then `number x y z`.
pub(super) fn nodes(words: &mut Words<'_>, raw: &mut Raw) -> Result<(), ReadError> {
    for _ in 0..words.integer("the number of nodes")? {
        let number = words.integer("the number of a node")?;
        let spot = words.spot();
        let mut at = [0.0; 3];
        for value in &mut at {
            *value = words.real("a coordinate")?;
        }
        raw.add_node(number, at, spot)?;
    }
    Ok(())
}

/// `$Elements`: the count, then `number type tags physical entity … nodes`.
pub(super) fn elements(
    words: &mut Words<'_>,
    raw: &mut Raw,
    groups: &mut Groups,
) -> Result<(), ReadError> {
    for _ in 0..words.integer("the number of elements")? {
        let number = words.integer("the number of an element")?;
        let spot = words.spot();
        let kind = words.integer("the type of an element")?;
        let shape = types::shape(kind).map_err(|why| ReadError::ElementType {
            at: place(spot),
            element: number,
            name: types::name(kind),
            why,
        })?;
        let [mut physical, mut entity] = [0, 0];
        for k in 0..words.integer("the number of tags")? {
            let tag = words.tag("a tag")?;
            match k {
                0 => physical = tag,
                1 => entity = tag,
                _ => {}
            }
        }
        let nodes = read_nodes(words, shape)?;
        let physical = (physical != 0).then_some(physical);
        groups.add(raw, shape, entity, physical);
        raw.add_element(number, shape, &nodes[..shape.nodes()], [0, entity], spot);
    }
    Ok(())
}

/// The nodes of an element; no shape has more than 9.
pub(super) fn read_nodes(words: &mut Words<'_>, shape: Shape) -> Result<[u64; 9], ReadError> {
    let mut nodes = [0; 9];
    for node in nodes.iter_mut().take(shape.nodes()) {
        *node = words.integer("a node of an element")?;
    }
    Ok(nodes)
}
