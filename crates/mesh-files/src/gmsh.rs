//! Files of Gmsh: MSH 2.2 and 4.1 as text.
//!
//! A file is a list of sections `$Name` … `$EndName`. Numbers are separated by blanks and line ends alike, as Gmsh itself reads them;
//! counts in headers are checked by reading, and nothing is reserved for them.
//!
//! Source: Gmsh reference manual, sections "MSH file format" and "MSH file format version 2 (Legacy)".

mod groups;
mod tokens;
mod types;
mod version2;
mod version4;

use std::collections::BTreeMap;

use crate::assemble::{Rules, assemble};
use crate::error::ReadError;
use crate::imported::{Coincident, Imported};
use crate::note::Note;
use crate::place::Place;
use crate::raw::Raw;
use groups::Groups;
use tokens::{Tokens, place};
pub(crate) use types::number_of;

/// The layouts of nodes and elements.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Version {
    Two,
    Four,
}

/// A file while it is read.
#[derive(Debug, Default)]
struct Reader {
    raw: Raw,
    groups: Groups,
    /// Sections that say nothing about the mesh.
    skipped: BTreeMap<String, (Place, usize)>,
}

/// Reads a mesh of Gmsh.
///
/// # Errors
/// [`ReadError`].
pub(crate) fn read(text: &str, coincident: Coincident) -> Result<Imported, ReadError> {
    let mut tokens = Tokens::new(text);
    let version = header(&mut tokens)?;
    let mut reader = Reader::default();
    while let Some(name) = tokens.section()? {
        reader.section(name, version, &mut tokens)?;
    }
    let end = tokens.spot();
    let Reader {
        mut raw,
        mut groups,
        skipped,
    } = reader;
    groups.finish(&mut raw);
    let skipped = skipped.into_iter();
    raw.notes
        .extend(skipped.map(|(keyword, (at, count))| Note::Skipped { keyword, at, count }));
    let mut file = raw.number(end)?;
    let sets = groups.sets(&mut file);
    let rules = Rules {
        coincident,
        edges_from_nodes: false,
        merge_twins: version == Version::Two,
    };
    assemble(file, &sets, rules)
}

/// Reads `$MeshFormat`.
fn header(tokens: &mut Tokens<'_>) -> Result<Version, ReadError> {
    let section = tokens.section()?;
    let at = || place(tokens.spot());
    match section {
        Some("MeshFormat") => {}
        // The format of Gmsh 1 begins with its nodes.
        Some("NOD") => {
            let version = "1".to_owned();
            return Err(ReadError::Version { at: at(), version });
        }
        found => {
            return Err(ReadError::Format {
                at: at(),
                format: "Gmsh",
                found: found.map_or_else(String::new, |name| format!("${name}")),
            });
        }
    }
    let version = tokens.token("the version of the format")?;
    let at = place(tokens.spot());
    let known = match version {
        "2" | "2.0" | "2.1" | "2.2" => Version::Two,
        "4.1" => Version::Four,
        other => {
            let version = other.to_owned();
            return Err(ReadError::Version { at, version });
        }
    };
    if tokens.integer("the file type, 0 for text")? != 0 {
        return Err(ReadError::Binary { at });
    }
    tokens.integer("the size of numbers")?;
    tokens.end("MeshFormat")?;
    Ok(known)
}

impl Reader {
    fn section(
        &mut self,
        name: &str,
        version: Version,
        tokens: &mut Tokens<'_>,
    ) -> Result<(), ReadError> {
        match (name, version) {
            ("PhysicalNames", _) => self.groups.read_names(tokens)?,
            ("Entities", Version::Four) => version4::entities(tokens, &mut self.groups)?,
            ("PartitionedEntities", _) => {
                let at = place(tokens.spot());
                return Err(ReadError::Partitioned { at });
            }
            ("Nodes", Version::Two) => version2::nodes(tokens, &mut self.raw)?,
            ("Nodes", Version::Four) => version4::nodes(tokens, &mut self.raw)?,
            ("Elements", Version::Two) => {
                version2::elements(tokens, &mut self.raw, &mut self.groups)?;
            }
            ("Elements", Version::Four) => {
                version4::elements(tokens, &mut self.raw, &mut self.groups)?;
            }
            (other, _) => return self.skip(other, tokens),
        }
        tokens.end(name)
    }

    fn skip(&mut self, name: &str, tokens: &mut Tokens<'_>) -> Result<(), ReadError> {
        let at = place(tokens.spot());
        tokens.skip(name)?;
        if name != "Comments" {
            let keyword = format!("${name}");
            self.skipped.entry(keyword).or_insert((at, 0)).1 += 1;
        }
        Ok(())
    }
}
