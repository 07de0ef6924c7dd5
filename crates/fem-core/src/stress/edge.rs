//! Stress on an edge whose tractions are known.
//!
//! With n the unit normal, t the normal turned by +90°, s the arc length along t and S' the compliance in (n, t), the
//! stress along the edge follows from the strain along the edge,
//!
//! ```text
//! ε_tt = t · ∂u/∂s = S'_tn σ_nn + S'_tt σ_tt + S'_ts τ_nt + ε₀_tt,
//! ```
//!
//! which for an isotropic plate is σ_tt = E ε_tt + ν σ_nn. The derivative is that of the polynomial of degree 2p in the
//! exact arc length through a node and its p neighbours on either side, p ≤ 2 being the order of the edge. It uses nothing but
//! the displacements of the edge, so neither the facets of the mesh nor the interior nodes of the cells spoil it. On edges of
//! order p > 2 it is that of the polynomial of degree p through the edge's own nodes, at a corner the mean of both edges.
//!
//! A rotation ω of the body has the derivative ω e_z × x′, with a part along t where x′ of the polynomial is not: between cells of
//! unequal length, or of unlike curvature. It is taken off, so that stresses do not depend on how far a free body has turned:
//!
//! ```text
//! ε_tt = t · u′ + (n · x′)/(t · x′) n · u′
//! ```
//!
//! At an open end the neighbours are all on one side, unless the end lies on a line of symmetry: then the path goes on
//! beyond it by reflection.
//!
//! On finite-element solutions around a hole the error falls as h² with Q4, as h⁴ with Q8 and Q9, about as h² with T6 and
//! between h and h² with T3. The derivative of each quadratic edge by itself, averaged at the corners, would fall only as
//! h²: the nodes of these cells are more accurate (h⁴) than the polynomial between them. With order p > 2 it falls as h^p.

use super::{StressError, length};
use crate::material::{Material, rotated_compliance, rotated_strain};

/// How one end of an open path goes on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PathEnd {
    /// Nothing is known beyond the end.
    Free,
    /// The end lies on a line of symmetry of body, material and load, which crosses the edge at a right angle; beyond it
    /// the path is its own mirror image. On the x axis, u_x is even and u_y odd.
    Mirror {
        /// Unit vector `[1]` along the line of symmetry: (1, 0) for the x axis.
        axis: [f64; 2],
    },
}

/// Whether a path has ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PathEnds {
    /// An open path, with its first and last end.
    Open([PathEnd; 2]),
    /// A closed path.
    Closed {
        /// Length of one turn `[length]`, positive.
        length: f64,
    },
}

/// An edge with its displacement and tractions. Every array has one entry per node of the path, in walk order, such as that
/// of an [`EdgePath`](crate::mesh::EdgePath).
#[derive(Clone, Copy, Debug)]
pub struct EdgeData<'a> {
    /// Polynomial order p of the edges; the path starts at a corner node, and every p-th is one.
    pub order: usize,
    /// Ends of the path.
    pub ends: PathEnds,
    /// Position along the exact curve, growing in the direction of t `[length]`. It may fall along the walk; on a circle
    /// with n = e_r it is R θ.
    pub parameter: &'a [f64],
    /// Place of each node on the exact curve, from any point of the axis of a mirror and in any unit: those of a circle or of a straight line may be
    /// its normals.
    pub place: &'a [[f64; 2]],
    /// Displacement (u_x, u_y) `[length]`.
    pub displacement: &'a [[f64; 2]],
    /// Unit normal n `[1]` of the exact curve, on either side; t is n turned by +90°.
    pub normal: &'a [[f64; 2]],
    /// σ_nn `[stress]`, tension positive.
    pub normal_stress: &'a [f64],
    /// τ_nt `[stress]`.
    pub shear_stress: &'a [f64],
}

/// Stress at an edge node in the frame (n, t) `[stress]`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EdgeStress {
    /// σ_nn, as given.
    pub normal: f64,
    /// σ_tt, recovered.
    pub tangential: f64,
    /// τ_nt, as given.
    pub shear: f64,
}

/// All three stresses at every node of `edge`, which bounds a body of `material`; `initial_strain` (ε_xx, ε_yy, γ_xy) `[1]` is the
/// strain without stress, such as [`Material::thermal_strain`].
///
/// # Errors
/// [`StressError::Length`] or [`StressError::PathNodes`] if the arrays do not fit each other, the order and the ends;
/// [`StressError::Parameter`] if the parameter does not run strictly one way (and, closed, through less than one turn);
/// [`StressError::Direction`] if a normal or a symmetry axis is not a unit vector.
pub fn edge_stresses(
    edge: &EdgeData<'_>,
    material: &dyn Material,
    initial_strain: [f64; 3],
) -> Result<Vec<EdgeStress>, StressError> {
    let turn = check(edge)?;
    let compliance = material.compliance();
    let places = EdgeData {
        displacement: edge.place,
        ..*edge
    };
    let stress = (0..edge.parameter.len()).map(|node| {
        let n = edge.normal[node];
        let slope = displacement_slope(edge, turn, node);
        let strain = slope[1] * n[0] - slope[0] * n[1] + turned(&places, turn, node, slope);
        let [tn, tt, ts] = rotated_compliance(&compliance, n)[1];
        let initial = rotated_strain(initial_strain, n)[1];
        let (normal, shear) = (edge.normal_stress[node], edge.shear_stress[node]);
        let tangential = (strain - initial - tn * normal - ts * shear) / tt;
        EdgeStress {
            normal,
            tangential,
            shear,
        }
    });
    Ok(stress.collect())
}

/// Checks `edge`; returns the signed change of the parameter in one turn, 0 for an open path.
fn check(edge: &EdgeData<'_>) -> Result<f64, StressError> {
    let nodes = edge.parameter.len();
    length("place", nodes, edge.place.len())?;
    length("displacement", nodes, edge.displacement.len())?;
    length("normal", nodes, edge.normal.len())?;
    length("normal_stress", nodes, edge.normal_stress.len())?;
    length("shear_stress", nodes, edge.shear_stress.len())?;
    let closed = matches!(edge.ends, PathEnds::Closed { .. });
    let edges = nodes.saturating_sub(usize::from(!closed)) / edge.order.max(1);
    let needed = match (edge.order, closed) {
        (1 | 2, false) => 2,
        (1 | 2, true) => 3,
        (_, false) => 1,
        (_, true) => 2,
    };
    let whole = nodes == edges * edge.order + usize::from(!closed);
    if !(edge.order > 0 && whole && edges >= needed) {
        return Err(StressError::PathNodes {
            nodes,
            order: edge.order,
            closed,
        });
    }
    for (node, n) in edge.normal.iter().enumerate() {
        unit("normal", node, *n)?;
    }
    if let PathEnds::Open(ends) = edge.ends {
        for (end, node) in ends.into_iter().zip([0, nodes - 1]) {
            if let PathEnd::Mirror { axis } = end {
                unit("symmetry axis", node, axis)?;
            }
        }
    }
    check_parameter(edge)
}

fn check_parameter(edge: &EdgeData<'_>) -> Result<f64, StressError> {
    let s = edge.parameter;
    let direction = (s[1] - s[0]).signum();
    let turn = match edge.ends {
        PathEnds::Open(_) => 0.0,
        PathEnds::Closed { length } => direction * length,
    };
    let last = (turn != 0.0).then(|| (s[s.len() - 1], s[0] + turn));
    let steps = s.windows(2).map(|pair| (pair[0], pair[1])).chain(last);
    for (node, (before, after)) in steps.enumerate() {
        let step = direction * (after - before);
        if !(step > 0.0 && step.is_finite()) {
            return Err(StressError::Parameter {
                node,
                before,
                after,
            });
        }
    }
    Ok(turn)
}

fn unit(name: &'static str, node: usize, v: [f64; 2]) -> Result<(), StressError> {
    let length = v[0].hypot(v[1]);
    if (length - 1.0).abs() <= 1e-6 {
        Ok(())
    } else {
        Err(StressError::Direction { name, node, length })
    }
}

/// ∂u/∂s at `node`: the mean of the derivatives of the polynomials through [`windows`].
fn displacement_slope(edge: &EdgeData<'_>, turn: f64, node: usize) -> [f64; 2] {
    let (degree, windows) = windows(edge, node);
    let share = 1.0 / windows.len() as f64;
    let slopes = windows.into_iter().map(|first| {
        let points: Vec<(f64, [f64; 2])> = (first..=first + degree)
            .map(|k| point_beyond(edge, turn, k))
            .collect();
        lagrange_slope(&points, node as isize - first)
    });
    slopes.fold([0.0; 2], |[x, y], [dx, dy]| {
        [x + share * dx, y + share * dy]
    })
}

/// The degree of the polynomials that give the derivative at `node`, and the first node of each. Up to order 2, `node` and its
/// neighbours on either side, at a free end all from inside; beyond, the nodes of each edge that has `node`.
fn windows(edge: &EdgeData<'_>, node: usize) -> (isize, Vec<isize>) {
    let (order, node) = (edge.order as isize, node as isize);
    let last = edge.parameter.len() as isize - 1;
    let (free_before, free_after) = match edge.ends {
        PathEnds::Open([before, after]) => (before == PathEnd::Free, after == PathEnd::Free),
        PathEnds::Closed { .. } => (false, false),
    };
    if order <= 2 {
        let centred = node - order;
        let first = if free_before && centred < 0 {
            0
        } else if free_after && node + order > last {
            last - 2 * order
        } else {
            centred
        };
        return (2 * order, vec![first]);
    }
    let start = node - node % order;
    let before = (node == start).then_some(start - order);
    let mut windows: Vec<isize> = before.into_iter().chain([start]).collect();
    windows.retain(|&first| !(free_before && first < 0 || free_after && first + order > last));
    (order, windows)
}

/// What the part along n of the displacement's `slope` at `node` adds to the strain along the edge; `places` has places for displacements.
fn turned(places: &EdgeData<'_>, turn: f64, node: usize, slope: [f64; 2]) -> f64 {
    let n = places.normal[node];
    let change = displacement_slope(places, turn, node);
    let (along_n, along_t) = (
        change[0] * n[0] + change[1] * n[1],
        change[1] * n[0] - change[0] * n[1],
    );
    if along_t == 0.0 {
        return 0.0;
    }
    along_n / along_t * (slope[0] * n[0] + slope[1] * n[1])
}

/// Derivative, at the point number `at`, of the polynomial through `points`.
///
/// Written for differences from the value at that point: Lₖ'(xₐ) = Π_{l≠k,a} (xₐ − xₗ) / Π_{l≠k} (xₖ − xₗ), and the
/// weights sum to zero.
fn lagrange_slope(points: &[(f64, [f64; 2])], at: isize) -> [f64; 2] {
    let at = at as usize;
    let (origin, value) = points[at];
    let mut slope = [0.0; 2];
    for (k, &(s, u)) in points.iter().enumerate().filter(|&(k, _)| k != at) {
        let others = points
            .iter()
            .enumerate()
            .filter(|&(l, _)| l != k && l != at);
        let weight = others.fold(1.0 / (s - origin), |w, (_, &(other, _))| {
            w * (origin - other) / (s - other)
        });
        (0..2).for_each(|i| slope[i] += weight * (u[i] - value[i]));
    }
    slope
}

/// Parameter and displacement of path node `k`, which may lie an edge, or up to two nodes, beyond an end: the path goes on by turning
/// round or by reflection.
fn point_beyond(edge: &EdgeData<'_>, turn: f64, k: isize) -> (f64, [f64; 2]) {
    let count = edge.parameter.len() as isize;
    let own = |k: isize| (edge.parameter[k as usize], edge.displacement[k as usize]);
    let reflected = |end: isize, axis: [f64; 2]| {
        let (s, u) = own(2 * end - k);
        let along = 2.0 * (axis[0] * u[0] + axis[1] * u[1]);
        (
            2.0 * own(end).0 - s,
            [along * axis[0] - u[0], along * axis[1] - u[1]],
        )
    };
    match edge.ends {
        PathEnds::Closed { .. } => {
            let (s, u) = own(k.rem_euclid(count));
            (s + turn * k.div_euclid(count) as f64, u)
        }
        PathEnds::Open([PathEnd::Mirror { axis }, _]) if k < 0 => reflected(0, axis),
        PathEnds::Open([_, PathEnd::Mirror { axis }]) if k >= count => reflected(count - 1, axis),
        PathEnds::Open(_) => own(k),
    }
}
