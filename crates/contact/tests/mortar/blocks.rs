//! Rectangular bodies under constant stress.

use std::sync::Arc;

use stickslip_fem_core::generate::{Generate, Rectangle};
use stickslip_fem_core::load::edge_load;
use stickslip_fem_core::material::{Isotropic, Material, PlaneState};
use stickslip_fem_core::mesh::{ElementKind, Mesh};
use stickslip_fem_core::stress::ElasticField;
use stickslip_fem_core::{CondensedBody, ElasticBody, HeldDirection, LoadCase, Support};

pub(crate) const THICKNESS: f64 = 0.7;

pub(crate) fn material() -> Arc<dyn Material> {
    Arc::new(Isotropic::new(100.0, 0.3, PlaneState::Stress).unwrap())
}

/// A rectangle with equal divisions along y and the given ones along x.
pub(crate) fn rectangle(xs: &[f64], y: [f64; 2], kind: ElementKind) -> Mesh {
    let ys = vec![y[0], 0.4 * y[0] + 0.6 * y[1], y[1]];
    Rectangle {
        xs: xs.to_vec(),
        ys,
        kind,
    }
    .generate()
    .unwrap()
}

/// `mesh` under the tractions of the constant stress (xx, yy, xy) on the sides `pulled`, condensed to `interface`.
pub(crate) fn stressed(
    mesh: Mesh,
    interface: &[usize],
    stress: [f64; 3],
    pulled: &[&str],
    supports: Vec<Support>,
) -> CondensedBody {
    let mut forces = vec![0.0; 2 * mesh.nodes().len()];
    for side in pulled {
        let edges = &mesh.edge_set(side).unwrap().edges;
        let load = edge_load(&mesh, edges, THICKNESS, |at| {
            let [nx, ny] = at.normal;
            [
                stress[0] * nx + stress[2] * ny,
                stress[2] * nx + stress[1] * ny,
            ]
        });
        forces
            .iter_mut()
            .zip(load)
            .for_each(|(sum, part)| *sum += part);
    }
    let case = LoadCase {
        forces,
        ..LoadCase::default()
    };
    let body = ElasticBody::new(Arc::new(mesh), vec![material()], THICKNESS)
        .unwrap()
        .with_supports(supports)
        .with_load_cases(vec![case])
        .unwrap();
    Arc::new(body).condense(interface).unwrap()
}

/// Nodes of the named sides.
pub(crate) fn nodes_of(mesh: &Mesh, side: &str) -> Vec<usize> {
    mesh.edge_path(side).unwrap().nodes
}

pub(crate) fn hold(nodes: Vec<usize>, direction: HeldDirection) -> Support {
    Support {
        nodes,
        direction,
        displacement: 0.0,
    }
}

/// Largest deviation of the stress at the Gauss points from `expected`.
pub(crate) fn stress_error(body: &CondensedBody, u: &[f64], expected: [f64; 3]) -> f64 {
    let mesh = body.body().mesh();
    let material = material();
    let materials = [material.as_ref()];
    let field = ElasticField::new(mesh, &materials, u, None).unwrap();
    let stresses = field.gauss_stresses();
    let deviations = stresses
        .values()
        .iter()
        .flat_map(|at| (0..3).map(|i| (at[i] - expected[i]).abs()));
    deviations.fold(0.0, f64::max)
}
