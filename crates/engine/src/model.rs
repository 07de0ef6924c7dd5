//! From a checked scene to condensed bodies and one interface problem: the choices are made here, and said.

mod bearing;
mod body;
mod compliance;
mod contacts;
mod edge;
mod edge_loads;
mod error;
mod extent;
mod fasteners;
mod half_plane;
mod limits;
mod load_table;
mod loads;
mod meshes;
mod plan;
mod polar_table;
mod problem;
mod remarks;
mod request;
mod resultant;
mod room;
mod series;
mod sets;
mod singular;
mod springs;

use std::collections::BTreeMap;
use std::sync::Arc;

use stickslip_contact::{ContactError, ContactPair, DeformedGaps, Facing, Kinematics, LoadHistory};
use stickslip_fem_core::InterfaceOperator;
use stickslip_fem_core::material::Material;
use stickslip_fem_core::mesh::{Mesh, Point};
use stickslip_friction::Mirror;

use crate::results::{Choice, Finding, Problem};
use stickslip_scene::Scene;
use stickslip_scene::host::Host;
use stickslip_scene::placement;
use stickslip_scene::schema::KinematicsChoice;

pub use body::{ModelBody, ModelBodyKind};
pub use edge::{EdgeEnd, ModelEdge};
pub use error::ModelError;
pub use fasteners::ModelFastener;
pub use load_table::LoadTable;
pub use meshes::{BYTES_PER_NODE, NODE_LIMIT};
pub use request::{FailingBody, FailureRequest, FollowedJoint, Request};
pub(crate) use room::parts;

use meshes::Meshes;
use plan::Plan;
pub use plan::Seat;
pub use sets::{Mean, Measure, ModelSet};
pub use singular::{ReentrantCorner, Singular};

/// What is known of a contact beside its points.
#[derive(Clone, Copy, Debug)]
pub struct ModelContact {
    /// The line about which a half model mirrors the first body; `None` where the whole is modelled.
    pub mirror: Option<Mirror>,
    /// Difference of the radii of two circles `[mm]`; 0 for an interference and without circles.
    pub clearance: f64,
    /// Where the centre of the second of two circles starts, seen from that of the first `[mm]`.
    pub start: Point,
    /// Whether an initial overlap is meant.
    pub interference: bool,
}

/// A scene turned into bodies, pairs and a load history.
#[derive(Clone, Debug)]
pub struct Model {
    /// The machine that its scene was read on; its clock times the run.
    pub host: Host,
    /// Where the origin of all its coordinates lies in those of the scene `[mm]`: in the middle of bodies that may stand anywhere, so that rounding is relative
    /// to their size.
    pub origin: Point,
    /// Bodies in the order of their names.
    pub bodies: Vec<ModelBody>,
    /// Contact pairs.
    pub pairs: Vec<ContactPair>,
    /// The undeformed edges of each pair, where contact is found on the deformed geometry; otherwise empty.
    pub facings: Vec<Facing>,
    /// What else is known of each contact.
    pub contacts: Vec<ModelContact>,
    /// Fasteners in the order of their names.
    pub fasteners: Vec<ModelFastener>,
    /// Contact edges first, then further edges.
    pub edges: Vec<ModelEdge>,
    /// Sets that loads act on, and those that are held.
    pub sets: Vec<ModelSet>,
    /// What acts where, for whoever shows it.
    pub problem: Problem,
    /// Load multipliers per step.
    pub history: LoadHistory,
    /// Whether one half of a symmetric scene is modelled.
    pub half: bool,
    /// What was chosen.
    pub choices: Vec<Choice>,
    /// What the reader must know.
    pub findings: Vec<Finding>,
    /// What the scene asks of a run.
    pub request: Request,
}

impl Model {
    /// Builds the model of `scene`. Its names are resolved here; what follows knows indices.
    ///
    /// # Errors
    /// [`ModelError`]; nothing large is allocated before the size of the meshes is known.
    pub fn build(scene: &Scene) -> Result<Self, ModelError> {
        Self::build_on(scene, None, &[])
    }

    /// As [`build`](Self::build), with the bodies by series of `known` where their nodes are the same, whose scene differs in nothing else that they depend on. `seats` are those of
    /// contacts, of as many as are known.
    ///
    /// # Errors
    /// As [`build`](Self::build).
    pub fn build_on(
        scene: &Scene,
        known: Option<&Self>,
        seats: &[Option<Seat>],
    ) -> Result<Self, ModelError> {
        let (scene, origin) = &placement::centred(scene);
        let mut plan = Plan::of(scene);
        plan.seat(seats);
        limits::check(&plan)?;
        let mut choices = Vec::new();
        let half = extent::choose(&plan, &mut choices)?;
        series::choose(&mut plan, scene, known, half, &mut choices)?;
        let meshes = meshes::build(&plan, scene.limits(), half, &mut choices)
            .map_err(|why| why.moved(*origin))?;
        let materials = materials(scene)?;
        let mut contacts = contacts::build(&plan, scene.display, &meshes, half, &mut choices)?;
        for pair in &mut contacts.pairs {
            pair.origin = *origin;
        }
        let ends = contacts.interfaces.into_iter().zip(contacts.rigid_points);
        let body = |(index, (interface, points)): (usize, (Vec<usize>, Vec<Point>))| {
            let own = &plan.bodies[index];
            let across = own.shape.mirror().filter(|_| half);
            let axis = across.map(|coordinate| singular::Axis {
                coordinate,
                at: own.centre[coordinate],
            });
            let of_mesh = |cause| ModelError::Mesh {
                body: own.name.to_owned(),
                cause,
            };
            let (singular, sheared) = match meshes.get(&index) {
                Some(mesh) => (
                    singular::places(&plan, index, mesh, axis).map_err(of_mesh)?,
                    singular::sheared(&plan, index, mesh, axis).map_err(of_mesh)?,
                ),
                None => Default::default(),
            };
            Ok(ModelBody {
                name: own.name.to_owned(),
                across,
                seated: own.seat.as_ref().map_or(0.0, Seat::largest_shift),
                singular,
                sheared,
                corners: (meshes.get(&index))
                    .map_or_else(Vec::new, |mesh| singular::corners(&plan, index, mesh)),
                is_general: own.shape.is_general(),
                yield_stress: own.elastic.and_then(|own| own.material.yield_stress()),
                kind: loads::body(&plan, index, &meshes, &materials, half, &points)?,
                interface,
                ends: Vec::new(),
                series: own.series.clone(),
            })
        };
        let bodies = ends.enumerate().map(body);
        let mut bodies = bodies.collect::<Result<Vec<_>, ModelError>>()?;
        compliance::choose(scene, &mut bodies, contacts.ends, &mut choices)?;
        choices.push(kinematics(scene, &plan));
        let model = Self {
            host: scene.host(),
            origin: *origin,
            pairs: contacts.pairs,
            facings: contacts.facings,
            contacts: known_of_contacts(&plan, half),
            fasteners: fasteners::build(&plan),
            edges: contacts.edges,
            sets: sets::all(&plan, &bodies, half)?,
            problem: problem::of(&plan, &meshes),
            history: loads::history(&plan)?,
            half,
            choices,
            findings: remarks::of_scene(&plan),
            request: Request::of(scene, &plan, &bodies, half)?,
            bodies,
        };
        room::check(scene.limits(), &model)?;
        Ok(model)
    }

    /// On which geometry contact is found between its condensed bodies `operators`.
    ///
    /// # Errors
    /// As [`DeformedGaps::new`].
    pub fn kinematics<'a>(
        &'a self,
        operators: &[&'a dyn InterfaceOperator],
    ) -> Result<Kinematics<'a>, ContactError> {
        Ok(match self.request.analysis.kinematics {
            Some(KinematicsChoice::DeformedGaps) => {
                let gaps = DeformedGaps::new(operators, &self.pairs, &self.facings)?;
                Kinematics::DeformedGaps(gaps)
            }
            Some(KinematicsChoice::Small | KinematicsChoice::Auto) | None => Kinematics::Small,
        })
    }

    /// The same bodies and pairs with the friction laws, the load history and the request of `scene`, which differs from the model's own
    /// scene in nothing else that a model depends on.
    ///
    /// # Errors
    /// As [`Model::build`].
    pub fn with_laws_and_history(&self, scene: &Scene) -> Result<Self, ModelError> {
        let (scene, _) = &placement::centred(scene);
        let plan = Plan::of(scene);
        let mut model = self.clone();
        for (contact, pair) in scene.contacts.iter().zip(&mut model.pairs) {
            pair.law = Arc::from(contact.law.clone());
        }
        for edge in &mut model.edges {
            if let Some(contact) = edge.pair.and_then(|pair| scene.contacts.get(pair)) {
                contact.law.name().clone_into(&mut edge.geometry.law);
            }
        }
        model.history = loads::history(&plan)?;
        model.contacts = known_of_contacts(&plan, model.half);
        model.request = Request::of(scene, &plan, &model.bodies, model.half)?;
        Ok(model)
    }

    /// `mesh`, that of its body `name`, in the coordinates of the scene.
    ///
    /// # Errors
    /// [`ModelError::Mesh`] where rounding destroys a cell there.
    pub fn placed(&self, name: &str, mesh: &Arc<Mesh>) -> Result<Arc<Mesh>, ModelError> {
        if self.origin == [0.0; 2] {
            return Ok(Arc::clone(mesh));
        }
        let placed = Mesh::clone(mesh).translated(self.origin);
        placed.map(Arc::new).map_err(|cause| ModelError::Mesh {
            body: name.to_owned(),
            cause,
        })
    }

    /// Divides load step k into `substeps[k]` increments.
    ///
    /// # Errors
    /// [`ModelError`] where their number is not that of the steps, or one is zero.
    pub fn divide_history(&mut self, substeps: &[usize]) -> Result<(), ModelError> {
        let (steps, ramp) = (self.history.steps().to_vec(), self.history.ramp());
        self.history = LoadHistory::divided(steps, substeps.to_vec(), ramp)?;
        Ok(())
    }

    /// The coordinate in which the mirror halves differ of the body with the index `body`, whose failure is asked about.
    pub fn across(&self, body: usize) -> Option<usize> {
        let failing = &self.request.failure.as_ref()?.bodies;
        Some(failing.iter().find(|own| own.body == body)?.across)
    }

    /// The edge of the contact with the index `pair`, that of its first body.
    pub fn edge_of(&self, pair: usize) -> Option<&ModelEdge> {
        self.edges.iter().find(|edge| edge.pair == Some(pair))
    }

    /// Whether stresses of the body with the index `body` are asked about in every step: for its failure or for its yield.
    pub fn is_asked_for_stresses(&self, body: usize) -> bool {
        let failure = self.request.failure.as_ref();
        let fails =
            failure.is_some_and(|failure| failure.bodies.iter().any(|own| own.body == body));
        fails || self.bodies[body].yield_stress.is_some()
    }
}

/// What breaks the symmetry of `scene`, so that no half of it is modelled; `None` if nothing does.
pub fn obstacle_to_half(scene: &Scene) -> Option<String> {
    extent::obstacle(&Plan::of(scene))
}

fn known_of_contacts(plan: &Plan<'_>, half: bool) -> Vec<ModelContact> {
    let known = |contact: &plan::ContactPlan<'_>| ModelContact {
        mirror: half.then(|| extent::mirror(plan, contact)).flatten(),
        clearance: (contact.radii()).map_or(0.0, |[hole, inner]| (hole - inner).max(0.0)),
        start: contact.offset,
        interference: contact.of.interference,
    };
    plan.contacts.iter().map(known).collect()
}

fn kinematics(scene: &Scene, plan: &Plan<'_>) -> Choice {
    let (value, reason) = if plan.finds_gaps_deformed() {
        (
            "deformed gaps",
            "the scene says so; gaps, normals and closest points follow the displacement, bodies are linear, and tractions are forces per \
             undeformed area; resultants and balances take deformed normals and closest points at their undeformed places",
        )
    } else if plan.bodies.iter().any(|body| {
        body.series
            .as_ref()
            .is_some_and(|series| series.line_nodes().is_some())
    }) {
        (
            "small displacement",
            "half-planes touch on the undeformed geometry, as Hertz has it",
        )
    } else if scene.kinematics() == KinematicsChoice::Auto && !plan.contacts.is_empty() {
        (
            "small displacement",
            "contact is found on the undeformed geometry; a search for an accuracy compares the deformed one where the model has it, and takes it where it changes a \
             number by more than three tenths of the accuracy",
        )
    } else {
        (
            "small displacement",
            "contact is found on the undeformed geometry; on the deformed one (analysis.kinematics = \"deformed-gaps\") a conforming pin's \
             peak pressure differs by a few tenths of a percent",
        )
    };
    Choice {
        what: Choice::KINEMATICS.into(),
        value: value.into(),
        reason: reason.into(),
    }
}

fn materials(scene: &Scene) -> Result<BTreeMap<String, Arc<dyn Material>>, ModelError> {
    scene
        .materials
        .iter()
        .map(|(name, constants)| {
            let material =
                constants
                    .in_plane(scene.analysis.plane)
                    .map_err(|cause| ModelError::Material {
                        material: name.clone(),
                        cause,
                    })?;
            Ok((name.clone(), Arc::from(material)))
        })
        .collect()
}
