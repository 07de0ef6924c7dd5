//! Errors and processor times of methods on the reference problems, by repeated runs on one thread.

use std::time::Instant;

use stickslip_contact::solver::Work;
use stickslip_fem_core::mesh::ElementKind;
use stickslip_laboratory::LaboratoryError;
use stickslip_laboratory::conventional::Settings;
use stickslip_laboratory::measure::{Timing, summary};
use stickslip_laboratory::problems::{Errors, Problem};
use stickslip_laboratory::run::{Path, Run, run};

use super::curve::Point;
use super::methods::{Enforcement, Group, Method};

/// A method whose run took longer `[s]` is not tried on finer meshes.
const PATIENCE: f64 = 3.0;
/// A run that took longer `[s]` is not repeated, unless it is the default's.
const REPEATED: f64 = 0.4;
/// Repetitions go on until they have taken this long together `[s]`, but there are at least and at most so many.
const LONG_ENOUGH: f64 = 0.4;
const LEAST: usize = 3;
const MOST: usize = 5;

/// What one method did on one mesh.
#[derive(Clone, Debug)]
pub(super) struct Sample {
    pub(super) problem: Problem,
    pub(super) method: Method,
    /// Spacing of the corner nodes, in the problem's unit.
    pub(super) spacing: f64,
    /// The numbers, or why there are none.
    pub(super) outcome: Result<Measured, String>,
}

impl Sample {
    /// Whether the matrices of `other` are these.
    fn shares(&self, other: &Self) -> bool {
        let conventional = |sample: &Self| sample.method.enforcement == Enforcement::Conventional;
        self.problem == other.problem
            && self.spacing == other.spacing
            && self.method.element == other.method.element
            && self.method.pairing == other.method.pairing
            && conventional(self) == conventional(other)
    }
}

/// Errors and costs of a solved history.
#[derive(Clone, Debug)]
pub(super) struct Measured {
    pub(super) unknowns: usize,
    /// The largest over the load steps with a known answer.
    pub(super) errors: Errors,
    /// Of the peak pressure in the first of these.
    pub(super) first_peak: f64,
    /// Everything but files: meshes, matrices, contact, edge stresses.
    pub(super) whole: Timing,
    /// The same by the wall clock.
    pub(super) wall: Timing,
    /// Without meshes and stresses. The matrices of one mesh are the same for all solvers of the condensed problem, and so is
    /// their time here ([`Bench::share_matrices`]).
    pub(super) solve: Timing,
    /// Contact alone.
    pub(super) contact: Timing,
    /// Work of the whole history.
    pub(super) work: Work,
}

/// An error of the results, and its name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Quantity {
    PeakPressure,
    Extent,
    Pressure,
    Shear,
    Hoop,
}

impl Quantity {
    pub(super) const ALL: [Self; 5] = [
        Self::PeakPressure,
        Self::Extent,
        Self::Pressure,
        Self::Shear,
        Self::Hoop,
    ];

    pub(super) fn name(self) -> &'static str {
        match self {
            Self::PeakPressure => "peak pressure",
            Self::Extent => "extent of contact",
            Self::Pressure => "pressure profile",
            Self::Shear => "shear profile",
            Self::Hoop => "hoop stress at 90°",
        }
    }

    pub(super) fn of(self, errors: &Errors) -> Option<f64> {
        match self {
            Self::PeakPressure => Some(errors.peak_pressure),
            Self::Extent => Some(errors.contact_extent),
            Self::Pressure => Some(errors.pressure_profile),
            Self::Shear => errors.shear,
            Self::Hoop => errors.hoop,
        }
    }
}

/// What a mesh is charged for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Cost {
    Whole,
    Solve,
    Contact,
    Unknowns,
}

impl Cost {
    pub(super) fn label(self) -> &'static str {
        match self {
            Self::Whole => "Processor time of the whole history [s]",
            Self::Solve => "Processor time of matrices and contact [s]",
            Self::Contact => "Processor time of contact alone [s]",
            Self::Unknowns => "Unknowns",
        }
    }

    fn timing(self, measured: &Measured) -> Option<Timing> {
        match self {
            Self::Whole => Some(measured.whole),
            Self::Solve => Some(measured.solve),
            Self::Contact => Some(measured.contact),
            Self::Unknowns => None,
        }
    }

    pub(super) fn of(self, measured: &Measured) -> f64 {
        self.timing(measured)
            .map_or(measured.unknowns as f64, |timing| timing.median)
    }

    /// First and third quartile; none of a cost that is counted.
    pub(super) fn spread(self, measured: &Measured) -> Option<[f64; 2]> {
        self.timing(measured)
            .map(|timing| [timing.lower, timing.upper])
    }
}

/// Measures each method once on each mesh, and remembers.
#[derive(Debug)]
pub(super) struct Bench {
    quick: bool,
    samples: Vec<Sample>,
}

impl Bench {
    /// With `quick`, few coarse meshes and one run of each.
    pub(super) fn new(quick: bool) -> Self {
        Self {
            quick,
            samples: Vec::new(),
        }
    }

    /// All samples, in the order in which they were measured.
    pub(super) fn samples(&self) -> &[Sample] {
        &self.samples
    }

    /// Measures all methods of `group` on all meshes of `problem`.
    pub(super) fn measure(&mut self, problem: Problem, group: &Group) {
        for (_, method) in group.methods.iter().filter(|(_, m)| m.suits(problem)) {
            self.measure_method(problem, *method);
        }
    }

    /// Gives all condensed runs on one mesh the same time for the matrices, the median over the solvers: runs that follow one
    /// another differ by more than the solvers do.
    pub(super) fn share_matrices(&mut self) {
        let shares: Vec<Option<f64>> = self
            .samples
            .iter()
            .map(|sample| {
                let alike = self.samples.iter().filter(|other| sample.shares(other));
                let times: Vec<f64> = alike
                    .filter_map(|other| other.outcome.as_ref().ok())
                    .map(|measured| measured.solve.median - measured.contact.median)
                    .collect();
                (sample.method.enforcement != Enforcement::Conventional)
                    .then(|| summary(&times).median)
            })
            .collect();
        for (sample, matrices) in self.samples.iter_mut().zip(shares) {
            if let (Ok(measured), Some(matrices)) = (&mut sample.outcome, matrices) {
                measured.solve = Timing {
                    median: matrices + measured.contact.median,
                    lower: matrices + measured.contact.lower,
                    upper: matrices + measured.contact.upper,
                    runs: measured.solve.runs,
                };
            }
        }
    }

    /// The meshes of `problem` that `method` solved, the coarsest first.
    pub(super) fn curve(&self, problem: Problem, method: Method) -> Vec<(f64, &Measured)> {
        self.samples
            .iter()
            .filter(|sample| sample.problem == problem && sample.method == method)
            .filter_map(|sample| Some((sample.spacing, sample.outcome.as_ref().ok()?)))
            .collect()
    }

    /// The errors that are known of `problem`.
    pub(super) fn known(&self, problem: Problem) -> impl Iterator<Item = Quantity> {
        let measured = self.curve(problem, Method::DEFAULT);
        Quantity::ALL.into_iter().filter(move |quantity| {
            let mut errors = measured.iter().map(|(_, measured)| &measured.errors);
            errors.any(|errors| quantity.of(errors).is_some())
        })
    }

    /// An error on the finest mesh of `problem` that `method` solved.
    pub(super) fn finest(
        &self,
        problem: Problem,
        method: Method,
        quantity: Quantity,
    ) -> Option<f64> {
        let (_, measured) = self.curve(problem, method).pop()?;
        quantity.of(&measured.errors)
    }

    /// That curve as points of one cost and one error.
    pub(super) fn points(
        &self,
        problem: Problem,
        method: Method,
        cost: Cost,
        quantity: Quantity,
    ) -> Vec<Point> {
        self.curve(problem, method)
            .into_iter()
            .filter_map(|(_, measured)| {
                Some(Point {
                    cost: cost.of(measured),
                    error: quantity.of(&measured.errors)?,
                })
            })
            .collect()
    }

    fn measure_method(&mut self, problem: Problem, method: Method) {
        let known = |sample: &Sample| sample.problem == problem && sample.method == method;
        if self.samples.iter().any(known) {
            return;
        }
        for spacing in self.spacings(problem, method.element) {
            let start = Instant::now();
            let outcome = self.sample(problem, method, spacing);
            let longest = match &outcome {
                Ok(measured) => measured.whole.median,
                Err(_) => start.elapsed().as_secs_f64(),
            };
            report(problem, method, spacing, &outcome);
            self.samples.push(Sample {
                problem,
                method,
                spacing,
                outcome: outcome.map_err(|cause| cause.to_string()),
            });
            if longest > PATIENCE {
                break;
            }
        }
    }

    /// The problem's spacings; linear elements, with fewer unknowns for each, go one further, and those of order p > 2 have cells p/2
    /// times as wide, so that their nodes are as far apart as those of quadratic elements.
    fn spacings(&self, problem: Problem, element: ElementKind) -> Vec<f64> {
        let wider = element.order().max(2) as f64 / 2.0;
        let mut spacings: Vec<f64> = problem.spacings().iter().map(|s| wider * s).collect();
        if self.quick {
            spacings.truncate(2);
        } else if element.order() == 1 {
            spacings.extend(spacings.last().map(|finest| 0.5 * finest));
        }
        spacings
    }

    fn sample(
        &self,
        problem: Problem,
        method: Method,
        spacing: f64,
    ) -> Result<Measured, LaboratoryError> {
        let scene = problem.build(spacing, method.element, method.pairing)?;
        let solver = method.enforcement.solver();
        let settings = Settings::default();
        let once = || {
            let way = match &solver {
                Some(solver) => Path::Condensed(solver.as_ref()),
                None => Path::Conventional(&settings),
            };
            run(&scene, way)
        };
        let mut runs = vec![once()?];
        let first = runs[0].processor.total();
        if !self.quick && (first < REPEATED || method == Method::DEFAULT) {
            // The first run warmed up caches and memory.
            runs.clear();
            let wanted = (LONG_ENOUGH / first).ceil() as usize;
            for _ in 0..wanted.clamp(LEAST, MOST) {
                runs.push(once()?);
            }
        }
        measured(problem, &runs)
    }
}

/// The errors of the last run and the times of all.
fn measured(problem: Problem, runs: &[Run]) -> Result<Measured, LaboratoryError> {
    let last = runs
        .last()
        .ok_or_else(|| LaboratoryError::Missing("no run".into()))?;
    let timing = |seconds: fn(&Run) -> f64| {
        let samples: Vec<f64> = runs.iter().map(seconds).collect();
        summary(&samples)
    };
    let mut work = Work::default();
    for step in &last.results.steps {
        work += step.work;
    }
    let steps = problem.measure_each(&last.results)?;
    Ok(Measured {
        unknowns: last.unknowns,
        errors: problem.measure(&last.results)?,
        first_peak: steps
            .first()
            .map_or(f64::NAN, |errors| errors.peak_pressure),
        wall: timing(|run| run.seconds.total()),
        whole: timing(|run| run.processor.total()),
        solve: timing(|run| run.processor.solve()),
        contact: timing(|run| run.processor.contact),
        work,
    })
}

fn report(
    problem: Problem,
    method: Method,
    spacing: f64,
    outcome: &Result<Measured, LaboratoryError>,
) {
    let [element, pairing, solver] = method.columns();
    let what = match outcome {
        Ok(measured) => format!(
            "{:.4} s, peak pressure {:.1e}",
            measured.whole.median, measured.errors.peak_pressure
        ),
        Err(cause) => format!("not solved: {cause}"),
    };
    let unit = problem.unit();
    eprintln!(
        "  {} {spacing} {unit}, {element}, {pairing}, {solver}: {what}",
        problem.name()
    );
}
