//! From a contour and its division to a mesh.

use stickslip_fem_core::generate::{Generate, GenerateError, MeshEstimate};
use stickslip_fem_core::mesh::{ElementKind, Mesh};

use crate::assemble::{Corners, assembled};
use crate::edges::{Boundary, Link};
use crate::frame::{Framed, ordered};
use crate::orientation::directions;
use crate::plan::Plan;
use crate::smooth::smooth;
use crate::symmetry::Mirror;
use crate::triangulate::{Refinement, Triangles};
use crate::{Contour, ContourError, Division};

/// A contour and its division: a body that can be meshed.
#[derive(Clone, Debug, PartialEq)]
pub struct ContourMesh {
    /// The body.
    pub contour: Contour,
    /// Its cells.
    pub division: Division,
}

impl ContourMesh {
    /// Checks the contour and its division without a mesh.
    ///
    /// # Errors
    /// As [`Contour::check`], and [`ContourError`] of a division: kind, growth, spacings, names of fine pieces.
    pub fn check(&self) -> Result<(), ContourError> {
        Plan::new(&self.contour, &self.division).map(|_| ())
    }

    /// Meshes with at most `limit` nodes; [`Generate::generate_within`] with errors in detail.
    ///
    /// One edge set per name of a piece or hole, with its exact curve; every boundary edge is in exactly one. Cells have the body on
    /// the left of their edges.
    ///
    /// # Errors
    /// As [`ContourMesh::check`]; [`ContourError::TooLarge`] as soon as the limit is passed; [`ContourError::Incomplete`] if cells
    /// stay large or flat; [`ContourError::Mesh`] if curved cells are folded.
    pub fn mesh(&self, limit: usize) -> Result<Mesh, ContourError> {
        let plan = Plan::new(&self.contour, &self.division)?;
        let MeshEstimate { nodes, .. } = self.estimated(&plan);
        // The estimate is rather high; what it refuses would take long to refuse otherwise.
        if nodes / 4 > limit {
            return Err(ContourError::TooLarge { nodes, limit });
        }
        // A triangulation has at least as many edges as corners, and T6 a node on each.
        let corners = match self.division.kind {
            ElementKind::T6 => limit / 2,
            _ => limit,
        };
        let (framed, (mirrors, chains)) = self.framed(&plan);
        let (half, mirrors) = match refined(&framed.plan, &chains, corners) {
            // Mirrors divide corners, which may leave no room for good cells beside them.
            Err(ContourError::Incomplete { .. } | ContourError::EdgesMeet { .. })
                if !mirrors.is_empty() =>
            {
                let whole = Link::loops(&framed.plan);
                (refined(&framed.plan, &whole, corners), Vec::new())
            }
            half => (half, mirrors),
        };
        let half = half.map_err(|error| match error {
            ContourError::TooLarge { nodes, .. } => ContourError::TooLarge {
                nodes: nodes.saturating_mul((limit / corners.max(1)) << mirrors.len()),
                limit,
            },
            other => other.at_places(|place| {
                let ([x, y], by) = (framed.back(place), self.division.centre);
                [x + by[0], y + by[1]]
            }),
        })?;
        let unfold = |all, mirror: &Mirror| mirror.unfold(all, &framed.plan);
        let whole = mirrors.iter().rev().fold(half, unfold);
        let corners = Corners::new(&framed, &plan, whole, &mirrors);
        assembled(&plan, corners, &self.division, limit)
    }

    /// The frame in which a body has the most mirrors, of several the one whose coordinates come first, with what [`Mirror::all`] finds in it.
    fn framed(&self, plan: &Plan) -> (Framed, (Vec<Mirror>, Vec<Vec<Link>>)) {
        let along = |direction| {
            let framed = Framed::along(direction, plan, &self.contour.holes, &self.division);
            let mirrors = Mirror::all(&framed.plan, &self.division.refined);
            (framed, mirrors)
        };
        let frames = directions(&plan.outline).into_iter().map(along);
        let best = frames.reduce(|best, own| {
            let more = own.1.0.len().cmp(&best.1.0.len());
            let is_first = || ordered(&best.0.key, &own.0.key);
            if more.then_with(is_first).is_gt() {
                own
            } else {
                best
            }
        });
        // An outline has a longest piece.
        best.unwrap_or_else(|| along([1.0, 0.0]))
    }

    fn estimated(&self, plan: &Plan) -> MeshEstimate {
        let (cells, corners) = plan.estimate(&self.division.refined);
        let nodes = if self.division.kind == ElementKind::T6 {
            // Edges are half as many again as cells, and half the boundary's.
            corners + 1.5 * cells + corners.sqrt()
        } else {
            corners
        };
        // Casts saturate.
        MeshEstimate {
            nodes: nodes as usize,
            elements: cells as usize,
        }
    }
}

/// The triangulation inside closed chains with at most `limit` corners.
fn refined(plan: &Plan, chains: &[Vec<Link>], limit: usize) -> Result<Triangles, ContourError> {
    let boundary = Boundary::new(plan, chains, limit)?;
    let mut refinement = Refinement::new(plan, boundary, limit)?;
    refinement.refine()?;
    smooth(&mut refinement)?;
    Ok(refinement.finished())
}

impl Generate for ContourMesh {
    type Output = Mesh;

    /// An estimate from ∫ dA/h², rather high.
    fn estimate(&self) -> Result<MeshEstimate, GenerateError> {
        let plan = Plan::new(&self.contour, &self.division)?;
        Ok(self.estimated(&plan))
    }

    fn generate_within(&self, limit: usize) -> Result<Mesh, GenerateError> {
        Ok(self.mesh(limit)?)
    }
}
