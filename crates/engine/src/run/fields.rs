//! Displacements inside the bodies, by which every step's balance is audited, and stresses for the steps that ask for them.

use stickslip_contact::StepRecord;
use stickslip_fem_core::body::{BodyBalance, BodyLoad};
use stickslip_fem_core::mesh::Point;
use stickslip_fem_core::{CondensedBody, InterfaceOperator};

use super::sets;
use super::solved::{Operator, Solved};
use crate::model::{Model, ModelSet};
use crate::results::SetMotion;
use crate::series::SeriesBody;

/// Displacements of one body, in numbers, that are held at once while its balance is audited.
const HELD: usize = 1 << 21;
/// Load steps that are recovered at once at least.
const TOGETHER: usize = 16;
/// Displacements of all bodies and steps, in numbers, that are kept until the fields are written.
const KEPT: usize = 1 << 23;

/// Displacements and balance of all bodies at the end of one load step.
#[derive(Debug, Default)]
pub(super) struct Recovered {
    /// Displacements per body, interleaved, without the free rigid motions, which make no strain and beside which those that do
    /// may be rounding; empty for a rigid body, and where they are not kept.
    pub(super) displacement: Vec<Vec<f64>>,
    /// Stresses (xx, yy, xy) `[MPa]` at the nodes of each body by series whose stresses are asked about in every step; empty for others.
    pub(super) stress: Vec<Vec<[f64; 3]>>,
    /// The displacements at the nodes of each of the model's edges without contact; empty for others.
    pub(super) free_edges: Vec<Vec<[f64; 2]>>,
    /// Tractions (σ_nn, τ_nt) of the reactions at the nodes of each of the model's edges that is held; empty for others.
    pub(super) reactions: Vec<Vec<[f64; 2]>>,
    /// Amounts of each body's free rigid motions.
    pub(super) motions: Vec<Vec<f64>>,
    /// Balance per body; `None` for a rigid one.
    pub(super) balance: Vec<Option<BodyBalance>>,
    /// Force and displacement of the model's sets; `None` of bodies that are not recovered, and where sets are not asked for.
    pub(super) sets: Vec<Option<SetMotion>>,
    pub(super) multipliers: Vec<f64>,
    /// What the compliance of each body that has it in blocks leaves out of the displacements of its contact points `[mm]`, 2n; empty for
    /// others.
    pub(super) left_out: Vec<Vec<f64>>,
    /// Whether displacements were recovered and not kept.
    dropped: bool,
}

impl Recovered {
    /// Whether stresses of the body `index` are known or follow from its displacements.
    pub(super) fn has_stresses(&self, index: usize) -> bool {
        !(self.stress[index].is_empty() && self.displacement[index].is_empty())
    }

    /// The worst unbalanced force or moment of any body.
    pub(super) fn imbalance(&self) -> f64 {
        let bodies = self.balance.iter().flatten();
        bodies.fold(0.0, |worst: f64, body| {
            worst.max(body.force).max(body.moment).max(body.nodal)
        })
    }

    /// Takes over what the reactions among the nodal forces `residual` of the body `index` are as tractions on its held edges.
    fn add_reactions(&mut self, model: &Model, index: usize, residual: &[f64]) {
        for (edge, tractions) in model.edges.iter().zip(&mut self.reactions) {
            if !edge.is_held_on(index) {
                continue;
            }
            let of_node = |(&node, [x, y]): (&usize, &[[f64; 2]; 2])| {
                [0, 1].map(|part| residual[2 * node] * x[part] + residual[2 * node + 1] * y[part])
            };
            let own = edge.nodes.iter().zip(&edge.reactions).map(of_node);
            *tractions = own.collect();
            edge.continue_to_shared_ends(tractions);
        }
    }
}

/// Recovers the displacements of all bodies at the end of every load step, and audits their balance: one pass over each
/// body's factor and one over its cells, for as many steps together as [`HELD`] allows. What is kept does not grow with long histories:
/// displacements on edges without contact, and those of bodies whose stresses are asked about in every step.
pub(super) fn recover(model: &Model, solved: &Solved) -> Vec<Recovered> {
    let elastic = solved.operators.iter().filter_map(Operator::elastic);
    let values: usize = elastic.map(values_of).sum();
    let steps = solved.records.len();
    let keeps_all = steps <= TOGETHER || values * steps <= KEPT;
    let all: Vec<usize> = (0..solved.operators.len()).collect();
    let audit = Pass {
        audits: true,
        sets: true,
        held: HELD,
    };
    audit.of(model, solved, &all, |body| {
        keeps_all || model.is_asked_for_stresses(body)
    })
}

/// Recovers the displacements of the bodies with the indices `wanted` alone, and the reactions on edges in contact, without an audit.
pub(super) fn recover_some(model: &Model, solved: &Solved, wanted: &[usize]) -> Vec<Recovered> {
    let some = Pass {
        audits: false,
        sets: false,
        held: HELD,
    };
    some.of(model, solved, &with_held(model, wanted), |_| true)
}

/// As [`recover_some`], with the sets of all bodies.
pub(super) fn recover_with_sets(
    model: &Model,
    solved: &Solved,
    wanted: &[usize],
) -> Vec<Recovered> {
    let some = Pass {
        audits: false,
        sets: true,
        held: HELD,
    };
    let kept = with_held(model, wanted);
    let sets = model.sets.iter().map(|own| own.set.body);
    let mut all: Vec<usize> = kept.iter().copied().chain(sets).collect();
    all.sort_unstable();
    all.dedup();
    some.of(model, solved, &all, |body| kept.contains(&body))
}

/// The bodies `wanted`, and those whose edges in contact are held.
fn with_held(model: &Model, wanted: &[usize]) -> Vec<usize> {
    let in_contact = model.edges.iter().filter(|edge| edge.pair.is_some());
    let held = in_contact.filter(|edge| edge.is_held_on(edge.geometry.body));
    let held = held.map(|edge| edge.geometry.body);
    let mut all: Vec<usize> = wanted.iter().copied().chain(held).collect();
    all.sort_unstable();
    all.dedup();
    all
}

/// What is recovered beside displacements.
#[derive(Clone, Copy)]
struct Pass {
    /// Balances.
    audits: bool,
    /// Forces and displacements of sets.
    sets: bool,
    /// Numbers that are held at once.
    held: usize,
}

impl Pass {
    /// Recovers the bodies `wanted`.
    fn of(
        self,
        model: &Model,
        solved: &Solved,
        wanted: &[usize],
        keeps: impl Fn(usize) -> bool,
    ) -> Vec<Recovered> {
        let records = &solved.records;
        let bodies = solved.operators.len();
        let mut all: Vec<Recovered> = records
            .iter()
            .map(|record| Recovered {
                displacement: vec![Vec::new(); bodies],
                stress: vec![Vec::new(); bodies],
                free_edges: vec![Vec::new(); model.edges.len()],
                reactions: vec![Vec::new(); model.edges.len()],
                motions: motions(solved, record),
                balance: vec![None; bodies],
                sets: vec![None; model.sets.len()],
                multipliers: record.state.multipliers.clone(),
                left_out: vec![Vec::new(); bodies],
                dropped: false,
            })
            .collect();
        for &index in wanted {
            if self.sets {
                for (record, step) in records.iter().zip(&mut all) {
                    let own = (index, record);
                    sets::of_rigid(model, solved, own, &step.motions[index], &mut step.sets);
                }
            }
            if let Some(body) = solved.operators.get(index).and_then(Operator::series) {
                self.recover_series(model, solved, (index, body), keeps(index), &mut all);
            }
            let Some(body) = solved.operators.get(index).and_then(Operator::elastic) else {
                continue;
            };
            let together = TOGETHER.max(self.held / values_of(body).max(1));
            for (records, steps) in records.chunks(together).zip(all.chunks_mut(together)) {
                let forces = forces_on(solved, records, index);
                let states = loads_on(records, &forces);
                let displacements = body.displacements_of(&states);
                let found = (displacements.as_slice(), states.as_slice());
                let residuals = if self.needs_residuals(model, index) {
                    self.audit(model, (index, body), found, steps)
                } else {
                    vec![Vec::new(); displacements.len()]
                };
                if self.finds_sets(model, index) {
                    let both = displacements.iter().zip(&residuals).zip(&states);
                    for ((record, step), ((u, residual), state)) in
                        records.iter().zip(steps.iter_mut()).zip(both)
                    {
                        let motions = &step.motions[index];
                        let own = (index, body, motions.as_slice());
                        let found = [u.as_slice(), residual];
                        sets::of_elastic(model, own, (record, state), found, &mut step.sets);
                    }
                }
                if body.blocks().is_some() {
                    for ((step, u), state) in steps.iter_mut().zip(&displacements).zip(&states) {
                        step.left_out[index] = left_out(body, u, state);
                    }
                }
                for (step, u) in steps.iter_mut().zip(displacements) {
                    for (edge, moved) in model.edges.iter().zip(&mut step.free_edges) {
                        if edge.geometry.body == index && edge.pair.is_none() {
                            let at = |&node: &usize| [u[2 * node], u[2 * node + 1]];
                            *moved = edge.nodes.iter().map(at).collect();
                        }
                    }
                    if keeps(index) {
                        step.displacement[index] = u;
                    } else {
                        step.dropped = true;
                    }
                }
            }
        }
        all
    }

    /// Whether sets of the body with this index are found.
    fn finds_sets(self, model: &Model, index: usize) -> bool {
        self.sets && model.sets.iter().any(|own| own.set.body == index)
    }

    /// Whether unbalanced nodal forces of the body with this index are needed.
    fn needs_residuals(self, model: &Model, index: usize) -> bool {
        let mut edges = model.edges.iter();
        let mut sets = model.sets.iter().filter(|own| own.set.body == index);
        self.audits
            || edges.any(|edge| edge.is_held_on(index))
            || self.sets && sets.any(ModelSet::is_held_at_nodes)
    }

    /// The balance of the body with this index, its reactions on held edges and its unbalanced nodal forces, for each of `steps`, from its displacements and from what acts on it.
    fn audit(
        self,
        model: &Model,
        (index, body): (usize, &CondensedBody),
        (displacements, states): (&[Vec<f64>], &[BodyLoad<'_>]),
        steps: &mut [Recovered],
    ) -> Vec<Vec<f64>> {
        let residuals = body.residual_forces_of(displacements, states);
        if self.audits {
            let balances = body.balances_of(&residuals, displacements, states);
            for (step, balance) in steps.iter_mut().zip(balances) {
                step.balance[index] = Some(balance);
            }
        }
        for (step, (residual, u)) in steps.iter_mut().zip(residuals.iter().zip(displacements)) {
            let mut reactions = residual.clone();
            let springs = body.body().spring_forces(u);
            let both = reactions.iter_mut().zip(springs);
            both.for_each(|(sum, force)| *sum += force);
            step.add_reactions(model, index, &reactions);
        }
        residuals
    }

    /// Recovers of a body by series what no field needs: its balance, and its stresses where they are asked about and kept.
    fn recover_series(
        self,
        model: &Model,
        solved: &Solved,
        (index, body): (usize, &SeriesBody),
        keeps: bool,
        all: &mut [Recovered],
    ) {
        for (record, step) in solved.records.iter().zip(all) {
            let forces = solved.forces_on_body(record, index);
            let is_carried = model.fastener_of(index).is_some();
            step.balance[index] = self
                .audits
                .then(|| body.balance(&forces, record, is_carried));
            step.dropped = true;
            if self.sets {
                let own = (index, body, step.motions[index].as_slice());
                sets::of_series(model, own, (record, &forces), &mut step.sets);
            }
            if keeps
                && model.is_asked_for_stresses(index)
                && let Some(own) = model.bodies[index].elastic()
            {
                step.stress[index] = body.stresses(record, &forces, own.mesh().nodes());
            }
        }
    }
}

/// The displacements `u` of the contact points of `body`, recovered inside, less those by its compliance.
fn left_out(body: &CondensedBody, u: &[f64], state: &BodyLoad<'_>) -> Vec<f64> {
    let still = vec![0.0; body.modes().ncols()];
    let seen = InterfaceOperator::displacements(body, state.forces, &still, state.multipliers);
    let nodes = body.interface_nodes().iter();
    let recovered = nodes.flat_map(|&node| [u[2 * node], u[2 * node + 1]]);
    recovered.zip(seen.iter()).map(|(a, b)| a - b).collect()
}

/// Displacements of a body by series at `places`, without its rigid motions, x and y of each in turn.
fn strained(body: &SeriesBody, record: &StepRecord, forces: &[f64], places: &[Point]) -> Vec<f64> {
    let Some(field) = body.strained(record, forces) else {
        return Vec::new();
    };
    // The places are those of the body's mesh.
    let at = |&place: &Point| field.displacement(place).unwrap_or_default();
    places.iter().flat_map(at).collect()
}

/// Recovers again the displacements in load step `step` that were not kept.
pub(super) fn complete(model: &Model, solved: &Solved, recovered: &mut Recovered, step: usize) {
    if !recovered.dropped {
        return;
    }
    let record = &solved.records[step..=step];
    for (index, operator) in solved.operators.iter().enumerate() {
        if let (Some(body), Some(own)) = (operator.series(), model.bodies[index].elastic()) {
            let forces = solved.forces_on_body(&record[0], index);
            let places = own.mesh().nodes();
            recovered.displacement[index] = strained(body, &record[0], &forces, places);
        }
        let Some(body) = operator.elastic() else {
            continue;
        };
        let forces = forces_on(solved, record, index);
        let found = body.displacements_of(&loads_on(record, &forces));
        if let Some(u) = found.into_iter().next() {
            recovered.displacement[index] = u;
        }
    }
    recovered.dropped = false;
}

/// Number of displacements of a body.
fn values_of(body: &CondensedBody) -> usize {
    2 * body.body().mesh().nodes().len()
}

/// Contact forces on the elastic body `index`, for each of `records`.
fn forces_on(solved: &Solved, records: &[StepRecord], index: usize) -> Vec<Vec<f64>> {
    let of_step = |record: &StepRecord| solved.forces_on_body(record, index);
    records.iter().map(of_step).collect()
}

/// Amounts of the rigid motions of each body at the end of a load step.
fn motions(solved: &Solved, record: &StepRecord) -> Vec<Vec<f64>> {
    let of_body = |body| solved.interface.motions_of_body(body, &record.state);
    (0..solved.operators.len()).map(of_body).collect()
}

/// Everything that acts on a body and strains it, for each of `records`, under the contact forces `forces`.
fn loads_on<'a>(records: &'a [StepRecord], forces: &'a [Vec<f64>]) -> Vec<BodyLoad<'a>> {
    let of_step = |(record, forces): (&'a StepRecord, &'a Vec<f64>)| BodyLoad {
        forces,
        multipliers: &record.state.multipliers,
        motions: &[],
    };
    records.iter().zip(forces).map(of_step).collect()
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;
    use crate::run::{solve, solver};
    use stickslip_scene::schema::SolverChoice;
    use stickslip_scene::{Format, Scene};

    /// A history of more steps than are recovered at once.
    fn solved() -> (Model, Solved) {
        let text = stickslip_scene::templates::TEMPLATES[0].text;
        let loads: Vec<String> = (1..=3 * TOGETHER / 2)
            .map(|k| format!("\"{k}00 N\""))
            .collect();
        let changes = [
            "mesh.element=Q4".to_owned(),
            "mesh.spacing=6 deg".to_owned(),
            "edges=[{ on = \"plate.top\" }]".to_owned(),
            format!("loads.0.force.steps=[{}]", loads.join(", ")),
        ];
        let changes: Vec<&str> = changes.iter().map(String::as_str).collect();
        let scene =
            Scene::from_text(text, Format::Toml, "pin.toml", Path::new(""), &changes).unwrap();
        let model = Model::build(&scene).unwrap();
        let chain = solver(SolverChoice::Auto);
        let solved = solve(&model, chain.as_ref(), &mut |_| {}).unwrap();
        (model, solved)
    }

    #[test]
    fn what_is_not_kept_is_recovered_again() {
        let (model, solved) = solved();
        let bodies = [0, 1];
        let at_once = |held: usize| Pass {
            audits: true,
            sets: true,
            held,
        };
        let kept = at_once(usize::MAX).of(&model, &solved, &bodies, |_| true);
        let mut dropped = at_once(0).of(&model, &solved, &bodies, |_| false);
        let close = |one: &[f64], other: &[f64]| {
            let largest = one
                .iter()
                .fold(0.0_f64, |most, value| most.max(value.abs()));
            let mut both = one.iter().zip(other);
            one.len() == other.len() && both.all(|(a, b)| (a - b).abs() <= 1e-12 * largest)
        };
        for (step, (kept, dropped)) in kept.iter().zip(&mut dropped).enumerate() {
            assert!(dropped.displacement.iter().all(Vec::is_empty));
            for (kept, dropped) in kept.free_edges.iter().zip(&dropped.free_edges) {
                assert!(close(kept.as_flattened(), dropped.as_flattened()));
            }
            assert!(kept.imbalance() < 1e-10 && dropped.imbalance() < 1e-10);
            complete(&model, &solved, dropped, step);
            for (kept, dropped) in kept.displacement.iter().zip(&dropped.displacement) {
                assert!(!kept.is_empty() && close(kept, dropped));
            }
        }
    }
}
