//! Findings on scenes that are right but surprise.

use std::path::Path;

use stickslip::host::HOST;
use stickslip::output::sentence;
use stickslip::results::{
    ContactFinding, Finding, FreeBody, FreeMotion, Quantity, UniquenessBound,
};
use stickslip::scene::Scene;

use super::series::PIN;
use super::{BUSHING, model, results, solved};

/// The bushing with its pin held over its section, since what hangs on a point draws a finding.
fn joint() -> String {
    BUSHING.replace("pin.centre", "pin.section")
}

/// What `kind` takes of the findings on contacts, with the name of each contact.
fn on_contacts<T>(
    findings: &[Finding],
    kind: impl Fn(&ContactFinding) -> Option<T>,
) -> Vec<(&str, T)> {
    let taken = findings.iter().map(|finding| match finding {
        Finding::Contact { contact, finding } => Some((contact.as_str(), kind(finding)?)),
        _ => None,
    });
    taken.flatten().collect()
}

fn free_bodies(findings: &[Finding]) -> Vec<&FreeBody> {
    let taken = findings.iter().map(|finding| match finding {
        Finding::FreeBody(free) => Some(free),
        _ => None,
    });
    taken.flatten().collect()
}

fn degrees(place: Quantity) -> f64 {
    match place {
        Quantity::Angle(angle) => (angle.to_degrees() * 10.0).round() / 10.0,
        Quantity::Length(_) | Quantity::Along(_) | Quantity::Stress(_) => {
            panic!("{place:?} on a circle")
        }
    }
}

#[test]
fn a_plain_joint_needs_no_remark() {
    assert_eq!(solved(&joint(), &["analysis.substeps=8"]).findings, []);
    // In one increment friction of the first step is another, which the second goes on from, and so is that of the turn of the load.
    let coarse = solved(&joint(), &[]);
    // The second step goes on as the first: the case that holds displacements is none of its loads.
    let path = |step: usize| coarse.steps[step].notes.otherwise.path;
    let increments = |step: usize| path(step).map(|path| path.increments);
    assert_eq!([0, 1, 2].map(increments), [4, 1, 4].map(Some));
    let [Finding::CoarseLoadPath(coarse)] = &coarse.findings[..] else {
        panic!("{coarse:?}");
    };
    assert_eq!((&coarse.steps[..], coarse.increments), (&[1, 2, 3][..], 4));
    let friction = |substeps: usize| {
        let found = solved(&joint(), &[&format!("analysis.substeps={substeps}")]);
        found.steps[0].edges[0].friction_force.abs()
    };
    let fine = friction(64);
    assert!((friction(1) / fine - 1.0).abs() > 0.05 && (friction(8) / fine - 1.0).abs() < 0.05);
}

/// The second walk through a history of ten steps takes no more than it may, and finds what unloading inherits.
#[test]
fn a_history_of_few_increments_is_compared_to_its_end() {
    let found = solved(include_str!("../../../../scenes/bushed-pin.toml"), &[]);
    let notes = |step: usize| found.steps[step].notes.otherwise;
    assert!((0..10).all(|step| notes(step).path_missing.is_none()));
    let coarse = found.findings.iter().find_map(|finding| match finding {
        Finding::CoarseLoadPath(coarse) => Some(&coarse.steps[..]),
        _ => None,
    });
    // The seventh by the work of friction alone.
    assert_eq!(coarse, Some(&[2, 3, 7, 9, 10][..]));
}

/// A contact that bears on one side and then on the other is reported; one that always bears on the far side needs no remark.
#[test]
fn a_bearing_point_that_moves_is_reported() {
    let wanders = |finding: &ContactFinding| match *finding {
        ContactFinding::BearingPointWanders {
            step,
            at,
            largest_step,
            largest_at,
        } => Some([(step, degrees(at)), (largest_step, degrees(largest_at))]),
        _ => None,
    };
    for extent in ["half", "whole"] {
        let extent = format!("analysis.model={extent}");
        let turned = solved(&joint(), &["loads.0.force.direction=[1, 0]", &extent]);
        assert_eq!(on_contacts(&turned.findings, wanders), []);
    }
    let pressed = "loads.0={ on = \"plate.left\", pressure.steps = [\"-5 MPa\", \"4 MPa\"] }";
    let pressed = solved(&joint(), &[pressed]);
    let places = [(2, 180.0), (1, 0.0)];
    assert_eq!(
        on_contacts(&pressed.findings, wanders),
        [("bushing", places), ("pin", places)]
    );
    let words = sentence(&pressed.findings[0], pressed.units);
    for place in ["θ = 180.0° in load step 2", "θ = 0.0° in load step 1"] {
        assert!(words.contains(place), "{place}: {words}");
    }
}

#[test]
fn a_wide_clearance_is_reported() {
    let wide = model(&joint(), &["bodies.pin.shape.disk.radius=4 mm"]);
    let clearance = on_contacts(&wide.findings, |finding| match *finding {
        ContactFinding::WideClearance { clearance } => Some(clearance),
        _ => None,
    });
    let [("pin", clearance)] = clearance[..] else {
        panic!("{:?}", wide.findings);
    };
    assert!((clearance - 0.2).abs() < 1e-12, "{clearance}");
}

#[test]
fn bodies_of_different_thickness_are_reported() {
    let uneven = model(&joint(), &["bodies.pin.thickness=1.5 mm"]).findings;
    let finding = ContactFinding::UnequalThickness {
        bodies: ["bushing", "pin"].map(String::from),
        thickness: [2.0, 1.5].map(Quantity::Length),
    };
    assert_eq!(uneven, [Finding::about("pin", finding)]);
    let words = sentence(&uneven[0], solved(&joint(), &[]).units);
    assert!(
        words.starts_with("Contact 'pin': 'bushing' is 2 mm thick and 'pin' 1.5 mm."),
        "{words}"
    );
}

#[test]
fn forces_that_cancel_are_nothing() {
    let whole = solved(&joint(), &["analysis.model=whole"]);
    for edge in whole.steps.iter().flat_map(|step| &step.edges) {
        assert_eq!(edge.resultant[1], 0.0);
    }
}

#[test]
fn an_end_of_contact_outside_the_fine_zone_is_reported() {
    let beyond = |finding: &ContactFinding| match *finding {
        ContactFinding::BeyondFineMesh { step, limit, .. } => Some((step, degrees(limit))),
        _ => None,
    };
    for extent in ["half", "whole"] {
        let extent = format!("analysis.model={extent}");
        let fine = ["mesh.fine_to=30 deg", "mesh.coarse_spacing=12 deg", &extent];
        assert_eq!(
            on_contacts(&solved(&joint(), &fine).findings, beyond),
            [("bushing", (2, 30.0)), ("pin", (2, 30.0))]
        );
    }
    // Contact all around has no end.
    let around = [
        "mesh.fine_to=30 deg",
        "mesh.coarse_spacing=12 deg",
        "bodies.bushing.shape.plate_with_hole.outline.ring.radius=7.05 mm",
        "contacts.0.interference=true",
    ];
    let around = solved(&joint(), &around);
    let names: Vec<&str> = (on_contacts(&around.findings, beyond).into_iter())
        .map(|(name, _)| name)
        .collect();
    assert_eq!(names, ["pin"]);
}

#[test]
fn a_bushing_without_friction_is_said_to_turn_freely() {
    let smooth = [
        "contacts.0.friction.coulomb.mu=0",
        "contacts.1.friction.coulomb.mu=0",
    ];
    let whole = solved(&joint(), &[&smooth[..], &["analysis.model=whole"]].concat());
    let bushing = FreeBody {
        body: "bushing".into(),
        motion: FreeMotion::Rotation,
        contacts: ["bushing", "pin"].map(String::from).into(),
    };
    assert_eq!(free_bodies(&whole.findings)[0], &bushing);
    // Symmetry holds it, and so does friction on either side.
    let half = solved(&joint(), &smooth);
    assert!(free_bodies(&half.findings).is_empty());
    let rubbing = ["analysis.model=whole", "analysis.substeps=8"];
    let rubbing = solved(&joint(), &rubbing).findings;
    assert_eq!(
        rubbing,
        [
            // The other solver would take more work than comparisons may.
            Finding::NoOtherSolver {
                too_dear: vec![1, 2, 3],
                limit: 1e9,
                unsolved: Vec::new(),
            },
            Finding::FreeTogether {
                bodies: ["bushing", "pin", "plate"].map(String::from).into(),
                motions: vec![FreeMotion::Rotation],
            },
        ]
    );
}

/// A coefficient beyond the estimate of the bound of uniqueness is reported once, with the step in which contact is largest.
#[test]
fn friction_beyond_its_estimated_bound_is_reported() {
    let bounds = |findings: &[Finding]| -> Vec<UniquenessBound> {
        let taken = findings.iter().map(|finding| match *finding {
            Finding::NearUniquenessBound(bound) => Some(bound),
            _ => None,
        });
        taken.flatten().collect()
    };
    let high = [0, 1].map(|pair| format!("contacts.{pair}.friction.coulomb.mu=3"));
    let changes: Vec<&str> = high.iter().map(String::as_str).collect();
    let run = solved(&joint(), &changes);
    let [bound] = bounds(&run.findings)[..] else {
        panic!("{:?}", run.findings);
    };
    assert_eq!((bound.step, bound.solutions), (2, None));
    assert!((bound.friction - 3.0).abs() < 1e-9 && bound.estimate < 3.0);
    let estimated: Vec<bool> = run
        .steps
        .iter()
        .map(|step| step.notes.uniqueness.is_some())
        .collect();
    assert_eq!(estimated, [false, true, false]);
    assert!(
        run.steps
            .iter()
            .all(|step| (step.notes.friction - 3.0).abs() < 1e-9)
    );
    assert!(bounds(&solved(&joint(), &[]).findings).is_empty());
}

/// The status iteration cycles on a pin with friction of 0.2; the solver that takes over says so in one line.
#[test]
fn solvers_that_failed_on_the_way_are_reported() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes/pin-benchmark.toml");
    let changes = [
        "analysis.solver=status",
        "mesh.spacing=9 deg",
        "contacts.0.friction.coulomb.mu=0.2",
        "output.fields=none",
    ];
    let run = results(&Scene::from_file(&path, &changes, HOST).unwrap());
    let taken = run.findings.iter().filter_map(|finding| match finding {
        Finding::FurtherSolvers(found) => Some(found),
        _ => None,
    });
    let [found] = taken.collect::<Vec<_>>()[..] else {
        panic!("{:?}", run.findings);
    };
    assert_eq!(
        (found.failed[0].solver, found.failed[0].reason),
        ("status iteration", "cycled")
    );
    assert!(found.cycle.is_some_and(|cycle| cycle.period > 1));
    let mut cycles = run.steps.iter().filter_map(|step| {
        let cycle = step.notes.recovery.first_cycle.as_ref()?;
        Some((cycle.points.len(), step.notes.cycle_places.len()))
    });
    assert!(cycles.all(|(points, places)| points == places && points > 0));
}

/// The penalty method lets bodies overlap: what it leaves of the conditions is a finding.
#[test]
fn answers_that_are_not_verified_are_reported() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes/pin-benchmark.toml");
    let coarse = ["mesh.spacing=9 deg", "output.fields=none"];
    let verified = results(&Scene::from_file(&path, &coarse, HOST).unwrap());
    let is_unverified = |finding: &&Finding| matches!(finding, Finding::Unverified { .. });
    assert_eq!(verified.findings.iter().find(is_unverified), None);

    let penalty = ["analysis.solver=penalty", "analysis.experimental=true"];
    let changes = [&coarse[..], &penalty[..]].concat();
    let run = results(&Scene::from_file(&path, &changes, HOST).unwrap());
    let Some(Finding::Unverified {
        steps,
        solvers,
        residual,
    }) = run.findings.iter().find(is_unverified)
    else {
        panic!("{:?}", run.findings);
    };
    assert_eq!(
        (steps.len(), solvers.as_slice()),
        (run.steps.len(), &["penalty"][..])
    );
    // Verified answers leave at most 1e-10, and none of the scales is less than what stands in it.
    assert!((1e-10..1.0).contains(residual), "{residual}");
}

/// A plate that turns freely about its pin under a load that one node bears: its normal turns with the strains, and no statuses balance it to rounding. That is an answer
/// with a residual, and not the end.
#[test]
fn a_load_that_one_node_bears_is_answered_with_its_residual() {
    let found = solved(
        r#"
version = 1
analysis = { kinematics = "deformed-gaps", contact_nodes = 31, substeps = 1 }
materials.plate.orthotropic = { e1 = "70 GPa", e2 = "64 GPa", g12 = "25.9 GPa", nu12 = 0.3, angle = "16 deg" }
materials.pin.isotropic = { young = "74.6 GPa", poisson = 0.31 }
bodies.pin = { material = "pin", thickness = "2 mm", shape.disk.radius = "4.893 mm" }
[bodies.plate]
material = "plate"
thickness = "2 mm"
[bodies.plate.shape.plate_with_hole]
hole_radius = "5 mm"
outline.strip = { half_width = "18 mm", left = "26 mm", right = "29 mm" }
[[contacts]]
first = "plate.hole"
second = "pin.rim"
friction.coulomb = { mu = 0.44 }
[[supports]]
on = "pin.centre"
fix = ["x", "y"]
[[loads]]
on = "plate.left"
force = { direction = [-1, 0], steps = ["0.5 N"] }
[output]
fields = "none"
figures = false
"#,
        &[],
    );
    let unverified = found.findings.iter().find_map(|finding| match finding {
        Finding::Unverified { residual, .. } => Some(*residual),
        _ => None,
    });
    assert!(
        (1e-10..1e-6).contains(&unverified.unwrap()),
        "{unverified:?}"
    );
    let force = found.steps[0].edges[0].normal_force;
    assert!((force - 0.5).abs() < 1e-6, "{force}");
}

/// A soft pin in a hole, with the numbers of a scene that random trials found.
fn pressed_pin(spacing: &str, loads: &str) -> String {
    format!(
        r#"
version = 1
[materials.plate.orthotropic]
e1 = "200 GPa"
e2 = "50 GPa"
e3 = "50 GPa"
g12 = "10 GPa"
nu12 = 0.1
nu13 = 0.1
nu23 = 0.1
expansion2 = "8e-5 1/K"
[materials.pin.isotropic]
young = "10 GPa"
poisson = 0.03
[bodies.plate]
material = "plate"
thickness = "0.8 mm"
[bodies.plate.shape.plate_with_hole]
hole_radius = "3.133 mm"
outline.strip = {{ half_width = "6 mm", left = "20 mm", right = "9 mm" }}
[bodies.pin]
material = "pin"
thickness = "0.8 mm"
shape.disk = {{ radius = "3.12546827 mm" }}
[mesh]
spacing = "{spacing}"
[[contacts]]
first = "plate.hole"
second = "pin.rim"
friction.coulomb = {{ mu = 0.3 }}
[[supports]]
on = "pin.centre"
fix = ["x", "y"]
{loads}
[output]
fields = "none"
"#
    )
}

/// Where one point stands at its bound and all others slip the pin may turn a little: CSLIP1 is one of many, in the whole model. Symmetry
/// holds the pin of the half, and one that sticks in the other load holds itself.
#[test]
fn slip_that_friction_leaves_undetermined_is_reported() {
    let pull =
        "[[loads]]\non = \"plate.left\"\nforce = { direction = [-1, 0], steps = [\"5 N\"] }\n";
    let cooled = format!("{pull}[[loads]]\non = \"plate\"\ntemperature.steps = [\"-70 K\"]\n");
    let said = |loads: &str, model: &str| {
        let scene = pressed_pin("10 deg", loads);
        let findings = solved(&scene, &[&format!("analysis.model={model}")]).findings;
        on_contacts(&findings, |finding| {
            matches!(finding, ContactFinding::SlipUndetermined { .. }).then_some(())
        })
        .len()
    };
    assert_eq!(said(&cooled, "whole"), 1);
    assert_eq!(said(&cooled, "half"), 0);
    assert_eq!(said(pull, "whole"), 0);
}

/// A modulus in MPa that was meant in GPa.
#[test]
fn strains_that_no_elasticity_describes_are_said() {
    let strains = |material: &str, young: &str| -> Vec<(String, f64)> {
        let material = format!(
            "materials.{material}={{ isotropic = {{ young = \"{young}\", poisson = 0.33 }} }}"
        );
        let results = solved(PIN, &[&material, "mesh.spacing=6 deg"]);
        let found = results.findings.into_iter().filter_map(|own| match own {
            Finding::LargeStrains { body, strain, .. } => Some((body, strain)),
            _ => None,
        });
        found.collect()
    };
    assert_eq!(strains("aluminium", "72 GPa"), []);
    for (material, softened) in [("aluminium", "plate"), ("steel", "pin")] {
        let found = strains(material, "72 MPa");
        let [(body, strain)] = &found[..] else {
            panic!("one body of {found:?}")
        };
        assert!(body == softened && *strain > 0.2, "{body} {strain}");
    }
}
