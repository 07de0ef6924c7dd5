//! Sets of nodes that loads act on and that supports hold, by which displacements and reactions are reported.

use std::collections::BTreeMap;

use stickslip_fem_core::element::edge_rule;
use stickslip_fem_core::load::edge_load;
use stickslip_fem_core::mesh::{MeshError, Point};
use stickslip_scene::schema::{LoadKind, SetRef, SpringSupport};

use super::plan::{Placed, Plan};
use super::springs;
use super::{ModelBody, ModelBodyKind, ModelError};
use crate::results::{LoadedSet, SetKind};

/// A set of the model with what its displacement or its reaction needs.
#[derive(Clone, Debug)]
pub struct ModelSet {
    /// What it is.
    pub set: LoadedSet,
    /// How its numbers are found.
    pub measure: Measure,
}

impl ModelSet {
    /// Whether nodes of a mesh take its reaction.
    pub fn is_held_at_nodes(&self) -> bool {
        let Measure::Held { nodes, .. } = &self.measure else {
            return false;
        };
        nodes.is_some()
    }
}

/// How the force on a set and its displacement are found.
#[derive(Clone, Debug)]
pub enum Measure {
    /// Of a load.
    Load {
        /// Index of its load case.
        case: usize,
        /// Force of a multiplier of one `[N]`.
        force: f64,
        /// Where displacements are taken, with weights `[1]` along x and y whose sum along the load is one.
        mean: Mean,
    },
    /// Of springs: their force follows from the mean displacement.
    Springs {
        /// Nodes with the weights `[1]` of their displacements along x and y, whose sum along the springs is one.
        weights: Vec<(usize, [f64; 2])>,
        /// Stiffness of all of them together `[N/mm]`.
        stiffness: f64,
    },
    /// Of what holds it: the displacement is given.
    Held {
        /// The nodes that are held, each with what its reaction is multiplied with: its part of `along`. `None` for all of a body that is held as a
        /// whole: by its area, a rigid one or one by series.
        nodes: Option<NodeWeights>,
        /// What the resultant is multiplied with `[1]`: the direction, of a half model by what the other half takes too.
        along: [f64; 2],
        /// Given displacement along it `[mm]`.
        displacement: f64,
    },
}

/// A weighted mean of displacements.
#[derive(Clone, Debug)]
pub enum Mean {
    /// Over nodes of the mesh, with weights `[1]` along x and y.
    Nodes(Vec<(usize, [f64; 2])>),
    /// Over places `[mm]` of a body by series, which knows its displacement between nodes.
    Places(Vec<(Point, [f64; 2])>),
}

impl Mean {
    fn weights(&self) -> Vec<[f64; 2]> {
        match self {
            Self::Nodes(nodes) => nodes.iter().map(|own| own.1).collect(),
            Self::Places(places) => places.iter().map(|own| own.1).collect(),
        }
    }
}

/// All sets of `plan`, loads first; polar tractions and temperatures have no direction in which a displacement could be counted.
pub(super) fn all(
    plan: &Plan<'_>,
    bodies: &[ModelBody],
    half: bool,
) -> Result<Vec<ModelSet>, ModelError> {
    let mut sets = Vec::new();
    for (case, load) in plan.loads.iter().enumerate() {
        let (on, kind) = match &load.of.kind {
            LoadKind::Force { on, direction, .. } | LoadKind::Bearing { on, direction, .. } => {
                let direction = *direction;
                (on, SetKind::Force { direction })
            }
            LoadKind::Pressure { on, .. } => (on, SetKind::Pressure),
            LoadKind::PolarTraction { .. } | LoadKind::Temperature { .. } => continue,
        };
        let body = &bodies[load.body];
        let mesh_error = |cause| ModelError::Mesh {
            body: body.name.clone(),
            cause,
        };
        let (force, nodes) = weights(body, case, on, kind, half).map_err(mesh_error)?;
        let is_even = !matches!(load.of.kind, LoadKind::Bearing { .. });
        let places = is_even.then(|| places(body, on, kind)).flatten();
        let reach = reach(body, nodes.iter().map(|(node, _)| *node));
        let mean = places.map_or(Mean::Nodes(nodes), Mean::Places);
        let along = match kind {
            SetKind::Force { direction } | SetKind::Held { direction } => direction,
            SetKind::Pressure => {
                (mean.weights().iter()).fold([0.0; 2], |[x, y], own| [x + own[0], y + own[1]])
            }
        };
        sets.push(ModelSet {
            set: LoadedSet {
                name: load.of.name.clone(),
                body: load.body,
                on: on.to_string(),
                kind,
                along,
                reach,
            },
            measure: Measure::Load { case, force, mean },
        });
    }
    let context = (plan, bodies, half);
    for support in &plan.supports {
        let (on, displacement) = (&support.of.on, support.of.displacement);
        for direction in support.of.hold.directions() {
            sets.push(held(context, support.body, on, direction, displacement)?);
        }
    }
    for placed in &plan.springs {
        for direction in placed.of.hold.directions() {
            sets.extend(sprung(&bodies[placed.body], placed, direction)?);
        }
    }
    for platen in &plan.platens {
        for direction in platen.of.free.others().directions() {
            sets.push(held(context, platen.body, &platen.of.on, direction, 0.0)?);
        }
    }
    share_nodes(plan, half, &mut sets);
    Ok(sets)
}

/// Divides the reactions at nodes that several sets hold, or one in several directions, among them: the least forces along the
/// directions whose sum is the reaction.
fn share_nodes(plan: &Plan<'_>, half: bool, sets: &mut [ModelSet]) {
    let mut holders: BTreeMap<(usize, usize), Vec<(usize, usize)>> = BTreeMap::new();
    for (set, own) in sets.iter().enumerate() {
        if let Measure::Held {
            nodes: Some(nodes), ..
        } = &own.measure
        {
            for (place, (node, _)) in nodes.iter().enumerate() {
                let known = holders.entry((own.set.body, *node)).or_default();
                known.push((set, place));
            }
        }
    }
    for own in holders.into_values().filter(|own| own.len() > 1) {
        let directions: Vec<[f64; 2]> = own.iter().map(|&(set, _)| sets[set].set.along).collect();
        for (&(set, place), share) in own.iter().zip(shares(&directions)) {
            let counts = counts(plan, sets[set].set.body, half);
            if let Measure::Held {
                nodes: Some(nodes), ..
            } = &mut sets[set].measure
            {
                nodes[place].1 = [0, 1].map(|axis| counts[axis] * share[axis]);
            }
        }
    }
}

/// By how much forces along x and y on a body count: in a half model what the other half takes counts too, and nothing across.
fn counts(plan: &Plan<'_>, body: usize, half: bool) -> [f64; 2] {
    match plan.bodies[body].shape.mirror().filter(|_| half) {
        Some(0) => [0.0, 2.0],
        Some(_) => [2.0, 0.0],
        None => [1.0; 2],
    }
}

/// The vectors wᵢ for which the forces R·wᵢ along the unit vectors dᵢ are the least with the sum R, as far as they can have it.
fn shares(directions: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let [a, b, c] = directions.iter().fold([0.0; 3], |[a, b, c], [x, y]| {
        [a + x * x, b + x * y, c + y * y]
    });
    let (trace, determinant) = (a + c, a * c - b * b);
    let share = |&[x, y]: &[f64; 2]| {
        if determinant > 1e-12 * trace * trace {
            [(c * x - b * y) / determinant, (a * y - b * x) / determinant]
        } else {
            [x / trace, y / trace]
        }
    };
    directions.iter().map(share).collect()
}

/// Nodes with their weights along x and y.
type NodeWeights = Vec<(usize, [f64; 2])>;

/// Force `[N]` of a unit of the load case `case` on `body`, and the weights of its nodes.
fn weights(
    body: &ModelBody,
    case: usize,
    on: &SetRef,
    kind: SetKind,
    half: bool,
) -> Result<(f64, NodeWeights), MeshError> {
    let ModelBodyKind::Elastic(elastic) = &body.kind else {
        // A rigid body moves everywhere as at its first point.
        let SetKind::Force { direction } = kind else {
            return Ok((1.0, Vec::new()));
        };
        return Ok((1.0, vec![(0, direction)]));
    };
    let forces = elastic
        .load_cases()
        .get(case)
        .map_or(&[][..], |case| &case.forces);
    let nodes = forces.chunks_exact(2).map(|own| [own[0], own[1]]);
    let (force, sum) = match kind {
        SetKind::Force { direction: [x, y] } | SetKind::Held { direction: [x, y] } => {
            let along = nodes.clone().map(|own| own[0] * x + own[1] * y);
            (1.0, along.sum::<f64>())
        }
        SetKind::Pressure => {
            let edges = &elastic.mesh().edge_set(&on.set)?.edges;
            let own = edge_load(elastic.mesh(), edges, elastic.thickness(), |_| [1.0, 0.0]);
            let area = own.iter().sum::<f64>();
            (if half { 2.0 * area } else { area }, area)
        }
    };
    let weights = nodes.enumerate().filter(|(_, own)| *own != [0.0; 2]);
    let weights = weights.map(|(node, own)| (node, own.map(|part| part / sum)));
    Ok((force, weights.collect()))
}

/// Where an evenly loaded edge of a body by series is asked, with weights along x and y: its straight pieces between nodes by Gauss's rule, since linear cells
/// would miss what displacements do between them. `None` of other bodies, and of what is no edge.
fn places(body: &ModelBody, on: &SetRef, kind: SetKind) -> Option<Vec<(Point, [f64; 2])>> {
    body.series.as_ref()?;
    let mesh = body.elastic()?.mesh();
    let mut places = Vec::new();
    for &edge in &mesh.edge_set(&on.set).ok()?.edges {
        let [from, to] = mesh.edge_nodes(edge).ends.map(|node| mesh.nodes()[node]);
        let [x, y] = [0, 1].map(|axis| to[axis] - from[axis]);
        let length = x.hypot(y);
        let towards = match kind {
            SetKind::Force { direction } | SetKind::Held { direction } => direction,
            SetKind::Pressure => [-y / length, x / length],
        };
        places.extend(edge_rule(1).iter().map(|&(xi, weight)| {
            let part = f64::midpoint(1.0, xi);
            let at = [from[0] + part * x, from[1] + part * y];
            (at, towards.map(|own| 0.5 * weight * length * own))
        }));
    }
    let size = |own: &(Point, [f64; 2])| own.1[0].hypot(own.1[1]);
    let whole: f64 = places.iter().map(size).sum();
    for (_, own) in &mut places {
        *own = own.map(|part| part / whole);
    }
    Some(places)
}

/// The set of `body` on the springs `placed` along `direction`.
fn sprung(
    body: &ModelBody,
    placed: &Placed<'_, SpringSupport>,
    direction: [f64; 2],
) -> Result<Option<ModelSet>, ModelError> {
    let Some(elastic) = body.elastic() else {
        return Ok(None);
    };
    let found = springs::mean(elastic, placed.of, direction);
    let (weights, stiffness) = found.map_err(|cause| ModelError::Mesh {
        body: body.name.clone(),
        cause,
    })?;
    let on = placed.of.on.to_string();
    Ok(Some(ModelSet {
        set: LoadedSet {
            name: on.clone(),
            body: placed.body,
            on,
            kind: SetKind::Held { direction },
            along: direction,
            reach: reach(body, weights.iter().map(|(node, _)| *node)),
        },
        measure: Measure::Springs { weights, stiffness },
    }))
}

/// The set `on` of the body with the index `body` that something holds along `direction` at `displacement` `[mm]`.
fn held(
    (plan, bodies, half): (&Plan<'_>, &[ModelBody], bool),
    body: usize,
    on: &SetRef,
    direction: [f64; 2],
    displacement: f64,
) -> Result<ModelSet, ModelError> {
    let (own, shape) = (&bodies[body], plan.bodies[body].shape);
    let as_a_whole = own.series.is_some() || shape.is_area(&on.set);
    let nodes = own.elastic().filter(|_| !as_a_whole).map(|elastic| {
        let found = elastic.mesh().node_set(&on.set).map(<[usize]>::to_vec);
        found.map_err(|cause| ModelError::Mesh {
            body: own.name.clone(),
            cause,
        })
    });
    let nodes = nodes.transpose()?;
    let reach = nodes
        .as_ref()
        .and_then(|nodes| reach(own, nodes.iter().copied()));
    let counts = counts(plan, body, half);
    let along = [0, 1].map(|axis| counts[axis] * direction[axis]);
    Ok(ModelSet {
        set: LoadedSet {
            name: on.to_string(),
            body,
            on: on.to_string(),
            kind: SetKind::Held { direction },
            along: direction,
            reach,
        },
        measure: Measure::Held {
            nodes: nodes.map(|nodes| nodes.into_iter().map(|node| (node, along)).collect()),
            along,
            displacement,
        },
    })
}

/// Smallest and largest x `[mm]` of `nodes` of an elastic `body`; `None` of a rigid one, and without nodes.
fn reach(body: &ModelBody, nodes: impl Iterator<Item = usize>) -> Option<[f64; 2]> {
    let places = body.elastic()?.mesh().nodes();
    let mut along = nodes.filter_map(|node| Some(places.get(node)?[0]));
    let first = along.next()?;
    Some(along.fold([first; 2], |[from, to], x| [from.min(x), to.max(x)]))
}
