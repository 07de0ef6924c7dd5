//! Bodies whose rigid motions springs couple, such as the slices of one fastener.
//!
//! With α the rigid motions of the bodies, one after the other, and q = Gᵀ λ + Σ m_k r_k the forces in them,
//!
//! ```text
//! α = F q + N β,     Nᵀ q = 0
//! A' = A + G F Gᵀ,   d_k' = d_k + G F r_k,   G' = G N,   r_k' = Nᵀ r_k
//! ```
//!
//! F is the flexibility of the springs, a symmetric generalised inverse of their stiffness, and N are the motions that they do not resist. Springs
//! that do not give have F = 0. So springs add to the compliance and leave fewer rigid motions, and solvers do not know them.

use std::ops::Range;

use nalgebra::{DMatrix, DVector};
use stickslip_fem_core::InterfaceOperator;

use super::InterfaceProblem;
use crate::error::ContactError;

/// Springs between the rigid motions of several bodies.
#[derive(Clone, Debug, PartialEq)]
pub struct Link {
    /// Indices of the bodies; each is in one link at most.
    pub bodies: Vec<usize>,
    /// Flexibility F `[length/force]`, m × m, of the rigid motions of all of them in this order, in the units of their
    /// [`modes`](InterfaceOperator::modes).
    pub flexibility: DMatrix<f64>,
    /// Motions N that the springs do not resist, m × p `[1]`.
    pub free: DMatrix<f64>,
}

impl Link {
    /// The link with its bodies counted anew by `local`; `None` if one of them is not counted.
    pub(crate) fn among(&self, local: impl Fn(usize) -> Option<usize>) -> Option<Self> {
        let bodies: Option<Vec<usize>> = self.bodies.iter().map(|&body| local(body)).collect();
        Some(Self {
            bodies: bodies?,
            ..self.clone()
        })
    }
}

/// Refuses links that do not fit `bodies`.
pub(crate) fn check(links: &[Link], bodies: &[&dyn InterfaceOperator]) -> Result<(), ContactError> {
    let mut seen = vec![false; bodies.len()];
    for (index, link) in links.iter().enumerate() {
        let refuse = |what: String| Err(ContactError::InvalidLink { link: index, what });
        let mut count = 0;
        for &body in &link.bodies {
            let Some(operator) = bodies.get(body) else {
                return refuse(format!("body {body} of {} does not exist", bodies.len()));
            };
            if std::mem::replace(&mut seen[body], true) {
                return refuse(format!("body {body} is linked twice"));
            }
            count += operator.modes().ncols();
        }
        let (flexibility, free) = (&link.flexibility, &link.free);
        if flexibility.shape() != (count, count) || free.nrows() != count {
            return refuse(format!(
                "its bodies have {count} rigid motions, and the matrices are {} × {} and {} × {}",
                flexibility.nrows(),
                flexibility.ncols(),
                free.nrows(),
                free.ncols()
            ));
        }
        if !flexibility
            .iter()
            .chain(free)
            .all(|value| value.is_finite())
        {
            return refuse("a number is not finite".into());
        }
    }
    Ok(())
}

/// First rigid motion of each body, and the number of rigid motions at the end: those of a link are with its first body.
pub(crate) fn mode_offsets(bodies: &[&dyn InterfaceOperator], links: &[Link]) -> Vec<usize> {
    let mut counts: Vec<usize> = bodies.iter().map(|body| body.modes().ncols()).collect();
    for link in links {
        link.bodies.iter().for_each(|&body| counts[body] = 0);
        if let Some(&first) = link.bodies.first() {
            counts[first] = link.free.ncols();
        }
    }
    let mut offsets = vec![0];
    for count in counts {
        offsets.push(offsets[offsets.len() - 1] + count);
    }
    offsets
}

/// A link in an interface problem.
#[derive(Clone, Debug)]
pub(super) struct Linked {
    link: Link,
    /// Range of the rigid motions of each body among those of the link.
    ranges: Vec<Range<usize>>,
    /// G of these motions, 2n × m.
    motions: DMatrix<f64>,
    /// r_k in them, m.
    loads: Vec<DVector<f64>>,
}

impl Linked {
    /// The link of bodies whose rigid motions have the columns `columns` of all of `modes`, and the resultants `loads`.
    pub(super) fn new(
        link: &Link,
        columns: &[Range<usize>],
        modes: &DMatrix<f64>,
        loads: &[DVector<f64>],
    ) -> Self {
        let own = || link.bodies.iter().map(|&body| columns[body].clone());
        let all: Vec<usize> = own().flatten().collect();
        let mut start = 0;
        let ranges = own().map(|range| {
            let from = start;
            start += range.len();
            from..start
        });
        Self {
            ranges: ranges.collect(),
            motions: modes.select_columns(&all),
            loads: loads.iter().map(|load| load.select_rows(&all)).collect(),
            link: link.clone(),
        }
    }

    pub(super) fn bodies(&self) -> &[usize] {
        &self.link.bodies
    }

    /// G F Gᵀ, exactly symmetric.
    pub(super) fn compliance(&self) -> DMatrix<f64> {
        let half = &self.motions * (&self.link.flexibility * 0.5) * self.motions.transpose();
        &half + half.transpose()
    }

    /// G F r_k.
    pub(super) fn response(&self, case: usize) -> DVector<f64> {
        &self.motions * (&self.link.flexibility * &self.loads[case])
    }

    /// G N.
    pub(super) fn modes(&self) -> DMatrix<f64> {
        &self.motions * &self.link.free
    }

    /// Nᵀ r_k.
    pub(super) fn mode_load(&self, case: usize) -> DVector<f64> {
        self.link.free.tr_mul(&self.loads[case])
    }

    /// α of the body at `place` in the link, where β is `amounts`.
    pub(super) fn motions_of(
        &self,
        place: usize,
        amounts: &DVector<f64>,
        forces: &DVector<f64>,
        multipliers: &[f64],
    ) -> Vec<f64> {
        let mut pushed = self.motions.tr_mul(forces);
        for (load, &factor) in self.loads.iter().zip(multipliers) {
            pushed.axpy(factor, load, 1.0);
        }
        let all = &self.link.flexibility * pushed + &self.link.free * amounts;
        all.as_slice()[self.ranges[place].clone()].to_vec()
    }
}

impl InterfaceProblem {
    /// Puts springs between the rigid motions of `bodies`, which have been added without them.
    pub(super) fn link(&mut self, bodies: &[&dyn InterfaceOperator], links: &[Link]) {
        let count = self.body_count();
        let columns: Vec<Range<usize>> = (0..count).map(|body| self.body_modes(body)).collect();
        let linked: Vec<Linked> = (links.iter())
            .filter(|link| !link.bodies.is_empty())
            .map(|link| Linked::new(link, &columns, &self.modes, &self.case_mode_load))
            .collect();
        if linked.is_empty() {
            return;
        }
        let offsets = mode_offsets(bodies, links);
        let mut modes = DMatrix::zeros(self.modes.nrows(), offsets[count]);
        let mut loads = vec![DVector::zeros(offsets[count]); self.case_mode_load.len()];
        for (body, range) in columns.into_iter().enumerate() {
            let (start, length) = (offsets[body], offsets[body + 1] - offsets[body]);
            let of_link = linked.iter().find(|link| link.bodies()[0] == body);
            let own = match of_link {
                Some(link) => link.modes(),
                None => self.modes.columns(range.start, length).into_owned(),
            };
            modes.columns_mut(start, length).copy_from(&own);
            for (case, load) in loads.iter_mut().enumerate() {
                let own = match of_link {
                    Some(link) => link.mode_load(case),
                    None => self.case_mode_load[case].rows(range.start, length).into(),
                };
                load.rows_mut(start, length).copy_from(&own);
            }
        }
        for link in &linked {
            *self.compliance.make_matrix() += link.compliance();
            for (case, motion) in self.case_motion.iter_mut().enumerate() {
                *motion += link.response(case);
            }
        }
        self.modes = modes;
        self.case_mode_load = loads;
        self.mode_units = vec![1.0; offsets[count]];
        self.mode_offsets = offsets;
        self.links = linked;
    }

    /// Amounts of the own rigid motions of body `body`, one for each column of its
    /// [`modes`](InterfaceOperator::modes) and in its unit, where those of the problem are `rigid`, m, under contact forces `forces` `[force]`, 2n, and the load
    /// multipliers `multipliers` `[1]`: these strain the springs of a link.
    pub fn motions_of_body(
        &self,
        body: usize,
        rigid: &DVector<f64>,
        forces: &DVector<f64>,
        multipliers: &[f64],
    ) -> Vec<f64> {
        let amount = |mode: usize| self.mode_units[mode] * rigid[mode];
        let Some((link, place)) = self.link_of(body) else {
            return self.body_modes(body).map(amount).collect();
        };
        let own = self.body_modes(link.bodies()[0]);
        let amounts = DVector::from_iterator(own.len(), own.map(amount));
        link.motions_of(place, &amounts, forces, multipliers)
    }

    /// The link of body `body` and its place in it.
    pub(super) fn link_of(&self, body: usize) -> Option<(&Linked, usize)> {
        self.links.iter().find_map(|link| {
            let place = link.bodies().iter().position(|&own| own == body)?;
            Some((link, place))
        })
    }

    /// Whether springs link bodies.
    pub(crate) fn is_linked(&self) -> bool {
        !self.links.is_empty()
    }

    /// The body among whose rigid motions those of body `body` count: itself, or the first of its link.
    pub(crate) fn carrier(&self, body: usize) -> usize {
        self.link_of(body)
            .map_or(body, |(link, _)| link.bodies()[0])
    }
}
