//! Plates in several layers, joined by fasteners whose slices springs couple.

mod loose;
mod lumped;
mod rows;

use std::fmt::Write as _;

use stickslip::results::{Finding, Results};
use stickslip_contact::nalgebra::{DMatrix, DVector};

use super::{difference, model, solved, tractions};

/// Radius of the shanks with clearance `[mm]`.
const RADIUS: f64 = 2.99;

/// A plate around the origin, pulled or held at one side.
fn strip(name: &str, thickness: f64, [left, right]: [f64; 2]) -> String {
    format!(
        r#"
[bodies.{name}]
material = "aluminium"
thickness = "{thickness} mm"
shape.plate_with_hole = {{ hole_radius = "3 mm", outline.strip = {{ half_width = "12 mm", left = "{left} mm", right = "{right} mm" }} }}
"#
    )
}

/// A disk of 3 mm less `clearance` in `hole`.
fn slice(name: &str, thickness: f64, hole: &str, clearance: f64) -> String {
    let radius = 3.0 - clearance;
    format!(
        r#"
[bodies.{name}]
material = "steel"
thickness = "{thickness} mm"
shape.disk.radius = "{radius} mm"
[[contacts]]
first = "{hole}"
second = "{name}.rim"
friction.coulomb = {{ mu = 0.2 }}
"#
    )
}

/// What all scenes have, in front of their bodies.
const HEAD: &str = r#"
version = 1
[materials.aluminium.isotropic]
young = "72 GPa"
poisson = 0.33
[materials.steel.isotropic]
young = "210 GPa"
poisson = 0.3
[analysis]
model = "whole"
[mesh]
spacing = "6 deg"
[output]
fields = "none"
figures = false
[[loads]]
on = "pulled.left"
force = { direction = [-1, 0], steps = ["1 kN", "3 kN", "0.5 kN"] }
"#;

/// A plate pulled at its left side and one held at its right, on a fastener with `springs`.
fn single_lap(springs: &str, clearance: f64) -> String {
    let mut text = HEAD.to_owned();
    text += &strip("pulled", 3.0, [40.0, 20.0]);
    text += &strip("held", 4.0, [20.0, 40.0]);
    text += &slice("one", 3.0, "pulled.hole", clearance);
    text += &slice("two", 4.0, "held.hole", clearance);
    let _ = write!(
        text,
        "[fasteners.bolt]\nslices = [\"one\", \"two\"]\nsprings.{springs}\n[[supports]]\non = \"held.right\"\nfix = [\"x\", \"y\"]\n"
    );
    text
}

/// A middle plate pulled between a lower and an upper one, `thicknesses` from below.
fn double_lap(springs: &str, thicknesses: [f64; 3]) -> String {
    let [lower, middle, upper] = thicknesses;
    let mut text = HEAD.to_owned();
    text += &strip("pulled", middle, [40.0, 20.0]);
    for (name, thickness) in [("lower", lower), ("upper", upper)] {
        text += &strip(name, thickness, [20.0, 40.0]);
        let _ = write!(
            text,
            "[[supports]]\non = \"{name}.right\"\nfix = [\"x\", \"y\"]\n"
        );
    }
    for (name, thickness, plate) in [
        ("one", lower, "lower"),
        ("two", middle, "pulled"),
        ("three", upper, "upper"),
    ] {
        text += &slice(name, thickness, &format!("{plate}.hole"), 0.01);
    }
    let _ = write!(
        text,
        "[fasteners.bolt]\nslices = [\"one\", \"two\", \"three\"]\nsprings.{springs}\n"
    );
    text
}

fn edge_of(results: &Results, name: &str) -> usize {
    let mut edges = results.edges.iter();
    edges.position(|edge| edge.name == name).unwrap()
}

fn is_balanced(results: &Results) {
    for step in &results.steps {
        assert!(step.balance_residual < 1e-9, "{:e}", step.balance_residual);
    }
}

/// A pin held over its section, and the same pin on a plate that holds it: contact does not know the difference.
#[test]
fn a_rigid_fastener_is_the_single_pin() {
    let mut alone = HEAD.to_owned();
    alone += &strip("pulled", 3.0, [40.0, 20.0]);
    alone += &slice("one", 3.0, "pulled.hole", 0.01);
    alone += "[[supports]]\non = \"one.section\"\nfix = [\"x\", \"y\"]\n";
    let alone = solved(&alone, &[]);
    for changes in [&[][..], &["bodies.one.model=series"]] {
        let joined = solved(&single_lap("rigid = {}", 0.01), changes);
        is_balanced(&joined);
        let edge = edge_of(&joined, "one");
        for (alone, joined) in alone.steps.iter().zip(&joined.steps) {
            let apart = difference(
                tractions(&alone.edges[0].rows),
                tractions(&joined.edges[edge].rows),
            );
            // A series is another discretisation of the disk.
            let near = if changes.is_empty() { 1e-9 } else { 2e-2 };
            assert!(apart < near, "{apart:e} {changes:?}");
            let layers = &joined.fasteners[0].layers;
            let turn = layers[0].displacement[0] - layers[1].displacement[0];
            assert!(turn.abs() < 1e-12, "{turn:e}");
        }
    }
}

/// Slices move apart by force times compliance, whatever contact does around them.
#[test]
fn a_spring_of_two_layers_gives_by_its_force() {
    let springs = "given = { force = \"1 kN\", displacements = [\"0.02 mm\"] }";
    for changes in [
        &[][..],
        &["bodies.one.model=series", "bodies.two.model=series"],
    ] {
        let results = solved(&single_lap(springs, 0.01), changes);
        is_balanced(&results);
        for (step, force) in results.steps.iter().zip([1e3, 3e3, 0.5e3]) {
            let [first, second] = step.fasteners[0].layers[..] else {
                panic!("{:?}", step.fasteners);
            };
            assert!((first.force[0] + force).abs() < 1e-8 * force, "{first:?}");
            assert!((second.force[0] - force).abs() < 1e-8 * force, "{second:?}");
            let apart = first.displacement[0] - second.displacement[0];
            assert!((apart + 0.02e-3 * force).abs() < 1e-10, "{apart}");
            // The layers' middles are 3.5 mm apart.
            let [moment, across] = step.fasteners[0].tilting;
            assert!((moment - 3.5 * force).abs() < 1e-7 * force, "{moment}");
            assert!(across.abs() < 1e-6 * force, "{across}");
        }
        let eccentric = |finding: &Finding| matches!(finding, Finding::EccentricLayers { .. });
        assert!(results.findings.iter().any(eccentric));
    }
}

#[test]
fn a_symmetric_double_lap_loads_both_sides_alike() {
    for springs in [
        "beam = {}",
        "beam = { head = \"clamped\", nut = \"clamped\" }",
        "rigid = {}",
    ] {
        let results = solved(&double_lap(springs, [2.5, 4.0, 2.5]), &[]);
        is_balanced(&results);
        for (step, force) in results.steps.iter().zip([1e3, 3e3, 0.5e3]) {
            let fastener = &step.fasteners[0];
            for (layer, wanted) in fastener.layers.iter().zip([0.5, -1.0, 0.5]) {
                let apart = layer.force[0] - wanted * force;
                assert!(apart.abs() < 1e-6 * force, "{springs}: {layer:?}");
            }
            assert!(fastener.tilting[0].abs() < 1e-5 * force, "{fastener:?}");
        }
        let eccentric = |finding: &Finding| matches!(finding, Finding::EccentricLayers { .. });
        assert!(!results.findings.iter().any(eccentric), "{springs}");
    }
}

/// A shank that may tilt shares the load by its levers; one that may not by the stiffness of what it joins.
#[test]
fn a_free_shank_balances_its_moments() {
    let lever = |springs: &str| {
        let results = solved(&double_lap(springs, [2.0, 4.0, 5.0]), &[]);
        is_balanced(&results);
        results.steps[1].fasteners[0].clone()
    };
    let free = lever("beam = {}");
    // Middles at 1, 4 and 8.5 mm.
    let lower = 3e3 * (8.5 - 4.0) / (8.5 - 1.0);
    let force = free.layers[0].force[0];
    assert!((force - lower).abs() < 1e-7 * lower, "{force} {lower}");
    assert!(free.tilting[0].abs() < 1e-7 * 3e3, "{free:?}");
    let clamped = lever("beam = { head = \"clamped\" }");
    let force = clamped.layers[0].force[0];
    assert!(force < 0.95 * lower && force > 0.2 * lower, "{clamped:?}");
}

/// Mean displacements of the layers of a Timoshenko beam of linear elements with one integration point each, under even loads `forces` on layers.
fn beam_by_elements(thicknesses: &[f64], forces: &[f64], clamped: [bool; 2]) -> Vec<f64> {
    const CELLS: usize = 60;
    let (young, poisson, radius) = (210_000.0, 0.3, RADIUS);
    let area = std::f64::consts::PI * radius * radius;
    let bending = young * area * radius * radius / 4.0;
    let shear = 0.9 * young / (2.0 * (1.0 + poisson)) * area;
    let nodes = CELLS * thicknesses.len() + 1;
    let mut stiffness = DMatrix::<f64>::zeros(2 * nodes, 2 * nodes);
    let mut load = DVector::<f64>::zeros(2 * nodes);
    for (layer, (thickness, force)) in thicknesses.iter().zip(forces).enumerate() {
        let size = thickness / CELLS as f64;
        for cell in 0..CELLS {
            let at = 2 * (CELLS * layer + cell);
            let slope = [-1.0 / size, -0.5, 1.0 / size, -0.5];
            let curvature = [0.0, -1.0 / size, 0.0, 1.0 / size];
            for i in 0..4 {
                for j in 0..4 {
                    stiffness[(at + i, at + j)] += size
                        * (shear * slope[i] * slope[j] + bending * curvature[i] * curvature[j]);
                }
            }
            load[at] += 0.5 * force / CELLS as f64;
            load[at + 2] += 0.5 * force / CELLS as f64;
        }
    }
    // Loads balance, so one point may be held; a shank with free ends may tilt, and balances moments.
    let mut held = vec![0];
    if clamped[0] || !clamped[1] {
        held.push(1);
    }
    if clamped[1] {
        held.push(2 * nodes - 1);
    }
    for &unknown in &held {
        stiffness.row_mut(unknown).fill(0.0);
        stiffness.column_mut(unknown).fill(0.0);
        stiffness[(unknown, unknown)] = 1.0;
        load[unknown] = 0.0;
    }
    let moved = stiffness.lu().solve(&load).unwrap();
    let mean = |layer: usize| {
        let cells = CELLS * layer..CELLS * (layer + 1);
        cells
            .map(|cell| (moved[2 * cell] + moved[2 * cell + 2]) / (2 * CELLS) as f64)
            .sum()
    };
    (0..thicknesses.len()).map(mean).collect()
}

/// The flexibility of a model's fastener through plates of these thicknesses, along x.
fn flexibility(thicknesses: [f64; 3], ends: &str) -> DMatrix<f64> {
    let model = model(&double_lap(&format!("beam = {ends}"), thicknesses), &[]);
    let whole = &model.fasteners[0].link.flexibility;
    DMatrix::from_fn(3, 3, |i, j| whole[(3 * i, 3 * j)])
}

#[test]
fn a_shank_is_a_beam() {
    let thicknesses = [2.0, 4.0, 5.0];
    for (ends, clamped) in [
        ("{}", [false, false]),
        ("{ head = \"clamped\" }", [true, false]),
        ("{ nut = \"clamped\" }", [false, true]),
        ("{ head = \"clamped\", nut = \"clamped\" }", [true, true]),
    ] {
        // Forces that balance, and their moments too.
        let loads: &[[f64; 3]] = if clamped == [false; 2] {
            &[[4.5, -7.5, 3.0]]
        } else {
            &[[1.0, -1.0, 0.0], [0.0, -1.0, 1.0]]
        };
        let own = flexibility(thicknesses, ends);
        for load in loads {
            let found = &own * DVector::from_row_slice(load);
            let wanted = beam_by_elements(&thicknesses, load, clamped);
            // Both count from a point of their own, and with free ends from a tilt.
            let shape = |moved: &[f64]| {
                let [first, second, third] = moved else {
                    panic!("{moved:?}");
                };
                match clamped {
                    [false, false] => vec![(second - first) / 3.0 - (third - second) / 4.5],
                    _ => vec![second - first, third - second],
                }
            };
            let (found, wanted) = (shape(found.as_slice()), shape(&wanted));
            // Elements of a sixtieth of a layer converge with the square of their size.
            let apart = difference(wanted.iter().copied(), found.iter().copied());
            assert!(apart < 1e-3, "{ends} {load:?}: {found:?} {wanted:?}");
        }
    }
}

/// A force P on the middle plate moves it against the outer ones, of thickness s beside its t, by
/// P (2s + t) / 12κGA and P (24s³ + 60s²t + 40st² + 8t³) / 960EI with free ends, (32s³ + 80s²t + 40st² + 4t³) / 2880EI with clamped ones.
#[test]
fn a_symmetric_shank_has_a_closed_form() {
    let (s, t) = (2.5_f64, 4.0_f64);
    let (young, area) = (210_000.0, std::f64::consts::PI * RADIUS * RADIUS);
    let (shear, inertia) = (young / 2.6, area * RADIUS * RADIUS / 4.0);
    let by_shear = (2.0 * s + t) / (12.0 * 0.9 * shear * area);
    let free = (24.0 * s.powi(3) + 60.0 * s * s * t + 40.0 * s * t * t + 8.0 * t.powi(3)) / 960.0;
    let clamped =
        (32.0 * s.powi(3) + 80.0 * s * s * t + 40.0 * s * t * t + 4.0 * t.powi(3)) / 2880.0;
    for (ends, bending) in [
        ("{}", free),
        ("{ head = \"clamped\", nut = \"clamped\" }", clamped),
    ] {
        let own = flexibility([s, t, s], ends);
        let load = DVector::from_row_slice(&[-0.5, 1.0, -0.5]);
        let found = load.dot(&(&own * &load));
        let wanted = by_shear + bending / (young * inertia);
        assert!(
            (found / wanted - 1.0).abs() < 1e-12,
            "{ends}: {found} {wanted}"
        );
    }
}

#[test]
fn what_makes_no_fastener_is_refused() {
    let lap = single_lap("rigid = {}", 0.01);
    let refused = |from: &str, to: &str| {
        let text = lap.replace(from, to);
        assert_ne!(text, lap, "{from}");
        let found = stickslip::scene::Scene::from_text(
            &text,
            stickslip::scene::Format::Toml,
            "lap.toml",
            std::path::Path::new(""),
            &[] as &[&str],
        );
        found.unwrap_err().to_string()
    };
    for (from, to, part) in [
        ("[\"one\", \"two\"]", "[\"one\"]", "the single slice 'one'"),
        ("[\"one\", \"two\"]", "[]", "the fastener has no slices"),
        ("[\"one\", \"two\"]", "[\"one\", \"one\"]", "named twice"),
        (
            "[\"one\", \"two\"]",
            "[\"one\", \"held\"]",
            "slices are disks",
        ),
        ("[\"one\", \"two\"]", "[\"one\", \"three\"]", "three"),
        ("rigid = {}", "beam = {}", "tilt a shank"),
        ("rigid = {}", "rigid = { clamping = \"1 kN\" }", "clamping"),
        (
            "rigid = {}",
            "given = { force = \"1 kN\", displacements = [\"1 mm\", \"1 mm\"] }",
            "2 displacements are given between 2 slices",
        ),
        (
            "[[supports]]",
            "[[supports]]\non = \"one.section\"\nfix = [\"x\"]\n[[supports]]",
            "what carries a slice",
        ),
        (
            "[analysis]",
            "[analysis]\nkinematics = \"deformed-gaps\"",
            "undeformed geometry",
        ),
    ] {
        let message = refused(from, to);
        assert!(message.contains(part), "{part}: {message}");
    }
}
