//! The charts: errors over costs in panels with one legend, the Pareto front behind the curves.

use stickslip_laboratory::problems::Problem;
use stickslip_report::FigureError;
use stickslip_report::axis::Axis;
use stickslip_report::chart::{Dash, LineChart, Panels, Series, SeriesStyle};
use stickslip_report::color::Color;
use stickslip_report::svg::Svg;

use super::bench::{Bench, Cost, Quantity};
use super::curve::{Point, front};
use super::factors::PathFactor;
use super::methods::{Group, Method};

const WIDTH: f64 = 400.0;
const ASPECT: f64 = 0.85;
const FRONT_COLOR: Color = Color::rgb(0xd5, 0xd5, 0xd5);
const FRONT_WIDTH: f64 = 7.0;
const FRONT_LABEL: &str = "Pareto front of the settled errors";
const KNOWN_COLOR: Color = Color::rgb(0x77, 0x77, 0x77);
/// That line is drawn from this part of the smallest error on.
const NEAR: f64 = 0.2;
const KNOWN_LABEL: &str = "What the reference is known to";

/// A curve of a chart: points, with the spread of their costs.
#[derive(Clone, Debug)]
pub(super) struct Curve {
    pub(super) label: String,
    pub(super) points: Vec<Point>,
    pub(super) spread: Vec<[f64; 2]>,
    /// Category of its colour.
    pub(super) color: usize,
    pub(super) dash: Dash,
    pub(super) width: f64,
}

impl Curve {
    fn of(
        bench: &Bench,
        problem: Problem,
        (index, (label, method)): (usize, &(String, Method)),
        cost: Cost,
        quantity: Quantity,
    ) -> Self {
        let mut spread = Vec::new();
        if cost != Cost::Unknowns {
            for (_, measured) in bench.curve(problem, *method) {
                spread.extend(cost.spread(measured));
            }
        }
        Self {
            label: label.clone(),
            points: bench.points(problem, *method, cost, quantity),
            spread,
            color: index,
            dash: Dash::Solid,
            width: 1.8,
        }
    }
}

/// A log–log chart of `curves`, with their front behind them and a line at the error that the reference has itself.
pub(super) fn chart(
    title: &str,
    cost: &str,
    error: &str,
    curves: &[Curve],
    known: f64,
) -> LineChart {
    let pareto: Vec<Vec<Point>> = curves.iter().map(|curve| curve.points.clone()).collect();
    let mut chart = LineChart::new(title, Axis::log(cost), Axis::log(error))
        .size(WIDTH, ASPECT)
        .with(
            Series::new(FRONT_LABEL, pairs(&front(&pareto)))
                .style(SeriesStyle::Step)
                .color(FRONT_COLOR)
                .width(FRONT_WIDTH),
        );
    for curve in curves {
        chart = chart.with(
            Series::new(curve.label.clone(), pairs(&curve.points))
                .style(SeriesStyle::Both)
                .spread(curve.spread.clone())
                .color(Color::category(curve.color))
                .dash(curve.dash)
                .width(curve.width),
        );
    }
    // Last, so that markers of curves are the same with and without it.
    let line = known_line(curves, known);
    if !line.is_empty() {
        chart = chart.with(
            Series::new(KNOWN_LABEL, line)
                .color(KNOWN_COLOR)
                .dash(Dash::Dotted),
        );
    }
    chart
}

/// A level line over all curves, where they come near it.
fn known_line(curves: &[Curve], known: f64) -> Vec<[f64; 2]> {
    let points = || curves.iter().flat_map(|curve| &curve.points);
    let least = points()
        .map(|point| point.error)
        .fold(f64::INFINITY, f64::min);
    if known < NEAR * least {
        return Vec::new();
    }
    let costs = points().map(|point| point.cost);
    let low = costs.clone().fold(f64::INFINITY, f64::min);
    let high = costs.fold(0.0, f64::max);
    vec![[low, known], [high, known]]
}

fn pairs(points: &[Point]) -> Vec<[f64; 2]> {
    points
        .iter()
        .map(|point| [point.cost, point.error])
        .collect()
}

/// An error over a cost for the methods of a group on a problem.
fn methods_chart(
    bench: &Bench,
    (title, problem): (&str, Problem),
    group: &Group,
    cost: Cost,
    quantity: Quantity,
) -> LineChart {
    let methods = group.methods.iter().enumerate();
    let curves: Vec<Curve> = methods
        .map(|method| Curve::of(bench, problem, method, cost, quantity))
        .collect();
    let error = format!("Relative error of the {}", quantity.name());
    let known = quantity.of(&problem.known()).unwrap_or(0.0);
    chart(title, cost.label(), &error, &curves, known)
}

/// One problem: every error over one cost.
pub(super) fn problem_figure(
    bench: &Bench,
    problem: Problem,
    group: &Group,
    cost: Cost,
) -> Result<Svg, FigureError> {
    let charts = bench
        .known(problem)
        .map(|quantity| methods_chart(bench, ("", problem), group, cost, quantity));
    let title = format!("{}: {}", problem.title(), group.title.to_lowercase());
    let panels = Panels::new(title, 3, charts.collect());
    panels.common_legend().render()
}

/// One error over one cost, in a panel for each problem.
pub(super) fn overview(
    bench: &Bench,
    group: &Group,
    cost: Cost,
    quantity: Quantity,
) -> Result<Svg, FigureError> {
    let chart = |own: Problem| methods_chart(bench, (own.title(), own), group, cost, quantity);
    let panels = Panels::new(group.title, 3, Problem::ALL.map(chart).into());
    panels.common_legend().render()
}

/// What contact alone costs over the size of the model, in a panel for each problem.
pub(super) fn contact_cost(bench: &Bench, group: &Group) -> Result<Svg, FigureError> {
    let chart = |problem: Problem| {
        let [x, y] = [Cost::Unknowns, Cost::Contact].map(|cost| Axis::log(cost.label()));
        let chart = LineChart::new(problem.title(), x, y).size(WIDTH, ASPECT);
        let curves = group.methods.iter().map(|(label, method)| {
            let meshes = bench.curve(problem, *method).into_iter();
            let points = meshes.map(|(_, m)| [m.unknowns as f64, m.contact.median]);
            (label.clone(), points.collect())
        });
        with_markers(chart, curves)
    };
    let title = format!("{}: cost of contact alone", group.title);
    let panels = Panels::new(title, 3, Problem::ALL.map(chart).into());
    panels.common_legend().render()
}

/// Curves through markers in the colours of their order.
fn with_markers(
    chart: LineChart,
    curves: impl Iterator<Item = (String, Vec<[f64; 2]>)>,
) -> LineChart {
    curves
        .enumerate()
        .fold(chart, |chart, (index, (label, points))| {
            let series = Series::new(label, points).style(SeriesStyle::Both);
            chart.with(series.color(Color::category(index)))
        })
}

/// The conventional path's time over the condensed one's on the same meshes, a curve for each problem.
pub(super) fn path_factors(factors: &[PathFactor]) -> Result<Svg, FigureError> {
    let chart = LineChart::new(
        "Conventional path against condensed path, same meshes, same answers",
        Axis::log(Cost::Unknowns.label()),
        Axis::log("Time for matrices and contact, conventional / condensed"),
    )
    .size(720.0, 0.55);
    let curves = Problem::ALL.into_iter().map(|problem| {
        let own = factors.iter().filter(|factor| factor.problem == problem);
        let points = own.map(|factor| [factor.unknowns as f64, factor.factor()]);
        (problem.title().to_owned(), points.collect())
    });
    with_markers(chart, curves).render()
}
