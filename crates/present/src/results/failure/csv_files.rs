//! Ply stresses, reserve factors, first-ply failure and envelopes as CSV files.

use super::tables::hypotheses;
use super::{FailureView, plain_name, plane_symbols};
use crate::results::display::EdgeView;
use crate::results::names::{FileNames, step_name};
use crate::results::progressive::{self, ProgressiveView};
use crate::results::{File, FileNote};
use stickslip_report::csv::{self, number};
use stickslip_results::LoadScale;
use stickslip_results::{EdgePlies, FailurePoint, PointErrors, Results};

/// All files about failure, and what they hold.
pub(crate) fn files(results: &Results) -> (Vec<File>, Vec<FileNote>) {
    let mut names = FileNames::default();
    let (mut files, mut notes) = (Vec::new(), Vec::new());
    for view in FailureView::all(results) {
        let mut add = |name: String, what: &str, rows: Vec<Vec<String>>| {
            files.push((name.clone(), csv::texts(rows)));
            notes.push(FileNote::new(name, what));
        };
        let stem = names.unique(view.body());
        add(
            format!("failure-{stem}.csv"),
            "reserve factor, ply, mode and place of the weakest point, per load step and criterion",
            step_rows(&view),
        );
        add(
            format!("first-ply-{stem}.csv"),
            "load, ply, mode and place of the first failure, per hypothesis and criterion",
            first_rows(&view),
        );
        if view.failure.characteristic.is_some() {
            add(
                format!("characteristic-{stem}.csv"),
                "largest index of the first criterion along the characteristic curve, per load step",
                curve_rows(&view),
            );
        }
        if !view.failure.envelopes.is_empty() {
            add(
                format!("envelopes-{stem}.csv"),
                "mean stresses at which the first or last ply of the laminate fails",
                envelope_rows(&view),
            );
        }
        if let Some(joint) = ProgressiveView::of(view) {
            let (own, about) = progressive::csv_files::files(&joint, &stem);
            files.extend(own);
            notes.extend(about);
        }
        for edge in &view.failure.edges {
            let shown = EdgeView::all(results)[edge.edge];
            let name = names.unique(&format!("plies-{}", shown.geometry.name));
            files.extend((0..edge.steps.len()).map(|step| {
                let rows = ply_rows(&view, &shown, edge, step);
                (
                    format!("{}.csv", step_name(&name, step, results)),
                    csv::texts(rows),
                )
            }));
            notes.push(FileNote::new(
                format!("{name}-step-*.csv"),
                "ply stresses in material axes and failure indices along the whole edge, one file per load step",
            ));
        }
    }
    (files, notes)
}

/// Headings of a point's cells.
fn point_headings(view: &FailureView<'_>) -> String {
    format!(
        "ply | angle [deg] | layers | mode | x [{0}] | y [{0}] | theta [deg] | r [{0}] | sigma_1 [{1}] | sigma_2 [{1}] | tau_12 [{1}]",
        view.results.units.length.name,
        view.stress_unit()
    )
}

fn point_cells(view: &FailureView<'_>, point: &FailurePoint) -> Vec<String> {
    let group = &view.failure.plies[point.ply];
    let layers: Vec<String> = group.layers.iter().map(|k| (k + 1).to_string()).collect();
    let mut cells = vec![
        group.ply.clone(),
        number(group.angle),
        layers.join(" "),
        point.mode.name().to_owned(),
    ];
    cells.extend(point.position.map(|x| number(view.length(x))));
    match view.failure.polar_from_x(point.position) {
        Some((angle, radius)) => {
            cells.extend([number(angle.to_degrees()), number(view.length(radius))]);
        }
        None => cells.extend([String::new(), String::new()]),
    }
    cells.extend(point.stress.map(|stress| number(view.stress(stress))));
    cells
}

fn load_heading(load: &LoadScale) -> Option<String> {
    load.is_load()
        .then(|| format!("load {} [{}]", load.name, load.unit))
}

fn step_rows(view: &FailureView<'_>) -> Vec<Vec<String>> {
    let load = view.load();
    let mut headings = csv::headings(&format!(
        "step | criterion | reserve_factor [-] | margin [-] | index [-] | {}",
        point_headings(view)
    ));
    headings.splice(1..1, load_heading(&load));
    let states_errors = view.results.ladder.is_some();
    if states_errors {
        let length = view.results.units.length.name;
        headings.extend(csv::headings(&format!(
            "reserve_factor_error [-] | index_error [-] | place_error [{length}]"
        )));
    }
    let mut rows = vec![headings];
    for (step, points) in view.failure.steps.iter().enumerate() {
        for point in points {
            let mut cells = vec![(step + 1).to_string()];
            cells.extend(load.is_load().then(|| number(load.values[step])));
            cells.push(point.criterion.to_owned());
            cells.extend([
                number(point.reserve_factor),
                number(point.reserve_factor - 1.0),
                number(point.index),
            ]);
            cells.extend(point_cells(view, point));
            if states_errors {
                let error = |of: fn(&PointErrors) -> Option<f64>| {
                    let error = point.errors.as_ref().and_then(of);
                    error.map_or(String::new(), number)
                };
                let place = point.errors.map(|errors| view.length(errors.place));
                cells.extend([
                    error(|errors| errors.reserve_factor),
                    error(|errors| errors.index),
                    place.map_or(String::new(), number),
                ]);
            }
            rows.push(cells);
        }
    }
    rows
}

fn first_rows(view: &FailureView<'_>) -> Vec<Vec<String>> {
    let load = view.load();
    let mut headings = csv::headings(&format!(
        "hypothesis | criterion | reached | step | factor [-] | {} | joint_mode",
        point_headings(view)
    ));
    headings.splice(2..2, load_heading(&load));
    let states_errors = view.results.ladder.is_some();
    if states_errors {
        let unit = if load.is_load() { &*load.unit } else { "-" };
        let length = view.results.units.length.name;
        let errors = format!("load_error [{unit}] | place_error [{length}]");
        headings.extend(csv::headings(&errors));
    }
    let width = headings.len();
    let mut rows = vec![headings];
    let joints = view.failure.characteristic.as_ref();
    for (hypothesis, firsts) in hypotheses(view) {
        for (k, first) in firsts.into_iter().enumerate() {
            let criterion = view.failure.criteria[k];
            let mut cells = vec![hypothesis.clone(), criterion.to_owned()];
            if let Some(first) = first {
                let value = first.load.as_ref().map(|load| load.value);
                cells.extend(load.is_load().then(|| value.map_or(String::new(), number)));
                cells.extend([
                    if first.reached { "yes" } else { "no" }.to_owned(),
                    (first.step + 1).to_string(),
                    number(first.factor),
                ]);
                cells.extend(point_cells(view, &first.at));
                let joint = joints.and_then(|joints| joints.curve[k].as_ref());
                let mode = joint.filter(|joint| std::ptr::eq(&raw const joint.first, first));
                cells.push(mode.map_or(String::new(), |joint| joint.mode.name().to_owned()));
                if states_errors {
                    let place = first.at.errors.map(|errors| view.length(errors.place));
                    let errors = [first.load_error, place];
                    cells.extend(errors.map(|error| error.map_or(String::new(), number)));
                }
            }
            cells.resize(width, String::new());
            rows.push(cells);
        }
    }
    rows
}

fn curve_rows(view: &FailureView<'_>) -> Vec<Vec<String>> {
    let Some(characteristic) = &view.failure.characteristic else {
        return Vec::new();
    };
    let length = view.results.units.length.name;
    let mut heading = csv::headings(&format!("theta [deg] | x [{length}] | y [{length}]"));
    heading.extend((1..=characteristic.index.len()).map(|step| format!("index step {step} [-]")));
    let rows = characteristic.places.iter().enumerate().map(|(k, place)| {
        let polar = view.failure.polar_from_x(*place);
        let mut cells = vec![polar.map_or(String::new(), |(theta, _)| number(theta.to_degrees()))];
        cells.extend(place.map(|x| number(view.length(x))));
        cells.extend(characteristic.index.iter().map(|step| number(step[k])));
        cells
    });
    std::iter::once(heading).chain(rows).collect()
}

fn envelope_rows(view: &FailureView<'_>) -> Vec<Vec<String>> {
    let unit = view.stress_unit();
    let headings = format!(
        "plane | bound | criterion | sigma_x [{unit}] | sigma_y [{unit}] | tau_xy [{unit}] | ply | angle [deg] | mode"
    );
    let mut rows = vec![csv::headings(&headings)];
    for envelope in &view.failure.envelopes {
        let bound = if envelope.last_ply {
            "last ply"
        } else {
            "first ply"
        };
        for point in &envelope.points {
            let group = &view.failure.plies[point.ply];
            let mut cells = vec![
                plane_symbols(envelope.plane).join(" "),
                bound.to_owned(),
                envelope.criterion.to_owned(),
            ];
            cells.extend(point.stress.map(|stress| number(view.stress(stress))));
            cells.extend([
                group.ply.clone(),
                number(group.angle),
                point.mode.name().to_owned(),
            ]);
            rows.push(cells);
        }
    }
    rows
}

/// Columns `sigma_1 60 [psi]` … and `index max_stress 60 [-]` for every ply.
fn ply_rows(
    view: &FailureView<'_>,
    shown: &EdgeView<'_>,
    edge: &EdgePlies,
    step: usize,
) -> Vec<Vec<String>> {
    let unit = view.stress_unit();
    let place = match shown.place_symbol() {
        "φ" | "θ" => "theta",
        symbol => symbol,
    };
    let mut heading = vec![format!("{place} [{}]", shown.place_unit())];
    for group in 0..view.failure.plies.len() {
        let name = plain_name(&view.failure.ply_name(group));
        let stresses = ["sigma_1", "sigma_2", "tau_12"];
        heading.extend(stresses.map(|symbol| format!("{symbol} {name} [{unit}]")));
        let criteria = view.failure.criteria.iter();
        heading.extend(criteria.map(|criterion| format!("index {criterion} {name} [-]")));
    }
    let groups = &edge.steps[step];
    let row = |(k, &at): (usize, &f64)| {
        let mut cells = vec![number(shown.length(at))];
        for group in groups {
            cells.extend(group[k].stress.map(|stress| number(view.stress(stress))));
            cells.extend(group[k].index.iter().map(|&index| number(index)));
        }
        cells
    };
    let rows = edge.parameter.iter().enumerate().map(row);
    std::iter::once(heading).chain(rows).collect()
}
