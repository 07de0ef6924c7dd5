//! Gaps on the deformed geometry: `[analysis] kinematics = "deformed-gaps"`.

use stickslip::model::{Model, ModelError};
use stickslip::results::{Finding, Results, SetKind};
use stickslip::run::{self, RunError};
use stickslip::scene::{Format, Scene};

use super::halves::ROLLER;
use super::series::PIN as SERIES;
use super::travel::JOINT;
use super::{BUSHING, difference, scene, solved, tractions, upper};

const DEFORMED: &str = "analysis.kinematics=deformed-gaps";

/// The job on which other programs were measured.
fn benchmark(changes: &[&str]) -> Results {
    let path = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../../scenes/pin-benchmark.toml"
    );
    let text = std::fs::read_to_string(path).unwrap();
    let quiet = ["output.fields=none", "output.figures=false"];
    let changes: Vec<&str> = changes.iter().chain(&quiet).copied().collect();
    solved(&text, &changes)
}

fn peak(results: &Results, step: usize) -> f64 {
    results.steps[step].edges[0].peak_pressure.unwrap().0
}

/// Peak pressures at 1240 lbf of geometrically nonlinear programs with linear bodies, fine meshes of three of them: 31 600 psi without friction and 25 293 psi
/// with it, ± 15 psi each. This mesh is 4 psi from the finest one here.
#[test]
fn other_programs_have_the_same_peak_pressure() {
    const PSI: f64 = 0.006_894_757_293_168;
    for (mu, reference) in [(0.0, 31_600.0), (0.25, 25_293.0)] {
        let friction = format!("contacts.0.friction.coulomb.mu={mu}");
        let of = |kinematics| {
            peak(
                &benchmark(&[kinematics, &friction, "mesh.spacing=2.25 deg"]),
                3,
            )
        };
        let found = of(DEFORMED) / PSI;
        assert!((found - reference).abs() < 15.0 + 4.0, "{mu}: {found}");
        let small = of("analysis.kinematics=small") / PSI;
        assert!(small < reference - 50.0, "{mu}: {small}");
    }
}

/// The passes gain a factor of the size of the strains each: two to four are needed, and said as updates.
#[test]
fn two_to_four_passes_settle_a_step() {
    let results = benchmark(&[DEFORMED, "mesh.spacing=4.5 deg"]);
    for step in &results.steps {
        assert!((2..=4).contains(&step.work.updates), "{:?}", step.work);
        assert_eq!(step.cutbacks, 0);
        assert!(step.balance_residual < 1e-10);
    }
    let choice = results
        .choices
        .iter()
        .find(|choice| choice.what == "kinematics");
    assert_eq!(choice.unwrap().value, "deformed gaps");
}

#[test]
fn a_half_is_the_whole() {
    for (text, mu) in [(BUSHING, "0.2"), (BUSHING, "0"), (ROLLER, "0.05")] {
        let friction = format!("contacts.0.friction.coulomb.mu={mu}");
        let [half, whole] = ["half", "whole"].map(|model| {
            let model = format!("analysis.model={model}");
            solved(text, &[DEFORMED, &model, &friction])
        });
        for step in 0..half.steps.len() {
            for edge in 0..half.edges.len() {
                let [one, other] = [&half, &whole].map(|all| tractions(&upper(all, step, edge)));
                let apart = difference(one, other);
                assert!(apart < 1e-8, "{mu} {step} {edge}: {apart:e}");
            }
            assert!(whole.steps[step].balance_residual < 1e-10);
        }
    }
}

/// A pin in a round plate, pulled along a direction on the mesh.
fn ring(degrees: f64, changes: &[&str]) -> Results {
    let (sine, cosine) = f64::to_radians(degrees).sin_cos();
    let text = format!(
        r#"
version = 1
analysis.model = "whole"
[materials.metal.isotropic]
young = "70 GPa"
poisson = 0.33
[bodies.plate]
material = "metal"
thickness = "2 mm"
shape.plate_with_hole = {{ hole_radius = "5 mm", outline.ring.radius = "25 mm" }}
[bodies.pin]
material = "metal"
thickness = "2 mm"
shape.disk = {{ radius = "5.01 mm" }}
[mesh]
spacing = "5 deg"
[[contacts]]
first = "plate.hole"
second = "pin.rim"
interference = true
friction.coulomb = {{ mu = 0.2 }}
[[supports]]
on = "pin.centre"
fix = ["x", "y"]
[[loads]]
on = "plate.outer"
force = {{ direction = [{cosine}, {sine}], steps = ["2 kN", "6 kN"] }}
[output]
fields = "none"
figures = false
"#
    );
    solved(&text, changes)
}

/// Where all points stick to each other no point moves against another, and changes of the geometry are measured by the bodies' own displacements.
#[test]
fn a_pin_that_only_presses_has_the_pressure_of_lame() {
    let found = ring(0.0, &[DEFORMED, "loads.0.force.steps=[\"0 N\"]"]);
    let (young, overlap, ratio) = (70e3, 0.01 / 5.0, f64::powi(5.0 / 25.0, 2));
    let lame = 0.5 * young * overlap * (1.0 - ratio);
    let rows = &found.steps[0].edges[0].rows;
    // The strains are the overlap.
    assert!(
        rows.iter()
            .all(|row| (row.pressure / lame - 1.0).abs() < 2.0 * overlap)
    );
    assert_eq!(found.steps[0].cutbacks, 0);
}

/// A load of another direction is a turned load: the mesh has four equal quarters.
#[test]
fn a_turned_load_has_the_turned_answer() {
    let [along, aside] = [0.0, 90.0].map(|degrees| ring(degrees, &[DEFORMED]));
    for (one, other) in along.steps.iter().zip(&aside.steps) {
        let (one, other) = (&one.edges[0], &other.edges[0]);
        let count = one.rows.len();
        let turned = other.rows.iter().cycle().skip(count / 4);
        let turned: Vec<_> = turned.take(count).copied().collect();
        assert!(difference(tractions(&one.rows), tractions(&turned)) < 1e-9);
    }
}

/// Lengths and forces in other units.
#[test]
fn units_change_no_answer() {
    let plain = ring(0.0, &[DEFORMED]);
    let young = "materials.metal.isotropic.young=70e3 GPa";
    let force = "loads.0.force.steps=[\"2000 kN\", \"6000 kN\"]";
    let stiffer = ring(0.0, &[DEFORMED, young, force]);
    let larger: Vec<String> = [
        ("bodies.plate.thickness", "2 m"),
        ("bodies.pin.thickness", "2 m"),
        ("bodies.plate.shape.plate_with_hole.hole_radius", "5 m"),
        (
            "bodies.plate.shape.plate_with_hole.outline.ring.radius",
            "25 m",
        ),
        ("bodies.pin.shape.disk.radius", "5.01 m"),
        ("loads.0.force.steps", "[\"2e6 kN\", \"6e6 kN\"]"),
    ]
    .map(|(key, value)| format!("{key}={value}"))
    .to_vec();
    let changes: Vec<&str> = std::iter::once(DEFORMED)
        .chain(larger.iter().map(String::as_str))
        .collect();
    let larger = ring(0.0, &changes);
    for (step, own) in plain.steps.iter().enumerate() {
        let own = tractions(&own.edges[0].rows);
        let of = |all: &Results| tractions(&all.steps[step].edges[0].rows);
        let stiffer = of(&stiffer).into_iter().map(|traction| traction * 1e-3);
        assert!(difference(own.clone(), stiffer) < 1e-9);
        assert!(difference(own, of(&larger)) < 1e-9);
    }
}

/// At vanishing displacement both kinematics are one: their difference falls with the load, at a clearance that falls with it.
#[test]
fn both_kinematics_agree_at_vanishing_loads() {
    let apart = |scale: f64| {
        let radius = format!("bodies.pin.shape.disk.radius={} mm", 5.0 - 0.01 * scale);
        let force = format!("loads.0.force.steps=[\"{} kN\"]", 4.0 * scale);
        let of = |kinematics| {
            let results = ring(0.0, &[kinematics, &radius, &force]);
            tractions(&results.steps[0].edges[0].rows)
        };
        difference(of("analysis.kinematics=small"), of(DEFORMED))
    };
    let [one, tenth] = [1.0, 0.1].map(apart);
    assert!((1e-4..1e-1).contains(&one), "{one}");
    assert!((0.05..0.2).contains(&(tenth / one)), "{tenth} of {one}");
}

/// A rigid pin, which has no nodes of its own, is what a very stiff one is.
#[test]
fn a_rigid_pin_is_a_stiff_one() {
    let stiff = [
        "materials.hard.isotropic.young=70e8 GPa",
        "materials.hard.isotropic.poisson=0.3",
        "bodies.pin.material=hard",
        "contacts.0.friction.coulomb.mu=0.2",
    ];
    let rigid = scene_with_rigid_pin();
    let rigid = solved(&rigid, &[DEFORMED]);
    let stiff: Vec<&str> = std::iter::once(DEFORMED).chain(stiff).collect();
    let stiff = solved(PIN, &stiff);
    for step in 0..rigid.steps.len() {
        let [one, other] = [&rigid, &stiff].map(|all| tractions(&upper(all, step, 0)));
        assert!(difference(one, other) < 1e-5);
    }
}

/// A pin in a strip.
const PIN: &str = r#"
version = 1
[materials.metal.isotropic]
young = "70 GPa"
poisson = 0.33
[bodies.plate]
material = "metal"
thickness = "2 mm"
[bodies.plate.shape.plate_with_hole]
hole_radius = "5 mm"
outline.strip = { half_width = "20 mm", left = "60 mm", right = "20 mm" }
[bodies.pin]
material = "metal"
thickness = "2 mm"
shape.disk = { radius = "4.98 mm" }
[mesh]
spacing = "6 deg"
[[contacts]]
first = "plate.hole"
second = "pin.rim"
friction.coulomb = { mu = 0.2 }
[[supports]]
on = "pin.centre"
fix = ["x", "y"]
[[loads]]
on = "plate.left"
force = { direction = [-1, 0], steps = ["1 kN", "4 kN", "1 kN"] }
[output]
fields = "none"
figures = false
"#;

fn scene_with_rigid_pin() -> String {
    PIN.replace(
        "[bodies.pin]\nmaterial = \"metal\"\nthickness = \"2 mm\"\n",
        "[bodies.pin]\nrigid = true\n",
    )
}

/// A pin that travels to its far side, and one that is pulled across it: mirror images, and alike but for the strip.
#[test]
fn pins_that_travel_slip_from_where_they_bear() {
    let near = solved(PIN, &[DEFORMED]);
    let far = PIN
        .replace("plate.left", "plate.right")
        .replace("[-1, 0]", "[1, 0]");
    let far = far.replace(
        "left = \"60 mm\", right = \"20 mm\"",
        "left = \"20 mm\", right = \"60 mm\"",
    );
    let far = solved(&far, &[DEFORMED]);
    for step in 0..3 {
        let one = tractions(&upper(&near, step, 0));
        let mut other = upper(&far, step, 0);
        other.reverse();
        let sign = |rows: Vec<stickslip::results::EdgeRow>| -> Vec<f64> {
            rows.iter()
                .flat_map(|row| [row.pressure, -row.shear])
                .collect()
        };
        assert!(difference(one, sign(other)) < 1e-6, "{step}");
    }
}

/// A pin with a clearance of 1.7 % that travels to the side of a square plate bears there as it does where it touches at the start, which paired
/// at equal angles it does to 10 %.
#[test]
fn a_pin_pulled_aside_bears_as_one_that_touches() {
    const PULL: &str = "[[loads]]\non = \"plate.EDGE\"\nforce = { direction = WAY, steps = [\"500 N\", \"1 kN\"] }\n";
    for (mu, tolerance) in [("0", 1e-3), ("0.3", 3e-2)] {
        let friction = format!("contacts.0.friction.coulomb.mu={mu}");
        let of = |edge: &str, way: &str| {
            let pull = PULL.replace("EDGE", edge).replace("WAY", way);
            let changes = [DEFORMED, &friction, "analysis.model=whole"];
            solved(&format!("{JOINT}{pull}"), &changes)
        };
        let (near, aside) = (of("left", "[-1, 0]"), of("top", "[0, 1]"));
        for step in 0..2 {
            let peaks = [&near, &aside].map(|all| peak(all, step));
            assert!((peaks[1] / peaks[0] - 1.0).abs() < 1e-3, "{mu} {peaks:?}");
            let friction = [&near, &aside].map(|all| all.steps[step].edges[0].friction_force);
            let apart = (friction[1] - friction[0]).abs();
            assert!(apart <= tolerance * friction[0], "{mu} {friction:?}");
        }
    }
}

fn refused(text: &str, changes: &[&str]) -> (String, String) {
    match Model::build(&scene(text, changes)) {
        Err(ModelError::Unsupported { key, what }) => (key, what),
        other => panic!("{other:?}"),
    }
}

#[test]
fn what_deformed_gaps_do_not_cover_is_refused_by_its_key() {
    let (key, what) = refused(PIN, &[DEFORMED, "contacts.0.gap=linearised"]);
    assert_eq!(key, "contacts.0.gap");
    assert!(what.contains("kinematics = \"small\""), "{what}");
    let (key, _) = refused(PIN, &[DEFORMED, "contacts.0.projection=mortar"]);
    assert_eq!(key, "contacts.0.projection");
    let (key, what) = refused(PIN, &[DEFORMED, "bodies.pin.mesh.spacing=5 deg"]);
    assert_eq!(key, "contacts.0.projection");
    assert!(what.contains("same divisions"), "{what}");
    let (key, what) = refused(
        super::series::PIN,
        &[
            DEFORMED,
            r#"bodies.plate.model="series""#,
            "mesh.element=Q4",
            r#"mesh.spacing="1 deg""#,
            r#"mesh.fine_to="60 deg""#,
            r#"mesh.coarse_spacing="4 deg""#,
        ],
    );
    assert_eq!(key, "analysis.kinematics");
    assert!(what.contains("equally spaced"), "{what}");
}

/// A load that pushes the roller's cap through the block has no answer, and no silent one.
#[test]
fn what_does_not_settle_is_an_error() {
    let changes = [DEFORMED, "loads.0.force.steps=[\"1e5 kN\"]"];
    let scene = Scene::from_text(
        ROLLER,
        Format::Toml,
        "roller",
        std::path::Path::new(""),
        &changes,
    );
    match run::run(&scene.unwrap(), &mut |_| {}) {
        Err(RunError::Contact(error)) => assert!(error.to_string().contains("load step 1")),
        other => panic!("{:?}", other.map(|results| results.findings)),
    }
}

/// Clearance of 2 % of the radius: the passes still settle, and the difference to small displacements is what strains make it.
#[test]
fn wide_clearances_settle() {
    let wide = ["bodies.pin.shape.disk.radius=4.9 mm"];
    let of = |kinematics| peak(&solved(PIN, &[kinematics, wide[0]]), 1);
    let change = of(DEFORMED) / of("analysis.kinematics=small") - 1.0;
    assert!((1e-4..2e-2).contains(&change), "{change}");
    let found = solved(PIN, &[DEFORMED, wide[0]]).findings;
    assert!(
        !found
            .iter()
            .any(|finding| matches!(finding, Finding::ContactParts { .. }))
    );
}

/// What holds a pin bears the loads, also where its nodes stand elsewhere than those of the hole, and are unequally far apart.
#[test]
fn a_soft_pin_bears_what_pulls_aside() {
    let text = SERIES
        .replace("substeps = 1\n", "")
        .replace("\"210 GPa\"", "\"3 GPa\"")
        .replace("4.99 mm", "4.95 mm")
        .replace("pin.centre", "pin.section");
    let aside = "loads.1={ on = \"plate.bottom\", force = { direction = [-20, -20], steps = [\"1 kN\", \"1 kN\", \"1 kN\"] } }";
    let found = solved(&text, &[DEFORMED, aside, "analysis.accuracy=8 %"]);
    let along = f64::sqrt(0.5) * 1e3;
    for (step, pull) in found.steps.iter().zip([1e3, 4e3, 1.5e3]) {
        for (set, motion) in found.sets.iter().zip(&step.sets) {
            let (SetKind::Held { .. }, Some(motion)) = (set.kind, motion) else {
                continue;
            };
            let expected = along + pull * set.along[0];
            assert!(
                (motion.force - expected).abs() < 1e-8 * (pull + along),
                "{motion:?} {expected}"
            );
        }
    }
}
