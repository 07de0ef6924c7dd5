//! Remarks on scenes that are right but surprise.

use stickslip::model::beyond_fine_zone;
use stickslip_contact::Status;
use stickslip_contact::zones::Zone;

use super::{BUSHING, model, scene};

#[test]
fn a_load_that_bears_at_the_far_side_is_told() {
    assert!(model(BUSHING, &[]).notes.is_empty());
    let turned = model(BUSHING, &["loads.0.force.direction=[1, 0]"]);
    assert_eq!(turned.notes.len(), 2);
    for (note, parts) in turned.notes.iter().zip([
        [
            "plate.hole and bushing.outer",
            "θ = 180°, where they are 0.02 mm apart",
        ],
        [
            "bushing.hole and pin.rim",
            "θ = 180°, where they are 0.04 mm apart",
        ],
    ]) {
        assert!(parts.iter().all(|part| note.contains(part)), "{note}");
    }
    let pressed = model(
        BUSHING,
        &["loads.0={ on = \"plate.left\", pressure.steps = [\"-5 MPa\", \"5 MPa\"] }"],
    );
    assert!(
        pressed.notes[0].contains("of 1 load steps, first 2"),
        "{:?}",
        pressed.notes
    );
    let pulled = "supports.1={ on = \"plate.left\", fix = [\"x\"], displacement = \"0.1 mm\" }";
    let moved = model(BUSHING, &[pulled, "loads.0.force.direction=[0, 1]"]);
    assert_eq!(moved.notes.len(), 2, "{:?}", moved.notes);
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
fn an_end_of_contact_outside_the_fine_zone_is_told() {
    let fine = ["mesh.fine_to=60 deg", "mesh.coarse_spacing=12 deg"];
    let (scene, model) = (scene(BUSHING, &fine), model(BUSHING, &fine));
    let edge = &model.edges[1].geometry;
    let zones = |end: f64| {
        let end = end.to_radians();
        let zone = |status, start, end| Zone { status, start, end };
        [
            zone(Status::Stick, 0.0, end),
            zone(Status::Open, end, std::f64::consts::PI),
        ]
    };
    let note = |ends: &[f64]| {
        let all: Vec<_> = ends.iter().map(|end| zones(*end)).collect();
        let steps: Vec<&[Zone]> = all.iter().map(|zones| &zones[..]).collect();
        beyond_fine_zone(&scene, edge, &steps)
    };
    assert_eq!(note(&[10.0, 59.9, 20.0]), None);
    let told = note(&[10.0, 75.0, 62.0]).unwrap();
    assert!(
        told.contains("'pin' ends at ±75.0° in load step 2") && told.contains("±60.0°"),
        "{told}"
    );
    // Contact all around has no end.
    let around = [Zone {
        status: Status::Stick,
        start: 0.0,
        end: std::f64::consts::PI,
    }];
    assert_eq!(beyond_fine_zone(&scene, edge, &[&around]), None);
}
