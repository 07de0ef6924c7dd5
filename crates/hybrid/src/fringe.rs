//! Fringe pictures: synthesis, phase, unwrapping, carrier.
//!
//! A moiré pattern shows a displacement component u as fringes of order N, counted from a carrier and a rigid-body motion, both of
//! them planes:
//!
//! ```text
//! N = f u + k_x x + k_y y + k₀,     I = a + b cos 2πN
//! ```
//!
//! with the grating's frequency f `[lines/length]`, the carrier's gradient k `[fringes/length]`, the mean intensity a and the amplitude b.
//! The way back leads from pictures to the phase N modulo 1, to orders without jumps, to orders without carrier, to displacements.
//! Phases are given in fringes throughout: N, not 2πN.
//!
//! | step | by |
//! | --- | --- |
//! | order fields and pictures of known displacements | [`orders`], [`orders_of`], [`picture`], [`four_pictures`] |
//! | picture files | [`encode`], [`decode`] |
//! | phase, from four pictures or from one with a carrier | [`four_step`], [`fourier`] |
//! | orders without jumps | [`unwrap`] |
//! | carrier, rigid-body motion, constant | [`Plane`], [`Unwrapped::fixed`] |
//! | displacements | [`measurement`] |
//!
//! Errors of the orders (root mean square, in fringes), measured on Kirsch's displacements around a hole: 31 fringes in U and 11 in V,
//! 512 × 512 pixels, a carrier of 0.16 fringes per pixel, b = 0.4 of full scale, the default band; 8 bits change nothing:
//!
//! | picture | [`fourier`] | of [`FourierPhase::deviation`] | [`four_step`] |
//! | --- | --- | --- | --- |
//! | clean, U, up to all edges / 12 pixels away | 0.0029 / 0.0009 | – | rounding |
//! | clean, V, up to all edges / 12 pixels away | 0.0010 / 0.0002 | – | rounding |
//! | noise σ/b = 0.05 | 0.0018 | 1.00 | 0.0056 |
//! | noise σ/b = 0.125 | 0.0044 | 1.00 | 0.0141 |
//! | noise σ/b = 0.25 | 0.0087 | 1.00 | 0.0286 |
//! | noise σ/b = 0.5 | 0.0175 | 1.01 | 0.0622 |
//! | orders uniform in ±0.1 fringe, pixel by pixel | 0.0110 | 1.19 | |
//! | orders uniform in ±¼ fringe, pixel by pixel | 0.0336 | 1.16 | |
//! | speckle of contrast ¼, ½, 1 | 0.0117, 0.0237, 0.0495 | 0.94, 0.95, 1.01 | |
//!
//! Errors of the orders themselves exceed what the noise of the intensity lets expect, by √1.5 at most, because all of them is
//! phase. In first order a Fourier phase's standard deviation is σ/b √(2 ΣH²/n) / 2π with the band's weights H, and that of four pictures
//! σ/b / (√2 · 2π).

mod carrier;
mod check;
mod fourier;
mod map;
mod measured;
mod order;
mod phase;
mod plane;
mod raster;
mod sideband;
mod spectrum;
mod synthesis;
mod unwrap;

use stickslip_fem_core::mesh::Point;
use thiserror::Error;

pub use carrier::{Carrier, FourierOptions};
pub use fourier::{FourierPhase, fourier};
pub use map::{Frame, PixelMap};
pub use measured::measurement;
pub use phase::{Phase, four_step};
pub use plane::{Constant, KnownOrder, Plane, PlaneFit};
pub use raster::{Format, Raster, decode, encode, size};
pub use synthesis::{Depth, Exposure, four_pictures, orders, orders_of, picture};
pub use unwrap::{Region, Residue, Unwrapped, unwrap};

/// Most pixels of a picture, so that a slip of the pen is an error and no exhausted memory.
const MOST_PIXELS: usize = 1 << 28;

/// Why a fringe picture cannot be made or read.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum FringeError {
    /// A frame without pixels, or whose pixels have no place.
    #[error(
        "no picture has {columns} x {rows} pixels with steps ({}, {}); \
         1 to {} pixels and finite steps that are not zero make one",
        step[0], step[1], MOST_PIXELS
    )]
    Frame {
        /// Requested columns.
        columns: usize,
        /// Requested rows.
        rows: usize,
        /// Steps from pixel to pixel `[length]`.
        step: [f64; 2],
    },
    /// A list does not have one entry per pixel.
    #[error("{found} values for a picture of {columns} x {rows} pixels")]
    Size {
        /// Columns of the picture.
        columns: usize,
        /// Rows of the picture.
        rows: usize,
        /// Entries given.
        found: usize,
    },
    /// Pictures that belong together differ in size or place.
    #[error("pictures that belong together differ: {}, and {}", .0.0, .0.1)]
    Frames(Box<(Frame, Frame)>),
    /// All pixels are missing.
    #[error("all {pixels} pixels are missing or masked")]
    Masked {
        /// Pixels of the picture.
        pixels: usize,
    },
    /// A pixel that is not marked as missing has no finite value.
    #[error("the pixel in column {column} and row {row} has the value {value}; mark it as missing")]
    NotFinite {
        /// Column of the pixel, from 0.
        column: usize,
        /// Row of the pixel, from 0.
        row: usize,
        /// Its value, in the unit of the picture or map.
        value: f64,
    },
    /// A parameter is out of its range.
    #[error("the {name} is {value}; it has to be {range}")]
    Parameter {
        /// The parameter.
        name: &'static str,
        /// Its value, in the unit of the parameter.
        value: f64,
        /// What it may be.
        range: &'static str,
    },
    /// Bytes that are no picture file, or a picture that no file holds.
    #[error("picture file: {0}")]
    File(String),
    /// A picture in colour.
    #[error(
        "picture file in colour ({0}); save it in grey, 8 or 16 bits, from the channel that shows the fringes best"
    )]
    Colour(String),
    /// No pixel has fringes.
    #[error("the fringes' amplitude is {greatest} at most, and {least} or less counts as none")]
    Modulation {
        /// Greatest amplitude `[intensity]`.
        greatest: f64,
        /// Amplitude that does not suffice `[intensity]`.
        least: f64,
    },
    /// The pixels cannot show a carrier.
    #[error(
        "a carrier of ({}, {}) fringes per length makes {fringes:.1} fringes in the picture and ({:.3}, {:.3}) per pixel; \
         at least {least} and less than 0.5 can be seen",
        gradient[0], gradient[1], cycles[0], cycles[1]
    )]
    CarrierRange {
        /// The carrier `[fringes/length]`.
        gradient: [f64; 2],
        /// Fringes per pixel along columns and rows `[fringes/px]`.
        cycles: [f64; 2],
        /// Fringes across the picture `[fringes]`.
        fringes: f64,
        /// Least number of fringes across the picture `[fringes]`.
        least: f64,
    },
    /// The spectrum has no peak where a carrier could be.
    #[error(
        "no carrier: the strongest peak of the spectrum has {strength:.1} times the power of the noise, less than {least:.1}; \
         add carrier fringes by turning the grating or the mirror, or take four pictures with shifted phase"
    )]
    NoCarrier {
        /// Power of the peak over that of the noise `[1]`.
        strength: f64,
        /// What it takes to exclude noise `[1]`.
        least: f64,
    },
    /// The fringes leave the carrier's band.
    #[error(
        "only {:.0} % of the fringes' power lies in the carrier's band, less than {:.0} %: the fringes turn back or are too steep; \
         add carrier fringes, or give the carrier",
        100.0 * share, 100.0 * least
    )]
    Crowded {
        /// Part of the power in the band `[1]`.
        share: f64,
        /// Requested least part `[1]`.
        least: f64,
    },
    /// A region's pixels do not span a plane.
    #[error(
        "{pixels} pixels of the region do not determine a plane; three that are not in line are needed"
    )]
    NoPlane {
        /// Pixels in the region.
        pixels: usize,
    },
    /// A known order lies where the picture has none.
    #[error("the known order at ({}, {}) lies where the picture has no order", place[0], place[1])]
    NoOrderAt {
        /// The place `[length]`.
        place: Point,
    },
    /// Known orders contradict the picture.
    #[error(
        "known orders at ({}, {}) and ({}, {}) are {difference:+.3} fringes apart from what the picture shows between them",
        first[0], first[1], second[0], second[1]
    )]
    KnownOrders {
        /// Place of the first `[length]`.
        first: Point,
        /// Place of the second `[length]`.
        second: Point,
        /// Difference less that of the picture `[fringes]`.
        difference: f64,
    },
}
