//! Tables: one description for the terminal and for the page.

use std::fmt;

use comfy_table::{CellAlignment, ContentArrangement, LineStyle, TableStyle};

/// A column's heading.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Column {
    /// Name: `CPRESS`.
    pub name: String,
    /// Unit, in its own row below the names; empty for none.
    pub unit: String,
}

impl Column {
    /// Makes a column with a name and a unit (empty for none).
    pub fn new(name: impl Into<String>, unit: impl Into<String>) -> Self {
        Self {
            name: name.into(),
            unit: unit.into(),
        }
    }
}

/// A table of texts; numbers arrive formatted.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Table {
    /// What the table shows; may be empty.
    pub caption: String,
    /// Headings.
    pub columns: Vec<Column>,
    /// Cells, row by row. A short row is completed by empty cells; cells beyond the
    /// last column are shown under an empty heading.
    pub rows: Vec<Vec<String>>,
    /// Remarks below the table.
    pub notes: Vec<String>,
}

impl Table {
    /// Makes an empty table with headings.
    pub fn new(caption: impl Into<String>, columns: Vec<Column>) -> Self {
        Self {
            caption: caption.into(),
            columns,
            ..Self::default()
        }
    }

    /// Makes an empty table from its headings in one line, names with units in brackets: `load [kN] | ply | σ_1 [MPa]`.
    pub fn headed(caption: impl Into<String>, headings: &str) -> Self {
        let column = |heading: &str| {
            let inside = heading.strip_suffix(']');
            match inside.and_then(|heading| heading.rsplit_once(" [")) {
                Some((name, unit)) => Column::new(name, unit),
                None => Column::new(heading, ""),
            }
        };
        Self::new(caption, headings.split(" | ").map(column).collect())
    }

    /// Adds a row.
    pub fn push<I, T>(&mut self, row: I)
    where
        I: IntoIterator<Item = T>,
        T: Into<String>,
    {
        self.rows.push(row.into_iter().map(Into::into).collect());
    }

    /// Adds rows.
    #[must_use]
    pub fn with_rows<I, T>(mut self, rows: impl IntoIterator<Item = I>) -> Self
    where
        I: IntoIterator<Item = T>,
        T: Into<String>,
    {
        for row in rows {
            self.push(row);
        }
        self
    }

    /// Adds a remark.
    #[must_use]
    pub fn note(mut self, note: impl Into<String>) -> Self {
        self.notes.push(note.into());
        self
    }

    /// Adds every line of `notes` as a remark.
    #[must_use]
    pub fn with_notes(mut self, notes: &str) -> Self {
        self.notes.extend(notes.lines().map(str::to_owned));
        self
    }

    /// Writes the table as plain text: caption, aligned columns with a row of units, notes.
    /// Numbers are aligned right. Cells are wrapped so that lines have at most `width`
    /// characters, if one is given. Ends with a line break.
    pub fn to_text(&self, width: Option<u16>) -> String {
        let mut text = comfy_table::Table::new();
        let rule = LineStyle::none().fill('─').junction('─');
        text.load_style(TableStyle::new().header_separator(rule));
        if let Some(width) = width {
            text.set_content_arrangement(ContentArrangement::Dynamic)
                .set_width(width);
        }
        text.set_header(self.headings());
        for row in self.full_rows() {
            text.add_row(row);
        }
        for (index, number) in self.numeric_columns().into_iter().enumerate() {
            let Some(column) = text.column_mut(index) else {
                continue;
            };
            column.set_padding((1, 0));
            if number {
                column.set_cell_alignment(CellAlignment::Right);
            }
        }
        let mut lines: Vec<String> = Vec::new();
        if !self.caption.is_empty() {
            lines.push(self.caption.clone());
        }
        lines.extend(text.lines().map(|line| line.trim_end().to_owned()));
        lines.extend(self.notes.iter().map(|note| format!("  {note}")));
        lines.join("\n") + "\n"
    }

    /// Removes column `index`, if there is one.
    #[must_use]
    pub fn without_column(mut self, index: usize) -> Self {
        for row in &mut self.rows {
            if index < row.len() {
                row.remove(index);
            }
        }
        if index < self.columns.len() {
            self.columns.remove(index);
        }
        self
    }

    /// Measures the widest line of the table as text, where no cell is wrapped.
    pub fn text_width(&self) -> usize {
        let text = self.to_text(None);
        text.lines()
            .map(|line| line.chars().count())
            .max()
            .unwrap_or(0)
    }

    /// The rows, each with as many cells as there are columns.
    pub(crate) fn full_rows(&self) -> Vec<Vec<String>> {
        let count = self.column_count();
        let fill = |row: &Vec<String>| {
            let mut row = row.clone();
            row.resize(count, String::new());
            row
        };
        self.rows.iter().map(fill).collect()
    }

    /// Which columns hold numbers and gaps and nothing else.
    pub(crate) fn numeric_columns(&self) -> Vec<bool> {
        let rows = self.full_rows();
        let numeric = |column: usize| {
            let mut cells = rows.iter().map(|row| row[column].trim());
            rows.iter().any(|row| !row[column].trim().is_empty())
                && cells.all(|cell| is_number(cell) || is_gap(cell))
        };
        (0..self.column_count()).map(numeric).collect()
    }

    pub(crate) fn column_count(&self) -> usize {
        self.rows
            .iter()
            .map(Vec::len)
            .fold(self.columns.len(), usize::max)
    }

    fn headings(&self) -> Vec<String> {
        let units = self.columns.iter().any(|column| !column.unit.is_empty());
        let heading = |index: usize| match self.columns.get(index) {
            Some(column) if units => format!("{}\n{}", column.name, column.unit),
            Some(column) => column.name.clone(),
            None => String::new(),
        };
        (0..self.column_count()).map(heading).collect()
    }
}

/// Makes the cell of an item.
type Cell<'a, T> = Box<dyn Fn(T) -> String + 'a>;

/// Columns of a table with a row for each item of one kind: name, unit, and the cell of an item.
pub struct Columns<'a, T> {
    columns: Vec<(Column, Cell<'a, T>)>,
}

impl<T> fmt::Debug for Columns<'_, T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let headings = self.columns.iter().map(|(heading, _)| heading);
        f.debug_list().entries(headings).finish()
    }
}

impl<T> Default for Columns<'_, T> {
    fn default() -> Self {
        Self {
            columns: Vec::new(),
        }
    }
}

impl<'a, T: Copy> Columns<'a, T> {
    /// Makes no columns.
    pub fn new() -> Self {
        Self::default()
    }

    /// Adds a column with a name, a unit (empty for none) and the cell of an item.
    #[must_use]
    pub fn with(
        mut self,
        name: impl Into<String>,
        unit: impl Into<String>,
        cell: impl Fn(T) -> String + 'a,
    ) -> Self {
        self.columns.push((Column::new(name, unit), Box::new(cell)));
        self
    }

    /// Adds the columns of `others`.
    #[must_use]
    pub fn and(mut self, others: impl IntoIterator<Item = Self>) -> Self {
        self.columns
            .extend(others.into_iter().flat_map(|other| other.columns));
        self
    }

    /// Names with units as files have them, `CPRESS [psi]`.
    pub fn header(&self) -> Vec<String> {
        let heading = |(column, _): &(Column, _)| match column.unit.as_str() {
            "" => column.name.clone(),
            unit => format!("{} [{unit}]", column.name),
        };
        self.columns.iter().map(heading).collect()
    }

    /// The cells of an item.
    pub fn cells(&self, item: T) -> Vec<String> {
        self.columns.iter().map(|(_, cell)| cell(item)).collect()
    }

    /// Makes a table with a row for each item.
    pub fn table(self, caption: impl Into<String>, items: impl IntoIterator<Item = T>) -> Table {
        let rows = items.into_iter().map(|item| self.cells(item)).collect();
        let columns = self.columns.into_iter().map(|(heading, _)| heading);
        Table {
            rows,
            ..Table::new(caption, columns.collect())
        }
    }
}

fn is_gap(cell: &str) -> bool {
    matches!(cell, "" | "–" | "—" | "-" | "n/a")
}

/// Whether a cell reads as a number: with a true minus, a power of ten, a percent sign.
fn is_number(cell: &str) -> bool {
    let plain = cell.replace('−', "-");
    let plain = plain.trim_end_matches('%').trim_end();
    let mantissa = plain
        .split_once("×10")
        .map_or(plain, |(mantissa, _)| mantissa);
    !mantissa.is_empty() && mantissa.parse::<f64>().is_ok()
}
