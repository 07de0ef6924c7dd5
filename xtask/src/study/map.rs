//! Maps of outcomes from a description and a table: a cell for each row and column, in groups.

use serde::Deserialize;
use stickslip_report::map::{Category, Group, OutcomeMap};
use stickslip_report::svg::Svg;
use toml::Table;

use super::TaskError;
use super::quote::filled;
use super::record::{color, matches, number, text};
use super::table::Tables;

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Map {
    pub(super) name: String,
    title: String,
    subtitle: String,
    x: String,
    width: f64,
    table: String,
    /// Keys of a cell's row, column, column label and category.
    row: String,
    column: String,
    column_label: String,
    cell: String,
    /// Groups of rows; without any each value of the key `group_by` has its own.
    #[serde(default)]
    groups: Vec<GroupOf>,
    #[serde(default)]
    group_by: String,
    #[serde(default)]
    categories: Vec<CategoryOf>,
    /// A category; rows of nothing else are left out.
    #[serde(default)]
    hidden: String,
    divider: Option<Divider>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct GroupOf {
    label: String,
    #[serde(rename = "where")]
    wanted: Table,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct CategoryOf {
    is: String,
    label: String,
    mark: String,
    color: String,
}

/// A line before the first column of a group with a row that has these values and whose column reaches the number `reaches`.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Divider {
    label: String,
    #[serde(default, rename = "where")]
    wanted: Table,
    reaches: Option<String>,
}

impl Map {
    /// The drawing; `None` without data. A map without categories has the `common` ones.
    pub(super) fn draw(
        &self,
        tables: &Tables,
        common: &[CategoryOf],
    ) -> Result<Option<Svg>, TaskError> {
        let Some(rows) = tables.get(&self.table) else {
            return Ok(None);
        };
        let groups = self.groups(rows);
        let mut columns: Vec<&Table> = Vec::new();
        for row in groups.iter().flat_map(|(_, rows)| rows) {
            let own = row.get(&self.column);
            if !columns.iter().any(|column| column.get(&self.column) == own) {
                columns.push(row);
            }
        }
        let place = |row: &&Table| number(row, &self.column).unwrap_or(f64::NAN);
        columns.sort_by(|a, b| place(a).total_cmp(&place(b)));
        if columns.is_empty() {
            return Ok(None);
        }
        let categories = if self.categories.is_empty() {
            common
        } else {
            &self.categories
        };
        let groups = groups.iter().map(|(label, rows)| Group {
            label: (*label).to_owned(),
            rows: self.lines(rows, &columns, categories),
            divider: self
                .divider
                .as_ref()
                .and_then(|own| self.line(own, rows, &columns)),
        });
        let category = |own: &CategoryOf| -> Result<Category, TaskError> {
            Ok(Category {
                label: own.label.clone(),
                mark: own.mark.clone(),
                color: color(&own.color)?,
            })
        };
        let map = OutcomeMap {
            title: self.title.clone(),
            subtitle: self.subtitle.clone(),
            x_label: self.x.clone(),
            columns: columns
                .iter()
                .map(|row| filled(&self.column_label, &[row]))
                .collect(),
            groups: groups.filter(|group| !group.rows.is_empty()).collect(),
            categories: categories.iter().map(category).collect::<Result<_, _>>()?,
            width: self.width,
        };
        Ok(Some(map.render()?))
    }

    /// Labels and rows of the groups.
    fn groups<'a>(&'a self, rows: &'a [Table]) -> Vec<(&'a str, Vec<&'a Table>)> {
        if !self.groups.is_empty() {
            let own = |group: &'a GroupOf| {
                let rows = rows.iter().filter(|row| matches(row, &group.wanted));
                (group.label.as_str(), rows.collect())
            };
            return self.groups.iter().map(own).collect();
        }
        let mut groups: Vec<(&str, Vec<&Table>)> = Vec::new();
        for row in rows {
            let label = text(row, &self.group_by).unwrap_or_default();
            match groups.iter_mut().find(|group| group.0 == label) {
                Some(group) => group.1.push(row),
                None => groups.push((label, vec![row])),
            }
        }
        groups
    }

    /// The rows of a group by their names, with the index of each cell's category.
    fn lines(
        &self,
        rows: &[&Table],
        columns: &[&Table],
        categories: &[CategoryOf],
    ) -> Vec<(String, Vec<Option<usize>>)> {
        let mut lines: Vec<(String, Vec<Option<usize>>)> = Vec::new();
        for row in rows {
            let name = text(row, &self.row).unwrap_or_default();
            let line = lines
                .iter()
                .position(|line| line.0 == name)
                .unwrap_or_else(|| {
                    lines.push((name.to_owned(), vec![None; columns.len()]));
                    lines.len() - 1
                });
            let own = |column: &&Table| column.get(&self.column) == row.get(&self.column);
            let cell = text(row, &self.cell).unwrap_or_default();
            if let Some(column) = columns.iter().position(own) {
                lines[line].1[column] = categories.iter().position(|category| category.is == cell);
            }
        }
        let hidden = categories
            .iter()
            .position(|category| category.is == self.hidden);
        lines.retain(|(_, cells)| cells.iter().flatten().any(|&cell| Some(cell) != hidden));
        lines
    }

    /// Where a group is divided, and the text there.
    fn line(
        &self,
        divider: &Divider,
        rows: &[&Table],
        columns: &[&Table],
    ) -> Option<(usize, String)> {
        let is_first = |row: &&&Table| {
            let reached = divider.reaches.as_ref().is_none_or(|limit| {
                let both = number(row, &self.column).zip(number(row, limit));
                both.is_some_and(|(value, limit)| value >= limit)
            });
            reached && matches(row, &divider.wanted)
        };
        let place = |row: &&Table| {
            let own = row.get(&self.column);
            columns
                .iter()
                .position(|column| column.get(&self.column) == own)
        };
        let first = rows.iter().filter(is_first).min_by_key(|row| place(row))?;
        Some((place(first)?, filled(&divider.label, &[first])))
    }
}
