//! From a checked scene to condensed bodies and one interface problem: the choices are made here, and said.

mod bearing;
mod compliance;
mod contacts;
mod extent;
mod fasteners;
mod half_plane;
mod limits;
mod load_table;
mod loads;
mod meshes;
mod plan;
mod polar_table;
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
use stickslip_fem_core::body::BodyError;
use stickslip_fem_core::generate::GenerateError;
use stickslip_fem_core::material::{Material, MaterialError};
use stickslip_fem_core::mesh::{Mesh, MeshError, Point};
use stickslip_fem_core::{CondensedBody, ElasticBody, InterfaceOperator, RigidBody};
use stickslip_friction::Mirror;
use thiserror::Error;

use crate::results::{Choice, EdgeGeometry, EdgeRow, Finding};
use crate::series::SeriesBody;
use stickslip_scene::Scene;
use stickslip_scene::host::Host;
use stickslip_scene::placement;
use stickslip_scene::schema::KinematicsChoice;

pub use fasteners::ModelFastener;
pub use load_table::LoadTable;
pub use meshes::{BYTES_PER_NODE, NODE_LIMIT};
pub use request::{FailingBody, FailureRequest, FollowedJoint, Request};
pub(crate) use room::parts;

use plan::Plan;
pub use plan::Seat;
pub use sets::{Measure, ModelSet};
pub use singular::Singular;

/// Why a scene that reads well cannot be modelled.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum ModelError {
    /// More nodes than a machine should be asked for.
    #[error(
        "the mesh would have about {nodes:.3e} nodes and need about {gigabytes:.1} GB; the limit is {limit:.0e} nodes"
    )]
    TooManyNodes {
        /// The body.
        body: String,
        /// Nodes that the scene asks for.
        nodes: f64,
        /// Memory of mesh, matrix and factor `[GB]`.
        gigabytes: f64,
        /// Limit on the number of nodes.
        limit: f64,
    },
    /// A mesh for which there is too little memory.
    #[error("body '{body}': the mesh would have about {nodes:.3e} nodes: {message}")]
    TooLittleMemory {
        /// The body.
        body: String,
        /// Nodes that the scene asks for.
        nodes: f64,
        /// The memory that it would take and the memory that there is, as text.
        message: String,
    },
    /// Contacts that share bodies, with more points than there is memory for.
    #[error(
        "contact '{contact}' is one of {contacts} that share bodies, with {points} points together: {message}"
    )]
    InterfaceTooLarge {
        /// Name of one of the contacts.
        contact: String,
        /// Number of contacts that are solved together.
        contacts: usize,
        /// Number of their points.
        points: usize,
        /// The memory that all contacts would take and the memory that there is, as text.
        message: String,
    },
    /// A load history of more steps than there is memory for.
    #[error("the history has {steps} load steps: {message}")]
    HistoryTooLong {
        /// Number of load steps.
        steps: usize,
        /// The memory that their results would take and the memory that there is, as text.
        message: String,
    },
    /// A mesh generator refused.
    #[error("body '{body}': {cause}")]
    Generate {
        /// The body.
        body: String,
        /// Its reason.
        #[source]
        cause: GenerateError,
    },
    /// A mesh has no such set, or an edge that is not one chain.
    #[error("body '{body}': {cause}")]
    Mesh {
        /// The body.
        body: String,
        /// Its reason.
        #[source]
        cause: MeshError,
    },
    /// Elastic constants that no stable material has.
    #[error("material '{material}': {cause}")]
    Material {
        /// The material.
        material: String,
        /// Its reason.
        #[source]
        cause: MaterialError,
    },
    /// A body cannot be condensed.
    #[error("body '{body}': {cause}")]
    Body {
        /// The body.
        body: String,
        /// Its reason.
        #[source]
        cause: BodyError,
    },
    /// The contact problem cannot be made.
    #[error(transparent)]
    Contact(#[from] ContactError),
    /// Shapes that cannot touch each other here.
    #[error("contact '{contact}': {what}")]
    Pairing {
        /// The contact.
        contact: String,
        /// What does not fit, and what does.
        what: String,
    },
    /// Edges that cannot be tied the way the scene says.
    #[error("contact '{contact}': {what}")]
    Projection {
        /// The contact.
        contact: String,
        /// Why they cannot.
        what: String,
    },
    /// `model = "series"` or `"half-plane"` for a body that has no such closed form.
    #[error(
        "body '{body}' cannot be modelled {model}: it {why}; say model = \"elements\" or \"auto\", and give a mesh"
    )]
    NotSeries {
        /// The body.
        body: String,
        /// How it was to be modelled.
        model: &'static str,
        /// Why, as the end of a sentence about the body.
        why: String,
    },
    /// `model = "half"` where the scene has no such symmetry.
    #[error("model = \"half\" asks for symmetry, but {0}; say model = \"whole\" or \"auto\"")]
    NotSymmetric(String),
    /// Something that scenes can say and this model cannot do.
    #[error("{what}")]
    Unsupported {
        /// Key of the scene.
        key: String,
        /// What is refused, and what can be done instead.
        what: String,
    },
    /// Something that a shape needs in the mesh settings.
    #[error("mesh: {what}")]
    MeshSettings {
        /// The body.
        body: String,
        /// What it needs.
        what: String,
    },
}

/// A body ready to be condensed.
#[derive(Clone, Debug)]
pub struct ModelBody {
    /// Name in the scene.
    pub name: String,
    /// What it is.
    pub kind: ModelBodyKind,
    /// Mesh nodes of its contact points, in the order that pairs refer to; empty for rigid bodies.
    pub interface: Vec<usize>,
    /// Ends of its edges among these where its compliance has a block for each; empty where it is one matrix.
    pub ends: Vec<usize>,
    /// Coordinate that the two halves differ in, where one of them is modelled.
    pub across: Option<usize>,
    /// Where its stresses have no bound.
    pub singular: Vec<Singular>,
    /// Von Mises stress at which its material yields `[MPa]`, where the scene gives one.
    pub yield_stress: Option<f64>,
    /// Its operator where it is a series, ready; its mesh is then the places where fields are shown.
    pub series: Option<Arc<SeriesBody>>,
}

impl ModelBody {
    /// The body, its mesh, loads and materials; `None` for a rigid one.
    pub fn elastic(&self) -> Option<&Arc<ElasticBody>> {
        match &self.kind {
            ModelBodyKind::Elastic(body) => Some(body),
            ModelBodyKind::Rigid(_) => None,
        }
    }

    /// Condenses `elastic`, this body or one with its geometry, to the contact points.
    ///
    /// # Errors
    /// As [`ElasticBody::condense`].
    pub fn condense(&self, elastic: &Arc<ElasticBody>) -> Result<CondensedBody, BodyError> {
        if self.ends.is_empty() {
            elastic.condense(&self.interface)
        } else {
            elastic.condense_edges(&self.interface, &self.ends)
        }
    }
}

/// An elastic or a rigid body.
#[derive(Clone, Debug)]
pub enum ModelBodyKind {
    /// To be condensed.
    Elastic(Arc<ElasticBody>),
    /// Ready.
    Rigid(RigidBody),
}

/// An edge to report, with what its stresses need.
#[derive(Clone, Debug)]
pub struct ModelEdge {
    /// What does not change from step to step.
    pub geometry: EdgeGeometry,
    /// Mesh nodes along the edge, by ascending parameter.
    pub nodes: Vec<usize>,
    /// Position of each node among the body's contact points; empty for an edge without contact.
    pub local: Vec<usize>,
    /// Contact area of each node `[mm²]`.
    pub areas: Vec<f64>,
    /// Polynomial order of the edge.
    pub order: usize,
    /// Arc length per node along e_t, the normal turned by +90° `[mm]`.
    pub along: Vec<f64>,
    /// Unit normal per node: e_r on a circle, otherwise that of the edge with a part along +y.
    pub normals: Vec<[f64; 2]>,
    /// Tractions (σ_nn, τ_nt) per node of a unit reaction there along x and along y `[1/mm²]`; empty where nothing holds it.
    pub reactions: Vec<[[f64; 2]; 2]>,
    /// Index of the contact pair.
    pub pair: Option<usize>,
    /// Up to where from the bearing point θ = 0 or x = 0 the mesh along it is fine `[rad or mm]`; `None` for all of it.
    pub fine_to: Option<f64>,
    /// What lies at its first and its last node, if it touches another open edge.
    pub ends: [EdgeEnd; 2],
    /// Tractions of the loads on it: load case, and (σ_nn, τ_nt) per node for a multiplier of one.
    pub tractions: Vec<(usize, Vec<[f64; 2]>)>,
}

impl ModelEdge {
    /// Whether a corner of one of the bodies presses on the other by the `rows` of its nodes, at the first end and at the last: within a cell of it, where the other body's edge
    /// ends.
    pub fn corners_that_press(&self, rows: &[EdgeRow]) -> [bool; 2] {
        let touches = |row: &EdgeRow| row.status.touches();
        let first = rows.iter().take(self.order + 1).any(touches);
        let last = rows.iter().rev().take(self.order + 1).any(touches);
        let is_corner = self.ends.map(|end| end == EdgeEnd::Corner);
        [is_corner[0] && first, is_corner[1] && last]
    }

    /// Whether it belongs to the body with the index `body` and something holds it.
    pub fn is_held_on(&self, body: usize) -> bool {
        self.geometry.body == body && !self.reactions.is_empty()
    }
}

/// What lies at an end of a contact.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum EdgeEnd {
    /// Nothing that a reader must know: both bodies end there, or the edge is closed.
    #[default]
    Free,
    /// A body ends there in a corner, and the other goes on.
    Corner,
    /// Both bodies go on, and their edges cease to face each other.
    GoesOn,
}

/// What is known of a contact beside its points.
#[derive(Clone, Copy, Debug)]
pub struct ModelContact {
    /// The line about which a half model mirrors the first body; `None` where the whole is modelled.
    pub mirror: Option<Mirror>,
    /// Difference of the radii of two circles `[mm]`; 0 for an interference and without circles.
    pub clearance: f64,
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
        let meshes = meshes::build(&plan, scene.limits(), half, &mut choices)?;
        let materials = materials(scene)?;
        let mut contacts = contacts::build(&plan, scene.display, &meshes, half, &mut choices)?;
        for pair in &mut contacts.pairs {
            pair.origin = *origin;
        }
        let ends = contacts.interfaces.into_iter().zip(contacts.rigid_points);
        let body = |(index, (interface, points)): (usize, (Vec<usize>, Vec<Point>))| {
            let own = &plan.bodies[index];
            let singular = match meshes.get(&index) {
                Some(mesh) => singular::places(&plan, index, mesh).map_err(|cause| {
                    let body = own.name.to_owned();
                    ModelError::Mesh { body, cause }
                })?,
                None => Vec::new(),
            };
            Ok(ModelBody {
                name: own.name.to_owned(),
                across: own.shape.mirror().filter(|_| half),
                singular,
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
        choices.push(kinematics(&plan));
        let model = Self {
            host: scene.host(),
            origin: *origin,
            pairs: contacts.pairs,
            facings: contacts.facings,
            contacts: known_of_contacts(&plan, half),
            fasteners: fasteners::build(&plan),
            edges: contacts.edges,
            sets: sets::all(&plan, &bodies, half)?,
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
        interference: contact.of.interference,
    };
    plan.contacts.iter().map(known).collect()
}

fn kinematics(plan: &Plan<'_>) -> Choice {
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
    } else {
        (
            "small displacement",
            "contact is found on the undeformed geometry; on the deformed one (analysis.kinematics = \"deformed-gaps\") a conforming pin's \
             peak pressure differs by a few tenths of a percent",
        )
    };
    Choice {
        what: "kinematics".into(),
        value: value.into(),
        reason: reason.into(),
    }
}

/// Each elastic body's mesh by the index of the body.
type Meshes = BTreeMap<usize, Arc<Mesh>>;

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
