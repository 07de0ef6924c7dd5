//! What a source is read for.

use stickslip_experiment::Experiment;
use stickslip_fem_core::mesh::Point;
use stickslip_hybrid::moire::Grating;
use stickslip_scene::limits::Content;

use crate::error::ExperimentError;

/// What a source is read for.
#[derive(Clone, Debug)]
pub(super) struct Scope<'a> {
    pub(super) experiment: &'a Experiment,
    pub(super) state: usize,
    /// Key of the source in the file.
    pub(super) key: String,
}

impl Scope<'_> {
    pub(super) fn name(&self) -> String {
        self.experiment.states[self.state].name.clone()
    }

    pub(super) fn data(&self, cause: stickslip_hybrid::data::DataError) -> ExperimentError {
        ExperimentError::Data {
            state: self.name(),
            key: self.key.clone(),
            cause: Box::new(cause),
        }
    }

    pub(super) fn fringes(
        &self,
        field: &'static str,
        cause: stickslip_hybrid::fringe::FringeError,
    ) -> ExperimentError {
        ExperimentError::fringes(&self.name(), field, &self.key, cause)
    }

    pub(super) fn bytes(
        &self,
        path: &std::path::Path,
        content: Content,
    ) -> Result<Vec<u8>, ExperimentError> {
        let read = self.experiment.host().read(path, content);
        read.map_err(|cause| ExperimentError::File {
            key: self.key.clone(),
            path: path.display().to_string(),
            cause: cause.to_string(),
        })
    }

    /// The longest side of triangles in which data are interpolated `[mm]`; infinite where none is stated.
    pub(super) fn longest_side(&self) -> f64 {
        let stated = self.experiment.reduce.longest_side;
        stated.unwrap_or(f64::INFINITY)
    }

    pub(super) fn grating(&self) -> Result<Grating, ExperimentError> {
        let missing = || {
            ExperimentError::missing(
                "",
                "fringe orders are displacements only with the frequency of their grating",
                "add [grating] frequency = \"2400 1/mm\"",
            )
        };
        self.experiment.grating.ok_or_else(missing)
    }

    /// Whether a place is on the specimen and under no mask.
    pub(super) fn shows(&self, place: Point) -> bool {
        let hole = self.experiment.specimen.hole;
        hole.from_centre(place) > hole.radius
            && !(self.experiment.reduce.mask.iter()).any(|area| area.contains(place))
    }

    /// Whether a place of data that resolve `resolved` \[mm\] is as far from the hole's edge as asked.
    pub(super) fn is_away(&self, place: Point, resolved: f64) -> bool {
        let hole = self.experiment.specimen.hole;
        hole.from_centre(place) >= hole.radius + self.experiment.reduce.margin.unwrap_or(resolved)
    }
}
