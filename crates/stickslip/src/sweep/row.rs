//! What is kept of a case: numbers in the display units of the sweep's scene, angles in degrees from the bearing point.

use super::Sweep;
use super::axis::tidy;
use stickslip_engine::results::{
    BodyFailure, Finding, FirstPly, JointMode, LoadScale, LoadValue, Results, Stated,
};

/// A case.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// Its number, from 0.
    pub case: usize,
    /// Time that it took `[s]`.
    pub seconds: f64,
    /// What came of it.
    pub outcome: Outcome,
}

impl Row {
    /// Its numbers, if it was solved.
    pub fn measures(&self) -> Option<&Measures> {
        match &self.outcome {
            Outcome::Solved(measures) => Some(measures),
            Outcome::Unresolved(_) => None,
        }
    }

    /// The failure on the characteristic curve, if there is one.
    pub fn joint(&self) -> Option<&JointLoad> {
        self.measures().and_then(|measures| measures.joint.as_ref())
    }
}

/// What came of a case.
#[derive(Clone, Debug, PartialEq)]
pub enum Outcome {
    /// Its numbers.
    Solved(Box<Measures>),
    /// Why it has none.
    Unresolved(String),
}

/// The numbers of a case. Contact and stresses are those of the load step with the largest load.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Measures {
    /// The load of that step, in [`Sweep::load_unit`].
    pub load: Option<f64>,
    /// Largest contact pressure of the joint, in the display unit of stress.
    pub peak_pressure: Option<f64>,
    /// Half of the angle that contact reaches over `[degree]`.
    pub contact_half_angle: Option<f64>,
    /// Largest hoop stress on the hole, in the display unit of stress, and its place `[degree]`.
    pub peak_hoop: Option<[f64; 2]>,
    /// Half of the angle of the stick zone around the bearing point `[degree]`.
    pub stick_half_angle: Option<f64>,
    /// Bearing stress |F| / (D t) of the contact force F, in the display unit of stress.
    pub bearing_stress: Option<f64>,
    /// Part of the contact in the load of its first body `[1]`, where several act on that.
    pub load_share: Option<f64>,
    /// Estimated errors of these, where the case states any.
    pub errors: MeasureErrors,
    /// The first ply to fail by any criterion.
    pub first_ply: Option<PlyFailure>,
    /// Failure on the characteristic curve.
    pub joint: Option<JointLoad>,
    /// Kinds of the findings of its run, each once; `None` in rows of versions that kept none.
    pub findings: Option<Vec<String>>,
}

/// Estimated errors of the numbers of a contact, in the units of these.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct MeasureErrors {
    /// Of the largest contact pressure.
    pub peak_pressure: Option<f64>,
    /// Of half of the angle that contact reaches over `[degree]`.
    pub contact_half_angle: Option<f64>,
    /// Of the largest hoop stress.
    pub peak_hoop: Option<f64>,
    /// Of its place `[degree]`.
    pub peak_hoop_angle: Option<f64>,
    /// Of half of the angle of the stick zone `[degree]`.
    pub stick_half_angle: Option<f64>,
    /// Of the bearing stress.
    pub bearing_stress: Option<f64>,
    /// Of the part in the load.
    pub load_share: Option<f64>,
}

/// The first ply to fail.
#[derive(Clone, Debug, PartialEq)]
pub struct PlyFailure {
    /// Its load, in [`Sweep::load_unit`].
    pub load: Option<f64>,
    /// Estimated error of the load, in its unit, where the case states one.
    pub load_error: Option<f64>,
    /// Its direction, with its name where there are several plies.
    pub ply: String,
    /// The criterion that fails first.
    pub criterion: String,
    /// How it fails.
    pub mode: String,
    /// Where, about the hole `[degree]`.
    pub angle: Option<f64>,
    /// Whether the load history reaches it; otherwise the largest load was multiplied.
    pub reached: bool,
}

/// Failure on the characteristic curve.
#[derive(Clone, Debug, PartialEq)]
pub struct JointLoad {
    /// Its load, in [`Sweep::load_unit`].
    pub load: Option<f64>,
    /// Estimated error of the load, in its unit, where the case states one.
    pub load_error: Option<f64>,
    /// That load over D t, in the display unit of stress; `None` where the load is no force.
    pub bearing_stress: Option<f64>,
    /// The mode, by the angle.
    pub mode: JointMode,
    /// Where on the curve `[degree]`.
    pub angle: f64,
    /// Whether the load history reaches it; otherwise the largest load was multiplied.
    pub reached: bool,
}

impl Measures {
    /// The numbers of a solved case of `sweep`; each to twelve digits, as tables have them.
    pub fn of(results: &Results, sweep: &Sweep) -> Self {
        let scale = LoadScale::of_edge(results, sweep.contact);
        let findings = Some(kinds(&results.findings));
        let Some(step) = scale.peak_step() else {
            return Self {
                findings,
                ..Self::default()
            };
        };
        let value = |load: Option<&LoadValue>| {
            load.filter(|load| load.unit == sweep.load_unit)
                .map(|load| tidy(load.value))
        };
        let stress = |value: f64| tidy(results.units.stress.from_base(value));
        let degrees = |angle: f64| tidy(angle.to_degrees());
        let geometry = results.edges.get(sweep.contact);
        let seen = |place: f64| geometry.map_or(place, |geometry| geometry.seen(place));
        let edge = results
            .steps
            .get(step)
            .and_then(|step| step.edges.get(sweep.contact));
        let bearing = edge
            .zip(geometry)
            .and_then(|(edge, geometry)| edge.bearing_stress(geometry));
        let share = results.load_share(sweep.contact, step);
        let of_plate = |failure: &&BodyFailure| Some(failure.body) == sweep.plate_index;
        let failure = results.failure.iter().find(of_plate);
        let reached = scale.at_failure(step, 1.0, true);
        Self {
            load: value(reached.as_ref()),
            peak_pressure: edge
                .and_then(|edge| edge.peak_pressure)
                .map(|(most, _)| stress(most)),
            contact_half_angle: edge.and_then(|edge| edge.contact_half_extent).map(degrees),
            peak_hoop: edge
                .and_then(|edge| edge.peak_hoop)
                .map(|(most, place)| [stress(most), degrees(seen(place))]),
            stick_half_angle: edge.and_then(|edge| edge.stick_half_extent).map(degrees),
            bearing_stress: bearing.map(stress),
            load_share: share.map(|share| tidy(share.part)),
            errors: edge.map_or_else(MeasureErrors::default, |edge| {
                let error = |stated| edge.errors.get(stated);
                let area = geometry.and_then(|geometry| geometry.bearing_area);
                MeasureErrors {
                    peak_pressure: error(Stated::PeakPressure).map(stress),
                    contact_half_angle: error(Stated::ContactExtent).map(degrees),
                    peak_hoop: error(Stated::PeakHoop).map(stress),
                    peak_hoop_angle: error(Stated::PeakHoopPlace).map(degrees),
                    stick_half_angle: error(Stated::StickExtent).map(degrees),
                    bearing_stress: (edge.resultant_error().zip(area))
                        .map(|(error, area)| stress(error / area)),
                    load_share: share.and_then(|share| share.error).map(tidy),
                }
            }),
            first_ply: failure.and_then(|failure| first_ply(failure, &value)),
            joint: failure.and_then(|failure| joint(failure, results, sweep, &value)),
            findings,
        }
    }
}

/// Kinds of `findings` as `summary.json` names them, each once.
fn kinds(findings: &[Finding]) -> Vec<String> {
    let mut kinds = Vec::new();
    for finding in findings {
        let entry = serde_json::to_value(finding).unwrap_or_default();
        let kind = entry["kind"].as_str().unwrap_or_default().to_owned();
        if !kinds.contains(&kind) {
            kinds.push(kind);
        }
    }
    kinds
}

/// The least load of all criteria; where no load is known, the first criterion's.
fn first_ply(
    failure: &BodyFailure,
    value: &dyn Fn(Option<&LoadValue>) -> Option<f64>,
) -> Option<PlyFailure> {
    let load = |first: &FirstPly| value(first.load.as_ref());
    let size = |first: &FirstPly| load(first).map_or(f64::INFINITY, f64::abs);
    let found = failure.first_ply.iter().flatten();
    let first = found.min_by(|a, b| size(a).total_cmp(&size(b)))?;
    Some(PlyFailure {
        load: load(first),
        load_error: load(first).and(first.load_error).map(tidy),
        ply: failure.ply_name(first.at.ply),
        criterion: first.at.criterion.to_owned(),
        mode: first.at.mode.to_string(),
        angle: failure
            .polar(first.at.position)
            .map(|(angle, _)| tidy(angle.to_degrees())),
        reached: first.reached,
    })
}

fn joint(
    failure: &BodyFailure,
    results: &Results,
    sweep: &Sweep,
    value: &dyn Fn(Option<&LoadValue>) -> Option<f64>,
) -> Option<JointLoad> {
    let wanted = sweep.criterion.as_deref()?;
    let index = failure.criteria.iter().position(|name| *name == wanted)?;
    let curve = &failure.characteristic.as_ref()?.curve;
    let found = curve.get(index)?.as_ref()?;
    let load = value(found.first.load.as_ref());
    let units = &results.units;
    let area = results
        .edges
        .get(sweep.contact)
        .and_then(|edge| edge.bearing_area);
    let force = load.filter(|_| sweep.load_unit == units.force.name);
    let bearing = force
        .zip(area)
        .map(|(load, area)| load * units.force.in_base / area);
    Some(JointLoad {
        load,
        load_error: load.and(found.first.load_error).map(tidy),
        bearing_stress: bearing.map(|stress| tidy(units.stress.from_base(stress))),
        mode: found.mode,
        angle: tidy(found.angle.to_degrees()),
        reached: found.first.reached,
    })
}
