//! How the edges of a contact are tied: pairs of nodes where the meshes match, the mortar projection where they do not.
//!
//! On circles the motion of a mortar point is made to follow a turn φ of its body about the circle's centre as a node does,
//!
//! ```text
//! (u_n, u_t) = Σ_j W_j F u_j + couples = (0, R φ)     for u_j = φ e_z × (x_j − c)
//! ```
//!
//! Cells between nodes miss that by the third power of their length, so the normal forces of a coarse mesh would turn a pin that
//! friction alone holds. The couples are forces of the stencil's own nodes without resultant, perpendicular to their arms.

use std::collections::HashMap;
use std::f64::consts::TAU;

use stickslip_contact::mortar::{self, MortarError, Projected};
use stickslip_contact::{
    ContactPoint, EdgeSide, InitialGap, Multipliers, Projection, Stencil, StencilTerm,
};
use stickslip_fem_core::mesh::{Mesh, Point};

use super::edge::EdgeNodes;
use super::geometry::Geometry;
use crate::model::ModelError;
use crate::results::{Choice, EdgeKind};
use stickslip_scene::schema::{Contact, ProjectionChoice};
use stickslip_scene::units::Unit;
use stickslip_series::LineNodes;

/// Places along an edge that differ by less than this part of its extent are the same.
const SAME_PLACE: f64 = 1e-9;

/// One side of a contact.
pub(super) struct Side<'a> {
    pub(super) edge: &'a EdgeNodes,
    /// Where its nodes stand among the body's contact points.
    pub(super) local: Vec<usize>,
    /// Positions of all contact points of the body so far `[mm]`.
    positions: Vec<Point>,
}

impl<'a> Side<'a> {
    /// Adds the nodes of `edge` to the contact points `interface` of its body, but for those that stand there of another contact.
    pub(super) fn new(interface: &mut Vec<usize>, mesh: &Mesh, edge: &'a EdgeNodes) -> Self {
        // Circles share no nodes.
        let open = interface.iter().filter(|_| edge.kind == EdgeKind::Path);
        let known: HashMap<usize, usize> = open.copied().zip(0..).collect();
        let mut place = |node: &usize| {
            known.get(node).copied().unwrap_or_else(|| {
                interface.push(*node);
                interface.len() - 1
            })
        };
        let local = edge.nodes.iter().map(&mut place).collect();
        Self {
            edge,
            local,
            positions: interface.iter().map(|&node| mesh.nodes()[node]).collect(),
        }
    }

    /// Adds the places of `other` to the contact points of a rigid body.
    pub(super) fn rigid(points: &mut Vec<Point>, other: &Self, edge: &'a EdgeNodes) -> Self {
        let start = points.len();
        points.extend(other.local.iter().map(|&own| other.positions[own]));
        Self {
            edge,
            local: (start..points.len()).collect(),
            positions: points.clone(),
        }
    }

    /// Position of its node `k` `[mm]`.
    pub(super) fn position(&self, k: usize) -> Point {
        self.positions[self.local[k]]
    }

    /// `stencil` with the moments about the circle's centre that a node on it has: none of a normal force, the radius of a tangential
    /// one.
    fn centred(&self, stencil: &Stencil, [nx, ny]: [f64; 2]) -> Stencil {
        let EdgeKind::Circle { centre, radius } = self.edge.kind else {
            return stencil.clone();
        };
        // In the frame of the point: along the normal and along the tangent.
        let place = |node: usize| {
            let [x, y] = [0, 1].map(|i| self.positions[node][i] - centre[i]);
            [nx * x + ny * y, nx * y - ny * x]
        };
        let terms = stencil.terms();
        let places: Vec<[f64; 2]> = terms.iter().map(|term| place(term.node)).collect();
        let count = places.len() as f64;
        let middle = [0, 1].map(|i| places.iter().map(|at| at[i]).sum::<f64>() / count);
        let arms = places
            .iter()
            .map(|at| [at[0] - middle[0], at[1] - middle[1]]);
        let arms: Vec<[f64; 2]> = arms.collect();
        let size: f64 = arms.iter().map(|[n, t]| n * n + t * t).sum();
        if size <= 0.0 {
            return stencil.clone();
        }
        let wanted = [0.0, radius];
        let missing: [f64; 2] = std::array::from_fn(|row| {
            let moment = |(term, at): (&StencilTerm, &[f64; 2])| {
                at[0] * term.weights[row][1] - at[1] * term.weights[row][0]
            };
            wanted[row] - terms.iter().zip(&places).map(moment).sum::<f64>()
        });
        let mended = terms.iter().zip(&arms).map(|(term, [n, t])| StencilTerm {
            node: term.node,
            weights: std::array::from_fn(|row| {
                let [along_n, along_t] = term.weights[row];
                let turn = missing[row] / size;
                [along_n - turn * t, along_t + turn * n]
            }),
        });
        Stencil::new(mended.collect())
    }

    fn projected(&self, closed: bool) -> Result<EdgeSide, MortarError> {
        let (nodes, parameter) = (self.local.clone(), self.edge.parameter.clone());
        if closed {
            EdgeSide::closed(nodes, parameter, self.edge.order, TAU)
        } else {
            EdgeSide::open(nodes, parameter, self.edge.order)
        }
    }
}

/// What the two sides of a contact have in common.
pub(super) struct Tied<'a> {
    /// The unit of lengths in messages.
    pub(super) length: &'static Unit,
    pub(super) contact: &'a Contact,
    pub(super) geometry: &'a Geometry,
    pub(super) half: bool,
    /// Whether nodes of the second edge stand where those of the first face it, not at the same places.
    pub(super) is_seated: bool,
    /// Where nodal forces on the first edge act, as in its parameter, if it is that of a series; otherwise at the nodes.
    pub(super) means: Option<Vec<f64>>,
    /// Nodes of the first edge if it is that of a half-plane, whose gaps are means over hats and whose areas are those of its tangent.
    pub(super) line: Option<&'a LineNodes>,
    /// Thickness `[mm]` and angle of the 1-axis `[rad]` of the first body.
    pub(super) thickness: f64,
    pub(super) material_angle: f64,
}

impl Tied<'_> {
    /// One contact point per node of the first edge; with how they were made and why.
    pub(super) fn tie(
        &self,
        first: &Side<'_>,
        second: &Side<'_>,
    ) -> Result<(Vec<ContactPoint>, [String; 2]), ModelError> {
        let mismatch = self.mismatch(first.edge, second.edge);
        let said = || {
            let meshes = mismatch.clone();
            format!(
                "the scene says so; {}",
                meshes.unwrap_or_else(|| "the meshes match".into())
            )
        };
        let (multipliers, reason) = match (self.contact.projection, &mismatch) {
            (ProjectionChoice::Nodes, Some(why)) => {
                return Err(self.refuse(format!("pairs of nodes need meshes that match, but {why}")));
            }
            (ProjectionChoice::Nodes, None) => (None, said()),
            (ProjectionChoice::Auto, None) => (
                None,
                "the meshes of a pair are made with the same divisions; gaps come from the true geometry"
                    .to_owned(),
            ),
            (ProjectionChoice::Auto, Some(why)) if self.line.is_some() => {
                return Err(self.refuse(format!("half-planes are tied by pairs of nodes, but {why}; give both the same mesh, or none")));
            }
            (ProjectionChoice::Auto, Some(why)) => (Some(Multipliers::Dual), why.clone()),
            (ProjectionChoice::Mortar, _) => (Some(Multipliers::Standard), said()),
            (ProjectionChoice::DualMortar, _) => (Some(Multipliers::Dual), said()),
        };
        let (points, value) = match multipliers {
            None => (self.node_pairs(first, second), "matching node pairs"),
            Some(Multipliers::Standard) => (
                self.mortar(first, second, Multipliers::Standard)?,
                "mortar projection, standard multipliers",
            ),
            Some(Multipliers::Dual) => (
                self.mortar(first, second, Multipliers::Dual)?,
                "mortar projection, dual multipliers",
            ),
        };
        Ok((points, [value.to_owned(), reason]))
    }

    pub(super) fn refuse(&self, what: String) -> ModelError {
        ModelError::Projection {
            contact: self.contact.name.clone(),
            what,
        }
    }

    /// Why the nodes of the two edges make no pairs.
    fn mismatch(&self, first: &EdgeNodes, second: &EdgeNodes) -> Option<String> {
        let Contact {
            first: upper,
            second: lower,
            ..
        } = self.contact;
        if first.order != second.order {
            let order = |edge: &EdgeNodes| match edge.order {
                1 => "linear".to_owned(),
                2 => "quadratic".to_owned(),
                order => format!("of order {order}"),
            };
            return Some(format!(
                "the cells along {upper} are {}, those along {lower} {}",
                order(first),
                order(second)
            ));
        }
        let (count, other) = (first.nodes.len(), second.nodes.len());
        if count != other {
            return Some(format!("{count} nodes of {upper} face {other} of {lower}"));
        }
        let places = first.parameter.iter().zip(&second.parameter);
        let apart = places.fold(0.0_f64, |most, (a, b)| most.max((a - b).abs()));
        let extent = first
            .parameter
            .iter()
            .fold(0.0_f64, |most, at| most.max(at.abs()));
        (apart > SAME_PLACE * extent && !self.is_seated).then(|| {
            let shown = match first.kind {
                EdgeKind::Circle { .. } => format!("{:.3}°", apart.to_degrees()),
                EdgeKind::Line | EdgeKind::Path => self.length.show(apart),
            };
            format!("nodes of {upper} and {lower} lie up to {shown} apart")
        })
    }

    fn gap(&self, at: f64) -> Option<f64> {
        self.geometry.gap(self.contact.gap, at)
    }

    /// Unit normal from the second body into the first at the place `at` of `edge`.
    fn normal(&self, edge: &EdgeNodes, at: f64) -> [f64; 2] {
        match self.geometry {
            Geometry::Open(pair) => pair.normal(at),
            Geometry::Circles { .. } | Geometry::Cylinder { .. } => edge.normal(at),
        }
    }

    fn node_pairs(&self, first: &Side<'_>, second: &Side<'_>) -> Vec<ContactPoint> {
        let edge = first.edge;
        let means = self.means.as_ref().unwrap_or(&edge.parameter);
        let (weights, gaps) = match self.line {
            Some(line) => {
                let gaps = self
                    .gap(0.0)
                    .map(|_| line.mean(|x| self.gap(x).unwrap_or_default()));
                (line.weights(), gaps)
            }
            None => (edge.weights.clone(), None),
        };
        let gap = |k: usize, at: f64| {
            gaps.as_ref()
                .map_or_else(|| self.gap(at), |gaps| Some(gaps[k]))
        };
        let point = |(k, &at): (usize, &f64)| {
            let normal = self.normal(edge, at);
            let (above, below) = (first.position(k), second.position(k));
            let faceted = normal[0] * (above[0] - below[0]) + normal[1] * (above[1] - below[1]);
            ContactPoint {
                first: first.local[k].into(),
                second: second.local[k].into(),
                normal,
                gap: gap(k, at).unwrap_or(faceted),
                area: weights[k] * self.thickness,
                material_angle: self.material_angle,
            }
        };
        means.iter().enumerate().map(point).collect()
    }

    fn mortar(
        &self,
        first: &Side<'_>,
        second: &Side<'_>,
        multipliers: Multipliers,
    ) -> Result<Vec<ContactPoint>, ModelError> {
        let edge = first.edge;
        let round = matches!(edge.kind, EdgeKind::Circle { .. });
        let closed = round && !self.half;
        // Where the gap is not one of the true geometry, it is that between the meshes.
        let exact = |at: f64| self.gap(at).unwrap_or_default();
        let gap = match self.gap(0.0) {
            Some(_) => InitialGap::Exact(&exact),
            None => InitialGap::Faceted(&first.positions, &second.positions),
        };
        let projection = Projection {
            multipliers,
            length: self.geometry.length(),
            thickness: self.thickness,
            normal: &|at| self.normal(edge, at),
            gap,
            material_angle: self.material_angle,
            symmetry: [self.half, self.half && round],
        };
        let project = || {
            let (above, below) = (first.projected(closed)?, second.projected(closed)?);
            mortar::project(&above, &below, &projection)
        };
        let made = project().map_err(|cause| self.refuse(cause.to_string()))?;
        // Rows of results are nodes of the first edge, so each must have its point.
        let (found, nodes) = (made.points.len(), edge.nodes.len());
        if let (Geometry::Open(pair), true) = (self.geometry, found < nodes) {
            return Ok(self.completed(made, pair.never(), first, second));
        }
        if found != nodes {
            return Err(self.refuse(format!(
                "{} covers {found} of the {nodes} nodes of {}",
                self.contact.second, self.contact.first
            )));
        }
        let mut points = made.points;
        let last = nodes - 1;
        for (k, point) in points.iter_mut().enumerate() {
            // On a line of symmetry the other half balances the moments.
            if !(self.half && (k == 0 || k == last)) {
                point.first = first.centred(&point.first, point.normal);
                point.second = second.centred(&point.second, point.normal);
            }
        }
        Ok(points)
    }
}

impl Tied<'_> {
    /// The points of a first edge that the second covers in part: nodes that face nothing never touch.
    fn completed(
        &self,
        made: Projected,
        never: f64,
        first: &Side<'_>,
        second: &Side<'_>,
    ) -> Vec<ContactPoint> {
        let edge = first.edge;
        let mut found: Vec<Option<ContactPoint>> = vec![None; edge.nodes.len()];
        for (node, point) in made.nodes.into_iter().zip(made.points) {
            found[node] = Some(point);
        }
        let point = |(k, found): (usize, Option<ContactPoint>)| {
            found.unwrap_or_else(|| ContactPoint {
                first: first.local[k].into(),
                second: second.local[0].into(),
                normal: self.normal(edge, edge.parameter[k]),
                gap: never,
                area: edge.weights[k] * self.thickness,
                material_angle: self.material_angle,
            })
        };
        found.into_iter().enumerate().map(point).collect()
    }
}

/// One choice for all contacts where they are tied alike, otherwise one for each: `chosen` holds value and reason of each contact.
pub(super) fn choices<'a>(
    contacts: impl Iterator<Item = &'a Contact>,
    chosen: &[[String; 2]],
) -> Vec<Choice> {
    let alike = chosen.windows(2).all(|pair| pair[0] == pair[1]);
    let contacts = contacts.zip(chosen);
    let choice = |(contact, [value, reason]): (&Contact, &[String; 2])| Choice {
        what: if alike {
            "contact discretisation".to_owned()
        } else {
            format!("contact discretisation of '{}'", contact.name)
        },
        value: value.clone(),
        reason: reason.clone(),
    };
    let count = if alike { 1 } else { chosen.len() };
    contacts.take(count).map(choice).collect()
}
