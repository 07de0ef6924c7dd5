//! What the stages of an experiment report: sections of one page, files, figures, a summary.

use serde_json::{Map, Value, json};
use stickslip_fem_core::parallel;
use stickslip_report::FigureError;
use stickslip_report::page::{Block, Figure, Page, PageError, Section};
use stickslip_report::prose::Prose;
use stickslip_report::raster::{DEFAULT_SCALE, to_png};
use stickslip_report::svg::Svg;
use stickslip_report::table::Table;
use thiserror::Error;

use super::findings::sentence;
use stickslip_experiment::Experiment;
use stickslip_measure::finding::{Level, Located};
use stickslip_report::PutFile;

/// Why a report cannot be written.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum ReportError {
    /// What takes the files refuses one.
    #[error(transparent)]
    Put(#[from] Box<dyn std::error::Error + Send + Sync>),
    /// The page.
    #[error("the page cannot be written")]
    Page(#[from] PageError),
    /// The summary.
    #[error("the summary cannot be written")]
    Summary(#[from] serde_json::Error),
    /// A figure as PNG.
    #[error("the figure '{name}' cannot be drawn as PNG")]
    Picture {
        /// Name of the figure.
        name: String,
        /// Its reason.
        #[source]
        cause: FigureError,
    },
}

/// The page of an experiment with all its files. Stages append to it in their order.
#[derive(Debug)]
pub struct ExperimentReport {
    page: Page,
    files: Vec<(String, Vec<u8>)>,
    notes: Vec<(Vec<String>, String)>,
    findings: Vec<Located>,
    summary: Map<String, Value>,
}

impl ExperimentReport {
    /// A report without stages.
    pub fn new(experiment: &Experiment) -> Self {
        let mut page = Page::new(&experiment.title, &experiment.source_name);
        page.notes.extend(experiment.description.clone());
        page.footer = format!(
            "stickslip {} · experiment {}",
            env!("CARGO_PKG_VERSION"),
            experiment.hash
        );
        let head = json!({
            "format": "stickslip-experiment-summary",
            "format_version": 1,
            "title": experiment.title,
            "experiment_hash": experiment.hash,
        });
        Self {
            page,
            files: Vec::new(),
            notes: Vec::new(),
            findings: Vec::new(),
            summary: head.as_object().cloned().unwrap_or_default(),
        }
    }

    /// Begins a section of the page.
    pub fn section(&mut self, title: &str) {
        self.page.sections.push(Section::new(title));
    }

    fn block(&mut self, block: Block) {
        if self.page.sections.is_empty() {
            self.section("Experiment");
        }
        if let Some(section) = self.page.sections.last_mut() {
            section.blocks.push(block);
        }
    }

    /// A paragraph of the section.
    pub fn text(&mut self, text: impl Into<String>) {
        self.block(Block::Text(text.into()));
    }

    /// Paragraphs of the section, from a template.
    pub fn prose(&mut self, prose: Prose) {
        self.block(Block::Prose(prose));
    }

    /// A table of the section.
    pub fn table(&mut self, table: Table) {
        self.block(Block::Table(table));
    }

    /// A figure of the section, also as `figures/NAME.svg` and `figures/NAME.png`. A figure that cannot be drawn is reported.
    pub fn figure(&mut self, name: &str, caption: &str, drawn: Result<Svg, FigureError>) {
        match drawn {
            Ok(picture) => {
                let bytes = picture.as_str().as_bytes().to_vec();
                self.files.push((format!("figures/{name}.svg"), bytes));
                self.block(Block::Figure(Figure::new(picture, caption, name)));
            }
            Err(cause) => self.warn(format!("The figure '{name}' cannot be drawn: {cause}.")),
        }
    }

    /// A file of the folder, and what it holds; files with one `what` are listed together.
    pub fn file(&mut self, name: impl Into<String>, what: &str, bytes: Vec<u8>) {
        let name = name.into();
        match self.notes.iter_mut().find(|(_, listed)| listed == what) {
            Some((names, _)) => names.push(name.clone()),
            None => self.notes.push((vec![name.clone()], what.to_owned())),
        }
        self.files.push((name, bytes));
    }

    /// Adds a warning, shown before the numbers.
    pub fn warn(&mut self, text: impl Into<String>) {
        self.page.warnings.push(text.into());
    }

    /// Adds a choice, a default, or a source, shown below the answers.
    pub fn note(&mut self, text: impl Into<String>) {
        self.page.notes.push(text.into());
    }

    /// Findings, as warnings and notes of the page and as data of the summary.
    pub fn findings(&mut self, experiment: &Experiment, found: impl IntoIterator<Item = Located>) {
        for own in found {
            let message = sentence(experiment, &own);
            match own.finding.level() {
                Level::Warning => self.warn(message),
                Level::Remark => self.note(message),
            }
            self.findings.push(own);
        }
    }

    /// An answer at the top of the page.
    pub fn answer(&mut self, name: &str, value: impl Into<String>) {
        self.page.summary.push((name.to_owned(), value.into()));
    }

    /// An entry of `summary.json`.
    pub fn entry(&mut self, name: &str, value: Value) {
        self.summary.insert(name.to_owned(), value);
    }

    /// The summary for programs.
    pub fn summary(&self) -> Value {
        let mut summary = self.summary.clone();
        summary.insert("warnings".to_owned(), json!(self.page.warnings));
        summary.insert("findings".to_owned(), json!(self.findings));
        Value::Object(summary)
    }

    /// The answers as lines of text.
    pub fn text_answers(&self) -> String {
        let mut lines = vec![self.page.title.clone()];
        let answers = self.page.summary.iter();
        lines.extend(answers.map(|(name, value)| format!("{name}: {value}")));
        lines.extend(
            self.page
                .warnings
                .iter()
                .map(|message| format!("warning: {message}")),
        );
        lines.join("\n")
    }

    /// Hands all files to `put` one after the other, and returns the text of `summary.json`, which belongs last.
    ///
    /// # Errors
    /// [`ReportError`].
    pub fn write(mut self, put: &PutFile<'_>) -> Result<String, ReportError> {
        self.list_files();
        for (name, bytes) in &self.files {
            put(name, bytes)?;
        }
        let sections = self.page.sections.iter();
        let figures: Vec<&Figure> = sections
            .flat_map(|section| &section.blocks)
            .filter_map(|block| match block {
                Block::Figure(figure) => Some(figure),
                _ => None,
            })
            .collect();
        let drawn = parallel::map(&figures, |figure| {
            let name = &figure.anchor;
            let png =
                to_png(&figure.picture, DEFAULT_SCALE).map_err(|cause| ReportError::Picture {
                    name: name.clone(),
                    cause,
                })?;
            Ok::<(), ReportError>(put(&format!("figures/{name}.png"), &png)?)
        });
        drawn.into_iter().collect::<Result<(), ReportError>>()?;
        put("index.html", self.page.render()?.as_bytes())?;
        Ok(serde_json::to_string_pretty(&self.summary())? + "\n")
    }

    fn list_files(&mut self) {
        let own = self.notes.iter();
        let own = own.map(|(names, what)| (listed(names), what.as_str()));
        let common = [
            ("figures/*.svg, figures/*.png", "the figures of this page"),
            ("summary.json", "the numbers that other programs read"),
        ];
        let common = common.map(|(names, what)| (names.to_owned(), what));
        let files = Section::of_files(own.chain(common));
        self.page.sections.push(files);
    }
}

/// Some names, or the first and the last of many.
fn listed(names: &[String]) -> String {
    const MOST: usize = 4;
    match names {
        [first, .., last] if names.len() > MOST => {
            format!("{first} … {last}, {} files", names.len())
        }
        _ => names.join(", "),
    }
}
