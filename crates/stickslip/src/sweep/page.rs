//! The page of a sweep: what governs first, then the pictures, all cases, and what was asked.

use stickslip_report::page::{Block, Figure, Page, Section};
use stickslip_report::table::{Column, Table};

use super::engine::Effort;
use super::figures::Drawing;
use super::row::{Measures, Outcome, Row};
use super::verdict::ORDER;
use super::{Sweep, verdict};
use stickslip_text::short;

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

/// The page of `rows`, with its pictures and remarks on those that are missing.
pub fn page(
    sweep: &Sweep,
    rows: &[Row],
    drawings: &[Drawing],
    remarks: &[String],
    account: &Account,
) -> Page {
    let subtitle = format!("{} · {} cases", sweep.source_name, sweep.cases());
    let mut page = Page::new(&sweep.title, subtitle);
    page.warnings = remarks.to_vec();
    if rows.len() < sweep.cases() {
        page.warnings.insert(
            0,
            format!(
                "{} of {} cases are solved; `--resume` goes on with the others.",
                rows.len(),
                sweep.cases()
            ),
        );
    }
    page.summary = summary(rows, account);
    page.notes = notes(sweep);
    let figures = drawings.iter().map(|drawing| {
        Block::Figure(Figure::new(
            drawing.picture.clone(),
            &drawing.caption,
            &drawing.name,
        ))
    });
    let figures: Vec<Block> = figures.collect();
    let governs = Section::new("What governs").with(Block::Text(verdict(sweep, rows)));
    page.sections
        .push(figures.into_iter().fold(governs, Section::with));
    page.sections
        .push(Section::new("Axes").with(Block::Table(axes(sweep))));
    page.sections
        .push(Section::new("Cases").with(Block::Table(cases(sweep, rows))));
    let unresolved = unresolved(sweep, rows);
    if !unresolved.rows.is_empty() {
        page.sections
            .push(Section::new("Without an answer").with(Block::Table(unresolved)));
    }
    page.sections
        .push(Section::new("Files").with(Block::Table(files(sweep))));
    page.footer = format!(
        "stickslip {} · sweep {}",
        env!("CARGO_PKG_VERSION"),
        sweep.hash
    );
    page
}

fn summary(rows: &[Row], account: &Account) -> Vec<(String, String)> {
    let workers = match account.jobs {
        1 => "1 worker".to_owned(),
        jobs => format!("{jobs} workers"),
    };
    let mut summary = Vec::new();
    for mode in ORDER {
        let own = rows
            .iter()
            .filter_map(Row::joint)
            .filter(|joint| joint.mode == mode);
        let count = own.count();
        if count > 0 {
            summary.push((
                capitalised(mode.name()),
                format!("{count} of {}", rows.len()),
            ));
        }
    }
    let unresolved = rows.iter().filter(|row| row.measures().is_none()).count();
    if unresolved > 0 {
        summary.push((
            "No answer".to_owned(),
            format!("{unresolved} of {}", rows.len()),
        ));
    }
    if account.solved_now > 0 {
        let each = short(account.seconds / account.solved_now as f64);
        summary.push((
            "Wall time".to_owned(),
            format!(
                "{} s: {} cases, {each} s each, {workers}, {} bodies condensed",
                short(account.seconds),
                account.solved_now,
                account.effort.condensed
            ),
        ));
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

fn notes(sweep: &Sweep) -> Vec<String> {
    let mut notes: Vec<String> = sweep.description.iter().cloned().collect();
    notes.push(format!(
        "All cases start from the scene '{}' ({}); contact and hoop stress are those at its largest load.",
        sweep.scene.title, sweep.scene.source_name
    ));
    notes.push(
        "A failure load that the history does not reach is the largest load times the reserve factor there: exact where contact no \
         longer spreads, an estimate elsewhere. The first-ply load depends on the mesh where its place is the edge of the hole."
            .to_owned(),
    );
    notes.push(
        "Failure is asked of the stresses of the undamaged joint. Where damage spreads before a joint breaks, and above all at narrow net \
         sections, follow single joints by [failure.progressive]; sweeps leave it out."
            .to_owned(),
    );
    notes
}

fn axes(sweep: &Sweep) -> Table {
    let columns = ["axis", "key", "values"].map(|name| Column::new(name, ""));
    let mut table = Table::new("", columns.into());
    for axis in &sweep.axes {
        let values: Vec<String> = (0..axis.values.len())
            .map(|value| axis.value_text(value))
            .collect();
        table.push([
            axis.symbol().to_owned(),
            axis.key.name().to_owned(),
            values.join(", "),
        ]);
    }
    table
}

fn cases(sweep: &Sweep, rows: &[Row]) -> Table {
    let unit = |axis: &super::axis::Axis| axis.unit.map_or("", |unit| unit.name);
    let (load, stress) = (sweep.load_unit.as_str(), sweep.scene.display.stress.name);
    let mut columns: Vec<Column> = sweep
        .axes
        .iter()
        .map(|axis| Column::new(axis.symbol(), unit(axis)))
        .collect();
    columns.extend([
        Column::new("peak pressure", stress),
        Column::new("contact ±", "deg"),
        Column::new("peak hoop", stress),
        Column::new("at", "deg"),
        Column::new("first ply", load),
        Column::new("ply", ""),
        Column::new("criterion: mode", ""),
        Column::new("joint", load),
        Column::new("mode", ""),
        Column::new("at", "deg"),
    ]);
    let mut sorted: Vec<&Row> = rows.iter().collect();
    sorted.sort_by_key(|row| row.case);
    let mut table = Table::new("", columns);
    for row in sorted.iter().take(MOST_ROWS) {
        let values = sweep.axes.iter().zip(sweep.values_of(row.case));
        let mut cells: Vec<String> = values.map(|(axis, value)| axis.cell(value)).collect();
        cells.extend(row.measures().into_iter().flat_map(case_cells));
        table.push(cells);
    }
    if sorted.len() > MOST_ROWS {
        let note = format!(
            "The first {MOST_ROWS} of {} cases; cases.csv has all.",
            sorted.len()
        );
        return table.note(note);
    }
    table
}

fn case_cells(measures: &Measures) -> Vec<String> {
    let number = |value: Option<f64>| value.map_or_else(String::new, short);
    let first = measures.first_ply.as_ref();
    let joint = measures.joint.as_ref();
    vec![
        number(measures.peak_pressure),
        number(measures.contact_half_angle),
        number(measures.peak_hoop.map(|[most, _]| most)),
        number(measures.peak_hoop.map(|[_, place]| place)),
        number(first.and_then(|first| first.load)),
        first.map_or_else(String::new, |first| first.ply.clone()),
        first.map_or_else(String::new, |first| {
            format!("{}: {}", first.criterion, first.mode)
        }),
        number(joint.and_then(|joint| joint.load)),
        joint.map_or_else(String::new, |joint| joint.mode.name().to_owned()),
        number(joint.map(|joint| joint.angle)),
    ]
}

fn unresolved(sweep: &Sweep, rows: &[Row]) -> Table {
    let columns = ["case", "reason"].map(|name| Column::new(name, ""));
    let mut table = Table::new("", columns.into());
    for row in rows {
        if let Outcome::Unresolved(reason) = &row.outcome {
            table.push([sweep.name_of(row.case), reason.clone()]);
        }
    }
    table
}

fn files(sweep: &Sweep) -> Table {
    let columns = ["file", "holds"].map(|name| Column::new(name, ""));
    let mut table = Table::new("", columns.into());
    let about = format!(
        "one row per case: {} axes, contact, hoop stress, first ply, failure of the joint, time, outcome",
        sweep.axes.len()
    );
    table.push(["cases.csv", &about]);
    table.push(["sweep.json", "which sweep the rows belong to"]);
    table.push(["summary.json", "what governs, and counts, for programs"]);
    table.push(["figures/*.svg, figures/*.png", "the figures of this page"]);
    table
}
