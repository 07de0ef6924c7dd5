//! Nodes and elements of MSH 2: one node and one element a line.

use super::groups::Groups;
use super::tokens::Tokens;
use super::tokens::place;
use super::types;
use crate::error::ReadError;
use crate::raw::{Raw, Shape};

/// `$Nodes`: the count, then `number x y z`.
pub(super) fn nodes(tokens: &mut Tokens<'_>, raw: &mut Raw) -> Result<(), ReadError> {
    for _ in 0..tokens.integer("the number of nodes")? {
        let number = tokens.integer("the number of a node")?;
        let spot = tokens.spot();
        let mut at = [0.0; 3];
        for value in &mut at {
            *value = tokens.real("a coordinate")?;
        }
        raw.add_node(number, at, spot)?;
    }
    Ok(())
}

/// `$Elements`: the count, then `number type tags physical entity … nodes`.
pub(super) fn elements(
    tokens: &mut Tokens<'_>,
    raw: &mut Raw,
    groups: &mut Groups,
) -> Result<(), ReadError> {
    for _ in 0..tokens.integer("the number of elements")? {
        let number = tokens.integer("the number of an element")?;
        let spot = tokens.spot();
        let kind = tokens.integer("the type of an element")?;
        let shape = types::shape(kind).map_err(|why| ReadError::ElementType {
            at: place(spot),
            element: number,
            name: types::name(kind),
            why,
        })?;
        let [mut physical, mut entity] = [0, 0];
        for k in 0..tokens.integer("the number of tags")? {
            let tag = tokens.tag("a tag")?;
            match k {
                0 => physical = tag,
                1 => entity = tag,
                _ => {}
            }
        }
        let nodes = read_nodes(tokens, shape)?;
        let physical = (physical != 0).then_some(physical);
        groups.add(raw, shape, entity, physical);
        raw.add_element(number, shape, &nodes[..shape.nodes()], [0, entity], spot);
    }
    Ok(())
}

/// The nodes of an element; no shape has more than 9.
pub(super) fn read_nodes(tokens: &mut Tokens<'_>, shape: Shape) -> Result<[u64; 9], ReadError> {
    let mut nodes = [0; 9];
    for node in nodes.iter_mut().take(shape.nodes()) {
        *node = tokens.integer("a node of an element")?;
    }
    Ok(nodes)
}
