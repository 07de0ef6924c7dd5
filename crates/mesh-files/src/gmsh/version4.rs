//! Entities, nodes and elements of MSH 4.1: blocks for each entity of the geometry.

use super::groups::Groups;
use super::types;
use super::version2::read_nodes;
use super::words::Words;
use super::words::place;
use crate::error::ReadError;
use crate::raw::Raw;

/// `$Entities`: the groups of points, curves, surfaces and volumes.
pub(super) fn entities(words: &mut Words<'_>, groups: &mut Groups) -> Result<(), ReadError> {
    let mut counts = [0; 4];
    for count in &mut counts {
        *count = words.integer("the number of entities")?;
    }
    for (dimension, count) in counts.into_iter().enumerate() {
        // Points have a place, the others a box.
        let coordinates = if dimension == 0 { 3 } else { 6 };
        for _ in 0..count {
            let entity = words.tag("the tag of an entity")?;
            for _ in 0..coordinates {
                words.word("a coordinate of an entity")?;
            }
            for _ in 0..words.integer("the number of physical groups")? {
                groups.assign(dimension, entity, words.tag("a physical group")?);
            }
            if dimension > 0 {
                for _ in 0..words.integer("the number of bounding entities")? {
                    words.word("a bounding entity")?;
                }
            }
        }
    }
    Ok(())
}

/// `$Nodes`: blocks of numbers followed by as many places.
pub(super) fn nodes(words: &mut Words<'_>, raw: &mut Raw) -> Result<(), ReadError> {
    let blocks = words.integer("the number of blocks")?;
    for _ in 0..3 {
        words.integer("the count and range of node numbers")?;
    }
    for _ in 0..blocks {
        let dimension = words.integer("the dimension of an entity")?;
        words.tag("the tag of an entity")?;
        let is_parametric = words.integer("the mark of parametric coordinates")? != 0;
        let parameters = if is_parametric { dimension.min(3) } else { 0 };
        let count = words.integer("the number of nodes")?;
        let mut numbers = Vec::new();
        for _ in 0..count {
            numbers.push(words.integer("the number of a node")?);
        }
        for number in numbers {
            let mut at = [0.0; 3];
            for value in &mut at {
                *value = words.real("a coordinate")?;
            }
            raw.add_node(number, at, words.spot())?;
            for _ in 0..parameters {
                words.word("a parametric coordinate")?;
            }
        }
    }
    Ok(())
}

/// `$Elements`: blocks of one type.
pub(super) fn elements(
    words: &mut Words<'_>,
    raw: &mut Raw,
    groups: &mut Groups,
) -> Result<(), ReadError> {
    let blocks = words.integer("the number of blocks")?;
    for _ in 0..3 {
        words.integer("the count and range of element numbers")?;
    }
    for _ in 0..blocks {
        words.integer("the dimension of an entity")?;
        let entity = words.tag("the tag of an entity")?;
        let kind = words.integer("the type of elements")?;
        for _ in 0..words.integer("the number of elements")? {
            let number = words.integer("the number of an element")?;
            let spot = words.spot();
            let shape = types::shape(kind).map_err(|why| ReadError::ElementType {
                at: place(spot),
                element: number,
                name: types::name(kind),
                why,
            })?;
            let nodes = read_nodes(words, shape)?;
            groups.add(raw, shape, entity, None);
            raw.add_element(number, shape, &nodes[..shape.nodes()], [0, entity], spot);
        }
    }
    Ok(())
}
