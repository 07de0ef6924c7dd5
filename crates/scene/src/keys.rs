//! Every key of a scene, declared once: its type and unit, its default, an example, what excludes it and what it means.
//!
//! | from the declarations come    | by                                              |
//! |-------------------------------|-------------------------------------------------|
//! | tables of `scene-format.md`   | [`document()`], written by `cargo xtask docs`   |
//! | `stickslip list keys`         | [`tables()`]                                    |
//! | examples of missing keys      | [`Key::assignment`]                             |
//! | checks of ranges and choices  | `build/declared.rs`                             |
//!
//! A new key is a field of a table and a row of its `TABLES`, both in the table's file below `schema`, where its value becomes a number. Shapes bring their own rows.
//!
//! A key of meshes is one row for `mesh` and `bodies.NAME.mesh`. Beside its field and its row it needs what makes it part of a mesh: the
//! compiler asks for it in the same file, where a body's settings are made of its own and the scene's and where a mesh is made coarser; the shapes that use it name it in [`mesh_keys`](crate::shape::Outline::mesh_keys); of others it is refused.

mod document;
#[cfg(test)]
mod tests;

use crate::declaration::{Key, Table};
use crate::schema::{
    analysis, body, contact, failure, fastener, loads, mesh, output, progressive, supports,
};
use crate::{format, material, shape};

pub use self::document::{DocumentError, document};

/// Every table of a scene, each before those inside it.
pub fn tables() -> impl Iterator<Item = Table> {
    let own = [
        format::TABLES,
        analysis::TABLES,
        material::TABLES,
        body::TABLES,
        mesh::TABLES,
        contact::TABLES,
        supports::TABLES,
        fastener::TABLES,
        loads::TABLES,
        failure::TABLES,
        progressive::TABLES,
        output::TABLES,
    ];
    let own = own.into_iter().flatten().copied();
    own.chain(shape::tables())
}

/// The table at `path`, `loads.0.force`.
pub(crate) fn table_at(path: &str) -> Option<Table> {
    tables().find(|table| table.stands_at(path))
}

/// The declaration of `key`, given in full: `bodies.plate.thickness`.
pub(crate) fn declared(key: &str) -> Option<&'static Key> {
    let (path, name) = key.rsplit_once('.').unwrap_or(("", key));
    let keys = table_at(path)?.keys;
    keys.iter().find(|own| own.name == name)
}
