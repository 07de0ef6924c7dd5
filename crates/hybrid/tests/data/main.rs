//! Tables of measured displacements and of fringe centres, and gratings: what is read, what is masked, what is refused and in which
//! words.

mod combine;
mod gratings;
#[path = "../kirsch/mod.rs"]
#[allow(dead_code, reason = "other test targets use the rest of this module")]
mod kirsch;
mod lines;
mod outliers;
mod rotation;
mod tables;

use stickslip_hybrid::data::{DataError, Format, Measurement, Reading, Track};

fn pixels(scale: f64) -> Reading {
    Reading {
        scale: Some(scale),
        ..Reading::default()
    }
}

fn read(text: &str, format: &Format, reading: &Reading) -> Result<Measurement, DataError> {
    Measurement::read(text.as_bytes(), "test.csv", format, reading)
}

fn plain(text: &str) -> Result<Measurement, DataError> {
    read(text, &Format::plain(), &Reading::default())
}

fn hole(closed: bool) -> Track {
    Track::Circle {
        centre: [0.0; 2],
        closed,
    }
}
