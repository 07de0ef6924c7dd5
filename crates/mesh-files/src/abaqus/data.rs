//! Data lines: nodes, elements, and members of sets and surfaces.

use std::cmp::Ordering;

use super::Reader;
use super::card::{Card, entries, unquoted};
use super::definitions::{Definition, Entry, Family};
use super::types;
use crate::error::{ReadError, Unsupported};
use crate::lines;
use crate::place::{Files, Spot};
use crate::raw::{RawBlock, Shape};

/// What the next data line belongs to.
#[derive(Clone, Debug)]
pub(super) enum Data {
    /// No keyword that has data lines.
    Nothing,
    /// No keyword yet.
    Unbegun,
    /// A keyword that is passed over.
    Skipped,
    /// A keyword of the assembly that is passed over.
    OfAssembly,
    /// The translation and rotation of an instance.
    Placement,
    /// Nodes, put into a set.
    Nodes { set: Option<usize> },
    /// Elements of one type, put into a set.
    Elements(Elements),
    /// Members of a set.
    Members(Members),
    /// Faces of elements.
    Faces { surface: usize },
}

/// How the members of a set are given.
#[derive(Clone, Copy, Debug)]
pub(super) struct Members {
    set: usize,
    is_generated: bool,
    /// Whether numbers are those of the assembly itself, and passed over.
    is_outside: bool,
}

/// The elements of a keyword.
#[derive(Clone, Debug)]
pub(super) struct Elements {
    type_name: String,
    shape: Result<Shape, Unsupported>,
    set: Option<usize>,
    block: u64,
    /// The element whose nodes continue on the next line.
    open: Vec<u64>,
    spot: Spot,
}

impl Elements {
    /// Takes the numbers of a line: of the element, unless it is open, and of its nodes.
    fn take_numbers(&mut self, line: &str, spot: Spot, files: &Files) -> Result<(), ReadError> {
        if self.open.is_empty() {
            self.spot = spot;
        }
        for entry in entries(line).filter(|entry| !entry.is_empty()) {
            let number = lines::integer(entry).ok_or_else(|| ReadError::Value {
                at: files.place(spot),
                what: "the number of an element or node",
                found: shortened(entry),
            })?;
            self.shape.map_err(|why| ReadError::ElementType {
                at: files.place(spot),
                element: number,
                name: self.type_name.clone(),
                why,
            })?;
            self.open.push(number);
        }
        Ok(())
    }
}

/// The beginning of what a message quotes.
fn shortened(text: &str) -> String {
    text.chars().take(40).collect()
}

impl Reader<'_> {
    pub(super) fn node(&mut self, card: &Card, spot: Spot) -> Result<(), ReadError> {
        if self.assembly.is_outside() {
            self.data = Data::OfAssembly;
            return Ok(());
        }
        let system = card.value("SYSTEM");
        if system.is_some_and(|system| !system.eq_ignore_ascii_case("R")) {
            return Err(ReadError::Generated {
                at: self.place(spot),
                keyword: "NODE, SYSTEM".to_owned(),
            });
        }
        let name = card.value("NSET").filter(|name| !name.is_empty());
        let set = name.map(|name| self.define(Family::Nodes, name, card, spot));
        self.data = Data::Nodes { set };
        self.input(card, spot)
    }

    pub(super) fn element(&mut self, card: &Card, spot: Spot) -> Result<(), ReadError> {
        if self.assembly.is_outside() {
            self.data = Data::OfAssembly;
            return Ok(());
        }
        let type_name = self.parameter(card, "TYPE", spot)?;
        let name = card.value("ELSET").filter(|name| !name.is_empty());
        let set = name.map(|name| self.define(Family::Elements, name, card, spot));
        let next = self.blocks.len() as u64;
        let block = *self.blocks.entry(set).or_insert(next);
        if block == next {
            let name = set.and_then(|set| self.definitions.list.get(set));
            let name = name.map_or("cells", |set| set.name.as_str()).to_owned();
            self.raw.blocks.push(RawBlock { name, rank: block });
        }
        self.data = Data::Elements(Elements {
            shape: types::shape(&type_name),
            type_name,
            set,
            block,
            open: Vec::new(),
            spot,
        });
        self.input(card, spot)
    }

    /// Reads the data lines of another file.
    fn input(&mut self, card: &Card, spot: Spot) -> Result<(), ReadError> {
        match card.value("INPUT") {
            Some(name) if !name.is_empty() => self.include(name, spot),
            _ => Ok(()),
        }
    }

    pub(super) fn set(&mut self, card: &Card, spot: Spot) -> Result<(), ReadError> {
        let (family, parameter) = match card.keyword.as_str() {
            "NSET" => (Family::Nodes, "NSET"),
            _ => (Family::Elements, "ELSET"),
        };
        let name = self.parameter(card, parameter, spot)?;
        if let (Some(named), Some(only)) = (card.value("INSTANCE"), &self.assembly.instance)
            && !named.eq_ignore_ascii_case(only)
        {
            return Err(ReadError::Assembly {
                at: self.place(spot),
                what: format!("set '{name}' belongs to instance '{named}', which is not '{only}'"),
            });
        }
        let set = self.define(family, &name, card, spot);
        // Without an instance, numbers at the level of the assembly are those of its own nodes and elements.
        let is_outside = self.assembly.is_outside() && !card.has("INSTANCE");
        if let Some(set) = self.definitions.list.get_mut(set) {
            set.partial |= is_outside;
        }
        self.data = Data::Members(Members {
            set,
            is_generated: card.has("GENERATE"),
            is_outside,
        });
        Ok(())
    }

    pub(super) fn surface(&mut self, card: &Card, spot: Spot) -> Result<(), ReadError> {
        let name = self.parameter(card, "NAME", spot)?;
        let kind = card.value("TYPE").unwrap_or("ELEMENT");
        if kind.eq_ignore_ascii_case("ELEMENT") {
            let surface = self.define(Family::Surface, &name, card, spot);
            self.data = Data::Faces { surface };
        } else if kind.eq_ignore_ascii_case("NODE") {
            let set = self.define(Family::NodeSurface, &name, card, spot);
            self.data = Data::Members(Members {
                set,
                is_generated: false,
                is_outside: false,
            });
        } else {
            self.skip(card, spot);
        }
        Ok(())
    }

    fn define(&mut self, family: Family, name: &str, card: &Card, spot: Spot) -> usize {
        self.definitions
            .instance
            .clone_from(&self.assembly.instance);
        self.definitions.define(Definition {
            family,
            name: name.to_owned(),
            of_assembly: self.assembly.is_outside(),
            internal: card.has("INTERNAL"),
            spot,
            partial: false,
        })
    }

    pub(super) fn data_line(&mut self, line: &str, spot: Spot) -> Result<(), ReadError> {
        match &mut self.data {
            Data::Unbegun => Err(ReadError::Format {
                at: self.place(spot),
                format: "Abaqus",
                found: shortened(line),
            }),
            Data::Nothing => Err(self.unexpected("a keyword", line, spot)),
            Data::Skipped => Ok(()),
            Data::OfAssembly => {
                let at = self.place(spot);
                self.assembly.pass(at);
                Ok(())
            }
            Data::Placement => {
                let entries = entries(line).filter(|entry| !entry.is_empty());
                let numbers = entries.map(lines::real);
                self.assembly
                    .placement(numbers, || self.raw.files.place(spot))
            }
            &mut Data::Nodes { set } => self.node_line(line, set, spot),
            Data::Elements(_) => self.element_line(line, spot),
            &mut Data::Members(members) if members.is_generated => {
                self.generate_line(line, members, spot)
            }
            &mut Data::Members(members) => {
                self.member_line(line, members, spot);
                Ok(())
            }
            &mut Data::Faces { surface } => self.face_line(line, surface, spot),
        }
    }

    fn unexpected(&self, what: &'static str, found: &str, spot: Spot) -> ReadError {
        ReadError::Value {
            at: self.place(spot),
            what,
            found: shortened(found),
        }
    }

    fn integer(&self, what: &'static str, entry: &str, spot: Spot) -> Result<u64, ReadError> {
        lines::integer(entry).ok_or_else(|| self.unexpected(what, entry, spot))
    }

    fn node_line(&mut self, line: &str, set: Option<usize>, spot: Spot) -> Result<(), ReadError> {
        let mut entries = entries(line);
        let number = entries.next().unwrap_or_default();
        let number = self.integer("the number of a node", number, spot)?;
        // Coordinates that are left out are 0.
        let mut at = [0.0; 3];
        for (value, entry) in at.iter_mut().zip(entries) {
            if !entry.is_empty() {
                let read = lines::real(entry);
                *value = read.ok_or_else(|| self.unexpected("a coordinate", entry, spot))?;
            }
        }
        self.raw.add_node(number, at, spot)?;
        if let Some(set) = set {
            let entry = Entry::Run(number, number);
            self.definitions.add(set, spot, entry, true);
        }
        Ok(())
    }

    fn element_line(&mut self, line: &str, spot: Spot) -> Result<(), ReadError> {
        let Data::Elements(elements) = &mut self.data else {
            return Ok(());
        };
        let files = &self.raw.files;
        elements.take_numbers(line, spot, files)?;
        let Ok(shape) = elements.shape else {
            return Ok(());
        };
        let wanted = shape.nodes() + 1;
        if elements.open.len() < wanted && line.ends_with(',') {
            return Ok(());
        }
        let at = || files.place(spot);
        match elements.open.len().cmp(&wanted) {
            Ordering::Less => {
                let what = "a node of the element";
                return Err(ReadError::MissingValue { at: at(), what });
            }
            Ordering::Greater => {
                let what = "the end of the element's nodes";
                let found = shortened(line);
                return Err(ReadError::Value {
                    at: at(),
                    what,
                    found,
                });
            }
            Ordering::Equal => {}
        }
        let (set, block, start) = (elements.set, elements.block, elements.spot);
        if let Some((&number, nodes)) = elements.open.split_first() {
            self.raw
                .add_element(number, shape, nodes, [block, block], start);
            if let Some(set) = set {
                let entry = Entry::Run(number, number);
                self.definitions.add(set, spot, entry, true);
            }
        }
        elements.open.clear();
        Ok(())
    }

    /// Ends the data of a keyword.
    ///
    /// # Errors
    /// [`ReadError::MissingValue`] inside an element.
    pub(super) fn close(&mut self, spot: Spot) -> Result<(), ReadError> {
        match &self.data {
            Data::Elements(elements) if !elements.open.is_empty() => Err(ReadError::MissingValue {
                at: self.place(spot),
                what: "a node of the element before this line",
            }),
            _ => Ok(()),
        }
    }

    fn generate_line(&mut self, line: &str, to: Members, spot: Spot) -> Result<(), ReadError> {
        let mut entries = entries(line).filter(|entry| !entry.is_empty());
        let mut next = |what| match entries.next() {
            Some(entry) => self.integer(what, entry, spot).map(Some),
            None => Ok(None),
        };
        let missing = |what| ReadError::MissingValue {
            at: self.place(spot),
            what,
        };
        let first = next("the first number")?.ok_or_else(|| missing("the first number"))?;
        let last = next("the last number")?.ok_or_else(|| missing("the last number"))?;
        let step = next("the step")?.unwrap_or(1);
        if step == 0 || last < first {
            return Err(self.unexpected("first, last and step of an ascending range", line, spot));
        }
        self.add_or_pass(to, spot, Entry::Generate([first, last, step]));
        Ok(())
    }

    /// Adds numbers, unless they are those of the assembly.
    fn add_or_pass(&mut self, to: Members, spot: Spot, entry: Entry) {
        if to.is_outside {
            let at = self.place(spot);
            self.assembly.pass(at);
        } else {
            self.definitions.add(to.set, spot, entry, false);
        }
    }

    fn member_line(&mut self, line: &str, to: Members, spot: Spot) {
        let set = self.definitions.list.get(to.set);
        // Behind a node of a surface stands its area.
        let most = match set {
            Some(set) if set.family == Family::NodeSurface => 1,
            _ => usize::MAX,
        };
        for entry in entries(line).take(most).filter(|entry| !entry.is_empty()) {
            let name = unquoted(entry);
            let of_part = self.definitions.without_instance(name);
            let named = Entry::Named(name.to_owned());
            match lines::integer(of_part.unwrap_or(name)) {
                Some(number) if of_part.is_none() => {
                    self.add_or_pass(to, spot, Entry::Run(number, number));
                }
                Some(number) => {
                    let entry = Entry::Run(number, number);
                    self.definitions.add(to.set, spot, entry, false);
                }
                None => self.definitions.add(to.set, spot, named, false),
            }
        }
    }

    fn face_line(&mut self, line: &str, surface: usize, spot: Spot) -> Result<(), ReadError> {
        let mut entries = entries(line);
        let target = unquoted(entries.next().unwrap_or_default());
        if target.is_empty() {
            let what = "an element or element set";
            return Err(ReadError::MissingValue {
                at: self.place(spot),
                what,
            });
        }
        let face = match entries.next().unwrap_or_default() {
            "" => None,
            label => {
                Some(face(label).ok_or_else(|| self.unexpected("a face, S1 to S4", label, spot))?)
            }
        };
        let number = self.definitions.without_instance(target).unwrap_or(target);
        let entry = match lines::integer(number) {
            Some(number) => Entry::Face(number, face),
            None => Entry::Faces(target.to_owned(), face),
        };
        self.definitions.add(surface, spot, entry, false);
        Ok(())
    }
}

/// The local edge of a face "S1" to "S4".
fn face(label: &str) -> Option<usize> {
    let number = label.strip_prefix(['S', 's'])?;
    let number = lines::integer(number).filter(|number| (1..=4).contains(number))?;
    Some(number as usize - 1)
}
