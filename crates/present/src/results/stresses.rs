//! The largest stresses of bodies: a table, and entries of `summary.json`.

use serde::Serialize;
use stickslip_report::table::Table;
use stickslip_results::{BodyStresses, Results, StressPeak};
use stickslip_text::{short, significant, tidy};

use super::findings::load_steps;
use super::quantity::{Quantity, Vector};

/// Part of the larger coordinate of a place below which the other one is rounding.
const ROUNDING: f64 = 1e-12;

/// What the table says of its places.
pub(super) const NOTE: &str = "At the nodes of the elastic bodies, each in the step with its largest von Mises stress: of bodies with a yield stress among all steps, of \
                    others among those with fields. Around held points, within two fifths of the body's smaller side, and ends of supported edges, within a twentieth, \
                    stresses have no bound and are left out; at re-entrant corners, and where a load ends within or along an edge, they have none either, are those of the mesh, and have no error.";

/// The largest stresses of every body, in the step with its largest von Mises stress; `None` where no step has stresses.
pub(super) fn table(results: &Results) -> Option<Table> {
    let units = results.units;
    let (stress, length) = (units.stress.name, units.length.name);
    let headings = format!(
        "body | step | von Mises [{stress}] | at x, y [{length}] | largest principal [{stress}] | at x, y [{length}] | least principal [{stress}] | at x, y [{length}] | \
         yield [{stress}]"
    );
    let value = |stress: f64| significant(units.stress.from_base(stress), 4);
    let stated = |peak: StressPeak| match peak.error {
        None => value(peak.stress),
        Some(error) => {
            let [stress, error] = [peak.stress, error].map(|own| units.stress.from_base(own));
            format!("{} ± {}", significant(stress, 5), significant(error, 2))
        }
    };
    let place = |peak: StressPeak| {
        let far = peak.at[0].abs().max(peak.at[1].abs());
        let clean = |at: f64| if at.abs() < ROUNDING * far { 0.0 } else { at };
        let [x, y] = peak.at.map(|at| short(units.length.from_base(clean(at))));
        format!("{x}, {y}")
    };
    let row = |(index, body)| {
        let (step, own) = largest(results, index)?;
        let body: &stickslip_results::BodySummary = body;
        let yields = body.yield_stress.map_or("–".into(), value);
        let peaks = [own.von_mises, own.largest_principal, own.least_principal];
        let peaks = peaks.map(|peak| [stated(peak), place(peak)]);
        let cells = [body.name.clone(), (step + 1).to_string()].into_iter();
        Some(cells.chain(peaks.into_iter().flatten()).chain([yields]))
    };
    let rows: Vec<_> = (results.bodies.iter().enumerate())
        .filter_map(row)
        .collect();
    let table = Table::headed(title(results), &headings).with_rows(rows);
    (!table.rows.is_empty()).then_some(table)
}

/// With the steps that alone were looked at of some body.
fn title(results: &Results) -> String {
    let of_body = |index: usize| -> Vec<usize> {
        let steps = results.steps.iter().enumerate();
        let with = steps.filter(|(_, record)| record.stresses.iter().any(|own| own.body == index));
        with.map(|(step, _)| step + 1).collect()
    };
    let bodies = (0..results.bodies.len()).map(of_body);
    let fewest = bodies
        .filter(|steps| !steps.is_empty())
        .min_by_key(Vec::len);
    let limited = fewest.filter(|steps| steps.len() < results.steps.len());
    let title = "Largest stresses of the bodies";
    limited.map_or_else(
        || title.to_owned(),
        |steps| {
            format!(
                "{title}, without a yield stress in {} alone",
                load_steps(&steps)
            )
        },
    )
}

/// The step in which the von Mises stress of the body `index` is largest.
fn largest(results: &Results, index: usize) -> Option<(usize, BodyStresses)> {
    let own = |(step, record): (usize, &stickslip_results::StepResults)| {
        let found = record.stresses.iter().find(|own| own.body == index)?;
        Some((step, *found))
    };
    let steps = results.steps.iter().enumerate().filter_map(own);
    steps.max_by(|one, other| one.1.von_mises.stress.total_cmp(&other.1.von_mises.stress))
}

/// The largest stresses of a body in `summary.json`, in a step.
#[derive(Debug, Serialize)]
pub(super) struct Entry<'a> {
    body: &'a str,
    von_mises: Peak,
    largest_principal: Peak,
    least_principal: Peak,
}

#[derive(Debug, Serialize)]
struct Peak {
    #[serde(flatten)]
    stress: Quantity,
    /// In the unit of the stress.
    #[serde(skip_serializing_if = "Option::is_none")]
    error: Option<f64>,
    at: Vector,
}

/// The largest stresses at the end of `step` in `summary.json`.
pub(super) fn entries(results: &Results, step: usize) -> Vec<Entry<'_>> {
    let units = results.units;
    let peak = |own: StressPeak| Peak {
        stress: Quantity::of(units.stress, own.stress),
        error: (own.error).and_then(|error| tidy(units.stress.from_base(error))),
        at: Vector::of(units.length, own.at),
    };
    let entry = |own: &BodyStresses| Entry {
        body: &results.bodies[own.body].name,
        von_mises: peak(own.von_mises),
        largest_principal: peak(own.largest_principal),
        least_principal: peak(own.least_principal),
    };
    results.steps[step].stresses.iter().map(entry).collect()
}
