//! Tables of ply failure for the terminal and the page.

use stickslip_report::table::Table;

use super::{FailureView, criterion_name, how, layers, load_text};
use stickslip_laminate::failure::criterion_named;
use stickslip_results::LoadScale;
use stickslip_results::{FirstPly, JointFailure};
use stickslip_text::{decimals, significant};

/// What fails first, by every criterion and hypothesis.
pub(crate) fn first_ply(view: &FailureView<'_>) -> Table {
    let failure = view.failure;
    let load = view.load();
    let headings = format!(
        "hypothesis | criterion{} | reached | ply | mode | {} | σ_1 [{s}] | σ_2 [{s}] | τ_12 [{s}]",
        load_heading(&load, "–"),
        place_headings(view),
        s = view.stress_unit()
    );
    let caption = format!("Failure of '{}', lay-up {}", view.body(), failure.layup);
    let mut table = Table::headed(caption, &headings);
    for (hypothesis, firsts) in hypotheses(view) {
        for (criterion, first) in failure.criteria.iter().zip(firsts) {
            table.push(row(view, &hypothesis, criterion, first, load.is_load()));
        }
    }
    beside_supports(view).into_iter().fold(table, Table::note)
}

/// A number and its error, where one was estimated.
fn with_error(number: String, error: Option<f64>) -> String {
    match error {
        Some(error) => format!("{number} ± {}", significant(error, 2)),
        None => number,
    }
}

/// The heading of the load behind others, if steps have one; of a factor `dimensionless` is the unit.
fn load_heading(load: &LoadScale, dimensionless: &str) -> String {
    match load.unit.as_str() {
        _ if !load.is_load() => String::new(),
        "1" if dimensionless.is_empty() => " | load".to_owned(),
        "1" => format!(" | load [{dimensionless}]"),
        unit => format!(" | load [{unit}]"),
    }
}

fn place_headings(view: &FailureView<'_>) -> String {
    let [(first, first_unit), (second, second_unit)] = view.place_columns();
    format!("{first} [{first_unit}] | {second} [{second_unit}]")
}

/// Where no ply was asked, and which criteria would have found the first one there.
fn beside_supports(view: &FailureView<'_>) -> Vec<String> {
    let Some(beside) = &view.failure.beside_supports else {
        return Vec::new();
    };
    let distance = significant(view.length(beside.distance), 3);
    let unit = view.results.units.length.name;
    let mut notes = vec![format!(
        "First ply: not within {distance} {unit} of the ends of supports, where stresses grow without bound as the mesh is refined."
    )];
    let criteria = view.failure.criteria.iter().zip(&beside.sooner);
    notes.extend(criteria.filter_map(|(name, first)| {
        let first = first.as_ref()?;
        Some(format!(
            "By {} the {} ply would fail there before, at {} on this mesh.",
            criterion_name(name),
            view.failure.ply_name(first.at.ply),
            load_text(first),
        ))
    }));
    notes
}

/// Every hypothesis with what it says by each criterion.
pub(crate) fn hypotheses<'a>(view: &FailureView<'a>) -> Vec<(String, Vec<Option<&'a FirstPly>>)> {
    let failure = view.failure;
    let plain = |firsts: &'a [Option<FirstPly>]| firsts.iter().map(Option::as_ref).collect();
    let mut all = vec![("first ply".to_owned(), plain(&failure.first_ply))];
    if let Some(characteristic) = &failure.characteristic {
        let curve = characteristic.curve.iter();
        let joints = curve.map(|joint| joint.as_ref().map(|joint| &joint.first));
        all.push(("characteristic curve".to_owned(), joints.collect()));
        all.push((
            "point, net section".to_owned(),
            plain(&characteristic.net_section),
        ));
        all.push((
            "point, bearing".to_owned(),
            plain(&characteristic.bearing_point),
        ));
    }
    all
}

fn row(
    view: &FailureView<'_>,
    hypothesis: &str,
    criterion: &str,
    first: Option<&FirstPly>,
    with_load: bool,
) -> Vec<String> {
    let mut cells = vec![hypothesis.to_owned(), criterion_name(criterion)];
    let Some(first) = first else {
        cells.extend(with_load.then(|| "–".to_owned()));
        cells.push("not by any load".to_owned());
        return cells;
    };
    if with_load {
        let value = first.load.as_ref().map(|load| load.value);
        let value = value.map(|value| with_error(significant(value, 4), first.load_error));
        cells.push(value.unwrap_or_else(|| "–".into()));
    }
    let at = &first.at;
    let place = view.place(at);
    let first_place = match view.failure.centre {
        Some(_) => decimals(Some(place[0]), 1),
        None => significant(place[0], 3),
    };
    cells.extend([
        how(first),
        view.failure.ply_name(at.ply),
        at.mode.to_string(),
        first_place,
        significant(place[1], 3),
    ]);
    cells.extend(at.stress.map(|stress| significant(view.stress(stress), 3)));
    cells
}

/// Joint modes on the characteristic curve, one sentence per criterion.
pub(crate) fn joint_modes(view: &FailureView<'_>) -> Vec<String> {
    let Some(characteristic) = &view.failure.characteristic else {
        return Vec::new();
    };
    let sentence = |(criterion, joint): (&&str, &Option<JointFailure>)| {
        let joint = joint.as_ref()?;
        // A crack in the matrix of one ply is not the end of a joint.
        let end = joint.first.at.mode.is_fibre()
            || criterion_named(criterion).is_ok_and(|own| own.is_ultimate());
        let event = if end {
            "fails by"
        } else {
            "has its first crack in a ply, where it begins to fail by"
        };
        Some(format!(
            "{}: on the characteristic curve the joint '{}' {event} {} at {} (at {}°, in the {} ply by {}).",
            criterion_name(criterion),
            view.body(),
            joint.mode,
            load_text(&joint.first),
            decimals(Some(joint.angle.to_degrees()), 0),
            view.failure.ply_name(joint.first.at.ply),
            joint.first.at.mode,
        ))
    };
    let criteria = view.failure.criteria.iter();
    criteria
        .zip(&characteristic.curve)
        .filter_map(sentence)
        .collect()
}

/// The reserve factor of every load step by each criterion, with the weakest ply of the first.
pub(crate) fn steps(view: &FailureView<'_>) -> Table {
    let failure = view.failure;
    let load = view.load();
    let names = failure.criteria.iter();
    let factors = names.map(|name| format!(" | RF {} [–]", criterion_name(name)));
    let headings = format!(
        "step{}{} | ply | mode | {} | index [–]",
        load_heading(&load, ""),
        factors.collect::<String>(),
        place_headings(view)
    );
    let caption = format!("Reserve factors of '{}'", view.body());
    let mut table = Table::headed(caption, &headings);
    for (step, points) in failure.steps.iter().enumerate() {
        let mut cells = vec![(step + 1).to_string()];
        if load.is_load() {
            cells.push(significant(load.values[step], 5));
        }
        cells.extend(points.iter().map(|point| {
            let error = point.errors.and_then(|errors| errors.reserve_factor);
            with_error(significant(point.reserve_factor, 4), error)
        }));
        if let Some(point) = points.first() {
            let place = view.place(point).map(|value| significant(value, 3));
            cells.extend([failure.ply_name(point.ply), point.mode.to_string()]);
            cells.extend(place);
            cells.push(significant(point.index, 4));
        }
        table.push(cells);
    }
    let leading = failure.criteria.first().map_or(String::new(), |name| {
        format!(
            "Ply, mode, place and index are those of {}.",
            criterion_name(name)
        )
    });
    table.with_notes(include_str!("reserve.txt")).note(leading)
}

/// The plies of the laminate and what the cure leaves in them.
pub(crate) fn plies(view: &FailureView<'_>) -> Table {
    let stress = view.stress_unit();
    let headings = format!(
        "ply | material | layers | σ_1 of the cure [{stress}] | σ_2 of the cure [{stress}] | τ_12 of the cure [{stress}]"
    );
    let failure = view.failure;
    let caption = format!(
        "Plies of '{}', lay-up {}, {} K since they were free of stress",
        view.body(),
        failure.layup,
        significant(failure.cure, 4)
    );
    let mut table = Table::headed(caption, &headings);
    for group in &failure.plies {
        let mut cells = vec![group.direction(), group.ply.clone(), layers(&group.layers)];
        let residual = group.residual;
        cells.extend(residual.map(|value| significant(view.stress(value), 4)));
        table.push(cells);
    }
    table.note("Layers are counted from the bottom, from 1.")
}
