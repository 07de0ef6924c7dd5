//! What a ladder chooses, and whether its errors hold.

use std::io;
use std::path::Path;
use std::sync::atomic::{AtomicU32, Ordering};

use stickslip::results::{ContactFinding, EdgeRow, Finding, LadderEnd, Results, RowErrors, Stated};
use stickslip::scene::host::{Host, System};
use stickslip::scene::{Format, Scene};

use super::series::PIN;
use super::{results, solved};

const SMALL: &str = "analysis.kinematics=small";
const DEFORMED: &str = "analysis.kinematics=deformed-gaps";

/// The pin whose increments the program chooses.
fn free() -> String {
    PIN.replace("[analysis]\nsubsteps = 1\n", "")
}

fn freely(changes: &[&str]) -> Results {
    solved(&free(), changes)
}

fn by(changes: &[&str]) -> Results {
    solved(PIN, changes)
}

/// The increments of each load step of its last model.
fn increments(found: &Results) -> &[usize] {
    &found
        .ladder
        .as_ref()
        .unwrap()
        .rungs
        .last()
        .unwrap()
        .increments
}

/// The numbers of every edge and step that are outside of the error of `found`, beside those of `truth` with theirs.
fn misses(found: &Results, truth: &Results, of: &[Stated]) -> Vec<String> {
    let mut misses = Vec::new();
    for (number, (step, other)) in found.steps.iter().zip(&truth.steps).enumerate() {
        for (edge, other) in step.edges.iter().zip(&other.edges) {
            for &stated in of {
                let (Some(value), Some(better)) = (stated.value(edge), stated.value(other)) else {
                    continue;
                };
                let [Some(own), Some(doubt)] = [edge, other].map(|edge| edge.errors.get(stated))
                else {
                    continue;
                };
                if (value - better).abs() > own + doubt {
                    misses.push(format!(
                        "step {}, {stated:?}: {value:e} ± {own:.1e}, {better:e} ± {doubt:.1e}",
                        number + 1
                    ));
                }
            }
        }
    }
    misses
}

#[test]
fn graded_nodes_hold_what_equal_ones_find() {
    let found = by(&[SMALL, r#"analysis.accuracy="0.5 %""#]);
    let ladder = found.ladder.as_ref().unwrap();
    assert!(
        ladder.rungs.last().unwrap().model.contains("graded"),
        "{ladder:?}"
    );
    let increments = format!(
        "analysis.substeps={}",
        4 * ladder.rungs.last().unwrap().most_increments()
    );
    let equal = by(&[
        SMALL,
        "analysis.contact_nodes=481",
        &increments,
        "analysis.ramp=quadratic",
    ]);
    let misses = misses(&found, &equal, &Stated::ALL);
    assert!(misses.is_empty(), "{misses:#?}");
}

/// Of the first model, with 3° elsewhere, they are an eighth of that apart where contact ends.
#[test]
fn nodes_are_close_where_contact_ends() {
    let found = by(&[
        SMALL,
        "contacts.0.friction.coulomb.mu=0",
        r#"analysis.accuracy="30 %""#,
    ]);
    let rungs = &found.ladder.as_ref().unwrap().rungs;
    assert_eq!(rungs.len(), 1, "{rungs:?}");
    let places = &found.edges[0].parameter;
    for step in &found.steps {
        let rows = &step.edges[0].rows;
        let end = rows.iter().position(|row| !row.status.touches()).unwrap();
        let apart = (places[end] - places[end - 1]).to_degrees();
        assert!((0.2..0.5).contains(&apart), "{apart}");
    }
}

#[test]
fn half_and_whole_agree_within_their_errors() {
    let [half, whole] = ["half", "whole"].map(|model| {
        let model = format!("analysis.model={model}");
        by(&[SMALL, &model, r#"analysis.accuracy="1 %""#])
    });
    // Of two mirrored peaks either may be the larger one.
    let is_place =
        |stated: &Stated| matches!(stated, Stated::PeakHoopPlace | Stated::PeakPressurePlace);
    let numbers: Vec<Stated> = Stated::ALL
        .into_iter()
        .filter(|stated| !is_place(stated))
        .collect();
    let misses = misses(&half, &whole, &numbers);
    assert!(misses.is_empty(), "{misses:#?}");
}

/// The reason for the geometry on which contact was found.
fn kinematics(found: &Results) -> (&str, &str) {
    let mut choices = found.choices.iter();
    let choice = choices.find(|choice| choice.what == "kinematics").unwrap();
    (&choice.value, &choice.reason)
}

#[test]
fn gaps_are_found_deformed_where_that_matters() {
    let frictionless = "contacts.0.friction.coulomb.mu=0";
    let [rough, fine] = ["20 %", "0.2 %"]
        .map(|accuracy| by(&[frictionless, &format!("analysis.accuracy=\"{accuracy}\"")]));
    let (value, reason) = kinematics(&rough);
    assert_eq!(value, "small displacement");
    assert!(
        reason.contains("which the stated errors contain"),
        "{reason}"
    );
    let (value, reason) = kinematics(&fine);
    assert_eq!(value, "deformed gaps");
    assert!(reason.contains("which matters to the accuracy"), "{reason}");
    let numbers = [
        Stated::PeakPressure,
        Stated::ContactExtent,
        Stated::NormalForce,
    ];
    let truth = by(&[frictionless, DEFORMED, "analysis.contact_nodes=481"]);
    for found in [&rough, &fine] {
        let misses = misses(found, &truth, &numbers);
        assert!(misses.is_empty(), "{misses:#?}");
    }
}

/// Beside Q8 elements with deformed gaps, graded to 0.125, 0.0625 and 0.03125° at the end of contact, whose nodes face each other there: 272.2 ± 1.8, 271.7 ± 2.5 and 272.4 ± 1.7 MPa. Where nodes
/// are paired at equal angles instead, 0.13° from what they face, finer elements find 266.2 MPa.
#[test]
fn peaks_with_friction_on_the_deformed_geometry_are_those_of_fine_elements() {
    const PEAK: f64 = 272.3;
    const DOUBT: f64 = 0.4;
    let text = PIN
        .replace("substeps = 1\n", "")
        .replace(r#""1 kN", "4 kN", "1.5 kN""#, r#""4 kN""#);
    for (accuracy, bound) in [("5 %", 0.05), ("1 %", 0.01)] {
        let accuracy = format!("analysis.accuracy=\"{accuracy}\"");
        let found = solved(&text, &[DEFORMED, &accuracy]);
        let edge = &found.steps[0].edges[0];
        let (peak, _) = edge.peak_hoop.unwrap();
        let error = edge.errors.get(Stated::PeakHoop).unwrap();
        assert!(error < bound * PEAK, "{error}");
        assert!(
            (peak - PEAK).abs() <= error + DOUBT,
            "{accuracy}: {peak} ± {error}"
        );
    }
}

/// Elements that are smaller than the way of a pin along its hole: their nodes are put where they face each other.
#[test]
fn peaks_of_small_elements_on_the_deformed_geometry_are_those_of_series() {
    let text = PIN.replace(r#""1 kN", "4 kN", "1.5 kN""#, r#""4 kN""#);
    let found = by_text(&text, 0.125);
    let edge = &found.steps[0].edges[0];
    let (peak, _) = edge.peak_hoop.unwrap();
    let error = edge.errors.get(Stated::PeakHoop).unwrap();
    assert!(
        error < 3.5 && (peak - 272.3).abs() <= error,
        "{peak} ± {error}"
    );
}

/// The scene `text` by Q8 elements that are graded to `fine` degrees at 72°.
fn by_text(text: &str, fine: f64) -> Results {
    let mut angles: Vec<f64> = (-6..=6).map(|k| 72.0 + fine * f64::from(k)).collect();
    for (sign, end) in [(-1.0, 0.0), (1.0, 180.0)] {
        let (mut at, mut width) = (72.0 + sign * 6.0 * fine, fine);
        while sign * (end - at) > 1.5 * width {
            width = (1.25 * width).min(2.0);
            at += sign * width;
            angles.push(at);
        }
        angles.push(end);
    }
    angles.sort_by(f64::total_cmp);
    let angles: Vec<String> = angles.iter().map(|at| format!("\"{at} deg\"")).collect();
    let mesh = format!("mesh.angles=[{}]", angles.join(", "));
    let changes = [
        DEFORMED,
        &mesh,
        "mesh.element=Q8",
        "analysis.substeps=16",
        r#"analysis.accuracy="1 %""#,
    ];
    solved(text, &changes)
}

/// A half model that is pushed back bears on the other side, and its extent of contact counts from there.
#[test]
fn extents_of_contact_count_from_where_a_step_bears() {
    let text = PIN.replace(r#""1 kN", "4 kN", "1.5 kN""#, r#""4 kN", "-2 kN""#);
    for kinematics in [SMALL, DEFORMED] {
        let [half, whole] = ["half", "whole"].map(|model| {
            let model = format!("analysis.model={model}");
            solved(&text, &[kinematics, &model, r#"analysis.accuracy="5 %""#])
        });
        let misses = misses(&half, &whole, &[Stated::ContactExtent]);
        assert!(misses.is_empty(), "{misses:#?}");
        for step in &half.steps {
            let extent = step.edges[0].contact_half_extent.unwrap();
            let error = step.edges[0].errors.get(Stated::ContactExtent).unwrap();
            assert!(
                extent < std::f64::consts::FRAC_PI_2 && error < 0.1,
                "{extent} ± {error}"
            );
        }
    }
}

/// Without friction nothing holds a plate against turning about its pin. Graded nodes, whose forces act within the circle, must not turn it either.
#[test]
fn bodies_that_turn_freely_find_deformed_gaps_on_graded_nodes() {
    let frictionless = "contacts.0.friction.coulomb.mu=0";
    let [half, whole] = ["half", "whole"].map(|model| {
        let model = format!("analysis.model={model}");
        by(&[
            frictionless,
            DEFORMED,
            &model,
            r#"analysis.accuracy="0.5 %""#,
        ])
    });
    let last = whole.ladder.as_ref().unwrap().rungs.last().unwrap();
    assert!(
        last.model.contains("graded nodes, deformed gaps"),
        "{last:?}"
    );
    let numbers = [
        Stated::PeakPressure,
        Stated::ContactExtent,
        Stated::NormalForce,
        Stated::PeakHoop,
    ];
    let misses = misses(&half, &whole, &numbers);
    assert!(misses.is_empty(), "{misses:#?}");
}

/// Steps whose path matters get more increments than others.
#[test]
fn load_steps_are_divided_each_for_itself() {
    let small_first = r#"loads.0={ on = "plate.left", force = { direction = [-1, 0], steps = ["20 N", "4 kN", "1.5 kN"] } }"#;
    let found = freely(&[SMALL, small_first, r#"analysis.accuracy="0.02 %""#]);
    let last = increments(&found);
    assert_eq!(last.len(), 3);
    assert!(last.iter().min() < last.iter().max(), "{last:?}");
    for (step, increments) in found.steps.iter().zip(last) {
        assert!(step.increments >= *increments);
    }
}

/// A rigid pin with so much friction that what the first increments lock in stays.
fn locked(changes: &[&str]) -> Results {
    let scene = [
        SMALL,
        "analysis.plane=strain",
        "bodies.pin={ rigid = true, shape.disk.radius = \"4.9992 mm\" }",
        "contacts.0.friction.coulomb.mu=0.85",
        r#"loads.0={ on = "plate.left", force = { direction = [-1, 0], steps = ["560 N", "270 N", "130 N", "65 N"] } }"#,
    ];
    freely(&[&scene, changes].concat())
}

/// How many nodes of a step that touch, farther than `apart` from the end of contact `[rad]`, have friction outside of their error and of what `truth` has, and of how many.
fn missed(found: &Results, truth: &Results, step: usize, apart: f64) -> [usize; 2] {
    let geometries = [found, truth].map(|of| &of.edges[0]);
    let [edge, better] = [found, truth].map(|of| &of.steps[step].edges[0]);
    let within = better.contact_half_extent.unwrap() - apart;
    let rows = edge.rows.iter().zip(&edge.row_errors);
    let rows = rows.zip(&geometries[0].parameter);
    let rows =
        rows.filter(|((row, _), at)| row.status.touches() && (apart == 0.0 || at.abs() < within));
    let is_missed = |((row, errors), at): ((&EdgeRow, &RowErrors), &f64)| {
        let [pressure, shear, _] = geometries[1].values_at(&better.rows, *at);
        let slack = 2e-3 * pressure.abs();
        (row.shear - shear).abs() > errors.shear + slack
    };
    let all: Vec<bool> = rows.map(is_missed).collect();
    [all.iter().filter(|&&missed| missed).count(), all.len()]
}

/// The tractions that increments of the first step lock in stay among the errors of later ones, near the kinks too that each increment leaves.
#[test]
fn what_an_early_step_leaves_stays_among_the_errors_of_later_ones() {
    let truth = locked(&[
        "analysis.substeps=1024",
        "analysis.ramp=quadratic",
        "analysis.contact_nodes=241",
    ]);
    let equal = "analysis.ramp=quadratic";
    let found = locked(&[equal, r#"analysis.accuracy={ peak_pressure = "1 %" }"#]);
    assert!(increments(&found)[0] > 8, "{:?}", increments(&found));
    let [outside, count] = missed(&found, &truth, 3, 0.0);
    assert!(20 * outside < count, "{outside} of {count}");

    // The errors of the first step are small: those of the last one are to blame on it.
    let found = locked(&[equal, r#"analysis.accuracy="5 %""#]);
    assert!(increments(&found)[0] > 8, "{:?}", increments(&found));
    // Closer to the end of contact the nodes of the truth, 1.5° apart, do not resolve it.
    let steps = (0..4).map(|step| missed(&found, &truth, step, f64::to_radians(3.0)));
    let [outside, count] = steps.fold([0; 2], |sum, own| [0, 1].map(|k| sum[k] + own[k]));
    assert!(20 * outside < count, "{outside} of {count}");
}

/// A press fit opens under a pull and closes again: up to eight equal increments all points slip then, and with more some stick, so that friction falls by 5 %. Increments that end where points
/// close find that.
#[test]
fn friction_of_contact_that_closes_again_lies_within_its_error() {
    let by_events = closing_again("contact");
    assert_eq!(increments(&by_events)[3], 8);
    let equal = closing_again("quadratic");
    assert!(increments(&equal)[3] >= 32, "{:?}", increments(&equal));
    for found in [by_events, equal] {
        // 1024 equal increments.
        for (step, exact) in [(3, -529.8), (4, -1259.7)] {
            let edge = &found.steps[step].edges[0];
            let error = edge.errors.get(Stated::FrictionForce).unwrap();
            assert!(
                (edge.friction_force - exact).abs() < error,
                "{} ± {error}",
                edge.friction_force
            );
        }
    }
}

/// A press fit that opens and closes, whose increments the program chooses.
fn closing_again(ramp: &str) -> Results {
    freely(&[
        SMALL,
        "bodies.plate.shape.plate_with_hole.hole_radius=6 mm",
        r#"bodies.plate.shape.plate_with_hole.outline.strip={ half_width = "18 mm", left = "70 mm", right = "24 mm" }"#,
        "bodies.pin.shape.disk.radius=6.01 mm",
        "contacts.0.interference=true",
        "contacts.0.friction.coulomb.mu=0.6",
        r#"loads.0={ on = "plate.left", force = { direction = [-1, 0], steps = ["0 N", "2 kN", "8 kN", "2 kN", "0 N"] } }"#,
        &format!("analysis.ramp={ramp}"),
        r#"analysis.accuracy="5 %""#,
    ])
}

/// A step that begins with all points open is ramped as the first one is, and ends as that does.
#[test]
fn a_step_that_begins_open_is_the_first_one_again() {
    let found = by(&[
        SMALL,
        "analysis.contact_nodes=61",
        "analysis.substeps=4",
        "analysis.ramp=quadratic",
        r#"loads.0={ on = "plate.left", force = { direction = [-1, 0], steps = ["4 kN", "0 N", "4 kN"] } }"#,
    ]);
    let [first, again] = [0, 2].map(|step| found.steps[step].edges[0].friction_force);
    assert!(
        (first - again).abs() < 1e-9 * first.abs(),
        "{first} {again}"
    );
}

/// A fit through few nodes between several ends of stick overshoots the largest stress by half of it. It is not taken, and so spoils no error: the ladder
/// ended at twice as many nodes and eight times as many increments before, at 11 %.
#[test]
fn a_fit_that_knows_nothing_spoils_no_error() {
    let found = freely(&[
        SMALL,
        r#"materials.aluminium={ orthotropic = { e1 = "70 GPa", e2 = "25.9 GPa", g12 = "41.2 GPa", nu12 = 0.3 } }"#,
        r#"materials.steel={ isotropic = { young = "40.9 GPa", poisson = 0.114 } }"#,
        "bodies.plate.thickness=2 mm",
        "bodies.pin.thickness=2 mm",
        "bodies.pin.shape.disk.radius=4.99886 mm",
        r#"bodies.plate.shape.plate_with_hole.outline.strip={ half_width = "21.9 mm", left = "54.4 mm", right = "20.4 mm" }"#,
        "contacts.0.friction.coulomb.mu=0.7235",
        r#"loads.0={ on = "plate.left", force = { direction = [-1, 0], steps = ["7.6 kN", "3.75 kN"] } }"#,
        r#"analysis.accuracy="5 %""#,
    ]);
    assert_eq!(found.ladder.as_ref().unwrap().end, LadderEnd::Reached);
    let edge = &found.steps[1].edges[0];
    let (stress, _) = edge.peak_hoop.unwrap();
    let error = edge.errors.get(Stated::PeakHoop).unwrap();
    // 64 increments and 674 nodes; 1024 and 600 give 429.5 ± 2.4.
    assert!(
        (stress - 430.9).abs() < error && error < 0.05 * stress,
        "{stress} ± {error}"
    );
}

/// Where friction drops when slip begins, the stress at the end of stick is infinite: no error is stated, and why.
#[test]
fn a_stress_without_a_limit_has_no_error() {
    let law = "contacts.0.friction={ static_dynamic = { static = 0.3, dynamic = 0.15 } }";
    let found = by(&[
        SMALL,
        law,
        r#"analysis.accuracy="0.01 %""#,
        "analysis.substeps=4",
    ]);
    // Of the numbers that have one the increments leave most.
    assert_eq!(found.ladder.as_ref().unwrap().end, LadderEnd::LoadPath);
    let finding = found.findings.iter().find_map(|finding| match finding {
        Finding::Contact {
            finding: ContactFinding::NoLimit { steps, numbers },
            ..
        } => Some((steps, numbers)),
        _ => None,
    });
    let (steps, numbers) = finding.unwrap();
    assert!(numbers.contains(&"peak tangential stress"), "{numbers:?}");
    for step in steps {
        let edge = &found.steps[step - 1].edges[0];
        assert!(
            Stated::ALL
                .iter()
                .any(|&stated| edge.errors.get(stated).is_none())
        );
    }
}

/// No files, and a clock that goes on by a second whenever it is asked.
#[derive(Debug, Default)]
struct Counter(AtomicU32);

impl System for Counter {
    fn read(&self, _: &Path, _: u64) -> io::Result<Vec<u8>> {
        Err(io::ErrorKind::Unsupported.into())
    }

    fn length(&self, _: &Path) -> io::Result<u64> {
        Err(io::ErrorKind::Unsupported.into())
    }

    fn seconds(&self) -> f64 {
        f64::from(self.0.fetch_add(1, Ordering::Relaxed))
    }
}

/// `text` with `changes` and a budget of so many readings of the clock.
fn within(text: &str, changes: &[&str], readings: u32) -> Results {
    let budget = format!(r#"analysis.budget="{readings} s""#);
    let changes = [changes, &[&budget]].concat();
    let host = Host::of(Counter::default());
    let read = Scene::from_text_on(
        text,
        Format::Toml,
        "pin.toml",
        Path::new(""),
        &changes,
        host,
    );
    results(&read.unwrap())
}

/// A model that is not ready when the budget is spent is given up, and the answer before it stands with its errors.
#[test]
fn a_budget_ends_within_a_model() {
    let asked = r#"analysis.accuracy="1e-6 %""#;
    let changes = [SMALL, asked, "analysis.substeps=16"];
    let finest = by(&changes);
    let mut stopped = 0;
    for readings in (40..120).step_by(5) {
        let found = within(PIN, &changes, readings);
        let ladder = found.ladder.as_ref().unwrap();
        assert_eq!(ladder.end, LadderEnd::Budget, "{readings}: {ladder:?}");
        let mut rungs = ladder.rungs.iter().rev();
        let last = rungs.next().unwrap();
        if last.stopped {
            stopped += 1;
            let before = rungs.next().and_then(|rung| rung.error);
            assert!(last.error.is_none() && before.is_some(), "{ladder:?}");
        }
        let misses = misses(&found, &finest, &Stated::ALL);
        assert!(misses.is_empty(), "{readings}: {misses:#?}");
    }
    assert!(stopped > 1, "{stopped}");
}

/// Where equal increments leave nearly all of a larger error than is asked, no finer nodes are tried.
#[test]
fn increments_that_leave_too_much_end_the_climb() {
    let asked = r#"analysis.accuracy={ friction_force = "1e-3 %" }"#;
    let found = freely(&[SMALL, "analysis.ramp=quadratic", asked]);
    let ladder = found.ladder.as_ref().unwrap();
    assert_eq!(ladder.end, LadderEnd::LoadPath);
    assert_eq!(ladder.rungs.last().unwrap().most_increments(), 64);
    // Those that end as points close leave less.
    let found = freely(&[SMALL, asked]);
    assert_eq!(found.ladder.as_ref().unwrap().end, LadderEnd::Finest);
}

/// A finer model that would take more memory than it may is not tried, and the answer before it stands with its errors.
#[test]
fn memory_ends_the_climb() {
    let free = free();
    let by = |memory: &str| {
        let changes = [
            SMALL,
            // With friction increments leave more than the division.
            "contacts.0.friction.coulomb.mu=0",
            "bodies.plate.model=elements",
            "bodies.pin.model=elements",
            "analysis.accuracy=\"0.2 %\"",
            memory,
        ];
        solved(&free, &changes)
    };
    let [little, much] = ["analysis.memory=\"60 MB\"", "analysis.memory=\"1 GB\""].map(by);
    let models = |found: &Results| found.ladder.as_ref().unwrap().rungs.len();
    assert_eq!(little.ladder.as_ref().unwrap().end, LadderEnd::Memory);
    assert!(models(&much) > models(&little));
    let missed = |own: &Finding| {
        matches!(
            own,
            Finding::AccuracyMissed {
                end: LadderEnd::Memory,
                ..
            }
        )
    };
    assert!(little.findings.iter().any(missed));
    let misses = misses(&little, &much, &Stated::ALL);
    assert!(misses.is_empty(), "{misses:#?}");
}

/// The same of increments that are left to the program.
#[test]
fn a_budget_ends_the_search_for_increments() {
    let free = free();
    let changes = [
        SMALL,
        "analysis.ramp=quadratic",
        r#"analysis.accuracy="0.01 %""#,
    ];
    let finest = freely(&changes);
    assert_eq!(finest.ladder.as_ref().unwrap().end, LadderEnd::LoadPath);
    let mut stopped = 0;
    for readings in (50..260).step_by(7) {
        let found = within(&free, &changes, readings);
        let ladder = found.ladder.as_ref().unwrap();
        let is_stopped = ladder.rungs.iter().any(|rung| rung.stopped);
        let increments = increments(&found);
        // With all of them no finer nodes are worth their time.
        let ends = if is_stopped || increments.iter().any(|&count| count < 64) {
            vec![LadderEnd::Budget]
        } else {
            vec![LadderEnd::Budget, LadderEnd::LoadPath]
        };
        assert!(ends.contains(&ladder.end), "{readings}: {ladder:?}");
        stopped += usize::from(is_stopped);
        let misses = misses(&found, &finest, &Stated::ALL);
        assert!(misses.is_empty(), "{readings}: {misses:#?}");
    }
    assert!(stopped > 1, "{stopped}");
}
