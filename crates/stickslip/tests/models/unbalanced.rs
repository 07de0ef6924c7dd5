//! Rigid motions that nothing resists: loads that balance themselves, and loads that nothing can balance.

use std::fmt::Write as _;
use std::fs;

use stickslip::run::{RunError, run};
use stickslip_contact::ContactError;
use stickslip_engine::run::{MovingBody, WholeMotion};
use tempfile::TempDir;

use super::{BUSHING, difference, results, scene, scene_in, solved, upper};

/// A ring under tractions of a table around a rigid pin far smaller than its hole.
const RING: &str = r#"
version = 1
[materials.metal.isotropic]
young = "70 GPa"
poisson = 0.33
[bodies.ring]
material = "metal"
thickness = "2 mm"
shape.plate_with_hole = { hole_radius = "5 mm", outline.ring.radius = "25 mm" }
[bodies.pin]
rigid = true
shape.disk.radius = "4 mm"
[mesh]
spacing = "6 deg"
[[contacts]]
first = "ring.hole"
second = "pin.rim"
friction.coulomb.mu = 0
[[supports]]
on = "pin.centre"
fix = ["x", "y"]
[[loads]]
name = "t"
on = "ring.outer"
polar_traction = { file = "table.csv", stress = "MPa", steps = [1.0, 0.4] }
[output]
fields = "none"
figures = false
"#;

/// A pin that is loose in its ring, almost without friction, under a force on its unevenly divided rim.
const LOOSE: &str = r#"
version = 1
[materials.metal.isotropic]
young = "70 GPa"
poisson = 0.33
[bodies.ring]
material = "metal"
thickness = "2 mm"
shape.plate_with_hole = { hole_radius = "10 mm", outline.ring.radius = "30 mm" }
[bodies.pin]
material = "metal"
thickness = "2 mm"
shape.disk.radius = "9.5 mm"
[mesh]
element = "T6"
spacing = "15 deg"
fine_to = "50 deg"
[[contacts]]
first = "ring.hole"
second = "pin.rim"
friction.coulomb.mu = 1e-6
projection = "mortar"
[[supports]]
on = "ring.outer"
fix = ["x", "y"]
[[loads]]
on = "pin.rim"
force = { direction = [0.78, -0.62], steps = ["20 N", "40 N", "20 N"] }
[output]
fields = "none"
figures = false
"#;

/// Plane tension σ along x: σ_r = σ cos²θ, τ_rθ = −σ sin θ cos θ. Its forces across x are rounding throughout.
fn folder_with_tension() -> TempDir {
    let folder = TempDir::new().unwrap();
    let mut table = "theta_deg,sigma_r,tau_rtheta\n".to_owned();
    for degrees in (0..=180).step_by(5) {
        let (sine, cosine) = f64::from(degrees).to_radians().sin_cos();
        // Writing into a string does not fail.
        let _ = writeln!(
            table,
            "{degrees},{},{}",
            50.0 * cosine * cosine,
            -50.0 * sine * cosine
        );
    }
    fs::write(folder.path().join("table.csv"), table).unwrap();
    folder
}

#[test]
fn a_ring_that_touches_nothing_stays_under_tension_that_balances_itself() {
    let folder = folder_with_tension();
    for mesh in [
        &["mesh.spacing=6 deg"][..],
        // Uneven, so that the forces on the nodes leave some of the tractions unbalanced.
        &["mesh.spacing=4 deg", "mesh.fine_to=60 deg"],
        &[
            "mesh.spacing=9 deg",
            "mesh.fine_to=60 deg",
            "mesh.element=Q4",
        ],
    ] {
        let [half, whole] = ["half", "whole"].map(|kind| {
            let model = format!("analysis.model={kind}");
            results(&scene_in(folder.path(), RING, &[mesh, &[&model]].concat()))
        });
        for step in 0..2 {
            for results in [&half, &whole] {
                let edge = &results.steps[step].edges[0];
                assert_eq!(edge.peak_pressure, None, "{mesh:?}");
                assert_eq!(edge.resultant, [0.0; 2], "{mesh:?}");
            }
            let hoop = |results| {
                let rows = upper(results, step, 0);
                rows.into_iter()
                    .map(|row| row.sigma_tangential)
                    .collect::<Vec<_>>()
            };
            let apart = difference(hoop(&half), hoop(&whole));
            assert!(apart < 1e-9, "{mesh:?}: {apart:e}");
        }
    }
}

/// The facets of the rim move the force off its centre by 10⁻⁵ of the radius, which is more than such friction holds.
#[test]
fn a_force_on_a_rim_needs_no_friction_to_be_held() {
    let frictionless = solved(LOOSE, &["contacts.0.friction.coulomb.mu=0"]);
    for mu in ["1e-6", "1e-4"] {
        let set = format!("contacts.0.friction.coulomb.mu={mu}");
        let slight = solved(LOOSE, &[&set]);
        for (step, pull) in [20.0, 40.0, 20.0].into_iter().enumerate() {
            let [none, some] =
                [&frictionless, &slight].map(|results| &results.steps[step].edges[0]);
            // The scene's direction is made a unit vector.
            let size = some.resultant[0].hypot(some.resultant[1]);
            assert!((size - pull).abs() < 1e-8 * pull, "μ = {mu}: {size}");
            let pressures = |rows: &[stickslip::results::EdgeRow]| -> Vec<f64> {
                rows.iter().map(|row| row.pressure).collect()
            };
            let apart = difference(pressures(&none.rows), pressures(&some.rows));
            let mu: f64 = mu.parse().unwrap();
            assert!(apart < 10.0 * mu + 1e-8, "μ = {mu}: {apart:e}");
        }
    }
}

/// A force on the section of a pin and the reaction that holds a section act through its centre, however unevenly its rim is divided.
#[test]
fn an_unevenly_divided_pin_does_not_turn_without_friction() {
    let lug = include_str!("../../../../scenes/validation/lug.toml");
    let oblique = "loads.0.force.direction=[3, 1]";
    let held = [
        oblique,
        "loads.0.on=lug.root",
        "loads.0.force.steps=[\"-10 kN\"]",
        "supports.0.on=pin.section",
        "platens=[{ on = \"lug.root\", free = [\"x\", \"y\"] }]",
    ];
    for changes in [&[oblique][..], &held] {
        let peak = |divided: &[&str]| {
            let found = solved(lug, &[changes, divided].concat());
            let step = &found.steps[0];
            assert!(step.balance_residual < 1e-10, "{}", step.balance_residual);
            step.edges[0].peak_pressure.unwrap().0
        };
        let even = peak(&["mesh.spacing=2 deg"]);
        let uneven = peak(&["mesh.spacing=2 deg", "mesh.fine_to=70 deg"]);
        assert!((uneven / even - 1.0).abs() < 2e-3, "{uneven} {even}");
    }
}

/// Nothing holds a plate against turning whose pin turns with it; every solver that a scene can name is asked after the proof.
#[test]
fn every_solver_refuses_a_load_without_balance_before_it_searches() {
    for solver in ["auto", "newton", "status", "pivoting"] {
        let solver = format!("analysis.solver={solver}");
        let across = "loads.0.force.direction=[0, 1]";
        let error = run(&scene(BUSHING, &[across, &solver]), &mut |_| {}).unwrap_err();
        let RunError::Unbalanced { cause, moving, .. } = error else {
            panic!("{solver}: {error}");
        };
        let turns = |own: &MovingBody| matches!(own.motion, WholeMotion::Turns { .. });
        assert!(moving.iter().all(turns), "{solver}: {moving:?}");
        let ContactError::StepFailed { cause, .. } = cause else {
            panic!("{solver}: {cause}");
        };
        assert!(cause.is_proved_impossible(), "{solver}: {cause}");
        assert_eq!(cause.work.pivots, 0, "{solver}: {cause}");
        assert_eq!(cause.attempts.len(), 1, "{solver}: {cause}");
    }
}

/// A load that misses the axis of the pin by what is left of rounded coordinates is carried; by how much more it misses is said.
#[test]
fn loads_balance_up_to_rounded_coordinates() {
    let missing = |along: &str| {
        let direction = format!("loads.0.force.direction=[1, {along}]");
        run(&scene(BUSHING, &[&direction]), &mut |_| {})
    };
    let found = missing("3e-11").unwrap();
    assert!(found.steps.iter().all(|step| step.balance_residual < 1e-10));
    let error = missing("1e-8").unwrap_err();
    let RunError::Unbalanced { part, .. } = error else {
        panic!("{error}");
    };
    // The turn of a point at the hole against the pull.
    assert!((2e-9..1e-7).contains(&part), "{part}");
}

/// A block on a slope of 30° that is too steep for it.
const SLOPE: &str = r#"
version = 1
[materials.metal.isotropic]
young = "72 GPa"
poisson = 0.33
[bodies.wedge]
material = "metal"
thickness = "4 mm"
shape.outline = { start = ["-30 mm", "-40 mm"], edges = [{ name = "base", to = ["30 mm", "-40 mm"] }, { name = "side", to = ["30 mm", "17.320508075688775 mm"] }, { name = "slope", to = ["-30 mm", "-17.320508075688775 mm"] }, { name = "back" }] }
[bodies.block]
material = "metal"
thickness = "4 mm"
shape.outline = { start = ["-8.660254037844387 mm", "-5 mm"], edges = [{ name = "base", to = ["8.660254037844387 mm", "5 mm"] }, { name = "lower", to = ["3.660254037844387 mm", "13.660254037844387 mm"] }, { name = "top", to = ["-13.660254037844387 mm", "3.660254037844387 mm"] }, { name = "upper" }] }
[mesh]
spacing = "2 mm"
[[contacts]]
first = "block.base"
second = "wedge.slope"
friction.coulomb.mu = 0.5
[[supports]]
on = "wedge.base"
fix = ["x", "y"]
[[loads]]
on = "block.section"
force = { direction = [0, -1], steps = ["1 kN"] }
[output]
fields = "none"
figures = false
"#;

/// A proof lifts the block by the friction of its slip; the block slides along the slope.
#[test]
fn a_block_on_a_steep_slope_slides_along_it() {
    let failure = run(&scene(SLOPE, &[]), &mut |_| {}).unwrap_err();
    let RunError::Unbalanced { moving, .. } = failure else {
        panic!("{failure}");
    };
    let [
        MovingBody {
            body,
            motion: WholeMotion::Slides([x, y]),
        },
    ] = &moving[..]
    else {
        panic!("{moving:?}");
    };
    assert_eq!(body, "block");
    let down = [-0.75_f64.sqrt(), -0.5];
    assert!(
        (x - down[0]).abs() < 1e-6 && (y - down[1]).abs() < 1e-6,
        "({x}, {y})"
    );
    assert!(
        run(
            &scene(SLOPE, &["contacts.0.friction.coulomb.mu=0.6"]),
            &mut |_| {}
        )
        .is_ok()
    );
}
