//! Bolts with clearance beside others that bear before them.

use std::fmt::Write as _;

use stickslip::results::Results;

use super::rows::{long_plate, slides};
use super::{HEAD, slice};
use crate::solved;

/// Largest load of [`lap`] `[N]`.
const LOAD: f64 = 12e3;

/// A double lap of two bolts with clearances of 10 and 50 µm, symmetric about the load.
fn lap() -> String {
    let mut text = HEAD.replace("6 deg", "10 deg").replace(
        "[\"1 kN\", \"3 kN\", \"0.5 kN\"]",
        "[\"2 kN\", \"6 kN\", \"12 kN\"]",
    );
    let plates = [
        ("lower", 2.5, [-18.0, 72.0]),
        ("pulled", 4.0, [-48.0, 42.0]),
        ("upper", 2.5, [-18.0, 72.0]),
    ];
    for (name, thickness, range) in plates {
        text += &long_plate(name, thickness, range, &[0.0, 24.0]);
    }
    for (bolt, clearance) in [0.01, 0.05].into_iter().enumerate() {
        for (layer, (plate, thickness, _)) in plates.iter().enumerate() {
            let name = format!("s{bolt}-{layer}");
            text += &slice(&name, *thickness, &format!("{plate}.h{bolt}"), clearance);
        }
        let _ = write!(
            text,
            "[fasteners.f{bolt}]\nslices = [\"s{bolt}-0\", \"s{bolt}-1\", \"s{bolt}-2\"]\nsprings.beam = {{ head = \"clamped\", nut = \"clamped\" }}\n"
        );
    }
    text + &slides("lower") + &slides("upper")
}

/// Force of the pulled plate on the second bolt at the end `[N]`.
fn second(results: &Results) -> [f64; 2] {
    results.steps.last().unwrap().fasteners[1].layers[1].force
}

/// A bolt that bears late hung anywhere in its clearance before, stuck there beside the line of the load, and bore 8.1 to 10.4 % by the number
/// of increments, with a force across of either sign.
#[test]
fn a_loose_bolt_does_not_drift_across_the_load() {
    let text = lap();
    let of = |changes: &[&str]| second(&solved(&text, changes));
    let fine = of(&["analysis.substeps=12"]);
    for changes in [
        &["analysis.substeps=1"][..],
        &["analysis.substeps=2"],
        &["analysis.substeps=5"],
        &["analysis.substeps=2", "analysis.solver=gauss_seidel"],
    ] {
        let [along, across] = of(changes);
        assert!(across.abs() < 1e-5 * LOAD, "{changes:?}: {across}");
        assert!(
            (along - fine[0]).abs() < 1e-3 * LOAD,
            "{changes:?}: {along} {fine:?}"
        );
    }
}
