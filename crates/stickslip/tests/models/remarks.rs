//! Remarks on scenes that are right but surprise.

use std::path::Path;

use stickslip::host::HOST;
use stickslip::scene::Scene;

use super::{BUSHING, model, results, solved};

/// The notes on a run that have this part.
fn told(changes: &[&str], part: &str) -> Vec<String> {
    let notes = solved(BUSHING, changes).notes;
    notes
        .into_iter()
        .filter(|note| note.contains(part))
        .collect()
}

#[test]
fn a_plain_joint_needs_no_remark() {
    assert_eq!(solved(BUSHING, &[]).notes, Vec::<String>::new());
}

/// A contact that bears on one side and then on the other is reported; one that always bears on the far side needs no remark.
#[test]
fn a_bearing_point_that_wanders_is_told() {
    let part = "The bearing point of contact";
    for extent in ["half", "whole"] {
        let extent = format!("analysis.model={extent}");
        let turned = told(&["loads.0.force.direction=[1, 0]", &extent], part);
        assert_eq!(turned, Vec::<String>::new());
    }
    let pressed = "loads.0={ on = \"plate.left\", pressure.steps = [\"-5 MPa\", \"4 MPa\"] }";
    let pressed = told(&[pressed], part);
    assert_eq!(pressed.len(), 2, "{pressed:?}");
    for (note, name) in pressed.iter().zip(["'bushing'", "'pin'"]) {
        let where_to = "it is at θ = 180.0° in load step 2 and at θ = 0.0° in load step 1";
        assert!(note.contains(name) && note.contains(where_to), "{note}");
    }
}

#[test]
fn a_wide_clearance_is_told() {
    let wide = model(BUSHING, &["bodies.pin.shape.disk.radius=4 mm"]);
    assert!(
        wide.notes[0].contains("the clearance is 20 % of the hole's radius"),
        "{:?}",
        wide.notes
    );
}

#[test]
fn bodies_of_different_thickness_are_told() {
    let uneven = model(BUSHING, &["bodies.pin.thickness=1.5 mm"]).notes;
    assert_eq!(uneven.len(), 1, "{uneven:?}");
    assert!(
        uneven[0].starts_with("Contact 'pin': 'bushing' is 2 mm thick and 'pin' 1.5 mm."),
        "{uneven:?}"
    );
}

#[test]
fn forces_that_cancel_are_nothing() {
    let whole = solved(BUSHING, &["analysis.model=whole"]);
    for edge in whole.steps.iter().flat_map(|step| &step.edges) {
        assert_eq!(edge.resultant[1], 0.0);
    }
}

#[test]
fn an_end_of_contact_outside_the_fine_zone_is_told() {
    let part = "beyond the fine part of its mesh, which ends at ±30.0°";
    for extent in ["half", "whole"] {
        let extent = format!("analysis.model={extent}");
        let fine = ["mesh.fine_to=30 deg", "mesh.coarse_spacing=12 deg", &extent];
        let notes = told(&fine, part);
        assert_eq!(notes.len(), 2, "{notes:?}");
        assert!(
            notes.iter().all(|note| note.contains("in load step 2")),
            "{notes:?}"
        );
    }
    // Contact all around has no end.
    let around = [
        "mesh.fine_to=30 deg",
        "mesh.coarse_spacing=12 deg",
        "bodies.bushing.shape.plate_with_hole.outline.ring.radius=7.05 mm",
        "contacts.0.interference=true",
    ];
    let notes = told(&around, part);
    assert!(notes.len() == 1 && notes[0].contains("'pin'"), "{notes:?}");
}

#[test]
fn a_bushing_without_friction_is_said_to_turn_freely() {
    let smooth = [
        "contacts.0.friction.coulomb.mu=0",
        "contacts.1.friction.coulomb.mu=0",
    ];
    let part = "Body 'bushing' can turn freely: its rotation and CSLIP1";
    let whole = told(&[&smooth[..], &["analysis.model=whole"]].concat(), part);
    assert_eq!(whole.len(), 1, "{whole:?}");
    assert!(whole[0].contains("are not unique"), "{whole:?}");
    // Symmetry holds it, and so does friction on either side.
    assert!(told(&smooth, "can turn freely").is_empty());
    let rubbing = solved(BUSHING, &["analysis.model=whole"]).notes;
    let begins = |part: &str| rubbing.iter().filter(|note| note.starts_with(part)).count();
    let moving =
        begins("Nothing holds 'bushing', 'pin' and 'plate' against turning or sliding together");
    // The other solver would take more work than comparisons may.
    let dear = begins("Whether another solver finds another answer is not known");
    assert_eq!([moving, dear, rubbing.len()], [1, 1, 2], "{rubbing:?}");
}

/// A coefficient beyond the estimate of the bound of uniqueness is told once, with the step in which contact is largest.
#[test]
fn friction_beyond_its_estimated_bound_is_told() {
    let part = "the estimate of the coefficient of friction up to which load step 2";
    let high = [0, 1].map(|pair| format!("contacts.{pair}.friction.coulomb.mu=3"));
    let changes: Vec<&str> = high.iter().map(String::as_str).collect();
    let notes = told(&changes, part);
    assert_eq!(notes.len(), 1, "{notes:?}");
    assert!(
        notes[0].contains("Friction of up to 3.000 is beyond"),
        "{notes:?}"
    );
    assert!(notes[0].contains("they were not enumerated"), "{notes:?}");
    let run = solved(BUSHING, &changes);
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
    assert!(told(&[], part).is_empty());
}

/// The status iteration cycles on a pin with friction of 0.2; the solver that takes over says so in one line.
#[test]
fn solvers_that_failed_on_the_way_are_told() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes/pin-benchmark.toml");
    let changes = [
        "analysis.solver=status",
        "mesh.spacing=9 deg",
        "contacts.0.friction.coulomb.mu=0.2",
        "output.fields=none",
    ];
    let run = results(&Scene::from_file(&path, &changes, HOST).unwrap());
    let part = "More than the first solver was needed in load step";
    let notes: Vec<&String> = run
        .notes
        .iter()
        .filter(|note| note.contains(part))
        .collect();
    assert_eq!(notes.len(), 1, "{:?}", run.notes);
    assert!(
        notes[0].contains("status iteration: cycled (×"),
        "{notes:?}"
    );
    assert!(notes[0].contains("repeated with period"), "{notes:?}");
    let mut cycles = run.steps.iter().filter_map(|step| {
        let cycle = step.notes.recovery.first_cycle.as_ref()?;
        Some((cycle.points.len(), step.notes.cycle_places.len()))
    });
    assert!(cycles.all(|(points, places)| points == places && points > 0));
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
fn slip_that_friction_leaves_undetermined_is_told() {
    let pull =
        "[[loads]]\non = \"plate.left\"\nforce = { direction = [-1, 0], steps = [\"5 N\"] }\n";
    let cooled = format!("{pull}[[loads]]\non = \"plate\"\ntemperature.steps = [\"-70 K\"]\n");
    let said = |loads: &str, model: &str| {
        let scene = pressed_pin("10 deg", loads);
        let notes = solved(&scene, &[&format!("analysis.model={model}")]).notes;
        let about = |note: &&String| note.contains("slip in a range has the same friction");
        notes.iter().filter(about).count()
    };
    assert_eq!(said(&cooled, "whole"), 1);
    assert_eq!(said(&cooled, "half"), 0);
    assert_eq!(said(pull, "whole"), 0);
}
