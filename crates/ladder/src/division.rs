//! What a division leaves of every stated number, by the models of the last two or three rungs.
//!
//! ```text
//! size  = max(|v_h − v_2h|, |v_2h − v_4h| r),     error = k max(size, WIDE · the largest size of all steps)
//! ```
//!
//! r is the part that a change should be of the one before: ½ with equal spacings, ¼ with graded ones. Changes of stress and force are compared
//! between steps as parts of the peak pressure and of the normal force. [`factors`] has k.

use super::limits::{Missing, STEEP};
use super::numbers::{Numbers, Table, difference};
use super::places::{peak_at, reach};
use stickslip_engine::results::{ContactFinding, EdgeGeometry, Errors, Finding, Nodes, Stated};

/// A change may vanish by chance; this part of the largest one of all steps does not.
const WIDE: f64 = 0.4;
/// Of two estimates of an error the smaller one counts, but at least this part of the larger one.
const LEAST: f64 = 0.1;
/// The expansion at an end of contact is off by so many times the error that it states, at most, on graded nodes.
const FITTED: f64 = 3.5;
/// Numbers that a fit between nodes would give are off by so many times what models estimate, where the nodes themselves have to do.
const NODAL: f64 = 1.7;
/// Part of the largest pressure, times the square of the spacing over the half extent of contact, by which it is off at least: up to two thirds of that it was along smooth
/// noses from 13 to 20 nodes.
const UNRESOLVED: f64 = 0.6;
/// The expansion at an end is off by at least this part of what models estimate.
const ENDS: f64 = 0.6;

/// How nodes are spaced.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Spaced {
    /// Equally.
    Equally,
    /// Graded towards where contact changes.
    Graded,
    /// The same, with deformed gaps.
    GradedDeformed,
    /// Graded along a line contact.
    GradedLine,
}

impl Spaced {
    pub(super) fn are_graded(self) -> bool {
        self != Self::Equally
    }

    /// The part that a change should be of the one before.
    pub(super) fn rate(self) -> f64 {
        if self.are_graded() { 0.25 } else { 0.5 }
    }
}

/// The errors of the last of `levels`; empty where there is one only.
pub(super) fn errors(levels: &[&Numbers], nodes: Spaced) -> Table {
    let [.., coarse, fine] = levels else {
        return Table::new();
    };
    let last = difference(fine, coarse);
    let before = match levels {
        [.., coarser, coarse, _] => difference(coarse, coarser),
        _ => Table::new(),
    };
    let changes = Changes {
        fine,
        coarse,
        last,
        before,
        nodes,
    };
    let edges = |step: usize| {
        let count = fine.spacings.len();
        (0..count)
            .map(|edge| changes.errors([step, edge]))
            .collect()
    };
    (0..fine.steps.len()).map(edges).collect()
}

/// What a reader must know of the numbers `of` that have no limit, and so no error among `errors`.
pub(super) fn findings(of: &Numbers, errors: &Table) -> Vec<Finding> {
    let edges = of.geometries.iter().enumerate();
    edges
        .flat_map(|(edge, geometry)| {
            if geometry.contact {
                of_contact(of, errors, (edge, geometry))
                    .into_iter()
                    .collect()
            } else {
                of_free_edge(of, errors, (edge, geometry))
            }
        })
        .collect()
}

/// Whether the number `stated` of an edge has no error in the step.
fn has_no_error(of: &Numbers, errors: &Table, [step, edge]: At, stated: Stated) -> bool {
    errors[step][edge].get(stated).is_none() && stated.value(&of.steps[step][edge]).is_some()
}

fn of_contact(
    of: &Numbers,
    errors: &Table,
    (edge, geometry): (usize, &EdgeGeometry),
) -> Option<Finding> {
    let (mut steps, mut numbers) = (Vec::new(), Vec::new());
    for step in 0..errors.len() {
        let missing = of.missing[step][edge];
        let own = Stated::ALL.into_iter().filter(|&stated| {
            missing.concern(stated)
                && !missing.are_of_a_corner()
                && has_no_error(of, errors, [step, edge], stated)
        });
        for stated in own {
            if steps.last() != Some(&(step + 1)) {
                steps.push(step + 1);
            }
            if !numbers.contains(&stated.describe()) {
                numbers.push(stated.describe());
            }
        }
    }
    let is_any = !steps.is_empty();
    is_any.then(|| Finding::about(&geometry.name, ContactFinding::NoLimit { steps, numbers }))
}

fn of_free_edge(
    of: &Numbers,
    errors: &Table,
    (edge, geometry): (usize, &EdgeGeometry),
) -> Vec<Finding> {
    let steps_with = |is_why: fn(Missing, Stated) -> bool| -> Option<Vec<usize>> {
        let is_one = |&step: &usize| {
            Stated::ALL.into_iter().any(|stated| {
                is_why(of.missing[step][edge], stated)
                    && has_no_error(of, errors, [step, edge], stated)
            })
        };
        let steps: Vec<usize> = (0..errors.len())
            .filter(is_one)
            .map(|step| step + 1)
            .collect();
        (!steps.is_empty()).then_some(steps)
    };
    let of_support = steps_with(Missing::is_of_a_support);
    let of_load = steps_with(Missing::is_of_a_load);
    let of_support = of_support.map(|steps| Finding::NoLimitAtSupport {
        edge: geometry.name.clone(),
        steps,
    });
    let of_load = of_load.map(|steps| Finding::NoValueAtLoadEnd {
        edge: geometry.name.clone(),
        steps,
    });
    of_support.into_iter().chain(of_load).collect()
}

/// A step and an edge.
type At = [usize; 2];

struct Changes<'a> {
    fine: &'a Numbers,
    coarse: &'a Numbers,
    last: Table,
    before: Table,
    nodes: Spaced,
}

impl Changes<'_> {
    fn errors(&self, at: At) -> Errors {
        let limits = self.fine.missing[at[0]][at[1]];
        let rows = &self.fine.steps[at[0]][at[1]].rows;
        let rubs = rows.iter().any(|row| row.shear != 0.0);
        Errors::of(|stated| {
            // Without friction no force depends on which way a point slips, and the sign is that of the last increment.
            if !rubs && matches!(stated, Stated::SlipAway | Stated::SlipTowards) {
                return None;
            }
            let [last, before] = self.changes(at, stated);
            let grows = if let Some(before) = before {
                last > Some(0.5 * before)
            } else {
                let value = stated.value(&self.fine.steps[at[0]][at[1]]);
                limits.is_of_a_support(stated) && last > value.map(|value| STEEP * value.abs())
            };
            let is_certain = limits.are_of_a_corner() || limits.is_of_a_load(stated);
            let is_peak = matches!(stated, Stated::PeakHoop | Stated::PeakHoopPlace);
            let may_rise = limits.may_rise(self.coarse.missing[at[0]][at[1]]);
            if limits.concern(stated) && (grows || is_certain) || is_peak && may_rise {
                return None;
            }
            let error = self.error(at, stated)?;
            let least = match stated {
                Stated::PeakPressurePlace | Stated::PeakHoopPlace => {
                    let of_peak = peak_at(stated).and_then(|peak| self.error(at, peak));
                    of_peak.map_or(0.0, |error| reach(self.fine, at, stated, error))
                }
                // Slip has two ends of stick.
                Stated::SlipAway | Stated::SlipTowards => {
                    2.0 * self.error(at, Stated::StickExtent).unwrap_or(0.0)
                }
                Stated::PeakPressure if !self.nodes.are_graded() => self.unresolved(at),
                _ => 0.0,
            };
            Some(error.max(least))
        })
    }

    fn changes(&self, [step, edge]: At, stated: Stated) -> [Option<f64>; 2] {
        [&self.last, &self.before].map(|table| table.get(step)?.get(edge)?.get(stated))
    }

    fn error(&self, at: At, stated: Stated) -> Option<f64> {
        let [step, edge] = at;
        let own = self.fine.fitted[step][edge].get(stated);
        let size = self.size(at, stated)?;
        let steps = 0..self.fine.steps.len();
        let parts = steps.filter_map(|other| {
            Some(self.size([other, edge], stated)? / self.scale([other, edge], stated)?)
        });
        let wide = parts.fold(0.0, f64::max) * self.scale(at, stated).unwrap_or(0.0);
        let has_three = !self.before.is_empty();
        let factor = factors(stated, self.nodes)[usize::from(has_three)];
        let by_models = factor * size.max(WIDE * wide);
        Some(match own {
            Some(own) if self.nodes.are_graded() && stated == Stated::ContactExtent => {
                (FITTED * own).max(ENDS * by_models)
            }
            Some(_) if self.nodes.are_graded() && has_three => by_models,
            // A fit cannot resolve zones of a few nodes, where three models show how far it is off.
            Some(own) if has_three => own.max(LEAST * by_models).min(by_models.max(LEAST * own)),
            Some(own) => own.max(by_models),
            None if stated.is_of_nodes() && !self.nodes.are_graded() => {
                by_models.max(0.5 * self.fine.spacings[edge])
            }
            None => {
                // Of two models alone the largest node of the coarse one may lie near the peak by chance.
                let is_nodal = self.nodes.are_graded() && stated.is_fitted();
                let by_models = if is_nodal {
                    NODAL * by_models
                } else {
                    by_models
                };
                match stated {
                    Stated::ContactExtent => by_models.max(0.5 * self.end_spacing(at)),
                    _ => by_models,
                }
            }
        })
    }

    /// The largest distance of neighbouring nodes one of which touches `[rad or mm]`: contact ends somewhere between them.
    fn end_spacing(&self, [step, edge]: At) -> f64 {
        let geometry = &self.fine.own[step][edge];
        let rows = &self.fine.steps[step][edge].rows;
        let count = rows.len();
        let period = geometry.closed().filter(|_| !geometry.half);
        let last = if period.is_some() {
            count
        } else {
            count.saturating_sub(1)
        };
        let width = |k: usize| {
            let apart = geometry.parameter[(k + 1) % count] - geometry.parameter[k];
            period.map_or(apart, |period| apart.rem_euclid(period))
        };
        let touches = |k: usize| rows[k % count].status.touches();
        let ends = (0..last).filter(|&k| touches(k) != touches(k + 1));
        ends.map(width).fold(0.0, f64::max)
    }

    fn size(&self, at: At, stated: Stated) -> Option<f64> {
        let [last, before] = self.changes(at, stated);
        Some(last?.max(self.nodes.rate() * before.unwrap_or(0.0)))
    }

    /// By what the changes of `stated` are measured in a step; `None` where that vanishes.
    fn scale(&self, [step, edge]: At, stated: Stated) -> Option<f64> {
        let results = &self.fine.steps[step][edge];
        let scale = match stated {
            // Edges without contact have stresses alone.
            Stated::PeakPressure | Stated::PeakHoop | Stated::HoopAtBearing => {
                let pressure = Stated::PeakPressure.value(results);
                pressure.or_else(|| Stated::PeakHoop.value(results).map(f64::abs))?
            }
            Stated::FrictionForce
            | Stated::NormalForce
            | Stated::ResultantX
            | Stated::ResultantY => results.normal_force,
            Stated::FrictionWork => results.friction_work,
            Stated::ContactExtent
            | Stated::StickExtent
            | Stated::Bearing
            | Stated::PeakPressurePlace
            | Stated::PeakHoopPlace
            | Stated::SlipAway
            | Stated::SlipTowards => 1.0,
        };
        (scale > 0.0).then_some(scale)
    }

    /// What nodes cannot resolve of a largest pressure, however little models differ by chance.
    fn unresolved(&self, [step, edge]: At) -> f64 {
        let results = &self.fine.steps[step][edge];
        let extent = Stated::ContactExtent.value(results);
        let (Some((pressure, place)), Some(half)) = (results.peak_pressure, extent) else {
            return 0.0;
        };
        let spacing = Nodes::of(&self.fine.own[step][edge]).spacing(place);
        if half > 0.0 {
            UNRESOLVED * pressure * (spacing / half).min(1.0).powi(2)
        } else {
            0.0
        }
    }
}

/// k of the module's equation, of two models and of three or more.
fn factors(stated: Stated, nodes: Spaced) -> [f64; 2] {
    match nodes {
        Spaced::Graded | Spaced::GradedDeformed => of_circles(stated, nodes),
        Spaced::GradedLine => [of_lines(stated); 2],
        Spaced::Equally => [of_equal_spacings(stated); 2],
    }
}

/// Such that 95 to 97 of 100 changes of about 1000 load steps of 420 random pins hold what the finest model still changes.
fn of_circles(stated: Stated, nodes: Spaced) -> [f64; 2] {
    match stated {
        Stated::PeakPressure if nodes == Spaced::GradedDeformed => [4.7, 2.3],
        Stated::PeakPressure => [2.3, 2.1],
        Stated::PeakHoop | Stated::FrictionWork => [2.8, 1.6],
        Stated::HoopAtBearing => [2.9, 1.6],
        Stated::FrictionForce => [2.5, 1.1],
        Stated::NormalForce => [2.0, 0.9],
        Stated::ContactExtent => [1.5, 0.9],
        Stated::StickExtent => [1.7, 1.2],
        Stated::SlipAway | Stated::SlipTowards => [1.3, 0.9],
        Stated::PeakHoopPlace => [1.8, 1.2],
        Stated::Bearing | Stated::PeakPressurePlace | Stated::ResultantX | Stated::ResultantY => {
            [1.0; 2]
        }
    }
}

fn of_lines(stated: Stated) -> f64 {
    match stated {
        Stated::PeakHoop => 2.6,
        Stated::FrictionForce => 1.6,
        Stated::PeakHoopPlace => 0.7,
        Stated::ContactExtent => 1.1,
        Stated::StickExtent | Stated::SlipAway | Stated::SlipTowards => 1.5,
        Stated::PeakPressure => 2.0,
        Stated::HoopAtBearing => 2.2,
        Stated::Bearing
        | Stated::PeakPressurePlace
        | Stated::NormalForce
        | Stated::ResultantX
        | Stated::ResultantY
        | Stated::FrictionWork => 1.0,
    }
}

fn of_equal_spacings(stated: Stated) -> f64 {
    match stated {
        Stated::HoopAtBearing | Stated::ContactExtent => 1.5,
        Stated::PeakHoop => 2.5,
        Stated::StickExtent
        | Stated::PeakPressurePlace
        | Stated::PeakHoopPlace
        | Stated::SlipAway
        | Stated::SlipTowards => 2.0,
        Stated::Bearing
        | Stated::PeakPressure
        | Stated::FrictionForce
        | Stated::NormalForce
        | Stated::ResultantX
        | Stated::ResultantY
        | Stated::FrictionWork => 1.0,
    }
}
