//! Progressive failure in `summary.json`.

use serde::Serialize;

use super::reasons::reasons;
use super::tables::DEPARTURE;
use super::{ProgressiveView, mode_name};
use crate::results::findings::{Entry, entries};
use crate::results::quantity::Quantity;
use stickslip_results::{CurvePoint, PlyLoss, ProgressiveEnd};
use stickslip_text::tidy;

#[derive(Debug, Serialize)]
pub(crate) struct Progressive<'a> {
    model: &'a str,
    control: &'a str,
    first_ply: Option<Loss<'a>>,
    first_fibre: Option<Loss<'a>>,
    peak: Option<Point>,
    strength: Option<Quantity>,
    mode: Option<Call>,
    end: &'static str,
    end_reason: Option<&'a str>,
    bearing_angle_deg: Option<f64>,
    free_travel: Quantity,
    edge_departures_deg: Vec<[Option<f64>; 2]>,
    curve: Vec<Point>,
    notes: Vec<String>,
    findings: Vec<Entry>,
}

#[derive(Debug, Serialize)]
struct Point {
    step: usize,
    load: Quantity,
    displacement: Quantity,
}

#[derive(Debug, Serialize)]
struct Loss<'a> {
    ply: &'a str,
    ply_angle_deg: Option<f64>,
    layer: usize,
    mode: String,
    load: Quantity,
    displacement: Quantity,
    x: Quantity,
    y: Quantity,
    angle_deg: Option<f64>,
    radius: Option<Quantity>,
}

#[derive(Debug, Serialize)]
struct Call {
    mode: &'static str,
    bearing: Option<f64>,
    shear_out: Option<f64>,
    net_tension: Option<f64>,
    collapse: Option<f64>,
    others: Vec<&'static str>,
    reasons: Vec<String>,
}

/// The entry of a followed joint.
pub(crate) fn progressive<'a>(view: &ProgressiveView<'a>) -> Progressive<'a> {
    let own = view.progressive;
    let point = |point: &CurvePoint| Point {
        step: point.step + 1,
        load: force(view, point.load),
        displacement: length(view, point.displacement),
    };
    let (end, end_reason) = match &own.end {
        ProgressiveEnd::Completed => ("completed", None),
        ProgressiveEnd::Dropped => ("load dropped", None),
        ProgressiveEnd::Severed => ("severed", None),
        ProgressiveEnd::NoEquilibrium(cause) => ("no equilibrium", Some(cause.as_str())),
    };
    Progressive {
        model: &own.model,
        control: &own.control,
        first_ply: own.first().map(|entry| loss(view, entry)),
        first_fibre: own.first_fibre().map(|entry| loss(view, entry)),
        peak: own.curve.get(own.peak).map(point),
        strength: own.strength.map(|value| force(view, value)),
        mode: own.mode.as_ref().map(|call| {
            let [bearing, shear_out, net_tension] = call.shares.map(tidy);
            Call {
                mode: call.mode.name(),
                bearing,
                shear_out,
                net_tension,
                collapse: tidy(call.collapse),
                others: call.others.iter().map(|mode| mode.name()).collect(),
                reasons: reasons(call),
            }
        }),
        end,
        end_reason,
        bearing_angle_deg: tidy(own.frame.bearing.unwrap_or_default().to_degrees()),
        free_travel: length(view, own.free_travel),
        edge_departures_deg: (own.departures(DEPARTURE).into_iter())
            .map(|range| range.map(|angle| tidy(angle.to_degrees())))
            .collect(),
        curve: own.curve.iter().map(point).collect(),
        notes: view.notes(),
        findings: entries(&own.findings, view.failure.results.units),
    }
}

fn force(view: &ProgressiveView<'_>, value: f64) -> Quantity {
    Quantity::new(view.force(value), view.force_unit())
}

fn length(view: &ProgressiveView<'_>, value: f64) -> Quantity {
    Quantity::new(view.failure.length(value), view.length_unit())
}

fn loss<'a>(view: &ProgressiveView<'a>, entry: &PlyLoss) -> Loss<'a> {
    let group = &view.failure.failure.plies[entry.ply];
    let polar = view.polar(entry.position);
    Loss {
        ply: &group.ply,
        ply_angle_deg: tidy(group.angle),
        layer: entry.layer + 1,
        mode: mode_name(entry),
        load: force(view, entry.load),
        displacement: length(view, entry.displacement),
        x: length(view, entry.position[0]),
        y: length(view, entry.position[1]),
        angle_deg: polar.and_then(|[angle, _]| tidy(angle)),
        radius: polar.map(|[_, radius]| Quantity::new(radius, view.length_unit())),
    }
}
