//! The terms of a fit, and the series that each of them needs to keep the hole free.

use nalgebra::{Complex, DMatrix};

use super::super::task::Task;
use crate::channel::{Channel, Unit};

type C64 = Complex<f64>;

/// A term of the fit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Term {
    /// A polynomial in one potential, with the unit of its coefficient.
    Polynomial {
        potential: Potential,
        degree: usize,
        unit: Unit,
    },
    /// φ′ = i ln(1 − ζ/c), ψ′ = −c̄ φ″ for a corner c, which makes an even traction on each of the two edges of the corner; `image` times that of c̄ added.
    Corner { place: C64, image: f64 },
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Potential {
    Phi,
    Psi,
}

/// All polynomials but the constant i of φ′, a rotation, and the corners.
pub(super) fn terms(task: &Task<'_>, degree: usize) -> Vec<Term> {
    let mut terms = Vec::new();
    for degree in 0..=degree {
        for potential in [Potential::Phi, Potential::Psi] {
            for &unit in task.units {
                if (degree, potential, unit) != (0, Potential::Phi, Unit::Imaginary) {
                    terms.push(Term::Polynomial {
                        potential,
                        degree,
                        unit,
                    });
                }
            }
        }
    }
    for place in task.surrounding.corners() {
        let image = match (&task.surrounding.images, task.units) {
            (Some(_), [Unit::Real]) => -1.0,
            (Some(_), [Unit::Imaginary]) => 1.0,
            _ => 0.0,
        };
        // On the axis, the symmetric part of a corner's term is none.
        let on_axis = place.im.abs() <= f64::EPSILON * place.norm();
        if !(on_axis && image < 0.0) {
            terms.push(Term::Corner { place, image });
        }
    }
    terms
}

/// Taylor coefficients at 0 of a term's φ′ and ψ′, as many as those of the polynomials.
pub(super) fn coefficients(term: Term, taylor: &[Vec<C64>]) -> [Vec<C64>; 2] {
    match term {
        Term::Polynomial {
            potential,
            degree,
            unit,
        } => {
            let own = taylor[degree].iter().map(|a| unit.value() * a).collect();
            match potential {
                Potential::Phi => [own, Vec::new()],
                Potential::Psi => [Vec::new(), own],
            }
        }
        Term::Corner { place, image } => {
            let i = C64::new(0.0, 1.0);
            let [mut phi, mut psi] = [Vec::new(), Vec::new()];
            for j in 0..taylor[0].len() {
                let [mut a, mut b] = [C64::new(0.0, 0.0); 2];
                for (c, factor) in [(place, 1.0), (place.conj(), image)] {
                    let power = c.powi(-(j as i32)) * factor;
                    if j > 0 {
                        a -= i * power / j as f64;
                    }
                    b += i * c.conj() / c * power;
                }
                phi.push(a);
                psi.push(b);
            }
            [phi, psi]
        }
    }
}

/// The numbers by which a coefficient with unit `unit` shows in channels: real and imaginary part of `value` in mode `order`.
fn spread(matrix: &mut DMatrix<f64>, channels: &[Channel], order: i64, column: usize, value: C64) {
    for (row, channel) in channels.iter().enumerate() {
        if channel.order == order {
            matrix[(row, column)] += match channel.unit {
                Unit::Real => value.re,
                Unit::Imaginary => value.im,
            };
        }
    }
}

/// Tractions t that keep the hole free, channels × terms.
pub(super) fn answers(channels: &[Channel], series: &[[Vec<C64>; 2]]) -> DMatrix<f64> {
    let mut matrix = DMatrix::zeros(channels.len(), series.len());
    for (column, [phi, psi]) in series.iter().enumerate() {
        let mut add = |order, value| spread(&mut matrix, channels, order, column, value);
        for (j, a) in phi.iter().enumerate() {
            add(1 + j as i64, -a);
            add(1 - j as i64, (j as f64 - 1.0) * a.conj());
        }
        for (j, b) in psi.iter().enumerate() {
            add(-1 - j as i64, b.conj());
        }
    }
    matrix
}

/// Displacements 2G u/R of the hole's edge, channels × terms.
pub(super) fn displacements(
    channels: &[Channel],
    series: &[[Vec<C64>; 2]],
    kappa: f64,
) -> DMatrix<f64> {
    let mut matrix = DMatrix::zeros(channels.len(), series.len());
    for (column, [phi, psi]) in series.iter().enumerate() {
        let mut add = |order, value| spread(&mut matrix, channels, order, column, value);
        for (j, a) in phi.iter().enumerate() {
            let factor = (1.0 + kappa) / (j as f64 + 1.0);
            match j {
                0 => add(1, kappa * a - a.conj() + 2.0 * a.re),
                1 => {
                    add(2, factor * a);
                    add(0, -a.conj());
                }
                _ => {
                    add(1 + j as i64, factor * a);
                    add(1 - j as i64, -(1.0 + kappa) * a.conj());
                }
            }
        }
        for (j, b) in psi.iter().enumerate() {
            add(-1 - j as i64, -(1.0 + kappa) / (j as f64 + 1.0) * b.conj());
        }
    }
    matrix
}
