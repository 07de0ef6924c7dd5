//! Edge stresses on the page, as tables, and in the summary.

pub(super) mod figures;
mod forces;
mod picture;

use serde_json::{Value, json};
use stickslip_hybrid::region::checks::ChiSquared;
use stickslip_hybrid::region::fit::Amount;
use stickslip_report::table::{Column, Table};

use crate::experiment::story::{Story, csv_table};
use stickslip_measure::analysed::{Analysed, TruePlace, UNUSED, free_in_region_only, true_edge};
use stickslip_measure::truth::Truth;
use stickslip_scene::experiment::{Experiment, Method, RegionShape};
use stickslip_text::{short, significant};

/// Reports the edge stresses of all states.
pub(crate) fn tell(
    experiment: &Experiment,
    analysed: &[Analysed],
    truth: Option<&Truth>,
    story: &mut Story,
) {
    story.section("Edge stresses");
    let direct = analysed.iter().any(|found| found.direct.is_some());
    story.text(words(experiment, direct));
    story.table(stresses(experiment, analysed));
    story.table(forces::table(experiment, analysed));
    story.table(checks(experiment, analysed));
    story.table(picture::table(experiment, analysed));
    story.report(experiment, free_in_region_only(experiment));
    for found in analysed {
        let name = &experiment.states[found.state].name;
        story.answer(&format!("State '{name}'"), answer(experiment, found));
        let truth = true_edge(experiment, truth, found.state);
        state(experiment, found, &truth, story);
    }
    let entries = analysed.iter().map(|found| entry(experiment, found));
    story.entry("edge_stresses", entries.collect());
}

fn words(experiment: &Experiment, direct: bool) -> String {
    let amount = experiment.region.as_ref().map(|plan| plan.smoothing.amount);
    let how = match (experiment.reduce.method, amount) {
        (Method::Fit, Some(Amount::CrossValidated { .. })) => {
            "The displacements of the region's boundary are fitted to all data with equilibrium inside and smoothing along the boundary, \
             whose amount was chosen by cross-validation of the same data. The noise of that choice, up to a fifth of the bands where \
             smoothing is strong, is not in them; a stated amount has none. "
        }
        (Method::Fit, _) => {
            "The displacements of the region's boundary are fitted to all data with equilibrium inside and the stated smoothing along \
             the boundary. "
        }
        (Method::Linear | Method::Polynomial { .. } | Method::Lines { .. }, _) => {
            "The displacements of the region's boundary are interpolated between the data. "
        }
    };
    let direct = if direct {
        " Direct interpolation is what the elements alone make of a local polynomial fit, without equilibrium."
    } else {
        ""
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
         bias of the smoothing; errors of the mesh, of the material and of where the hole is are not in them. θ is counted from +x towards +y. \
         One of {UNUSED} places, evenly over the plane, is not used and checks the others.{direct}"
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
    if !found.checks.misfit.is_empty() {
        story.figure(
            &format!("misfit-{name}"),
            "Measured less calculated displacements at places that were not used, in standard deviations. Noise has no pattern.",
            figures::misfit(experiment, found),
        );
    }
    story.report(experiment, found.findings(experiment));
    story.file(
        format!("edge-{name}.csv"),
        "stresses on the edge with standard deviations",
        csv(experiment, found),
    );
    story.file(
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
        let trusted = f64::from(u8::from(found.inner().contains(&k)));
        let mut row = vec![found.angle[k].to_degrees()];
        for (which, ([value, deviation], bias)) in values.into_iter().zip(found.bias[k]).enumerate()
        {
            let direct = found.direct.as_ref().map(|direct| direct[k][which]);
            let own = [value, deviation, bias].into_iter().chain(direct);
            row.extend(own.map(|stress| unit.from_base(stress)));
        }
        row.push(trusted);
        row
    });
    csv_table(&header, rows)
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
    let told = parts.filter_map(|(name, largest)| {
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
    let mut told: Vec<String> = told.collect();
    if told.is_empty() {
        told.push(unresolved(found));
    }
    if found.is_free() {
        told.push("no contact: no pressure that counts beside the hoop stress".to_owned());
    } else if found.contact().is_none() {
        told.push(
            "whether it is in contact cannot be told: no pressure exceeds its uncertainty"
                .to_owned(),
        );
    }
    told.join("; ")
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
    let stress = experiment.display.stress.name;
    let mut columns = vec![Column::new("state", "")];
    for name in ["peak pressure", "largest shear", "largest hoop stress"] {
        columns.extend([
            Column::new(name, stress),
            Column::new("±", stress),
            Column::new("at θ", "deg"),
        ]);
    }
    let mut table = Table::new("Largest stresses, with standard deviations", columns);
    let unit = experiment.display.stress;
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
    table.note(
        "Standard deviations are those of the place. The largest of many uncertain values is too large as a rule: the highest stress of the \
         edge itself may lie lower by more than the deviation.",
    )
}

/// What each check says, in the order of its columns.
const MEANINGS: [&str; 5] = [
    "Data and parameters: displacements that were fitted, and how many of them the fit uses up; far more data than parameters are good.",
    "Smoothing: the order of the differences along the boundary that are kept small, and how much they count.",
    "Noise factor: the variance of means of neighbouring residuals over that of independent errors of the deviation, at least that which \
     was stated or rounding leaves; bands are its root wider.",
    "Misfit: squares of measured less calculated displacements at places that were not used, over their variances; much above the \
     expected number data, region or material do not fit together.",
    "Free edge: the same of tractions on the edge beyond contact, which should vanish; the bias of smoothing counts as in the bands.",
];
const INSIDE: &str = "Nodes inside: the same of the forces on nodes inside of the region that move as measured, where nothing acts.";

fn checks(experiment: &Experiment, analysed: &[Analysed]) -> Table {
    let inside = (analysed.iter()).any(|found| found.checks.interior.is_some());
    let mut columns = vec![
        Column::new("state", ""),
        Column::new("data", ""),
        Column::new("parameters", ""),
        Column::new("smoothing", ""),
        Column::new("noise factor", ""),
        Column::new("misfit χ²", "(expected)"),
        Column::new("free edge χ²", "(expected)"),
    ];
    if inside {
        columns.push(Column::new("nodes inside χ²", "(expected)"));
    }
    let mut table = Table::new("Checks of the data", columns);
    let of_lines = matches!(experiment.reduce.method, Method::Lines { .. });
    for found in analysed {
        let facts = found.fit.as_ref();
        let told = |value: Option<String>| value.unwrap_or_default();
        let mut row = vec![
            experiment.states[found.state].name.clone(),
            told(facts.map(|fit| fit.data.to_string())),
            told(facts.map(|fit| format!("{:.0}", fit.parameters))),
            told(facts.map(|fit| format!("order {}: {}", fit.order, short(fit.amount)))),
            told((!of_lines).then(|| noise_factor(found))),
            told(found.checks.unused.as_ref().map(chi_squared)),
            told(found.checks.free_edge.as_ref().map(chi_squared)),
        ];
        if inside {
            row.push(told(found.checks.interior.as_ref().map(chi_squared)));
        }
        table.push(row);
    }
    let meanings = MEANINGS.into_iter().chain(inside.then_some(INSIDE));
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

fn chi_squared(check: &ChiSquared) -> String {
    format!(
        "{} ({} ± {})",
        short(check.value),
        check.count,
        short(check.deviation)
    )
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
