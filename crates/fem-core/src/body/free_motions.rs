//! Rigid motions that supports leave free.

use nalgebra::{DMatrix, SymmetricEigen};

use super::constraints::NodeConstraint;
use super::elastic::ElasticBody;
use super::error::BodyError;
use crate::mesh::{Mesh, Point};

/// Rigid motions that the supports leave free, as combinations of two translations and a turn.
#[derive(Clone, Debug)]
pub(super) struct FreeMotions {
    centre: Point,
    length: f64,
    /// 3 × f.
    combinations: DMatrix<f64>,
}

impl FreeMotions {
    /// Null space of the supports and springs on the candidate motions: all three, or the translations that a platen is free to make,
    /// which supports elsewhere must not resist: the platen would then move by deforming the body.
    pub(super) fn of(
        body: &ElasticBody,
        constraints: &[NodeConstraint],
    ) -> Result<Self, BodyError> {
        let [low, high] = body.mesh.bounding_box();
        let centre = [
            f64::midpoint(low[0], high[0]),
            f64::midpoint(low[1], high[1]),
        ];
        let length = (high[0] - low[0])
            .hypot(high[1] - low[1])
            .max(f64::MIN_POSITIVE);
        let mut motions = Self {
            centre,
            length,
            combinations: DMatrix::identity(3, 3),
        };
        let mut counts = vec![true; constraints.len()];
        if let Some(platen) = &body.platen {
            let free: Vec<usize> = (0..2).filter(|&i| platen.free[i]).collect();
            motions.combinations = motions.combinations.select_columns(&free);
            platen.nodes.iter().for_each(|&node| counts[node] = false);
        }
        let candidates = motions.count();
        let mut gram = DMatrix::zeros(candidates, candidates);
        let mut holds = 0;
        for (node, constraint) in constraints
            .iter()
            .enumerate()
            .filter(|&(node, _)| counts[node])
        {
            for axis in (0..2).filter(|&axis| constraint.held[axis]) {
                let row = motions.row(&body.mesh, node, constraint.axes()[axis]);
                gram += row.transpose() * row;
                holds += 1;
            }
        }
        // Springs on the platen itself resist it too.
        for (node, direction) in body.sprung() {
            let row = motions.row(&body.mesh, node, direction);
            gram += row.transpose() * row;
            holds += 1;
        }
        if holds > 0 && candidates > 0 {
            let eigen = SymmetricEigen::new(gram);
            let free: Vec<usize> = (0..candidates)
                .filter(|&k| eigen.eigenvalues[k] <= 1e-12 * f64::from(holds))
                .collect();
            if body.platen.is_some() && free.len() < candidates {
                return Err(BodyError::PlatenResisted {
                    free: candidates,
                    left: free.len(),
                });
            }
            motions.combinations = &motions.combinations * eigen.eigenvectors.select_columns(&free);
        }
        Ok(motions)
    }

    /// The same motions with turns about the middle of the nodes `interface`, divided by their extent: on a body much larger than
    /// its contacts, turns about its own middle and translations would be nearly the same there.
    pub(super) fn about(self, mesh: &Mesh, interface: &[usize]) -> Self {
        let Some((centre, length)) = extent(interface.iter().map(|&node| mesh.nodes()[node]))
        else {
            return self;
        };
        let combinations = if self.count() == 3 {
            self.combinations
        } else {
            let [dx, dy] = [0, 1].map(|i| (centre[i] - self.centre[i]) / self.length);
            let turn = length / self.length;
            let change =
                DMatrix::from_row_slice(3, 3, &[1.0, 0.0, -dy, 0.0, 1.0, dx, 0.0, 0.0, turn]);
            let mut changed = change * self.combinations;
            for mut column in changed.column_iter_mut() {
                column.normalize_mut();
            }
            changed
        };
        Self {
            centre,
            length,
            combinations,
        }
    }

    /// Number of free motions.
    pub(super) fn count(&self) -> usize {
        self.combinations.ncols()
    }

    /// Component of each free motion at a node along `direction`, 1 × f.
    fn row(&self, mesh: &Mesh, node: usize, direction: [f64; 2]) -> DMatrix<f64> {
        let [x, y] = mesh.nodes()[node];
        let turn = [
            -(y - self.centre[1]) / self.length,
            (x - self.centre[0]) / self.length,
        ];
        let basis = [
            direction[0],
            direction[1],
            direction[0] * turn[0] + direction[1] * turn[1],
        ];
        DMatrix::from_row_slice(1, 3, &basis) * &self.combinations
    }

    /// Displacement of a node by each free motion, 2 × f.
    pub(super) fn at(&self, mesh: &Mesh, node: usize) -> DMatrix<f64> {
        let mut both = DMatrix::zeros(2, self.count());
        both.row_mut(0).copy_from(&self.row(mesh, node, [1.0, 0.0]));
        both.row_mut(1).copy_from(&self.row(mesh, node, [0.0, 1.0]));
        both
    }

    /// Holds one unknown per free motion so that the stiffness matrix becomes regular. Which ones does not change any
    /// answer, because the balance of the body makes their reactions vanish. Nodes near the interface are taken, so that its
    /// compliance is not the small difference of large motions; those of the interface only where the others have no leverage.
    pub(super) fn hold_isostatically(
        &self,
        mesh: &Mesh,
        constraints: &mut [NodeConstraint],
        on_interface: &[bool],
    ) {
        const LEVERAGE: f64 = 0.05;
        let mut basis: Vec<DMatrix<f64>> = Vec::new();
        for _ in 0..self.count() {
            let near = |node: usize| {
                let [x, y] = mesh.nodes()[node];
                (x - self.centre[0]).hypot(y - self.centre[1]) <= self.length
            };
            let best_of = |allowed: &dyn Fn(usize) -> bool| {
                let best = self.best_hold(mesh, constraints, &basis, allowed);
                best.filter(|hold| hold.size > LEVERAGE)
            };
            let best = best_of(&|node| !on_interface[node] && near(node))
                .or_else(|| best_of(&|node| !on_interface[node]))
                .or_else(|| self.best_hold(mesh, constraints, &basis, |_| true));
            if let Some(hold) = best {
                constraints[hold.node].held[hold.axis] = true;
                basis.push(hold.row / hold.size);
            }
        }
    }

    /// The unknown of the nodes `allowed` that the free motions, less those in `basis`, move most.
    fn best_hold(
        &self,
        mesh: &Mesh,
        constraints: &[NodeConstraint],
        basis: &[DMatrix<f64>],
        allowed: impl Fn(usize) -> bool,
    ) -> Option<Hold> {
        let mut best: Option<Hold> = None;
        for node in (0..constraints.len()).filter(|&node| allowed(node)) {
            for axis in (0..2).filter(|&axis| !constraints[node].held[axis]) {
                let mut row = self.row(mesh, node, constraints[node].axes()[axis]);
                for known in basis {
                    let along = row.dot(known);
                    row -= known * along;
                }
                let size = row.norm();
                if best
                    .as_ref()
                    .is_none_or(|largest| size > largest.size * (1.0 + 1e-9))
                {
                    best = Some(Hold {
                        size,
                        node,
                        axis,
                        row,
                    });
                }
            }
        }
        best
    }
}

/// Middle and diagonal of the box around `points`; `None` if that has no extent.
fn extent(points: impl Iterator<Item = Point>) -> Option<(Point, f64)> {
    let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
    for point in points {
        for i in 0..2 {
            low[i] = low[i].min(point[i]);
            high[i] = high[i].max(point[i]);
        }
    }
    let length = (high[0] - low[0]).hypot(high[1] - low[1]);
    let centre = [0, 1].map(|i| f64::midpoint(low[i], high[i]));
    (length > 0.0 && length.is_finite()).then_some((centre, length))
}

/// An unknown that could be held, and how the motions move it: 1 × f, and its norm.
struct Hold {
    size: f64,
    node: usize,
    axis: usize,
    row: DMatrix<f64>,
}
