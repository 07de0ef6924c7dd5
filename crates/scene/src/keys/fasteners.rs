//! Fasteners.

use crate::declaration::{
    POSITIVE, REQUIRED, Table, filled, force, lengths, table, table_as, words,
};

const ENDS: &str = r#"`"free"`, `"clamped"`"#;

#[rustfmt::skip]
pub(super) const TABLES: &[Table] = &[
    Table::new("fasteners.NAME", &[
        words("slices", "list of bodies", REQUIRED, r#"["bolt-1", "bolt-2", "bolt-3"]"#,
            "its disks, one in each plate and as thick as it, in the order of the layers").range(filled("two or more disks")),
        table_as("springs", REQUIRED, ".beam = {}", "what couples the slices"),
    ]),
    Table::new("fasteners.NAME.springs", &[
        table_as("rigid", "one of the three", "{}", "nothing gives: the slices move and turn as one; without keys"),
        table("beam", "one of the three", "the shank as a beam of the slices' material, in shear, bending and torsion"),
        table("given", "one of the three", "a displacement between each slice and the next; all turn as one"),
    ]).choice(),
    Table::new("fasteners.NAME.springs.beam", &[
        words("head", ENDS, r#"`"free"`"#, r#""clamped""#, "whether the outer face of the first slice may tilt"),
        words("nut", ENDS, r#"`"free"`"#, r#""clamped""#, "whether the outer face of the last slice may tilt"),
    ]),
    Table::new("fasteners.NAME.springs.given", &[
        force("force", REQUIRED, r#""1 kN""#, "a force that one slice hands to the next").range(POSITIVE),
        lengths("displacements", REQUIRED, r#"["0.01 mm", "0.01 mm"]"#,
            "by how much that moves each slice against the next, one number fewer than slices").range(POSITIVE),
    ]),
];
