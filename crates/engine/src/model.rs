//! From a checked scene to condensed bodies and one interface problem: the choices are made here, and said.

mod bearing;
mod contacts;
mod extent;
mod limits;
mod loads;
mod meshes;
mod polar_table;
mod remarks;
mod resultant;
mod room;

use std::collections::BTreeMap;
use std::sync::Arc;

use stickslip_contact::{ContactError, ContactPair, LoadHistory};
use stickslip_fem_core::body::BodyError;
use stickslip_fem_core::generate::GenerateError;
use stickslip_fem_core::material::{Material, MaterialError};
use stickslip_fem_core::mesh::{Mesh, MeshError};
use stickslip_fem_core::{ElasticBody, RigidBody};
use thiserror::Error;

use crate::results::{Choice, EdgeGeometry, Finding};
use stickslip_scene::Scene;
use stickslip_scene::host::Host;

pub use extent::{mirror, obstacle as obstacle_to_half};
pub(crate) use loads::frame as frame_of_loads;
pub use meshes::BYTES_PER_NODE;
pub use meshes::NODE_LIMIT;
pub(crate) use remarks::beyond_fine_zone;
pub(crate) use room::parts;

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
    #[error("body '{body}': the mesh would have about {nodes:.3e} nodes: {words}")]
    TooLittleMemory {
        /// The body.
        body: String,
        /// Nodes that the scene asks for.
        nodes: f64,
        /// The memory that it would take and the memory that there is, as text.
        words: String,
    },
    /// Contacts that share bodies, with more points than there is memory for.
    #[error(
        "contact '{contact}' is one of {contacts} that share bodies, with {points} points together: {words}"
    )]
    InterfaceTooLarge {
        /// Name of one of the contacts.
        contact: String,
        /// Number of contacts that are solved together.
        contacts: usize,
        /// Number of their points.
        points: usize,
        /// The memory that all contacts would take and the memory that there is, as text.
        words: String,
    },
    /// A load history of more steps than there is memory for.
    #[error("the history has {steps} load steps: {words}")]
    HistoryTooLong {
        /// Number of load steps.
        steps: usize,
        /// The memory that their results would take and the memory that there is, as text.
        words: String,
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
    /// Index of the body whose stresses are reported.
    pub body: usize,
    /// Mesh nodes along the edge, by ascending parameter.
    pub nodes: Vec<usize>,
    /// Position of each node among the body's contact points; empty for an edge without contact.
    pub local: Vec<usize>,
    /// Contact area of each node `[mm²]`.
    pub areas: Vec<f64>,
    /// Polynomial order of the edge.
    pub order: usize,
    /// Unit normal per node: e_r, or e_n of a line.
    pub normals: Vec<[f64; 2]>,
    /// Index of the contact pair.
    pub pair: Option<usize>,
    /// Tractions of the loads on an edge without contact: load case, and (σ_nn, τ_nt) per node for a multiplier of one.
    pub tractions: Vec<(usize, Vec<[f64; 2]>)>,
}

/// A scene turned into bodies, pairs and a load history.
#[derive(Clone, Debug)]
pub struct Model {
    /// The machine that its scene was read on; its clock times the run.
    pub host: Host,
    /// Bodies in the order of their names.
    pub bodies: Vec<ModelBody>,
    /// Contact pairs.
    pub pairs: Vec<ContactPair>,
    /// Contact edges first, then further edges.
    pub edges: Vec<ModelEdge>,
    /// Load multipliers per step.
    pub history: LoadHistory,
    /// Whether one half of a symmetric scene is modelled.
    pub half: bool,
    /// What was chosen.
    pub choices: Vec<Choice>,
    /// What the reader must know.
    pub findings: Vec<Finding>,
}

impl Model {
    /// Builds the model of `scene`.
    ///
    /// # Errors
    /// [`ModelError`]; nothing large is allocated before the size of the meshes is known.
    pub fn build(scene: &Scene) -> Result<Self, ModelError> {
        limits::check(scene)?;
        let mut choices = Vec::new();
        let half = extent::choose(scene, &mut choices)?;
        let meshes = meshes::build(scene, half, &mut choices)?;
        let materials = materials(scene)?;
        let names: Vec<String> = scene.bodies.keys().cloned().collect();
        let contacts = contacts::build(scene, &meshes, &names, half, &mut choices)?;
        let mut bodies = Vec::with_capacity(names.len());
        for (index, name) in names.iter().enumerate() {
            let kind = loads::body(
                scene,
                name,
                &meshes,
                &materials,
                half,
                &contacts.rigid_points[index],
            )?;
            bodies.push(ModelBody {
                name: name.clone(),
                kind,
                interface: contacts.interfaces[index].clone(),
            });
        }
        choices.push(Choice {
            what: "kinematics".into(),
            value: "small displacement".into(),
            reason: "contact is found on the undeformed geometry; on the deformed one a conforming pin's peak pressure differs by \
                     a few tenths of a percent"
                .into(),
        });
        let model = Self {
            host: scene.host(),
            bodies,
            pairs: contacts.pairs,
            edges: contacts.edges,
            history: loads::history(scene)?,
            half,
            choices,
            findings: remarks::of_scene(scene),
        };
        room::check(scene, &model)?;
        Ok(model)
    }
}

impl Model {
    /// The same bodies and pairs with the friction laws and the load history of `scene`, which differs from the model's own scene in
    /// nothing else that a model depends on.
    ///
    /// # Errors
    /// As [`Model::build`].
    pub fn with_laws_and_history(&self, scene: &Scene) -> Result<Self, ModelError> {
        let mut model = self.clone();
        for (contact, pair) in scene.contacts.iter().zip(&mut model.pairs) {
            pair.law = Arc::from(contact.law.clone());
        }
        for edge in &mut model.edges {
            if let Some(contact) = edge.pair.and_then(|pair| scene.contacts.get(pair)) {
                contact.law.name().clone_into(&mut edge.geometry.law);
            }
        }
        model.history = loads::history(scene)?;
        Ok(model)
    }
}

/// Each body's mesh by name; rigid bodies have none.
type Meshes = BTreeMap<String, Arc<Mesh>>;

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
