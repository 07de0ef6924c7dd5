//! Studies whose cases, tables, figures and checks are described by a file, `studies/NAME/study.toml`.
//!
//! ```text
//! [[cases]] ──► records ──► code of the study ──► rows ──► [[tables]]   docs/NAME/*.csv
//!                           (numbers only)                [[figures]]  docs/NAME/*.svg, *.png
//!                                                         [[quotes]]   findings on stdout; a full run fails if docs/NAME/README.md
//!                                                                      has other numbers
//! ```
//!
//! The page is written by hand.

pub(crate) mod figure;
mod map;
pub(crate) mod quote;
pub(crate) mod record;
pub(crate) mod table;

use std::path::{Path, PathBuf};

use serde::Deserialize;
use toml::{Table, Value};

use crate::publish::{Options, Published};
use figure::Figure;
use map::CategoryOf;
use quote::Quote;
use record::expanded;
use table::Tables;

pub(crate) use crate::publish::{TaskError, root, side_by_side};

/// A study: its folder below `studies` and `docs`, and its code.
#[derive(Debug)]
pub(crate) struct Study {
    pub(crate) name: &'static str,
    /// Computes rows of all tables from the cases.
    pub(crate) solve: fn(&[Table]) -> Result<Tables, TaskError>,
    /// Adds to rows what follows from the rows of their table.
    pub(crate) complete: fn(&mut Tables),
}

/// What a study's file says.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Description {
    /// Name of its folder.
    #[serde(skip)]
    name: String,
    /// Keys of all cases, and those that differ in quick plans.
    #[serde(default)]
    values: Table,
    #[serde(default)]
    quick: Table,
    #[serde(default)]
    cases: Vec<Value>,
    tables: Vec<Columns>,
    figures: Vec<Figure>,
    /// Categories of maps that list none.
    #[serde(default)]
    categories: Vec<CategoryOf>,
    quotes: Vec<Value>,
}

/// A table that is kept, as `NAME.csv`.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Columns {
    name: String,
    columns: Vec<String>,
}

/// Solves cases side by side; each row says in `table` where it belongs, as its case does.
pub(crate) fn solved_side_by_side(
    cases: &[Table],
    solve: impl Fn(&Table) -> Result<Vec<Table>, TaskError> + Sync,
) -> Result<Tables, TaskError> {
    let named = |case: &Table| {
        let name = case
            .get("name")
            .map_or_else(|| format!("{case:?}"), ToString::to_string);
        solve(case).map_err(|error| TaskError::from(format!("{name}: {error}")))
    };
    let mut tables = Tables::new();
    for row in side_by_side(cases, named)?.into_iter().flatten() {
        let table = record::text(&row, "table")?.to_owned();
        tables.entry(table).or_default().push(row);
    }
    Ok(tables)
}

impl Study {
    /// Solves and writes: progress and what is wrong with the results on stderr, findings on stdout.
    pub(crate) fn main(&self, options: &Options) -> Result<bool, TaskError> {
        let description = Description::of(self.name)?;
        let cases = description.cases(options.quick)?;
        let mut tables = (self.solve)(&cases)?;
        (self.complete)(&mut tables);
        let folder = description.folder(options.output.as_deref(), !options.quick)?;
        let mut kept = description.write(&tables, folder)?;
        (self.complete)(&mut kept);
        for (name, rows) in tables {
            kept.entry(name).or_insert(rows);
        }
        let faults = description.judge(&kept, !options.quick)?;
        for fault in &faults {
            eprintln!("{fault}");
        }
        Ok(faults.is_empty())
    }
}

impl Description {
    /// The description in `studies/NAME`.
    pub(crate) fn of(name: &str) -> Result<Self, TaskError> {
        let path = root().join("studies").join(name).join("study.toml");
        let text = std::fs::read_to_string(&path)?;
        let read = toml::from_str(&text);
        let own: Self = read.map_err(|error| format!("{}: {error}", path.display()))?;
        Ok(Self {
            name: name.to_owned(),
            ..own
        })
    }

    /// The records of all cases.
    fn cases(&self, quick: bool) -> Result<Vec<Table>, TaskError> {
        let mut values = self.values.clone();
        if quick {
            values.extend(self.quick.clone());
        }
        expanded(&self.cases, &values, "cases", quick)
    }

    fn docs(&self) -> PathBuf {
        root().join("docs").join(&self.name)
    }

    /// The folder that was named, otherwise of a full run its own below `docs`.
    pub(crate) fn folder(
        &self,
        named: Option<&Path>,
        is_full: bool,
    ) -> Result<Option<Published>, TaskError> {
        Ok(Published::open(named, is_full.then(|| self.docs()))?)
    }

    /// Draws the figures and writes all; returns the tables that are kept, as their files have them.
    pub(crate) fn write(
        &self,
        tables: &Tables,
        mut folder: Option<Published>,
    ) -> Result<Tables, TaskError> {
        let mut kept = Tables::new();
        for Columns { name, columns } in &self.tables {
            let Some(rows) = tables.get(name) else {
                continue;
            };
            let csv = table::csv(rows, columns)?;
            if let Some(folder) = &mut folder {
                folder.write(&format!("{name}.csv"), &csv)?;
            }
            kept.insert(name.clone(), table::read(csv.as_slice())?);
        }
        for figure in &self.figures {
            if let Some((name, svg)) = figure.draw(tables, &self.categories)?
                && let Some(folder) = &mut folder
            {
                folder.write_picture(name, &svg)?;
            }
        }
        Ok(kept)
    }

    /// Prints the findings; returns those outside their bounds, and of a full run those that the page does not have.
    pub(crate) fn judge(&self, tables: &Tables, is_full: bool) -> Result<Vec<String>, TaskError> {
        let page = self.docs().join("README.md");
        let text = std::fs::read_to_string(&page)?;
        let words: Vec<&str> = text.split_whitespace().collect();
        let text = words.join(" ");
        let mut faults = Vec::new();
        for quote in expanded(&self.quotes, &Table::new(), "quotes", !is_full)? {
            let quote: Quote = quote.try_into()?;
            for sentence in quote.sentences(tables) {
                println!("{sentence}");
                faults.extend(quote.fault(&sentence));
                if is_full && !text.contains(&sentence) {
                    faults.push(format!("{} does not say: {sentence}", page.display()));
                }
            }
        }
        Ok(faults)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Numbers on a page are those of the tables beside it.
    #[test]
    fn pages_quote_their_tables() {
        let own = [
            crate::closed_loop::STUDY,
            crate::cosine::STUDY,
            crate::hybrid_noise::STUDY,
            crate::load_shares::STUDY,
            crate::mesh_dependence::STUDY,
            crate::shear_sign::STUDY,
        ];
        let own = own.map(|study| (study.name, study.complete));
        let atlas: (&str, fn(&mut Tables)) = ("stability", |_| {});
        for (name, complete) in own.into_iter().chain([atlas]) {
            let description = Description::of(name).expect("it reads");
            let mut tables = Tables::new();
            for Columns { name, .. } in &description.tables {
                let path = description.docs().join(format!("{name}.csv"));
                let file = std::fs::File::open(path).expect("it was kept");
                tables.insert(name.clone(), table::read(file).expect("it reads"));
            }
            complete(&mut tables);
            let faults = description.judge(&tables, true).expect("there is a page");
            assert_eq!(faults, [""; 0]);
        }
    }
}
