//! Compares the force on an edge with the stated load.
//!
//! ```text
//! F_b = R t ∫ (p cos φ + τ sin φ) dφ,   φ from the bearing point, over the contact in sight and the mirror image of what is not
//! ```
//!
//! A wrong unit changes the ratio by a larger factor than a slightly asymmetric contact. Loads are labels and need not equal the
//! contact force exactly, so only a ratio well away from 1 is reported.

use std::f64::consts::TAU;

use super::Analysed;
use crate::finding::NotCompared;
use stickslip_experiment::history::History;
use stickslip_experiment::{Experiment, RegionShape, Source};

/// Factor between force and load within which they agree.
const FACTOR: f64 = 1.3;
/// The same for the load over the force where the initial load is not known, which the force does not hold.
const ABOVE_NULL: f64 = 10.0;
/// Standard deviations, and part of all tractions along the load whatever their sign, by which the force may be wrong.
const ALLOWED: [f64; 2] = [3.0, 0.1];
/// Largest angle around the bearing point that may be out of sight, to either side `[rad]`.
const HIDDEN: f64 = 0.5;

/// The force on an edge along its bearing point against the stated load.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LoadCheck {
    /// Force of the whole contact `[N]`, by symmetry of what is out of sight.
    pub force: f64,
    /// Its standard deviation by noise `[N]`.
    pub deviation: f64,
    /// Error that noise, asymmetry and the mesh explain together `[N]`.
    pub explained: f64,
    /// The stated load, less that of the null field where it is known `[N]`.
    pub load: f64,
    /// Whether there is a null field whose load is not known.
    pub above_null: bool,
    /// The bearing point `[rad]`.
    pub bearing: f64,
    /// Whether all of the contact is in sight.
    pub is_whole: bool,
}

impl LoadCheck {
    /// Whether force and load differ by more than a factor that anything but a wrong unit or value explains.
    pub fn fails(&self) -> bool {
        let less = if self.above_null { ABOVE_NULL } else { FACTOR };
        self.force - self.explained > FACTOR * self.load
            || (self.force + self.explained) * less < self.load
    }
}

impl Analysed {
    /// Compares the force on the edge with the load of the state.
    ///
    /// # Errors
    /// Why they cannot be compared.
    pub fn load_check(&self, experiment: &Experiment) -> Result<LoadCheck, NotCompared> {
        let (load, above_null) = load(experiment, self.state)?;
        let contact = self.contact().ok_or(NotCompared::NoContact)?;
        let sight = (self.sight()).ok_or(NotCompared::Noise)?;
        if sight.ends == [false; 2] {
            return Err(NotCompared::NoEnd);
        }
        let stated = experiment.identify.bearing;
        if (self.bearing_check(stated)).is_some_and(|check| check.fails()) {
            return Err(NotCompared::DoubtfulBearing);
        }
        let bearing = self.bearing(&contact, stated);
        let from = sight.turned(&self.angle, bearing);
        let places = sight.places.clone();
        let [first, last] = [places.start, places.end - 1];
        let [start, end] = [first, last].map(|k| from(self.angle[k]));
        let gap = start.max(-end).max(0.0);
        if gap > HIDDEN {
            return Err(NotCompared::HiddenBearing);
        }
        let is_seen = |at: f64| {
            let turns = [at - TAU, at, at + TAU];
            turns.iter().any(|at| (start..=end).contains(at))
        };
        let n = self.angle.len();
        let mut row = Vec::new();
        for (k, width) in places.clone().zip(self.widths(&places)) {
            let angle = from(self.angle[k]);
            let (s, c) = angle.sin_cos();
            let width = if is_seen(-angle) { width } else { 2.0 * width };
            row.extend([(k, width * c), (n + k, width * s)]);
        }
        row.push((if start > 0.0 { first } else { last }, 2.0 * gap.sin()));
        let area = radius(experiment) * experiment.specimen.thickness;
        for (_, weight) in &mut row {
            *weight *= area;
        }
        let own = &self.tractions;
        let parts = (row.iter()).map(|(k, weight)| {
            let stress = if *k < n {
                own.pressure[*k]
            } else {
                own.shear[*k - n]
            };
            weight * stress
        });
        let (force, gross) = parts.fold((0.0, 0.0), |(force, gross), part| {
            (force + part, gross + part.abs())
        });
        let deviation = self.deviation_of(&row);
        Ok(LoadCheck {
            force,
            deviation,
            explained: ALLOWED[0] * deviation + ALLOWED[1] * gross,
            load,
            above_null,
            bearing,
            is_whole: sight.ends == [true; 2],
        })
    }
}

/// Radius of the region's edge `[mm]`.
fn radius(experiment: &Experiment) -> f64 {
    let stand_off = match experiment.region.as_ref().map(|plan| &plan.shape) {
        Some(RegionShape::Sector(sector)) => sector.stand_off,
        _ => 0.0,
    };
    experiment.specimen.hole.radius + stand_off
}

/// Load since the null field, and whether that is not known to be free of load.
fn load(experiment: &Experiment, state: usize) -> Result<(f64, bool), NotCompared> {
    let plan = &experiment.states[state];
    let load = plan.load.ok_or(NotCompared::NoLoad)?;
    let scene = experiment.specimen.scene.as_ref();
    if scene.is_some_and(|own| own.scene.loads.len() > 1 || own.scene.contacts.len() > 1) {
        return Err(NotCompared::OtherLoads);
    }
    let null = match &plan.null {
        None => Some(0.0),
        Some(Source::Step(step)) => scene.and_then(|own| History::of(&own.scene).load(*step)),
        Some(_) => None,
    };
    let load = (load - null.unwrap_or(0.0)).abs();
    if load > 0.0 {
        Ok((load, null.is_none()))
    } else {
        Err(NotCompared::ZeroLoad)
    }
}
