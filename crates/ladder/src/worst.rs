//! The error that is largest beside what is asked.

use stickslip_engine::results::{Bounded, EdgeResults, EdgeRow, SetStated, Stated};
use stickslip_scene::schema::Accuracy;

use super::motions::Motions;
use super::numbers::{Estimates, Numbers, Table, balanced_friction};

/// Numbers below this part of the largest of their history are measured by it.
const SMALL: f64 = 1e-3;

/// A relative error beside its bound.
#[derive(Clone, Copy)]
pub(super) struct Worst {
    error: f64,
    number: Bounded,
    /// The error over its bound.
    pub(super) part: f64,
}

impl Worst {
    /// `error` of the `number` that is measured by `scale` and may have the relative error `bound`; `None` of what vanishes.
    fn of(number: Bounded, error: f64, scale: f64, bound: f64) -> Option<Self> {
        (scale > 0.0).then(|| Self {
            error: error / scale,
            number,
            part: error / scale / bound,
        })
    }

    pub(super) fn named(self) -> (f64, Bounded) {
        (self.error, self.number)
    }

    fn compared(&self, other: &Self) -> std::cmp::Ordering {
        self.part.total_cmp(&other.part)
    }
}

/// The relative error that is largest beside its bound of `accuracy`: of sets, and of contacts, or where there are none of all edges.
pub(super) fn worst(level: &Numbers, errors: &Estimates, accuracy: Accuracy) -> Option<Worst> {
    let of_step = |step: usize| {
        let edges = worst_of_edges(level, &errors.numbers, accuracy, step);
        let sets = worst_of_sets(level, &errors.sets, accuracy, step);
        edges.into_iter().chain(sets)
    };
    let all = (0..level.steps.len()).flat_map(of_step);
    all.max_by(Worst::compared)
}

/// The same of the edges in the load step `step`. Stresses are measured by the larger of themselves and of the peak pressure, beside which σ_t may vanish, and by no less than a small part of all
/// stresses along edges; friction and stick by the largest of their history, and friction by no less than what may balance itself.
pub(super) fn worst_of_edges(
    level: &Numbers,
    errors: &Table,
    accuracy: Accuracy,
    step: usize,
) -> Option<Worst> {
    let stress = largest_stress(&level.steps[step]);
    let part = |(edge, stated): (usize, Stated)| {
        let number = Bounded::from(stated);
        let bound = number.bound(accuracy)?;
        let error = errors.get(step)?.get(edge)?.get(stated)?;
        let size = |results: &EdgeResults| stated.value(results).map_or(0.0, f64::abs);
        let history = level.steps.iter().map(|step| size(&step[edge]));
        let largest = history.fold(0.0, f64::max);
        let own = &level.steps[step][edge];
        let scale = match stated {
            Stated::FrictionForce => {
                let held = level
                    .steps
                    .iter()
                    .map(|step| balanced_friction(&step[edge]));
                held.fold(largest, f64::max)
            }
            Stated::StickExtent => largest,
            Stated::PeakHoop | Stated::HoopAtBearing => {
                let pressure = Stated::PeakPressure.value(own).unwrap_or(0.0);
                size(own).max(SMALL * largest.max(stress)).max(pressure)
            }
            _ => size(own).max(SMALL * largest),
        };
        Worst::of(number, error, scale, bound)
    };
    of_edges(level).filter_map(part).max_by(Worst::compared)
}

/// The numbers of edges that count: of contacts, or where there are none of all edges, along which nothing rubs.
fn of_edges(level: &Numbers) -> impl Iterator<Item = (usize, Stated)> {
    let touches = level.geometries.iter().any(|geometry| geometry.contact);
    let edges = level.geometries.iter().enumerate();
    let edges = edges.filter(move |(_, geometry)| geometry.contact || !touches);
    let numbers = edges.flat_map(|(edge, _)| Stated::ALL.map(|stated| (edge, stated)));
    numbers.filter(move |(_, stated)| touches || *stated != Stated::FrictionForce)
}

/// The largest stress along any of `edges` `[MPa]`.
fn largest_stress(edges: &[EdgeResults]) -> f64 {
    let rows = edges.iter().flat_map(|edge| &edge.rows);
    rows.map(EdgeRow::largest_stress).fold(0.0, f64::max)
}

/// What `accuracy` allows of the number `stated` of sets. One that names nothing bounds displacements where there are no edges.
fn bound_of_set(level: &Numbers, stated: SetStated, accuracy: Accuracy) -> Option<f64> {
    match accuracy {
        Accuracy::Overall(error) => {
            let is_all_there_is = level.geometries.is_empty() && stated == SetStated::Displacement;
            is_all_there_is.then(|| error.share())
        }
        Accuracy::Named(_) => Bounded::from(stated).bound(accuracy),
    }
}

/// Whether `accuracy` bounds numbers of sets.
pub(super) fn bounds_sets(level: &Numbers, accuracy: Accuracy) -> bool {
    let mut all = SetStated::ALL.into_iter();
    all.any(|stated| bound_of_set(level, stated, accuracy).is_some())
}

/// The same of sets in the load step `step`, whose forces and displacements are measured by no less than a small part of the largest of all sets, and stiffness by that of its own history.
pub(super) fn worst_of_sets(
    level: &Numbers,
    errors: &Motions,
    accuracy: Accuracy,
    step: usize,
) -> Option<Worst> {
    let part = |(set, stated): (usize, SetStated)| {
        let bound = bound_of_set(level, stated, accuracy)?;
        let error = errors.get(step, set, stated)?;
        let own = level.sets.get(step, set, stated)?.abs();
        let largest = match stated {
            // No stiffness vanishes.
            SetStated::Secant | SetStated::Tangent => level.sets.largest(set, stated),
            SetStated::Force | SetStated::Displacement => {
                let all = (0..level.sets.count()).map(|set| level.sets.largest(set, stated));
                all.fold(0.0, f64::max)
            }
        };
        let scale = own.max(SMALL * largest);
        Worst::of(stated.into(), error, scale, bound)
    };
    let sets = 0..errors.count();
    let numbers = sets.flat_map(|set| SetStated::ALL.map(|stated| (set, stated)));
    numbers.filter_map(part).max_by(Worst::compared)
}

/// What `accuracy` bounds and has no error anywhere in `errors`: every number with a name, of others all together.
pub(super) fn unstated(level: &Numbers, errors: &Estimates, accuracy: Accuracy) -> Vec<Bounded> {
    let any = |number: Bounded, is_so: &dyn Fn(usize, usize, Stated) -> bool| {
        let own = of_edges(level).filter(|(_, stated)| number == Bounded::from(*stated));
        let mut own = own.flat_map(|own| (0..level.steps.len()).map(move |step| (step, own)));
        own.any(|(step, (edge, stated))| is_so(step, edge, stated))
    };
    let has_error = |number: Bounded| match number {
        Bounded::Edge(_) => any(number, &|step, edge, stated| {
            let own = errors.numbers.get(step).and_then(|step| step.get(edge));
            own.is_some_and(|own| own.get(stated).is_some())
        }),
        Bounded::Set(stated) => errors.sets.have(stated),
    };
    let is_there = |number: Bounded| match number {
        Bounded::Edge(_) => any(number, &|step, edge, stated| {
            let value = stated.value(&level.steps[step][edge]);
            value.is_some_and(|value| value != 0.0)
        }),
        Bounded::Set(_) => true,
    };
    let sets = SetStated::ALL.into_iter();
    let sets = sets.filter(|&stated| bound_of_set(level, stated, accuracy).is_some());
    let numbers = Stated::ALL.into_iter().map(Bounded::from);
    let numbers = numbers.filter(|number| number.bound(accuracy).is_some());
    let asked: Vec<Bounded> = numbers.chain(sets.map(Bounded::from)).collect();
    let without = asked.iter().copied().filter(|&number| !has_error(number));
    match accuracy {
        Accuracy::Named(_) => without.collect(),
        Accuracy::Overall(_) if asked.iter().any(|&number| has_error(number)) => Vec::new(),
        Accuracy::Overall(_) => without.filter(|&number| is_there(number)).collect(),
    }
}
