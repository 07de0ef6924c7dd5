//! A body whose mean displacement over its area is held, by a reaction spread evenly over it, as a pin is by the parts of it that stand
//! in other plates.
//!
//! With unit forces b (nodal, one column per held axis), the operator of the body without that hold and x_b = K⁻ b,
//!
//! ```text
//! bᵀ u = d,    Bᵀ α + bᵀ(K⁻ f + …) = d,    B = Rᵀ b,    E = B (BᵀB)⁻¹,    Bᵀ N = 0
//! ρ  = −Qᵀ λ − Eᵀ r,                     Q = R E,   U = (x_b on the contact points),   M = bᵀ x_b
//! C' = C − U Qᵀ − Q Uᵀ + Q M Qᵀ,          R' = R N
//! u' = u_k − U Eᵀ r_k + Q (d − bᵀ u_s − x_bᵀ f_k + M Eᵀ r_k),    r' = Nᵀ r_k
//! ```
//!
//! A carried section has three columns, ū_x, ū_y and the mean turn ω̄ times a length. Its means are no given numbers but the amounts of the rigid
//! motions, N = E, and ρ is what carries the body,
//!
//! ```text
//! bᵀ u = (ū_x, ū_y, L ω̄),     A ū = ∫ u dA,     J ω̄ = ∫ (r × u) dA,     J = ∫ r² dA,   r from the centroid
//! ```
//!
//! u_s are the displacements that moving supports prescribe, d and u_s only in the load case that moves them; ρ is the reaction; b, x_b and α are in the gauge in which the body without the hold was condensed.

use nalgebra::{DMatrix, DVector};

use super::{Compliance, CondensedBody};
use crate::body::error::BodyError;
use crate::load::{area_integral, area_load};
use crate::mesh::Mesh;
use crate::support::SectionHold;

/// Part of its size below which a direction of motion is none. Means of rigid motions, which are about 1 on the body, are numbers without a unit.
const INDEPENDENT: f64 = 1e-9;

/// What holds the mean displacement, and how it is recovered.
#[derive(Clone, Debug)]
pub(super) struct Section {
    /// Nodal forces of a unit reaction along each held axis, interleaved.
    pub(super) nodal: Vec<Vec<f64>>,
    /// The same on the unknowns.
    on_unknowns: Vec<Vec<f64>>,
    /// Mean displacement that is given along each `[length]`.
    given: Vec<f64>,
    /// E, f × s.
    along: DMatrix<f64>,
    /// N, f × (f − s).
    free: DMatrix<f64>,
    /// Q, 2n × s.
    motions: DMatrix<f64>,
    /// Eᵀ r_k of each load case.
    resultants: Vec<DVector<f64>>,
}

impl Section {
    /// The hold `hold` of `body`, which is condensed without it.
    ///
    /// # Errors
    /// [`BodyError::SectionHeld`] where supports leave it nothing to hold.
    fn held(body: &CondensedBody, hold: &SectionHold) -> Result<Self, BodyError> {
        let axes: Vec<usize> = (0..2).filter(|&axis| hold.held[axis]).collect();
        let means = means(&body.body.mesh);
        let nodal = axes.iter().map(|&axis| means[axis].clone()).collect();
        let given = axes.iter().map(|&axis| hold.displacement[axis]).collect();
        Self::of(body, nodal, given)
    }

    /// The section that carries `body`, with turns times `length`.
    ///
    /// # Errors
    /// [`BodyError::SectionHeld`] for a body with supports.
    fn carried(body: &CondensedBody, length: f64) -> Result<Self, BodyError> {
        let mesh = &body.body.mesh;
        let [x, y] = means(mesh);
        let nodal = vec![x, y, turn(mesh, length)];
        let own = Self::of(body, nodal, vec![0.0; 3])?;
        let free = own.along.clone();
        Ok(Self { free, ..own })
    }

    /// With the means bᵀ u of `nodal`, held at `given`.
    fn of(body: &CondensedBody, nodal: Vec<Vec<f64>>, given: Vec<f64>) -> Result<Self, BodyError> {
        let structure = &body.structure;
        let columns = nodal
            .iter()
            .map(|forces| structure.mode_load(&body.body, forces));
        let columns: Vec<DVector<f64>> = columns.collect();
        let held = if columns.is_empty() {
            DMatrix::zeros(structure.motions.count(), 0)
        } else {
            DMatrix::from_columns(&columns)
        };
        let gram = (held.transpose() * &held).cholesky();
        let gram = gram.filter(|own| own.l_dirty().diagonal().min() > INDEPENDENT);
        let along = &held * gram.ok_or(BodyError::SectionHeld)?.inverse();
        let free = complement(&held);
        Ok(Self {
            on_unknowns: nodal
                .iter()
                .map(|forces| structure.to_unknowns(forces))
                .collect(),
            nodal,
            given,
            motions: &body.modes * &along,
            resultants: body
                .mode_loads
                .iter()
                .map(|own| along.tr_mul(own))
                .collect(),
            along,
            free,
        })
    }

    /// Reaction ρ under contact forces and load cases times `multipliers`.
    pub(super) fn reactions(&self, forces: &[f64], multipliers: &[f64]) -> DVector<f64> {
        let count = self.given.len();
        let mut reactions = if forces.is_empty() {
            DVector::zeros(count)
        } else {
            -self.motions.tr_mul(&DVector::from_column_slice(forces))
        };
        for (resultant, &factor) in self.resultants.iter().zip(multipliers) {
            reactions.axpy(-factor, resultant, 1.0);
        }
        reactions
    }

    /// Adds the forces of the reactions `reactions` to those on the unknowns.
    pub(super) fn add(&self, reactions: &DVector<f64>, side: &mut [f64]) {
        for (forces, reaction) in self.on_unknowns.iter().zip(reactions.iter()) {
            let both = side.iter_mut().zip(forces);
            both.for_each(|(sum, force)| *sum += reaction * force);
        }
    }

    /// Amounts of all rigid motions of the body without the hold: those that bring the mean of the displacements `u` to `scale` times
    /// what is given, and the free ones by `amounts`, which may be left out.
    pub(super) fn amounts(&self, u: &[f64], scale: f64, amounts: &DVector<f64>) -> DVector<f64> {
        let mean = |forces: &Vec<f64>| forces.iter().zip(u).map(|(b, u)| b * u).sum::<f64>();
        let missing = self.nodal.iter().zip(&self.given);
        let missing = missing.map(|(forces, given)| scale * given - mean(forces));
        let held = &self.along * DVector::from_iterator(self.given.len(), missing);
        if amounts.is_empty() {
            held
        } else {
            held + &self.free * amounts
        }
    }

    /// Amounts of all rigid motions by those of the free ones.
    pub(super) fn of_free(&self, amounts: &DVector<f64>) -> DVector<f64> {
        &self.free * amounts
    }
}

/// Nodal forces, interleaved, whose work on displacements is their mean along x and along y.
fn means(mesh: &Mesh) -> [Vec<f64>; 2] {
    let weights = area_load(mesh);
    let area: f64 = weights.iter().sum();
    [0, 1].map(|axis| {
        let mut forces = vec![0.0; 2 * weights.len()];
        let own = forces.iter_mut().skip(axis).step_by(2);
        own.zip(&weights)
            .for_each(|(force, weight)| *force = weight / area);
        forces
    })
}

/// Nodal forces, interleaved, whose work on displacements is their mean turn about the centroid, times `length`.
fn turn(mesh: &Mesh, length: f64) -> Vec<f64> {
    let whole =
        |function: &dyn Fn([f64; 2]) -> f64| -> f64 { area_integral(mesh, function).iter().sum() };
    let area = whole(&|_| 1.0);
    let centre = [whole(&|[x, _]| x), whole(&|[_, y]| y)].map(|moment| moment / area);
    let from = |[x, y]: [f64; 2]| [x - centre[0], y - centre[1]];
    let polar = whole(&|at| from(at).iter().map(|part| part * part).sum());
    let along_x = area_integral(mesh, |at| -from(at)[1] * length / polar);
    let along_y = area_integral(mesh, |at| from(at)[0] * length / polar);
    along_x
        .into_iter()
        .zip(along_y)
        .flat_map(|(x, y)| [x, y])
        .collect()
}

/// An orthonormal basis of what is perpendicular to the columns of `held`.
fn complement(held: &DMatrix<f64>) -> DMatrix<f64> {
    let count = held.nrows();
    let mut basis: Vec<DVector<f64>> = Vec::new();
    let candidates = held.column_iter().map(nalgebra::Matrix::into_owned);
    let candidates =
        candidates.chain((0..count).map(|k| DVector::from_fn(count, |i, _| f64::from(i == k))));
    for candidate in candidates {
        let size = candidate.norm();
        let mut rest = candidate;
        for own in basis.iter().chain(&basis) {
            let part = rest.dot(own);
            rest.axpy(-part, own, 1.0);
        }
        if basis.len() < count && rest.norm() > INDEPENDENT * size {
            basis.push(rest.normalize());
        }
    }
    let free = &basis[held.ncols()..];
    if free.is_empty() {
        DMatrix::zeros(count, 0)
    } else {
        DMatrix::from_columns(free)
    }
}

impl CondensedBody {
    /// Holds the mean displacement, or carries the body by it, as the body says.
    pub(super) fn hold_section(&mut self) -> Result<(), BodyError> {
        let own = match (self.body.section, self.body.carried) {
            (Some(hold), _) => Section::held(self, &hold)?,
            (None, Some(length)) => Section::carried(self, length)?,
            (None, None) => return Ok(()),
        };
        let solved: Vec<Vec<f64>> = (own.on_unknowns.iter())
            .map(|forces| {
                let mut solution = forces.clone();
                self.factor.solve(&mut solution);
                solution
            })
            .collect();
        let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        let count = solved.len();
        let inner = DMatrix::from_fn(count, count, |i, j| dot(&own.on_unknowns[i], &solved[j]));
        let tail = self.structure.unknowns - self.structure.interface_unknowns;
        let columns = solved.iter().map(|solution| {
            let reduced = DVector::from_column_slice(&solution[tail..]);
            self.structure.spread_response(&reduced, false)
        });
        let columns: Vec<DVector<f64>> = columns.collect();
        let responses = DMatrix::from_columns(&columns);
        let q = &own.motions;
        // Q M Qᵀ − U Qᵀ − Q Uᵀ, by one product and its transpose.
        let half = (q * (&inner * 0.5) - &responses) * q.transpose();
        let Compliance::Matrix(compliance) = &mut self.compliance else {
            return Err(BodyError::OtherSupports);
        };
        *compliance += &half + half.transpose();
        for case in 0..self.mode_loads.len() {
            let resultant = &own.resultants[case];
            let loads = &self.body.cases[case];
            let mut along = &inner * resultant;
            if let Some(forces) = &self.case_forces[case] {
                along -= DVector::from_iterator(count, solved.iter().map(|own| dot(own, forces)));
            }
            if loads.moves_supports {
                let moved = self.structure.support_motion();
                let means = own.nodal.iter().map(|forces| dot(forces, &moved));
                along += DVector::from_column_slice(&own.given);
                along -= DVector::from_iterator(count, means);
            }
            let change = q * along - &responses * resultant;
            if change.iter().any(|part| *part != 0.0) {
                let size = change.len();
                let response = self.responses[case].get_or_insert_with(|| DVector::zeros(size));
                *response += change;
            }
            self.mode_loads[case] = own.free.tr_mul(&self.mode_loads[case]);
        }
        self.modes = &self.modes * &own.free;
        self.section = Some(own);
        Ok(())
    }
}
