//! The part of the page that sets other programs beside this one.

use std::fmt::Write as _;

use super::{none, number, percent, seconds};
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
fn range(mut values: Vec<f64>) -> Option<[f64; 3]> {
    values.sort_by(f64::total_cmp);
    Some([
        *values.first()?,
        *values.get(values.len() / 2)?,
        *values.last()?,
    ])
}

pub(super) fn section(page: &mut String, charts: &Charts) {
    let _ = write!(
        page,
        "## Beside other programs\n\n![Error of the peak pressure over time](summary.png)\n\n{}\n\n\
         | μ | error | fastest other program | its time | stickslip | factor | factor in factorisations | factor of Q8, the default |\n\
         | ---: | ---: | --- | ---: | --- | ---: | ---: | ---: |\n",
        sentence(charts)
    );
    for duel in duels(charts, &DUELS) {
        let _ = writeln!(page, "{}", duel_row(&duel));
    }
    let mut machines: Vec<String> = Vec::new();
    for run in &charts.peers {
        let machine = format!("{} on {}", run.measured, run.machine);
        if !machines.contains(&machine) {
            machines.push(machine);
        }
    }
    let _ = write!(
        page,
        "\nHow the factor is computed: each side gets the time of the whole history at which its curve reaches the error, \
         interpolated between two meshes along straight lines of the chart, and the factor is their ratio. Errors are settled for \
         both sides: a mesh counts with the largest error of itself and all finer meshes of its curve, so a number that is right \
         by chance on one mesh, or a method that goes wrong on a finer one, gains nothing. Each side has the choice of its elements \
         and contact discretisations; stickslip has its default solver. The error is that of the peak pressure \
         at 1240 lb while loading.\n\n\
         Times of other programs are the smaller one of wall and processor time of the whole history, one thread, without \
         start-up of Python, as measured ({}); those of stickslip are medians of its processor time here. The last column takes the \
         machines out: either time is divided by that of one sparse Cholesky factorisation of about 41 000 unknowns on its own \
         machine ({} unknowns, {} here). Each contact method is held against the peak pressure of the kinematics that is nearer \
         to its finest run (undeformed or deformed contact geometry, 0.3 % apart), and no error counts as smaller than that reference is \
         known: 0.006 to 0.008 % undeformed, 0.05 to 0.06 % deformed, where curves end on a level line.\n\n\
         ![The same in factorisations](peers-factorisations.png)\n\n",
        machines.join("; "),
        charts.yardstick.unknowns,
        seconds(charts.yardstick.seconds),
    );
    let wrong: Vec<String> = charts
        .peers
        .iter()
        .filter_map(|run| {
            let error = run.error().filter(|&error| error >= WRONG)?;
            Some(format!(
                "{} (μ = {}, {}°, {:.0} %)",
                run.label(),
                run.mu,
                run.spacing_deg,
                100.0 * error
            ))
        })
        .collect();
    if !wrong.is_empty() {
        let _ = write!(
            page,
            "Runs that report convergence with an error of more than 20 % are off the chart, and not held against the coarser runs of \
             their curve: {}.\n\n",
            wrong.join("; ")
        );
    }
}

fn duel_row(duel: &Duel) -> String {
    format!(
        "| {} | {} | {} | {} | {}, {} | {} | {} | {} |",
        duel.mu,
        percent(duel.error),
        duel.label,
        seconds(duel.other),
        duel.discretisation,
        seconds(duel.own),
        number(duel.factor),
        number(duel.scaled),
        duel.default.map_or_else(none, number),
    )
}
