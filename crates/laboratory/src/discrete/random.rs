//! Random problems of one to three points.
//!
//! Compliance A = B Bᵀ + ε 1 with the entries of B between −1 and 1; gaps, normals, two load cases, a past of up to two steps
//! and the friction coefficient are drawn as well. Everything follows from the seed.

use std::f64::consts::PI;
use std::sync::Arc;

use nalgebra::{DMatrix, DVector};
use stickslip_contact::{ContactState, InterfaceProblem};
use stickslip_fem_core::GivenBody;
use stickslip_friction::Coulomb;

use super::{Discrete, GroundPoint, enumerate, on_ground};
use crate::error::LaboratoryError;

/// Largest number of points.
const POINTS: usize = 3;
/// Largest coefficient of friction.
const FRICTION: f64 = 3.0;

/// The problem that belongs to `seed`, of a body that floats along `floating` ≤ 2 rigid motions: a random step after a random
/// past of at most two steps, each the first of its solutions.
///
/// # Errors
/// [`LaboratoryError`] if `floating` is more than 2, the motions that a single point can show.
pub fn random(seed: u64, floating: usize) -> Result<Discrete, LaboratoryError> {
    if floating > 2 {
        let what = format!("a random problem has at most 2 rigid motions, not {floating}");
        return Err(LaboratoryError::Missing(what));
    }
    let mut draw = Draw(seed);
    let least = floating.max(1);
    let count = least + (draw.part() * (POINTS + 1 - least) as f64) as usize;
    let count = count.min(POINTS);
    let problem = problem(&mut draw, count, floating)?;
    let mut discrete = Discrete {
        name: format!("random problem {seed}"),
        committed: ContactState::unloaded(&problem),
        problem,
        multipliers: Vec::new(),
        coercive: floating == 0,
        solutions: None,
    };
    for _ in 0..(3.0 * draw.part()) as usize {
        discrete.multipliers = vec![draw.sign(), draw.sign()];
        if let Some(first) = enumerate(&discrete).states.first() {
            discrete = discrete.next(first, Vec::new());
        }
    }
    let scale = if floating == 0 { 2.0 } else { 1.0 };
    discrete.multipliers = vec![scale * draw.sign(), scale * draw.sign()];
    Ok(discrete)
}

fn problem(
    draw: &mut Draw,
    count: usize,
    floating: usize,
) -> Result<InterfaceProblem, LaboratoryError> {
    let size = 2 * count;
    let factor = DMatrix::from_fn(size, size, |_, _| draw.sign());
    let floor = 1e-3 + 0.02 * draw.part();
    let compliance = &factor * factor.transpose() + DMatrix::identity(size, size) * floor;
    let mut vectors = |rows: usize, scale: f64| -> Vec<DVector<f64>> {
        (0..2)
            .map(|_| DVector::from_fn(rows, |_, _| scale * draw.sign()))
            .collect()
    };
    let (responses, mode_loads) = (vectors(size, 2.0), vectors(floating, 1.0));
    let modes = DMatrix::from_fn(size, floating, |_, _| draw.sign());
    let body = GivenBody::floating(compliance, modes, responses, mode_loads)?;
    let points: Vec<GroundPoint> = (0..count)
        .map(|_| {
            let angle = PI * draw.sign();
            // Half of the points fit neatly; of the others some overlap.
            let gap = if draw.part() < 0.5 {
                0.0
            } else {
                0.25 + 0.5 * draw.sign()
            };
            GroundPoint {
                normal: [angle.cos(), angle.sin()],
                gap,
                area: 1.0,
            }
        })
        .collect();
    let mu = if draw.part() < 0.05 {
        0.0
    } else {
        FRICTION * draw.part()
    };
    let law = Coulomb::new(mu).map_err(|cause| LaboratoryError::Missing(cause.to_string()))?;
    Ok(on_ground(&body, &points, Arc::new(law))?)
}

/// `SplitMix64` (Steele, Lea & Flood 2014).
struct Draw(u64);

impl Draw {
    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut bits = self.0;
        bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        bits ^ (bits >> 31)
    }

    /// Between 0 and 1.
    fn part(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// Between −1 and 1.
    fn sign(&mut self) -> f64 {
        2.0 * self.part() - 1.0
    }
}
