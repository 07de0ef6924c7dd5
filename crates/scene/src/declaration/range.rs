//! Ranges of values.

use serde_json::Value;

use crate::units::{Dimension, Expected, parse};

/// What a number, the base value of a quantity or a list must be.
#[derive(Debug, Clone, Copy)]
pub enum Range {
    /// An integer from one to another.
    Counts(u32, u32),
    /// A list that is not empty, and what messages allow.
    Filled(&'static str),
    /// A number for which `holds`.
    Numbers {
        /// As tables show it, after the type.
        shown: &'static str,
        /// As messages say it.
        allowed: &'static str,
        /// Whether a number in base units is allowed.
        holds: fn(f64) -> bool,
    },
}

/// Greater than 0.
pub const POSITIVE: Range = numbers(" > 0", "greater than 0", |value| value > 0.0);

/// From `first` to `last`.
pub const fn counts(first: u32, last: u32) -> Range {
    Range::Counts(first, last)
}

/// A list with an entry.
pub(crate) const fn filled(allowed: &'static str) -> Range {
    Range::Filled(allowed)
}

/// Numbers for which `holds`; tables show them as `shown` after the type, and messages say what is `allowed`.
pub const fn numbers(shown: &'static str, allowed: &'static str, holds: fn(f64) -> bool) -> Range {
    Range::Numbers {
        shown,
        allowed,
        holds,
    }
}

impl Range {
    /// As tables show it, after the type.
    pub(crate) fn shown(self) -> String {
        match self {
            Self::Counts(first, last) => format!(" from {first} to {last}"),
            Self::Filled(_) => String::new(),
            Self::Numbers { shown, .. } => shown.to_owned(),
        }
    }

    /// Whether it is about a list and not about its entries.
    pub(crate) fn is_of_lists(self) -> bool {
        matches!(self, Self::Filled(_))
    }

    /// The value as written and what is allowed, of a value outside.
    pub(crate) fn refusal(self, value: &Value) -> Option<(String, String)> {
        let (number, text) = match value {
            Value::Array(list) => (list.len() as f64, "[]".to_owned()),
            Value::String(text) => {
                let (number, _) = parse(text, &Expected::any(&Dimension::ALL)).ok()?;
                (number, text.clone())
            }
            Value::Number(number) => (number.as_f64()?, number.to_string()),
            _ => return None,
        };
        let (holds, allowed) = match self {
            Self::Counts(first, last) => (
                (f64::from(first)..=f64::from(last)).contains(&number),
                format!("from {first} to {last}"),
            ),
            Self::Filled(allowed) => (number > 0.0, allowed.to_owned()),
            Self::Numbers { allowed, holds, .. } => (holds(number), allowed.to_owned()),
        };
        (!holds).then_some((text, allowed))
    }
}
