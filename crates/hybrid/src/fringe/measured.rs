//! Displacements from fringe orders.

use super::check::{not_negative, parameter, positive};
use super::{FringeError, PixelMap};
use crate::data::Measurement;

/// Displacements u = N / f at every `stride`-th pixel of every `stride`-th row, from the orders of the U and V pictures without
/// carrier; a picture may be absent, and its component is then nowhere valid. `frequency` f is in lines per `[length]`,
/// `deviations` of the orders are in fringes. A measurement's errors are independent from place to place: take a stride of at
/// least [`super::FourierPhase::resolution`] where the orders come from a band of the spectrum.
///
/// # Errors
///
/// Pictures of unlike frames; a frequency that is not positive, a standard deviation below 0, a stride of 0; no order at any pixel taken.
pub fn measurement(
    orders: [Option<&PixelMap>; 2],
    frequency: f64,
    deviations: [f64; 2],
    stride: usize,
) -> Result<Measurement, FringeError> {
    positive("frequency", frequency)?;
    parameter("stride", stride as f64, stride > 0, "at least 1")?;
    for deviation in deviations {
        not_negative("deviation", deviation)?;
    }
    let Some(frame) = orders.iter().flatten().map(|map| *map.frame()).next() else {
        return Err(FringeError::Masked { pixels: 0 });
    };
    if let [Some(first), Some(second)] = orders {
        first.same_frame(second)?;
    }
    let mut taken = Measurement {
        deviation: deviations.map(|deviation| deviation / frequency),
        ..Measurement::default()
    };
    for row in (0..frame.rows()).step_by(stride) {
        for column in (0..frame.columns()).step_by(stride) {
            let pixel = row * frame.columns() + column;
            let found = orders.map(|map| map.and_then(|map| map.get(pixel)));
            if found.iter().all(Option::is_none) {
                continue;
            }
            let displacements = found.map(|order| order.map(|order| order / frequency));
            taken.push(frame.place(pixel), displacements);
        }
    }
    if taken.places.is_empty() {
        Err(FringeError::Masked {
            pixels: frame.pixels(),
        })
    } else {
        Ok(taken)
    }
}
