//! `report.html`: the answer first, then the load steps, the figures, and how it was done.

use stickslip_report::page::{Block, Figure, Page, Section};
use stickslip_report::table::{Column, Table};

use super::FileNote;
use super::display::EdgeView;
use super::display::shared;
use super::failure::{self, FailureView};
use super::figures::{Drawing, Group};
use super::findings;
use super::progressive::{self, ProgressiveView};
use super::tables::{self, Detail};
use super::zones::{contact_ranges, stick_ranges};
use stickslip_engine::LoadScale;
use stickslip_engine::results::{Results, StepResults};
use stickslip_text::{counted, decimals, short, significant};

/// The page of `results` with its figures; `failures` are figures that could not be drawn.
pub(super) fn page(
    results: &Results,
    drawings: Vec<Drawing>,
    failures: &[String],
    files: &[FileNote],
) -> Page {
    let mut page = Page::new(&results.title, subtitle(results));
    page.warnings = findings::sentences(results);
    page.warnings.extend_from_slice(failures);
    page.summary = summary(results);
    page.notes = notes(results);
    let (joint, mut drawings): (Vec<_>, Vec<_>) = drawings
        .into_iter()
        .partition(|drawing| drawing.group == Group::Joint);
    page.sections.extend(joint_section(results, joint));
    page.sections.push(steps_section(results));
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
    page.sections.push(
        Section::new("How it was modelled")
            .with(Block::Table(tables::choices(results)))
            .with(Block::Table(tables::bodies(results)))
            .with(Block::Table(tables::phases(results))),
    );
    page.sections
        .push(Section::new("Signs and names").with(Block::Table(tables::signs())));
    page.sections
        .push(Section::new("Files").with(Block::Table(file_table(files))));
    page.footer = format!(
        "stickslip {} · scene {}",
        env!("CARGO_PKG_VERSION"),
        results.scene_hash
    );
    page
}

fn subtitle(results: &Results) -> String {
    let count = results.steps.len();
    let steps = if count == 1 {
        "1 load step".to_owned()
    } else {
        format!("{count} load steps")
    };
    format!("{} · {steps}", results.source)
}

fn figure_section(title: &str, drawings: Vec<Drawing>) -> Section {
    let figures = drawings
        .into_iter()
        .map(|drawing| Block::Figure(Figure::new(drawing.picture, drawing.caption, drawing.name)));
    figures.fold(Section::new(title), Section::with)
}

/// Contacts whose numbers are summed up.
const SUMMED_UP: usize = 4;

/// The most important numbers, at the largest load.
fn summary(results: &Results) -> Vec<(String, String)> {
    let mut rows = Vec::new();
    let mut add = |name: &str, value: String| rows.push((name.to_owned(), value));
    let load = LoadScale::of(results);
    let Some(step) = load.peak_step() else {
        return rows;
    };
    for joint in FailureView::all(results)
        .into_iter()
        .filter_map(ProgressiveView::of)
    {
        let (name, value) = progressive::tables::headline(&joint);
        add(name, value);
    }
    let largest = |load: &LoadScale, step| format!("{}, {}", load.name, load.step_text(step));
    let one_load = tables::has_one_load(results);
    if one_load {
        add("Largest load", largest(&load, step));
    }
    let mut edges = EdgeView::all(results);
    edges.retain(|edge| edge.geometry.contact);
    let several = edges.len() > 1;
    if !several {
        edges = EdgeView::main(results).into_iter().collect();
    }
    for edge in edges.iter().take(SUMMED_UP) {
        let load = edge.load();
        let Some(step) = load.peak_step() else {
            continue;
        };
        let mut own = edge_summary(edge, step);
        if !one_load {
            own.insert(0, ("Largest load".to_owned(), largest(&load, step)));
        }
        for (name, value) in own {
            if several {
                add(&format!("'{}': {name}", edge.geometry.name), value);
            } else {
                add(&name, value);
            }
        }
    }
    if let Some(further @ 1..) = edges.len().checked_sub(SUMMED_UP) {
        let contacts = counted(further, "contact");
        add("Further", format!("{contacts}, in the tables below"));
    }
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

fn edge_summary(edge: &EdgeView<'_>, step: usize) -> Vec<(String, String)> {
    let mut rows = Vec::new();
    let mut add = |name: String, value: String| rows.push((name, value));
    let record = edge.step(step);
    let unit = edge.units().stress.name;
    let stress = |value: f64| {
        let absolute = format!("{} {unit}", significant(edge.stress(value), 5));
        match edge.bearing(step).filter(|_| edge.geometry.contact) {
            Some(bearing) => format!("{absolute} = {} σ_b", decimals(Some(value / bearing), 3)),
            None => absolute,
        }
    };
    if let Some(bearing) = edge.bearing(step).filter(|_| edge.geometry.contact) {
        add(
            "Bearing stress σ_b".into(),
            format!("{} {unit}", significant(edge.stress(bearing), 5)),
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
            format!("{} at {}", stress(pressure), edge.at(place)),
        );
    }
    if let Some((hoop, place)) = record.peak_hoop {
        let name = format!("Largest {}", edge.stress_symbols()[1]);
        let cusp = record.peak_hoop_uncertainty;
        let margin = cusp.map_or(String::new(), |value| {
            format!(" (± {} {unit})", significant(edge.stress(value), 2))
        });
        add(
            name,
            format!("{}{margin} at {}", stress(hoop), edge.at(place)),
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

fn steps_section(results: &Results) -> Section {
    let mut section = Section::new("Load steps");
    let one_load = tables::has_one_load(results);
    for edge in EdgeView::all(results) {
        let table = if edge.geometry.contact {
            let table = tables::contact_table(&edge, one_load, Detail::Full);
            table
                .note(extents_note(&edge))
                .note("Solves are interface solves of all increments; balance is the unbalanced force over the load.")
        } else {
            tables::stress_table(&edge, one_load)
        };
        section = section.with(Block::Table(table));
    }
    if results.steps.len() > 1 {
        let text = single_steps(results).map(Block::Text);
        section = text.into_iter().fold(section, Section::with);
    }
    section
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

/// What the columns of extents mean.
fn extents_note(edge: &EdgeView<'_>) -> String {
    let extents = if tables::lies_evenly(edge) {
        "Contact ± and stick ± are half-extents"
    } else {
        "Contact goes from the first to the last place that touches, gaps between included, stick over all zones that stick"
    };
    let slip = match edge.slip_names() {
        ["slip +", _] => "slip± are the lengths of the zones that slip along ±e_t",
        _ => {
            "slip away and slip towards are the lengths of the zones that slip away from the bearing point of the step and towards it"
        }
    };
    let angles = match (edge.is_circle(), edge.geometry.frame.bearing) {
        (true, Some(bearing)) => format!(
            " Angles φ are counted counter-clockwise from the bearing point, which lies at θ = {} from +x.",
            edge.extent(bearing)
        ),
        (true, None) => {
            " Angles θ are counted counter-clockwise from +x: there is no bearing point.".into()
        }
        (false, _) => String::new(),
    };
    format!("{extents}; {slip}.{angles}")
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
        section = section.with(Block::Table(failure::tables::first_ply(view)));
        for sentence in failure::tables::joint_modes(view) {
            section = section.with(Block::Text(sentence));
        }
        section = section
            .with(Block::Table(failure::tables::steps(view)))
            .with(Block::Table(failure::tables::plies(view)));
    }
    (!views.is_empty()).then_some(section)
}

fn file_table(files: &[FileNote]) -> Table {
    let mut table = Table::new("", vec![Column::new("file", ""), Column::new("holds", "")]);
    table.push([
        "summary.json",
        "all quantities of the load steps for other programs",
    ]);
    for note in files {
        table.push([&note.files, &note.what]);
    }
    table
}
