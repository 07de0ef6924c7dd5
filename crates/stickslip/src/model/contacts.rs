//! Contact pairs with their frames and exact gaps, and the edges that results are reported on.

use std::f64::consts::{PI, TAU};
use std::sync::Arc;

use stickslip_contact::{ContactPair, ContactPoint, gap};
use stickslip_fem_core::mesh::{Curve, Mesh, Point};

use super::{Meshes, ModelEdge, ModelError, loads, placement};
use crate::results::{Choice, EdgeGeometry, EdgeKind};
use crate::scene::Scene;
use crate::scene::schema::{self, Contact, GapKind, SetRef, Shape, Substance};

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

/// The nodes of an edge by ascending parameter.
struct EdgeNodes {
    kind: EdgeKind,
    parameter: Vec<f64>,
    nodes: Vec<usize>,
    corner: Vec<bool>,
    weights: Vec<f64>,
    order: usize,
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
    for contact in &scene.contacts {
        let (first, second) = (index(&contact.first.body), index(&contact.second.body));
        contacts.add(scene, contact, meshes, [first, second], half)?;
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
        contacts.edges.push(edge);
    }
    if !scene.contacts.is_empty() {
        choices.push(Choice {
            what: "contact discretisation".into(),
            value: "matching node pairs".into(),
            reason: "the meshes of a pair are made with the same divisions; gaps come from the true geometry".into(),
        });
    }
    Ok(contacts)
}

impl Contacts {
    fn add(
        &mut self,
        scene: &Scene,
        contact: &Contact,
        meshes: &Meshes,
        [first, second]: [usize; 2],
        half: bool,
    ) -> Result<(), ModelError> {
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
        let count = upper.nodes.len();
        let first_start = self.interfaces[first].len();
        self.interfaces[first].extend(&upper.nodes);
        let positions = |mesh: &Mesh, nodes: &[usize]| -> Vec<Point> {
            nodes.iter().map(|&node| mesh.nodes()[node]).collect()
        };
        let upper_positions = positions(&meshes[&contact.first.body], &upper.nodes);
        let (second_start, lower_positions) = if rigid(&contact.second.body) {
            let start = self.rigid_points[second].len();
            self.rigid_points[second].extend(&upper_positions);
            (start, upper_positions.clone())
        } else {
            let lower = edge_nodes(scene, &contact.second, meshes, half)?;
            if lower.nodes.len() != count {
                return Err(refuse(format!(
                    "{count} nodes face {}; the meshes must match",
                    lower.nodes.len()
                )));
            }
            let start = self.interfaces[second].len();
            self.interfaces[second].extend(&lower.nodes);
            (
                start,
                positions(&meshes[&contact.second.body], &lower.nodes),
            )
        };
        let (thickness, material_angle) = substance(scene, &contact.first.body);
        let points = (0..count)
            .map(|k| {
                let normal = upper.normal(k);
                let faceted = normal[0] * (upper_positions[k][0] - lower_positions[k][0])
                    + normal[1] * (upper_positions[k][1] - lower_positions[k][1]);
                ContactPoint {
                    first: (first_start + k).into(),
                    second: (second_start + k).into(),
                    normal,
                    gap: geometry
                        .gap(contact.gap, upper.parameter[k])
                        .unwrap_or(faceted),
                    area: upper.weights[k] * thickness,
                    material_angle,
                }
            })
            .collect();
        let pair = self.pairs.len();
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
        edge.local = (first_start..first_start + count).collect();
        self.edges.push(edge);
        Ok(())
    }
}

/// The two curves that face each other.
enum Geometry {
    Circles {
        radius: f64,
        clearance: f64,
        offset: Point,
    },
    Cylinder {
        radius: f64,
    },
}

impl Geometry {
    fn of(scene: &Scene, contact: &Contact) -> Option<Self> {
        let shape = |set: &SetRef| scene.bodies.get(&set.body).map(|body| body.shape);
        match (shape(&contact.first)?, shape(&contact.second)?) {
            (Shape::PlateWithHole { .. }, Shape::Disk { .. } | Shape::PlateWithHole { .. })
                if contact.first.set == "hole" && contact.second.set != "hole" =>
            {
                let radii @ [radius, inner] = placement::radii(scene, contact)?;
                Some(Self::Circles {
                    radius,
                    clearance: radius - inner,
                    offset: placement::offset(radii),
                })
            }
            (Shape::Cylinder { radius, .. }, Shape::Block { .. })
                if contact.first.set == "contact" && contact.second.set == "contact" =>
            {
                Some(Self::Cylinder { radius })
            }
            _ => None,
        }
    }

    /// Initial gap; `None` for a faceted one.
    fn gap(&self, kind: GapKind, at: f64) -> Option<f64> {
        match (self, kind) {
            (_, GapKind::Faceted) => None,
            (
                Self::Circles {
                    radius,
                    clearance,
                    offset,
                },
                GapKind::Exact,
            ) => Some(gap::circles(*radius, *clearance, *offset, at)),
            (
                Self::Circles {
                    clearance, offset, ..
                },
                GapKind::Linearised,
            ) => Some(gap::circles_linearised(*clearance, *offset, at)),
            (Self::Cylinder { radius }, GapKind::Exact) => Some(gap::cylinder(*radius, at)),
            (Self::Cylinder { radius }, GapKind::Linearised) => {
                Some(gap::cylinder_linearised(*radius, at))
            }
        }
    }
}

/// Thickness `[mm]` and material angle `[rad]` of an elastic body.
fn substance(scene: &Scene, body: &str) -> (f64, f64) {
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

fn edge_nodes(
    scene: &Scene,
    edge: &SetRef,
    meshes: &Meshes,
    half: bool,
) -> Result<EdgeNodes, ModelError> {
    let mesh_error = |cause| ModelError::Mesh {
        body: edge.body.clone(),
        cause,
    };
    let mesh = &meshes[&edge.body];
    let path = mesh.edge_path(&edge.set).map_err(mesh_error)?;
    let curve = mesh.edge_set(&edge.set).map_err(mesh_error)?.curve;
    let shape = &scene.bodies[&edge.body].shape;
    if let (Some(radius), Some(Curve::Arc { centre, .. })) = (shape.circle(&edge.set), curve) {
        let walk = mesh.counter_clockwise(&path, centre);
        let weights = mesh.edge_weights(&walk, curve);
        let parameter = mesh.angles(&walk, centre);
        let corner = (0..walk.nodes.len()).map(|k| k % walk.order == 0).collect();
        let mut nodes = EdgeNodes {
            kind: EdgeKind::Circle { centre, radius },
            parameter,
            nodes: walk.nodes,
            corner,
            weights,
            order: walk.order,
        };
        if !half {
            nodes.start_at_minus_pi();
        }
        return Ok(nodes);
    }
    let weights = mesh.edge_weights(&path, curve);
    let x = |node: usize| mesh.nodes()[node][0];
    let mut nodes = EdgeNodes {
        kind: EdgeKind::Line,
        parameter: path.nodes.iter().map(|&node| x(node)).collect(),
        corner: (0..path.nodes.len()).map(|k| k % path.order == 0).collect(),
        weights,
        order: path.order,
        nodes: path.nodes,
    };
    if nodes.parameter.first() > nodes.parameter.last() {
        nodes.parameter.reverse();
        nodes.nodes.reverse();
        nodes.corner.reverse();
        nodes.weights.reverse();
    }
    Ok(nodes)
}

impl EdgeNodes {
    /// Rotates a closed walk so that its angles ascend from −π and the bearing point lies in the middle.
    fn start_at_minus_pi(&mut self) {
        let first = (0..self.nodes.len())
            .filter(|&k| self.corner[k])
            .find(|&k| self.parameter[k] > PI - 1e-9)
            .unwrap_or(0);
        for angle in &mut self.parameter[first..] {
            *angle -= TAU;
        }
        self.parameter.rotate_left(first);
        self.nodes.rotate_left(first);
        self.corner.rotate_left(first);
        self.weights.rotate_left(first);
    }

    /// e_r on a circle, +y on a line.
    fn normal(&self, k: usize) -> [f64; 2] {
        match self.kind {
            EdgeKind::Circle { .. } => [self.parameter[k].cos(), self.parameter[k].sin()],
            EdgeKind::Line => [0.0, 1.0],
        }
    }

    fn into_model_edge(
        self,
        scene: &Scene,
        edge: &SetRef,
        body: usize,
        half: bool,
        pair: Option<usize>,
    ) -> ModelEdge {
        let normals = (0..self.nodes.len()).map(|k| self.normal(k)).collect();
        let (thickness, _) = substance(scene, &edge.body);
        let bearing_area = match self.kind {
            EdgeKind::Circle { radius, .. } => Some(2.0 * radius * thickness),
            EdgeKind::Line => None,
        };
        ModelEdge {
            geometry: EdgeGeometry {
                name: edge.to_string(),
                contact: pair.is_some(),
                body: edge.body.clone(),
                kind: self.kind,
                parameter: self.parameter,
                corner: self.corner,
                half,
                bearing_area,
                law: String::new(),
            },
            body,
            nodes: self.nodes,
            local: Vec::new(),
            areas: self
                .weights
                .iter()
                .map(|weight| weight * thickness)
                .collect(),
            order: self.order,
            normals,
            pair,
            tractions: Vec::new(),
        }
    }
}
