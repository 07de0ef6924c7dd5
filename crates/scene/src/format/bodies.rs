//! Bodies, and how they are divided, as a file spells them.

use serde::{Deserialize, Serialize};
use stickslip_fem_core::mesh::ElementKind;

use crate::declaration::choices::quoted;
use crate::declaration::{
    Key, NONE, POSITIVE, REQUIRED, Range, Table, angle, angles, flag, integer, length, names,
    numbers, spacing, table, table_as, with_default, words,
};
use crate::schema::BodyModel;
use crate::shape::ShapeFormat;
use crate::shape::pattern::{self, PatternFormat};
use crate::units::{Angle, AngleOrLength, Length, Quantity};

#[derive(Debug, Clone, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct BodyFormat {
    pub(crate) material: Option<String>,
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub(crate) rigid: bool,
    pub(crate) thickness: Option<Quantity<Length>>,
    pub(crate) shape: ShapeFormat,
    pub(crate) position: Option<[Quantity<Length>; 2]>,
    pub(crate) angle: Option<Quantity<Angle>>,
    #[serde(default, skip_serializing_if = "BodyModel::is_auto")]
    pub(crate) model: BodyModel,
    pub(crate) mesh: Option<MeshFormat>,
    pub(crate) pattern: Option<PatternFormat>,
}

/// `[mesh]`, or what differs from it in `[bodies.NAME.mesh]`.
#[derive(Debug, Clone, Default, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct MeshFormat {
    pub(crate) element: Option<ElementKind>,
    pub(crate) spacing: Option<Quantity<AngleOrLength>>,
    pub(crate) angles: Option<Vec<Quantity<Angle>>>,
    pub(crate) fine_to: Option<Quantity<AngleOrLength>>,
    pub(crate) coarse_spacing: Option<Quantity<AngleOrLength>>,
    pub(crate) layers: Option<usize>,
}

/// `[mesh]`.
#[rustfmt::skip]
const MESH: [Key; 6] = [
    names("element", elements, r#"`"Q8"`"#, r#""Q4""#, "element of the cells"),
    spacing("spacing", "required, or `angles`", r#""2 deg""#,
        "spacing of nodes: round shapes, an angle on the contact circle at θ = 0; cylinder and block, a length at the contact \
        point; rectangle, a length everywhere; an angle is at most 45 deg").range(POSITIVE),
    angles("angles", NONE, r#"["0 deg", "30 deg", "60 deg", "90 deg", "120 deg", "150 deg", "180 deg"]"#,
        "the nodes of the contact circle themselves, increasing from 0 deg: to 180 deg, mirrored in a whole model; or around \
        to below 360 deg, for whole models only; a strip needs nodes near the directions of its corners"),
    spacing("fine_to", "everywhere; line contact: half_length/8", r#""100 deg""#,
        "distance from θ = 0 or from the contact point, to both sides, up to which `spacing` holds; beyond it the spacing \
        grows from cell to cell by 15 % on circles and 12 % in line contacts; not of rectangles").range(POSITIVE),
    spacing("coarse_spacing", "4 × `spacing`", r#""9 deg""#,
        "on circles the spacing that it grows to; needs `fine_to`").range(POSITIVE),
    integer("layers", "by the number of angles and the width of a ring, for cells about as deep as wide", "24",
        "layers of cells around the hole of a plate or ring; other shapes choose their own").range(FROM_ONE),
];

/// `[bodies.NAME.mesh]`: what differs from there.
const OWN_MESH: &[Key] = &with_default(MESH, "of the scene");

const DIVISIONS: &[&[&str]] = &[&["spacing", "fine_to", "coarse_spacing"], &["angles"]];
const DIVISION_CHOICES: &str = r#"spacing = "2 deg", angles = ["0 deg", …]"#;
const FROM_ONE: Range = numbers(" ≥ 1", "at least 1", |value| value >= 1.0);

#[rustfmt::skip]
pub(crate) const TABLES: &[Table] = &[
    Table::new("bodies.NAME", &[
        words("material", "name of a material", "required unless rigid", r#""aluminium""#, "what the body is made of"),
        flag("rigid", "`false`", "true", "nothing in the body deforms; without `material`"),
        length("thickness", "required unless rigid or of a laminate, whose own it is", r#""1.5 mm""#,
            "thickness; also in plane strain, where forces are those on this length; one that contradicts the laminate is \
            refused").range(POSITIVE),
        table_as("shape", REQUIRED, r#".disk = { radius = "5 mm" }"#, "outline"),
        words("position", "two lengths", r#"`["0 mm", "0 mm"]`"#, r#"["60 mm", "0 mm"]"#,
            "where the origin of its coordinates stands; of an outline, a mesh or a rectangle that no contact puts into a hole"),
        angle("angle", r#"`"0 deg"`"#, r#""30 deg""#,
            "by which an outline or a mesh is turned about that origin, counter-clockwise; materials keep their own angles"),
        words("model", r#"`"auto"`, `"series"`, `"half-plane"`, `"elements"`"#, r#"`"auto"`"#, r#""series""#,
            "how its compliance is found: by series about its contact circle, which needs no mesh, as the half-plane that a block or a \
            cylinder stands for, or by finite elements; auto takes series where the scene gives no mesh and they can hold the body; not of a \
            rigid one"),
        table("mesh", "that of the [scene](#mesh)", "how finely this body is divided; not of a rigid one"),
        table("pattern", NONE, pattern::MEANING),
    ]).one_of(&[&["material"], &["rigid"]], r#"material = "…", rigid = true"#),
    Table::new("bodies.NAME.mesh", OWN_MESH).at_most_one_of(DIVISIONS, DIVISION_CHOICES),
    Table::new("mesh", &MESH).one_of(DIVISIONS, DIVISION_CHOICES),
];

/// The names of the elements.
fn elements() -> String {
    quoted(ElementKind::ALL.iter().map(|kind| kind.name()))
}
