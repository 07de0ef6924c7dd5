//! A joint followed beyond the failure of its plies: the scene's model with a history at every point of one body.
//!
//! Under displacement control the scene's loads are left out, and the driven edge or point is held along the driven axis at a
//! displacement that grows. The load is the force of the pin on the plate along the direction in which the pin bears under the scene's
//! own loads, or without any against the drive; the displacement is that of the pin's centre against the far end of the plate, counted
//! from where a pin with clearance can bear.

mod description;
mod edge;
mod findings;
mod reading;
mod reported;
mod subject;

use std::sync::Arc;

use stickslip_contact::InterfaceSolver;
use stickslip_fem_core::{ElasticBody, QuadraturePoints};
use stickslip_joint::{
    Ending, Joint, JointBody, JointError, JointHistory, Options, ProgressiveBody,
};
use stickslip_laminate::progressive::PointModel;
use stickslip_scene::schema::Control;

use super::error::{ProgressiveRunError, RunError};
use crate::model::{Model, ModelBodyKind};
use crate::results::{LinearJoint, ProgressiveFailure};
use reading::{Reading, direction};
use subject::crack_band;

pub(super) use subject::Subject;

/// The largest load on the way `[N]`, and the displacements of the body under it.
#[derive(Default)]
struct Peak {
    load: f64,
    displacements: Vec<f64>,
}

impl Subject<'_> {
    /// Follows the joint whose model under the scene's own loads is `model`.
    pub(super) fn follow(
        &self,
        model: &Model,
        solver: &dyn InterfaceSolver,
    ) -> Result<ProgressiveFailure, RunError> {
        let followed = self.followed.driven.as_deref().unwrap_or(model);
        let bodies = self.bodies(followed, true)?;
        let body = || self.asked.body.clone();
        let frame = (self.frame(followed.half))
            .ok_or_else(|| self.refused(ProgressiveRunError::NoBearing { body: body() }))?;
        let bearing = frame.bearing.unwrap_or_default();
        let reading = (self.reading(followed, direction(bearing)))
            .ok_or_else(|| self.refused(ProgressiveRunError::NoPin { body: body() }))?;
        let (history, peak) = self.until_failure(followed, bodies, &reading, solver)?;
        if peak.displacements.is_empty() {
            return Err(self.refused(match history.ending {
                Ending::NoEquilibrium {
                    step,
                    reached,
                    cause,
                    ..
                } => ProgressiveRunError::NothingBorne {
                    step,
                    percent: 100.0 * reached,
                    cause,
                },
                _ => ProgressiveRunError::WrongWay {
                    body: body(),
                    angle_deg: bearing.to_degrees(),
                },
            }));
        }
        let mut reported = self.reported(model, followed, &history, &reading.hole);
        reported.frame = frame;
        reported.free_travel = reading.gauge.free_travel;
        let linear = self.without_failure(followed, &reading, solver, peak.load)?;
        if let (Some((linear, displacements)), Some(mesh)) = (linear, self.mesh(followed)) {
            let points = edge::EdgePoints::new(mesh, &reading.hole);
            reported.edge = points.beside(&peak.displacements, &displacements);
            reported.linear = Some(linear);
        }
        Ok(reported)
    }

    fn joint(
        &self,
        model: &Model,
        bodies: Vec<JointBody>,
        reading: &Reading,
    ) -> Result<Joint, JointError> {
        Joint::new(bodies, model.pairs.clone(), reading.gauge)?
            .with_options(self.options(model.half))
    }

    /// The history of the joint of `bodies`, some of which fail.
    fn until_failure(
        &self,
        model: &Model,
        bodies: Vec<JointBody>,
        reading: &Reading,
        solver: &dyn InterfaceSolver,
    ) -> Result<(JointHistory, Peak), RunError> {
        let mut peak = Peak::default();
        let history = self.joint(model, bodies, reading).and_then(|joint| {
            joint.follow(model.history.steps(), solver, |record, state| {
                if record.load > peak.load {
                    let own = &state.bodies[self.found.body];
                    peak = Peak {
                        load: record.load,
                        displacements: own.displacements.clone(),
                    };
                }
            })
        });
        let history = history.map_err(|cause| self.refused(cause.into()))?;
        Ok((history, peak))
    }

    /// The joint whose plies do not fail, followed to the load `target` `[N]`, and the displacements of the body there.
    fn without_failure(
        &self,
        model: &Model,
        reading: &Reading,
        solver: &dyn InterfaceSolver,
        target: f64,
    ) -> Result<Option<(LinearJoint, Vec<f64>)>, RunError> {
        let bodies = self.bodies(model, false)?;
        let steps = model.history.steps();
        let (body, gauge) = (self.found.body, &reading.gauge);
        self.joint(model, bodies, reading)
            .and_then(|joint| edge::linear(&joint, gauge, body, steps, solver, target))
            .map_err(|cause| self.refused(cause.into()))
    }

    fn options(&self, half: bool) -> Options {
        let usual = Options::default();
        // What fails in a half fails twice in the whole.
        let burst = if half { usual.burst } else { 2 * usual.burst };
        let (increments, residual_load) = match self.asked.control {
            Control::Loads { increments } => (increments, usual.residual_load),
            Control::Displacement {
                increments, drop, ..
            } => (increments, 1.0 - drop),
        };
        Options {
            increments,
            residual_load,
            burst,
            ..usual
        }
    }

    /// The bodies; `fail` says whether the plies of the one asked about can.
    fn bodies(&self, model: &Model, fail: bool) -> Result<Vec<JointBody>, RunError> {
        let bodies = model.bodies.iter().enumerate();
        bodies
            .map(|(index, body)| match &body.kind {
                ModelBodyKind::Rigid(rigid) => Ok(JointBody::Rigid(rigid.clone())),
                ModelBodyKind::Elastic(elastic) if fail && index == self.found.body => self
                    .progressive(elastic, &body.interface)
                    .map(|body| JointBody::Progressive(Arc::new(body)))
                    .map_err(|cause| RunError::Progressive {
                        body: body.name.clone(),
                        cause: Box::new(cause),
                    }),
                ModelBodyKind::Elastic(elastic) => elastic
                    .condense(&body.interface)
                    .map(|condensed| JointBody::Elastic(Arc::new(condensed)))
                    .map_err(|cause| RunError::Body {
                        body: body.name.clone(),
                        cause,
                    }),
            })
            .collect()
    }

    fn progressive(
        &self,
        elastic: &Arc<ElasticBody>,
        interface: &[usize],
    ) -> Result<ProgressiveBody, ProgressiveRunError> {
        let laminate = &self.sheet.laminate;
        let model = &self.asked.model;
        let failing = model.parameters.degradation().zip(self.asked.crack_band);
        let models = if let Some((degradation, energies)) = failing {
            let band = crack_band(energies, degradation, elastic.mesh())?;
            let points = QuadraturePoints::of(elastic.mesh());
            let build = |scaled| Ok(model.point(scaled)?);
            band.models::<ProgressiveRunError>(&points, laminate, build)?
        } else {
            let point: Arc<dyn PointModel> = model.point(laminate.clone())?;
            vec![point; elastic.mesh().element_count()]
        };
        let body = ProgressiveBody::with_models(Arc::clone(elastic), interface, models)?;
        Ok(body.at_temperature(self.sheet.cure)?)
    }
}
