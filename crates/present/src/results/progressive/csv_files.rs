//! The load–displacement curve and the damage of every ply as CSV files.

use super::{ProgressiveView, mode_name};
use crate::results::failure::plain_name;
use crate::results::{File, FileNote};
use stickslip_report::csv::{self, number};

/// The files of a followed joint, named by `stem`, and what they hold.
pub(crate) fn files(view: &ProgressiveView<'_>, stem: &str) -> (Vec<File>, Vec<FileNote>) {
    let curve = format!("load-displacement-{stem}.csv");
    let mut files = vec![(curve.clone(), csv::texts(curve_rows(view)))];
    let mut notes = vec![FileNote::new(
        curve,
        "load, displacement, energies and failures, one row per increment",
    )];
    if !view.progressive.edge.is_empty() {
        let name = format!("edge-strains-{stem}.csv");
        files.push((name.clone(), csv::texts(strain_rows(view))));
        notes.push(FileNote::new(
            name,
            "strains at the hole's edge under the largest load, and those of the same joint without failure",
        ));
    }
    let failure = view.failure.failure;
    files.extend((0..failure.plies.len()).map(|group| {
        let ply = plain_name(&failure.ply_name(group)).replace(' ', "-");
        let rows = damage_rows(view, group);
        (format!("damage-{stem}-{ply}.csv"), csv::texts(rows))
    }));
    notes.push(FileNote::new(
        format!("damage-{stem}-*.csv"),
        "what failed in the plies of one direction: place, mode and load, in order, one file per direction",
    ));
    (files, notes)
}

fn curve_rows(view: &ProgressiveView<'_>) -> Vec<Vec<String>> {
    let (force, length) = (view.force_unit(), view.length_unit());
    let heading = csv::headings(&format!(
        "increment | step | part of step [-] | displacement [{length}] | load [{force}] | work [{force} {length}] | \
         dissipated and released [{force} {length}] | matrix failures | fibre failures | points that began to flow"
    ));
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
    let heading = csv::headings(
        "theta [deg] | radial strain [-] | circumferential strain [-] | linear radial strain [-] | linear circumferential strain [-]",
    );
    let rows = view.progressive.edge.iter().map(|edge| {
        let mut cells = vec![number(edge.angle.to_degrees())];
        cells.extend(edge.followed.into_iter().chain(edge.linear).map(number));
        cells
    });
    std::iter::once(heading).chain(rows).collect()
}

fn damage_rows(view: &ProgressiveView<'_>, group: usize) -> Vec<Vec<String>> {
    let (force, length) = (view.force_unit(), view.length_unit());
    let heading = csv::headings(&format!(
        "increment | load [{force}] | displacement [{length}] | layer | mode | x [{length}] | y [{length}] | theta [deg] | r [{length}] | cell"
    ));
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
