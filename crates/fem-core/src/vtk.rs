//! Fields on meshes as VTK XML files.
//!
//! [`write_vtu`] writes one unstructured grid, [`write_pvd`] a list of such files with their times. Arrays are inline base64
//! of a 64-bit byte count and the little-endian numbers, so values survive to the last bit. Points have z = 0. The format is
//! that of *VTK File Formats* (Kitware).

mod base64;
mod pvd;
mod vtu;

use std::io;

use thiserror::Error;

pub use pvd::{PvdEntry, write_pvd};
pub use vtu::{Field, write_vtu};

/// Why a file was not written.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum VtkError {
    /// The output refused.
    #[error("the VTK output could not be written")]
    Io(#[from] io::Error),
    /// A field has a number of components outside 1 … 9.
    #[error("field '{field}' has {components} components; 1 to 9 are possible")]
    Components {
        /// Name of the field.
        field: String,
        /// Number of components.
        components: usize,
    },
    /// A field does not match the mesh.
    #[error(
        "field '{field}' has {found} values; {entities} {what} with {components} components need {expected}"
    )]
    Length {
        /// Name of the field.
        field: String,
        /// Number of values given.
        found: usize,
        /// "nodes" or "cells".
        what: &'static str,
        /// How many of them the mesh has.
        entities: usize,
        /// Number of components.
        components: usize,
        /// Number of values needed.
        expected: usize,
    },
    /// Two point fields, or two cell fields, have the same name.
    #[error("field '{field}' is given twice")]
    Duplicate {
        /// Name of the field.
        field: String,
    },
    /// A text holds a control character, which XML cannot carry, or a field has no name.
    #[error("'{}' cannot be used as a name in a VTK file", text.escape_debug())]
    Name {
        /// The text.
        text: String,
    },
    /// A time that is NaN or infinite.
    #[error("time {time} of file '{file}' is not finite")]
    Time {
        /// The time, in the unit given.
        time: f64,
        /// The file it belongs to.
        file: String,
    },
}

/// Text for an attribute value.
fn escaped(text: &str) -> Result<String, VtkError> {
    if text.is_empty() || text.chars().any(char::is_control) {
        return Err(VtkError::Name {
            text: text.to_owned(),
        });
    }
    let mut escaped = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => escaped.push_str("&amp;"),
            '<' => escaped.push_str("&lt;"),
            '>' => escaped.push_str("&gt;"),
            '"' => escaped.push_str("&quot;"),
            _ => escaped.push(c),
        }
    }
    Ok(escaped)
}
