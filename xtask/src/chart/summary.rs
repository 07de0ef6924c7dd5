//! stickslip beside the conventional path and beside other programs: one chart for a reader in a hurry.

use stickslip_fem_core::mesh::ElementKind;
use stickslip_laboratory::problems::Problem;
use stickslip_report::FigureError;
use stickslip_report::chart::{Dash, Panels};
use stickslip_report::svg::Svg;

use super::Charts;
use super::bench::Cost;
use super::curve::{Point, cost_of};
use super::figures::{Curve, chart};
use super::methods::{self, Enforcement, Method};
use super::peers::{PeerRun, WRONG, finest_error};

/// The two jobs.
pub(super) const JOBS: [(f64, Problem); 2] = [
    (0.0, Problem::AluminiumFrictionless),
    (0.25, Problem::AluminiumFrictional),
];
/// Curves without a mesh.
const UNMESHED: usize = 2;
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
        let mut curves: Vec<Curve> = own_methods()
            .into_iter()
            .enumerate()
            .map(|(index, own)| own_curve(charts, (mu, problem), own, own_unit, index))
            .collect();
        let first = own_methods().len();
        let unmeshed = charts.unmeshed.iter().filter(|own| own.mu == mu);
        curves.extend(unmeshed.enumerate().map(|(index, own)| Curve {
            label: format!("stickslip, {} (no mesh)", own.label),
            points: scaled(&own.points, own_unit),
            spread: Vec::new(),
            color: first + index,
            dash: Dash::Solid,
            width: 3.0,
        }));
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

/// This program's curves: the default, the element that is often faster, and the conventional path.
fn own_methods() -> [(&'static str, Method); 3] {
    let linear = Method {
        element: ElementKind::Q4,
        ..Method::DEFAULT
    };
    let conventional = Method {
        enforcement: Enforcement::Conventional,
        ..Method::DEFAULT
    };
    [
        ("stickslip, Q8 (condensed, default)", Method::DEFAULT),
        ("stickslip, Q4 (condensed)", linear),
        ("stickslip, Q8 (conventional Newton)", conventional),
    ]
}

/// This program's curve, with errors no smaller than the reference is known.
fn own_curve(
    charts: &Charts,
    (mu, problem): (f64, Problem),
    (label, method): (&str, Method),
    unit: f64,
    index: usize,
) -> Curve {
    let points = own_points(charts, mu, problem, method);
    Curve {
        label: label.to_owned(),
        points: scaled(&points, unit),
        spread: charts
            .bench
            .curve(problem, method)
            .iter()
            .filter_map(|(_, measured)| Cost::Whole.spread(measured))
            .map(|ends| ends.map(|end| end / unit))
            .collect(),
        color: index,
        dash: Dash::Solid,
        width: if index < 2 { 3.0 } else { 2.0 },
    }
}

/// The same points with costs in units of `unit`.
fn scaled(points: &[Point], unit: f64) -> Vec<Point> {
    let scale = |point: &Point| Point {
        cost: point.cost / unit,
        ..*point
    };
    points.iter().map(scale).collect()
}

/// Time of the whole history over the error of the peak pressure while loading, which the other programs are judged by.
fn own_points(charts: &Charts, mu: f64, problem: Problem, method: Method) -> Vec<Point> {
    let curve = charts.bench.curve(problem, method).into_iter();
    curve
        .map(|(_, measured)| Point {
            cost: Cost::Whole.of(measured),
            error: measured.first_peak.max(finest_error(mu)),
        })
        .collect()
}

/// The element and contact discretisation that reach `error` soonest, and their seconds; the solver is the default.
fn fastest_own(charts: &Charts, mu: f64, problem: Problem, error: f64) -> Option<(String, f64)> {
    let groups = [
        methods::elements(),
        methods::projections(ElementKind::Q8),
        methods::projections(ElementKind::Q4),
    ];
    let all = groups.into_iter().flat_map(|group| group.methods);
    let meshed = all.filter_map(|(_, method)| {
        let points = own_points(charts, mu, problem, method);
        Some((method.discretisation(), cost_of(&points, error)?))
    });
    let unmeshed = charts.unmeshed.iter().filter(|own| own.mu == mu);
    let unmeshed =
        unmeshed.filter_map(|own| Some((own.label.to_owned(), cost_of(&own.points, error)?)));
    meshed.chain(unmeshed).min_by(|a, b| a.1.total_cmp(&b.1))
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
        let color = own_methods().len()
            + UNMESHED
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

/// The fastest other program at one error, beside the fastest discretisation here.
#[derive(Clone, Debug)]
pub(super) struct Duel {
    pub(super) mu: f64,
    pub(super) error: f64,
    /// Curve of the other program.
    pub(super) label: String,
    /// Its seconds, on its machine.
    pub(super) other: f64,
    /// Fastest element and contact discretisation here.
    pub(super) discretisation: String,
    /// Its seconds.
    pub(super) own: f64,
    /// Time of the other over that.
    pub(super) factor: f64,
    /// The same with either time in units of the factorisation on its machine.
    pub(super) scaled: f64,
    /// Time of the other over that of the default, if it reaches the error.
    pub(super) default: Option<f64>,
}

/// One duel for each of `errors` that both sides reach, by the same rule for both: settled errors, costs interpolated between
/// meshes.
pub(super) fn duels(charts: &Charts, errors: &[f64]) -> Vec<Duel> {
    let mut duels = Vec::new();
    for (mu, problem) in JOBS {
        let curves = peer_curves(&charts.peers, mu);
        for &error in errors {
            let fastest = curves
                .iter()
                .filter_map(|(run, points)| Some((*run, cost_of(points, error)?)))
                .min_by(|a, b| a.1.total_cmp(&b.1));
            duels.extend(fastest.and_then(|(run, cost)| duel(charts, problem, run, cost, error)));
        }
    }
    duels
}

/// Every single run of another program against the default at that run's own error, lucky or not.
pub(super) fn single_duels(charts: &Charts) -> Vec<Duel> {
    let mut duels = Vec::new();
    for (mu, problem) in JOBS {
        for run in charts.peers.iter().filter(|run| run.mu == mu) {
            let error = run.error().filter(|&error| error < WRONG);
            duels.extend(error.and_then(|error| duel(charts, problem, run, run.seconds(), error)));
        }
    }
    duels
}

/// The curves of other programs, the coarsest mesh first, each with one of its runs.
fn peer_curves(runs: &[PeerRun], mu: f64) -> Vec<(&PeerRun, Vec<Point>)> {
    let mut curves: Vec<(&PeerRun, Vec<Point>)> = Vec::new();
    for run in runs.iter().filter(|run| run.mu == mu) {
        let Some(point) = run.point().filter(|point| point.error < WRONG) else {
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

fn duel(charts: &Charts, problem: Problem, run: &PeerRun, other: f64, error: f64) -> Option<Duel> {
    let (discretisation, own) = fastest_own(charts, run.mu, problem, error)?;
    let default = own_points(charts, run.mu, problem, Method::DEFAULT);
    let factor = other / own;
    Some(Duel {
        mu: run.mu,
        error,
        label: run.label(),
        other,
        discretisation,
        own,
        factor,
        scaled: factor * charts.yardstick.seconds / run.yardstick_s,
        default: cost_of(&default, error).map(|seconds| other / seconds),
    })
}
