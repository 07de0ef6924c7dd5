//! The whole plate under its remote load against the truth and the localized analysis.

use std::path::Path;
use std::sync::Arc;

use stickslip::experiment::Experiment;
use stickslip::experiment::analysed::{self, Analysed};
use stickslip::experiment::identified::identify;
use stickslip::experiment::measured::Measured;
use stickslip::experiment::whole::{WholeError, WholePlate, WholeSolution, WholeState};
use stickslip::host::HOST;
use stickslip::scene::Format;
use stickslip_hybrid::region::fit::{Amount, Smoothing};

use crate::common::{aluminium, measured_fields, scene, window};

const SMOOTHING: Smoothing = Smoothing {
    order: 3,
    amount: Amount::CrossValidated { share: 0.4 },
};
#[test]
fn the_whole_plate_balances_its_load_and_finds_the_friction_of_the_truth() {
    let truth = aluminium(1.125);
    let overrides = ["mesh.spacing=\"4.5 deg\"", "mesh.coarse_spacing=\"9 deg\""];
    let plate = WholePlate::new(&scene("pin-loaded-aluminium", &overrides)).unwrap();
    let places = window(20.0, 0.7, 0.1);
    let law = Arc::clone(truth.own_law());
    let data = measured_fields(&truth, law, &[6], &places, 0.25, 1).remove(0);
    let measured = Measured::new(0, data);
    let found: WholeSolution = plate.analyse(&measured, 6, None, SMOOTHING).unwrap();
    // 1980 lbf; the reactions of a solved plate balance the load to rounding.
    let load = 1980.0 * 4.448_221_615_260_5;
    assert!((found.load[0] + load).abs() < 1e-6 * load);
    for axis in 0..2 {
        assert!((found.force[axis] + found.load[axis]).abs() < 1e-9 * load);
    }
    let (residual, count, parameters) = found.fit;
    let reduced = residual / (count as f64 - parameters);
    assert!((reduced - 1.0).abs() < 0.06, "{reduced}");

    let text = r#"
        version = 1
        [specimen]
        material.isotropic = { young = "10400 ksi", poisson = 0.33 }
        thickness = "0.06 in"
        hole = { centre = ["0 mm", "0 mm"], radius = "0.375 in" }
        [[states]]
        name = "up"
        table = { file = "up.csv", scale = "1 mm", y_axis = "up" }
        [region]
        sector = { angles = ["-100 deg", "100 deg"], outer = "17 mm", cells = [44, 6], growth = 1.5 }
    "#;
    let none: [&str; 0] = [];
    let experiment =
        Experiment::from_text(text, Format::Toml, "up.toml", Path::new("."), &none, HOST).unwrap();
    let coefficient = |edge: Analysed| {
        let found = identify(&experiment, &[edge]).unwrap();
        let fit = found.dynamic.unwrap();
        println!(
            "{:.4} {:?}, χ² {:.1} of {}",
            fit.mu, fit.bounds, fit.chi_squared, fit.degrees
        );
        fit.mu
    };
    let state = WholeState {
        state: 0,
        solution: found,
    };
    let whole = coefficient(state.edge());
    // The localized analysis of the same data: a sector every side of which is measured.
    let localized = coefficient(analysed::all(&experiment, &[measured]).unwrap().remove(0));
    assert!((whole - 0.25).abs() < 0.01, "{whole}");
    assert!((localized - 0.25).abs() < 0.015, "{localized}");
    assert!((whole - localized).abs() < 0.015);
}

#[test]
fn a_plate_that_a_support_holds_is_refused() {
    let mut own = scene("pin-loaded-aluminium", &[]);
    own.body = "pin".to_owned();
    own.edge = "rim".to_owned();
    let refused = WholePlate::new(&own).unwrap_err();
    assert!(matches!(&refused, WholeError::Held { body } if body == "pin"));
}
