//! Findings as sentences and in `summary.json`.

use std::fs;
use std::path::Path;

use serde_json::{Value, json};
use stickslip::output::{joint_sentence, sentence, summary_json};
use stickslip::results::{
    CoarseLoadPath, ContactFinding, CutBackEffect, FailedSolver, Finding, FreeBody, FreeMotion,
    FurtherSolvers, JointFinding, LadderEnd, Quantity, SolverDependence, StatusCycle,
    UniquenessBound, Yield,
};
use stickslip::scene::shape::{FileCurve, FileNote};

use super::fixture::results;

/// 1 psi in MPa.
pub(super) const PSI: f64 = 4.448_221_615_260_5 / (25.4 * 25.4);

/// One of every kind that concerns no contact.
fn of_the_run() -> Vec<Finding> {
    [of_other_ways(), of_bodies(), of_errors()].concat()
}

/// One of every kind about other ways to an answer.
fn of_other_ways() -> Vec<Finding> {
    let steps = vec![2, 3, 4, 7];
    vec![
        Finding::CutBack {
            steps: steps.clone(),
            effect: CutBackEffect::Slip {
                step: 7,
                increments: 8,
                slip_change: 0.0123456,
                dissipation_change: 0.5,
            },
        },
        Finding::CoarseLoadPath(CoarseLoadPath {
            steps: steps.clone(),
            step: 7,
            increments: 4,
            traction_change: 0.08,
            dissipation_change: 0.25,
        }),
        Finding::LoadPathUnchecked { steps: vec![1] },
        Finding::SolverDependent(SolverDependence {
            steps: steps.clone(),
            step: 7,
            solver: "pivoting",
            peak_pressure_change: 0.25,
            traction_change: 0.1 + 0.2,
        }),
        Finding::NoOtherSolver {
            too_dear: steps.clone(),
            limit: 2e9,
            unsolved: vec![1],
        },
    ]
}

fn of_bodies() -> Vec<Finding> {
    let steps = vec![2, 3, 4, 7];
    let names = || vec!["a".to_owned(), "b".to_owned(), "c".to_owned()];
    vec![
        Finding::PointsInDoubt {
            steps: steps.clone(),
            points: 3,
        },
        Finding::FurtherSolvers(FurtherSolvers {
            steps: steps.clone(),
            failed: vec![FailedSolver {
                solver: "status iteration",
                reason: "cycled",
                count: 2,
            }],
            cycle: Some(StatusCycle {
                period: 2,
                points: 5,
            }),
        }),
        Finding::SeveralSolutions {
            steps: steps.clone(),
            solutions: 3,
        },
        Finding::NearUniquenessBound(UniquenessBound {
            step: 3,
            friction: 0.9,
            estimate: 1.0,
            solutions: Some(1),
            other_solver_asked: false,
        }),
        Finding::Unverified {
            steps: steps.clone(),
            solvers: vec!["penalty"],
            residual: 1.2e-3,
        },
        Finding::Unbalanced {
            steps: steps.clone(),
            residual: 2.8e-7,
            usual: 1e-8,
        },
        Finding::MeshFile {
            body: "plate".into(),
            notes: vec![FileNote::MidNodes {
                edge: "hole".into(),
                moved: 24,
                onto: FileCurve::Circle(5.0),
            }],
        },
        Finding::MovedIntoHole {
            body: "pin".into(),
            hole: "plate.hole".into(),
            distance: Quantity::Length(25.4),
        },
        Finding::PointSupports {
            bodies: vec!["pin".into()],
        },
        Finding::PointLoads {
            loads: vec!["push".into()],
        },
        Finding::ContactParts { steps },
        Finding::FreeBody(FreeBody {
            body: "pin".into(),
            motion: FreeMotion::Translation,
            contacts: names(),
        }),
        Finding::FreeTogether {
            bodies: names(),
            motions: vec![FreeMotion::Rotation],
        },
        Finding::ReserveWithInterference { contacts: names() },
        Finding::Yields(Yield {
            body: "plate".into(),
            steps: vec![3, 4],
            step: 4,
            von_mises: Quantity::Stress(200.0 * PSI),
            yield_stress: Quantity::Stress(150.0 * PSI),
            at: [25.4, 0.0].map(Quantity::Length),
        }),
        Finding::LargeStrains {
            body: "plate".into(),
            step: 2,
            strain: 2.4,
        },
    ]
}

/// One of every kind about errors that are not known.
fn of_errors() -> Vec<Finding> {
    let steps = vec![2, 3, 4, 7];
    vec![
        Finding::NoLimitAtSupport {
            edge: "plate.bottom".into(),
            steps: steps.clone(),
        },
        Finding::NoValueAtLoadEnd {
            edge: "plate.right".into(),
            steps: steps.clone(),
        },
        Finding::NoLimitAtReentrantCorner {
            edge: "plate.inner".into(),
            steps,
            angle: 270.0,
            exponent: Some(-0.4555),
        },
        Finding::AccuracyMissed {
            number: "peak tangential stress",
            error: 0.0662,
            end: LadderEnd::Finest,
        },
        Finding::AccuracyUnstated {
            numbers: vec!["displacement", "stiffness"],
        },
        Finding::GeometryLeftOut {
            why: "contact 'pin' is tied by a mortar projection".into(),
        },
        Finding::GeometryUnchecked {
            why: "load step 1 was not solved".into(),
        },
    ]
}

/// One of every kind that concerns a contact.
fn of_a_contact() -> Vec<Finding> {
    let bodies = || ["plate", "pin"].map(String::from);
    let steps = || vec![2, 5];
    let findings = [
        ContactFinding::UnequalThickness {
            bodies: bodies(),
            thickness: [25.4, 50.8].map(Quantity::Length),
        },
        ContactFinding::WideClearance { clearance: 0.2 },
        ContactFinding::FittedRadius {
            edge: "plate.hole".into(),
            off: Quantity::Length(0.0254),
            clearance: Quantity::Length(0.254),
        },
        ContactFinding::OtherRadius {
            edge: "plate.hole".into(),
            given: Quantity::Length(25.4),
            fitted: Quantity::Length(26.4),
            off: Quantity::Length(0.0254),
        },
        ContactFinding::BeyondFineMesh {
            step: 2,
            end: Quantity::Length(-25.4),
            both_ends: false,
            limit: Quantity::Length(12.7),
        },
        ContactFinding::BeyondFacing {
            step: 2,
            at: Quantity::Along(12.7),
        },
        ContactFinding::BearingPointWanders {
            step: 2,
            at: Quantity::Angle(-0.5),
            largest_step: 3,
            largest_at: Quantity::Angle(std::f64::consts::PI),
        },
        ContactFinding::Unresolved {
            steps: steps(),
            nodes: 1,
        },
        ContactFinding::PeakUnresolved {
            steps: steps(),
            nodes: 2,
        },
        ContactFinding::NoLimit {
            steps: steps(),
            numbers: vec!["peak pressure", "peak tangential stress"],
        },
        ContactFinding::NoLimitAtCorner {
            steps: steps(),
            at: vec![Quantity::Along(25.4)],
        },
        ContactFinding::PairsApart {
            steps: steps(),
            apart: Quantity::Angle(0.01),
            spacing: Quantity::Angle(0.005),
        },
        ContactFinding::OutlineLeftOut {
            step: 2,
            reach: Quantity::Length(2.54),
            size: Quantity::Length(25.4),
            radius: Some(Quantity::Length(254.0)),
        },
        ContactFinding::RipplingPressures {
            bodies: bodies(),
            nodes: [30, 10],
            stiffness_ratio: 20.4,
        },
        ContactFinding::GapsUndetermined {
            bodies: bodies(),
            steps: steps(),
        },
        ContactFinding::SlipUndetermined {
            bodies: bodies(),
            steps: steps(),
        },
    ];
    findings
        .map(|finding| Finding::about("pin", finding))
        .into()
}

/// One of every kind that concerns a followed joint.
fn of_a_joint() -> [JointFinding; 6] {
    let [row_width, cell_size, largest_cell] = [25.4, 50.8, 12.7].map(Quantity::Length);
    [
        JointFinding::CrackBandIdle {
            energy: "fibre_tension",
            row_width,
            cell_size,
            largest_cell,
        },
        JointFinding::CrackBandPartial {
            energy: "matrix_tension",
            lowered_cells: 27,
            cells: 78,
            cell_size,
        },
        JointFinding::Unverified {
            solvers: vec!["penalty"],
            residual: 1.2e-3,
        },
        JointFinding::SubstepsIgnored,
        JointFinding::ClearOfSupportsIgnored,
        JointFinding::OtherBodiesIntact {
            bodies: vec!["a".into(), "b".into()],
        },
    ]
}

#[test]
fn sentences_hold_steps_parts_and_display_units() {
    let units = results().units;
    let mut words: Vec<String> = (of_the_run().iter().chain(&of_a_contact()))
        .map(|finding| sentence(finding, units))
        .collect();
    words.extend(of_a_joint().map(|finding| joint_sentence(&finding, units)));
    // Sentences, to see how their parts join.
    for start in [
        "Contact 'pin': 'plate' is 1 in thick and 'pin' 2 in.",
        "Body 'pin' can slide freely: its translation and CSLIP1 on 'a', 'b' and 'c' are not unique.",
        "Body 'plate' yields: in load step 4 its von Mises stress of 200 psi exceeds the yield stress of 150 psi at x = 1 in, y = 0 in; it does so in load steps 3–4.",
    ] {
        let own = words.iter().filter(|own| own.starts_with(start));
        assert_eq!(own.count(), 1, "{start} in {words:#?}");
    }
    // Of others the beginning, and the parts that hold numbers and names.
    let others = "\
The answer is not unique … load steps 2–4, 7: up to 3 contact points
More than the first solver … load steps 2–4, 7: status iteration: cycled (×2) … 5 points repeated with period 2
Friction of up to 0.900 is near 1.000 … up to which load step 3
The increment was cut back in … load steps 2–4, 7. … 8 increments CSLIP1 of load step 7 … 1.2 % of … friction by 50 %
The answer depends on the number of … load steps 2–4, 7: with four times … load step 7 … 8.0 % of the largest … friction by 25 %
Whether friction depends on the number … not checked in load step 1:
Whether another solver finds another … load steps 2–4, 7 would take … 2e9 operations … did not solve load step 1.
Forces balance to 2.8e-7 of the load … load steps 2–4, 7, where 1e-8 is usual:
No error is stated for the peak … pressure and the peak tangential stress of contact 'pin' … load steps 2, 5: friction jumps
A corner presses at s = 1 in … of contact 'pin' in load steps 2, 5:
Contact 'pin' ends at x = -1 in … in load step 2, … ends at ±0.5 in:
The bearing point of contact 'pin' moves … θ = −28.6° in load step 2 … θ = 180.0° in load step 3 … counted from the latter;
crack_band.fibre_tension has no effect … wider than 1 in, … larger than 2 in; … has 0.5 in.
Plies of 'a', 'b' do not fail … one body is followed.";
    for line in others.lines() {
        let (start, parts) = line.split_once(" … ").unwrap();
        let is_it = |own: &&String| {
            own.starts_with(start) && parts.split(" … ").all(|part| own.contains(part))
        };
        assert_eq!(
            words.iter().filter(is_it).count(),
            1,
            "{line} in {words:#?}"
        );
    }
}

/// Contacts that leave bodies loose in the same steps are one note, and findings for themselves.
#[test]
fn loose_contacts_of_the_same_steps_share_a_note() {
    let loose = |contact: &str, steps: &[usize]| {
        let found = ContactFinding::GapsUndetermined {
            bodies: ["plate".to_owned(), contact.to_owned()],
            steps: steps.to_vec(),
        };
        Finding::about(contact, found)
    };
    let mut results = results();
    results.findings = vec![loose("a", &[1, 2]), loose("b", &[3]), loose("c", &[1, 2])];
    let summary = summary_json(&results).unwrap();
    let notes = summary["notes"].as_array().unwrap();
    let begin = |start: &str| {
        notes
            .iter()
            .filter(|note| note.as_str().unwrap().starts_with(start))
            .count()
    };
    assert_eq!(
        (
            notes.len(),
            begin("Contacts 'a' and 'c'"),
            begin("Contact 'b'")
        ),
        (2, 1, 1)
    );
    assert_eq!(summary["findings"].as_array().unwrap().len(), 3);
}

#[test]
fn the_summary_has_their_numbers_in_display_units() {
    let mut results = results();
    results.findings = [of_the_run(), of_a_contact()].concat();
    let summary = summary_json(&results).unwrap();
    let findings = summary["findings"].as_array().unwrap();
    assert_eq!(findings.len(), summary["notes"].as_array().unwrap().len());
    let of_kind = |kind: &str| findings.iter().find(|finding| finding["kind"] == kind);
    let inches = |value: f64| json!({ "value": value, "unit": "in" });
    assert_eq!(
        of_kind("solver_dependent").unwrap(),
        &json!({
            "kind": "solver_dependent", "steps": [2, 3, 4, 7], "step": 7, "solver": "pivoting",
            "peak_pressure_change": 0.25, "traction_change": 0.3,
        })
    );
    assert_eq!(
        of_kind("unequal_thickness").unwrap(),
        &json!({
            "kind": "unequal_thickness", "contact": "pin", "bodies": ["plate", "pin"],
            "thickness": [inches(1.0), inches(2.0)],
        })
    );
    let place = &of_kind("bearing_point_wanders").unwrap()["largest_at"];
    assert_eq!(place, &json!({ "value": 180.0, "unit": "deg" }));
    let effect = &of_kind("cut_back").unwrap()["effect"];
    assert_eq!(effect["kind"], "slip");
}

#[test]
fn every_kind_and_key_is_described() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/summary-format.md");
    let text = fs::read_to_string(path).unwrap();
    let (_, text) = text.split_once("## Findings").unwrap();
    let findings = [of_the_run(), of_a_contact()].concat();
    let entries = (findings.iter().map(serde_json::to_value)).chain(
        of_a_joint()
            .iter()
            .map(serde_json::to_value)
            .collect::<Vec<_>>(),
    );
    for entry in entries {
        let Value::Object(entry) = entry.unwrap() else {
            panic!("a finding is an object");
        };
        let line = format!("| `{}` |", entry["kind"].as_str().unwrap());
        let line = text.lines().find(|described| described.starts_with(&line));
        let line = line.unwrap_or_else(|| panic!("{entry:?} is not described"));
        for key in entry.keys().filter(|key| *key != "kind") {
            assert!(line.contains(&format!("`{key}`")), "{key}: {line}");
        }
    }
}
