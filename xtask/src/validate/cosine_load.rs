//! Hole with an assumed cosine pressure, in an isotropic and an orthotropic plate.

use std::f64::consts::PI;

use stickslip::results::Results;
use stickslip_laboratory::references::loaded_hole::{LoadedHole, Plate, isotropic_hoop, pressure};

use super::check::{Check, Checks, Tolerance};
use super::laboratory::{KSI, Laboratory, Trouble, Worst};
use super::rigid_pin::stresses;

/// Allowed error.
const BOUND: f64 = 2e-3;
/// P/(D t) of the scene.
const MEAN: f64 = 10.0 * KSI;
const SCENE: &str = "validation/cosine-load";
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

pub(super) fn checks(laboratory: &Laboratory) -> Result<Vec<Check>, Trouble> {
    let mut checks = Checks::against("series of Fourier, closed form");
    let isotropic = [format!(
        "materials.laminate.isotropic={{ young = \"10000 ksi\", poisson = {POISSON} }}"
    )];
    let results = laboratory.run(SCENE, &isotropic)?;
    let peak = -stresses(&results, 0, 0.0)?[0] / MEAN;
    checks.near(
        "isotropic plate: prescribed peak pressure D t/P = 4/π",
        peak,
        4.0 / PI,
        "",
        Tolerance::Relative(1e-12),
    );
    checks.near(
        "isotropic plate: σ_θ D t/P at 90° = 8/π²",
        stresses(&results, 0, 90.0)?[1] / MEAN,
        8.0 / (PI * PI),
        "",
        Tolerance::Relative(BOUND),
    );
    hoop(&mut checks, "isotropic plate", &results, |theta| {
        isotropic_hoop(POISSON, theta)
    });

    checks.now_against("Lekhnitskii 1968, complex potentials");
    for (name, plate) in [("orthotropic plate", ORTHOTROPIC), ("ply along x", PLY)] {
        let exact = LoadedHole::new(plate)
            .ok_or_else(|| Trouble::Missing(format!("{name}: no potentials")))?;
        let Plate { e1, e2, g12, nu12 } = plate;
        let material = [format!(
            "materials.laminate.orthotropic={{ e1 = \"{e1} ksi\", e2 = \"{e2} ksi\", g12 = \"{g12} ksi\", nu12 = {nu12} }}"
        )];
        let results = laboratory.run(SCENE, &material)?;
        let found = stresses(&results, 0, 90.0)?[1] / MEAN;
        checks.near(
            format!("{name}: σ_θ D t/P at 90°"),
            found,
            exact.polar_stresses(1.0, 0.5 * PI)[1],
            "",
            Tolerance::Relative(BOUND),
        );
        hoop(&mut checks, name, &results, |theta| {
            exact.polar_stresses(1.0, theta)[1]
        });
    }
    Ok(checks.into_list())
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
    checks.error_below(
        format!("{name}: σ_θ, of its peak"),
        worst.place,
        worst.value,
        BOUND,
    );
    checks.rounding_below(
        format!("{name}: prescribed σ_r, of P/(D t)"),
        "all nodes",
        traction,
        1e-12,
    );
}
