//! Text for readers.
//!
//! | module | holds |
//! | --- | --- |
//! | [`number`] | numbers with a few significant digits, counts with their noun |
//! | [`plain`] | text of others, safe for a terminal, a page, a picture and a spreadsheet |

pub mod number;
pub mod plain;

pub use number::{counted, decimals, short, significant, tidy};
