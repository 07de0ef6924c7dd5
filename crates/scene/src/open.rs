//! What readers of documents share: the text of a file, its overrides, what its keys say, units of results and friction laws.
//!
//! ```text
//! text_of ──► document ──► check_version ──► keys::<T> ──► values, refused by Document::error at their keys
//! ```

use std::io;
use std::path::Path;
use std::sync::Arc;

use serde::de::DeserializeOwned;
use stickslip_mesh_files::Foreign;

use crate::diagnostic::{SceneError, SceneProblem, SourceText};
use crate::document::{Document, Format, Part};
use crate::foreign;
use crate::host::Host;
use crate::limits::Content;
use crate::overrides;
use crate::pattern;
use crate::read::Reader;

pub use crate::format::UnitsFormat;
pub use crate::friction::law;

/// Reads the text of a file of `host`. What it says of one that cannot be read comes from `problem`, by its path.
///
/// # Errors
/// [`SceneError`]: no such file, one that is too large or not text, and a mesh or a geometry of another program.
pub fn text_of(
    path: &Path,
    host: Host,
    problem: fn(String, &io::Error) -> SceneProblem,
) -> Result<SourceText, SceneError> {
    let name = path.display().to_string();
    let by_name = Foreign::of_name(&name).filter(|_| host.system.length(path).is_ok());
    let problem = match by_name {
        Some(kind) => foreign::problem(path, kind, host),
        None => match host.read_text(path, Content::Document) {
            Ok(text) => match Foreign::of_text(&text) {
                Some(kind) => foreign::problem(path, kind, host),
                None => return Ok(SourceText { name, text }),
            },
            Err(error) => problem(name.clone(), &error),
        },
    };
    let text = String::new();
    let source = Arc::new(SourceText { name, text });
    Err(SceneError::in_text(problem, &source, None))
}

/// Reads a document with the overrides `key=value` applied in turn. The files that it names are those of `host`.
///
/// # Errors
/// [`SceneError`] at the first place that is neither TOML nor JSON, at an override that cannot be applied, at a text with a control character.
pub fn document(
    source: SourceText,
    format: Format,
    overrides: &[impl AsRef<str>],
    host: Host,
) -> Result<Document, SceneError> {
    let mut document = Document::parse(source, format)?;
    document.host = host;
    for argument in overrides {
        overrides::apply(&mut document, argument.as_ref())?;
    }
    document.check_texts()?;
    Ok(document)
}

/// Reads the document of a scene, with its patterns written out. Overrides of what a pattern copies, and those that bring patterns, are applied before, others after.
///
/// # Errors
/// As [`document`], and at a pattern that cannot be written out.
pub(crate) fn scene(
    source: SourceText,
    format: Format,
    overrides: &[impl AsRef<str>],
    host: Host,
) -> Result<Document, SceneError> {
    let mut document = Document::parse(source, format)?;
    document.host = host;
    let mut later = Vec::new();
    for argument in overrides.iter().map(AsRef::as_ref) {
        let (key, value) = argument.split_once('=').unwrap_or((argument, ""));
        if pattern::is_copied(&document, key.trim()) || value.contains("pattern") {
            overrides::apply(&mut document, argument)?;
        } else {
            later.push(argument);
        }
    }
    pattern::write_out(&mut document)?;
    for argument in later {
        overrides::apply(&mut document, argument)?;
    }
    document.check_texts()?;
    Ok(document)
}

/// Checks the version of a document that is no scene; `what` names its kind.
///
/// # Errors
/// [`SceneError`] at a missing version, or one that is not `supported`.
pub fn check_version(document: &Document, what: &str, supported: u64) -> Result<(), SceneError> {
    let problem = match document.get("version") {
        Some(version) if version.as_u64() == Some(supported) => return Ok(()),
        Some(version) => SceneProblem::conflict(
            format!("version {version} of the {what} format is not supported"),
            format!("this program reads version = {supported}"),
        ),
        None => SceneProblem::MissingKey {
            key: "version".to_owned(),
            table: format!("the {what}"),
            example: format!("version = {supported}"),
        },
    };
    Err(document.error("version", Part::Value, problem))
}

/// Reads the keys of a document.
///
/// # Errors
/// [`SceneError`] at the first key that is unknown, missing or of another kind.
pub fn keys<T: DeserializeOwned>(document: &Document) -> Result<T, SceneError> {
    T::deserialize(Reader::new(&document.root, "")).map_err(|error| {
        let key = error.key.as_deref().unwrap_or_default();
        let problem = overrides::mistyped(document, key, *error.problem);
        document.error(key, error.part, problem)
    })
}

/// The stem of a path's last name, the title of a document without one.
pub fn stem(name: &str) -> String {
    let stem = Path::new(name).file_stem();
    stem.unwrap_or_default().to_string_lossy().into_owned()
}
