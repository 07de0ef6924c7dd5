//! Parts, instances and assemblies: one part with one instance at its place is as good as a flat file.

use super::card::Card;
use super::data::Data;
use crate::error::ReadError;
use crate::note::Note;
use crate::place::Place;

/// Where in the structure of parts and instances the file is.
#[derive(Debug, Default)]
pub(super) struct Assembly {
    parts: usize,
    instances: usize,
    /// Name of the instance.
    pub(super) instance: Option<String>,
    is_open: bool,
    in_instance: bool,
    /// Lines that belong to the assembly: the first and how many.
    passed: Option<(Place, usize)>,
}

impl Assembly {
    /// Whether nodes, elements and sets belong to the assembly itself.
    pub(super) fn is_outside(&self) -> bool {
        self.is_open && !self.in_instance
    }

    /// What data lines behind the last structural keyword are.
    pub(super) fn data(&self) -> Data {
        if self.in_instance {
            Data::Placement
        } else {
            Data::Nothing
        }
    }

    /// Takes note of a line that was passed over.
    pub(super) fn pass(&mut self, at: Place) {
        self.passed.get_or_insert((at, 0)).1 += 1;
    }

    pub(super) fn note(self) -> Option<Note> {
        let (at, count) = self.passed?;
        Some(Note::OfAssembly { at, count })
    }

    /// Follows a structural keyword; false for all others.
    ///
    /// # Errors
    /// [`ReadError::Assembly`] for a second part or instance.
    pub(super) fn keyword(
        &mut self,
        card: &Card,
        at: impl Fn() -> Place,
    ) -> Result<bool, ReadError> {
        match card.keyword.as_str() {
            "PART" => {
                self.parts += 1;
                let name = card.value("NAME").unwrap_or_default();
                only(self.parts, "part", name, at)?;
            }
            "INSTANCE" => {
                self.instances += 1;
                self.in_instance = true;
                let name = card.value("NAME").unwrap_or_default();
                self.instance.get_or_insert_with(|| name.to_owned());
                only(self.instances, "instance", name, at)?;
            }
            "ASSEMBLY" => self.is_open = true,
            "ENDASSEMBLY" => self.is_open = false,
            "ENDINSTANCE" => self.in_instance = false,
            "ENDPART" => {}
            _ => return Ok(false),
        }
        Ok(true)
    }

    /// Checks a data line of `*INSTANCE`: a translation or rotation.
    ///
    /// # Errors
    /// [`ReadError::Assembly`] unless all numbers are 0.
    pub(super) fn placement(
        &self,
        mut entries: impl Iterator<Item = Option<f64>>,
        at: impl Fn() -> Place,
    ) -> Result<(), ReadError> {
        if entries.all(|value| value == Some(0.0)) {
            return Ok(());
        }
        let name = self.instance.as_deref().unwrap_or_default();
        Err(ReadError::Assembly {
            at: at(),
            what: format!("instance '{name}' is moved from the place of its part"),
        })
    }
}

fn only(count: usize, what: &str, name: &str, at: impl Fn() -> Place) -> Result<(), ReadError> {
    if count < 2 {
        return Ok(());
    }
    Err(ReadError::Assembly {
        at: at(),
        what: format!("'{name}' is a second {what}; one part with one instance is read"),
    })
}
