//! How an active-set iteration corrects the status of a point after a solve with frozen statuses.
//!
//! ```text
//! closed:  λ_n ≥ 0, else open;      open:  g_n ≥ 0, else closed
//! stick:   |λ_t| ≤ F_stick, else slip against λ_t
//! slip:    −σ Δs ≤ 0, else stick or turn:  |λ_t − Δs/c| ≤ F(λ_n − g_n/c)  sticks,  else slip against it
//! ```
//!
//! The status of a point that closes follows from the same projection. c is the sum of magnitudes of the compliances by which all touching
//! points move this one, so that the projection is that of Alart & Curnier with 1/c for its parameter, applied where a status changes to
//! contact or turns; elsewhere signs alone decide, as in the report's rules.

use super::accept::ROUNDING;
use super::frozen::Frozen;
use super::residual::Scales;
use super::step::Step;
use crate::state::Status;

/// Which rules correct the statuses.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Rules {
    /// Post & Reddy (1988, II 2.1): a closing or turning point sticks.
    Report,
    /// The projection's (Alart & Curnier 1991): a closing or turning point sticks if the force that this takes lies within the
    /// bound, and slips against that force if it does not.
    Projection,
}

/// A point whose status is to change.
pub(super) struct Change {
    pub(super) point: usize,
    pub(super) status: Status,
    /// Relative size of the violation.
    pub(super) violation: f64,
}

impl Rules {
    /// The points whose status is to change after the solve `frozen` with statuses `status`. Points that are `slipped` are
    /// held by their slip traction only, not by a larger bound of sticking.
    pub(super) fn changes(
        self,
        step: &Step<'_>,
        status: &[Status],
        slipped: &[bool],
        frozen: &Frozen,
        scales: Scales,
    ) -> Vec<Change> {
        let at = At {
            step,
            status,
            slipped,
            frozen,
            scales,
        };
        let mut next: Vec<(Status, f64)> = (0..status.len())
            .map(|point| at.report_rule(point))
            .collect();
        if self == Self::Projection {
            at.project(&mut next);
        }
        let changes = next.into_iter().enumerate();
        changes
            .filter(|(point, (next, _))| *next != status[*point])
            .map(|(point, (status, violation))| Change {
                point,
                status,
                violation,
            })
            .collect()
    }
}

struct At<'a> {
    step: &'a Step<'a>,
    status: &'a [Status],
    slipped: &'a [bool],
    frozen: &'a Frozen,
    scales: Scales,
}

impl At<'_> {
    /// Tangential force that `point` can carry without slip.
    fn holding(&self, point: usize, normal: f64, slip: f64) -> f64 {
        let bound = self.step.bound(point, normal, slip);
        if self.slipped[point] {
            bound.stick.min(bound.slip)
        } else {
            bound.stick
        }
    }

    fn report_rule(&self, point: usize) -> (Status, f64) {
        let now = self.status[point];
        let (normal, tangential) = (
            self.frozen.forces[2 * point],
            self.frozen.forces[2 * point + 1],
        );
        let (gap, slip) = (
            self.frozen.motion[2 * point],
            self.frozen.motion[2 * point + 1],
        );
        if now == Status::Open {
            let depth = -gap / self.scales.length;
            return if depth > ROUNDING {
                (Status::Stick, depth)
            } else {
                (now, 0.0)
            };
        }
        let pull = -normal / self.scales.force;
        if pull > ROUNDING {
            return (Status::Open, pull);
        }
        if !self.step.problem.points()[point].slides {
            return (Status::Stick, 0.0);
        }
        if now == Status::Stick {
            let excess = (tangential.abs() - self.holding(point, normal, 0.0)) / self.scales.force;
            if excess > ROUNDING {
                (Status::slip_along(-tangential), excess)
            } else {
                (now, 0.0)
            }
        } else {
            let backward = -now.slip_sign() * slip / self.scales.length;
            if backward > ROUNDING {
                (Status::Stick, backward)
            } else {
                (now, 0.0)
            }
        }
    }

    /// Of the points that are to stick in `next` and do not yet, those whose motion the force within the bound does not stop slip. Their
    /// neighbours move with them, so that force needs the compliance of all touching points together.
    fn project(&self, next: &mut [(Status, f64)]) {
        let turns = |k: usize| {
            let slides = self.step.problem.points()[k].slides;
            next[k].0 == Status::Stick && self.status[k] != Status::Stick && slides
        };
        let turning: Vec<usize> = (0..next.len()).filter(|&k| turns(k)).collect();
        let moving = |k: &usize| self.status[*k].touches() || turns(*k);
        let touching: Vec<usize> = (0..next.len()).filter(moving).collect();
        let components = |points: &[usize]| {
            points
                .iter()
                .flat_map(|k| [2 * k, 2 * k + 1])
                .collect::<Vec<_>>()
        };
        let compliance = self.step.problem.compliance();
        let compliance = compliance.chosen(&components(&touching), &components(&turning));
        for point in turning {
            let stop = |axis: usize| {
                let row = 2 * point + axis;
                let own = touching.iter().enumerate();
                let own = own.filter(|(_, k)| self.status[**k].touches() || **k == point);
                let together: f64 = own
                    .map(|(i, _)| compliance.at(2 * i + axis, row).abs())
                    .sum();
                self.frozen.motion[row] / (together + self.step.softness).max(f64::MIN_POSITIVE)
            };
            let trial = self.frozen.forces[2 * point + 1] - stop(1);
            let normal = (self.frozen.forces[2 * point] - stop(0)).max(0.0);
            let bound = self.holding(point, normal, self.frozen.motion[2 * point + 1]);
            if trial.abs() > bound {
                next[point].0 = Status::slip_along(-trial);
            }
        }
    }
}
