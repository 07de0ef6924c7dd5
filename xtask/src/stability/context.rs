//! What a study is given, and what it finds.

use indicatif::ProgressBar;
use rayon::prelude::*;
use stickslip_fem_core::mesh::ElementKind;
use stickslip_report::svg::Svg;
use toml::Table;

use super::row::Row;
use crate::publish::TaskError;

/// Elements whose answers are compared.
pub(super) const ELEMENTS: [ElementKind; 5] = {
    use ElementKind::{Q4, Q8, Q9, T3, T6};
    [T3, Q4, T6, Q8, Q9]
};

/// How much is computed, and where progress is shown.
pub(super) struct Context {
    pub(super) quick: bool,
    pub(super) progress: ProgressBar,
}

impl Context {
    /// `quick` or `full`, whichever is asked for.
    pub(super) fn sized<T>(&self, quick: T, full: T) -> T {
        if self.quick { quick } else { full }
    }

    /// The rows of each of `values`, computed side by side, in their order.
    pub(super) fn rows_of<V: Sync>(
        &self,
        values: &[V],
        rows: impl Fn(&V) -> Result<Vec<Row>, TaskError> + Sync,
    ) -> Result<Vec<Row>, TaskError> {
        self.progress.inc_length(values.len() as u64);
        let parts = values
            .par_iter()
            .map(|value| {
                let rows = rows(value);
                self.progress.inc(1);
                rows
            })
            .collect::<Result<Vec<_>, _>>()?;
        Ok(parts.into_iter().flatten().collect())
    }
}

/// What a study found.
#[derive(Default)]
pub(super) struct Found {
    /// What methods did, whose outcomes are counted; what the table's name adds to the study's; and what is varied.
    pub(super) rows: Vec<Row>,
    pub(super) suffix: &'static str,
    pub(super) varied: &'static str,
    /// Further tables, by what their names add to the study's.
    pub(super) more: Vec<(&'static str, Vec<Table>)>,
    /// Pictures that no description can make, called as the study.
    pub(super) pictures: Vec<Svg>,
    /// What fails the task.
    pub(super) failures: Vec<String>,
}

impl Found {
    pub(super) fn of(varied: &'static str, rows: Vec<Row>) -> Self {
        Self {
            rows,
            varied,
            ..Self::default()
        }
    }

    /// With a further table of rows.
    pub(super) fn and(mut self, suffix: &'static str, varied: &str, rows: &[Row]) -> Self {
        let records = rows.iter().map(|row| row.record(varied));
        self.more.push((suffix, records.collect()));
        self
    }
}
