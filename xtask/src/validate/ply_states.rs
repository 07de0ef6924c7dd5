//! Stresses that a laminate has without load, its coupling, and plies that yield, against closed forms.
//!
//! ```text
//! [0/90]s cooled by ΔT     ε = ΔT [Q₁₁ α₁ + Q₁₂ (α₁ + α₂) + Q₂₂ α₂] / (Q₁₁ + 2 Q₁₂ + Q₂₂)   in all directions
//!                          σ₂ = Q₁₂ (ε − α₁ ΔT) + Q₂₂ (ε − α₂ ΔT) = −σ₁
//! [0/90], thickness t      B₁₁ = (Q₂₂ − Q₁₁) t²/8 = −B₂₂,   B₁₂ = B₆₆ = 0
//! Tsai–Hill yield          on the axes the strengths themselves; elsewhere the stress at which the surface is met
//! ```

use stickslip_fem_core::material::apply;
use stickslip_laminate::progressive::{ClosestPoint, YieldSurface};
use stickslip_laminate::{Laminate, Ply, PlyConstants, Strengths};

use super::check::{Check, Checks};
use super::laboratory::Laboratory;
use crate::publish::TaskError;

/// Strengths of Post & Reddy (1988) `[ksi]`.
const STRENGTHS: [f64; 5] = [229.4, 252.1, 10.1, 32.0, 17.3];

/// Carbon-epoxy, with the moduli of the same report `[ksi]`.
const CARBON: PlyConstants = PlyConstants {
    e1: 19_100.0,
    e2: 2_000.0,
    g12: 900.0,
    nu12: 0.3,
    alpha1: 0.02e-6,
    alpha2: 22.5e-6,
    thickness: 0.005,
};

pub(super) fn checks(_: &Laboratory) -> Result<Vec<Check>, TaskError> {
    let [xt, xc, yt, yc, s12] = STRENGTHS;
    let strengths = Strengths::in_plane(xt, xc, yt, yc, s12);
    let ply = Ply::new("carbon", CARBON, strengths)?;
    let mut checks = Checks::against("lamination theory in closed form");
    residual_stress(&mut checks, &ply)?;
    coupling(&mut checks, &ply)?;
    checks.now_against("Hill (1950) with Tsai–Hill strengths; Simo & Hughes (1998)");
    yielding(&mut checks, &ply)?;
    Ok(checks.into_list())
}

fn laminate(layup: &str, ply: &Ply) -> Result<Laminate, TaskError> {
    Ok(Laminate::new(&layup.parse()?, ply)?)
}

/// Q₁₁, Q₁₂ and Q₂₂.
fn reduced_stiffness() -> [f64; 3] {
    let inverse = 1.0 / (1.0 - CARBON.nu12 * CARBON.nu12 * CARBON.e2 / CARBON.e1);
    [
        CARBON.e1 * inverse,
        CARBON.nu12 * CARBON.e2 * inverse,
        CARBON.e2 * inverse,
    ]
}

fn residual_stress(checks: &mut Checks, ply: &Ply) -> Result<(), TaskError> {
    let cooling = -150.0;
    let [q11, q12, q22] = reduced_stiffness();
    let [a1, a2] = [CARBON.alpha1, CARBON.alpha2];
    let strain = cooling * (q11 * a1 + q12 * (a1 + a2) + q22 * a2) / (q11 + 2.0 * q12 + q22);
    let across = q12 * (strain - a1 * cooling) + q22 * (strain - a2 * cooling);
    let states = laminate("[0/90]s", ply)?.residual_states(cooling);
    let error = states.iter().map(|state| {
        let [s1, s2, shear] = state.stress;
        let parts = [s1 + across, s2 - across, shear];
        parts.into_iter().map(f64::abs).fold(0.0, f64::max) / across
    });
    checks.rounding_below(
        format!("[0/90]s after −150 K: σ₂ = −σ₁ = {across:.6} ksi"),
        (
            format!("worst of {} places", states.len()),
            error.fold(0.0, f64::max),
        ),
        1e-10,
    );
    Ok(())
}

fn coupling(checks: &mut Checks, ply: &Ply) -> Result<(), TaskError> {
    let [q11, _, q22] = reduced_stiffness();
    let pair = laminate("[0/90]", ply)?;
    let size = (q11 - q22) * pair.thickness() * pair.thickness() / 8.0;
    let coupling = pair.stiffness().coupling;
    let wanted = [[-size, 0.0, 0.0], [0.0, size, 0.0], [0.0; 3]];
    let error = (0..9).map(|k| (coupling[k / 3][k % 3] - wanted[k / 3][k % 3]).abs() / size);
    checks.rounding_below(
        format!("[0/90]: B₁₁ = −B₂₂ = {:.6} ksi in², all else 0", -size),
        ("worst of 9 entries", error.fold(0.0, f64::max)),
        1e-10,
    );
    let symmetric = laminate("[0/90]s", ply)?.stiffness().coupling;
    let largest = symmetric
        .iter()
        .flatten()
        .fold(0.0, |a: f64, b| a.max(b.abs()));
    checks.rounding_below("[0/90]s: B = 0", ("largest entry", largest / size), 1e-12);
    Ok(())
}

/// The stress that the elastic strain of `stress` is returned to.
fn returned(
    surface: &YieldSurface,
    ply: &Ply,
    stress: [f64; 3],
) -> Result<ClosestPoint, TaskError> {
    let strain = apply(ply.compliance(), stress);
    surface.closest_point(strain, 0.0).map_err(|(residual, iterations)| {
        format!("the return mapping stops at a residual of {residual:.1e} after {iterations} iterations").into()
    })
}

fn yielding(checks: &mut Checks, ply: &Ply) -> Result<(), TaskError> {
    let surface = YieldSurface::new(ply, 0.0)?;
    let [xt, xc, yt, yc, s12] = STRENGTHS;
    let uniaxial = [
        [xt, 0.0, 0.0],
        [-xc, 0.0, 0.0],
        [0.0, yt, 0.0],
        [0.0, -yc, 0.0],
        [0.0, 0.0, s12],
    ];
    let met = uniaxial.map(|stress| (surface.value(stress) - 1.0).abs());
    checks.rounding_below(
        "strengths along the axes lie on the surface",
        ("worst of 5", met.into_iter().fold(0.0, f64::max)),
        1e-10,
    );
    let biaxial = [
        [xt, yt, 0.0],
        [-xc, yt, s12],
        [xt, -yc, -s12],
        [-xc, -yc, 3.0],
    ];
    let (mut worst, mut least_work) = (0.0_f64, f64::INFINITY);
    for direction in uniaxial.into_iter().chain(biaxial) {
        let yields = direction.map(|stress| stress / surface.value(direction));
        let end = returned(&surface, ply, yields.map(|stress| (1.0 + 1e-8) * stress))?;
        let size = yields.iter().fold(0.0, |a: f64, b| a.max(b.abs()));
        let apart = (0..3).map(|i| (end.stress[i] - yields[i]).abs() / size);
        worst = apart.fold(worst, f64::max);
        let far = returned(&surface, ply, yields.map(|stress| 3.0 * stress))?;
        let work: f64 = (0..3)
            .map(|i| far.stress[i] * far.plastic_increment[i])
            .sum();
        least_work = least_work.min(work);
    }
    checks.rounding_below(
        "uniaxial and biaxial yield stress",
        ("worst of 9", worst),
        1e-8,
    );
    checks.holds(
        "plastic work",
        "≥ 0",
        format!("{least_work:.3e} ksi at least"),
        least_work >= 0.0,
    );
    convergence(
        checks,
        &returned(&surface, ply, [300.0, 40.0, 30.0])?.residuals,
    );
    Ok(())
}

fn convergence(checks: &mut Checks, residuals: &[f64]) {
    let quadratic = (residuals.windows(2).filter(|pair| pair[0] < 0.3))
        .all(|pair| pair[1] < pair[0] * pair[0] + 1e-14);
    let shown: Vec<String> = (residuals.iter())
        .map(|residual| format!("{residual:.0e}"))
        .collect();
    checks.holds(
        "residuals of the return mapping",
        "each below the square of the one before",
        shown.join(", "),
        quadratic && residuals.len() >= 3,
    );
}
