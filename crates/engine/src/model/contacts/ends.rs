//! What lies at the ends of a contact between two open edges.
//!
//! A body whose corner presses on another that goes on has a pressure that grows like r^(λ−1), 0 < λ < 1, towards it (Dundurs & Lee 1972; 0.4555 for a bonded square
//! punch), so the largest pressure has no limit.

use std::f64::consts::{FRAC_PI_2, PI};

use stickslip_fem_core::mesh::Point;
use stickslip_scene::schema::SetRef;
use stickslip_scene::shape::Path;

use super::edge::EdgeNodes;
use crate::model::plan::{Placed, Plan};
use crate::model::{EdgeEnd, Meshes};

/// Angle by which an outline turns at least where it has a corner `[rad]`.
const TURN: f64 = PI / 18.0;
/// Angle of a wedge that sticks to a rigid body up to which stress at its corner is bounded, about 60° at ν = 0.3 (Williams 1952, one side held) `[rad]`.
const STICKING: f64 = PI / 3.0;
/// Part of the edge's length by which two places differ that are the same.
const SAME: f64 = 1e-6;

/// An open edge of a contact, as far as its ends go.
pub(super) struct Side<'a> {
    pub(super) placed: &'a Placed<'a, SetRef>,
    /// Its curve, where it stands.
    pub(super) path: &'a Path,
    /// Where its ends are along the first edge, ascending `[mm]`.
    pub(super) reach: [f64; 2],
    /// Whether its walk descends along the first edge.
    pub(super) is_reversed: bool,
}

/// What lies at the two ends of the nodes `upper` of the first edge.
pub(super) fn of(
    plan: &Plan<'_>,
    meshes: &Meshes,
    [first, second]: [Side<'_>; 2],
    upper: &EdgeNodes,
    has_friction: bool,
) -> [EdgeEnd; 2] {
    let same = SAME * first.path.length();
    let last = upper.parameter.len() - 1;
    [0, 1].map(|end| {
        let out = if end == 0 { -1.0 } else { 1.0 };
        let [own, other] = [&first, &second].map(|side| out * side.reach[end]);
        let inner = own.min(other);
        if out * upper.parameter[end * last] < inner - same {
            return EdgeEnd::GoesOn;
        }
        let angle = |side: &Side<'_>| side.angle(plan, meshes, end);
        let sides = [(&first, own, &second), (&second, other, &first)];
        // The angle of a body that ends there in a corner, and the least one from which on its pressure has no bound against the other.
        let corners = sides.map(|(side, at, against)| {
            let angle = (at <= inner + same).then(|| angle(side)).flatten();
            let corner = angle.filter(|angle| *angle < PI - TURN)?;
            let is_rigid = plan.is_rigid(against.placed.body);
            let is_held = side.is_held(plan, meshes, end);
            let least = match (is_rigid, has_friction) {
                // A wedge on a smooth rigid line is half of twice its angle.
                (true, false) => FRAC_PI_2 + TURN,
                (true, true) => STICKING,
                (false, _) => 0.0,
            };
            Some((corner, corner > least && !is_held))
        });
        match corners {
            [None, None] => EdgeEnd::GoesOn,
            [Some((_, true)), None] | [None, Some((_, true))] => EdgeEnd::Corner,
            [Some((one, _)), Some((other, _))] if has_friction && one + other > PI + TURN => {
                EdgeEnd::Corner
            }
            _ => EdgeEnd::Free,
        }
    })
}

impl Side<'_> {
    /// Whether a support of another edge holds the corner at the end `end`, as on a line of symmetry, so that it is none of the whole body.
    fn is_held(&self, plan: &Plan<'_>, meshes: &Meshes, end: usize) -> bool {
        let Some(mesh) = meshes.get(&self.placed.body) else {
            return false;
        };
        let Some(node) = self.node(meshes, end) else {
            return false;
        };
        let mut supports = plan.supports_of(self.placed.body);
        supports.any(|support| {
            let nodes = mesh.node_set(&support.on.set);
            nodes.is_ok_and(|nodes| nodes.contains(&node))
        })
    }

    /// The node of an elastic body at the end `end`.
    fn node(&self, meshes: &Meshes, end: usize) -> Option<usize> {
        let mesh = meshes.get(&self.placed.body)?;
        let path = mesh.edge_path(&self.placed.of.set).ok()?;
        let is_first = (end == 0) != self.is_reversed;
        let node = if is_first {
            path.nodes.first()
        } else {
            path.nodes.last()
        };
        node.copied()
    }

    /// The angle of the body at the end `end` of the reach `[rad]`.
    fn angle(&self, plan: &Plan<'_>, meshes: &Meshes, end: usize) -> Option<f64> {
        let is_first = (end == 0) != self.is_reversed;
        if !plan.is_rigid(self.placed.body) {
            let mesh = meshes.get(&self.placed.body)?;
            return Some(mesh.angle_at(self.node(meshes, end)?));
        }
        let body = &plan.bodies[self.placed.body];
        let edges = body.shape.edges();
        let others = edges.iter().filter(|edge| edge.name != self.placed.of.set);
        let paths = others.filter_map(|edge| Some(edge.curve.path()?.moved(body.centre)));
        let length = self.path.length();
        let (at, along) = if is_first {
            (0.0, self.path.tangent(0.0))
        } else {
            (length, self.path.tangent(length))
        };
        let place = self.path.at(at);
        let is_here =
            |point: Point| (point[0] - place[0]).hypot(point[1] - place[1]) < SAME * length;
        let mut turns = paths.filter_map(|other| {
            let meeting = if is_first { other.length() } else { 0.0 };
            let tangent = other.tangent(meeting);
            let pair = if is_first {
                [tangent, along]
            } else {
                [along, tangent]
            };
            is_here(other.at(meeting)).then(|| turn(pair))
        });
        // A rigid body whose outline is not known further on ends there.
        Some(PI - turns.next().unwrap_or(FRAC_PI_2))
    }
}

/// The angle from one direction to the next, to the left `[rad]`.
fn turn([before, after]: [Point; 2]) -> f64 {
    let cross = before[0] * after[1] - before[1] * after[0];
    cross.atan2(before[0] * after[0] + before[1] * after[1])
}
