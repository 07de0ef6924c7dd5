//! Several contacts that know nothing of each other, in one scene.

use stickslip::run::{run_with, solve, solver};
use stickslip::scene::schema::SolverChoice;
use stickslip_contact::InterfaceSolver;
use stickslip_contact::solver::{Step, StepFailure, StepSolution};

use super::{BUSHING, difference, model, scene, solved, tractions};

const LINES: &str = r#"
version = 1
[analysis]
plane = "strain"
[materials.metal.isotropic]
young = "70 GPa"
poisson = 0.33
[bodies.block]
material = "metal"
thickness = "1 mm"
shape.block = { half_length = "12 mm", depth = "12 mm" }
[bodies.roller]
material = "metal"
thickness = "1 mm"
shape.cylinder = { radius = "50 mm", half_length = "12 mm", depth = "12 mm" }
[bodies.slab]
material = "metal"
thickness = "1 mm"
shape.block = { half_length = "8 mm", depth = "10 mm" }
[bodies.wheel]
material = "metal"
thickness = "1 mm"
shape.cylinder = { radius = "30 mm", half_length = "8 mm", depth = "10 mm" }
[mesh]
spacing = "0.2 mm"
fine_to = "1.6 mm"
[[contacts]]
first = "roller.contact"
second = "block.contact"
friction.coulomb = { mu = 0.4 }
[[contacts]]
first = "wheel.contact"
second = "slab.contact"
friction.coulomb = { mu = 0.2 }
[[supports]]
on = "block.bottom"
fix = ["x", "y"]
[[supports]]
on = "slab.bottom"
fix = ["x", "y"]
[[platens]]
on = "roller.top"
free = ["x", "y"]
[[platens]]
on = "wheel.top"
free = ["x", "y"]
[[loads]]
on = "roller.top"
force = { direction = [0, -1], steps = ["300 N", "600 N"] }
[[loads]]
on = "roller.top"
force = { direction = [1, 0], steps = ["10 N", "100 N"] }
[[loads]]
on = "wheel.top"
force = { direction = [0, -1], steps = ["200 N", "300 N"] }
[output]
fields = "none"
figures = false
"#;

/// A second joint beside [`BUSHING`].
const LUG: &str = r#"
[bodies.lug]
material = "metal"
thickness = "3 mm"
shape.plate_with_hole = { hole_radius = "4 mm", outline.ring.radius = "15 mm" }
[bodies.bolt]
material = "metal"
thickness = "3 mm"
shape.disk.radius = "3.99 mm"
[[contacts]]
first = "lug.hole"
second = "bolt.rim"
friction.coulomb = { mu = 0.1 }
[[supports]]
on = "bolt.centre"
fix = ["x", "y"]
[[loads]]
on = "lug.outer"
force = { direction = [-1, 0], steps = ["500 N", "700 N", "900 N"] }
"#;

/// The scene without some of its tables, which start with these lines.
fn without(text: &str, tables: &[&str]) -> String {
    let mut kept = String::new();
    for table in text.split("\n[").skip(1) {
        let table = format!("[{table}\n");
        if !tables.iter().any(|start| table.contains(start)) {
            kept += &table;
        }
    }
    format!("version = 1\n{kept}")
}

#[test]
fn two_line_contacts_are_as_each_is_alone() {
    let both = solved(LINES, &[]);
    let roller = solved(&without(LINES, &["wheel", "slab"]), &[]);
    let wheel = solved(
        &without(LINES, &["roller", "block]", "block."]),
        &["analysis.model=whole"],
    );
    for step in 0..2 {
        for (edge, alone) in [(0, &roller), (1, &wheel)] {
            let apart = difference(
                tractions(&alone.steps[step].edges[0].rows),
                tractions(&both.steps[step].edges[edge].rows),
            );
            // The same bodies and the same points; only the sums of the solvers run over more of them.
            assert!(apart < 1e-9, "step {step}, contact {edge}: {apart:e}");
        }
    }
    // Different radii and loads: different contacts.
    let extent = |edge: usize| both.steps[1].edges[edge].contact_half_extent.unwrap();
    assert!((extent(0) / extent(1) - 1.0).abs() > 0.1);
}

#[test]
fn two_joints_are_as_each_is_alone() {
    let both = solved(&format!("{BUSHING}{LUG}"), &[]);
    let bushing = solved(BUSHING, &[]);
    let lug = without(
        &format!("{BUSHING}{LUG}"),
        &["plate]", "\"plate.", "bodies.plate.", "bushing", "pin"],
    );
    let lug = solved(&lug, &[]);
    assert_eq!(both.edges.len(), 3);
    for step in 0..3 {
        for (edge, alone, own) in [(0, &bushing, 0), (1, &bushing, 1), (2, &lug, 0)] {
            let apart = difference(
                tractions(&alone.steps[step].edges[own].rows),
                tractions(&both.steps[step].edges[edge].rows),
            );
            assert!(apart < 1e-9, "step {step}, contact {edge}: {apart:e}");
        }
    }
}

/// `count` joints of a lug and its bolt, loaded by `load(k)` in newtons and once more by half of it.
fn lugs(count: i32, load: impl Fn(i32) -> f64) -> String {
    let mut text = BUSHING[..BUSHING.find("[bodies").unwrap()].to_owned();
    text += "[mesh]\nspacing = \"12 deg\"\nelement = \"Q4\"\n[output]\nfields = \"none\"\nfigures = false\n";
    for k in 0..count {
        let own = LUG
            .replace("lug", &format!("lug{k:02}"))
            .replace("bolt", &format!("bolt{k:02}"));
        let steps = format!("steps = [\"{} N\", \"{} N\"]", load(k), 0.5 * load(k));
        text += &own.replace("steps = [\"500 N\", \"700 N\", \"900 N\"]", &steps);
    }
    text
}

#[test]
fn copies_of_a_joint_are_as_each_is_alone_to_the_last_bit() {
    let load = |k: i32| 900.0 / 10_f64.powi(2 * k);
    let together = solved(&lugs(4, load), &[]);
    for (k, joint) in (0..4).enumerate() {
        let alone = solved(&lugs(1, |_| load(joint)), &[]);
        for (together, alone) in together.steps.iter().zip(&alone.steps) {
            assert_eq!(together.edges[k].rows, alone.edges[0].rows);
            assert_eq!(together.edges[k].zones, alone.edges[0].zones);
            assert_eq!(together.edges[k].resultant, alone.edges[0].resultant);
        }
    }
}

#[test]
fn what_is_stored_grows_with_the_number_of_joints() {
    let entries = |count: i32| {
        let model = model(&lugs(count, |_| 900.0), &[]);
        let solver = solver(SolverChoice::Auto);
        let solved = solve(&model, solver.as_ref(), &mut |_| {}).unwrap();
        assert_eq!(solved.interface.parts().len(), count as usize);
        let operations: u64 = solved
            .records
            .iter()
            .map(|record| record.work.operations)
            .sum();
        (solved.interface.entries(), operations)
    };
    let (entries_of_one, operations_of_one) = entries(1);
    assert_eq!(entries(12), (12 * entries_of_one, 12 * operations_of_one));
}

/// The wheel is lifted off its slab, and the roller's history ends with it.
#[test]
fn bodies_without_balance_are_named() {
    let folder = tempfile::TempDir::new().unwrap();
    std::fs::write(folder.path().join("lines.toml"), LINES).unwrap();
    let output = std::process::Command::new(env!("CARGO_BIN_EXE_stickslip"))
        .current_dir(folder.path())
        .args(["run", "lines.toml"])
        .args(["--set", "loads.2.force.direction=[0, 1]"])
        .output()
        .unwrap();
    let message = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(1), "{message}");
    for part in [
        "for 'slab' and 'wheel'",
        "cannot be balanced: 'wheel' slides along y",
        "(proved)",
    ] {
        assert!(message.contains(part), "{part}: {message}");
    }
    assert!(!message.contains("'roller'"), "{message}");
}

/// Solves as the command does, then makes the largest normal force of a pair wrong.
#[derive(Debug)]
struct Wrong {
    pair: String,
    error: f64,
}

impl InterfaceSolver for Wrong {
    fn name(&self) -> &'static str {
        "wrong"
    }

    fn solve(&self, step: &Step<'_>) -> Result<StepSolution, StepFailure> {
        let mut solution = solver(SolverChoice::Auto).solve(step)?;
        let forces = &mut solution.trial.forces;
        let mut pairs = step.problem.pairs().iter();
        let Some(pair) = pairs.position(|pair| pair.name == self.pair) else {
            return Ok(solution);
        };
        let rows = step.problem.pair_points(pair).map(|k| 2 * k);
        let largest = rows
            .max_by(|&a, &b| forces[a].total_cmp(&forces[b]))
            .unwrap();
        forces[largest] *= 1.0 + self.error;
        Ok(solution)
    }
}

/// A large joint whose last step is small, and a small joint beside it, with one force wrong.
fn balances(pair: usize, error: f64) -> Vec<f64> {
    let changes = [
        "loads.0.force.steps=[\"1 kN\", \"4 kN\", \"1 N\"]",
        "loads.1.force.steps=[\"0.005 N\", \"0.007 N\", \"0 N\"]",
    ];
    let scene = scene(&format!("{BUSHING}{LUG}"), &changes);
    let pair = scene.contacts[pair].name.clone();
    let results = run_with(&scene, &Wrong { pair, error }, &mut |_| {}).unwrap();
    results
        .steps
        .iter()
        .map(|step| step.balance_residual)
        .collect()
}

#[test]
fn an_error_in_one_force_shows_in_the_balance_of_its_joint() {
    let right = balances(0, 0.0);
    assert!(right.iter().all(|balance| *balance < 1e-11), "{right:?}");
    for (pair, steps) in [(0, &[0, 1, 2][..]), (1, &[0, 1, 2]), (2, &[0, 1])] {
        let wrong = balances(pair, 1e-6);
        for &step in steps {
            assert!(wrong[step] > 1e-10, "pair {pair}, step {step}: {wrong:?}");
        }
    }
}

#[test]
fn forces_are_rounding_beside_those_of_their_own_contact() {
    let changes = [
        "loads.0.force.steps=[\"1 kN\", \"4 kN\", \"0 N\"]",
        "loads.1.force.steps=[\"0 N\", \"0 N\", \"1e-10 N\"]",
    ];
    let results = solved(&format!("{BUSHING}{LUG}"), &changes);
    assert!(results.steps[2].edges[2].contact_half_extent.is_some());
}
