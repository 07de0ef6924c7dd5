//! Contact points that move along their edges.

use nalgebra::DVector;
use stickslip_fem_core::InterfaceOperator;

use super::InterfaceProblem;
use super::compliance::add_compliance;
use super::contacts::{ContactPair, Contacts, Couple};
use super::stencil::BodyRows;

impl InterfaceProblem {
    /// Moves the contact points to those of `pairs`: as many in each pair, with other frames, gaps and stencils, and `couples`. The compliance
    /// is that of the new points between those that are `in_play`; other entries stay as they are. Units, and which points slide, stay too.
    pub(crate) fn move_points(
        &mut self,
        bodies: &[&dyn InterfaceOperator],
        pairs: Vec<ContactPair>,
        couples: Vec<Couple>,
        in_play: &[bool],
    ) {
        let mut contacts = Contacts::new(pairs, bodies).with_couples(couples);
        for (point, own) in contacts.points_mut().iter_mut().zip(self.points()) {
            point.slides = own.slides;
        }
        self.contacts = contacts;
        let chosen: Vec<usize> = (0..in_play.len()).filter(|&k| in_play[k]).collect();
        let matrix = self.compliance.make_matrix();
        for &pushed in &chosen {
            for &seen in &chosen {
                matrix
                    .fixed_view_mut::<2, 2>(2 * seen, 2 * pushed)
                    .fill(0.0);
            }
        }
        self.modes.fill(0.0);
        self.case_motion
            .iter_mut()
            .for_each(|motion| motion.fill(0.0));
        for (index, body) in bodies.iter().enumerate() {
            let mut rows = self.body_rows(index);
            self.add_motions(index, *body, &rows);
            rows.retain(|row| in_play[row.point]);
            if let Some(compliance) = body.matrix() {
                add_compliance(self.compliance.make_matrix(), &rows, &compliance);
            }
            self.add_couples(index, *body, &rows, &chosen);
        }
        for (mode, unit) in self.mode_units.iter().enumerate() {
            self.modes.column_mut(mode).scale_mut(*unit);
        }
    }

    /// Adds what the couples of body `index` do, whose rows are `rows`, those of the points `chosen` in play. With D and T the columns of d and τ,
    ///
    /// ```text
    /// (B + D Tᵀ) C (B + D Tᵀ)ᵀ = B C Bᵀ + Y Dᵀ + D Yᵀ,      Y = (B + ½ D Tᵀ) C T
    /// ```
    fn add_couples(
        &mut self,
        index: usize,
        body: &dyn InterfaceOperator,
        rows: &[BodyRows],
        chosen: &[usize],
    ) {
        let couples: Vec<Couple> = (self.contacts.couples().iter())
            .filter(|couple| couple.body == index)
            .cloned()
            .collect();
        let size = 2 * self.points().len();
        let columns: Vec<DVector<f64>> = couples.iter().map(|couple| couple.column(size)).collect();
        for (couple, own) in couples.iter().zip(&columns) {
            self.add_turns(index, body, couple, own);
            let Some(compliance) = body.matrix() else {
                continue;
            };
            let mut moved = DVector::zeros(compliance.nrows());
            for (node, turn) in &couple.turn {
                for (axis, factor) in turn.iter().enumerate() {
                    moved.axpy(*factor, &compliance.column(2 * node + axis), 1.0);
                }
            }
            let mut seen = DVector::zeros(size);
            for row in rows {
                let mut target = seen.fixed_rows_mut::<2>(2 * row.point);
                for (node, weight) in &row.terms {
                    target += weight * moved.fixed_rows::<2>(2 * node);
                }
            }
            for (other, column) in couples.iter().zip(&columns) {
                seen.axpy(0.5 * other.turn_of(moved.as_slice()), column, 1.0);
            }
            self.add_product(own, &seen, chosen);
        }
    }

    /// Adds the turns that rigid motions and loads of body `index` make of the edge of `couple`, whose column of d is `column`.
    fn add_turns(
        &mut self,
        index: usize,
        body: &dyn InterfaceOperator,
        couple: &Couple,
        column: &DVector<f64>,
    ) {
        let modes = self.body_modes(index);
        for (mode, motion) in modes.zip(body.modes().column_iter()) {
            let turn = couple.turn_of(motion.as_slice());
            self.modes.column_mut(mode).axpy(turn, column, 1.0);
        }
        for (case, motion) in self.case_motion.iter_mut().enumerate() {
            if let Some(response) = body.load_response(case) {
                motion.axpy(couple.turn_of(response.as_slice()), column, 1.0);
            }
        }
    }

    /// Adds a bᵀ + b aᵀ to the compliance between the points `chosen`.
    fn add_product(&mut self, a: &DVector<f64>, b: &DVector<f64>, chosen: &[usize]) {
        let rows = || chosen.iter().flat_map(|k| [2 * k, 2 * k + 1]);
        let matrix = self.compliance.make_matrix();
        for column in rows().filter(|&row| a[row] != 0.0 || b[row] != 0.0) {
            for row in rows() {
                matrix[(row, column)] += a[row] * b[column] + b[row] * a[column];
            }
        }
    }

    /// Sets the initial gap `[length]` of every point.
    pub(crate) fn set_gaps(&mut self, gaps: &[f64]) {
        self.contacts.set_gaps(gaps);
    }
}
