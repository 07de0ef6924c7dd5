//! Other programs beside this one.

use super::{Rows, none, number, percent, seconds};
use crate::chart::Charts;
use crate::chart::peers::WRONG;
use crate::chart::summary::{Duel, duels, single_duels};

/// Errors at which other programs are met.
const DUELS: [f64; 5] = [1e-2, 5e-3, 2e-3, 1e-3, 5e-4];

pub(super) fn sentence(charts: &Charts) -> String {
    let factors: Vec<f64> = duels(charts, &DUELS).iter().map(|d| d.factor).collect();
    let singles: Vec<f64> = single_duels(charts).iter().map(|d| d.factor).collect();
    let (Some([least, middle, most]), Some([lowest, median, highest])) =
        (range(factors.clone()), range(singles.clone()))
    else {
        return "No run of another program can be compared on these meshes.".to_owned();
    };
    let above = |factors: &[f64]| factors.iter().filter(|&&factor| factor >= 50.0).count();
    format!(
        "At equal error the fastest discretisation is {} to {} times faster than the fastest other program, {} in the median of {} pairs \
         of error and friction, at least 50 times in {}. At the error of each of {} single runs of other programs, lucky ones \
         included, it is {} to {} times faster, {} in the median, at least 50 times in {}.",
        number(least),
        number(most),
        number(middle),
        factors.len(),
        above(&factors),
        singles.len(),
        number(lowest),
        number(highest),
        number(median),
        above(&singles),
    )
}

/// Smallest, median and largest.
pub(super) fn range(mut values: Vec<f64>) -> Option<[f64; 3]> {
    values.sort_by(f64::total_cmp);
    Some([
        *values.first()?,
        *values.get(values.len() / 2)?,
        *values.last()?,
    ])
}

/// The duels at fixed errors.
pub(super) fn duel_rows(charts: &Charts) -> Rows {
    let row = |duel: &Duel| {
        vec![
            duel.mu.to_string(),
            percent(duel.error),
            duel.label.clone(),
            seconds(duel.other),
            format!("{}, {}", duel.discretisation, seconds(duel.own)),
            number(duel.factor),
            number(duel.scaled),
            duel.default.map_or_else(none, number),
        ]
    };
    duels(charts, &DUELS).iter().map(row).collect()
}

/// Days and machines of the other programs' runs.
pub(super) fn machines(charts: &Charts) -> String {
    let mut machines: Vec<String> = Vec::new();
    for run in &charts.peers {
        let machine = format!("{} on {}", run.measured, run.machine);
        if !machines.contains(&machine) {
            machines.push(machine);
        }
    }
    machines.join("; ")
}

/// Runs whose answer is off the chart.
pub(super) fn wrong(charts: &Charts) -> String {
    let wrong = charts.peers.iter().filter_map(|run| {
        let error = 100.0 * run.error().filter(|&error| error >= WRONG)?;
        Some(format!(
            "{} (μ = {}, {}°, {error:.0} %)",
            run.label(),
            run.mu,
            run.spacing_deg
        ))
    });
    wrong.collect::<Vec<_>>().join("; ")
}
