//! The measurements as a table, and the day on which they were made.

use std::time::{SystemTime, UNIX_EPOCH};

use super::bench::{Measured, Quantity, Sample};
use crate::publish::TaskError;

/// Columns that every sample has.
const COLUMNS: [&str; 7] = [
    "problem",
    "element",
    "discretisation",
    "solver",
    "spacing",
    "spacing_unit",
    "outcome",
];

/// A number of a solved sample as a cell.
type Written = fn(&Measured) -> String;

/// Columns of what a solved sample has.
const NUMBERS: [(&str, Written); 21] = [
    ("unknowns", |own| own.unknowns.to_string()),
    ("error_peak_pressure", |own| {
        error(Quantity::PeakPressure, own)
    }),
    ("error_extent", |own| error(Quantity::Extent, own)),
    ("error_pressure_profile", |own| {
        error(Quantity::Pressure, own)
    }),
    ("error_shear_profile", |own| error(Quantity::Shear, own)),
    ("error_hoop", |own| error(Quantity::Hoop, own)),
    ("whole_s", |own| short(own.whole.median)),
    ("whole_lower_quartile_s", |own| short(own.whole.lower)),
    ("whole_upper_quartile_s", |own| short(own.whole.upper)),
    ("wall_s", |own| short(own.wall.median)),
    ("solve_s", |own| short(own.solve.median)),
    ("solve_lower_quartile_s", |own| short(own.solve.lower)),
    ("solve_upper_quartile_s", |own| short(own.solve.upper)),
    ("contact_s", |own| short(own.contact.median)),
    ("contact_lower_quartile_s", |own| short(own.contact.lower)),
    ("contact_upper_quartile_s", |own| short(own.contact.upper)),
    ("runs", |own| own.whole.runs.to_string()),
    ("contact_solves", |own| own.work.solves.to_string()),
    ("pivots_or_sweeps", |own| {
        (own.work.pivots + own.work.sweeps).to_string()
    }),
    ("factorisations", |own| own.work.factorisations.to_string()),
    ("operations", |own| own.work.operations.to_string()),
];

fn short(number: f64) -> String {
    format!("{number:.4e}")
}

fn error(quantity: Quantity, measured: &Measured) -> String {
    quantity
        .of(&measured.errors)
        .map_or_else(String::new, short)
}

/// Every sample as a table.
pub(super) fn csv(samples: &[Sample]) -> Result<Vec<u8>, TaskError> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    let numbers = NUMBERS.iter().map(|(name, _)| *name);
    writer.write_record(COLUMNS.into_iter().chain(numbers))?;
    for sample in samples {
        let mut cells = vec![sample.problem.name().to_owned()];
        cells.extend(sample.method.columns());
        cells.extend([sample.spacing.to_string(), sample.problem.unit().to_owned()]);
        match &sample.outcome {
            Ok(measured) => {
                cells.push("solved".to_owned());
                cells.extend(NUMBERS.iter().map(|(_, number)| number(measured)));
            }
            Err(cause) => cells.push(cause.clone()),
        }
        cells.resize(COLUMNS.len() + NUMBERS.len(), String::new());
        writer.write_record(cells)?;
    }
    Ok(writer.into_inner()?)
}

/// The date in the form 2026-11-21 (UTC).
pub(super) fn today() -> String {
    let seconds = SystemTime::now()
        .duration_since(UNIX_EPOCH)
        .map_or(0, |time| time.as_secs());
    let [year, month, day] = date(seconds / 86_400);
    format!("{year}-{month:02}-{day:02}")
}

/// Processor and system, as far as they are known.
pub(super) fn machine() -> String {
    let system = format!("{} {}", std::env::consts::OS, std::env::consts::ARCH);
    let processor = std::fs::read_to_string("/proc/cpuinfo")
        .ok()
        .and_then(|text| {
            let line = text.lines().find(|line| line.starts_with("model name"))?;
            Some(line.split(':').nth(1)?.trim().to_owned())
        });
    processor.map_or(system.clone(), |name| format!("{name}, {system}"))
}

/// Year, month and day of the day `days` after 1970-01-01, in the Gregorian calendar: years begin in March, so that leap days are
/// their last, and 153 days are five months.
fn date(days: u64) -> [u64; 3] {
    const FOUR_CENTURIES: u64 = 146_097;
    // Days since 0000-03-01.
    let days = days + 719_468;
    let (era, day) = (days / FOUR_CENTURIES, days % FOUR_CENTURIES);
    let year = (day - day / 1460 + day / 36_524 - day / 146_096) / 365;
    let day = day - (365 * year + year / 4 - year / 100);
    let month = (5 * day + 2) / 153;
    let january = u64::from(month >= 10);
    [
        400 * era + year + january,
        month + 3 - 12 * january,
        day - (153 * month + 2) / 5 + 1,
    ]
}

/// A time with two digits, in s or ms.
pub(super) fn seconds(value: f64) -> String {
    if value >= 1.0 {
        format!("{value:.1} s")
    } else if value >= 9.95e-3 {
        format!("{:.0} ms", 1e3 * value)
    } else {
        format!("{:.1} ms", 1e3 * value)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn days_are_counted_through_leap_years() {
        assert_eq!(date(0), [1970, 1, 1]);
        assert_eq!(date(11_016), [2000, 2, 29]);
        assert_eq!(date(20_778), [2026, 11, 21]);
    }
}
