//! Numbers that are stated with an error, and the accuracies that bound them.

use std::f64::consts::PI;

use stickslip::results::{Bounded, EdgeRow, Finding, LadderEnd, Results, SetStated, Stated};

use super::displacement::ELEMENTS;
use super::series::{PIN, without_mesh};
use super::{difference, solved};

/// A frictional pin that is loaded and unloaded, in increments of the program.
fn found(accuracy: &str) -> Results {
    let text = PIN.replace("substeps = 1\n", "");
    solved(&text, &[&format!("analysis.accuracy={accuracy}")])
}

#[test]
fn every_number_of_a_contact_has_an_error() {
    let found = found("\"2 %\"");
    for step in &found.steps {
        let edge = &step.edges[0];
        for stated in Stated::ALL {
            let error = edge.errors.get(stated);
            assert!(
                stated.value(edge).is_none() || error.is_some(),
                "{stated:?}"
            );
        }
        let works = step.edges.iter();
        let sum: f64 = works
            .filter_map(|edge| edge.errors.get(Stated::FrictionWork))
            .sum();
        assert_eq!(step.dissipation_error(&found.edges), Some(sum));
    }
}

#[test]
fn slip_resultant_and_work_lie_within_their_errors() {
    let (found, truth) = (found("\"3 %\""), found("\"0.5 %\""));
    for (step, truth) in found.steps.iter().zip(&truth.steps) {
        let (edge, truth) = (&step.edges[0], &truth.edges[0]);
        for stated in [
            Stated::ResultantX,
            Stated::ResultantY,
            Stated::SlipAway,
            Stated::SlipTowards,
            Stated::FrictionWork,
        ] {
            let apart = stated.value(edge).unwrap() - stated.value(truth).unwrap();
            let [own, doubt] = [edge, truth].map(|edge| edge.errors.get(stated).unwrap());
            assert!(
                apart.abs() <= own + doubt,
                "{stated:?}: {apart:e} beyond {own:e}"
            );
        }
    }
}

/// Tractions and stresses at nodes lie within their errors of those of a finer answer, but for single nodes beside ends of zones.
#[test]
fn tractions_lie_within_their_errors() {
    let (found, truth) = (found("\"3 %\""), found("\"0.5 %\""));
    let (geometry, finer) = (&found.edges[0], &truth.edges[0]);
    let (mut within, mut all) = (0, 0);
    for (step, truth) in found.steps.iter().zip(&truth.steps) {
        let (edge, truth) = (&step.edges[0], &truth.edges[0]);
        assert_eq!(edge.row_errors.len(), edge.rows.len());
        let rows = edge.rows.iter().zip(&edge.row_errors);
        for ((row, errors), &place) in rows.zip(&geometry.parameter) {
            let own = [row.pressure, row.shear, row.sigma_tangential];
            let errors = [errors.pressure, errors.shear, errors.sigma_tangential];
            let exact = finer.values_at(&truth.rows, place);
            for number in 0..3 {
                all += 1;
                let apart = (own[number] - exact[number]).abs();
                within += usize::from(apart <= errors[number] + 1e-9);
            }
        }
        // Where there is no contact there is no doubt of that, away from its ends.
        let far = edge.row_errors.last().unwrap();
        assert_eq!([far.pressure, far.shear], [0.0; 2]);
        assert!(far.sigma_tangential > 0.0);
    }
    assert!(within as f64 >= 0.97 * f64::from(all), "{within} of {all}");
}

/// Without friction no force depends on which way points slip.
#[test]
fn slip_without_friction_has_no_error() {
    let changes = [
        "contacts.0.friction.coulomb.mu=0",
        "analysis.accuracy=\"2 %\"",
    ];
    let found = solved(&PIN.replace("substeps = 1\n", ""), &changes);
    let edge = &found.steps[0].edges[0];
    assert!(edge.errors.get(Stated::SlipAway).is_none());
    assert!(edge.errors.get(Stated::PeakPressure).is_some());
}

/// Works of single contacts are those of the step, and while loading contact slips wherever it does not stick.
#[test]
fn extents_and_works_add_up() {
    let found = solved(PIN, &["analysis.contact_nodes=121", "analysis.substeps=4"]);
    // While unloading, further zones stick.
    for step in &found.steps[..2] {
        let edge = &step.edges[0];
        let works = step.edges.iter().map(|edge| edge.friction_work);
        assert!(difference([step.dissipation], [works.sum()]) < 1e-12);
        let slip: f64 = edge.slip_lengths.unwrap().iter().sum();
        let stick = edge.stick_half_extent.unwrap();
        let rest = edge.contact_half_extent.unwrap() - stick - 0.5 * slip;
        // Zones end at nodes, 1.5° apart, and the end of contact within two of these.
        assert!(rest.abs() < 0.053, "{rest}");
    }
}

/// A single number is reached with no more nodes than all of them.
#[test]
fn a_named_number_alone_decides() {
    let [named, all] = [r#"{ contact_extent = "1 %" }"#, "\"1 %\""].map(found);
    let nodes = [&named, &all].map(|found| found.edges[0].parameter.len());
    assert!(nodes[0] <= nodes[1], "{nodes:?}");
    let ladder = named.ladder.unwrap();
    assert_eq!(ladder.end, LadderEnd::Reached);
    let mut errors = ladder.rungs.iter().filter_map(|rung| rung.error);
    assert!(errors.all(|(_, of)| of == Stated::ContactExtent.into()));
}

/// Nodes are divided until a stiffness is as accurate as asked, and the truth, of a far finer answer, lies within its error.
#[test]
fn a_stiffness_is_as_accurate_as_asked() {
    let text = PIN.replace("substeps = 1\n", "");
    let section = r#"supports.0={ on = "pin.section", fix = ["x", "y"] }"#;
    for model in [&[][..], &ELEMENTS] {
        let by = |error: &str| {
            let accuracy = format!("analysis.accuracy={{ stiffness = \"{error}\" }}");
            solved(&text, &[&[section, &accuracy], model].concat())
        };
        let truth = by("0.02 %");
        for asked in ["2 %", "0.1 %"] {
            let found = by(asked);
            let ladder = found.ladder.as_ref().unwrap();
            assert_eq!(ladder.end, LadderEnd::Reached, "{asked}");
            let stiffness = Bounded::from(SetStated::Secant);
            let bound = stiffness.bound(ladder.asked.unwrap()).unwrap();
            let mut named = ladder.rungs.iter().filter_map(|rung| rung.error);
            assert!(named.all(|(_, of)| of == stiffness));
            for step in 0..3 {
                let [own, exact] = [&found, &truth].map(|all| {
                    let value = all.set_numbers(0, step).get(SetStated::Secant).unwrap();
                    (
                        value,
                        all.set_errors(0, step).get(SetStated::Secant).unwrap(),
                    )
                });
                assert!(own.1 <= bound * own.0, "{asked} {step}: {own:?}");
                assert!(
                    (own.0 - exact.0).abs() <= own.1 + exact.1,
                    "{asked} {step}: {own:?} {exact:?}"
                );
            }
        }
    }
}

/// A plate without edges has nothing but displacements and reactions that could be accurate.
#[test]
fn without_edges_an_accuracy_bounds_displacements() {
    let text = without_mesh("scenes/open-hole.toml");
    let text = text.replace("[[edges]]\non = \"plate.hole\"", "");
    for asked in [0.01, 1e-4] {
        let found = solved(&text, &[&format!("analysis.accuracy={asked}")]);
        let ladder = found.ladder.as_ref().unwrap();
        let error = ladder.rungs.last().and_then(|rung| rung.error);
        let (error, number) = error.unwrap();
        assert_eq!(ladder.end, LadderEnd::Reached);
        assert!(error <= asked && number == SetStated::Displacement.into());
    }
}

/// A named number that can have no error is not reached, however accurate the others are.
#[test]
fn what_has_no_error_is_not_reached() {
    let text = PIN.replace("substeps = 1\n", "");
    for (accuracy, numbers) in [
        (
            r#"{ contact_extent = "10 %", displacement = "10 %" }"#,
            &["displacement"][..],
        ),
        (
            r#"{ displacement = "10 %", stiffness = "10 %" }"#,
            &["displacement", "stiffness"],
        ),
        (
            r#"{ displacement = "10 %", peak_pressure = "1e-5 %" }"#,
            &["displacement"],
        ),
    ] {
        let is_reached = !accuracy.contains("1e-5");
        let accuracy = format!("analysis.accuracy={accuracy}");
        let changes = [&[accuracy.as_str(), "analysis.memory=60 MB"], &ELEMENTS[..]];
        let found = solved(&text, &changes.concat());
        let end = found.ladder.as_ref().unwrap().end;
        assert_eq!(end == LadderEnd::Unstated, is_reached, "{end:?}");
        assert_ne!(end, LadderEnd::Reached);
        let is_said = |own: &Finding| matches!(own, Finding::AccuracyUnstated { numbers: own } if own == numbers);
        assert!(found.findings.iter().any(is_said), "{:?}", found.findings);
    }
    let reaction = r#"analysis.accuracy={ reaction = "1 %" }"#;
    let found = solved(&text, &[reaction]);
    assert_eq!(found.ladder.unwrap().end, LadderEnd::Reached);
}

/// A stiffness is measured by itself, however stiff the body is against another load.
#[test]
fn a_small_stiffness_is_as_accurate_as_a_large_one() {
    let beam = r#"
version = 1
[materials.metal.isotropic]
young = "70 GPa"
poisson = 0.3
[bodies.beam]
material = "metal"
thickness = "1 mm"
shape.rectangle = { width = "200 mm", height = "2 mm" }
[mesh]
element = "T3"
spacing = "1 mm"
[analysis]
accuracy.stiffness = "1 %"
[[supports]]
on = "beam.left"
fix = ["x", "y"]
[[loads]]
on = "beam.right"
force = { direction = [1, 0], steps = ["10 N"] }
[[loads]]
on = "beam.right"
force = { direction = [0, 1], steps = ["0.1 N"] }
[output]
fields = "none"
figures = false
"#;
    let found = solved(beam, &[]);
    let ladder = found.ladder.as_ref().unwrap();
    assert_eq!(ladder.end, LadderEnd::Pinned);
    let (error, of) = ladder.rungs.last().unwrap().error.unwrap();
    assert!(error > 0.05 && of == SetStated::Secant.into(), "{error}");
    // E h³ t/4 L³, of which constant strain leaves a multiple.
    let bending = found.set_numbers(1, 0).get(SetStated::Secant).unwrap();
    assert!(bending > 1.2 * 70e3 * 8.0 / 4.0 / 8e6, "{bending}");
}

/// Every name bounds its own number.
#[test]
fn each_name_bounds_its_number() {
    for (name, stated) in [
        ("peak_pressure", Bounded::Edge(Stated::PeakPressure)),
        ("peak_hoop", Bounded::Edge(Stated::PeakHoop)),
        ("contact_extent", Bounded::Edge(Stated::ContactExtent)),
        ("stick_extent", Bounded::Edge(Stated::StickExtent)),
        ("friction_force", Bounded::Edge(Stated::FrictionForce)),
        ("normal_force", Bounded::Edge(Stated::NormalForce)),
        ("hoop_at_bearing", Bounded::Edge(Stated::HoopAtBearing)),
        ("displacement", Bounded::Set(SetStated::Displacement)),
        ("stiffness", Bounded::Set(SetStated::Secant)),
        ("tangent_stiffness", Bounded::Set(SetStated::Tangent)),
        ("reaction", Bounded::Set(SetStated::Force)),
    ] {
        let scene = super::scene(PIN, &[&format!("analysis.accuracy={{ {name} = \"3 %\" }}")]);
        let accuracy = scene.analysis.accuracy.unwrap();
        let bounded: Vec<_> = Bounded::all(accuracy).collect();
        assert_eq!(bounded, [(stated, 0.03)], "{name}");
        // What `check` prints is read again.
        assert_eq!(
            super::scene(scene.resolved(), &[]).analysis.accuracy,
            Some(accuracy)
        );
    }
}

/// Where the model on the deformed geometry gives no answer, no number has an error, no accuracy is reached, and it is said.
#[test]
fn without_the_deformed_geometry_no_error_is_stated() {
    let far = "loads.0.force.steps=[\"400 kN\"]";
    let results = solved(
        &PIN.replace("substeps = 1\n", ""),
        &[far, "analysis.accuracy=\"1 %\""],
    );
    let ladder = results.ladder.as_ref().unwrap();
    assert_eq!(ladder.end, LadderEnd::Unchecked);
    assert!(!ladder.rungs.is_empty() && ladder.rungs.iter().all(|rung| rung.error.is_none()));
    let is_said = |finding: &Finding| matches!(finding, Finding::GeometryUnchecked { .. });
    assert!(
        results.findings.iter().any(is_said),
        "{:?}",
        results.findings
    );
    let edge = &results.steps[0].edges[0];
    assert!(
        Stated::ALL
            .into_iter()
            .all(|stated| edge.errors.get(stated).is_none())
    );
    assert!(edge.row_errors.is_empty());
}

/// A peak may be wherever a node is within the peak's error, whatever that error comes from.
#[test]
fn the_place_of_the_peak_reaches_over_all_nodes_that_may_be_it() {
    let text = PIN.replace("substeps = 1\n", "");
    let changes = [
        "analysis.accuracy=\"5 %\"",
        "bodies.pin.shape.disk.radius=4.98 mm",
        "contacts.0.friction.coulomb.mu=0.5",
    ];
    let results = solved(&text, &changes);
    let geometry = &results.edges[0];
    for edge in results.steps.iter().map(|step| &step.edges[0]) {
        type Value = fn(&EdgeRow) -> f64;
        let stress: Value = |row| row.sigma_tangential;
        let pressure: Value = |row| row.pressure;
        let peaks = [
            (
                edge.peak_hoop,
                [Stated::PeakHoop, Stated::PeakHoopPlace],
                stress,
            ),
            (
                edge.peak_pressure,
                [Stated::PeakPressure, Stated::PeakPressurePlace],
                pressure,
            ),
        ];
        for (peak, stated, value) in peaks {
            let (most, at) = peak.unwrap();
            let [error, reach] = stated.map(|stated| edge.errors.get(stated).unwrap());
            for (row, other) in edge.rows.iter().zip(&geometry.parameter) {
                let away = stickslip::results::wrapped(other - at).abs();
                let is_lower = value(row) < most - error;
                assert!(is_lower || away <= reach + 1e-9, "{stated:?} {other} {at}");
            }
        }
    }
}

/// Nothing on a circle is farther away than half of it, whatever increments change where hardly a load is left.
#[test]
fn places_on_a_circle_are_off_by_half_of_it_at_most() {
    let text = PIN.replace("substeps = 1\n", "");
    let changes = [
        "analysis.accuracy=\"5 %\"",
        "analysis.model=whole",
        "loads.0.force.steps=[\"1 kN\", \"0.001 N\"]",
    ];
    let results = solved(&text, &changes);
    for edge in results.steps.iter().map(|step| &step.edges[0]) {
        for stated in [Stated::PeakPressurePlace, Stated::PeakHoopPlace] {
            let error = edge.errors.get(stated);
            assert!(error.is_some_and(|error| error <= PI), "{error:?}");
        }
    }
}

/// Where there is no model on the deformed geometry, or none is asked for, errors are stated, and it is said what they leave out.
#[test]
fn errors_say_that_they_leave_out_the_deformed_geometry() {
    let text = PIN.replace("substeps = 1\n", "");
    let reasons = |changes: &[&str]| {
        let asked = ["analysis.accuracy=\"40 %\""];
        let results = solved(&text, &[changes, &asked].concat());
        let errors = &results.steps[0].edges[0].errors;
        assert!(errors.get(Stated::PeakPressure).is_some());
        let why = results.findings.into_iter().filter_map(|own| match own {
            Finding::GeometryLeftOut { why } => Some(why),
            _ => None,
        });
        why.collect::<Vec<_>>()
    };
    let (mesh, auto) = ("mesh.spacing=6 deg", "analysis.kinematics=auto");
    let nodes = "analysis.contact_nodes=61";
    for known in [
        &[mesh, auto][..],
        &[mesh, "analysis.kinematics=small"],
        &[nodes],
    ] {
        assert!(reasons(known).is_empty(), "{known:?}");
    }
    for (left, part) in [
        (
            &[mesh, auto, "contacts.0.projection=mortar"][..],
            "mortar projection",
        ),
        (&[mesh], "where a mesh is given"),
    ] {
        let [why] = &reasons(left)[..] else {
            panic!("one reason")
        };
        assert!(why.contains(part), "{why}");
    }
}

/// An elliptic nose on a flat, without friction: two meshes may have the same peak by chance, which is not its error.
#[test]
fn a_peak_on_which_two_meshes_agree_has_an_error() {
    let at = |degrees: i32| {
        let (sin, cos) = f64::from(degrees).to_radians().sin_cos();
        [12.0 * sin, 8.0 - 8.0 * cos]
    };
    let place = |degrees: i32| {
        let [x, y] = at(degrees);
        format!("[\"{x:.6} mm\", \"{y:.6} mm\"]")
    };
    let piece = |from: i32, to: i32, further: &str| {
        let between: Vec<String> = (from / 5 + 1..to / 5).map(|k| place(5 * k)).collect();
        let (to, between) = (place(to), between.join(", "));
        format!("{{ name = \"nose\", to = {to}, spline = [{between}]{further} }}")
    };
    let nose = [
        piece(-80, -5, ""),
        piece(-5, 5, ", refine = 80"),
        piece(5, 80, ""),
    ]
    .join(", ");
    let ([left, _], start) = (at(-80), place(-80));
    let text = format!(
        r#"
version = 1
[analysis]
plane = "strain"
[materials.steel.isotropic]
young = "210 GPa"
poisson = 0.3
[bodies.cam]
material = "steel"
thickness = "10 mm"
[bodies.cam.shape.outline]
start = {start}
edges = [{nose}, {{ name = "side", to = ["{right} mm", "25 mm"] }}, {{ name = "back", to = ["{left} mm", "25 mm"] }}, {{ name = "other" }}]
[bodies.flat]
material = "steel"
thickness = "10 mm"
[bodies.flat.shape.outline]
start = ["-30 mm", "-30 mm"]
edges = [
  {{ name = "bottom", to = ["30 mm", "-30 mm"] }}, {{ name = "right", to = ["30 mm", "0 mm"] }}, {{ name = "top", to = ["0.8 mm", "0 mm"] }},
  {{ name = "top", to = ["-0.8 mm", "0 mm"], refine = 80 }}, {{ name = "top", to = ["-30 mm", "0 mm"] }}, {{ name = "left" }},
]
[[contacts]]
first = "cam.nose"
second = "flat.top"
friction.coulomb = {{ mu = 0.0 }}
[[supports]]
on = "flat.bottom"
fix = ["x", "y"]
[[platens]]
on = "cam.back"
free = ["y"]
[[loads]]
on = "cam.back"
force = {{ direction = [0, -1], steps = ["3 kN", "4 kN", "5 kN", "6 kN"] }}
[output]
fields = "none"
figures = false
"#,
        right = -left
    );
    let peak = |results: &Results, step: usize| {
        let edge = &results.steps[step].edges[0];
        let peak = Stated::PeakPressure;
        [peak.value(edge).unwrap(), edge.errors.get(peak).unwrap()]
    };
    let truth = solved(&text, &["analysis.accuracy={ peak_pressure = \"0.05 %\" }"]);
    for step in 0..4 {
        let force = format!("loads.0.force.steps=[\"{} kN\"]", 3 + step);
        let accuracy = "analysis.accuracy={ peak_pressure = \"1 %\", contact_extent = \"2 %\" }";
        let [found, error] = peak(&solved(&text, &[accuracy, &force]), 0);
        let [true_peak, doubt] = peak(&truth, step);
        assert!(
            (found - true_peak).abs() <= error + doubt,
            "{found} ± {error}, {true_peak} ± {doubt}"
        );
        assert!(error < 0.01 * found, "{error}");
    }
}
