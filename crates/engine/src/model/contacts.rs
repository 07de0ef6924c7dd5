//! Contact pairs with their frames and exact gaps, and the edges that results are reported on.

mod edge;
mod geometry;
mod projection;

use std::sync::Arc;

use stickslip_contact::ContactPair;
use stickslip_fem_core::mesh::Point;

use self::edge::edge_nodes;
use self::geometry::Geometry;
use self::projection::{Side, Tied};
use super::{Meshes, ModelEdge, ModelError, loads};
use crate::results::Choice;
use stickslip_scene::Scene;
use stickslip_scene::schema::{self, Contact, Substance};

/// Pairs, edges, and each body's contact points.
#[derive(Debug, Default)]
pub(super) struct Contacts {
    pub(super) pairs: Vec<ContactPair>,
    pub(super) edges: Vec<ModelEdge>,
    /// Mesh nodes of each body's contact points.
    pub(super) interfaces: Vec<Vec<usize>>,
    /// Contact points of each rigid body.
    pub(super) rigid_points: Vec<Vec<Point>>,
}

pub(super) fn build(
    scene: &Scene,
    meshes: &Meshes,
    names: &[String],
    half: bool,
    choices: &mut Vec<Choice>,
) -> Result<Contacts, ModelError> {
    let mut contacts = Contacts {
        interfaces: vec![Vec::new(); names.len()],
        rigid_points: vec![Vec::new(); names.len()],
        ..Contacts::default()
    };
    // The scene was checked: every contact names two bodies of it.
    let index = |body: &str| names.iter().position(|name| name == body).unwrap_or(0);
    let mut chosen = Vec::new();
    for contact in &scene.contacts {
        let (first, second) = (index(&contact.first.body), index(&contact.second.body));
        chosen.push(contacts.add(scene, contact, meshes, [first, second], half)?);
    }
    for reported in &scene.edges {
        let known = contacts
            .edges
            .iter()
            .any(|edge| edge.geometry.name == reported.to_string());
        if known
            || scene
                .contacts
                .iter()
                .any(|contact| contact.first == *reported)
        {
            continue;
        }
        let edge = edge_nodes(scene, reported, meshes, half)?;
        let mut edge = edge.into_model_edge(scene, reported, index(&reported.body), half, None);
        edge.tractions = loads::edge_tractions(scene, reported, &edge);
        edge.geometry.frame = loads::frame(scene, reported, half);
        contacts.edges.push(edge);
    }
    choices.extend(projection::choices(scene, &chosen));
    Ok(contacts)
}

impl Contacts {
    /// Adds a contact, and says how its edges are tied and why.
    fn add(
        &mut self,
        scene: &Scene,
        contact: &Contact,
        meshes: &Meshes,
        [first, second]: [usize; 2],
        half: bool,
    ) -> Result<[String; 2], ModelError> {
        let refuse = |what: String| ModelError::Pairing {
            contact: contact.name.clone(),
            what,
        };
        let rigid = |body: &str| scene.bodies[body].substance == Substance::Rigid;
        if rigid(&contact.first.body) {
            return Err(refuse(format!(
                "the first body '{}' is rigid, which only the second may be: give it a material",
                contact.first.body
            )));
        }
        let upper = edge_nodes(scene, &contact.first, meshes, half)?;
        let geometry = Geometry::of(scene, contact).ok_or_else(|| {
            refuse(format!(
                "{} and {} cannot touch; a hole takes a disk's rim or a ring's outer edge, a cylinder a block",
                contact.first, contact.second
            ))
        })?;
        let lower = if rigid(&contact.second.body) {
            None
        } else {
            Some(edge_nodes(scene, &contact.second, meshes, half)?)
        };
        let mesh = &meshes[&contact.first.body];
        let above = Side::new(&mut self.interfaces[first], mesh, &upper);
        let below = match &lower {
            Some(lower) => Side::new(
                &mut self.interfaces[second],
                &meshes[&contact.second.body],
                lower,
            ),
            // A rigid body takes the places of the first edge's nodes for its own.
            None => Side::rigid(&mut self.rigid_points[second], &above, &upper),
        };
        let (thickness, material_angle) = substance(scene, &contact.first.body);
        let tied = Tied {
            scene,
            contact,
            geometry: &geometry,
            half,
            thickness,
            material_angle,
        };
        let (points, chosen) = tied.tie(&above, &below)?;
        let pair = self.pairs.len();
        let areas = points.iter().map(|point| point.area).collect();
        let local = above.local.clone().collect();
        self.pairs.push(ContactPair {
            name: contact.name.clone(),
            first,
            second,
            points,
            law: Arc::from(contact.law.clone()),
        });
        let mut edge = upper.into_model_edge(scene, &contact.first, first, half, Some(pair));
        edge.geometry.name.clone_from(&contact.name);
        contact.law.name().clone_into(&mut edge.geometry.law);
        edge.local = local;
        edge.areas = areas;
        self.edges.push(edge);
        Ok(chosen)
    }
}

/// Thickness `[mm]` and material angle `[rad]` of an elastic body.
pub(super) fn substance(scene: &Scene, body: &str) -> (f64, f64) {
    match &scene.bodies[body].substance {
        Substance::Elastic {
            material,
            thickness,
        } => (
            *thickness,
            scene
                .materials
                .get(material)
                .map_or(0.0, schema::Material::angle),
        ),
        Substance::Rigid => (1.0, 0.0),
    }
}
