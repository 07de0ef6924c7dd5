//! Which way the corners of cells go.

use std::collections::{BTreeMap, BTreeSet};

use crate::error::ReadError;
use crate::note::Note;
use crate::raw::{Numbered, Shape};

/// First cell and number of cells of a group that go one way.
#[derive(Clone, Copy, Debug, Default)]
struct Tally {
    first: usize,
    count: usize,
}

impl Tally {
    fn add(&mut self, element: usize) {
        if self.count == 0 {
            self.first = element;
        }
        self.count += 1;
    }
}

/// Turns the cells of groups that go clockwise as a whole, and returns those groups.
///
/// # Errors
/// [`ReadError::Orientation`] for a group that goes both ways, with a cell of the smaller half.
pub(super) fn turn_clockwise(file: &mut Numbered) -> Result<BTreeSet<u64>, ReadError> {
    let mut groups = BTreeMap::<u64, [Tally; 2]>::new();
    for (k, element) in file.elements.iter().enumerate() {
        let Shape::Cell(kind) = element.shape else {
            continue;
        };
        let area = doubled_area(file, k, kind.corners());
        let [clockwise, counter] = groups.entry(element.turn).or_default();
        if area < 0.0 {
            clockwise.add(k);
        } else if area > 0.0 {
            counter.add(k);
        }
    }
    for [clockwise, counter] in groups.values() {
        if clockwise.count > 0 && counter.count > 0 {
            let is_clockwise = clockwise.count <= counter.count;
            let odd = if is_clockwise { clockwise } else { counter };
            return Err(ReadError::Orientation {
                at: file.place(odd.first),
                element: file.elements[odd.first].number,
                clockwise: is_clockwise,
            });
        }
    }
    groups.retain(|_, [clockwise, _]| clockwise.count > 0);
    let turned: BTreeSet<u64> = groups.keys().copied().collect();
    if let Some(first) = groups.values().map(|[clockwise, _]| clockwise.first).min() {
        let count = groups.values().map(|[clockwise, _]| clockwise.count).sum();
        let first = file.elements[first].number;
        file.notes.push(Note::Turned { count, first });
        for k in 0..file.elements.len() {
            let element = file.elements[k];
            if let Shape::Cell(kind) = element.shape
                && turned.contains(&element.turn)
            {
                reverse(file.nodes_of_mut(k), kind.corners());
            }
        }
    }
    Ok(turned)
}

/// Twice the area of the polygon of the corners, positive counter-clockwise.
fn doubled_area(file: &Numbered, element: usize, corners: usize) -> f64 {
    let nodes = file.nodes_of(element).iter().take(corners);
    let at = |node: &usize| file.nodes[*node].at;
    let points = nodes.map(at);
    let Some(origin) = points.clone().next() else {
        return 0.0;
    };
    let spans = points.map(|p| [p[0] - origin[0], p[1] - origin[1]]).skip(1);
    spans
        .clone()
        .zip(spans.skip(1))
        .map(|(a, b)| a[0] * b[1] - a[1] * b[0])
        .sum()
}

/// Walks a cell the other way: the first corner stays, and the mid nodes go with their edges. Local edge k becomes `corners` − 1 − k.
fn reverse(nodes: &mut [usize], corners: usize) {
    if let Some(rest) = nodes.get_mut(1..corners) {
        rest.reverse();
    }
    if let Some(middles) = nodes.get_mut(corners..2 * corners) {
        middles.reverse();
    }
}
