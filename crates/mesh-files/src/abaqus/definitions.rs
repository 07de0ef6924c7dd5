//! Sets and surfaces as the file defines them, before their members are looked up.

use std::collections::BTreeMap;

use crate::place::Spot;

/// What the members of a definition are.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Family {
    Nodes,
    Elements,
    /// `*SURFACE, TYPE=NODE`.
    NodeSurface,
    /// `*SURFACE, TYPE=ELEMENT`.
    Surface,
}

impl Family {
    /// Word for messages.
    pub(super) fn word(self) -> &'static str {
        match self {
            Self::Nodes | Self::NodeSurface => "node",
            Self::Elements => "element",
            Self::Surface => "edge",
        }
    }
}

/// A set or surface.
#[derive(Clone, Debug)]
pub(super) struct Definition {
    pub(super) family: Family,
    /// Its first spelling.
    pub(super) name: String,
    /// Whether it belongs to the assembly, not to its part.
    pub(super) of_assembly: bool,
    /// Whether the file hides it (INTERNAL).
    pub(super) internal: bool,
    pub(super) spot: Spot,
    /// Whether some of its members belong to the assembly and were passed over.
    pub(super) partial: bool,
}

/// What a line adds to a definition.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Entry {
    /// All numbers from the first to the second, which must exist.
    Run(u64, u64),
    /// The numbers first, first + step, … last, as far as they exist.
    Generate([u64; 3]),
    /// The members of another set.
    Named(String),
    /// A face of an element, or all free faces.
    Face(u64, Option<usize>),
    /// A face of all elements of a set, or all free faces.
    Faces(String, Option<usize>),
}

/// An entry and the definition that it is added to.
#[derive(Clone, Debug)]
pub(super) struct Addition {
    pub(super) to: usize,
    pub(super) spot: Spot,
    pub(super) entry: Entry,
}

/// All definitions of a file, and what is added to them in the order of the file.
#[derive(Debug, Default)]
pub(super) struct Definitions {
    index: BTreeMap<(Family, bool, String), usize>,
    pub(super) list: Vec<Definition>,
    pub(super) additions: Vec<Addition>,
    /// Name of the instance, which may stand before names of sets and numbers.
    pub(super) instance: Option<String>,
}

impl Definitions {
    /// The definition of this name, made if there is none.
    pub(super) fn define(&mut self, new: Definition) -> usize {
        let key = (new.family, new.of_assembly, new.name.to_uppercase());
        let next = self.list.len();
        let k = *self.index.entry(key).or_insert(next);
        if k == next {
            self.list.push(new);
        }
        k
    }

    /// Adds to the definition `to`. Consecutive numbers of one line, or numbers that are known to exist, become one run.
    pub(super) fn add(&mut self, to: usize, spot: Spot, entry: Entry, is_known: bool) {
        if let Entry::Run(number, end) = entry
            && let Some(last) = self.additions.last_mut()
            && last.to == to
            && (is_known || last.spot == spot)
            && let Entry::Run(_, last) = &mut last.entry
            && last.checked_add(1) == Some(number)
        {
            *last = end;
            return;
        }
        self.additions.push(Addition { to, spot, entry });
    }

    /// The set of this name that a definition may name: one of the assembly first, if it belongs to it.
    pub(super) fn find(&self, family: Family, of_assembly: bool, name: &str) -> Option<usize> {
        let get = |of_assembly: bool, name: &str| {
            let key = (family, of_assembly, name.to_uppercase());
            self.index.get(&key).copied()
        };
        let own = of_assembly.then(|| get(true, name)).flatten();
        let own = own.or_else(|| get(false, name));
        own.or_else(|| get(false, self.without_instance(name)?))
    }

    /// The name or number behind "instance.".
    pub(super) fn without_instance<'a>(&self, name: &'a str) -> Option<&'a str> {
        let (head, rest) = name.split_once('.')?;
        let instance = self.instance.as_deref()?;
        head.eq_ignore_ascii_case(instance).then_some(rest)
    }
}
