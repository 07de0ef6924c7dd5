//! The table, the findings in words, and the page.

use std::fmt::Write as _;

use super::case::{Failure, Load, MEAN, Row};
use super::study::{CLEARANCE, CRITERION, FRICTION, Study};
use super::{Picture, Trouble};

const COLUMNS: [&str; 11] = [
    "layup",
    "load",
    "clearance_percent",
    "friction",
    "peak_hoop",
    "peak_hoop_angle_deg",
    "hoop_at_90_deg",
    "peak_pressure",
    "peak_pressure_angle_deg",
    "peak_shear",
    "contact_end_deg",
];

/// All joints; stresses over P/(D t).
pub(super) fn csv(study: &Study) -> Result<Vec<u8>, Trouble> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    let criteria = criteria(study);
    let mut head: Vec<String> = COLUMNS.map(str::to_owned).to_vec();
    for criterion in &criteria {
        for what in [
            "bearing_MPa",
            "reached",
            "ply",
            "mode",
            "angle_deg",
            "r_over_R",
        ] {
            head.push(format!("{criterion}_{what}"));
        }
    }
    writer.write_record(&head)?;
    for row in &study.rows {
        let (load, fit) = match row.fit() {
            None => ("cosine", [String::new(), String::new()]),
            Some((clearance, friction)) => {
                ("contact", [clearance.to_string(), friction.to_string()])
            }
        };
        let mut cells = vec![row.layup.to_owned(), load.to_owned()];
        cells.extend(fit);
        let numbers = [
            row.peak_hoop[0],
            row.peak_hoop[1],
            row.net_hoop,
            row.peak_pressure[0],
            row.peak_pressure[1],
            row.peak_shear,
            row.end,
        ];
        cells.extend(numbers.map(|value| format!("{value:.4}")));
        for criterion in &criteria {
            let own = row.failures.iter().find(|own| own.criterion == *criterion);
            cells.extend(own.map_or_else(Default::default, failure_cells));
        }
        writer.write_record(&cells)?;
    }
    Ok(writer.into_inner()?)
}

fn failure_cells(failure: &Failure) -> [String; 6] {
    [
        format!("{:.2}", failure.bearing),
        failure.reached.to_string(),
        failure.ply.clone(),
        failure.mode.to_string(),
        format!("{:.2}", failure.place[0]),
        format!("{:.4}", failure.place[1]),
    ]
}

fn criteria(study: &Study) -> Vec<&'static str> {
    let first = study.rows.first();
    first.map_or_else(Vec::new, |row| {
        row.failures.iter().map(|own| own.criterion).collect()
    })
}

/// A ratio of contact to assumption, and the joint that has it.
struct Extreme<'a> {
    ratio: f64,
    row: &'a Row,
}

/// Smallest and largest ratio of a quantity over the joints that `wanted` takes.
fn range(
    study: &Study,
    of: impl Fn(&Row) -> Option<f64>,
    wanted: impl Fn(&Row) -> bool,
) -> Option<[Extreme<'_>; 2]> {
    let mut all: Vec<Extreme<'_>> = study
        .pairs()
        .filter(|(row, _)| wanted(row))
        .filter_map(|(row, assumed)| {
            let ratio = of(row)? / of(assumed)?;
            Some(Extreme { ratio, row })
        })
        .collect();
    all.sort_by(|a, b| a.ratio.total_cmp(&b.ratio));
    let last = all.pop()?;
    if all.is_empty() {
        let (ratio, row) = (last.ratio, last.row);
        return Some([Extreme { ratio, row }, last]);
    }
    Some([all.swap_remove(0), last])
}

/// "c/R = 0.25 %, μ = 0.2, [0/±45/90]s".
fn joint(row: &Row) -> String {
    let fit = row.fit().map_or_else(String::new, |(clearance, friction)| {
        format!("c/R = {clearance} %, μ = {friction}, ")
    });
    format!("{fit}{}", row.layup)
}

/// A quantity of a row, and its name.
type Reading = (&'static str, fn(&Row) -> Option<f64>);

/// What the study found, in sentences; the first is for a stress engineer.
pub(super) fn findings(study: &Study) -> Vec<String> {
    let strength = |row: &Row| row.strength(CRITERION);
    let mut sentences = Vec::new();
    if let Some([least, most]) = range(study, strength, |_| true) {
        let ratios: Vec<f64> = study
            .pairs()
            .filter_map(|(row, assumed)| Some(strength(row)? / strength(assumed)?))
            .collect();
        let unsafe_count = ratios.iter().filter(|&&ratio| ratio < 1.0).count();
        sentences.push(format!(
            "**First-ply failure** by maximum stress. With computed contact the first ply fails at {:.2} to {:.2} times the load that the \
             assumed cosine gives: the cosine is on the unsafe side in {unsafe_count} of {} joints, at worst by {:.0} % ({}), and at \
             best {:.0} % too cautious ({}).",
            least.ratio,
            most.ratio,
            ratios.len(),
            100.0 * (1.0 / least.ratio - 1.0),
            joint(least.row),
            100.0 * (most.ratio - 1.0),
            joint(most.row),
        ));
        sentences.insert(0, advice(study));
    }
    let readings: [Reading; 3] = [
        ("Peak hoop stress", |row| Some(row.peak_hoop[0])),
        ("Hoop stress at 90°", |row| Some(row.net_hoop)),
        ("Peak pressure", |row| Some(row.peak_pressure[0])),
    ];
    for (name, of) in readings {
        if let Some([least, most]) = range(study, of, |_| true) {
            sentences.push(format!(
                "**{name}** at P/(D t) = {MEAN} MPa: {:.2} ({}) to {:.2} ({}) times the assumed one.",
                least.ratio,
                joint(least.row),
                most.ratio,
                joint(most.row),
            ));
        }
    }
    let shear = study
        .pairs()
        .map(|(row, _)| row)
        .max_by(|a, b| a.peak_shear.total_cmp(&b.peak_shear));
    if let Some(row) = shear {
        sentences.push(format!(
            "**Shear on the edge**, which the assumed load leaves out, reaches {:.2} P/(D t) ({}).",
            row.peak_shear,
            joint(row)
        ));
    }
    sentences.extend(mesh_dependence(study));
    sentences
}

/// What to do with a first-ply load from the assumed cosine, lay-up by lay-up.
fn advice(study: &Study) -> String {
    let of = |layup: &'static str| {
        let [least, _] = range(
            study,
            |row| row.strength(CRITERION),
            |row| row.layup == layup,
        )?;
        let computed = governing(least.row)?;
        let assumed = governing(study.cosine(layup)?)?;
        let verdict = if least.ratio < 1.0 {
            ""
        } else {
            ", so it is safe"
        };
        Some(format!(
            "{layup} by {:.2}{verdict} (contact: {computed}; assumed: {assumed})",
            (100.0 * least.ratio).floor() / 100.0
        ))
    };
    let parts: Vec<String> = study
        .plan
        .layups
        .iter()
        .filter_map(|&layup| of(layup))
        .collect();
    format!(
        "**What to do.** To cover every clearance and friction studied, multiply the first-ply load that an assumed cosine gives for {}. \
         Where the factor is below 1, compute contact with the joint's own clearance and friction instead: the first ply fails near the \
         end of contact or inside it, under a hoop stress and a shear that the cosine does not have.",
        parts.join("; for ")
    )
}

/// Ply, mode and place of the first failure by the charts' criterion.
fn governing(row: &Row) -> Option<String> {
    let mut failures = row.failures.iter();
    let own = failures.find(|own| own.criterion == CRITERION)?;
    Some(format!(
        "{} ply, {} at {:.0}°",
        own.ply, own.mode, own.place[0]
    ))
}

/// How much the worst joint depends on the mesh.
fn mesh_dependence(study: &Study) -> Option<String> {
    let fine = study.refined.as_ref()?;
    let row = study.worst()?;
    // One decimal, without minus zero.
    let change = |fine: f64, coarse: f64| (1e3 * (fine / coarse - 1.0)).round() / 10.0 + 0.0;
    Some(format!(
        "**Mesh.** At half the spacing the worst joint ({}) has {:+.1} % peak hoop stress, {:+.1} % hoop stress at 90°, {:+.1} % peak \
         pressure and {:+.1} % load of first-ply failure: at the end of contact stresses with friction are cusps, which \
         converge only like the root of the spacing. A criterion at a characteristic distance hardly depends on that.",
        joint(row),
        change(fine.peak_hoop[0], row.peak_hoop[0]),
        change(fine.net_hoop, row.net_hoop),
        change(fine.peak_pressure[0], row.peak_pressure[0]),
        change(fine.strength(CRITERION)?, row.strength(CRITERION)?),
    ))
}

/// The page of the study.
pub(super) fn page(study: &Study, pictures: &[Picture]) -> String {
    let mut text = format!(
        "<!-- Generated by `cargo xtask cosine`; do not edit. -->\n\n# The assumed cosine against computed contact\n\n\
         Handbooks replace the bolt in a joint by the pressure 4P/(π D t) cos θ over |θ| ≤ 90°, without clearance and friction. Here the \
         same joint is solved with that load ([scene](../../scenes/joint-assumed-cosine.toml)) and with a steel bolt in contact \
         ([scene](../../scenes/joint-computed-contact.toml)): 6 mm hole, W/D = 6, e/D = 4, carbon-epoxy plies, {} joints. The bearing \
         point is θ = 0, the net section ±90°; stresses are means over the thickness and over P/(D t). Contact is not linear in the \
         load: stresses are compared at P/(D t) = {MEAN} MPa, first-ply failure at its own load on the way there. Plies carry no \
         stress of the cure. The mesh has corner nodes every {}°.\n\n## Findings\n\n",
        study.rows.len(),
        study.plan.spacing,
    );
    for sentence in findings(study) {
        // Writing into a string does not fail.
        let _ = writeln!(text, "- {sentence}");
    }
    for picture in pictures {
        let _ = write!(text, "\n![{}]({}.png)\n", picture.alternative, picture.name);
    }
    text.push_str("\n## First-ply failure, computed over assumed\n\nSmallest and largest ratio over clearance and friction.\n\n");
    text.push_str(&criteria_table(study));
    text.push_str("\n## Some joints\n\n");
    text.push_str(&joints_table(study));
    text.push_str("\nAll joints: [cosine.csv](cosine.csv). To repeat: `cargo xtask cosine`, or `cargo xtask cosine --quick` for a minute.\n");
    text
}

fn criteria_table(study: &Study) -> String {
    let criteria = criteria(study);
    let mut text = format!(
        "| lay-up | {} |\n|{}\n",
        criteria.join(" | "),
        " --- |".repeat(criteria.len() + 1)
    );
    for &layup in study.plan.layups {
        let cells: Vec<String> = criteria
            .iter()
            .map(|criterion| {
                let own = range(
                    study,
                    |row| row.strength(criterion),
                    |row| row.layup == layup,
                );
                own.map_or_else(
                    || "–".to_owned(),
                    |[low, high]| format!("{:.2} … {:.2}", low.ratio, high.ratio),
                )
            })
            .collect();
        // Writing into a string does not fail.
        let _ = writeln!(text, "| {layup} | {} |", cells.join(" | "));
    }
    text
}

fn joints_table(study: &Study) -> String {
    let mut text = String::from(
        "| lay-up | load | peak pressure | peak hoop | hoop at 90° | peak shear | first ply, maximum stress |\n\
         | --- | --- | --- | --- | --- | --- | --- |\n",
    );
    let shown = |row: &Row| match row.load {
        Load::Cosine => true,
        Load::Contact {
            clearance,
            friction,
        } => {
            let of_clearance = friction == FRICTION && [0.0, CLEARANCE, 0.01].contains(&clearance);
            of_clearance || (clearance == CLEARANCE && [0.0, 0.5].contains(&friction))
        }
    };
    for row in study.rows.iter().filter(|row| shown(row)) {
        let load = row.fit().map_or_else(
            || "assumed cosine".to_owned(),
            |(clearance, friction)| format!("c/R = {clearance} %, μ = {friction}"),
        );
        let mut failures = row.failures.iter();
        let failure = failures.find(|own| own.criterion == CRITERION);
        let failure = failure.map_or_else(String::new, |own| {
            format!(
                "{:.0} MPa{}: {} ply, {}, θ = {:.0}°, r = {:.2} R",
                own.bearing,
                if own.reached {
                    ""
                } else {
                    " (beyond the steps)"
                },
                own.ply,
                own.mode,
                own.place[0],
                own.place[1]
            )
        });
        // Writing into a string does not fail.
        let _ = writeln!(
            text,
            "| {} | {load} | {:.3} | {:.3} at {:.0}° | {:.3} | {:.3} | {failure} |",
            row.layup,
            row.peak_pressure[0],
            row.peak_hoop[0],
            row.peak_hoop[1],
            row.net_hoop,
            row.peak_shear,
        );
    }
    text
}
