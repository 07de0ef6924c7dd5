//! The outer edge of a plate: polynomials in addition to the series of the hole, fitted to its tractions.
//!
//! ```text
//! φ′ = φ_h′ + Σ a_n q_n,   ψ′ = ψ_h′ + Σ b_n q_n,     min ‖σ_nn − iσ_nt − T‖ on points of the outline
//! σ_nn − iσ_nt = φ′ + conj φ′ − n² (ζ̄ φ″ + ψ′)          (n: outward normal as a complex number)
//! ```
//!
//! An even traction on one edge alone, that is not parallel to the next edge, has no polynomial; the term i ln(1 − ζ/c) of the corner c has it.
//! Each term comes with the series that keeps the hole's edge free of traction. A term a ζ^j of φ′ or b ζ^j of ψ′ makes tractions on |ζ| = 1 that the
//! hole's modes t_K (stress σ_rr + iσ_rθ in x and y) cancel:
//!
//! ```text
//! t_{1+j} −= a,   t_{1−j} −= (1 − j) conj a (once −2 Re a for j = 0),   t_{−1−j} += conj b
//! 2G u/R of both together:  (1 + κ) a ζ^{1+j}/(1 + j),   −(1 + κ) conj a ζ^{1−j} (j ≥ 2),   −(1 + κ) conj b ζ^{−1−j}/(1 + j)
//! ```

mod terms;

use std::cmp::Ordering;
use std::sync::Arc;

use nalgebra::{Complex, DMatrix, DVector};

use super::least_squares::least_squares;
use crate::arnoldi::{Basis, Values};
use crate::channel::{Channel, Unit};
use crate::field::{Outer, Outside};
use crate::outline::{EdgePoint, Surrounding, corner};
use terms::{Potential, Term, answers, coefficients, displacements, terms};

type C64 = Complex<f64>;

/// Outer part of a plate for states that have some of the two units.
#[derive(Clone, Debug)]
pub(crate) struct OuterFit {
    basis: Arc<Basis>,
    terms: Vec<Term>,
    /// Modes of the hole that the fit knows.
    pub(crate) channels: Vec<Channel>,
    /// Amounts of the terms by unit tractions t in the channels, terms × channels.
    pub(crate) by_channels: DMatrix<f64>,
    /// The same by the tractions of the load cases, terms × cases.
    pub(crate) by_loads: DMatrix<f64>,
    /// Tractions t on the hole of unit terms' own series, channels × terms.
    pub(crate) answers: DMatrix<f64>,
    /// Displacements 2G u/R of the hole's edge by unit terms, channels × terms.
    pub(crate) displacements: DMatrix<f64>,
    /// Points of the fit.
    pub(crate) points: usize,
    /// What the fit leaves.
    pub(crate) residual: f64,
}

/// What the fit is asked for.
pub(crate) struct Task<'a> {
    pub(crate) surrounding: &'a Surrounding,
    pub(crate) units: &'a [Unit],
    /// Largest |K| of the hole's modes.
    pub(crate) orders: i64,
    /// These modes.
    pub(crate) channels: &'a [Channel],
    pub(crate) kappa: f64,
    /// Tractions on each edge by load case `[stress]`, x + iy.
    pub(crate) tractions: &'a [Vec<C64>],
    /// Tractions t on the hole that balance each load case, by channels.
    pub(crate) reactions: &'a DMatrix<f64>,
}

impl OuterFit {
    /// The fit with polynomials up to `degree`.
    pub(crate) fn new(task: &Task<'_>, degree: usize) -> Self {
        let halves = task.surrounding.images.is_some();
        let unknowns = 2 * task.units.len() * (degree + 1);
        let [fitted, checked] = task.surrounding.points(3 * unknowns / 2);
        let places =
            |points: &[EdgePoint]| -> Vec<C64> { points.iter().map(|p| p.place).collect() };
        // One polynomial more than terms, for their antiderivatives.
        let (basis, values) = Basis::new(&places(&fitted), degree + 1, halves);
        let checks = basis.at(&places(&checked));
        let channels = task.channels;
        let terms = terms(task, degree);
        let taylor = basis.taylor(task.orders as usize + 1);
        let series: Vec<[Vec<C64>; 2]> = terms
            .iter()
            .map(|&term| coefficients(term, &taylor))
            .collect();
        let answers = answers(channels, &series);
        let on_points = |points: &[EdgePoint], values: &Values| {
            let hole = hole_tractions(points, channels, task.kappa);
            let mut columns = term_tractions(points, &terms, values);
            columns.gemm(1.0, &hole, &answers, 1.0);
            let sides = sides(task, points, &hole);
            (columns, sides)
        };
        let (columns, wanted) = on_points(&fitted, &values);
        let solution = least_squares(columns, &wanted);
        let (columns, wanted) = on_points(&checked, &checks);
        let residual = residual(task, &wanted, &(&wanted - columns * &solution));
        let loads = task.tractions.len();
        Self {
            displacements: displacements(channels, &series, task.kappa),
            by_loads: solution.columns(0, loads).into_owned(),
            by_channels: solution.columns(loads, channels.len()).into_owned(),
            points: fitted.len(),
            basis: Arc::new(basis),
            terms,
            channels: channels.to_vec(),
            answers,
            residual,
        }
    }
}

impl OuterFit {
    /// Real unknowns.
    pub(crate) fn columns(&self) -> usize {
        self.terms.len()
    }

    /// Adds the terms times `amounts`, and the series that keep the hole free of them.
    pub(crate) fn add_to(&self, outside: &mut Outside, amounts: &DVector<f64>) {
        let zero = C64::new(0.0, 0.0);
        let count = 1 + self.basis.degree();
        let [mut phi, mut psi] = [vec![zero; count], vec![zero; count]];
        let mut corners = Vec::new();
        for (term, &amount) in self.terms.iter().zip(amounts.iter()) {
            match *term {
                Term::Polynomial {
                    potential,
                    degree,
                    unit,
                } => match potential {
                    Potential::Phi => phi[degree] += unit.value() * amount,
                    Potential::Psi => psi[degree] += unit.value() * amount,
                },
                Term::Corner { place, image } => {
                    corners.push((place, amount));
                    if image != 0.0 {
                        corners.push((place.conj(), image * amount));
                    }
                }
            }
        }
        let answers = &self.answers * amounts;
        for (channel, &amount) in self.channels.iter().zip(answers.iter()) {
            outside.add_mode(channel.order, channel.unit.value() * amount);
        }
        let outer = Outer::new(Arc::clone(&self.basis), phi, psi, corners);
        outside.outer.push(outer);
    }

    /// What the terms times `amounts` (terms × states), and the series that keep the hole free of them, add to σ_rr + σ_θθ at the places `directions` of the
    /// hole's edge, places × states.
    pub(crate) fn sums_on_edge(&self, directions: &[C64], amounts: &DMatrix<f64>) -> DMatrix<f64> {
        let mut by_terms = DMatrix::zeros(directions.len(), self.terms.len());
        let mut by_channels = DMatrix::zeros(directions.len(), self.channels.len());
        for (place, &direction) in directions.iter().enumerate() {
            let values = self.basis.values(direction);
            for (column, term) in self.terms.iter().enumerate() {
                by_terms[(place, column)] = 4.0 * phi_at(*term, &values, direction).re;
            }
            for (column, channel) in self.channels.iter().enumerate() {
                if channel.order < 0 {
                    let power = direction.powi(channel.order as i32 - 1);
                    by_channels[(place, column)] = 4.0 * (channel.unit.value() * power).re;
                }
            }
        }
        by_terms.gemm(1.0, &by_channels, &self.answers, 1.0);
        by_terms * amounts
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

fn rows(points: usize, columns: usize, mut value: impl FnMut(usize, usize) -> C64) -> DMatrix<f64> {
    let mut matrix = DMatrix::zeros(2 * points, columns);
    for column in 0..columns {
        for point in 0..points {
            let z = value(point, column);
            matrix[(2 * point, column)] = z.re;
            matrix[(2 * point + 1, column)] = z.im;
        }
    }
    matrix
}

/// σ_nn − iσ_nt at a point.
fn traction(point: &EdgePoint, phi: C64, slope: C64, psi: C64) -> C64 {
    phi + phi.conj() - point.normal * point.normal * (point.place.conj() * slope + psi)
}

/// Tractions of the hole's modes with unit tractions on the hole, 2 points × channels.
fn hole_tractions(points: &[EdgePoint], channels: &[Channel], kappa: f64) -> DMatrix<f64> {
    let inverse: Vec<C64> = points.iter().map(|point| point.place.inv()).collect();
    let mut powers: Vec<C64> = vec![C64::new(1.0, 0.0); points.len()];
    let mut power = 0;
    let mut matrix = DMatrix::zeros(2 * points.len(), channels.len());
    for (column, channel) in channels.iter().enumerate() {
        let order = channel.order.unsigned_abs();
        while power < order {
            powers.iter_mut().zip(&inverse).for_each(|(p, z)| *p *= z);
            power += 1;
        }
        for (k, point) in points.iter().enumerate() {
            let [phi, slope, psi] = hole_mode(
                channel.order,
                channel.unit.value(),
                powers[k],
                inverse[k],
                kappa,
            );
            let z = traction(point, phi, slope, psi);
            matrix[(2 * k, column)] = z.re;
            matrix[(2 * k + 1, column)] = z.im;
        }
    }
    matrix
}

/// φ′, φ″ and ψ′ of the traction t e^{iKθ} on the hole, `power` being ζ^−|K| and `inverse` 1/ζ.
pub(crate) fn hole_mode(order: i64, t: C64, power: C64, inverse: C64, kappa: f64) -> [C64; 3] {
    let zero = C64::new(0.0, 0.0);
    match order.cmp(&0) {
        Ordering::Equal => {
            let a = t / (1.0 + kappa);
            let phi = a * inverse;
            let psi = -kappa * a.conj() * inverse + 2.0 * a * inverse.powi(3);
            [phi, -phi * inverse, psi]
        }
        Ordering::Greater => [zero, zero, -t.conj() * power * inverse],
        Ordering::Less => {
            let count = order.unsigned_abs() as f64;
            let phi = t * power * inverse;
            let slope = -(count + 1.0) * phi * inverse;
            [phi, slope, (count + 2.0) * phi * inverse * inverse]
        }
    }
}

/// φ′ of a term without the series that keep the hole free, `values` being those of the polynomials at `zeta`.
fn phi_at(term: Term, values: &[C64], zeta: C64) -> C64 {
    match term {
        Term::Polynomial {
            potential: Potential::Phi,
            degree,
            unit,
        } => unit.value() * values[degree],
        Term::Polynomial { .. } => C64::new(0.0, 0.0),
        Term::Corner { place, image } => {
            let [own, other] = [place, place.conj()].map(|c| corner(c, zeta)[0]);
            own + image * other
        }
    }
}

/// Tractions of the terms without the series that keep the hole free, 2 points × terms.
fn term_tractions(points: &[EdgePoint], terms: &[Term], values: &Values) -> DMatrix<f64> {
    let zero = C64::new(0.0, 0.0);
    rows(points.len(), terms.len(), |k, column| {
        let point = &points[k];
        match terms[column] {
            Term::Polynomial {
                potential,
                degree,
                unit,
            } => {
                let value = unit.value() * values.values[degree][k];
                match potential {
                    Potential::Phi => {
                        let slope = unit.value() * values.slopes[degree][k];
                        traction(point, value, slope, zero)
                    }
                    Potential::Psi => traction(point, zero, zero, value),
                }
            }
            Term::Corner { place, image } => {
                let [own, other] = [place, place.conj()].map(|c| {
                    let [phi, slope, psi] = corner(c, point.place);
                    traction(point, phi, slope, psi)
                });
                own + image * other
            }
        }
    })
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
