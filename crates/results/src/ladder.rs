//! What an accuracy bounds, and the models that were tried for it.

use serde::Serialize;
use stickslip_scene::schema::{Accuracy, Bounds, RelativeError};

use super::displacement::SetStated;
use super::stated::Stated;

/// A number whose relative error an accuracy can bound.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Bounded {
    /// That of an edge.
    Edge(Stated),
    /// That of a set.
    Set(SetStated),
}

impl From<Stated> for Bounded {
    fn from(stated: Stated) -> Self {
        Self::Edge(stated)
    }
}

impl From<SetStated> for Bounded {
    fn from(stated: SetStated) -> Self {
        Self::Set(stated)
    }
}

impl Bounded {
    /// All that `accuracy` bounds, with the relative errors `[1]` that it allows.
    pub fn all(accuracy: Accuracy) -> impl Iterator<Item = (Self, f64)> {
        let edges = Stated::ALL.into_iter().map(Self::Edge);
        let all = edges.chain(SetStated::ALL.map(Self::Set));
        all.filter_map(move |own| Some((own, own.bound(accuracy)?)))
    }

    /// What it is, for a reader.
    pub fn describe(self) -> &'static str {
        match self {
            Self::Edge(stated) => stated.describe(),
            Self::Set(stated) => stated.describe(),
        }
    }

    /// The relative error `[1]` of it that `accuracy` allows; `None` where that does not bound it.
    pub fn bound(self, accuracy: Accuracy) -> Option<f64> {
        let named = match accuracy {
            Accuracy::Overall(error) => {
                let is_asked = matches!(self, Self::Edge(own) if Stated::ASKED.contains(&own));
                return is_asked.then(|| error.share());
            }
            Accuracy::Named(bounds) => bounds,
        };
        // Without `..`, so that no bound is without effect.
        let Bounds {
            peak_pressure,
            peak_hoop,
            contact_extent,
            stick_extent,
            friction_force,
            normal_force,
            hoop_at_bearing,
            displacement,
            stiffness,
            tangent_stiffness,
            reaction,
        } = named;
        let error = match self {
            Self::Edge(Stated::PeakPressure) => peak_pressure,
            Self::Edge(Stated::PeakHoop) => peak_hoop,
            Self::Edge(Stated::ContactExtent) => contact_extent,
            Self::Edge(Stated::StickExtent) => stick_extent,
            Self::Edge(Stated::FrictionForce) => friction_force,
            Self::Edge(Stated::NormalForce) => normal_force,
            Self::Edge(Stated::HoopAtBearing) => hoop_at_bearing,
            Self::Edge(_) => None,
            Self::Set(SetStated::Force) => reaction,
            Self::Set(SetStated::Displacement) => displacement,
            Self::Set(SetStated::Secant) => stiffness,
            Self::Set(SetStated::Tangent) => tangent_stiffness,
        };
        error.map(RelativeError::share)
    }
}

/// A model that was tried on the way to an accuracy.
#[derive(Clone, Debug, PartialEq)]
pub struct Rung {
    /// How it is divided: "series, 61 nodes".
    pub model: String,
    /// Increments of each load step.
    pub increments: Vec<usize>,
    /// The relative error `[1]` of what is asked for that is largest beside its bound, and what has it; `None` of the first rung, which has no coarser one to compare with, and of one that was stopped.
    pub error: Option<(f64, Bounded)>,
    /// Wall time `[s]`.
    pub seconds: f64,
    /// Whether it was given up because the budget was spent.
    pub stopped: bool,
}

impl Rung {
    /// Largest number of increments of a load step.
    pub fn most_increments(&self) -> usize {
        self.increments.iter().copied().max().unwrap_or(1)
    }
}

/// How an accuracy was sought.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Ladder {
    /// What was asked for; `None` where only errors were.
    pub asked: Option<Accuracy>,
    /// What was tried, in this order; the results are those of the last one that was not stopped.
    pub rungs: Vec<Rung>,
    /// Why the climb ended there.
    pub end: LadderEnd,
}

/// Why no finer model was tried.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum LadderEnd {
    /// The estimated errors meet what was asked.
    Reached,
    /// The division is pinned by the scene.
    #[default]
    Pinned,
    /// The budget is spent.
    Budget,
    /// A finer model would take more memory than it may.
    Memory,
    /// The finest model that is tried.
    Finest,
    /// What the increments of load steps leave is too much, and nearly all.
    LoadPath,
    /// No error is stated: what gaps on the deformed geometry would change was to be found and was not.
    Unchecked,
    /// No error can be stated of a number whose accuracy is asked for by its name, or of any that an accuracy without names bounds; others are met.
    Unstated,
}

impl LadderEnd {
    /// Its name in `summary.json`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Reached => "reached",
            Self::Pinned => "pinned",
            Self::Budget => "budget",
            Self::Memory => "memory",
            Self::Finest => "finest",
            Self::LoadPath => "load_path",
            Self::Unchecked => "unchecked",
            Self::Unstated => "unstated",
        }
    }
}
