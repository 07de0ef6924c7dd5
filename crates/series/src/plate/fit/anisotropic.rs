//! Potentials of an anisotropic plate: polynomials and corners in the two planes w_k, with the series that keep the hole's edge free of traction.
//!
//! ```text
//! φ_k = Σ_n a_n q_n^k(w_k),     t(θ) = 2 Re Σ (μ_k, −1) φ_k dw_k/dθ,     du/dθ = 2 Re Σ (p_k, q_k) φ_k dw_k/dθ     on the circle
//! ```
//!
//! Modes of a term on the circle are sums over even angles. In a plate that is symmetric about x each term is added to its mirror image, or subtracted from it.

use std::f64::consts::TAU;
use std::sync::Arc;

use nalgebra::{Complex, DMatrix, DVector};

use super::task::{Drawn, Task, rows};
use crate::arnoldi::{Basis, Values};
use crate::channel::{Channel, Unit};
use crate::field::OuterPlanes;
use crate::lekhnitskii::Planes;
use crate::outline::{EdgePoint, Surrounding};

type C64 = Complex<f64>;

/// Terms of φ_1 and φ_2.
#[derive(Clone, Debug)]
pub(crate) struct AnisotropicTerms {
    planes: Planes,
    bases: [Arc<Basis>; 2],
    terms: Vec<Vec<Part>>,
}

/// A function of one plane times an amount. Terms are sums of such parts.
#[derive(Clone, Copy, Debug)]
struct Part {
    plane: usize,
    function: Function,
    amount: C64,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Function {
    /// q_n.
    Polynomial(usize),
    /// ln(1 − w/c) of the corner c.
    Corner(C64),
}

/// All terms up to `degree`, and what they do at `points` and on the hole.
pub(super) fn draw(
    task: &Task<'_>,
    planes: &Planes,
    points: &[Vec<EdgePoint>; 2],
    degree: usize,
) -> (AnisotropicTerms, Drawn) {
    let [fitted, checked] = points;
    let places = |points: &[EdgePoint], plane| -> Vec<C64> {
        let places = points.iter().map(|point| planes.at(plane, point.place));
        places.collect()
    };
    let basis = |plane| {
        let mut all = places(fitted, plane);
        if task.surrounding.images.is_some() {
            let images = fitted.iter().map(|point| point.place.conj());
            all.extend(images.map(|place| planes.at(plane, place)));
        }
        // One polynomial more than terms, for their antiderivatives.
        Basis::new(&all, degree + 1, false)
    };
    let [(first, on_first), (second, on_second)] = [basis(0), basis(1)];
    let bases = [first, second];
    let terms = terms(task, planes, degree);
    let own = on_points(planes, fitted, &terms, &[on_first, on_second]);
    let at = |points: &[EdgePoint]| [0, 1].map(|plane| bases[plane].at(&places(points, plane)));
    let checks = on_points(planes, checked, &terms, &at(checked));

    let circle = circle(4 * (task.orders as usize + 2));
    let values = at(&circle);
    let units = task.channels;
    let stresses = rows(circle.len(), terms.len(), |k, column| {
        planes.resultant(along(planes, &circle[k], &terms[column], &values, k))
    });
    let slopes = rows(circle.len(), terms.len(), |k, column| {
        planes.motion(along(planes, &circle[k], &terms[column], &values, k))
    });
    let answers = -modes(&circle, units, |_| C64::from(1.0)).tr_mul(&stresses);
    // u_K = (du/dθ)_K/iK; the mean motion is counted as none.
    let mut displacements = modes(&circle, units, |order| {
        if order == 0 {
            C64::from(0.0)
        } else {
            C64::new(0.0, -1.0 / order as f64)
        }
    })
    .tr_mul(&slopes);
    displacements.gemm(1.0, &hole_motions(planes, units), &answers, 1.0);
    let drawn = Drawn {
        hole: [fitted, checked].map(|points| hole_tractions(planes, points, units)),
        terms: [own, checks],
        answers,
        displacements,
    };
    let terms = AnisotropicTerms {
        planes: *planes,
        bases: bases.map(Arc::new),
        terms,
    };
    (terms, drawn)
}

/// Polynomials and corners with the units and the symmetry of the task.
fn terms(task: &Task<'_>, planes: &Planes, degree: usize) -> Vec<Vec<Part>> {
    let mirrored = |part: &Part| Part {
        plane: planes.image(part.plane),
        function: match part.function {
            Function::Corner(place) => Function::Corner(place.conj()),
            polynomial @ Function::Polynomial(_) => polynomial,
        },
        amount: part.amount.conj(),
    };
    let sign = match (&task.surrounding.images, task.units) {
        (Some(_), [Unit::Real]) => 1.0,
        (Some(_), [Unit::Imaginary]) => -1.0,
        _ => 0.0,
    };
    let completed = |mut parts: Vec<Part>| {
        if sign != 0.0 {
            let images: Vec<Part> = parts.iter().map(mirrored).collect();
            parts.extend(images.into_iter().map(|part| Part {
                amount: sign * part.amount,
                ..part
            }));
        }
        merged(parts)
    };
    let units = [Unit::Real.value(), Unit::Imaginary.value()];
    let polynomials = (0..=degree).flat_map(|degree| {
        [0, 1].into_iter().flat_map(move |plane| {
            units.into_iter().map(move |amount| {
                let function = Function::Polynomial(degree);
                vec![Part {
                    plane,
                    function,
                    amount,
                }]
            })
        })
    });
    // Of two planes that are images of each other the terms of one are enough.
    let once = sign == 0.0 || planes.image(0) == 0;
    let polynomials = polynomials.filter(|parts| once || parts[0].plane == 0);
    let corners = task.surrounding.corners().map(|place| {
        let part = |(plane, amount)| Part {
            plane,
            function: Function::Corner(planes.at(plane, place)),
            amount,
        };
        planes.corner().into_iter().enumerate().map(part).collect()
    });
    let all = polynomials.chain(corners).map(completed);
    all.filter(|parts| !parts.is_empty()).collect()
}

/// Parts of one function added, without those that vanish.
fn merged(parts: Vec<Part>) -> Vec<Part> {
    const SAME: f64 = 1e-9;
    let mut found: Vec<Part> = Vec::with_capacity(parts.len());
    for part in parts {
        let same = |other: &&mut Part| {
            other.plane == part.plane
                && match (other.function, part.function) {
                    (Function::Corner(a), Function::Corner(b)) => (a - b).norm() < SAME * a.norm(),
                    (a, b) => a == b,
                }
        };
        match found.iter_mut().find(same) {
            Some(own) => own.amount += part.amount,
            None => found.push(part),
        }
    }
    found.retain(|part| part.amount.norm() > SAME);
    found
}

/// σ n or du/ds follow from these v_k = φ_k dw_k/ds of a term at a point, the direction of s being counter-clockwise.
fn along(
    planes: &Planes,
    point: &EdgePoint,
    term: &[Part],
    values: &[Values; 2],
    index: usize,
) -> [C64; 2] {
    let mut phi = [C64::new(0.0, 0.0); 2];
    for &Part {
        plane,
        function,
        amount,
    } in term
    {
        phi[plane] += amount
            * match function {
                Function::Polynomial(degree) => values[plane].values[degree][index],
                Function::Corner(corner) => (1.0 - planes.at(plane, point.place) / corner).ln(),
            };
    }
    let tangent = C64::new(0.0, 1.0) * point.normal;
    [0, 1].map(|plane| phi[plane] * planes.at(plane, tangent))
}

/// Tractions of the terms without the series that keep the hole free, 2 points × terms.
fn on_points(
    planes: &Planes,
    points: &[EdgePoint],
    terms: &[Vec<Part>],
    values: &[Values; 2],
) -> DMatrix<f64> {
    rows(points.len(), terms.len(), |k, column| {
        let point = &points[k];
        planes
            .resultant(along(planes, point, &terms[column], values, k))
            .conj()
            * point.normal
    })
}

/// `count` places at even angles.
fn circle(count: usize) -> Vec<EdgePoint> {
    let place = |k| C64::from_polar(1.0, k as f64 * TAU / count as f64);
    (0..count)
        .map(|k| EdgePoint {
            edge: 0,
            place: place(k),
            normal: place(k),
        })
        .collect()
}

/// What turns samples x + iy on the circle into channels, times `factor` of the order: 2 samples × channels.
fn modes(circle: &[EdgePoint], channels: &[Channel], factor: impl Fn(i64) -> C64) -> DMatrix<f64> {
    rows(circle.len(), channels.len(), |k, column| {
        let Channel { order, unit } = channels[column];
        let weight = factor(order) * circle[k].place.powi(-order as i32) / circle.len() as f64;
        // Re(w z) = (conj w) · z as vectors, Im(w z) = (i conj w) · z.
        weight.conj() * unit.value()
    })
}

/// Displacements u/R of the hole's modes with unit stresses on the hole, channels × channels: u_−n = iM T_n/n.
fn hole_motions(planes: &Planes, channels: &[Channel]) -> DMatrix<f64> {
    let mut matrix = DMatrix::zeros(channels.len(), channels.len());
    for (column, Channel { order, unit }) in channels.iter().enumerate() {
        if *order == 0 {
            continue;
        }
        let count = order.abs();
        let turned = planes.matrix().apply(Planes::mode(*order, unit.value()));
        let [x, y] = turned.map(|part| part * C64::new(0.0, 1.0 / count as f64));
        let i = C64::new(0.0, 1.0);
        for (own, value) in [(-count, x + i * y), (count, x.conj() + i * y.conj())] {
            for (row, channel) in channels.iter().enumerate() {
                if channel.order == own {
                    matrix[(row, column)] = match channel.unit {
                        Unit::Real => value.re,
                        Unit::Imaginary => value.im,
                    };
                }
            }
        }
    }
    matrix
}

/// Tractions of the hole's modes with unit stresses on the hole, 2 points × channels.
fn hole_tractions(planes: &Planes, points: &[EdgePoint], channels: &[Channel]) -> DMatrix<f64> {
    let exterior = |point: &EdgePoint| [0, 1].map(|plane| planes.exterior(plane, point.place));
    let zetas: Vec<[C64; 2]> = points.iter().map(exterior).collect();
    // (dw_k/ds)/(dw_k/dθ).
    let ratios: Vec<[C64; 2]> = (points.iter().zip(&zetas))
        .map(|(point, zeta)| {
            let tangent = C64::new(0.0, 1.0) * point.normal;
            [0, 1].map(|k| planes.at(k, tangent) / planes.slope(k, zeta[k]))
        })
        .collect();
    let mut powers: Vec<[C64; 2]> = ratios;
    let mut power = 0;
    let mut matrix = DMatrix::zeros(2 * points.len(), channels.len());
    for (column, channel) in channels.iter().enumerate() {
        while power < channel.order.abs() {
            for (powers, zeta) in powers.iter_mut().zip(&zetas) {
                *powers = [powers[0] / zeta[0], powers[1] / zeta[1]];
            }
            power += 1;
        }
        let [one, two] = planes.split(stress(planes, channel));
        for (k, point) in points.iter().enumerate() {
            let along = [one * powers[k][0], two * powers[k][1]];
            let traction = planes.resultant(along).conj() * point.normal;
            matrix[(2 * k, column)] = traction.re;
            matrix[(2 * k + 1, column)] = traction.im;
        }
    }
    matrix
}

/// T of a channel with unit stress on the hole.
fn stress(planes: &Planes, channel: &Channel) -> [C64; 2] {
    match channel.order {
        0 => planes.mean(channel.unit.value()),
        order => Planes::mode(order, channel.unit.value()),
    }
}

/// Least |ζ_k| of the outline: modes of the hole reach it as its powers.
pub(crate) fn distance(planes: &Planes, surrounding: &Surrounding) -> f64 {
    const POINTS: usize = 400;
    let [points, _] = surrounding.points(POINTS);
    let all = points.iter().map(|point| point.place);
    let sizes = all.flat_map(|place| [0, 1].map(|plane| planes.exterior(plane, place).norm()));
    sizes.fold(f64::INFINITY, f64::min)
}

impl AnisotropicTerms {
    pub(super) fn count(&self) -> usize {
        self.terms.len()
    }

    /// The terms times `amounts`, for a field.
    pub(super) fn outer(&self, amounts: &DVector<f64>) -> OuterPlanes {
        let count = 1 + self.bases[0].degree();
        let mut coefficients = [
            vec![C64::new(0.0, 0.0); count],
            vec![C64::new(0.0, 0.0); count],
        ];
        let mut corners = [Vec::new(), Vec::new()];
        for (term, &amount) in self.terms.iter().zip(amounts.iter()) {
            for part in term {
                match part.function {
                    Function::Polynomial(degree) => {
                        coefficients[part.plane][degree] += part.amount * amount;
                    }
                    Function::Corner(place) => {
                        corners[part.plane].push((place, part.amount * amount));
                    }
                }
            }
        }
        OuterPlanes::new(self.planes, self.bases.clone(), coefficients, corners)
    }

    /// σ_rr + σ_θθ of each term at the place `direction` of the hole's edge.
    pub(super) fn sums_on_edge(&self, direction: C64) -> Vec<f64> {
        let places = [0, 1].map(|plane| self.planes.at(plane, direction));
        let values = [0, 1].map(|plane| self.bases[plane].values(places[plane]));
        let sum = |term: &Vec<Part>| {
            let mut phi = [C64::new(0.0, 0.0); 2];
            for part in term {
                phi[part.plane] += part.amount
                    * match part.function {
                        Function::Polynomial(degree) => values[part.plane][degree],
                        Function::Corner(corner) => (1.0 - places[part.plane] / corner).ln(),
                    };
            }
            self.planes.stress(phi).0
        };
        self.terms.iter().map(sum).collect()
    }

    /// σ_rr + σ_θθ of the hole's mode at the place `direction` of its edge.
    pub(super) fn mode_on_edge(&self, channel: &Channel, direction: C64) -> f64 {
        let planes = &self.planes;
        let power = direction.powi(-(channel.order.abs() as i32));
        let parts = planes.split(stress(planes, channel).map(|part| part * power));
        let phi = [0, 1].map(|plane| parts[plane] / planes.slope(plane, direction));
        planes.stress(phi).0
    }
}
