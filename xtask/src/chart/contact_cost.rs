//! What contact costs beside the elastic bodies: iterations of Newton's method, and contact work beside triangular solves.

use std::time::Instant;

use stickslip::model::Model;
use stickslip::run::{Operator, condense};
use stickslip_contact::SemismoothNewton;
use stickslip_fem_core::mesh::ElementKind;
use stickslip_laboratory::LaboratoryError;
use stickslip_laboratory::measure::{summary, thread_seconds};
use stickslip_laboratory::problems::{Pairing, Problem};
use stickslip_laboratory::run::{Path, Run, run};

use super::data::seconds;
use super::yardstick::{factorisation, stiffness};
use crate::publish::TaskError;

/// Spacings `[deg]`; the last has about 195 000 unknowns.
const SPACINGS: [f64; 5] = [9.0, 4.5, 2.25, 1.125, 0.9];
const RUNS: usize = 3;

/// One mesh of the aluminium history with friction.
#[derive(Clone, Debug)]
pub(super) struct ContactCost {
    unknowns: usize,
    /// Most contact nodes that touch at once, in the half that is modelled.
    touching: usize,
    /// Newton iterations of a load step, the confirming one included: median and most.
    iterations: [f64; 2],
    /// Contact work of a load step, median over the steps `[s]`.
    step: f64,
    /// One pair of triangular solves with all bodies' factors `[s]`.
    solves: f64,
    /// The whole history, everything but files `[s]`.
    history: f64,
    /// One factorisation of the same stiffness matrix, symbolic and numeric `[s]`.
    factorisation: f64,
}

/// Measures the history on every mesh, or on the coarsest two.
pub(super) fn measure(quick: bool) -> Result<Vec<ContactCost>, TaskError> {
    let count = if quick { 2 } else { SPACINGS.len() };
    SPACINGS[..count].iter().map(|&at| measure_at(at)).collect()
}

fn measure_at(spacing: f64) -> Result<ContactCost, TaskError> {
    let pairing = Pairing::NodePairs;
    let scene = Problem::AluminiumFrictional.build(spacing, ElementKind::Q8, pairing)?;
    let newton = SemismoothNewton::default();
    let runs = (0..RUNS)
        .map(|_| run(&scene, Path::Condensed(&newton)))
        .collect::<Result<Vec<Run>, LaboratoryError>>()?;
    let model = Model::build(&scene)?;
    let operators = condense(&model)?;
    let steps = &runs[0].results.steps;
    let iterations: Vec<f64> = steps.iter().map(|step| step.work.solves as f64).collect();
    let touching = steps.iter().map(|step| {
        let rows = step.edges[0].rows.iter();
        rows.filter(|row| row.pressure > 0.0).count()
    });
    let contact: Vec<f64> = (runs.iter())
        .flat_map(|run| run.results.steps.iter().map(|step| step.seconds))
        .collect();
    let whole: Vec<f64> = runs.iter().map(|run| run.processor.total()).collect();
    Ok(ContactCost {
        unknowns: runs[0].unknowns,
        touching: touching.max().unwrap_or(0),
        iterations: [
            summary(&iterations).median,
            iterations.iter().copied().fold(0.0, f64::max),
        ],
        step: summary(&contact).median,
        solves: pair_of_solves(&operators),
        history: summary(&whole).median,
        factorisation: factorisation(&stiffness(&model)?)?,
    })
}

/// Recovers all displacements from forces on the interface, in every elastic body: median of repeated runs `[s]`.
fn pair_of_solves(operators: &[Operator]) -> f64 {
    let samples: Vec<f64> = (0..=2 * RUNS)
        .map(|_| {
            let (wall, before) = (Instant::now(), thread_seconds());
            for body in operators.iter().filter_map(Operator::elastic) {
                let forces = vec![1.0; 2 * body.interface_nodes().len()];
                std::hint::black_box(body.displacements(&forces, &[], &[]));
            }
            let used = before.zip(thread_seconds()).map(|(start, end)| end - start);
            used.unwrap_or_else(|| wall.elapsed().as_secs_f64())
        })
        .collect();
    summary(&samples).median
}

impl ContactCost {
    /// Its row of the page.
    pub(super) fn cells(&self) -> Vec<String> {
        let [median, most] = self.iterations;
        vec![
            self.unknowns.to_string(),
            self.touching.to_string(),
            format!("{median}, {most}"),
            seconds(self.step),
            seconds(self.solves),
            format!("{:.2}", self.step / self.solves),
            seconds(self.history),
            seconds(self.factorisation),
            format!("{:.2}", self.history / self.factorisation),
        ]
    }
}
