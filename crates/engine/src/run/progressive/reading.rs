//! Where a joint is read: its load at the pin, and its displacement between the pin and the far end of the plate.

use std::f64::consts::{FRAC_PI_2, PI};

use stickslip_contact::ContactPair;
use stickslip_fem_core::mesh::{Mesh, Point};
use stickslip_joint::{Gauge, Hole, Mark, Pull};
use stickslip_scene::schema::{Axis, Control};

use super::subject::Subject;
use crate::model::{Model, ModelBodyKind, ModelContact};
use crate::results::{BearingSource, ContactFrame};

/// Part of a clearance that is rounding.
const ROUNDING: f64 = 1e-9;

/// Where the joint is read.
pub(super) struct Reading {
    pub(super) gauge: Gauge,
    pub(super) hole: Hole,
}

impl Subject<'_> {
    /// Where the pin bears under the scene's loads, or without any against the drive; `None` if neither says.
    pub(super) fn frame(&self, half: bool) -> Option<ContactFrame> {
        if self.found.frame.bearing.is_some() {
            let frame = self.found.frame;
            let behind = frame.bearing.is_some_and(|at| at.abs() > FRAC_PI_2);
            return Some(ContactFrame {
                clockwise: half && behind,
                ..frame
            });
        }
        let Control::Displacement { axis, end, .. } = &self.asked.control else {
            return None;
        };
        let own = if self.followed.drives_body { -1.0 } else { 1.0 };
        let towards = own * end.signum();
        let bearing = match (axis, towards > 0.0) {
            (Axis::X, true) => 0.0,
            (Axis::X, false) => PI,
            (Axis::Y, _) => towards * FRAC_PI_2,
        };
        Some(ContactFrame {
            bearing: Some(bearing),
            found: BearingSource::Load,
            clockwise: half && bearing == PI,
        })
    }

    /// What is read along `direction`, in which the pin bears; `None` if no pin touches the hole.
    pub(super) fn reading(&self, model: &Model, direction: [f64; 2]) -> Option<Reading> {
        let centre = self.found.centre?;
        let own = self.found.body;
        let mesh = self.mesh(model)?;
        let touches = |pair: &ContactPair| pair.first == own || pair.second == own;
        let pair = (model.edges.iter())
            .filter(|edge| edge.geometry.body == own)
            .find_map(|edge| edge.pair)
            .or_else(|| model.pairs.iter().position(touches))?;
        let ContactPair { first, second, .. } = model.pairs[pair];
        let (pin, onto_own) = if first == own {
            (second, direction)
        } else {
            (first, direction.map(|component| -component))
        };
        let nodes = mesh.nodes();
        let arm = |node: &Point| [node[0] - centre[0], node[1] - centre[1]];
        let distance = |node: &Point| arm(node)[0].hypot(arm(node)[1]);
        let [x, y] = direction;
        let ahead = |node: &Point| arm(node)[0] * x + arm(node)[1] * y;
        let aside = |node: &Point| arm(node)[1] * x - arm(node)[0] * y;
        let largest = |value: &dyn Fn(&Point) -> f64| nodes.iter().map(value).fold(0.0, f64::max);
        let far = largest(&|node| -ahead(node));
        let sides = [1.0, -1.0].map(|sign| largest(&|node| sign * aside(node)));
        // A half has one side.
        let side_distance = if model.half {
            sides[0].max(sides[1])
        } else {
            sides[0].min(sides[1])
        };
        Some(Reading {
            gauge: Gauge {
                pull: Pull::Contact {
                    pair,
                    direction: onto_own,
                },
                multiple: if model.half { 2.0 } else { 1.0 },
                direction,
                first: pin_mark(model, pin, centre),
                second: Mark::Node {
                    body: own,
                    node: nearest(mesh, [centre[0] - far * x, centre[1] - far * y]),
                },
                // From where it starts, c a, the pin travels c (1 − a·e_b) to where a clearance c lets it touch.
                free_travel: {
                    let ModelContact {
                        clearance, start, ..
                    } = model.contacts[pair];
                    let free = clearance - start[0] * direction[0] - start[1] * direction[1];
                    if free > ROUNDING * clearance {
                        free
                    } else {
                        0.0
                    }
                },
            },
            hole: Hole {
                centre,
                radius: nodes.iter().map(distance).fold(f64::INFINITY, f64::min),
                bearing: direction,
                side_distance,
                end_distance: largest(&ahead),
            },
        })
    }
}

/// Unit vector at the angle `bearing` `[rad]`, exact along the axes.
pub(super) fn direction(bearing: f64) -> [f64; 2] {
    let exact = |part: f64| if part.abs() < 1e-15 { 0.0 } else { part };
    [exact(bearing.cos()), exact(bearing.sin())]
}

fn nearest(mesh: &Mesh, place: Point) -> usize {
    let distance = |node: &Point| (node[0] - place[0]).hypot(node[1] - place[1]);
    let nodes = mesh.nodes().iter().enumerate();
    nodes
        .min_by(|a, b| distance(a.1).total_cmp(&distance(b.1)))
        .map_or(0, |(node, _)| node)
}

/// The pin's centre.
fn pin_mark(model: &Model, pin: usize, centre: Point) -> Mark {
    match &model.bodies[pin].kind {
        ModelBodyKind::Elastic(body) => Mark::Node {
            body: pin,
            node: nearest(body.mesh(), centre),
        },
        // A rigid body does not turn, so any of its points moves as its centre does.
        ModelBodyKind::Rigid(_) => Mark::Node { body: pin, node: 0 },
    }
}
