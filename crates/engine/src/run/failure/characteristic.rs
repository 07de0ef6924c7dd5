//! Failure on the characteristic curve and at its ends.

use stickslip_fem_core::mesh::Point;

use super::{RunError, Subject};
use crate::failure::{Region, Sample, Sites, curve, joint_mode, locate};
use crate::model::ModelError;
use crate::results::{CharacteristicFailure, ContactFrame, FirstPly, JointFailure};
use stickslip_scene::schema::Characteristic;

impl Subject<'_> {
    pub(super) fn characteristic(
        &self,
        distances: Characteristic,
        frame: ContactFrame,
        steps: &[Sites],
    ) -> Result<CharacteristicFailure, RunError> {
        let outside = |why: String| ModelError::Unsupported {
            key: "failure.characteristic".to_owned(),
            what: why,
        };
        let hole = self
            .own
            .hole
            .ok_or_else(|| outside(format!("body '{}' has no hole to measure from", self.name)))?;
        let (angles, places): (Vec<f64>, Vec<Point>) =
            curve(hole, distances, self.model.half, frame)
                .into_iter()
                .unzip();
        let samples = locate(self.mesh, &places);
        let found: Option<Vec<&Sample>> = samples.iter().map(Option::as_ref).collect();
        let samples = found.ok_or_else(|| {
            let show = |value: f64| self.model.request.units.length.show(value);
            outside(format!(
                "the characteristic curve, {} from the hole's edge at the net section and {} at the bearing point, leaves body '{}'",
                show(distances.tension),
                show(distances.compression),
                self.name
            ))
        })?;
        let sampled = |sites: &Sites| Sites {
            stress: samples.iter().map(|at| at.of(&sites.stress)).collect(),
            heating: sites.heating,
        };
        let sites: Vec<Sites> = steps.iter().map(sampled).collect();
        let last = places.len() - 1;
        let middle = if self.model.half { 0 } else { last / 2 };
        let net = if self.model.half {
            vec![last]
        } else {
            vec![last, 0]
        };
        let mut found = CharacteristicFailure {
            tension: distances.tension,
            compression: distances.compression,
            curve: self.joint_failures(&sites, &places, hole, frame)?,
            net_section: self.at_places(&sites, &places, &net)?,
            bearing_point: self.at_places(&sites, &places, &[middle])?,
            index: sites
                .iter()
                .map(|sites| self.profile(sites))
                .collect::<Result<_, _>>()?,
            angles: self.whole_curve(&angles),
            places: self.whole_places(&places),
        };
        ascend(&mut found);
        Ok(found)
    }

    fn joint_failures(
        &self,
        sites: &[Sites],
        places: &[Point],
        hole: Region,
        frame: ContactFrame,
    ) -> Result<Vec<Option<JointFailure>>, RunError> {
        let all: Vec<usize> = (0..places.len()).collect();
        let joint = |first: FirstPly| {
            let [x, y] = first.at.position;
            let angle = frame.turned((y - hole.centre[1]).atan2(x - hole.centre[0]));
            JointFailure {
                mode: joint_mode(angle),
                angle,
                first,
            }
        };
        let firsts = self.at_places(sites, places, &all)?;
        Ok(firsts.into_iter().map(|first| first.map(joint)).collect())
    }

    /// First-ply failure by all criteria at some of the places.
    pub(super) fn at_places(
        &self,
        sites: &[Sites],
        places: &[Point],
        chosen: &[usize],
    ) -> Result<Vec<Option<FirstPly>>, RunError> {
        let some = sites.iter().map(|sites| sites.chosen(chosen)).collect();
        let chosen_places = chosen.iter().map(|&k| places[k]).collect();
        let (sites, positions) = self.both_halves(some, chosen_places);
        let tracked = self.tracked(&sites, &positions)?;
        Ok(tracked.into_iter().map(|(_, first)| first).collect())
    }

    /// The largest index of the first criterion over the plies, along the whole curve.
    fn profile(&self, sites: &Sites) -> Result<Vec<f64>, RunError> {
        let largest = |mean: [f64; 3]| -> Result<f64, RunError> {
            let plies = self.at(mean, sites.heating)?;
            let indices = plies.iter().filter_map(|ply| ply.index.first());
            Ok(indices.copied().fold(f64::NEG_INFINITY, f64::max))
        };
        let mirrored = sites.stress.iter().skip(1).rev();
        let images: Vec<[f64; 3]> = mirrored.map(|&[x, y, t]| [x, y, -t]).collect();
        let below = if self.model.half { images } else { Vec::new() };
        let all = below.into_iter().chain(sites.stress.iter().copied());
        all.map(largest).collect()
    }

    fn whole_curve(&self, angles: &[f64]) -> Vec<f64> {
        let mirrored = angles.iter().skip(1).rev().map(|angle| -angle);
        let below: Vec<f64> = mirrored.filter(|_| self.model.half).collect();
        below.into_iter().chain(angles.iter().copied()).collect()
    }

    fn whole_places(&self, places: &[Point]) -> Vec<Point> {
        let mirrored = places.iter().skip(1).rev().map(|&[x, y]| [x, -y]);
        let below: Vec<Point> = mirrored.filter(|_| self.model.half).collect();
        below.into_iter().chain(places.iter().copied()).collect()
    }
}

/// Orders the curve by ascending angles: the modelled half of a hole that bears at −x lies at negative ones.
fn ascend(found: &mut CharacteristicFailure) {
    if found.angles.first() > found.angles.last() {
        found.angles.reverse();
        found.places.reverse();
        found.index.iter_mut().for_each(|index| index.reverse());
    }
}
