//! What a scene says of each body, contact and load: its names are resolved here, and become indices.

use std::collections::BTreeMap;
use std::sync::Arc;

use stickslip_fem_core::mesh::Point;
use stickslip_scene::schema::{
    self, Analysis, Contact, Division, Hold, KinematicsChoice, Load, LoadKind, MeshSettings,
    Platen, SetRef, Substance, Support,
};
use stickslip_scene::shape::{Edge, Shape};
use stickslip_scene::{Scene, placement};

use crate::series::SeriesBody;

/// A scene whose bodies and edges are known by index, bodies in the order of their names.
pub(super) struct Plan<'a> {
    pub(super) analysis: Analysis,
    /// Whether the scene gives a mesh, for all bodies or for one.
    pub(super) is_divided: bool,
    pub(super) bodies: Vec<BodyPlan<'a>>,
    pub(super) contacts: Vec<ContactPlan<'a>>,
    pub(super) supports: Vec<Placed<'a, Support>>,
    pub(super) platens: Vec<Placed<'a, Platen>>,
    pub(super) loads: Vec<Placed<'a, Load>>,
    /// Edges to report besides those in contact.
    pub(super) edges: Vec<Placed<'a, SetRef>>,
}

/// A body.
pub(super) struct BodyPlan<'a> {
    pub(super) name: &'a str,
    pub(super) shape: &'a Shape,
    /// What it is made of; `None` for a rigid body.
    pub(super) elastic: Option<Elastic<'a>>,
    pub(super) mesh: MeshSettings,
    /// Its operator where it is modelled by series.
    pub(super) series: Option<Arc<SeriesBody>>,
    /// Where its centre stands `[mm]`.
    pub(super) centre: Point,
}

/// What an elastic body is made of.
#[derive(Clone, Copy)]
pub(super) struct Elastic<'a> {
    /// Name of the material.
    pub(super) name: &'a str,
    pub(super) material: &'a schema::Material,
    /// Thickness `[mm]`.
    pub(super) thickness: f64,
}

/// Something that a scene puts on an edge, a point, or the whole of a body.
pub(super) struct Placed<'a, T> {
    /// Index of the body.
    pub(super) body: usize,
    /// The edge, if it is one.
    pub(super) edge: Option<Edge>,
    pub(super) of: &'a T,
}

/// Two edges that may touch.
pub(super) struct ContactPlan<'a> {
    pub(super) of: &'a Contact,
    pub(super) sides: [Placed<'a, SetRef>; 2],
}

impl<'a> Plan<'a> {
    /// Resolves the names of `scene`. It was checked: all of them refer to something in it.
    pub(super) fn of(scene: &'a Scene) -> Self {
        let numbers = scene.bodies.keys().map(String::as_str).zip(0..);
        let numbers: BTreeMap<&str, usize> = numbers.collect();
        let names = Names { scene, numbers };
        let contact = |of: &'a Contact| ContactPlan {
            of,
            sides: [&of.first, &of.second].map(|on| names.placed(on, on)),
        };
        let load = |of: &'a Load| match &of.kind {
            LoadKind::Force { on, .. }
            | LoadKind::Bearing { on, .. }
            | LoadKind::Pressure { on, .. }
            | LoadKind::PolarTraction { on, .. } => names.placed(on, of),
            LoadKind::Temperature { body, .. } => Placed {
                body: names.numbers[body.as_str()],
                edge: None,
                of,
            },
        };
        let (supports, platens) = (scene.supports.iter(), scene.platens.iter());
        Self {
            analysis: scene.analysis,
            is_divided: scene.is_divided_anywhere(),
            bodies: scene.bodies.keys().map(|name| names.body(name)).collect(),
            contacts: scene.contacts.iter().map(contact).collect(),
            supports: supports.map(|of| names.placed(&of.on, of)).collect(),
            platens: platens.map(|of| names.placed(&of.on, of)).collect(),
            loads: scene.loads.iter().map(load).collect(),
            edges: scene.edges.iter().map(|on| names.placed(on, on)).collect(),
        }
    }

    /// Whether contact is found on the deformed geometry.
    pub(super) fn finds_gaps_deformed(&self) -> bool {
        self.analysis.kinematics == Some(KinematicsChoice::DeformedGaps)
    }

    pub(super) fn is_rigid(&self, body: usize) -> bool {
        self.bodies[body].elastic.is_none()
    }

    /// The supports of a body.
    pub(super) fn supports_of(&self, body: usize) -> impl Iterator<Item = &'a Support> {
        on(&self.supports, body)
    }

    /// The platens of a body.
    pub(super) fn platens_of(&self, body: usize) -> impl Iterator<Item = &'a Platen> {
        on(&self.platens, body)
    }

    /// Unit vectors along which supports and platens hold the edge `on`.
    pub(super) fn held_along(&self, on: &SetRef) -> Vec<[f64; 2]> {
        let supports = self.supports.iter().map(|support| support.of);
        let holds = supports.filter(|support| support.on == *on);
        let mut held: Vec<[f64; 2]> = holds
            .flat_map(|support| support.hold.directions())
            .collect();
        if self.platens.iter().any(|platen| platen.of.on == *on) {
            held.extend([[1.0, 0.0], [0.0, 1.0]]);
        }
        held
    }

    /// Along which axes its supports leave a rigid body free.
    pub(super) fn free_axes(&self, body: usize) -> [bool; 2] {
        self.supports_of(body)
            .fold([true; 2], |[x, y], support| match support.hold {
                Hold::Axes(axes) => [x && !axes.x, y && !axes.y],
                Hold::Direction(_) => [false; 2],
            })
    }

    /// The indices of the two bodies of every contact.
    pub(super) fn pairs(&self) -> Vec<[usize; 2]> {
        let sides = self.contacts.iter().map(|contact| &contact.sides);
        sides.map(|[one, other]| [one.body, other.body]).collect()
    }
}

impl<T> Placed<'_, T> {
    /// Radius of the closed circle that it is on.
    pub(super) fn circle(&self) -> Option<f64> {
        self.edge?.circle()
    }
}

impl ContactPlan<'_> {
    /// Radii `[mm]` of the two circles of a round contact.
    pub(super) fn radii(&self) -> Option<[f64; 2]> {
        let [first, second] = &self.sides;
        Some([first.circle()?, second.circle()?])
    }
}

impl BodyPlan<'_> {
    /// Thickness `[mm]`; 1 for a rigid body.
    pub(super) fn thickness(&self) -> f64 {
        self.elastic.map_or(1.0, |elastic| elastic.thickness)
    }

    /// Material angle `[rad]`.
    pub(super) fn material_angle(&self) -> f64 {
        self.elastic.map_or(0.0, |elastic| elastic.material.angle())
    }

    /// Up to which angle `[rad]` or length `[mm]` along its contact edge its mesh is fine; `None` for all of it.
    pub(super) fn fine_to(&self) -> Option<f64> {
        match self.mesh.division {
            Division::Angular(grading) | Division::Linear(grading) => {
                self.shape.fine_to(grading.fine_to)
            }
            Division::AngleList(_) => None,
        }
    }
}

fn on<'a, T>(all: &[Placed<'a, T>], body: usize) -> impl Iterator<Item = &'a T> {
    let own = all.iter().filter(move |placed| placed.body == body);
    own.map(|placed| placed.of)
}

/// The names of a scene.
struct Names<'a> {
    scene: &'a Scene,
    /// The index of each body.
    numbers: BTreeMap<&'a str, usize>,
}

impl<'a> Names<'a> {
    fn placed<T>(&self, on: &SetRef, of: &'a T) -> Placed<'a, T> {
        Placed {
            body: self.numbers[on.body.as_str()],
            edge: self.scene.bodies[&on.body].shape.edge(&on.set),
            of,
        }
    }

    fn body(&self, name: &'a str) -> BodyPlan<'a> {
        let body = &self.scene.bodies[name];
        let elastic = match &body.substance {
            Substance::Elastic {
                material,
                thickness,
            } => Some(Elastic {
                name: material,
                material: &self.scene.materials[material],
                thickness: *thickness,
            }),
            Substance::Rigid => None,
        };
        BodyPlan {
            name,
            shape: &body.shape,
            elastic,
            mesh: self.scene.mesh_of(name).clone(),
            series: None,
            centre: placement::centre(self.scene, name),
        }
    }
}
