//! Measured fields: displacements with their standard deviation and their mask, from tables, fringe pictures or fringe lines.
//!
//! ```text
//! u = (N − N₀) / f      orders less those of the carrier, or of the null field with the same carrier
//! ```
//!
//! A picture shows neither whole orders nor the rigid motion of the plate: U and V are known up to a constant each and, where the
//! carrier is not known to the last digit, a rotation. Neither changes any stress. A finite rotation does, to second order, and is taken off
//! each table before its null field is, and off pictures after it.

mod combine;
mod coverage;
mod elsewhere;
mod lines;
mod phase;
mod pictures;
mod rotation;
mod scatter;
mod symmetry;
mod table;

use std::collections::BTreeMap;

use stickslip_fem_core::mesh::Point;
use stickslip_hybrid::data::{Field, FringeLines, Measurement, Symmetry};
use stickslip_hybrid::fringe::PixelMap;
use stickslip_hybrid::moire::Grating;

use super::ends::span;
use super::error::ExperimentError;
use super::finding::{FieldFinding, Finding, Located, Part};
use super::synthesis::{Shot, Shots};
use stickslip_experiment::{Experiment, Source};
use stickslip_scene::limits::Content;

pub use rotation::TakenOff;

/// The measured field of one state.
#[derive(Clone, Debug)]
pub struct Measured {
    /// Index of the state in the experiment.
    pub state: usize,
    /// Displacements in base units, the null field taken off, masked where bad.
    pub measurement: Measurement,
    /// Fringe lines of the U and the V field, where the state has lines.
    pub lines: Option<[FringeLines; 2]>,
    /// What the pictures of the U and the V field say, where the state has pictures, or else where its null field has.
    pub pictures: [Option<PictureField>; 2],
    /// Front against back along the chosen line, U and V, before the null field is taken off.
    pub symmetry: Vec<(Field, Symmetry)>,
    /// Indices of the places of a table that are masked as outliers.
    pub outliers: Vec<usize>,
    /// Standard deviation `[mm]` that errors of U and V have at least, whatever residuals say: as stated, or as digits are rounded; 0
    /// where nothing says.
    pub floor: [f64; 2],
    /// Rotations of the specimen that were taken off.
    pub rotations: Vec<TakenOff>,
    /// What was assumed or left out, and what a reader must know before trusting the field.
    pub findings: Vec<(Part, Finding)>,
}

impl Measured {
    /// A field of displacements that is known in full, without lines, pictures or findings.
    pub fn new(state: usize, measurement: Measurement) -> Self {
        Self {
            state,
            measurement,
            lines: None,
            pictures: [None, None],
            symmetry: Vec::new(),
            outliers: Vec::new(),
            floor: [0.0; 2],
            rotations: Vec::new(),
            findings: Vec::new(),
        }
    }

    /// The findings with the name of the state.
    pub fn located(&self, experiment: &Experiment) -> impl Iterator<Item = Located> {
        let name = &experiment.states[self.state].name;
        let each = self.findings.iter();
        each.map(move |(part, finding)| Located::of_state(name, *part, finding.clone()))
    }

    fn found(&mut self, findings: impl IntoIterator<Item = Finding>) {
        self.found_in(Part::State, findings);
    }

    fn found_in(&mut self, part: Part, findings: impl IntoIterator<Item = Finding>) {
        let findings = findings.into_iter();
        self.findings.extend(findings.map(|own| (part, own)));
    }
}

/// One field as its pictures show it.
#[derive(Clone, Debug)]
pub struct PictureField {
    /// The picture, or the first of four.
    pub picture: PixelMap,
    /// Orders up to a whole number, in −½ … ½, less the carrier.
    pub wrapped: PixelMap,
    /// Orders without jumps, carrier and null field taken off (but for a null field that is a table); one region.
    pub orders: PixelMap,
    /// Middles of loops of four pixels around which orders do not close, those of the null field's picture too `[mm]`.
    pub residues: Vec<Point>,
    /// Middles between neighbouring pixels that differ by half a fringe or more `[mm]`; their orders are masked.
    pub cuts: Vec<Point>,
    /// Standard deviation of an order `[fringes]`.
    pub deviation: f64,
    /// Length over which errors depend on each other `[mm]`.
    pub resolution: f64,
    /// The carrier that was taken off `[1/mm]`.
    pub carrier: [f64; 2],
    /// Power of the carrier's peak over that of the noise, of a single picture.
    pub strength: Option<f64>,
    /// Median amplitude of the fringes, part of full scale.
    pub modulation: f64,
    /// Whether this is a picture of the null field alone: the state's own data are a table.
    pub of_null: bool,
}

/// The measured field of a state; `shots` are its synthetic pictures.
///
/// # Errors
/// [`ExperimentError`]: files that cannot be read, invalid data, pictures without fringes, a region without data.
pub fn state(
    experiment: &Experiment,
    state: usize,
    shots: &Shots,
) -> Result<Measured, ExperimentError> {
    let plan = &experiment.states[state];
    let key = format!("states.{state}");
    let scope = |key: String| Scope {
        experiment,
        state,
        key,
    };
    let read = |source: &Source, key: &str, shot: Shot| {
        let scope = scope(match source {
            Source::Step(_) => "fringes".to_owned(),
            Source::Table(_) => format!("{key}.table"),
            Source::Pictures(_) => format!("{key}.pictures"),
            Source::Lines(_) => format!("{key}.lines"),
        });
        read(&scope, source, shot, shots)
    };
    let own = read(&plan.source, &key, Shot::State)?;
    let null = plan.null.as_ref();
    let null = null
        .map(|source| read(source, &format!("{key}.null"), Shot::Null))
        .transpose()?;
    let scope = scope(key.clone());
    let compared = experiment.reduce.symmetry.as_ref().zip(plan.back.as_ref());
    // The back has no null field, so that it is compared with the front as that was measured.
    let front = match (compared, &null) {
        (Some(_), Some(_)) => {
            let front = combine::combined(&scope, own.clone(), None)?;
            Some((front, symmetry::of_carriers(&own)))
        }
        _ => None,
    };
    let mut measured = combine::combined(&scope, own, null)?;
    if let Some((line, source)) = compared {
        let back = read(source, &format!("{key}.back"), Shot::Back)?;
        let back = combine::combined(&scope, back, None)?;
        let (front, of_carriers) =
            front.map_or((None, None), |(front, found)| (Some(front), found));
        let sides = symmetry::compared(&scope, line, front.as_ref().unwrap_or(&measured), &back)?;
        let of_back = back.findings.into_iter().map(|(_, finding)| finding);
        measured.found_in(Part::Back, of_back);
        measured.symmetry = sides.found;
        measured.found(sides.findings.into_iter().chain(of_carriers));
    }
    if matches!(plan.source, Source::Table(_)) {
        measured.found(large(&measured.measurement));
    }
    coverage::check(&scope, &measured)?;
    Ok(measured)
}

/// What `source` says of a state, its null field or its back.
fn read(
    scope: &Scope<'_>,
    source: &Source,
    shot: Shot,
    shots: &Shots,
) -> Result<Reading, ExperimentError> {
    match source {
        Source::Step(_) => pictures::synthetic(scope, shots.get(shot)),
        Source::Table(source) => table::read(scope, source),
        Source::Pictures(source) => {
            // What a null field with the same carrier takes off need not be reported.
            let null = &scope.experiment.states[scope.state].null;
            let takes_off = matches!(shot, Shot::State) && null.is_none();
            pictures::read(scope, source, takes_off)
        }
        Source::Lines(source) => lines::read(scope, source),
    }
}

/// States that have the same data, each group once: a table under two loads, or one that was saved twice.
pub fn repeated(experiment: &Experiment, fields: &[Measured]) -> Vec<Located> {
    // Masked displacements are NaN, which equals nothing.
    let bits = |measured: &Measured| -> Vec<u64> {
        let data = &measured.measurement;
        let places = data.places.iter().flatten();
        let displacements = data.displacements.iter().flatten();
        places.chain(displacements).map(|x| x.to_bits()).collect()
    };
    let mut groups: BTreeMap<Vec<u64>, Vec<String>> = BTreeMap::new();
    for measured in fields {
        let names = groups.entry(bits(measured)).or_default();
        names.push(experiment.states[measured.state].name.clone());
    }
    let shared = groups.into_values().filter(|names| names.len() > 1);
    let found = shared.map(|states| Finding::Field(FieldFinding::SameData { states }));
    found.map(Located::of_all).collect()
}

/// Displacements that differ by more than small strains allow: the mark of a wrong scale.
fn large(measurement: &Measurement) -> Option<Finding> {
    const STRAIN: f64 = 0.02;
    let places = measurement.places.iter();
    let extent = [0, 1].map(|axis| span(places.clone().map(|place| place[axis])));
    let range = Field::BOTH.map(|field| range(measurement, field));
    let of_extent = range[0].max(range[1]) / extent[0].hypot(extent[1]);
    let found = FieldFinding::LargeDisplacements { of_extent };
    (of_extent > STRAIN).then_some(Finding::Field(found))
}

/// Greatest less least valid displacement `[mm]`.
fn range(measurement: &Measurement, field: Field) -> f64 {
    let c = field.component();
    let both = measurement.displacements[c]
        .iter()
        .zip(&measurement.valid[c]);
    span(both.filter(|(_, valid)| **valid).map(|(&value, _)| value))
}

/// What a source is read for.
#[derive(Clone, Debug)]
struct Scope<'a> {
    experiment: &'a Experiment,
    state: usize,
    /// Key of the source in the file.
    key: String,
}

impl Scope<'_> {
    fn name(&self) -> String {
        self.experiment.states[self.state].name.clone()
    }

    fn data(&self, cause: stickslip_hybrid::data::DataError) -> ExperimentError {
        ExperimentError::Data {
            state: self.name(),
            key: self.key.clone(),
            cause: Box::new(cause),
        }
    }

    fn fringes(
        &self,
        field: &'static str,
        cause: stickslip_hybrid::fringe::FringeError,
    ) -> ExperimentError {
        ExperimentError::fringes(&self.name(), field, &self.key, cause)
    }

    fn bytes(&self, path: &std::path::Path, content: Content) -> Result<Vec<u8>, ExperimentError> {
        let read = self.experiment.host().read(path, content);
        read.map_err(|cause| ExperimentError::File {
            key: self.key.clone(),
            path: path.display().to_string(),
            cause: cause.to_string(),
        })
    }

    /// The longest side of triangles in which data are interpolated `[mm]`; infinite where none is stated.
    fn longest_side(&self) -> f64 {
        let stated = self.experiment.reduce.longest_side;
        stated.unwrap_or(f64::INFINITY)
    }

    fn grating(&self) -> Result<Grating, ExperimentError> {
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
    fn shows(&self, place: Point) -> bool {
        let hole = self.experiment.specimen.hole;
        hole.from_centre(place) > hole.radius
            && !(self.experiment.reduce.mask.iter()).any(|area| area.contains(place))
    }

    /// Whether a place of data that resolve `resolved` \[mm\] is as far from the hole's edge as asked.
    fn is_away(&self, place: Point, resolved: f64) -> bool {
        let hole = self.experiment.specimen.hole;
        hole.from_centre(place) >= hole.radius + self.experiment.reduce.margin.unwrap_or(resolved)
    }
}

/// A source as it was read, before anything is taken off.
#[derive(Clone, Debug)]
enum Reading {
    /// Displacements at places of a table.
    Scattered(Box<Measured>),
    /// Orders at the pixels of the U and the V field.
    Pictures(Box<[Option<phase::Unwound>; 2]>),
    /// Fringe lines of the U and the V field.
    Lines(lines::Digitised),
}
