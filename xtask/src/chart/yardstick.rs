//! One ordinary sparse Cholesky factorisation, by which times on different machines can be compared.

use std::time::Instant;

use stickslip::model::{Model, ModelBodyKind};
use stickslip_fem_core::linalg::{LowerMatrix, reference_factorisation};
use stickslip_fem_core::mesh::ElementKind;
use stickslip_laboratory::measure::{summary, thread_seconds};
use stickslip_laboratory::problems::{Pairing, Problem};

use crate::publish::TaskError;

/// Spacing `[deg]` at which linear elements on the benchmark have about 41 000 unknowns, the size of the other programs'
/// yardstick.
const SPACING: f64 = 1.125;

/// Times that it is repeated.
const RUNS: usize = 5;

/// One factorisation of the benchmark's stiffness matrix on linear elements, one thread.
#[derive(Clone, Copy, Debug)]
pub(super) struct Yardstick {
    pub(super) unknowns: usize,
    /// Symbolic and numeric, minimum degree, median `[s]`.
    pub(super) seconds: f64,
}

impl Yardstick {
    pub(super) fn measure() -> Result<Self, TaskError> {
        let scene =
            Problem::AluminiumFrictional.build(SPACING, ElementKind::Q4, Pairing::NodePairs)?;
        let model = Model::build(&scene)?;
        let matrix = stiffness(&model)?;
        Ok(Self {
            unknowns: matrix.order(),
            seconds: factorisation(&matrix)?,
        })
    }
}

/// The stiffness matrix of all elastic bodies, one diagonal block for each.
pub(super) fn stiffness(model: &Model) -> Result<LowerMatrix, TaskError> {
    let mut matrix = LowerMatrix {
        column_start: vec![0],
        ..LowerMatrix::default()
    };
    for body in &model.bodies {
        if let ModelBodyKind::Elastic(elastic) = &body.kind {
            let structure = elastic.analyse(&body.interface)?;
            append(&mut matrix, &structure.stiffness(elastic));
        }
    }
    Ok(matrix)
}

/// Processor time of one Cholesky factorisation of `matrix`, symbolic and numeric, minimum degree, one thread: median `[s]`.
pub(super) fn factorisation(matrix: &LowerMatrix) -> Result<f64, TaskError> {
    let mut samples = Vec::new();
    for _ in 0..RUNS {
        let (wall, before) = (Instant::now(), thread_seconds());
        reference_factorisation(matrix, 1)?;
        let used = before.zip(thread_seconds()).map(|(start, end)| end - start);
        samples.push(used.unwrap_or_else(|| wall.elapsed().as_secs_f64()));
    }
    Ok(summary(&samples).median)
}

/// Adds `block` as a further diagonal block.
fn append(matrix: &mut LowerMatrix, block: &LowerMatrix) {
    let (rows, entries) = (matrix.order(), matrix.rows.len());
    let starts = block.column_start[1..].iter().map(|start| start + entries);
    matrix.column_start.extend(starts);
    matrix.rows.extend(block.rows.iter().map(|row| row + rows));
    matrix.values.extend(&block.values);
}
