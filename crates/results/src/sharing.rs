//! How the contacts of a body share its load, such as the fasteners of a plate.
//!
//! ```text
//! share_k = F_k · e / Σ_j F_j · e,   e = Σ_j F_j / |Σ_j F_j|
//! ```
//!
//! F_k is the force of contact k on the body, against that on the contact's first body where the body is the second.

use super::Results;

/// Sum of contact forces, as a part of the largest sum of their magnitudes in the history, below which they balance each other and share nothing.
const BALANCED: f64 = 1e-6;

/// A part of a load, with its estimated error where contact forces have one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LoadShare {
    /// The part `[1]`.
    pub part: f64,
    /// Its estimated error `[1]`.
    pub error: Option<f64>,
}

impl Results {
    /// The contacts of the body with the index `body`, which elastic bodies are on either side and rigid ones as the first, as indices into [`edges`](Self::edges).
    pub fn contacts_of(&self, body: usize) -> Vec<usize> {
        let edges = self.edges.iter().enumerate();
        let own = edges.filter(|(_, edge)| {
            let second = edge.second.as_ref().map(|second| second.body);
            edge.contact && (edge.body == body || second == Some(body))
        });
        own.map(|(index, _)| index).collect()
    }

    /// Whether the contacts of the body with the index `body` share a load: several, of which the body is always the same side, or whose forces have a sum in some step.
    pub fn shares_load(&self, body: usize) -> bool {
        let contacts = self.contacts_of(body);
        let firsts = contacts.iter().filter(|&&own| self.edges[own].body == body);
        let one_side = [0, contacts.len()].contains(&firsts.count());
        let mut steps = 0..self.steps.len();
        contacts.len() > 1
            && (one_side || steps.any(|step| self.share_of(body, contacts[0], step).is_some()))
    }

    /// The body whose load the contact with the index `edge` shares with others: its first one, otherwise its second one.
    pub fn shared_body(&self, edge: usize) -> Option<usize> {
        let own = self.edges.get(edge).filter(|own| own.contact)?;
        let second = own.second.as_ref().map(|second| second.body);
        let mut sides = [Some(own.body), second].into_iter().flatten();
        sides.find(|&body| self.shares_load(body))
    }

    /// The share of the contact with the index `edge` in the load of its [`shared_body`](Self::shared_body) at the end of `step`; `None` without one, and where the forces
    /// balance each other, to rounding or within their errors.
    pub fn load_share(&self, edge: usize, step: usize) -> Option<LoadShare> {
        self.share_of(self.shared_body(edge)?, edge, step)
    }

    /// Force of the contact with the index `edge` on the body with the index `body` at the end of `step` `[N]`.
    pub fn force_on(&self, body: usize, edge: usize, step: usize) -> [f64; 2] {
        let sign = if self.edges[edge].body == body {
            1.0
        } else {
            -1.0
        };
        let force = self.steps[step].edges[edge].resultant;
        force.map(|part| sign * part)
    }

    /// As [`load_share`](Self::load_share), in the load of the body with the index `body`.
    pub fn share_of(&self, body: usize, edge: usize, step: usize) -> Option<LoadShare> {
        let contacts = self.contacts_of(body);
        let sum = [0, 1].map(|axis| {
            let forces = contacts
                .iter()
                .map(|&own| self.force_on(body, own, step)[axis]);
            forces.sum::<f64>()
        });
        let size = |[x, y]: [f64; 2]| x.hypot(y);
        let total = size(sum);
        let each = |step: usize| {
            let sizes = contacts
                .iter()
                .map(|&own| size(self.force_on(body, own, step)));
            sizes.sum::<f64>()
        };
        if total <= BALANCED * (0..self.steps.len()).map(each).fold(0.0, f64::max) {
            return None;
        }
        let [x, y] = self.force_on(body, edge, step);
        let part = (x * sum[0] + y * sum[1]) / (total * total);
        let error = |own: usize| self.steps[step].edges[own].resultant_error();
        let together = contacts.iter().map(|&own| error(own)).sum::<Option<f64>>();
        if together.is_some_and(|together| total <= together) {
            return None;
        }
        let error = error(edge)
            .zip(together)
            .map(|(own, together)| (own + part.abs() * together) / total);
        Some(LoadShare { part, error })
    }
}
