//! The numbers of a model, and tables of their errors.

use super::limits::Missing;
use super::motions::Motions;
use stickslip_engine::results::{EdgeGeometry, EdgeResults, Errors, Stated};

/// Errors per step, edge and number.
pub(super) type Table = Vec<Vec<Errors>>;

/// Estimated errors of the numbers of edges, and of those of sets.
#[derive(Clone, Default)]
pub(super) struct Estimates {
    pub(super) numbers: Table,
    pub(super) sets: Motions,
}

/// What a model says of its edges.
pub(super) struct Numbers {
    pub(super) geometries: Vec<EdgeGeometry>,
    /// The edges of every step with the nodes that it has, those of the rows.
    pub(super) own: Vec<Vec<EdgeGeometry>>,
    /// Results per step and edge.
    pub(super) steps: Vec<Vec<EdgeResults>>,
    /// Errors that fits between nodes estimate of themselves.
    pub(super) fitted: Table,
    /// Numbers without a limit, per step and edge.
    pub(super) missing: Vec<Vec<Missing>>,
    /// Largest spacing of nodes on each edge `[rad or mm]`.
    pub(super) spacings: Vec<f64>,
    /// Those of sets.
    pub(super) sets: Motions,
}

/// Part of a number that rounding may leave.
const ROUNDING: f64 = 1e-12;
/// Part of the friction along an edge below which its force is what a division leaves of friction that balances itself.
const BALANCED: f64 = 0.05;

/// The friction force of `edge` below which it is that of a division alone: along an edge pressed without a push friction balances itself,
/// and the force vanishes with finer divisions.
pub(super) fn balanced_friction(edge: &EdgeResults) -> f64 {
    let friction = edge
        .rows
        .iter()
        .fold(0.0, |most: f64, row| most.max(row.shear.abs()));
    let pressure = Stated::PeakPressure.value(edge).unwrap_or(0.0);
    if pressure > 0.0 {
        BALANCED * edge.normal_force.abs() * friction / pressure
    } else {
        0.0
    }
}

/// The differences of the numbers of two models. Extents and pressures of a contact that is open in the coarse one change from zero.
pub(super) fn difference(fine: &Numbers, coarse: &Numbers) -> Table {
    let edges = |(step, other): (&Vec<EdgeResults>, &Vec<EdgeResults>)| {
        let own = step.iter().zip(other);
        own.map(|(edge, other)| {
            Errors::of(|stated| {
                let before = stated.value(other);
                let before = before.or(stated.vanishes().then_some(0.0));
                Some((stated.value(edge)? - before?).abs())
            })
        })
        .collect()
    };
    fine.steps.iter().zip(&coarse.steps).map(edges).collect()
}

/// The sum of two tables; either may be empty.
pub(super) fn sum(one: &Table, other: &Table) -> Table {
    if one.is_empty() {
        return other.clone();
    }
    zipped(one, other, |one, other| match (one, other) {
        (Some(one), Some(other)) => Some(one + other),
        (one, _) => one,
    })
}

/// Raises errors that are not zero to what rounding leaves of the numbers `of`.
pub(super) fn above_rounding(errors: &mut Table, of: &Numbers) {
    let edges = errors.iter_mut().flatten().zip(of.steps.iter().flatten());
    for (errors, edge) in edges {
        *errors = Errors::of(|stated| {
            let error = errors.get(stated)?;
            let rounding = ROUNDING * stated.value(edge).map_or(0.0, f64::abs);
            Some(if error == 0.0 {
                error
            } else {
                error.max(rounding)
            })
        });
    }
}

/// Takes from `errors` those of largest pressures of the numbers `of` which two divisions of the same few nodes say nothing about.
pub(super) fn drop_unresolved(errors: &mut Table, of: &Numbers) {
    for (step, edges) in errors.iter_mut().enumerate() {
        for (edge, own) in edges.iter_mut().enumerate() {
            if of.is_unresolved(step, edge) {
                *own = Errors::of(|stated| {
                    let is_kept = stated != Stated::PeakPressure;
                    own.get(stated).filter(|_| is_kept)
                });
            }
        }
    }
}

impl Numbers {
    /// Whether the largest pressure of an edge in a step rests on too few nodes to be known, though it has a limit.
    pub(super) fn is_unresolved(&self, step: usize, edge: usize) -> bool {
        let has_limit = !self.missing[step][edge].concern(Stated::PeakPressure);
        has_limit && self.steps[step][edge].has_sharp_peak(&self.own[step][edge])
    }
}

/// The errors of both tables joined; the second one may be empty.
pub(super) fn zipped(
    one: &Table,
    other: &Table,
    join: impl Fn(Option<f64>, Option<f64>) -> Option<f64>,
) -> Table {
    let edges = |(step, edges): (usize, &Vec<Errors>)| {
        let own = edges.iter().enumerate();
        own.map(|(edge, errors)| {
            let second = other.get(step).and_then(|edges| edges.get(edge));
            Errors::of(|stated| join(errors.get(stated), second.and_then(|own| own.get(stated))))
        })
        .collect()
    };
    one.iter().enumerate().map(edges).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A history without friction has no errors of the load path, and keeps those of the geometry.
    #[test]
    fn either_table_of_a_sum_may_be_empty() {
        let table = |error: f64| vec![vec![Errors::of(|_| Some(error))]];
        let first = |sum: &Table| sum[0][0].get(Stated::PeakPressure);
        assert_eq!(first(&sum(&Table::new(), &table(2.0))), Some(2.0));
        assert_eq!(first(&sum(&table(2.0), &Table::new())), Some(2.0));
        assert_eq!(first(&sum(&table(2.0), &table(3.0))), Some(5.0));
    }
}
