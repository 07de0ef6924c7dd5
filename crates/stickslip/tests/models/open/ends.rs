//! What lies at the ends of a contact, and edges of several curves in a mesh from a file.

use std::fs;

use stickslip::results::{ContactFinding, Finding, LadderEnd, Results, Stated};
use tempfile::TempDir;

use super::{PUNCH, close, edge, stacked};
use crate::{results, scene_in, solved};

/// The scene of the rounded punch with other edges of the punch.
fn punch(outline: &str) -> String {
    let (head, tail) = PUNCH.split_once("[bodies.punch.shape.outline]").unwrap();
    let (_, tail) = tail.split_once("[mesh]").unwrap();
    format!("{head}[bodies.punch.shape.outline]\n{outline}\n[mesh]{tail}")
}

/// A punch of 2 mm with corners of 90°.
fn square() -> String {
    punch(
        r#"start = ["-1 mm", "0 mm"]
edges = [
  { name = "face", to = ["1 mm", "0 mm"], refine = 80 },
  { name = "right", to = ["1 mm", "4 mm"] },
  { name = "top", to = ["-1 mm", "4 mm"] },
  { name = "left" },
]"#,
    )
}

/// The places at which corners press, and whether edges cease to face each other where both bodies go on.
fn ends(results: &Results) -> (usize, bool) {
    let (mut corners, mut beyond) = (0, false);
    for own in &results.findings {
        let Finding::Contact { finding, .. } = own else {
            continue;
        };
        match finding {
            ContactFinding::NoLimitAtCorner { at, .. } => corners += at.len(),
            ContactFinding::BeyondFacing { .. } => beyond = true,
            _ => {}
        }
    }
    (corners, beyond)
}

/// The largest pressure of the rounded punch, 63.98 MPa, is off by a quarter where two nodes carry it, and by half a percent where seven do.
#[test]
fn a_peak_on_few_nodes_is_reported() {
    let solved = |refine: u32| {
        let text = PUNCH.replace("refine = 160", &format!("refine = {refine}"));
        let pressed = [
            "analysis.accuracy=5 %",
            "loads.0.force.steps=[\"73.8556 N\"]",
            "loads.1.force.steps=[\"0 N\"]",
        ];
        solved(&text, &pressed)
    };
    let fewest = |results: &Results| {
        results.findings.iter().find_map(|own| match own {
            Finding::Contact {
                finding: ContactFinding::PeakUnresolved { nodes, .. },
                ..
            } => Some(*nodes),
            _ => None,
        })
    };
    let peak = |results: &Results| edge(results, 0).peak_pressure.unwrap().0;
    let (coarse, fine) = (solved(10), solved(40));
    assert!(fewest(&coarse).is_some_and(|nodes| nodes < 5));
    assert_eq!(fewest(&fine), None);
    assert!((peak(&coarse) / 63.98 - 1.0).abs() > 0.1);
    close(peak(&fine), 63.98, 0.01);
    let error = |results: &Results| edge(results, 0).errors.get(Stated::PeakPressure);
    assert_eq!(error(&coarse), None);
    assert!(error(&fine).is_some());
    // What is not known is not reached, whatever the errors of other numbers.
    let end = |results: &Results| results.ladder.as_ref().unwrap().end;
    let hardly = "analysis.accuracy=50 %";
    let text = PUNCH.replace("refine = 160", "refine = 10");
    assert_eq!(end(&crate::solved(&text, &[hardly])), LadderEnd::Pinned);
    assert_eq!(end(&crate::solved(PUNCH, &[hardly])), LadderEnd::Reached);
}

#[test]
fn corners_that_press_have_no_limit() {
    let text = square();
    let results = solved(&text, &[]);
    assert_eq!(ends(&results), (2, false));
    assert_eq!(edge(&results, 0).peak_hoop_uncertainty, None);
    // In either order of the bodies.
    let swapped = [
        r#"contacts.0.first="block.top""#,
        r#"contacts.0.second="punch.face""#,
    ];
    assert_eq!(ends(&solved(&text, &swapped)), (2, false));
    // A rounded one has none, nor have two bodies that end at the same places.
    assert_eq!(ends(&solved(PUNCH, &[])), (0, false));
    let same = stacked(
        r#"{ name = "face", to = ["0 mm", "0 mm"] }"#,
        r#"{ name = "face", to = ["10 mm", "0 mm"] }"#,
    );
    assert_eq!(ends(&solved(&same, &[])), (0, false));
}

/// Nor has the largest stress of the bodies there, which grows with every division.
#[test]
fn stresses_of_bodies_at_pressed_corners_have_no_error() {
    let fields = ["output.fields=last", "analysis.accuracy=20 %"];
    let errors = |text: &str| {
        let results = solved(text, &fields);
        let step = results.steps.last().unwrap();
        assert_eq!(step.stresses.len(), 2);
        let own = step.stresses.iter();
        own.map(|own| own.least_principal.error.is_some())
            .collect::<Vec<_>>()
    };
    assert_eq!(errors(&square()), [false, false]);
    assert_eq!(errors(PUNCH), [true, true]);
}

/// Half a block on a wide rigid floor: its corner has a bounded pressure on a smooth floor, and is none of the whole body where it lies on the line of symmetry.
#[test]
fn corners_whose_pressure_is_bounded_are_none() {
    let floor = r#"[bodies.lower]
rigid = true
shape.outline = { start = ["-40 mm", "-6 mm"], edges = [{ name = "bottom", to = ["40 mm", "-6 mm"] }, { name = "right", to = ["40 mm", "0 mm"] }, { name = "face", to = ["-40 mm", "0 mm"] }, { name = "left" }] }
"#;
    let text = stacked("", r#"{ name = "face", to = ["10 mm", "0 mm"] }"#);
    let (head, tail) = text.split_once("[bodies.lower]").unwrap();
    let (_, upper) = tail.split_once("[bodies.upper]").unwrap();
    let (upper, _) = upper.split_once("[[supports]]").unwrap();
    let rest = r#"[[supports]]
on = "lower.bottom"
fix = ["x", "y"]
[[supports]]
on = "upper.left"
fix = ["x"]
[[loads]]
on = "upper.top"
pressure.steps = ["5 MPa"]
"#;
    let text = format!("{head}{floor}[bodies.upper]{upper}{rest}");
    let smooth = solved(&text, &[]);
    assert_eq!(ends(&smooth), (0, false));
    for row in &edge(&smooth, 0).rows {
        close(row.pressure, 5.0, 1e-9);
    }
    // With friction the free corner alone has none; the other is on the line of symmetry.
    assert_eq!(
        ends(&solved(&text, &["contacts.0.friction.coulomb.mu=0.3"])),
        (1, false)
    );
}

#[test]
fn no_error_is_stated_for_what_has_no_limit() {
    let results = solved(&square(), &["analysis.accuracy=\"5 %\""]);
    for step in 0..3 {
        let errors = &edge(&results, step).errors;
        assert!(
            errors
                .get(stickslip::results::Stated::PeakPressure)
                .is_none()
        );
        assert!(
            errors
                .get(stickslip::results::Stated::NormalForce)
                .is_some()
        );
    }
}

/// All points of the flat stick, so nothing but rounding moves there, and its ends are no corners.
#[test]
fn an_edge_that_goes_on_under_another_name_is_reported() {
    let mut text = PUNCH.to_owned();
    for (to, name) in [("-1.6", "a"), ("-1 ", "b"), ("1.6", "c"), ("41", "d")] {
        let own = format!("{{ name = \"face\", to = [\"{to}");
        let own = own.trim_end().to_owned();
        text = text.replacen(&own, &own.replace("face", name), 1);
    }
    let results = solved(&text, &[]);
    assert_eq!(ends(&results), (0, true));
    close(edge(&results, 0).resultant[1], 73.8556, 1e-6);
}

/// A punch of flat and arcs as a file: the edge of several curves is these, and its mid nodes need not be on them.
#[test]
fn a_punch_of_a_file_is_that_of_its_outline() {
    let own = solved(PUNCH, &[]);
    let body = own.bodies.iter().find(|body| body.name == "punch").unwrap();
    let text = stickslip_mesh_files::write_msh(body.mesh.as_deref().unwrap()).unwrap();
    let folder = TempDir::new().unwrap();
    fs::write(folder.path().join("punch.msh"), text).unwrap();
    let (head, tail) = PUNCH.split_once("[bodies.punch.shape.outline]").unwrap();
    let (_, tail) = tail.split_once("[mesh]").unwrap();
    let text = format!(
        "{head}[bodies.punch.shape.mesh]\nfile = \"punch.msh\"\nunit = \"mm\"\n[mesh]{tail}"
    );
    let found = results(&scene_in(folder.path(), &text, &[]));
    for step in 0..3 {
        let [a, b] = [&found, &own].map(|results| edge(results, step));
        close(a.peak_pressure.unwrap().0, b.peak_pressure.unwrap().0, 1e-6);
        close(
            a.contact_half_extent.unwrap(),
            b.contact_half_extent.unwrap(),
            1e-6,
        );
    }
}

/// A punch with corners of 1 mm on cells of 3 mm, whose last cell under a corner faces it in part: wherever it stands, its flat touches whole.
#[test]
fn cells_that_face_an_edge_in_part_are_kept() {
    let text = punch(
        r#"start = ["-6 mm", "1 mm"]
edges = [
  { name = "face", to = ["-5 mm", "0 mm"], through = ["-5.70710678 mm", "0.29289322 mm"], refine = 60 },
  { name = "face", to = ["5 mm", "0 mm"], refine = 20 },
  { name = "face", to = ["6 mm", "1 mm"], through = ["5.70710678 mm", "0.29289322 mm"], refine = 60 },
  { name = "right", to = ["6 mm", "15 mm"] },
  { name = "top", to = ["-6 mm", "15 mm"] },
  { name = "left" },
]"#,
    );
    for x in [-16, -15, -14, 15] {
        let place = format!(r#"bodies.punch.position=["{x} mm", "0 mm"]"#);
        let cells = [
            "mesh.spacing=\"3 mm\"",
            "bodies.block.shape.outline.edges.3.refine=4.0",
        ];
        let results = solved(&text, &[&cells[..], &[place.as_str()]].concat());
        assert_eq!(ends(&results), (0, false), "at {x}");
        let pressed = edge(&results, 0);
        close(pressed.contact_half_extent.unwrap(), 5.03, 0.01);
        // 73.86 N on some 10 mm: 7.3 MPa on average, and some 20 times that where a part is lost.
        assert!(pressed.peak_pressure.unwrap().0 < 150.0, "at {x}");
    }
}
