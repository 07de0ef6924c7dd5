//! Charts of ply stresses and indices along an edge, of the characteristic curve, and of failure envelopes.

use stickslip_report::axis::{Axis, ends};
use stickslip_report::chart::{Band, Dash, Legend, LineChart, Panels, ReferenceLine, Series};
use stickslip_report::color::Color;

use super::{FailureView, criterion_name, plane_symbols};
use crate::results::attempt::Attempt;
use crate::results::display::EdgeView;
use crate::results::figures::edge::{TICK_INTERVALS, along, place_axis};
use stickslip_results::{EdgePlies, EdgePly, Envelope};
use stickslip_scene::schema::EnvelopePlane;
use stickslip_text::{short, significant};

/// Dashes of plies, which distinguish curves without colour.
const DASHES: [Dash; 5] = [
    Dash::Solid,
    Dash::Dashed,
    Dash::DashDotted,
    Dash::Dotted,
    Dash::LongDashed,
];

/// The step of the largest load.
fn peak(view: &FailureView<'_>) -> Option<usize> {
    view.load().peak_step()
}

fn at_load(view: &FailureView<'_>, step: usize) -> String {
    format!("At {}", view.load().step_text(step))
}

/// A quantity of every ply along the edge.
fn curves(
    view: &FailureView<'_>,
    shown: &EdgeView<'_>,
    edge: &EdgePlies,
    step: usize,
    value: impl Fn(&EdgePly) -> f64,
) -> Vec<Series> {
    let groups = edge.steps[step].iter().enumerate();
    let curve = |(group, plies): (usize, &Vec<EdgePly>)| {
        let points =
            (edge.parameter.iter().zip(plies)).map(|(&at, ply)| (place(shown, at), value(ply)));
        // A whole circle has no point twice.
        let points = along(points, shown.is_circle() && is_whole(&edge.parameter));
        Series::new(view.failure.ply_name(group), points).dash(DASHES[group % DASHES.len()])
    };
    groups.map(curve).collect()
}

/// A place of the whole edge in display units, counter-clockwise from the bearing point: the plies of two halves differ.
fn place(shown: &EdgeView<'_>, at: f64) -> f64 {
    if shown.is_circle() {
        shown.length(shown.geometry.frame.turned(at))
    } else {
        shown.length(at)
    }
}

/// "φ = 12.3°" or "x = 1.23 mm" of a place of the whole edge.
fn at_place(shown: &EdgeView<'_>, at: f64) -> String {
    format!(
        "{} = {}",
        shown.place_symbol(),
        shown.shown(place(shown, at))
    )
}

/// Whether places `[rad]` go around a circle.
fn is_whole(parameter: &[f64]) -> bool {
    let ends = parameter.first().zip(parameter.last());
    ends.is_some_and(|(first, last)| last - first > 1.5 * std::f64::consts::PI)
}

/// The axis of the whole edge.
fn whole_axis(shown: &EdgeView<'_>, intervals: f64) -> Axis {
    let ends = shown.is_circle().then_some([-180.0, 180.0]);
    place_axis(shown, ends, intervals)
}

/// Index of the first criterion along an edge, one curve per ply.
pub(crate) fn index_along(view: &FailureView<'_>, edge: &EdgePlies) -> Attempt {
    let shown = EdgeView::all(view.results)[edge.edge];
    let (Some(step), Some(criterion)) = (peak(view), view.failure.criteria.first()) else {
        return Ok(None);
    };
    let name = criterion_name(criterion);
    let title = format!("Ply failure index along '{}'", shown.geometry.name);
    let mut chart = LineChart::new(
        title,
        whole_axis(&shown, TICK_INTERVALS),
        Axis::linear(format!("Failure index, {name} [–]")),
    )
    .subtitle(format!(
        "{} · lay-up {}",
        at_load(view, step),
        view.failure.layup
    ))
    .legend(Legend::Right)
    .size(760.0, 0.5)
    .reference(ReferenceLine::horizontal("fails", 1.0));
    for series in curves(view, &shown, edge, step, |ply| {
        ply.index.first().copied().unwrap_or(f64::NAN)
    }) {
        chart = chart.with(series);
    }
    let largest = largest(edge, step, |ply| ply.index.first().copied().unwrap_or(0.0));
    let caption = largest.map_or(String::new(), |(group, index, at)| {
        format!(
            "Index by {name} in each ply, at {}; a ply fails where it is 1. The largest is {} in the {} ply at {}.",
            view.load().step_text(step),
            significant(index, 4),
            view.failure.ply_name(group),
            at_place(&shown, at),
        )
    });
    Ok(Some((chart.render()?, caption)))
}

/// σ_1, σ_2 and τ_12 of every ply along an edge.
pub(crate) fn stresses_along(view: &FailureView<'_>, edge: &EdgePlies) -> Attempt {
    let shown = EdgeView::all(view.results)[edge.edge];
    let Some(step) = peak(view) else {
        return Ok(None);
    };
    let unit = view.stress_unit();
    let parts = [
        ("(a) along the fibres", "σ_1"),
        ("(b) across the fibres", "σ_2"),
        ("(c) shear", "τ_12"),
    ];
    let chart = |(k, (title, symbol)): (usize, (&str, &str))| {
        let mut chart = LineChart::new(
            title,
            whole_axis(&shown, 6.0),
            Axis::linear(format!("{symbol} [{unit}]")),
        )
        .size(400.0, 0.85);
        for series in curves(view, &shown, edge, step, |ply| view.stress(ply.stress[k])) {
            chart = chart.with(series.width(1.5));
        }
        chart
    };
    let charts = parts.into_iter().enumerate().map(chart).collect();
    let title = format!(
        "Ply stresses along '{}' at {}",
        shown.geometry.name,
        view.load().text(step)
    );
    let picture = Panels::new(title, 3, charts).common_legend().render()?;
    let transverse = largest(edge, step, |ply| ply.stress[1]);
    let caption = transverse.map_or(String::new(), |(group, stress, at)| {
        format!(
            "Stresses in the material axes of each ply, the stress of the cure included. The largest tension across fibres is {} {unit} in \
             the {} ply at {}.",
            significant(view.stress(stress), 4),
            view.failure.ply_name(group),
            at_place(&shown, at),
        )
    });
    Ok(Some((picture, caption)))
}

/// The ply with the largest value in a step, the value and its place.
fn largest(
    edge: &EdgePlies,
    step: usize,
    value: impl Fn(&EdgePly) -> f64,
) -> Option<(usize, f64, f64)> {
    let groups = edge.steps[step].iter().enumerate();
    let values = groups.flat_map(|(group, plies)| {
        let plies = plies.iter().zip(&edge.parameter);
        plies.map(move |(ply, &at)| (group, ply, at))
    });
    values
        .map(|(group, ply, at)| (group, value(ply), at))
        .max_by(|a, b| a.1.total_cmp(&b.1))
}

/// Largest index over the plies along the characteristic curve, for every load step, with the zones of the modes.
pub(crate) fn characteristic(view: &FailureView<'_>) -> Attempt {
    let (Some(given), Some(criterion), Some(step)) = (
        &view.failure.characteristic,
        view.failure.criteria.first(),
        peak(view),
    ) else {
        return Ok(None);
    };
    let name = criterion_name(criterion);
    let load = view.load();
    let from = match view.failure.frame.bearing {
        Some(_) => "Angle φ from the bearing point [deg]",
        None => "Angle θ from +x [deg]",
    };
    let x = Axis::linear(from).between(-90.0, 90.0).every(15.0);
    let y = Axis::linear(format!("Largest ply index, {name} [–]"));
    let title = format!("Characteristic curve of '{}'", view.body());
    let mut chart = LineChart::new(title, x, y)
        .subtitle(format!(
            "R_t = {}, R_c = {}",
            view.results.units.length.show(given.tension),
            view.results.units.length.show(given.compression)
        ))
        .legend(Legend::Right)
        .size(760.0, 0.55)
        .reference(ReferenceLine::horizontal("fails", 1.0));
    chart.bands = mode_bands();
    let rising = (0..=step).filter(|&k| k == step || k % step.div_ceil(6).max(1) == 0);
    let rising: Vec<usize> = rising.collect();
    let colors = stickslip_report::color::sequence(rising.len());
    for (&k, color) in rising.iter().zip(colors) {
        let points = given.angles.iter().zip(&given.index[k]);
        let points = points
            .map(|(angle, index)| [angle.to_degrees(), *index])
            .collect();
        chart = chart.with(Series::new(load.text(k), points).color(color));
    }
    let symbol = view.failure.frame.symbol();
    let mut sentences = vec![format!(
        "Index by {name} on r_c({symbol}) = R + R_t + (R_c − R_t) cos {symbol} (Chang, Scott & Springer 1982) up to the largest load; the place where it \
         first is 1 names the mode."
    )];
    sentences.extend(super::tables::joint_modes(view));
    Ok(Some((chart.render()?, sentences.join(" "))))
}

fn mode_bands() -> Vec<Band> {
    let zones = [
        ("net tension", 75.0, 90.0, Color::rgb(0x2a, 0x93, 0x5c)),
        ("shear-out", 30.0, 60.0, Color::rgb(0xe0, 0x7b, 0x1a)),
    ];
    let bearing = Band::new("bearing", -15.0, 15.0, Color::rgb(0x1f, 0x6f, 0xb4));
    let both = |(name, low, high, color): (&str, f64, f64, Color)| {
        [
            Band::new(name, -high, -low, color),
            Band::new(name, low, high, color),
        ]
    };
    zones.into_iter().flat_map(both).chain([bearing]).collect()
}

/// Envelopes of all criteria in one plane: of the first ply and, beside them, of the last.
pub(crate) fn envelopes(view: &FailureView<'_>, plane: EnvelopePlane) -> Attempt {
    let here = || {
        view.failure
            .envelopes
            .iter()
            .filter(|own| own.plane == plane)
    };
    let bounds: Vec<bool> = [false, true]
        .into_iter()
        .filter(|last| here().any(|own| own.last_ply == *last))
        .collect();
    if bounds.is_empty() {
        return Ok(None);
    }
    let layup = &view.failure.layup;
    let charts = bounds.iter().map(|&last| {
        let own: Vec<&Envelope> = here().filter(|own| own.last_ply == last).collect();
        envelope_chart(view, plane, last, &own)
    });
    let title = match view.failure.cure {
        0.0 => format!("Failure envelopes of {layup}"),
        cure => format!(
            "Failure envelopes of {layup}, {} K since the cure",
            short(cure)
        ),
    };
    let picture = Panels::new(title, 2, charts.collect())
        .common_legend()
        .render()?;
    let sentences: Vec<String> = here().filter_map(|own| tension(view, own)).collect();
    Ok(Some((picture, sentences.join(" "))))
}

fn envelope_chart(
    view: &FailureView<'_>,
    plane: EnvelopePlane,
    last: bool,
    envelopes: &[&Envelope],
) -> LineChart {
    let [first, second] = plane_symbols(plane);
    let second_part = match plane {
        EnvelopePlane::Normal => 1,
        EnvelopePlane::Shear => 2,
    };
    let shown =
        |stress: &[f64; 3]| [stress[0], stress[second_part]].map(|value| view.stress(value));
    let closed = |own: &&Envelope| {
        let mut points: Vec<[f64; 2]> = own.points.iter().map(|at| shown(&at.stress)).collect();
        points.extend(points.first().copied());
        points
    };
    let curves: Vec<Vec<[f64; 2]>> = envelopes.iter().map(closed).collect();
    let unit = view.stress_unit();
    let axis = |k: usize, symbol: &str| {
        let axis = Axis::linear(format!("Mean stress {symbol} [{unit}]"));
        let [low, high] = ends(curves.iter().flatten().map(|point| point[k]));
        let room = 0.05 * (high - low);
        if room > 0.0 {
            axis.between(low - room, high + room)
        } else {
            axis
        }
    };
    let title = if last {
        "(b) last ply"
    } else {
        "(a) first ply"
    };
    let mut chart = LineChart::new(title, axis(0, first), axis(1, second)).size(540.0, 0.85);
    for (k, (own, points)) in envelopes.iter().zip(&curves).enumerate() {
        let series = Series::new(criterion_name(own.criterion), points.clone());
        chart = chart.with(series.dash(DASHES[k % DASHES.len()]));
    }
    chart
}

/// What an envelope says of tension along x, where it begins.
fn tension(view: &FailureView<'_>, envelope: &Envelope) -> Option<String> {
    let tension = envelope.points.first()?;
    let bound = if envelope.last_ply { "last" } else { "first" };
    Some(format!(
        "{}: in tension along x the {bound} ply fails at {} {}, by {} in the {} ply.",
        criterion_name(envelope.criterion),
        significant(view.stress(tension.stress[0]), 4),
        view.stress_unit(),
        tension.mode,
        view.failure.ply_name(tension.ply),
    ))
}
