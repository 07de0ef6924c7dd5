//! Contact pairs with their frames and exact gaps, and the edges that results are reported on.

mod edge;
mod ends;
mod facing;
mod geometry;
mod open;
mod projection;

use std::collections::HashSet;
use std::sync::Arc;

use stickslip_contact::{ContactPair, ContactPoint, Facing};
use stickslip_fem_core::mesh::{Mesh, Point};

use self::edge::{EdgeNodes, edge_nodes, reported_nodes};
use self::geometry::Geometry;
use self::projection::{Side, Tied};
use super::plan::{ContactPlan, Placed, Plan};
use super::{Meshes, ModelEdge, ModelError, edge_loads, loads};
use crate::results::{Choice, SecondSide};
use stickslip_scene::schema::{Contact, DisplayUnits, SetRef};

/// Pairs, edges, and each body's contact points.
#[derive(Debug, Default)]
pub(super) struct Contacts {
    pub(super) pairs: Vec<ContactPair>,
    /// The undeformed edges of each pair, where gaps follow the displacement.
    pub(super) facings: Vec<Facing>,
    pub(super) edges: Vec<ModelEdge>,
    /// Mesh nodes of each body's contact points.
    pub(super) interfaces: Vec<Vec<usize>>,
    /// Where the nodes of each edge end there.
    pub(super) ends: Vec<Vec<usize>>,
    /// Contact points of each rigid body.
    pub(super) rigid_points: Vec<Vec<Point>>,
}

pub(super) fn build(
    plan: &Plan<'_>,
    units: DisplayUnits,
    meshes: &Meshes,
    half: bool,
    choices: &mut Vec<Choice>,
) -> Result<Contacts, ModelError> {
    let mut contacts = Contacts {
        interfaces: vec![Vec::new(); plan.bodies.len()],
        ends: vec![Vec::new(); plan.bodies.len()],
        rigid_points: vec![Vec::new(); plan.bodies.len()],
        ..Contacts::default()
    };
    let mut chosen = Vec::new();
    for contact in &plan.contacts {
        chosen.push(contacts.add(plan, contact, units, meshes, half)?);
    }
    for reported in &plan.edges {
        let name = reported.of.to_string();
        let known = (contacts.edges.iter()).any(|edge| edge.geometry.name == name);
        let mut firsts = plan.contacts.iter().map(|contact| &contact.of.first);
        if known || firsts.any(|first| first == reported.of) {
            continue;
        }
        let body = &plan.bodies[reported.body];
        let edge = reported_nodes(reported, body, meshes, half)?;
        let edge = edge.into_model_edge(reported, body, half, None);
        let mut edge = loaded(plan, reported, edge, &meshes[&reported.body]);
        edge.geometry.frame = loads::frame(plan, reported.of, half);
        contacts.edges.push(edge);
    }
    let own = plan.contacts.iter().map(|contact| contact.of);
    choices.extend(projection::choices(own, &chosen));
    Ok(contacts)
}

/// Part of a radius below which a difference of radii is rounding.
const ROUNDING: f64 = 1e-12;

/// Radius of the hole less that of the circle in it `[mm]`; zero where the difference is rounding.
fn clearance([hole, inner]: [f64; 2]) -> f64 {
    let own = hole - inner;
    if own.abs() > ROUNDING * hole {
        own
    } else {
        0.0
    }
}

impl Contacts {
    /// Adds a contact, and says how its edges are tied and why.
    fn add(
        &mut self,
        plan: &Plan<'_>,
        planned: &ContactPlan<'_>,
        units: DisplayUnits,
        meshes: &Meshes,
        half: bool,
    ) -> Result<[String; 2], ModelError> {
        let ContactPlan {
            of: contact,
            sides: [first, second],
            offset: _,
        } = planned;
        let geometry = geometry(plan, planned)?;
        let is_rigid = plan.is_rigid(second.body);
        let (upper, lower) = match &geometry {
            Geometry::Open(pair) => pair.nodes(plan, planned, meshes, is_rigid, units.length)?,
            Geometry::Circles { .. } | Geometry::Cylinder { .. } => {
                let lower = (!is_rigid).then(|| edge_nodes(second, meshes, half));
                (edge_nodes(first, meshes, half)?, lower.transpose()?)
            }
        };
        let bodies = [first.body, second.body];
        if matches!(geometry, Geometry::Open(_)) {
            let sides = [(first, Some(&upper)), (second, lower.as_ref())];
            self.refuse_shared_nodes(contact, sides)?;
        }
        let [above, below] = self.sides(meshes, bodies, &upper, lower.as_ref());
        let body = &plan.bodies[first.body];
        let tied = Tied {
            length: units.length,
            contact,
            geometry: &geometry,
            half,
            is_seated: plan.bodies[second.body].seat.is_some(),
            means: body
                .series
                .as_ref()
                .and_then(|series| Some(series.circle_nodes()?.mean_angles())),
            line: body.series.as_ref().and_then(|series| series.line_nodes()),
            thickness: body.thickness(),
            material_angle: body.material_angle(),
        };
        let (points, chosen) = tied.tie(&above, &below)?;
        if plan.finds_gaps_deformed() {
            let by_series = facing::by_series(plan, bodies);
            let sides = [&above, &below];
            let facing = tied.facing(self.pairs.len(), sides, &points, by_series)?;
            self.facings.push(facing);
        }
        let local = above.local.clone();
        let edge = upper.into_model_edge(first, body, half, Some(self.pairs.len()));
        let mut edge = loaded(plan, first, edge, &meshes[&first.body]);
        edge.geometry.clearance = planned.radii().map(clearance);
        edge.geometry.second = lower.map(|lower| SecondSide {
            body: second.body,
            normals: lower.path.iter().map(|(_, normal)| *normal).collect(),
            nodes: lower.nodes,
            parameter: lower.parameter,
        });
        self.edges.push(in_contact(edge, contact, local, &points));
        self.pairs.push(ContactPair {
            name: contact.name.clone(),
            origin: [0.0; 2],
            first: first.body,
            second: second.body,
            points,
            law: Arc::from(contact.law.clone()),
        });
        Ok(chosen)
    }

    /// Refuses `contact` where one of its open edges has nodes that touch in another contact already.
    fn refuse_shared_nodes(
        &self,
        contact: &Contact,
        sides: [(&Placed<'_, SetRef>, Option<&EdgeNodes>); 2],
    ) -> Result<(), ModelError> {
        for (side, nodes) in sides {
            let known = &self.interfaces[side.body];
            let shared = nodes.map_or(0, |nodes| shared(known, &nodes.nodes));
            // A corner between two edges is one node.
            if shared > 1 {
                let what = format!(
                    "{} touches in another contact at the same {shared} nodes, whose stresses would lack one of the two: give parts of the edge names of their own",
                    side.of
                );
                return Err(refused(contact, what));
            }
        }
        Ok(())
    }

    /// Adds the nodes of the edges `upper` and `lower` to the contact points of their bodies.
    fn sides<'e>(
        &mut self,
        meshes: &Meshes,
        [first, second]: [usize; 2],
        upper: &'e EdgeNodes,
        lower: Option<&'e EdgeNodes>,
    ) -> [Side<'e>; 2] {
        let above = Side::new(&mut self.interfaces[first], &meshes[&first], upper);
        self.end(first);
        let below = match lower {
            Some(lower) => Side::new(&mut self.interfaces[second], &meshes[&second], lower),
            // A rigid body takes the places of the first edge's nodes for its own.
            None => Side::rigid(&mut self.rigid_points[second], &above, upper),
        };
        if lower.is_some() {
            self.end(second);
        }
        [above, below]
    }

    /// Ends an edge of the body with the index `body`, if it has brought nodes.
    fn end(&mut self, body: usize) {
        let count = self.interfaces[body].len();
        if self.ends[body].last() != Some(&count) {
            self.ends[body].push(count);
        }
    }
}

/// Number of `nodes` that are among `known`.
fn shared(known: &[usize], nodes: &[usize]) -> usize {
    let known: HashSet<usize> = known.iter().copied().collect();
    nodes.iter().filter(|node| known.contains(node)).count()
}

/// `edge` with what else than contact acts on it.
fn loaded(plan: &Plan<'_>, on: &Placed<'_, SetRef>, mut edge: ModelEdge, mesh: &Mesh) -> ModelEdge {
    edge.tractions = edge_loads::edge_tractions(plan, on, &edge);
    edge.reactions = edge_loads::edge_reactions(plan, on, &edge);
    edge.shared_ends = edge_loads::shared_ends(plan, on, &edge, mesh);
    edge
}

/// What the edges of a contact are to each other, if they can touch.
fn geometry(plan: &Plan<'_>, planned: &ContactPlan<'_>) -> Result<Geometry, ModelError> {
    let contact = planned.of;
    if plan.is_rigid(planned.sides[0].body) {
        let what = format!(
            "the first body '{}' is rigid, which only the second may be: give it a material",
            contact.first.body
        );
        return Err(refused(contact, what));
    }
    Geometry::of(plan, planned).ok_or_else(|| {
        let what = format!(
            "{} and {} cannot touch; a hole takes a disk's rim or a ring's outer edge, a cylinder a block, an open edge another",
            contact.first, contact.second
        );
        refused(contact, what)
    })
}

fn refused(contact: &Contact, what: String) -> ModelError {
    ModelError::Pairing {
        contact: contact.name.clone(),
        what,
    }
}

/// `edge` as the first of `contact`, with the contact points `points` at its nodes `local`.
fn in_contact(
    mut edge: ModelEdge,
    contact: &Contact,
    local: Vec<usize>,
    points: &[ContactPoint],
) -> ModelEdge {
    edge.geometry.name.clone_from(&contact.name);
    contact.law.name().clone_into(&mut edge.geometry.law);
    edge.local = local;
    edge.areas = points.iter().map(|point| point.area).collect();
    edge
}
