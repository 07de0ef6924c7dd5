//! A body some of whose displacements are prescribed, with other values again and again.
//!
//! With Δ¹ the prescribed displacements, Δ² all others and F² the forces on these,
//!
//! ```text
//! Δ² = K₂₂⁻¹ (F² − K₂₁ Δ¹),   F¹ = K₁₁ Δ¹ + K₁₂ Δ²,
//! y = A₁ Δ¹ + A₂ Δ²   ⇒   ∂y/∂Δ¹ = A₁ − (K₂₂⁻¹ A₂ᵀ)ᵀ K₂₁.
//! ```
//!
//! K₂₂ is factorised once; the rows K₁ of the prescribed displacements are kept. Everything else is triangular solves.

use std::collections::BTreeMap;
use std::sync::Arc;

use super::elastic::ElasticBody;
use super::equations::{BodyStructure, HELD};
use super::error::BodyError;
use crate::element::{Element, KindVisitor, gather, stiffness, with_element};
use crate::linalg::SparseCholesky;
use crate::material::PlaneStiffness;
use crate::support::{HeldDirection, Support};

/// A number for each of some degrees of freedom; degree 2·node + axis is the displacement of `node` along x (0) or y (1).
pub type SparseRow = Vec<(usize, f64)>;

/// A body with K₂₂ factorised. What its supports hold stays where it is, at zero.
#[derive(Clone, Debug)]
pub struct PartitionedBody {
    body: Arc<ElasticBody>,
    structure: Arc<BodyStructure>,
    factor: SparseCholesky,
    prescribed: Vec<usize>,
    /// Rows K₁ of the whole stiffness matrix, over all degrees of freedom.
    rows: Vec<SparseRow>,
    /// The same over the unknowns: K₁₂.
    coupling: Vec<SparseRow>,
}

/// Solutions for several sets of prescribed displacements.
#[derive(Clone, Debug)]
pub struct PartitionedStates<'a> {
    body: &'a PartitionedBody,
    values: &'a [f64],
    count: usize,
    unknowns: Vec<f64>,
}

impl PartitionedBody {
    /// Prescribes the degrees of freedom `prescribed` (2·node + axis) of `body`, each once, and factorises K₂₂.
    ///
    /// # Errors
    /// [`BodyError::NoSuchNode`], [`BodyError::RepeatedNode`]; [`BodyError::ContradictingSupports`] for a node that a skew
    /// support holds; [`BodyError::LoosePart`] if a part of the body can still move rigidly; [`BodyError::Factor`].
    pub fn new(body: &Arc<ElasticBody>, prescribed: &[usize]) -> Result<Self, BodyError> {
        let mut position = vec![usize::MAX; 2 * body.mesh.nodes().len()];
        for (k, &dof) in prescribed.iter().enumerate() {
            let node = dof / 2;
            let slot = position
                .get_mut(dof)
                .ok_or(BodyError::NoSuchNode { node })?;
            if std::mem::replace(slot, k) != usize::MAX {
                return Err(BodyError::RepeatedNode { node });
            }
        }
        let holds = [HeldDirection::X, HeldDirection::Y].into_iter().enumerate();
        let held = ElasticBody::clone(body).with_supports(holds.map(|(axis, direction)| {
            Support {
                nodes: (prescribed.iter().filter(|&dof| dof % 2 == axis))
                    .map(|dof| dof / 2)
                    .collect(),
                direction,
                displacement: 0.0,
            }
        }));
        let structure = held.analyse(&[])?;
        let motions = structure.motions.count();
        if motions > 0 {
            // A motion of the whole body moves each of its parts, so that any node's part is loose.
            return Err(BodyError::LoosePart {
                node: 0,
                at: body.mesh().nodes()[0],
                parts: 1,
                motions,
            });
        }
        if let Some(dof) =
            (prescribed.iter()).find(|&dof| structure.constraints[dof / 2].is_turned())
        {
            return Err(BodyError::ContradictingSupports { node: dof / 2 });
        }
        let factor = SparseCholesky::factorise(&structure.symbolic, &structure.stiffness(&held))?;
        let rows = stiffness_rows(body, &position, prescribed.len());
        let coupling = rows.iter().map(|row| structure.on_unknowns(row)).collect();
        Ok(Self {
            body: Arc::clone(body),
            structure,
            factor,
            prescribed: prescribed.to_vec(),
            rows,
            coupling,
        })
    }

    /// The body.
    pub fn body(&self) -> &Arc<ElasticBody> {
        &self.body
    }

    /// The prescribed degrees of freedom, in the order of their values.
    pub fn prescribed(&self) -> &[usize] {
        &self.prescribed
    }

    /// Number of unknowns: the order of K₂₂.
    pub fn unknowns(&self) -> usize {
        self.structure.unknowns
    }

    /// Row K₁ of each prescribed degree of freedom `[force/length]`: its reaction is this row times all displacements.
    pub fn reaction_rows(&self) -> &[SparseRow] {
        &self.rows
    }

    /// Solves for several states in one pass through the factor. `values` `[length]` holds the prescribed displacements of one
    /// state after the other (nothing, and there is one state, if no displacement is prescribed); `forces` `[force]`, empty or interleaved over all nodes, acts in every state.
    pub fn solve<'a>(&'a self, values: &'a [f64], forces: &[f64]) -> PartitionedStates<'a> {
        let own = self.prescribed.len();
        let count = values.len().checked_div(own).unwrap_or(1);
        let load = self.structure.to_unknowns(forces);
        let mut sides = Vec::with_capacity(self.unknowns() * count);
        for state in 0..count {
            let first = sides.len();
            sides.extend_from_slice(&load);
            let side = &mut sides[first..];
            let values = &values[state * own..(state + 1) * own];
            for (row, value) in self.coupling.iter().zip(values) {
                for &(k, entry) in row {
                    side[k] -= entry * value;
                }
            }
        }
        self.factor.solve(&mut sides);
        PartitionedStates {
            body: self,
            values,
            count,
            unknowns: sides,
        }
    }

    /// Derivatives of outputs y = A Δ with respect to the prescribed displacements, one column of numbers per row of
    /// `outputs`, one after the other: as many solves as outputs, in one pass through the factor. In the unit of an output per `[length]`.
    pub fn derivatives(&self, outputs: &[SparseRow]) -> Vec<f64> {
        let unknowns = self.unknowns();
        let mut sides = vec![0.0; unknowns * outputs.len()];
        for (k, row) in outputs.iter().enumerate() {
            let side = &mut sides[k * unknowns..(k + 1) * unknowns];
            for (unknown, weight) in self.structure.on_unknowns(row) {
                side[unknown] += weight;
            }
        }
        self.factor.solve(&mut sides);
        let mut derivatives = Vec::with_capacity(self.prescribed.len() * outputs.len());
        let mut direct = vec![0.0; 2 * self.body.mesh.nodes().len()];
        for (k, row) in outputs.iter().enumerate() {
            let adjoint = &sides[k * unknowns..(k + 1) * unknowns];
            for &(dof, weight) in row {
                direct[dof] += weight;
            }
            derivatives.extend(
                self.prescribed
                    .iter()
                    .zip(&self.coupling)
                    .map(|(&dof, row)| {
                        let through: f64 = row.iter().map(|&(k, entry)| entry * adjoint[k]).sum();
                        direct[dof] - through
                    }),
            );
            for &(dof, _) in row {
                direct[dof] = 0.0;
            }
        }
        derivatives
    }
}

impl PartitionedStates<'_> {
    /// Number of states.
    pub fn count(&self) -> usize {
        self.count
    }

    /// Displacements of all nodes `[length]`, interleaved, of state `state`, which is less than [`count`](Self::count).
    pub fn displacements(&self, state: usize) -> Vec<f64> {
        let count = self.body.structure.equations.len();
        let mut u = vec![0.0; 2 * count];
        self.read(state, 0..count, &mut u);
        u
    }

    /// Writes the displacements of `nodes` and of all prescribed degrees of freedom in state `state`, less than
    /// [`count`](Self::count), into `u` `[length]`, which has two places for each node of the mesh; the others stay as they are.
    pub fn read(&self, state: usize, nodes: impl IntoIterator<Item = usize>, u: &mut [f64]) {
        let structure = &self.body.structure;
        let unknowns = &self.unknowns[state * structure.unknowns..(state + 1) * structure.unknowns];
        for node in nodes {
            let local = structure.equations[node].map(|equation| match equation {
                HELD => 0.0,
                equation => unknowns[equation as usize],
            });
            u[2 * node..2 * node + 2]
                .copy_from_slice(&structure.constraints[node].to_global(local));
        }
        let own = self.body.prescribed.len();
        let values = &self.values[state * own..(state + 1) * own];
        for (&dof, &value) in self.body.prescribed.iter().zip(values) {
            u[dof] = value;
        }
    }
}

impl BodyStructure {
    /// Numbers on degrees of freedom as numbers on the unknowns that move them.
    fn on_unknowns(&self, row: &[(usize, f64)]) -> SparseRow {
        let mut spread = SparseRow::new();
        for &(dof, value) in row {
            let (node, axis) = (dof / 2, dof % 2);
            let axes = self.constraints[node].axes();
            for (equation, direction) in self.equations[node].into_iter().zip(axes) {
                if equation != HELD && direction[axis] != 0.0 {
                    spread.push((equation as usize, value * direction[axis]));
                }
            }
        }
        spread
    }
}

/// The `count` rows of the whole stiffness matrix whose degrees of freedom have a `position`.
fn stiffness_rows(body: &ElasticBody, position: &[usize], count: usize) -> Vec<SparseRow> {
    let mut rows = vec![BTreeMap::new(); count];
    for (block, stiffness) in body.mesh.blocks().iter().zip(&body.stiffnesses()) {
        let visit = CollectRows {
            body,
            connectivity: &block.connectivity,
            stiffness,
            position,
            rows: &mut rows,
        };
        with_element(block.kind, visit);
    }
    rows.into_iter()
        .map(|row| row.into_iter().collect())
        .collect()
}

struct CollectRows<'a> {
    body: &'a ElasticBody,
    connectivity: &'a [usize],
    stiffness: &'a PlaneStiffness,
    position: &'a [usize],
    rows: &'a mut [BTreeMap<usize, f64>],
}

impl KindVisitor for CollectRows<'_> {
    type Output = ();

    fn visit<const N: usize, E: Element<N>>(self) {
        let mut local = vec![0.0; 4 * N * N];
        for cell in self.connectivity.chunks_exact(N) {
            let own = |k: usize| 2 * cell[k / 2] + k % 2;
            if (0..2 * N).all(|k| self.position[own(k)] == usize::MAX) {
                continue;
            }
            let x = gather::<N>(self.body.mesh.nodes(), cell);
            stiffness::<N, E>(&x, self.stiffness, self.body.thickness, &mut local);
            for (k, line) in local.chunks_exact(2 * N).enumerate() {
                if let Some(row) = self.rows.get_mut(self.position[own(k)]) {
                    for (l, &entry) in line.iter().enumerate() {
                        *row.entry(own(l)).or_insert(0.0) += entry;
                    }
                }
            }
        }
    }
}
