//! Friction of measured states: where edges slip, and with which coefficient.
//!
//! ```text
//! slip at the end of contact:   s τ = μ_d p,     stick inside:   |τ| ≤ μ_s p   ⇒   μ_s ≥ |τ|/p
//! ```
//!
//! Slip starts at the ends of contact. A zone goes from there inwards as far as one coefficient explains its tractions; places nearer to
//! its ends than the edge can resolve are left out, because stresses are not smooth there. The coefficient of all zones of all
//! states is fitted once more to all of them together, and a Monte Carlo simulation confirms its interval.

mod coarser;
mod grip;
pub mod static_friction;
mod zone;
mod zones;

use stickslip_hybrid::identify::{Bounds, SlipFit, Tractions, chi_squared_of_one};

use super::analysed::Analysed;
use super::error::ExperimentError;
use super::finding::FrictionFinding;
use stickslip_experiment::{Experiment, RegionShape};
use stickslip_text::short;

pub use coarser::{Coarser, on_half_the_cells};
pub use grip::Grip;
pub use static_friction::moves;
pub use zone::SlipZone;

/// Draws of the coefficient of all zones.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Simulation {
    /// Number of draws.
    pub samples: usize,
    /// Their mean `[1]`.
    pub mean: f64,
    /// Their standard deviation `[1]`.
    pub deviation: f64,
    /// The interval `[1]` that holds the confidence's part of them, with equal parts beyond either end.
    pub interval: [f64; 2],
}

/// Friction of an experiment.
#[derive(Clone, Debug)]
pub struct Identified {
    /// Slip zones of all states.
    pub zones: Vec<SlipZone>,
    /// The coefficient of all zones together; `None` where nothing slips beyond doubt.
    pub dynamic: Option<SlipFit>,
    /// Whether the zones' own coefficients are the same within their errors.
    pub zones_agree: bool,
    /// Monte Carlo simulation of that, where it has an upper end.
    pub simulation: Option<Simulation>,
    /// How far the coefficient moves on half of the region's cells, where that was asked `[1]`: an error of the mesh that intervals hold.
    pub mesh: Option<f64>,
    /// What asks for the greatest static friction, of all stretches inside of slip zones.
    pub grip: Option<Grip>,
    /// Where no zone is recognised.
    pub findings: Vec<FrictionFinding>,
}

/// Number of standard deviations `[1]` by which χ² of all zones may exceed its mean before one coefficient is rejected.
pub const CONSISTENT: f64 = 3.0;

impl Identified {
    /// The interval of the coefficient of all zones, by noise and mesh; `None` without slip zones, and where χ² rejects one coefficient for
    /// all of them.
    pub fn dynamic_bounds(&self) -> Option<Bounds> {
        let fit = self.dynamic.as_ref()?;
        self.is_explained().then(|| self.with_mesh(fit))
    }

    /// The interval of the coefficient of `zone` alone; `None` where χ² rejects it, and where zones contradict each other, so that one of
    /// them does not slip all over.
    pub fn zone_bounds(&self, zone: &SlipZone) -> Option<Bounds> {
        let holds = self.is_explained() && zone.fit.is_consistent(CONSISTENT);
        holds.then(|| self.with_mesh(&zone.fit))
    }

    /// Takes what the same data on half of the cells say of the error of the mesh.
    #[must_use]
    pub fn beside(mut self, coarser: Option<&Coarser>) -> Self {
        let moved = |coarse: &SlipFit| Some((self.dynamic.as_ref()?.mu - coarse.mu).abs());
        self.mesh = coarser.and_then(|own| own.dynamic.as_ref()).and_then(moved);
        self
    }

    fn with_mesh(&self, fit: &SlipFit) -> Bounds {
        fit.bounds.widened(fit.mu, self.mesh.unwrap_or(0.0), 0.0)
    }

    /// Whether one coefficient explains all slip zones: χ² of all together, and beside that of each alone.
    pub fn is_explained(&self) -> bool {
        let consistent = |fit: &SlipFit| fit.is_consistent(CONSISTENT);
        self.zones_agree && self.dynamic.as_ref().is_none_or(consistent)
    }

    /// What makes the coefficient doubtful, `coarser` being the same on half of the cells.
    pub(crate) fn doubts(&self, coarser: Option<&Coarser>) -> Vec<FrictionFinding> {
        let Some(fit) = &self.dynamic else {
            return Vec::new();
        };
        let mut found = Vec::new();
        if !self.is_explained() {
            found.push(if self.zones_agree {
                FrictionFinding::Rejected
            } else {
                FrictionFinding::ZonesDisagree
            });
        }
        let [has_friction, _] = fit.bounds.ends().map(|end| end.is_some());
        if has_friction && self.zones.iter().any(SlipZone::has_no_end) {
            found.push(FrictionFinding::ZoneWithoutEnd);
        }
        found.extend(coarser.and_then(|own| own.doubt(fit)));
        found
    }

    /// The stretch that bounds static friction from below; `None` where no bound lies above what slipping places leave of the dynamic
    /// coefficient, or where that is rejected.
    pub fn static_bound(&self) -> Option<&Grip> {
        let [_, high] = self.dynamic_bounds()?.ends();
        let highest = high.unwrap_or(f64::INFINITY);
        self.grip.as_ref().filter(|grip| grip.at_least > highest)
    }
}

/// Identifies friction from the edge stresses of all states.
///
/// # Errors
/// [`ExperimentError::Identify`] for tractions without a covariance.
pub fn identify(
    experiment: &Experiment,
    analysed: &[Analysed],
) -> Result<Identified, ExperimentError> {
    on_the_hole(experiment)?;
    let rise = chi_squared_of_one(experiment.identify.confidence);
    let mut findings = Vec::new();
    let mut zones = Vec::new();
    for found in analysed {
        zones.extend(zones::of_state(experiment, found, rise, &mut findings)?);
    }
    let together = together(analysed, &zones)?;
    let (mut dynamic, mut simulation) = (None, None);
    if let Some(tractions) = together {
        let all = 0..tractions.pressure.len();
        let fit = tractions.slip_within(all.clone(), true, rise)?;
        let plan = &experiment.identify;
        let draws = tractions.simulate(all, true, &fit, plan.samples, plan.seed)?;
        simulation = summarised(draws, plan.confidence);
        dynamic = Some(fit);
    }
    Ok(Identified {
        grip: grip::grip(&experiment.identify, analysed, &zones)?,
        zones_agree: dynamic.as_ref().is_none_or(|fit| agree(&zones, fit)),
        zones,
        dynamic,
        simulation,
        mesh: None,
        findings,
    })
}

/// Whether χ² of one coefficient for all `zones` exceeds the sum of theirs by no more than chance makes of it.
fn agree(zones: &[SlipZone], together: &SlipFit) -> bool {
    const DEVIATIONS: f64 = 3.0;
    let own: f64 = zones.iter().map(|zone| zone.fit.chi_squared).sum();
    let difference = SlipFit {
        chi_squared: (together.chi_squared - own).max(0.0),
        degrees: zones.len().saturating_sub(1),
        ..together.clone()
    };
    difference.is_consistent(DEVIATIONS)
}

/// Refuses a region that stands off from the hole: shear over pressure at a distance is not friction.
fn on_the_hole(experiment: &Experiment) -> Result<(), ExperimentError> {
    match experiment.region.as_ref().map(|plan| &plan.shape) {
        Some(RegionShape::Sector(sector)) if sector.stand_off > 0.0 => {
            Err(ExperimentError::Missing {
                key: "region.sector.stand_off".to_owned(),
                what: format!(
                    "friction acts on the hole, and the region begins {} mm from it",
                    short(sector.stand_off)
                ),
                remedy: "leave stand_off out and mask data near the edge by reduce.margin: the fit goes on to the edge".to_owned(),
            })
        }
        _ => Ok(()),
    }
}

/// The tractions of all zones, with shears along friction.
fn together(
    analysed: &[Analysed],
    zones: &[SlipZone],
) -> Result<Option<Tractions>, ExperimentError> {
    let mut parts = Vec::new();
    for found in analysed {
        let own = zones.iter().filter(|zone| zone.state == found.state);
        let own: Vec<_> = own
            .map(|zone| (zone.places.clone(), zone.positive))
            .collect();
        if !own.is_empty() {
            parts.push(found.tractions.of_zones(&own)?);
        }
    }
    Ok(if parts.is_empty() {
        None
    } else {
        Some(Tractions::together(&parts)?)
    })
}

fn summarised(mut draws: Vec<f64>, confidence: f64) -> Option<Simulation> {
    let count = draws.len();
    if count < 2 {
        return None;
    }
    draws.sort_by(f64::total_cmp);
    let mean = draws.iter().sum::<f64>() / count as f64;
    let squares = draws.iter().map(|draw| (draw - mean).powi(2));
    let beyond = 0.5 * (1.0 - confidence) * (count - 1) as f64;
    let at = |position: f64| draws[(position.round() as usize).min(count - 1)];
    Some(Simulation {
        samples: count,
        mean,
        deviation: (squares.sum::<f64>() / (count - 1) as f64).sqrt(),
        interval: [at(beyond), at((count - 1) as f64 - beyond)],
    })
}

/// τ/p `[1]` at a place and its standard deviation `[1]`, to first order.
pub fn ratio(found: &Analysed, place: usize) -> (f64, f64) {
    found.tractions.ratio(place)
}

/// Bounds as text.
pub fn describe_bounds(bounds: Bounds) -> String {
    match bounds {
        Bounds::Between(low, high) => format!("between {low:.4} and {high:.4}"),
        Bounds::AtMost(high) => format!("at most {high:.4}; there may be no friction at all"),
        Bounds::AtLeast(low) => format!("at least {low:.4}; no upper bound is identifiable"),
        Bounds::Nothing => "not identifiable: no coefficient is ruled out".to_owned(),
    }
}
