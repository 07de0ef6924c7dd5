//! Documents in TOML and JSON whose values know where they were written, what can be wrong with the scene in one, and the seam to the machine.
//!
//! Every value of a [`Document`](document::Document) keeps the bytes of its key and its own. A problem at a key becomes a
//! [`Finding`](diagnostic::Finding), and all that was found a [`SceneError`](diagnostic::SceneError), which shows lines and remedies. Files,
//! time and the memory that reading may take come through a [`Host`](host::Host).
//!
//! ```
//! use stickslip_document::diagnostic::{SceneProblem, SourceText};
//! use stickslip_document::document::{Document, Format, Part};
//!
//! let text = "[mesh]\nlayres = 7\n";
//! let source = SourceText { name: "pin.toml".into(), text: text.into() };
//! let document = Document::parse(source, Format::Toml)?;
//! assert_eq!(document.get("mesh.layres"), Some(&7.into()));
//! let problem = SceneProblem::unknown_key("layres", ["layers", "spacing"]);
//! let finding = document.finding("mesh.layres", Part::Key, problem);
//! assert_eq!(finding.position(), Some((2, 1)));
//! # Ok::<(), stickslip_document::diagnostic::SceneError>(())
//! ```

pub mod diagnostic;
pub mod document;
pub mod host;
pub mod limits;

/// The crates whose values documents are made of, whose diagnostics errors are, and whose errors they hold.
pub use {miette, serde_json, stickslip_fem_core, stickslip_laminate, stickslip_units};
