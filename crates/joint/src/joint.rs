//! A joint: bodies, contact pairs, and how its load is read.

use stickslip_contact::ContactPair;

use crate::body::{self, JointBody};
use crate::error::JointError;
use crate::gauge::{Gauge, Pull};

/// How a load history is followed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Options {
    /// Increments of each load step, before any is cut.
    pub increments: usize,
    /// Smallest part of such an increment `[1]` to which cut-back goes, in (0, 1].
    pub smallest_part: f64,
    /// Nodal forces out of balance, relative to the largest nodal force `[1]`, at which an increment is accepted.
    pub tolerance: f64,
    /// Newton iterations between two redistributions.
    pub iterations: usize,
    /// Redistributions at constant load.
    pub passes: usize,
    /// Plies times points that may fail by the load itself in one increment; where more do, the increment is cut, as far as a
    /// 32nd, so that the order of failures does not depend on the increment.
    pub burst: usize,
    /// Where supports are driven and the load falls from a new peak, the increment is cut until the plies that make it fall do so
    /// within this part `[1]` of the load before, and likewise to the first failure of all: strength and first failure are known as closely.
    pub peak_resolution: f64,
    /// A history with driven supports ends where the load has fallen to this part of its peak `[1]`.
    pub residual_load: f64,
    /// Under given loads, the load path is lost where load per displacement, from where the joint begins to bear, falls to this part `[1]` of its largest
    /// value.
    pub residual_stiffness: f64,
    /// Likewise where it falls to this part `[1]` within one increment: the plate would jump apart, and what is found beyond the jump is
    /// borne by the stiffness that failed plies are left with.
    pub jump: f64,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            increments: 20,
            smallest_part: 1.0 / 256.0,
            tolerance: 1e-9,
            iterations: 25,
            passes: 200,
            burst: 16,
            peak_resolution: 0.001,
            residual_load: 0.5,
            residual_stiffness: 0.1,
            jump: 0.5,
        }
    }
}

impl Options {
    fn check(&self) -> Result<(), JointError> {
        let refuse = |name, value: f64, range| Err(JointError::Option { name, value, range });
        for (name, count) in [
            ("increments", self.increments),
            ("iterations", self.iterations),
            ("passes", self.passes),
            ("burst", self.burst),
        ] {
            if count == 0 {
                return refuse(name, 0.0, "at least 1");
            }
        }
        for (name, value) in [
            ("smallest_part", self.smallest_part),
            ("tolerance", self.tolerance),
            ("peak_resolution", self.peak_resolution),
        ] {
            if !(value > 0.0 && value <= 1.0) {
                return refuse(name, value, "greater than 0, at most 1");
            }
        }
        for (name, value) in [
            ("residual_load", self.residual_load),
            ("residual_stiffness", self.residual_stiffness),
            ("jump", self.jump),
        ] {
            if !(0.0..1.0).contains(&value) {
                return refuse(name, value, "at least 0, less than 1");
            }
        }
        Ok(())
    }
}

/// A checked joint.
#[derive(Clone, Debug)]
pub struct Joint {
    pub(crate) bodies: Vec<JointBody>,
    pub(crate) pairs: Vec<ContactPair>,
    pub(crate) gauge: Gauge,
    pub(crate) options: Options,
    /// Displacements that the supports of each body prescribe for a multiplier of 1; `None` where they prescribe none.
    pub(crate) support_motion: Vec<Option<Vec<f64>>>,
    /// By how much the driven supports that pull move a node at most at a multiplier of 1 `[length]`; 1 where none pull.
    pub(crate) pulled_by: f64,
}

impl Joint {
    /// A joint of `bodies` that touch at `pairs`, read by `gauge`. All bodies have the same number of load cases.
    ///
    /// # Errors
    /// [`JointError::LoadCases`], [`JointError::InitialStrain`], [`JointError::Gauge`], [`JointError::GaugeNumber`].
    pub fn new(
        bodies: Vec<JointBody>,
        pairs: Vec<ContactPair>,
        gauge: Gauge,
    ) -> Result<Self, JointError> {
        body::check(&bodies)?;
        gauge.check(&bodies, &pairs)?;
        let motion = |body: &JointBody| {
            let (_, structure) = body.elements()?;
            let motion = structure.support_motion();
            motion.iter().any(|value| *value != 0.0).then_some(motion)
        };
        let support_motion: Vec<Option<Vec<f64>>> = bodies.iter().map(motion).collect();
        let pulling = match gauge.pull {
            Pull::Supports { body } => support_motion[body].as_deref(),
            Pull::Contact { .. } => None,
        };
        let node = |motion: &[f64]| motion[0].hypot(motion[1]);
        let largest = |motion: &[f64]| motion.chunks_exact(2).map(node).fold(0.0, f64::max);
        Ok(Self {
            pulled_by: pulling.map_or(1.0, largest),
            support_motion,
            bodies,
            pairs,
            gauge,
            options: Options::default(),
        })
    }

    /// The same joint, followed by other options.
    ///
    /// # Errors
    /// [`JointError::Option`].
    pub fn with_options(mut self, options: Options) -> Result<Self, JointError> {
        options.check()?;
        self.options = options;
        Ok(self)
    }

    /// The bodies.
    pub fn bodies(&self) -> &[JointBody] {
        &self.bodies
    }

    /// The contact pairs.
    pub fn pairs(&self) -> &[ContactPair] {
        &self.pairs
    }

    /// The options.
    pub fn options(&self) -> &Options {
        &self.options
    }

    pub(crate) fn load_cases(&self) -> usize {
        self.bodies.first().map_or(0, JointBody::load_cases)
    }

    /// By how much the supports of body `index` are driven under `multipliers`.
    pub(crate) fn drive(&self, index: usize, multipliers: &[f64]) -> f64 {
        let cases = (self.bodies[index].elements()).map_or(&[][..], |(body, _)| body.load_cases());
        (cases.iter().zip(multipliers))
            .filter(|(case, _)| case.moves_supports)
            .map(|(_, factor)| factor)
            .sum()
    }

    /// Whether supports move between `from` and `to`.
    pub(crate) fn is_driven(&self, from: &[f64], to: &[f64]) -> bool {
        (0..self.bodies.len()).any(|index| {
            self.support_motion[index].is_some() && self.drive(index, from) != self.drive(index, to)
        })
    }

    /// Nodal forces `[force]` of the load cases of body `index` times `multipliers`, interleaved; empty for a rigid body.
    pub(crate) fn nodal_loads(&self, index: usize, multipliers: &[f64]) -> Vec<f64> {
        let Some((body, _)) = self.bodies[index].elements() else {
            return Vec::new();
        };
        let mut sum = vec![0.0; 2 * body.mesh().nodes().len()];
        for (case, factor) in body.load_cases().iter().zip(multipliers) {
            for (total, force) in sum.iter_mut().zip(&case.forces) {
                *total += factor * force;
            }
        }
        sum
    }
}
