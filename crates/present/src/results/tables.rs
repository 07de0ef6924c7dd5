//! Tables for the terminal and the page: load steps, signs, choices, bodies.

mod fit;
mod signs;

pub use signs::SIGNS;
pub(super) use signs::signs;

use stickslip_contact::Status;
use stickslip_report::table::{Column, Table};

use super::display::shared;
use super::display::{EdgeView, even};
use super::failure::{self, FailureView};
use super::progressive::{self, ProgressiveView};
use super::quantities::table_columns;
use super::zones::{contact_reach, stick_ranges, zone_length};
use fit::fitted;
use stickslip_engine::LoadScale;
use stickslip_engine::results::Results;
use stickslip_text::{decimals, short, significant};

/// The load steps for a terminal of `width` columns.
pub(super) fn terminal(results: &Results, width: usize) -> String {
    let edges = EdgeView::all(results);
    let contacts: Vec<_> = edges.iter().filter(|edge| edge.geometry.contact).collect();
    let one_load = has_one_load(results);
    let mut text = String::new();
    if contacts.is_empty() {
        for edge in &edges {
            text += &fitted(stress_table(edge, one_load), width);
        }
    }
    for edge in contacts {
        text += &fitted(contact_table(edge, one_load, Detail::Brief), width);
    }
    for view in FailureView::all(results) {
        text += "\n";
        text += &fitted(failure::tables::first_ply(&view), width);
        for sentence in failure::tables::joint_modes(&view) {
            text += &sentence;
            text.push('\n');
        }
        if let Some(joint) = ProgressiveView::of(view) {
            text.push('\n');
            text += &fitted(progressive::tables::milestones(&joint), width);
            for sentence in progressive::tables::verdict(&joint) {
                text += &sentence;
                text.push('\n');
            }
        }
    }
    text
}

/// How many columns a table of load steps has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Detail {
    /// What fits in a terminal.
    Brief,
    /// Everything.
    Full,
}

/// A column of a load-step table: heading, unit, and the cell of a step.
type StepColumn<'a> = (String, String, Box<dyn Fn(usize) -> String + 'a>);

/// Whether the steps of all edges are counted by the same load.
pub(super) fn has_one_load(results: &Results) -> bool {
    shared(results).len() < 2
}

/// One row per load step for a contact edge, with its load in the caption unless there is `one_load` for all.
pub(super) fn contact_table(edge: &EdgeView<'_>, one_load: bool, detail: Detail) -> Table {
    let edge = *edge;
    let mut columns = load_columns(edge);
    columns.extend(extent_columns(edge));
    columns.extend(quantity_columns(edge, detail));
    columns.extend(work_columns(edge, detail));
    let mut table = assembled(edge.results(), &columns);
    table.caption = format!("Contact {}", captioned(&edge, one_load));
    table
}

/// One row per load step for an edge without contact; `one_load` as for [`contact_table`].
pub(super) fn stress_table(edge: &EdgeView<'_>, one_load: bool) -> Table {
    let edge = *edge;
    let mut columns = load_columns(edge);
    columns.extend(quantity_columns(edge, Detail::Brief));
    let mut table = assembled(edge.results(), &columns);
    table.caption = format!("Edge {}", captioned(&edge, one_load));
    table
}

/// The name of an edge, with the load that its table shows where those of other edges show others.
fn captioned(edge: &EdgeView<'_>, one_load: bool) -> String {
    let (name, load) = (&edge.geometry.name, edge.load());
    if load.is_load() && !one_load {
        format!("'{name}', {}", in_sentence(&load.label()))
    } else {
        format!("'{name}'")
    }
}

fn assembled(results: &Results, columns: &[StepColumn<'_>]) -> Table {
    let heading = columns
        .iter()
        .map(|(name, unit, _)| Column::new(name, unit))
        .collect();
    let mut table = Table::new("", heading);
    for step in 0..results.steps.len() {
        table.push(columns.iter().map(|(_, _, cell)| cell(step)));
    }
    table
}

fn column<'a>(
    name: impl Into<String>,
    unit: &str,
    cell: impl Fn(usize) -> String + 'a,
) -> StepColumn<'a> {
    (name.into(), unit.to_owned(), Box::new(cell))
}

fn load_columns(edge: EdgeView<'_>) -> Vec<StepColumn<'_>> {
    let load = edge.load();
    let mut columns = vec![column("step", "", |step| (step + 1).to_string())];
    if load.is_load() {
        let unit = if load.unit == "1" { "" } else { &load.unit };
        let values = load.values.clone();
        columns.push(column("load", unit, move |step| {
            significant(values[step], 5)
        }));
    }
    columns
}

/// A place or a length along the edge in display units.
fn along(edge: EdgeView<'_>, value: Option<f64>) -> String {
    if edge.is_circle() {
        decimals(value, 1)
    } else {
        value.map_or("–".into(), short)
    }
}

/// Contact, stick and slip: half-extents where all lies evenly about the bearing point, otherwise both ends.
fn extent_columns(edge: EdgeView<'_>) -> Vec<StepColumn<'_>> {
    let unit = edge.place_unit();
    let range = move |[start, end]: [f64; 2]| {
        let digits = |value| along(edge, Some(value));
        format!("{} … {}", digits(start), digits(end))
    };
    let mut columns = if lies_evenly(&edge) {
        let half = move |value: Option<f64>| along(edge, value.map(|value| edge.length(value)));
        vec![
            column("contact ±", unit, move |step| {
                half(edge.step(step).contact_half_extent)
            }),
            column("stick ±", unit, move |step| {
                half(edge.step(step).stick_half_extent)
            }),
        ]
    } else {
        vec![
            column("contact", unit, move |step| {
                contact_reach(&edge, step).map_or("–".into(), range)
            }),
            column("stick", unit, move |step| {
                let all = stick_ranges(&edge, step).into_iter().map(range);
                let all: Vec<String> = all.collect();
                if all.is_empty() {
                    "–".into()
                } else {
                    all.join(", ")
                }
            }),
        ]
    };
    if wanders(&edge) {
        columns.insert(
            0,
            column("bears at", unit, move |step| {
                along(edge, edge.bearing_point(step))
            }),
        );
    }
    let slip = move |status| move |step| along(edge, zone_length(&edge, step, status));
    let [positive, negative] = edge.slip_names().map(|name| {
        // Signs stand close to their name in the narrow columns of a table.
        name.replace(" +", "+").replace(" −", "−")
    });
    columns.push(column(positive, unit, slip(Status::SlipPositive)));
    columns.push(column(negative, unit, slip(Status::SlipNegative)));
    columns
}

/// Whether the bearing point of a circle moves by what a reader can see.
fn wanders(edge: &EdgeView<'_>) -> bool {
    const SEEN: f64 = 0.05;
    let mut points = (0..edge.results().steps.len()).filter_map(|step| edge.bearing_point(step));
    edge.is_circle() && points.any(|point| point.abs() > SEEN)
}

/// Whether contact and stick lie evenly about the bearing point, or about x = 0, in all steps.
pub(super) fn lies_evenly(edge: &EdgeView<'_>) -> bool {
    (0..edge.results().steps.len()).all(|step| {
        let stick = stick_ranges(edge, step);
        let has_image = |one: &[f64; 2]| stick.iter().any(|other| edge.are_images(*one, *other));
        stick.iter().all(has_image) && contact_reach(edge, step).is_none_or(even)
    })
}

/// The columns of declared quantities.
fn quantity_columns(edge: EdgeView<'_>, detail: Detail) -> impl Iterator<Item = StepColumn<'_>> {
    let columns = table_columns(edge, detail == Detail::Full);
    columns.map(|own| (own.heading, own.unit.to_owned(), own.cell))
}

fn work_columns(edge: EdgeView<'_>, detail: Detail) -> Vec<StepColumn<'_>> {
    let record = move |step: usize| &edge.results().steps[step];
    let mut columns = vec![column("solves", "", move |step| {
        record(step).work.solves.to_string()
    })];
    if detail == Detail::Full {
        let ratio = move |step| decimals(edge.friction_ratio(step), 4);
        columns.push(column(edge.friction_symbol(), "–", ratio));
    }
    columns.push(column("balance", "–", move |step| {
        format!("{:.1e}", record(step).balance_residual)
    }));
    columns.push(column("time", "ms", move |step| {
        decimals(Some(1e3 * record(step).seconds), 1)
    }));
    columns
}

/// What the program chose.
pub(super) fn choices(results: &Results) -> Table {
    let mut table = Table::new(
        "Choices of the program; each can be set in the scene",
        ["what", "choice", "reason"]
            .iter()
            .map(|name| Column::new(*name, ""))
            .collect(),
    );
    for choice in &results.choices {
        table.push([&choice.what, &choice.value, &choice.reason]);
    }
    table
}

/// Size of each body's model.
pub(super) fn bodies(results: &Results) -> Table {
    let names = [
        "body",
        "nodes",
        "elements",
        "unknowns",
        "factor entries",
        "free motions",
    ];
    let columns = names.iter().map(|name| Column::new(*name, "")).collect();
    let mut table = Table::new("Models of the bodies", columns);
    for body in &results.bodies {
        let size =
            |count: Option<usize>| count.map_or("rigid".to_owned(), |count| count.to_string());
        let mesh = body.mesh.as_ref();
        table.push([
            body.name.clone(),
            size(mesh.map(|mesh| mesh.nodes().len())),
            size(mesh.map(|mesh| mesh.element_count())),
            body.dofs.to_string(),
            body.factor_entries.to_string(),
            body.free_motions.to_string(),
        ]);
    }
    table
}

/// Seconds of each phase.
pub(super) fn phases(results: &Results) -> Table {
    let columns = vec![Column::new("phase", ""), Column::new("wall time", "s")];
    let mut table = Table::new("Where the time went", columns);
    for (phase, seconds) in &results.phases {
        table.push([(*phase).to_owned(), decimals(Some(*seconds), 3)]);
    }
    table
}

/// What the tables count the steps by, where there are several loads.
pub(super) fn load_note(results: &Results) -> Option<String> {
    let loads = &results.steps.first()?.loads;
    let own = shared(results);
    let counted = |(load, names): &(LoadScale, Vec<String>)| {
        let by = in_sentence(&load.label());
        if own.len() > 1 {
            format!("of {} by {by}", names.join(", "))
        } else {
            format!("by {by}")
        }
    };
    let own: Vec<String> = own.iter().map(counted).collect();
    let own = if own.is_empty() {
        format!("by {}", in_sentence(&LoadScale::of(results).label()))
    } else {
        own.join("; ")
    };
    (loads.len() > 1)
        .then(|| format!("Steps are told apart {own}; all loads of every step are in steps.csv."))
}

/// A label within a sentence.
fn in_sentence(label: &str) -> String {
    let mut letters = label.chars();
    letters.next().map_or(String::new(), |first| {
        first.to_lowercase().chain(letters).collect()
    })
}
