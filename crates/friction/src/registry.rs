//! The laws that are linked into the program, with their parameters and dimensions.
//!
//! The crate takes plain numbers, but a file may give a length as "0.001 in". Whoever reads the file must know which
//! parameter is a length before it can hand over a number; each law says so here:
//!
//! ```
//! use stickslip_friction::{Dimension, laws};
//!
//! let lengths: Vec<_> = laws()
//!     .flat_map(|law| law.parameters.iter().map(move |parameter| (law.name, parameter)))
//!     .filter(|(_, parameter)| parameter.dimension == Dimension::Length)
//!     .map(|(law, parameter)| (law, parameter.path))
//!     .collect();
//! assert!(lengths.contains(&("slip_power", "slip_scale")));
//! ```
//!
//! A law registers with `inventory::submit!`; see [`law`](crate::law) for an example.

use std::fmt;

/// Dimension, or kind, of a parameter of a law.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Dimension {
    /// A bare number.
    Dimensionless,
    /// A length.
    Length,
    /// A pressure or a stress.
    Stress,
    /// An angle; laws take radians.
    Angle,
    /// A word.
    Text,
    /// `true` or `false`.
    Flag,
    /// Another friction law, written as a law is: `fibre.coulomb = { mu = 0.1 }`.
    Law,
}

impl fmt::Display for Dimension {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.pad(match self {
            Self::Dimensionless => "dimensionless",
            Self::Length => "length",
            Self::Stress => "stress",
            Self::Angle => "angle",
            Self::Text => "text",
            Self::Flag => "flag",
            Self::Law => "friction law",
        })
    }
}

/// One parameter of a law.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ParameterInfo {
    /// Where the parameter stands below the law's name: a dot enters a table, `[]` every entry of a list. Examples:
    /// `mu`, `kernel.swept.kappa`, `plies[].angle`.
    pub path: &'static str,
    /// Dimension of the value.
    pub dimension: Dimension,
    /// The value taken when none is given, as a file would write it; `None` if the parameter cannot be left out.
    pub default: Option<&'static str>,
    /// What the parameter means, with its range.
    pub meaning: &'static str,
}

/// The constructor is the dimension; a parameter must be given unless [`or`](Self::or) says what stands for it.
impl ParameterInfo {
    const fn new(dimension: Dimension, path: &'static str, meaning: &'static str) -> Self {
        Self {
            path,
            dimension,
            default: None,
            meaning,
        }
    }

    /// A bare number.
    pub const fn number(path: &'static str, meaning: &'static str) -> Self {
        Self::new(Dimension::Dimensionless, path, meaning)
    }

    /// A length.
    pub const fn length(path: &'static str, meaning: &'static str) -> Self {
        Self::new(Dimension::Length, path, meaning)
    }

    /// A pressure or a stress.
    pub const fn stress(path: &'static str, meaning: &'static str) -> Self {
        Self::new(Dimension::Stress, path, meaning)
    }

    /// An angle.
    pub const fn angle(path: &'static str, meaning: &'static str) -> Self {
        Self::new(Dimension::Angle, path, meaning)
    }

    /// A word.
    pub const fn text(path: &'static str, meaning: &'static str) -> Self {
        Self::new(Dimension::Text, path, meaning)
    }

    /// `true` or `false`.
    pub const fn flag(path: &'static str, meaning: &'static str) -> Self {
        Self::new(Dimension::Flag, path, meaning)
    }

    /// Another friction law.
    pub const fn law(path: &'static str, meaning: &'static str) -> Self {
        Self::new(Dimension::Law, path, meaning)
    }

    /// The same parameter with the value taken when none is given, as a file would write it.
    #[must_use]
    pub const fn or(self, default: &'static str) -> Self {
        Self {
            default: Some(default),
            ..self
        }
    }
}

/// What a user must know of a law in order to name it in a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct LawInfo {
    /// Name of the law in files, the same as that given to `typetag`.
    pub name: &'static str,
    /// The law in one line.
    pub summary: &'static str,
    /// Its parameters; every value that a file may hold below the law's name has an entry.
    pub parameters: &'static [ParameterInfo],
}

inventory::collect!(LawInfo);

/// All registered laws by name, those of other crates included.
pub fn laws() -> impl Iterator<Item = &'static LawInfo> {
    let mut sorted: Vec<_> = inventory::iter::<LawInfo>.into_iter().collect();
    // The order of registration is the linker's.
    sorted.sort_by_key(|law| law.name);
    sorted.into_iter()
}

/// The registered law of that name.
pub fn find(name: &str) -> Option<&'static LawInfo> {
    inventory::iter::<LawInfo>
        .into_iter()
        .find(|law| law.name == name)
}
