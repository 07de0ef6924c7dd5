//! Slip that moves a pin along its hole, and increments that the scene gives.

use stickslip::results::{Finding, LadderEnd, Results, Stated};

use super::solved;

/// A pin with friction and some clearance, pulled in two steps and let go in two.
const PIN: &str = r#"
version = 1
[materials.al.isotropic]
young = "72 GPa"
poisson = 0.33
[materials.st.isotropic]
young = "210 GPa"
poisson = 0.3
[bodies.plate]
material = "al"
thickness = "3 mm"
shape.plate_with_hole = { hole_radius = "5 mm", outline.strip = { half_width = "15 mm", left = "50 mm", right = "15 mm" } }
[bodies.pin]
material = "st"
thickness = "3 mm"
shape.disk.radius = "4.985 mm"
[[contacts]]
first = "plate.hole"
second = "pin.rim"
friction.coulomb.mu = 0.65
[[supports]]
on = "pin.section"
fix = ["x", "y"]
[[loads]]
on = "plate.left"
force = { direction = [-1, 0], steps = ["1 kN", "4 kN", "1.5 kN", "0.1 kN"] }
[output]
fields = "none"
figures = false
"#;

const SMALL: &str = "analysis.kinematics=small";
const DEFORMED: &str = "analysis.kinematics=deformed-gaps";

/// How far `stated` of the contact in the step with this index is from that of `truth`, in parts of its error.
fn off(found: &Results, truth: &Results, step: usize, stated: Stated) -> f64 {
    let [own, other] = [found, truth].map(|results| &results.steps[step].edges[0]);
    let [value, better] = [own, other].map(|edge| stated.value(edge).unwrap());
    let doubt = other.errors.get(stated).unwrap_or(0.0);
    ((value - better).abs() - doubt) / own.errors.get(stated).unwrap()
}

/// In every load step nodes of the pin stand where those of the hole face them, so that stresses at the ends of contact are as accurate on the deformed geometry as on the undeformed one.
#[test]
fn slip_does_not_spoil_peaks_on_the_deformed_geometry() {
    let soft = PIN
        .replace("72 GPa", "15 GPa")
        .replace("mu = 0.65", "mu = 0.3")
        .replace(r#", "1.5 kN", "0.1 kN""#, "");
    let found = solved(&soft, &[DEFORMED, r#"analysis.accuracy="1 %""#]);
    let ladder = found.ladder.as_ref().unwrap();
    assert_eq!(ladder.end, LadderEnd::Reached, "{ladder:?}");
    let truth = solved(&soft, &[DEFORMED, r#"analysis.accuracy="0.2 %""#]);
    for step in 0..2 {
        for stated in [
            Stated::PeakHoop,
            Stated::PeakPressure,
            Stated::FrictionForce,
        ] {
            let off = off(&found, &truth, step, stated);
            assert!(off < 1.0, "step {}, {stated:?}: {off}", step + 1);
        }
    }
}

/// A cusp of friction that increments leave at the end of contact is no part of a coarse model, whose own peak does not change with them.
#[test]
fn errors_hold_what_given_increments_leave() {
    let truth = solved(
        PIN,
        &[
            SMALL,
            "analysis.substeps=64",
            r#"analysis.accuracy="0.5 %""#,
        ],
    );
    for substeps in [4, 16] {
        let substeps = format!("analysis.substeps={substeps}");
        let found = solved(PIN, &[SMALL, &substeps, r#"analysis.accuracy="2 %""#]);
        for stated in [
            Stated::PeakHoop,
            Stated::PeakHoopPlace,
            Stated::FrictionWork,
        ] {
            let off = off(&found, &truth, 0, stated);
            assert!(off < 1.0, "{substeps}, {stated:?}: {off}");
        }
        assert_eq!(found.ladder.unwrap().end, LadderEnd::LoadPath, "{substeps}");
    }
}

/// A pin that is too large touches all around from the first increment on, and up to eight of them change nothing.
#[test]
fn work_of_friction_of_a_tight_pin_lies_within_its_error() {
    let tight = PIN.replace("4.985 mm", "5.005 mm").replace(
        "friction.coulomb.mu = 0.65",
        "friction.coulomb.mu = 0.3\ninterference = true",
    );
    let found = solved(&tight, &[SMALL, r#"analysis.accuracy="1 %""#]);
    let truth = solved(
        &tight,
        &[SMALL, "analysis.substeps=64", "analysis.contact_nodes=241"],
    );
    let off = off(&found, &truth, 0, Stated::FrictionWork);
    assert!(off < 1.0, "{off}");
}

/// Friction forces of the pin in its first step and in the unloading that follows, with so many increments on given nodes.
fn friction_with(increments: usize, ramp: &str) -> [f64; 2] {
    let found = solved(
        PIN,
        &[
            SMALL,
            "analysis.contact_nodes=61",
            &format!("analysis.substeps={increments}"),
            &format!("analysis.ramp={ramp}"),
        ],
    );
    [0, found.steps.len() - 1].map(|step| found.steps[step].edges[0].friction_force)
}

/// Equal increments approach what those that end as points close and open find at once, however few.
#[test]
fn increments_that_end_as_points_close_leave_nothing_of_friction() {
    let [few, many] = [2, 32].map(|count| friction_with(count, "contact"));
    let [coarse, fine] = [128, 512].map(|count| friction_with(count, "quadratic"));
    let scale = few[0].abs();
    let apart = |one: [f64; 2], step: usize| (one[step] - many[step]).abs() / scale;
    assert!(
        apart(few, 0) < 3e-4 && apart(few, 1) < 3e-4,
        "{few:?} {many:?}"
    );
    for step in 0..2 {
        let [coarse, fine] = [coarse, fine].map(|own| apart(own, step));
        assert!(fine < 0.5 * coarse && fine < 1e-3, "{coarse:e} {fine:e}");
    }
}

/// With static and dynamic friction another solver is asked too. It walks the same increments: in equal ones friction would differ by percents for these alone.
#[test]
fn another_solver_walks_the_same_increments() {
    let law = "contacts.0.friction={ static_dynamic = { static = 0.5, dynamic = 0.45 } }";
    let given = [
        "analysis.contact_nodes=41",
        "analysis.substeps=2",
        "analysis.ramp=contact",
    ];
    let found = solved(PIN, &[&[SMALL, law], &given[..]].concat());
    let differs = |own: &Finding| matches!(own, Finding::SolverDependent { .. });
    assert!(!found.findings.iter().any(differs), "{:?}", found.findings);
}

/// A cylinder on a softer half-plane with friction, pressed, pressed on and let go.
const CYLINDER: &str = r#"
version = 1
analysis.plane = "strain"
[materials.al.isotropic]
young = "70 GPa"
poisson = 0.33
[materials.st.isotropic]
young = "210 GPa"
poisson = 0.3
[bodies.flat]
material = "al"
thickness = "1 mm"
model = "half-plane"
shape.block = { half_length = "10 mm", depth = "10 mm" }
[bodies.cylinder]
material = "st"
thickness = "1 mm"
model = "half-plane"
shape.cylinder = { radius = "50 mm", half_length = "10 mm", depth = "10 mm" }
[[contacts]]
first = "cylinder.contact"
second = "flat.contact"
gap = "linearised"
friction.coulomb.mu = 0.3
[[supports]]
on = "flat.bottom"
fix = ["x", "y"]
[[platens]]
on = "cylinder.top"
free = ["x", "y"]
[[loads]]
on = "cylinder.top"
force = { direction = [0, -1], steps = ["500 N", "1 kN", "300 N"] }
[output]
fields = "none"
figures = false
"#;

/// Eight increments that are divided where points close do what 512 equal ones do not yet: of 256 each closes one of few nodes, and peaks change with their number.
#[test]
fn few_increments_do_where_they_end_as_points_close() {
    let found = solved(CYLINDER, &[r#"analysis.accuracy="2 %""#]);
    let ladder = found.ladder.as_ref().unwrap();
    assert_eq!(ladder.end, LadderEnd::Reached);
    let last = ladder.rungs.last().unwrap();
    assert_eq!(last.most_increments(), 8);
    // Given increments are equal.
    let truth = solved(
        CYLINDER,
        &[r#"analysis.accuracy="1 %""#, "analysis.substeps=512"],
    );
    for step in 0..3 {
        for stated in [
            Stated::PeakHoop,
            Stated::PeakPressure,
            Stated::StickExtent,
            Stated::FrictionWork,
        ] {
            let [own, other] = [&found, &truth]
                .map(|results| stated.value(&results.steps[step].edges[0]).unwrap());
            let [error, other_error] =
                [&found, &truth].map(|results| results.steps[step].edges[0].errors.get(stated));
            // The last peak stress has no limit.
            let (Some(error), Some(other_error)) = (error, other_error) else {
                assert_eq!((step, stated), (2, Stated::PeakHoop));
                continue;
            };
            assert!(
                (own - other).abs() <= error + other_error,
                "step {}, {stated:?}: {own} ± {error}, {other} ± {other_error}",
                step + 1
            );
        }
    }
}

/// Tractions may stay while the work of friction does not: more increments of the first step of a growing load find another slip alone.
#[test]
fn increments_that_change_the_work_of_friction_are_found() {
    let joint = include_str!("../../../../scenes/joint-computed-contact.toml");
    let found = solved(joint, &["output.fields=none", "output.figures=false"]);
    let coarse = found.findings.iter().find_map(|finding| match finding {
        Finding::CoarseLoadPath(coarse) => Some(coarse),
        _ => None,
    });
    let coarse = coarse.unwrap();
    assert_eq!(coarse.steps, [1]);
    assert!(coarse.traction_change < 1e-6 && coarse.dissipation_change.abs() > 0.3);
}

/// A whole model, whose pin is free to turn: moments are kept where forces go over to the nodes of the model.
#[test]
fn a_whole_pin_balances_on_nodes_of_each_step() {
    let changes = [
        DEFORMED,
        "contacts.0.friction.coulomb.mu=0.3",
        r#"analysis.accuracy="5 %""#,
    ];
    let [found, half] = ["whole", "half"].map(|model| {
        let model = format!("analysis.model={model}");
        solved(PIN, &[&changes[..], &[&*model]].concat())
    });
    for step in 0..4 {
        assert!(found.steps[step].balance_residual < 1e-9);
        for stated in [
            Stated::PeakHoop,
            Stated::PeakPressure,
            Stated::FrictionForce,
        ] {
            let off = off(&found, &half, step, stated);
            assert!(off < 1.0, "step {}, {stated:?}: {off}", step + 1);
        }
    }
}
