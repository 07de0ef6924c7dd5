//! A joint followed beyond the failure of its plies: the scene's model with a history at every point of one body.
//!
//! Under displacement control the scene's loads are left out, and the driven edge or point is held along the driven axis at a
//! displacement that grows. The load is the force of the pin on the plate along the direction in which the pin bears under the scene's
//! own loads, or without any against the drive; the displacement is that of the pin's centre against the far end of the plate, counted
//! from where a pin with clearance can bear.

mod description;
mod edge;
mod findings;

use std::f64::consts::{FRAC_PI_2, PI};
use std::sync::Arc;

use stickslip_contact::{ContactPair, InterfaceSolver};
use stickslip_fem_core::mesh::{Mesh, Point};
use stickslip_fem_core::{ElasticBody, QuadraturePoints};
use stickslip_joint::{
    CrackBand, CrackBandError, Ending, FractureEnergies, Gauge, Hole, Joint, JointBody, JointError,
    JointHistory, Mark, Options, PlyEventKind, ProgressiveBody, Pull,
};
use stickslip_laminate::Degradation;
use stickslip_laminate::progressive::PointModel;

use super::error::{ProgressiveRunError, RunError};
use crate::model::{FollowedJoint, Model, ModelBodyKind};
use crate::results::{
    BearingSource, BodyFailure, ContactFrame, CurvePoint, LinearJoint, PlyLoss, ProgressiveEnd,
    ProgressiveFailure,
};
use stickslip_scene::schema::{Axis, Control, LaminateSheet, Progressive};

/// A body whose failure is followed.
pub(super) struct Subject<'a> {
    sheet: &'a LaminateSheet,
    followed: &'a FollowedJoint,
    asked: &'a Progressive,
    found: &'a BodyFailure,
}

/// Where the joint is read.
struct Reading {
    gauge: Gauge,
    hole: Hole,
}

/// The largest load on the way `[N]`, and the displacements of the body under it.
#[derive(Default)]
struct Peak {
    load: f64,
    displacements: Vec<f64>,
}

impl<'a> Subject<'a> {
    pub(super) fn new(
        sheet: &'a LaminateSheet,
        followed: &'a FollowedJoint,
        found: &'a BodyFailure,
    ) -> Self {
        Self {
            sheet,
            followed,
            asked: &followed.asked,
            found,
        }
    }

    /// Follows the joint whose model under the scene's own loads is `model`.
    pub(super) fn follow(
        &self,
        model: &Model,
        solver: &dyn InterfaceSolver,
    ) -> Result<ProgressiveFailure, RunError> {
        let driven = self.followed.driven()?;
        let followed = driven.as_ref().unwrap_or(model);
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

    fn refused(&self, cause: ProgressiveRunError) -> RunError {
        RunError::Progressive {
            body: self.asked.body.clone(),
            cause: Box::new(cause),
        }
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

    /// Where the pin bears under the scene's loads, or without any against the drive; `None` if neither says.
    fn frame(&self, half: bool) -> Option<ContactFrame> {
        if self.found.frame.bearing.is_some() {
            let frame = self.found.frame;
            let behind = frame.bearing.is_some_and(|at| at.abs() > FRAC_PI_2);
            return Some(ContactFrame {
                clockwise: half && behind,
                ..frame
            });
        }
        let Control::Displacement { axis, end, .. } = &self.asked.control else {
            return None;
        };
        let own = if self.followed.drives_body { -1.0 } else { 1.0 };
        let towards = own * end.signum();
        let bearing = match (axis, towards > 0.0) {
            (Axis::X, true) => 0.0,
            (Axis::X, false) => PI,
            (Axis::Y, _) => towards * FRAC_PI_2,
        };
        Some(ContactFrame {
            bearing: Some(bearing),
            found: BearingSource::Load,
            clockwise: half && bearing == PI,
        })
    }

    /// What is read along `direction`, in which the pin bears; `None` if no pin touches the hole.
    fn reading(&self, model: &Model, direction: [f64; 2]) -> Option<Reading> {
        let centre = self.found.centre?;
        let own = self.found.body;
        let mesh = self.mesh(model)?;
        let touches = |pair: &ContactPair| pair.first == own || pair.second == own;
        let pair = (model.edges.iter())
            .filter(|edge| edge.geometry.body == own)
            .find_map(|edge| edge.pair)
            .or_else(|| model.pairs.iter().position(touches))?;
        let ContactPair { first, second, .. } = model.pairs[pair];
        let (pin, onto_own) = if first == own {
            (second, direction)
        } else {
            (first, direction.map(|component| -component))
        };
        let nodes = mesh.nodes();
        let arm = |node: &Point| [node[0] - centre[0], node[1] - centre[1]];
        let distance = |node: &Point| arm(node)[0].hypot(arm(node)[1]);
        let [x, y] = direction;
        let ahead = |node: &Point| arm(node)[0] * x + arm(node)[1] * y;
        let aside = |node: &Point| arm(node)[1] * x - arm(node)[0] * y;
        let largest = |value: &dyn Fn(&Point) -> f64| nodes.iter().map(value).fold(0.0, f64::max);
        let far = largest(&|node| -ahead(node));
        let sides = [1.0, -1.0].map(|sign| largest(&|node| sign * aside(node)));
        // A half has one side.
        let side_distance = if model.half {
            sides[0].max(sides[1])
        } else {
            sides[0].min(sides[1])
        };
        Some(Reading {
            gauge: Gauge {
                pull: Pull::Contact {
                    pair,
                    direction: onto_own,
                },
                multiple: if model.half { 2.0 } else { 1.0 },
                direction,
                first: pin_mark(model, pin, centre),
                second: Mark::Node {
                    body: own,
                    node: nearest(mesh, [centre[0] - far * x, centre[1] - far * y]),
                },
                // From where it starts, the pin travels c (1 − cos θ_b) to where a clearance c lets it touch.
                free_travel: model.contacts[pair].clearance * (1.0 - direction[0]),
            },
            hole: Hole {
                centre,
                radius: nodes.iter().map(distance).fold(f64::INFINITY, f64::min),
                bearing: direction,
                side_distance,
                end_distance: largest(&ahead),
            },
        })
    }

    /// What is reported of the joint that was followed on `followed`, instead of the scene's own `model`.
    fn reported(
        &self,
        model: &Model,
        followed: &Model,
        history: &JointHistory,
        hole: &Hole,
    ) -> ProgressiveFailure {
        // Energies are those of the modelled part.
        let both = if followed.half { 2.0 } else { 1.0 };
        let curve = history.records.iter().map(|record| CurvePoint {
            step: record.step,
            reached: record.reached,
            displacement: record.displacement,
            load: record.load,
            work: both * record.energy.external,
            dissipated: both * (record.energy.dissipated + record.energy.released),
        });
        let cells = self.mesh(followed).map_or(0, Mesh::element_count);
        ProgressiveFailure {
            model: description::model(self, &model.request),
            control: description::control(self, &model.request),
            curve: curve.collect(),
            peak: history.peak(),
            strength: history.strength(),
            end: match &history.ending {
                Ending::Completed => ProgressiveEnd::Completed,
                Ending::LoadDropped { .. } => ProgressiveEnd::Dropped,
                Ending::Severed { .. } => ProgressiveEnd::Severed,
                Ending::NoEquilibrium { cause, .. } => {
                    ProgressiveEnd::NoEquilibrium(cause.to_string())
                }
            },
            losses: self.losses(history),
            mode: history.mode(self.found.body, hole),
            linear: None,
            edge: Vec::new(),
            cells,
            half: followed.half,
            frame: ContactFrame::NONE,
            free_travel: 0.0,
            findings: findings::of(self, model, followed, &history.records),
        }
    }

    fn mesh<'m>(&self, model: &'m Model) -> Option<&'m Mesh> {
        match &model.bodies[self.found.body].kind {
            ModelBodyKind::Elastic(body) => Some(body.mesh()),
            ModelBodyKind::Rigid(_) => None,
        }
    }

    fn losses(&self, history: &JointHistory) -> Vec<PlyLoss> {
        let group = |layer: usize| {
            let mut groups = self.found.plies.iter();
            // Every layer belongs to one group.
            groups
                .position(|group| group.layers.contains(&layer))
                .unwrap_or(0)
        };
        let records = history.records.iter().enumerate();
        let events = records.flat_map(|(increment, record)| {
            let own = record.events.iter();
            own.filter(|event| event.body == self.found.body)
                .map(move |event| (increment, event))
        });
        events
            .map(|(increment, event)| PlyLoss {
                increment,
                ply: group(event.layer),
                layer: event.layer,
                mode: match event.kind {
                    PlyEventKind::Failure(mode) => Some(mode),
                    PlyEventKind::Yield => None,
                },
                position: event.position,
                cell: event.cell,
                load: event.load,
                displacement: event.displacement,
            })
            .collect()
    }
}

/// Bands on `mesh`: rows of points of quadratic quadrilaterals are half a cell wide.
fn crack_band(
    energies: FractureEnergies,
    degradation: Degradation,
    mesh: &Mesh,
) -> Result<CrackBand, CrackBandError> {
    let order = mesh.blocks().iter().map(|block| block.kind.order()).max();
    CrackBand::new(energies, degradation)?.with_width(1.0 / order.unwrap_or(1) as f64)
}

/// Unit vector at the angle `bearing` `[rad]`, exact along the axes.
fn direction(bearing: f64) -> [f64; 2] {
    let exact = |part: f64| if part.abs() < 1e-15 { 0.0 } else { part };
    [exact(bearing.cos()), exact(bearing.sin())]
}

fn nearest(mesh: &Mesh, place: Point) -> usize {
    let distance = |node: &Point| (node[0] - place[0]).hypot(node[1] - place[1]);
    let nodes = mesh.nodes().iter().enumerate();
    nodes
        .min_by(|a, b| distance(a.1).total_cmp(&distance(b.1)))
        .map_or(0, |(node, _)| node)
}

/// The pin's centre.
fn pin_mark(model: &Model, pin: usize, centre: Point) -> Mark {
    match &model.bodies[pin].kind {
        ModelBodyKind::Elastic(body) => Mark::Node {
            body: pin,
            node: nearest(body.mesh(), centre),
        },
        // A rigid body does not turn, so any of its points moves as its centre does.
        ModelBodyKind::Rigid(_) => Mark::Node { body: pin, node: 0 },
    }
}
