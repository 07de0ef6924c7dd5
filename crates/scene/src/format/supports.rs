//! Supports and platens as a file spells them.

use serde::{Deserialize, Serialize};

use crate::declaration::{
    NONE, POSITIVE, REQUIRED, Table, angle, bed_stiffness, filled, length, set, spring_stiffness,
    words,
};
use crate::schema::Axis;
use crate::units::{Angle, BedStiffness, Length, Quantity, SpringStiffness};

#[derive(Debug, Clone, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct SupportFormat {
    pub(crate) on: String,
    pub(crate) fix: Option<Vec<Axis>>,
    pub(crate) normal: Option<Quantity<Angle>>,
    pub(crate) displacement: Option<Quantity<Length>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) stiffness: Option<Quantity<SpringStiffness>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) bed: Option<Quantity<BedStiffness>>,
}

#[derive(Debug, Clone, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct PlatenFormat {
    pub(crate) on: String,
    pub(crate) free: Vec<Axis>,
}

#[rustfmt::skip]
pub(crate) const TABLES: &[Table] = &[
    Table::new("supports", &[
        set("on", REQUIRED, r#""plate.left""#, "edge, point, or area, whose mean displacement is held by a reaction that is spread evenly over it"),
        words("fix", r#"list of `"x"`, `"y"`"#, "required, or `normal`", r#"["x"]"#,
            "axes along which the nodes are held").range(filled(r#"["x"], ["y"] or ["x", "y"]"#)),
        angle("normal", NONE, r#""30 deg""#, "one direction, from +x, along which the nodes are held; across it they slide"),
        length("displacement", "0", r#""0.01 mm""#,
            "displacement along that one axis or direction, reached at the end of the first load step and kept"),
        spring_stiffness("stiffness", NONE, r#""500 N/mm""#,
            "springs to the ground instead, along each axis or direction: of the whole edge, over which it is spread evenly, or of a point").range(POSITIVE),
        bed_stiffness("bed", NONE, r#""20 MPa/mm""#, "the same of an edge, per area").range(POSITIVE),
    ]).one_of(&[&["fix"], &["normal"]], r#"fix = ["x", "y"], normal = "30 deg""#),
    Table::new("platens", &[
        set("on", REQUIRED, r#""plate.left""#, "the edge"),
        words("free", r#"list of `"x"`, `"y"`"#, REQUIRED, r#"["x", "y"]"#,
            "axes along which it moves freely; along the others it is held, `[]` holds it"),
    ]),
];
