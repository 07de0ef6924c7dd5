//! `report.html`: the answer first, then the load steps, the figures, and how it was done.

use stickslip_report::context;
use stickslip_report::page::{Block, Figure, Page, PageError, Section};
use stickslip_report::prose::Prose;

use super::FileNote;
use super::bypass;
use super::display::EdgeView;
use super::display::shared;
use super::failure::{self, FailureView};
use super::fasteners;
use super::figures::{Drawing, Group, sides};
use super::findings;
use super::problem;
use super::progressive::{self, ProgressiveView};
use super::sets;
use super::sharing;
use super::stresses;
use super::tables::{self, Detail};
use super::zones::{contact_ranges, stick_ranges};
use stickslip_results::LoadScale;
use stickslip_results::{Results, Stated, StepResults};
use stickslip_text::{counted, decimals, short, significant};

/// The page of `results` with its figures; `failures` are figures that could not be drawn.
pub(super) fn page(
    results: &Results,
    drawings: Vec<Drawing>,
    failures: &[String],
    files: &[FileNote],
) -> Result<Page, PageError> {
    let mut page = Page::new(&results.title, subtitle(results));
    page.warnings = findings::sentences(results);
    page.warnings.extend_from_slice(failures);
    page.summary = summary(results);
    page.notes = notes(results);
    let (joint, drawings): (Vec<_>, Vec<_>) = drawings
        .into_iter()
        .partition(|drawing| drawing.group == Group::Joint);
    let (sketches, mut drawings): (Vec<_>, Vec<_>) = drawings
        .into_iter()
        .partition(|drawing| drawing.group == Group::Problem);
    page.sections.extend(joint_section(results, joint));
    page.sections.push(steps_section(results)?);
    page.sections.extend(failure_section(results));
    let groups = [
        (Group::Edge, "Along the edges"),
        (Group::History, "Through the load history"),
        (Group::Failure, "Plies"),
        (Group::Field, "Fields"),
    ];
    for (group, title) in groups {
        let (here, rest): (Vec<_>, Vec<_>) = drawings
            .into_iter()
            .partition(|drawing| drawing.group == group);
        drawings = rest;
        if !here.is_empty() {
            page.sections.push(figure_section(title, here));
        }
    }
    let modelled = [
        tables::choices(results),
        tables::bodies(results),
        tables::phases(results),
    ];
    let modelled = (tables::ladder(results).into_iter().chain(modelled))
        .fold(Section::new("How it was modelled"), Section::with);
    let signs = Section::new("Signs and names").with(tables::signs_table());
    page.sections.extend(problem::section(results, sketches));
    page.sections.extend([modelled, signs, file_section(files)]);
    page.footer = format!(
        "stickslip {} · scene {}",
        env!("CARGO_PKG_VERSION"),
        results.scene_hash
    );
    Ok(page)
}

fn subtitle(results: &Results) -> String {
    let steps = counted(results.steps.len(), "load step");
    format!("{} · {steps}", results.source)
}

fn figure_section(title: &str, drawings: Vec<Drawing>) -> Section {
    let figures = drawings
        .into_iter()
        .map(|drawing| Figure::new(drawing.picture, drawing.caption, drawing.name));
    figures.fold(Section::new(title), Section::with)
}

/// Contacts whose numbers are summed up.
const SUMMED_UP: usize = 4;

/// A name and a value.
type Row = (String, String);

/// The most important numbers, at the largest load.
fn summary(results: &Results) -> Vec<Row> {
    let load = LoadScale::of(results);
    let Some(step) = load.peak_step() else {
        return Vec::new();
    };
    let joints = FailureView::all(results).into_iter();
    let mut rows: Vec<Row> = joints
        .filter_map(ProgressiveView::of)
        .map(|joint| progressive::tables::headline(&joint))
        .collect();
    if tables::has_one_load(results) {
        rows.push(largest_load(&load, step));
    }
    rows.extend(contacts_summary(results));
    rows.extend(solution_summary(results));
    rows
}

fn largest_load(load: &LoadScale, step: usize) -> Row {
    let value = format!("{}, {}", load.name, load.step_text(step));
    ("Largest load".to_owned(), value)
}

/// The numbers of the first contacts, each at its own largest load, or of the edge that tables show.
fn contacts_summary(results: &Results) -> Vec<Row> {
    let mut edges = EdgeView::all(results);
    edges.retain(|edge| edge.geometry.contact);
    let several = edges.len() > 1;
    if !several {
        edges = EdgeView::main(results).into_iter().collect();
    }
    let mut rows = Vec::new();
    for edge in edges.iter().take(SUMMED_UP) {
        let load = edge.load();
        let Some(step) = load.peak_step() else {
            continue;
        };
        let mut own = edge_summary(edge, step);
        if !tables::has_one_load(results) {
            own.insert(0, largest_load(&load, step));
        }
        if several {
            for (name, _) in &mut own {
                *name = format!("'{}': {name}", edge.geometry.name);
            }
        }
        rows.extend(own);
    }
    if let Some(further @ 1..) = edges.len().checked_sub(SUMMED_UP) {
        let contacts = counted(further, "contact");
        rows.push((
            "Further".to_owned(),
            format!("{contacts}, in the tables below"),
        ));
    }
    rows
}

/// How well the contact conditions are met, and what the solution took.
fn solution_summary(results: &Results) -> Vec<Row> {
    let mut rows = Vec::new();
    let mut add = |name: &str, value: String| rows.push((name.to_owned(), value));
    let worst = |value: fn(&StepResults) -> f64| {
        let values = results.steps.iter().map(value);
        // The largest, or NaN if there is one, which `max` would drop.
        let worst = values.fold(0.0, |worst: f64, value| {
            if worst.is_nan() || value <= worst {
                worst
            } else {
                value
            }
        });
        format!("{worst:.1e}")
    };
    add(
        "Unbalanced force, worst step",
        format!("{} of the load", worst(|step| step.balance_residual)),
    );
    if results.edges.iter().any(|edge| edge.contact) {
        add(
            "Contact conditions, worst step",
            format!(
                "complementarity {}, friction cone {}",
                worst(|step| step.residuals.complementarity),
                worst(|step| step.residuals.cone)
            ),
        );
    }
    let dofs: usize = results.bodies.iter().map(|body| body.dofs).sum();
    let seconds: f64 = results.phases.iter().map(|(_, seconds)| seconds).sum();
    add(
        "Unknowns",
        format!("{dofs}, {} factorisations", results.factorisations),
    );
    add("Wall time", format!("{} s", short(seconds)));
    rows
}

fn edge_summary(edge: &EdgeView<'_>, step: usize) -> Vec<Row> {
    let mut rows = Vec::new();
    let mut add = |name: String, value: String| rows.push((name, value));
    let record = edge.step(step);
    let unit = edge.units().stress.name;
    let margin = |error: Option<f64>| {
        error.map_or(String::new(), |error| {
            format!(" ± {}", significant(edge.stress(error), 2))
        })
    };
    let stress = |value: f64, error: Option<f64>| {
        let value_shown = significant(edge.stress(value), 5);
        let absolute = format!("{value_shown}{} {unit}", margin(error));
        match edge.bearing(step).filter(|_| edge.geometry.contact) {
            Some(bearing) => format!("{absolute} = {} σ_b", decimals(Some(value / bearing), 3)),
            None => absolute,
        }
    };
    if let Some(bearing) = edge.bearing(step).filter(|_| edge.geometry.contact) {
        add(
            "Bearing stress σ_b".into(),
            format!(
                "{}{} {unit}",
                significant(edge.stress(bearing), 5),
                margin(edge.bearing_error(step))
            ),
        );
    }
    if let Some(bearing) = edge.geometry.frame.bearing.filter(|_| edge.is_circle()) {
        add(
            "Bearing point φ = 0".into(),
            format!("at θ = {} from +x", edge.extent(bearing)),
        );
    }
    if let Some(contact) = edge.ranges(&contact_ranges(edge, step)) {
        add("Contact".into(), contact);
        let stick = edge.ranges(&stick_ranges(edge, step));
        add("Stick".into(), stick.unwrap_or_else(|| "nowhere".into()));
    }
    if let Some((pressure, place)) = record.peak_pressure {
        add(
            "Largest pressure".into(),
            format!(
                "{} at {}",
                stress(pressure, record.errors.get(Stated::PeakPressure)),
                edge.at(place)
            ),
        );
    }
    if let Some((hoop, place)) = record.peak_hoop {
        let name = format!("Largest {}", edge.stress_symbols()[1]);
        let error = record.errors.get(Stated::PeakHoop);
        add(
            name,
            format!("{} at {}", stress(hoop, error), edge.at(place)),
        );
    }
    if let Some(ratio) = edge.friction_ratio(step) {
        add(format!("Friction {}", edge.friction_symbol()), short(ratio));
    }
    rows
}

fn notes(results: &Results) -> Vec<String> {
    let mut notes = Vec::new();
    if results.edges.iter().any(|edge| edge.half) {
        notes.push(
            "One half of a symmetric model was solved: angles run from 0° to 180°, forces are those of the whole, field files \
             hold the half."
                .to_owned(),
        );
    }
    notes.extend(tables::load_note(results));
    notes
}

fn steps_section(results: &Results) -> Result<Section, PageError> {
    let mut section = Section::new("Load steps");
    let one_load = tables::has_one_load(results);
    for edge in EdgeView::all(results) {
        section = section.with(if edge.geometry.contact {
            let mut table = tables::contact_table(&edge, one_load, Detail::Full);
            table.notes.extend(columns_notes(&edge).paragraphs()?);
            table
        } else {
            tables::stress_table(&edge, one_load)
        });
    }
    let sides = EdgeView::all(results);
    let sides = sides.iter().filter_map(sides::table);
    section = sides.fold(section, Section::with);
    let stresses = stresses::table(results).map(|table| table.note(stresses::NOTE));
    let further = sharing::tables(results).into_iter();
    let further = further
        .chain(bypass::tables(results))
        .chain(fasteners::tables(results));
    let further = further
        .chain(sets::tables(results))
        .chain(sets::reactions(results));
    section = further.chain(stresses).fold(section, Section::with);
    if results.steps.len() > 1 {
        let text = single_steps(results).map(Block::Text);
        section = text.into_iter().fold(section, Section::with);
    }
    Ok(section)
}

/// Which step figures of a single step show.
fn single_steps(results: &Results) -> Option<String> {
    let shown = |load: &LoadScale| {
        let step = load.peak_step()?;
        Some(format!("step {} ({})", step + 1, load.text(step)))
    };
    let own: Vec<String> = (shared(results).into_iter())
        .filter_map(|(load, names)| Some(format!("of {} {}", names.join(", "), shown(&load)?)))
        .collect();
    if own.len() > 1 {
        return Some(format!(
            "Figures of a single step show the largest load that acts there: {}.",
            own.join("; ")
        ));
    }
    let step = shown(&LoadScale::of(results))?;
    Some(format!(
        "Figures of a single step show {step}, the largest load."
    ))
}

/// What the columns of a contact's steps mean.
fn columns_notes(edge: &EdgeView<'_>) -> Prose {
    let bearing = edge.geometry.frame.bearing;
    Prose::new(
        include_str!("page/steps.jinja"),
        context! {
            evenly => tables::lies_evenly(edge),
            along_edge => !edge.slips_about_bearing(),
            circle => edge.is_circle(),
            bearing => bearing.map(|bearing| edge.extent(bearing)),
        },
    )
}

/// A joint that was followed to its end: what it bears, how it fails and why, with its figures.
fn joint_section(results: &Results, drawings: Vec<Drawing>) -> Option<Section> {
    let views = FailureView::all(results);
    let joints: Vec<_> = (views.into_iter().filter_map(ProgressiveView::of)).collect();
    let mut section = figure_section("The joint to its end", drawings);
    for joint in joints.iter().rev() {
        let mut blocks = vec![Block::Table(progressive::tables::milestones(joint))];
        blocks.extend(
            progressive::tables::verdict(joint)
                .into_iter()
                .map(Block::Text),
        );
        blocks.push(Block::Text(
            "All other sections show the joint whose plies do not fail, under the loads of the scene.".to_owned(),
        ));
        section.blocks.splice(0..0, blocks);
    }
    (!joints.is_empty()).then_some(section)
}

/// What fails first in every laminated body, and how far each step is from it.
fn failure_section(results: &Results) -> Option<Section> {
    let views = FailureView::all(results);
    let mut section = Section::new("Failure of plies");
    for view in &views {
        section = section.with(failure::tables::first_ply(view));
        for sentence in failure::tables::joint_modes(view) {
            section = section.with(Block::Text(sentence));
        }
        section = section
            .with(failure::tables::steps(view))
            .with(failure::tables::plies(view));
    }
    (!views.is_empty()).then_some(section)
}

fn file_section(files: &[FileNote]) -> Section {
    let summary = (
        "summary.json",
        "all quantities of the load steps for other programs",
    );
    let files = files
        .iter()
        .map(|note| (note.files.as_str(), note.what.as_str()));
    Section::of_files([summary].into_iter().chain(files))
}
