//! Numbers without a limit, which grow with every finer division.
//!
//! Where the friction of two neighbouring points differs by a jump, the tangential stress between them is infinite like the logarithm of the distance:
//! at a place from where slip leads away on both sides without a stick zone, and at an end of stick where friction drops when slip begins.
//! With bodies of unlike elasticity the pressure is infinite there too. At an end of a supported edge, at a point that is held, and at a
//! re-entrant corner, stress is infinite without any contact. Where a traction along an edge ends it depends on the side from which one comes.

use stickslip_contact::{Contacts, Status, StepRecord};

use stickslip_engine::model::Model;
use stickslip_engine::results::{EdgeGeometry, EdgeResults, EdgeRow, Stated};

/// Part of the largest stress along an edge, in size, below which the largest pull is what cells leave of none.
const SMALL: f64 = 1e-3;
/// Part by which stress where a support ends grows at least from one division to the next, if it has no limit.
pub(super) const STEEP: f64 = 0.05;
/// Part of the largest stress along an edge from which that at the end of a support may become the largest with finer cells.
const GROWS: f64 = 0.3;

/// Which numbers of an edge in a step have no limit.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Missing {
    /// The stress at the bearing point, and why.
    bearing: Option<Cause>,
    /// The largest stress, and why.
    hoop: Option<Cause>,
    /// The largest pressure.
    pressure: bool,
    /// The stress at the end of a support `[MPa]`, if finer cells may have their largest one there.
    end: Option<f64>,
}

/// Why the largest stress along an edge has no limit.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Cause {
    /// It is where friction jumps.
    Friction,
    /// It is where a support ends.
    Support,
    /// It is where a traction along an edge ends.
    Load,
    /// It is where a corner of a body presses, or at a re-entrant one.
    Corner,
}

impl Missing {
    /// Those of the edge with the index `edge` in the step of `record`.
    pub(super) fn of(
        model: &Model,
        contacts: &Contacts,
        record: &StepRecord,
        (edge, geometry, results): (usize, &EdgeGeometry, &EdgeResults),
    ) -> Self {
        let Some(pair) = model.edges[edge].pair else {
            return of_free_edge(model, record, (edge, geometry), results);
        };
        if model.edges[edge]
            .corners_that_press(&results.rows)
            .contains(&true)
        {
            return Self {
                hoop: Some(Cause::Corner),
                pressure: true,
                ..Self::default()
            };
        }
        let drops = || drops(contacts, record, pair, results);
        let turns = turns(geometry, results);
        let near = |place: Option<f64>| {
            place.is_some_and(|place| turns.iter().any(|turn| turn.holds(place)))
        };
        Self {
            bearing: near(results.bearing.or(Some(0.0))).then_some(Cause::Friction),
            hoop: (near(Stated::PeakHoopPlace.value(results)) || drops())
                .then_some(Cause::Friction),
            pressure: near(Stated::PeakPressurePlace.value(results)) && are_unlike(model, pair),
            end: None,
        }
    }

    /// Whether the end of a support is why `stated` is one of them, or may be with finer cells; either shows in two divisions.
    pub(super) fn is_of_a_support(self, stated: Stated) -> bool {
        let is_peak = matches!(stated, Stated::PeakHoop | Stated::PeakHoopPlace);
        self.why(stated) == Some(Cause::Support) || is_peak && self.end.is_some()
    }

    /// Whether the corner of a body is why, which has a finding of its own in every run.
    pub(super) fn are_of_a_corner(self) -> bool {
        self.hoop == Some(Cause::Corner)
    }

    /// Whether the end of a load is why `stated` is one of them.
    pub(super) fn is_of_a_load(self, stated: Stated) -> bool {
        self.why(stated) == Some(Cause::Load)
    }

    /// Why `stated` is one of them, if it is a stress along the edge.
    fn why(self, stated: Stated) -> Option<Cause> {
        match stated {
            Stated::HoopAtBearing => self.bearing,
            Stated::PeakHoop | Stated::PeakHoopPlace => self.hoop,
            _ => None,
        }
    }

    /// Whether stress where a support ends, which may become the largest, grew from the `coarser` model to this one.
    pub(super) fn may_rise(self, coarser: Self) -> bool {
        let grew = |(end, before): (f64, f64)| end > (1.0 + STEEP) * before;
        self.end.zip(coarser.end).is_some_and(grew)
    }

    /// Whether `stated` is one of them.
    pub(super) fn concern(self, stated: Stated) -> bool {
        match stated {
            Stated::HoopAtBearing => self.bearing.is_some(),
            Stated::PeakHoop | Stated::PeakHoopPlace => self.hoop.is_some(),
            Stated::PeakPressure => self.pressure,
            Stated::ContactExtent
            | Stated::StickExtent
            | Stated::Bearing
            | Stated::PeakPressurePlace
            | Stated::FrictionForce
            | Stated::NormalForce
            | Stated::ResultantX
            | Stated::ResultantY
            | Stated::SlipAway
            | Stated::SlipTowards
            | Stated::FrictionWork => false,
        }
    }
}

/// The numbers of the edge with the index `edge`, which touches nothing, that have no limit.
fn of_free_edge(
    model: &Model,
    record: &StepRecord,
    (edge, geometry): (usize, &EdgeGeometry),
    results: &EdgeResults,
) -> Missing {
    let own = &model.edges[edge];
    let body = &model.bodies[own.geometry.body];
    let ends: Vec<usize> = body.singular.iter().map(|place| place.node()).collect();
    let acts = |case: usize| record.state.multipliers.get(case) != Some(&0.0);
    let sheared: Vec<usize> = body.traction_ends(acts).collect();
    let at = |place: f64| {
        if own.has_beside(&ends, place) {
            Some(Cause::Support)
        } else {
            (own.has_beside(&sheared, place)).then_some(Cause::Load)
        }
    };
    let rows = results.rows.iter();
    let largest = rows
        .clone()
        .map(EdgeRow::largest_stress)
        .fold(0.0, f64::max);
    let along = rows.map(|row| row.sigma_tangential.abs());
    let is_small = along.fold(0.0, f64::max) <= SMALL * largest;
    let peak = results
        .peak_hoop
        .filter(|peak| peak.0.abs() > SMALL * largest);
    let corner =
        || (own.corner_at_peak((&body.singular, &body.corners), results)).map(|_| Cause::Corner);
    Missing {
        hoop: peak.and_then(|(_, place)| at(place).or_else(corner)),
        bearing: at(geometry.reference(results.bearing, -model.origin[0])).filter(|_| !is_small),
        end: (own.largest_end(&body.singular, results))
            .filter(|end| peak.is_some_and(|(peak, _)| *end > GROWS * peak)),
        pressure: false,
    }
}

/// Where slip leads away on both sides.
struct Turn {
    from: f64,
    to: f64,
}

impl Turn {
    fn holds(&self, place: f64) -> bool {
        let width = self.to - self.from;
        (self.from - width..=self.to + width).contains(&place)
    }
}

fn slips(row: &EdgeRow) -> bool {
    matches!(row.status, Status::SlipPositive | Status::SlipNegative) && row.shear != 0.0
}

fn turns(geometry: &EdgeGeometry, results: &EdgeResults) -> Vec<Turn> {
    let (rows, parameter) = (&results.rows, &geometry.parameter);
    let mut turns = Vec::new();
    // Between neighbours, or across one that sticks.
    for apart in [1, 2] {
        for (k, pair) in rows.windows(apart + 1).enumerate() {
            let (one, other) = (&pair[0], &pair[apart]);
            let between = pair[1..apart].iter().all(|row| row.status == Status::Stick);
            if between && slips(one) && slips(other) && one.status != other.status {
                let (from, to) = (parameter[k], parameter[k + apart]);
                turns.push(Turn { from, to });
            }
        }
    }
    // A point on a line of symmetry has the mirrored neighbour on its other side.
    if let (true, [first, second, .., before, last]) = (geometry.half, rows.as_slice()) {
        let count = parameter.len();
        if first.status.touches() && slips(second) {
            let (from, to) = (2.0 * parameter[0] - parameter[1], parameter[1]);
            turns.push(Turn { from, to });
        }
        if last.status.touches() && slips(before) {
            let [from, middle] = [parameter[count - 2], parameter[count - 1]];
            let to = 2.0 * middle - from;
            turns.push(Turn { from, to });
        }
    }
    turns
}

/// Whether friction drops at an end of stick.
fn drops(contacts: &Contacts, record: &StepRecord, pair: usize, results: &EdgeResults) -> bool {
    let mut ends = results.rows.windows(2);
    let has_end = ends.any(|pair| {
        let sticks = [0, 1].map(|k| pair[k].status == Status::Stick);
        sticks[0] != sticks[1] && pair.iter().all(|row| row.status.touches())
    });
    has_end
        && contacts.pair_points(pair).any(|k| {
            let point = &contacts.points()[k];
            let pressure = record.state.normal_force(k) / point.area;
            let history = &record.state.history[k];
            let bound = contacts.law(k).bound(pressure, 0.0, &point.place, history);
            record.state.status[k].touches() && bound.stick > bound.slip * (1.0 + 1e-9)
        })
}

/// Whether the bodies of a pair differ in elasticity.
fn are_unlike(model: &Model, pair: usize) -> bool {
    let edges = model.edges.iter().filter(|edge| edge.pair == Some(pair));
    let mut stiffness = edges.map(|edge| {
        let body = model.bodies[edge.geometry.body].elastic()?;
        Some(body.materials().first()?.stiffness())
    });
    let first = stiffness.next();
    stiffness.any(|other| Some(&other) != first.as_ref())
}
