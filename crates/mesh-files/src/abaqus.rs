//! Input files of Abaqus and CalculiX.
//!
//! A keyword line `*KEYWORD, PARAMETER=value, …` is followed by its data lines. Keywords, parameters and names of sets match without
//! regard to case; sets keep the spelling of their first appearance. Keywords that say nothing about the mesh are passed over and
//! noted; those that would generate nodes or elements are refused.
//!
//! Sources: Abaqus Keywords Reference Guide; Dhondt, *CalculiX CrunchiX User's Manual*, "Input deck format".

mod assembly;
mod card;
mod data;
mod definitions;
mod resolve;
mod types;

use std::collections::BTreeMap;
use std::io;

use crate::assemble::{Rules, assemble};
use crate::error::ReadError;
use crate::imported::{Coincident, Imported};
use crate::lines::Lines;
use crate::note::Note;
use crate::place::{Place, Spot};
use crate::raw::Raw;
use assembly::Assembly;
use card::Card;
use data::Data;
use definitions::Definitions;

/// How deeply files may include each other.
const DEEPEST: usize = 32;

/// How many files may be included.
const MOST_FILES: usize = 10_000;

type Includes<'a> = &'a dyn Fn(&str) -> io::Result<String>;

/// A file while it is read.
struct Reader<'a> {
    includes: Includes<'a>,
    raw: Raw,
    definitions: Definitions,
    /// Blocks of cells by the sets that `*ELEMENT` names.
    blocks: BTreeMap<Option<usize>, u64>,
    assembly: Assembly,
    /// What the next data line belongs to.
    data: Data,
    /// First place and number of keywords that were passed over.
    skipped: BTreeMap<String, (Place, usize)>,
    /// Whether the analysis has begun.
    in_step: bool,
    /// How deep the current file is included.
    depth: usize,
    /// Bytes read, which bound the sizes of sets.
    bytes: usize,
}

/// Reads a mesh of Abaqus or CalculiX.
///
/// # Errors
/// [`ReadError`].
pub(crate) fn read(
    text: &str,
    includes: Includes<'_>,
    coincident: Coincident,
) -> Result<Imported, ReadError> {
    let mut reader = Reader {
        includes,
        raw: Raw::default(),
        definitions: Definitions::default(),
        blocks: BTreeMap::new(),
        assembly: Assembly::default(),
        data: Data::Unbegun,
        skipped: BTreeMap::new(),
        in_step: false,
        depth: 0,
        bytes: 0,
    };
    let end = reader.text(text, 0)?;
    reader.close(end)?;
    let Reader {
        mut raw,
        definitions,
        assembly,
        skipped,
        bytes,
        ..
    } = reader;
    let skipped = skipped.into_iter();
    raw.notes
        .extend(skipped.map(|(keyword, (at, count))| Note::Skipped { keyword, at, count }));
    raw.notes.extend(assembly.note());
    let mut file = raw.number(end)?;
    let sets = resolve::sets(&mut file, &definitions, bytes)?;
    let rules = Rules {
        coincident,
        edges_from_nodes: true,
        merge_twins: false,
    };
    assemble(file, &sets, rules)
}

impl Reader<'_> {
    fn place(&self, spot: Spot) -> Place {
        self.raw.files.place(spot)
    }

    /// Reads the lines of one file, and returns the last. The data of a keyword may go on in the next file.
    fn text(&mut self, text: &str, file: u32) -> Result<Spot, ReadError> {
        self.bytes = self.bytes.saturating_add(text.len());
        let mut lines = Lines::new(text);
        while let Some(line) = lines.next() {
            let number = lines.number();
            let spot = Spot { file, line: number };
            if line.is_empty() || line.starts_with("**") {
                continue;
            }
            if !line.starts_with('*') {
                self.data_line(line, spot)?;
                continue;
            }
            let mut whole = line.to_owned();
            while whole.ends_with(',') {
                let Some(next) = lines.next() else { break };
                whole.push_str(next);
            }
            let card = Card::parse(&whole);
            if card.keyword == "INCLUDE" {
                // Data lines may go on in the included file, and behind it.
                let name = self.parameter(&card, "INPUT", spot)?;
                self.include(&name, spot)?;
                continue;
            }
            self.close(spot)?;
            self.data = Data::Nothing;
            self.keyword(&card, spot)?;
        }
        Ok(Spot {
            file,
            line: lines.number().max(1),
        })
    }

    fn keyword(&mut self, card: &Card, spot: Spot) -> Result<(), ReadError> {
        if self.in_step {
            self.in_step = card.keyword != "ENDSTEP";
            self.skip(card, spot);
            return Ok(());
        }
        if self.assembly.keyword(card, || self.raw.files.place(spot))? {
            self.data = self.assembly.data();
            return Ok(());
        }
        match card.keyword.as_str() {
            "NODE" => self.node(card, spot)?,
            "ELEMENT" => self.element(card, spot)?,
            "NSET" | "ELSET" => self.set(card, spot)?,
            "SURFACE" => self.surface(card, spot)?,
            "NGEN"
            | "NFILL"
            | "NCOPY"
            | "NMAP"
            | "ELGEN"
            | "ELCOPY"
            | "SYSTEM"
            | "SYMMETRICMODELGENERATION" => {
                return Err(ReadError::Generated {
                    at: self.place(spot),
                    keyword: card.shown.clone(),
                });
            }
            "HEADING" => self.data = Data::Skipped,
            other => {
                self.in_step = other == "STEP";
                self.skip(card, spot);
            }
        }
        Ok(())
    }

    fn skip(&mut self, card: &Card, spot: Spot) {
        let first = self.raw.files.place(spot);
        let keyword = format!("*{}", card.shown.to_uppercase());
        self.skipped.entry(keyword).or_insert((first, 0)).1 += 1;
        self.data = Data::Skipped;
    }

    /// The value of a parameter that must be there.
    fn parameter(
        &self,
        card: &Card,
        parameter: &'static str,
        spot: Spot,
    ) -> Result<String, ReadError> {
        match card.value(parameter) {
            Some(value) if !value.is_empty() => Ok(value.to_owned()),
            _ => Err(ReadError::MissingParameter {
                at: self.place(spot),
                keyword: card.shown.clone(),
                parameter,
            }),
        }
    }

    fn include(&mut self, name: &str, spot: Spot) -> Result<(), ReadError> {
        let failed = |cause: String| ReadError::Include {
            at: self.place(spot),
            file: name.to_owned(),
            cause,
        };
        if self.depth >= DEEPEST || self.raw.files.len() >= MOST_FILES {
            return Err(failed("files include each other too often".to_owned()));
        }
        let text = (self.includes)(name).map_err(|cause| failed(cause.to_string()))?;
        let file = self.raw.files.add(name);
        self.depth += 1;
        self.text(&text, file)?;
        self.depth -= 1;
        Ok(())
    }
}
