//! Runs scenes, with or without a deliberate mistake, and keeps the worst residuals.

use std::cell::RefCell;
use std::path::Path;
use std::time::Instant;

use stickslip::host::HOST;
use stickslip::results::Results;
use stickslip::run::{RunError, run_with};
use stickslip::scene::{Format, Scene};
use stickslip_contact::ContactError;
use thiserror::Error;

use super::mutation::Mutation;
use crate::publish::{TaskError, root};

/// 1 ksi in MPa.
pub(crate) const KSI: f64 = 6.894757293168361;
/// 1 psi in MPa.
pub(crate) const PSI: f64 = 1e-3 * KSI;

/// A scene whose run stopped.
#[derive(Debug, Error)]
#[error("{scene}: {cause}")]
struct Stopped {
    scene: String,
    cause: RunError,
}

/// Whether a solver proved that nothing can balance the load.
pub(crate) fn is_proved_impossible(error: &TaskError) -> bool {
    let stopped: Option<&Stopped> = error.downcast_ref();
    let cause = stopped.and_then(|stopped| stopped.cause.contact());
    matches!(
        cause,
        Some(ContactError::StepFailed { cause, .. }) if cause.is_proved_impossible()
    )
}

/// How much is computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Size {
    /// Coarser meshes and fewer of them.
    Quick,
    /// Everything.
    Full,
}

/// A largest value and where it occurred.
#[derive(Clone, Debug, Default)]
pub(crate) struct Worst {
    pub(crate) value: f64,
    pub(crate) place: String,
}

impl Worst {
    /// Keeps the larger one. A NaN is larger than any number.
    pub(crate) fn meet(&mut self, value: f64, place: impl FnOnce() -> String) {
        if self.place.is_empty() || value > self.value || value.is_nan() {
            *self = Self {
                value,
                place: place(),
            };
        }
    }
}

impl<S: Into<String>> From<(S, f64)> for Worst {
    fn from((place, value): (S, f64)) -> Self {
        let place = place.into();
        Self { value, place }
    }
}

/// The largest residuals of all runs, and how many there were.
#[derive(Clone, Debug, Default)]
pub(crate) struct Residuals {
    pub(crate) runs: usize,
    pub(crate) steps: usize,
    pub(crate) balance: Worst,
    pub(crate) complementarity: Worst,
    pub(crate) cone: Worst,
}

/// Where cases compute.
#[derive(Debug)]
pub(crate) struct Laboratory {
    pub(crate) size: Size,
    mutation: Mutation,
    residuals: RefCell<Residuals>,
}

impl Laboratory {
    /// A laboratory in which friction has `mutation`.
    pub(crate) fn new(size: Size, mutation: Mutation) -> Self {
        Self {
            size,
            mutation,
            residuals: RefCell::default(),
        }
    }

    /// `quick` or `full`, whichever is requested.
    pub(crate) fn sized<T>(&self, quick: T, full: T) -> T {
        match self.size {
            Size::Quick => quick,
            Size::Full => full,
        }
    }

    /// The largest residuals so far.
    pub(crate) fn residuals(&self) -> Residuals {
        self.residuals.borrow().clone()
    }

    /// Runs `scenes/{name}.toml` with `overrides`.
    pub(crate) fn run(&self, name: &str, overrides: &[String]) -> Result<Results, TaskError> {
        let mesh = overrides
            .iter()
            .filter_map(|text| text.strip_prefix("mesh."));
        let label = std::iter::once(name)
            .chain(mesh)
            .collect::<Vec<_>>()
            .join(" ")
            .replace('"', "");
        let path = root().join("scenes").join(format!("{name}.toml"));
        self.solved(Scene::from_file(&path, overrides, HOST)?, &label)
    }

    /// Runs the scene `text`, which messages call `name`.
    pub(crate) fn run_text(&self, name: &str, text: &str) -> Result<Results, TaskError> {
        let scene = Scene::from_text(text, Format::Toml, name, Path::new(""), &[] as &[&str])?;
        self.solved(scene, name)
    }

    fn solved(&self, mut scene: Scene, label: &str) -> Result<Results, TaskError> {
        let start = Instant::now();
        self.mutation.change_laws(&mut scene)?;
        let solver = self.mutation.solver(&scene);
        let outcome = run_with(&scene, solver.as_ref(), &mut |_| {});
        eprintln!("  {label}  {:.2} s", start.elapsed().as_secs_f64());
        let stopped = |cause| Stopped {
            scene: label.to_owned(),
            cause,
        };
        let results = outcome.map_err(stopped)?;
        self.keep_residuals(&results, label);
        Ok(results)
    }

    fn keep_residuals(&self, results: &Results, label: &str) {
        let mut worst = self.residuals.borrow_mut();
        worst.runs += 1;
        worst.steps += results.steps.len();
        for (index, step) in results.steps.iter().enumerate() {
            let place = || format!("{label}, step {}", index + 1);
            worst.balance.meet(step.balance_residual, place);
            worst
                .complementarity
                .meet(step.residuals.complementarity, place);
            worst.cone.meet(step.residuals.cone, place);
        }
    }
}
