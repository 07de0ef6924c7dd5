//! Edge stresses on the page, as tables, and in the summary.

use serde_json::{Value, json};
use stickslip_hybrid::region::checks::ChiSquared;
use stickslip_report::table::{Column, Table};

use super::truth::{TruePlace, true_edge};
use super::{Analysed, UNUSED, figures};
use crate::experiment::plan::{Experiment, Method, RegionShape};
use crate::experiment::story::{Story, csv_table};
use crate::experiment::truth::Truth;
use crate::output::short;

/// Standard deviations above its mean at which a χ² is told of as too large.
const LARGE: f64 = 4.0;
/// Part of the data that the parameters of a fit may be before it is told of.
const MANY: f64 = 0.5;
/// Noise factors beyond which the stated deviation is told of as wrong.
const FACTORS: [f64; 2] = [0.1, 10.0];

/// Tells of the edge stresses of all states.
pub(in crate::experiment) fn tell(
    experiment: &Experiment,
    analysed: &[Analysed],
    truth: Option<&Truth>,
    story: &mut Story,
) {
    story.section("Edge stresses");
    story.text(words(experiment));
    story.table(table(experiment, analysed));
    for found in analysed {
        let truth = true_edge(experiment, truth, found.state);
        state(experiment, found, &truth, story);
    }
    let entries = analysed.iter().map(|found| entry(experiment, found));
    story.entry("edge_stresses", entries.collect());
}

fn words(experiment: &Experiment) -> String {
    let how = match experiment.reduce.method {
        Method::Fit => {
            "The displacements of the region's boundary are fitted to all data with equilibrium inside and the stated smoothing along \
             the boundary. The noise factor is the variance of means of neighbouring residuals over that of independent ones: errors \
             of neighbouring data go together, and the fit sees what is left of them in the mean. "
        }
        Method::Linear { .. } | Method::Polynomial { .. } | Method::Lines { .. } => {
            "The displacements of the region's boundary are interpolated between the data. "
        }
    };
    let place = match experiment.region.as_ref().map(|plan| &plan.shape) {
        Some(RegionShape::Sector(sector)) if sector.stand_off > 0.0 => {
            let length = experiment.display.length;
            let radius = experiment.specimen.hole.radius + sector.stand_off;
            format!(
                "Its edge stands off from the hole: stresses are those at r = {} {}, not on the hole. ",
                short(length.from_base(radius)),
                length.name
            )
        }
        _ => String::new(),
    };
    format!(
        "A region of finite elements moves at its boundary as measured and is in balance inside; its stresses on the edge are linear in \
         the data, so that their covariance is exact. {place}{how}Bands hold the noise and, as a declared systematic deviation, the estimated \
         bias of the smoothing; the error of the mesh is not in them; friction is identified on half of the cells too, to show it. θ is counted from +x towards +y. Balance \
         is the force on the edge by its stresses against that by its nodes; the ends of the edge leave some per cent. One of {UNUSED} places is not used; the misfit there checks the data. Direct interpolation is what the \
         elements alone make of a local polynomial fit, without equilibrium."
    )
}

fn state(experiment: &Experiment, found: &Analysed, truth: &[TruePlace], story: &mut Story) {
    let name = &experiment.states[found.state].name;
    let beside = if truth.is_empty() {
        ""
    } else {
        ", and the truth of the scene as a thin line"
    };
    story.figure(
        &format!("edge-{name}"),
        &format!("Stresses on the edge with bands of two standard deviations{beside}."),
        figures::edge(experiment, found, truth),
    );
    if !found.misfit.is_empty() {
        story.figure(
            &format!("misfit-{name}"),
            "Measured less calculated displacements at places that were not used, in standard deviations. Noise has no pattern.",
            figures::misfit(experiment, found),
        );
    }
    for (what, check) in [
        ("the misfit at unused places", &found.unused),
        ("the traction on the free edge", &found.free_edge),
    ] {
        if let Some(check) = check.as_ref().filter(|check| check.excess() > LARGE) {
            story.warn(format!(
                "State '{name}': {what} has χ² = {} where {} ± {} is expected: data, region or material do not fit together.",
                short(check.value),
                check.count,
                short(check.deviation)
            ));
        }
    }
    for warning in doubts(found) {
        story.warn(format!("State '{name}': {warning}"));
    }
    story.file(
        format!("edge-{name}.csv"),
        "stresses on the edge with standard deviations",
        csv(experiment, found),
    );
}

/// What makes the bands of a state doubtful.
fn doubts(found: &Analysed) -> Vec<String> {
    let mut doubts = Vec::new();
    let Some(fit) = &found.fit else {
        return doubts;
    };
    if fit.parameters > MANY * fit.data as f64 {
        doubts.push(format!(
            "{} data determine {:.0} parameters of the fit: the region has too many cells for them, and neither its stresses nor their \
             bands can be trusted. Take fewer cells, or state a smoothing amount.",
            fit.data, fit.parameters
        ));
    }
    if !(FACTORS[0]..=FACTORS[1]).contains(&found.scale) {
        doubts.push(format!(
            "the variance of the residuals is {} times the one stated; bands follow the residuals. Check the deviation.",
            short(found.scale)
        ));
    }
    doubts
}

fn csv(experiment: &Experiment, found: &Analysed) -> Vec<u8> {
    let unit = experiment.display.stress;
    let mut header = vec!["theta [deg]".to_owned()];
    for name in ["pressure", "shear tau_rtheta", "hoop sigma_theta"] {
        for part in ["", " deviation", " bias"] {
            header.push(format!("{name}{part} [{}]", unit.name));
        }
    }
    let [pressure, shear] = found.deviations();
    let rows = (0..found.angle.len()).map(|k| {
        let parts = [
            [found.tractions.pressure[k], pressure[k]],
            [found.tractions.shear[k], shear[k]],
            [found.hoop[k], found.hoop_deviation[k]],
        ];
        let mut row = vec![found.angle[k].to_degrees()];
        for ([value, deviation], bias) in parts.into_iter().zip(found.bias[k]) {
            row.extend([value, deviation, bias].map(|stress| unit.from_base(stress)));
        }
        row
    });
    csv_table(&header, rows)
}

fn table(experiment: &Experiment, analysed: &[Analysed]) -> Table {
    let stress = experiment.display.stress.name;
    let columns = vec![
        Column::new("state", ""),
        Column::new("data", ""),
        Column::new("parameters", ""),
        Column::new("smoothing", ""),
        Column::new("noise factor", ""),
        Column::new("peak pressure", stress),
        Column::new("deviation", stress),
        Column::new("largest shear", stress),
        Column::new("deviation", stress),
        Column::new("misfit χ² (expected)", ""),
        Column::new("free edge χ² (expected)", ""),
        Column::new("balance", "% of the force"),
    ];
    let mut table = Table::new("Hybrid analysis", columns);
    for found in analysed {
        table.push(row(experiment, found));
    }
    table
}

fn row(experiment: &Experiment, found: &Analysed) -> Vec<String> {
    let unit = experiment.display.stress;
    let stress = |value: f64| short(unit.from_base(value));
    let [pressure, shear] = found.deviations();
    let peak = |values: &[f64]| {
        let inner = found.inner();
        inner.max_by(|a, b| values[*a].abs().total_cmp(&values[*b].abs()))
    };
    let largest = |values: &[f64], deviation: &[f64]| match peak(values) {
        Some(k) => [stress(values[k]), stress(deviation[k])],
        None => [String::new(), String::new()],
    };
    let [p, dp] = largest(&found.tractions.pressure, &pressure);
    let [t, dt] = largest(&found.tractions.shear, &shear);
    let facts = found.fit.as_ref();
    let told = |value: Option<String>| value.unwrap_or_default();
    vec![
        experiment.states[found.state].name.clone(),
        told(facts.map(|fit| fit.data.to_string())),
        told(facts.map(|fit| format!("{:.0}", fit.parameters))),
        told(facts.map(|fit| format!("order {}, amount {}", fit.order, short(fit.amount)))),
        format!("{:.2}", found.scale),
        p,
        dp,
        t,
        dt,
        told(found.unused.as_ref().map(chi_squared)),
        told(found.free_edge.as_ref().map(chi_squared)),
        format!("{:.1}", 100.0 * imbalance(found)),
    ]
}

fn chi_squared(check: &ChiSquared) -> String {
    format!(
        "{} ({} ± {})",
        short(check.value),
        check.count,
        short(check.deviation)
    )
}

/// Force on the edge by its stresses plus that by its nodes, over the latter. Where the edge ends, its last nodes carry forces of the
/// neighbouring edges too, so that some per cent remain on any mesh.
fn imbalance(found: &Analysed) -> f64 {
    let values = &found.forces.values;
    let size = |x: f64, y: f64| x.hypot(y);
    let force = size(values[2], values[3]);
    if force > 0.0 {
        size(values[0] + values[2], values[1] + values[3]) / force
    } else {
        0.0
    }
}

fn entry(experiment: &Experiment, found: &Analysed) -> Value {
    let check = |check: Option<&ChiSquared>| {
        check.map(|check| {
            json!({ "value": check.value, "count": check.count, "deviation": check.deviation })
        })
    };
    json!({
        "state": experiment.states[found.state].name,
        "noise_factor": found.scale,
        "resolution_degrees": found.resolution.to_degrees(),
        "fit": found.fit.map(|fit| json!({
            "data": fit.data,
            "parameters": fit.parameters,
            "kept_on_edge": fit.kept,
            "order": fit.order,
            "amount": fit.amount,
            "chi_squared": fit.residual,
        })),
        "unused_misfit": check(found.unused.as_ref()),
        "free_edge": check(found.free_edge.as_ref()),
        "imbalance": imbalance(found),
    })
}
