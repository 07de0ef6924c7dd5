//! Results as files, figures, one page and a table for the terminal.
//!
//! | file | holds |
//! | --- | --- |
//! | `summary.json` | the numbers that other programs read |
//! | `report.html` | everything for a reader, in one self-contained page |
//! | `scene.toml` | the scene with all defaults filled in |
//! | `steps.csv` | one row per load step |
//! | `edge-NAME-step-NN.csv` | tractions, gaps, slip, status and stresses along an edge |
//! | `failure-BODY.csv`, `first-ply-BODY.csv`, `plies-NAME-step-NN.csv`, … | failure of laminates, where the scene asks for it |
//! | `load-displacement-BODY.csv`, `damage-BODY-PLY.csv` | progressive failure of a joint, where the scene asks for it |
//! | `results.pvd`, `fields/*.vtu` | displacement and stress fields for ParaView |
//! | `meshes/*.msh`, `meshes/*.inp` | meshes for other programs, where the scene asks for them |
//! | `figures/*.svg`, `figures/*.png` | the page's figures |
//!
//! Everything is in the scene's display units, and every heading names its unit.

mod attempt;
mod bypass;
mod choices;
mod consistency;
mod csv_files;
mod display;
mod error;
mod failure;
mod fasteners;
mod figures;
mod files;
mod findings;
mod mesh_files;
mod names;
mod page;
mod problem;
mod progressive;
mod quantities;
mod quantity;
mod sets;
mod sharing;
mod stresses;
mod summary;
mod tables;
pub use error::OutputError;
pub use figures::sketch::{SketchBody, sketch};
pub use findings::{findings_json, joint_sentence, quoted, sentence, sentences};
pub use tables::signs;
mod vtk_files;
mod zones;

use stickslip_fem_core::parallel;

use crate::PutFile;

use consistency::check;
use figures::Drawing;
use files::{File, FileNote};
use stickslip_results::Results;

/// Makes all files of `results`, hands them to `put`, several at a time, and returns the text of `summary.json`, which belongs last. Figures
/// are drawn if `figures` says so; one that cannot be drawn is named in the summary's notes and on the page.
///
/// # Errors
/// [`OutputError::Inconsistent`], [`OutputError::NoEntry`] and [`OutputError::NoBody`] for results that do not fit together,
/// [`OutputError::Put`] if a file is refused; the other variants name the file that could not be made.
pub fn write(results: &Results, figures: bool, put: &PutFile<'_>) -> Result<String, OutputError> {
    check(results)?;
    let (tables, pictures) = parallel::join(
        || write_tables(results, put),
        || write_pictures(results, put, figures),
    );
    let (mut notes, (drawings, failures)) = (tables?, pictures?);
    if !drawings.is_empty() {
        notes.push(FileNote::new(
            "figures/*.svg, figures/*.png",
            "the figures of this page",
        ));
    }
    let page = page::page(results, drawings, &failures, &notes)?.render()?;
    put("report.html", page.as_bytes())?;
    let mut summary = summary::summary(results);
    summary.notes.extend(failures);
    Ok(serde_json::to_string_pretty(&summary)? + "\n")
}

/// Writes tables and fields.
fn write_tables(results: &Results, put: &PutFile<'_>) -> Result<Vec<FileNote>, OutputError> {
    let mut notes = Vec::new();
    if !results.scene.is_empty() {
        put("scene.toml", results.scene.as_bytes())?;
        notes.push(FileNote::new("scene.toml", "the scene with all defaults filled in; data files that it names are relative to its first folder"));
    }
    notes.extend(csv_files::files(results, put)?);
    let (fields, field_notes) = vtk_files::files(results)?;
    notes.extend(field_notes);
    let (meshes, mesh_note) = mesh_files::files(results)?;
    notes.extend(mesh_note);
    for (name, bytes) in fields.iter().chain(&meshes) {
        put(name, bytes)?;
    }
    Ok(notes)
}

/// Draws the figures if they are wanted, and writes them side by side; returns them and a line for each that cannot be drawn.
fn write_pictures(
    results: &Results,
    put: &PutFile<'_>,
    figures: bool,
) -> Result<(Vec<Drawing>, Vec<String>), OutputError> {
    if !figures {
        return Ok((Vec::new(), Vec::new()));
    }
    let (drawings, failures) = figures::draw(results)?;
    let written = parallel::map(&drawings, |drawing| {
        let name = format!("figures/{}", drawing.name);
        put(&format!("{name}.svg"), drawing.picture.as_str().as_bytes())?;
        put(&format!("{name}.png"), &drawing.png)
    });
    written.into_iter().collect::<Result<(), _>>()?;
    Ok((drawings, failures))
}

/// The content of `summary.json`, described in `docs/summary-format.md`.
///
/// # Errors
/// [`OutputError::Inconsistent`], [`OutputError::NoEntry`] and [`OutputError::NoBody`] for results that do not fit together.
pub fn summary_json(results: &Results) -> Result<serde_json::Value, OutputError> {
    check(results)?;
    Ok(serde_json::to_value(summary::summary(results))?)
}

/// The load steps as a table for a terminal of `width` columns, which leaves columns out, the least needed first, rather than break
/// numbers.
///
/// # Errors
/// As [`summary_json`].
pub fn summary_table(results: &Results, width: usize) -> Result<String, OutputError> {
    check(results)?;
    Ok(tables::terminal(results, width))
}

/// What every quantity's sign means, as a table for the terminal.
pub fn signs_table() -> String {
    tables::signs_table().to_text(Some(120))
}
