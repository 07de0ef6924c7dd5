//! What was measured: the specimen, its hole, and how synthetic pictures of it are taken.

use std::sync::Arc;

use stickslip_fem_core::material::PlaneState;
use stickslip_fem_core::mesh::Point;
use stickslip_hybrid::fringe;

use stickslip_scene::Scene;
use stickslip_scene::schema::{Material, SetRef};

/// What was measured.
#[derive(Clone, Debug)]
pub struct Specimen {
    /// Its material.
    pub material: Material,
    /// Plane stress or plane strain.
    pub plane: PlaneState,
    /// Thickness `[mm]`.
    pub thickness: f64,
    /// Its hole.
    pub hole: Hole,
    /// The scene that it is a body of, if it was given so: what synthetic pictures are taken of.
    pub scene: Option<SpecimenScene>,
    /// The same scene as laws are fitted with and the whole plate is analysed by; it may have overrides of its own.
    pub model: Option<SpecimenScene>,
}

impl Specimen {
    /// Whether the model that is fitted has the very mesh of the scene, so that errors of discretisation cancel in synthetic data.
    pub fn shares_its_mesh(&self) -> bool {
        match (&self.scene, &self.model) {
            (Some(scene), Some(model)) => scene.scene.mesh == model.scene.mesh,
            _ => false,
        }
    }
}

/// A circular hole.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hole {
    /// Its centre `[mm]`.
    pub centre: Point,
    /// Its radius `[mm]`.
    pub radius: f64,
}

impl Hole {
    /// Distance `[mm]` of `place` `[mm]` from the centre.
    pub fn from_centre(&self, [x, y]: Point) -> f64 {
        (x - self.centre[0]).hypot(y - self.centre[1])
    }
}

/// The scene of a specimen.
#[derive(Clone, Debug)]
pub struct SpecimenScene {
    /// The scene, with its overrides.
    pub scene: Arc<Scene>,
    /// Name of the body.
    pub body: String,
    /// Name of the hole's edge, without that of the body.
    pub edge: String,
}

impl SpecimenScene {
    /// Index of the body among those of the scene and its model; `None` where the scene lacks it.
    pub fn index(&self) -> Option<usize> {
        self.scene.bodies.keys().position(|name| *name == self.body)
    }

    /// Index of the contact of the scene at the hole's edge; `None` where nothing touches it.
    pub fn contact(&self) -> Option<usize> {
        let at_edge = |set: &SetRef| set.body == self.body && set.set == self.edge;
        let mut contacts = self.scene.contacts.iter();
        contacts.position(|contact| at_edge(&contact.first) || at_edge(&contact.second))
    }
}

/// How synthetic pictures are taken.
#[derive(Clone, Debug, PartialEq)]
pub struct Fringes {
    /// Lower left and upper right corner `[mm]`.
    pub window: [Point; 2],
    /// Edge of a pixel `[mm]`.
    pub pixel: f64,
    /// Carriers (k_x, k_y) of the U and the V field `[1/mm]`.
    pub carrier: [[f64; 2]; 2],
    /// Light, noise and grey levels.
    pub exposure: fringe::Exposure,
    /// Places without picture.
    pub missing: Vec<Area>,
    /// Whether each field has four pictures with shifted phase instead of one.
    pub four: bool,
    /// Kind of the files.
    pub format: fringe::Format,
    /// Grey levels of the files.
    pub depth: fringe::Depth,
    /// Seed of all noise.
    pub seed: u64,
}

/// A part of the plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Area {
    /// A disc.
    Disc {
        /// Its centre `[mm]`.
        centre: Point,
        /// Its radius `[mm]`.
        radius: f64,
    },
    /// An upright rectangle between its lower left and its upper right corner `[mm]`.
    Window([Point; 2]),
}

impl Area {
    /// Whether a place `[mm]` lies in it.
    pub fn contains(&self, place: Point) -> bool {
        match self {
            Self::Disc { centre, radius } => {
                (place[0] - centre[0]).hypot(place[1] - centre[1]) <= *radius
            }
            Self::Window([low, high]) => {
                (0..2).all(|axis| (low[axis]..=high[axis]).contains(&place[axis]))
            }
        }
    }
}
