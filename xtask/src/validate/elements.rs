//! Finite elements against fields that they contain, and against a smooth one that they do not.
//!
//! The fields, the distorted meshes and the norms are those of the tests of the elements' crate.

use std::f64::consts::{FRAC_PI_2, PI};
use std::sync::Arc;

use stickslip_fem_core::HeldDirection;
use stickslip_fem_core::material::{Isotropic, Material, PlaneState};
use stickslip_fem_core::mesh::{ElementKind, Point};

use super::check::Tolerance::Absolute;
use super::check::{Check, Checks};
use super::laboratory::Laboratory;
use crate::publish::TaskError;
use fields::{Field, both, driven, kolosov, lekhnitskii, linear, materials, ply};
use meshes::{Distortion, SIDES, mapped, nearest, rectangle, scattered, side_nodes};
use norms::{Errors, errors};

#[allow(dead_code, reason = "the tests use more of it")]
#[path = "../../../crates/fem-core/tests/body/fields.rs"]
mod fields;
#[allow(dead_code, reason = "the tests use more of it")]
#[path = "../../../crates/fem-core/tests/body/meshes.rs"]
mod meshes;
#[path = "../../../crates/fem-core/tests/body/norms.rs"]
mod norms;

/// Relative error of a field that comes back to rounding.
const PATCH: f64 = 1e-12;

pub(super) fn checks(laboratory: &Laboratory) -> Result<Vec<Check>, TaskError> {
    let mut checks = Checks::against("linear displacement field");
    for kind in ElementKind::COMMON {
        checks.rounding_below(
            format!("{kind:?} patch test, distorted"),
            ("displacements, 4 materials", patch(kind)?),
            PATCH,
        );
    }
    checks.now_against("Kolosov, Lekhnitskii: exponential potentials");
    let cells = laboratory.sized([8, 16, 32], [16, 32, 64]);
    for kind in ElementKind::COMMON {
        convergence(&mut checks, kind, cells)?;
    }
    Ok(checks.into_list())
}

/// Largest relative error over all materials, distortions and ways of driving the patch.
fn patch(kind: ElementKind) -> Result<f64, TaskError> {
    let mut worst = 0.0_f64;
    for (k, material) in materials().iter().enumerate() {
        let field = linear(&material.stiffness());
        for distortion in [Distortion::Straight, Distortion::Curved] {
            let mesh = scattered(kind, distortion, 7 + k as u64);
            let isostatic = vec![
                (nearest(&mesh, [-0.2, 0.0]), HeldDirection::X),
                (nearest(&mesh, [-0.2, 0.0]), HeldDirection::Y),
                (nearest(&mesh, [1.1, -0.2]), HeldDirection::Y),
            ];
            let held = both(&side_nodes(&mesh, &SIDES));
            let exact = field.at_nodes(&mesh);
            for (held, pulled) in [(held, &[][..]), (isostatic, &SIDES[..])] {
                let body = driven(mesh.clone(), Arc::clone(material), &field, &held, pulled);
                let found = displacements(&body)?;
                let scale = exact.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
                let error = found.iter().zip(&exact).map(|(a, b)| (a - b).abs());
                worst = worst.max(error.fold(0.0, f64::max) / scale);
            }
        }
    }
    Ok(worst)
}

fn displacements(body: &Arc<stickslip_fem_core::ElasticBody>) -> Result<Vec<f64>, TaskError> {
    let condensed = body.condense(&[])?;
    Ok(condensed.displacements(&[], &[1.0], &[]))
}

fn convergence(checks: &mut Checks, kind: ElementKind, cells: [usize; 3]) -> Result<(), TaskError> {
    let (young, poisson, strain) = (70.0, 0.33, PlaneState::Strain);
    let isotropic: Arc<dyn Material> = Arc::new(Isotropic::new(young, poisson, strain)?);
    let laminate = ply(0.5);
    let order = kind.order() as f64;
    let problems = [
        ("isotropic", isotropic, kolosov(young, poisson, strain)),
        ("ply", Arc::clone(&laminate), lekhnitskii(laminate.as_ref())),
    ];
    for (name, material, field) in problems {
        let mut runs = Vec::with_capacity(cells.len());
        for n in cells {
            runs.push(solve(kind, n, &material, &field)?);
        }
        let rate = |norm: fn(&Errors) -> f64| (norm(&runs[1]) / norm(&runs[2])).log2();
        let tolerance = Absolute(0.1, "");
        let what = format!("{kind:?} manufactured, {name}");
        checks.near(
            format!("{what}: order in L²"),
            [rate(|e| e.l2), order + 1.0],
            tolerance,
        );
        checks.near(
            format!("{what}: order in energy"),
            [rate(|e| e.energy), order],
            tolerance,
        );
    }
    Ok(())
}

/// Errors on a turned rectangle whose cells are swayed inside and tend to parallelograms; normal displacements are given on
/// two sides, tractions on the rest.
fn solve(
    kind: ElementKind,
    cells: usize,
    material: &Arc<dyn Material>,
    field: &Field,
) -> Result<Errors, TaskError> {
    const TURN: f64 = 0.3;
    let mesh = mapped(
        rectangle(kind, [0.0, 1.0], [0.0, 1.0], [cells, cells]),
        |[x, y]: Point| {
            let sway = 0.04 * (PI * x).sin() * (2.0 * PI * y).sin();
            let lift = 0.05 * (PI * x).sin() * (PI * y).sin();
            let [x, y] = [1.2 * (x + sway), y - 0.5 * sway + lift];
            let (s, c) = TURN.sin_cos();
            [c * x - s * y, s * x + c * y]
        },
    );
    let along = |side: &str, angle: f64| -> Vec<(usize, HeldDirection)> {
        let nodes = side_nodes(&mesh, &[side]);
        nodes
            .into_iter()
            .map(|node| (node, HeldDirection::Angle(angle)))
            .collect()
    };
    let mut held = along("left", TURN);
    held.extend(along("bottom", TURN + FRAC_PI_2));
    let body = driven(mesh, Arc::clone(material), field, &held, &SIDES);
    let found = displacements(&body)?;
    Ok(errors(body.mesh(), material.as_ref(), &found, field))
}
