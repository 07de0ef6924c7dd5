//! Whether the mesh resolves a contact.
//!
//! Contact that reaches over fewer than two element edges has 2p nodes or less, p being the order of the edge. The peak pressure of
//! a pin's small contact is then off by up to 80 % on linear and 65 % on quadratic elements (by 6 % with one node more), and contact
//! on a single node has a pressure in inverse proportion to the spacing, and no half-angle. Open edges have meshes of their own, and a second one that
//! is coarser than the contact puts it off as far.

use super::{EdgeGeometry, EdgeKind, EdgeResults};

/// Part of the largest pressure from which a run of touching nodes matters.
const CARRIES: f64 = 0.1;

impl EdgeGeometry {
    /// Number of nodes over two element edges, which a contact must touch to be resolved.
    pub fn nodes_to_resolve(&self) -> usize {
        let inner = self.corner.split(|&corner| corner).map(<[_]>::len);
        let order = 1 + inner.max().unwrap_or(0);
        2 * order + 1
    }

    /// Number of nodes of the second of two open edges that face the places from the node `first` to the node `last`.
    fn nodes_faced(&self, first: usize, last: usize) -> Option<usize> {
        let second = self
            .second
            .as_ref()
            .filter(|_| self.kind == EdgeKind::Path)?;
        let reach = self.parameter[first]..=self.parameter[last];
        Some(
            second
                .parameter
                .iter()
                .filter(|at| reach.contains(at))
                .count(),
        )
    }
}

impl EdgeResults {
    /// Number of nodes in the shortest run of touching nodes of the whole edge, among runs that carry a tenth of the largest pressure
    /// somewhere, or of the second of two open edges along it; `None` where nothing touches or the edge is no contact. `geometry` is the edge's own.
    pub fn fewest_contact_nodes(&self, geometry: &EdgeGeometry) -> Option<usize> {
        if !geometry.contact {
            return None;
        }
        let whole = self.whole(geometry);
        let count = whole.len();
        let largest = whole.iter().copied().flatten().fold(0.0, f64::max);
        // A run across the place where a closed walk starts is counted from an open node before it.
        let start = match geometry.closed() {
            Some(_) => whole.iter().position(Option::is_none).unwrap_or(0),
            None => 0,
        };
        let walk: Vec<(usize, Option<f64>)> = (0..count)
            .map(|k| (start + k) % count)
            .map(|k| (k, whole[k]))
            .collect();
        let runs = walk.split(|(_, pressure)| pressure.is_none());
        let carries = |run: &&[(usize, Option<f64>)]| {
            let mut pressures = run.iter().filter_map(|(_, pressure)| *pressure);
            pressures.any(|pressure| pressure >= CARRIES * largest)
        };
        let nodes = |run: &[(usize, Option<f64>)]| {
            let (&[(first, _), ..], &[.., (last, _)]) = (run, run) else {
                return None;
            };
            let faced = geometry.nodes_faced(first, last);
            Some(faced.map_or(run.len(), |faced| faced.min(run.len())))
        };
        runs.filter(carries).filter_map(nodes).min()
    }

    /// Whether each part of the contact touches two element edges at least; `None` where nothing touches.
    pub fn is_resolved(&self, geometry: &EdgeGeometry) -> Option<bool> {
        let nodes = self.fewest_contact_nodes(geometry)?;
        Some(nodes >= geometry.nodes_to_resolve())
    }

    /// Number of nodes around the largest pressure of an open edge at which it is more than half as large, or of the second edge along these; `None` of other edges and
    /// without pressure.
    pub fn nodes_of_peak(&self, geometry: &EdgeGeometry) -> Option<usize> {
        if geometry.kind != EdgeKind::Path {
            return None;
        }
        let pressures: Vec<f64> = self.rows.iter().map(|row| row.pressure).collect();
        let largest =
            (0..pressures.len()).max_by(|&a, &b| pressures[a].total_cmp(&pressures[b]))?;
        let is_high = |k: &&f64| **k > 0.5 * pressures[largest];
        let before = pressures[..largest]
            .iter()
            .rev()
            .take_while(is_high)
            .count();
        let after = pressures[largest..].iter().take_while(is_high).count();
        let last = (largest + after).checked_sub(1).filter(|_| after > 0)?;
        let own = before + after;
        let faced = geometry.nodes_faced(largest - before, last);
        // A single node faces one at least, wherever that stands.
        Some(faced.map_or(own, |faced| faced.clamp(1, own)))
    }

    /// Whether the largest pressure of an open edge rests on less than two element edges, so that nothing is known of its error.
    pub fn has_sharp_peak(&self, geometry: &EdgeGeometry) -> bool {
        let nodes = self.nodes_of_peak(geometry);
        nodes.is_some_and(|nodes| nodes < geometry.nodes_to_resolve())
    }

    /// Pressure of each node of the whole edge in walk order, `None` at open ones; of a half the mirror image comes first.
    fn whole(&self, geometry: &EdgeGeometry) -> Vec<Option<f64>> {
        let own: Vec<Option<f64>> = (self.rows.iter())
            .map(|row| row.status.touches().then_some(row.pressure))
            .collect();
        if !geometry.half {
            return own;
        }
        // A node on the line of symmetry is its own image.
        let on_axis = |k: usize| {
            let place = geometry.parameter[k];
            place == 0.0
                || geometry
                    .closed()
                    .is_some_and(|length| place >= 0.5 * length * (1.0 - 1e-9))
        };
        let images = (0..own.len()).rev().filter(|&k| !on_axis(k));
        images.map(|k| own[k]).chain(own.iter().copied()).collect()
    }
}

#[cfg(test)]
mod tests {
    use stickslip_contact::Status;

    use super::super::{ContactFrame, EdgeKind, EdgeRow};
    use super::*;

    /// An edge of `nodes` corners.
    fn edge(half: bool, closed: bool, nodes: usize) -> EdgeGeometry {
        let last = (nodes - 1) as f64;
        let parameter = (0..nodes).map(|k| {
            let part = k as f64 / last;
            if half {
                part * std::f64::consts::PI
            } else {
                part * 6.0 - 3.0
            }
        });
        EdgeGeometry {
            name: String::new(),
            contact: true,
            body: 0,
            kind: if closed {
                EdgeKind::Circle {
                    centre: [0.0; 2],
                    radius: 1.0,
                }
            } else {
                EdgeKind::Line
            },
            parameter: parameter.collect(),
            corner: vec![true; nodes],
            half,
            clearance: None,
            bearing_area: None,
            law: String::new(),
            frame: ContactFrame::NONE,
            second: None,
        }
    }

    fn fewest(half: bool, closed: bool, pressures: &[f64]) -> Option<usize> {
        let row = |&pressure: &f64| EdgeRow {
            pressure,
            shear: 0.0,
            gap: 0.0,
            slip: 0.0,
            status: if pressure > 0.0 {
                Status::Stick
            } else {
                Status::Open
            },
            sigma_normal: 0.0,
            sigma_tangential: 0.0,
            tau: 0.0,
        };
        let results = EdgeResults {
            rows: pressures.iter().map(row).collect(),
            ..EdgeResults::default()
        };
        results.fewest_contact_nodes(&edge(half, closed, pressures.len()))
    }

    #[test]
    fn runs_are_those_of_the_whole_edge() {
        assert_eq!(fewest(false, false, &[0.0; 5]), None);
        assert_eq!(fewest(false, false, &[1.0, 0.0, 2.0, 2.0, 0.0]), Some(1));
        assert_eq!(fewest(false, true, &[1.0, 0.0, 2.0, 2.0, 1.0]), Some(4));
        assert_eq!(fewest(true, true, &[1.0, 0.5, 0.0, 0.0, 0.0]), Some(3));
        assert_eq!(fewest(true, true, &[0.0, 0.0, 0.0, 1.0, 1.0]), Some(3));
        assert_eq!(fewest(true, true, &[1.0, 1.0, 1.0]), Some(4));
        // A touch of next to nothing beside a wide contact.
        assert_eq!(fewest(false, false, &[0.01, 0.0, 2.0, 2.0, 1.0]), Some(3));
    }

    #[test]
    fn two_element_edges_have_2p_and_one_nodes() {
        for (order, nodes) in [(1, 3), (2, 5), (3, 7), (8, 17)] {
            let mut geometry = edge(false, false, 5 * order + 1);
            let corners = geometry.corner.iter_mut().enumerate();
            corners.for_each(|(k, corner)| *corner = k % order == 0);
            assert_eq!(geometry.nodes_to_resolve(), nodes, "order {order}");
        }
    }
}
