//! The machine itself: every check holds for a sound answer and fails for one that was tampered with; failures shrink; and the
//! scenes that failed once hold.

use std::path::Path;
use std::time::Duration;

use serde_json::{Value, json};
use stickslip::results::{EdgeRow, Finding, Results};
use stickslip_contact::Status;

use super::replay::replay;
use super::sample::{Sample, Verdict, solve};
use super::{checks, random, shrink};

/// A pin in a strip that is pulled, let go and pulled again.
fn strip() -> Value {
    json!({
        "version": 1,
        "materials": { "m": { "isotropic": { "young": "70000 MPa", "poisson": 0.3 } } },
        "bodies": {
            "plate": {
                "material": "m", "thickness": "2 mm",
                "shape": { "plate_with_hole": {
                    "hole_radius": "5 mm",
                    "outline": { "strip": { "half_width": "15 mm", "left": "40 mm", "right": "15 mm" } },
                } },
            },
            "pin": { "material": "m", "thickness": "2 mm", "shape": { "disk": { "radius": "4.99 mm" } } },
        },
        "mesh": { "spacing": "15 deg" },
        "analysis": { "model": "whole" },
        "contacts": [{
            "name": "pin", "first": "plate.hole", "second": "pin.rim", "friction": { "coulomb": { "mu": 0.2 } },
        }],
        "supports": [{ "on": "pin.centre", "fix": ["x", "y"] }],
        "loads": [{ "on": "plate.left", "force": { "direction": [-1.0, 0.0], "steps": ["1000 N", "300 N", "2000 N"] } }],
        "output": { "fields": "none", "figures": false },
    })
}

/// A ring around a neat pin, pulled by its rim.
fn ring() -> Value {
    let mut scene = strip();
    scene["bodies"]["plate"]["shape"]["plate_with_hole"]["outline"] =
        json!({ "ring": { "radius": "20 mm" } });
    scene["bodies"]["pin"]["shape"]["disk"]["radius"] = json!("5 mm");
    scene["loads"][0]["on"] = json!("plate.outer");
    scene
}

fn sample(value: &Value) -> Sample {
    solve(value).unwrap_or_else(|none| panic!("{}", none.describe()))
}

/// The scene in which a check concerns something.
fn scene_for(check: &str) -> Value {
    match check {
        "turned" => ring(),
        "half and whole" => {
            let mut scene = strip();
            scene["analysis"]["model"] = json!("auto");
            scene
        }
        "path" => {
            let mut scene = strip();
            scene["contacts"][0]["friction"]["coulomb"]["mu"] = json!(0.0);
            scene
        }
        _ => strip(),
    }
}

/// The most loaded point of the last step.
fn loaded(results: &mut Results) -> &mut EdgeRow {
    let rows = &mut results.steps.last_mut().unwrap().edges[0].rows;
    rows.iter_mut()
        .max_by(|a, b| a.pressure.total_cmp(&b.pressure))
        .unwrap()
}

/// A point that slips in the last step.
fn slipping(results: &mut Results) -> &mut EdgeRow {
    let rows = &mut results.steps.last_mut().unwrap().edges[0].rows;
    let slips =
        |row: &&mut EdgeRow| matches!(row.status, Status::SlipPositive | Status::SlipNegative);
    rows.iter_mut().find(slips).unwrap()
}

/// What a fault of the program could do to the results, for each check.
fn tamper(check: &str, sample: &mut Sample) {
    let results = &mut sample.results;
    match check {
        "numbers" => loaded(results).tau = f64::NAN,
        "unilateral" => loaded(results).gap = 1e-6,
        "cone" => slipping(results).shear *= 1.0 + 1e-5,
        "direction" => slipping(results).shear *= -1.0,
        "dissipation" => results.steps[0].dissipation = -1e-3,
        // A tenth more pressure everywhere, the sums as they are.
        "resultant" => results.steps[0].edges[0]
            .rows
            .iter_mut()
            .for_each(|row| row.pressure *= 1.3),
        "bodies" => results.steps[0].edges[0].resultant[0] *= 1.0 + 1e-6,
        "balance note" => results.steps[0].balance_residual = 1e-6,
        "written" => results.steps[0].loads[0].value *= 1.001,
        "another mesh" => results.steps[2].edges[0].normal_force *= 2.0,
        "key order" | "threads" => loaded(results).pressure = loaded(results).pressure.next_up(),
        _ => loaded(results).pressure *= 1.0 + 1e-5,
    }
}

#[test]
fn every_check_holds_and_can_fail() {
    for check in checks() {
        let mut sample = sample(&scene_for(check.name));
        assert_eq!((check.verdict)(&sample), Verdict::Holds, "{}", check.name);
        if check.name == "resumed" {
            // A sweep makes its own results: its rows are tampered with below.
            continue;
        }
        tamper(check.name, &mut sample);
        let verdict = (check.verdict)(&sample);
        assert!(
            matches!(verdict, Verdict::Fails(_)),
            "{}: {verdict:?}",
            check.name
        );
    }
}

#[test]
fn a_row_that_a_single_run_contradicts_is_found() {
    let sample = sample(&strip());
    let verdict = super::sweeps::tampered(&sample, 1.0);
    assert_eq!(verdict.ok(), Some(Verdict::Holds));
    let verdict = super::sweeps::tampered(&sample, 1.0 + 1e-5);
    assert!(matches!(verdict, Ok(Verdict::Fails(_))), "{verdict:?}");
}

#[test]
fn what_the_notes_declare_is_counted_as_declared() {
    let mut sample = sample(&strip());
    sample.results.findings.push(Finding::SeveralSolutions {
        steps: vec![1],
        solutions: 2,
    });
    let mirrored = checks().find(|check| check.name == "mirrored").unwrap();
    assert_eq!((mirrored.verdict)(&sample), Verdict::Holds);
    tamper("mirrored", &mut sample);
    assert!(matches!((mirrored.verdict)(&sample), Verdict::Declared(_)));
}

#[test]
fn a_failure_shrinks_to_what_it_needs() {
    // A pretended fault: wherever a bushing is held with a law that remembers.
    let needs = |scene: &Value| {
        let contacts = scene["contacts"].as_array().is_some_and(|contacts| {
            contacts
                .iter()
                .any(|contact| contact["friction"].get("slip_power").is_some())
        });
        contacts
            && scene["loads"]
                .as_array()
                .is_some_and(|loads| !loads.is_empty())
    };
    let scene = (0..500)
        .map(random::scene)
        .find(|scene| needs(scene) && scene["contacts"].as_array().unwrap().len() > 1);
    let scene = scene.expect("some seed has a bushing with this law");
    let small = shrink::shrink(&scene, Duration::from_secs(30), 5000, &mut |candidate| {
        needs(candidate)
    });
    assert!(needs(&small));
    assert_eq!(small["contacts"].as_array().unwrap().len(), 1, "{small}");
    assert_eq!(small["loads"].as_array().unwrap().len(), 1);
    assert!(small.get("title").is_none() && small.get("analysis").is_none());
    assert_eq!(small["bodies"].as_object().unwrap().len(), 2, "{small}");
    assert_eq!(
        small["loads"][0]["force"]["steps"]
            .as_array()
            .unwrap()
            .len(),
        1,
        "{small}"
    );
}

#[test]
fn drawn_scenes_read_and_repeat() {
    let mut refused = Vec::new();
    for seed in 0..300 {
        let scene = random::scene(seed);
        assert_eq!(scene, random::scene(seed));
        if let Err(none) = super::sample::read(&scene.to_string(), stickslip::scene::Format::Json) {
            refused.push(format!("{seed}: {}", none.describe()));
        }
    }
    assert!(refused.is_empty(), "{}", refused.join("\n"));
}

/// Scenes in which a check failed once, with its name in their titles.
#[test]
fn what_was_found_holds() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/torture/found");
    for file in std::fs::read_dir(folder).unwrap() {
        let path = file.unwrap().path();
        let (lines, holds) =
            replay(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
        assert!(holds && !lines.is_empty(), "{}: {lines}", path.display());
    }
}
