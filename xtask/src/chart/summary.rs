//! stickslip beside the conventional path and beside other programs: one chart for a reader in a hurry.

use stickslip_laboratory::problems::Problem;
use stickslip_report::FigureError;
use stickslip_report::axis::Axis;
use stickslip_report::chart::{Dash, LineChart, Panels, Series, SeriesStyle};
use stickslip_report::color::Color;
use stickslip_report::svg::Svg;

use super::Charts;
use super::bench::{Cost, Quantity};
use super::curve::{Point, cost_of};
use super::methods::{Enforcement, Method};
use super::peers::{PeerRun, finest_error};

/// A run that claims convergence with an error beyond this is a wrong answer, and off the chart.
pub(super) const WRONG: f64 = 0.5;
/// The two jobs.
pub(super) const JOBS: [(f64, Problem); 2] = [
    (0.0, Problem::AluminiumFrictionless),
    (0.25, Problem::AluminiumFrictional),
];
const WIDTH: f64 = 500.0;
const ASPECT: f64 = 0.75;

/// Seconds, each on the machine on which it was measured.
pub(super) fn seconds(charts: &Charts) -> Result<Svg, FigureError> {
    panels(
        charts,
        "Peak pressure of a pin joint, 14 load steps: error over time",
        "Wall time of the whole history, one thread [s]",
        1.0,
        |_| 1.0,
    )
}

/// The same in units of a factorisation of about 41 000 unknowns on the same machine.
pub(super) fn factorisations(charts: &Charts) -> Result<Svg, FigureError> {
    panels(
        charts,
        "The same in units of one sparse Cholesky factorisation of 41 000 unknowns on the same machine",
        "Time of the whole history over that of the factorisation",
        charts.yardstick.seconds,
        |run| run.yardstick_s,
    )
}

fn panels(
    charts: &Charts,
    title: &str,
    cost: &str,
    own_unit: f64,
    unit: impl Fn(&PeerRun) -> f64,
) -> Result<Svg, FigureError> {
    let families = families(&charts.peers);
    let parts = JOBS
        .iter()
        .map(|&(mu, problem)| {
            let name = if mu == 0.0 {
                "Frictionless".to_owned()
            } else {
                format!("Friction, μ = {mu}")
            };
            let axes = [
                Axis::log(cost),
                Axis::log("Relative error of the peak pressure"),
            ];
            let [x, y] = axes;
            let mut chart = LineChart::new(name, x, y).size(WIDTH, ASPECT);
            for (index, (label, enforcement)) in OWN.into_iter().enumerate() {
                chart = chart.with(own(
                    charts,
                    mu,
                    problem,
                    enforcement,
                    own_unit,
                    label,
                    index,
                ));
            }
            for family in &families {
                let points = charts
                    .peers
                    .iter()
                    .filter(|run| run.mu == mu && run.label() == family.label)
                    .filter_map(|run| {
                        let point = run.point().filter(|point| point.error < WRONG)?;
                        Some([point.cost / unit(run), point.error])
                    })
                    .collect();
                chart = chart.with(
                    Series::new(family.label.clone(), points)
                        .style(SeriesStyle::Both)
                        .width(1.2)
                        .color(Color::category(family.color))
                        .dash(family.dash),
                );
            }
            chart
        })
        .collect();
    Panels::new(title, 2, parts).common_legend().render()
}

const OWN: [(&str, Enforcement); 2] = [
    ("stickslip, Q8 (condensed, default)", Enforcement::DEFAULT),
    (
        "stickslip, Q8 (conventional Newton)",
        Enforcement::Conventional,
    ),
];

/// This program's curve, with errors no smaller than the reference is known.
fn own(
    charts: &Charts,
    mu: f64,
    problem: Problem,
    enforcement: Enforcement,
    unit: f64,
    label: &str,
    index: usize,
) -> Series {
    let method = Method {
        enforcement,
        ..Method::DEFAULT
    };
    let points = own_points(charts, mu, problem, method);
    let spread = charts
        .bench
        .curve(problem, method)
        .iter()
        .filter_map(|(_, measured)| Cost::Whole.spread(measured))
        .map(|ends| ends.map(|end| end / unit))
        .collect();
    let pairs = points
        .iter()
        .map(|point| [point.cost / unit, point.error])
        .collect();
    Series::new(label, pairs)
        .style(SeriesStyle::Both)
        .width(if index == 0 { 3.0 } else { 2.0 })
        .spread(spread)
        .color(Color::category(index))
}

fn own_points(charts: &Charts, mu: f64, problem: Problem, method: Method) -> Vec<Point> {
    let points = charts
        .bench
        .points(problem, method, Cost::Whole, Quantity::PeakPressure);
    let known = |point: Point| Point {
        error: point.error.max(finest_error(mu)),
        ..point
    };
    points.into_iter().map(known).collect()
}

/// The other programs' curves: one colour for a program's contact method, dashes for quadratic elements.
struct Family {
    label: String,
    color: usize,
    dash: Dash,
}

fn families(runs: &[PeerRun]) -> Vec<Family> {
    let mut methods: Vec<(String, String)> = Vec::new();
    let mut families: Vec<Family> = Vec::new();
    for run in runs {
        let label = run.label();
        let shown = run.error().is_some_and(|error| error < WRONG);
        if !shown || families.iter().any(|family| family.label == label) {
            continue;
        }
        let method = (run.program.clone(), run.contact.clone());
        let known = methods.iter().position(|other| *other == method);
        let color = OWN.len()
            + known.unwrap_or_else(|| {
                methods.push(method);
                methods.len() - 1
            });
        families.push(Family {
            label,
            color,
            dash: if run.element.starts_with("Q8") {
                Dash::Dashed
            } else {
                Dash::Solid
            },
        });
    }
    families
}

/// The fastest run of another program at one error, beside the default here.
#[derive(Clone, Debug)]
pub(super) struct Duel {
    pub(super) mu: f64,
    pub(super) error: f64,
    pub(super) run: PeerRun,
    /// Seconds of the default, here.
    pub(super) own: f64,
    /// Time of the other over that of the default.
    pub(super) factor: f64,
    /// The same with either time in units of the factorisation on its machine.
    pub(super) scaled: f64,
}

/// One duel for each of `errors` that both sides reach.
pub(super) fn duels(charts: &Charts, errors: &[f64]) -> Vec<Duel> {
    let mut duels = Vec::new();
    for (mu, problem) in JOBS {
        let own = own_points(charts, mu, problem, Method::DEFAULT);
        for &error in errors {
            let fastest = charts
                .peers
                .iter()
                .filter(|run| run.mu == mu && run.error().is_some_and(|found| found <= error))
                .min_by(|a, b| a.seconds().total_cmp(&b.seconds()));
            duels.extend(fastest.and_then(|run| duel(charts, run, error, &own)));
        }
    }
    duels
}

/// Every run of another program against the default at that run's own error.
pub(super) fn all_duels(charts: &Charts) -> Vec<Duel> {
    let mut duels = Vec::new();
    for (mu, problem) in JOBS {
        let own = own_points(charts, mu, problem, Method::DEFAULT);
        for run in charts.peers.iter().filter(|run| run.mu == mu) {
            let error = run.error().filter(|&error| error < WRONG);
            duels.extend(error.and_then(|error| duel(charts, run, error, &own)));
        }
    }
    duels
}

fn duel(charts: &Charts, run: &PeerRun, error: f64, own: &[Point]) -> Option<Duel> {
    let own = cost_of(own, error)?;
    let factor = run.seconds() / own;
    Some(Duel {
        mu: run.mu,
        error,
        run: run.clone(),
        own,
        factor,
        scaled: factor * charts.yardstick.seconds / run.yardstick_s,
    })
}
