//! Where the entries of the whole system stand.

use nalgebra::DVector;
use stickslip_contact::InterfaceProblem;
use stickslip_fem_core::CondensedBody;
use stickslip_fem_core::linalg::SparseMatrix;

/// Displacement unknowns and their coefficients in one row of B.
pub(super) type Coefficients = Vec<(usize, f64)>;

/// The relative motion of each point and direction as a combination of displacement unknowns: the rows of B, 2n.
///
/// `first` is the first unknown of each body.
pub(super) fn contact_coefficients(
    bodies: &[Option<&CondensedBody>],
    first: &[usize],
    problem: &InterfaceProblem,
) -> Vec<Coefficients> {
    let size = 2 * problem.points().len();
    let mut rows = vec![Coefficients::new(); size];
    for (index, body) in bodies.iter().enumerate() {
        let Some(body) = body else { continue };
        let unknowns = body.interface_unknowns();
        let count = body.interface_nodes().len();
        for (row, coefficients) in rows.iter_mut().enumerate() {
            // A unit contact force acts on the nodes by the coefficients with which their displacements make its motion.
            let on_nodes = unit_force_on(problem, index, count, row);
            for at in &unknowns {
                let force = [on_nodes[2 * at.point], on_nodes[2 * at.point + 1]];
                let coefficient = at.axis[0] * force[0] + at.axis[1] * force[1];
                if coefficient != 0.0 {
                    coefficients.push((first[index] + at.unknown, coefficient));
                }
            }
        }
    }
    rows
}

fn unit_force_on(problem: &InterfaceProblem, body: usize, count: usize, row: usize) -> Vec<f64> {
    let mut force = DVector::zeros(2 * problem.points().len());
    force[row] = 1.0;
    problem.forces_on_body(body, count, &force)
}

/// Relative motion of the contact points by displacements `[length]` of body `body`'s contact points, xy interleaved.
pub(super) fn relative_motion(
    problem: &InterfaceProblem,
    body: usize,
    displacements: &[f64],
) -> DVector<f64> {
    let count = displacements.len() / 2;
    DVector::from_fn(2 * problem.points().len(), |row, _| {
        let coefficients = unit_force_on(problem, body, count, row);
        coefficients
            .iter()
            .zip(displacements)
            .map(|(coefficient, displacement)| coefficient * displacement)
            .sum()
    })
}

/// The matrix as it is being made: (column, row, value).
#[derive(Debug)]
pub(super) struct Pattern {
    entries: Vec<(usize, usize, f64)>,
    displacements: usize,
    contact: usize,
    rigid: usize,
}

impl Pattern {
    pub(super) fn new(displacements: usize, problem: &InterfaceProblem) -> Self {
        Self {
            entries: Vec::new(),
            displacements,
            contact: 2 * problem.points().len(),
            rigid: problem.modes().ncols(),
        }
    }

    /// Adds a body's stiffness from unknown `start` on, and returns its largest entry.
    pub(super) fn add_stiffness(&mut self, body: &CondensedBody, start: usize) -> f64 {
        let lower = body.structure().stiffness(body.body());
        let mut largest = 0.0_f64;
        for column in 0..lower.order() {
            for k in lower.column_start[column]..lower.column_start[column + 1] {
                let (row, value) = (lower.rows[k], lower.values[k]);
                largest = largest.max(value.abs());
                self.entries.push((start + column, start + row, value));
                if row != column {
                    self.entries.push((start + row, start + column, value));
                }
            }
        }
        largest
    }

    /// Adds −Bᵀ λ to the equilibrium, and the places of all conditions and balances with zeros.
    pub(super) fn add_contact(&mut self, rows: &[Coefficients], scale: f64) {
        for (row, coefficients) in rows.iter().enumerate() {
            let place = self.displacements + row;
            for &(unknown, coefficient) in coefficients {
                self.entries.push((place, unknown, -scale * coefficient));
                self.entries.push((unknown, place, 0.0));
            }
            self.entries.push((place, place, 0.0));
            if row % 2 == 1 {
                self.entries.push((place - 1, place, 0.0));
            }
        }
        let first = self.displacements + self.contact;
        for mode in first..first + self.rigid {
            for row in self.displacements..first {
                self.entries.push((mode, row, 0.0));
                self.entries.push((row, mode, 0.0));
            }
            for other in first..first + self.rigid {
                self.entries.push((other, mode, 0.0));
            }
        }
    }

    pub(super) fn compress(mut self) -> SparseMatrix {
        self.entries
            .sort_unstable_by_key(|&(column, row, _)| (column, row));
        let order = self.displacements + self.contact + self.rigid;
        let mut matrix = SparseMatrix {
            column_start: Vec::with_capacity(order + 1),
            rows: Vec::with_capacity(self.entries.len()),
            values: Vec::with_capacity(self.entries.len()),
        };
        for (column, row, value) in self.entries {
            while matrix.column_start.len() <= column {
                matrix.column_start.push(matrix.rows.len());
            }
            matrix.rows.push(row);
            matrix.values.push(value);
        }
        matrix.column_start.resize(order + 1, matrix.rows.len());
        matrix
    }
}
