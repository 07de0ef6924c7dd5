//! The whole plate on the page, as tables, and in the summary.

mod figures;

use serde_json::{Value, json};
use stickslip_hybrid::identify::SlipFit;
use stickslip_report::table::Table;

use super::identified::describe_dynamic;
use crate::report::ExperimentReport;
use stickslip_experiment::Experiment;
use stickslip_measure::Finding;
use stickslip_measure::chain::Edges;
use stickslip_measure::finding::Located;
use stickslip_measure::identified::{Identified, describe_bounds};
use stickslip_measure::whole::WholeState;
use stickslip_report::csv;
use stickslip_text::short;

/// Reports the whole plate; nothing without a state of it.
pub fn report(experiment: &Experiment, edges: &Edges, report: &mut ExperimentReport) {
    let findings = edges.plate_findings.iter().cloned();
    let located = findings.map(|own| Located::of_all(Finding::Model(own)));
    report.findings(experiment, located);
    let states = &edges.plates;
    let Some(friction) = &edges.plate_friction else {
        return;
    };
    report.section("The whole plate without its pin");
    report.text(include_str!("whole/text.txt").trim_end());
    report.table(table(experiment, states));
    report.table(zones(experiment, states, friction));
    let found = friction.dynamic.as_ref().map_or_else(
        || "no slip zone is recognised".to_owned(),
        |fit| describe_dynamic(friction, fit, 100.0 * experiment.identify.confidence),
    );
    report.answer("Dynamic friction by the whole plate", found);
    report.figure(
        "whole-plate-ratio",
        "Shear over pressure on the hole where the pressure is clear: level where the plate slips, with the sign of the friction, and \
         between where it sticks.",
        figures::ratio(experiment, states),
    );
    report.figure(
        "whole-plate-tractions",
        "Pressure and shear on the hole with twice their standard deviation by the noise of the data.",
        figures::tractions(experiment, states),
    );
    for own in states {
        let name = &experiment.states[own.state].name;
        report.file(
            format!("whole-plate-{name}.csv"),
            "tractions on the hole of the whole plate",
            csv(experiment, own),
        );
    }
    let dynamic = friction.dynamic.as_ref().map(|fit| {
        json!({ "mu": fit.mu, "words": describe_bounds(fit.bounds), "chi_squared": fit.chi_squared, "degrees_of_freedom": fit.degrees })
    });
    let each: Vec<Value> = states.iter().map(|own| entry(experiment, own)).collect();
    report.entry(
        "whole_plate",
        json!({ "dynamic_friction": dynamic, "states": each }),
    );
}

/// Slip zones of all states, and their common coefficient.
fn zones(experiment: &Experiment, states: &[WholeState], friction: &Identified) -> Table {
    let headings = "state | slips from [deg] | to [deg] | coefficient | χ² | degrees of freedom";
    let cells = |fit: &SlipFit| {
        let [bounds, chi_squared] = [describe_bounds(fit.bounds), short(fit.chi_squared)];
        [bounds, chi_squared, fit.degrees.to_string()]
    };
    let mut table = Table::headed("Slip zones of the whole plate", headings);
    for zone in &friction.zones {
        let own = states.iter().find(|own| own.state == zone.state);
        let ends = [zone.places.start, zone.places.end.saturating_sub(1)];
        let ends = ends.map(|k| {
            let angle = own.and_then(|own| own.solution.angle.get(k));
            angle.map_or_else(String::new, |angle| format!("{:.1}", angle.to_degrees()))
        });
        let name = experiment.states[zone.state].name.clone();
        table.push([name].into_iter().chain(ends).chain(cells(&zone.fit)));
    }
    if let Some(fit) = &friction.dynamic {
        let name = ["all together", "", ""].map(str::to_owned);
        table.push(name.into_iter().chain(cells(fit)));
    }
    table
}

fn table(experiment: &Experiment, states: &[WholeState]) -> Table {
    let (force, stress) = (experiment.display.force, experiment.display.stress);
    let headings = format!(
        "state | remote load [{0}] | force on the hole [{0}] | largest pressure [{1}] | deviation of the shear [{1}] | \
         its bias by smoothing [{1}] | data | χ² per degree of freedom",
        force.name, stress.name
    );
    let size = |[x, y]: [f64; 2]| short(force.from_base(x.hypot(y)));
    let shown = |value: f64| short(stress.from_base(value));
    let rows = states.iter().map(|own| {
        let solution = &own.solution;
        let count = solution.angle.len();
        let rms = |value: &dyn Fn(usize) -> f64| {
            let squares = (0..count).map(|k| value(k) * value(k));
            (squares.sum::<f64>() / count as f64).sqrt()
        };
        let (residual, data, parameters) = solution.fit;
        [
            experiment.states[own.state].name.clone(),
            size(solution.load),
            size(solution.force),
            shown(largest_pressure(own)),
            shown(rms(&|k| solution.deviation(1, k))),
            shown(rms(&|k| solution.bias[k][1])),
            data.to_string(),
            format!("{:.3}", residual / (data as f64 - parameters).max(1.0)),
        ]
    });
    Table::headed("Balance and fit", &headings).with_rows(rows)
}

fn largest_pressure(own: &WholeState) -> f64 {
    let pressure = own.solution.tractions.pressure.iter();
    pressure.copied().fold(0.0, f64::max)
}

fn csv(experiment: &Experiment, own: &WholeState) -> Vec<u8> {
    let unit = experiment.display.stress;
    let solution = &own.solution;
    let headings = csv::headings(&format!(
        "angle [deg] | CPRESS [{0}] | deviation of CPRESS [{0}] | tau_rtheta [{0}] | deviation of tau_rtheta [{0}] | hoop stress [{0}] | \
         deviation of the hoop stress [{0}]",
        unit.name
    ));
    let rows = (0..solution.angle.len()).map(|k| {
        let stresses = [
            solution.tractions.pressure[k],
            solution.deviation(0, k),
            solution.tractions.shear[k],
            solution.deviation(1, k),
            solution.hoop[k][0],
            solution.hoop[k][1],
        ];
        let mut row = vec![solution.angle[k].to_degrees()];
        row.extend(stresses.map(|own| unit.from_base(own)));
        row
    });
    csv::numbers(headings, rows)
}

fn entry(experiment: &Experiment, own: &WholeState) -> Value {
    let (force, stress) = (experiment.display.force, experiment.display.stress);
    let solution = &own.solution;
    json!({
        "state": experiment.states[own.state].name,
        "force_unit": force.name,
        "stress_unit": stress.name,
        "load": solution.load.map(|x| force.from_base(x)),
        "force_on_hole": solution.force.map(|x| force.from_base(x)),
        "largest_pressure": stress.from_base(largest_pressure(own)),
        "chi_squared": solution.fit.0,
        "data": solution.fit.1,
    })
}
