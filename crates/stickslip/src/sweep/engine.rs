//! Solves the cases of a sweep on several cores.
//!
//! Every worker computes on a pool of one thread, so that a case uses one core and its result does not depend on how many there are.
//! Cases that share bodies are solved one after the other by the same worker, see [`sweep`](crate::sweep) for what they share.

use std::collections::BTreeMap;
use std::num::NonZeroUsize;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::mpsc::{Sender, channel};
use std::sync::{Mutex, PoisonError};

use rayon::ThreadPool;

use crate::host::HOST;
use stickslip_fem_core::InterfaceOperator;

use super::queue::Queue;
use super::row::{Measures, Outcome, Row};
use super::store::{Form, Store};
use super::{Sweep, SweepError, bodies};
use stickslip_engine::model::{Model, ModelBody, ModelBodyKind, ModelError};
use stickslip_engine::results::Results;
use stickslip_engine::run::{Operator, follow, results_without_audit, solver};
use stickslip_scene::Scene;
use stickslip_scene::schema::FieldOutput;

/// What a sweep took.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Effort {
    /// Bodies condensed.
    pub condensed: usize,
}

/// Solves the `cases` of `sweep` with `jobs` workers and hands every row to `each`, in the order in which they are done, until
/// `stop` is set; then the cases that are running are finished.
///
/// # Errors
/// [`SweepError::Workers`], and what `each` returns. A case that cannot be solved is a row.
pub fn run(
    sweep: &Sweep,
    cases: &[usize],
    jobs: NonZeroUsize,
    stop: &AtomicBool,
    each: &mut dyn FnMut(Row) -> Result<(), SweepError>,
) -> Result<Effort, SweepError> {
    let pools = (0..jobs.get())
        .map(|_| rayon::ThreadPoolBuilder::new().num_threads(1).build())
        .collect::<Result<Vec<ThreadPool>, _>>()
        .map_err(|cause| SweepError::Workers {
            cause: cause.into(),
        })?;
    let plans: BTreeMap<usize, Vec<String>> = cases
        .iter()
        .map(|&case| (case, keys(sweep, case)))
        .collect();
    let shop = Shop::new(sweep, plans, stop);
    let outcome = std::thread::scope(|scope| {
        let (sender, receiver) = channel();
        for pool in &pools {
            let (sender, shop) = (sender.clone(), &shop);
            scope.spawn(move || shop.work(pool, &sender));
        }
        drop(sender);
        let handed = receiver.iter().try_for_each(&mut *each);
        if handed.is_err() {
            stop.store(true, Ordering::Relaxed);
        }
        handed
    });
    outcome.map(|()| Effort {
        condensed: shop.condensed.into_inner(),
    })
}

/// Keys of the bodies of a case; none where its values make no scene.
fn keys(sweep: &Sweep, case: usize) -> Vec<String> {
    let Ok(scene) = sweep.scene_of(case) else {
        return Vec::new();
    };
    let names = scene.bodies.keys();
    names.filter_map(|name| bodies::key(&scene, name)).collect()
}

/// All cases with each key of `plans` up to the last of these cases, ascending.
fn cases_with(sweep: &Sweep, plans: &BTreeMap<usize, Vec<String>>) -> BTreeMap<String, Vec<usize>> {
    let wanted = plans.values().flatten().cloned();
    let mut found: BTreeMap<String, Vec<usize>> = wanted.map(|key| (key, Vec::new())).collect();
    let count = plans.last_key_value().map_or(0, |(last, _)| last + 1);
    for case in 0..count {
        let own = plans.get(&case).cloned();
        for key in own.unwrap_or_else(|| keys(sweep, case)) {
            if let Some(cases) = found.get_mut(&key) {
                cases.push(case);
            }
        }
    }
    found
}

/// Cases with equal bodies together, in the order of their first cases.
fn groups(plans: &BTreeMap<usize, Vec<String>>) -> Vec<Vec<usize>> {
    let mut groups: Vec<Vec<usize>> = Vec::new();
    let mut known: BTreeMap<&Vec<String>, usize> = BTreeMap::new();
    for (&case, keys) in plans {
        let group = *known.entry(keys).or_insert_with(|| {
            groups.push(Vec::new());
            groups.len() - 1
        });
        groups[group].push(case);
    }
    groups
}

/// Everything that workers share.
struct Shop<'a> {
    sweep: &'a Sweep,
    store: Store,
    queue: Mutex<Queue>,
    plans: BTreeMap<usize, Vec<String>>,
    /// The cases of the sweep with the body of each key. That of the first is condensed for all: bodies of equal keys differ in size, and
    /// by rounding in what they give, so a row would else depend on which cases are asked for and on the order in which they are done.
    cases_with: BTreeMap<String, Vec<usize>>,
    condensed: AtomicUsize,
    stop: &'a AtomicBool,
}

/// The model of a worker's last case, which the next one may differ from in laws and loads only.
type LastModel = Option<(String, Model)>;

impl<'a> Shop<'a> {
    fn new(sweep: &'a Sweep, plans: BTreeMap<usize, Vec<String>>, stop: &'a AtomicBool) -> Self {
        Self {
            sweep,
            store: Store::for_uses(plans.values().flatten()),
            queue: Mutex::new(Queue::new(groups(&plans))),
            cases_with: cases_with(sweep, &plans),
            plans,
            condensed: AtomicUsize::new(0),
            stop,
        }
    }

    fn work(&self, pool: &ThreadPool, rows: &Sender<Row>) {
        let mut own = None;
        let mut last = None;
        while !self.stop.load(Ordering::Relaxed) {
            let next = {
                // A queue is only ever popped, which no panic interrupts.
                let mut queue = self.queue.lock().unwrap_or_else(PoisonError::into_inner);
                queue.next(own)
            };
            let Some((group, case)) = next else {
                return;
            };
            own = Some(group);
            let row = pool.install(|| self.row(case, &mut last));
            for key in self.plans.get(&case).into_iter().flatten() {
                self.store.release(key);
            }
            if rows.send(row).is_err() {
                return;
            }
        }
    }

    fn row(&self, case: usize, last: &mut LastModel) -> Row {
        let start = HOST.seconds();
        let outcome = match self.solved(case, last) {
            Ok(measures) => Outcome::Solved(Box::new(measures)),
            Err(reason) => Outcome::Unresolved(reason),
        };
        Row {
            case,
            seconds: HOST.seconds() - start,
            outcome,
        }
    }

    /// The numbers of a case, or as text why there are none.
    fn solved(&self, case: usize, last: &mut LastModel) -> Result<Measures, String> {
        let scene = self
            .sweep
            .scene_of(case)
            .map_err(|error| error.to_string())?;
        let results = self.results(case, &scene, last)?;
        Ok(Measures::of(&results, self.sweep))
    }

    fn results(&self, case: usize, scene: &Scene, last: &mut LastModel) -> Result<Results, String> {
        if scene.seeks_accuracy() {
            return whole(scene);
        }
        let model = modelled(scene, last).map_err(|error| error.to_string())?;
        let operators = self.operators(case, scene, &model)?;
        let faces: Vec<&dyn InterfaceOperator> =
            operators.iter().map(Operator::interface).collect();
        let interface = model.interface(&faces).map_err(|error| error.to_string())?;
        drop(faces);
        let solver = solver(scene.analysis.solver);
        let solved = follow(&model, operators, interface, solver.as_ref(), &mut |_| {})
            .map_err(|error| error.to_string())?;
        let wanted = needed(&model);
        results_without_audit(&model, solver.as_ref(), solved, &wanted)
            .map_err(|error| error.to_string())
    }

    /// The body of `key` in the first case before `case` that has it and models the same half, if one can be modelled.
    fn first_body(&self, key: &str, case: usize, half: bool) -> Option<ModelBody> {
        let cases = self.cases_with.get(key)?.iter();
        cases.take_while(|&&other| other < case).find_map(|&other| {
            let scene = self.sweep.scene_of(other).ok()?;
            let model = Model::build(&scene).ok()?;
            let same = |body: &ModelBody| bodies::key(&scene, &body.name).as_deref() == Some(key);
            let mut bodies = model.bodies.into_iter();
            bodies.find(|body| model.half == half && same(body))
        })
    }

    fn operators(
        &self,
        case: usize,
        scene: &Scene,
        model: &Model,
    ) -> Result<Vec<Operator>, String> {
        let operator = |body: &ModelBody| {
            if let Some(series) = &body.series {
                return Ok(Operator::Series(Arc::clone(series)));
            }
            let elastic = match &body.kind {
                ModelBodyKind::Rigid(rigid) => return Ok(Operator::Rigid(rigid.clone())),
                ModelBodyKind::Elastic(elastic) => elastic,
            };
            let Some(key) = bodies::key(scene, &body.name) else {
                return Err(format!("body '{}' has no elastic material", body.name));
            };
            let condense = || {
                let first = self.first_body(&key, case, model.half);
                let first = first.map(|first| ModelBody {
                    ends: body.ends.clone(),
                    ..first
                });
                let condensed = match first.as_ref().map(|body| (body, &body.kind)) {
                    Some((body, ModelBodyKind::Elastic(elastic))) => body.condense(elastic),
                    _ => body.condense(elastic),
                };
                condensed.map_err(|cause| format!("body '{}': {cause}", body.name))
            };
            let form = Form {
                half: model.half,
                in_blocks: !body.ends.is_empty(),
            };
            let (condensed, made) = self.store.get(&key, form, condense);
            self.condensed
                .fetch_add(usize::from(made), Ordering::Relaxed);
            condensed.map(Operator::Elastic)
        };
        model.bodies.iter().map(operator).collect()
    }
}

/// A case that finds its own model for the accuracy that it asks for.
fn whole(scene: &Scene) -> Result<Results, String> {
    let mut scene = scene.clone();
    scene.output.fields = FieldOutput::None;
    stickslip_ladder::run(&scene, &mut |_| {}).map_err(|error| error.to_string())
}

/// The model of `scene`, from the last one where it differs in laws and loads only.
fn modelled(scene: &Scene, last: &mut LastModel) -> Result<Model, ModelError> {
    let key = bodies::model_key(scene);
    match last {
        Some((known, model)) if *known == key => model.with_laws_and_history(scene),
        _ => {
            let model = Model::build(scene)?;
            *last = Some((key, model.clone()));
            Ok(model)
        }
    }
}

/// Bodies whose inner displacements are needed.
fn needed(model: &Model) -> Vec<usize> {
    let shows = |index: usize| {
        let mut free = model.edges.iter().filter(|edge| edge.pair.is_none());
        free.any(|edge| edge.geometry.body == index)
    };
    let all = 0..model.bodies.len();
    all.filter(|&index| model.is_asked_for_stresses(index) || shows(index))
        .collect()
}

#[cfg(test)]
mod tests;
