//! Convergence to smooth exact solutions: rates and sizes of the errors.
//!
//! ```text
//! ‖u − u_h‖ = O(h^{p+1}),   ‖u − u_h‖_E = O(h^p),   ‖u − u_h‖_E ≤ ‖u − I u‖_E
//! ```
//!
//! The last line is Galerkin's optimality: no displacement with the same nodal boundary values, hence not the
//! interpolant I u, is closer in energy. It bounds the finest error without an observed number; 1 % is left for the
//! quadrature on curved cells. In L² the solution is optimal up to a constant only, which smooth problems on regular cells
//! keep below 3 interpolation errors.
//!
//! The cells are images of equal cells under one smooth map, so they are distorted and curved inside the body but tend to
//! parallelograms under refinement. That is what Q8 needs for its full order: on cells whose shape does not improve it is
//! one order worse (Arnold, Boffi & Falk 2002). The boundary prescribes normal displacements on two sides and tractions
//! everywhere else. Held and loaded sides then meet as on lines of symmetry, and the dual solution behind the order of L²
//! is not singular there, as it would be beside a clamped side.

use std::f64::consts::{FRAC_PI_2, PI};
use std::sync::Arc;

use stickslip_fem_core::HeldDirection;
use stickslip_fem_core::material::{Isotropic, Material, Orthotropic, OutOfPlane, PlaneState};
use stickslip_fem_core::mesh::{ElementKind, Mesh, Point};

use crate::fields::{Field, PLY, driven, kolosov, lekhnitskii, ply};
use crate::meshes::{SIDES, mapped, rectangle};
use crate::norms::{Errors, errors};

/// How far the rectangle is turned.
const TURN: f64 = 0.3;

/// A turned rectangle 1.2 × 1 whose cells are swayed inside.
pub(crate) fn swayed(kind: ElementKind, cells: usize) -> Mesh {
    let map = |[x, y]: Point| {
        let sway = 0.04 * (PI * x).sin() * (2.0 * PI * y).sin();
        let [x, y] = [
            1.2 * (x + sway),
            y - 0.5 * sway + 0.05 * (PI * x).sin() * (PI * y).sin(),
        ];
        let (s, c) = TURN.sin_cos();
        [c * x - s * y, s * x + c * y]
    };
    mapped(rectangle(kind, [0.0, 1.0], [0.0, 1.0], [cells, cells]), map)
}

/// Errors of the finite-element solution and of the interpolant.
pub(crate) fn solve(mesh: Mesh, material: &Arc<dyn Material>, field: &Field) -> [Errors; 2] {
    let along = |side: &str, direction| {
        let nodes = mesh.node_set(side).unwrap().iter();
        nodes
            .map(move |&node| (node, direction))
            .collect::<Vec<_>>()
    };
    let mut held = along("left", HeldDirection::Angle(TURN));
    held.extend(along("bottom", HeldDirection::Angle(TURN + FRAC_PI_2)));
    let body = driven(mesh, Arc::clone(material), field, &held, &SIDES);
    let u = body.condense(&[]).unwrap().displacements(&[], &[1.0], &[]);
    let interpolant = field.at_nodes(body.mesh());
    [u, interpolant].map(|u| errors(body.mesh(), material.as_ref(), &u, field))
}

fn study(kind: ElementKind, material: &Arc<dyn Material>, field: &Field) {
    let order = kind.order() as f64;
    let runs = [16, 32, 64].map(|cells| solve(swayed(kind, cells), material, field));
    let rate = |norm: fn(&Errors) -> f64| (norm(&runs[1][0]) / norm(&runs[2][0])).log2();
    let (l2, energy) = (rate(|e| e.l2), rate(|e| e.energy));
    assert!((l2 - order - 1.0).abs() < 0.1, "{kind:?}: L² order {l2:.3}");
    assert!(
        (energy - order).abs() < 0.1,
        "{kind:?}: energy order {energy:.3}"
    );

    let [found, interpolant] = runs[2];
    assert!(
        found.energy < 1.01 * interpolant.energy,
        "{kind:?}: {found:?}, {interpolant:?}"
    );
    assert!(
        found.l2 < 3.0 * interpolant.l2,
        "{kind:?}: {found:?}, {interpolant:?}"
    );
}

#[test]
fn isotropic_plane_strain_converges_at_the_full_order() {
    let (young, poisson, state) = (70.0, 0.33, PlaneState::Strain);
    let material: Arc<dyn Material> = Arc::new(Isotropic::new(young, poisson, state).unwrap());
    for kind in ElementKind::COMMON {
        study(kind, &material, &kolosov(young, poisson, state));
    }
}

#[test]
fn a_ply_at_an_angle_in_plane_stress_converges_at_the_full_order() {
    let material = ply(0.5);
    for kind in ElementKind::COMMON {
        study(kind, &material, &lekhnitskii(material.as_ref()));
    }
}

#[test]
fn a_ply_in_plane_strain_converges_at_the_full_order() {
    let across = OutOfPlane {
        e3: 10.3,
        nu13: 0.28,
        nu23: 0.5,
        alpha3: 0.0,
    };
    let material: Arc<dyn Material> =
        Arc::new(Orthotropic::plane_strain(PLY, across, -1.1).unwrap());
    for kind in [ElementKind::T6, ElementKind::Q8] {
        study(kind, &material, &lekhnitskii(material.as_ref()));
    }
}
