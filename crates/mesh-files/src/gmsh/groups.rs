//! Physical groups: of points, curves and surfaces, by number and name.

use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;

use super::tokens::Tokens;
use super::tokens::place;
use crate::assemble::{RawEdge, Sets};
use crate::error::ReadError;
use crate::lines;
use crate::note::Note;
use crate::raw::{Numbered, Raw, RawBlock, Shape};

/// Elements that follow each other in the file and belong to the same groups.
#[derive(Debug)]
struct Run {
    dimension: usize,
    entity: u64,
    /// The group that the element itself names (MSH 2).
    physical: Option<u64>,
    /// Positions in the unsorted elements.
    elements: Range<usize>,
}

/// The groups of a file while it is read.
#[derive(Debug, Default)]
pub(super) struct Groups {
    names: BTreeMap<(usize, u64), String>,
    /// Groups of an entity of a dimension (MSH 4).
    of_entity: BTreeMap<(usize, u64), BTreeSet<u64>>,
    runs: Vec<Run>,
    /// Numbers of the elements of each group.
    members: BTreeMap<(usize, u64), Vec<u64>>,
    /// Elements in no group, of each dimension.
    unnamed: [usize; 3],
}

impl Groups {
    /// Reads `$PhysicalNames`: the count, then `dimension number "name"`.
    pub(super) fn read_names(&mut self, tokens: &mut Tokens<'_>) -> Result<(), ReadError> {
        const WHAT: &str = "dimension, number and name of a group";
        for _ in 0..tokens.integer("the number of names")? {
            let line = tokens.line(WHAT)?;
            let parsed = parse_name(line);
            let (key, name) = parsed.ok_or_else(|| ReadError::Value {
                at: place(tokens.spot()),
                what: WHAT,
                found: line.chars().take(40).collect(),
            })?;
            self.names.insert(key, name.to_owned());
        }
        Ok(())
    }

    /// Puts an entity into a group.
    pub(super) fn assign(&mut self, dimension: usize, entity: u64, physical: u64) {
        let groups = self.of_entity.entry((dimension, entity)).or_default();
        groups.insert(physical);
    }

    /// Takes note of the element that is added to `raw` next.
    pub(super) fn add(&mut self, raw: &Raw, shape: Shape, entity: u64, physical: Option<u64>) {
        let dimension = dimension(shape);
        let k = raw.elements.len();
        if let Some(last) = self.runs.last_mut()
            && (last.dimension, last.entity, last.physical) == (dimension, entity, physical)
        {
            last.elements.end = k + 1;
            return;
        }
        self.runs.push(Run {
            dimension,
            entity,
            physical,
            elements: k..k + 1,
        });
    }

    /// Collects the members of groups and gives cells the block of their lowest group.
    pub(super) fn finish(&mut self, raw: &mut Raw) {
        let mut blocks = BTreeMap::<Option<u64>, usize>::new();
        for run in std::mem::take(&mut self.runs) {
            let key = (run.dimension, run.entity);
            let groups: Vec<u64> = match run.physical {
                Some(own) => vec![own],
                None => (self.of_entity.get(&key).into_iter().flatten().copied()).collect(),
            };
            // Runs are ranges of the elements that were added; dimensions are 0, 1 and 2.
            let elements = &mut raw.elements[run.elements];
            if groups.is_empty() {
                self.unnamed[run.dimension] += elements.len();
            }
            for &group in &groups {
                let members = self.members.entry((run.dimension, group)).or_default();
                members.extend(elements.iter().map(|element| element.number));
            }
            if run.dimension == 2 {
                let lowest = groups.first().copied();
                let next = blocks.len();
                let block = *blocks.entry(lowest).or_insert(next);
                for element in elements {
                    element.block = block;
                }
            }
        }
        let mut order: Vec<_> = blocks.into_iter().collect();
        order.sort_by_key(|&(_, block)| block);
        raw.blocks = order
            .into_iter()
            .map(|(group, _)| RawBlock {
                name: group.map_or_else(|| "cells".to_owned(), |tag| self.name(2, tag)),
                rank: group.unwrap_or(u64::MAX),
            })
            .collect();
    }

    fn name(&self, dimension: usize, group: u64) -> String {
        let known = self.names.get(&(dimension, group));
        known.map_or_else(|| format!("physical-{group}"), String::clone)
    }

    /// Groups as sets. Groups of one dimension and name are one set.
    pub(super) fn sets(&self, file: &mut Numbered) -> Sets {
        let mut sets = Sets::default();
        for (&(dimension, group), numbers) in &self.members {
            let name = self.name(dimension, group);
            let found = numbers.iter().filter_map(|&n| file.element_index.get(n));
            match dimension {
                0 => {
                    let nodes = found.flat_map(|k| file.nodes_of(k)).copied();
                    sets.nodes.entry(name).or_default().extend(nodes);
                }
                1 => {
                    let lines = found.map(|element| RawEdge::Line { element });
                    sets.edges.entry(name).or_default().extend(lines);
                }
                _ => sets.elements.entry(name).or_default().extend(found),
            }
        }
        self.note(file);
        sets
    }

    fn note(&self, file: &mut Numbered) {
        const FAMILIES: [&str; 4] = ["node", "edge", "element", "volume"];
        for (what, count) in ["point", "line"].into_iter().zip(self.unnamed) {
            if count > 0 {
                file.notes.push(Note::Unnamed { what, count });
            }
        }
        for (key, name) in &self.names {
            if !self.members.contains_key(key) {
                let family = FAMILIES.get(key.0).copied().unwrap_or("unknown");
                let set = name.clone();
                file.notes.push(Note::DroppedSet { family, set });
            }
        }
    }
}

fn dimension(shape: Shape) -> usize {
    match shape {
        Shape::Point => 0,
        Shape::Line(_) => 1,
        Shape::Cell(_) => 2,
    }
}

fn parse_name(line: &str) -> Option<((usize, u64), &str)> {
    let (dimension, rest) = line.split_once(char::is_whitespace)?;
    let (group, name) = rest.trim_start().split_once(char::is_whitespace)?;
    let dimension = usize::try_from(lines::integer(dimension)?).ok()?;
    let name = name.trim().strip_prefix('"')?.strip_suffix('"')?;
    Some(((dimension, lines::integer(group)?), name))
}
