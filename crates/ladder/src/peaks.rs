//! Peaks of stress and ends of contact between nodes, by the expansions of [`stickslip_contact::peaks`], with the errors that these estimate.

use stickslip_contact::peaks::{EdgeValues, Located, edge_peak, locate_end};
use stickslip_contact::{ContactState, Contacts, StepRecord};

use stickslip_engine::model::{Model, ModelEdge};
use stickslip_engine::results::{EdgeGeometry, EdgeKind, EdgeResults, EdgeRow, Errors, Stated};
use stickslip_engine::run::Solved;
use stickslip_engine::run::seats::Faced;
use stickslip_engine::series::is_isotropic;

/// Part of a largest stress, or of the largest pressure, beyond which the error of its fit is useless: fits through few nodes at several ends of stick overshot it by half of it and more.
const UNKNOWN: f64 = 0.25;
/// Nodes that are looked at on either side of an end of contact.
const REACH: i64 = 5;

/// Replaces the nodal peak of stress and extent of contact of every contact edge by those between nodes; returns their own errors. `own` are the edges with the nodes of every step, which are
/// those with the numbers `rows` of the model.
pub(super) fn between_nodes(
    model: &Model,
    solved: &Solved,
    geometries: &[EdgeGeometry],
    (own, rows): (&[Vec<EdgeGeometry>], &[Vec<Vec<usize>>]),
    steps: &mut [Vec<EdgeResults>],
) -> Vec<Vec<Errors>> {
    let nodes = own.iter().zip(rows);
    let each = solved.records.iter().zip(nodes).zip(steps).enumerate();
    let each = each.map(|(index, ((record, (own, rows)), step))| {
        let all = model.edges.iter().zip(geometries);
        let edges = all.zip(own).zip(rows).zip(step);
        edges
            .map(|((((edge, all), geometry), rows), results)| {
                if finds_no_cusp(model, solved, index, (edge, all), (rows, results)) {
                    return Errors::default();
                }
                let of = (edge, geometry, rows.as_slice());
                let walk = Walk::new(model, solved, record, of, results);
                walk.map_or_else(Errors::default, |walk| walk.improve(results))
            })
            .collect()
    });
    each.collect()
}

/// Whether the expansions of [`stickslip_contact::peaks`] do not describe the ends of contact: where gaps are those of the deformed geometry and nodes are paired with others that are too far
/// from what they face, pressure falls to zero linearly, not like a root.
fn finds_no_cusp(
    model: &Model,
    solved: &Solved,
    step: usize,
    (edge, geometry): (&ModelEdge, &EdgeGeometry),
    (rows, results): (&[usize], &EdgeResults),
) -> bool {
    let is_deformed = solved.records[step].contacts.is_some();
    let pair = edge.pair.filter(|_| is_deformed);
    let faced = pair.and_then(|pair| Faced::of(model, solved, step, (pair, geometry)));
    let touches = |row: usize| results.rows[row].status.touches();
    faced.is_some_and(|faced| faced.apart(rows, touches).is_some())
}

/// A contact edge in a step, its nodes in the order of growing places along e_t.
struct Walk<'a> {
    geometry: &'a EdgeGeometry,
    rows: Vec<EdgeRow>,
    /// Where it bears, as in the edge's parameter.
    bearing: Option<f64>,
    /// Arc lengths `[mm]`.
    places: Vec<f64>,
    closed: Option<f64>,
    bound: Vec<f64>,
    slip: Vec<f64>,
    isotropic: bool,
    /// Arc length per unit of the parameter, with its sign.
    scale: f64,
}

impl<'a> Walk<'a> {
    fn new(
        model: &Model,
        solved: &Solved,
        record: &StepRecord,
        (edge, geometry, rows): (&ModelEdge, &'a EdgeGeometry, &[usize]),
        results: &EdgeResults,
    ) -> Option<Self> {
        let contacts = solved.interface.contacts();
        let first = contacts.pair_points(edge.pair?).start;
        let points: Vec<usize> = rows.iter().map(|row| first + row).collect();
        let bound = points.iter().map(|&k| bound(contacts, &record.state, k));
        let slip = points.iter().map(|&k| record.slip[k]);
        let material = model.bodies[geometry.body].elastic()?.materials().first()?;
        let (scale, closed) = match geometry.kind {
            EdgeKind::Circle { radius, .. } => {
                let whole = (!geometry.half).then_some(std::f64::consts::TAU * radius);
                (radius, whole)
            }
            EdgeKind::Line | EdgeKind::Path => (-1.0, None),
        };
        let mut walk = Self {
            geometry,
            rows: results.rows.clone(),
            bearing: results.bearing.or(geometry.frame.bearing),
            places: geometry.parameter.iter().map(|at| scale * at).collect(),
            closed,
            bound: bound.collect(),
            slip: slip.collect(),
            isotropic: is_isotropic(&material.stiffness()),
            scale,
        };
        if scale < 0.0 {
            walk.rows.reverse();
            walk.places.reverse();
            walk.bound.reverse();
            walk.slip.reverse();
        }
        Some(walk)
    }

    /// Puts what lies between nodes into `results`, and returns the errors of these numbers.
    fn improve(&self, results: &mut EdgeResults) -> Errors {
        // A fit that knows its value no better says less than the largest node.
        let pressure = results.peak_pressure.map_or(0.0, |(peak, _)| peak);
        let is_known =
            |&(value, _, error): &(f64, f64, f64)| error <= UNKNOWN * value.abs().max(pressure);
        let peak = results.peak_hoop.and_then(|_| self.peak()).filter(is_known);
        if let Some((value, place, _)) = peak {
            results.peak_hoop = Some((value, place));
        }
        let extent = results.contact_half_extent.and_then(|_| self.extent());
        if let Some((extent, _)) = extent {
            results.contact_half_extent = Some(extent);
        }
        Errors::of(|stated| match stated {
            Stated::PeakHoop => peak.map(|(_, _, error)| error),
            Stated::ContactExtent => extent.map(|(_, error)| error),
            _ => None,
        })
    }

    /// The largest tangential stress, its place as in the edge's parameter, and its error.
    fn peak(&self) -> Option<(f64, f64, f64)> {
        let of = |value: fn(&EdgeRow) -> f64| -> Vec<f64> { self.rows.iter().map(value).collect() };
        let [stress, pressure, shear, gap] = [
            of(|row| row.sigma_tangential),
            of(|row| row.pressure),
            of(|row| row.shear),
            of(|row| row.gap),
        ];
        let status: Vec<_> = self.rows.iter().map(|row| row.status).collect();
        let peak = edge_peak(&EdgeValues {
            places: &self.places,
            closed: self.closed,
            stress: &stress,
            pressure: &pressure,
            shear: &shear,
            bound: &self.bound,
            gap: &gap,
            slip: &self.slip,
            status: &status,
            isotropic: self.isotropic,
        })?;
        Some((peak.value, peak.place / self.scale, peak.error))
    }

    /// Half of what contact reaches over, where it is one piece, and its error; as in the edge's parameter.
    fn extent(&self) -> Option<(f64, f64)> {
        let count = i64::try_from(self.rows.len()).ok()?;
        let last = if self.closed.is_some() {
            count
        } else {
            count - 1
        };
        let ends: Vec<Located> = (0..last).filter_map(|k| self.end(k)).collect();
        let scale = self.scale.abs();
        let symmetric = match self.geometry.kind {
            EdgeKind::Circle { .. } => self.bearing.map_or(0.0, |at| {
                if at.abs() > 1.0 {
                    std::f64::consts::PI * scale
                } else {
                    0.0
                }
            }),
            EdgeKind::Line | EdgeKind::Path => 0.0,
        };
        match (self.geometry.half, ends.as_slice()) {
            (true, [end]) => Some(((end.place - symmetric).abs() / scale, end.error / scale)),
            (false, [one, other]) => {
                let apart = (one.place - other.place).abs();
                let held = self.closed.filter(|_| self.rows[0].status.touches());
                let reach = held.map_or(apart, |length| length - apart);
                Some((0.5 * reach / scale, 0.5 * (one.error + other.error) / scale))
            }
            _ => None,
        }
    }

    /// The end of contact between the node at `position` and the next one, if there is one.
    fn end(&self, position: i64) -> Option<Located> {
        let touching = |position| self.node(position).map(|(row, _)| row.status.touches());
        let side = |from: i64, onwards: i64, value: fn(&EdgeRow) -> f64| -> Vec<[f64; 2]> {
            let nodes = (0..REACH).map_while(|step| self.node(from + onwards * step));
            let alike = nodes.take_while(|(row, _)| Some(row.status.touches()) == touching(from));
            alike.map(|(row, place)| [place, value(row)]).collect()
        };
        let pressure = |row: &EdgeRow| row.pressure;
        let gap = |row: &EdgeRow| row.gap;
        let next = position + 1;
        match (touching(position)?, touching(next)?) {
            (true, false) => locate_end(&side(position, -1, pressure), &side(next, 1, gap)),
            (false, true) => locate_end(&side(next, 1, pressure), &side(position, -1, gap)),
            _ => None,
        }
    }

    /// The node at `position` with its place; around a closed edge positions and places go on.
    fn node(&self, position: i64) -> Option<(&EdgeRow, f64)> {
        let count = i64::try_from(self.rows.len()).ok()?;
        let turns = position.div_euclid(count);
        let index = usize::try_from(position.rem_euclid(count)).ok()?;
        let beyond = match self.closed {
            Some(length) => turns as f64 * length,
            None if turns == 0 => 0.0,
            None => return None,
        };
        Some((&self.rows[index], self.places[index] + beyond))
    }
}

/// What slipping friction holds at a point `[MPa]`.
fn bound(contacts: &Contacts, state: &ContactState, k: usize) -> f64 {
    let point = &contacts.points()[k];
    let pressure = state.normal_force(k) / point.area;
    if !state.status[k].touches() || pressure <= 0.0 {
        return 0.0;
    }
    let law = contacts.law(k);
    law.bound(pressure, 0.0, &point.place, &state.history[k])
        .slip
}
