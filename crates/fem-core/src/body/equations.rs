//! Numbering of a body's equations and the structure of its stiffness matrix.

use std::sync::Arc;

use super::constraints::{NodeConstraint, node_constraints};
use super::elastic::ElasticBody;
use super::error::BodyError;
use super::free_motions::FreeMotions;
use super::parts::check_parts;
use super::regions::{RegionOrder, Regions};
use super::springs;
use crate::linalg::{LowerMatrix, SparseStructure, minimum_degree};
use crate::mesh::Mesh;
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
