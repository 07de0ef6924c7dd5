//! Places held out of a fit to check it: one of n, evenly over the plane.
//!
//! ```text
//! groups of n places along Morton's curve;   of group g the place ⌊n frac(g φ)⌋,   φ = (√5 − 1)/2
//! ```
//!
//! The curve (Morton 1966) visits quarters of the plane, quarters of them, and so on, each wholly before the next, so that a group lies
//! close together wherever its places stand in the table. The golden ratio spreads the choices within groups, so that they fall into
//! no rows or columns of a grid.

use stickslip_fem_core::mesh::Point;
use stickslip_hybrid::data::Measurement;

use super::UNUSED;
use crate::ends::ends;

/// The golden ratio less one.
const GOLDEN: f64 = 0.618_033_988_749_894_9;
/// Steps of the grid that orders places along the curve, in each direction.
const STEPS: f64 = 65_536.0;

/// The places that are used, and one of [`UNUSED`] that is kept out.
pub(super) fn split(all: &Measurement) -> (Measurement, Measurement) {
    let known = |k: usize| all.valid[0][k] || all.valid[1][k];
    let marks = held_out(&all.places, known, UNUSED);
    let part = |kept_out: bool| {
        let mut part = all.clone();
        for valid in &mut part.valid {
            for (valid, mark) in valid.iter_mut().zip(&marks) {
                *valid &= *mark == kept_out;
            }
        }
        part
    };
    (part(false), part(true))
}

/// Marks of the places that are kept out, one of `every` among those that are `known`.
fn held_out(places: &[Point], known: impl Fn(usize) -> bool, every: usize) -> Vec<bool> {
    let mut marks = vec![false; places.len()];
    let mut along: Vec<usize> = (0..places.len()).filter(|&k| known(k)).collect();
    let bounds = [0, 1].map(|axis| ends(along.iter().map(|&k| places[k][axis])));
    let [width, height] = bounds.map(|[low, high]| high - low);
    let extent = width.max(height);
    let step = |k: usize, axis: usize| {
        let part = (places[k][axis] - bounds[axis][0]) / extent.max(f64::MIN_POSITIVE);
        // Below 2¹⁶, as parts are from 0 to 1.
        (part * (STEPS - 1.0)) as u32
    };
    along.sort_by_key(|&k| (spread(step(k, 0)) | spread(step(k, 1)) << 1, k));
    for (group, members) in along.chunks(every).enumerate() {
        let choice = (every as f64 * (group as f64 * GOLDEN).fract()) as usize;
        if let Some(&place) = members.get(choice) {
            marks[place] = true;
        }
    }
    marks
}

/// The bits of a number below 2¹⁶, each followed by a zero.
fn spread(number: u32) -> u32 {
    let masks = [
        (8, 0x00FF_00FF),
        (4, 0x0F0F_0F0F),
        (2, 0x3333_3333),
        (1, 0x5555_5555),
    ];
    masks
        .into_iter()
        .fold(number, |bits, (shift, mask)| (bits | bits << shift) & mask)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn grid(columns: usize, rows: usize) -> Vec<Point> {
        let all = (0..columns * rows).map(|k| (k % columns, k / columns));
        all.map(|(i, j)| [0.5 * i as f64, 0.5 * j as f64]).collect()
    }

    /// Of how many in a row, in a column, and in a square of eight by eight; least and greatest.
    #[test]
    fn choices_are_even_over_the_plane_and_in_no_rows() {
        for (columns, rows) in [(80, 80), (64, 64), (89, 55), (96, 41)] {
            let places = grid(columns, rows);
            let marks = held_out(&places, |_| true, 16);
            let count = |columns_of: std::ops::Range<usize>, rows_of: std::ops::Range<usize>| {
                let inside = |k: &usize| {
                    columns_of.contains(&(k % columns)) && rows_of.contains(&(k / columns))
                };
                (0..places.len())
                    .filter(inside)
                    .filter(|&k| marks[k])
                    .count()
            };
            let all = count(0..columns, 0..rows);
            assert!(all.abs_diff(columns * rows / 16) <= 1, "{all}");
            for i in 0..columns / 8 {
                for j in 0..rows / 8 {
                    let found = count(8 * i..8 * i + 8, 8 * j..8 * j + 8);
                    assert!(
                        (1..=8).contains(&found),
                        "{columns} x {rows}: {found} of 64"
                    );
                }
            }
            // A sixteenth of each line is to be expected; stripes would have all of it.
            for i in 0..columns {
                assert!(count(i..i + 1, 0..rows) * 4 < rows, "column {i}");
            }
            for j in 0..rows {
                assert!(count(0..columns, j..j + 1) * 4 < columns, "row {j}");
            }
        }
    }

    /// Whatever the order of rows in a table.
    #[test]
    fn choices_do_not_depend_on_how_the_table_is_sorted() {
        let places = grid(40, 40);
        let marks = held_out(&places, |_| true, 16);
        let turned: Vec<Point> = places.iter().rev().copied().collect();
        let mut again = held_out(&turned, |_| true, 16);
        again.reverse();
        assert_eq!(marks, again);
    }

    #[test]
    fn what_is_not_known_is_not_chosen_and_few_places_are_no_trouble() {
        let places = grid(20, 20);
        let marks = held_out(&places, |k| k % 3 == 0, 16);
        assert!((0..400).all(|k| !marks[k] || k % 3 == 0));
        // One of each whole group of 134 known places; the last group of six has it only by chance.
        let count = marks.iter().filter(|mark| **mark).count();
        assert!((8..=9).contains(&count), "{count}");
        assert!(held_out(&[], |_| true, 16).is_empty());
        assert_eq!(held_out(&[[1.0, 1.0]], |_| true, 16), [true]);
        assert_eq!(
            held_out(&[[0.0; 2], [f64::MAX, 0.0]], |_| true, 1),
            [true, true]
        );
    }
}
