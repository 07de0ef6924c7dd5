//! A pin with interference in a ring held outside: the pressure is uniform (Lamé).
//!
//! ```text
//! δ = p R (1 − ν)/E + p (1 − ν²)/E · (b²/R − R) / [(1 + ν) + (1 − ν) b²/R²]
//! ```

use std::f64::consts::PI;
use std::sync::Arc;

use stickslip_contact::{EdgeSide, InitialGap, Multipliers, Projection, mortar};
use stickslip_fem_core::generate::{
    Disk, Extent, Generate, Growth, Outline, PlateWithHole, uniform_angles,
};
use stickslip_fem_core::mesh::{ElementKind, Mesh};
use stickslip_fem_core::{CondensedBody, ElasticBody, HeldDirection, LoadCase, Support};

use crate::blocks::{hold, material, nodes_of};
use crate::{BOTH, solve, tractions};

const RADIUS: f64 = 1.0;
const OUTER: f64 = 3.0;
const INTERFERENCE: f64 = 1e-3;
const GROWTH: Growth = Growth::Geometric { aspect: 1.0 };

fn exact_pressure() -> f64 {
    let (young, nu) = (100.0, 0.3);
    let ring =
        (OUTER * OUTER / RADIUS - RADIUS) / (1.0 + nu + (1.0 - nu) * (OUTER / RADIUS).powi(2));
    INTERFERENCE * young / (RADIUS * (1.0 - nu) + (1.0 - nu * nu) * ring)
}

fn around(mesh: &Mesh, set: &str) -> (Vec<usize>, EdgeSide) {
    let path = mesh.counter_clockwise(&mesh.edge_path(set).unwrap(), [0.0; 2]);
    let angles = mesh.angles(&path, [0.0; 2]);
    let side = EdgeSide::open((0..angles.len()).collect(), angles, path.order).unwrap();
    (path.nodes, side)
}

fn body(mesh: Mesh, interface: &[usize], supports: Vec<Support>) -> CondensedBody {
    let body = ElasticBody::new(Arc::new(mesh), vec![material()], 1.0)
        .unwrap()
        .with_supports(supports)
        .with_load_cases(vec![LoadCase::default()])
        .unwrap();
    Arc::new(body).condense(interface).unwrap()
}

/// Largest deviation of the pressure from the exact one, relative, with `cells` cells on half the hole and the pin.
fn deviation(cells: [usize; 2], kind: ElementKind, multipliers: Multipliers) -> f64 {
    let ring = PlateWithHole {
        hole_radius: RADIUS,
        outline: Outline::Ring {
            outer_radius: OUTER,
        },
        extent: Extent::Half,
        angles: uniform_angles(Extent::Half, cells[0]),
        layers: cells[0] / 2,
        growth: GROWTH,
        far_cells: 1,
        kind,
    }
    .generate()
    .unwrap();
    let pin = Disk {
        radius: RADIUS,
        centre: [0.0; 2],
        extent: Extent::Half,
        angles: uniform_angles(Extent::Half, cells[1]),
        core: Disk::CORE,
        layers: cells[1] / 4,
        growth: GROWTH,
        kind,
    }
    .generate()
    .unwrap();
    let (hole, outside) = around(&ring, "hole");
    let (rim, inside) = around(&pin, "rim");
    let held =
        |mesh: &Mesh, set: &str, direction| hold(mesh.node_set(set).unwrap().to_vec(), direction);
    let of_ring = vec![
        hold(nodes_of(&ring, "outer"), HeldDirection::X),
        hold(nodes_of(&ring, "outer"), HeldDirection::Y),
        held(&ring, "symmetry", HeldDirection::Y),
    ];
    let of_pin = vec![held(&pin, "symmetry", HeldDirection::Y)];
    let projection = Projection {
        multipliers,
        length: RADIUS,
        thickness: 1.0,
        normal: &|angle| [angle.cos(), angle.sin()],
        gap: InitialGap::Exact(&|_| -INTERFERENCE),
        material_angle: 0.0,
        symmetry: [true; 2],
    };
    let made = mortar::project(&outside, &inside, &projection).unwrap();
    let area: f64 = made.points.iter().map(|point| point.area).sum();
    assert!((area - PI * RADIUS).abs() < 1e-12);
    let (first, second) = (body(ring, &hole, of_ring), body(pin, &rim, of_pin));
    let (problem, record) = solve([&first, &second], made.points, 0.2, &[1.0]);
    let exact = exact_pressure();
    let off = |[pressure, _]: [f64; 2]| (pressure / exact - 1.0).abs();
    tractions(&problem, &record)
        .into_iter()
        .map(off)
        .fold(0.0, f64::max)
}

/// In the largest norm, with 3 cells of the hole against 2 of the pin and the other way round, as with equal ones. Linear
/// triangles reach the first order only, matching or not.
#[test]
fn the_pressure_of_a_press_fit_converges() {
    let orders = [
        (ElementKind::T3, 0.75),
        (ElementKind::Q4, 1.4),
        (ElementKind::T6, 1.7),
        (ElementKind::Q8, 1.7),
    ];
    for (kind, order) in orders {
        for multipliers in BOTH {
            for [hole, rim] in [[2, 2], [3, 2], [2, 3]] {
                let what = format!("{kind:?}, {multipliers:?}, {hole} : {rim}");
                let [coarse, fine] =
                    [4, 16].map(|k| deviation([hole * k, rim * k], kind, multipliers));
                let found = (coarse / fine).log2() / 2.0;
                assert!(
                    found > order,
                    "{what}: {coarse:.1e} {fine:.1e}, order {found}"
                );
            }
        }
    }
}
