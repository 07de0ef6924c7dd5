//! stickslip beside the conventional path and beside other programs: one chart for a reader in a hurry.

use stickslip_laboratory::problems::Problem;
use stickslip_report::FigureError;
use stickslip_report::chart::{Dash, Panels};
use stickslip_report::svg::Svg;

use super::Charts;
use super::bench::{Cost, Quantity};
use super::curve::{Point, cost_of};
use super::figures::{Curve, chart};
use super::methods::{Enforcement, Method};
use super::peers::{PeerRun, finest_error};

/// A run that claims convergence with an error beyond this is a wrong answer, and off the chart.
pub(super) const WRONG: f64 = 0.2;
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
        "Processor time of the whole history, one thread [s]",
        1.0,
        |_| 1.0,
    )
}

/// The same in units of a factorisation of about 41 000 unknowns on the same machine.
pub(super) fn factorisations(charts: &Charts) -> Result<Svg, FigureError> {
    panels(
        charts,
        "The same in factorisations of a sparse matrix of 41 000 unknowns on the same machine",
        "Processor time over that of one factorisation",
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
    let parts = JOBS.map(|(mu, problem)| {
        let name = if mu == 0.0 {
            "Frictionless".to_owned()
        } else {
            format!("Friction, μ = {mu}")
        };
        let mut curves: Vec<Curve> = OWN
            .into_iter()
            .enumerate()
            .map(|(index, own)| own_curve(charts, (mu, problem), own, own_unit, index))
            .collect();
        curves.extend(families.iter().map(|family| {
            let runs = charts.peers.iter();
            Curve {
                label: family.label.clone(),
                points: runs
                    .filter(|run| run.mu == mu && legend(run) == family.label)
                    .filter_map(|run| {
                        let point = run.point().filter(|point| point.error < WRONG)?;
                        Some(Point {
                            cost: point.cost / unit(run),
                            ..point
                        })
                    })
                    .collect(),
                spread: Vec::new(),
                color: family.color,
                dash: family.dash,
                width: 1.2,
            }
        }));
        let error = "Relative error of the peak pressure";
        chart(&name, cost, error, &curves, finest_error(mu)).size(WIDTH, ASPECT)
    });
    Panels::new(title, 2, parts.into()).common_legend().render()
}

const OWN: [(&str, Enforcement); 2] = [
    ("stickslip, Q8 (condensed, default)", Enforcement::DEFAULT),
    (
        "stickslip, Q8 (conventional Newton)",
        Enforcement::Conventional,
    ),
];

/// This program's curve, with errors no smaller than the reference is known.
fn own_curve(
    charts: &Charts,
    (mu, problem): (f64, Problem),
    (label, enforcement): (&str, Enforcement),
    unit: f64,
    index: usize,
) -> Curve {
    let method = Method {
        enforcement,
        ..Method::DEFAULT
    };
    let scaled = |point: Point| Point {
        cost: point.cost / unit,
        ..point
    };
    let points = own_points(charts, mu, problem, method);
    Curve {
        label: label.to_owned(),
        points: points.into_iter().map(scaled).collect(),
        spread: charts
            .bench
            .curve(problem, method)
            .iter()
            .filter_map(|(_, measured)| Cost::Whole.spread(measured))
            .map(|ends| ends.map(|end| end / unit))
            .collect(),
        color: index,
        dash: Dash::Solid,
        width: if index == 0 { 3.0 } else { 2.0 },
    }
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

/// Label of a run's curve, with the day on which it was measured.
fn legend(run: &PeerRun) -> String {
    format!("{} ({})", run.label(), run.measured)
}

fn families(runs: &[PeerRun]) -> Vec<Family> {
    let mut methods: Vec<(&str, &str)> = Vec::new();
    let mut families: Vec<Family> = Vec::new();
    for run in runs {
        let label = legend(run);
        let shown = run.error().is_some_and(|error| error < WRONG);
        if !shown || families.iter().any(|family| family.label == label) {
            continue;
        }
        let method = (run.program.as_str(), run.contact.as_str());
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

/// The fastest other program at one error, beside the default here.
#[derive(Clone, Debug)]
pub(super) struct Duel {
    pub(super) mu: f64,
    pub(super) error: f64,
    /// Curve of the other program.
    pub(super) label: String,
    /// Its seconds, on its machine.
    pub(super) other: f64,
    /// Seconds of the default, here.
    pub(super) own: f64,
    /// Time of the other over that of the default.
    pub(super) factor: f64,
    /// The same with either time in units of the factorisation on its machine.
    pub(super) scaled: f64,
}

/// One duel for each of `errors` that both sides reach, by the same rule for both: settled errors, costs interpolated between
/// meshes.
pub(super) fn duels(charts: &Charts, errors: &[f64]) -> Vec<Duel> {
    let mut duels = Vec::new();
    for (mu, problem) in JOBS {
        let own = own_points(charts, mu, problem, Method::DEFAULT);
        let curves = peer_curves(&charts.peers, mu);
        for &error in errors {
            let fastest = curves
                .iter()
                .filter_map(|(run, points)| Some((*run, cost_of(points, error)?)))
                .min_by(|a, b| a.1.total_cmp(&b.1));
            duels.extend(fastest.and_then(|(run, cost)| duel(charts, run, cost, error, &own)));
        }
    }
    duels
}

/// Every single run of another program against the default at that run's own error, lucky or not.
pub(super) fn single_duels(charts: &Charts) -> Vec<Duel> {
    let mut duels = Vec::new();
    for (mu, problem) in JOBS {
        let own = own_points(charts, mu, problem, Method::DEFAULT);
        for run in charts.peers.iter().filter(|run| run.mu == mu) {
            let error = run.error().filter(|&error| error < WRONG);
            duels.extend(error.and_then(|error| duel(charts, run, run.seconds(), error, &own)));
        }
    }
    duels
}

/// The curves of other programs, the coarsest mesh first, each with one of its runs.
fn peer_curves(runs: &[PeerRun], mu: f64) -> Vec<(&PeerRun, Vec<Point>)> {
    let mut curves: Vec<(&PeerRun, Vec<Point>)> = Vec::new();
    for run in runs.iter().filter(|run| run.mu == mu) {
        let Some(point) = run.point() else {
            continue;
        };
        match curves
            .iter_mut()
            .find(|(other, _)| other.label() == run.label())
        {
            Some((_, points)) => points.push(point),
            None => curves.push((run, vec![point])),
        }
    }
    curves
}

fn duel(charts: &Charts, run: &PeerRun, other: f64, error: f64, own: &[Point]) -> Option<Duel> {
    let own = cost_of(own, error)?;
    let factor = other / own;
    Some(Duel {
        mu: run.mu,
        error,
        label: run.label(),
        other,
        own,
        factor,
        scaled: factor * charts.yardstick.seconds / run.yardstick_s,
    })
}
