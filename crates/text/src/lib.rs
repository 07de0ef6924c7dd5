//! Text for readers.
//!
//! | module | holds |
//! | --- | --- |
//! | [`dotted`] | keys of nested tables as one text |
//! | [`json`] | where the entries of a JSON text stand |
//! | [`number`] | numbers with a few significant digits, counts with their noun |
//! | [`plain`] | text of others, safe for a terminal, a page, a picture and a spreadsheet |
//!
//! ```
//! use stickslip_text::plain::printable;
//! use stickslip_text::{counted, short, tidy};
//!
//! assert_eq!(format!("{} of {} MPa", counted(2, "step"), short(82.0612)), "2 steps of 82.06 MPa");
//! assert_eq!(tidy(0.1 + 0.2), Some(0.3));
//! assert_eq!(printable("pin\u{1b}[2J"), "pin\\u{1b}[2J");
//! ```

pub mod dotted;
pub mod json;
pub mod number;
pub mod plain;

pub use number::{counted, decimals, short, significant, tidy};
