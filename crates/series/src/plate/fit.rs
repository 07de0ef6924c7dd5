//! The outer edge of a plate: polynomials in addition to the series of the hole, fitted to its tractions.
//!
//! ```text
//! φ′ = φ_h′ + Σ a_n q_n,   ψ′ = ψ_h′ + Σ b_n q_n,     min ‖σ_nn − iσ_nt − T‖ on points of the outline
//! σ_nn − iσ_nt = φ′ + conj φ′ − n² (ζ̄ φ″ + ψ′)          (n: outward normal as a complex number)
//! ```
//!
//! An even traction on one edge alone, that is not parallel to the next edge, has no polynomial; the term i ln(1 − ζ/c) of the corner c has it.
//! Each term comes with the series that keeps the hole's edge free of traction. In an anisotropic plate the polynomials are those of two planes,
//! φ_1(w_1) and φ_2(w_2).

mod anisotropic;
mod isotropic;
mod task;

use nalgebra::{Complex, DMatrix, DVector};

use super::least_squares::least_squares;
use crate::channel::{Channel, Unit};
use crate::elasticity::Elasticity;
use crate::field::Outside;
use crate::outline::{EdgePoint, Surrounding};
use anisotropic::AnisotropicTerms;
use isotropic::IsotropicTerms;
pub(crate) use task::Task;
use task::{Drawn, rows};

type C64 = Complex<f64>;

/// Outer part of a plate for states that have some of the two units.
#[derive(Clone, Debug)]
pub(crate) struct OuterFit {
    potentials: Potentials,
    /// Modes of the hole that the fit knows.
    pub(crate) channels: Vec<Channel>,
    /// Amounts of the terms by unit tractions t in the channels, terms × channels.
    pub(crate) by_channels: DMatrix<f64>,
    /// The same by the tractions of the load cases, terms × cases.
    pub(crate) by_loads: DMatrix<f64>,
    /// Tractions t on the hole of unit terms' own series, channels × terms.
    pub(crate) answers: DMatrix<f64>,
    /// Displacements 2G u/R of the hole's edge by unit terms, of an anisotropic plate u/R, channels × terms.
    pub(crate) displacements: DMatrix<f64>,
    /// Points of the fit.
    pub(crate) points: usize,
    /// What the fit leaves.
    pub(crate) residual: f64,
}

/// The terms of a fit.
#[derive(Clone, Debug)]
enum Potentials {
    Isotropic(IsotropicTerms),
    Anisotropic(AnisotropicTerms),
}

impl OuterFit {
    /// The fit with polynomials up to `degree`.
    pub(crate) fn new(task: &Task<'_>, degree: usize) -> Self {
        let unknowns = 2 * task.units.len() * (degree + 1);
        let points = task.surrounding.points(3 * unknowns / 2);
        let (potentials, drawn) = match task.elasticity {
            Elasticity::Isotropic(material) => {
                let (terms, drawn) = isotropic::draw(task, material.kappa, &points, degree);
                (Potentials::Isotropic(terms), drawn)
            }
            Elasticity::Anisotropic(planes) => {
                let (terms, drawn) = anisotropic::draw(task, planes, &points, degree);
                (Potentials::Anisotropic(terms), drawn)
            }
        };
        let [fitted, checked] = &points;
        let Drawn {
            hole,
            terms: [mut columns, mut checks],
            answers,
            displacements,
        } = drawn;
        columns.gemm(1.0, &hole[0], &answers, 1.0);
        let solution = least_squares(columns, &sides(task, fitted, &hole[0]));
        checks.gemm(1.0, &hole[1], &answers, 1.0);
        let wanted = sides(task, checked, &hole[1]);
        let residual = residual(task, &wanted, &(&wanted - checks * &solution));
        let loads = task.tractions.len();
        Self {
            potentials,
            displacements,
            by_loads: solution.columns(0, loads).into_owned(),
            by_channels: solution.columns(loads, task.channels.len()).into_owned(),
            points: fitted.len(),
            channels: task.channels.to_vec(),
            answers,
            residual,
        }
    }
}

impl OuterFit {
    /// Real unknowns.
    pub(crate) fn columns(&self) -> usize {
        match &self.potentials {
            Potentials::Isotropic(terms) => terms.count(),
            Potentials::Anisotropic(terms) => terms.count(),
        }
    }

    /// Adds the terms times `amounts`, and the series that keep the hole free of them.
    pub(crate) fn add_to(&self, outside: &mut Outside, amounts: &DVector<f64>) {
        let answers = &self.answers * amounts;
        for (channel, &amount) in self.channels.iter().zip(answers.iter()) {
            outside.add_mode(channel.order, channel.unit.value() * amount);
        }
        match &self.potentials {
            Potentials::Isotropic(terms) => outside.outer.push(terms.outer(amounts)),
            Potentials::Anisotropic(terms) => outside.outer_planes.push(terms.outer(amounts)),
        }
    }

    /// What the terms times `amounts` (terms × states), and the series that keep the hole free of them, add to σ_rr + σ_θθ at the places `directions` of the
    /// hole's edge, places × states.
    pub(crate) fn sums_on_edge(&self, directions: &[C64], amounts: &DMatrix<f64>) -> DMatrix<f64> {
        let mut by_terms = DMatrix::zeros(directions.len(), self.columns());
        let mut by_channels = DMatrix::zeros(directions.len(), self.channels.len());
        for (place, &direction) in directions.iter().enumerate() {
            let own = match &self.potentials {
                Potentials::Isotropic(terms) => terms.sums_on_edge(direction),
                Potentials::Anisotropic(terms) => terms.sums_on_edge(direction),
            };
            by_terms.row_mut(place).copy_from_slice(&own);
            for (column, channel) in self.channels.iter().enumerate() {
                by_channels[(place, column)] = match &self.potentials {
                    Potentials::Isotropic(_) => isotropic::mode_on_edge(channel, direction),
                    Potentials::Anisotropic(terms) => terms.mode_on_edge(channel, direction),
                };
            }
        }
        by_terms.gemm(1.0, &by_channels, &self.answers, 1.0);
        by_terms * amounts
    }
}

/// Distance of the outline from the hole in terms of its modes, which reach the outline as (1/distance)^|K|.
pub(crate) fn distance(elasticity: &Elasticity, surrounding: &Surrounding) -> f64 {
    match elasticity {
        Elasticity::Isotropic(_) => surrounding.distance,
        Elasticity::Anisotropic(planes) => anisotropic::distance(planes, surrounding),
    }
}

/// All modes up to the largest order, in the order of |K|.
pub(crate) fn channels(units: &[Unit], orders: i64) -> Vec<Channel> {
    let orders = (0..=orders).flat_map(|order| {
        if order == 0 {
            vec![0]
        } else {
            vec![order, -order]
        }
    });
    orders
        .flat_map(|order| units.iter().map(move |&unit| Channel { order, unit }))
        .collect()
}

/// Right-hand sides: load cases with the reactions that balance them, then −(the tractions of unit modes).
fn sides(task: &Task<'_>, points: &[EdgePoint], hole: &DMatrix<f64>) -> DMatrix<f64> {
    let (loads, channels) = (task.tractions.len(), task.channels);
    let mut sides = DMatrix::zeros(2 * points.len(), loads + channels.len());
    let given = rows(points.len(), loads, |point, case| {
        let EdgePoint { edge, normal, .. } = points[point];
        own_part(task, case, edge).conj() * normal
    });
    let balance = hole * task.reactions;
    sides.columns_mut(0, loads).copy_from(&(given - balance));
    (sides.columns_mut(loads, channels.len())).copy_from(&-hole);
    sides
}

/// Traction of load case `case` on edge `edge`; of a symmetric outline its part that the units of the task stand for.
fn own_part(task: &Task<'_>, case: usize, edge: usize) -> C64 {
    let own = task.tractions[case][edge];
    match (&task.surrounding.images, task.units) {
        (Some(images), [Unit::Real]) => 0.5 * (own + task.tractions[case][images[edge]].conj()),
        (Some(images), [Unit::Imaginary]) => {
            0.5 * (own - task.tractions[case][images[edge]].conj())
        }
        _ => own,
    }
}

/// Largest traction that is left, relative to the mean one: of load cases over loaded edges, of modes over the outline under a net force on the hole.
fn residual(task: &Task<'_>, wanted: &DMatrix<f64>, left: &DMatrix<f64>) -> f64 {
    let size =
        |column: &[f64]| -> Vec<f64> { column.chunks_exact(2).map(|z| z[0].hypot(z[1])).collect() };
    let largest = |column: usize| {
        size(left.column(column).as_slice())
            .into_iter()
            .fold(0.0, f64::max)
    };
    let loads = task.tractions.len();
    let mut found: f64 = 0.0;
    for (case, tractions) in task.tractions.iter().enumerate() {
        let sides = &task.surrounding.sides;
        let loaded = tractions.iter().zip(sides).filter(|(t, _)| t.norm() > 0.0);
        let [force, length] = loaded.fold([0.0; 2], |[force, length], (t, side)| {
            [force + t.norm() * side.length, length + side.length]
        });
        if force > 0.0 {
            found = found.max(largest(case) * length / force);
        }
    }
    let unit = size(wanted.column(loads).as_slice());
    let mean = unit.iter().sum::<f64>() / unit.len() as f64;
    for (k, channel) in task.channels.iter().enumerate() {
        // Modes with a resultant have no balance of their own.
        let alone = channel.order == 0 || (channel.order, channel.unit) == (1, Unit::Imaginary);
        if !alone {
            found = found.max(largest(loads + k) / mean);
        }
    }
    found
}
