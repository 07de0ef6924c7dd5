//! What a scene asks of a run beside the solution of its model, with its names resolved.

use std::sync::Arc;

use stickslip_fem_core::mesh::{Curve, Mesh, MeshError};
use stickslip_scene::Scene;
use stickslip_scene::schema::{
    Analysis, Axes, Axis, Control, DisplayUnits, Failure, FieldOutput, Hold, LaminateSheet,
    Progressive, SetRef, Support,
};

use super::load_table::LoadTable;
use super::plan::Plan;
use super::{Model, ModelBody, ModelBodyKind, ModelError, loads};
use crate::failure::Region;
use crate::results::ContactFrame;

/// What is to be reported, and how.
#[derive(Clone, Debug)]
pub struct Request {
    /// Title of the scene.
    pub title: String,
    /// Name of the scene's file.
    pub source: String,
    /// SHA-256 of the resolved scene.
    pub scene_hash: String,
    /// The scene as text, with all defaults filled in.
    pub scene: String,
    /// Whether the meshes of bodies are written for other programs.
    pub meshes: bool,
    /// Units to show results in.
    pub units: DisplayUnits,
    /// How the scene asks to be solved.
    pub analysis: Analysis,
    /// For which steps fields are computed.
    pub fields: FieldOutput,
    /// Values of the loads.
    pub loads: LoadTable,
    /// Failure of laminated bodies.
    pub failure: Option<FailureRequest>,
}

/// What is asked about the failure of laminates.
#[derive(Clone, Debug)]
pub struct FailureRequest {
    /// Criteria, distances and envelopes.
    pub settings: Failure,
    /// The bodies that are asked about, ascending.
    pub bodies: Vec<FailingBody>,
}

/// A laminated body whose failure is asked about.
#[derive(Clone, Debug)]
pub struct FailingBody {
    /// Index of the body.
    pub body: usize,
    /// Its laminate.
    pub sheet: Arc<LaminateSheet>,
    /// Coordinate that the halves of a half model differ in.
    pub across: usize,
    /// Its hole.
    pub(crate) hole: Option<Region>,
    /// Frame of the assumed bearing load on its hole; +x without one.
    pub frame: ContactFrame,
    /// How its failure is followed until the load path is lost.
    pub progressive: Option<FollowedJoint>,
}

/// A joint that is followed beyond the failure of its plies.
#[derive(Clone, Debug)]
pub struct FollowedJoint {
    /// What is asked.
    pub asked: Progressive,
    /// Whether the body itself is driven, and not what it is joined to.
    pub drives_body: bool,
    /// The model under the drive, which replaces the loads; `None` where these are raised.
    pub(crate) driven: Option<Arc<Model>>,
}

impl Request {
    pub(super) fn of(
        scene: &Scene,
        plan: &Plan<'_>,
        bodies: &[ModelBody],
        half: bool,
    ) -> Result<Self, ModelError> {
        let failure = scene.failure.as_ref();
        Ok(Self {
            title: scene.title.clone(),
            source: scene.source_name.clone(),
            scene_hash: scene.hash.clone(),
            scene: scene.resolved().to_owned(),
            meshes: scene.output.meshes,
            units: scene.display,
            analysis: scene.analysis,
            fields: scene.output.fields,
            loads: LoadTable::of_plan(plan, scene.display),
            failure: failure
                .map(|settings| FailureRequest::of(scene, plan, settings, bodies, half))
                .transpose()?,
        })
    }
}

impl FailureRequest {
    fn of(
        scene: &Scene,
        plan: &Plan<'_>,
        settings: &Failure,
        bodies: &[ModelBody],
        half: bool,
    ) -> Result<Self, ModelError> {
        let mut failing = Vec::new();
        for (index, body) in bodies.iter().enumerate() {
            let (planned, asked) = (&plan.bodies[index], settings.bodies.contains(&body.name));
            let sheet = planned.elastic.and_then(|own| own.material.laminate());
            let (ModelBodyKind::Elastic(elastic), Some(sheet), true) = (&body.kind, sheet, asked)
            else {
                continue;
            };
            let mesh_error = |cause| ModelError::Mesh {
                body: body.name.clone(),
                cause,
            };
            let mesh = elastic.mesh();
            let edge = planned.shape.only_hole().map(|edge| edge.name);
            let hole = (edge.as_deref()).map(|set| region(mesh, set)).transpose();
            let hole = hole.map_err(mesh_error)?.flatten();
            let frame = edge.map_or(ContactFrame::NONE, |set| {
                let (body, set) = (body.name.clone(), set.into_owned());
                loads::frame(plan, &SetRef { body, set }, half)
            });
            let progressive = settings.progressive.as_ref();
            if progressive.is_some() && plan.finds_gaps_deformed() {
                return Err(ModelError::Unsupported {
                    key: "analysis.kinematics".into(),
                    what: "progressive failure is followed with gaps on the undeformed geometry: say analysis.kinematics = \"small\", or leave \
                           failure.progressive out"
                        .into(),
                });
            }
            let own = progressive.filter(|asked| asked.body == body.name);
            failing.push(FailingBody {
                body: index,
                sheet: Arc::clone(sheet),
                across: planned.shape.mirror().unwrap_or(0),
                hole,
                frame,
                progressive: own
                    .map(|asked| FollowedJoint::of(scene, asked))
                    .transpose()?,
            });
        }
        Ok(Self {
            settings: settings.clone(),
            bodies: failing,
        })
    }
}

/// The circle that the edge `set` is part of; `None` where it is none.
fn region(mesh: &Mesh, set: &str) -> Result<Option<Region>, MeshError> {
    let curve = mesh.edge_set(set)?.curve;
    Ok(curve.and_then(|curve| match curve {
        Curve::Arc { centre, radius } => Some(Region { centre, radius }),
        Curve::Line => None,
    }))
}

impl FollowedJoint {
    fn of(scene: &Scene, asked: &Progressive) -> Result<Self, ModelError> {
        let (drives_body, driven) = match &asked.control {
            Control::Loads { .. } => (false, None),
            Control::Displacement { on, axis, end, .. } => {
                let mut driven = scene.clone();
                driven.loads.clear();
                driven.failure = None;
                drive(&mut driven, on, *axis, *end);
                (
                    on.body == asked.body,
                    Some(Arc::new(Model::build(&driven)?)),
                )
            }
        };
        Ok(Self {
            asked: asked.clone(),
            drives_body,
            driven,
        })
    }
}

/// Holds `on` along `axis` at the displacement `end`, instead of whatever held or loaded it there.
fn drive(scene: &mut Scene, on: &SetRef, axis: Axis, end: f64) {
    let along = Axes {
        x: axis == Axis::X,
        y: axis == Axis::Y,
    };
    let across = Axes {
        x: along.y,
        y: along.x,
    };
    let mut held_across = scene.platens.iter().any(|platen| platen.on == *on);
    scene.platens.retain(|platen| platen.on != *on);
    let mut kept = Vec::new();
    for support in scene.supports.drain(..) {
        if support.on != *on {
            kept.push(support);
        } else if let Hold::Axes(axes) = support.hold {
            held_across |= (axes.x && across.x) || (axes.y && across.y);
        }
    }
    scene.supports = kept;
    let numbers = scene.supports.iter().map(|support| support.index + 1);
    let next = numbers.max().unwrap_or(0);
    let mut hold = |axes, displacement| {
        scene.supports.push(Support {
            index: next,
            on: on.clone(),
            hold: Hold::Axes(axes),
            displacement,
        });
    };
    hold(along, end);
    if held_across {
        hold(across, 0.0);
    }
}
