//! `stickslip init`: scenes and an experiment to start from.

use std::path::{Path, PathBuf};

use clap::Args;
use serde_json::json;

use super::console::Console;
use super::failure::{CommandError, Failure};
use crate::folder::{FolderError, write_new};
use stickslip_experiment::templates::TEMPLATES as EXPERIMENTS;
use stickslip_scene::Format;
use stickslip_scene::templates::{TEMPLATES as SCENES, Template};

#[derive(Debug, Args)]
pub(super) struct InitArguments {
    /// Name of a template; `stickslip list templates` shows them
    template: String,
    /// File to write, TOML, or JSON without comments if its name ends in .json; by default the template's name with .toml
    file: Option<PathBuf>,
}

/// All templates.
pub(super) fn templates() -> impl Iterator<Item = &'static Template> {
    SCENES.iter().chain(&EXPERIMENTS)
}

pub(super) fn init(arguments: &InitArguments, console: Console) -> Result<(), Failure> {
    let Some(template) = templates().find(|template| template.name == arguments.template) else {
        return Err(CommandError::UnknownTemplate {
            name: arguments.template.clone(),
            known: templates()
                .map(|template| template.name.to_owned())
                .collect(),
        }
        .into());
    };
    let default = || PathBuf::from(format!("{}.toml", template.name));
    let file = arguments.file.clone().unwrap_or_else(default);
    let format = format_of(&file, template)?;
    let folder = file.parent().unwrap_or(Path::new(""));
    // A sample is named after the file that reads it, so that a folder may hold several.
    let mut own = template.text.to_owned();
    let mut files = Vec::new();
    for (name, text) in template.data {
        let kind = Path::new(name).extension().unwrap_or_default();
        let path = folder.join(file.with_extension(kind).file_name().unwrap_or_default());
        if let Some(named) = path.file_name() {
            own = own.replace(name, &named.to_string_lossy());
        }
        files.push((path, (*text).to_owned()));
    }
    if format == Format::Json {
        own = json_of(&own).map_err(|cause| CommandError::Write {
            path: file.display().to_string(),
            cause,
        })?;
    }
    files.push((file.clone(), own));
    if let Some((path, _)) = files.iter().find(|(path, _)| path.exists()) {
        return Err(exists(path, template).into());
    }
    write_all_new(&files, template)?;
    let shown = file.display().to_string();
    let names: Vec<_> = files
        .iter()
        .map(|(path, _)| path.display().to_string())
        .collect();
    let mut scenes = SCENES.iter();
    let next = if scenes.any(|scene| scene.name == template.name) {
        "check"
    } else {
        "reduce"
    };
    console.result(
        || {
            format!(
                "wrote {}\nnext: stickslip {next} {shown}\n",
                names.join(" and ")
            )
        },
        &json!({ "template": template.name, "scene": shown, "files": names }),
    )
}

/// The format that commands will read the file in, by its name.
fn format_of(file: &Path, template: &Template) -> Result<Format, CommandError> {
    let extension = file
        .extension()
        .map(|own| own.to_string_lossy().to_lowercase());
    match extension.as_deref() {
        Some("toml") | None => Ok(Format::Toml),
        Some("json") => Ok(Format::Json),
        Some(extension) => Err(CommandError::TemplateFormat {
            path: file.display().to_string(),
            extension: extension.to_owned(),
            template: template.name.to_owned(),
            instead: file.with_extension("toml").display().to_string(),
        }),
    }
}

/// The keys of a template as JSON, which has no comments.
fn json_of(text: &str) -> Result<String, String> {
    let keys: serde_json::Value = toml::from_str(text).map_err(|cause| cause.to_string())?;
    let json = serde_json::to_string_pretty(&keys).map_err(|cause| cause.to_string())?;
    Ok(json + "\n")
}

fn exists(path: &Path, template: &Template) -> CommandError {
    CommandError::FileExists {
        path: path.display().to_string(),
        template: template.name.to_owned(),
    }
}

/// Writes files that must not exist yet, all of them or none.
fn write_all_new(files: &[(PathBuf, String)], template: &Template) -> Result<(), CommandError> {
    for (index, (path, text)) in files.iter().enumerate() {
        let written = write_new(path, text.as_bytes());
        if let Err(error) = written {
            for (path, _) in &files[..index] {
                // The first error is the one to report.
                let _ = std::fs::remove_file(path);
            }
            return Err(match error {
                FolderError::Exists { path } => exists(&path, template),
                FolderError::Unwritable { cause, .. } => CommandError::Write {
                    path: path.display().to_string(),
                    cause: cause.to_string(),
                },
                other => CommandError::Write {
                    path: path.display().to_string(),
                    cause: other.to_string(),
                },
            });
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::host::HOST;
    use stickslip_experiment::Experiment;
    use stickslip_scene::Scene;

    #[test]
    fn every_template_is_valid_as_it_stands() {
        let crates = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/.."));
        let none = &[] as &[&str];
        let scene = |text: &str, name: &str| {
            let folder = crates.join("scene/src/templates");
            Scene::from_text_on(text, Format::Toml, name, &folder, none, HOST)
                .map(|scene| (scene.title, scene.description))
        };
        let experiment = |text: &str, name: &str| {
            let folder = crates.join("experiment/src/templates");
            Experiment::from_text(text, Format::Toml, name, &folder, none, HOST)
                .map(|experiment| (experiment.title, experiment.description))
        };
        let scenes = SCENES.iter().map(|own| (own, scene(own.text, own.name)));
        let experiments = EXPERIMENTS
            .iter()
            .map(|own| (own, experiment(own.text, own.name)));
        for (template, checked) in scenes.chain(experiments) {
            let (title, description) =
                checked.unwrap_or_else(|error| panic!("{}", error.render(100, false)));
            let comments = template.text.lines().filter(|line| line.contains('#'));
            assert!(comments.count() >= 8, "{}: comments", template.name);
            assert!(description.is_some() && title != template.name);
        }
    }
}
