//! The nodes of an edge, in walk order.

use std::f64::consts::{PI, TAU};

use stickslip_fem_core::mesh::{Curve, Point};

use crate::model::plan::{BodyPlan, Placed};
use crate::model::{EdgeEnd, Meshes, ModelEdge, ModelError};
use crate::results::{ContactFrame, EdgeGeometry, EdgeKind};
use stickslip_scene::schema::SetRef;
use stickslip_scene::shape::Path;

/// The nodes of an edge by ascending parameter.
pub(super) struct EdgeNodes {
    pub(super) kind: EdgeKind,
    pub(super) parameter: Vec<f64>,
    /// Arc length along e_t, and e_n there.
    pub(super) path: Vec<(f64, [f64; 2])>,
    /// Centre of its circle or arc.
    pub(super) centre: Option<Point>,
    pub(super) nodes: Vec<usize>,
    pub(super) corner: Vec<bool>,
    pub(super) weights: Vec<f64>,
    pub(super) order: usize,
    /// What lies at its ends, if it touches another open edge.
    pub(super) ends: [EdgeEnd; 2],
}

/// The nodes of an edge without contact of `body`, over the arc length where neither θ nor x says its places.
pub(super) fn reported_nodes(
    edge: &Placed<'_, SetRef>,
    body: &BodyPlan<'_>,
    meshes: &Meshes,
    half: bool,
) -> Result<EdgeNodes, ModelError> {
    let own = edge.edge.as_ref().filter(|own| !own.is_reportable());
    match own.and_then(|own| own.curve.path()) {
        Some(path) => path_nodes(edge, &path.moved(body.centre), meshes),
        None => edge_nodes(edge, meshes, half),
    }
}

/// The nodes of an open edge along `path`, by their arc lengths from its middle.
fn path_nodes(
    edge: &Placed<'_, SetRef>,
    path: &Path,
    meshes: &Meshes,
) -> Result<EdgeNodes, ModelError> {
    let mesh_error = |cause| ModelError::Mesh {
        body: edge.of.body.clone(),
        cause,
    };
    let mesh = &meshes[&edge.body];
    let walk = mesh.edge_path(&edge.of.set).map_err(mesh_error)?;
    let curve = mesh.edge_set(&edge.of.set).map_err(mesh_error)?.curve;
    let places = walk
        .nodes
        .iter()
        .map(|&node| path.nearest(mesh.nodes()[node]));
    let places: Vec<f64> = places.collect();
    let middle = 0.5 * path.length();
    Ok(EdgeNodes {
        kind: EdgeKind::Path,
        parameter: places.iter().map(|s| s - middle).collect(),
        path: places.iter().map(|&s| (middle - s, path.left(s))).collect(),
        centre: None,
        weights: mesh.edge_weights(&walk, curve),
        corner: (0..walk.nodes.len()).map(|k| k % walk.order == 0).collect(),
        nodes: walk.nodes,
        order: walk.order,
        ends: [EdgeEnd::Free; 2],
    })
}

pub(super) fn edge_nodes(
    edge: &Placed<'_, SetRef>,
    meshes: &Meshes,
    half: bool,
) -> Result<EdgeNodes, ModelError> {
    let mesh_error = |cause| ModelError::Mesh {
        body: edge.of.body.clone(),
        cause,
    };
    let mesh = &meshes[&edge.body];
    let path = mesh.edge_path(&edge.of.set).map_err(mesh_error)?;
    let curve = mesh.edge_set(&edge.of.set).map_err(mesh_error)?.curve;
    if let (Some(radius), Some(Curve::Arc { centre, .. })) = (edge.circle(), curve) {
        let walk = mesh.counter_clockwise(&path, centre);
        let weights = mesh.edge_weights(&walk, curve);
        let parameter = mesh.angles(&walk, centre);
        let corner = (0..walk.nodes.len()).map(|k| k % walk.order == 0).collect();
        let mut nodes = EdgeNodes {
            kind: EdgeKind::Circle { centre, radius },
            path: Vec::new(),
            parameter,
            centre: Some(centre),
            nodes: walk.nodes,
            corner,
            weights,
            order: walk.order,
            ends: [EdgeEnd::Free; 2],
        };
        if !half {
            nodes.start_at_minus_pi();
        }
        let places = nodes.parameter.iter();
        nodes.path = places
            .map(|&at| (radius * at, [at.cos(), at.sin()]))
            .collect();
        return Ok(nodes);
    }
    let weights = mesh.edge_weights(&path, curve);
    let x = |node: usize| mesh.nodes()[node][0];
    let places = path.nodes.iter().map(|&node| mesh.nodes()[node]);
    let mut nodes = EdgeNodes {
        kind: EdgeKind::Line,
        path: places.map(|place| on_line(place, curve)).collect(),
        parameter: path.nodes.iter().map(|&node| x(node)).collect(),
        corner: (0..path.nodes.len()).map(|k| k % path.order == 0).collect(),
        weights,
        order: path.order,
        centre: match curve {
            Some(Curve::Arc { centre, .. }) => Some(centre),
            _ => None,
        },
        nodes: path.nodes,
        ends: [EdgeEnd::Free; 2],
    };
    if nodes.parameter.first() > nodes.parameter.last() {
        nodes.parameter.reverse();
        nodes.path.reverse();
        nodes.nodes.reverse();
        nodes.corner.reverse();
        nodes.weights.reverse();
    }
    Ok(nodes)
}

/// Arc length along e_t, which leads to smaller x, and e_n at `place` of an edge whose results stand over x: a straight line along x,
/// or an arc that crosses the line through its centre along y.
fn on_line(place: Point, curve: Option<Curve>) -> (f64, [f64; 2]) {
    let Some(Curve::Arc { centre, .. }) = curve else {
        return (-place[0], [0.0, 1.0]);
    };
    let [x, y] = [place[0] - centre[0], place[1] - centre[1]];
    let radius = x.hypot(y);
    let upwards = y.signum() / radius;
    (-radius * x.atan2(y.abs()), [x * upwards, y * upwards])
}

impl EdgeNodes {
    /// Rotates a closed walk so that its angles ascend from −π.
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

    /// At parameter `at`: e_r on a circle, +y on a line.
    pub(super) fn normal(&self, at: f64) -> [f64; 2] {
        match self.kind {
            EdgeKind::Circle { .. } => [at.cos(), at.sin()],
            EdgeKind::Line | EdgeKind::Path => [0.0, 1.0],
        }
    }

    pub(super) fn into_model_edge(
        self,
        edge: &Placed<'_, SetRef>,
        body: &BodyPlan<'_>,
        half: bool,
        pair: Option<usize>,
    ) -> ModelEdge {
        let (along, normals) = self.path.into_iter().unzip();
        let thickness = body.thickness();
        // An edge beside the line of symmetry lies wholly in the half or wholly out of it.
        let own = edge.edge.as_ref().zip(body.shape.mirror());
        let aside = own.and_then(|(own, across)| own.side(across));
        let half = half && aside.is_none();
        let bearing_area = match self.kind {
            EdgeKind::Circle { radius, .. } => Some(2.0 * radius * thickness),
            EdgeKind::Line | EdgeKind::Path => None,
        };
        ModelEdge {
            geometry: EdgeGeometry {
                name: edge.of.to_string(),
                contact: pair.is_some(),
                body: edge.body,
                kind: self.kind,
                parameter: self.parameter,
                corner: self.corner,
                half,
                clearance: None,
                bearing_area,
                law: String::new(),
                frame: ContactFrame::NONE,
                second: None,
            },
            nodes: self.nodes,
            local: Vec::new(),
            areas: self
                .weights
                .iter()
                .map(|weight| weight * thickness)
                .collect(),
            order: self.order,
            along,
            normals,
            reactions: Vec::new(),
            shared_ends: [false; 2],
            pair,
            fine_to: match self.kind {
                EdgeKind::Circle { .. } | EdgeKind::Line => body.fine_to(),
                EdgeKind::Path => None,
            },
            turn: body.shape.turn(),
            ends: self.ends,
            tractions: Vec::new(),
        }
    }
}
