//! Hole with an assumed cosine pressure, in an isotropic and an orthotropic plate.
//!
//! At 90° the pressure has a kink and the hoop stress the slope of x ln x, so nodes are graded towards it.

use std::f64::consts::PI;

use stickslip::results::Results;
use stickslip_laboratory::references::loaded_hole::{LoadedHole, Plate, isotropic_hoop, pressure};

use super::check::Tolerance::Relative;
use super::check::{Check, Checks};
use super::laboratory::{KSI, Laboratory, Worst};
use super::rigid_pin::stresses;
use crate::publish::TaskError;

/// Allowed error.
const BOUND: f64 = 2e-3;
/// P/(D t) of the scene.
const MEAN: f64 = 10.0 * KSI;
const SCENE: &str = "validation/cosine-load";
/// Spacing `[deg]` at 90° and far from it, and the growth between the two.
const NEAR: f64 = 0.1;
const FAR: f64 = 1.25;
const GROWTH: f64 = 1.1;
/// Layers of cells between hole and ring; the cells' depth beside their width does not matter here.
const LAYERS: usize = 160;
const POISSON: f64 = 0.3;
const ORTHOTROPIC: Plate = Plate {
    e1: 12_400.0,
    e2: 3_730.0,
    g12: 3_210.0,
    nu12: 0.66,
};
/// A ply along the load: twenty times as stiff along it as across it.
const PLY: Plate = Plate {
    e1: 20_000.0,
    e2: 1_000.0,
    g12: 800.0,
    nu12: 0.3,
};

pub(super) fn checks(laboratory: &Laboratory) -> Result<Vec<Check>, TaskError> {
    let mut checks = Checks::against("Fourier series, closed form");
    let with = |material: String| {
        let changes = [
            format!("bodies.plate.mesh.angles=[{}]", angles()),
            format!("bodies.plate.mesh.layers={LAYERS}"),
            material,
        ];
        laboratory.run(SCENE, &changes)
    };
    let results = with(format!(
        "materials.laminate.isotropic={{ young = \"10000 ksi\", poisson = {POISSON} }}"
    ))?;
    let peak = -stresses(&results, 0, 0.0)?[0] / MEAN;
    checks.near(
        "isotropic plate: prescribed peak pressure D t/P = 4/π",
        [peak, 4.0 / PI],
        Relative(1e-12, ""),
    );
    checks.near(
        "isotropic plate: σ_θ D t/P at 90° = 8/π²",
        [stresses(&results, 0, 90.0)?[1] / MEAN, 8.0 / (PI * PI)],
        Relative(BOUND, ""),
    );
    hoop(&mut checks, "isotropic plate", &results, |theta| {
        isotropic_hoop(POISSON, theta)
    });

    checks.now_against("Lekhnitskii 1968, complex potentials");
    for (name, plate) in [("orthotropic plate", ORTHOTROPIC), ("ply along x", PLY)] {
        let exact = LoadedHole::new(plate).ok_or_else(|| format!("{name}: no potentials"))?;
        let Plate { e1, e2, g12, nu12 } = plate;
        let results = with(format!(
            "materials.laminate.orthotropic={{ e1 = \"{e1} ksi\", e2 = \"{e2} ksi\", g12 = \"{g12} ksi\", nu12 = {nu12} }}"
        ))?;
        let found = stresses(&results, 0, 90.0)?[1] / MEAN;
        checks.near(
            format!("{name}: σ_θ D t/P at 90°"),
            [found, exact.polar_stresses(1.0, 0.5 * PI)[1]],
            Relative(BOUND, ""),
        );
        hoop(&mut checks, name, &results, |theta| {
            exact.polar_stresses(1.0, theta)[1]
        });
    }
    Ok(checks.into_list())
}

/// Angles of the corner nodes, graded towards 90° from both sides.
fn angles() -> String {
    let mut offsets = vec![0.0];
    let (mut at, mut step) = (0.0, NEAR);
    while step < FAR {
        at += step;
        offsets.push(at);
        step *= GROWTH;
    }
    let rest = 90.0 - at;
    let count = (rest / FAR).ceil();
    // A small whole number.
    offsets.extend((1..=count as u32).map(|k| at + rest * f64::from(k) / count));
    let below = offsets.iter().skip(1).rev().map(|offset| 90.0 - offset);
    let all = below.chain(offsets.iter().map(|offset| 90.0 + offset));
    let texts: Vec<String> = all.map(|angle| format!("\"{angle:.6} deg\"")).collect();
    texts.join(", ")
}

/// The hoop stress at all nodes, and the tractions on them.
fn hoop(checks: &mut Checks, name: &str, results: &Results, exact: impl Fn(f64) -> f64) {
    let (geometry, edge) = (&results.edges[0], &results.steps[0].edges[0]);
    let peak = geometry
        .parameter
        .iter()
        .fold(0.0_f64, |most, &theta| most.max(exact(theta).abs()));
    let (mut worst, mut traction) = (Worst::default(), 0.0_f64);
    for (row, &theta) in edge.rows.iter().zip(&geometry.parameter) {
        let error = (row.sigma_tangential / MEAN - exact(theta)).abs() / peak;
        worst.meet(error, || {
            format!(
                "worst of {} nodes at {:.2}°",
                edge.rows.len(),
                theta.to_degrees()
            )
        });
        traction = traction.max((row.sigma_normal / MEAN + pressure(theta)).abs());
    }
    checks.error_below(format!("{name}: σ_θ, of its peak"), worst, BOUND);
    checks.rounding_below(
        format!("{name}: prescribed σ_r, of P/(D t)"),
        ("all nodes", traction),
        1e-12,
    );
}
