//! Errors that show file, line and remedy.
//!
//! A [`SceneProblem`] says what is wrong and how to correct it, with numbers. A [`Finding`] is a problem at its place: the key, and
//! the span of the scene file or of the `--set` argument that it stands in. A [`SceneError`] is everything that was found in
//! one scene.

mod laminate;
mod made;
mod nearest;
mod problem;
mod remedy;

use std::fmt;
use std::sync::Arc;

use miette::{
    Diagnostic, GraphicalReportHandler, GraphicalTheme, LabeledSpan, SourceCode, SourceOffset,
};
use serde::Serialize;
use stickslip_text::plain::{printable, printable_with_colours};

pub use laminate::LaminateProblem;
pub use nearest::{nearest, one_of};
pub use problem::SceneProblem;

/// A text that a problem can be shown in: a scene file, or an argument of `--set`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SourceText {
    /// Path of the file as given, or `--set`.
    pub name: String,
    /// The whole text.
    pub text: String,
}

/// Bytes `start..end` of a [`SourceText`].
pub type Span = std::ops::Range<usize>;

/// A problem at its place.
#[derive(Debug, Clone)]
pub struct Finding {
    /// What is wrong.
    pub problem: SceneProblem,
    /// The key, as `--set` would name it: `contacts.0.friction`. Empty for the scene as a whole.
    pub key: String,
    /// The text it stands in.
    pub source: Arc<SourceText>,
    /// Where in the text, if it stands anywhere.
    pub span: Option<Span>,
}

impl Finding {
    /// Line and column in the source, both from 1.
    pub fn position(&self) -> Option<(usize, usize)> {
        let before = self.source.text.get(..self.span.as_ref()?.start)?;
        let line_start = before.rfind('\n').map_or(0, |newline| newline + 1);
        let line = before.matches('\n').count() + 1;
        Some((line, before[line_start..].chars().count() + 1))
    }

    /// The finding as numbers and texts for programs.
    pub fn summary(&self) -> FindingSummary {
        let (line, column) = self.position().unzip();
        FindingSummary {
            code: self.problem.code().map(|code| code.to_string()),
            message: self.problem.to_string(),
            help: self.problem.help().map(|help| help.to_string()),
            source: Some(self.source.name.clone()),
            line,
            column,
            key: Some(self.key.clone()).filter(|key| !key.is_empty()),
        }
    }
}

/// A [`Finding`] for programs.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct FindingSummary {
    /// Kind of the problem, such as `scene::unknown_key`.
    pub code: Option<String>,
    /// What is wrong.
    pub message: String,
    /// How to correct it.
    pub help: Option<String>,
    /// File, or `--set`.
    pub source: Option<String>,
    /// Line from 1.
    pub line: Option<usize>,
    /// Column from 1, in characters.
    pub column: Option<usize>,
    /// The key in the scene.
    pub key: Option<String>,
}

impl fmt::Display for Finding {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.problem.fmt(formatter)
    }
}

impl std::error::Error for Finding {}

impl Diagnostic for Finding {
    fn code<'a>(&'a self) -> Option<Box<dyn fmt::Display + 'a>> {
        self.problem.code()
    }

    fn help<'a>(&'a self) -> Option<Box<dyn fmt::Display + 'a>> {
        self.problem.help()
    }

    fn source_code(&self) -> Option<&dyn SourceCode> {
        self.span.as_ref().map(|_| &*self.source as &dyn SourceCode)
    }

    fn labels(&self) -> Option<Box<dyn Iterator<Item = LabeledSpan> + '_>> {
        let span = self.span.clone()?;
        let label = if self.key.is_empty() {
            "here"
        } else {
            &self.key
        };
        let length = self.source.shown(&span).len();
        let label = LabeledSpan::new(Some(label.to_owned()), span.start, length);
        Some(Box::new(std::iter::once(label)))
    }
}

impl SourceText {
    /// The last boundary of characters up to `at`.
    fn boundary(&self, at: usize) -> usize {
        let mut places = (0..=at.min(self.text.len())).rev();
        // There is one at 0.
        places
            .find(|&place| self.text.is_char_boundary(place))
            .unwrap_or(0)
    }

    /// The part of a span that is marked: its beginning, where it lies in long lines.
    fn shown(&self, span: &Span) -> Span {
        let end = if has_long_lines(self.text.get(span.clone()).unwrap_or_default()) {
            self.boundary(span.start + BESIDE)
        } else {
            span.end
        };
        span.start..end
    }
}

/// Bytes of the longest line that is shown whole; [`miette`] panics from 65536 columns on.
const LONGEST_LINE: usize = 1000;
/// Bytes that are shown of long lines, of a span and on either side of it.
const BESIDE: usize = 100;

fn has_long_lines(text: &str) -> bool {
    text.lines().any(|line| line.len() > LONGEST_LINE)
}

impl SourceCode for SourceText {
    fn read_span<'a>(
        &'a self,
        span: &miette::SourceSpan,
        lines_before: usize,
        lines_after: usize,
    ) -> Result<Box<dyn miette::SpanContents<'a> + 'a>, miette::MietteError> {
        let inner = self.text.read_span(span, lines_before, lines_after)?;
        let (mut from, mut line, mut column) =
            (inner.span().offset(), inner.line(), inner.column());
        let mut to = from + inner.span().len();
        let text = self.text.get(from..to).unwrap_or_default();
        if has_long_lines(text) {
            let begin = self.boundary(span.offset().saturating_sub(BESIDE));
            if begin > from {
                line += self.text[from..begin].matches('\n').count();
                (from, column) = (begin, 0);
            }
            let end = span.offset() + span.len() + BESIDE;
            to = to.min(self.boundary(end));
        }
        let part = &self.text.as_bytes()[from..to];
        Ok(Box::new(miette::MietteSpanContents::new_named(
            self.name.clone(),
            part,
            (from, part.len()).into(),
            line,
            column,
            part.split(|&byte| byte == b'\n').count(),
        )))
    }
}

/// Everything that was found wrong with a scene; at least one finding.
#[derive(Debug, Clone)]
pub struct SceneError {
    findings: Vec<Finding>,
}

impl SceneError {
    /// `first` and all `others`.
    pub fn new(first: Finding, others: impl IntoIterator<Item = Finding>) -> Self {
        let mut findings = vec![first];
        findings.extend(others);
        Self { findings }
    }

    /// A problem of a text that has no key.
    pub fn in_text(problem: SceneProblem, source: &Arc<SourceText>, span: Option<Span>) -> Self {
        let finding = Finding {
            problem,
            key: String::new(),
            source: Arc::clone(source),
            span,
        };
        Self::new(finding, [])
    }

    /// Nothing where there are no findings.
    ///
    /// # Errors
    /// All of them.
    pub fn of_all(findings: Vec<Finding>) -> Result<(), Self> {
        if findings.is_empty() {
            return Ok(());
        }
        Err(Self { findings })
    }

    /// The findings in the order in which they were met.
    pub fn findings(&self) -> &[Finding] {
        &self.findings
    }

    /// The findings as text with the lines they stand in, `width` columns wide, with colours on request.
    pub fn render(&self, width: usize, colours: bool) -> String {
        self.findings
            .iter()
            .map(|finding| render(finding, width, colours))
            .collect::<Vec<_>>()
            .join("\n")
    }
}

impl fmt::Display for SceneError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (index, finding) in self.findings.iter().enumerate() {
            if index > 0 {
                formatter.write_str("; ")?;
            }
            write!(formatter, "{}", finding.source.name)?;
            if let Some((line, column)) = finding.position() {
                write!(formatter, ":{line}:{column}")?;
            }
            write!(formatter, ": {}", finding.problem)?;
        }
        Ok(())
    }
}

impl std::error::Error for SceneError {}

/// One diagnostic as text.
pub fn render(diagnostic: &dyn Diagnostic, width: usize, colours: bool) -> String {
    let theme = if colours {
        GraphicalTheme::unicode()
    } else {
        GraphicalTheme::unicode_nocolor()
    };
    let handler = GraphicalReportHandler::new_themed(theme)
        .with_width(width)
        .with_links(false);
    let mut text = String::new();
    if handler.render_report(&mut text, diagnostic).is_err() {
        // Writing into a string does not fail; a span outside its text would, and then the words must do.
        return printable(&format!("{diagnostic}\n")).into_owned();
    }
    if colours {
        printable_with_colours(&text)
    } else {
        printable(&text).into_owned()
    }
}

/// Byte offset of a line and column, both from 1 and the column in bytes, as `serde_json` gives them.
pub(crate) fn offset_of(text: &str, line: usize, column: usize) -> usize {
    SourceOffset::from_location(text, line, column)
        .offset()
        .min(text.len())
}
