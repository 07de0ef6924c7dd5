//! Everything in `reference/clt.json`, to 1e-10 of the size of each quantity: closed forms on both sides.

use approx::assert_relative_eq;
use serde_json::Value;
use stickslip_laminate::failure::{assess_plies, criterion_named, first_ply_failure};
use stickslip_laminate::laminate::Layer;
use stickslip_laminate::{
    Curvature, Deformation, Laminate, LaminateLoad, Ply, PlyConstants, Strengths,
};

use crate::{STRENGTHS, assert_matrix, assert_vector};

const DIGITS: f64 = 1e-10;

fn table() -> Value {
    serde_json::from_str(include_str!("../reference/clt.json")).unwrap()
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap()
}

fn vector(value: &Value) -> Vec<f64> {
    value.as_array().unwrap().iter().map(number).collect()
}

fn matrix(value: &Value) -> [[f64; 3]; 3] {
    let rows = value.as_array().unwrap();
    std::array::from_fn(|i| vector(&rows[i]).try_into().unwrap())
}

fn laminates() -> Vec<(Value, Laminate)> {
    let [xt, xc, yt, yc, s12] = STRENGTHS;
    let entries = table()["laminates"].as_array().unwrap().clone();
    let build = |entry: Value| {
        let ply = &entry["ply_ksi"];
        let constants = PlyConstants {
            e1: number(&ply["E1"]),
            e2: number(&ply["E2"]),
            g12: number(&ply["G12"]),
            nu12: number(&ply["nu12"]),
            alpha1: 0.0,
            alpha2: 0.0,
            thickness: number(&entry["ply_thickness_in"]),
        };
        let ply = Ply::new(
            "reference",
            constants,
            Strengths::in_plane(xt, xc, yt, yc, s12),
        )
        .unwrap();
        let layup = match entry["laminate"].as_str().unwrap() {
            "QI_0_2/60_2/-60_2_s" => "[0_2/60_2/-60_2]s",
            "0/45/-45/90_s" => "[0/±45/90]s",
            other => panic!("{other}"),
        };
        let laminate = Laminate::new(&layup.parse().unwrap(), &ply).unwrap();
        (entry, laminate)
    };
    entries.into_iter().map(build).collect()
}

fn unit_load(name: &str, thickness: f64) -> LaminateLoad {
    match name {
        "Nx=+1 (N/h, ksi)" => LaminateLoad::membrane([thickness, 0.0, 0.0]),
        "Nxy=+1 (N/h, ksi)" => LaminateLoad::membrane([0.0, 0.0, thickness]),
        other => panic!("{other}"),
    }
}

fn load_cases(entry: &Value, laminate: &Laminate) -> Vec<(Value, LaminateLoad)> {
    let cases = entry["load_cases"].as_array().unwrap().clone();
    let load = |case: &Value| unit_load(case["load"].as_str().unwrap(), laminate.thickness());
    cases
        .into_iter()
        .map(|case| (case.clone(), load(&case)))
        .collect()
}

#[test]
fn strengths_are_those_of_the_table() {
    let names = ["XT", "XC", "YT", "YC", "S"];
    let table = table();
    assert_eq!(
        names.map(|name| number(&table["strengths_ksi"][name])),
        STRENGTHS
    );
}

#[test]
fn stacks_and_stiffness() {
    for (entry, laminate) in laminates() {
        let angles: Vec<f64> = laminate.layers().iter().map(Layer::angle).collect();
        assert_eq!(angles, vector(&entry["stack_bottom_to_top_deg"]));
        assert_relative_eq!(
            laminate.thickness(),
            number(&entry["h_in"]),
            max_relative = DIGITS
        );
        let stiffness = laminate.stiffness();
        assert_matrix(&stiffness.membrane, &matrix(&entry["A_kip_per_in"]), DIGITS);
        assert_matrix(&stiffness.bending, &matrix(&entry["D_kip_in"]), DIGITS);
        let size = laminate.thickness() * stiffness.membrane[0][0];
        for value in stiffness.coupling.iter().flatten() {
            assert!(value.abs() < 1e-15 * size, "{value:e}");
        }
    }
}

#[test]
fn effective_moduli() {
    for (entry, laminate) in laminates() {
        let table = &entry["effective_ksi"];
        for curvature in [Curvature::Suppressed, Curvature::Free] {
            let moduli = laminate.membrane_moduli(curvature);
            let pairs = [
                (moduli.ex, "Ex"),
                (moduli.ey, "Ey"),
                (moduli.gxy, "Gxy"),
                (moduli.nuxy, "nuxy"),
                (moduli.nuyx, "nuyx"),
            ];
            for (value, name) in pairs {
                assert_relative_eq!(value, number(&table[name]), max_relative = DIGITS);
            }
        }
    }
}

#[test]
fn ply_stresses() {
    for (entry, laminate) in laminates() {
        for (case, load) in load_cases(&entry, &laminate) {
            let deformation = laminate.deformation(&load);
            for state in laminate.ply_states(&Deformation::membrane(deformation.strain), 0.0) {
                let name = format!("{}", state.angle);
                let table = vector(&case["ply_stress_ksi_sigma1_sigma2_tau12"][&name]);
                assert_vector(&state.stress, &table, DIGITS);
            }
        }
    }
}

#[test]
fn first_ply_failure_by_every_criterion() {
    let names = [
        ("max_stress", "maxstress"),
        ("tsai_hill", "tsaihill"),
        ("hoffman", "hoffman"),
        ("tsai_wu", "tsaiwu"),
    ];
    for (entry, laminate) in laminates() {
        for (case, load) in load_cases(&entry, &laminate) {
            for (name, key) in names {
                let criterion = criterion_named(name).unwrap();
                let table = &case["first_ply_failure"][key];
                let factor = number(&table["factor_on_N_over_h_ksi"]);
                let first = first_ply_failure(&laminate, &load, criterion.as_ref()).unwrap();
                assert_relative_eq!(
                    first.assessment.reserve_factor,
                    factor,
                    max_relative = DIGITS
                );
                // The table names one of several plies that tie.
                let plies = assess_plies(&laminate, &load, criterion.as_ref()).unwrap();
                let named = plies
                    .iter()
                    .find(|ply| ply.angle == number(&table["ply_deg"]))
                    .unwrap();
                assert_relative_eq!(
                    named.assessment.reserve_factor,
                    factor,
                    max_relative = DIGITS
                );
            }
        }
    }
}
