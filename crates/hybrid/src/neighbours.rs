//! Nearest places: a tree that halves the places by x and by y in turn.

use stickslip_fem_core::mesh::Point;

use crate::order_statistics::median;

/// A tree over some of a list of places.
pub(crate) struct Neighbours<'a> {
    places: &'a [Point],
    /// Indices; the middle of a range parts it, by x on even and by y on odd levels.
    tree: Vec<usize>,
}

impl<'a> Neighbours<'a> {
    /// A tree over the places that are `valid`.
    pub(crate) fn new(places: &'a [Point], valid: &[bool]) -> Self {
        let mut tree: Vec<usize> = (0..places.len()).filter(|&k| valid[k]).collect();
        part(&mut tree, places, 0);
        Self { places, tree }
    }

    /// The `count` nearest places, or all if there are fewer: distance and index, nearest first, equal ones by index.
    pub(crate) fn nearest(&self, at: Point, count: usize) -> Vec<(f64, usize)> {
        let mut found = Vec::with_capacity(count + 1);
        self.visit(&self.tree, at, 0, &mut |distance, index| {
            let entry = (distance, index);
            let position = found.partition_point(|other| precedes(*other, entry));
            if position < count {
                found.insert(position, entry);
                found.truncate(count);
            }
            match found.last() {
                Some(&(farthest, _)) if found.len() == count => farthest,
                _ => f64::INFINITY,
            }
        });
        found
    }

    /// Median distance of a place from its nearest neighbour; infinite for fewer than two.
    pub(crate) fn spacing(&self) -> f64 {
        let second = |&index: &usize| Some(self.nearest(self.places[index], 2).get(1)?.0);
        median(self.tree.iter().filter_map(second).collect()).unwrap_or(f64::INFINITY)
    }

    /// All places at less than `radius`, nearest first, equal ones by index.
    pub(crate) fn within(&self, at: Point, radius: f64) -> Vec<(f64, usize)> {
        let mut found = Vec::new();
        self.visit(&self.tree, at, 0, &mut |distance, index| {
            if distance < radius {
                found.push((distance, index));
            }
            radius
        });
        found.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        found
    }

    /// Visits places; each visit returns the distance beyond which no further place matters.
    fn visit(
        &self,
        range: &[usize],
        at: Point,
        level: usize,
        see: &mut impl FnMut(f64, usize) -> f64,
    ) {
        let middle = range.len() / 2;
        let Some(&index) = range.get(middle) else {
            return;
        };
        let place = self.places[index];
        let off = at[level % 2] - place[level % 2];
        let [near, far] = if off < 0.0 {
            [&range[..middle], &range[middle + 1..]]
        } else {
            [&range[middle + 1..], &range[..middle]]
        };
        self.visit(near, at, level + 1, see);
        let reach = see((at[0] - place[0]).hypot(at[1] - place[1]), index);
        if off.abs() <= reach {
            self.visit(far, at, level + 1, see);
        }
    }
}

fn precedes(a: (f64, usize), b: (f64, usize)) -> bool {
    a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)).is_lt()
}

fn part(range: &mut [usize], places: &[Point], level: usize) {
    if range.len() < 2 {
        return;
    }
    let middle = range.len() / 2;
    let axis = level % 2;
    range.select_nth_unstable_by(middle, |&a, &b| {
        places[a][axis].total_cmp(&places[b][axis]).then(a.cmp(&b))
    });
    let (before, after) = range.split_at_mut(middle);
    part(before, places, level + 1);
    part(&mut after[1..], places, level + 1);
}
