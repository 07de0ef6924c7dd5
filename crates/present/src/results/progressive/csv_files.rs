//! The load–displacement curve and the damage of every ply as CSV files.

use super::{ProgressiveView, mode_name};
use crate::results::cells::{File, number, write};
use crate::results::failure::plain_name;
use crate::results::{FileNote, OutputError};

/// The files of a followed joint, named by `stem`, and what they hold.
pub(crate) fn files(
    view: &ProgressiveView<'_>,
    stem: &str,
) -> Result<(Vec<File>, Vec<FileNote>), OutputError> {
    let curve = format!("load-displacement-{stem}.csv");
    let mut files = vec![(curve.clone(), write(&curve, curve_rows(view))?)];
    let mut notes = vec![FileNote::new(
        curve,
        "load, displacement, energies and failures, one row per increment",
    )];
    if !view.progressive.edge.is_empty() {
        let name = format!("edge-strains-{stem}.csv");
        files.push((name.clone(), write(&name, strain_rows(view))?));
        notes.push(FileNote::new(
            name,
            "strains at the hole's edge under the largest load, and those of the same joint without failure",
        ));
    }
    for group in 0..view.failure.failure.plies.len() {
        let ply = plain_name(&view.failure.failure.ply_name(group)).replace(' ', "-");
        let name = format!("damage-{stem}-{ply}.csv");
        files.push((name.clone(), write(&name, damage_rows(view, group))?));
    }
    notes.push(FileNote::new(
        format!("damage-{stem}-*.csv"),
        "what failed in the plies of one direction: place, mode and load, in order, one file per direction",
    ));
    Ok((files, notes))
}

fn curve_rows(view: &ProgressiveView<'_>) -> Vec<Vec<String>> {
    let (force, length) = (view.force_unit(), view.length_unit());
    let heading = vec![
        "increment".to_owned(),
        "step".to_owned(),
        "part of step [-]".to_owned(),
        format!("displacement [{length}]"),
        format!("load [{force}]"),
        format!("work [{force} {length}]"),
        format!("dissipated and released [{force} {length}]"),
        "matrix failures".to_owned(),
        "fibre failures".to_owned(),
        "points that began to flow".to_owned(),
    ];
    let own = view.progressive;
    let mut counts = vec![[0_usize; 3]; own.curve.len()];
    for loss in &own.losses {
        let kind = match loss.mode {
            Some(mode) if mode.is_fibre() => 1,
            Some(_) => 0,
            None => 2,
        };
        counts[loss.increment][kind] += 1;
    }
    let energy = |value: f64| view.force(view.failure.length(value));
    let rows = own.curve.iter().zip(counts).enumerate();
    let rows = rows.map(|(index, (point, counts))| {
        let mut cells = vec![
            (index + 1).to_string(),
            (point.step + 1).to_string(),
            number(point.reached),
            number(view.failure.length(point.displacement)),
            number(view.force(point.load)),
            number(energy(point.work)),
            number(energy(point.dissipated)),
        ];
        cells.extend(counts.map(|count| count.to_string()));
        cells
    });
    std::iter::once(heading).chain(rows).collect()
}

fn strain_rows(view: &ProgressiveView<'_>) -> Vec<Vec<String>> {
    let heading = [
        "theta [deg]",
        "radial strain [-]",
        "circumferential strain [-]",
        "linear radial strain [-]",
        "linear circumferential strain [-]",
    ];
    let heading = heading.map(str::to_owned).to_vec();
    let rows = view.progressive.edge.iter().map(|edge| {
        let mut cells = vec![number(edge.angle.to_degrees())];
        cells.extend(edge.followed.into_iter().chain(edge.linear).map(number));
        cells
    });
    std::iter::once(heading).chain(rows).collect()
}

fn damage_rows(view: &ProgressiveView<'_>, group: usize) -> Vec<Vec<String>> {
    let (force, length) = (view.force_unit(), view.length_unit());
    let heading = vec![
        "increment".to_owned(),
        format!("load [{force}]"),
        format!("displacement [{length}]"),
        "layer".to_owned(),
        "mode".to_owned(),
        format!("x [{length}]"),
        format!("y [{length}]"),
        "theta [deg]".to_owned(),
        format!("r [{length}]"),
        "cell".to_owned(),
    ];
    let losses = view.progressive.losses.iter();
    let rows = losses.filter(|loss| loss.ply == group).map(|loss| {
        let mut cells = vec![
            (loss.increment + 1).to_string(),
            number(view.force(loss.load)),
            number(view.failure.length(loss.displacement)),
            (loss.layer + 1).to_string(),
            mode_name(loss),
        ];
        cells.extend(loss.position.map(|x| number(view.failure.length(x))));
        match view.polar(loss.position) {
            Some(place) => cells.extend(place.map(number)),
            None => cells.extend([String::new(), String::new()]),
        }
        cells.push((loss.cell + 1).to_string());
        cells
    });
    std::iter::once(heading).chain(rows).collect()
}
