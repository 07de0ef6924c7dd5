//! Files of other programs where a scene is expected, and scenes that name them.

use std::io;
use std::path::Path;

use stickslip_mesh_files::{Coincident, Foreign, Format, Imported, ReadError, read_with};
use thiserror::Error;

use crate::diagnostic::SceneProblem;
use crate::host::Host;
use crate::limits::Content;

/// A scene of a mesh that is held and pulled at two of its edges.
const EXAMPLE: &str = include_str!("foreign/part.toml");

/// Why there is no mesh of a file.
#[derive(Debug, Error)]
#[error(transparent)]
enum ImportedError {
    File(#[from] io::Error),
    Mesh(#[from] ReadError),
}

/// That the file at `path` is `foreign`, with a scene that names it.
pub(crate) fn problem(path: &Path, foreign: Foreign, host: Host) -> SceneProblem {
    let [file, stem] =
        [path.file_name(), path.file_stem()].map(|part| part.unwrap_or_default().to_string_lossy());
    let format = foreign.format.unwrap_or(Format::Gmsh);
    let named = if Format::of_name(&file) == Some(format) {
        file.to_string()
    } else {
        format!("{stem}.{}", format.extension())
    };
    let read = foreign.format.map(|format| imported(path, format, host));
    let (edges, sets) = match &read {
        None => (Vec::new(), String::new()),
        Some(Err(cause)) => {
            let refused = format!("The file cannot be used as it is: {cause}.");
            (Vec::new(), refused)
        }
        Some(Ok(mesh)) => (mesh.edge_names(), mesh.describe_sets()),
    };
    let to_do = match read {
        None => foreign.export().to_owned() + " ",
        Some(_) if file != named => format!("rename it to '{named}', and "),
        Some(_) => String::new(),
    };
    let ends = [
        edges.first().unwrap_or(&"left"),
        edges.get(1..).and_then(<[_]>::last).unwrap_or(&"right"),
    ];
    let example = (EXAMPLE.replace("part.inp", &named))
        .replace("part.left", &format!("part.{}", ends[0]))
        .replace("part.right", &format!("part.{}", ends[1]));
    SceneProblem::Foreign {
        path: path.display().to_string(),
        what: foreign.what,
        remedy: format!(
            "{to_do}write a scene that names it, with your thickness, material and unit:\n\n{example}\n{sets}"
        ),
    }
}

/// The mesh of a file, otherwise why there is none.
fn imported(path: &Path, format: Format, host: Host) -> Result<Imported, ImportedError> {
    let text = host.read_text(path, Content::Table)?;
    let include = |name: &str| host.read_included(path, name, Content::Table);
    Ok(read_with(&text, format, &include, Coincident::Allow)?)
}
