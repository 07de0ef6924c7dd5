//! Failure of the laminated bodies: stresses of every step at every node, asked ply by ply.

mod characteristic;
mod envelopes;
mod supports;

use std::f64::consts::PI;
use std::sync::Arc;

use stickslip_contact::InterfaceSolver;
use stickslip_fem_core::mesh::{Mesh, Point};
use stickslip_fem_core::parallel;
use stickslip_fem_core::stress::StressError;
use stickslip_laminate::{FailureCriterion, FailureError};

use super::error::RunError;
use super::fields::Recovered;
use super::{progressive, stresses};
use crate::failure::{PlyStresses, Sites, Tracker};
use crate::model::{FailingBody, Model, ModelBodyKind};
use crate::results::{
    BodyFailure, ContactFrame, EdgeKind, EdgePlies, EdgePly, EdgeResults, FailurePoint, FirstPly,
    LoadScale, PlyMap, Results,
};
use stickslip_scene::schema::{Failure, LaminateSheet};

/// What the scene asks about the failure of its laminates; `fields` are the steps that have fields.
pub(super) fn all(
    model: &Model,
    solver: &dyn InterfaceSolver,
    recovered: &[Recovered],
    results: &Results,
    fields: &[usize],
) -> Result<Vec<BodyFailure>, RunError> {
    let Some(failure) = &model.request.failure else {
        return Ok(Vec::new());
    };
    let subjects = failure.bodies.iter();
    subjects
        .filter_map(|own| Subject::new(model, &failure.settings, own))
        .map(|subject| {
            let mut found = subject.assess(recovered, results, fields)?;
            name_loads(&mut found, &LoadScale::of_body(results, subject.index));
            if let Some(followed) = &subject.own.progressive {
                let joint = progressive::Subject::new(subject.sheet, followed, &found);
                found.progressive = Some(joint.follow(model, solver)?);
            }
            Ok(found)
        })
        .collect()
}

/// The weakest point of every load step by one criterion, and first-ply failure.
type Followed = (Vec<FailurePoint>, Option<FirstPly>);

/// A laminated body about which the scene asks.
struct Subject<'a> {
    model: &'a Model,
    failure: &'a Failure,
    own: &'a FailingBody,
    index: usize,
    name: &'a str,
    mesh: &'a Mesh,
    sheet: &'a LaminateSheet,
    plies: PlyStresses,
    /// Coordinate that the halves of a half model differ in.
    across: usize,
}

impl<'a> Subject<'a> {
    fn new(model: &'a Model, failure: &'a Failure, own: &'a FailingBody) -> Option<Self> {
        let body = &model.bodies[own.body];
        let ModelBodyKind::Elastic(elastic) = &body.kind else {
            return None;
        };
        Some(Self {
            model,
            failure,
            own,
            index: own.body,
            name: &body.name,
            mesh: elastic.mesh(),
            sheet: &own.sheet,
            plies: PlyStresses::new(&own.sheet),
            across: own.across,
        })
    }

    fn assess(
        &self,
        recovered: &[Recovered],
        results: &Results,
        fields: &[usize],
    ) -> Result<BodyFailure, RunError> {
        let frame = self.frame(results);
        let steps = parallel::map_range(0..recovered.len(), |step| {
            self.stresses(&recovered[step], &results.steps[step].edges)
        });
        let steps = steps.into_iter().collect::<Result<Vec<Sites>, _>>()?;
        let characteristic = match self.failure.characteristic {
            Some(distances) => Some(self.characteristic(distances, frame, &steps)?),
            None => None,
        };
        let edges = self.edges(&steps)?;
        let maps = fields.iter().map(|&step| self.map(step, &steps[step]));
        let maps = maps.collect::<Result<_, _>>()?;
        let search = self.search()?;
        let mut beside = self.beside_supports(&search, &steps)?;
        let (sites, positions) = search.kept(steps, self.mesh.nodes());
        let (sites, positions) = self.both_halves(sites, positions);
        let mut found = self.followed(&sites, &positions)?;
        if let Some(beside) = &mut beside {
            beside.keep_sooner_than(&found.first_ply);
        }
        found.frame = frame;
        found.beside_supports = beside;
        found.edges = edges;
        found.characteristic = characteristic;
        found.maps = maps;
        if let Some(envelopes) = &self.failure.envelopes {
            found.envelopes = self.envelopes(envelopes)?;
        }
        Ok(found)
    }

    fn asked(&self, cause: FailureError) -> RunError {
        RunError::Failure {
            body: self.name.to_owned(),
            cause,
        }
    }

    /// Mean stress at every node.
    fn stresses(&self, recovered: &Recovered, edges: &[EdgeResults]) -> Result<Sites, StressError> {
        let loads = &self.model.request.loads;
        let heating = loads.heating(self.index, &recovered.multipliers);
        let stress = stresses::at_nodes(self.model, self.index, recovered, edges)?;
        Ok(Sites { stress, heating })
    }

    /// The places of a half model and, if the plies are not alike there, their mirror images; of a whole one the places.
    fn both_halves(
        &self,
        steps: Vec<Sites>,
        mut positions: Vec<Point>,
    ) -> (Vec<Sites>, Vec<Point>) {
        if !self.model.half || self.plies.are_their_mirror_image() {
            return (steps, positions);
        }
        let mut images = positions.clone();
        for image in &mut images {
            image[self.across] *= -1.0;
        }
        positions.extend(images);
        let doubled = steps.into_iter().map(Sites::with_mirror_images);
        (doubled.collect(), positions)
    }

    /// Weakest points and first-ply failure by all criteria, at these places.
    fn tracked(&self, sites: &[Sites], positions: &[Point]) -> Result<Vec<Followed>, RunError> {
        let by_criterion = |criterion: &Arc<dyn FailureCriterion>| {
            let mut tracker = Tracker::new(&self.plies, Arc::clone(criterion), positions);
            sites.iter().try_for_each(|sites| tracker.follow(sites))?;
            Ok(tracker.finish())
        };
        self.failure
            .criteria
            .iter()
            .map(|criterion| by_criterion(criterion).map_err(|cause| self.asked(cause)))
            .collect()
    }

    fn followed(&self, sites: &[Sites], positions: &[Point]) -> Result<BodyFailure, RunError> {
        let (by_criterion, first_ply): (Vec<_>, Vec<_>) =
            self.tracked(sites, positions)?.into_iter().unzip();
        let steps = (0..sites.len())
            .map(|step| {
                let points = by_criterion.iter().map(|steps| steps[step].clone());
                points.collect()
            })
            .collect();
        Ok(BodyFailure {
            body: self.index,
            layup: self.sheet.layup.clone(),
            cure: self.sheet.cure,
            plies: self.plies.shown().to_vec(),
            criteria: self.criteria().map(FailureCriterion::name).collect(),
            centre: self.own.hole.map(|hole| hole.centre),
            frame: ContactFrame::NONE,
            steps,
            first_ply,
            beside_supports: None,
            edges: Vec::new(),
            maps: Vec::new(),
            characteristic: None,
            envelopes: Vec::new(),
            progressive: None,
        })
    }

    fn criteria(&self) -> impl Iterator<Item = &dyn FailureCriterion> {
        self.failure.criteria.iter().map(AsRef::as_ref)
    }

    /// Failure indices of the plies at a mean stress, by group and criterion.
    fn at(&self, mean: [f64; 3], heating: f64) -> Result<Vec<EdgePly>, RunError> {
        let of_group = |group: usize| {
            let loading = self.plies.loading(group, mean, heating);
            let index = |criterion: &dyn FailureCriterion| {
                let assessed = criterion.assess(self.plies.ply(group), &loading);
                assessed.map(|assessment| assessment.index)
            };
            let indices = self.criteria().map(index).collect::<Result<_, _>>();
            Ok(EdgePly {
                stress: loading.at(1.0),
                index: indices.map_err(|cause| self.asked(cause))?,
            })
        };
        (0..self.plies.shown().len()).map(of_group).collect()
    }

    fn edges(&self, steps: &[Sites]) -> Result<Vec<EdgePlies>, RunError> {
        let own = self.model.edges.iter().enumerate();
        own.filter(|(_, edge)| edge.geometry.body == self.index)
            .map(|(index, edge)| {
                let geometry = &edge.geometry;
                let points = whole_edge(geometry.kind, &geometry.parameter, geometry.half);
                let of_step = |sites: &Sites| {
                    let mut groups = vec![Vec::new(); self.plies.shown().len()];
                    for &(k, _, sign) in &points {
                        let [x, y, t] = sites.stress[edge.nodes[k]];
                        let plies = self.at([x, y, sign * t], sites.heating)?;
                        for (group, ply) in groups.iter_mut().zip(plies) {
                            group.push(ply);
                        }
                    }
                    Ok(groups)
                };
                Ok(EdgePlies {
                    edge: index,
                    parameter: points.iter().map(|&(_, at, _)| at).collect(),
                    steps: steps.iter().map(of_step).collect::<Result<_, RunError>>()?,
                })
            })
            .collect()
    }

    /// Indices of the first criterion at all places, and of a half model at their mirror images.
    fn map(&self, step: usize, sites: &Sites) -> Result<PlyMap, RunError> {
        let Some(criterion) = self.failure.criteria.first() else {
            return Ok(PlyMap {
                step,
                index: Vec::new(),
            });
        };
        let mut sites = sites.clone();
        if self.model.half {
            sites = sites.with_mirror_images();
        }
        let of_group = |group: usize| {
            let index = |&mean: &[f64; 3]| {
                let loading = self.plies.loading(group, mean, sites.heating);
                let assessed = criterion.assess(self.plies.ply(group), &loading);
                assessed.map(|assessment| assessment.index)
            };
            let indices = parallel::map(&sites.stress, index);
            (indices.into_iter())
                .collect::<Result<Vec<f64>, _>>()
                .map_err(|cause| self.asked(cause))
        };
        Ok(PlyMap {
            step,
            index: (0..self.plies.shown().len())
                .map(of_group)
                .collect::<Result<_, _>>()?,
        })
    }

    /// From where angles about the hole are measured: the bearing point of the contact that loads it, or of its bearing load. Counter-
    /// clockwise also for a half, because plies are no mirror images of each other.
    fn frame(&self, results: &Results) -> ContactFrame {
        let Some(hole) = self.own.hole else {
            return ContactFrame::NONE;
        };
        let same = |kind: EdgeKind| match kind {
            EdgeKind::Circle { centre, radius } => {
                centre == hole.centre && (radius - hole.radius).abs() <= 1e-9 * radius
            }
            EdgeKind::Line | EdgeKind::Path => false,
        };
        let edges = self.model.edges.iter().zip(&results.edges);
        let own = edges
            .filter(|(edge, geometry)| edge.geometry.body == self.index && same(geometry.kind));
        let found = own.map(|(_, geometry)| geometry.frame);
        let found = found.filter(|frame| frame.bearing.is_some());
        ContactFrame {
            clockwise: false,
            ..found.into_iter().next().unwrap_or(self.own.frame)
        }
    }
}

/// The points of an edge and, of a half, those of its mirror image before them: index of the node, place, and the sign of the
/// shear. A closed circle starts at −180° and has no point at 180°.
fn whole_edge(kind: EdgeKind, parameter: &[f64], half: bool) -> Vec<(usize, f64, f64)> {
    let own = parameter.iter().enumerate().map(|(k, &at)| (k, at, 1.0));
    if !half {
        return own.collect();
    }
    let closed = matches!(kind, EdgeKind::Circle { .. });
    let end = |at: f64| closed && at > PI - 1e-9;
    let images = parameter.iter().enumerate().rev();
    images
        .filter(|&(_, &at)| at.abs() > 1e-12)
        .map(|(k, &at)| (k, -at, -1.0))
        .chain(own.filter(|&(_, at, _)| !end(at)))
        .collect()
}

/// Puts names and values of the load to every first-ply failure.
fn name_loads(found: &mut BodyFailure, scale: &LoadScale) {
    let name = |first: &mut Option<FirstPly>| {
        if let Some(first) = first {
            first.load = scale.at_failure(first.step, first.factor, first.reached);
        }
    };
    found.first_ply.iter_mut().for_each(name);
    if let Some(beside) = &mut found.beside_supports {
        beside.sooner.iter_mut().for_each(name);
    }
    if let Some(characteristic) = &mut found.characteristic {
        characteristic.net_section.iter_mut().for_each(name);
        characteristic.bearing_point.iter_mut().for_each(name);
        for joint in characteristic.curve.iter_mut().flatten() {
            let first = &mut joint.first;
            first.load = scale.at_failure(first.step, first.factor, first.reached);
        }
    }
}
