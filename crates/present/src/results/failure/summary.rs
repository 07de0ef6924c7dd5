//! Failure in `summary.json`.

use serde::Serialize;

use super::FailureView;
use super::tables::hypotheses;
use crate::results::progressive::ProgressiveView;
use crate::results::progressive::summary::{Progressive, progressive};
use crate::results::quantity::Quantity;
use stickslip_results::{FailurePoint, FirstPly, PlyGroup};
use stickslip_text::tidy;

#[derive(Debug, Serialize)]
pub(crate) struct Failure<'a> {
    body: &'a str,
    layup: &'a str,
    cure: Quantity,
    plies: Vec<Ply<'a>>,
    criteria: &'a [&'static str],
    load_name: String,
    first_ply: Vec<First<'a>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    beside_supports: Option<BesideSupports<'a>>,
    characteristic: Option<Characteristic<'a>>,
    steps: Vec<Vec<Point<'a>>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    progressive: Option<Progressive<'a>>,
}

#[derive(Debug, Serialize)]
struct Stress {
    sigma_1: Option<f64>,
    sigma_2: Option<f64>,
    tau_12: Option<f64>,
    unit: &'static str,
}

#[derive(Debug, Serialize)]
struct Ply<'a> {
    #[serde(rename = "ply")]
    name: &'a str,
    angle_deg: Option<f64>,
    layers: Vec<usize>,
    residual_stress: Stress,
}

#[derive(Debug, Serialize)]
struct Point<'a> {
    criterion: &'a str,
    ply: &'a str,
    ply_angle_deg: Option<f64>,
    mode: &'static str,
    x: Quantity,
    y: Quantity,
    angle_deg: Option<f64>,
    radius: Option<Quantity>,
    stress: Stress,
    index: Option<f64>,
    reserve_factor: Option<f64>,
    margin: Option<f64>,
    #[serde(flatten)]
    errors: Option<PointErrors>,
}

#[derive(Debug, Serialize)]
struct PointErrors {
    #[serde(rename = "index_error")]
    index: Option<f64>,
    #[serde(rename = "reserve_factor_error")]
    reserve_factor: Option<f64>,
    #[serde(rename = "place_error")]
    place: Quantity,
}

#[derive(Debug, Serialize)]
struct First<'a> {
    criterion: &'a str,
    fails: bool,
    reached: Option<bool>,
    step: Option<usize>,
    factor: Option<f64>,
    load: Option<Quantity>,
    #[serde(skip_serializing_if = "Option::is_none")]
    load_error: Option<Quantity>,
    #[serde(skip_serializing_if = "Option::is_none")]
    joint_mode: Option<&'static str>,
    at: Option<Point<'a>>,
}

#[derive(Debug, Serialize)]
struct BesideSupports<'a> {
    distance: Quantity,
    sooner: Vec<First<'a>>,
}

#[derive(Debug, Serialize)]
struct Characteristic<'a> {
    tension: Quantity,
    compression: Quantity,
    curve: Vec<First<'a>>,
    net_section: Vec<First<'a>>,
    bearing_point: Vec<First<'a>>,
}

/// The entry of a body.
pub(crate) fn failure<'a>(view: &FailureView<'a>) -> Failure<'a> {
    let own = view.failure;
    let mut all = hypotheses(view).into_iter().map(|(_, firsts)| {
        let criteria = own.criteria.iter();
        let entries = criteria.zip(firsts).map(|(name, at)| first(view, name, at));
        entries.collect::<Vec<_>>()
    });
    let first_ply = all.next().unwrap_or_default();
    let characteristic = own.characteristic.as_ref().map(|given| {
        let mut next = || all.next().unwrap_or_default();
        let mut curve = next();
        for (entry, joint) in curve.iter_mut().zip(&given.curve) {
            entry.joint_mode = joint.as_ref().map(|joint| joint.mode.name());
        }
        Characteristic {
            tension: length(view, given.tension),
            compression: length(view, given.compression),
            curve,
            net_section: next(),
            bearing_point: next(),
        }
    });
    let beside_supports = own.beside_supports.as_ref().map(|beside| {
        let criteria = own.criteria.iter().zip(&beside.sooner);
        let found = criteria.filter(|(_, at)| at.is_some());
        BesideSupports {
            distance: length(view, beside.distance),
            sooner: found
                .map(|(name, at)| first(view, name, at.as_ref()))
                .collect(),
        }
    });
    Failure {
        body: view.body(),
        layup: &own.layup,
        cure: Quantity::new(own.cure, "K"),
        plies: own.plies.iter().map(|group| ply(view, group)).collect(),
        criteria: &own.criteria,
        load_name: view.load().name,
        first_ply,
        beside_supports,
        characteristic,
        steps: own
            .steps
            .iter()
            .map(|points| points.iter().map(|at| point(view, at)).collect())
            .collect(),
        progressive: ProgressiveView::of(*view).map(|view| progressive(&view)),
    }
}

fn length(view: &FailureView<'_>, value: f64) -> Quantity {
    Quantity::of(view.results.units.length, value)
}

fn stress(view: &FailureView<'_>, stress: [f64; 3]) -> Stress {
    let [sigma_1, sigma_2, tau_12] = stress.map(|value| tidy(view.stress(value)));
    Stress {
        sigma_1,
        sigma_2,
        tau_12,
        unit: view.stress_unit(),
    }
}

fn ply<'a>(view: &FailureView<'a>, group: &'a PlyGroup) -> Ply<'a> {
    Ply {
        name: &group.ply,
        angle_deg: tidy(group.angle),
        layers: group.layers.iter().map(|layer| layer + 1).collect(),
        residual_stress: stress(view, group.residual),
    }
}

fn point<'a>(view: &FailureView<'a>, at: &'a FailurePoint) -> Point<'a> {
    let group = &view.failure.plies[at.ply];
    let polar = view.failure.polar(at.position);
    Point {
        criterion: at.criterion,
        ply: &group.ply,
        ply_angle_deg: tidy(group.angle),
        mode: at.mode.name(),
        x: length(view, at.position[0]),
        y: length(view, at.position[1]),
        angle_deg: polar.and_then(|(angle, _)| tidy(angle.to_degrees())),
        radius: polar.map(|(_, radius)| length(view, radius)),
        stress: stress(view, at.stress),
        index: tidy(at.index),
        reserve_factor: tidy(at.reserve_factor),
        margin: tidy(at.reserve_factor - 1.0),
        errors: at.errors.map(|errors| PointErrors {
            index: errors.index.and_then(tidy),
            reserve_factor: errors.reserve_factor.and_then(tidy),
            place: length(view, errors.place),
        }),
    }
}

fn first<'a>(view: &FailureView<'a>, criterion: &'a str, found: Option<&'a FirstPly>) -> First<'a> {
    let load = found.and_then(|first| first.load.as_ref());
    let load_error = load.zip(found.and_then(|first| first.load_error));
    First {
        criterion,
        fails: found.is_some(),
        reached: found.map(|first| first.reached),
        step: found.map(|first| first.step + 1),
        factor: found.and_then(|first| tidy(first.factor)),
        load: load.map(|load| Quantity::new(load.value, load.unit.clone())),
        load_error: load_error.map(|(load, error)| Quantity::new(error, load.unit.clone())),
        joint_mode: None,
        at: found.map(|first| point(view, &first.at)),
    }
}
