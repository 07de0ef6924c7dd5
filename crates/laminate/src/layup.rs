//! Lay-up notation: the stack of a laminate as one line of text.
//!
//! ```text
//! lay-up  =  "[" item { "/" item } "]" [ "_" repeats ] [ "s" ]       ( ) serve as [ ]
//! item    =  lay-up  |  [ "+" | "-" | "±" | "∓" ] degrees [ "_" count ] [ "~" ] [ ":" ply ]
//! ```
//!
//! | text                 | stack, bottom to top                    |
//! |----------------------|-----------------------------------------|
//! | `[0/90]`             | 0, 90                                   |
//! | `[0_2/90]`           | 0, 0, 90                                |
//! | `[0/±45/90]s`        | 0, 45, −45, 90, 90, −45, 45, 0          |
//! | `[0/90]_2s`          | 0, 90, 0, 90, 90, 0, 90, 0              |
//! | `[0/45/90~]s`        | 0, 45, 90, 45, 0                        |
//! | `[(±45)_2/0]`        | 45, −45, 45, −45, 0                     |
//! | `[0:carbon/90:glass]`| 0 of ply "carbon", 90 of ply "glass"    |
//!
//! Angles are real numbers in degrees, counter-clockwise from x. The first angle named is the bottom ply, at z = −h/2. The mark
//! `~` stands for the bar over an angle: the mid-plane goes through this ply, half of which belongs to each side, so an odd
//! number of plies can be symmetric. `+-` and `+/-` read as `±`; spaces, the minus sign U+2212, subscript digits, a combining
//! overline and `°` are understood; a trailing `t` ("total") changes nothing. `±45_2` is refused, for it has two readings.
//!
//! [`Layup`]'s text form is the notation in the table; reading it gives an equal lay-up.

mod error;
mod parse;

use std::fmt;
use std::str::FromStr;

pub use error::LayupError;

/// Largest number of plies of a lay-up.
pub const MAXIMUM_PLIES: usize = 100_000;

/// One ply of a stack.
#[derive(Clone, Debug, PartialEq)]
pub struct StackedPly {
    /// Angle of the fibres `[degree]`, counter-clockwise from x.
    pub angle: f64,
    /// Name of the ply, where the lay-up gives one.
    pub ply: Option<String>,
}

/// A lay-up: its notation and the stack that it means.
#[derive(Clone, Debug, PartialEq)]
pub struct Layup {
    root: Group,
    stack: Vec<StackedPly>,
}

impl Layup {
    /// The plies from bottom (z = −h/2) to top; never empty.
    pub fn stack(&self) -> &[StackedPly] {
        &self.stack
    }
}

impl FromStr for Layup {
    type Err = LayupError;

    /// Reads the notation of the [module](self).
    ///
    /// # Errors
    /// A [`LayupError`] that names the place and the way out.
    fn from_str(text: &str) -> Result<Self, LayupError> {
        let root = parse::parse(text)?;
        if root.size().is_none_or(|plies| plies > MAXIMUM_PLIES) {
            return Err(LayupError::TooManyPlies {
                layup: text.to_owned(),
                limit: MAXIMUM_PLIES,
            });
        }
        let stack = root.stack();
        Ok(Self { root, stack })
    }
}

impl fmt::Display for Layup {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.root.write(f, ['[', ']'])
    }
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Sign {
    Single,
    PlusMinus,
    MinusPlus,
}

#[derive(Clone, Debug, PartialEq)]
struct Plies {
    sign: Sign,
    angle: f64,
    count: usize,
    /// The mid-plane goes through this ply.
    shared: bool,
    ply: Option<String>,
}

#[derive(Clone, Debug, PartialEq)]
enum Item {
    Plies(Plies),
    Group(Group),
}

#[derive(Clone, Debug, PartialEq)]
struct Group {
    items: Vec<Item>,
    repeats: usize,
    symmetric: bool,
}

impl Plies {
    fn size(&self) -> Option<usize> {
        let angles = if self.sign == Sign::Single { 1 } else { 2 };
        self.count.checked_mul(angles)
    }

    fn push_to(&self, stack: &mut Vec<StackedPly>) {
        let angles: &[f64] = match self.sign {
            Sign::Single => &[self.angle],
            Sign::PlusMinus => &[self.angle, -self.angle],
            Sign::MinusPlus => &[-self.angle, self.angle],
        };
        for _ in 0..self.count {
            stack.extend(angles.iter().map(|&angle| StackedPly {
                // -0 would read as another angle than 0.
                angle: angle + 0.0,
                ply: self.ply.clone(),
            }));
        }
    }
}

impl Group {
    /// Number of plies, `None` on overflow.
    fn size(&self) -> Option<usize> {
        let mut once = 0_usize;
        for item in &self.items {
            once = once.checked_add(match item {
                Item::Plies(plies) => plies.size()?,
                Item::Group(group) => group.size()?,
            })?;
        }
        let half = once.checked_mul(self.repeats)?;
        half.checked_mul(if self.symmetric { 2 } else { 1 })
    }

    fn stack(&self) -> Vec<StackedPly> {
        let mut once = Vec::new();
        for item in &self.items {
            match item {
                Item::Plies(plies) => plies.push_to(&mut once),
                Item::Group(group) => once.extend(group.stack()),
            }
        }
        let mut stack = vec![once; self.repeats].concat();
        if self.symmetric {
            let shared = matches!(self.items.last(), Some(Item::Plies(plies)) if plies.shared);
            let mirrored = stack.len() - usize::from(shared);
            let upper: Vec<_> = stack[..mirrored].iter().rev().cloned().collect();
            stack.extend(upper);
        }
        stack
    }

    fn write(&self, f: &mut fmt::Formatter<'_>, [open, close]: [char; 2]) -> fmt::Result {
        write!(f, "{open}")?;
        for (index, item) in self.items.iter().enumerate() {
            if index > 0 {
                write!(f, "/")?;
            }
            match item {
                Item::Plies(plies) => plies.write(f)?,
                Item::Group(group) => group.write(f, ['(', ')'])?,
            }
        }
        write!(f, "{close}")?;
        if self.repeats > 1 {
            write!(f, "_{}", self.repeats)?;
        }
        write!(f, "{}", if self.symmetric { "s" } else { "" })
    }
}

impl Plies {
    fn write(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let sign = match self.sign {
            Sign::Single => "",
            Sign::PlusMinus => "±",
            Sign::MinusPlus => "∓",
        };
        write!(f, "{sign}{}", self.angle)?;
        if self.count > 1 {
            write!(f, "_{}", self.count)?;
        }
        if self.shared {
            write!(f, "~")?;
        }
        self.ply.as_ref().map_or(Ok(()), |ply| write!(f, ":{ply}"))
    }
}
