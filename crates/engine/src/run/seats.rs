//! Which places of two circles face each other under load, and how far these are from the nodes that are paired.
//!
//! Contact with deformed gaps takes displacements of the second edge at the place that is closest to a node of the first one. It follows them from the paired node by their derivative, so the
//! pair must stand closer than displacements bend: beside an end of contact, where they have a root, closer than nodes are to each other. A pin moves along its hole by as much as its clearance
//! and by slip. So nodes of the second circle are put where those of the first face it: in the step with the largest contact force, and of bodies by series in each step for itself
//! ([`Seated`](super::Seated)).

use std::f64::consts::TAU;

use stickslip_contact::deformed::is_free_to_turn;

use super::solved::Solved;
use crate::model::{Model, ModelContact, Seat};
use crate::results::{ContactFinding, EdgeGeometry, EdgeKind, Finding, Quantity};

/// Part of the distance of nodes beyond which pairs are too far apart.
const APART: f64 = 0.5;

/// Two circles in a load step.
#[derive(Debug)]
pub struct Faced {
    /// Angles of the contact points on the first circle `[rad]`, those that face them on the second one, and those of its nodes.
    first: Vec<f64>,
    facing: Vec<f64>,
    paired: Vec<f64>,
    closed: bool,
}

impl Faced {
    /// The circles of the pair with the index `pair` and the edge `geometry` in the load step with the index `step`; `None` for other contacts.
    pub fn of(
        model: &Model,
        solved: &Solved,
        step: usize,
        (pair, geometry): (usize, &EdgeGeometry),
    ) -> Option<Self> {
        let EdgeKind::Circle { centre, radius } = geometry.kind else {
            return None;
        };
        // Displacements of a rigid body bend nowhere.
        model.bodies[model.pairs[pair].second].elastic()?;
        let own = solved.seated(step).map(|seated| &seated.facings);
        let edges = own.unwrap_or(&model.facings).get(pair);
        let state = &solved.records[step].state;
        let first: Vec<f64> = match edges {
            Some(edges) => {
                let angle = |([x, y], node): (&[f64; 2], &f64)| {
                    node + apart((y - centre[1]).atan2(x - centre[0]), *node)
                };
                edges
                    .first
                    .iter()
                    .zip(&geometry.parameter)
                    .map(angle)
                    .collect()
            }
            None => geometry.parameter.clone(),
        };
        let paired = edges.map_or_else(|| first.clone(), |edges| edges.second.places().to_vec());
        let first_point = solved.interface.contacts().pair_points(pair).start;
        let ModelContact {
            clearance, start, ..
        } = model.contacts[pair];
        let moved = |k: usize| state.tangential_displacement(first_point + k);
        let bodies = [&model.pairs[pair].first, &model.pairs[pair].second];
        let turns = bodies.map(|&body| is_free_to_turn(solved.operators[body].interface()));
        // A circle that turns about its centre faces what it faced.
        let turn = if turns.contains(&true) {
            let points = model.pairs[pair].points.iter().enumerate();
            let sums = points.fold([0.0; 2], |[sum, whole], (k, point)| {
                [sum + point.area * moved(k), whole + point.area]
            });
            sums[0] / sums[1]
        } else {
            0.0
        };
        let facing = |(k, angle): (usize, &f64)| {
            let (sine, cosine) = angle.sin_cos();
            // From where the second circle starts the first moves along it.
            let there = (radius * sine - start[1]).atan2(radius * cosine - start[0]);
            angle + apart(there, *angle) + (moved(k) - turn) / (radius - clearance)
        };
        Some(Self {
            facing: first.iter().enumerate().map(facing).collect(),
            first,
            paired,
            closed: !geometry.half,
        })
    }

    /// Angle `[rad]` from the node that is paired with the point `k` of the first circle to the place that faces it.
    fn travel(&self, k: usize) -> f64 {
        apart(self.facing[k], self.paired[k])
    }

    /// The largest angle from a node to the place that faces its pair where contact ends, and the distance of nodes there `[rad]`, if it is more than a part of that; `rows` are
    /// the points that are nodes, and `touches` says which of them touch.
    pub fn apart(&self, rows: &[usize], touches: impl Fn(usize) -> bool) -> Option<[f64; 2]> {
        let count = rows.len();
        let last = if self.closed { count } else { count - 1 };
        let ends = (0..last).map(|k| [k, (k + 1) % count]);
        let ends = ends.filter(|&[from, to]| touches(from) != touches(to));
        let apart = ends.filter_map(|[from, to]| {
            let [from, to] = [rows[from], rows[to]];
            let width = apart(self.first[to], self.first[from]).abs();
            let travel = self.travel(from).abs().max(self.travel(to).abs());
            (travel > APART * width).then_some([travel, width])
        });
        apart.max_by(|one, other| (one[0] / one[1]).total_cmp(&(other[0] / other[1])))
    }

    fn seat(&self) -> Seat {
        Seat::new(&self.first, |k| self.facing[k], self.closed)
    }
}

/// The angle from `from` to `to` on the shorter way.
fn apart(to: f64, from: f64) -> f64 {
    let apart = to - from;
    apart - TAU * (apart / TAU).round()
}

/// How the second bodies of contacts sit in the step with the largest contact force, of those that can be seated: bodies by series, and half ones of elements, that touch along one edge alone.
pub fn seats(model: &Model, solved: &Solved) -> Vec<Option<Seat>> {
    let largest = |pair: usize| {
        let force = |step: &usize| solved.records[*step].audit.pairs[pair].normal;
        let steps = 0..solved.records.len();
        steps.max_by(|one, other| force(one).total_cmp(&force(other)))
    };
    let seat = |pair: usize| seat(model, solved, largest(pair)?, pair);
    (0..model.pairs.len()).map(seat).collect()
}

/// The same in every load step, of bodies by series; those that touch nothing in a step sit as in `otherwise`.
pub fn of_steps(
    model: &Model,
    solved: &Solved,
    otherwise: &[Option<Seat>],
) -> Vec<Vec<Option<Seat>>> {
    let of_step = |step: usize| {
        let seat = |(pair, otherwise): (usize, &Option<Seat>)| {
            let is_series = model.bodies[model.pairs[pair].second].series.is_some();
            let bears = solved.records[step].audit.pairs[pair].normal > 0.0;
            if is_series && bears {
                seat(model, solved, step, pair)
            } else {
                otherwise.clone()
            }
        };
        otherwise.iter().enumerate().map(seat).collect()
    };
    (0..solved.records.len()).map(of_step).collect()
}

fn seat(model: &Model, solved: &Solved, step: usize, pair: usize) -> Option<Seat> {
    let own = &model.pairs[pair];
    let touches = |body| {
        (model.pairs.iter()).filter(move |other| other.first == body || other.second == body)
    };
    let is_series = model.bodies[own.second].series.is_some();
    if touches(own.second).count() > 1 || !(is_series || model.half) {
        return None;
    }
    let geometry = &model.edge_of(pair)?.geometry;
    Some(Faced::of(model, solved, step, (pair, geometry))?.seat())
}

/// The same of those whose nodes are paired too far apart on the deformed geometry.
pub fn wanted(model: &Model, solved: &Solved) -> Vec<Option<Seat>> {
    let mut seats = seats(model, solved);
    for (pair, seat) in seats.iter_mut().enumerate() {
        if doubtful(model, solved, pair).is_empty() {
            *seat = None;
        }
    }
    seats
}

/// What a reader must know of contacts whose nodes are paired too far from what they face.
pub(super) fn findings(model: &Model, solved: &Solved) -> Vec<Finding> {
    let finding = |pair: usize| {
        let steps = doubtful(model, solved, pair);
        let worst = steps.iter().map(|(_, apart)| *apart);
        let ratio = |[travel, width]: [f64; 2]| travel / width;
        let [travel, spacing] = worst.max_by(|one, other| ratio(*one).total_cmp(&ratio(*other)))?;
        let found = ContactFinding::PairsApart {
            steps: steps.iter().map(|(step, _)| *step).collect(),
            apart: Quantity::Angle(travel),
            spacing: Quantity::Angle(spacing),
        };
        Some(Finding::about(&model.pairs[pair].name, found))
    };
    (0..model.pairs.len()).filter_map(finding).collect()
}

/// The load steps, counted from 1, in which nodes of `pair` are paired too far apart, with how far and the distance of nodes.
fn doubtful(model: &Model, solved: &Solved, pair: usize) -> Vec<(usize, [f64; 2])> {
    let Some(edge) = model.edge_of(pair).filter(|_| !model.facings.is_empty()) else {
        return Vec::new();
    };
    let points = solved.interface.contacts().pair_points(pair);
    let rows: Vec<usize> = (0..points.len()).collect();
    let steps = solved.records.iter().enumerate();
    steps
        .filter_map(|(step, record)| {
            let faced = Faced::of(model, solved, step, (pair, &edge.geometry))?;
            let touches = |k: usize| record.state.status[points.start + k].touches();
            Some((step + 1, faced.apart(&rows, touches)?))
        })
        .collect()
}
