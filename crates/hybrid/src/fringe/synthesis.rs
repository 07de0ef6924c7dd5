//! Fringe-order fields and pictures of known displacements.

use std::f64::consts::TAU;

use rand::rngs::StdRng;
use rand::{RngExt, SeedableRng};
use stickslip_fem_core::mesh::Point;

use super::check::{not_negative, parameter, positive};
use super::{Frame, FringeError, PixelMap, Plane};
use crate::random::{exponential, normal};

/// Whole numbers in which a camera counts intensity.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Depth {
    /// 8 bits: 256 grey levels.
    Eight,
    /// 16 bits: 65 536 grey levels.
    Sixteen,
}

impl Depth {
    /// Greatest grey level `[1]`, which stands for the intensity 1.
    pub fn full_scale(self) -> f64 {
        match self {
            Self::Eight => f64::from(u8::MAX),
            Self::Sixteen => f64::from(u16::MAX),
        }
    }
}

/// How a picture is exposed; intensities are parts of the camera's full scale.
#[derive(Clone, Debug, PartialEq)]
pub struct Exposure {
    /// Mean intensity a `[intensity]`, positive.
    pub background: f64,
    /// Amplitude b of the fringes `[intensity]`, positive and at most the mean.
    pub modulation: f64,
    /// Greatest error e of the order of a pixel `[fringes]`: uniform in ±e, independent from pixel to pixel, the same in all
    /// pictures of a phase-stepped series.
    pub order_error: f64,
    /// Speckle: number M of independent speckle patterns that add up in a pixel. Intensities are multiplied by a factor of mean 1
    /// and contrast 1/√M with a gamma distribution (Goodman 1975), independent from pixel to pixel and the same in all pictures of
    /// a series.
    pub speckle_patterns: Option<u32>,
    /// Standard deviation of the camera's additive normal noise `[intensity]`.
    pub noise: f64,
    /// Grey levels; values outside 0 and 1 are clipped. Without it intensities are neither rounded nor clipped.
    pub depth: Option<Depth>,
}

impl Default for Exposure {
    /// Mean 0.5, amplitude 0.4, no errors, no quantisation.
    fn default() -> Self {
        Self {
            background: 0.5,
            modulation: 0.4,
            order_error: 0.0,
            speckle_patterns: None,
            noise: 0.0,
            depth: None,
        }
    }
}

impl Exposure {
    fn check(&self) -> Result<(), FringeError> {
        positive("background", self.background)?;
        let bounded = self.modulation > 0.0 && self.modulation <= self.background;
        parameter(
            "modulation",
            self.modulation,
            bounded,
            "positive and at most the background",
        )?;
        not_negative("order error", self.order_error)?;
        not_negative("noise", self.noise)?;
        let counted = self.speckle_patterns != Some(0);
        parameter("speckle patterns", 0.0, counted, "at least 1")
    }
}

/// Fringe orders N = f u + carrier of a displacement component `[length]` that is a function of the place, missing where it has no
/// value; `frequency` f is in lines per `[length]`.
///
/// # Errors
///
/// A frequency that is not positive, no value at any pixel, a value that is not finite.
pub fn orders(
    frame: Frame,
    frequency: f64,
    carrier: &Plane,
    displacement: impl Fn(Point) -> Option<f64>,
) -> Result<PixelMap, FringeError> {
    positive("frequency", frequency)?;
    PixelMap::of(frame, |place| {
        displacement(place).map(|value| frequency * value + carrier.at(place))
    })
}

/// Fringe orders N = f u + carrier of a displacement component `[length]` given pixel by pixel; `frequency` f is in lines per
/// `[length]`.
///
/// # Errors
///
/// A frequency that is not positive; an order that is not finite.
pub fn orders_of(
    displacement: &PixelMap,
    frequency: f64,
    carrier: &Plane,
) -> Result<PixelMap, FringeError> {
    positive("frequency", frequency)?;
    displacement
        .mapped(|pixel, value| frequency * value + carrier.at(displacement.frame().place(pixel)))
}

/// Picture a + b cos 2πN of fringe orders. The same `seed` gives the same picture.
///
/// # Errors
///
/// An exposure out of its range.
pub fn picture(orders: &PixelMap, exposure: &Exposure, seed: u64) -> Result<PixelMap, FringeError> {
    let mut random = StdRng::seed_from_u64(seed);
    Surface::new(orders, exposure, &mut random)?.exposed(0.0, exposure, &mut random)
}

/// The four pictures a + b cos 2π(N + k/4), k = 0 … 3, of one surface, with the camera's noise anew in each. The same `seed` gives
/// the same pictures.
///
/// # Errors
///
/// An exposure out of its range.
pub fn four_pictures(
    orders: &PixelMap,
    exposure: &Exposure,
    seed: u64,
) -> Result<[PixelMap; 4], FringeError> {
    let mut random = StdRng::seed_from_u64(seed);
    let surface = Surface::new(orders, exposure, &mut random)?;
    let mut step = |quarters: f64| surface.exposed(quarters / 4.0, exposure, &mut random);
    Ok([step(0.0)?, step(1.0)?, step(2.0)?, step(3.0)?])
}

/// What all pictures of a series share: orders with their errors, and the factor of the speckles.
struct Surface {
    orders: PixelMap,
    speckle: Option<Vec<f64>>,
}

impl Surface {
    fn new(
        orders: &PixelMap,
        exposure: &Exposure,
        random: &mut StdRng,
    ) -> Result<Self, FringeError> {
        exposure.check()?;
        let mut values = orders.values().to_vec();
        if exposure.order_error > 0.0 {
            for value in &mut values {
                *value += exposure.order_error * random.random_range(-1.0..=1.0);
            }
        }
        let speckle = exposure.speckle_patterns.map(|patterns| {
            values
                .iter()
                .map(|_| {
                    (0..patterns).map(|_| exponential(random)).sum::<f64>() / f64::from(patterns)
                })
                .collect()
        });
        Ok(Self {
            orders: PixelMap::new(*orders.frame(), values, orders.valid().to_vec())?,
            speckle,
        })
    }

    fn exposed(
        &self,
        shift: f64,
        exposure: &Exposure,
        random: &mut StdRng,
    ) -> Result<PixelMap, FringeError> {
        let mut values = Vec::with_capacity(self.orders.values().len());
        for (pixel, &order) in self.orders.values().iter().enumerate() {
            let fringes = exposure.background + exposure.modulation * (TAU * (order + shift)).cos();
            let clean = fringes * self.speckle.as_ref().map_or(1.0, |factor| factor[pixel]);
            let noise = if exposure.noise > 0.0 {
                exposure.noise * normal(random)
            } else {
                0.0
            };
            values.push(
                exposure
                    .depth
                    .map_or(clean + noise, |depth| quantised(clean + noise, depth)),
            );
        }
        PixelMap::new(*self.orders.frame(), values, self.orders.valid().to_vec())
    }
}

fn quantised(intensity: f64, depth: Depth) -> f64 {
    (intensity.clamp(0.0, 1.0) * depth.full_scale()).round() / depth.full_scale()
}
