//! Synthetic fringe pictures of a solved scene.
//!
//! ```text
//! N = f u + k·x,     I = a + b cos 2πN
//! ```

use std::sync::Arc;

use stickslip_hybrid::data::Field;
use stickslip_hybrid::fringe::{
    Frame, FringeError, PixelMap, Plane, encode, four_pictures, orders_of, picture,
};
use stickslip_hybrid::moire::Grating;

use super::error::ExperimentError;
use super::finding::{Finding, Located, Part, PictureFinding};
use super::truth::{Sampling, Truth};
use stickslip_experiment::{Experiment, Fringes, Source};

/// How synthetic pictures are taken of a solved scene: pixels found in the mesh once, for all states.
#[derive(Clone, Debug)]
pub struct Camera<'a> {
    experiment: &'a Experiment,
    truth: &'a Truth,
    fringes: &'a Fringes,
    grating: Grating,
    frame: Frame,
    sampling: Arc<Sampling>,
    seed: u64,
}

/// Pictures of one field.
#[derive(Clone, Debug)]
pub struct FieldPictures {
    /// Fringe orders without noise, carrier included.
    pub orders: PixelMap,
    /// One picture, or four with shifted phase.
    pub pictures: Vec<PixelMap>,
}

/// What a picture is taken of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shot {
    /// A state itself.
    State,
    /// Its null field.
    Null,
    /// Its back.
    Back,
}

/// The synthetic pictures of a state: of itself, its null field, its back.
#[derive(Clone, Debug, Default)]
pub struct Shots(Vec<(Shot, [FieldPictures; 2])>);

impl Shots {
    /// Pictures of the U and the V field, if these are synthetic.
    pub fn get(&self, shot: Shot) -> Option<&[FieldPictures; 2]> {
        let found = self.0.iter().find(|(own, _)| *own == shot);
        found.map(|(_, fields)| fields)
    }

    /// Fringes of the state with the index `state` that are too fine for their pixels.
    pub fn located(&self, experiment: &Experiment, state: usize) -> Vec<Located> {
        let fields = Field::BOTH
            .into_iter()
            .zip(self.get(Shot::State).into_iter().flatten());
        let fine = fields.filter_map(|(field, own)| {
            let part = too_fine(&own.orders);
            let finding = PictureFinding::FineFringes {
                field: field.name(),
                part,
            };
            (part > 0.0).then_some(Finding::Picture(finding))
        });
        let name = &experiment.states[state].name;
        fine.map(|finding| Located::of_state(name, Part::State, finding))
            .collect()
    }

    /// All that there are.
    pub fn iter(&self) -> impl Iterator<Item = &(Shot, [FieldPictures; 2])> {
        self.0.iter()
    }
}

impl<'a> Camera<'a> {
    /// A camera in front of the solved scene of `experiment`.
    ///
    /// # Errors
    /// [`ExperimentError::Missing`] without `[fringes]` or `[grating]`; [`ExperimentError::Fringes`] for a window without pixels.
    pub fn new(experiment: &'a Experiment, truth: &'a Truth) -> Result<Self, ExperimentError> {
        let (Some(fringes), Some(grating)) = (&experiment.fringes, experiment.grating) else {
            return Err(ExperimentError::Missing {
                key: String::new(),
                what: "synthetic pictures need [fringes] and [grating]".to_owned(),
                remedy:
                    "add [grating] frequency = \"2400 1/mm\" and [fringes] with window and pixel"
                        .to_owned(),
            });
        };
        let refused = |cause| ExperimentError::fringes("all", "U and V", "fringes", cause);
        let frame = Frame::over(fringes.window, fringes.pixel).map_err(refused)?;
        let pictures = if fringes.four { 8.0 } else { 2.0 };
        let pixels = frame.columns() as f64 * frame.rows() as f64;
        let limits = experiment.limits();
        let fits = limits.check_pixels(pixels * pictures);
        fits.map_err(|cause| ExperimentError::Memory {
            key: "fringes.pixel".to_owned(),
            what: format!(
                "synthetic pictures have {} x {} pixels",
                frame.columns(),
                frame.rows()
            ),
            cause,
        })?;
        let places: Vec<_> = (0..frame.pixels())
            .map(|pixel| frame.place(pixel))
            .collect();
        let sampling = truth.sampled(&places);
        Ok(Self {
            experiment,
            truth,
            fringes,
            grating,
            frame,
            sampling: Arc::new(sampling),
            seed: fringes.seed,
        })
    }

    /// The same camera with other noise.
    #[must_use]
    pub fn with_seed(&self, seed: u64) -> Self {
        Self {
            seed,
            ..self.clone()
        }
    }

    /// The grating.
    pub fn grating(&self) -> &Grating {
        &self.grating
    }

    /// How the pictures are taken.
    pub fn fringes(&self) -> &Fringes {
        self.fringes
    }

    /// Where the pixels lie.
    pub fn frame(&self) -> &Frame {
        &self.frame
    }

    /// All pictures of a state that are synthetic.
    ///
    /// # Errors
    /// As [`Camera::pictures`].
    pub fn shots(&self, state: usize) -> Result<Shots, ExperimentError> {
        let plan = &self.experiment.states[state];
        let sources = [
            (Shot::State, Some(&plan.source)),
            (Shot::Null, plan.null.as_ref()),
            (Shot::Back, plan.back.as_ref()),
        ];
        let mut shots = Vec::new();
        for (shot, source) in sources {
            if let Some(Source::Step(step)) = source {
                shots.push((shot, self.pictures(state, *step, shot)?));
            }
        }
        Ok(Shots(shots))
    }

    /// The pictures of both fields of a state at a load step, counted from 0.
    ///
    /// # Errors
    /// [`ExperimentError::Fringes`]: a window beside the body, all of it missing.
    pub fn pictures(
        &self,
        state: usize,
        step: usize,
        shot: Shot,
    ) -> Result<[FieldPictures; 2], ExperimentError> {
        let take = |field: Field| {
            self.field(step, field, self.seed(state, field, shot))
                .map_err(|cause| {
                    let name = &self.experiment.states[state].name;
                    ExperimentError::fringes(name, field.name(), "fringes.window", cause)
                })
        };
        Ok([take(Field::U)?, take(Field::V)?])
    }

    /// Displacement of each pixel `[mm]`, without noise.
    ///
    /// # Errors
    /// [`FringeError`]: nothing of the body in sight.
    pub fn displacement(&self, step: usize, field: Field) -> Result<PixelMap, FringeError> {
        let found = self
            .truth
            .component(&self.sampling, step, field.component());
        let seen = |pixel: usize| {
            let place = self.frame.place(pixel);
            !self.fringes.missing.iter().any(|area| area.contains(place))
        };
        let values = found
            .into_iter()
            .enumerate()
            .map(|(pixel, value)| value.filter(|_| seen(pixel)).unwrap_or(f64::NAN));
        PixelMap::with_gaps(self.frame, values.collect())
    }

    fn field(&self, step: usize, field: Field, seed: u64) -> Result<FieldPictures, FringeError> {
        let carrier = Plane {
            gradient: self.fringes.carrier[field.component()],
            constant: 0.0,
        };
        let displacement = self.displacement(step, field)?;
        let orders = orders_of(&displacement, self.grating.frequency(), &carrier)?;
        let exposure = &self.fringes.exposure;
        let pictures = if self.fringes.four {
            four_pictures(&orders, exposure, seed)?.into()
        } else {
            vec![picture(&orders, exposure, seed)?]
        };
        Ok(FieldPictures { orders, pictures })
    }

    /// A seed of its own for every picture.
    fn seed(&self, state: usize, field: Field, shot: Shot) -> u64 {
        const SHOTS: u64 = 3;
        let own = (state as u64 * SHOTS + shot as u64) * 2 + field.component() as u64;
        // Neighbouring seeds of experiments must not share pictures: a multiplier that is odd keeps all distinct.
        self.seed
            .wrapping_mul(0x9E37_79B9_7F4A_7C15)
            .wrapping_add(own)
    }

    /// The files of a field's pictures: name without folder, and bytes.
    ///
    /// # Errors
    /// [`ExperimentError::Fringes`] where the pictures are too large for their format.
    pub fn files(
        &self,
        state: usize,
        shot: Shot,
        field: Field,
        pictures: &FieldPictures,
    ) -> Result<Vec<(String, Vec<u8>)>, ExperimentError> {
        let names = file_names(self.experiment, state, shot, field);
        let encoded = names.into_iter().zip(&pictures.pictures);
        encoded
            .map(|(name, picture)| {
                let bytes = encode(picture, self.fringes.format, self.fringes.depth);
                let bytes = bytes.map_err(|cause| {
                    let name = &self.experiment.states[state].name;
                    ExperimentError::fringes(name, field.name(), "fringes", cause)
                })?;
                Ok((name, bytes))
            })
            .collect()
    }
}

/// Part of the pixels whose order differs from that of the next one to the right or below by half a fringe or more.
fn too_fine(orders: &PixelMap) -> f64 {
    let (values, columns) = (orders.values(), orders.frame().columns());
    let far = |pixel: usize, next: usize| {
        let step: Option<f64> = values.get(next).map(|next| next - values[pixel]);
        step.is_some_and(|step| step.abs() >= 0.5)
    };
    let (mut seen, mut fine) = (0.0, 0.0);
    for (pixel, _) in orders.present() {
        let at_end = (pixel + 1).is_multiple_of(columns);
        seen += 1.0;
        if far(pixel, pixel + columns) || (!at_end && far(pixel, pixel + 1)) {
            fine += 1.0;
        }
    }
    fine / seen
}

/// Names of the picture files of a field, without folder.
pub fn file_names(experiment: &Experiment, state: usize, shot: Shot, field: Field) -> Vec<String> {
    use stickslip_hybrid::fringe::Format;
    let Some(fringes) = &experiment.fringes else {
        return Vec::new();
    };
    let end = match fringes.format {
        Format::Png => "png",
        Format::Tiff => "tiff",
    };
    let part = match shot {
        Shot::State => "",
        Shot::Null => "-null",
        Shot::Back => "-back",
    };
    let letter = field.name().to_lowercase();
    let name = &experiment.states[state].name;
    if fringes.four {
        (1..=4)
            .map(|k| format!("{name}{part}-{letter}-{k}.{end}"))
            .collect()
    } else {
        vec![format!("{name}{part}-{letter}.{end}")]
    }
}
