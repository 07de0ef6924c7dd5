//! Joints followed to their failure by scenes.

use std::path::Path;

use stickslip::results::{ProgressiveEnd, ProgressiveFailure};
use stickslip::run::run;
use stickslip::scene::Scene;

/// The ready scene `name` with further `overrides`.
fn scene(name: &str, overrides: &[&str]) -> Scene {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes");
    Scene::from_file(&folder.join(name), overrides).unwrap()
}

fn followed(name: &str) -> ProgressiveFailure {
    let results = run(&scene(name, &[]), &mut |_| {}).unwrap();
    results.failure[0].progressive.clone().unwrap()
}

#[test]
fn each_ready_joint_fails_in_its_mode() {
    for (name, mode) in [
        ("joint-bearing.toml", "bearing"),
        ("joint-shear-out.toml", "shear-out"),
        ("joint-net-tension.toml", "net tension"),
    ] {
        let joint = followed(name);
        let first = joint.first().unwrap();
        println!(
            "{name}: {:?}, first ply {:.0} N, peak {:.0} N, {} increments",
            joint.mode.as_ref().unwrap().mode,
            first.load,
            joint.peak_load(),
            joint.curve.len()
        );
        assert_eq!(joint.mode.as_ref().unwrap().mode.name(), mode, "{name}");
        assert_eq!(joint.strength, Some(joint.peak_load()));
        assert!(first.load < joint.peak_load());
        let fibre = joint.first_fibre().unwrap();
        assert!(fibre.load < 1.006 * joint.peak_load(), "{name}: {fibre:?}");
        assert!(joint.mode.as_ref().unwrap().reasons.len() >= 2);
        // Without failure the joint is stiffer, and its curve ends at the same load.
        let [displacement, load] = *joint.linear.as_ref().unwrap().curve.last().unwrap();
        let peak = joint.curve[joint.peak];
        assert!((load / peak.load - 1.0).abs() < 1e-9);
        assert!(displacement <= peak.displacement);
    }
}

/// The scene `name` with plies that flow.
fn flowing(name: &str, hardening: &str, end: &str) -> ProgressiveFailure {
    let model =
        format!("failure.progressive.model={{plasticity={{hardening=\"{hardening} MPa\"}}}}");
    let end = format!("failure.progressive.control.displacement.end=\"{end} mm\"");
    let results = run(&scene(name, &[&model, &end]), &mut |_| {}).unwrap();
    results.failure[0].progressive.clone().unwrap()
}

#[test]
fn flowing_plies_part_from_the_linear_ones_where_the_mode_has_its_place() {
    for (name, end, [low, high]) in [
        ("joint-shear-out.toml", "-0.15", [45.0, 85.0]),
        ("joint-net-tension.toml", "-0.1", [75.0, 105.0]),
    ] {
        let joint = flowing(name, "100", end);
        assert!(joint.losses.iter().all(|loss| loss.mode.is_none()) && joint.mode.is_none());
        let ranges = joint.departures(0.1);
        println!("{name}: {ranges:?}");
        assert!(!ranges.is_empty());
        for angle in ranges.concat().into_iter().map(f64::to_degrees) {
            assert!((low..high).contains(&angle), "{name}: {angle}");
        }
        assert!(
            joint
                .curve
                .windows(2)
                .all(|pair| pair[1].dissipated >= pair[0].dissipated)
        );
        assert_eq!(joint.strength, None);
    }
}

#[test]
fn a_harder_ply_bears_more_and_departs_less() {
    let [soft, hard] = ["100", "2000"].map(|h| flowing("joint-net-tension.toml", h, "-0.15"));
    assert!(hard.peak_load() > soft.peak_load());
    let width = |joint: &ProgressiveFailure| -> f64 {
        joint
            .departures(0.1)
            .iter()
            .map(|[from, to]| to - from)
            .sum()
    };
    assert!(width(&hard) < width(&soft));
}

#[test]
fn given_loads_end_at_the_strength_that_the_drive_finds() {
    let coarse = "mesh.spacing=\"11.25 deg\"";
    let driven = run(&scene("joint-net-tension.toml", &[coarse]), &mut |_| {}).unwrap();
    let control = "failure.progressive.control={loads={increments=20}}";
    let steps = "loads.0.force.steps=[\"1500 N\"]";
    let loaded = scene("joint-net-tension.toml", &[coarse, control, steps]);
    let loaded = run(&loaded, &mut |_| {}).unwrap();
    let [driven, loaded] =
        [driven, loaded].map(|results| results.failure[0].progressive.clone().unwrap());
    let [by_drive, by_load] = [&driven, &loaded].map(|joint| joint.strength.unwrap());
    println!("{by_drive} N driven, {by_load} N loaded");
    // An increment of 75 N is cut to a 256th; the drive resolves its peak to 0.1 %.
    assert!(
        (by_load / by_drive - 1.0).abs() < 0.02,
        "{by_load} {by_drive}"
    );
    // The collapse under the load is that of the drive.
    for joint in [&driven, &loaded] {
        assert_eq!(joint.mode.as_ref().unwrap().mode.name(), "net tension");
    }
    assert!(matches!(loaded.end, ProgressiveEnd::NoEquilibrium(_)));
}

/// With a pin without clearance all is linear up to the first failure, whose load goes with the strengths, those with the root of the
/// energies, as long as none reaches the ply's own.
#[test]
fn first_failure_goes_with_the_root_of_fracture_energies() {
    let first = |energy: f64| {
        let band = [
            "fibre_tension",
            "fibre_compression",
            "matrix_tension",
            "matrix_compression",
            "shear",
        ]
        .map(|name| format!("{name}=\"{energy} J/m2\""))
        .join(",");
        let band = format!("failure.progressive.crack_band={{{band}}}");
        let overrides = [
            "mesh.spacing=\"11.25 deg\"",
            "bodies.pin.shape.disk.radius=\"3 mm\"",
            &band,
        ];
        let results = run(&scene("joint-net-tension.toml", &overrides), &mut |_| {}).unwrap();
        let joint = results.failure[0].progressive.clone().unwrap();
        assert!(joint.model.contains("strengths by fracture energies"));
        joint.first().unwrap().load
    };
    let ratio = first(8.0) / first(2.0);
    assert!((ratio - 2.0).abs() < 0.01, "{ratio}");
}

#[test]
fn energies_beyond_a_cells_leave_the_own_strength_and_say_so() {
    let coarse = "mesh.spacing=\"11.25 deg\"";
    let band = "failure.progressive.crack_band={fibre_tension=\"90 kJ/m2\"}";
    let [plain, tough] = [&[coarse][..], &[coarse, band][..]].map(|overrides| {
        let results = run(&scene("joint-net-tension.toml", overrides), &mut |_| {}).unwrap();
        results.failure[0].progressive.clone().unwrap()
    });
    assert_eq!(plain.peak_load(), tough.peak_load());
    assert!(
        tough.model.contains("some keep the ply's own"),
        "{}",
        tough.model
    );
}

#[test]
fn a_joint_pulled_the_wrong_way_is_refused() {
    let coarse = "mesh.spacing=\"22.5 deg\"";
    let loads = [
        coarse,
        "failure.progressive.control={loads={increments=4}}",
        "loads.0.force.direction=[1,0]",
    ];
    let error = run(&scene("joint-net-tension.toml", &loads), &mut |_| {}).unwrap_err();
    assert!(
        error
            .to_string()
            .contains("turn the load or the drive round"),
        "{error}"
    );
}
