//! Shear on arcs beneath the edge.
//!
//! At a place inside the plate the stress is the value there of the plane that fits the recovered stresses of the nearest nodes best.

use nalgebra::{Matrix3, Vector3};
use stickslip::results::Results;
use stickslip_fem_core::stress::polar;
use toml::Table;

use super::{begun, crossings, loads, of_report};
use crate::study::TaskError;
use crate::study::record::{curve, fields, numbers, solved};

/// `[in]`
const RADIUS: f64 = 0.375;
const THICKNESS: f64 = 0.06;
/// Nodes that a plane is fitted to.
const NEIGHBOURS: usize = 9;
/// Shear below this part of the largest has no sign.
const NEGLIGIBLE: f64 = 1e-2;

/// A row for each of the loads `looked_at` `[lbf]` and `depths` over the thickness.
pub(super) fn rows(case: &Table) -> Result<Vec<Table>, TaskError> {
    let results = solved(case)?;
    let mut rows = Vec::new();
    for load in numbers(case, "looked_at") {
        let step = loads(case)
            .iter()
            .position(|own| *own == load)
            .ok_or("no such load")?;
        for depth in numbers(case, "depths") {
            let profile = if depth == 0.0 {
                on_edge(&results, step)?
            } else {
                inside(&results, step, depth)?
            };
            let largest = profile
                .iter()
                .fold(0.0_f64, |most, row| row[1].abs().max(most));
            let signed = profile
                .iter()
                .filter(|row| row[1].abs() > NEGLIGIBLE * largest);
            let signed: Vec<[f64; 2]> = signed.copied().collect();
            let changes = crossings(&signed).into_iter().rev().map(of_report);
            let mut row = begun(case);
            row.extend(fields([
                ("load_lbf", load.into()),
                ("depth_over_thickness", depth.into()),
                (
                    "forward_at_bearing_point",
                    signed.first().is_some_and(|row| row[1] > 0.0).into(),
                ),
                ("changes_deg", changes.collect::<Vec<_>>().into()),
                (
                    "shear",
                    curve(
                        profile
                            .iter()
                            .map(|&[angle, shear]| [of_report(angle), shear]),
                    ),
                ),
            ]));
            rows.push(row);
        }
    }
    Ok(rows)
}

/// P/(D t) of a step.
fn mean(results: &Results, step: usize) -> Result<f64, TaskError> {
    let bearing = results.steps[step].edges[0].bearing_stress(&results.edges[0]);
    Ok(bearing.ok_or("no bearing stress")?)
}

/// |θ| `[degree]` up to 90, and τ over P/(D t).
fn on_edge(results: &Results, step: usize) -> Result<Vec<[f64; 2]>, TaskError> {
    let mean = mean(results, step)?;
    let nodes = results.edges[0].parameter.iter();
    let rows = nodes.zip(&results.steps[step].edges[0].rows);
    let rows = rows.map(|(theta, row)| [theta.to_degrees(), row.tau / mean]);
    Ok(rows
        .filter(|row| (0.5..=90.0 + 1e-9).contains(&row[0]))
        .collect())
}

/// |θ| `[degree]` from 1 to 90, and τ over P/(D t) at a depth over the thickness.
fn inside(results: &Results, step: usize, depth: f64) -> Result<Vec<[f64; 2]>, TaskError> {
    let mean = mean(results, step)?;
    let mut bodies = results.bodies.iter();
    let index = bodies
        .position(|body| body.name == "plate")
        .ok_or("no plate")?;
    let mesh = results.bodies[index].mesh.as_ref().ok_or("no mesh")?;
    let mut fields = results.steps[step].fields.iter();
    let fields = fields
        .find(|fields| fields.body == index)
        .ok_or("no fields")?;
    let display = |length: f64| results.units.length.from_base(length);
    let nodes = mesh.nodes().iter().map(|node| node.map(display));
    let near: Vec<Node> = nodes
        .zip(fields.stress.iter().copied())
        .filter(|(node, _)| node[0].hypot(node[1]) < RADIUS + (depth + 1.0) * THICKNESS)
        .collect();
    let at = |degree: u32| {
        let theta = f64::from(degree).to_radians();
        let radius = RADIUS + depth * THICKNESS;
        let place = [radius * theta.cos(), radius * theta.sin()];
        let stress = fitted(&near, place).ok_or("nodes on one line")?;
        Ok([f64::from(degree), polar(stress, theta)[2] / mean])
    };
    (1..=90).map(at).collect()
}

/// A place `[in]`, and the stress (xx, yy, xy) there.
type Node = ([f64; 2], [f64; 3]);

/// The plane through the values of the nearest nodes, at `place`; `None` if they do not span one.
fn fitted(nodes: &[Node], place: [f64; 2]) -> Option<[f64; 3]> {
    let squared = |node: &[f64; 2]| (node[0] - place[0]).powi(2) + (node[1] - place[1]).powi(2);
    let mut nearest: Vec<(f64, &Node)> = nodes.iter().map(|own| (squared(&own.0), own)).collect();
    if nearest.len() < NEIGHBOURS {
        return None;
    }
    nearest.select_nth_unstable_by(NEIGHBOURS - 1, |a, b| a.0.total_cmp(&b.0));
    nearest.truncate(NEIGHBOURS);
    let scale = nearest
        .iter()
        .fold(0.0_f64, |most, own| most.max(own.0))
        .sqrt();
    let mut matrix = Matrix3::zeros();
    let mut right = [Vector3::zeros(); 3];
    for (squared, (node, value)) in nearest {
        let weight = (-2.0 * squared / (scale * scale)).exp();
        let [x, y] = [0, 1].map(|axis| (node[axis] - place[axis]) / scale);
        let basis = Vector3::new(1.0, x, y);
        matrix += weight * basis * basis.transpose();
        for (right, value) in right.iter_mut().zip(value) {
            *right += weight * *value * basis;
        }
    }
    let inverse = matrix.try_inverse()?;
    Some(right.map(|right| (inverse * right)[0]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_plane_is_fitted_exactly() {
        let of = |[x, y]: [f64; 2]| [1.0 + 2.0 * x - y, x, 3.0];
        let nodes: Vec<Node> = (0..25_u32)
            .map(|k| [f64::from(k % 5) + 0.1 * f64::from(k / 5), f64::from(k / 5)])
            .map(|node| (node, of(node)))
            .collect();
        let place = [2.3, 1.9];
        let found = fitted(&nodes, place).expect("they span a plane");
        for (found, exact) in found.iter().zip(of(place)) {
            // Rounding of a well-conditioned 3 × 3 system.
            assert!((found - exact).abs() < 1e-12);
        }
        assert!(fitted(&nodes[..5], place).is_none());
    }
}
