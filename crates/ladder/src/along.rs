//! What is left of tractions and stresses at the nodes of edges.
//!
//! ```text
//! error(θ) = k max max(|v_h − v_2h|, r |v_2h − v_4h|)      over the nodes no farther from θ than those of 2h are apart
//! ```
//!
//! Values of a coarser model are those of cubic polynomials between nodes of one status, and linear elsewhere. To that comes what increments of load steps leave,
//! and what deformed gaps may change.

use super::division::Spaced;
use super::numbers::Numbers;
use stickslip_engine::results::{EdgeGeometry, Nodes, RowErrors, Stated, Values, joined, values};

/// k of the module's equation, of pressure, shear and σ_t, with graded nodes and with others.
const DIVISION: [[f64; 3]; 2] = [[1.2, 1.2, 1.6], [2.5; 3]];
/// Changes vanish by chance, and most of all where points stick; so much of the largest error along an edge does not.
const LEAST: f64 = 0.03;
/// r of the module's equation, with graded nodes and with others.
const RATE: [f64; 2] = [0.25, 0.5];

/// Errors at the nodes of edges, per step and edge.
#[derive(Clone, Default)]
pub(super) struct Along {
    /// Nodes per step and edge.
    nodes: Vec<Vec<Nodes>>,
    steps: Vec<Vec<Vec<Values>>>,
}

impl Along {
    /// What the division of the last of `levels` leaves; empty where there is one only.
    pub(super) fn of_division(levels: &[&Numbers], spaced: Spaced) -> Self {
        let kind = usize::from(!spaced.are_graded());
        let [.., coarse, fine] = levels else {
            return Self::default();
        };
        let last = Self::between(fine, coarse);
        let sizes = match levels {
            [.., coarser, coarse, _] => {
                let before = Self::between(coarse, coarser).at(&nodes(fine));
                last.joined(&before, |last, before| last.max(RATE[kind] * before))
            }
            _ => last,
        };
        sizes.widened(coarse).times_each(DIVISION[kind])
    }

    /// The errors of steps that were `halved`; of the others beside those `before`.
    pub(super) fn beside(mut self, before: &Self, halved: &[bool]) -> Self {
        let before = before.at(&self.nodes);
        let steps = self.steps.iter_mut().zip(before.steps).zip(halved);
        for ((own, before), _) in steps.filter(|(_, halved)| !**halved) {
            *own = joined_edges(std::mem::take(own), &before, |own, before| own + before);
        }
        self
    }

    /// What steps that are not `halved` leave in those after them: at most their own errors, and at most those after them; `before` is what they left before.
    pub(super) fn kept(&self, before: &Self, halved: &[bool]) -> Self {
        let before = before.at(&self.nodes);
        let steps = self.nodes.iter().enumerate().map(|(step, nodes)| {
            let earlier = (0..step).filter(|&other| !halved[other]);
            let left = earlier.map(|other| {
                let other = moved(&self.steps[other], &self.nodes[other], nodes);
                joined_edges(other, &self.steps[step], f64::min)
            });
            let left = left.reduce(|one, other| joined_edges(one, &other, f64::max));
            let before = before.steps.get(step);
            match (left, before) {
                (Some(left), Some(before)) if halved[step] => joined_edges(left, before, f64::max),
                (Some(left), None) if halved[step] => left,
                (Some(_), Some(before)) => before.clone(),
                _ => nodes
                    .iter()
                    .map(|own| vec![[0.0; 3]; own.parameter.len()])
                    .collect(),
            }
        });
        Self {
            steps: steps.collect(),
            nodes: self.nodes.clone(),
        }
    }

    /// At every node the largest error no farther away than contact grows in an increment of the load step or of one before it, of which there are `counts`; `of` are the numbers
    /// at the same nodes. Each increment leaves a kink in friction, which stays, and those of half as many may cross there.
    pub(super) fn spread(self, of: &Numbers, counts: &[f64]) -> Self {
        self.over(|step, edge| {
            let growth = (0..=step).map(|step| touching(of, [step, edge]) / counts[step]);
            let growth = growth.fold(0.0, f64::max);
            move |_| growth
        })
    }

    /// The differences of two models at the nodes of the first.
    pub(super) fn between(fine: &Numbers, coarse: &Numbers) -> Self {
        let (nodes, other) = (nodes(fine), nodes(coarse));
        let steps = fine.steps.iter().zip(&coarse.steps).enumerate();
        let steps = steps.map(|(step, (edges, coarser))| {
            let edges = edges.iter().zip(coarser).enumerate();
            edges
                .map(|(edge, (own, coarser))| {
                    let rows = own.rows.iter().zip(&nodes[step][edge].parameter);
                    rows.map(|(row, &at)| {
                        let there = other[step][edge].interpolated(&coarser.rows, at);
                        joined(values(row), there, |own, there| (own - there).abs())
                    })
                    .collect()
                })
                .collect()
        });
        Self {
            steps: steps.collect(),
            nodes,
        }
    }

    /// All errors `factor` times as large.
    pub(super) fn times(self, factor: f64) -> Self {
        self.times_each([factor; 3])
    }

    fn times_each(mut self, factors: [f64; 3]) -> Self {
        let rows = self.steps.iter_mut().flatten().flatten();
        rows.for_each(|row| *row = joined(*row, factors, |error, factor| factor * error));
        self
    }

    /// The sum with errors at other nodes; those that are empty add nothing.
    pub(super) fn and(&self, other: &Self) -> Self {
        let other = other.at(&self.nodes);
        self.joined(&other, |own, other| own + other)
    }

    /// The larger ones of these and of errors at other nodes, which may be empty.
    pub(super) fn or_larger(&self, other: &Self) -> Self {
        self.joined(&other.at(&self.nodes), f64::max)
    }

    /// Errors of at least [`LEAST`] of the largest along the edge, of tractions where there is contact; `of` are the numbers at the same nodes.
    pub(super) fn floored(mut self, of: &Numbers) -> Self {
        let edges = self.steps.iter_mut().zip(&of.steps);
        for (errors, edge) in edges.flat_map(|(step, edges)| step.iter_mut().zip(edges)) {
            let largest = errors.iter().copied();
            let largest = largest.fold([0.0; 3], |most, own| joined(most, own, f64::max));
            for (own, row) in errors.iter_mut().zip(&edge.rows) {
                let touches = f64::from(u8::from(row.status.touches()));
                let least = joined(largest, [touches, touches, 1.0], |most, part| {
                    LEAST * part * most
                });
                *own = joined(*own, least, f64::max);
            }
        }
        self
    }

    /// The errors of every step and edge, at all nodes of the edges `geometries`.
    pub(super) fn into_steps(self, geometries: &[EdgeGeometry]) -> Vec<Vec<Vec<RowErrors>>> {
        let all: Vec<Nodes> = geometries.iter().map(Nodes::of).collect();
        let all = vec![all; self.steps.len()];
        let named = |[pressure, shear, sigma_tangential]: Values| RowErrors {
            pressure,
            shear,
            sigma_tangential,
        };
        let edge = |errors: Vec<Values>| errors.into_iter().map(named).collect();
        let step = |edges: Vec<Vec<Values>>| edges.into_iter().map(edge).collect();
        self.at(&all).steps.into_iter().map(step).collect()
    }

    /// The larger ones of the neighbours of `nodes`.
    fn at(&self, nodes: &[Vec<Nodes>]) -> Self {
        if self.nodes == nodes {
            return self.clone();
        }
        let all = self.steps.iter().zip(&self.nodes).zip(nodes);
        Self {
            steps: all
                .map(|((step, own), nodes)| moved(step, own, nodes))
                .collect(),
            nodes: nodes.to_vec(),
        }
    }

    /// Errors at the same nodes; the second ones may be empty.
    fn joined(&self, other: &Self, join: impl Fn(f64, f64) -> f64) -> Self {
        let mut all = self.clone();
        for (own, other) in all.steps.iter_mut().zip(&other.steps) {
            *own = joined_edges(std::mem::take(own), other, &join);
        }
        all
    }

    /// At every node the largest error no farther away than nodes of `coarse` are apart there.
    fn widened(self, coarse: &Numbers) -> Self {
        let coarse = nodes(coarse);
        self.over(|step, edge| {
            let coarse = &coarse[step][edge];
            |at| coarse.spacing(at)
        })
    }

    /// At every node the largest error no farther away than the `reach` of a step and an edge, at a place.
    fn over<R: Fn(f64) -> f64>(mut self, reach: impl Fn(usize, usize) -> R) -> Self {
        for (step, (edges, nodes)) in self.steps.iter_mut().zip(&self.nodes).enumerate() {
            for (edge, (errors, own)) in edges.iter_mut().zip(nodes).enumerate() {
                let reach = reach(step, edge);
                let at = own.parameter.iter().enumerate();
                *errors = at
                    .map(|(k, &at)| own.largest_near(errors, k, reach(at)))
                    .collect();
            }
        }
        self
    }
}

/// Errors of the edges of a step at other nodes: the larger ones of their neighbours.
fn moved(errors: &[Vec<Values>], from: &[Nodes], to: &[Nodes]) -> Vec<Vec<Values>> {
    let edges = errors.iter().zip(from).zip(to);
    edges
        .map(|((errors, own), nodes)| {
            let largest = |&at: &f64| {
                let [from, to] = own.around(at);
                joined(errors[from], errors[to], f64::max)
            };
            nodes.parameter.iter().map(largest).collect()
        })
        .collect()
}

/// Errors of the edges of a step, joined with others at the same nodes.
fn joined_edges(
    mut one: Vec<Vec<Values>>,
    other: &[Vec<Values>],
    join: impl Fn(f64, f64) -> f64,
) -> Vec<Vec<Values>> {
    let pairs = one.iter_mut().zip(other);
    for (own, other) in pairs.flat_map(|(edge, other)| edge.iter_mut().zip(other)) {
        *own = joined(*own, *other, &join);
    }
    one
}

/// How far contact reaches on an edge in a step: half of it where its extent is known, else from its first node to its last.
fn touching(of: &Numbers, [step, edge]: [usize; 2]) -> f64 {
    let (results, geometry) = (&of.steps[step][edge], &of.own[step][edge]);
    if let Some(extent) = Stated::ContactExtent.value(results) {
        return extent;
    }
    let rows = results.rows.iter().zip(&geometry.parameter);
    let mut places = rows
        .filter(|(row, _)| row.status.touches())
        .map(|(_, at)| *at);
    let first = places.next();
    first.map_or(0.0, |first| places.next_back().unwrap_or(first) - first)
}

/// The nodes of every step and edge.
fn nodes(of: &Numbers) -> Vec<Vec<Nodes>> {
    let step = |edges: &Vec<EdgeGeometry>| edges.iter().map(Nodes::of).collect();
    of.own.iter().map(step).collect()
}
