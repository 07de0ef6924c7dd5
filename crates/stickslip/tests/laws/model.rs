//! Models that are not the truth: meshes of their own, null fields in common, scales of variance.

use std::path::Path;
use std::sync::Arc;

use stickslip::experiment::Experiment;
use stickslip::experiment::SpecimenScene;
use stickslip::experiment::finding::ModelFinding;
use stickslip::experiment::laws::{
    ContactModel, Known, LawStage, Observation, Scale, ScaleSource, discrepancies, stage,
};
use stickslip::experiment::measured::Measured;
use stickslip::experiment::report::ExperimentReport;
use stickslip::experiment::truth::Truth;
use stickslip::host::HOST;
use stickslip::scene::Format;
use stickslip_hybrid::data::Measurement;

use crate::common::{FREQUENCY, QUARTER, aluminium, measured_fields, scene, window};

const SYNTHETIC: &str = r#"
version = 1
[specimen]
scene = "pin-loaded-aluminium.toml"
body = "plate"
overrides = ["mesh.spacing=4.5 deg", "mesh.coarse_spacing=9 deg"]
model_overrides = ["mesh.spacing=9 deg"]
[grating]
frequency = "2400 1/mm"
[fringes]
window = [["-13 mm", "-13 mm"], ["13 mm", "13 mm"]]
pixel = "0.05 mm"
[[states]]
name = "up"
step = 7
[[laws]]
friction.coulomb = { mu = 0.3 }
free = { mu = [0.0, 1.0] }
"#;

const MEASURED: &str = r#"
version = 1
[specimen]
scene = "pin-loaded-aluminium.toml"
body = "plate"
overrides = ["mesh.spacing=4.5 deg", "mesh.coarse_spacing=9 deg"]
[grating]
frequency = "2400 1/mm"
[[states]]
name = "up"
load = "1980 lbf"
table = { file = "up.csv", scale = "1 mm", y_axis = "up" }
null.table = { file = "null.csv", scale = "1 mm", y_axis = "up" }
[[states]]
name = "down"
load = "1210 lbf"
direction = "unloading"
table = { file = "down.csv", scale = "1 mm", y_axis = "up" }
null.table = { file = "null.csv", scale = "1 mm", y_axis = "up" }
[[laws]]
friction.static_dynamic = { static = 0.35, dynamic = 0.25 }
free = { dynamic = [0.0, 0.35] }
"#;

fn read(text: &str) -> Result<Experiment, String> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes");
    let none: [&str; 0] = [];
    Experiment::from_text(text, Format::Toml, "mine.toml", &folder, &none, HOST)
        .map_err(|error| error.to_string())
}

fn as_measured(fields: Vec<Measurement>) -> Vec<Measured> {
    let numbered = fields.into_iter().enumerate();
    numbered
        .map(|(state, measurement)| Measured::new(state, measurement))
        .collect()
}

fn reported(experiment: &Experiment, stage: &LawStage) -> String {
    let mut report = ExperimentReport::new(experiment);
    stickslip_experiment_pages::laws::report(experiment, stage, &mut report);
    report.text_answers() + &report.summary().to_string()
}

#[test]
fn a_model_has_a_mesh_of_its_own_and_whoever_gives_it_none_is_warned() {
    let truth = aluminium(4.5);
    let law = Arc::clone(truth.own_law());
    let fields = measured_fields(&truth, law, &[6], &window(20.0, 2.0, 0.2), 0.25, 1);
    let fields = as_measured(fields);
    let own = read(SYNTHETIC).unwrap();
    assert!(!own.specimen.shares_its_mesh());
    let found = stage(&own, &fields, Known::default(), &mut |_| ())
        .unwrap()
        .unwrap();
    // The model's nodes are 9° apart along the half circle that is modelled, its mid-side nodes 4.5°.
    assert!(found.edge_nodes < truth.edge().len());
    assert_eq!(found.findings, []);

    let shared = SYNTHETIC.replace("model_overrides = [\"mesh.spacing=9 deg\"]\n", "");
    let shared = read(&shared).unwrap();
    assert!(shared.specimen.shares_its_mesh());
    let found = stage(&shared, &fields, Known::default(), &mut |_| ())
        .unwrap()
        .unwrap();
    assert_eq!(found.findings, [ModelFinding::SharedMesh]);
    assert!(reported(&shared, &found).contains("model_overrides = [\\\"mesh.spacing="));
}

#[test]
fn a_model_with_another_hole_is_refused_at_its_line() {
    let hole = "\"bodies.plate.shape.plate_with_hole.hole_radius=0.38 in\"";
    let other = SYNTHETIC.replace("\"mesh.spacing=9 deg\"", hole);
    let words = read(&other).unwrap_err();
    assert!(
        words.contains("'plate.hole' is not the circle of the"),
        "{words}"
    );
    let none = SYNTHETIC.replace("mesh.spacing=9 deg", "mesh.spacng=9 deg");
    assert!(read(&none).unwrap_err().contains("spacng"));
    let alone = r#"
        version = 1
        [specimen]
        model_overrides = ["mesh.spacing=9 deg"]
        material.isotropic = { young = "70 GPa", poisson = 0.33 }
        thickness = "1.5 mm"
        hole = { centre = ["0 mm", "0 mm"], radius = "9.5 mm" }
        [[states]]
        name = "up"
        table = { file = "up.csv", scale = "1 mm", y_axis = "up" }
    "#;
    let words = read(alone).unwrap_err();
    assert!(
        words.contains("'model_overrides' belongs to a scene"),
        "{words}"
    );
}

#[test]
fn the_discrepancy_is_none_on_the_same_mesh_and_falls_with_the_mesh() {
    let meshed = |degrees: f64| {
        let spacing = format!("mesh.spacing=\"{degrees} deg\"");
        let coarse = "mesh.coarse_spacing=\"9 deg\"";
        scene("pin-loaded-aluminium", &[&spacing, coarse])
    };
    let own = meshed(2.25);
    let truth = Truth::solve(&own, &mut |_| ()).unwrap();
    let places = window(20.0, 2.0, 0.2);
    let found = [2.25, 4.5, 9.0].map(|degrees| {
        let model = ContactModel::new(&meshed(degrees)).unwrap();
        let law = Arc::clone(model.own_law());
        let data = measured_fields(&model, law, &[6], &places, 0.0, 1).remove(0);
        let data = Observation::of_measurement("up", 6, &data);
        let found = discrepancies(&model, &truth, &[data]).unwrap().remove(0);
        found.unwrap()
    });
    for own in &found {
        println!(
            "rms {:.5} fringes, most {:.5}, χ² {:.4} of {} data",
            FREQUENCY * own.rms,
            FREQUENCY * own.largest,
            own.chi_squared,
            2 * places.len()
        );
        let expected = own.rms.powi(2) * 2.0 * places.len() as f64;
        let expected = expected / (QUARTER / FREQUENCY).powi(2);
        assert!((own.chi_squared - expected).abs() <= 1e-6 * expected + 1e-12);
        assert!(own.largest >= own.rms);
    }
    assert!(FREQUENCY * found[0].largest < 1e-6);
    assert!(found[1].rms > found[0].rms && found[2].rms > 2.0 * found[1].rms);
    // Coarse as it is, it shows nothing beside a quarter of a fringe.
    assert!(FREQUENCY * found[1].rms < 0.05);
}

#[test]
fn states_with_one_null_field_are_reported_with_their_effect() {
    let experiment = read(MEASURED).unwrap();
    let truth = aluminium(2.25);
    let law = Arc::clone(truth.own_law());
    let places = window(20.0, 1.0, 0.2);
    let all = measured_fields(&truth, law, &[6, 9, 0], &places, 0.25, 1);
    let less_null = |k: usize| {
        let mut own = all[k].clone();
        for axis in 0..2 {
            let null = &all[2].displacements[axis];
            let values = own.displacements[axis].iter_mut();
            values.zip(null).for_each(|(value, null)| *value -= null);
            own.deviation[axis] *= 2.0_f64.sqrt();
        }
        own
    };
    let fields = as_measured(vec![less_null(0), less_null(1)]);
    let found = stage(&experiment, &fields, Known::default(), &mut |_| ());
    let found = found.unwrap().unwrap();
    let [shared] = &found.shared_nulls[..] else {
        panic!("{:?}", found.shared_nulls)
    };
    assert_eq!(shared.states, [0, 1]);
    assert!(shared.data > 1500, "{}", shared.data);
    // Half of either variance is the null field's.
    assert!((shared.correlation - 0.5).abs() < 0.06, "{shared:?}");
    assert!((shared.too_narrow() - 1.5_f64.sqrt()).abs() < 0.03);
    let fit = found.comparison.best();
    assert!(fit.explains(), "{}", fit.calibration.excess());
    assert!((fit.calibration.values()[0] - 0.25).abs() < 0.002);
    let words = reported(&experiment, &found);
    assert!(
        words.contains("\"shared_nulls\":[{\"correlation\":0."),
        "{words}"
    );

    let apart = MEASURED.replacen("null.csv", "other.csv", 1);
    let found = stage(
        &read(&apart).unwrap(),
        &fields,
        Known::default(),
        &mut |_| (),
    );
    assert!(found.unwrap().unwrap().shared_nulls.is_empty());
}

#[test]
fn a_variance_is_as_stated_where_no_fit_says_otherwise() {
    let experiment = read(MEASURED).unwrap();
    let truth = aluminium(4.5);
    let law = Arc::clone(truth.own_law());
    let fields = measured_fields(&truth, law, &[6, 9], &window(20.0, 3.0, 0.2), 0.25, 1);
    let found = stage(
        &experiment,
        &as_measured(fields),
        Known::default(),
        &mut |_| (),
    );
    let stated = Scale {
        factor: 1.0,
        source: ScaleSource::Stated,
    };
    assert_eq!(found.unwrap().unwrap().scales, [stated; 2]);
}

#[test]
fn the_scenes_that_fit_laws_have_models_with_meshes_of_their_own() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes/hybrid-aluminium");
    for (name, laws) in [("laws.toml", 3), ("power-law.toml", 3)] {
        let none: [&str; 0] = [];
        let own = Experiment::from_file(&folder.join(name), &none, HOST).unwrap();
        assert!(!own.specimen.shares_its_mesh(), "{name}");
        assert_eq!(own.laws.len(), laws);
        let nodes = |own: &SpecimenScene| ContactModel::new(own).unwrap().edge().len();
        let truth = nodes(own.specimen.scene.as_ref().unwrap());
        let model = nodes(own.specimen.model.as_ref().unwrap());
        assert!(truth >= 2 * model, "{name}: {truth} {model}");
    }
}
