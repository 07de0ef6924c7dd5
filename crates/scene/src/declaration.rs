//! What is declared of a key and of a table of keys; the declarations are in [`keys`](crate::keys) and in the files of shapes.

pub(crate) mod choices;
mod kind;
mod range;

use serde_json::Value;

use crate::document::child;

pub use self::kind::Kind;
pub(crate) use self::kind::{
    angle, angles, bed_stiffness, described, energy, expansion, flag, force, forces, integer,
    length, lengths, lists, names, number, set, spacing, spring_stiffness, stress, stresses, table,
    table_as, tables_of, temperature, temperatures, text,
};
pub(crate) use self::range::filled;
pub use self::range::{POSITIVE, Range, counts, numbers};

/// The default of a key that must be there.
pub(crate) const REQUIRED: &str = "required";
/// The default of a key without which there is nothing of the kind.
pub(crate) const NONE: &str = "–";

/// One key of a table.
#[derive(Debug, Clone, Copy)]
pub struct Key {
    /// Its name.
    pub name: &'static str,
    /// Its type.
    pub kind: Kind,
    /// What holds where it is left out, as text or as a value in backticks.
    pub default: &'static str,
    /// What it means.
    pub meaning: &'static str,
    example: &'static str,
    noted: &'static str,
    range: Option<Range>,
}

impl Key {
    /// Checks its value, or each entry of its list, against `range`.
    pub(crate) const fn range(mut self, range: Range) -> Self {
        self.range = Some(range);
        self
    }

    /// Adds a range that is checked with other values.
    pub(crate) const fn noted(mut self, noted: &'static str) -> Self {
        self.noted = noted;
        self
    }

    /// An example as a scene writes it, `spacing = "2 deg"`; `None` of tables that have keys of their own.
    pub fn assignment(&self) -> Option<String> {
        let (name, example) = (self.name, self.example);
        match example.chars().next() {
            None => None,
            Some('.') => Some(format!("{name}{example}")),
            Some(_) => Some(format!("{name} = {example}")),
        }
    }

    /// Its type with its range: `length > 0`.
    pub fn type_text(&self) -> String {
        let range = self.range.map(Range::shown).unwrap_or_default();
        format!("{}{range}{}", self.kind, self.noted)
    }

    /// Its name with its range, if it has one.
    pub(crate) fn ranged(&self) -> Option<(&'static str, Range)> {
        Some((self.name, self.range?))
    }

    /// Whether it must be there, at least under some condition.
    pub fn is_required(&self) -> bool {
        self.default.starts_with(REQUIRED)
    }
}

/// A table of keys.
#[derive(Debug, Clone, Copy)]
pub struct Table {
    /// Where it stands, with `NAME` for any name: `materials.NAME.isotropic`; empty for the scene itself.
    pub path: &'static str,
    /// Its keys.
    pub keys: &'static [Key],
    pub(crate) exclusive: Option<Exclusive>,
    /// Whether it holds exactly one entry, named after the choice, which an override replaces.
    pub(crate) is_choice: bool,
}

/// Keys of a table of which exactly one is given.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Exclusive {
    /// Each key with those that stand beside it alone.
    pub(crate) groups: &'static [&'static [&'static str]],
    /// The choices as a message lists them.
    pub(crate) choices: &'static str,
    /// Whether the table may leave out all of them.
    pub(crate) optional: bool,
}

impl Exclusive {
    /// The keys.
    pub(crate) fn names(&self) -> Vec<&'static str> {
        self.groups.iter().map(|group| group[0]).collect()
    }
}

impl Table {
    /// The table at `path`.
    pub(crate) const fn new(path: &'static str, keys: &'static [Key]) -> Self {
        Self {
            path,
            keys,
            exclusive: None,
            is_choice: false,
        }
    }

    /// The same table, which holds exactly one entry.
    pub(crate) const fn choice(mut self) -> Self {
        self.is_choice = true;
        self
    }

    /// The same table, in which exactly one of the first keys of `groups` is given, as messages list their `choices`.
    pub(crate) const fn one_of(
        mut self,
        groups: &'static [&'static [&'static str]],
        choices: &'static str,
    ) -> Self {
        self.exclusive = Some(Exclusive {
            groups,
            choices,
            optional: false,
        });
        self
    }

    /// The same table, in which one of the first keys of `groups` is given, or none.
    pub(crate) const fn at_most_one_of(
        self,
        groups: &'static [&'static [&'static str]],
        choices: &'static str,
    ) -> Self {
        let mut own = self.one_of(groups, choices);
        if let Some(exclusive) = &mut own.exclusive {
            exclusive.optional = true;
        }
        own
    }

    /// Whether this is the table at `path`, in which entries of lists have their index.
    pub(crate) fn stands_at(&self, path: &str) -> bool {
        let is_index = |name: &&str| name.parse::<usize>().is_ok();
        let mut given = path.split('.').filter(|name| !name.is_empty()).peekable();
        for own in self.path.split('.').filter(|name| !name.is_empty()) {
            let fits = |name: &&str| own == "NAME" || own == *name;
            given.next_if(|name| !fits(name) && is_index(name));
            if given.next_if(fits).is_none() {
                return false;
            }
        }
        given.all(|name| is_index(&name))
    }
}

/// The same keys with another default.
pub(crate) const fn with_default<const N: usize>(
    mut keys: [Key; N],
    default: &'static str,
) -> [Key; N] {
    let mut index = 0;
    while index < N {
        keys[index].default = default;
        index += 1;
    }
    keys
}

/// The default of a table that is one of `count` choices.
pub(crate) const fn one_of_the(count: usize) -> &'static str {
    const CHOICES: [&str; 10] = [
        "",
        "the only one",
        "one of the two",
        "one of the three",
        "one of the four",
        "one of the five",
        "one of the six",
        "one of the seven",
        "one of the eight",
        "one of the nine",
    ];
    CHOICES[count]
}

/// The tables at `path` below `root`, with their keys.
pub fn tables_at<'v>(path: &str, root: &'v Value) -> Vec<(String, &'v Value)> {
    let mut found = vec![(String::new(), root)];
    for segment in path.split('.').filter(|segment| !segment.is_empty()) {
        let below = |(key, value): (String, &'v Value)| entries(&key, value, segment);
        found = found.into_iter().flat_map(below).collect();
    }
    found.retain(|(_, value)| value.is_object());
    found
}

/// The values of the table `given` at `place` that are outside of their ranges: key, value as written, what is allowed.
pub fn outside(
    place: &str,
    given: &Value,
    ranges: impl Iterator<Item = (&'static str, Range)>,
) -> Vec<[String; 3]> {
    let of_key = |(name, range): (&str, Range)| {
        let values = match given.get(name) {
            Some(value) if range.is_of_lists() => vec![(child(place, name), value)],
            Some(value) => each(child(place, name), value),
            None => Vec::new(),
        };
        let refused = values.into_iter().filter_map(move |(key, value)| {
            let (value, allowed) = range.refusal(value)?;
            Some([key, value, allowed])
        });
        refused.collect::<Vec<_>>()
    };
    ranges.flat_map(of_key).collect()
}

/// What `value` has at `segment`: any entry at `NAME`, and of a list each entry.
fn entries<'v>(key: &str, value: &'v Value, segment: &str) -> Vec<(String, &'v Value)> {
    let Value::Object(map) = value else {
        return Vec::new();
    };
    let fits = map
        .iter()
        .filter(|(name, _)| segment == "NAME" || *name == segment);
    fits.flat_map(|(name, value)| each(child(key, name), value))
        .collect()
}

/// The value, or the entries of a list.
fn each(key: String, value: &Value) -> Vec<(String, &Value)> {
    match value {
        Value::Array(list) => {
            let entry = |(index, value)| (child(&key, index), value);
            list.iter().enumerate().map(entry).collect()
        }
        value => vec![(key, value)],
    }
}
