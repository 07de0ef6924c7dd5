//! The first crossing of a ray of stresses with a surface that is quadratic for given signs of its variables.
//!
//! ```text
//! f(x) = max_b (l_b · x + x · q_b x),   b over the branches for the signs of x
//! x(r) = held + r applied;   on an interval without change of sign   f_b(start + s) = g₀ + g₁ s + g₂ s²
//! ```
//!
//! Between changes of sign, of which a ray of N variables has at most N, the first s ≥ 0 with f_b = 1 is a root in closed form.
//! Where f jumps upwards past 1 at a change of sign, the place of the jump is the crossing.

use super::criterion::Assessment;
use super::error::{FailureError, finite};
use crate::failure_mode::FailureMode;

/// One polynomial of a surface.
#[derive(Clone, Copy, Debug)]
pub(super) struct Branch<const N: usize> {
    /// The mode of this polynomial; `None` where the surface has one polynomial for all modes.
    pub mode: Option<FailureMode>,
    pub linear: [f64; N],
    /// Symmetric.
    pub quadratic: [[f64; N]; N],
}

/// The polynomials for given signs of the variables.
pub(super) type Branches<const N: usize> = [Option<Branch<N>>; 3];

impl<const N: usize> Branch<N> {
    /// `Σ l_i x_i`.
    pub(super) fn linear(mode: FailureMode, linear: [f64; N]) -> Self {
        Self {
            mode: Some(mode),
            linear,
            quadratic: [[0.0; N]; N],
        }
    }

    /// Coefficients (g₀, g₁, g₂) of f(x + s d).
    fn along(&self, x: &[f64; N], d: &[f64; N]) -> [f64; 3] {
        let mut g = [0.0; 3];
        for i in 0..N {
            g[0] += self.linear[i] * x[i];
            g[1] += self.linear[i] * d[i];
            for j in 0..N {
                let q = self.quadratic[i][j];
                g[0] += q * x[i] * x[j];
                g[1] += 2.0 * q * x[i] * d[j];
                g[2] += q * d[i] * d[j];
            }
        }
        g
    }
}

/// A surface by its branches, which may depend on which variables are positive or zero, and the mode of a point where a branch
/// has none.
pub(super) struct Surface<B, M> {
    pub criterion: &'static str,
    pub branches: B,
    pub dominant: M,
}

impl<B, M> Surface<B, M> {
    pub(super) fn assess<const N: usize>(
        &self,
        held: &[f64; N],
        applied: &[f64; N],
    ) -> Result<Assessment, FailureError>
    where
        B: Fn([bool; N]) -> Branches<N>,
        M: Fn(&[f64; N]) -> FailureMode,
    {
        finite("stress", held)?;
        finite("stress", applied)?;
        let (index, nearest) = self.value(&at(held, applied, 1.0));
        let (reserve_factor, mode) = self
            .crossing(held, applied)
            .unwrap_or((f64::INFINITY, nearest));
        Ok(Assessment {
            criterion: self.criterion,
            index,
            reserve_factor,
            mode,
        })
    }

    /// f at a point and the mode that gives it.
    fn value<const N: usize>(&self, x: &[f64; N]) -> (f64, FailureMode)
    where
        B: Fn([bool; N]) -> Branches<N>,
        M: Fn(&[f64; N]) -> FailureMode,
    {
        let mut best = (f64::NEG_INFINITY, None);
        for branch in (self.branches)(x.map(|value| value >= 0.0))
            .iter()
            .flatten()
        {
            let [value, ..] = branch.along(x, &[0.0; N]);
            // Squares that overflow are far beyond any strength.
            let value = if value.is_nan() { f64::INFINITY } else { value };
            if value > best.0 {
                best = (value, branch.mode);
            }
        }
        (best.0, best.1.unwrap_or_else(|| (self.dominant)(x)))
    }

    /// The smallest r ≥ 0 with f ≥ 1, and the mode there.
    fn crossing<const N: usize>(
        &self,
        held: &[f64; N],
        applied: &[f64; N],
    ) -> Option<(f64, FailureMode)>
    where
        B: Fn([bool; N]) -> Branches<N>,
        M: Fn(&[f64; N]) -> FailureMode,
    {
        let mut ends: [f64; N] = std::array::from_fn(|i| {
            let change = -held[i] / applied[i];
            if change > 0.0 { change } else { f64::INFINITY }
        });
        ends.sort_by(f64::total_cmp);
        let mut start = 0.0;
        for end in ends.into_iter().chain([f64::INFINITY]) {
            if end == start {
                continue;
            }
            let inside = if end.is_finite() {
                0.5 * (start + end)
            } else {
                2.0 * start + 1.0
            };
            let origin = at(held, applied, start);
            let signs = at(held, applied, inside).map(|value| value >= 0.0);
            let mut first: Option<(f64, Option<FailureMode>)> = None;
            for branch in (self.branches)(signs).iter().flatten() {
                if let Some(step) = first_root(branch.along(&origin, applied))
                    && start + step <= end
                    && first.is_none_or(|(known, _)| step < known)
                {
                    first = Some((step, branch.mode));
                }
            }
            if let Some((step, mode)) = first {
                let factor = start + step;
                return Some((
                    factor,
                    mode.unwrap_or_else(|| (self.dominant)(&at(held, applied, factor))),
                ));
            }
            start = end;
            if !start.is_finite() {
                break;
            }
        }
        None
    }
}

fn at<const N: usize>(held: &[f64; N], applied: &[f64; N], factor: f64) -> [f64; N] {
    std::array::from_fn(|i| held[i] + factor * applied[i])
}

/// The smallest s ≥ 0 with g₀ + g₁ s + g₂ s² ≥ 1, without cancellation.
fn first_root([g0, g1, g2]: [f64; 3]) -> Option<f64> {
    let room = 1.0 - g0;
    // Squares that overflow are far beyond any strength.
    if room <= 0.0 || ![g0, g1, g2].iter().all(|g| g.is_finite()) {
        return Some(0.0);
    }
    let discriminant = g1 * g1 + 4.0 * g2 * room;
    let root = if discriminant < 0.0 {
        return None;
    } else if g1 > 0.0 {
        2.0 * room / (g1 + discriminant.sqrt())
    } else if g2 > 0.0 {
        (discriminant.sqrt() - g1) / (2.0 * g2)
    } else {
        return None;
    };
    root.is_finite().then_some(root)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn roots_are_the_first_ones_and_keep_their_digits() {
        assert_eq!(first_root([0.0, 0.0, 4.0]), Some(0.5));
        assert_eq!(first_root([0.0, 2.0, 0.0]), Some(0.5));
        assert_eq!(first_root([2.0, -1.0, 0.0]), Some(0.0));
        assert_eq!(first_root([0.0, -1.0, 0.0]), None);
        assert_eq!(first_root([0.0, 1.0, -1.0]), None);
        // (1 − s)(s − 3) + 1 reaches 1 at 1 and 3.
        assert_eq!(first_root([-2.0, 4.0, -1.0]), Some(1.0));
        // 1e-20 s² + s = 1: the textbook formula would return 0.
        assert_eq!(first_root([0.0, 1.0, 1e-20]), Some(1.0));
    }

    #[test]
    fn a_jump_at_a_change_of_sign_is_a_crossing() {
        let surface = Surface {
            criterion: "step",
            branches: |[positive]: [bool; 1]| {
                let slope = if positive { -0.1 } else { 0.0 };
                let branch = Branch::linear(FailureMode::Shear, [slope]);
                let curved = Branch {
                    quadratic: [[if positive { 0.0 } else { 4.0 }]],
                    ..branch
                };
                [Some(curved), None, None]
            },
            dominant: |_: &[f64; 1]| FailureMode::Shear,
        };
        // From 1 downwards: −0.1 x until x = 0, then 4x², which is 1 at −0.5.
        let assessment = surface.assess(&[1.0], &[-1.0]).unwrap();
        assert!((assessment.reserve_factor - 1.5).abs() < 1e-15);
    }
}
