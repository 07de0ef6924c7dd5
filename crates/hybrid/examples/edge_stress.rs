//! Finds the hoop stress on the edge of a hole from displacements around it, with its standard deviation.
//!
//! The displacements are those of Kirsch (1898) in an infinite aluminium plate under 60 MPa along x, sampled on the two circles that
//! bound a ring of finite elements, with a standard deviation of 10 nm. The hoop stress at θ = 90° is three times the remote stress.
//!
//! Lengths in mm, stresses in MPa.

use std::error::Error;
use std::f64::consts::{FRAC_PI_2, TAU};
use std::sync::Arc;

use stickslip_fem_core::ElasticBody;
use stickslip_fem_core::material::{Isotropic, PlaneState};
use stickslip_fem_core::mesh::{ElementKind, Point};
use stickslip_hybrid::data::NodalDisplacements;
use stickslip_hybrid::region::outputs::EdgeRows;
use stickslip_hybrid::region::sector::ArcSector;
use stickslip_hybrid::region::{Region, independent_covariance};

const STRESS: f64 = 60.0;
const YOUNG: f64 = 71_700.0;
const POISSON: f64 = 0.33;
const RADIUS: f64 = 2.0;
const DEVIATION: f64 = 1e-5;

/// Displacement of an infinite plate in plane stress with a hole, stretched along x.
fn kirsch([x, y]: Point) -> [f64; 2] {
    let (q, theta) = (RADIUS / x.hypot(y), y.atan2(x));
    let kappa = (3.0 - POISSON) / (1.0 + POISSON);
    let factor = STRESS * RADIUS * (1.0 + POISSON) / (4.0 * YOUNG);
    let u = (kappa + 1.0) * theta.cos() / q
        + 2.0 * q * ((1.0 + kappa) * theta.cos() + (3.0 * theta).cos())
        - 2.0 * q.powi(3) * (3.0 * theta).cos();
    let v = (kappa - 3.0) * theta.sin() / q
        + 2.0 * q * ((1.0 - kappa) * theta.sin() + (3.0 * theta).sin())
        - 2.0 * q.powi(3) * (3.0 * theta).sin();
    [factor * u, factor * v]
}

fn main() -> Result<(), Box<dyn Error>> {
    let ring = ArcSector {
        centre: [0.0, 0.0],
        hole: RADIUS,
        stand_off: 0.0,
        outer: 2.0 * RADIUS,
        angles: [0.0, TAU],
        cells: [48, 8],
        growth: 2.0,
        kind: ElementKind::Q8,
    };
    let mesh = Arc::new(ring.mesh()?);
    let aluminium = Isotropic::new(YOUNG, POISSON, PlaneState::Stress)?;
    let body = Arc::new(ElasticBody::new(
        Arc::clone(&mesh),
        vec![Arc::new(aluminium)],
        1.0,
    )?);

    // All boundary nodes move as measured, and the forces inside vanish.
    let region = Region::new(&body, &[])?;
    let nodes = region.prescribed_nodes();
    let measured = NodalDisplacements {
        values: (nodes.iter())
            .flat_map(|&node| kirsch(mesh.nodes()[node]))
            .collect(),
        covariance: independent_covariance(nodes.len(), [DEVIATION; 2]),
        nodes,
    };

    // Three rows per node of the edge: radial, hoop and shear stress.
    let edge = EdgeRows::new(&body, "inner")?;
    let stresses = region.propagate(&edge.rows, &measured)?;
    let top = (0..edge.nodes.len())
        .min_by(|&a, &b| {
            let off = |k: usize| (edge.parameter[k] / RADIUS - FRAC_PI_2).abs();
            off(a).total_cmp(&off(b))
        })
        .ok_or("the edge has nodes")?;
    let hoop = stresses.values[3 * top + 1];
    let deviation = stresses.deviations()[3 * top + 1];
    println!(
        "hoop stress at 90°: ({hoop:.1} ± {deviation:.1}) MPa, Kirsch {:.1} MPa",
        3.0 * STRESS
    );
    assert!((hoop - 3.0 * STRESS).abs() < 0.02 * 3.0 * STRESS);
    Ok(())
}
