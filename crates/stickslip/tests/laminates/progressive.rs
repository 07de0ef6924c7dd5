//! Joints followed to their failure by scenes.

use std::path::Path;

use stickslip::host::HOST;
use stickslip::results::{EdgeStrain, JointFinding, ProgressiveEnd, ProgressiveFailure};
use stickslip::run::run;
use stickslip::scene::{Format, Scene};

/// The ready scene `name` with further `overrides`.
fn scene(name: &str, overrides: &[&str]) -> Scene {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes");
    Scene::from_file(&folder.join(name), overrides, HOST).unwrap()
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
        assert!(fibre.load <= joint.peak_load(), "{name}: {fibre:?}");
        let call = joint.mode.as_ref().unwrap();
        assert!(!call.others.contains(&call.mode));
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

/// The file gives a plastic modulus; divided by S₁₂² and multiplied again it would lose its last bit in many cases.
#[test]
fn the_hardening_stays_as_given() {
    for modulus in (1..100).map(|k| 0.7 * f64::from(k)) {
        let model =
            format!("failure.progressive.model={{plasticity={{hardening=\"{modulus:?} MPa\"}}}}");
        let scene = scene("joint-net-tension.toml", &[&model]);
        let asked = scene
            .failure
            .as_ref()
            .unwrap()
            .progressive
            .as_ref()
            .unwrap();
        let described = asked.model.parameters.describe("", &|stress| {
            assert_eq!(stress.to_bits(), modulus.to_bits());
            "the modulus".to_owned()
        });
        assert!(described.ends_with("plastic shear modulus the modulus"));
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
    assert_eq!(plain.findings, []);
    // l₀ = 2 E G/((1 − d) X²), and rows of quadratic cells are half as wide as these.
    let [e, x] = [19.1e3, 229.4].map(|ksi| 6.894_757_293 * ksi);
    let own = 2.0 * e * 90.0 / (0.99 * x * x);
    let [
        JointFinding::CrackBandIdle {
            energy: "fibre_tension",
            row_width,
            cell_size,
            largest_cell,
        },
    ] = &tough.findings[..]
    else {
        panic!("{:?}", tough.findings);
    };
    assert!(
        (row_width.value() / own - 1.0).abs() < 1e-6,
        "{row_width:?}"
    );
    assert!((cell_size.value() / row_width.value() - 2.0).abs() < 1e-9);
    assert!(largest_cell.value() < cell_size.value());
}

/// Of the energies measured on carbon–epoxy only those of the matrix lower a strength on cells of millimetres.
#[test]
fn every_energy_says_on_which_cells_it_lowers_a_strength() {
    let band = "failure.progressive.crack_band={fibre_tension=\"90 kJ/m2\",fibre_compression=\"80 kJ/m2\",\
                matrix_tension=\"0.25 kJ/m2\",matrix_compression=\"0.8 kJ/m2\"}";
    let results = run(&bypass(&["mesh.spacing=\"15 deg\"", band]), &mut |_| {}).unwrap();
    let joint = results.failure[0].progressive.as_ref().unwrap();
    let found = |name: &str| {
        joint.findings.iter().find(|finding| match finding {
            JointFinding::CrackBandIdle { energy, .. }
            | JointFinding::CrackBandPartial { energy, .. } => *energy == name,
            _ => false,
        })
    };
    for idle in ["fibre_tension", "fibre_compression"] {
        let found = found(idle);
        assert!(
            matches!(found, Some(JointFinding::CrackBandIdle { .. })),
            "{idle}: {found:?}"
        );
    }
    let partial = found("matrix_tension");
    assert!(
        matches!(partial, Some(JointFinding::CrackBandPartial { lowered_cells, cells, .. })
            if (1..*cells).contains(lowered_cells)),
        "{partial:?}"
    );
}

/// A joint with as much bypass as bearing load, under given loads, with `overrides`.
fn bypass(overrides: &[&str]) -> Scene {
    let text = include_str!("bearing-bypass.toml");
    Scene::from_text_on(
        text,
        Format::Toml,
        "bypass.toml",
        Path::new(""),
        overrides,
        HOST,
    )
    .unwrap()
}

/// Once its net section is severed the plate bears on what broken plies keep, here to 2872 N and more. Meshes of 5, 7.5 and 10° have it
/// severed at 2070, 2066 and 2247 N; this one is coarser.
#[test]
fn a_severed_net_section_ends_the_strength() {
    let results = run(&bypass(&["mesh.spacing=\"15 deg\""]), &mut |_| {}).unwrap();
    let joint = results.failure[0].progressive.as_ref().unwrap();
    let strength = joint.strength.unwrap();
    println!("{strength:.0} N, {:?}", joint.end);
    assert!((strength / 2070.0 - 1.0).abs() < 0.15, "{strength}");
    let ProgressiveEnd::NoEquilibrium(reason) = &joint.end else {
        panic!("{:?}", joint.end);
    };
    assert!(reason.contains("severed"), "{reason}");
    assert_eq!(joint.mode.as_ref().unwrap().mode.name(), "net tension");
}

/// A drive that goes on beyond the net section's last fibres ends there, and not on a load that climbs again, to 1157 N.
#[test]
fn a_drive_ends_where_the_joint_is_severed() {
    let overrides = [
        "mesh.spacing=\"11.25 deg\"",
        "failure.progressive.control.displacement.drop=1.0",
    ];
    let results = run(&scene("joint-net-tension.toml", &overrides), &mut |_| {}).unwrap();
    let joint = results.failure[0].progressive.as_ref().unwrap();
    assert_eq!(joint.end, ProgressiveEnd::Severed);
    let last = joint.curve.last().unwrap();
    assert!(last.load < 0.5 * joint.strength.unwrap());
    assert!(joint.strength.unwrap() < 900.0, "{:?}", joint.strength);
}

#[test]
fn a_drive_beside_other_loads_is_refused() {
    let drive = "failure.progressive.control={displacement={on=\"plate.left\",end=\"-0.5 mm\"}}";
    let text = include_str!("bearing-bypass.toml");
    let refused = |overrides: &[&str]| {
        let read = Scene::from_text_on(
            text,
            Format::Toml,
            "bypass.toml",
            Path::new(""),
            overrides,
            HOST,
        );
        let finding = read.unwrap_err().findings()[0].summary();
        format!("{} {}", finding.message, finding.help.unwrap_or_default())
    };
    let other = refused(&[drive]);
    for part in ["'bypass'", "plate.left", "delete loads.1", "control.loads"] {
        assert!(other.contains(part), "{part}: {other}");
    }
    // A force across the driven axis is no part of the drive either.
    let across = refused(&[drive, "loads.0.force.direction=[-1,0.1]"]);
    assert!(
        across.contains("'pull'") && across.contains("delete loads.0"),
        "{across}"
    );
    let crosswise = refused(&[
        "failure.progressive.control={displacement={on=\"plate.left\",axis=\"y\",end=\"-0.4 mm\"}}",
        "loads.1.on=\"plate.left\"",
    ]);
    assert!(crosswise.contains("axis = \"x\""), "{crosswise}");
    let moved = refused(&[
        drive,
        "loads.1.on=\"plate.left\"",
        "supports.1={on=\"plate.left\",fix=[\"y\"],displacement=\"0.1 mm\"}",
    ]);
    assert!(moved.contains("displacement of that support"), "{moved}");
}

#[test]
fn what_a_drive_replaces_and_what_has_no_effect_is_said() {
    let overrides = [
        "mesh.spacing=\"22.5 deg\"",
        "analysis.substeps=2",
        "failure.clear_of_supports=\"1 mm\"",
        "failure.progressive.control.displacement.increments=4",
    ];
    let results = run(&scene("joint-net-tension.toml", &overrides), &mut |_| {}).unwrap();
    let joint = results.failure[0].progressive.as_ref().unwrap();
    assert!(
        joint.control.ends_with(", in place of 'pull'"),
        "{}",
        joint.control
    );
    assert_eq!(
        joint.findings,
        [
            JointFinding::SubstepsIgnored,
            JointFinding::ClearOfSupportsIgnored
        ]
    );
}

/// A pin that touches at θ = 0, without loads, and is driven along y travels round the hole before it bears, whatever the increments.
#[test]
fn a_drive_passes_the_clearance_in_any_increments() {
    let load = |increments: usize| {
        let overrides = [
            "mesh.spacing=\"15 deg\"".to_owned(),
            "bodies.plate.shape.plate_with_hole.outline.strip={half_width=\"9 mm\",left=\"9 mm\",right=\"9 mm\"}"
                .to_owned(),
            "loads=[]".to_owned(),
            format!(
                "failure.progressive.control={{displacement={{on=\"plate.top\",axis=\"y\",end=\"0.06 mm\",increments={increments}}}}}"
            ),
        ];
        let overrides: Vec<&str> = overrides.iter().map(String::as_str).collect();
        let results = run(&scene("joint-net-tension.toml", &overrides), &mut |_| {}).unwrap();
        results.failure[0].progressive.as_ref().unwrap().peak_load()
    };
    let loads = [3, 7, 15, 30].map(load);
    println!("{loads:.1?} N");
    for load in loads {
        assert!((load / loads[0] - 1.0).abs() < 0.02, "{loads:?}");
    }
}

/// A drive needs no load to say where the pin bears.
#[test]
fn a_drive_alone_is_followed() {
    let changes = ["mesh.spacing=\"22.5 deg\"", "loads=[]"];
    let results = run(&scene("joint-net-tension.toml", &changes), &mut |_| {}).unwrap();
    let alone = results.failure[0].progressive.as_ref().unwrap();
    let changes = ["mesh.spacing=\"22.5 deg\""];
    let results = run(&scene("joint-net-tension.toml", &changes), &mut |_| {}).unwrap();
    let beside = results.failure[0].progressive.as_ref().unwrap();
    assert_eq!(alone.peak_load(), beside.peak_load());
}

/// Under loads the half and the whole are cut where equal numbers of plies fail on either side.
#[test]
fn under_loads_the_half_is_as_the_whole() {
    let strength = |model: &str| {
        let model = format!("analysis.model=\"{model}\"");
        let changes = [
            "mesh.spacing=\"10 deg\"",
            "failure.progressive.control={loads={increments=10}}",
            &model,
        ];
        let results = run(&scene("joint-net-tension.toml", &changes), &mut |_| {}).unwrap();
        let joint = results.failure[0].progressive.as_ref().unwrap();
        (joint.peak_load(), joint.curve.len())
    };
    let (half, whole) = (strength("half"), strength("whole"));
    println!("{half:?} {whole:?}");
    assert!((half.0 / whole.0 - 1.0).abs() < 1e-6 && half.1 == whole.1);
}

/// The turned square joint, loaded by increments.
fn turned(direction: [f64; 2], pulled: &str, angle: f64) -> ProgressiveFailure {
    let [x, y] = direction;
    let overrides = [
        "mesh.spacing=\"15 deg\"".to_owned(),
        "bodies.plate.shape.plate_with_hole.outline.strip={half_width=\"9 mm\",left=\"9 mm\",right=\"9 mm\"}"
            .to_owned(),
        format!("materials.laminate.laminate.angle=\"{angle} deg\""),
        "analysis.model=\"whole\"".to_owned(),
        format!("loads.0.on=\"plate.{pulled}\""),
        format!("loads.0.force={{direction=[{x},{y}],steps=[\"1500 N\"]}}"),
        "failure.progressive.control={loads={increments=10}}".to_owned(),
    ];
    let overrides: Vec<&str> = overrides.iter().map(String::as_str).collect();
    let results = run(&scene("joint-net-tension.toml", &overrides), &mut |_| {}).unwrap();
    results.failure[0].progressive.clone().unwrap()
}

#[test]
fn a_joint_is_read_along_the_direction_in_which_its_pin_bears() {
    let along = turned([-1.0, 0.0], "left", 0.0);
    assert_eq!(along.frame.bearing, Some(0.0));
    assert_eq!(along.free_travel, 0.0);
    for (direction, pulled, angle) in [
        ([1.0, 0.0], "right", 180.0),
        ([0.0, -1.0], "bottom", 90.0),
        ([0.0, 1.0], "top", -90.0),
    ] {
        let other = turned(direction, pulled, angle);
        let [x, y] = direction;
        let bearing = other.frame.bearing.unwrap();
        assert!(
            (bearing.cos() + x).hypot(bearing.sin() + y) < 1e-9,
            "{bearing}"
        );
        println!(
            "{direction:?}: {} and {} N, {:?}",
            along.peak_load(),
            other.peak_load(),
            other.mode.as_ref().map(|call| call.mode)
        );
        // Later failures depend on which of two equal plies comes first.
        let close = |a: f64, b: f64, part: f64| assert!((a / b - 1.0).abs() < part, "{a} {b}");
        let [first, same] = [&other, &along].map(|joint| joint.first().unwrap().load);
        // Both are resolved to 0.1 %.
        close(first, same, 2.1e-3);
        close(other.peak_load(), along.peak_load(), 0.02);
        let [moved, same] = [&other, &along].map(|joint| joint.curve[0].displacement);
        // The pin starts where it bears.
        close(moved, same, 1e-6);
        assert!(other.free_travel.abs() < 1e-12);
        let [mode, same] = [&other, &along].map(|joint| joint.mode.as_ref().unwrap().mode);
        assert_eq!(mode, same);
        let ends = |joint: &ProgressiveFailure| joint.departures(0.1).concat();
        assert_eq!(ends(&other).len(), ends(&along).len());
    }
}

#[test]
fn a_drive_bears_on_the_side_that_it_pulls_from() {
    let driven = |end: &str, loads: &str| {
        let end = format!("failure.progressive.control.displacement.end=\"{end}\"");
        let overrides = ["mesh.spacing=\"22.5 deg\"", loads, &end];
        run(&scene("joint-net-tension.toml", &overrides), &mut |_| {})
    };
    let pushed = driven("0.2 mm", "loads.0.force.direction=[1,0]").unwrap();
    let pushed = pushed.failure[0].progressive.as_ref().unwrap();
    assert_eq!(pushed.frame.bearing, Some(std::f64::consts::PI));
    assert!(pushed.frame.clockwise && pushed.peak_load() > 0.0);
    let error = driven("0.2 mm", "loads.0.force.direction=[-1,0]").unwrap_err();
    assert!(
        error
            .to_string()
            .contains("turn the load or the drive round"),
        "{error}"
    );
}

#[test]
fn a_half_has_the_work_of_the_whole() {
    let [half, whole] = ["half", "whole"].map(|model| {
        let model = format!("analysis.model={model:?}");
        let loads = "loads.0.force.steps=[\"200 N\"]";
        let control = "failure.progressive.control={loads={increments=2}}";
        let overrides = ["mesh.spacing=\"15 deg\"", &model, loads, control];
        let results = run(&scene("joint-net-tension.toml", &overrides), &mut |_| {}).unwrap();
        results.failure[0].progressive.clone().unwrap()
    });
    for (half, whole) in half.curve.iter().zip(&whole.curve) {
        assert!((half.load / whole.load - 1.0).abs() < 1e-6);
        assert!((half.work / whole.work - 1.0).abs() < 1e-6);
    }
}

#[test]
fn strains_part_on_either_side_of_a_whole_joint() {
    let overrides = [
        "mesh.spacing=\"22.5 deg\"",
        "failure.progressive.control.displacement.increments=4",
    ];
    let results = run(&scene("joint-net-tension.toml", &overrides), &mut |_| {}).unwrap();
    let mut joint = results.failure[0].progressive.clone().unwrap();
    let parted = |degrees: i32| {
        degrees <= -160 || (-90..=-70).contains(&degrees) || [40, 180].contains(&degrees)
    };
    joint.half = false;
    joint.frame.clockwise = false;
    joint.frame.bearing = Some(0.0);
    joint.edge = (-17..=18)
        .map(|k| EdgeStrain {
            angle: f64::from(10 * k).to_radians(),
            followed: [if parted(10 * k) { 2.0 } else { 1.0 }, 0.0],
            linear: [1.0, 0.0],
        })
        .collect();
    let ranges = joint.departures(0.1);
    let degrees: Vec<[f64; 2]> = ranges
        .iter()
        .map(|range| range.map(|angle| angle.to_degrees().round()))
        .collect();
    assert_eq!(degrees, [[-90.0, -70.0], [40.0, 40.0], [180.0, 200.0]]);
}
