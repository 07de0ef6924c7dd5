//! Classical lamination theory and failure criteria against an independent table, and the moduli of the report's laminate.

use std::collections::BTreeMap;

use serde::Deserialize;
use stickslip_laminate::failure::{assess_plies, criterion_named, first_ply_failure};
use stickslip_laminate::laminate::EffectiveModuli;
use stickslip_laminate::{
    Curvature, Deformation, Laminate, LaminateLoad, Ply, PlyConstants, Strengths,
};

use super::check::Tolerance::Absolute;
use super::check::{Check, Checks};
use super::laboratory::{Laboratory, Worst};
use crate::publish::TaskError;

/// The table that the tests of the laminates' crate use too.
const TABLE: &str = include_str!("../../../crates/laminate/tests/reference/clt.json");
/// Relative error of closed forms on both sides.
const CLOSED: f64 = 1e-10;
/// The report prints three digits.
const DIGITS: f64 = 5e-3;

#[derive(Deserialize)]
struct Table {
    strengths_ksi: BTreeMap<String, f64>,
    laminates: Vec<Entry>,
}

#[derive(Deserialize)]
struct Entry {
    laminate: String,
    ply_ksi: Constants,
    ply_thickness_in: f64,
    #[serde(rename = "A_kip_per_in")]
    membrane: [[f64; 3]; 3],
    #[serde(rename = "D_kip_in")]
    bending: [[f64; 3]; 3],
    effective_ksi: BTreeMap<String, f64>,
    load_cases: Vec<LoadCase>,
}

#[derive(Clone, Copy, Deserialize)]
struct Constants {
    #[serde(rename = "E1")]
    e1: f64,
    #[serde(rename = "E2")]
    e2: f64,
    #[serde(rename = "G12")]
    g12: f64,
    nu12: f64,
}

#[derive(Deserialize)]
struct LoadCase {
    load: String,
    ply_stress_ksi_sigma1_sigma2_tau12: BTreeMap<String, [f64; 3]>,
    first_ply_failure: BTreeMap<String, Failure>,
}

#[derive(Deserialize)]
struct Failure {
    #[serde(rename = "factor_on_N_over_h_ksi")]
    factor: f64,
    ply_deg: f64,
}

pub(super) fn checks(_: &Laboratory) -> Result<Vec<Check>, TaskError> {
    let mut checks = Checks::against("classical lamination theory, programmed anew");
    let table: Table = serde_json::from_str(TABLE)?;
    for entry in &table.laminates {
        let laminate = laminate(entry, &table.strengths_ksi)?;
        let name = laminate_name(&entry.laminate)?;
        stiffness(&mut checks, name, entry, &laminate)?;
        loads(&mut checks, name, entry, &laminate)?;
    }
    report(&mut checks)?;
    Ok(checks.into_list())
}

/// The table's names as lay-ups.
fn laminate_name(name: &str) -> Result<&'static str, TaskError> {
    match name {
        "QI_0_2/60_2/-60_2_s" => Ok("[0_2/60_2/-60_2]s"),
        "0/45/-45/90_s" => Ok("[0/±45/90]s"),
        other => Err(format!("the table's laminate '{other}' is unknown").into()),
    }
}

fn laminate(entry: &Entry, strengths: &BTreeMap<String, f64>) -> Result<Laminate, TaskError> {
    let strength = |name: &str| {
        let value = strengths.get(name).copied();
        value.ok_or_else(|| format!("the table has no strength {name}"))
    };
    let strengths = Strengths::in_plane(
        strength("XT")?,
        strength("XC")?,
        strength("YT")?,
        strength("YC")?,
        strength("S")?,
    );
    of_constants(
        laminate_name(&entry.laminate)?,
        entry.ply_ksi,
        entry.ply_thickness_in,
        strengths,
    )
}

fn of_constants(
    layup: &str,
    Constants { e1, e2, g12, nu12 }: Constants,
    thickness: f64,
    strengths: Strengths,
) -> Result<Laminate, TaskError> {
    let constants = PlyConstants {
        e1,
        e2,
        g12,
        nu12,
        alpha1: 0.0,
        alpha2: 0.0,
        thickness,
    };
    let ply = Ply::new("reference", constants, strengths)?;
    Ok(Laminate::new(&layup.parse()?, &ply)?)
}

/// Largest difference over the largest entry of the reference.
fn apart<const N: usize>(found: &[f64; N], reference: &[f64; N]) -> f64 {
    let size = reference.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
    let pairs = found.iter().zip(reference);
    pairs.fold(0.0_f64, |m, (a, b)| m.max((a - b).abs())) / size
}

fn flat(matrix: &[[f64; 3]; 3]) -> [f64; 9] {
    std::array::from_fn(|k| matrix[k / 3][k % 3])
}

fn stiffness(
    checks: &mut Checks,
    name: &str,
    entry: &Entry,
    laminate: &Laminate,
) -> Result<(), TaskError> {
    let found = laminate.stiffness();
    for (what, found, reference) in [
        ("A", &found.membrane, &entry.membrane),
        ("D", &found.bending, &entry.bending),
    ] {
        let error = apart(&flat(found), &flat(reference));
        checks.rounding_below(format!("{name}: {what}"), ("9 entries", error), CLOSED);
    }
    let EffectiveModuli {
        ex,
        ey,
        gxy,
        nuxy,
        nuyx,
        ..
    } = laminate.membrane_moduli(Curvature::Suppressed);
    let mut worst = Worst::default();
    for (key, found) in [
        ("Ex", ex),
        ("Ey", ey),
        ("Gxy", gxy),
        ("nuxy", nuxy),
        ("nuyx", nuyx),
    ] {
        let reference = entry.effective_ksi.get(key);
        let reference = reference.ok_or_else(|| format!("the table has no {key}"))?;
        worst.meet((found / reference - 1.0).abs(), || format!("worst: {key}"));
    }
    checks.rounding_below(format!("{name}: effective moduli"), worst, CLOSED);
    Ok(())
}

/// Ply stresses and first-ply failure by each criterion, under each load.
fn loads(
    checks: &mut Checks,
    name: &str,
    entry: &Entry,
    laminate: &Laminate,
) -> Result<(), TaskError> {
    for case in &entry.load_cases {
        let h = laminate.thickness();
        let (short, force) = match case.load.split('=').next() {
            Some("Nx") => ("N_x", [h, 0.0, 0.0]),
            Some("Nxy") => ("N_xy", [0.0, 0.0, h]),
            _ => {
                return Err(format!("the table's load '{}' is unknown", case.load).into());
            }
        };
        let load = LaminateLoad::membrane(force);
        let strain = laminate.deformation(&load).strain;
        let mut worst = Worst::default();
        for state in laminate.ply_states(&Deformation::membrane(strain), 0.0) {
            let key = state.angle.to_string();
            let reference = case.ply_stress_ksi_sigma1_sigma2_tau12.get(&key);
            let reference = reference.ok_or_else(|| format!("no ply at {key}°"))?;
            worst.meet(apart(&state.stress, reference), || {
                format!("worst: {key}° ply")
            });
        }
        checks.rounding_below(format!("{name}, {short}: ply stresses"), worst, CLOSED);
        for (criterion, key) in [
            ("max_stress", "maxstress"),
            ("tsai_hill", "tsaihill"),
            ("hoffman", "hoffman"),
            ("tsai_wu", "tsaiwu"),
        ] {
            let reference = case.first_ply_failure.get(key);
            let reference = reference.ok_or_else(|| format!("no {key}"))?;
            let chosen = criterion_named(criterion)?;
            let first = first_ply_failure(laminate, &load, chosen.as_ref())?;
            let factor = first.assessment.reserve_factor;
            // The table names one of several plies that tie.
            let plies = assess_plies(laminate, &load, chosen.as_ref())?;
            let named = plies.iter().find(|ply| ply.angle == reference.ply_deg);
            let named = named.ok_or_else(|| format!("no ply at {}°", reference.ply_deg))?;
            let expected = reference.factor;
            let error = (factor / expected - 1.0).abs();
            let tied = (named.assessment.reserve_factor / expected - 1.0).abs();
            checks.rounding_below(
                format!("{name}, {short}: first ply by {criterion}"),
                (
                    format!("{factor:.4} ksi in the {}° ply", first.angle),
                    error.max(tied),
                ),
                CLOSED,
            );
        }
    }
    Ok(())
}

/// Moduli of the quasi-isotropic plate in millions of psi.
fn report(checks: &mut Checks) -> Result<(), TaskError> {
    const LAYUP: &str = "[0_2/60_2/-60_2]s";
    let moduli = |constants: Constants| {
        let laminate = of_constants(LAYUP, constants, 0.005, Strengths::default())?;
        Ok::<_, TaskError>(laminate.membrane_moduli(Curvature::Suppressed))
    };
    checks.now_against("Post & Reddy 1988, 3 digits");
    let own = moduli(Constants {
        e1: 19.585,
        e2: 1.5,
        g12: 0.847,
        nu12: 0.28,
    })?;
    let what = "(0₂/60₂/−60₂)s of the back-calculated ply";
    for (name, found, reference, unit) in [
        ("E", own.ex, 7.72, "e6 psi"),
        ("G", own.gxy, 2.97, "e6 psi"),
        ("ν", own.nuxy, 0.30, ""),
    ] {
        checks.near(
            format!("{what}: {name}"),
            [found, reference],
            Absolute(DIGITS, unit),
        );
    }
    checks.now_against("Tsai & Hahn 1980, ply constants in GPa");
    let psi = 6.894_757_293_168;
    let textbook = moduli(Constants {
        e1: 181.0 / psi,
        e2: 10.3 / psi,
        g12: 7.17 / psi,
        nu12: 0.28,
    })?;
    checks.near(
        "the same lay-up of a textbook T300/5208 ply, a third stiffer than the report's plate: E",
        [textbook.ex, 69.68 / psi],
        Absolute(DIGITS, "e6 psi"),
    );
    Ok(())
}
