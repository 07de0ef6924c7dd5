//! Relations between the answers of a scene and of the same scene seen another way.
//!
//! Both are solved from scratch. What a relation says exactly is asked for up to [`EXACT`]; what depends on the mesh or on the order of
//! events is asked for as far as theory goes. An answer that the results call one of several, or dependent on the path of the solution,
//! is declared and counted as such.

use serde_json::{Value, json};
use stickslip::results::Results;
use stickslip::scene::Format;

use super::answer::Answer;
use super::sample::{NoAnswer, Sample, Verdict, declared, read, run, solve};
use super::spelling;
use super::transform;

/// Rounding 1e-16 and solvers' residuals 1e-10, amplified by the condition of coarse bodies and of contact near its ends, about 1e3.
const EXACT: f64 = 1e-7;

/// By what scenes of outlines are turned `[deg]`.
const SPIN: f64 = 37.0;

/// The answer of `variant`, brought back by `back`, is that of `sample`.
fn same(sample: &Sample, variant: &Value, back: impl Fn(Answer) -> Answer) -> Verdict {
    match solve(variant) {
        Ok(other) => judge(sample, &other, &back(Answer::of(&other.results))),
        Err(none) => missing(sample, &none),
    }
}

/// A variant that must have an answer has none.
fn missing(sample: &Sample, none: &NoAnswer) -> Verdict {
    let message = format!("the variant is {}", none.describe());
    match sample.declared() {
        Some(note) => Verdict::Declared(format!("{message}; {note}")),
        None => Verdict::Fails(message),
    }
}

fn judge(sample: &Sample, other: &Sample, answer: &Answer) -> Verdict {
    compare(sample, other, &Answer::of(&sample.results), answer)
}

fn compare(sample: &Sample, other: &Sample, own: &Answer, answer: &Answer) -> Verdict {
    let difference = own.difference(answer, sample.give(), false);
    if difference.relative <= EXACT {
        return Verdict::Holds;
    }
    if let Some(note) = sample.declared().or_else(|| other.declared()) {
        return Verdict::Declared(format!("{}; {note}", difference.found));
    }
    let firm = own.difference(answer, sample.give(), true);
    if (own.is_free() || answer.is_free()) && firm.relative <= EXACT {
        return Verdict::Declared(format!("{}; gaps are noted as free", difference.found));
    }
    Verdict::Fails(firm.found)
}

/// The mirror image of the scene has the mirror image of the answer.
pub(super) fn mirrored(sample: &Sample) -> Verdict {
    let has = |shape: &str| {
        let mut bodies = super::quantity::table(&sample.value, "bodies");
        bodies.any(|(_, body)| body["shape"].get(shape).is_some())
    };
    let round = sample.is_round() || has("disk");
    // The cells of a rectangle have no mirror image.
    if has("rectangle") || sample.is_half() {
        return Verdict::Beside;
    }
    let mut scene = transform::mirrored(&sample.value, round);
    // What keeps a scene from being halved, such as an edge of its lower half, may lie in the other half of its image.
    scene["analysis"]["model"] = json!("whole");
    same(sample, &scene, |answer| answer.mirrored(round))
}

/// A scene of circles turned by a quarter has the turned answer: with quadrilaterals of equal spacing, and with contacts that know no
/// direction: neat fits and interference with any friction; clearance without friction and with the linearised gap, where one body alone
/// is held. Outlines and the pins in them are turned by any angle.
pub(super) fn turned(sample: &Sample) -> Verdict {
    if let Some(spun) = transform::spun(&sample.value, SPIN).filter(|_| !sample.is_half()) {
        return same(sample, &spun, |answer| answer.spun(-SPIN.to_radians()));
    }
    if !sample.is_circular() || !turns(&sample.value) {
        return Verdict::Beside;
    }
    let mut scene = sample.value.clone();
    scene["analysis"]["model"] = json!("whole");
    let quarters = 1 + (sample.results.steps.len() % 3) as u8;
    let turned = transform::turned(&scene, quarters);
    same(sample, &turned, |answer| answer.turned(4 - quarters))
}

fn turns(scene: &Value) -> bool {
    let meshes = [Some(&scene["mesh"])].into_iter().flatten();
    let own = scene["bodies"]
        .as_object()
        .into_iter()
        .flatten()
        .filter_map(|(_, body)| body.get("mesh"));
    let equal = meshes.chain(own).all(|mesh| {
        let quads = mesh.get("element").is_none_or(|element| {
            element
                .as_str()
                .is_some_and(|name| name.starts_with(['Q', 'P']))
        });
        let spacing = super::quantity::number(mesh, "/spacing");
        // The core of a pin has its corners at 45°.
        let eighth = spacing.map(|spacing| 45.0 / spacing);
        let fits = eighth.is_none_or(|cells| (cells - cells.round()).abs() < 1e-9);
        quads && fits && mesh.get("angles").is_none() && mesh.get("fine_to").is_none()
    });
    let contacts = super::quantity::list(scene, "contacts");
    let polar =
        super::quantity::list(scene, "loads").any(|load| load.get("polar_traction").is_some());
    let failure = scene.get("failure").is_some();
    equal
        && !polar
        && !failure
        && contacts.into_iter().all(|contact| {
            let radius = |key: &str| {
                let (body, set) = contact[key].as_str()?.split_once('.')?;
                let shape = &scene["bodies"][body]["shape"];
                let key = match set {
                    "hole" => "/plate_with_hole/hole_radius",
                    "outer" => "/plate_with_hole/outline/ring/radius",
                    _ => "/disk/radius",
                };
                super::quantity::number(shape, key)
            };
            let neat = radius("second") >= radius("first");
            let frictionless = contact
                .pointer("/friction/coulomb/mu")
                .is_some_and(|mu| *mu == 0.0);
            let linear = contact.get("gap").is_some_and(|gap| gap == "linearised");
            neat || frictionless && linear && held_bodies(scene) == 1
        })
}

/// Number of bodies that supports or platens hold.
fn held_bodies(scene: &Value) -> usize {
    let supports = super::quantity::list(scene, "supports");
    let platens = super::quantity::list(scene, "platens");
    let held = platens.filter(|platen| platen["free"].as_array().is_none_or(|free| free.len() < 2));
    let names = supports
        .chain(held)
        .filter_map(|entry| entry["on"].as_str()?.split('.').next());
    names.collect::<std::collections::BTreeSet<_>>().len()
}

/// The whole model of a scene that is solved by half of it.
pub(super) fn half_and_whole(sample: &Sample) -> Verdict {
    if !sample.is_half() {
        return Verdict::Beside;
    }
    let mut scene = sample.value.clone();
    scene["analysis"]["model"] = json!("whole");
    same(sample, &scene, |answer| answer)
}

/// Lengths × 7.3 and moduli × 3.1.
pub(super) fn rescaled(sample: &Sample) -> Verdict {
    let (length, stress) = (7.3, 3.1);
    let scene = transform::scaled(&sample.value, length, stress);
    same(sample, &scene, |answer| {
        answer.scaled(1.0 / length, 1.0 / stress)
    })
}

/// Moduli and loads × 1000.
pub(super) fn stiffer(sample: &Sample) -> Verdict {
    let scene = transform::scaled(&sample.value, 1.0, 1000.0);
    same(sample, &scene, |answer| answer.scaled(1.0, 1e-3))
}

/// The same scene in other units.
pub(super) fn other_units(sample: &Sample) -> Verdict {
    same(sample, &transform::in_inches(&sample.value), |answer| {
        answer
    })
}

/// Without friction the last load step alone gives what the history ends with.
pub(super) fn path(sample: &Sample) -> Verdict {
    if sample.results.steps.len() < 2 || sample.scene.contacts.is_empty() {
        return Verdict::Beside;
    }
    let smooth = transform::frictionless(&sample.value);
    let frictionless = sample.value["contacts"] == smooth["contacts"];
    let whole = if frictionless {
        None
    } else {
        Some(solve(&smooth))
    };
    let history = match &whole {
        None => sample,
        Some(Ok(history)) => history,
        // Friction may be what holds a body.
        Some(Err(none)) => return Verdict::Unanswered(none.describe()),
    };
    match solve(&transform::last_step(&smooth)) {
        Ok(last) => {
            let [own, others] = [history, &last].map(|one| Answer::of(&one.results).end());
            compare(history, &last, &own, &others)
        }
        Err(none) => missing(history, &none),
    }
}

/// Another solver finds the same. That it finds nothing is no contradiction.
pub(super) fn another_solver(sample: &Sample) -> Verdict {
    if sample.scene.contacts.is_empty() {
        return Verdict::Beside;
    }
    let mut scene = sample.value.clone();
    let own = scene["analysis"]["solver"].as_str().unwrap_or("auto");
    let other = match own {
        "auto" | "newton" if sample.results.steps.len().is_multiple_of(2) => "status",
        "auto" | "newton" => "pivoting",
        _ => "auto",
    };
    scene["analysis"]["solver"] = json!(other);
    match solve(&scene) {
        Ok(found) => judge(sample, &found, &Answer::of(&found.results)),
        Err(none) => Verdict::Unanswered(format!("{other}: {}", none.describe())),
    }
}

/// Keys in another order, as TOML and as JSON: the same hash, and the same bits.
pub(super) fn key_order(sample: &Sample) -> Verdict {
    let toml = match spelling::toml(&sample.value) {
        Ok(text) => text,
        Err(error) => return Verdict::Fails(format!("no TOML: {error}")),
    };
    let texts = [
        (spelling::backwards(&sample.value), Format::Json),
        (toml, Format::Toml),
    ];
    for (text, format) in texts {
        let scene = match read(&text, format) {
            Ok(scene) => scene,
            Err(none) => return Verdict::Fails(none.describe()),
        };
        if scene.hash != sample.scene.hash {
            return Verdict::Fails(format!("{format:?}: another hash"));
        }
        match run(&scene) {
            Ok(results) if bits(&results) == bits(&sample.results) => {}
            Ok(_) => return Verdict::Fails(format!("{format:?}: other bits")),
            Err(none) => return Verdict::Fails(none.describe()),
        }
    }
    Verdict::Holds
}

/// Bodies with other names, and contacts, supports and loads listed the other way round.
pub(super) fn renamed(sample: &Sample) -> Verdict {
    let scene = transform::renamed(&sample.value);
    // Further edges are named after their bodies.
    if scene == sample.value || !sample.scene.edges.is_empty() {
        return Verdict::Beside;
    }
    same(sample, &scene, |answer| answer)
}

/// Three threads give the bits of one.
pub(super) fn threads(sample: &Sample) -> Verdict {
    let pool = match rayon::ThreadPoolBuilder::new().num_threads(3).build() {
        Ok(pool) => pool,
        Err(error) => return Verdict::Unanswered(error.to_string()),
    };
    match pool.install(|| run(&sample.scene)) {
        Ok(results) if bits(&results) == bits(&sample.results) => Verdict::Holds,
        Ok(_) => Verdict::Fails("other bits on three threads".into()),
        Err(none) => Verdict::Fails(format!("on three threads {}", none.describe())),
    }
}

/// What is written, without times.
fn bits(results: &Results) -> String {
    let mut results = results.clone();
    results.phases.clear();
    for step in &mut results.steps {
        step.seconds = 0.0;
    }
    // Rust prints a number with the digits that give its bits back.
    format!("{:?} {:?}", results.edges, results.steps)
}

/// Twice as fine a mesh: contact forces and extents move by no more than the error that elements of their order have.
pub(super) fn another_mesh(sample: &Sample) -> Verdict {
    let Some(scene) = transform::refined(&sample.value) else {
        return Verdict::Beside;
    };
    // Histories with friction, and gaps between the facets of a mesh, are made of it.
    let faceted = super::quantity::list(&sample.value, "contacts")
        .any(|contact| contact.get("gap").is_some_and(|gap| gap == "faceted"));
    if sample.scene.contacts.is_empty() || faceted {
        return Verdict::Beside;
    }
    let coarse = &sample.results;
    let edges = coarse.steps.iter().flat_map(|step| &step.edges);
    let touching = edges.filter(|edge| edge.normal_force > 0.0);
    let touching = touching.map(|edge| edge.rows.iter().filter(|row| row.pressure > 0.0).count());
    if touching.min().unwrap_or(0) < RESOLVED {
        return Verdict::Beside;
    }
    let fine = match solve(&scene) {
        Ok(fine) => fine,
        Err(none) => return Verdict::Unanswered(none.describe()),
    };
    let mut worst = (0.0, String::new());
    for (index, geometry) in sample.contacts() {
        let forces = |results: &Results| -> Vec<f64> {
            let steps = results.steps.iter();
            steps.map(|step| step.edges[index].normal_force).collect()
        };
        let [coarse, fine] = [coarse, &fine.results].map(forces);
        let most = coarse.iter().copied().fold(0.0, f64::max);
        for (step, (coarse, fine)) in coarse.iter().zip(&fine).enumerate() {
            let apart = (coarse - fine).abs() / most;
            if apart > worst.0 {
                let (name, step, percent) = (&geometry.name, step + 1, 100.0 * apart);
                worst = (
                    apart,
                    format!("normal force of '{name}', step {step}: {percent:.1} %"),
                );
            }
        }
    }
    if worst.0 <= MESH {
        return Verdict::Holds;
    }
    match declared(coarse).or_else(|| fine.declared()) {
        Some(note) => Verdict::Declared(note),
        None => Verdict::Fails(worst.1),
    }
}

/// Nodes in contact from which on a mesh is said to resolve it.
const RESOLVED: usize = 5;
/// Largest change of a normal force by a mesh twice as fine.
const MESH: f64 = 0.3;
