//! Rounds of refinement.
//!
//! A triangle is bad if its circumradius exceeds [`ROUGH`] h or the sine of its least angle is below [`FLAT`]. Its circumcentre becomes a node unless
//! a boundary edge hides it or has it in its diametral circle; such an edge is halved on its true curve, unless it is fixed.

use super::mend::Outcome;
use super::{FLAT, Refinement};
use crate::ContourError;
use crate::vector::{circumcircle, least_sine};

/// Largest circumradius in sizes; equilateral cells of side h have 0.577.
const ROUGH: f64 = 0.65;

/// Rounds before refinement is given up.
const ROUNDS: usize = 200;

impl Refinement<'_> {
    /// Inserts nodes until no triangle is bad that could be mended.
    pub(crate) fn refine(&mut self) -> Result<(), ContourError> {
        for _ in 0..ROUNDS {
            let bad = self.bad();
            let mut changed = self.split_encroached()?;
            for triangle in &bad {
                changed |= matches!(self.mend(*triangle)?, Outcome::Changed);
            }
            if !changed {
                return Ok(());
            }
        }
        let bad = self.bad();
        Err(self.incomplete(&bad))
    }

    /// Bad triangles, the worst first.
    fn bad(&mut self) -> Vec<[usize; 3]> {
        let mut bad = Vec::new();
        for triangle in self.triangles() {
            if self.good.contains(&triangle) {
                continue;
            }
            match self.badness(triangle) {
                Some(badness) => bad.push((badness, triangle)),
                None => {
                    self.good.insert(triangle);
                }
            }
        }
        bad.sort_by(|a: &(f64, _), b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
        bad.into_iter().map(|(_, triangle)| triangle).collect()
    }

    /// How bad a triangle is, if it is.
    fn badness(&self, triangle: [usize; 3]) -> Option<f64> {
        let corners = self.positions(triangle);
        let (_, radius) = circumcircle(corners);
        let middle = [0, 1].map(|c| corners.iter().map(|p| p[c]).sum::<f64>() / 3.0);
        let size = radius / (ROUGH * self.plan.size.at(middle));
        let shape = FLAT / least_sine(corners);
        let worst = if self.at_acute_corner(triangle) {
            size
        } else {
            size.max(shape)
        };
        (worst > 1.0).then_some(worst)
    }
}
