//! The largest stress of a whole edge.

use super::{Cusp, HeldSide, Peak, Side, cusp_peak, locate_end, smooth_peak};
use crate::state::Status;

/// Nodal values along a contact edge, n each, in the order of growing places along e_t.
#[derive(Clone, Copy, Debug)]
pub struct EdgeValues<'a> {
    /// Places `[length]`.
    pub places: &'a [f64],
    /// Length `[length]` after which the edge closes on itself, if it does.
    pub closed: Option<f64>,
    /// Stress σ_t along the edge `[stress]`, tension positive.
    pub stress: &'a [f64],
    /// Pressure `[stress]`.
    pub pressure: &'a [f64],
    /// Shear traction λ_t per area on the body along e_t `[stress]`.
    pub shear: &'a [f64],
    /// What friction can hold at most `[stress]`, zero without friction.
    pub bound: &'a [f64],
    /// Gap `[length]`, zero where nodes touch.
    pub gap: &'a [f64],
    /// Slip in the load step `[length]`.
    pub slip: &'a [f64],
    /// Statuses.
    pub status: &'a [Status],
    /// Whether the body is isotropic.
    pub isotropic: bool,
}

/// Nodes that are looked at on either side of an end.
const REACH: usize = 12;

/// Estimates the largest stress along an edge: of the cusps at all ends of contact and of stick ([`cusp_peak`]), of the smooth peaks between them ([`smooth_peak`]), and of
/// nodes beside ends that are not resolved: without, or with a single, sticking node between opposite slips. The error includes how much higher than the largest of these another one may be.
///
/// `None` with fewer than three nodes, or arrays of different length.
pub fn edge_peak(edge: &EdgeValues<'_>) -> Option<Peak> {
    let count = edge.places.len();
    if count < 3 || !edge.is_complete() {
        return None;
    }
    let all = edge.candidates();
    let higher = |best: Peak, next: Peak| if next.value > best.value { next } else { best };
    let best = all.iter().copied().reduce(higher)?;
    let upper = all.iter().map(|peak| peak.value + peak.error);
    Some(Peak {
        error: upper.fold(f64::NEG_INFINITY, f64::max) - best.value,
        ..best
    })
}

/// A node of a walk away from an end.
#[derive(Clone, Copy, Debug)]
struct Node {
    index: usize,
    /// Its place, on a closed edge without the jump at the start.
    place: f64,
}

/// A walk from a node in one direction.
#[derive(Clone, Copy, Debug)]
struct Walk {
    from: usize,
    forward: bool,
}

impl EdgeValues<'_> {
    /// Whether all arrays have one entry per node.
    fn is_complete(&self) -> bool {
        let values = [
            self.stress,
            self.pressure,
            self.shear,
            self.bound,
            self.gap,
            self.slip,
        ];
        let count = self.places.len();
        self.status.len() == count && values.iter().all(|values| values.len() == count)
    }

    /// Peaks of which the largest is that of the edge.
    fn candidates(&self) -> Vec<Peak> {
        let count = self.places.len();
        let last = if self.closed.is_some() {
            count
        } else {
            count - 1
        };
        let pairs = || (0..last).map(|k| [k, (k + 1) % count]);
        let ends: Vec<[Walk; 2]> = pairs().filter_map(|pair| self.end(pair)).collect();
        let cusps = ends.iter().filter_map(|&[held, free]| {
            let cusp = self.cusp(held, free);
            cusp.or_else(|| self.unresolved(held.from))
        });
        let sign = |k: usize| self.status[k].slip_sign() * self.bound[k];
        let turns = pairs().filter(|&[one, other]| sign(one) * sign(other) < 0.0);
        let turns = turns.flatten().filter_map(|node| self.unresolved(node));
        let smooth = self.between(&ends).into_iter().filter_map(|nodes| {
            let places: Vec<f64> = nodes.iter().map(|node| node.place).collect();
            let values: Vec<f64> = nodes.iter().map(|node| self.stress[node.index]).collect();
            smooth_peak(&places, &values)
        });
        smooth.chain(cusps).chain(turns).collect()
    }

    /// Walks to the held and the free side, if there is an end between the nodes `pair`.
    fn end(&self, pair: [usize; 2]) -> Option<[Walk; 2]> {
        let [backward, forward] = [
            Walk {
                from: pair[0],
                forward: false,
            },
            Walk {
                from: pair[1],
                forward: true,
            },
        ];
        // How firmly a node is held.
        let grade = |k: usize| match self.status[k] {
            Status::Open => 0,
            Status::Stick if self.bound[k] > 0.0 => 2,
            _ => 1,
        };
        match grade(pair[0]).cmp(&grade(pair[1])) {
            std::cmp::Ordering::Greater => Some([backward, forward]),
            std::cmp::Ordering::Less => Some([forward, backward]),
            std::cmp::Ordering::Equal => None,
        }
    }

    /// Nodes of a walk of at most `most`, places counted on from `origin`.
    fn walk(&self, walk: Walk, most: usize) -> impl Iterator<Item = Node> {
        let count = self.places.len();
        (0..most.min(count)).map_while(move |steps| {
            let (index, turns) = if walk.forward {
                let at = walk.from + steps;
                (at % count, (at / count) as f64)
            } else {
                let wraps = steps > walk.from;
                (
                    (walk.from + count - steps) % count,
                    if wraps { -1.0 } else { 0.0 },
                )
            };
            let place = self.places[index];
            match self.closed {
                Some(length) => Some(Node {
                    index,
                    place: place + turns * length,
                }),
                None => (turns == 0.0).then_some(Node { index, place }),
            }
        })
    }

    /// The first nodes of a walk that obey one law of shear: all open, sticking, or slipping one way.
    fn alike(&self, walk: Walk) -> Vec<Node> {
        let rubs = |k: usize| self.bound[k] > 0.0 || self.shear[k] != 0.0;
        let law = |k: usize| match self.status[k] {
            status if status.touches() && !rubs(k) => Status::SlipPositive,
            status => status,
        };
        let same = |node: &Node| law(node.index) == law(walk.from);
        self.walk(walk, REACH).take_while(same).collect()
    }

    /// Height of the cusp at the end between two walks.
    fn cusp(&self, held: Walk, free: Walk) -> Option<Peak> {
        let [held, mut free] = [self.alike(held), self.alike(free)];
        let (&first, &beyond) = (held.first()?, free.first()?);
        // On a closed edge both walks start beside the end, maybe on two sides of the place where it closes.
        if let Some(length) = self.closed {
            let turns = ((first.place - beyond.place) / length).round();
            for node in &mut free {
                node.place += turns * length;
            }
        }
        let open = self.status[beyond.index] == Status::Open;
        let sticks = self.status[first.index] == Status::Stick && self.bound[first.index] > 0.0;
        if !open && held.len() < 2 {
            return None;
        }
        let slips = -self.status[beyond.index].slip_sign();
        let excess = |k: usize| self.shear[k] - slips * self.bound[k];
        let pairs = |nodes: &[Node], value: &dyn Fn(usize) -> f64| -> Vec<[f64; 2]> {
            let pair = |node: &Node| [node.place, value(node.index)];
            nodes.iter().map(pair).collect()
        };
        let end = if open {
            let pressure = pairs(&held, &|k| self.pressure[k]);
            locate_end(&pressure, &pairs(&free, &|k| self.gap[k]))
        } else {
            locate_end(
                &pairs(&held, &excess),
                &pairs(&free, &|k| self.slip[k].abs()),
            )
        }?;
        let excess: Vec<f64> = held.iter().map(|node| excess(node.index)).collect();
        let [free, held] = [self.side(&free), self.side(&held)];
        let known = self.isotropic && !(open && sticks);
        cusp_peak(&Cusp {
            end,
            free: side(&free),
            held: known.then(|| HeldSide {
                side: side(&held),
                excess: &excess,
            }),
            open,
        })
    }

    /// Places, stresses and pressures of nodes.
    fn side(&self, nodes: &[Node]) -> [Vec<f64>; 3] {
        let of = |values: &[f64]| nodes.iter().map(|node| values[node.index]).collect();
        let places = nodes.iter().map(|node| node.place).collect();
        [places, of(self.stress), of(self.pressure)]
    }

    /// The value of a node beside an end that is not resolved, with twice the larger difference to its neighbours as error.
    fn unresolved(&self, node: usize) -> Option<Peak> {
        let neighbours = [true, false].map(|forward| {
            let next = self
                .walk(
                    Walk {
                        from: node,
                        forward,
                    },
                    2,
                )
                .nth(1);
            next.map(|next| (self.stress[next.index] - self.stress[node]).abs())
        });
        Some(Peak {
            value: self.stress[node],
            place: self.places[node],
            error: 2.0 * neighbours.into_iter().flatten().reduce(f64::max)?,
        })
    }

    /// The nodes between ends, each run in order.
    fn between(&self, ends: &[[Walk; 2]]) -> Vec<Vec<Node>> {
        let starts_run = |k: usize| {
            ends.iter()
                .flatten()
                .any(|walk| walk.forward && walk.from == k)
        };
        let count = self.places.len();
        let from = if self.closed.is_some() {
            (0..count).find(|&k| starts_run(k)).unwrap_or(0)
        } else {
            0
        };
        let mut runs: Vec<Vec<Node>> = Vec::new();
        for node in self.walk(
            Walk {
                from,
                forward: true,
            },
            count,
        ) {
            match runs.last_mut() {
                Some(run) if !starts_run(node.index) => run.push(node),
                _ => runs.push(vec![node]),
            }
        }
        runs
    }
}

fn side(values: &[Vec<f64>; 3]) -> Side<'_> {
    let [places, stress, pressure] = values;
    Side {
        places,
        stress,
        pressure,
    }
}
