//! The table that the last full run of the task left in `docs/closed-loop`.

use std::path::Path;

use serde::Deserialize;

use super::Trouble;
use super::study::{Known, NEAR, Series};

/// Coefficients of all zones together, by seed.
pub(crate) struct Record {
    rows: Vec<Row>,
    truth: f64,
}

#[derive(Deserialize)]
struct Row {
    experiment: String,
    seed: u64,
    zone: String,
    mu: f64,
    low: Option<f64>,
    high: Option<f64>,
}

/// Digits of the table's numbers leave this.
const ROUNDED: f64 = 1e-5;

impl Record {
    /// What is recorded of an experiment.
    pub(crate) fn of(known: Known) -> Result<Self, Trouble> {
        let path =
            Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/closed-loop/closed-loop.csv");
        let mut rows = Vec::new();
        for row in csv::Reader::from_path(path)?.deserialize() {
            let row: Row = row?;
            if row.experiment == known.file && row.zone == "together" {
                rows.push(row);
            }
        }
        Ok(Self {
            rows,
            truth: known.mu,
        })
    }

    pub(crate) fn seeds(&self) -> usize {
        self.rows.len()
    }

    /// Seeds with an interval, of two ends, that holds the truth.
    pub(crate) fn covered(&self) -> usize {
        let ends = self.rows.iter().filter_map(|row| row.low.zip(row.high));
        ends.filter(|(low, high)| (*low..=*high).contains(&self.truth))
            .count()
    }

    /// The farthest coefficient from the truth.
    pub(crate) fn farthest(&self) -> f64 {
        let distances = self.rows.iter().map(|row| (row.mu - self.truth).abs());
        distances.fold(0.0, f64::max)
    }

    /// Seeds without friction that say at most a little of it.
    pub(crate) fn little(&self) -> usize {
        let highs = self.rows.iter().filter(|row| row.low.is_none());
        highs
            .filter(|row| row.high.is_some_and(|high| high <= NEAR))
            .count()
    }

    /// Seeds of `series` whose coefficient is the recorded one: then the record is one of this program.
    pub(crate) fn repeated_by(&self, series: &Series) -> usize {
        let is_same = |seed: u64, mu: f64| {
            let mut rows = self.rows.iter();
            rows.any(|row| row.seed == seed && (row.mu - mu).abs() <= ROUNDED)
        };
        let own = series.outcomes.iter();
        own.filter_map(|one| Some((one.seed, one.together.as_ref()?.mu)))
            .filter(|&(seed, mu)| is_same(seed, mu))
            .count()
    }
}
