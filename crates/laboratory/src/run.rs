//! A scene by either path, its phases timed.

use std::time::Instant;

use stickslip::model::Model;
use stickslip::results::Results;
use stickslip::run::{Operator, RunError, condense, follow, results};
use stickslip::scene::Scene;
use stickslip_contact::{InterfaceProblem, InterfaceSolver};
use stickslip_fem_core::InterfaceOperator;

use crate::conventional::{ConventionalError, ConventionalNewton, Settings};
use crate::error::LaboratoryError;
use crate::measure::thread_seconds;

/// How a scene is solved.
#[derive(Clone, Copy, Debug)]
pub enum Path<'a> {
    /// Bodies are condensed once, and this solver works on their interfaces.
    Condensed(&'a dyn InterfaceSolver),
    /// The whole finite-element system is refactorised in every contact iteration.
    Conventional(&'a Settings),
}

/// Times of the phases `[s]`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Seconds {
    /// Meshing and model.
    pub mesh: f64,
    /// Before the first contact iteration: factorisation and interface, or assembly and symbolic analysis.
    pub setup: f64,
    /// The load history.
    pub contact: f64,
    /// Displacements and stresses of the results.
    pub stresses: f64,
}

impl Seconds {
    /// Time that the methods differ in: set-up and contact `[s]`.
    pub fn solve(&self) -> f64 {
        self.setup + self.contact
    }

    /// Time of all phases `[s]`.
    pub fn total(&self) -> f64 {
        self.mesh + self.setup + self.contact + self.stresses
    }
}

/// Results of a scene and what they cost.
#[derive(Clone, Debug)]
pub struct Run {
    /// As the `stickslip` command has them.
    pub results: Results,
    /// Wall times.
    pub seconds: Seconds,
    /// Processor times of the calling thread: of the whole work if it uses no other thread. Wall times where the system does
    /// not report them.
    pub processor: Seconds,
    /// Unknowns of all elastic bodies.
    pub unknowns: usize,
}

/// Runs `scene` by `path`.
///
/// The conventional path is handed the same interface problem, against whose conditions both paths are accepted; the
/// condensation that makes it is not part of the path and not of its time.
///
/// # Errors
/// [`LaboratoryError::Run`], [`LaboratoryError::Conventional`].
pub fn run(scene: &Scene, path: Path<'_>) -> Result<Run, LaboratoryError> {
    let mut clock = Clock::start();
    let (mut seconds, mut processor) = (Seconds::default(), Seconds::default());
    let model = Model::build(scene).map_err(RunError::from)?;
    [seconds.mesh, processor.mesh] = clock.lap();
    let operators = condense(&model)?;
    let problem = {
        let faces: Vec<&dyn InterfaceOperator> =
            operators.iter().map(Operator::interface).collect();
        InterfaceProblem::linked(&faces, model.pairs.clone(), &model.links())
            .map_err(RunError::from)?
    };
    [seconds.setup, processor.setup] = clock.lap();
    let whole;
    let solver: &dyn InterfaceSolver = match path {
        Path::Condensed(solver) => solver,
        Path::Conventional(_) if !model.facings.is_empty() => {
            return Err(ConventionalError::DeformedGaps.into());
        }
        Path::Conventional(settings) => {
            whole = ConventionalNewton::new(&operators, &problem, *settings)?;
            [seconds.setup, processor.setup] = clock.lap();
            &whole
        }
    };
    let solved = follow(&model, operators, problem.into(), solver, &mut |_| {})?;
    [seconds.contact, processor.contact] = clock.lap();
    let unknowns = unknowns(&solved.operators);
    let results = results(&model, solver, solved)?;
    [seconds.stresses, processor.stresses] = clock.lap();
    Ok(Run {
        results,
        seconds,
        processor,
        unknowns,
    })
}

fn unknowns(operators: &[Operator]) -> usize {
    let elastic = operators.iter().filter_map(Operator::elastic);
    elastic.map(|body| body.structure().unknowns()).sum()
}

struct Clock {
    wall: Instant,
    processor: Option<f64>,
}

impl Clock {
    fn start() -> Self {
        Self {
            wall: Instant::now(),
            processor: thread_seconds(),
        }
    }

    /// Seconds since the last lap, by the wall clock and of the processor.
    fn lap(&mut self) -> [f64; 2] {
        let now = Self::start();
        let wall = now.wall.duration_since(self.wall).as_secs_f64();
        let used = now.processor.zip(self.processor);
        *self = now;
        [wall, used.map_or(wall, |(now, before)| now - before)]
    }
}
