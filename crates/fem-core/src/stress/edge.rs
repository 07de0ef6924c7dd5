//! Stress on an edge whose tractions are known.
//!
//! With n the unit normal, t the normal turned by +90°, s the arc length along t and S' the compliance in (n, t), the
//! stress along the edge follows from the strain along the edge,
//!
//! ```text
//! ε_tt = t · ∂u/∂s = S'_tn σ_nn + S'_tt σ_tt + S'_ts τ_nt + ε₀_tt,
//! ```
//!
//! which for an isotropic plate is σ_tt = E ε_tt + ν σ_nn. The derivative uses only the displacements of the edge and the
//! exact arc length, so neither the facets of the mesh nor the cells' other nodes spoil it:
//!
//! - order 1: the parabola through a node and its two neighbours;
//! - order 2: DERIVATIVE_DOC
//!
//! At an open end the parabola is one-sided, unless the end lies on a line of symmetry: then the path goes on beyond it by
//! reflection.

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
        /// Unit vector along the line of symmetry: (1, 0) for the x axis.
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
        /// Length of one turn [length], positive.
        length: f64,
    },
}

/// An edge with its displacement and tractions. Every array has one entry per node of the path, in walk order, such as that
/// of an [`EdgePath`](crate::mesh::EdgePath).
#[derive(Clone, Copy, Debug)]
pub struct EdgeData<'a> {
    /// Polynomial order of the edges, 1 or 2; a path of order 2 starts at a corner node.
    pub order: usize,
    /// Ends of the path.
    pub ends: PathEnds,
    /// Position along the exact curve, growing in the direction of t [length]. It may fall along the walk; on a circle
    /// with n = e_r it is R θ.
    pub parameter: &'a [f64],
    /// Displacement (u_x, u_y) [length].
    pub displacement: &'a [[f64; 2]],
    /// Unit normal n of the exact curve, on either side; t is n turned by +90°.
    pub normal: &'a [[f64; 2]],
    /// σ_nn [stress], tension positive.
    pub normal_stress: &'a [f64],
    /// τ_nt [stress].
    pub shear_stress: &'a [f64],
}

/// Stress at an edge node in the frame (n, t) [stress].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EdgeStress {
    /// σ_nn, as given.
    pub normal: f64,
    /// σ_tt, recovered.
    pub tangential: f64,
    /// τ_nt, as given.
    pub shear: f64,
}

/// All three stresses at every node of `edge`, which bounds a body of `material`; `initial_strain` (ε_xx, ε_yy, γ_xy) is the
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
    let stress = (0..edge.parameter.len()).map(|node| {
        let n = edge.normal[node];
        let slope = displacement_slope(edge, turn, node);
        let strain = slope[1] * n[0] - slope[0] * n[1];
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
    length("displacement", nodes, edge.displacement.len())?;
    length("normal", nodes, edge.normal.len())?;
    length("normal_stress", nodes, edge.normal_stress.len())?;
    length("shear_stress", nodes, edge.shear_stress.len())?;
    let closed = matches!(edge.ends, PathEnds::Closed { .. });
    let complete = match (edge.order, closed) {
        (1, _) => nodes >= 3,
        (2, false) => nodes >= 5 && nodes % 2 == 1,
        (2, true) => nodes >= 4 && nodes.is_multiple_of(2),
        _ => false,
    };
    if !complete {
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

/// ∂u/∂s at `node`.
fn displacement_slope(edge: &EdgeData<'_>, turn: f64, node: usize) -> [f64; 2] {
    let node = node as isize;
    if edge.order == 1 || node % 2 == 1 {
        return slope_in_window(edge, turn, node - 1, node);
    }
    let sides = [node - 2, node].map(|first| slope_in_window(edge, turn, first, node));
    [0, 1].map(|i| 0.5 * (sides[0][i] + sides[1][i]))
}

/// ∂u/∂s at `node` of the parabola through the nodes `first`, `first + 1` and `first + 2`, moved inside free ends.
fn slope_in_window(edge: &EdgeData<'_>, turn: f64, first: isize, node: isize) -> [f64; 2] {
    let last = edge.parameter.len() as isize - 1;
    let first = match edge.ends {
        PathEnds::Open([PathEnd::Free, _]) if first < 0 => 0,
        PathEnds::Open([_, PathEnd::Free]) if first + 2 > last => last - 2,
        _ => first,
    };
    let points = [first, first + 1, first + 2].map(|k| point_beyond(edge, turn, k));
    let at = edge.parameter[node as usize];
    let s = points.map(|point| point.0);
    let weight = |k: usize| {
        let (i, j) = ((k + 1) % 3, (k + 2) % 3);
        ((at - s[i]) + (at - s[j])) / ((s[k] - s[i]) * (s[k] - s[j]))
    };
    let weights = [weight(0), weight(1), weight(2)];
    [0, 1].map(|i| (0..3).map(|k| weights[k] * points[k].1[i]).sum())
}

/// Parameter and displacement of path node `k`, which may lie up to two nodes beyond an end: the path goes on by turning
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
