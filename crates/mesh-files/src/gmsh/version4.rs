//! Entities, nodes and elements of MSH 4.1: blocks for each entity of the geometry.

use super::groups::Groups;
use super::tokens::Tokens;
use super::tokens::place;
use super::types;
use super::version2::read_nodes;
use crate::error::ReadError;
use crate::raw::Raw;

/// `$Entities`: the groups of points, curves, surfaces and volumes.
pub(super) fn entities(tokens: &mut Tokens<'_>, groups: &mut Groups) -> Result<(), ReadError> {
    let mut counts = [0; 4];
    for count in &mut counts {
        *count = tokens.integer("the number of entities")?;
    }
    for (dimension, count) in counts.into_iter().enumerate() {
        // Points have a place, the others a box.
        let coordinates = if dimension == 0 { 3 } else { 6 };
        for _ in 0..count {
            let entity = tokens.tag("the tag of an entity")?;
            for _ in 0..coordinates {
                tokens.token("a coordinate of an entity")?;
            }
            for _ in 0..tokens.integer("the number of physical groups")? {
                groups.assign(dimension, entity, tokens.tag("a physical group")?);
            }
            if dimension > 0 {
                for _ in 0..tokens.integer("the number of bounding entities")? {
                    tokens.token("a bounding entity")?;
                }
            }
        }
    }
    Ok(())
}

/// `$Nodes`: blocks of numbers followed by as many places.
pub(super) fn nodes(tokens: &mut Tokens<'_>, raw: &mut Raw) -> Result<(), ReadError> {
    let blocks = tokens.integer("the number of blocks")?;
    for _ in 0..3 {
        tokens.integer("the count and range of node numbers")?;
    }
    for _ in 0..blocks {
        let dimension = tokens.integer("the dimension of an entity")?;
        tokens.tag("the tag of an entity")?;
        let is_parametric = tokens.integer("the mark of parametric coordinates")? != 0;
        let parameters = if is_parametric { dimension.min(3) } else { 0 };
        let count = tokens.integer("the number of nodes")?;
        let mut numbers = Vec::new();
        for _ in 0..count {
            numbers.push(tokens.integer("the number of a node")?);
        }
        for number in numbers {
            let mut at = [0.0; 3];
            for value in &mut at {
                *value = tokens.real("a coordinate")?;
            }
            raw.add_node(number, at, tokens.spot())?;
            for _ in 0..parameters {
                tokens.token("a parametric coordinate")?;
            }
        }
    }
    Ok(())
}

/// `$Elements`: blocks of one type.
pub(super) fn elements(
    tokens: &mut Tokens<'_>,
    raw: &mut Raw,
    groups: &mut Groups,
) -> Result<(), ReadError> {
    let blocks = tokens.integer("the number of blocks")?;
    for _ in 0..3 {
        tokens.integer("the count and range of element numbers")?;
    }
    for _ in 0..blocks {
        tokens.integer("the dimension of an entity")?;
        let entity = tokens.tag("the tag of an entity")?;
        let kind = tokens.integer("the type of elements")?;
        for _ in 0..tokens.integer("the number of elements")? {
            let number = tokens.integer("the number of an element")?;
            let spot = tokens.spot();
            let shape = types::shape(kind).map_err(|why| ReadError::ElementType {
                at: place(spot),
                element: number,
                name: types::name(kind),
                why,
            })?;
            let nodes = read_nodes(tokens, shape)?;
            groups.add(raw, shape, entity, None);
            raw.add_element(number, shape, &nodes[..shape.nodes()], [0, entity], spot);
        }
    }
    Ok(())
}
