//! Edges of a model.

use crate::results::{EdgeGeometry, EdgeRow};

/// An edge to report, with what its stresses need.
#[derive(Clone, Debug)]
pub struct ModelEdge {
    /// What does not change from step to step.
    pub geometry: EdgeGeometry,
    /// Mesh nodes along the edge, by ascending parameter.
    pub nodes: Vec<usize>,
    /// Position of each node among the body's contact points; empty for an edge without contact.
    pub local: Vec<usize>,
    /// Contact area of each node `[mm²]`.
    pub areas: Vec<f64>,
    /// Polynomial order of the edge.
    pub order: usize,
    /// Arc length per node along e_t, the normal turned by +90° `[mm]`.
    pub along: Vec<f64>,
    /// Unit normal `[1]` per node: e_r on a circle, otherwise that of the edge with a part along +y.
    pub normals: Vec<[f64; 2]>,
    /// Tractions (σ_nn, τ_nt) per node of a unit reaction there along x and along y `[1/mm²]`; empty where nothing holds it.
    pub reactions: Vec<[[f64; 2]; 2]>,
    /// Whether its first and its last node are held beside this edge too, so that reactions there are not its own alone.
    pub shared_ends: [bool; 2],
    /// Index of the contact pair.
    pub pair: Option<usize>,
    /// Up to where from the bearing point θ = 0 or x = 0 the mesh along it is fine `[rad or mm]`; `None` for all of it.
    pub fine_to: Option<f64>,
    /// By what its body is turned, from where angles of the fine part count `[rad]`.
    pub turn: f64,
    /// What lies at its first and its last node, if it touches another open edge.
    pub ends: [EdgeEnd; 2],
    /// Tractions of the loads on it: load case, and (σ_nn, τ_nt) `[MPa]` per node for a multiplier of one.
    pub tractions: Vec<(usize, Vec<[f64; 2]>)>,
}

impl ModelEdge {
    /// Whether a corner of one of the bodies presses on the other by the `rows` of its nodes, at the first end and at the last: within a cell of it, where the other body's edge
    /// ends.
    pub fn corners_that_press(&self, rows: &[EdgeRow]) -> [bool; 2] {
        let touches = |row: &EdgeRow| row.status.touches();
        let first = rows.iter().take(self.order + 1).any(touches);
        let last = rows.iter().rev().take(self.order + 1).any(touches);
        let is_corner = self.ends.map(|end| end == EdgeEnd::Corner);
        [is_corner[0] && first, is_corner[1] && last]
    }

    /// Puts at ends that are held beside this edge too what the line through the `tractions`, in any unit, of the next two nodes is there; of the three nodes between two
    /// others those of the middle one. Edges of one cell have no stresses.
    pub fn continue_to_shared_ends(&self, tractions: &mut [[f64; 2]]) {
        let (known, places) = (tractions.to_vec(), &self.geometry.parameter);
        let count = known.len();
        let least = 3 + usize::from(self.shared_ends == [true; 2]);
        for (is_shared, is_last) in self.shared_ends.into_iter().zip([false, true]) {
            if !is_shared || count < 3 {
                continue;
            }
            let at = |k: usize| if is_last { count - 1 - k } else { k };
            let [end, next, far] = [at(0), at(1), at(2)];
            let part = if count < least {
                0.0
            } else {
                (places[end] - places[next]) / (places[next] - places[far])
            };
            tractions[end] = [0, 1]
                .map(|axis| known[next][axis] + part * (known[next][axis] - known[far][axis]));
        }
    }

    /// Whether it belongs to the body with the index `body` and something holds it.
    pub fn is_held_on(&self, body: usize) -> bool {
        self.geometry.body == body && !self.reactions.is_empty()
    }
}

/// What lies at an end of a contact.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum EdgeEnd {
    /// Nothing that a reader must know: both bodies end there, or the edge is closed.
    #[default]
    Free,
    /// A body ends there in a corner, and the other goes on.
    Corner,
    /// Both bodies go on, and their edges cease to face each other.
    GoesOn,
}
