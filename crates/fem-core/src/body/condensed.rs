//! A finite-element body condensed to its contact nodes.

mod balance;
mod compress;
mod residual;
mod section;
mod unknowns;

use std::sync::Arc;

use nalgebra::{DMatrix, DVector};

use super::assembly::{Assembled, assemble};
use super::elastic::ElasticBody;
use super::equations::{BodyStructure, HELD};
use super::error::BodyError;
use crate::interface::{BlockCompliance, InterfaceOperator};
use crate::linalg::{SparseCholesky, invert_from_cholesky, solve_lower_transposed};
use crate::load::initial_strain_load;
use crate::mesh::Point;
use section::Section;

pub use balance::BodyBalance;

/// A linear elastic body seen from its contact nodes, with its factor kept for the fields inside.
///
/// Cost: one numeric factorisation, one dense inverse of the interface's size, and half a sparse solve per load case.
#[derive(Clone, Debug)]
pub struct CondensedBody {
    body: Arc<ElasticBody>,
    structure: Arc<BodyStructure>,
    factor: SparseCholesky,
    points: Vec<Point>,
    compliance: Compliance,
    modes: DMatrix<f64>,
    /// Forces of each load case on the unknowns; `None` for a case that does not load this body.
    case_forces: Vec<Option<Vec<f64>>>,
    /// Half the sum of the nodal forces of each load case, on held nodes as well `[force]`.
    case_sums: Vec<f64>,
    responses: Vec<Option<DVector<f64>>>,
    mode_loads: Vec<DVector<f64>>,
    section: Option<Section>,
}

/// C on the contact nodes.
#[derive(Clone, Debug)]
enum Compliance {
    Matrix(DMatrix<f64>),
    Blocks(BlockCompliance),
}

impl ElasticBody {
    /// As [`condense`](Self::condense), with the compliance in blocks as by [`analyse_edges`](Self::analyse_edges).
    ///
    /// # Errors
    /// As [`condense`](Self::condense).
    pub fn condense_edges(
        self: &Arc<Self>,
        interface: &[usize],
        ends: &[usize],
    ) -> Result<CondensedBody, BodyError> {
        CondensedBody::new(Arc::clone(self), self.analyse_edges(interface, ends)?)
    }

    /// Condenses the body to the nodes of `interface`, in that order: one factorisation.
    ///
    /// # Errors
    /// As [`analyse`](Self::analyse); [`BodyError::Factor`] if the stiffness matrix is not positive definite, as where two
    /// parts share a single node about which they can turn.
    pub fn condense(self: &Arc<Self>, interface: &[usize]) -> Result<CondensedBody, BodyError> {
        CondensedBody::new(Arc::clone(self), self.analyse(interface)?)
    }
}

impl CondensedBody {
    /// Condenses `body` with a structure made by [`ElasticBody::analyse`], perhaps of a body that differs in material.
    ///
    /// # Errors
    /// [`BodyError::OtherStructure`], [`BodyError::OtherSupports`]; [`BodyError::Factor`] if the stiffness matrix is not positive definite.
    pub fn new(body: Arc<ElasticBody>, structure: Arc<BodyStructure>) -> Result<Self, BodyError> {
        structure.check_made_for(&body)?;
        let assembled = assemble(&body, &structure);
        Self::of_matrix(body, structure, assembled)
    }

    /// Condenses `body` with a matrix assembled for it.
    pub(super) fn of_matrix(
        body: Arc<ElasticBody>,
        structure: Arc<BodyStructure>,
        assembled: Assembled,
    ) -> Result<Self, BodyError> {
        let factor = SparseCholesky::factorise(&structure.symbolic, &assembled.matrix)?;
        drop(assembled.matrix);
        let (compliance, lower) = match &structure.regions {
            None => {
                let lower = factor.trailing_block(structure.interface_unknowns);
                let inverse = invert_from_cholesky(&lower);
                (Compliance::Matrix(structure.spread(inverse)), Some(lower))
            }
            Some(regions) => (Compliance::Blocks(regions.compliance(&factor)), None),
        };
        let mut condensed = Self {
            points: structure
                .interface
                .iter()
                .map(|&node| body.mesh.nodes()[node])
                .collect(),
            compliance,
            modes: structure.interface_modes(&body),
            case_forces: Vec::new(),
            case_sums: Vec::new(),
            responses: Vec::new(),
            mode_loads: Vec::new(),
            section: None,
            body,
            structure,
            factor,
        };
        condensed.add_load_cases(&assembled.support_forces, lower.as_ref());
        condensed.hold_section()?;
        Ok(condensed)
    }

    fn add_load_cases(&mut self, support_forces: &[f64], lower: Option<&DMatrix<f64>>) {
        let stiffnesses = self.body.stiffnesses();
        for case in &self.body.cases {
            let mut nodal = case.forces.clone();
            if !case.initial_strain.is_empty() {
                let thermal = initial_strain_load(
                    &self.body.mesh,
                    &stiffnesses,
                    &case.initial_strain,
                    self.body.thickness,
                );
                if nodal.is_empty() {
                    nodal = thermal;
                } else {
                    nodal
                        .iter_mut()
                        .zip(thermal)
                        .for_each(|(sum, part)| *sum += part);
                }
            }
            self.mode_loads
                .push(self.structure.mode_load(&self.body, &nodal));
            self.case_sums
                .push(nodal.iter().map(|force| force.abs()).sum::<f64>() / 2.0);
            let mut forces = self.structure.to_unknowns(&nodal);
            if case.moves_supports {
                forces
                    .iter_mut()
                    .zip(support_forces)
                    .for_each(|(sum, part)| *sum += part);
            }
            if forces.iter().all(|&force| force == 0.0) {
                self.case_forces.push(None);
                self.responses.push(None);
                continue;
            }
            let tail = self.interface_response(&forces, lower);
            self.responses.push(Some(
                self.structure.spread_response(&tail, case.moves_supports),
            ));
            self.case_forces.push(Some(forces));
        }
    }

    /// Displacements of the interface unknowns by `forces` on all unknowns: half a sparse solve where the trailing block `lower` of the
    /// factor is theirs, else a whole one.
    fn interface_response(&self, forces: &[f64], lower: Option<&DMatrix<f64>>) -> DVector<f64> {
        let mut solution = forces.to_vec();
        let Some(lower) = lower else {
            self.factor.solve(&mut solution);
            let own = self.structure.interface_equations();
            return DVector::from_iterator(
                self.structure.interface_unknowns,
                own.map(|unknown| solution[unknown]),
            );
        };
        self.factor.solve_lower(&mut solution);
        let first = self.structure.unknowns - lower.nrows();
        let mut tail = DVector::from_column_slice(&solution[first..]);
        solve_lower_transposed(lower, &mut tail);
        tail
    }

    /// Displacements `[length]` of the contact points, 2n, by nodal forces that balance themselves, and these forces on the
    /// unknowns.
    pub(super) fn response_to(&self, nodal: &[f64]) -> (DVector<f64>, Vec<f64>) {
        let forces = self.structure.to_unknowns(nodal);
        let count = self.structure.interface_unknowns;
        let undivided = self.structure.regions.is_none();
        let lower = undivided.then(|| self.factor.trailing_block(count));
        let tail = self.interface_response(&forces, lower.as_ref());
        (self.structure.spread_response(&tail, false), forces)
    }

    /// As [`displacements`](Self::displacements), with `further` forces on the unknowns.
    pub(super) fn displacements_with(&self, state: &BodyLoad<'_>, further: &[f64]) -> Vec<f64> {
        let mut side = self.right_hand_side(state.forces, state.multipliers);
        side.iter_mut()
            .zip(further)
            .for_each(|(sum, part)| *sum += part);
        self.factor.solve(&mut side);
        self.displacement(&side, state)
    }

    /// The body.
    pub fn body(&self) -> &Arc<ElasticBody> {
        &self.body
    }

    /// The structure, to condense a body that differs in material or load only.
    pub fn structure(&self) -> &Arc<BodyStructure> {
        &self.structure
    }

    /// Mesh nodes of the interface, in the order of the contact points.
    pub fn interface_nodes(&self) -> &[usize] {
        &self.structure.interface
    }

    /// Displacements of all nodes `[length]`, interleaved, under interface forces `forces` (2n) `[force]`, load cases times
    /// `multipliers`, and rigid motions `motions` (f) `[length]`: one pair of sparse triangular solves.
    pub fn displacements(&self, forces: &[f64], multipliers: &[f64], motions: &[f64]) -> Vec<f64> {
        let state = BodyLoad {
            forces,
            multipliers,
            motions,
        };
        self.displacements_of(&[state]).swap_remove(0)
    }

    /// Displacements of all nodes `[length]`, interleaved, of each of `states`: one pair of sparse triangular solves that
    /// passes over the factor once for all of them.
    pub fn displacements_of(&self, states: &[BodyLoad<'_>]) -> Vec<Vec<f64>> {
        let unknowns = self.structure.unknowns;
        let mut sides = Vec::with_capacity(unknowns * states.len());
        for state in states {
            sides.extend(self.right_hand_side(state.forces, state.multipliers));
        }
        self.factor.solve(&mut sides);
        let part = |k: usize| &sides[k * unknowns..(k + 1) * unknowns];
        (states.iter().enumerate())
            .map(|(k, state)| self.displacement(part(k), state))
            .collect()
    }

    fn displacement(&self, unknowns: &[f64], state: &BodyLoad<'_>) -> Vec<f64> {
        let structure = &self.structure;
        let cases = self.body.cases.iter().zip(state.multipliers);
        let support_scale: f64 = cases
            .filter(|(case, _)| case.moves_supports)
            .map(|(_, m)| m)
            .sum();
        let motions = DVector::from_column_slice(state.motions);
        let mut u = vec![0.0; 2 * structure.equations.len()];
        for (node, equations) in structure.equations.iter().enumerate() {
            let constraint = structure.constraints[node];
            let local = std::array::from_fn(|axis| match equations[axis] {
                HELD => support_scale * constraint.displacement[axis],
                equation => unknowns[equation as usize],
            });
            let mut at_node = constraint.to_global(local);
            if !motions.is_empty() && self.section.is_none() {
                let rigid = structure.motions.at(&self.body.mesh, node) * &motions;
                at_node = [at_node[0] + rigid[0], at_node[1] + rigid[1]];
            }
            u[2 * node..2 * node + 2].copy_from_slice(&at_node);
        }
        if let Some(section) = &self.section {
            let amounts = section.amounts(&u, support_scale, &motions);
            let rigid = self.all_rigid_displacements(&amounts);
            let both = u.iter_mut().zip(rigid);
            both.for_each(|(sum, part)| *sum += part);
        }
        u
    }

    /// Displacements of all nodes `[length]`, interleaved, by the free rigid motions with the amounts `motions` (f) `[length]`.
    pub fn rigid_displacements(&self, motions: &[f64]) -> Vec<f64> {
        let motions = DVector::from_column_slice(motions);
        match &self.section {
            Some(section) => self.all_rigid_displacements(&section.of_free(&motions)),
            None => self.all_rigid_displacements(&motions),
        }
    }

    /// The same by all rigid motions that supports leave, also those in which the section is held.
    fn all_rigid_displacements(&self, motions: &DVector<f64>) -> Vec<f64> {
        let structure = &self.structure;
        let count = structure.equations.len();
        if motions.is_empty() {
            return vec![0.0; 2 * count];
        }
        (0..count)
            .flat_map(|node| {
                let at_node = structure.motions.at(&self.body.mesh, node) * motions;
                [at_node[0], at_node[1]]
            })
            .collect()
    }

    pub(super) fn right_hand_side(&self, forces: &[f64], multipliers: &[f64]) -> Vec<f64> {
        let structure = &self.structure;
        let mut side = vec![0.0; structure.unknowns];
        for (case, &factor) in self.case_forces.iter().zip(multipliers) {
            if let Some(case) = case {
                side.iter_mut()
                    .zip(case)
                    .for_each(|(sum, part)| *sum += factor * part);
            }
        }
        for (force, &node) in forces.chunks_exact(2).zip(&structure.interface) {
            let local = structure.constraints[node].to_local([force[0], force[1]]);
            for axis in 0..2 {
                if structure.equations[node][axis] != HELD {
                    side[structure.equations[node][axis] as usize] += local[axis];
                }
            }
        }
        if let Some(section) = &self.section {
            section.add(&section.reactions(forces, multipliers), &mut side);
        }
        side
    }
}

/// What acts on a condensed body besides its supports.
#[derive(Clone, Copy, Debug)]
pub struct BodyLoad<'a> {
    /// Forces on the contact points `[force]`, xy interleaved, 2n.
    pub forces: &'a [f64],
    /// Multiplier of each load case `[1]`.
    pub multipliers: &'a [f64],
    /// Amounts of the free rigid motions `[length]`, f.
    pub motions: &'a [f64],
}

impl InterfaceOperator for CondensedBody {
    fn points(&self) -> &[Point] {
        &self.points
    }

    fn compliance(&self) -> Option<&DMatrix<f64>> {
        match &self.compliance {
            Compliance::Matrix(matrix) => Some(matrix),
            Compliance::Blocks(_) => None,
        }
    }

    fn blocks(&self) -> Option<&BlockCompliance> {
        match &self.compliance {
            Compliance::Matrix(_) => None,
            Compliance::Blocks(blocks) => Some(blocks),
        }
    }

    fn modes(&self) -> &DMatrix<f64> {
        &self.modes
    }

    fn load_cases(&self) -> usize {
        self.mode_loads.len()
    }

    fn load_response(&self, case: usize) -> Option<&DVector<f64>> {
        self.responses[case].as_ref()
    }

    fn mode_load(&self, case: usize) -> &DVector<f64> {
        &self.mode_loads[case]
    }
}
