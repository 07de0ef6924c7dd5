//! The region of an experiment, ready for any number of states.

use std::sync::Arc;

use stickslip_fem_core::ElasticBody;
use stickslip_fem_core::material::Material;
use stickslip_fem_core::mesh::{Mesh, Point};
use stickslip_hybrid::region::outline::boundary_nodes;
use stickslip_hybrid::region::{Region, RegionError};

use super::edge::Edge;
use crate::error::ExperimentError;
use crate::measured::Measured;
use crate::region_mesh::{EDGE, meshed};
use stickslip_experiment::{Area, Experiment, RegionPlan, RegionShape};

/// A factorised region with the rows of its edge.
#[derive(Debug)]
pub struct Workbench<'a> {
    pub(super) experiment: &'a Experiment,
    pub(super) plan: &'a RegionPlan,
    pub(super) region: Region,
    pub(super) edge: Edge,
    /// Nodes inside that move as measured, ascending.
    pub(super) interior: Vec<usize>,
}

/// Nodes inside of the mesh that lie in one of the areas, ascending.
fn interior(mesh: &Mesh, areas: &[Area]) -> Result<Vec<usize>, ExperimentError> {
    let boundary = boundary_nodes(mesh);
    let nodes = mesh.nodes().iter().enumerate();
    let mut inside: Vec<(usize, Point)> = nodes
        .filter(|(node, _)| boundary.binary_search(node).is_err())
        .map(|(node, place)| (node, *place))
        .collect();
    for (index, area) in areas.iter().enumerate() {
        if !inside.iter().any(|(_, place)| area.contains(*place)) {
            return Err(ExperimentError::missing(
                format!("region.interior.{index}"),
                format!(
                    "area {} of region.interior holds no node inside of the region",
                    index + 1
                ),
                "make it larger, or the cells smaller; nodes on the boundary move as measured anyway",
            ));
        }
    }
    inside.retain(|(_, place)| areas.iter().any(|area| area.contains(*place)));
    Ok(inside.into_iter().map(|(node, _)| node).collect())
}

impl<'a> Workbench<'a> {
    /// Meshes and factorises the region of `experiment`.
    ///
    /// # Errors
    /// [`ExperimentError::Missing`] without `[region]` or for areas without a node, [`ExperimentError::Region`] for one that cannot be
    /// analysed.
    pub fn new(experiment: &'a Experiment) -> Result<Self, ExperimentError> {
        const SECTOR: &str = "write [region] sector = { angles = [\"-10 deg\", \"110 deg\"], outer = \"13 mm\", cells = [40, 10] }";
        let plan = experiment.region.as_ref().ok_or_else(|| {
            ExperimentError::missing("region", "edge stresses need a [region]", SECTOR)
        })?;
        let specimen = &experiment.specimen;
        let (mesh, radius) = meshed(plan, &specimen.hole, experiment.host())?;
        let mesh = Arc::new(mesh);
        let material = (specimen.material.in_plane(specimen.plane)).map_err(|cause| {
            let what = format!("the specimen's material is not valid: {cause}");
            ExperimentError::missing("specimen.material", what, "correct its constants")
        })?;
        let material: Arc<dyn Material> = Arc::from(material);
        let blocks = mesh.blocks().iter();
        let materials = blocks.map(|_| Arc::clone(&material)).collect();
        let body = ElasticBody::new(mesh, materials, specimen.thickness);
        let body = Arc::new(body.map_err(ExperimentError::of_the_region)?);
        let interior = interior(body.mesh(), &plan.interior)?;
        let region = Region::new(&body, &interior).map_err(ExperimentError::of_the_region)?;
        let cut = match &plan.shape {
            RegionShape::Sector(sector) => sector.angles[0],
            // Opposite of where scenes bear.
            RegionShape::Mesh(_) => std::f64::consts::PI,
        };
        let edge = Edge::new(&body, EDGE, radius, cut).map_err(ExperimentError::of_the_region)?;
        Ok(Self {
            experiment,
            plan,
            region,
            edge,
            interior,
        })
    }

    pub(super) fn refuse(&self, measured: &Measured, cause: RegionError) -> ExperimentError {
        ExperimentError::region(&self.experiment.states[measured.state].name, cause)
    }

    /// Whether the edge is not that of the hole.
    pub(super) fn stands_off(&self) -> bool {
        match &self.plan.shape {
            RegionShape::Sector(sector) => sector.stand_off > 0.0,
            RegionShape::Mesh(_) => false,
        }
    }
}
