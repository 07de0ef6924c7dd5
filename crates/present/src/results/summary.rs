//! `summary.json`: the numbers that other programs read. The format is described in `docs/summary-format.md`.

mod keys;

use std::collections::BTreeMap;

use stickslip_contact::Status;
use stickslip_contact::history::Difference;

use super::bypass;
use super::choices::choices;
use super::display::{EdgeView, energy, energy_unit};
use super::failure::{self, FailureView};
use super::fasteners;
use super::findings;
use super::quantities::SummaryQuantities;
use super::quantity::{Quantity, Vector};
use super::sets;
use super::stresses;
use super::zones::{contact_ranges, stick_ranges, zone_ranges};
use keys::{
    Asked, Body, Choice, ContactZone, Cycle, Edge, EdgeStep, FORMAT_VERSION, Failed, Load,
    OtherAnswer, OwnEdgeStep, Program, SlipZone, SolverNotes, Sought, Step, Summary, Tried, Units,
    Zones,
};
use stickslip_results::LoadScale;
use stickslip_results::{
    BearingSource, EdgeKind, EdgeResults, Ladder, LoadValue, PlateRows, Results, Rung, Stated,
    StepNotes,
};
use stickslip_scene::schema::{Accuracy, DisplayUnits};
use stickslip_text::tidy;

/// The summary of `results`, which are consistent.
pub(super) fn summary(results: &Results) -> Summary<'_> {
    let DisplayUnits {
        length,
        force,
        stress,
    } = results.units;
    let mut wall_time_s = BTreeMap::new();
    for (phase, seconds) in &results.phases {
        let sum = wall_time_s.entry(*phase).or_insert(0.0);
        *sum = microseconds(*sum + seconds);
    }
    Summary {
        format: "stickslip-summary",
        format_version: FORMAT_VERSION,
        title: &results.title,
        source: &results.source,
        scene_hash: &results.scene_hash,
        program: Program {
            name: "stickslip",
            version: env!("CARGO_PKG_VERSION"),
        },
        units: Units {
            length: length.name,
            force: force.name,
            stress: stress.name,
            energy: energy_unit(results.units),
            angle: "deg",
        },
        choices: choices(results).into_iter().map(choice).collect(),
        notes: findings::sentences(results),
        findings: findings::entries(&results.findings, results.units),
        bodies: results
            .bodies
            .iter()
            .map(|own| body(own, results.units))
            .collect(),
        dofs: results.bodies.iter().map(|body| body.dofs).sum(),
        factorisations: results.factorisations,
        wall_time_s,
        accuracy: results.ladder.as_ref().map(sought),
        edge: EdgeView::main(results).map(|edge| edge.geometry.name.as_str()),
        edges: EdgeView::all(results).iter().map(edge).collect(),
        fasteners: fasteners::entries(results),
        steps: steps(results),
        failure: FailureView::all(results)
            .iter()
            .map(failure::summary::failure)
            .collect(),
    }
}

fn sought(ladder: &Ladder) -> Sought {
    let tried = |rung: &Rung| Tried {
        model: rung.model.clone(),
        increments: rung.most_increments(),
        increments_of_steps: rung.increments.clone(),
        error: rung.error.and_then(|(error, _)| tidy(error)),
        of: rung.error.map(|(_, stated)| stated.describe()),
        stopped: rung.stopped,
        wall_time_s: microseconds(rung.seconds),
    };
    Sought {
        asked: ladder.asked.map(asked),
        end: ladder.end.name(),
        rungs: ladder.rungs.iter().map(tried).collect(),
    }
}

/// The relative errors that are asked for.
fn asked(accuracy: Accuracy) -> Asked {
    match accuracy {
        Accuracy::Overall(error) => Asked::Overall(error.share()),
        Accuracy::Named(bounds) => {
            let named = bounds.entries();
            Asked::Named(named.map(|(name, error)| (name, error.share())).collect())
        }
    }
}

/// A time `[s]` to the microsecond.
fn microseconds(seconds: f64) -> f64 {
    (seconds * 1e6).round() / 1e6
}

fn choice(choice: stickslip_results::Choice) -> Choice {
    Choice {
        what: choice.what,
        value: choice.value,
        reason: choice.reason,
    }
}

fn named_load(load: &LoadValue) -> Load<'_> {
    Load {
        name: &load.name,
        value: tidy(load.value),
        unit: &load.unit,
    }
}

fn body(body: &stickslip_results::BodySummary, units: DisplayUnits) -> Body<'_> {
    Body {
        name: &body.name,
        rigid: body.mesh.is_none(),
        nodes: body.mesh.as_ref().map_or(0, |mesh| mesh.nodes().len()),
        elements: body.mesh.as_ref().map_or(0, |mesh| mesh.element_count()),
        dofs: body.dofs,
        factor_entries: body.factor_entries,
        free_motions: body.free_motions,
        yield_stress: (body.yield_stress).map(|stress| Quantity::of(units.stress, stress)),
    }
}

fn edge<'a>(view: &EdgeView<'a>) -> Edge<'a> {
    let geometry = view.geometry;
    let radius = match geometry.kind {
        EdgeKind::Circle { radius, .. } => Some(Quantity::of(view.units().length, radius)),
        EdgeKind::Line | EdgeKind::Path => None,
    };
    Edge {
        name: &geometry.name,
        kind: match geometry.kind {
            EdgeKind::Circle { .. } => "circle",
            EdgeKind::Line => "line",
            EdgeKind::Path => "path",
        },
        contact: geometry.contact,
        body: view.body(),
        law: geometry.contact.then_some(geometry.law.as_str()),
        load_name: view.load().name,
        radius,
        clearance: geometry
            .clearance
            .map(|own| Quantity::of(view.units().length, own)),
        bearing_angle_deg: (geometry.frame.bearing.filter(|_| view.is_circle()))
            .and_then(|theta| tidy(theta.to_degrees())),
        bearing_found: match geometry.frame.found {
            BearingSource::Nowhere => None,
            BearingSource::Contact { step } => Some(format!("contact force of step {}", step + 1)),
            BearingSource::Load => Some("bearing load".to_owned()),
        },
        nodes: geometry.parameter.len(),
        half: geometry.half,
    }
}

fn steps(results: &Results) -> Vec<Step<'_>> {
    let scale = LoadScale::of(results);
    let edges: Vec<CountedEdge> = (EdgeView::all(results).into_iter())
        .map(|view| {
            let scale = view.load();
            CountedEdge {
                unloading: scale.unloading(),
                scale,
                view,
            }
        })
        .collect();
    let plates = results.plates_with_rows();
    (0..results.steps.len())
        .map(|step| step_entry(results, &scale, (&edges, &plates), step))
        .collect()
}

/// An edge with what its steps are counted by.
struct CountedEdge<'a> {
    view: EdgeView<'a>,
    scale: LoadScale,
    unloading: Vec<bool>,
}

fn step_entry<'a>(
    results: &'a Results,
    scale: &LoadScale,
    (edges, plates): (&[CountedEdge<'a>], &[PlateRows]),
    index: usize,
) -> Step<'a> {
    let step = &results.steps[index];
    let units = results.units;
    Step {
        number: index + 1,
        load: load(scale, index),
        loads: step.loads.iter().map(named_load).collect(),
        unloading: step.unloading,
        edge: EdgeView::main(results).map(|edge| edge_step(&edge, index)),
        edges: edges
            .iter()
            .map(|edge| (edge.view.geometry.name.as_str(), own_step(edge, index)))
            .collect(),
        sets: sets::entries(results, index),
        stresses: stresses::entries(results, index),
        fasteners: (results.fasteners.iter().zip(&step.fasteners))
            .map(|(own, step)| (own.name.as_str(), fasteners::step_entry(step, units)))
            .collect(),
        bypass: bypass::entries(results, plates, index),
        iterations: step.work.solves,
        pivots: step.work.pivots,
        solvers: &step.solvers,
        increments: step.increments,
        cutbacks: step.cutbacks,
        points_in_doubt: step.doubtful,
        solver_notes: solver_notes(&step.notes, units),
        solutions_counted: step.notes.solutions_known(),
        other_solver: step.notes.otherwise.other_solver.map(other_answer),
        finer_increments: step.notes.otherwise.finer.map(other_answer),
        friction_coefficient: tidy(step.notes.friction),
        uniqueness_estimate: step.notes.uniqueness.and_then(tidy),
        balance_residual: tidy(step.balance_residual),
        complementarity_residual: tidy(step.residuals.complementarity),
        cone_violation: tidy(step.residuals.cone),
        dissipation: work(units, step.dissipation),
        dissipation_error: (step.dissipation_error(&results.edges)).map(|error| work(units, error)),
        wall_time_s: microseconds(step.seconds),
    }
}

fn work(units: DisplayUnits, work: f64) -> Quantity {
    Quantity::new(energy(units, work), energy_unit(units))
}

/// The load of a step; `None` where only its number distinguishes the step.
fn load(scale: &LoadScale, step: usize) -> Option<Quantity> {
    scale
        .is_load()
        .then(|| Quantity::new(scale.values[step], scale.unit.clone()))
}

fn own_step(edge: &CountedEdge<'_>, step: usize) -> OwnEdgeStep {
    OwnEdgeStep {
        load: load(&edge.scale, step),
        unloading: edge.unloading[step],
        edge: edge_step(&edge.view, step),
    }
}

fn other_answer(difference: Difference) -> OtherAnswer {
    OtherAnswer {
        solver: difference.solver,
        increments: difference.increments,
        peak_pressure_change: tidy(difference.peak_pressure),
        traction_change: tidy(difference.traction),
        slip_change: tidy(difference.slip),
        dissipation_change: tidy(difference.dissipation),
    }
}

fn solver_notes(notes: &StepNotes, units: DisplayUnits) -> SolverNotes {
    let place = |&place: &[f64; 2]| Vector::of(units.length, place);
    let recovery = &notes.recovery;
    SolverNotes {
        failed: (recovery.failures.iter())
            .map(|entry| Failed {
                solver: entry.solver,
                reason: entry.kind,
                count: entry.count,
            })
            .collect(),
        first_cycle: recovery.first_cycle.as_ref().map(|cycle| Cycle {
            solver: cycle.solver,
            period: cycle.period,
            nodes: notes.cycle_places.iter().map(place).collect(),
        }),
    }
}

fn edge_step(view: &EdgeView<'_>, step: usize) -> EdgeStep {
    let edge = view.step(step);
    EdgeStep {
        zones: zones(view, step),
        quantities: SummaryQuantities::of(view, step),
        fewest_contact_nodes: edge.fewest_contact_nodes(view.geometry),
        contact_resolved: edge.is_resolved(view.geometry),
        resultant: (view.geometry.contact).then(|| Vector::of(view.units().force, edge.resultant)),
        resultant_error: resultant_errors(edge)
            .filter(|_| view.geometry.contact)
            .map(|errors| Vector::of(view.units().force, errors)),
    }
}

fn resultant_errors(edge: &EdgeResults) -> Option<[f64; 2]> {
    let [x, y] = [Stated::ResultantX, Stated::ResultantY].map(|stated| edge.errors.get(stated));
    Some([x?, y?])
}

fn zones(view: &EdgeView<'_>, step: usize) -> Zones {
    let contact = zone_list(view, contact_ranges(view, step));
    let stick = zone_list(view, stick_ranges(view, step));
    let slip = slip_zones(view, step);
    if view.is_circle() {
        Zones::Circle {
            contact_zones_deg: contact,
            stick_zones_deg: stick,
            slip_zones_deg: slip,
        }
    } else {
        Zones::Line {
            contact_zones: contact,
            stick_zones: stick,
            slip_zones: slip,
        }
    }
}

fn zone_list(view: &EdgeView<'_>, ranges: Vec<[f64; 2]>) -> Vec<ContactZone> {
    let zone = |[start, end]: [f64; 2]| ContactZone {
        start: tidy(start),
        end: tidy(end),
        unit: zone_unit(view),
    };
    ranges.into_iter().map(zone).collect()
}

fn slip_zones(view: &EdgeView<'_>, step: usize) -> Vec<SlipZone> {
    let [positive, negative] = if view.slips_about_bearing() {
        ["away", "towards"]
    } else {
        ["+", "-"]
    };
    let direction = |status: Status| match status {
        Status::SlipPositive => Some(positive),
        Status::SlipNegative => Some(negative),
        Status::Open | Status::Stick => None,
    };
    let zone = |(status, [start, end]): (Status, [f64; 2])| {
        Some(SlipZone {
            start: tidy(start),
            end: tidy(end),
            unit: zone_unit(view),
            direction: direction(status)?,
        })
    };
    zone_ranges(view, step)
        .into_iter()
        .filter_map(zone)
        .collect()
}

/// The unit of places along a line; on a circle the key names it.
fn zone_unit(view: &EdgeView<'_>) -> Option<&'static str> {
    (!view.is_circle()).then(|| view.place_unit())
}
