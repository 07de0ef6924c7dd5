//! Edge stresses on the page, as tables, and in the summary.

pub(super) mod figures;
mod forces;
mod picture;

use serde_json::{Value, json};
use stickslip_hybrid::region::checks::ChiSquared;
use stickslip_hybrid::region::fit::Amount;
use stickslip_report::context;
use stickslip_report::prose::Prose;
use stickslip_report::table::{Column, Table};

use crate::findings::shown;
use crate::report::ExperimentReport;
use stickslip_experiment::{Experiment, Method, RegionShape};
use stickslip_measure::analysed::{Analysed, TruePlace, UNUSED, free_in_region_only, true_edge};
use stickslip_measure::truth::Truth;
use stickslip_report::csv;
use stickslip_text::{short, significant};

/// Reports the edge stresses of all states.
pub(crate) fn report(
    experiment: &Experiment,
    analysed: &[Analysed],
    truth: Option<&Truth>,
    report: &mut ExperimentReport,
) {
    report.section("Edge stresses");
    let direct = analysed.iter().any(|found| found.direct.is_some());
    report.prose(introduction(experiment, direct));
    report.table(stresses(experiment, analysed));
    report.table(forces::table(experiment, analysed));
    report.table(checks(experiment, analysed));
    report.table(picture::table(experiment, analysed));
    report.findings(experiment, free_in_region_only(experiment));
    for found in analysed {
        let name = &experiment.states[found.state].name;
        report.answer(&format!("State '{name}'"), answer(experiment, found));
        let truth = true_edge(experiment, truth, found.state);
        state(experiment, found, &truth, report);
    }
    let entries = analysed.iter().map(|found| entry(experiment, found));
    report.entry("edge_stresses", entries.collect());
}

/// How the stresses are found, and what their bands hold.
fn introduction(experiment: &Experiment, direct: bool) -> Prose {
    let plan = experiment.region.as_ref();
    let amount = plan.map(|plan| plan.smoothing.amount);
    let reduction = match (experiment.reduce.method, amount) {
        (Method::Fit, Some(Amount::CrossValidated { .. })) => "cross-validated fit",
        (Method::Fit, _) => "fit",
        (Method::Linear | Method::Polynomial { .. } | Method::Lines { .. }, _) => "interpolation",
    };
    let radius = match plan.map(|plan| &plan.shape) {
        Some(RegionShape::Sector(sector)) if sector.stand_off > 0.0 => {
            let radius = experiment.specimen.hole.radius + sector.stand_off;
            Some(shown(experiment.display.length, radius))
        }
        _ => None,
    };
    Prose::new(
        include_str!("analysed/text.jinja"),
        context! { reduction, radius, unused => UNUSED, direct },
    )
}

fn state(
    experiment: &Experiment,
    found: &Analysed,
    truth: &[TruePlace],
    report: &mut ExperimentReport,
) {
    let name = &experiment.states[found.state].name;
    let beside = if truth.is_empty() {
        ""
    } else {
        ", and the truth of the scene as a thin line"
    };
    report.figure(
        &format!("edge-{name}"),
        &format!("Stresses on the edge with bands of two standard deviations{beside}."),
        figures::edge(experiment, found, truth),
    );
    if !found.checks.misfit.is_empty() {
        report.figure(
            &format!("misfit-{name}"),
            "Measured less calculated displacements at places that were not used, in standard deviations. Noise has no pattern.",
            figures::misfit(experiment, found),
        );
    }
    report.findings(experiment, found.findings(experiment));
    report.file(
        format!("edge-{name}.csv"),
        "stresses on the edge with standard deviations",
        csv(experiment, found),
    );
    report.file(
        format!("forces-{name}.csv"),
        "forces that hold the region, at the nodes that move as measured, with standard deviations",
        forces::csv(experiment, found),
    );
}

fn csv(experiment: &Experiment, found: &Analysed) -> Vec<u8> {
    let unit = experiment.display.stress;
    let mut header = vec!["theta [deg]".to_owned()];
    let parts = match found.direct {
        Some(_) => &["", " deviation", " bias", " direct"][..],
        None => &["", " deviation", " bias"],
    };
    for name in ["pressure", "shear tau_rtheta", "hoop sigma_theta"] {
        let columns = parts.iter();
        header.extend(columns.map(|part| format!("{name}{part} [{}]", unit.name)));
    }
    header.push("trusted".to_owned());
    let [pressure, shear] = found.deviations();
    let rows = (0..found.angle.len()).map(|k| {
        let values = [
            [found.tractions.pressure[k], pressure[k]],
            [found.tractions.shear[k], shear[k]],
            [found.hoop[k], found.hoop_deviation[k]],
        ];
        let mut row = vec![found.angle[k].to_degrees()];
        for (which, (value, bias)) in values.into_iter().zip(found.bias[k]).enumerate() {
            let direct = found.direct.as_ref().map(|direct| direct[k][which]);
            let own = value.into_iter().chain([bias]).chain(direct);
            row.extend(own.map(|stress| unit.from_base(stress)));
        }
        row.push(f64::from(found.inner().contains(&k)));
        row
    });
    csv::numbers(header, rows)
}

/// A largest stress and where it is.
struct Largest {
    value: f64,
    deviation: f64,
    angle: f64,
}

/// The largest pressure, and the shear and the hoop stress of the largest magnitude, at places that can be trusted.
fn largest(found: &Analysed) -> [Option<Largest>; 3] {
    let [pressure, shear] = found.deviations();
    let of = |values: &[f64], deviations: &[f64], size: fn(f64) -> f64| {
        let inner = found.inner();
        let place = inner.max_by(|a, b| size(values[*a]).total_cmp(&size(values[*b])))?;
        Some(Largest {
            value: values[place],
            deviation: deviations[place],
            // Without minus zero.
            angle: (1e4 * found.angle[place].to_degrees()).round() / 1e4 + 0.0,
        })
    };
    [
        of(&found.tractions.pressure, &pressure, |value| value),
        of(&found.tractions.shear, &shear, f64::abs),
        of(&found.hoop, &found.hoop_deviation, f64::abs),
    ]
}

/// The stresses of a state in one line.
fn answer(experiment: &Experiment, found: &Analysed) -> String {
    let unit = experiment.display.stress;
    let names = ["peak pressure", "largest shear τ_rθ", "largest hoop stress"];
    let parts = names.into_iter().zip(largest(found));
    let reported = parts.filter_map(|(name, largest)| {
        let Largest {
            value,
            deviation,
            angle,
        } = largest?;
        Some(format!(
            "{name} {} ± {} {} at θ = {angle:.1}°",
            short(unit.from_base(value)),
            significant(unit.from_base(deviation), 2),
            unit.name
        ))
    });
    let mut reported: Vec<String> = reported.collect();
    if reported.is_empty() {
        reported.push(unresolved(found));
    }
    if found.is_free() {
        reported.push("no contact: every pressure is negligible beside the hoop stress".to_owned());
    } else if found.contact().is_none() {
        reported
            .push("contact is not identifiable: no pressure exceeds its uncertainty".to_owned());
    }
    reported.join("; ")
}

/// Why no stress can be resolved.
fn unresolved(found: &Analysed) -> String {
    let reach = 2.0 * found.resolution;
    let length = found.angle.last().zip(found.angle.first());
    let length = length.map_or(0.0, |(last, first)| last - first);
    if reach > length {
        return "the data resolve nothing along the edge: measure more of them, smooth less, or take fewer nodes".to_owned();
    }
    format!(
        "no place is {:.1}°, twice what is resolved, from both ends of the region: take a longer one, or resolve more by more data, less \
         smoothing or more cells",
        reach.to_degrees()
    )
}

fn stresses(experiment: &Experiment, analysed: &[Analysed]) -> Table {
    let unit = experiment.display.stress;
    let names = ["peak pressure", "largest shear", "largest hoop stress"];
    let groups = names.map(|name| format!(" | {name} [{0}] | ± [{0}] | at θ [deg]", unit.name));
    let headings = format!("state{}", groups.concat());
    let mut table = Table::headed("Largest stresses, with standard deviations", &headings);
    for found in analysed {
        let mut row = vec![experiment.states[found.state].name.clone()];
        for largest in largest(found) {
            row.extend(largest.map_or_else(Default::default, |largest| {
                let [value, deviation] =
                    [largest.value, largest.deviation].map(|value| short(unit.from_base(value)));
                [value, deviation, format!("{:.1}", largest.angle)]
            }));
        }
        table.push(row);
    }
    table.with_notes(include_str!("analysed/stresses.txt"))
}

fn checks(experiment: &Experiment, analysed: &[Analysed]) -> Table {
    let inside = (analysed.iter()).any(|found| found.checks.interior.is_some());
    let headings = "state | data | parameters | smoothing | noise factor | misfit χ² [(expected)] | free edge χ² [(expected)]";
    let mut table = Table::headed("Checks of the data", headings);
    let mut meanings = include_str!("analysed/checks.txt").lines();
    if inside {
        let column = Column::new("nodes inside χ²", "(expected)");
        table.columns.push(column);
    } else {
        // The last one is of the nodes inside.
        meanings.next_back();
    }
    let of_lines = matches!(experiment.reduce.method, Method::Lines { .. });
    for found in analysed {
        let fit = found.fit.map(|fit| {
            let [data, parameters] = [fit.data.to_string(), format!("{:.0}", fit.parameters)];
            [
                data,
                parameters,
                format!("order {}: {}", fit.order, short(fit.amount)),
            ]
        });
        let checks = &found.checks;
        let checks = [&checks.unused, &checks.free_edge, &checks.interior].map(Option::as_ref);
        let mut row = vec![experiment.states[found.state].name.clone()];
        row.extend(fit.unwrap_or_default());
        row.push(if of_lines {
            String::new()
        } else {
            noise_factor(found)
        });
        row.extend(checks.map(chi_squared));
        row.truncate(table.columns.len());
        table.push(row);
    }
    meanings.fold(table, Table::note)
}

fn noise_factor(found: &Analysed) -> String {
    let how = if found.scale_assumed.is_some() {
        ", assumed"
    } else {
        ""
    };
    format!("{:.2}{how}", found.scale)
}

fn chi_squared(check: Option<&ChiSquared>) -> String {
    check.map_or_else(String::new, |check| {
        let [value, deviation] = [check.value, check.deviation].map(short);
        format!("{value} ({} ± {deviation})", check.count)
    })
}

fn entry(experiment: &Experiment, found: &Analysed) -> Value {
    let check = |check: Option<&ChiSquared>| {
        check.map(|check| {
            json!({ "value": check.value, "count": check.count, "deviation": check.deviation })
        })
    };
    let unit = experiment.display.stress;
    let most = largest(found).map(|largest| {
        largest.map(|largest| {
            json!({
                "value": unit.from_base(largest.value),
                "deviation": unit.from_base(largest.deviation),
                "theta_degrees": largest.angle,
            })
        })
    });
    json!({
        "state": experiment.states[found.state].name,
        "noise_factor": found.scale,
        "noise_factor_assumed": found.scale_assumed,
        "resolution_degrees": found.resolution.to_degrees(),
        "largest": {
            "stress_unit": experiment.display.stress.name,
            "pressure": most[0],
            "shear": most[1],
            "hoop": most[2],
        },
        "contact": found.contact().is_some(),
        "fit": found.fit.map(|fit| json!({
            "data": fit.data,
            "parameters": fit.parameters,
            "kept_on_edge": fit.kept,
            "order": fit.order,
            "amount": fit.amount,
            "chi_squared": fit.residual,
            "noise_factor_of_residuals": fit.of_residuals,
        })),
        "unused_misfit": check(found.checks.unused.as_ref()),
        "free_edge": check(found.checks.free_edge.as_ref()),
        "nodes_inside": check(found.checks.interior.as_ref()),
        "force": forces::entry(experiment, found),
        "picture": picture::entry(experiment, found),
    })
}
