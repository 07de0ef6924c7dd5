//! One experiment with many seeds.

use std::ops::RangeInclusive;
use std::path::Path;

use stickslip::experiment::analysed::Workbench;
use stickslip::experiment::identified::identify;
use stickslip::experiment::measured;
use stickslip::experiment::synthesis::Camera;
use stickslip::experiment::truth::Truth;
use stickslip::experiment::{Experiment, ExperimentError};
use stickslip_hybrid::identify::{Bounds, SlipFit};

use super::Trouble;
use crate::publish::side_by_side;

/// An experiment, and the dynamic coefficient of its scene.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Known {
    pub(crate) file: &'static str,
    pub(crate) mu: f64,
}

pub(crate) const WITH_FRICTION: Known = Known {
    file: "experiment.toml",
    mu: 0.25,
};
pub(crate) const WITHOUT_FRICTION: Known = Known {
    file: "no-friction.toml",
    mu: 0.0,
};

/// How far an identified coefficient may be from the truth.
pub(crate) const NEAR: f64 = 0.01;

/// How many of `seeds` intervals of 95 % are to hold the truth: 90 to 99 % of many, at least 90 % of a few.
pub(crate) fn wanted(seeds: usize) -> RangeInclusive<usize> {
    const MANY: usize = 100;
    let most = if seeds < MANY {
        seeds
    } else {
        seeds * 99 / 100
    };
    (seeds * 90).div_ceil(100)..=most
}

/// What one seed gives.
#[derive(Clone, Debug)]
pub(crate) struct Outcome {
    pub(crate) seed: u64,
    /// Coefficient of all zones of all states; `None` where no zone was recognised.
    pub(crate) together: Option<SlipFit>,
    /// Index of the state, first and last angle `[degree]` and coefficient of each zone.
    pub(crate) zones: Vec<(usize, [f64; 2], SlipFit)>,
}

/// All seeds of one experiment.
#[derive(Debug)]
pub(crate) struct Series {
    pub(crate) known: Known,
    pub(crate) outcomes: Vec<Outcome>,
    pub(crate) states: Vec<String>,
}

impl Series {
    /// Solves the scene once and goes through the chain with every seed.
    pub(crate) fn of(known: Known, seeds: RangeInclusive<u64>) -> Result<Self, Trouble> {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../scenes/hybrid-aluminium");
        let mut experiment = Experiment::from_file(&folder.join(known.file), &[] as &[&str])?;
        // The draws that confirm the interval are not asked for here.
        experiment.identify.samples = 2;
        let own = experiment.specimen.scene.clone();
        let own = own.ok_or("the experiment has no scene")?;
        let truth = Truth::solve(&own, &mut |_| ())?;
        let camera = Camera::new(&experiment, &truth)?;
        let bench = Workbench::new(&experiment)?;
        let seeds: Vec<u64> = seeds.collect();
        let outcomes = side_by_side(&seeds, |&seed| {
            Ok(outcome(&experiment, &camera.with_seed(seed), &bench, seed)?)
        })?;
        Ok(Self {
            known,
            outcomes,
            states: experiment
                .states
                .iter()
                .map(|state| state.name.clone())
                .collect(),
        })
    }

    fn coefficients(&self) -> impl Iterator<Item = f64> + '_ {
        self.outcomes
            .iter()
            .filter_map(|one| one.together.as_ref().map(|fit| fit.mu))
    }

    /// Seeds whose bounds say that there is no friction or at most `little`.
    pub(crate) fn none_found(&self, little: f64) -> usize {
        let fits = self.outcomes.iter().filter_map(|one| one.together.as_ref());
        fits.filter(|fit| matches!(fit.bounds, Bounds::AtMost(high) if high <= little))
            .count()
    }

    /// Mean and standard deviation of the coefficients found.
    pub(crate) fn mean_and_spread(&self) -> [f64; 2] {
        let count = self.coefficients().count() as f64;
        let mean = self.coefficients().sum::<f64>() / count;
        let squares = self
            .coefficients()
            .map(|mu| (mu - mean).powi(2))
            .sum::<f64>();
        [mean, (squares / (count - 1.0)).sqrt()]
    }

    /// Mean half width of two-sided intervals.
    pub(crate) fn half_width(&self) -> f64 {
        let fits = self.outcomes.iter().filter_map(|one| one.together.as_ref());
        let widths: Vec<f64> = fits
            .filter_map(|fit| match fit.bounds {
                Bounds::Between(low, high) => Some(0.5 * (high - low)),
                _ => None,
            })
            .collect();
        widths.iter().sum::<f64>() / widths.len() as f64
    }

    /// Seeds with an interval, of two ends, that holds the truth.
    pub(crate) fn covered(&self) -> usize {
        self.outcomes
            .iter()
            .filter(|one| one.holds(self.known.mu))
            .count()
    }

    /// Part of the seeds whose intervals hold the truth.
    pub(crate) fn coverage(&self) -> f64 {
        self.covered() as f64 / self.outcomes.len() as f64
    }

    /// The farthest coefficient from the truth; infinite where a seed has none.
    pub(crate) fn farthest(&self) -> f64 {
        if self.coefficients().count() < self.outcomes.len() {
            return f64::INFINITY;
        }
        self.coefficients()
            .map(|mu| (mu - self.known.mu).abs())
            .fold(0.0, f64::max)
    }
}

impl Outcome {
    /// Whether all zones together have an interval, of two ends, that holds `mu`: bounds on one side hold too much to say so.
    pub(crate) fn holds(&self, mu: f64) -> bool {
        self.together
            .as_ref()
            .is_some_and(|fit| matches!(fit.bounds, Bounds::Between(..)) && fit.bounds.contain(mu))
    }
}

fn outcome(
    experiment: &Experiment,
    camera: &Camera<'_>,
    bench: &Workbench<'_>,
    seed: u64,
) -> Result<Outcome, ExperimentError> {
    let mut analysed = Vec::new();
    for state in 0..experiment.states.len() {
        let measured = measured::state(experiment, state, &camera.shots(state)?)?;
        analysed.push(bench.stresses(&measured)?);
    }
    let found = identify(experiment, &analysed)?;
    let zones = found.zones.into_iter().map(|zone| {
        let angle = &analysed[zone.state].angle;
        let ends = [zone.places.start, zone.places.end - 1].map(|k| angle[k].to_degrees());
        (zone.state, ends, zone.fit)
    });
    Ok(Outcome {
        seed,
        together: found.dynamic,
        zones: zones.collect(),
    })
}
