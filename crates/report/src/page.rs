//! One self-contained HTML page: summary, tables and figures, nothing loaded from
//! elsewhere, no scripts. It follows the reader's choice of light or dark; figures stay
//! on white. Every text is escaped; only pictures of this crate enter as they are.

use std::collections::BTreeSet;

use minijinja::{Environment, Value, context};

pub use crate::error::PageError;
use crate::prose::Prose;
use crate::svg::Svg;
use crate::table::Table;
use stickslip_text::plain::printable;

/// A picture with a caption.
#[derive(Debug, Clone, PartialEq)]
pub struct Figure {
    /// The picture.
    pub picture: Svg,
    /// What it shows, below it.
    pub caption: String,
    /// Name for links to it, `#traction`; unique on the page. Characters other than
    /// letters, digits, `-`, `_` and `.` become `-`.
    pub anchor: String,
}

impl Figure {
    /// Makes a figure with a caption that `anchor` links to.
    pub fn new(picture: Svg, caption: impl Into<String>, anchor: impl Into<String>) -> Self {
        Self {
            picture,
            caption: caption.into(),
            anchor: anchor.into(),
        }
    }
}

/// One thing in a section.
#[derive(Debug, Clone, PartialEq)]
pub enum Block {
    /// A paragraph.
    Text(String),
    /// Paragraphs of a template.
    Prose(Prose),
    /// A table.
    Table(Table),
    /// A figure.
    Figure(Figure),
    /// Text as a file has it, below its title.
    Code {
        /// What it is.
        title: String,
        /// Its lines.
        text: String,
    },
}

impl From<Prose> for Block {
    fn from(prose: Prose) -> Self {
        Self::Prose(prose)
    }
}

impl From<Table> for Block {
    fn from(table: Table) -> Self {
        Self::Table(table)
    }
}

impl From<Figure> for Block {
    fn from(figure: Figure) -> Self {
        Self::Figure(figure)
    }
}

/// A titled part of the page.
#[derive(Debug, Clone, PartialEq)]
pub struct Section {
    /// Title, also in the table of contents.
    pub title: String,
    /// What it holds, in order.
    pub blocks: Vec<Block>,
}

impl Section {
    /// Makes an empty section.
    pub fn new(title: impl Into<String>) -> Self {
        Self {
            title: title.into(),
            blocks: Vec::new(),
        }
    }

    /// Adds a block.
    #[must_use]
    pub fn with(mut self, block: impl Into<Block>) -> Self {
        self.blocks.push(block.into());
        self
    }

    /// Makes the section that lists files, by name or pattern, and what they hold.
    pub fn of_files<A: Into<String>, B: Into<String>>(
        files: impl IntoIterator<Item = (A, B)>,
    ) -> Self {
        let rows = files
            .into_iter()
            .map(|(names, what)| [names.into(), what.into()]);
        Self::new("Files").with(Table::headed("", "file | holds").with_rows(rows))
    }
}

/// A page: title, warnings, summary, then the sections in order.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Page {
    /// Title.
    pub title: String,
    /// One line below the title; may be empty.
    pub subtitle: String,
    /// What a reader must know before trusting the numbers.
    pub warnings: Vec<String>,
    /// The answer first: names and values.
    pub summary: Vec<(String, String)>,
    /// Remarks below the summary: choices made, signs, sources.
    pub notes: Vec<String>,
    /// The rest.
    pub sections: Vec<Section>,
    /// A line at the end: program, version; may be empty.
    pub footer: String,
}

impl Page {
    /// Makes an empty page.
    pub fn new(title: impl Into<String>, subtitle: impl Into<String>) -> Self {
        Self {
            title: title.into(),
            subtitle: subtitle.into(),
            ..Self::default()
        }
    }

    /// Writes the page as HTML 5, UTF-8.
    ///
    /// # Errors
    /// [`PageError::DuplicateAnchor`] if two figures share an anchor; [`PageError::Template`] if the template engine fails.
    pub fn render(&self) -> Result<String, PageError> {
        self.check_anchors()?;
        let sections = (1..).zip(&self.sections);
        let sections = sections.map(|(number, section)| section_value(number, section));
        let page = self.filled(sections.collect::<Result<_, _>>()?)?;
        Ok(printable(&page).into_owned())
    }

    /// The template with the page's texts.
    fn filled(&self, sections: Vec<Value>) -> Result<String, minijinja::Error> {
        let mut environment = Environment::new();
        environment.add_template("page.html", include_str!("page.jinja"))?;
        let pairs = |(name, value): &(String, String)| context! { name, value };
        environment.get_template("page.html")?.render(context! {
            title => self.title.clone(),
            subtitle => self.subtitle.clone(),
            warnings => self.warnings.clone(),
            summary => self.summary.iter().map(pairs).collect::<Vec<Value>>(),
            notes => self.notes.clone(),
            sections,
            footer => self.footer.clone(),
        })
    }

    fn check_anchors(&self) -> Result<(), PageError> {
        let mut seen = BTreeSet::new();
        let blocks = self.sections.iter().flat_map(|section| &section.blocks);
        for block in blocks {
            if let Block::Figure(figure) = block {
                let anchor = figure_anchor(figure);
                if !seen.insert(anchor.clone()) {
                    return Err(PageError::DuplicateAnchor { anchor });
                }
            }
        }
        Ok(())
    }
}

fn section_value(number: usize, section: &Section) -> Result<Value, PageError> {
    let mut blocks = Vec::new();
    for block in &section.blocks {
        match block {
            Block::Text(text) => blocks.push(text_value(text)),
            Block::Prose(prose) => {
                blocks.extend(prose.paragraphs()?.iter().map(|text| text_value(text)));
            }
            Block::Table(table) => blocks.push(table_value(table)),
            Block::Figure(figure) => blocks.push(figure_value(figure)),
            Block::Code { title, text } => {
                blocks.push(context! { kind => "code", title, text });
            }
        }
    }
    // A colon keeps these apart from the anchors of figures.
    Ok(context! { title => section.title.clone(), anchor => format!("section:{number}"), blocks })
}

fn text_value(text: &str) -> Value {
    context! { kind => "text", text }
}

fn figure_value(figure: &Figure) -> Value {
    context! {
        kind => "figure",
        picture => Value::from_safe_string(figure.picture.to_string()),
        caption => figure.caption.clone(),
        anchor => figure_anchor(figure),
    }
}

fn table_value(table: &Table) -> Value {
    let numeric = table.numeric_columns();
    let heading = |index: usize| {
        let column = table.columns.get(index);
        context! {
            name => column.map_or("", |column| column.name.as_str()),
            unit => column.map_or("", |column| column.unit.as_str()),
            number => numeric[index],
        }
    };
    let cells = |row: Vec<String>| -> Vec<Value> {
        row.into_iter()
            .zip(&numeric)
            .map(|(text, number)| context! { text, number => *number })
            .collect()
    };
    let rows: Vec<Vec<Value>> = table.full_rows().into_iter().map(cells).collect();
    context! {
        kind => "table",
        caption => table.caption.clone(),
        columns => (0..table.column_count()).map(heading).collect::<Vec<Value>>(),
        units => table.columns.iter().any(|column| !column.unit.is_empty()),
        rows,
        notes => table.notes.clone(),
    }
}

/// The anchor in characters that need no escape in a link.
fn figure_anchor(figure: &Figure) -> String {
    let safe = |c: char| {
        if c.is_ascii_alphanumeric() || "-_.".contains(c) {
            c
        } else {
            '-'
        }
    };
    figure.anchor.chars().map(safe).collect()
}
