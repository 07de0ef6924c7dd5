//! The errors that Hertz's problem keeps on fine meshes are those of blocks that end where the half-plane goes on.

use stickslip_contact::Chain;
use stickslip_fem_core::mesh::ElementKind;
use stickslip_laboratory::references::line_contact;
use stickslip_laboratory::{Pairing, Path, Problem, run};

/// Error of the peak pressure under `part` of the load, whose half-width is √part of the whole one.
fn error(part: f64, spacing: f64) -> f64 {
    let overrides = [format!("loads.0.force.steps=[\"{} N\"]", 500.0 * part)];
    let scene = Problem::Hertz
        .build_with(spacing, ElementKind::Q8, Pairing::NodePairs, &overrides)
        .unwrap();
    let results = run(&scene, Path::Condensed(&Chain::default()))
        .unwrap()
        .results;
    let (peak, _) = results.steps[0].edges[0].peak_pressure.unwrap();
    peak / (part.sqrt() * line_contact::PEAK) - 1.0
}

/// What the errors on two meshes tend to at second order.
fn limit(part: f64, coarse: f64) -> f64 {
    (4.0 * error(part, 0.5 * coarse) - error(part, coarse)) / 3.0
}

#[test]
fn what_is_left_on_fine_meshes_falls_with_the_square_of_the_half_width() {
    let (whole, half) = (limit(1.0, 0.08), limit(0.25, 0.04));
    let known = Problem::Hertz.known().peak_pressure;
    assert!(whole > 0.5 * known && whole < known, "{whole:.2e}");
    let ratio = whole / half;
    assert!((3.5..4.5).contains(&ratio), "{whole:.2e} over {half:.2e}");
}
