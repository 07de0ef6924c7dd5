//! The measurements as a table, and the day on which they were made.

use std::time::{SystemTime, UNIX_EPOCH};

use stickslip_laboratory::measure::Timing;

use super::Trouble;
use super::bench::{Measured, Sample};

const COLUMNS: [&str; 28] = [
    "problem",
    "element",
    "discretisation",
    "solver",
    "spacing",
    "spacing_unit",
    "outcome",
    "unknowns",
    "error_peak_pressure",
    "error_extent",
    "error_pressure_profile",
    "error_shear_profile",
    "error_hoop",
    "whole_s",
    "whole_lower_quartile_s",
    "whole_upper_quartile_s",
    "wall_s",
    "solve_s",
    "solve_lower_quartile_s",
    "solve_upper_quartile_s",
    "contact_s",
    "contact_lower_quartile_s",
    "contact_upper_quartile_s",
    "runs",
    "contact_solves",
    "pivots_or_sweeps",
    "factorisations",
    "operations",
];

/// Every sample as a table.
pub(super) fn csv(samples: &[Sample]) -> Result<Vec<u8>, Trouble> {
    let trouble = |cause| Trouble::Csv {
        path: "work-precision.csv".into(),
        cause,
    };
    let mut writer = csv::WriterBuilder::new()
        .flexible(true)
        .from_writer(Vec::new());
    writer.write_record(COLUMNS).map_err(trouble)?;
    for sample in samples {
        writer.write_record(record(sample)).map_err(trouble)?;
    }
    writer
        .into_inner()
        .map_err(|cause| trouble(cause.into_error().into()))
}

fn record(sample: &Sample) -> Vec<String> {
    let mut cells = vec![sample.problem.name().to_owned()];
    cells.extend(sample.method.columns());
    cells.push(sample.spacing.to_string());
    cells.push(sample.problem.unit().to_owned());
    match &sample.outcome {
        Ok(measured) => {
            cells.push("solved".to_owned());
            cells.extend(numbers(measured));
        }
        Err(cause) => cells.push(cause.clone()),
    }
    cells.resize(COLUMNS.len(), String::new());
    cells
}

fn numbers(measured: &Measured) -> Vec<String> {
    let errors = &measured.errors;
    let mut cells = vec![measured.unknowns.to_string()];
    let all = [
        Some(errors.peak_pressure),
        Some(errors.contact_extent),
        Some(errors.pressure_profile),
        errors.shear,
        errors.hoop,
    ];
    cells.extend(all.map(|error| error.map_or_else(String::new, |error| format!("{error:.4e}"))));
    let seconds = |time: f64| format!("{time:.4e}");
    let timing = |t: Timing| [t.median, t.lower, t.upper].map(seconds);
    cells.extend(timing(measured.whole));
    cells.push(seconds(measured.wall.median));
    cells.extend(timing(measured.solve));
    cells.extend(timing(measured.contact));
    let work = &measured.work;
    cells.push(measured.whole.runs.to_string());
    cells.push(work.solves.to_string());
    cells.push((work.pivots + work.sweeps).to_string());
    cells.push(work.factorisations.to_string());
    cells.push(work.operations.to_string());
    cells
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

/// Year, month and day of the day `days` after 1970-01-01, in the Gregorian calendar.
fn date(mut days: u64) -> [u64; 3] {
    let leap = |year: u64| {
        (year.is_multiple_of(4) && !year.is_multiple_of(100)) || year.is_multiple_of(400)
    };
    let mut year = 1970;
    while days >= 365 + u64::from(leap(year)) {
        days -= 365 + u64::from(leap(year));
        year += 1;
    }
    let lengths = [
        31,
        28 + u64::from(leap(year)),
        31,
        30,
        31,
        30,
        31,
        31,
        30,
        31,
        30,
        31,
    ];
    let mut month = 1;
    for length in lengths {
        if days < length {
            break;
        }
        days -= length;
        month += 1;
    }
    [year, month, days + 1]
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
