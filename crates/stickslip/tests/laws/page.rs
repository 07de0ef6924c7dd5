//! What the page reports of fitted laws and of the whole plate.

use std::path::Path;
use std::sync::Arc;

use stickslip::experiment::chain::Edges;
use stickslip::experiment::finding::{LeftOutReason, ModelFinding};
use stickslip::experiment::history::Untied;
use stickslip::experiment::identified::identify;
use stickslip::experiment::laws::Known;
use stickslip::experiment::measured::Measured;
use stickslip::experiment::report::ExperimentReport;
use stickslip::experiment::whole::WholeState;
use stickslip::experiment::{Experiment, ExperimentError, laws, whole};
use stickslip::folder::{Overwrite, ResultFolder};
use stickslip::host::HOST;
use stickslip::keep;
use stickslip::scene::Format;
use stickslip_experiment_pages as page;

use crate::common::{aluminium, law, measured_fields, window};

const EXPERIMENT: &str = r#"
version = 1
title = "Laws on known truth"
[units]
length = "mm"
force = "N"
stress = "MPa"
[specimen]
scene = "pin-loaded-aluminium.toml"
body = "plate"
edge = "hole"
overrides = ["mesh.spacing=4.5 deg", "mesh.coarse_spacing=9 deg"]
[grating]
frequency = "2400 1/mm"
[[states]]
name = "up"
table = { file = "up.csv", scale = "1 mm", y_axis = "up" }
load = "1980 lbf"
[[states]]
name = "down"
table = { file = "down.csv", scale = "1 mm", y_axis = "up" }
load = "1210 lbf"
direction = "unloading"
[region]
sector = { angles = ["-100 deg", "100 deg"], outer = "18 mm", cells = [40, 6] }
whole_plate = true
[[laws]]
name = "Coulomb"
friction.coulomb = { mu = 0.3 }
free = { mu = [0.0, 1.0] }
[[laws]]
name = "static and dynamic"
friction.static_dynamic = { static = 0.4, dynamic = 0.25 }
free = { dynamic = [0.0, 1.0] }
[[laws]]
name = "slip power"
friction.slip_power = { static = 0.4, dynamic = 0.25, slip_scale = "0.002 mm", exponent = 2.0 }
free = { slip_scale = ["0.0001 mm", "0.1 mm"], dynamic = [0.0, 1.0] }
"#;

fn experiment(text: &str) -> Experiment {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes");
    let none: [&str; 0] = [];
    Experiment::from_text(text, Format::Toml, "known.toml", &folder, &none, HOST).unwrap()
}

fn fields() -> Vec<Measured> {
    let truth = aluminium(2.25);
    let text = r#"{ "slip_power": { "static": 0.4, "dynamic": 0.2, "slip_scale": 0.002, "exponent": 2.0 } }"#;
    let places = window(20.0, 1.0, 0.2);
    let all = measured_fields(&truth, Arc::from(law(text)), &[6, 9], &places, 0.25, 1);
    let numbered = all.into_iter().enumerate();
    numbered
        .map(|(state, measurement)| Measured::new(state, measurement))
        .collect()
}

#[test]
fn the_page_shows_laws_and_the_whole_plate() {
    let experiment = experiment(EXPERIMENT);
    let fields = fields();
    let mut report = ExperimentReport::new(&experiment);
    let (states, findings) = whole::stage(&experiment, &fields).unwrap();
    assert_eq!((states.len(), findings.len()), (2, 0));
    let bears: Vec<_> = states.iter().map(WholeState::edge).collect();
    let edges = Edges {
        analysed: Vec::new(),
        plate_friction: Some(identify(&experiment, &bears).unwrap()),
        plates: states,
        plate_findings: findings,
    };
    page::whole::report(&experiment, &edges, &mut report);
    let stage = laws::stage(&experiment, &fields, Known::default(), &mut |_| ())
        .unwrap()
        .unwrap();
    page::laws::report(&experiment, &stage, &mut report);

    assert_eq!(stage.comparison.best().law.name, "slip power");
    let summary = report.summary();
    assert_eq!(summary["laws"]["best"], "slip power");
    // Free parameters stand in the order of their names.
    assert_eq!(
        summary["laws"]["fits"][2]["parameters"][1]["name"],
        "slip_scale"
    );
    assert_eq!(summary["laws"]["fits"][2]["parameters"][1]["unit"], "mm");
    let answers = report.text_answers();
    assert!(
        answers.contains("Friction law: slip power: preferred"),
        "{answers}"
    );

    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join("laws-page");
    let folder = ResultFolder::create(&path, Overwrite::Force(|_| None)).unwrap();
    let path = keep::report(report, folder).unwrap();
    for file in ["laws.csv", "law-fit-up.csv", "whole-plate-down.csv"] {
        assert!(path.join(file).exists(), "{file}");
    }
    let fitted = std::fs::read_to_string(path.join("law-fit-up.csv")).unwrap();
    let headings = fitted.lines().next().unwrap();
    assert!(
        headings.starts_with("x [mm],y [mm],\"component (0: u, 1: v)\",measured [mm],"),
        "{headings}"
    );
    assert!(!headings.contains("\"\""), "{headings}");
    for figure in [
        "law-profiles",
        "law-residuals",
        "law-predictions",
        "law-passage",
        "whole-plate-ratio",
        "whole-plate-tractions",
    ] {
        assert!(
            path.join(format!("figures/{figure}.png")).exists(),
            "{figure}"
        );
    }
    let table = std::fs::read_to_string(path.join("laws.csv")).unwrap();
    assert_eq!(table.lines().count(), 5);
}

/// What the experiment with `from` replaced by `to` is refused with.
fn refused(from: &str, to: &str) -> (ExperimentError, String) {
    let text = EXPERIMENT.replace(from, to);
    assert_ne!(text, EXPERIMENT);
    let experiment = experiment(&text);
    let error = laws::stage(&experiment, &fields(), Known::default(), &mut |_| ()).unwrap_err();
    let located = error.located(&experiment).to_string();
    (error, located)
}

#[test]
fn laws_that_cannot_be_fitted_are_refused_at_their_line() {
    let (_, words) = refused("free = { mu =", "free = { my =");
    assert!(words.starts_with("known.toml:"), "{words}");
    assert!(words.contains("my"), "{words}");
    let (_, words) = refused("free = { mu = [0.0, 1.0] }", "");
    assert!(
        words.contains("law 'Coulomb' has no free parameter to fit"),
        "{words}"
    );
    let (error, _) = refused("load = \"1", "load = \"9");
    assert!(matches!(error, ExperimentError::Missing { .. }));
}

#[test]
fn a_state_that_is_no_load_step_is_reported_and_left_out() {
    let laws_begin = EXPERIMENT.find("[[laws]]\nname = \"static").unwrap();
    let text = EXPERIMENT[..laws_begin].replace("1210 lbf", "1240 lbf");
    let experiment = experiment(&text);
    let stage = laws::stage(&experiment, &fields(), Known::default(), &mut |_| ())
        .unwrap()
        .unwrap();
    assert_eq!(stage.states, [0]);
    let ModelFinding::LeftOutOfLaws(left_out) = &stage.findings[0] else {
        panic!("{:?}", stage.findings);
    };
    let state = &experiment.states[1];
    assert_eq!(left_out.state, "down");
    assert!(matches!(
        left_out.reason,
        LeftOutReason::Untied(Untied::NoSuchStep { load, direction, .. })
            if Some(load) == state.load && direction == state.direction
    ));
    let load = experiment.display.force.show(state.load.unwrap());
    let words = left_out.to_string();
    assert!(
        words.starts_with("State 'down' ") && words.contains(&format!("has {load} in unloading")),
        "{words}"
    );
}
