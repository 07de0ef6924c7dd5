//! Shapes of bodies: one file each, and the list of them all.
//!
//! | file             | in scenes                              | body                                              |
//! |------------------|----------------------------------------|---------------------------------------------------|
//! | [`Strip`]        | `shape.plate_with_hole.outline.strip`  | a rectangular plate around a hole                 |
//! | [`Ring`]         | `shape.plate_with_hole.outline.ring`   | a plate between two circles                       |
//! | [`Disk`]         | `shape.disk`                           | a pin                                             |
//! | [`Profile`]      | `shape.outline`                        | lines, arcs and splines with any number of holes  |
//! | [`GivenMesh`]    | `shape.mesh`                           | cells of a file                                   |
//! | [`Rectangle`]    | `shape.rectangle`                      | a coupon                                          |
//! | [`Block`]        | `shape.block`                          | stands for the half-plane below a line contact    |
//! | [`Cylinder`]     | `shape.cylinder`                       | the cap above it                                  |
//!
//! A file brings the keys and their checks, and by [`Outline`] the edges and points with their exact curves, the extent, the symmetry,
//! the generator of the mesh and one line of description. The rest of the program does not depend on the shape of a body.

mod block;
mod curve;
mod cylinder;
mod disk;
mod hole;
mod imported;
mod line_contact;
mod note;
mod outline;
pub(crate) mod pattern;
mod profile;
mod rectangle;
mod ring;
mod strip;
#[cfg(test)]
mod tests;

use std::ops::Deref;

use serde::{Deserialize, Serialize};

use self::hole::Hole;
use crate::declaration::{Key, Table, one_of_the, table};
use crate::document::child;
use crate::units::{Length, Quantity};

pub use stickslip_mesher::Path;

pub use self::curve::Curve;
pub use self::note::{FileCurve, FileNote};
pub(crate) use self::outline::Sizes;
pub use self::outline::{CircleFit, Divided, DivisionError, Edge, Meshing, Outline, Role, Touch};

/// Makes everything that lists the shapes: the shape, and its table in scenes.
macro_rules! shapes {
    (
        around a hole: $($hole_key:literal => $hole_file:ident::$Hole:ident,)*
        others: $($key:literal => $file:ident::$Other:ident,)*
    ) => {
        $(pub use self::$hole_file::$Hole;)*
        $(pub use self::$file::$Other;)*

        /// A body's shape; what it brings is its [`Outline`].
        #[derive(Debug, Clone, PartialEq)]
        pub enum Shape {
            $(#[doc = concat!("`plate_with_hole.outline.", $hole_key, "`")] $Hole($Hole),)*
            $(#[doc = concat!("`", $key, "`")] $Other($Other),)*
        }

        impl Deref for Shape {
            type Target = dyn Outline;

            fn deref(&self) -> &Self::Target {
                match self {
                    $(Self::$Hole(own) => own,)*
                    $(Self::$Other(own) => own,)*
                }
            }
        }

        /// `shape.NAME = { … }`.
        #[derive(Debug, Clone, Deserialize, Serialize)]
        pub(crate) enum ShapeFormat {
            #[serde(rename = "plate_with_hole")]
            PlateWithHole(PlateWithHoleFormat),
            $(#[serde(rename = $key)] $Other($file::Keys),)*
        }

        /// `outline.NAME = { … }` of a plate with a hole.
        #[derive(Debug, Clone, Deserialize, Serialize)]
        pub(crate) enum OutlineFormat {
            $(#[serde(rename = $hole_key)] $Hole($hole_file::Keys),)*
        }

        impl ShapeFormat {
            /// Whether it brings a mesh that no setting divides.
            pub(crate) fn has_own_mesh(&self) -> bool {
                let mesh_keys = match self {
                    Self::PlateWithHole(_) => hole::MESH_KEYS,
                    $(Self::$Other(_) => $file::MESH_KEYS,)*
                };
                mesh_keys.is_empty()
            }

            /// The shape that the table `table` of a body describes.
            pub(crate) fn read(&self, table: &str, sizes: &mut dyn Sizes) -> Shape {
                match self {
                    Self::PlateWithHole(given) => given.read(&child(table, hole::NAME), sizes),
                    $(Self::$Other(given) => {
                        Shape::$Other(given.read(&child(table, $key), sizes))
                    })*
                }
            }
        }

        impl OutlineFormat {
            fn read(&self, table: &str, hole: &Hole<'_>, sizes: &mut dyn Sizes) -> Shape {
                match self {
                    $(Self::$Hole(given) => {
                        Shape::$Hole(given.read(&child(table, $hole_key), hole, sizes))
                    })*
                }
            }
        }

        const SHAPE: &str = one_of_the(1 + [$($key),*].len());
        const OUTLINE: &str = one_of_the([$($hole_key),*].len());

        const SHAPES: &[Key] = &[
            table(hole::NAME, SHAPE, hole::MEANING),
            $(table($key, SHAPE, $file::MEANING),)*
        ];

        const OUTLINES: &[Key] = &[$(table($hole_key, OUTLINE, $hole_file::MEANING),)*];

        const TABLES: &[Table] = &[
            Table::new("bodies.NAME.shape", SHAPES).choice(),
            Table::new("bodies.NAME.shape.plate_with_hole", hole::ROWS),
            Table::new("bodies.NAME.shape.plate_with_hole.outline", OUTLINES).choice(),
            $(Table::new(concat!("bodies.NAME.shape.plate_with_hole.outline.", $hole_key), $hole_file::ROWS),)*
            $(Table::new(concat!("bodies.NAME.shape.", $key), $file::ROWS),)*
        ];

        /// An example of each shape, as a scene writes it.
        #[cfg(test)]
        const EXAMPLES: &[&str] = &[$($hole_file::EXAMPLE,)* $($file::EXAMPLE,)*];
    };
}

// The list: key, file and type of each shape, in the order of messages.
shapes! {
    around a hole:
        "strip" => strip::Strip,
        "ring" => ring::Ring,
    others:
        "disk" => disk::Disk,
        "outline" => profile::Profile,
        "mesh" => imported::GivenMesh,
        "rectangle" => rectangle::Rectangle,
        "block" => block::Block,
        "cylinder" => cylinder::Cylinder,
}

/// The tables of keys of all shapes.
pub(crate) fn tables() -> impl Iterator<Item = Table> {
    let own = TABLES.iter().chain(profile::TABLES);
    own.chain(pattern::TABLES).copied()
}

/// `shape.plate_with_hole = { … }`: a hole and what surrounds it.
#[derive(Debug, Clone, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct PlateWithHoleFormat {
    hole_radius: Quantity<Length>,
    outline: OutlineFormat,
}

impl PlateWithHoleFormat {
    fn read(&self, table: &str, sizes: &mut dyn Sizes) -> Shape {
        let Self {
            hole_radius,
            outline,
        } = self;
        let hole = Hole {
            radius: hole_radius.value(),
            text: hole_radius.text(),
        };
        outline.read(&child(table, "outline"), &hole, sizes)
    }
}
