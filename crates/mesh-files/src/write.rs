//! Meshes as files of other programs.

mod inp;
mod msh;

use stickslip_fem_core::mesh::Mesh;

pub use inp::write_inp;
pub use msh::write_msh;

use crate::error::WriteError;

/// Names of all sets and blocks.
fn names(mesh: &Mesh) -> impl Iterator<Item = &str> {
    let blocks = mesh.blocks().iter().map(|block| block.name.as_str());
    blocks
        .chain(mesh.node_set_names())
        .chain(mesh.edge_set_names())
        .chain(mesh.element_set_names())
}

/// Refuses names that no format can quote.
fn check_names(mesh: &Mesh) -> Result<(), WriteError> {
    for name in names(mesh) {
        let why = if name.trim().is_empty() {
            "is empty"
        } else if name.contains(['"', '\n', '\r']) {
            "has a quote or a line end in it"
        } else if name.trim() != name {
            "begins or ends with a blank"
        } else {
            continue;
        };
        let name = name.to_owned();
        return Err(WriteError::Name { name, why });
    }
    Ok(())
}
