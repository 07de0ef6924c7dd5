//! Bearing and bypass: how much of a plate's load along x goes into each row of its fasteners, and how much goes on beside it.
//!
//! ```text
//! N_left  = −Σ F_x of loads, supports and contacts left of the row          section force, tension is positive
//! N_right =  Σ F_x of those right of the row
//! bearing = incoming − bypass = |F_x| of the row to rounding               incoming: the larger of both in size, bypass: the other one
//! ```
//!
//! Holes whose centres have the same x are one row.

use super::{EdgeKind, Results};

/// Distance of centres, as a part of the radius, up to which they are in one row.
const SAME: f64 = 1e-6;
/// Section force, as a part of the largest of the history, that is rounding.
const ROUNDING: f64 = 1e-6;

/// The rows of fasteners in a plate.
#[derive(Clone, Debug, PartialEq)]
pub struct PlateRows {
    /// Index of the plate in [`Results::bodies`].
    pub body: usize,
    /// Rows from left to right: x of the centres `[mm]`, and the contacts as indices into [`Results::edges`].
    pub rows: Vec<(f64, Vec<usize>)>,
}

/// Forces along x on a plate at a row `[N]`; tension is positive.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RowForces {
    /// Section force on the left of the row, from what acts there.
    pub left: f64,
    /// Section force on the right of the row, from what acts there.
    pub right: f64,
    /// Force of the fasteners of the row on the plate.
    pub fasteners: f64,
}

impl RowForces {
    /// The larger section force in size `[N]`.
    pub fn incoming(&self) -> f64 {
        if self.left.abs() >= self.right.abs() {
            self.left
        } else {
            self.right
        }
    }

    /// The smaller section force in size `[N]`.
    pub fn bypass(&self) -> f64 {
        if self.left.abs() >= self.right.abs() {
            self.right
        } else {
            self.left
        }
    }

    /// What the fasteners take of the incoming force `[N]`.
    pub fn bearing(&self) -> f64 {
        let is_left = self.left.abs() >= self.right.abs();
        if is_left {
            self.fasteners
        } else {
            -self.fasteners
        }
    }

    /// By how much incoming differs from bearing and bypass `[N]`: what the plate as a whole is out of balance.
    pub fn unbalanced(&self) -> f64 {
        self.incoming() - self.bearing() - self.bypass()
    }
}

impl Results {
    /// The plates whose bearing and bypass loads are known: with holes in contact and no other contact, with loads and supports on either side of every row, and in balance with these.
    /// Plates with one hole only where a load passes it in some step.
    pub fn plates_with_rows(&self) -> Vec<PlateRows> {
        let plates = (0..self.bodies.len()).filter_map(|body| self.rows_of(body));
        let passes = |plate: &PlateRows| {
            let contacts: usize = plate.rows.iter().map(|(_, own)| own.len()).sum();
            let all = (0..self.steps.len()).flat_map(|step| self.row_forces(plate, step));
            let all: Vec<RowForces> = all.collect();
            let most = all
                .iter()
                .fold(0.0, |most: f64, own| most.max(own.incoming().abs()));
            // Forces that belong to no set, as those of polar tractions, leave the plate out of balance.
            let is_balanced = all
                .iter()
                .all(|own| own.unbalanced().abs() <= ROUNDING * most);
            let is_passed = || all.iter().any(|own| own.bypass().abs() > ROUNDING * most);
            is_balanced && (contacts > 1 || is_passed())
        };
        plates.filter(passes).collect()
    }

    fn rows_of(&self, body: usize) -> Option<PlateRows> {
        let mut fasteners = self.fasteners.iter().flat_map(|own| &own.layers);
        if fasteners.any(|layer| layer.slice == body) {
            return None;
        }
        let mut holes: Vec<([f64; 2], f64, usize)> = Vec::new();
        for contact in self.contacts_of(body) {
            let EdgeKind::Circle { centre, radius } = self.edges[contact].kind else {
                return None;
            };
            // Of two circles of a body one surrounds the other only in a bushing.
            let is_around = |&(other, size, _): &([f64; 2], f64, usize)| {
                (centre[0] - other[0]).hypot(centre[1] - other[1]) < radius.max(size)
            };
            if holes.iter().any(is_around) {
                return None;
            }
            holes.push((centre, radius, contact));
        }
        holes.sort_by(|a, b| a.0[0].total_cmp(&b.0[0]));
        let mut rows: Vec<(f64, Vec<usize>)> = Vec::new();
        for ([x, _], radius, contact) in holes {
            match rows.last_mut() {
                Some((place, row)) if x - *place <= SAME * radius => row.push(contact),
                _ => rows.push((x, vec![contact])),
            }
        }
        let mut sets = self.sets.iter().filter(|set| set.body == body).peekable();
        // A strap of a butt joint is held by its fasteners alone; a pin or a bushing is no plate.
        if sets.peek().is_none() && rows.len() < 2 {
            return None;
        }
        let is_beside = |reach: Option<[f64; 2]>| {
            let within = |[from, to]: [f64; 2]| rows.iter().any(|(x, _)| from <= *x && *x <= to);
            reach.is_some_and(|reach| !within(reach))
        };
        let all_beside = sets.all(|set| is_beside(set.reach));
        (all_beside && !rows.is_empty()).then_some(PlateRows { body, rows })
    }

    /// Forces at each row of `plate` at the end of the step with the index `step`; none where those on its sets are not known.
    pub fn row_forces(&self, plate: &PlateRows, step: usize) -> Vec<RowForces> {
        let own = self.sets.iter().zip(&self.steps[step].sets);
        let own = own.filter(|(set, _)| set.body == plate.body);
        let sets: Option<Vec<[f64; 2]>> = own
            .map(|(set, motion)| Some([set.reach?[0], motion.as_ref()?.force * set.along[0]]))
            .collect();
        let Some(sets) = sets else {
            return Vec::new();
        };
        let row = |contacts: &[usize]| {
            let forces = contacts
                .iter()
                .map(|&own| self.force_on(plate.body, own, step)[0]);
            forces.sum::<f64>()
        };
        let rows = plate.rows.iter().map(|(x, contacts)| [*x, row(contacts)]);
        let rows: Vec<[f64; 2]> = rows.collect();
        let beyond = |is_there: &dyn Fn(f64) -> bool| {
            let all = rows
                .iter()
                .chain(&sets)
                .filter(|[place, _]| is_there(*place));
            all.map(|[_, force]| force).sum::<f64>()
        };
        let forces = |&[x, fasteners]: &[f64; 2]| RowForces {
            left: -beyond(&|place| place < x),
            right: beyond(&|place| place > x),
            fasteners,
        };
        rows.iter().map(forces).collect()
    }
}
