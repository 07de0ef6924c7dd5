//! Why a scene cannot be modelled.

use stickslip_contact::ContactError;
use stickslip_fem_core::body::BodyError;
use stickslip_fem_core::generate::GenerateError;
use stickslip_fem_core::material::MaterialError;
use stickslip_fem_core::mesh::{MeshError, Point};
use stickslip_scene::limits::TooLittleMemory;
use thiserror::Error;

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
        /// Number of nodes that the scene asks for `[1]`.
        nodes: f64,
        /// Memory of mesh, matrix and factor `[GB]`.
        gigabytes: f64,
        /// Limit on the number of nodes `[1]`.
        limit: f64,
    },
    /// A mesh for which there is too little memory.
    #[error(
        "body '{body}': the mesh would have about {nodes:.3e} nodes: {}{cause}",
        if *together { "with the other bodies " } else { "" }
    )]
    TooLittleMemory {
        /// The body.
        body: String,
        /// Number of nodes that the scene asks for `[1]`.
        nodes: f64,
        /// Whether there is enough for this mesh, and too little for those of all bodies.
        together: bool,
        /// The memory that it would take and the memory that there is.
        #[source]
        cause: TooLittleMemory,
    },
    /// Contacts that share bodies, with more points than there is memory for.
    #[error(
        "contact '{contact}' is one of {contacts} that share bodies, with {points} points together: {cause}"
    )]
    InterfaceTooLarge {
        /// Name of one of the contacts.
        contact: String,
        /// Number of contacts that are solved together.
        contacts: usize,
        /// Number of their points.
        points: usize,
        /// The memory that all contacts would take and the memory that there is.
        #[source]
        cause: TooLittleMemory,
    },
    /// A load history of more steps than there is memory for.
    #[error("the history has {steps} load steps: {cause}")]
    HistoryTooLong {
        /// Number of load steps.
        steps: usize,
        /// The memory that their results would take and the memory that there is.
        #[source]
        cause: TooLittleMemory,
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
    /// Two supports that move a node of a body by different displacements along the same direction.
    #[error("{} and {} share a node, and their supports, supports.{} and supports.{index}, move it by different displacements along the same direction", on[0], on[1], other)]
    Contradiction {
        /// The sets.
        on: [String; 2],
        /// Number of the first support in the scene.
        other: usize,
        /// Number of the second one.
        index: usize,
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

impl ModelError {
    /// The same of a scene that stands `by` farther `[mm]`.
    pub(super) fn moved(self, by: Point) -> Self {
        match self {
            Self::Generate { body, cause } => Self::Generate {
                body,
                cause: cause.placed(|[x, y]| [x + by[0], y + by[1]]),
            },
            other => other,
        }
    }
}
