//! Why a stage of an experiment fails.

mod laws;
mod messages;
mod whole;

use stickslip_hybrid::data::DataError;
use stickslip_hybrid::fringe::FringeError;
use stickslip_hybrid::identify::IdentifyError;
use stickslip_hybrid::moire::MoireError;
use stickslip_hybrid::reduce::ReduceError;
use stickslip_hybrid::region::RegionError;
use thiserror::Error;

use stickslip_engine::run::RunError;
use stickslip_experiment::Experiment;
use stickslip_scene::diagnostic::{SceneError, SceneProblem};
use stickslip_scene::limits::TooLittleMemory;

pub use laws::LawsError;
pub(super) use messages::{at, of_reduction, of_region};
pub use whole::WholeError;

/// Why a stage of an experiment fails. Every variant knows the key of the experiment file that it is about.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum ExperimentError {
    /// The scene behind a synthetic experiment cannot be solved.
    #[error(transparent)]
    Run(Box<RunError>),
    /// A part that a stage needs is not in the file.
    #[error("{what}")]
    Missing {
        /// Key of the table that lacks it.
        key: String,
        /// What is needed and why.
        what: String,
        /// A line that would do.
        remedy: String,
    },
    /// A file cannot be read.
    #[error("the file '{path}' cannot be read: {cause}")]
    File {
        /// Key that names it.
        key: String,
        /// Its path.
        path: String,
        /// What the system says.
        cause: String,
    },
    /// What there is too little memory for.
    #[error("{what}: {cause}")]
    Memory {
        /// Key that asks for it.
        key: String,
        /// What it is.
        what: String,
        /// The memory that it would take and the memory that there is.
        #[source]
        cause: TooLittleMemory,
    },
    /// Measured data that cannot be read or combined.
    #[error("state '{state}': {cause}")]
    Data {
        /// Name of the state.
        state: String,
        /// Key of the data.
        key: String,
        /// What is wrong.
        #[source]
        cause: Box<DataError>,
    },
    /// Fringe pictures that cannot be made or read.
    #[error("state '{state}', {field} field{file}: {cause}{hint}")]
    Fringes {
        /// Name of the state.
        state: String,
        /// U, V, or both.
        field: &'static str,
        /// The picture as text, ", 'up-u.png'"; empty for synthetic ones.
        file: String,
        /// What else was found, as text; may be empty.
        hint: String,
        /// Key of the pictures.
        key: String,
        /// What is wrong.
        #[source]
        cause: Box<FringeError>,
    },
    /// Data that do not cover the region's nodes.
    #[error("state '{state}': {cause}")]
    Reduction {
        /// Name of the state.
        state: String,
        /// Key of the reduction.
        key: String,
        /// What is wrong.
        #[source]
        cause: Box<ReduceError>,
    },
    /// A law that cannot be fitted as the file says.
    #[error("{problem}")]
    Law {
        /// Key of what is wrong.
        key: String,
        /// What it is.
        problem: Box<SceneProblem>,
    },
    /// Laws that cannot be fitted.
    #[error("fitting of friction laws: {cause}")]
    Laws {
        /// Key of the laws.
        key: String,
        /// What is wrong.
        #[source]
        cause: Box<LawsError>,
    },
    /// The whole plate cannot be analysed.
    #[error("the whole plate: {cause}")]
    Whole {
        /// Key that asks for it.
        key: String,
        /// What is wrong.
        #[source]
        cause: Box<WholeError>,
    },
    /// A region that cannot be analysed, or data that do not determine it.
    #[error("state '{state}': {cause}")]
    Region {
        /// Name of the state.
        state: String,
        /// Key of the region.
        key: String,
        /// What is wrong.
        #[source]
        cause: Box<RegionError>,
    },
    /// Tractions that friction cannot be asked of.
    #[error("friction: {0}")]
    Identify(#[from] IdentifyError),
    /// A grating that cannot be.
    #[error(transparent)]
    Grating(#[from] MoireError),
}

impl From<RunError> for ExperimentError {
    fn from(cause: RunError) -> Self {
        Self::Run(Box::new(cause))
    }
}

impl ExperimentError {
    /// A part that a stage needs and the table `key` lacks: `what` is needed and why, and a line that would do.
    pub(crate) fn missing(
        key: impl Into<String>,
        what: impl Into<String>,
        remedy: impl Into<String>,
    ) -> Self {
        Self::Missing {
            key: key.into(),
            what: what.into(),
            remedy: remedy.into(),
        }
    }

    /// Synthetic pictures of the state `state` that cannot be made, by what `key` asks for.
    pub(crate) fn fringes(
        state: &str,
        field: &'static str,
        key: impl Into<String>,
        cause: FringeError,
    ) -> Self {
        Self::Fringes {
            state: state.to_owned(),
            field,
            file: String::new(),
            hint: String::new(),
            key: key.into(),
            cause: Box::new(cause),
        }
    }

    /// A region that cannot be analysed whatever the state.
    pub(crate) fn of_the_region(cause: impl Into<RegionError>) -> Self {
        Self::region("all", cause.into())
    }

    /// A region that cannot be analysed with the data of `state`.
    pub(crate) fn region(state: &str, cause: RegionError) -> Self {
        Self::Region {
            state: state.to_owned(),
            key: "region".to_owned(),
            cause: Box::new(cause),
        }
    }

    /// Data of `state` that do not cover the region's nodes.
    pub(crate) fn reduction(state: &str, cause: ReduceError) -> Self {
        Self::Reduction {
            state: state.to_owned(),
            key: "reduce".to_owned(),
            cause: Box::new(cause),
        }
    }

    /// The key of the experiment file that the error is about.
    pub fn key(&self) -> &str {
        match self {
            Self::Run(_) => "specimen.scene",
            Self::Grating(_) => "grating",
            Self::Identify(_) => "identify",
            Self::Missing { key, .. }
            | Self::File { key, .. }
            | Self::Memory { key, .. }
            | Self::Data { key, .. }
            | Self::Fringes { key, .. }
            | Self::Reduction { key, .. }
            | Self::Law { key, .. }
            | Self::Whole { key, .. }
            | Self::Laws { key, .. }
            | Self::Region { key, .. } => key,
        }
    }

    fn remedy(&self) -> String {
        let fixed = match self {
            Self::Run(_) => {
                "`stickslip run` with the same scene and overrides shows what is wrong with it"
            }
            Self::Missing { remedy, .. } => return remedy.clone(),
            Self::File { .. } => "paths are relative to the folder of the experiment file",
            Self::Memory { .. } => {
                "cut pictures to the specimen or join their pixels, or make cells larger; or take a machine with more memory"
            }
            Self::Data { cause, .. } => match cause.as_ref() {
                DataError::MissingColumn { .. } | DataError::RepeatedColumn { .. } => {
                    "`stickslip list presets` shows the columns of each preset; columns = { u = \"…\" } names others"
                }
                _ => "correct the file, or what the experiment says of it",
            },
            Self::Fringes { cause, .. } => match cause.as_ref() {
                FringeError::File(_) | FringeError::Colour(_) => {
                    "save the picture as PNG or TIFF in grey, 8 or 16 bits: `magick photo.jpg -colorspace Gray -depth 8 up-u.png`"
                }
                FringeError::Frames(_) => {
                    "pictures of one state, and of its null field, need the same pixels: state them with one pixel, top_left and size"
                }
                FringeError::CarrierRange { .. } => {
                    "check carrier and pixel: a carrier counts fringes per length, not per pixel"
                }
                FringeError::NoCarrier { .. } | FringeError::Crowded { .. } => {
                    "look at the picture: fringes must not turn back; four = pictures with shifted phase need no carrier"
                }
                FringeError::Masked { .. } => {
                    "check window, dark, missing and mask: nothing of the picture is left"
                }
                _ => "look at the picture, its scale and its place",
            },
            Self::Reduction { .. } => "make the region smaller, give it a stand-off, or mask less",
            Self::Whole { .. } => {
                "the data must surround the hole, and only known forces may hold the plate; whole_plate = false leaves it out"
            }
            Self::Law { .. } => "`stickslip list laws` shows the parameters of each law",
            Self::Laws { cause, .. } if matches!(**cause, LawsError::NotSymmetric { .. }) => {
                "model = \"whole\" or \"auto\" of the scene does for every law"
            }
            Self::Laws { .. } => {
                "`stickslip run` with the scene and the law shows where its solution fails; narrow the ranges of free parameters"
            }
            Self::Region { cause, .. } => messages::remedy_of_region(cause),
            Self::Identify(_) => "give the slip zones by hand, [[identify.zones]]",
            Self::Grating(_) => "give a grating that can exist",
        };
        fixed.to_owned()
    }

    /// The error with its places and lengths as the experiment shows them.
    fn message(&self, experiment: &Experiment) -> String {
        match self {
            Self::Region { state, cause, .. } => {
                format!("state '{state}': {}", of_region(experiment, cause))
            }
            Self::Reduction { state, cause, .. } => {
                format!("state '{state}': {}", of_reduction(experiment, cause))
            }
            Self::Whole { cause, .. } => match cause.as_ref() {
                WholeError::Region(cause) => {
                    format!("the whole plate: {}", of_region(experiment, cause))
                }
                _ => self.to_string(),
            },
            _ => self.to_string(),
        }
    }

    /// The error at its line of the experiment file.
    pub fn located(&self, experiment: &Experiment) -> SceneError {
        let problem = match self {
            Self::Law { problem, .. } => problem.as_ref().clone(),
            _ => SceneProblem::Experiment {
                message: self.message(experiment),
                remedy: self.remedy(),
            },
        };
        experiment.error_at(self.key(), problem)
    }
}
