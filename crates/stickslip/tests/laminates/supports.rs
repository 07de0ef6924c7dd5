//! Clamped corners, where the mesh decides what the stress is.

use super::{COUPON, PIN, close, read, scene, solved};

use stickslip::results::Results;
use stickslip::run;

/// A coupon that is clamped at one end and pulled at the other, on cells of the size `cell`.
fn clamped(cell: &str, more: &[&str]) -> Results {
    let spacing = format!("mesh.spacing={cell}");
    let mut changes = vec!["supports.0.fix=[\"x\", \"y\"]", spacing.as_str()];
    changes.extend(more);
    solved(COUPON, &changes)
}

fn factor(results: &Results) -> f64 {
    results.failure[0].first_ply[0].as_ref().unwrap().factor
}

#[test]
fn a_clamped_corner_is_not_the_first_ply() {
    let meshes = ["2 mm", "1 mm", "0.5 mm"];
    let everywhere = meshes.map(|cell| clamped(cell, &["failure.clear_of_supports=0 mm"]));
    let clear = meshes.map(|cell| clamped(cell, &[]));
    for (results, clear) in everywhere.iter().zip(&clear) {
        let failure = &results.failure[0];
        let [x, y] = failure.first_ply[0].as_ref().unwrap().at.position;
        let (corner, other) = ((x.abs() - 30.0).abs(), ((y + 10.0).abs() - 10.0).abs());
        assert!(corner < 1e-9 && other < 1e-9, "{x} {y}");
        let place = clear.failure[0].first_ply[0].as_ref().unwrap().at.position;
        // 5 % of the coupon's width of 20 mm.
        assert!((place[0] - x).hypot(place[1] - y) > 1.0, "{place:?}");
        let beside = clear.failure[0].beside_supports.as_ref().unwrap();
        close(1.0, beside.distance, 1e-12);
        let hidden = beside.sooner[0].as_ref().unwrap();
        close(factor(results), hidden.factor, 1e-12);
        assert_eq!(hidden.at.position, [x, y]);
        assert!(hidden.load.is_some());
    }
    let [coarse, middle, fine] = everywhere.each_ref().map(factor);
    println!(
        "everywhere {coarse} {middle} {fine}, clear {:?}",
        clear.each_ref().map(factor)
    );
    assert!(middle < 0.97 * coarse && fine < 0.97 * middle);
    let [_, middle, fine] = clear.each_ref().map(factor);
    close(middle, fine, 0.02);
}

#[test]
fn halves_leave_out_what_wholes_do() {
    let clamp = "platens=[{ on = \"plate.right\", free = [] }]";
    let with = |model: &str| solved(PIN, &[clamp, model, "loads.0.force.steps=[\"2 kN\"]"]);
    let half = with("analysis.model=half");
    let whole = with("analysis.model=whole");
    let [one, other] = [&half, &whole].map(|results| &results.failure[0]);
    let [left, right] = [one, other].map(|failure| failure.beside_supports.as_ref().unwrap());
    // 5 % of a width of 40 mm; the end on the line of symmetry is no end.
    close(2.0, left.distance, 1e-12);
    close(2.0, right.distance, 1e-12);
    for (a, b) in one.steps.iter().flatten().zip(other.steps.iter().flatten()) {
        close(a.reserve_factor, b.reserve_factor, 1e-7);
    }
    let sooner = |found: &[Option<_>]| found.iter().map(Option::is_some).collect::<Vec<_>>();
    assert_eq!(sooner(&left.sooner), sooner(&right.sooner));
    // A pin that is held at its centre is no laminate, and the plate is held by nothing else.
    assert!(solved(PIN, &[]).failure[0].beside_supports.is_none());
}

#[test]
fn distances_that_leave_nothing_are_refused() {
    let negative = read(COUPON, &["failure.clear_of_supports=-1 mm"]).unwrap_err();
    assert!(negative.to_string().contains("clear_of_supports = -1 mm"));
    let all = scene(COUPON, &["failure.clear_of_supports=1 m"]);
    let error = run::run(&all, &mut |_| {}).unwrap_err().to_string();
    assert!(
        error.contains("coupon") && error.contains("1000 mm"),
        "{error}"
    );
}
