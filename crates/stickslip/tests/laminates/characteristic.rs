//! Failure at a distance from the hole.

use stickslip::results::JointMode;
use stickslip::run::{self, RunError};

use super::{PIN, close, scene, solved};

const CURVE: &str = "failure.characteristic={ tension = \"1 mm\", compression = \"2 mm\" }";

#[test]
fn the_curve_is_at_least_as_weak_as_its_ends_and_not_weaker_than_the_body() {
    let results = solved(PIN, &[CURVE, "mesh.spacing=3 deg"]);
    let failure = &results.failure[0];
    let found = failure.characteristic.as_ref().unwrap();
    for k in 0..failure.criteria.len() {
        let curve = found.curve[k].as_ref().unwrap();
        let ends = [&found.net_section[k], &found.bearing_point[k]];
        for end in ends {
            assert!(curve.first.factor <= end.as_ref().unwrap().factor);
        }
        let body = failure.first_ply[k].as_ref().unwrap();
        assert!(body.factor <= curve.first.factor);
    }
    // 6 mm beside the hole's centre and 7 mm before it.
    let at = found.net_section[0].as_ref().unwrap().at.position;
    assert!(at[0].abs() < 1e-12);
    close(at[1].abs(), 6.0, 1e-12);
    let at = found.bearing_point[0].as_ref().unwrap().at.position;
    assert_eq!(at, [7.0, 0.0]);
}

/// The closer the end of the plate, the more the pin shears a strip out of it; the narrower the plate, the more its section is torn.
#[test]
fn narrow_plates_tear() {
    let fibres = "failure.criteria=[\"yamada_sun\"]";
    let narrow = "bodies.plate.shape.plate_with_hole.outline.strip.half_width=8 mm";
    let results = solved(PIN, &[CURVE, fibres, narrow, "mesh.spacing=3 deg"]);
    let found = results.failure[0].characteristic.as_ref().unwrap();
    let joint = found.curve[0].as_ref().unwrap();
    assert_eq!(joint.mode, JointMode::NetTension);
    let wide = "bodies.plate.shape.plate_with_hole.outline.strip={ half_width = \"40 mm\", left = \"80 mm\", right = \"40 mm\" }";
    let layup = "materials.laminate.laminate.layup=[±45/±45]s";
    let turned = solved(PIN, &[CURVE, fibres, wide, layup, "mesh.spacing=3 deg"]);
    let found = turned.failure[0].characteristic.as_ref().unwrap();
    assert_ne!(found.curve[0].as_ref().unwrap().mode, JointMode::NetTension);
}

#[test]
fn a_curve_that_leaves_the_body_is_refused() {
    let far = "failure.characteristic={ tension = \"16 mm\", compression = \"2 mm\" }";
    let error = run::run(&scene(PIN, &[far]), &mut |_| {}).unwrap_err();
    assert!(matches!(error, RunError::Model(_)));
    let text = error.to_string();
    assert!(
        text.contains("16 mm") && text.contains("leaves body 'plate'"),
        "{text}"
    );
}
