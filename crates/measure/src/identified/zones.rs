//! Which part of an edge slips.

use std::ops::Range;

use stickslip_hybrid::identify::{Bounds, IdentifyError, SlipFit, Tractions};

use super::grip::MARGIN;
use super::zone::SlipZone;
use crate::analysed::Analysed;
use crate::error::ExperimentError;
use crate::finding::FrictionFinding;
use stickslip_experiment::{Experiment, ZonePlan};

/// Standard deviations by which χ² of a zone may exceed what it should be.
const CONSISTENT: f64 = 3.0;
/// Fewest places of a zone.
const FEWEST: usize = 3;
/// Part of a flank that a zone must cover to be one although it goes as far as the bearing point: slip of pins in holes covers less than
/// half of it only where friction exceeds 0.4, and twice the resolved angle at the end of contact is left out.
const COVERED: f64 = 0.6;
/// Places next to the end of contact that say which way friction acts.
const LEADING: usize = 5;

/// The slip zones of a state: those given by hand, or those that are recognised on either flank of contact.
pub(super) fn of_state(
    experiment: &Experiment,
    found: &Analysed,
    rise: f64,
    findings: &mut Vec<FrictionFinding>,
) -> Result<Vec<SlipZone>, ExperimentError> {
    let name = &experiment.states[found.state].name;
    let plans = experiment.identify.zones.iter();
    let own: Vec<_> = plans.filter(|zone| zone.state == found.state).collect();
    if !own.is_empty() {
        return own
            .into_iter()
            .map(|plan| stated(found, name, plan, experiment.identify.bearing, rise))
            .collect();
    }
    let mut zones = Vec::new();
    let Some(contact) = found.contact() else {
        findings.push(FrictionFinding::NoPressure {
            state: name.clone(),
        });
        return Ok(zones);
    };
    let bearing = found.bearing_place(&contact, experiment.identify.bearing);
    for flank in [Flank::After, Flank::Before] {
        match recognised(found, &contact, bearing, flank, rise)? {
            Some(zone) => zones.push(zone),
            None if flank.ends_in_sight(found, &contact) => {
                findings.push(FrictionFinding::NoZone {
                    state: name.clone(),
                    after: flank == Flank::After,
                    bearing_degrees: found.angle[bearing].to_degrees(),
                });
            }
            None => {}
        }
    }
    Ok(zones)
}

/// A zone that is stated in the experiment.
fn stated(
    found: &Analysed,
    name: &str,
    plan: &ZonePlan,
    bearing: Option<f64>,
    rise: f64,
) -> Result<SlipZone, ExperimentError> {
    let [from, to] = plan.angles;
    let start = found.angle.partition_point(|angle| *angle < from);
    let end = found.angle.partition_point(|angle| *angle <= to);
    if start >= end {
        let ends = [found.angle.first(), found.angle.last()];
        let [first, last] = ends.map(|angle| angle.copied().unwrap_or_default().to_degrees());
        return Err(ExperimentError::Missing {
            key: "identify.zones".to_owned(),
            what: format!(
                "state '{name}': no place of the region lies between {:.2} and {:.2} deg",
                from.to_degrees(),
                to.to_degrees()
            ),
            remedy: format!("the region's edge goes from {first:.2} to {last:.2} deg"),
        });
    }
    let places = start..end;
    let data = &found.tractions;
    let positive = direction(data, places.clone())?;
    Ok(SlipZone {
        state: found.state,
        fit: data.slip_within(places.clone(), positive, rise)?,
        inside: beyond_slip(found, bearing, &places, positive)?,
        places,
        positive,
        given: true,
    })
}

/// A side of the bearing point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Flank {
    /// Greater angles.
    After,
    /// Smaller angles.
    Before,
}

impl Flank {
    /// Whether a zone goes as far as the bearing point.
    const fn reaches(self, zone: &Range<usize>, bearing: usize) -> bool {
        match self {
            Self::After => zone.start <= bearing,
            Self::Before => zone.end > bearing,
        }
    }

    /// A zone without its inner `margin`, in which the first places of stick are hidden in the noise.
    fn without_inner(self, zone: &Range<usize>, angle: &[f64], margin: f64) -> Range<usize> {
        match self {
            Self::After => angle.partition_point(|a| *a < angle[zone.start] + margin)..zone.end,
            Self::Before => {
                zone.start..angle.partition_point(|a| *a <= angle[zone.end - 1] - margin)
            }
        }
    }

    /// Whether contact ends on this side within the places that can be trusted.
    fn ends_in_sight(self, found: &Analysed, contact: &Range<usize>) -> bool {
        let inner = found.inner();
        match self {
            Self::After => contact.end < inner.end,
            Self::Before => contact.start > inner.start,
        }
    }
}

fn recognised(
    found: &Analysed,
    contact: &Range<usize>,
    bearing: usize,
    flank: Flank,
    rise: f64,
) -> Result<Option<SlipZone>, IdentifyError> {
    if !flank.ends_in_sight(found, contact) {
        return Ok(None);
    }
    let margin = MARGIN * found.resolution * (1.0 - 1e-6);
    let angle = &found.angle;
    let end = match flank {
        Flank::After => angle
            .partition_point(|a| *a <= angle[contact.end - 1] - margin)
            .saturating_sub(1),
        Flank::Before => angle.partition_point(|a| *a < angle[contact.start] + margin),
    };
    let is_beyond = match flank {
        Flank::After => end < bearing + FEWEST,
        Flank::Before => end + FEWEST > bearing,
    };
    if is_beyond {
        return Ok(None);
    }
    let leading = match flank {
        Flank::After => end + 1 - LEADING.min(end + 1 - bearing)..end + 1,
        Flank::Before => end..(end + LEADING).min(bearing + 1),
    };
    let data = &found.tractions;
    let positive = direction(data, leading)?;
    let (full, _) = data.slip_zone(end, bearing, positive, CONSISTENT)?;
    let places = if flank.reaches(&full, bearing) {
        if !covers(&found.angle, contact, bearing, flank, &full) {
            return Ok(None);
        }
        surest(data, &full, flank, positive, rise)?
    } else {
        flank.without_inner(&full, angle, margin)
    };
    if places.len() < FEWEST {
        return Ok(None);
    }
    Ok(Some(SlipZone {
        state: found.state,
        fit: data.slip_within(places.clone(), positive, rise)?,
        inside: match flank {
            Flank::After => bearing..full.start,
            Flank::Before => full.end..bearing + 1,
        },
        places,
        positive,
        given: false,
    }))
}

/// Whether a zone that goes as far as the bearing point is the greater part of its flank. A lesser one, beside the bearing point, may stick
/// all over: shear is small there whatever the friction.
fn covers(
    angle: &[f64],
    contact: &Range<usize>,
    bearing: usize,
    flank: Flank,
    full: &Range<usize>,
) -> bool {
    let (far, end) = match flank {
        Flank::After => (full.end - 1, contact.end - 1),
        Flank::Before => (full.start, contact.start),
    };
    let from_bearing = |place: usize| (angle[place] - angle[bearing]).abs();
    // Where the bearing point is not in contact, or not in sight, the nearest end of contact stands for it.
    let holds = contact.start < bearing && bearing + 1 < contact.end;
    holds && from_bearing(far) >= COVERED * from_bearing(end)
}

/// Places of a zone that goes as far as the bearing point, where friction turns. If it slips there, its end is unknown, and its outer half
/// slips most surely.
fn surest(
    data: &Tractions,
    full: &Range<usize>,
    flank: Flank,
    positive: bool,
    rise: f64,
) -> Result<Range<usize>, IdentifyError> {
    let half = full.len() / 2;
    let bounds = data.slip_within(full.clone(), positive, rise)?.bounds;
    let rubs = matches!(bounds, Bounds::Between(..) | Bounds::AtLeast(_));
    Ok(match flank {
        Flank::After if rubs => full.end - half..full.end,
        Flank::Before if rubs => full.start..full.start + half,
        _ => full.clone(),
    })
}

/// Places from where slip is recognised to end, beyond a stated zone or at its end, to the bearing point.
fn beyond_slip(
    found: &Analysed,
    bearing: Option<f64>,
    zone: &Range<usize>,
    positive: bool,
) -> Result<Range<usize>, IdentifyError> {
    let Some(contact) = found.contact() else {
        return Ok(0..0);
    };
    let bearing = found.bearing_place(&contact, bearing);
    let after = bearing < zone.start;
    if !after && bearing < zone.end {
        return Ok(0..0);
    }
    let end = if after { zone.end - 1 } else { zone.start };
    let (full, _) = (found.tractions).slip_zone(end, bearing, positive, CONSISTENT)?;
    Ok(if after {
        bearing..full.start.min(zone.start)
    } else {
        full.end.max(zone.end)..bearing + 1
    })
}

/// Whether friction acts along +τ: the direction that explains the places better.
fn direction(data: &Tractions, places: Range<usize>) -> Result<bool, IdentifyError> {
    let [along, against]: [SlipFit; 2] =
        [data.slip(places.clone(), true)?, data.slip(places, false)?];
    Ok(along.chi_squared <= against.chi_squared)
}
