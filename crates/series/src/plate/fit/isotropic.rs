//! Potentials of an isotropic plate: polynomials and corners in φ′ and ψ′, with the series that keep the hole's edge free of traction.
//!
//! A term a ζ^j of φ′ or b ζ^j of ψ′ makes tractions on |ζ| = 1 that the hole's modes t_K (stress σ_rr + iσ_rθ in x and y) cancel:
//!
//! ```text
//! t_{1+j} −= a,   t_{1−j} −= (1 − j) conj a (once −2 Re a for j = 0),   t_{−1−j} += conj b
//! 2G u/R of both together:  (1 + κ) a ζ^{1+j}/(1 + j),   −(1 + κ) conj a ζ^{1−j} (j ≥ 2),   −(1 + κ) conj b ζ^{−1−j}/(1 + j)
//! ```

mod terms;

use std::cmp::Ordering;
use std::sync::Arc;

use nalgebra::{Complex, DMatrix, DVector};

use super::task::{Drawn, Task, rows};
use crate::arnoldi::{Basis, Values};
use crate::channel::Channel;
use crate::field::Outer;
use crate::outline::{EdgePoint, corner};
use terms::{Potential, Term, answers, coefficients, displacements, terms};

type C64 = Complex<f64>;

/// Terms of φ′ and ψ′.
#[derive(Clone, Debug)]
pub(crate) struct IsotropicTerms {
    basis: Arc<Basis>,
    terms: Vec<Term>,
}

/// All terms up to `degree`, and what they do at `points` and on the hole.
pub(super) fn draw(
    task: &Task<'_>,
    kappa: f64,
    points: &[Vec<EdgePoint>; 2],
    degree: usize,
) -> (IsotropicTerms, Drawn) {
    let places = |points: &[EdgePoint]| -> Vec<C64> { points.iter().map(|p| p.place).collect() };
    let [fitted, checked] = points;
    let halves = task.surrounding.images.is_some();
    // One polynomial more than terms, for their antiderivatives.
    let (basis, values) = Basis::new(&places(fitted), degree + 1, halves);
    let checks = basis.at(&places(checked));
    let channels = task.channels;
    let terms = terms(task, degree);
    let taylor = basis.taylor(task.orders as usize + 1);
    let series: Vec<[Vec<C64>; 2]> = (terms.iter())
        .map(|&term| coefficients(term, &taylor))
        .collect();
    let drawn = Drawn {
        hole: [fitted, checked].map(|points| hole_tractions(points, channels, kappa)),
        terms: [(fitted, &values), (checked, &checks)]
            .map(|(points, values)| term_tractions(points, &terms, values)),
        answers: answers(channels, &series),
        displacements: displacements(channels, &series, kappa),
    };
    let terms = IsotropicTerms {
        basis: Arc::new(basis),
        terms,
    };
    (terms, drawn)
}

impl IsotropicTerms {
    pub(super) fn count(&self) -> usize {
        self.terms.len()
    }

    /// The terms times `amounts`, for a field.
    pub(super) fn outer(&self, amounts: &DVector<f64>) -> Outer {
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
        Outer::new(Arc::clone(&self.basis), phi, psi, corners)
    }

    /// σ_rr + σ_θθ of each term at the place `direction` of the hole's edge.
    pub(super) fn sums_on_edge(&self, direction: C64) -> Vec<f64> {
        let values = self.basis.values(direction);
        let terms = self.terms.iter();
        terms
            .map(|term| 4.0 * phi_at(*term, &values, direction).re)
            .collect()
    }
}

/// σ_rr + σ_θθ of the hole's mode at the place `direction` of its edge.
pub(super) fn mode_on_edge(channel: &Channel, direction: C64) -> f64 {
    if channel.order < 0 {
        let power = direction.powi(channel.order as i32 - 1);
        4.0 * (channel.unit.value() * power).re
    } else {
        0.0
    }
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
