//! A misspelt key of a document, shown at its line with a remedy, and the column where it stands.
//!
//! Run with `cargo run --release -p stickslip-document --example places`.

use stickslip_document::diagnostic::{SceneError, SceneProblem, SourceText};
use stickslip_document::document::{Document, Format, Part};

fn main() -> Result<(), SceneError> {
    let text = "[mesh]\nspacing = \"2 deg\"\nlayres = 7\n";
    let source = SourceText {
        name: "pin.toml".into(),
        text: text.into(),
    };
    let document = Document::parse(source, Format::Toml)?;
    let problem = SceneProblem::unknown_key("layres", ["layers", "spacing"]);
    let finding = document.finding("mesh.layres", Part::Key, problem);
    let column = finding.position().map_or(0, |(_, column)| column);
    print!("{}", SceneError::new(finding, []).render(80, false));
    println!("column {column}");
    Ok(())
}
