//! How far loaded and held sets move, and how stiff the model is against it.
//!
//! ```text
//! u_k = f · u / (f · e),   secant F_k / u_k,   tangent (F_k − F_{k−1}) / (u_k − u_{k−1})
//! ```
//!
//! f are the nodal forces of the load, so F u is its work: the mean displacement of an edge along e under a force that is spread evenly, that of
//! a hole weighted with the pressure under an assumed bearing load, and the mean displacement against the normal under a pressure, whose F is ∫p dA.

use super::Results;

/// Force or displacement, as a part of the largest of its set in the history, below which there is no stiffness.
const SMALL: f64 = 1e-9;

/// What makes a set of the model.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SetKind {
    /// A force acts along the unit vector `direction`.
    Force {
        /// Unit vector `[1]`.
        direction: [f64; 2],
    },
    /// A pressure acts against the outward normal.
    Pressure,
    /// A support or platen holds it, or gives its displacement, along the unit vector `direction`.
    Held {
        /// Unit vector `[1]`.
        direction: [f64; 2],
    },
}

/// A set of a body whose displacement is known or asked for.
#[derive(Clone, Debug, PartialEq)]
pub struct LoadedSet {
    /// Name of the load; that of the set where it is held.
    pub name: String,
    /// Index of the body in [`Results::bodies`].
    pub body: usize,
    /// Set of the body, `plate.left`.
    pub on: String,
    /// What acts on it.
    pub kind: SetKind,
    /// Force on the body over the force of the set, (x, y) `[1]`: the direction, of a pressure the mean normal against which it is counted.
    pub along: [f64; 2],
    /// Smallest and largest x of its nodes `[mm]`; `None` where a body is loaded or held as a whole.
    pub reach: Option<[f64; 2]>,
}

/// A set at the end of a load step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SetMotion {
    /// Force of the load, or of the support on the body, along the set's direction, of the whole model `[N]`.
    pub force: f64,
    /// Mean displacement along the set's direction `[mm]`.
    pub displacement: f64,
}

/// Stiffness of a model against a loaded set `[N/mm]`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Stiffness {
    /// Force over displacement; `None` without either.
    pub secant: Option<f64>,
    /// Change of the force over that of the displacement since the step before; `None` in the first step and where either does not change.
    pub tangent: Option<f64>,
}

impl Stiffness {
    /// That at the end of the step with the index `step` of a set whose `motion` is that of every step of a history of `steps`.
    pub fn of(motion: impl Fn(usize) -> Option<SetMotion>, steps: usize, step: usize) -> Self {
        let largest = |of: fn(SetMotion) -> f64| {
            let all = (0..steps).filter_map(&motion);
            all.fold(0.0, |most: f64, own| most.max(of(own).abs()))
        };
        let least = SetMotion {
            force: SMALL * largest(|own| own.force),
            displacement: SMALL * largest(|own| own.displacement),
        };
        let ratio = |own: SetMotion| {
            let is_there =
                own.force.abs() > least.force && own.displacement.abs() > least.displacement;
            is_there.then(|| own.force / own.displacement)
        };
        let since = |own: SetMotion| {
            let before = motion(step.checked_sub(1)?)?;
            Some(SetMotion {
                force: own.force - before.force,
                displacement: own.displacement - before.displacement,
            })
        };
        Self {
            secant: motion(step).and_then(ratio),
            tangent: motion(step).and_then(since).and_then(ratio),
        }
    }
}

/// A number of a set at the end of a load step that is stated with an error.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum SetStated {
    /// Force `[N]`: of the load, or of what holds the set.
    Force,
    /// Mean displacement `[mm]`.
    Displacement,
    /// Secant stiffness `[N/mm]`.
    Secant,
    /// Tangent stiffness `[N/mm]`.
    Tangent,
}

impl SetStated {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::Force, Self::Displacement, Self::Secant, Self::Tangent];

    /// What it is, for a reader.
    pub fn describe(self) -> &'static str {
        match self {
            Self::Force => "force on a set",
            Self::Displacement => "displacement",
            Self::Secant => "stiffness",
            Self::Tangent => "tangent stiffness",
        }
    }
}

/// The numbers of a set at the end of a load step, or their estimated errors, in base units; `None` where there is none.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SetNumbers([Option<f64>; 4]);

impl SetNumbers {
    /// Collects what `number` gives of each, in base units.
    pub fn of(number: impl FnMut(SetStated) -> Option<f64>) -> Self {
        Self(SetStated::ALL.map(number))
    }

    /// Those at the end of the step with the index `step` of a set whose `motion` is that of every step of a history of `steps`.
    pub fn at(motion: impl Fn(usize) -> Option<SetMotion>, steps: usize, step: usize) -> Self {
        let (own, stiffness) = (motion(step), Stiffness::of(motion, steps, step));
        Self::of(|stated| match stated {
            SetStated::Force => own.map(|own| own.force),
            SetStated::Displacement => own.map(|own| own.displacement),
            SetStated::Secant => stiffness.secant,
            SetStated::Tangent => stiffness.tangent,
        })
    }

    /// The one that `stated` names, in its base unit.
    pub fn get(&self, stated: SetStated) -> Option<f64> {
        self.0[stated as usize]
    }
}

impl Results {
    /// The numbers of the set with the index `set` at the end of the step with the index `step`.
    pub fn set_numbers(&self, set: usize, step: usize) -> SetNumbers {
        let motion = |step: usize| *self.steps.get(step)?.sets.get(set)?;
        SetNumbers::at(motion, self.steps.len(), step)
    }

    /// Estimated errors of these; `None` of a number that has none, or where none were estimated.
    pub fn set_errors(&self, set: usize, step: usize) -> SetNumbers {
        let step = self.steps.get(step);
        let own = step.and_then(|step| step.set_errors.get(set));
        own.copied().unwrap_or_default()
    }

    /// The stiffness against the set with the index `set` at the end of the step with the index `step`.
    pub fn stiffness(&self, set: usize, step: usize) -> Stiffness {
        let motion = |step: usize| *self.steps.get(step)?.sets.get(set)?;
        Stiffness::of(motion, self.steps.len(), step)
    }
}
