//! From the text of an experiment file to a checked experiment.

use std::path::Path;
use std::sync::Arc;

use stickslip_hybrid::fringe::{Depth, Exposure, Format as FileFormat};
use stickslip_hybrid::moire::Grating;

use super::refuse::{Refuse, gradient};
use super::{Experiment, VERSION, laws, ranges, settings, specimen, states, unused};
use crate::format::{ExperimentFormat, FileKindFormat, FringesFormat, GratingFormat, SeriesFormat};
use crate::{Fringes, Reduce, Specimen, State};
use stickslip_scene::diagnostic::{SceneError, SceneProblem, SourceText};
use stickslip_scene::digest::sha256;
use stickslip_scene::host::Host;
use stickslip_scene::open::UnitsFormat;
use stickslip_scene::schema::DisplayUnits;
use stickslip_scene::{Format, open};

impl Experiment {
    /// Reads and checks a file of `host`, JSON if its name ends in `.json` and otherwise TOML, with the overrides `key=value` applied in
    /// turn. The files with data are not read yet; they and the models may take no more than the host's limits.
    ///
    /// # Errors
    /// [`SceneError`] with what is wrong at its line, in the experiment or in its scene; a file that is too large.
    pub fn from_file(
        path: &Path,
        overrides: &[impl AsRef<str>],
        host: Host,
    ) -> Result<Self, SceneError> {
        let source = open::text_of(path, host, SceneProblem::unreadable)?;
        let folder = path.parent().unwrap_or(Path::new(""));
        experiment(source, Format::of_path(path), folder, overrides, host)
    }

    /// Reads and checks an experiment. `name` stands for the text in errors, and files of `host` are looked for in `folder`.
    ///
    /// # Errors
    /// As [`Experiment::from_file`].
    pub fn from_text(
        text: &str,
        format: Format,
        name: &str,
        folder: &Path,
        overrides: &[impl AsRef<str>],
        host: Host,
    ) -> Result<Self, SceneError> {
        let source = SourceText {
            name: name.to_owned(),
            text: text.to_owned(),
        };
        experiment(source, format, folder, overrides, host)
    }
}

fn experiment(
    source: SourceText,
    format: Format,
    folder: &Path,
    overrides: &[impl AsRef<str>],
    host: Host,
) -> Result<Experiment, SceneError> {
    let source_name = source.name.clone();
    let document = open::document(source, format, overrides, host)?;
    open::check_version(&document, "experiment", VERSION)?;
    let read: ExperimentFormat = open::keys(&document)?;
    ranges::check(&document)?;
    let refuse = Refuse(&document);
    let mut specimen = specimen::read(refuse, &read, folder)?;
    let display = shown_in(read.units.as_ref(), &mut specimen);
    let grating = read.grating.as_ref().map(|given| grating(refuse, given));
    let grating = grating.transpose()?;
    let fringes = read.fringes.as_ref().map(|given| fringes(refuse, given));
    let fringes = fringes.transpose()?;
    let scope = states::Scope {
        refuse,
        specimen: &specimen,
        grating: grating.as_ref(),
        fringes: fringes.as_ref(),
        folder,
    };
    let states = scope.states(&read.states)?;
    let region = read.region.as_ref();
    let region = region.map(|given| settings::region(refuse, given, &specimen.hole, folder));
    let region = region.transpose()?;
    let reduce = settings::reduce(refuse, &read.reduce)?;
    check_symmetry(refuse, &reduce, &states)?;
    let scene = specimen.scene.as_ref().map(|own| own.scene.hash.as_str());
    Ok(Experiment {
        title: read.title.unwrap_or_else(|| open::stem(&source_name)),
        description: read.description,
        display,
        identify: settings::identify(refuse, &read.identify, &states)?,
        laws: laws::read(refuse, &read.laws, &specimen)?,
        hash: sha256(format!("{}\n{}", document.root, scene.unwrap_or_default())),
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

fn grating(refuse: Refuse<'_>, given: &GratingFormat) -> Result<Grating, SceneError> {
    let made = match (&given.frequency, &given.wavelength, &given.angle) {
        (Some(frequency), None, None) => Grating::new(frequency.value()),
        (None, Some(wavelength), Some(angle)) => {
            Grating::from_beams(wavelength.value(), angle.value())
        }
        _ => {
            let message = "a grating is given by its frequency, or by wavelength and angle";
            let remedy = "write frequency = \"2400 1/mm\", or wavelength = \"514.5e-6 mm\" and angle = \"38.1 deg\"";
            return Err(refuse.conflict("grating", message, remedy));
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
    let background = given.background.unwrap_or(0.5);
    let modulation = given.modulation.unwrap_or(0.4);
    if modulation > background {
        let allowed = "greater than 0 and at most the background";
        return Err(refuse.out_of_range("fringes.modulation", &modulation, allowed));
    }
    let depth = match given.bits {
        Some(16) => Depth::Sixteen,
        _ => Depth::Eight,
    };
    let exposure = Exposure {
        background,
        modulation,
        order_error: given.order_error,
        noise: given.camera_noise,
        speckle_patterns: given.speckle,
        depth: Some(depth),
    };
    let none = [[0.0; 2]; 2];
    Ok(Fringes {
        window: refuse.window("fringes.window", &given.window)?,
        pixel: given.pixel.value(),
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
        seed: given.seed.unwrap_or(1),
    })
}
