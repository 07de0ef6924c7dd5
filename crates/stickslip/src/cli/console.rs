//! The two output streams.

use std::io::{self, IsTerminal, Write};

use serde::Serialize;
use serde_json::json;
use stickslip_text::plain::printable;

use super::failure::{CommandError, Failure};

/// Columns of a message on a terminal. Elsewhere lines are not broken, so that they can be searched.
const TERMINAL_WIDTH: usize = 100;
const UNBROKEN: usize = 10_000;
/// Columns of a table that goes to a file or another program.
const FILE_WIDTH: usize = 120;

/// Where and how the command speaks.
#[derive(Debug, Clone, Copy)]
pub(super) struct Console {
    pub(super) quiet: bool,
    pub(super) json: bool,
}

impl Console {
    pub(super) fn new(quiet: bool, json: bool) -> Self {
        Self { quiet, json }
    }

    /// Columns of the terminal that standard output is, or those of a table elsewhere.
    pub(super) fn width() -> usize {
        let terminal = terminal_size::terminal_size_of(io::stdout());
        terminal.map_or(FILE_WIDTH, |(width, _)| usize::from(width.0))
    }

    /// Whether somebody sees how far a command is.
    pub(super) fn shows_progress(self) -> bool {
        !self.quiet && !self.json && io::stderr().is_terminal()
    }

    /// Prints a result: `text` for people, `value` for programs.
    pub(super) fn result(
        self,
        text: impl FnOnce() -> String,
        value: &impl Serialize,
    ) -> Result<(), Failure> {
        let output = match (self.json, self.quiet) {
            (true, _) => {
                let rendered = serde_json::to_string_pretty(value);
                rendered.map_err(|error| CommandError::Output {
                    cause: error.to_string(),
                })? + "\n"
            }
            (false, true) => return Ok(()),
            (false, false) => printable(&text()).into_owned(),
        };
        match io::stdout().lock().write_all(output.as_bytes()) {
            // The reader has seen enough: `stickslip list | head`.
            Err(error) if error.kind() == io::ErrorKind::BrokenPipe => Ok(()),
            Err(error) => Err(CommandError::Output {
                cause: error.to_string(),
            }
            .into()),
            Ok(()) => Ok(()),
        }
    }

    /// Prints what happened beside the results to standard error.
    pub(super) fn note(self, text: &str) {
        let line = match (self.json, self.quiet) {
            (true, _) => format!("{:#}\n", json!({ "notes": [text] })),
            (false, true) => return,
            (false, false) => format!("note: {}\n", printable(text)),
        };
        // A note that nobody can read is no reason to fail.
        let _ = io::stderr().lock().write_all(line.as_bytes());
    }

    /// Prints an error to standard error.
    pub(super) fn fail(self, failure: &Failure) {
        let mut stream = io::stderr().lock();
        let terminal = stream.is_terminal();
        let text = if self.json {
            format!("{:#}\n", json!({ "errors": failure.summaries() }))
        } else {
            let colours = terminal && std::env::var_os("NO_COLOR").is_none();
            failure.render(if terminal { TERMINAL_WIDTH } else { UNBROKEN }, colours)
        };
        // The exit code reports the failure even if nobody can read the message.
        let _ = stream.write_all(text.as_bytes());
    }
}
