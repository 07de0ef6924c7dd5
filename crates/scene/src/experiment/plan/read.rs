//! From the text of an experiment file to a checked experiment.

use std::fmt::Write as _;
use std::path::Path;
use std::sync::Arc;

use serde::Deserialize as _;
use sha2::{Digest as _, Sha256};
use stickslip_hybrid::fringe::{Depth, Exposure, Format as FileFormat};
use stickslip_hybrid::moire::Grating;

use super::{
    Area, DisplayUnits, Experiment, Fringes, Reduce, Specimen, State, VERSION, laws, settings,
    specimen, states, unused,
};
use crate::diagnostic::{SceneError, SceneProblem, SourceText};
use crate::document::{Document, Part};
use crate::experiment::format::{
    ExperimentFormat, FileKindFormat, FringesFormat, GratingFormat, MaskFormat, PlaceFormat,
    SeriesFormat,
};
use crate::host::Host;
use crate::read::Reader;
use crate::units::{Length, PerLength, Quantity};
use crate::{Format, format::UnitsFormat, overrides::apply as apply_override};

pub(super) fn experiment(
    source: SourceText,
    format: Format,
    folder: &Path,
    overrides: &[impl AsRef<str>],
    host: Host,
) -> Result<Experiment, SceneError> {
    let source_name = source.name.clone();
    let (document, read) = keys(source, format, overrides, host)?;
    let refuse = Refuse(&document);
    let mut specimen = specimen::read(refuse, &read, folder)?;
    let display = shown_in(read.units.as_ref(), &mut specimen);
    let grating = read.grating.as_ref();
    let grating = grating.map(|given| self::grating(refuse, given));
    let grating = grating.transpose()?;
    let fringes = read.fringes.as_ref();
    let fringes = fringes.map(|given| self::fringes(refuse, given));
    let fringes = fringes.transpose()?;
    let scope = states::Scope {
        refuse,
        specimen: &specimen,
        grating: grating.as_ref(),
        fringes: fringes.as_ref(),
        folder,
    };
    let states = scope.states(&read.states)?;
    let region = read
        .region
        .as_ref()
        .map(|given| settings::region(refuse, given, &specimen.hole, folder))
        .transpose()?;
    let reduce = settings::reduce(refuse, &read.reduce)?;
    check_symmetry(refuse, &reduce, &states)?;
    let stem = Path::new(&source_name).file_stem();
    Ok(Experiment {
        title: read
            .title
            .or_else(|| stem.map(|stem| stem.to_string_lossy().into_owned()))
            .unwrap_or_default(),
        description: read.description,
        display,
        identify: settings::identify(refuse, &read.identify, &states)?,
        laws: laws::read(refuse, &read.laws, &specimen)?,
        hash: hash(
            &document,
            specimen.scene.as_ref().map(|own| own.scene.hash.as_str()),
        ),
        without_effect: unused::without_effect(
            &document,
            &reduce,
            region.as_ref(),
            fringes.as_ref(),
            &states,
        ),
        reduce,
        region,
        specimen,
        grating,
        fringes,
        states,
        source_name,
        folder: folder.to_owned(),
        document,
    })
}

/// The document with its overrides, and what its keys say.
fn keys(
    source: SourceText,
    format: Format,
    overrides: &[impl AsRef<str>],
    host: Host,
) -> Result<(Document, ExperimentFormat), SceneError> {
    let mut document = Document::parse(source, format)?;
    document.host = host;
    for argument in overrides {
        apply_override(&mut document, argument.as_ref())?;
    }
    document.check_texts()?;
    check_version(&document)?;
    let read = ExperimentFormat::deserialize(Reader::new(&document.root, ""));
    let read = read.map_err(|error| {
        let key = error.key.as_deref().unwrap_or_default();
        document.error(key, error.part, *error.problem)
    })?;
    Ok((document, read))
}

/// Units of results. What is said of the scene is said in them too.
fn shown_in(given: Option<&UnitsFormat>, specimen: &mut Specimen) -> DisplayUnits {
    let display = match (given, &specimen.scene) {
        (None, Some(own)) => own.scene.display,
        (given, _) => given.unwrap_or(&UnitsFormat::default()).display(),
    };
    for own in specimen.scene.iter_mut().chain(&mut specimen.model) {
        if own.scene.display != display {
            Arc::make_mut(&mut own.scene).display = display;
        }
    }
    display
}

fn check_version(document: &Document) -> Result<(), SceneError> {
    let problem = match document.get("version") {
        Some(version) if version.as_u64() == Some(VERSION) => return Ok(()),
        Some(version) => SceneProblem::Conflict {
            message: format!("version {version} of the experiment format is not supported"),
            remedy: format!("this program reads version = {VERSION}"),
        },
        None => SceneProblem::MissingKey {
            key: "version".to_owned(),
            table: "the experiment".to_owned(),
            example: format!("version = {VERSION}"),
        },
    };
    Err(document.error("version", Part::Value, problem))
}

/// A back without a line to compare it along, and a line without any back.
fn check_symmetry(refuse: Refuse<'_>, reduce: &Reduce, states: &[State]) -> Result<(), SceneError> {
    let with_back = states.iter().position(|state| state.back.is_some());
    match (&reduce.symmetry, with_back) {
        (None, Some(state)) => Err(refuse.conflict(
            &format!("states.{state}.back"),
            "the back is given, but no line along which it is compared with the front",
            "add [reduce] symmetry = { from = [\"6 mm\", \"0 mm\"], to = [\"11 mm\", \"3 mm\"] }, or remove back",
        )),
        (Some(_), None) => Err(refuse.conflict(
            "reduce.symmetry",
            "no state has a back that its front could be compared with",
            "give a state its back = { table = … }, in the same form as its front, or remove symmetry",
        )),
        _ => Ok(()),
    }
}

fn hash(document: &Document, scene: Option<&str>) -> String {
    let mut digest = Sha256::new();
    digest.update(format!("{}\n{}", document.root, scene.unwrap_or_default()));
    digest
        .finalize()
        .iter()
        .fold(String::new(), |mut text, byte| {
            // Writing into a string does not fail.
            let _ = write!(text, "{byte:02x}");
            text
        })
}

/// Makes errors at keys of the file.
#[derive(Clone, Copy)]
pub(super) struct Refuse<'a>(pub(super) &'a Document);

impl Refuse<'_> {
    pub(super) fn at(self, key: &str, problem: SceneProblem) -> SceneError {
        self.0.error(key, Part::Value, problem)
    }

    pub(super) fn conflict(
        self,
        key: &str,
        message: impl Into<String>,
        remedy: impl Into<String>,
    ) -> SceneError {
        let problem = SceneProblem::Conflict {
            message: message.into(),
            remedy: remedy.into(),
        };
        self.at(key, problem)
    }

    pub(super) fn missing(self, table: &str, key: &str, example: &str) -> SceneError {
        let problem = SceneProblem::MissingKey {
            key: key.to_owned(),
            table: if table.is_empty() {
                "the experiment".to_owned()
            } else {
                table.to_owned()
            },
            example: example.to_owned(),
        };
        self.0.error(table, Part::Key, problem)
    }

    /// A number within its range, or an error that says what that is.
    pub(super) fn within<T: std::fmt::Display>(
        self,
        key: &str,
        value: T,
        fits: bool,
        allowed: &str,
    ) -> Result<T, SceneError> {
        if fits {
            Ok(value)
        } else {
            Err(self.out_of_range(key, &value, allowed))
        }
    }

    pub(super) fn out_of_range(
        self,
        key: &str,
        value: &dyn std::fmt::Display,
        allowed: &str,
    ) -> SceneError {
        let problem = SceneProblem::OutOfRange {
            key: key.rsplit('.').next().unwrap_or(key).to_owned(),
            value: value.to_string(),
            allowed: allowed.to_owned(),
        };
        self.at(key, problem)
    }

    pub(super) fn positive(self, key: &str, length: &Quantity<Length>) -> Result<f64, SceneError> {
        let value = length.value();
        self.within(key, length.text(), value > 0.0, "greater than 0")?;
        Ok(value)
    }

    pub(super) fn not_negative(
        self,
        key: &str,
        length: &Quantity<Length>,
    ) -> Result<f64, SceneError> {
        let value = length.value();
        self.within(key, length.text(), value >= 0.0, "at least 0")?;
        Ok(value)
    }

    /// Lower left and upper right corner.
    pub(super) fn window(
        self,
        key: &str,
        given: &[PlaceFormat; 2],
    ) -> Result<[[f64; 2]; 2], SceneError> {
        let [low, high] = [place(&given[0]), place(&given[1])];
        if low[0] < high[0] && low[1] < high[1] {
            return Ok([low, high]);
        }
        Err(self.conflict(
            key,
            "the window's first corner is not to the lower left of its second",
            "give the lower left and then the upper right corner",
        ))
    }

    pub(super) fn areas(self, key: &str, given: &[MaskFormat]) -> Result<Vec<Area>, SceneError> {
        let each = given.iter().enumerate();
        each.map(|(index, area)| self.area(&format!("{key}.{index}"), area))
            .collect()
    }

    fn area(self, key: &str, given: &MaskFormat) -> Result<Area, SceneError> {
        match (&given.centre, &given.radius, &given.window) {
            (Some(centre), Some(radius), None) => Ok(Area::Disc {
                centre: place(centre),
                radius: self.positive(&format!("{key}.radius"), radius)?,
            }),
            (None, None, Some(window)) => {
                Ok(Area::Window(self.window(&format!("{key}.window"), window)?))
            }
            _ => Err(self.conflict(
                key,
                "this is neither a disc nor a window",
                "give { centre = [\"0 mm\", \"0 mm\"], radius = \"1 mm\" } or { window = [[\"0 mm\", \"0 mm\"], [\"1 mm\", \"1 mm\"]] }",
            )),
        }
    }
}

/// A place in base units.
pub(super) fn place(given: &PlaceFormat) -> [f64; 2] {
    [given[0].value(), given[1].value()]
}

/// A gradient of orders in base units.
pub(super) fn gradient(given: &[Quantity<PerLength>; 2]) -> [f64; 2] {
    [given[0].value(), given[1].value()]
}

fn grating(refuse: Refuse<'_>, given: &GratingFormat) -> Result<Grating, SceneError> {
    let made = match (&given.frequency, &given.wavelength, &given.angle) {
        (Some(frequency), None, None) => Grating::new(frequency.value()),
        (None, Some(wavelength), Some(angle)) => {
            Grating::from_beams(wavelength.value(), angle.value())
        }
        _ => {
            return Err(refuse.conflict(
                "grating",
                "a grating is given by its frequency, or by wavelength and angle",
                "write frequency = \"2400 1/mm\", or wavelength = \"514.5e-6 mm\" and angle = \"38.1 deg\"",
            ));
        }
    };
    made.map_err(|cause| {
        refuse.conflict(
            "grating",
            cause.to_string(),
            "give a grating that can exist",
        )
    })
}

fn fringes(refuse: Refuse<'_>, given: &FringesFormat) -> Result<Fringes, SceneError> {
    let depth = match given.bits {
        None | Some(8) => Depth::Eight,
        Some(16) => Depth::Sixteen,
        Some(bits) => return Err(refuse.out_of_range("fringes.bits", &bits, "8 or 16")),
    };
    let number = |name: &str, value: f64, fits: bool, allowed: &str| {
        refuse.within(&format!("fringes.{name}"), value, fits, allowed)
    };
    let exposure = Exposure {
        background: number(
            "background",
            given.background,
            given.background > 0.0,
            "greater than 0",
        )?,
        modulation: number(
            "modulation",
            given.modulation,
            given.modulation > 0.0 && given.modulation <= given.background,
            "greater than 0 and at most the background",
        )?,
        order_error: number(
            "order_error",
            given.order_error,
            given.order_error >= 0.0,
            "at least 0",
        )?,
        noise: number(
            "camera_noise",
            given.camera_noise,
            given.camera_noise >= 0.0,
            "at least 0",
        )?,
        speckle_patterns: given
            .speckle
            .map(|count| refuse.within("fringes.speckle", count, count > 0, "at least 1"))
            .transpose()?,
        depth: Some(depth),
    };
    let none = [[0.0; 2]; 2];
    Ok(Fringes {
        window: refuse.window("fringes.window", &given.window)?,
        pixel: refuse.positive("fringes.pixel", &given.pixel)?,
        carrier: given
            .carrier
            .as_ref()
            .map_or(none, |both| [gradient(&both.u), gradient(&both.v)]),
        exposure,
        missing: refuse.areas("fringes.missing", &given.missing)?,
        four: given.pictures == SeriesFormat::Four,
        format: match given.format {
            FileKindFormat::Png => FileFormat::Png,
            FileKindFormat::Tiff => FileFormat::Tiff,
        },
        depth,
        seed: given.seed,
    })
}
