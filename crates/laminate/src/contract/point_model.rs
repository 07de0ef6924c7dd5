//! The contract of point models; its equations stand at [`contract`](crate::contract).
//!
//! The difference of the stresses at ε ± h in one component, with h = [`STEP`] times the strain scale, is off by about h² times a
//! third derivative and by rounding over h. Where the two one-sided differences part by more than [`SMOOTH`] of the stiffness, the
//! response has a kink or a jump (a ply fails, a ply yields), and no derivative is compared there.

mod breach;
mod parameters;

pub use breach::{ParametersBreach, PointBreach, PointViolation};
pub use parameters::check_parameters;

use crate::progressive::{PointModel, PointResponse, PointState, ProgressiveError};

/// Half of a difference of strains, as a part of the strain scale.
const STEP: f64 = 5e-6;

/// Largest distance of one-sided differences, and of the tangent from the central one, as a part of the initial stiffness.
const SMOOTH: f64 = 1e-4;

/// Rounding of a response, relative to the stress and energy of the strain scale: return mappings stop within 1e-11 of their surface.
const ROUNDING: f64 = 1e-9;

type Checked<T = ()> = Result<T, Box<PointBreach>>;

/// A step of a path: total strain (xx, yy, xy) and temperature rise `[temperature]`.
type Step = ([f64; 3], f64);

/// Paths along which a point model is tested, each from the initial state.
#[derive(Clone, Debug, PartialEq)]
pub struct PointSample {
    /// Steps of each path: total strain (xx, yy, xy) and temperature rise `[temperature]`.
    pub paths: Vec<Vec<([f64; 3], f64)>>,
    /// Size of the strains > 0, dimensionless, by which differences and rounding are measured.
    pub strain_scale: f64,
}

impl PointSample {
    /// Makes a sample of 24 paths of 6 steps, with strains between ± `strain_scale` > 0 in each component, dimensionless, such as a few times the
    /// strain at first failure, and temperature rises between 0 and `temperature` `[temperature]`; every path ends unloaded.
    pub fn default_for(strain_scale: f64, temperature: f64) -> Self {
        /// Fractions of the roots of x⁵ = x + 1: points that fill a cube of four dimensions evenly.
        const RATIOS: [f64; 4] = [0.856_675, 0.733_892, 0.628_707, 0.538_597];
        let step = |index: usize| {
            let part = RATIOS.map(|ratio| (ratio * index as f64).fract());
            let strain = [0, 1, 2].map(|i| strain_scale * (2.0 * part[i] - 1.0));
            (strain, temperature * part[3])
        };
        let path = |path: usize| {
            let end = ([0.0; 3], 0.0);
            (1..=5)
                .map(|own| step(5 * path + own))
                .chain([end])
                .collect()
        };
        Self {
            paths: (0..24).map(path).collect(),
            strain_scale,
        }
    }
}

/// Tests `model` along `sample`.
///
/// # Errors
/// The first property that the model breaks, with the numbers.
pub fn check_point_model(
    model: &dyn PointModel,
    sample: &PointSample,
) -> Result<(), PointViolation> {
    run(model, sample).map_err(|breach| PointViolation { breach })
}

fn run(model: &dyn PointModel, sample: &PointSample) -> Checked {
    let positive = sample.strain_scale.is_finite() && sample.strain_scale > 0.0;
    if !positive || sample.paths.iter().all(Vec::is_empty) {
        let fault = "the sample holds no step, or its strain scale is not positive";
        return Err(Box::new(PointBreach::UselessSample { fault }));
    }
    let initial = model.initial_state();
    let start = respond(model, &initial, ([0.0; 3], 0.0))?;
    let stiffness = (0..3)
        .map(|i| start.tangent[i][i].abs())
        .fold(0.0, f64::max);
    let tested = Tested {
        model,
        scale: sample.strain_scale,
        stiffness,
    };
    tested.unchanged([0.0; 3], &initial, &start)?;
    tested.nonsense(&initial)?;
    let mut compared = 0;
    for path in &sample.paths {
        let mut state = initial.clone();
        for (index, &step) in path.iter().enumerate() {
            // A step of another path, which is rejected.
            let rejected = path[(index + 1) % path.len()];
            let response = tested.step(&state, step, rejected)?;
            compared += tested.tangent(&state, step, &response)?;
            state = response.trial;
        }
    }
    if compared == 0 {
        let fault = "the response is smooth nowhere along the sample, so no tangent was compared";
        return Err(Box::new(PointBreach::UselessSample { fault }));
    }
    Ok(())
}

/// The response to a step, finite and of that step.
fn respond(
    model: &dyn PointModel,
    state: &PointState,
    (strain, temperature): Step,
) -> Checked<PointResponse> {
    let response =
        model
            .respond(state, strain, temperature)
            .map_err(|cause| PointBreach::Refused {
                strain,
                temperature,
                cause,
            })?;
    let trial = &response.trial;
    let energies = [&trial.stored, &trial.dissipated];
    let finite = |value: &f64| value.is_finite();
    let layers_are_finite = trial.layers.iter().all(|layer| {
        let vectors = layer.stress.iter().chain(&layer.plastic_strain);
        vectors.chain([&layer.hardening]).all(finite)
    });
    for (quantity, is_finite) in [
        ("the stress", response.stress.iter().all(finite)),
        ("the tangent", response.tangent.iter().flatten().all(finite)),
        ("an energy", energies.into_iter().all(finite)),
        ("the state of a layer", layers_are_finite),
    ] {
        if !is_finite {
            return Err(Box::new(PointBreach::NotFinite { quantity, strain }));
        }
    }
    for (quantity, same) in [
        ("strain", trial.strain == strain),
        ("temperature rise", trial.temperature == temperature),
        ("number of layers", trial.layers.len() == state.layers.len()),
    ] {
        if !same {
            return Err(Box::new(PointBreach::OtherState { quantity, strain }));
        }
    }
    Ok(response)
}

/// A model with the scales of its test.
struct Tested<'a> {
    model: &'a dyn PointModel,
    /// Size of the strains.
    scale: f64,
    /// Largest entry on the diagonal of the initial tangent `[stress]`.
    stiffness: f64,
}

impl Tested<'_> {
    /// One step, tried again after a rejected one.
    fn step(&self, state: &PointState, step: Step, rejected: Step) -> Checked<PointResponse> {
        let response = respond(self.model, state, step)?;
        respond(self.model, state, rejected)?;
        let strain = step.0;
        if respond(self.model, state, step)? != response {
            return Err(Box::new(PointBreach::NotPure { strain }));
        }
        self.symmetric(strain, &response)?;
        self.energies(strain, state, &response.trial)?;
        let again = respond(self.model, &response.trial, step)?;
        self.same_stress(strain, response.stress, again.stress)?;
        self.unchanged(strain, &response.trial, &again)?;
        Ok(response)
    }

    fn symmetric(&self, strain: [f64; 3], response: &PointResponse) -> Checked {
        for (row, column) in [(0, 1), (0, 2), (1, 2)] {
            let (upper, lower) = (response.tangent[row][column], response.tangent[column][row]);
            // A NaN is not within the bound.
            let symmetric = (upper - lower).abs() <= ROUNDING * self.stiffness;
            if !symmetric {
                return Err(Box::new(PointBreach::NotSymmetric {
                    row,
                    column,
                    upper,
                    lower,
                    strain,
                }));
            }
        }
        Ok(())
    }

    fn energies(&self, strain: [f64; 3], before: &PointState, after: &PointState) -> Checked {
        if after.dissipated < before.dissipated {
            let (before, after) = (before.dissipated, after.dissipated);
            return Err(Box::new(PointBreach::NegativeDissipation {
                before,
                after,
                strain,
            }));
        }
        if after.stored < -ROUNDING * self.energy() {
            let stored = after.stored;
            return Err(Box::new(PointBreach::NegativeStored { stored, strain }));
        }
        let layers = before.layers.iter().zip(&after.layers);
        let healed = layers.map(|(old, new)| {
            (old.damage.fibre && !new.damage.fibre) || (old.damage.matrix && !new.damage.matrix)
        });
        match healed.enumerate().find(|(_, healed)| *healed) {
            Some((layer, _)) => Err(Box::new(PointBreach::Healed { layer, strain })),
            None => Ok(()),
        }
    }

    fn stress(&self) -> f64 {
        self.stiffness * self.scale
    }

    fn energy(&self) -> f64 {
        self.stress() * self.scale
    }

    fn same_stress(&self, strain: [f64; 3], before: [f64; 3], after: [f64; 3]) -> Checked {
        let pairs = before.into_iter().zip(after);
        same(strain, "a stress", pairs, self.stress())
    }

    /// The trial state of a step without change is the state; at the initial one the stress is zero.
    fn unchanged(&self, strain: [f64; 3], state: &PointState, again: &PointResponse) -> Checked {
        if *state == self.model.initial_state() {
            self.same_stress(strain, [0.0; 3], again.stress)?;
        }
        let after = &again.trial;
        let energies = [
            (state.stored, after.stored),
            (state.dissipated, after.dissipated),
        ];
        same(strain, "an energy", energies.into_iter(), self.energy())?;
        for (old, new) in state.layers.iter().zip(&after.layers) {
            let stresses = old.stress.into_iter().zip(new.stress);
            same(strain, "the stress of a layer", stresses, self.stress())?;
            let plastic = old.plastic_strain.into_iter().zip(new.plastic_strain);
            same(strain, "a plastic strain", plastic, self.scale)?;
            let hardening = [(old.hardening, new.hardening)].into_iter();
            same(strain, "a hardening variable", hardening, self.stress())?;
            let damage = [
                (old.damage.fibre, new.damage.fibre),
                (old.damage.matrix, new.damage.matrix),
            ];
            let damage = damage.map(|(old, new)| (f64::from(old), f64::from(new)));
            same(strain, "damage", damage.into_iter(), 1.0)?;
        }
        Ok(())
    }

    /// How many entries of the tangent could be compared with differences.
    fn tangent(
        &self,
        state: &PointState,
        (strain, temperature): Step,
        here: &PointResponse,
    ) -> Checked<usize> {
        let h = STEP * self.scale;
        let tolerance = SMOOTH * self.stiffness;
        let mut compared = 0;
        for column in 0..3 {
            let side = |step: f64| {
                let mut moved = strain;
                moved[column] += step;
                respond(self.model, state, (moved, temperature)).map(|found| found.stress)
            };
            let (left, right) = (side(-h)?, side(h)?);
            let one_sided = |row: usize| {
                let stress = here.stress[row];
                [(stress - left[row]) / h, (right[row] - stress) / h]
            };
            let differences = [0, 1, 2].map(one_sided);
            if differences
                .iter()
                .any(|[below, above]| (above - below).abs() > tolerance)
            {
                continue;
            }
            for (row, [below, above]) in differences.into_iter().enumerate() {
                let (stated, difference) = (here.tangent[row][column], 0.5 * (below + above));
                if (stated - difference).abs() > tolerance {
                    return Err(Box::new(PointBreach::WrongTangent {
                        row,
                        column,
                        stated,
                        difference,
                        tolerance,
                        strain,
                    }));
                }
                compared += 1;
            }
        }
        Ok(compared)
    }

    fn nonsense(&self, initial: &PointState) -> Checked {
        for (what, strain, temperature) in [
            ("a strain that is not a number", [0.0, f64::NAN, 0.0], 0.0),
            ("an infinite strain", [f64::INFINITY, 0.0, 0.0], 0.0),
            (
                "a temperature rise that is not a number",
                [0.0; 3],
                f64::NAN,
            ),
        ] {
            let found = self.model.respond(initial, strain, temperature);
            if !matches!(found, Err(ProgressiveError::NotFinite { .. })) {
                return Err(Box::new(PointBreach::NonsenseAccepted { what }));
            }
        }
        let mut longer = initial.clone();
        longer
            .layers
            .push(longer.layers.first().copied().unwrap_or_default());
        let found = self.model.respond(&longer, [0.0; 3], 0.0);
        if !matches!(found, Err(ProgressiveError::LayerCount { .. })) {
            let what = "a state with a layer too many";
            return Err(Box::new(PointBreach::NonsenseAccepted { what }));
        }
        Ok(())
    }
}

/// Pairs of numbers before and after that agree to rounding at the size `scale`.
fn same(
    strain: [f64; 3],
    quantity: &'static str,
    mut pairs: impl Iterator<Item = (f64, f64)>,
    scale: f64,
) -> Checked {
    match pairs.find(|(before, after)| (after - before).abs() > ROUNDING * scale) {
        Some((before, after)) => Err(Box::new(PointBreach::ZeroStep {
            quantity,
            before,
            after,
            strain,
        })),
        None => Ok(()),
    }
}
