//! Friction laws fitted by contact solves to displacements whose law is known.
//!
//! ```text
//! χ²(θ) = |L⁻¹ (m − u(θ) − Z b)|²,     m: displacements of a finer mesh under the true law, each off by up to a quarter of a fringe
//! ```

mod transition;

use std::sync::Arc;

use rand::rngs::StdRng;
use rand::{RngExt, SeedableRng};
use stickslip::experiment::SpecimenScene;
use stickslip::experiment::laws::{
    Candidate, Comparison, ContactModel, Fit, Observation, coarser, fit_on_two_meshes, sensitivity,
};
use stickslip::host::HOST;
use stickslip::scene::Scene;
use stickslip_friction::{FrictionLaw, History};
use stickslip_hybrid::calibrate::Settings;
use stickslip_hybrid::data::Measurement;
use stickslip_hybrid::identify::Bounds;

use super::check::Tolerance::Absolute;
use super::check::{Check, Checks};
use super::laboratory::Laboratory;
use crate::publish::{TaskError, root};

/// Lines per millimetre.
const FREQUENCY: f64 = 2400.0;
/// Orders are off by up to so much, evenly spread.
const ERROR: f64 = 0.25;
/// Corner nodes of the mesh that makes the data, and of the one that is fitted, are so far apart `[deg]`. Two pairs, so that intervals
/// that hold the error of the model's mesh are seen where it is large and where it is small.
const PAIRS: [[f64; 2]; 2] = [[1.125, 2.25], [2.25, 4.5]];
const RADIUS: f64 = 9.525;
const DROP: &str = r#"{ "static_dynamic": { "static": 0.35, "dynamic": 0.25 } }"#;
const NONE: &str = r#"{ "coulomb": { "mu": 0.0 } }"#;

pub(super) fn checks(laboratory: &Laboratory) -> Result<Vec<Check>, TaskError> {
    let [fine, coarse] = PAIRS;
    let studies = [
        Study::new(fine[0], fine[1])?,
        Study::new(coarse[0], coarse[1])?,
    ];
    let coarse = &studies[1];
    let mut checks = Checks::against("the law that the displacements were solved with");
    let contact_solves = transition::checks(&mut checks, &studies, laboratory.sized(1, 4))?
        + drop_law(&mut checks, coarse)?
        + no_friction(&mut checks, coarse)?;
    checks.show(
        "histories solved by all fits",
        "",
        contact_solves.to_string(),
    );
    sensitivities(&mut checks)?;
    Ok(checks.into_list())
}

/// The drop without a length: its static coefficient hardly shows.
fn drop_law(checks: &mut Checks, study: &Study) -> Result<usize, TaskError> {
    let found = study.fitted(DROP, &[drop_candidate()?], &[3, 6, 9], 1)?;
    let own = &found.fits[0];
    let (dynamic, _) = estimate(own, "dynamic")?;
    checks.near(
        "drop: dynamic coefficient",
        [dynamic, 0.25],
        Absolute(0.002, ""),
    );
    let (_, bounds) = estimate(own, "static")?;
    let weak = match bounds {
        Bounds::AtMost(high) => high >= 0.35,
        Bounds::AtLeast(low) => low <= 0.35,
        Bounds::Nothing => true,
        Bounds::Between(..) => false,
    };
    checks.holds(
        "drop: static coefficient 0.35",
        "bounded on one side, or not identifiable",
        describe_bounds(bounds),
        weak,
    );
    Ok(evaluations(&found))
}

fn no_friction(checks: &mut Checks, study: &Study) -> Result<usize, TaskError> {
    let found = study.fitted(NONE, &[coulomb()?], &[3, 6, 9], 1)?;
    let (_, bounds) = estimate(&found.fits[0], "mu")?;
    checks.holds(
        "no friction: coefficient",
        "none, or at most 0.001",
        describe_bounds(bounds),
        matches!(bounds, Bounds::AtMost(high) if high <= 0.001),
    );
    Ok(evaluations(&found))
}

/// How far the hole's edge moves.
fn sensitivities(checks: &mut Checks) -> Result<(), TaskError> {
    let model = ContactModel::new(&aluminium(1.125)?)?;
    let law = drop_candidate()?;
    let changes = [vec![0.25, 0.30], vec![0.27, 0.37]];
    let found = sensitivity(&model, &law, &[0.25, 0.35], &changes, FREQUENCY);
    let found = found?;
    let largest = |values: &[f64]| values.iter().copied().fold(0.0, f64::max);
    checks.now_against(
        "an independent program on the same plate: at most 0.11 fringe, and 1.2 fringes",
    );
    let [drop, both] = [0, 1].map(|k| {
        found
            .get(k)
            .map_or(f64::NAN, |own| largest(&own.deformation))
    });
    checks.holds(
        "most that the hole's edge deforms: static coefficient from 0.35 to 0.30",
        "at most 0.11 fringes",
        format!("{drop:.4} fringes"),
        drop > 0.0 && drop <= 0.11,
    );
    checks.near(
        "most that the hole's edge deforms: both coefficients up by 0.02",
        [both, 1.2],
        Absolute(0.05, " fringes"),
    );
    Ok(())
}

/// A mesh that makes the data, a coarser one that is fitted, and one still coarser that says what the error of that is like.
struct Study {
    truth: ContactModel,
    model: ContactModel,
    coarser: ContactModel,
}

impl Study {
    fn new(truth: f64, model: f64) -> Result<Self, TaskError> {
        let own = aluminium(model)?;
        Ok(Self {
            truth: ContactModel::new(&aluminium(truth)?)?,
            model: ContactModel::new(&own)?,
            coarser: ContactModel::new(&coarser(&own))?,
        })
    }

    fn fitted(
        &self,
        true_law: &str,
        laws: &[Candidate],
        steps: &[usize],
        seed: u64,
    ) -> Result<Comparison, TaskError> {
        let data = self.observations(true_law, steps, seed)?;
        let settings = Settings::default();
        let Self { model, coarser, .. } = self;
        Ok(fit_on_two_meshes(model, coarser, laws, &data, &settings)?)
    }

    /// The longest slip path `[mm]` of any contact point of the truth after the load step `last`, counted from 0.
    fn slipped(&self, true_law: &str, last: usize) -> Result<f64, TaskError> {
        let states = self.truth.states(Arc::from(law(true_law)?), last + 1);
        let states = states?;
        let history = states.last().map_or(&[][..], |state| &state.history);
        let paths = history.iter().map(History::slip_path);
        Ok(paths.fold(0.0, f64::max))
    }

    /// Displacements every 2 mm in a window of 40 mm around the hole.
    fn observations(
        &self,
        true_law: &str,
        steps: &[usize],
        seed: u64,
    ) -> Result<Vec<Observation>, TaskError> {
        let at = |k: i32| -20.0 + 2.0 * f64::from(k);
        let places: Vec<[f64; 2]> = (0..=20)
            .flat_map(|i| (0..=20).map(move |j| [at(i), at(j)]))
            .filter(|[x, y]| x.hypot(*y) >= RADIUS + 0.2)
            .collect();
        let mut random = StdRng::seed_from_u64(seed);
        let view = self.truth.view(&places)?;
        let last = steps.iter().max().copied().unwrap_or(0);
        let law = Arc::from(law(true_law)?);
        let states = self.truth.states(law, last + 1)?;
        let observation = |&step: &usize| {
            let exact = view.displacements(&states[step]);
            let mut noisy = |axis: usize| -> Vec<f64> {
                (0..places.len())
                    .map(|k| {
                        let part = 2.0 * random.random::<f64>() - 1.0;
                        exact[2 * k + axis] + ERROR * part / FREQUENCY
                    })
                    .collect()
            };
            let measured = Measurement {
                displacements: [noisy(0), noisy(1)],
                valid: [vec![true; places.len()], vec![true; places.len()]],
                deviation: [ERROR / 3.0_f64.sqrt() / FREQUENCY; 2],
                places: places.clone(),
            };
            Observation::of_measurement(&format!("step {}", step + 1), step, &measured)
        };
        Ok(steps.iter().map(observation).collect())
    }
}

/// The aluminium plate with corner nodes every `degrees` along the fine part of its edge.
fn aluminium(degrees: f64) -> Result<SpecimenScene, TaskError> {
    let path = root().join("scenes/pin-loaded-aluminium.toml");
    let overrides = [
        format!("mesh.spacing=\"{degrees} deg\""),
        format!("mesh.coarse_spacing=\"{} deg\"", (4.0 * degrees).min(9.0)),
    ];
    let scene = Scene::from_file(&path, &overrides, HOST)?;
    Ok(SpecimenScene {
        scene: Arc::new(scene),
        body: "plate".to_owned(),
        edge: "hole".to_owned(),
    })
}

fn law(text: &str) -> Result<Box<dyn FrictionLaw>, TaskError> {
    Ok(serde_json::from_str(text)?)
}

fn candidate(name: &str, text: &str, free: &[(&str, [f64; 2])]) -> Result<Candidate, TaskError> {
    Candidate::of_law(name, law(text)?.as_ref(), free)
        .map_err(|(parameter, cause)| format!("{name}.{parameter}: {cause}").into())
}

fn coulomb() -> Result<Candidate, TaskError> {
    candidate("Coulomb", NONE, &[("mu", [0.0, 1.0])])
}

fn drop_candidate() -> Result<Candidate, TaskError> {
    let free = [("dynamic", [0.0, 1.0]), ("static", [0.0, 1.0])];
    candidate("drop", DROP, &free)
}

fn estimate(fit: &Fit, name: &str) -> Result<(f64, Bounds), TaskError> {
    let mut all = fit.calibration.estimates.iter();
    let own = all.find(|own| own.name == name);
    let own = own.ok_or_else(|| format!("no parameter '{name}'"))?;
    Ok((own.value, own.bounds))
}

fn describe_bounds(bounds: Bounds) -> String {
    match bounds {
        Bounds::Between(low, high) => format!("{low:.4} … {high:.4}"),
        Bounds::AtMost(high) => format!("at most {high:.4}"),
        Bounds::AtLeast(low) => format!("at least {low:.4}"),
        Bounds::Nothing => "not identifiable".to_owned(),
    }
}

fn evaluations(found: &Comparison) -> usize {
    let counts = found.fits.iter().map(|fit| fit.calibration.evaluations);
    counts.sum()
}
