//! From the text of a scene file to a checked scene.

use std::io;
use std::path::Path;

use crate::diagnostic::{SceneError, SceneProblem, SourceText};
use crate::document::{Document, Format, Part};
use crate::host::Host;
use crate::scene::{Scene, VERSION};
use crate::{build, open};

impl Scene {
    /// Reads and checks a file of `host`, JSON if its name ends in `.json` and otherwise TOML, with the overrides `key=value` applied in
    /// turn. The scene, its data files and its model may take no more than the host's limits.
    ///
    /// # Errors
    /// [`SceneError`] with everything that is wrong, each at its line or in its override; a file that is too large.
    pub fn from_file(
        path: &Path,
        overrides: &[impl AsRef<str>],
        host: Host,
    ) -> Result<Self, SceneError> {
        let SourceText { name, text } = open::text_of(path, host, unread)?;
        let base = path.parent().unwrap_or(Path::new(""));
        Self::from_text_on(&text, Format::of_path(path), &name, base, overrides, host)
    }

    /// Reads and checks a scene that names no files. `name` stands for the text in errors.
    ///
    /// # Errors
    /// As [`Scene::from_file`].
    pub fn from_text(
        text: &str,
        format: Format,
        name: &str,
        base_dir: &Path,
        overrides: &[impl AsRef<str>],
    ) -> Result<Self, SceneError> {
        Self::from_text_on(text, format, name, base_dir, overrides, Host::NONE)
    }

    /// As [`from_text`](Self::from_text), with `host` for data files, which are looked for in `base_dir`. Data and model may take no more than
    /// the limits of `host`. Each of `overrides` is `key=value`, as after `--set`.
    ///
    /// # Errors
    /// As [`Scene::from_file`].
    pub fn from_text_on(
        text: &str,
        format: Format,
        name: &str,
        base_dir: &Path,
        overrides: &[impl AsRef<str>],
        host: Host,
    ) -> Result<Self, SceneError> {
        let source = SourceText {
            name: name.to_owned(),
            text: text.to_owned(),
        };
        let document = open::scene(source, format, overrides, host)?;
        check_version(&document)?;
        let spelled = open::keys(&document)?;
        build::build(document, spelled, base_dir)
    }
}

fn unread(path: String, error: &io::Error) -> SceneProblem {
    match error.kind() {
        io::ErrorKind::NotFound => SceneProblem::MissingFile { path },
        _ => SceneProblem::unreadable(path, error),
    }
}

fn check_version(document: &Document) -> Result<(), SceneError> {
    let supported = VERSION;
    let problem = match document.get("version") {
        None => SceneProblem::MissingVersion { supported },
        Some(version) if version.as_u64() == Some(supported) => return Ok(()),
        Some(version) => SceneProblem::UnsupportedVersion {
            found: version.to_string(),
            supported,
        },
    };
    Err(document.error("version", Part::Value, problem))
}
