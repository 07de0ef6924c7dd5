//! The whole plate on the page, as tables, and in the summary.

mod figures;

use serde_json::{Value, json};
use stickslip_report::table::{Column, Table};

use super::identified::dynamic_words;
use crate::experiment::story::{Story, csv_table};
use stickslip_measure::Finding;
use stickslip_measure::chain::Edges;
use stickslip_measure::finding::Located;
use stickslip_measure::identified::{Identified, words};
use stickslip_measure::whole::WholeState;
use stickslip_scene::experiment::Experiment;
use stickslip_text::short;

/// Tells of the whole plate; nothing where there is no state of it.
pub fn tell(experiment: &Experiment, edges: &Edges, story: &mut Story) {
    let findings = edges.plate_findings.iter().cloned();
    let located = findings.map(|own| Located::of_all(Finding::Model(own)));
    story.report(experiment, located);
    let states = &edges.plates;
    let Some(friction) = &edges.plate_friction else {
        return;
    };
    story.section("The whole plate without its pin");
    story.text(
        "The plate of the scene under its remote load, its hole displaced so that all measured displacements are met best: every other edge \
         is free or carries a known load, so that the tractions on the hole balance the remote load exactly, and nothing but the hole's own \
         displacements is asked of the data (report II 4.3, Figs 10–13).",
    );
    story.table(table(experiment, states));
    story.table(zones(experiment, states, friction));
    let found = friction.dynamic.as_ref().map_or_else(
        || "no slip zone is recognised".to_owned(),
        |fit| dynamic_words(friction, fit, 100.0 * experiment.identify.confidence),
    );
    story.answer("Dynamic friction by the whole plate", found);
    story.figure(
        "whole-plate-ratio",
        "Shear over pressure on the hole where the pressure is clear: level where the plate slips, with the sign of the friction, and \
         between where it sticks.",
        figures::ratio(experiment, states),
    );
    story.figure(
        "whole-plate-tractions",
        "Pressure and shear on the hole with twice their standard deviation by the noise of the data.",
        figures::tractions(experiment, states),
    );
    for own in states {
        let name = &experiment.states[own.state].name;
        story.file(
            format!("whole-plate-{name}.csv"),
            "tractions on the hole of the whole plate",
            csv(experiment, own),
        );
    }
    let dynamic = friction.dynamic.as_ref().map(|fit| {
        json!({ "mu": fit.mu, "words": words(fit.bounds), "chi_squared": fit.chi_squared, "degrees_of_freedom": fit.degrees })
    });
    let each: Vec<Value> = states.iter().map(|own| entry(experiment, own)).collect();
    story.entry(
        "whole_plate",
        json!({ "dynamic_friction": dynamic, "states": each }),
    );
}

/// Slip zones of all states, and their common coefficient.
fn zones(experiment: &Experiment, states: &[WholeState], friction: &Identified) -> Table {
    let columns = vec![
        Column::new("state", ""),
        Column::new("slips from", "deg"),
        Column::new("to", "deg"),
        Column::new("coefficient", ""),
        Column::new("χ²", ""),
        Column::new("degrees of freedom", ""),
    ];
    let mut table = Table::new("Slip zones of the whole plate", columns);
    for zone in &friction.zones {
        let own = states.iter().find(|own| own.state == zone.state);
        let degrees = |k: usize| {
            let angle = own.and_then(|own| own.solution.angle.get(k));
            angle.map_or_else(String::new, |angle| format!("{:.1}", angle.to_degrees()))
        };
        table.push(vec![
            experiment.states[zone.state].name.clone(),
            degrees(zone.places.start),
            degrees(zone.places.end.saturating_sub(1)),
            words(zone.fit.bounds),
            short(zone.fit.chi_squared),
            zone.fit.degrees.to_string(),
        ]);
    }
    if let Some(fit) = &friction.dynamic {
        table.push(vec![
            "all together".to_owned(),
            String::new(),
            String::new(),
            words(fit.bounds),
            short(fit.chi_squared),
            fit.degrees.to_string(),
        ]);
    }
    table
}

fn table(experiment: &Experiment, states: &[WholeState]) -> Table {
    let (force, stress) = (experiment.display.force, experiment.display.stress);
    let columns = vec![
        Column::new("state", ""),
        Column::new("remote load", force.name),
        Column::new("force on the hole", force.name),
        Column::new("largest pressure", stress.name),
        Column::new("deviation of the shear", stress.name),
        Column::new("its bias by smoothing", stress.name),
        Column::new("data", ""),
        Column::new("χ² per degree of freedom", ""),
    ];
    let mut table = Table::new("Balance and fit", columns);
    for own in states {
        let solution = &own.solution;
        let size = |[x, y]: [f64; 2]| force.from_base(x.hypot(y));
        let count = solution.angle.len() as f64;
        let rms = |values: &mut dyn Iterator<Item = f64>| {
            (values.map(|x| x * x).sum::<f64>() / count).sqrt()
        };
        let largest = solution
            .tractions
            .pressure
            .iter()
            .copied()
            .fold(0.0, f64::max);
        let mut deviations = (0..solution.angle.len()).map(|k| solution.deviation(1, k));
        let (residual, data, parameters) = solution.fit;
        table.push(vec![
            experiment.states[own.state].name.clone(),
            short(size(solution.load)),
            short(size(solution.force)),
            short(stress.from_base(largest)),
            short(stress.from_base(rms(&mut deviations))),
            short(stress.from_base(rms(&mut solution.bias.iter().map(|bias| bias[1])))),
            data.to_string(),
            format!("{:.3}", residual / (data as f64 - parameters).max(1.0)),
        ]);
    }
    table
}

fn csv(experiment: &Experiment, own: &WholeState) -> Vec<u8> {
    let unit = experiment.display.stress;
    let solution = &own.solution;
    let mut header = vec!["angle [deg]".to_owned()];
    for name in [
        "CPRESS",
        "deviation of CPRESS",
        "tau_rtheta",
        "deviation of tau_rtheta",
        "hoop stress",
        "deviation of the hoop stress",
    ] {
        header.push(format!("{name} [{}]", unit.name));
    }
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
    csv_table(&header, rows)
}

fn entry(experiment: &Experiment, own: &WholeState) -> Value {
    let (force, stress) = (experiment.display.force, experiment.display.stress);
    let solution = &own.solution;
    let largest = solution
        .tractions
        .pressure
        .iter()
        .copied()
        .fold(0.0, f64::max);
    json!({
        "state": experiment.states[own.state].name,
        "force_unit": force.name,
        "stress_unit": stress.name,
        "load": solution.load.map(|x| force.from_base(x)),
        "force_on_hole": solution.force.map(|x| force.from_base(x)),
        "largest_pressure": stress.from_base(largest),
        "chi_squared": solution.fit.0,
        "data": solution.fit.1,
    })
}
