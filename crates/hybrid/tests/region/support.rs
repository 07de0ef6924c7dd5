//! A sector under a smooth state of stress, known in closed form.

use std::sync::Arc;

use stickslip_fem_core::ElasticBody;
use stickslip_fem_core::material::{Isotropic, Material, PlaneState};
use stickslip_fem_core::mesh::{ElementKind, Mesh, Point};
use stickslip_hybrid::data::NodalDisplacements;
use stickslip_hybrid::region::sector::ArcSector;

pub(crate) const YOUNG: f64 = 70e3;
pub(crate) const POISSON: f64 = 0.3;

pub(crate) fn sector(cells: [usize; 2], kind: ElementKind) -> ArcSector {
    ArcSector {
        centre: [3.0, -1.0],
        hole: 9.0,
        stand_off: 1.0,
        outer: 20.0,
        angles: [-0.9, 1.2],
        cells,
        growth: 1.5,
        kind,
    }
}

pub(crate) fn body(mesh: Mesh) -> Arc<ElasticBody> {
    let material = Isotropic::new(YOUNG, POISSON, PlaneState::Stress).unwrap();
    let materials: Vec<Arc<dyn Material>> = mesh
        .blocks()
        .iter()
        .map(|_| Arc::new(material) as Arc<dyn Material>)
        .collect();
    Arc::new(ElasticBody::new(Arc::new(mesh), materials, 2.0).unwrap())
}

/// Displacements of `nodes` by the field `u`, without covariance.
pub(crate) fn sampled(
    mesh: &Mesh,
    nodes: &[usize],
    u: impl Fn(Point) -> [f64; 2],
) -> NodalDisplacements {
    NodalDisplacements {
        nodes: nodes.to_vec(),
        values: nodes
            .iter()
            .flat_map(|&node| u(mesh.nodes()[node]))
            .collect(),
        covariance: Vec::new(),
    }
}

/// A uniform strain and a rigid motion.
pub(crate) fn uniform([x, y]: Point) -> [f64; 2] {
    [0.3 + 1e-3 * x + 0.4e-3 * y, -0.1 - 0.7e-3 * y + 0.9e-3 * x]
}

/// Stress (σ_xx, σ_yy, τ_xy) of [`uniform`].
pub(crate) fn uniform_stress() -> [f64; 3] {
    let factor = YOUNG / (1.0 - POISSON * POISSON);
    let [xx, yy, xy] = [1e-3, -0.7e-3, 1.3e-3];
    [
        factor * (xx + POISSON * yy),
        factor * (yy + POISSON * xx),
        factor * (1.0 - POISSON) / 2.0 * xy,
    ]
}
