//! Rows of fasteners against bars and springs.

use std::fmt::Write as _;

use stickslip::model::Model;
use stickslip::results::{ContactFinding, Finding, PlateRows, Results};
use stickslip::run::{displacements_of, solve, solver};
use stickslip::scene::schema::SolverChoice;
use stickslip_contact::nalgebra::{DMatrix, DVector};

use super::{HEAD, is_balanced, slice};
use crate::{BUSHING, scene, solved};

/// Young's modulus of the plates `[MPa]`.
const YOUNG: f64 = 72_000.0;
/// Width of the plates `[mm]`.
const WIDTH: f64 = 24.0;
/// Thicknesses of the plates `[mm]`.
const THICKNESS: [f64; 3] = [2.5, 4.0, 2.5];
/// From the last hole to a loaded or held side, and to a free one `[mm]`.
const ENDS: [f64; 2] = [48.0, 18.0];

/// A plate of `thickness` from `from` to `to` along x with holes at `holes`.
pub(super) fn long_plate(
    name: &str,
    thickness: f64,
    [from, to]: [f64; 2],
    holes: &[f64],
) -> String {
    let mut text = format!(
        r#"
[bodies.{name}]
material = "aluminium"
thickness = "{thickness} mm"
[bodies.{name}.shape.outline]
start = ["{from} mm", "-12 mm"]
edges = [
  {{ name = "bottom", to = ["{to} mm", "-12 mm"] }},
  {{ name = "right", to = ["{to} mm", "12 mm"] }},
  {{ name = "top", to = ["{from} mm", "12 mm"] }},
  {{ name = "left" }},
]
[bodies.{name}.shape.outline.holes]
"#
    );
    for (k, x) in holes.iter().enumerate() {
        let _ = writeln!(
            text,
            "h{k} = {{ centre = [\"{x} mm\", \"0 mm\"], radius = \"3 mm\" }}"
        );
    }
    text
}

/// A tight disk without friction.
fn tight(name: &str, thickness: f64, hole: &str) -> String {
    slice(name, thickness, hole, 0.0).replace("0.2 }", "0.0 }")
}

fn head_of_rows() -> String {
    HEAD.replace("6 deg", "10 deg")
        .replace("[\"1 kN\", \"3 kN\", \"0.5 kN\"]", "[\"3 kN\"]")
}

/// Sides that slide across the load, so that plates narrow freely.
pub(super) fn slides(plate: &str) -> String {
    format!("[[supports]]\non = \"{plate}.right\"\nfix = [\"x\"]\n")
}

/// A double lap of `count` tight frictionless bolts at `pitch` with `springs`, the middle plate pulled along −x.
fn row(count: usize, pitch: f64, springs: &str) -> String {
    let mut text = head_of_rows();
    let holes: Vec<f64> = (0..count).map(|k| pitch * k as f64).collect();
    let last = holes[count - 1];
    let [far, near] = ENDS;
    let plates = ["lower", "pulled", "upper"];
    for (name, thickness) in plates.into_iter().zip(THICKNESS) {
        let range = match name {
            "pulled" => [-far, last + near],
            _ => [-near, last + far],
        };
        text += &long_plate(name, thickness, range, &holes);
    }
    for k in 0..count {
        for (layer, plate) in plates.into_iter().enumerate() {
            let name = format!("s{k}-{layer}");
            text += &tight(&name, THICKNESS[layer], &format!("{plate}.h{k}"));
        }
        let _ = write!(
            text,
            "[fasteners.f{k}]\nslices = [\"s{k}-0\", \"s{k}-1\", \"s{k}-2\"]\nsprings.{springs}\n"
        );
    }
    text + &slides("lower") + &slides("upper")
}

/// By how much the loaded side of `text` moves along the load `[mm]`.
fn stretch(text: &str) -> f64 {
    let model = Model::build(&scene(text, &[])).unwrap();
    let found = solve(&model, solver(SolverChoice::Auto).as_ref(), &mut |_| {}).unwrap();
    let mut bodies = model.bodies.iter();
    let pulled = bodies.position(|body| body.name == "pulled").unwrap();
    let moved = displacements_of(&model, &found, pulled);
    let mesh = model.bodies[pulled].elastic().unwrap().mesh();
    let side = mesh.node_set("left").unwrap();
    let total: f64 = side.iter().map(|&node| moved[0][2 * node]).sum();
    -total / side.len() as f64
}

/// Forces on the bolts of a row, as parts of the load, where plates are bars with the compliances `bars` between the bolts, of the middle plate and of the
/// others, and bolts are springs with the compliance `spring`:
///
/// ```text
/// spring (f_k+1 − f_k) + bars_0 (P − S_k) − bars_1 S_k = 0,    S_k = Σ_≤k f,    S_n = P
/// ```
fn classical(count: usize, spring: f64, bars: [f64; 2]) -> DVector<f64> {
    let mut system = DMatrix::<f64>::zeros(count, count);
    let mut side = DVector::<f64>::zeros(count);
    for k in 0..count - 1 {
        system[(k, k)] -= spring;
        system[(k, k + 1)] += spring;
        (0..=k).for_each(|j| system[(k, j)] -= bars[0] + bars[1]);
        side[k] = -bars[0];
    }
    system.row_mut(count - 1).fill(1.0);
    side[count - 1] = 1.0;
    system.lu().solve(&side).unwrap()
}

/// The largest difference of the forces on the bolts of a row from those of springs and bars, as a part of the load. The spring is what a joint of one
/// bolt has beside its bars.
fn beside_classical(count: usize, pitch: f64, springs: &str) -> f64 {
    const LOAD: f64 = 3e3;
    let bar = |thickness: f64, length: f64| length / (YOUNG * WIDTH * thickness);
    let outside = THICKNESS[0] + THICKNESS[2];
    let bars = |length: f64| [bar(THICKNESS[1], length), bar(outside, length)];
    let single = stretch(&row(1, 0.0, springs)) / LOAD;
    let spring = single - bars(ENDS[0]).iter().sum::<f64>();
    let results = solved(&row(count, pitch, springs), &[]);
    is_balanced(&results);
    let fasteners = results.steps[0].fasteners.iter();
    let found = fasteners.map(|own| -own.layers[1].force[0] / LOAD);
    let wanted = classical(count, spring, bars(pitch));
    let apart = found.zip(wanted.iter());
    apart
        .map(|(found, wanted)| (found - wanted).abs())
        .fold(0.0, f64::max)
}

/// What bars leave out, that a hole of radius a lengthens its plate of width w as 3πa²/w more of it would and that a bolt moves with the side of the hole that it
/// bears on, by 2a times the strain of what passes, is some 5 mm of a plate for each bolt; the springs give as 690 mm of it.
#[test]
fn rows_of_soft_springs_share_their_load_as_springs_and_bars() {
    let soft = "given = { force = \"1 kN\", displacements = [\"0.2 mm\", \"0.2 mm\"] }";
    for count in [2, 3, 5] {
        let apart = beside_classical(count, 96.0, soft);
        println!("soft {count}: {apart}");
        assert!(apart < 0.005, "{count}: {apart}");
    }
}

/// Bolts give as 50 mm of a plate, so that these 5 mm show, less the farther the bolts are apart.
#[test]
fn rows_of_bolts_far_apart_share_their_load_as_springs_and_bars() {
    let beam = "beam = { head = \"clamped\", nut = \"clamped\" }";
    for count in [2, 3, 5] {
        let [near, far] = [48.0, 192.0].map(|pitch| beside_classical(count, pitch, beam));
        println!("{count}: {near} {far}");
        assert!(
            near < 0.04 && far < 0.03 && far < near,
            "{count}: {near} {far}"
        );
    }
}

/// A bolt that touches nothing has no force, no bearing point and no moment, and nothing is said of the digits of its forces.
#[test]
fn a_loose_bolt_beside_tight_ones_carries_nothing() {
    let loose = (0..3).map(|layer| format!("bodies.s2-{layer}.shape.disk.radius=\"2.5 mm\""));
    let loose: Vec<String> = loose.collect();
    let changes: Vec<&str> = loose.iter().map(String::as_str).collect();
    let text = row(3, 24.0, "beam = { head = \"clamped\", nut = \"clamped\" }");
    let results = solved(&text, &changes);
    is_balanced(&results);
    let step = results.steps.last().unwrap();
    for layer in &step.fasteners[2].layers {
        assert_eq!((layer.force, layer.shear), ([0.0; 2], [0.0; 2]));
    }
    assert_eq!(step.fasteners[2].tilting, [0.0; 2]);
    for (edge, own) in results.edges.iter().zip(&step.edges) {
        let is_loose = edge.name.contains("h2") || edge.name.contains("s2");
        assert_eq!(own.normal_force == 0.0, is_loose, "{}", edge.name);
        assert_eq!(own.bearing.is_none(), is_loose, "{}", edge.name);
    }
    let kinds = |finding: &&Finding| {
        matches!(
            finding,
            Finding::Unbalanced { .. }
                | Finding::EccentricLayers { .. }
                | Finding::Contact {
                    finding: ContactFinding::Unresolved { .. }
                        | ContactFinding::BearingPointWanders { .. },
                    ..
                }
        )
    };
    let found: Vec<&Finding> = results.findings.iter().filter(kinds).collect();
    assert!(found.is_empty(), "{found:?}");
}

/// Pin and hole of a bushing lie in one place but for clearances, and are no two fasteners.
#[test]
fn a_bushing_has_no_rows() {
    let results = solved(BUSHING, &["analysis.model=whole"]);
    let circles = results.edges.iter().map(|edge| &edge.kind);
    let places: Vec<String> = circles.map(|kind| format!("{kind:?}")).collect();
    assert_eq!(results.plates_with_rows(), [], "{places:?}");
}

/// Between bolts a plate carries what those on one side of it leave, and each bolt takes the difference.
#[test]
fn bearing_and_bypass_are_the_incoming_load() {
    const LOAD: f64 = 3e3;
    let text = row(3, 24.0, "beam = { head = \"clamped\", nut = \"clamped\" }");
    let results = solved(&text, &[]);
    let plates = results.plates_with_rows();
    assert_eq!(plates.len(), 3);
    for plate in &plates {
        let layer = ["lower", "pulled", "upper"]
            .iter()
            .position(|name| *name == results.bodies[plate.body].name)
            .unwrap();
        let forces = results.row_forces(plate, 0);
        let bolts = results.steps[0].fasteners.iter();
        let bolts: Vec<f64> = bolts.map(|own| own.layers[layer].force[0].abs()).collect();
        let whole = if layer == 1 { LOAD } else { 0.5 * LOAD };
        for (k, own) in forces.iter().enumerate() {
            let beyond: f64 = if layer == 1 {
                bolts[k + 1..].iter().sum()
            } else {
                bolts[..k].iter().sum()
            };
            for (found, wanted) in [
                (own.bearing(), bolts[k]),
                (own.bypass(), beyond),
                (own.incoming(), beyond + bolts[k]),
                (own.unbalanced(), 0.0),
            ] {
                assert!(
                    (found - wanted).abs() < 1e-7 * whole,
                    "{layer} {k}: {own:?} {bolts:?}"
                );
            }
        }
    }
}

/// The strap of a butt joint, on which nothing but its two bolts acts: all of the load is bearing in both rows.
#[test]
fn a_strap_has_its_rows() {
    let mut text = head_of_rows();
    text += &long_plate("pulled", 3.0, [-48.0, 12.0], &[0.0]);
    text += &long_plate("held", 3.0, [18.0, 78.0], &[30.0]);
    text += &long_plate("strap", 4.0, [-12.0, 42.0], &[0.0, 30.0]);
    for (k, plate) in ["pulled", "held"].into_iter().enumerate() {
        text += &slice(&format!("s{k}-0"), 3.0, &format!("{plate}.h0"), 0.01);
        text += &slice(&format!("s{k}-1"), 4.0, &format!("strap.h{k}"), 0.01);
        let _ = write!(
            text,
            "[fasteners.f{k}]\nslices = [\"s{k}-0\", \"s{k}-1\"]\nsprings.rigid = {{}}\n"
        );
    }
    text += "[[supports]]\non = \"held.right\"\nfix = [\"x\", \"y\"]\n";
    let moved = ["pulled", "held", "strap"]
        .map(|plate| format!("bodies.{plate}.position=[\"-100 mm\", \"7 mm\"]"));
    let moved = moved.each_ref().map(String::as_str);
    for changes in [&[][..], &moved] {
        let found = solved(&text, changes);
        is_balanced(&found);
        let plates = found.plates_with_rows();
        let [strap] = &plates[..] else {
            panic!("{plates:?}");
        };
        assert_eq!(found.bodies[strap.body].name, "strap");
        all_bears(&found, strap);
    }
}

/// The bypass of a row is what comes into the next one, wherever the plate stands.
#[test]
fn rows_pass_their_load_on() {
    let rows = |place: f64| {
        let text = row(3, 24.0, "rigid = {}");
        let moved = ["lower", "pulled", "upper"]
            .map(|plate| format!("bodies.{plate}.position=[\"{place} mm\", \"0 mm\"]"));
        let found = solved(&text, &moved.each_ref().map(String::as_str));
        let plates = found.plates_with_rows();
        let all = plates.iter().map(|plate| found.row_forces(plate, 0));
        all.collect::<Vec<_>>()
    };
    let still = rows(0.0);
    assert_eq!(still.len(), 3);
    for (still, moved) in still.iter().zip(rows(-100.0)) {
        assert_eq!(moved.len(), 3);
        for (a, b) in still.iter().zip(&moved) {
            assert!((a.left - b.left).abs() < 1e-5 && (a.right - b.right).abs() < 1e-5);
        }
        for pair in moved.windows(2) {
            assert!((pair[0].right - pair[1].left).abs() < 1e-5, "{pair:?}");
        }
    }
}

/// Each row of a plate takes all of the load.
fn all_bears(found: &Results, strap: &PlateRows) {
    for row in found.row_forces(strap, 0) {
        let apart = [row.incoming() - 3e3, row.bearing() - 3e3, row.bypass()];
        assert!(apart.iter().all(|own| own.abs() < 1e-5), "{row:?}");
    }
}
