//! The page of a sweep: what governs first, then the pictures, all cases, and what was asked.

use stickslip_report::context;
use stickslip_report::page::{Block, Figure, Page, PageError, Section};
use stickslip_report::prose::Prose;
use stickslip_report::table::{Column, Table};

use super::axis::Axis;
use super::engine::Effort;
use super::figures::{Drawing, NotShown};
use super::row::{Measures, Outcome, Row};
use super::verdict::ORDER;
use super::{Sweep, minima, verdict, warning};
use stickslip_engine::results::JointMode;
use stickslip_text::{counted, short, significant};

/// Most cases that the page lists; the table file has all.
const MOST_ROWS: usize = 500;

/// What a page says beside the rows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Account {
    /// Wall time of this run `[s]`.
    pub seconds: f64,
    /// Cases solved in this run; the others were there before.
    pub solved_now: usize,
    /// Workers.
    pub jobs: usize,
    /// What they took.
    pub effort: Effort,
}

/// The page of `rows`, with its pictures and what they do not show.
///
/// # Errors
/// [`PageError::Template`] for notes that cannot be put together.
pub fn page(
    sweep: &Sweep,
    rows: &[Row],
    drawings: &[Drawing],
    not_shown: &[NotShown],
    account: &Account,
) -> Result<Page, PageError> {
    let subtitle = format!("{} · {} cases", sweep.source_name, sweep.cases());
    let mut page = Page::new(&sweep.title, subtitle);
    if rows.len() < sweep.cases() {
        page.warnings.push(format!(
            "{} of {} cases are solved; `--resume` goes on with the others.",
            rows.len(),
            sweep.cases()
        ));
    }
    page.warnings.extend(warning(rows));
    page.warnings
        .extend(not_shown.iter().map(NotShown::to_string));
    page.summary = summary(rows, account);
    page.notes.extend(sweep.description.clone());
    page.notes.extend(notes(sweep).paragraphs()?);
    let governs = Section::new("What governs").with(Block::Text(verdict(sweep, rows)));
    let figures = drawings.iter().map(|drawing| {
        let picture = drawing.picture.clone();
        Figure::new(picture, &drawing.caption, &drawing.name)
    });
    page.sections = vec![
        figures.fold(governs, Section::with),
        Section::new("Axes").with(axes(sweep)),
        Section::new("Cases").with(cases(sweep, rows)),
    ];
    let minima = minima_table(sweep, rows);
    if !minima.rows.is_empty() {
        page.sections.push(Section::new("Minima").with(minima));
    }
    let unresolved = unresolved(sweep, rows);
    if !unresolved.rows.is_empty() {
        page.sections
            .push(Section::new("Without an answer").with(unresolved));
    }
    page.sections.push(files(sweep));
    page.footer = format!(
        "stickslip {} · sweep {}",
        env!("CARGO_PKG_VERSION"),
        sweep.hash
    );
    Ok(page)
}

fn summary(rows: &[Row], account: &Account) -> Vec<(String, String)> {
    let of_all = |count: usize| format!("{count} of {}", rows.len());
    let joints = |mode: JointMode| {
        let joints = rows.iter().filter_map(Row::joint);
        joints.filter(|joint| joint.mode == mode).count()
    };
    let mut summary: Vec<(String, String)> = (ORDER.into_iter())
        .map(|mode| (capitalised(mode.name()), joints(mode)))
        .filter(|(_, count)| *count > 0)
        .map(|(name, count)| (name, of_all(count)))
        .collect();
    let unresolved = rows.iter().filter(|row| row.measures().is_none()).count();
    if unresolved > 0 {
        summary.push(("No answer".to_owned(), of_all(unresolved)));
    }
    if account.solved_now > 0 {
        let seconds = short(account.seconds);
        let each = short(account.seconds / account.solved_now as f64);
        let time = format!(
            "{seconds} s: {} cases, {each} s each, {}, {} bodies condensed",
            account.solved_now,
            counted(account.jobs, "worker"),
            account.effort.condensed
        );
        summary.push(("Wall time".to_owned(), time));
    }
    summary
}

fn capitalised(words: &str) -> String {
    let mut letters = words.chars();
    let first = letters
        .next()
        .map(|letter| letter.to_uppercase().to_string());
    first.unwrap_or_default() + letters.as_str()
}

/// What the cases have in common, and what their loads are.
fn notes(sweep: &Sweep) -> Prose {
    Prose::new(
        include_str!("page/notes.jinja"),
        context! {
            scene => &sweep.scene.title,
            source => &sweep.scene.source_name,
            fails => sweep.scene.failure.is_some(),
        },
    )
}

fn axes(sweep: &Sweep) -> Table {
    let rows = sweep.axes.iter().map(|axis| {
        let values = (0..axis.values.len()).map(|value| axis.value_text(value));
        [
            axis.symbol().to_owned(),
            axis.key.name().to_owned(),
            values.collect::<Vec<_>>().join(", "),
        ]
    });
    Table::headed("", "axis | key | values").with_rows(rows)
}

fn cases(sweep: &Sweep, rows: &[Row]) -> Table {
    let unit = |axis: &Axis| axis.unit.map_or("", |unit| unit.name);
    let axes = sweep.axes.iter();
    let axes = axes.map(|axis| Column::new(axis.symbol(), unit(axis)));
    let (load, stress) = (sweep.load_unit.as_str(), sweep.scene.display.stress.name);
    let fails = sweep.scene.failure.is_some();
    let failures = if fails {
        format!(" | first ply [{load}] | ply | criterion: mode | joint [{load}] | mode | at [deg]")
    } else {
        String::new()
    };
    let headings = format!(
        "peak pressure [{stress}] | contact ± [deg] | stick ± [deg] | peak hoop [{stress}] | at [deg] | bearing stress [{stress}] | load share{failures}"
    );
    let mut table = Table::headed("", &headings);
    table.columns.splice(0..0, axes);
    let mut sorted: Vec<&Row> = rows.iter().collect();
    sorted.sort_by_key(|row| row.case);
    for row in sorted.iter().take(MOST_ROWS) {
        let values = sweep.axes.iter().zip(sweep.values_of(row.case));
        let values = values.map(|(axis, value)| axis.cell(value));
        let measures = row.measures();
        let contact = measures.into_iter().flat_map(contact_cells);
        let failures = measures
            .filter(|_| fails)
            .into_iter()
            .flat_map(failure_cells);
        table.push(values.chain(contact).chain(failures));
    }
    if sorted.len() <= MOST_ROWS {
        return table;
    }
    table.note(format!(
        "The first {MOST_ROWS} of {} cases; cases.csv has all.",
        sorted.len()
    ))
}

/// A number, with its error where it has one.
fn stated(value: Option<f64>, error: Option<f64>) -> String {
    match value.zip(error) {
        Some((value, error)) => format!("{} ± {}", significant(value, 5), significant(error, 2)),
        None => value.map_or_else(String::new, short),
    }
}

fn contact_cells(measures: &Measures) -> [String; 7] {
    let errors = measures.errors;
    let [hoop, place] = [0, 1].map(|k| measures.peak_hoop.map(|own| own[k]));
    [
        stated(measures.peak_pressure, errors.peak_pressure),
        stated(measures.contact_half_angle, errors.contact_half_angle),
        stated(measures.stick_half_angle, errors.stick_half_angle),
        stated(hoop, errors.peak_hoop),
        stated(place, errors.peak_hoop_angle),
        stated(measures.bearing_stress, errors.bearing_stress),
        stated(measures.load_share, errors.load_share),
    ]
}

fn failure_cells(measures: &Measures) -> [String; 6] {
    let first = measures.first_ply.as_ref();
    let joint = measures.joint.as_ref();
    [
        stated(
            first.and_then(|first| first.load),
            first.and_then(|first| first.load_error),
        ),
        first.map_or_else(String::new, |first| first.ply.clone()),
        first.map_or_else(String::new, |first| {
            format!("{}: {}", first.criterion, first.mode)
        }),
        stated(
            joint.and_then(|joint| joint.load),
            joint.and_then(|joint| joint.load_error),
        ),
        joint.map_or_else(String::new, |joint| joint.mode.name().to_owned()),
        stated(joint.map(|joint| joint.angle), None),
    ]
}

/// Where numbers are least along an axis, and whether their errors leave that open.
fn minima_table(sweep: &Sweep, rows: &[Row]) -> Table {
    let all = minima(sweep, rows);
    let mut table = Table::headed(
        "",
        "number | unit | along | least where | value | by its error",
    );
    for own in all.iter().take(MOST_ROWS) {
        let [value, error] = own.value;
        table.push([
            own.number.replace('_', " "),
            own.unit.to_owned(),
            sweep.axes[own.axis].symbol().to_owned(),
            sweep.name_of(own.case),
            format!("{} ± {}", significant(value, 5), significant(error, 2)),
            if own.is_open {
                "open: a neighbour may be as low".to_owned()
            } else {
                "lower than its neighbours".to_owned()
            },
        ]);
    }
    if all.len() <= MOST_ROWS {
        return table;
    }
    table.note(format!(
        "The first {MOST_ROWS} of {} minima; summary.json has all.",
        all.len()
    ))
}

fn unresolved(sweep: &Sweep, rows: &[Row]) -> Table {
    let mut table = Table::headed("", "case | reason");
    for row in rows {
        if let Outcome::Unresolved(reason) = &row.outcome {
            table.push([sweep.name_of(row.case), reason.clone()]);
        }
    }
    table
}

fn files(sweep: &Sweep) -> Section {
    let errors = if sweep.states_errors() {
        " and their errors"
    } else {
        ""
    };
    let cases = format!(
        "one row per case: {} axes, contact, hoop stress{errors}, first ply, failure of the joint, time, outcome, findings",
        sweep.axes.len()
    );
    Section::of_files([
        ("cases.csv", cases.as_str()),
        ("sweep.json", "which sweep the rows belong to"),
        ("summary.json", "what governs, and counts, for programs"),
        ("figures/*.svg, figures/*.png", "the figures of this page"),
    ])
}
