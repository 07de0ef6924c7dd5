//! Members of sets by position, and the sets that the mesh gets.

use std::collections::BTreeMap;
use std::collections::btree_map::Entry as Place;

use super::definitions::{Addition, Definition, Definitions, Entry, Family};
use crate::assemble::{RawEdge, Sets};
use crate::error::ReadError;
use crate::note::Note;
use crate::place::Spot;
use crate::raw::{Numbered, Shape};

/// Members that sets may have in all, beyond one for every byte of the text.
const FREE_MEMBERS: usize = 1_000_000;

/// The members of a definition: positions of nodes or elements, or edges.
#[derive(Clone, Debug, Default)]
struct Found {
    items: Vec<usize>,
    edges: Vec<RawEdge>,
}

struct Resolver<'a> {
    file: &'a Numbered,
    definitions: &'a Definitions,
    found: Vec<Found>,
    /// Members so far, and how many there may be.
    members: usize,
    limit: usize,
}

/// Looks up all members, in the order of the file, and sorts the sets by what they hold.
///
/// # Errors
/// [`ReadError::UnknownMember`], [`ReadError::EmptySet`], [`ReadError::SetsTooLarge`].
pub(super) fn sets(
    file: &mut Numbered,
    definitions: &Definitions,
    bytes: usize,
) -> Result<Sets, ReadError> {
    let mut resolver = Resolver {
        file,
        definitions,
        found: vec![Found::default(); definitions.list.len()],
        members: 0,
        limit: bytes.saturating_add(FREE_MEMBERS),
    };
    for addition in &definitions.additions {
        resolver.add(addition)?;
    }
    let found = resolver.found;
    let mut sets = Sets::default();
    let mut notes = Vec::new();
    let mut all: Vec<_> = definitions.list.iter().zip(found).collect();
    // Surfaces have the first claim to names of edge sets, sets to those of node sets.
    all.sort_by_key(|(definition, _)| {
        let rank = [Family::Surface, Family::Nodes, Family::Elements];
        rank.iter()
            .position(|family| *family == definition.family)
            .unwrap_or(3)
    });
    for (definition, found) in all {
        if found.items.is_empty() && found.edges.is_empty() {
            check_empty(definition, file)?;
        } else if !definition.internal {
            publish(definition, found, file, &mut sets, &mut notes);
        }
    }
    file.notes.extend(notes);
    Ok(sets)
}

/// Only sets that lost their members to the assembly may be empty.
fn check_empty(definition: &Definition, file: &Numbered) -> Result<(), ReadError> {
    if definition.partial {
        return Ok(());
    }
    Err(ReadError::EmptySet {
        at: file.files.place(definition.spot),
        family: definition.family.word(),
        set: definition.name.clone(),
    })
}

impl Resolver<'_> {
    fn add(&mut self, addition: &Addition) -> Result<(), ReadError> {
        // `add` was given positions of definitions, and there is one `found` for each.
        let definition = &self.definitions.list[addition.to];
        match &addition.entry {
            &Entry::Run(first, last) => self.run(addition, definition, [first, last]),
            &Entry::Generate(range) => self.generate(addition, definition, range),
            Entry::Named(name) => {
                let family = match definition.family {
                    Family::Elements => Family::Elements,
                    _ => Family::Nodes,
                };
                let items = self.named(addition, definition, family, name)?;
                self.extend(addition, items)
            }
            &Entry::Face(element, face) => {
                let k = self.file.element_index.get(element).ok_or_else(|| {
                    self.unknown(addition, definition, format!("element {element}"))
                })?;
                self.faces(addition, &[k], face)
            }
            Entry::Faces(name, face) => {
                let items = self.named(addition, definition, Family::Elements, name)?;
                self.faces(addition, &items, *face)
            }
        }
    }

    fn unknown(&self, addition: &Addition, set: &Definition, member: String) -> ReadError {
        ReadError::UnknownMember {
            at: self.file.files.place(addition.spot),
            family: set.family.word(),
            set: set.name.clone(),
            member,
        }
    }

    /// Counts members before they are stored.
    fn grow(&mut self, by: usize, spot: Spot) -> Result<(), ReadError> {
        self.members = self.members.saturating_add(by);
        if self.members <= self.limit {
            return Ok(());
        }
        Err(ReadError::SetsTooLarge {
            at: self.file.files.place(spot),
            limit: self.limit,
        })
    }

    fn extend(&mut self, addition: &Addition, items: Vec<usize>) -> Result<(), ReadError> {
        self.grow(items.len(), addition.spot)?;
        self.found[addition.to].items.extend(items);
        Ok(())
    }

    fn range(&self, family: Family, [first, last, step]: [u64; 3]) -> Vec<usize> {
        let index = match family {
            Family::Elements | Family::Surface => &self.file.element_index,
            Family::Nodes | Family::NodeSurface => &self.file.node_index,
        };
        index.range(first, last, step).collect()
    }

    fn run(
        &mut self,
        addition: &Addition,
        set: &Definition,
        [first, last]: [u64; 2],
    ) -> Result<(), ReadError> {
        let items = self.range(set.family, [first, last, 1]);
        if items.len() as u64 != last - first + 1 {
            let known = |number: u64| match set.family {
                Family::Elements => self.file.element_index.get(number),
                _ => self.file.node_index.get(number),
            };
            let missing = (first..=last).find(|&number| known(number).is_none());
            let member = format!("{} {}", set.family.word(), missing.unwrap_or(first));
            return Err(self.unknown(addition, set, member));
        }
        self.extend(addition, items)
    }

    fn generate(
        &mut self,
        addition: &Addition,
        set: &Definition,
        range: [u64; 3],
    ) -> Result<(), ReadError> {
        let items = self.range(set.family, range);
        if items.is_empty() {
            let [first, last, step] = range;
            let word = set.family.word();
            let member = format!("{word}s {first} to {last} by {step}");
            return Err(self.unknown(addition, set, member));
        }
        self.extend(addition, items)
    }

    /// The members of another set, as far as it is defined.
    fn named(
        &self,
        addition: &Addition,
        set: &Definition,
        family: Family,
        name: &str,
    ) -> Result<Vec<usize>, ReadError> {
        let other = self.definitions.find(family, set.of_assembly, name);
        let items = other.map(|k| self.found[k].items.clone());
        items
            .filter(|items| !items.is_empty())
            .ok_or_else(|| self.unknown(addition, set, format!("set '{name}'")))
    }

    fn faces(
        &mut self,
        addition: &Addition,
        elements: &[usize],
        face: Option<usize>,
    ) -> Result<(), ReadError> {
        self.grow(elements.len(), addition.spot)?;
        let spot = addition.spot;
        let edge = |&element: &usize| match (face, self.file.elements[element].shape) {
            (None, Shape::Line(_)) => RawEdge::Line { element },
            (None, _) => RawEdge::Free { element },
            (Some(local), _) => RawEdge::Face {
                element,
                local,
                spot,
            },
        };
        let edges = elements.iter().map(edge);
        self.found[addition.to].edges.extend(edges);
        Ok(())
    }
}

/// Puts the members of a definition into the sets of the mesh.
fn publish(
    definition: &Definition,
    found: Found,
    file: &Numbered,
    sets: &mut Sets,
    notes: &mut Vec<Note>,
) {
    let Found { items, edges } = found;
    match definition.family {
        Family::Nodes | Family::NodeSurface => insert(&mut sets.nodes, definition, items, notes),
        Family::Surface => insert(&mut sets.edges, definition, edges, notes),
        Family::Elements => {
            let is_line = |&k: &usize| matches!(file.elements[k].shape, Shape::Line(_));
            let (lines, cells): (Vec<_>, Vec<_>) = items.into_iter().partition(is_line);
            let lines = lines.into_iter().map(|element| RawEdge::Line { element });
            let lines: Vec<_> = lines.collect();
            if !lines.is_empty() {
                insert(&mut sets.edges, definition, lines, notes);
            }
            if !cells.is_empty() {
                insert(&mut sets.elements, definition, cells, notes);
            }
        }
    }
}

/// Inserts under the name in the file or, if it is taken, under a free one.
fn insert<T>(
    sets: &mut BTreeMap<String, Vec<T>>,
    definition: &Definition,
    items: Vec<T>,
    notes: &mut Vec<Note>,
) {
    let mut name = definition.name.clone();
    loop {
        match sets.entry(name) {
            Place::Vacant(place) => {
                let to = place.key().clone();
                if to != definition.name {
                    let name = definition.name.clone();
                    notes.push(Note::Renamed { name, to });
                }
                place.insert(items);
                return;
            }
            Place::Occupied(place) => name = format!("{}-2", place.key()),
        }
    }
}
