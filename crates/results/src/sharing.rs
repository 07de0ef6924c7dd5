//! How the contacts of a body share its load, such as the fasteners of a plate.
//!
//! ```text
//! share_k = F_k · e / Σ_j F_j · e,   e = Σ_j F_j / |Σ_j F_j|
//! ```
//!
//! F_k is the force of contact k on its first body; contacts in which that body is the second have no share.

use super::Results;

/// Sum of contact forces, as a part of the largest sum of their magnitudes in the history, below which they balance each other and share nothing.
const BALANCED: f64 = 1e-6;

/// A part of a load, with its estimated error where contact forces have one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LoadShare {
    /// The part.
    pub part: f64,
    /// Its estimated error.
    pub error: Option<f64>,
}

impl Results {
    /// The contacts whose first body is that of the edge with the index `edge`, as indices into [`edges`](Self::edges).
    pub fn contacts_beside(&self, edge: usize) -> Vec<usize> {
        let Some(own) = self.edges.get(edge) else {
            return Vec::new();
        };
        let edges = self.edges.iter().enumerate();
        let beside = edges.filter(|(_, other)| other.contact && other.body == own.body);
        beside.map(|(index, _)| index).collect()
    }

    /// The share of the contact with the index `edge` in the load of its first body at the end of `step`; `None` for the only contact of a body, for edges without
    /// contact, and where the forces balance each other, to rounding or within their errors.
    pub fn load_share(&self, edge: usize, step: usize) -> Option<LoadShare> {
        let beside = self.contacts_beside(edge);
        if beside.len() < 2 || !self.edges[edge].contact {
            return None;
        }
        let at = |own: usize, step: usize| &self.steps[step].edges[own];
        let force = |own: usize| at(own, step).resultant;
        let sum = [0, 1].map(|axis| beside.iter().map(|&own| force(own)[axis]).sum::<f64>());
        let size = |[x, y]: [f64; 2]| x.hypot(y);
        let total = size(sum);
        let each = |step: usize| {
            let sizes = beside.iter().map(|&own| size(at(own, step).resultant));
            sizes.sum::<f64>()
        };
        if total <= BALANCED * (0..self.steps.len()).map(each).fold(0.0, f64::max) {
            return None;
        }
        let [x, y] = force(edge);
        let part = (x * sum[0] + y * sum[1]) / (total * total);
        let errors = beside.iter().map(|&own| at(own, step).resultant_error());
        let together = errors.sum::<Option<f64>>();
        if together.is_some_and(|together| total <= together) {
            return None;
        }
        let own = at(edge, step).resultant_error();
        let error = own
            .zip(together)
            .map(|(own, together)| (own + part.abs() * together) / total);
        Some(LoadShare { part, error })
    }
}
