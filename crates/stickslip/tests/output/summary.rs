//! `summary.json`: its keys, its numbers, and that each key is described.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use serde_json::{Value, json};
use stickslip::output::{OutputError, summary_json, write};
use stickslip::results::{BlockError, Choice};

use super::files::written;
use super::fixture::{LOADS, RADIUS, THICKNESS, open_hole, results};

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or(f64::NAN)
}

/// Eleven digits: twelve are written.
fn close(value: &Value, expected: f64) -> bool {
    (number(value) - expected).abs() <= 1e-11 * expected.abs()
}

#[test]
fn the_first_contact_edge_stands_in_each_step() {
    let summary = summary_json(&results()).unwrap();
    assert_eq!(summary["format"], "stickslip-summary");
    assert_eq!(summary["format_version"], 2);
    assert_eq!(summary["edge"], "pin");
    assert_eq!(summary["program"]["name"], "stickslip");
    assert_eq!(summary["program"]["version"], env!("CARGO_PKG_VERSION"));
    assert_eq!(summary["steps"].as_array().unwrap().len(), LOADS.len());
    let step = &summary["steps"][2];
    // lbf to the twelfth digit.
    assert!(close(&step["load"]["value"], 4000.0 / 4.448_221_615_260_5));
    assert_eq!(step["load"]["unit"], "lbf");
    assert_eq!(step["loads"][1]["name"], "cool, slowly");
    assert!(close(&step["contact_half_angle_deg"], 80.0));
    let bearing = LOADS[2] / (2.0 * RADIUS * THICKNESS);
    assert!(close(&step["peak_pressure_over_bearing"], 100.0 / bearing));
    assert_eq!(step["peak_pressure_angle_deg"], 0.0);
    assert_eq!(step["peak_pressure"]["unit"], "psi");
    // Sticking nodes reach to 40°; slip follows up to the last node inside 80°.
    assert!(close(&step["stick_half_angle_deg"], 40.0));
    let contact = step["contact_zones_deg"].as_array().unwrap();
    assert_eq!(contact.len(), 1);
    assert!(close(&contact[0]["start"], -75.0) && close(&contact[0]["end"], 75.0));
    let stick = &step["stick_zones_deg"][0];
    assert!(
        close(&stick["start"], -40.0) && close(&stick["end"], 40.0),
        "{stick}"
    );
    // Both sides slip away from the bearing point under a rising load, and towards it under a falling one.
    let slip = &step["slip_zones_deg"];
    assert!(
        close(&slip[0]["start"], -75.0) && close(&slip[0]["end"], -40.0),
        "{slip}"
    );
    assert!(
        close(&slip[1]["start"], 40.0) && close(&slip[1]["end"], 75.0),
        "{slip}"
    );
    for zone in slip.as_array().unwrap() {
        assert_eq!(zone["direction"], "away");
    }
    for zone in summary["steps"][3]["slip_zones_deg"].as_array().unwrap() {
        assert_eq!(zone["direction"], "towards");
    }
    assert_eq!(step["bearing_angle_deg"], 0.0);
    assert_eq!(summary["edges"][0]["bearing_angle_deg"], 0.0);
    let clearance = &summary["edges"][0]["clearance"];
    assert!(close(&clearance["value"], 0.1 / 25.4) && clearance["unit"] == "in");
    assert_eq!(summary["edges"][1]["clearance"], Value::Null);
    assert_eq!(
        summary["edges"][0]["bearing_found"],
        "contact force of step 3"
    );
    assert_eq!(summary["steps"][3]["unloading"], true);
    assert_eq!(step["iterations"], 5);
    assert_eq!(step["points_in_doubt"], 1);
    assert_eq!(
        step["solver_notes"],
        json!({
            "failed": [{ "solver": "semismooth Newton", "reason": "cycled", "count": 4 }],
            "first_cycle": {
                "solver": "semismooth Newton",
                "period": 2,
                "nodes": [{ "x": 1.0, "y": 0.0, "unit": "in" }],
            },
        })
    );
    assert_eq!(step["solutions_counted"], 3);
    assert_eq!(step["other_solver"]["solver"], "pivoting");
    assert_eq!(step["other_solver"]["traction_change"], 0.02);
    assert_eq!(step["finer_increments"], serde_json::Value::Null);
    assert_eq!(step["friction_coefficient"], 0.5);
    assert_eq!(step["uniqueness_estimate"], 0.4);
    let quiet = json!({ "failed": [], "first_cycle": null });
    assert_eq!(summary["steps"][1]["solver_notes"], quiet);
    assert_eq!(summary["steps"][1]["uniqueness_estimate"], Value::Null);
    assert_eq!(
        step["edges"]["pin"]["contact_half_angle_deg"],
        step["contact_half_angle_deg"]
    );
}

#[test]
fn a_line_has_widths_and_an_edge_without_contact_has_nulls() {
    let summary = summary_json(&results()).unwrap();
    let line = &summary["steps"][2]["edges"]["roller"];
    assert!(close(&line["contact_half_width"]["value"], 2.0 / 25.4));
    assert_eq!(line["contact_half_width"]["unit"], "in");
    assert_eq!(line["slip_zones"][0]["unit"], "in");
    assert_eq!(line["contact_zones"].as_array().unwrap().len(), 1);
    assert_eq!(line["contact_zones"][0]["unit"], "in");
    assert!(close(&line["stick_half_width"]["value"], 1.0 / 25.4)); // half of the contact in this fixture
    assert!(line.get("contact_half_angle_deg").is_none());
    let free = &summary["steps"][2]["edges"]["plate.left"];
    for key in [
        "contact_half_width",
        "peak_pressure",
        "friction_force",
        "resultant",
    ] {
        assert_eq!(free[key], Value::Null, "{key}");
    }
    assert_eq!(free["slip_zones"], Value::Array(Vec::new()));
    assert_eq!(free["peak_hoop"]["unit"], "psi");
}

#[test]
fn numbers_that_do_not_exist_are_null() {
    let mut results = results();
    results.steps[0].balance_residual = f64::NAN;
    results.steps[0].edges[0].resultant = [0.0; 2];
    let summary = summary_json(&results).unwrap();
    assert_eq!(summary["steps"][0]["balance_residual"], Value::Null);
    assert_eq!(
        summary["steps"][0]["peak_pressure_over_bearing"],
        Value::Null
    );
    results.steps.pop();
    results.steps[0].edges.pop();
    assert!(matches!(
        summary_json(&results),
        Err(OutputError::Inconsistent { .. })
    ));
}

#[test]
fn pressures_that_balance_each_other_give_no_bearing_stress() {
    let mut results = results();
    // What is left of 1000 N all around a pin with interference.
    results.steps[0].edges[0].resultant = [1e-13, 0.0];
    let summary = summary_json(&results).unwrap();
    assert_eq!(summary["steps"][0]["bearing_stress"], Value::Null);
    assert_eq!(summary["steps"][0]["peak_hoop_over_bearing"], Value::Null);
    assert!(summary["steps"][0]["peak_hoop"]["value"].is_f64());
}

#[test]
fn the_file_is_the_value() {
    let results = results();
    let (_place, folder) = written(&results, false);
    let text = fs::read_to_string(folder.join("summary.json")).unwrap();
    assert_eq!(
        serde_json::from_str::<Value>(&text).unwrap(),
        summary_json(&results).unwrap()
    );
    assert!(text.starts_with("{\n  \"format\": \"stickslip-summary\""));
}

/// Of two equal keys of one object only the last would be read. The parts of a step that are flattened into it must not share any.
/// Between the solver and what was chosen after it.
#[test]
fn the_error_of_blocks_is_stated_among_the_choices() {
    let mut results = results();
    let choice = |what: &str| Choice {
        what: what.to_owned(),
        value: "so".to_owned(),
        reason: String::new(),
    };
    results.choices = vec![choice(Choice::SOLVER), choice("errors")];
    results.blocks = Some(BlockError {
        rank: 7,
        tractions: 0.25,
        displacement: 0.5,
    });
    let summary = summary_json(&results).unwrap();
    let whats = [0, 1, 2].map(|k| &summary["choices"][k]["what"]);
    assert_eq!(whats, ["solver", "compliance in blocks", "errors"]);
    let expected = json!({
        "what": "compliance in blocks",
        "value": "at most 7 shapes an edge, tractions to 0.25 of the peak pressure",
        "reason": "displacements of contact points to 0.5 mm of those by the whole factor",
    });
    assert_eq!(summary["choices"][1], expected);
}

#[test]
fn no_key_stands_twice() {
    let mut line_first = results();
    line_first.edges.remove(0);
    for step in &mut line_first.steps {
        step.edges.remove(0);
    }
    for results in [results(), line_first, open_hole()] {
        let text = write(&results, false, &|_, _| Ok(())).unwrap();
        let read: Value = serde_json::from_str(&text).unwrap();
        let again = serde_json::to_string_pretty(&read).unwrap();
        assert_eq!(
            text.lines().count(),
            again.lines().count(),
            "{}",
            results.edges[0].name
        );
    }
}

/// Every key below `value`; names of edges and phases are data, not keys.
fn keys(value: &Value, found: &mut BTreeSet<String>) {
    match value {
        Value::Object(entries) => {
            for (key, value) in entries {
                found.insert(key.clone());
                match (key.as_str(), value) {
                    ("wall_time_s", Value::Object(_)) => {}
                    ("edges", Value::Object(edges)) => {
                        edges.values().for_each(|edge| keys(edge, found));
                    }
                    _ => keys(value, found),
                }
            }
        }
        Value::Array(values) => values.iter().for_each(|value| keys(value, found)),
        _ => {}
    }
}

#[test]
fn every_key_is_described() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/summary-format.md");
    let text = fs::read_to_string(path).unwrap();
    let mut found = BTreeSet::new();
    keys(&summary_json(&results()).unwrap(), &mut found);
    assert!(found.len() > 50, "{found:?}");
    for key in found {
        assert!(
            text.contains(&format!("`{key}`")),
            "docs/summary-format.md does not describe `{key}`"
        );
    }
}
