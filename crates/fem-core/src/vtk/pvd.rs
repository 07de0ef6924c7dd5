//! Collections of files over time.

use std::io::Write;

use super::{VtkError, escaped};

/// One file of a collection.
#[derive(Clone, Debug, PartialEq)]
pub struct PvdEntry {
    /// Time, in any unit, or load step.
    pub time: f64,
    /// Number of the part among the files of the same time, such as the body.
    pub part: usize,
    /// Path of the file relative to the collection.
    pub file: String,
}

/// Writes a ParaView collection of `entries` to `out`.
///
/// # Errors
/// [`VtkError::Time`] or [`VtkError::Name`] for an entry, [`VtkError::Io`] from `out`.
pub fn write_pvd<W: Write>(entries: &[PvdEntry], mut out: W) -> Result<(), VtkError> {
    writeln!(out, "<?xml version=\"1.0\"?>")?;
    writeln!(
        out,
        "<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">"
    )?;
    writeln!(out, "<Collection>")?;
    for PvdEntry { time, part, file } in entries {
        if !time.is_finite() {
            return Err(VtkError::Time {
                time: *time,
                file: file.clone(),
            });
        }
        let file = escaped(file)?;
        writeln!(
            out,
            "<DataSet timestep=\"{time}\" group=\"\" part=\"{part}\" file=\"{file}\"/>"
        )?;
    }
    writeln!(out, "</Collection>")?;
    writeln!(out, "</VTKFile>")?;
    out.flush()?;
    Ok(())
}
