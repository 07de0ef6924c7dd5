//! Reused bodies against runs that share nothing.

use std::fs;
use std::path::Path;

use tempfile::TempDir;

use super::*;
use crate::host::HOST;
use stickslip_engine::results::{BodyFailure, EdgeRow};
use stickslip_ladder::run as whole_run;

const AXES: &str = r#"
version = 1
scene = "joint.toml"
[[axes]]
key = "clearance"
values = ["0 mm", "0.01 mm", "0.08 mm"]
[[axes]]
key = "mu"
values = [0, 0.35]
[[axes]]
key = "loads.0.force.steps"
values = [["1 kN", "4 kN"], ["3 kN", "0.5 kN"]]
"#;

fn sweep(axes: &str, overrides: &[&str]) -> (TempDir, Sweep) {
    sweep_of("sweeps/pinned-joint.toml", axes, overrides)
}

fn sweep_of(scene: &str, axes: &str, overrides: &[&str]) -> (TempDir, Sweep) {
    let folder = TempDir::new().unwrap();
    let scenes = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes");
    fs::copy(scenes.join(scene), folder.path().join("joint.toml")).unwrap();
    let path = folder.path().join("sweep.toml");
    fs::write(&path, axes).unwrap();
    let sweep = Sweep::from_file(&path, overrides, HOST).unwrap();
    (folder, sweep)
}

/// Largest difference over the largest size.
fn apart(found: &[f64], expected: &[f64]) -> f64 {
    assert_eq!(found.len(), expected.len());
    let pairs = found.iter().zip(expected);
    let difference = pairs.fold(0.0_f64, |most, (a, b)| most.max((a - b).abs()));
    let size = expected
        .iter()
        .fold(0.0_f64, |most, value| most.max(value.abs()));
    if size == 0.0 {
        difference
    } else {
        difference / size
    }
}

/// A number of a point of an edge.
type Quantity = fn(&EdgeRow) -> f64;

fn values(results: &Results, of: Quantity) -> Vec<f64> {
    let edges = results.steps.iter().flat_map(|step| &step.edges);
    edges.flat_map(|edge| &edge.rows).map(of).collect()
}

fn failures(results: &Results) -> Vec<f64> {
    let of_body = |body: &BodyFailure| -> Vec<f64> {
        let curve = body
            .characteristic
            .iter()
            .flat_map(|curve| &curve.curve)
            .flatten();
        let curve = curve.map(|joint| &joint.first);
        let all = body.first_ply.iter().flatten().chain(curve);
        let loads = all.filter_map(|first| first.load.as_ref());
        loads.map(|load| load.value).collect()
    };
    results.failure.iter().flat_map(of_body).collect()
}

/// Every case of a sweep, solved in one shop, against a run by itself.
fn agrees(axes: &str, overrides: &[&str], condensed: usize) {
    let (_folder, sweep) = sweep(axes, overrides);
    let stop = AtomicBool::new(false);
    let plans = (0..sweep.cases())
        .map(|case| (case, keys(&sweep, case)))
        .collect();
    let shop = Shop::new(&sweep, plans, &stop);
    let mut last = None;
    for case in 0..sweep.cases() {
        let scene = sweep.scene_of(case).unwrap();
        let reused = shop.results(case, &scene, &mut last).unwrap();
        let alone = whole_run(&scene, &mut |_| {}).unwrap();
        let fields: [(&str, Quantity); 5] = [
            ("pressure", |row| row.pressure),
            ("shear", |row| row.shear),
            ("gap", |row| row.gap),
            ("slip", |row| row.slip),
            ("hoop stress", |row| row.sigma_tangential),
        ];
        for (name, of) in fields {
            let difference = apart(&values(&reused, of), &values(&alone, of));
            assert!(
                difference < 1e-10,
                "{}, {name}: {difference:e}",
                sweep.name_of(case)
            );
        }
        let yields = |results: &Results| -> Vec<Option<f64>> {
            results.bodies.iter().map(|own| own.yield_stress).collect()
        };
        assert_eq!(yields(&reused), yields(&alone), "{}", sweep.name_of(case));
        assert!(!failures(&alone).is_empty());
        let difference = apart(&failures(&reused), &failures(&alone));
        assert!(
            difference < 1e-10,
            "{}, failure: {difference:e}",
            sweep.name_of(case)
        );
    }
    assert_eq!(shop.condensed.load(Ordering::Relaxed), condensed);
}

#[test]
fn a_pin_of_another_size_has_the_same_compliance() {
    agrees(AXES, &["mesh.spacing=6 deg"], 2);
}

#[test]
fn a_whole_pin_too() {
    agrees(AXES, &["mesh.spacing=6 deg", "analysis.model=whole"], 2);
}

#[test]
fn a_rigid_pin_has_none() {
    let rigid = ["mesh.spacing=6 deg", "bodies.pin.rigid=true"];
    agrees(AXES, &rigid, 1);
}

#[test]
fn a_pin_that_is_loaded_is_condensed_for_each_size() {
    let loaded = [
        "mesh.spacing=6 deg",
        "loads.0.force.steps=[\"1 kN\", \"2 kN\"]",
        "loads.1.on=pin.rim",
        "loads.1.pressure.steps=[\"1 MPa\", \"2 MPa\"]",
    ];
    // The plate, and the pin of three sizes.
    agrees(AXES, &loaded, 4);
}

#[test]
fn a_yield_stress_is_that_of_its_case() {
    let axes = r#"
version = 1
scene = "joint.toml"
[[axes]]
key = "materials.aluminium.isotropic.yield"
values = ["100 MPa", "900 MPa"]
"#;
    agrees(axes, &["mesh.spacing=6 deg"], 2);
}

#[test]
fn lay_ups_and_outlines_are_bodies_of_their_own() {
    let axes = r#"
version = 1
scene = "joint.toml"
[[axes]]
key = "layup"
values = ["[0/±45/90]s", "[0_2/±45]s"]
[[axes]]
key = "e_over_d"
values = [2, 3]
[[axes]]
key = "plies.carbon.strengths.xc"
values = ["1500 MPa", "900 MPa"]
"#;
    // Four plates and one pin; strengths are no matter of stiffness.
    agrees(axes, &["mesh.spacing=6 deg"], 5);
}

#[test]
fn workers_give_the_same_rows_in_any_number() {
    let (_folder, sweep) = sweep(AXES, &["mesh.spacing=6 deg"]);
    let stop = AtomicBool::new(false);
    let cases: Vec<usize> = (0..sweep.cases()).collect();
    let solved = |jobs: usize| {
        let mut rows = Vec::new();
        let jobs = NonZeroUsize::new(jobs).unwrap();
        run(&sweep, &cases, jobs, &stop, &mut |row| {
            rows.push((row.case, row.outcome));
            Ok(())
        })
        .unwrap();
        rows.sort_by_key(|row| row.0);
        rows
    };
    let one = solved(1);
    assert_eq!(one.len(), sweep.cases());
    assert_eq!(one, solved(3));
}

#[test]
fn a_sweep_that_is_stopped_ends_with_what_is_finished() {
    let (_folder, sweep) = sweep(AXES, &["mesh.spacing=6 deg"]);
    let stop = AtomicBool::new(false);
    let cases: Vec<usize> = (0..sweep.cases()).collect();
    let mut rows = 0;
    run(&sweep, &cases, NonZeroUsize::MIN, &stop, &mut |_| {
        rows += 1;
        stop.store(true, Ordering::Relaxed);
        Ok(())
    })
    .unwrap();
    // The worker may have begun some cases before the first row was handed over.
    assert!(rows < sweep.cases(), "{rows}");
}

/// A sweep that is gone on with asks for its last cases alone.
#[test]
fn a_case_has_the_same_bits_whatever_else_is_asked_for() {
    let (_folder, sweep) = sweep(AXES, &["mesh.spacing=6 deg"]);
    let stop = AtomicBool::new(false);
    let last_of = |cases: &[usize]| {
        let plans = cases.iter().map(|&case| (case, keys(&sweep, case)));
        let shop = Shop::new(&sweep, plans.collect(), &stop);
        let mut last = None;
        let results = cases.iter().map(|&case| {
            let scene = sweep.scene_of(case).unwrap();
            shop.results(case, &scene, &mut last).unwrap()
        });
        let results = results.last().unwrap();
        let edges = results.steps.into_iter().map(|step| step.edges);
        format!("{:?}", edges.collect::<Vec<_>>())
    };
    let end = sweep.cases() - 1;
    assert_eq!(last_of(&[0, end]), last_of(&[end]));
}

/// A case that is refused does not take others with it that have its bodies.
#[test]
fn a_refused_first_case_leaves_the_others() {
    let axes = r#"
version = 1
scene = "joint.toml"
[[axes]]
key = "analysis.model"
values = ["half"]
[[axes]]
key = "contacts.0.friction"
values = [
  { fibre_coverage = { plies = [{ angle = "45 deg", fraction = 1.0 }], fibre_fraction = 0.6, kernel.tangent.width = "40 deg", fibre.coulomb = { mu = 0.0 }, matrix.coulomb = { mu = 0.8 } } },
  { coulomb = { mu = 0.2 } },
]
"#;
    let (_folder, sweep) = sweep(axes, &["mesh.spacing=6 deg"]);
    let mut rows = Vec::new();
    let stop = AtomicBool::new(false);
    run(&sweep, &[0, 1], NonZeroUsize::MIN, &stop, &mut |row| {
        rows.push(row);
        Ok(())
    })
    .unwrap();
    rows.sort_by_key(|row| row.case);
    let solved = |k: usize| matches!(rows[k].outcome, Outcome::Solved(_));
    assert!(!solved(0) && solved(1), "{rows:?}");
}

#[test]
fn no_body_is_kept_after_the_last_case() {
    let axes = r#"
version = 1
scene = "joint.toml"
[joint]
contact = "bolt-1"
[[axes]]
key = "contacts.0.friction.coulomb.mu"
values = [0.1, 0.3]
"#;
    for compliance in ["matrix", "blocks"] {
        let form = format!("analysis.compliance={compliance}");
        let overrides = [r#"mesh.spacing="6 deg""#, &form];
        let (_folder, sweep) = sweep_of("fasteners-five.toml", axes, &overrides);
        let stop = AtomicBool::new(false);
        let plans = (0..2).map(|case| (case, keys(&sweep, case))).collect();
        let shop = Shop::new(&sweep, plans, &stop);
        let pool = rayon::ThreadPoolBuilder::new().num_threads(1);
        let (sender, receiver) = channel();
        shop.work(&pool.build().unwrap(), &sender);
        drop(sender);
        let mut rows = receiver.iter();
        assert!(rows.all(|row| matches!(row.outcome, Outcome::Solved(_))));
        assert!(shop.store.is_empty(), "{compliance}");
    }
}
