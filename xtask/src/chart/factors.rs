//! The conventional path against the condensed one.

use stickslip_laboratory::problems::Problem;

use super::bench::{Bench, Cost};
use super::methods::{Enforcement, Method};

/// Both paths on one mesh, where they give the same answer.
#[derive(Clone, Copy, Debug)]
pub(super) struct PathFactor {
    pub(super) problem: Problem,
    pub(super) unknowns: usize,
    /// Seconds for matrices and contact.
    pub(super) condensed: f64,
    pub(super) conventional: f64,
    /// Sparse factorisations of the whole history by the conventional path.
    pub(super) factorisations: usize,
}

impl PathFactor {
    /// How many times longer the conventional path takes.
    pub(super) fn factor(&self) -> f64 {
        self.conventional / self.condensed
    }
}

/// All meshes that both paths solved.
pub(super) fn path_factors(bench: &Bench) -> Vec<PathFactor> {
    let conventional = Method {
        enforcement: Enforcement::Conventional,
        ..Method::DEFAULT
    };
    let mut factors = Vec::new();
    for problem in Problem::ALL {
        let condensed = bench.curve(problem, Method::DEFAULT);
        for (spacing, whole) in bench.curve(problem, conventional) {
            let same = condensed.iter().find(|(other, _)| *other == spacing);
            factors.extend(same.map(|(_, condensed)| PathFactor {
                problem,
                unknowns: condensed.unknowns,
                condensed: Cost::Solve.of(condensed),
                conventional: Cost::Solve.of(whole),
                factorisations: whole.work.factorisations,
            }));
        }
    }
    factors
}
