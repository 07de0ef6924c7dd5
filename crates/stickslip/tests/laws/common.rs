//! The aluminium plate of the ready scenes, as truth and as model.

use std::path::Path;
use std::sync::Arc;

use rand::rngs::StdRng;
use rand::{RngExt, SeedableRng};
use stickslip::experiment::SpecimenScene;
use stickslip::experiment::laws::{Candidate, ContactModel, Observation};
use stickslip::host::HOST;
use stickslip::scene::{Format, Scene};
use stickslip_friction::FrictionLaw;
use stickslip_hybrid::data::Measurement;

/// Lines per mm of the report's grating.
pub(crate) const FREQUENCY: f64 = 2400.0;
/// Standard deviation of an order with an error of up to a quarter fringe, evenly spread.
pub(crate) const QUARTER: f64 = 0.25 / 1.732_050_807_568_877_2;
/// Radius of the hole `[mm]`.
pub(crate) const RADIUS: f64 = 9.525;

/// The scene `name` with `overrides`, seen at the plate's hole.
pub(crate) fn scene(name: &str, overrides: &[&str]) -> SpecimenScene {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("../../scenes/{name}.toml"));
    SpecimenScene {
        scene: Arc::new(Scene::from_file(&path, overrides, HOST).unwrap()),
        body: "plate".to_owned(),
        edge: "hole".to_owned(),
    }
}

/// Nodes every `degrees` along the fine part of the edge.
pub(crate) fn aluminium(degrees: f64) -> ContactModel {
    let spacing = format!("mesh.spacing=\"{degrees} deg\"");
    let coarse = format!("mesh.coarse_spacing=\"{} deg\"", (4.0 * degrees).min(9.0));
    ContactModel::new(&scene("pin-loaded-aluminium", &[&spacing, &coarse])).unwrap()
}

/// A law as a file of numbers spells it.
pub(crate) fn law(text: &str) -> Box<dyn FrictionLaw> {
    serde_json::from_str(text).unwrap()
}

pub(crate) fn candidate(name: &str, text: &str, free: &[(&str, [f64; 2])]) -> Candidate {
    Candidate::of_law(name, law(text).as_ref(), free).unwrap()
}

/// Places every `spacing` `[mm]` in a square window of half width `half` around the hole, clear of the edge by `clear`.
pub(crate) fn window(half: f64, spacing: f64, clear: f64) -> Vec<[f64; 2]> {
    let count = (2.0 * half / spacing) as i32;
    let at = |k: i32| -half + spacing * f64::from(k);
    (0..=count)
        .flat_map(|i| (0..=count).map(move |j| [at(i), at(j)]))
        .filter(|[x, y]| x.hypot(*y) >= RADIUS + clear)
        .collect()
}

/// Displacements of `truth` under `law` at load steps `steps`, each with an error of up to `error` fringes, evenly spread.
pub(crate) fn measured_fields(
    truth: &ContactModel,
    law: Arc<dyn FrictionLaw>,
    steps: &[usize],
    places: &[[f64; 2]],
    error: f64,
    seed: u64,
) -> Vec<Measurement> {
    let mut random = StdRng::seed_from_u64(seed);
    let view = truth.view(places).unwrap();
    let last = steps.iter().max().copied().unwrap_or(0);
    let states = truth.states(law, last + 1).unwrap();
    let field = |&step: &usize| {
        let exact = view.displacements(&states[step]);
        let mut noisy = |axis: usize| -> Vec<f64> {
            (0..places.len())
                .map(|k| {
                    let part = 2.0 * random.random::<f64>() - 1.0;
                    exact[2 * k + axis] + error * part / FREQUENCY
                })
                .collect()
        };
        Measurement {
            places: places.to_vec(),
            displacements: [noisy(0), noisy(1)],
            valid: [vec![true; places.len()], vec![true; places.len()]],
            deviation: [QUARTER / FREQUENCY; 2],
        }
    };
    steps.iter().map(field).collect()
}

/// The same as a fit of laws takes them.
pub(crate) fn measured(
    truth: &ContactModel,
    law: Box<dyn FrictionLaw>,
    steps: &[usize],
    places: &[[f64; 2]],
    error: f64,
    seed: u64,
) -> Vec<Observation> {
    let fields = measured_fields(truth, Arc::from(law), steps, places, error, seed);
    let both = steps.iter().zip(&fields);
    both.map(|(&step, data)| Observation::of_measurement(&format!("step {}", step + 1), step, data))
        .collect()
}

/// The quasi-isotropic laminate with fibre coverage, its nodes every `degrees`.
pub(crate) fn laminate(degrees: f64) -> ContactModel {
    let text = format!(
        r#"
version = 1
[plies.carbon]
e1 = "19584.7 ksi"
e2 = "1500 ksi"
g12 = "846.713 ksi"
nu12 = 0.28
thickness = "0.005 in"
[materials.laminate.laminate]
layup = "[0_2/60_2/-60_2]s"
ply = "carbon"
[materials.aluminium.isotropic]
young = "10400 ksi"
poisson = 0.33
[bodies.plate]
material = "laminate"
[bodies.plate.shape.plate_with_hole]
hole_radius = "0.375 in"
outline.strip = {{ half_width = "1.495 in", left = "7.005 in", right = "1.5 in" }}
[bodies.pin]
material = "aluminium"
thickness = "0.06 in"
shape.disk = {{ radius = "0.3745 in" }}
[mesh]
element = "Q8"
spacing = "{degrees} deg"
[[contacts]]
name = "pin"
first = "plate.hole"
second = "pin.rim"
[contacts.friction.fibre_coverage]
fibre_fraction = 0.6
kernel.tangent = {{ width = "15 deg" }}
fibre.coulomb = {{ mu = 0.1 }}
matrix.coulomb = {{ mu = 0.4 }}
[[supports]]
on = "pin.centre"
fix = ["x", "y"]
[[loads]]
on = "plate.left"
force = {{ direction = [-1, 0], steps = ["750 lbf", "1500 lbf", "900 lbf"] }}
"#
    );
    let none: [&str; 0] = [];
    let scene = Scene::from_text_on(
        &text,
        Format::Toml,
        "laminate.toml",
        Path::new("."),
        &none,
        HOST,
    );
    ContactModel::new(&SpecimenScene {
        scene: Arc::new(scene.unwrap()),
        body: "plate".to_owned(),
        edge: "hole".to_owned(),
    })
    .unwrap()
}

/// How many seeds a study of intervals asks: `few`, or as many as the environment variable `STICKSLIP_SEEDS` says.
pub(crate) fn seeds(few: u64) -> u64 {
    let many = std::env::var("STICKSLIP_SEEDS").ok();
    many.and_then(|own| own.parse().ok()).unwrap_or(few)
}
