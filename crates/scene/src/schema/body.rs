//! Bodies.

use serde::{Deserialize, Serialize};
use stickslip_fem_core::mesh::Point;

use super::mesh::{MeshFormat, MeshSettings};
use crate::declaration::{
    NONE, POSITIVE, REQUIRED, Table, angle, described, flag, length, table, table_as,
};
use crate::shape::pattern::{self, PatternFormat};
use crate::shape::{Shape, ShapeFormat};
use crate::units::{Angle, Length, Quantity};

/// A body.
#[derive(Debug, Clone, PartialEq)]
pub struct Body {
    /// What it is made of.
    pub substance: Substance,
    /// Its outline.
    pub shape: Shape,
    /// Where the origin of its coordinates stands, unless a contact puts it into a hole `[mm]`.
    pub position: Point,
    /// How its compliance is found.
    pub model: BodyModel,
    /// How finely it is divided where it differs from [`Scene::mesh`](crate::Scene::mesh); whole, with what it takes from there.
    pub mesh: Option<MeshSettings>,
}

/// What a body is made of.
#[derive(Debug, Clone, PartialEq)]
pub enum Substance {
    /// An elastic material of the scene.
    Elastic {
        /// Name of the material, defined in [`Scene::materials`](crate::Scene::materials).
        material: String,
        /// Thickness `[mm]`.
        thickness: f64,
    },
    /// Nothing in it deforms.
    Rigid,
}

/// How the compliance of an elastic body is found.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum BodyModel {
    /// By series where the scene gives no mesh and a series can hold the body, otherwise by finite elements.
    #[default]
    Auto,
    /// By series about the circle of its contact, without a factorisation.
    Series,
    /// As the half-plane that a block or a cylinder of a line contact stands for, in closed form.
    #[serde(rename = "half-plane")]
    HalfPlane,
    /// By condensed finite elements.
    Elements,
}

impl BodyModel {
    /// Whether it is left to the program.
    #[expect(
        clippy::trivially_copy_pass_by_ref,
        reason = "serde hands over references"
    )]
    pub(crate) fn is_auto(&self) -> bool {
        *self == Self::Auto
    }

    /// Whether the scene asks for a closed form, which has no mesh to solve on.
    pub fn is_closed_form(self) -> bool {
        matches!(self, Self::Series | Self::HalfPlane)
    }
}

/// `[bodies.NAME]`.
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

impl BodyFormat {
    /// The body, whose division is found when all bodies are known.
    pub(crate) fn body(&self, substance: Substance, shape: Shape, position: Point) -> Body {
        let Self {
            material: _,
            rigid: _,
            thickness: _,
            shape: _,
            position: _,
            angle: _,
            model,
            mesh: _,
            // Written out before the scene is read.
            pattern: _,
        } = *self;
        Body {
            substance,
            shape,
            position,
            model,
            mesh: None,
        }
    }
}

#[rustfmt::skip]
pub(crate) const TABLES: &[Table] = &[
    Table::new("bodies.NAME", &[
        described("material", "name of a material", "required unless rigid", r#""aluminium""#, "what the body is made of"),
        flag("rigid", "`false`", "true", "nothing in the body deforms; without `material`"),
        length("thickness", "required unless rigid or of a laminate, whose own it is", r#""1.5 mm""#,
            "thickness; also in plane strain, where forces are those on this length; one that contradicts the laminate is \
            refused").range(POSITIVE),
        table_as("shape", REQUIRED, r#".disk = { radius = "5 mm" }"#, "outline"),
        described("position", "two lengths", r#"`["0 mm", "0 mm"]`"#, r#"["60 mm", "0 mm"]"#,
            "where the origin of its coordinates stands; of an outline, a mesh or a rectangle that no contact puts into a hole"),
        angle("angle", r#"`"0 deg"`"#, r#""30 deg""#,
            "by which an outline or a mesh is turned about that origin, counter-clockwise; materials keep their own angles"),
        described("model", r#"`"auto"`, `"series"`, `"half-plane"`, `"elements"`"#, r#"`"auto"`"#, r#""series""#,
            "how its compliance is found: by series about its contact circle, which needs no mesh, as the half-plane that a block or a \
            cylinder stands for, or by finite elements; auto takes series where the scene gives no mesh and they can hold the body; not of a \
            rigid one"),
        table("mesh", "that of the [scene](#mesh)", "how finely this body is divided; not of a rigid one"),
        table("pattern", NONE, pattern::MEANING),
    ]).one_of(&[&["material"], &["rigid"]], r#"material = "…", rigid = true"#),
];
