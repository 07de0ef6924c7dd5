//! The mesh of a region: a sector around the hole, or one from a file.

mod imported;

use stickslip_fem_core::mesh::Mesh;

use crate::error::ExperimentError;
use stickslip_experiment::{Hole, RegionPlan, RegionShape};
use stickslip_scene::host::Host;

/// The edge set on which stresses are asked for.
pub(crate) const EDGE: &str = "inner";

/// Meshes the region of `plan` around `hole`: the mesh, whose edges on the hole or at the stand-off from it are the set [`EDGE`], and their
/// radius `[mm]`.
///
/// # Errors
/// [`ExperimentError::Region`] for a sector that cannot be meshed, [`ExperimentError::File`] and [`ExperimentError::Missing`] for a
/// file that holds no mesh of the hole.
pub(crate) fn meshed(
    plan: &RegionPlan,
    hole: &Hole,
    host: Host,
) -> Result<(Mesh, f64), ExperimentError> {
    match &plan.shape {
        RegionShape::Sector(sector) => {
            let sector = sector.around(hole);
            let mesh = sector.mesh().map_err(ExperimentError::of_the_region)?;
            Ok((mesh, sector.inner()))
        }
        RegionShape::Mesh(mesh) => Ok((imported::mesh(mesh, hole, EDGE, host)?, hole.radius)),
    }
}
