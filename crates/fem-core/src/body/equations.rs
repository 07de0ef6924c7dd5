//! Numbering of a body's equations and the structure of its stiffness matrix.

use std::sync::Arc;

use nalgebra::{DMatrix, SymmetricEigen};

use super::constraints::{NodeConstraint, node_constraints};
use super::elastic::ElasticBody;
use super::error::BodyError;
use super::parts::check_parts;
use super::regions::{RegionOrder, Regions};
use super::springs;
use crate::linalg::{LowerMatrix, SparseStructure, minimum_degree};
use crate::mesh::{Mesh, Point};
use crate::support::{Platen, Spring, Support};

/// Number of an equation that does not exist because its unknown is held.
pub(super) const HELD: u32 = u32::MAX;

/// What of a condensation depends only on connectivity, supports and interface: the order of the equations, the
/// pattern and symbolic factorisation of the stiffness matrix, and the rigid motions left free. Bodies that differ in
/// material or load share it.
#[derive(Clone, Debug)]
pub struct BodyStructure {
    mesh: Arc<Mesh>,
    supports: Vec<Support>,
    springs: Vec<Spring>,
    platen: Option<Platen>,
    pub(super) constraints: Vec<NodeConstraint>,
    /// Equation of each node in each of its own axes.
    pub(super) equations: Vec<[u32; 2]>,
    pub(super) unknowns: usize,
    pub(super) interface: Vec<usize>,
    /// Number of interface equations, which are the last.
    pub(super) interface_unknowns: usize,
    pub(super) pattern: LowerMatrix,
    pub(super) symbolic: SparseStructure,
    pub(super) motions: FreeMotions,
    /// Where the unknowns of each edge stand, if they are ordered by regions.
    pub(super) regions: Option<Regions>,
}

impl ElasticBody {
    /// Numbers the equations with the nodes of `interface` last and analyses the stiffness matrix's structure.
    ///
    /// # Errors
    /// A node that does not exist or appears twice, supports that are not finite or contradict each other or the platen, a
    /// part of the mesh that is neither joined nor held, or a structure too large for memory.
    pub fn analyse(&self, interface: &[usize]) -> Result<Arc<BodyStructure>, BodyError> {
        BodyStructure::new(self, interface, &[]).map(Arc::new)
    }

    /// As [`analyse`](Self::analyse), for a compliance in blocks, one for each edge of `interface`; `ends` are the ends of the edges there,
    /// ascending. Where a cell stands on two edges, or something holds a node of `interface`, the structure is that of one matrix.
    ///
    /// # Errors
    /// As [`analyse`](Self::analyse).
    pub fn analyse_edges(
        &self,
        interface: &[usize],
        ends: &[usize],
    ) -> Result<Arc<BodyStructure>, BodyError> {
        BodyStructure::new(self, interface, ends).map(Arc::new)
    }
}

impl BodyStructure {
    pub(super) fn new(
        body: &ElasticBody,
        interface: &[usize],
        ends: &[usize],
    ) -> Result<Self, BodyError> {
        let mesh = &body.mesh;
        springs::check(mesh, &body.springs)?;
        let mut constraints = node_constraints(mesh, &body.supports, body.platen.as_ref())?;
        let on_interface = flag_interface(mesh, interface)?;
        let motions = FreeMotions::of(body, &constraints)?.about(mesh, interface);
        if body.platen.is_none() {
            motions.hold_isostatically(mesh, &mut constraints, &on_interface);
        }
        let adjacency = node_adjacency(mesh);
        check_parts(body, &adjacency, &constraints)?;

        let free = |&node: &usize| {
            let own = constraints[node];
            !own.held.contains(&true) && !own.is_turned()
        };
        let by_region = if !ends.is_empty() && body.section.is_none() && interface.iter().all(free)
        {
            RegionOrder::new(mesh, &adjacency, interface, ends)?
        } else {
            None
        };
        let (order, separators) = match by_region {
            Some(order) => (order.nodes, Some(order.separators)),
            None => (minimum_degree(&adjacency, interface)?, None),
        };
        let mut equations = vec![[HELD; 2]; mesh.nodes().len()];
        let mut unknowns = 0_u32;
        for &node in &order {
            for axis in 0..2 {
                if !constraints[node].held[axis] {
                    equations[node][axis] = unknowns;
                    unknowns += 1;
                }
            }
        }
        let interface_unknowns = interface
            .iter()
            .flat_map(|&node| equations[node])
            .filter(|&equation| equation != HELD)
            .count();
        let regions = separators.map(|count| {
            let last = &order[order.len() - count..];
            let of_separators = last.iter().flat_map(|&node| equations[node]);
            let count = of_separators.filter(|&equation| equation != HELD).count();
            Regions::new(interface.len(), ends, unknowns as usize - count)
        });
        let pattern = lower_pattern(&order, &adjacency, &equations);
        let symbolic = SparseStructure::analyse(&pattern)?;
        Ok(Self {
            mesh: Arc::clone(mesh),
            supports: body.supports.clone(),
            springs: body.springs.clone(),
            platen: body.platen.clone(),
            constraints,
            equations,
            unknowns: unknowns as usize,
            interface: interface.to_vec(),
            interface_unknowns,
            pattern,
            symbolic,
            motions,
            regions,
        })
    }

    /// Refuses a body that differs in more than material and load.
    pub(super) fn check_made_for(&self, body: &ElasticBody) -> Result<(), BodyError> {
        if !Arc::ptr_eq(&self.mesh, &body.mesh) && self.mesh != body.mesh {
            return Err(BodyError::OtherStructure {
                expected: self.mesh.nodes().len(),
                found: body.mesh.nodes().len(),
            });
        }
        if self.supports != body.supports
            || self.springs != body.springs
            || self.platen != body.platen
        {
            return Err(BodyError::OtherSupports);
        }
        Ok(())
    }

    /// Number of unknowns.
    pub fn unknowns(&self) -> usize {
        self.unknowns
    }

    /// Stored entries of the Cholesky factor, explicit zeros of supernodes included.
    pub fn factor_entries(&self) -> usize {
        self.symbolic.factor_entries()
    }

    /// Floating-point operations of one Cholesky factorisation.
    pub fn factor_operations(&self) -> u64 {
        self.symbolic.operations()
    }
}

fn flag_interface(mesh: &Mesh, interface: &[usize]) -> Result<Vec<bool>, BodyError> {
    let mut flags = vec![false; mesh.nodes().len()];
    for &node in interface {
        let flag = flags.get_mut(node).ok_or(BodyError::NoSuchNode { node })?;
        if std::mem::replace(flag, true) {
            return Err(BodyError::RepeatedNode { node });
        }
    }
    Ok(flags)
}

/// Neighbours of each node in the mesh, ascending, without the node.
fn node_adjacency(mesh: &Mesh) -> Vec<Vec<u32>> {
    let mut adjacency = vec![Vec::with_capacity(24); mesh.nodes().len()];
    for block in mesh.blocks() {
        for cell in block.connectivity.chunks_exact(block.kind.nodes()) {
            for &a in cell {
                adjacency[a].extend(cell.iter().filter(|&&b| b != a).map(|&b| b as u32));
            }
        }
    }
    for neighbours in &mut adjacency {
        neighbours.sort_unstable();
        neighbours.dedup();
    }
    adjacency
}

/// Pattern of the lower triangle for equations numbered along `order`.
fn lower_pattern(order: &[usize], adjacency: &[Vec<u32>], equations: &[[u32; 2]]) -> LowerMatrix {
    let mut rank = vec![0; order.len()];
    for (position, &node) in order.iter().enumerate() {
        rank[node] = position;
    }
    let mut pattern = LowerMatrix {
        column_start: vec![0],
        ..LowerMatrix::default()
    };
    let mut later: Vec<usize> = Vec::new();
    for &node in order {
        later.clear();
        later.extend(
            adjacency[node]
                .iter()
                .map(|&b| rank[b as usize])
                .filter(|&other| other > rank[node]),
        );
        later.sort_unstable();
        for column in equations[node]
            .into_iter()
            .filter(|&equation| equation != HELD)
        {
            let own = equations[node]
                .into_iter()
                .filter(|&row| row != HELD && row >= column);
            let others = later
                .iter()
                .flat_map(|&position| equations[order[position]])
                .filter(|&row| row != HELD);
            pattern
                .rows
                .extend(own.chain(others).map(|row| row as usize));
            pattern.column_start.push(pattern.rows.len());
        }
    }
    pattern.values = vec![0.0; pattern.rows.len()];
    pattern
}

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
    fn of(body: &ElasticBody, constraints: &[NodeConstraint]) -> Result<Self, BodyError> {
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
    fn about(self, mesh: &Mesh, interface: &[usize]) -> Self {
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
    fn hold_isostatically(
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
