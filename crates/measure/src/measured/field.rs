//! A measured field of one state.

use stickslip_experiment::Experiment;
use stickslip_fem_core::mesh::Point;
use stickslip_hybrid::data::{Field, FringeLines, Measurement, Symmetry};
use stickslip_hybrid::fringe::PixelMap;

use super::rotation::TakenOff;
use crate::ends::span;
use crate::finding::{Finding, Located, Part};

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

    pub(super) fn found(&mut self, findings: impl IntoIterator<Item = Finding>) {
        self.found_in(Part::State, findings);
    }

    pub(super) fn found_in(&mut self, part: Part, findings: impl IntoIterator<Item = Finding>) {
        let findings = findings.into_iter();
        self.findings.extend(findings.map(|own| (part, own)));
    }
}

/// One field as its pictures show it.
#[derive(Clone, Debug)]
pub struct PictureField {
    /// The picture, or the first of four.
    pub picture: PixelMap,
    /// Orders up to a whole number, in −½ … ½, less the carrier `[fringes]`.
    pub wrapped: PixelMap,
    /// Orders without jumps, carrier and null field taken off (but for a null field that is a table) `[fringes]`; one region.
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
    /// Power of the carrier's peak over that of the noise `[1]`, of a single picture.
    pub strength: Option<f64>,
    /// Median amplitude of the fringes over full scale `[1]`.
    pub modulation: f64,
    /// Whether this is a picture of the null field alone: the state's own data are a table.
    pub of_null: bool,
}

/// Greatest less least valid displacement `[mm]`.
pub(super) fn range(measurement: &Measurement, field: Field) -> f64 {
    let c = field.component();
    let both = measurement.displacements[c]
        .iter()
        .zip(&measurement.valid[c]);
    span(both.filter(|(_, valid)| **valid).map(|(&value, _)| value))
}
