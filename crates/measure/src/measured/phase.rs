//! From fringe pictures to orders without jumps.

use stickslip_fem_core::mesh::Point;
use stickslip_hybrid::fringe::{
    Carrier, FourierOptions, Frame, FringeError, Phase, PixelMap, Plane, Unwrapped, four_step,
    fourier,
};

use super::{PictureField, Scope};

/// Pictures of one field and what is known of them.
pub(super) struct FieldInput {
    /// One, or four with shifted phase.
    pub(super) pictures: Vec<PixelMap>,
    /// The carrier, if it is known `[1/mm]`.
    pub(super) carrier: Option<[f64; 2]>,
    /// Direction in which orders rise, for a carrier that is not.
    pub(super) rising: [f64; 2],
}

/// One field less a carrier.
#[derive(Clone, Debug)]
pub(super) struct Unwound {
    /// The field; of its orders the largest region alone.
    pub(super) field: PictureField,
    /// Whether the carrier was known, and not found in the picture.
    pub(super) known: bool,
    /// Pixels of other regions, whose whole orders are not known.
    pub(super) apart: usize,
}

/// A phase and what its spectrum says.
struct Found {
    phase: Phase,
    carrier: [f64; 2],
    deviation: f64,
    resolution: f64,
    strength: Option<f64>,
}

/// The orders of a field.
pub(super) fn orders(scope: &Scope<'_>, input: FieldInput) -> Result<Unwound, FringeError> {
    let shown: Vec<PixelMap> = input
        .pictures
        .iter()
        .map(|picture| picture.restricted(|place| scope.shows(place)))
        .collect::<Result<_, _>>()?;
    let found = match &shown[..] {
        [picture] => single(scope, &input, picture)?,
        _ => stepped(&input, &shown)?,
    };
    let least = scope.experiment.reduce.least_modulation * found.phase.median_modulation();
    let phase = found.phase.above(least)?;
    let carrier = Plane {
        gradient: found.carrier,
        constant: 0.0,
    };
    let phase = phase.demodulated(&carrier)?;
    let unwrapped = phase.unwrapped()?;
    let frame = *phase.wrapped().frame();
    let cuts = unwrapped.cuts.iter();
    let cuts = cuts.map(|&[a, b]| middle(frame.place(a), frame.place(b)));
    let residues = unwrapped.residues.iter();
    let residues = residues.map(|residue| loop_middle(&frame, residue.pixel));
    let (residues, cuts) = (residues.collect(), cuts.collect());
    // The phases of four pictures are those of their pixels, and mix nothing.
    let mixed = if shown.len() == 1 {
        found.resolution
    } else {
        0.0
    };
    let (orders, apart) = largest_region(scope, &unwrapped, mixed)?;
    let field = PictureField {
        picture: first(input.pictures)?,
        wrapped: phase.wrapped().clone(),
        orders,
        residues,
        cuts,
        deviation: found.deviation,
        resolution: found.resolution,
        carrier: found.carrier,
        strength: found.strength,
        modulation: phase.median_modulation(),
        of_null: false,
    };
    Ok(Unwound {
        field,
        known: input.carrier.is_some() || shown.len() > 1,
        apart,
    })
}

fn first(pictures: Vec<PixelMap>) -> Result<PixelMap, FringeError> {
    let none = FringeError::Masked { pixels: 0 };
    pictures.into_iter().next().ok_or(none)
}

fn single(scope: &Scope<'_>, input: &FieldInput, picture: &PixelMap) -> Result<Found, FringeError> {
    let carrier = match input.carrier {
        Some(gradient) => Carrier::Given(gradient),
        None => Carrier::Found {
            towards: input.rising,
        },
    };
    let options = FourierOptions {
        band: scope.experiment.reduce.band,
        settled: scope.experiment.reduce.settled,
        ..FourierOptions::new(carrier)
    };
    let found = fourier(picture, &options)?;
    Ok(Found {
        deviation: found.deviation(),
        carrier: found.carrier,
        resolution: found.resolution,
        strength: Some(found.strength),
        phase: found.phase,
    })
}

fn stepped(input: &FieldInput, pictures: &[PixelMap]) -> Result<Found, FringeError> {
    let [a, b, c, d] = pictures else {
        return Err(FringeError::Masked { pixels: 0 });
    };
    let phase = four_step(&[a.clone(), b.clone(), c.clone(), d.clone()], 0.0)?;
    let step = phase.wrapped().frame().step();
    let carrier = input.carrier.unwrap_or([0.0; 2]);
    let deviation = roughness(&phase.demodulated(&Plane {
        gradient: carrier,
        constant: 0.0,
    })?);
    Ok(Found {
        deviation,
        carrier,
        resolution: step[0].abs().max(step[1].abs()),
        strength: None,
        phase,
    })
}

/// Standard deviation of orders that are independent from pixel to pixel `[fringes]`: second differences along rows have √6 of it, and
/// their median magnitude does not see where fringes are steep or jump.
fn roughness(phase: &Phase) -> f64 {
    let map = phase.wrapped();
    let (values, columns) = (map.values(), map.frame().columns());
    let mut differences: Vec<f64> = Vec::new();
    for row in values.chunks(columns) {
        for triple in row.windows(3) {
            let second = triple[0] - 2.0 * triple[1] + triple[2];
            if second.is_finite() {
                differences.push((second - second.round()).abs());
            }
        }
    }
    super::scatter::deviation_of_magnitudes(differences) / 6.0_f64.sqrt()
}

fn middle(a: Point, b: Point) -> Point {
    [0, 1].map(|axis| f64::midpoint(a[axis], b[axis]))
}

/// Middle of the loop of four pixels that begins at one.
fn loop_middle(frame: &Frame, pixel: usize) -> Point {
    let (place, step) = (frame.place(pixel), frame.step());
    [place[0] + 0.5 * step[0], place[1] + 0.5 * step[1]]
}

/// Orders of the largest region without the pixels at cuts and near the hole, where phases are those of both sides within `mixed`
/// \[mm\], and how many pixels the other regions have.
fn largest_region(
    scope: &Scope<'_>,
    unwrapped: &Unwrapped,
    mixed: f64,
) -> Result<(PixelMap, usize), FringeError> {
    let sizes = unwrapped.regions.iter().map(|region| region.pixels);
    let largest = sizes.clone().enumerate().max_by_key(|(_, pixels)| *pixels);
    let (own, pixels) = largest.unwrap_or((0, 0));
    let mut cut = vec![false; unwrapped.region_of.len()];
    for pixel in unwrapped.cuts.iter().flatten() {
        cut[*pixel] = true;
    }
    let frame = *unwrapped.orders.frame();
    let keep = |pixel: usize| {
        unwrapped.region_of[pixel] == Some(own as u32)
            && !cut[pixel]
            && scope.is_away(frame.place(pixel), mixed)
    };
    let values = unwrapped.orders.values().iter().enumerate();
    let values = values.map(|(pixel, &order)| if keep(pixel) { order } else { f64::NAN });
    let orders = PixelMap::with_gaps(frame, values.collect())?;
    Ok((orders, sizes.sum::<usize>() - pixels))
}
