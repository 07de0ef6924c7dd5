//! Elastic pin in an elastic plate, the job on which other programs were measured: five spacings, Q4 and Q8.

use stickslip::results::Results;
use stickslip_fem_core::mesh::ElementKind;

use super::check::Tolerance::{Absolute, Relative};
use super::check::{Check, Checks};
use super::laboratory::{Laboratory, PSI};
use super::rigid_pin::stresses;
use crate::publish::TaskError;

const LOAD_STEPS: usize = 14;
/// Load steps that are compared: 1240 lb while loading, 1210 lb while unloading.
const LOADED: usize = 3;
const UNLOADED: usize = 9;

/// What is known of one coefficient of friction, at 1240 lb while loading.
struct Case {
    friction: f64,
    /// `[psi]`
    peak_pressure: f64,
    /// σ_θ at 90° `[psi]`
    hoop: f64,
    /// Largest σ_θ, as far as it is known.
    peak_hoop: &'static str,
    /// Friction over μ times the normal force, at 1240 lb loading and 1210 lb unloading.
    ratios: Option<[f64; 2]>,
}

const FRICTIONLESS: Case = Case {
    friction: 0.0,
    peak_pressure: 31501.0,
    hoop: 39590.0,
    peak_hoop: "43500 ± 800 psi at 81°",
    ratios: None,
};

const FRICTIONAL: Case = Case {
    friction: 0.25,
    peak_pressure: 25229.0,
    hoop: 42255.0,
    peak_hoop: "50000 ± 1500 psi at 82°",
    ratios: Some([0.760, 0.479]),
};

pub(super) fn frictionless(laboratory: &Laboratory) -> Result<Vec<Check>, TaskError> {
    all(laboratory, &FRICTIONLESS)
}

pub(super) fn frictional(laboratory: &Laboratory) -> Result<Vec<Check>, TaskError> {
    all(laboratory, &FRICTIONAL)
}

fn all(laboratory: &Laboratory, case: &Case) -> Result<Vec<Check>, TaskError> {
    let mut checks = Checks::against("condensed node-to-node code, Q4 and Q8, small sliding");
    let spacings = laboratory.sized(&[9.0, 4.5, 2.25][..], &[9.0, 4.5, 2.25, 1.125, 0.5625][..]);
    for kind in [ElementKind::Q4, ElementKind::Q8] {
        let mut peaks = Vec::with_capacity(spacings.len());
        for &spacing in spacings {
            let overrides = [
                format!("mesh.element={kind:?}"),
                format!("mesh.spacing=\"{spacing} deg\""),
                format!("contacts.0.friction.coulomb.mu={}", case.friction),
            ];
            let results = laboratory.run("pin-benchmark", &overrides)?;
            let what = format!("{kind:?} {spacing}°");
            checks.converges(&what, &results, LOAD_STEPS);
            one(&mut checks, &what, case, spacing, &results)?;
            peaks.push(PeakHoop::of(&results)?);
        }
        show_peaks(&mut checks, kind, case.peak_hoop, &peaks, spacings);
    }
    Ok(checks.into_list())
}

fn one(
    checks: &mut Checks,
    what: &str,
    case: &Case,
    spacing: f64,
    results: &Results,
) -> Result<(), TaskError> {
    let edge = &results.steps[LOADED].edges[0];
    let (pressure, _) = edge.peak_pressure.ok_or("the pin does not touch")?;
    let (limit, is_fine) = if spacing <= 1.125 {
        (2e-4, true)
    } else {
        (1e-3, false)
    };
    let pressure = [pressure / PSI, case.peak_pressure];
    let quantity = format!("{what}: peak pressure, 1240 lb");
    checks.near_if(spacing <= 2.25, quantity, pressure, Relative(limit, " psi"));
    let hoop = [stresses(results, LOADED, 90.0)?[1] / PSI, case.hoop];
    let quantity = format!("{what}: σ_θ at 90°, 1240 lb");
    checks.near_if(is_fine, quantity, hoop, Relative(3e-3, " psi"));
    let steps = [(LOADED, "1240 lb loading"), (UNLOADED, "1210 lb unloading")];
    for ((step, name), reference) in steps.into_iter().zip(case.ratios.into_iter().flatten()) {
        let edge = &results.steps[step].edges[0];
        let ratio = edge.friction_force / (case.friction * edge.normal_force);
        let quantity = format!("{what}: T/(μN), {name}");
        checks.near_if(
            spacing <= 2.25,
            quantity,
            [ratio, reference],
            Absolute(2e-3, ""),
        );
    }
    Ok(())
}

/// Largest σ_θ at 1240 lb, its angle, and the uncertainty that the run itself states.
struct PeakHoop {
    /// `[psi]`
    value: f64,
    /// `[deg]`
    angle: f64,
    /// `[psi]`; none where the peak is not at the end of contact.
    uncertainty: Option<f64>,
}

impl PeakHoop {
    fn of(results: &Results) -> Result<Self, TaskError> {
        let edge = &results.steps[LOADED].edges[0];
        let (value, angle) = edge.peak_hoop.ok_or("no stress")?;
        Ok(Self {
            value: value / PSI,
            angle: angle.to_degrees(),
            uncertainty: edge.peak_hoop_uncertainty.map(|u| u / PSI),
        })
    }
}

/// The peak at the contact's end is a cusp, and no mesh knows it better than to the order √h. The end lies differently in
/// each mesh, so one extrapolation says little, and the spread of two is what it is worth.
fn show_peaks(
    checks: &mut Checks,
    kind: ElementKind,
    reference: &str,
    peaks: &[PeakHoop],
    spacings: &[f64],
) {
    let ([.., coarse, before, last], [.., finest]) = (peaks, spacings) else {
        return;
    };
    let root = 2.0_f64.sqrt();
    let limit = |a: &PeakHoop, b: &PeakHoop| (root * b.value - a.value) / (root - 1.0);
    checks.show(
        format!("{kind:?} {finest}°: peak σ_θ, 1240 lb, a cusp with an error of order √h"),
        reference,
        format!(
            "{:.0}{} psi at {:.1}°; √h-extrapolated {:.0}, from coarser meshes {:.0}",
            last.value,
            last.uncertainty
                .map_or_else(String::new, |u| format!(" ± {u:.0}")),
            last.angle,
            limit(before, last),
            limit(coarse, before)
        ),
    );
}
