//! Tables for the terminal and the page: load steps, signs, choices, bodies.

mod fit;
mod signs;

pub use signs::signs;
pub(super) use signs::signs_table;

use stickslip_fem_core::mesh::Mesh;
use stickslip_report::table::{Columns, Table};

use super::bypass;
use super::choices;
use super::display::shared;
use super::display::{EdgeView, even};
use super::failure::{self, FailureView};
use super::fasteners;
use super::progressive::{self, ProgressiveView};
use super::quantities::table_columns;
use super::sets;
use super::sharing;
use super::stresses;
use super::zones::{contact_reach, stick_ranges};
use fit::fitted;
use stickslip_results::LoadScale;
use stickslip_results::{BodySummary, Bounded, Choice, LadderEnd, Results, Rung, Stated};
use stickslip_scene::schema::Accuracy;
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
    for table in sharing::tables(results)
        .into_iter()
        .chain(bypass::tables(results))
        .chain(fasteners::tables(results))
        .chain(sets::tables(results))
        .chain(sets::reactions(results))
    {
        text += &fitted(table, width);
    }
    if let Some(table) = stresses::table(results) {
        text += &fitted(table, width);
    }
    if let Some(ladder) = ladder(results) {
        text.push('\n');
        text += &fitted(ladder, width);
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

/// Whether the steps of all edges are counted by the same load.
pub(super) fn has_one_load(results: &Results) -> bool {
    shared(results).len() < 2
}

/// One row per load step for a contact edge, with its load in the caption unless there is `one_load` for all.
pub(super) fn contact_table(edge: &EdgeView<'_>, one_load: bool, detail: Detail) -> Table {
    let edge = *edge;
    let full = detail == Detail::Full;
    let columns = load_columns(edge).and([
        extent_columns(edge),
        table_columns(edge, full),
        work_columns(edge, full),
    ]);
    let caption = format!("Contact {}", captioned(&edge, one_load));
    columns.table(caption, 0..edge.results().steps.len())
}

/// One row per load step for an edge without contact; `one_load` as for [`contact_table`].
pub(super) fn stress_table(edge: &EdgeView<'_>, one_load: bool) -> Table {
    let columns = load_columns(*edge).and([table_columns(*edge, false)]);
    let caption = format!("Edge {}", captioned(edge, one_load));
    columns.table(caption, 0..edge.results().steps.len())
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

/// Columns of a table of load steps.
type StepColumns<'a> = Columns<'a, usize>;

fn load_columns(edge: EdgeView<'_>) -> StepColumns<'_> {
    let load = edge.load();
    let columns = StepColumns::new().with("step", "", |step| (step + 1).to_string());
    if !load.is_load() {
        return columns;
    }
    let unit = if load.unit == "1" { "" } else { &load.unit };
    columns.with("load", unit.to_owned(), move |step| {
        significant(load.values[step], 5)
    })
}

/// A place or a length along the edge in display units.
fn along(edge: EdgeView<'_>, value: Option<f64>) -> String {
    if edge.is_circle() {
        decimals(value, 1)
    } else {
        value.map_or("–".into(), short)
    }
}

/// The cell of a length or place with its estimated error in brackets, where it has both.
fn bracketed(edge: EdgeView<'_>, step: usize, stated: Stated, cell: String) -> String {
    let results = edge.step(step);
    let error = stated
        .value(results)
        .and_then(|_| results.errors.get(stated));
    match error {
        Some(error) => format!("{cell} ({})", significant(edge.length(error), 1)),
        None => cell,
    }
}

/// Contact, stick and slip: half-extents where all lies evenly about the bearing point, otherwise both ends.
fn extent_columns(edge: EdgeView<'_>) -> StepColumns<'_> {
    let unit = edge.place_unit();
    let mut columns = StepColumns::new();
    if wanders(&edge) {
        columns = columns.with("bears at", unit, move |step| {
            let cell = along(edge, edge.bearing_point(step));
            bracketed(edge, step, Stated::Bearing, cell)
        });
    }
    let half = move |value: Option<f64>| along(edge, value.map(|value| edge.length(value)));
    let range = move |[start, end]: [f64; 2]| {
        let digits = |value| along(edge, Some(value));
        format!("{} … {}", digits(start), digits(end))
    };
    let with_error = move |step: usize, stated: Stated| {
        let cell = half(stated.value(edge.step(step)));
        bracketed(edge, step, stated, cell)
    };
    columns = if lies_evenly(&edge) {
        columns
            .with("contact ±", unit, move |step| {
                with_error(step, Stated::ContactExtent)
            })
            .with("stick ±", unit, move |step| {
                with_error(step, Stated::StickExtent)
            })
    } else {
        columns
            .with("contact", unit, move |step| {
                contact_reach(&edge, step).map_or("–".into(), range)
            })
            .with("stick", unit, move |step| {
                let all: Vec<String> = stick_ranges(&edge, step).into_iter().map(range).collect();
                if all.is_empty() {
                    "–".into()
                } else {
                    all.join(", ")
                }
            })
    };
    let slip = move |stated| move |step| with_error(step, stated);
    let [positive, negative] = edge.slip_names().map(|name| {
        // Signs stand close to their name in the narrow columns of a table.
        name.replace(" +", "+").replace(" −", "−")
    });
    columns.with(positive, unit, slip(Stated::SlipAway)).with(
        negative,
        unit,
        slip(Stated::SlipTowards),
    )
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

fn work_columns(edge: EdgeView<'_>, full: bool) -> StepColumns<'_> {
    let record = move |step: usize| &edge.results().steps[step];
    let mut columns = StepColumns::new().with("solves", "", move |step| {
        record(step).work.solves.to_string()
    });
    if full {
        let ratio = move |step| {
            let cell = decimals(edge.friction_ratio(step), 4);
            match edge.friction_ratio_error(step) {
                Some(error) => format!("{cell} ± {}", significant(error, 2)),
                None => cell,
            }
        };
        columns = columns.with(edge.friction_symbol(), "–", ratio);
    }
    columns
        .with("balance", "–", move |step| {
            format!("{:.1e}", record(step).balance_residual)
        })
        .with("time", "ms", move |step| {
            decimals(Some(1e3 * record(step).seconds), 1)
        })
}

/// What the program chose.
pub(super) fn choices(results: &Results) -> Table {
    let caption = "Choices of the program; each can be set in the scene";
    let row = |choice: Choice| [choice.what, choice.value, choice.reason];
    let rows = choices::choices(results).into_iter().map(row);
    Table::headed(caption, "what | choice | reason").with_rows(rows)
}

/// The models that were tried for an accuracy, with their errors; none where none was sought.
pub(super) fn ladder(results: &Results) -> Option<Table> {
    let ladder = results.ladder.as_ref()?;
    let asked = ladder.asked.map_or("no accuracy asked".into(), |asked| {
        format!("{} asked, {}", describe(asked), end(ladder.end))
    });
    let row = |rung: &Rung| {
        let (error, of) = rung.error.map_or(("–".into(), ""), |(error, stated)| {
            (percent(error), stated.describe())
        });
        [
            rung.model.clone() + if rung.stopped { ", stopped" } else { "" },
            from_to(&rung.increments),
            error,
            of.to_owned(),
            decimals(Some(1e3 * rung.seconds), 1),
        ]
    };
    let headings = "model | increments | largest error | of | time [ms]";
    let caption = format!("Models tried: {asked}");
    Some(Table::headed(caption, headings).with_rows(ladder.rungs.iter().map(row)))
}

/// Least and largest of `counts`, once where they are equal.
fn from_to(counts: &[usize]) -> String {
    match (counts.iter().min(), counts.iter().max()) {
        (Some(least), Some(most)) if least != most => format!("{least}–{most}"),
        (_, most) => most.map_or_else(String::new, usize::to_string),
    }
}

/// A relative error as "0.1 %".
fn percent(share: f64) -> String {
    format!("{} %", significant(100.0 * share, 2))
}

/// What is asked: "1 %", or "peak pressure 0.1 %, extent of contact 0.5 %".
fn describe(asked: Accuracy) -> String {
    if let Accuracy::Overall(error) = asked {
        return percent(error.share());
    }
    let named = Bounded::all(asked)
        .map(|(number, bound)| format!("{} {}", number.describe(), percent(bound)));
    named.collect::<Vec<_>>().join(", ")
}

fn end(end: LadderEnd) -> &'static str {
    match end {
        LadderEnd::Reached => "reached",
        LadderEnd::Pinned => "not reached: the scene pins the model",
        LadderEnd::Budget => "not reached within the budget",
        LadderEnd::Memory => "not reached within the memory",
        LadderEnd::Finest => "not reached by the finest model that is tried",
        LadderEnd::LoadPath => "not reached: the increments of load steps leave more",
        LadderEnd::Unstated => "not known: no error can be stated of a number that is asked for",
        LadderEnd::Unchecked => "not known: gaps on the deformed geometry were not found",
    }
}

/// Size of each body's model.
pub(super) fn bodies(results: &Results) -> Table {
    let headings = "body | nodes | elements | unknowns | factor entries | free motions";
    let row = |body: &BodySummary| {
        let size = |count: fn(&Mesh) -> usize| match &body.mesh {
            Some(mesh) => count(mesh).to_string(),
            None => "rigid".to_owned(),
        };
        [
            body.name.clone(),
            size(|mesh| mesh.nodes().len()),
            size(Mesh::element_count),
            body.dofs.to_string(),
            body.factor_entries.to_string(),
            body.free_motions.to_string(),
        ]
    };
    Table::headed("Models of the bodies", headings).with_rows(results.bodies.iter().map(row))
}

/// Seconds of each phase.
pub(super) fn phases(results: &Results) -> Table {
    let phases = results.phases.iter();
    let rows = phases.map(|(phase, time)| [(*phase).to_owned(), decimals(Some(*time), 3)]);
    Table::headed("Where the time went", "phase | wall time [s]").with_rows(rows)
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
    (loads.len() > 1).then(|| {
        format!("Steps are distinguished {own}; all loads of every step are in steps.csv.")
    })
}

/// A label within a sentence.
fn in_sentence(label: &str) -> String {
    let mut letters = label.chars();
    letters.next().map_or(String::new(), |first| {
        first.to_lowercase().chain(letters).collect()
    })
}
