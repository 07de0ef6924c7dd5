//! What is wrong with an outline, at the key that causes it.

use stickslip_mesher::{ContourError, ContourMesh, Course, Division, Piece, SplineFlaw};

use super::Profile;
use crate::document::child;
use crate::shape::outline::{Outline, Sizes};

impl Profile {
    /// Reports what does not bound a body, or bounds it by two edges of one name.
    pub(super) fn refuse_defects(&self, table: &str, sizes: &mut dyn Sizes) {
        let names = self.edges().into_iter().map(|edge| edge.name);
        let points = self.points().into_iter().map(|(name, _)| name);
        let mut names: Vec<_> = names.chain(points).collect();
        names.sort_unstable();
        let is_plain = |name: &str| {
            let plain = |letter: char| letter.is_ascii_alphanumeric() || "_-".contains(letter);
            !name.is_empty() && name.chars().all(plain)
        };
        if let Some(odd) = names.iter().find(|name| !is_plain(name)) {
            let message = format!(
                "the name '{odd}' of an edge, a hole or a point is not made of letters a–z, digits, '_' and '-'"
            );
            let remedy = "give it another name, such as end or hole-1";
            sizes.conflict(&child(table, "edges"), message, remedy);
        } else if let Some([twice, ..]) = names.windows(2).find(|pair| pair[0] == pair[1]) {
            let message = format!("two edges are called '{twice}'");
            let remedy = "give each edge, hole and point a name of its own";
            sizes.conflict(&child(table, "edges"), message, remedy);
        } else if let Err(defect) = self.contour.check() {
            let key = child(table, self.key_of(&defect));
            sizes.conflict(&key, defect.to_string(), remedy(&defect));
        } else if let Err(defect) = self.pointed().check() {
            let key = child(table, self.key_of(&defect));
            sizes.conflict(&key, defect.to_string(), remedy(&defect));
        }
    }

    /// The body with its points, to be checked.
    fn pointed(&self) -> ContourMesh {
        let division = Division {
            points: self.points.clone(),
            ..Division::default()
        };
        ContourMesh {
            contour: self.contour.clone(),
            division,
        }
    }

    /// The key below the shape's table that a defect is shown at.
    fn key_of(&self, defect: &ContourError) -> String {
        let key_with = |is_it: &dyn Fn(&Piece) -> bool| {
            let outer = self.contour.pieces.iter().position(is_it);
            let outer = outer.map(|index| format!("edges.{index}"));
            let cut = self.contour.cutouts.iter().find_map(|own| {
                let index = own.pieces.iter().position(is_it)?;
                Some(format!("cutouts.{}.edges.{index}", own.name))
            });
            outer.or(cut).unwrap_or_else(|| "edges".to_owned())
        };
        let edge = |name: &str| key_with(&|piece| piece.name == name);
        let spline = |name: &str| {
            let is_it =
                |piece: &Piece| piece.name == name && matches!(piece.course, Course::Spline(_));
            format!("{}.spline", key_with(&is_it))
        };
        match defect {
            ContourError::Open { piece, .. }
            | ContourError::ZeroLength { piece, .. }
            | ContourError::StraightArc { piece } => edge(piece),
            ContourError::Spline { piece, .. } => spline(piece),
            ContourError::Crossing { second, .. } | ContourError::Cusp { second, .. } => {
                edge(second)
            }
            ContourError::Clockwise {
                cutout: Some(own), ..
            }
            | ContourError::TooFewPieces {
                cutout: Some(own), ..
            }
            | ContourError::CutoutOutside { cutout: own, .. }
            | ContourError::CutoutInside { inner: own, .. } => format!("cutouts.{own}"),
            ContourError::HoleOutside { hole, .. } | ContourError::HoleCrosses { hole, .. } => {
                format!("holes.{hole}")
            }
            ContourError::HolesOverlap { second, .. } => format!("holes.{second}"),
            ContourError::NoEnd { point, .. } => format!("points.{point}"),
            _ => "edges".to_owned(),
        }
    }
}

/// What to do about a defect; its coordinates are in mm.
fn remedy(defect: &ContourError) -> &'static str {
    match defect {
        ContourError::Open { .. } => {
            "leave out `to` of the last edge, which then closes the outline; numbers are in mm"
        }
        ContourError::Clockwise { .. } => {
            "list edges counter-clockwise, those of cut-outs as those around the body"
        }
        ContourError::StraightArc { .. } => {
            "give a point beside the line between its ends, or remove `through`"
        }
        ContourError::Spline { flaw, .. } => flawed(flaw),
        ContourError::NoEnd { .. } => {
            "end an edge there, or move the point to where one ends; numbers are in mm"
        }
        ContourError::CutoutOutside { .. } | ContourError::CutoutInside { .. } => {
            "move the cut-out, or remove it; coordinates are in mm"
        }
        ContourError::HoleOutside { .. }
        | ContourError::HoleCrosses { .. }
        | ContourError::HolesOverlap { .. } => {
            "move the hole or give it a smaller radius; numbers are in mm"
        }
        _ => "change the edges; coordinates are in mm",
    }
}

/// What to do about a spline.
fn flawed(flaw: &SplineFlaw) -> &'static str {
    match flaw {
        SplineFlaw::NoPoint => {
            "give points between its ends, or remove `spline` for a straight edge"
        }
        SplineFlaw::TooManyPoints { .. } => "leave out points, or divide the edge into several",
        SplineFlaw::RepeatedPoint { .. } => {
            "remove one of the two points; `spline` leaves out the ends of the edge, and coordinates are in mm"
        }
        SplineFlaw::Tight { .. } => {
            "give more points there, check their order and the directions `leaves` and `arrives`, or end the edge where the outline has a corner; numbers are in mm"
        }
        _ => "change its points, or give more of them; coordinates are in mm",
    }
}
