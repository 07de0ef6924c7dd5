//! Intervals that hold the error of the model's mesh.

use stickslip::experiment::SpecimenScene;
use stickslip::experiment::laws::{
    Candidate, Comparison, ContactModel, coarser, fit, fit_on_two_meshes,
};
use stickslip_hybrid::calibrate::Settings;
use stickslip_hybrid::identify::Bounds;

use crate::common::{FREQUENCY, candidate, law, measured, scene, window};

const TRUTH: &str = r#"{ "static_dynamic": { "static": 0.35, "dynamic": 0.25 } }"#;
const STEPS: [usize; 3] = [3, 6, 9];

fn meshed(degrees: f64) -> SpecimenScene {
    let spacing = format!("mesh.spacing=\"{degrees} deg\"");
    scene(
        "pin-loaded-aluminium",
        &[&spacing, "mesh.coarse_spacing=\"9 deg\""],
    )
}

fn dynamic() -> Candidate {
    candidate("drop", TRUTH, &[("dynamic", [0.0, 0.35])])
}

/// Fits without and with the error of the mesh.
fn both(truth: f64, model: f64, laws: &[Candidate]) -> [Comparison; 2] {
    let truth = ContactModel::new(&meshed(truth)).unwrap();
    let own = meshed(model);
    let model = ContactModel::new(&own).unwrap();
    let coarse = ContactModel::new(&coarser(&own)).unwrap();
    assert!(coarse.edge().len() < model.edge().len());
    let places = window(20.0, 2.0, 0.2);
    let data = measured(&truth, law(TRUTH), &STEPS, &places, 0.25, 1);
    let settings = Settings::default();
    [
        fit(&model, laws, &data, &settings).unwrap(),
        fit_on_two_meshes(&model, &coarse, laws, &data, &settings).unwrap(),
    ]
}

fn ends(found: &Comparison) -> [f64; 2] {
    match found.best().calibration.estimates[0].bounds {
        Bounds::Between(low, high) => [low, high],
        other => panic!("{other:?}"),
    }
}

#[test]
fn the_interval_of_a_coarser_model_holds_the_truth_and_the_amount_is_reported() {
    let [without, with] = both(2.25, 4.5, &[dynamic()]);
    println!("{:?} {:?}", ends(&without), ends(&with));
    assert!(without.mesh_error.is_none());
    let [low, high] = ends(&with);
    assert!((low..=high).contains(&0.25), "{low} {high}");
    let own = with.mesh_error.as_ref().unwrap();
    assert_eq!((own.law.as_str(), own.states.len()), ("drop", STEPS.len()));
    for state in &own.states {
        println!("{state:?}");
        assert!(state.amount.value.abs() < 1.0);
        assert!((0.0..=1.0).contains(&state.amount.deviation));
        // A difference of meshes, not of whole fringes.
        assert!(state.rms > 0.0 && state.rms * FREQUENCY < 0.1);
    }
    // An error that is known better than a nuisance takes no degree of freedom.
    let [without, with] = [&without, &with].map(|own| &own.best().calibration);
    assert_eq!(without.degrees(), with.degrees());
    assert!(with.chi_squared <= without.chi_squared);
    assert!(with.evaluations > without.evaluations);
}

#[test]
fn bounds_hardly_change_where_the_model_is_the_truth() {
    let [without, with] = both(4.5, 4.5, &[dynamic()]).map(|own| ends(&own));
    println!("{without:?} {with:?}");
    let width = |[low, high]: [f64; 2]| high - low;
    let ratio = width(with) / width(without);
    assert!((0.95..1.5).contains(&ratio), "{ratio}");
}

#[test]
fn rival_laws_are_compared_beside_one_mesh_error() {
    let wrong = candidate(
        "Coulomb",
        r#"{ "coulomb": { "mu": 0.1 } }"#,
        &[("mu", [0.0, 0.15])],
    );
    let [without, with] = both(4.5, 4.5, &[wrong, dynamic()]);
    assert_eq!((without.best, with.best), (1, 1));
    assert_eq!(with.mesh_error.unwrap().law, "drop");
    // What does not hold is ruled out all the same.
    assert!(with.fits[0].distance > 0.5 * without.fits[0].distance);
    assert!(with.fits[0].distance > 100.0);
}
