//! Shear beneath the edge.
//!
//! At a place inside the plate the stress is the value there of the plane that fits the recovered stresses of the nearest nodes best.

use nalgebra::{Matrix3, Vector3};
use stickslip::results::Results;
use stickslip::run::run;
use stickslip_fem_core::stress::polar;

use super::case::Case;
use super::plan::{LOADING, coulomb};
use crate::publish::Trouble;

/// Depth beneath the edge over the thickness; the last is that of the arc on which the report shows its stresses.
pub(crate) const DEPTHS: [f64; 6] = [0.0, 0.1, 0.25, 0.5, 1.0, 1.55];
/// Loads that are looked at `[lbf]`.
pub(crate) const LOADS: [f64; 2] = [400.0, 900.0];
/// Load steps: those of loading up to here `[lbf]`.
const LAST: f64 = 900.0;
/// `[in]`
const RADIUS: f64 = 0.375;
const THICKNESS: f64 = 0.06;
/// Nodes that a plane is fitted to.
const NEIGHBOURS: usize = 9;

/// A joint whose plate is looked into.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Joint {
    pub(crate) friction: f64,
    /// Radial `[in]`.
    pub(crate) clearance: f64,
}

/// Shear at one load and depth.
#[derive(Clone, Debug)]
pub(crate) struct Arc {
    pub(crate) joint: Joint,
    /// `[lbf]`
    pub(crate) load: f64,
    /// Over the thickness.
    pub(crate) depth: f64,
    /// |θ| `[degree]` from 1 to 90, and τ over P/(D t).
    pub(crate) profile: Vec<[f64; 2]>,
}

impl Arc {
    /// |θ| where the shear changes its sign `[degree]`, and whether it is forward before the first of these places.
    pub(crate) fn signs(&self) -> (bool, Vec<f64>) {
        let largest = self
            .profile
            .iter()
            .fold(0.0_f64, |most, row| row[1].abs().max(most));
        let signed = self
            .profile
            .iter()
            .filter(|row| row[1].abs() > 1e-2 * largest);
        let rows: Vec<&[f64; 2]> = signed.collect();
        let forward = rows.first().is_some_and(|row| row[1] > 0.0);
        let changes = rows.windows(2).filter(|pair| pair[0][1] * pair[1][1] < 0.0);
        let places = changes.map(|pair| {
            let part = pair[0][1] / (pair[0][1] - pair[1][1]);
            pair[0][0] + part * (pair[1][0] - pair[0][0])
        });
        (forward, places.collect())
    }
}

/// Solves a joint and reads the shear along arcs beneath its edge.
pub(crate) fn look(joint: Joint, spacing: f64) -> Result<Vec<Arc>, Trouble> {
    let loads: Vec<f64> = LOADING.into_iter().filter(|&load| load <= LAST).collect();
    let case = Case {
        clearance: joint.clearance,
        ..Case::new(
            "depth",
            "beneath the edge",
            &coulomb(joint.friction),
            &loads,
        )
    };
    let mut scene = case.scene(spacing, &["output.fields=\"all\""])?;
    scene.failure = None;
    let results = run(&scene, &mut |_| {})?;
    let mut arcs = Vec::new();
    for load in LOADS {
        let step = loads
            .iter()
            .position(|&own| own == load)
            .ok_or("no such load")?;
        for depth in DEPTHS {
            let profile = if depth == 0.0 {
                on_edge(&results, step)?
            } else {
                inside(&results, step, depth)?
            };
            arcs.push(Arc {
                joint,
                load,
                depth,
                profile,
            });
        }
    }
    Ok(arcs)
}

fn mean(results: &Results, step: usize) -> Result<f64, Trouble> {
    let bearing = results.steps[step].edges[0].bearing_stress(&results.edges[0]);
    Ok(bearing.ok_or("no bearing stress")?)
}

fn on_edge(results: &Results, step: usize) -> Result<Vec<[f64; 2]>, Trouble> {
    let mean = mean(results, step)?;
    let rows = results.edges[0]
        .parameter
        .iter()
        .zip(&results.steps[step].edges[0].rows);
    let rows = rows.map(|(theta, row)| [theta.to_degrees(), row.tau / mean]);
    Ok(rows
        .filter(|row| (0.5..=90.0 + 1e-9).contains(&row[0]))
        .collect())
}

fn inside(results: &Results, step: usize, depth: f64) -> Result<Vec<[f64; 2]>, Trouble> {
    let mean = mean(results, step)?;
    let index = results
        .bodies
        .iter()
        .position(|body| body.name == "plate")
        .ok_or("no plate")?;
    let mesh = results.bodies[index].mesh.as_ref().ok_or("no mesh")?;
    let mut fields = results.steps[step].fields.iter();
    let fields = fields
        .find(|fields| fields.body == index)
        .ok_or("no fields")?;
    let display = |length: f64| results.units.length.from_base(length);
    let near: Vec<Node> = mesh
        .nodes()
        .iter()
        .zip(&fields.stress)
        .map(|(node, &stress)| ([display(node[0]), display(node[1])], stress))
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
        let basis = Vector3::new(
            1.0,
            (node[0] - place[0]) / scale,
            (node[1] - place[1]) / scale,
        );
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
