//! Half-planes in closed form: beside Hertz, Cattaneo and Mindlin, beside finite elements, and beside themselves mirrored.

use std::path::Path;

use stickslip::model::Model;
use stickslip::results::{ContactFinding, Finding, LadderEnd, Results, Stated};
use stickslip::scene::{Format, Scene};

use super::{difference, solved};

const FRETTING: &str = include_str!("../../../../scenes/fretting-half-planes.toml");

const HALF_WIDTH: f64 = 0.880_936_48;
const PEAK: f64 = 36.133_126;
const FRICTION: f64 = 0.4;

/// The number `stated` of step `step` with its error.
fn number(results: &Results, step: usize, stated: Stated) -> [f64; 2] {
    let edge = &results.steps[step].edges[0];
    let error = edge.errors.get(stated);
    [stated.value(edge).unwrap(), error.unwrap_or(f64::NAN)]
}

fn steps(values: [f64; 2]) -> String {
    format!(
        r#"loads.1.force.steps=["{} N", "{} N"]"#,
        values[0], values[1]
    )
}

const PRESSED: &str = r#"loads.0.force.steps=["50 N", "50 N"]"#;

#[test]
fn errors_hold_the_closed_forms_of_partial_slip() {
    for (part, accuracy) in [(0.5, "1 %"), (0.15, "2 %"), (-0.8, "0.5 %"), (0.97, "5 %")] {
        let push = steps([0.0, part * FRICTION * 50.0]);
        let accuracy = format!("analysis.accuracy=\"{accuracy}\"");
        let found = solved(FRETTING, &[PRESSED, &push, &accuracy]);
        let reached = found.ladder.as_ref().unwrap().end;
        assert_eq!(reached, LadderEnd::Reached, "{part}");
        let slips = f64::abs(part);
        for (stated, exact) in [
            (Stated::PeakPressure, PEAK),
            (Stated::ContactExtent, HALF_WIDTH),
            (Stated::StickExtent, HALF_WIDTH * (1.0 - slips).sqrt()),
            (Stated::PeakHoop, 2.0 * FRICTION * PEAK * slips.sqrt()),
        ] {
            let [value, error] = number(&found, 1, stated);
            assert!(
                (value - exact).abs() <= error,
                "{part} {stated:?}: {value} ± {error:e}, exactly {exact}"
            );
            assert!(error < 0.2 * exact, "{part} {stated:?} ± {error:e}");
        }
    }
}

/// Slip beside the ends of contact that no node of coarse models shows.
#[test]
fn errors_hold_the_stress_of_a_small_push() {
    for part in [0.0005, 0.002, 0.01] {
        let push = steps([0.0, part * FRICTION * 50.0]);
        let found = solved(FRETTING, &[PRESSED, &push, "analysis.accuracy=\"5 %\""]);
        let [value, error] = number(&found, 1, Stated::PeakHoop);
        let exact = 2.0 * FRICTION * PEAK * f64::sqrt(part);
        assert!(
            (value - exact).abs() <= error,
            "{part}: {value} ± {error:e}, exactly {exact}"
        );
    }
}

#[test]
fn the_push_to_the_other_side_is_the_mirror_image() {
    let found = solved(FRETTING, &[PRESSED, &steps([0.0, 10.0])]);
    let mirrored = solved(FRETTING, &[PRESSED, &steps([0.0, -10.0])]);
    let rows = |results: &Results| results.steps[1].edges[0].rows.clone();
    let (one, mut other) = (rows(&found), rows(&mirrored));
    other.reverse();
    let close = |a: f64, b: f64| (a - b).abs() < 1e-8 * PEAK;
    for (a, b) in one.iter().zip(&other) {
        assert!(close(a.pressure, b.pressure) && close(a.shear, -b.shear));
        assert!(close(a.sigma_tangential, b.sigma_tangential));
    }
}

#[test]
fn a_contact_much_smaller_than_the_outline_is_found() {
    let load = r#"loads.0.force.steps=["5e-5 N", "5e-5 N"]"#;
    let found = solved(FRETTING, &[load, &steps([0.0, 0.0])]);
    // The half-width goes with the root of the load.
    let [extent, error] = number(&found, 1, Stated::ContactExtent);
    assert!((extent - 1e-3 * HALF_WIDTH).abs() <= error);
    let [peak, error] = number(&found, 1, Stated::PeakPressure);
    assert!((peak - 1e-3 * PEAK).abs() <= error && error < 1e-2 * peak);
}

#[test]
fn half_of_a_symmetric_contact_is_the_whole() {
    let changes = [
        PRESSED,
        "loads.1.force.direction=[0, -1]",
        r#"loads.1.force.steps=["10 N", "-20 N"]"#,
        r#"bodies.flat.material="steel""#,
        "materials.steel.isotropic.young=210 GPa",
        "materials.steel.isotropic.poisson=0.3",
        "mesh.spacing=0.05 mm",
        "mesh.fine_to=1.2 mm",
        "analysis.accuracy=\"5 %\"",
    ];
    let half = solved(FRETTING, &changes);
    let whole = solved(
        FRETTING,
        &[&changes[..], &["analysis.model=whole"]].concat(),
    );
    assert!(half.edges[0].half && !whole.edges[0].half);
    let of = |results: &Results, stated: Stated| -> Vec<f64> {
        let steps = 0..results.steps.len();
        steps.map(|step| number(results, step, stated)[0]).collect()
    };
    for stated in [Stated::PeakPressure, Stated::NormalForce] {
        let apart = difference(of(&half, stated), of(&whole, stated));
        assert!(apart < 1e-9, "{stated:?} {apart:e}");
    }
    // Like bodies stick, and what they slip is rounding.
    for work in [&half, &whole].map(|results| of(results, Stated::FrictionWork)) {
        assert!(work.iter().all(|work| work.abs() < 1e-12), "{work:?}");
    }
}

/// Unlike materials slip when they are pressed. Elements of a wide outline leave some thousandths, 0.4 (a/d)² of the peak pressure and their spacing of
/// a/44, and stress that the outline adds along the edge, 0.47 P/td.
#[test]
fn elements_of_a_wide_outline_agree() {
    let changes = [
        r#"loads.0.force.steps=["20 N", "50 N", "15 N"]"#,
        r#"loads.1.force.steps=["0 N", "5 N", "-2 N"]"#,
        r#"bodies.flat.material="steel""#,
        "materials.steel.isotropic.young=210 GPa",
        "materials.steel.isotropic.poisson=0.3",
        r#"bodies.flat.shape.block={ half_length = "25 mm", depth = "25 mm" }"#,
        r#"bodies.cylinder.shape.cylinder={ radius = "500 mm", half_length = "25 mm", depth = "25 mm" }"#,
        "mesh.spacing=0.02 mm",
        "mesh.fine_to=1 mm",
        "analysis.substeps=4",
        "contacts.0.friction.coulomb.mu=0.2",
        r#"output.fields="none""#,
    ];
    let plain: Vec<&str> = changes.to_vec();
    let text = FRETTING.replace("accuracy = \"1 %\"\n", "");
    let closed = solved(&text, &plain);
    let elements = [
        "bodies.flat.model=elements",
        "bodies.cylinder.model=elements",
    ];
    let elements = solved(&text, &[&plain[..], &elements].concat());
    assert!(closed.factorisations == 0 && elements.factorisations == 2);
    for (stated, bound) in [
        (Stated::PeakPressure, 2e-3),
        (Stated::NormalForce, 1e-10),
        (Stated::FrictionForce, 5e-3),
        (Stated::HoopAtBearing, 2e-2),
    ] {
        let of = |results: &Results| -> Vec<f64> {
            let steps = 0..results.steps.len();
            steps.map(|step| number(results, step, stated)[0]).collect()
        };
        let apart = difference(of(&closed), of(&elements));
        assert!(apart < bound, "{stated:?} {apart:e}");
    }
}

#[test]
fn what_the_outline_changes_is_said() {
    let found = solved(FRETTING, &[PRESSED, &steps([0.0, 0.0])]);
    let outline = found.findings.iter().find_map(|finding| match finding {
        Finding::Contact {
            finding:
                ContactFinding::OutlineLeftOut {
                    reach,
                    size,
                    radius: Some(radius),
                    ..
                },
            ..
        } => Some([reach, size, radius].map(|own| own.value())),
        _ => None,
    });
    let [reach, size, radius] = outline.unwrap();
    assert!((radius / 500.0 - 1.0).abs() < 1e-3, "{radius}");
    assert!((reach - HALF_WIDTH).abs() < 1e-2 && (size - 4.0).abs() < 1e-12);
}

#[test]
fn what_is_no_half_plane_is_refused() {
    let refused = |changes: &[&str]| {
        let scene = Scene::from_text(FRETTING, Format::Toml, "f.toml", Path::new(""), changes);
        match scene {
            Ok(scene) => Model::build(&scene).unwrap_err().to_string(),
            Err(why) => why.to_string(),
        }
    };
    for (changes, why) in [
        (vec!["platens=[]"], "it is free to turn"),
        (vec!["supports.0.on=flat.left"], "held on its edge 'left'"),
        (
            vec!["loads.1.on=cylinder.contact"],
            "forces on a half-plane act far away",
        ),
        (
            vec![
                r#"supports=[{ on = "flat.bottom", fix = ["y"], displacement = "0.1 mm" }, { on = "flat.bottom", fix = ["x"] }]"#,
            ],
            "moved by its support",
        ),
        (
            vec!["bodies.flat.model=series"],
            "which model = \"half-plane\" can be",
        ),
        (
            vec!["bodies.flat.model=elements"],
            "a half-plane touches half-planes",
        ),
        (
            vec!["contacts.0.projection=mortar"],
            "pairs of nodes; leave projection out",
        ),
        (vec!["contacts.0.gap=faceted"], "have no facets"),
        (
            vec!["bodies.flat.mesh.spacing=0.02 mm"],
            "tied by pairs of nodes, but",
        ),
        (
            vec![r#"edges=[{ on = "flat.bottom" }]"#],
            "is an edge that a half-plane does not have",
        ),
        (vec!["analysis.contact_nodes=61"], "touch along a line"),
        (
            vec!["analysis.kinematics=deformed-gaps"],
            "undeformed geometry",
        ),
        (
            vec![
                "materials.ply.orthotropic.e1=100 GPa",
                "materials.ply.orthotropic.e2=10 GPa",
                "materials.ply.orthotropic.nu12=0.3",
                "materials.ply.orthotropic.g12=5 GPa",
                "analysis.plane=stress",
                "bodies.flat.material=ply",
            ],
            "is not isotropic",
        ),
        (
            vec![
                r#"platens.0.free=["y"]"#,
                "loads.1.force.direction=[0, -1]",
                "analysis.model=whole",
            ],
            "is held along x, and so is its partner",
        ),
    ] {
        let found = refused(&changes);
        assert!(found.contains(why), "{changes:?}: {found}");
    }
    let pin = super::series::PIN.replace(
        "material = \"steel\"",
        "model = \"half-plane\"\nmaterial = \"steel\"",
    );
    let scene = Scene::from_text(&pin, Format::Toml, "p.toml", Path::new(""), &[""; 0]);
    let why = scene.unwrap_err().to_string();
    assert!(why.contains("for a block or a cylinder"), "{why}");
}
