//! Gratings: frequency, fringe orders, displacements, strains.
//!
//! ```text
//! f = (2/λ) sin α,   U = N_x / f,   V = N_y / f,
//! ε_x = (1/f) ∂N_x/∂x,   ε_y = (1/f) ∂N_y/∂y,   γ_xy = (1/f) (∂N_x/∂y + ∂N_y/∂x)
//! ```
//!
//! | symbol | meaning | unit |
//! | --- | --- | --- |
//! | f | frequency of the virtual reference grating | `[1/length]` |
//! | λ | wavelength of the light | `[length]` |
//! | α | angle of incidence of either beam | rad |
//! | N_x, N_y | fringe orders of the U and the V field | fringes |
//!
//! Source: Post & Reddy (1988), part I, 2.2, Eqs 1–5.

use thiserror::Error;

/// Why a grating cannot be.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum MoireError {
    /// A frequency `[1/length]` is not positive and finite.
    #[error("a grating frequency of {0}; give lines per length, positive and finite")]
    Frequency(f64),
    /// A wavelength `[length]` is not positive and finite.
    #[error("a wavelength of {0}; give a length, positive and finite")]
    Wavelength(f64),
    /// An angle of incidence `[rad]` does not lie between the normal and grazing light.
    #[error("an angle of incidence of {0} rad; it must be above 0 and at most π/2")]
    Angle(f64),
    /// Light of this wavelength makes no grating this fine.
    #[error(
        "light of wavelength {wavelength} makes gratings of at most {most} lines per length, fewer than the {frequency} requested"
    )]
    TooFine {
        /// Requested lines per length `[1/length]`.
        frequency: f64,
        /// Wavelength `[length]`.
        wavelength: f64,
        /// Lines per length at grazing incidence, 2/λ `[1/length]`.
        most: f64,
    },
}

/// A virtual reference grating.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Grating {
    frequency: f64,
}

impl Grating {
    /// A grating of `frequency` lines per length `[1/length]`.
    ///
    /// # Errors
    /// [`MoireError::Frequency`] unless it is positive and finite.
    pub fn new(frequency: f64) -> Result<Self, MoireError> {
        if frequency.is_finite() && frequency > 0.0 {
            Ok(Self { frequency })
        } else {
            Err(MoireError::Frequency(frequency))
        }
    }

    /// The grating that two beams of `wavelength` λ `[length]` make at the angles ±α `angle` `[rad]` to the normal,
    /// f = (2/λ) sin α.
    ///
    /// # Errors
    /// [`MoireError::Wavelength`] or [`MoireError::Angle`] out of range.
    pub fn from_beams(wavelength: f64, angle: f64) -> Result<Self, MoireError> {
        if !(wavelength.is_finite() && wavelength > 0.0) {
            return Err(MoireError::Wavelength(wavelength));
        }
        if !(angle > 0.0 && angle <= std::f64::consts::FRAC_PI_2) {
            return Err(MoireError::Angle(angle));
        }
        Self::new(2.0 / wavelength * angle.sin())
    }

    /// Lines per length `[1/length]`.
    pub fn frequency(&self) -> f64 {
        self.frequency
    }

    /// The angle of incidence α `[rad]` at which light of `wavelength` `[length]` makes this grating.
    ///
    /// # Errors
    /// [`MoireError::Wavelength`] out of range, [`MoireError::TooFine`] where sin α would be above 1.
    pub fn angle(&self, wavelength: f64) -> Result<f64, MoireError> {
        if !(wavelength.is_finite() && wavelength > 0.0) {
            return Err(MoireError::Wavelength(wavelength));
        }
        let sine = 0.5 * self.frequency * wavelength;
        if sine > 1.0 {
            return Err(MoireError::TooFine {
                frequency: self.frequency,
                wavelength,
                most: 2.0 / wavelength,
            });
        }
        Ok(sine.asin())
    }

    /// Displacement `[length]` of a fringe `order` `[fringes]`, N/f; standard deviations convert alike.
    pub fn displacement(&self, order: f64) -> f64 {
        order / self.frequency
    }

    /// Fringe order `[fringes]` of a `displacement` `[length]`, f U.
    pub fn order(&self, displacement: f64) -> f64 {
        displacement * self.frequency
    }

    /// Strains (ε_x, ε_y, γ_xy) `[1]` of the gradients `[[∂N_x/∂x, ∂N_x/∂y], [∂N_y/∂x, ∂N_y/∂y]]` `[fringes/length]`.
    pub fn strains(&self, gradients: [[f64; 2]; 2]) -> [f64; 3] {
        let [[xx, xy], [yx, yy]] = gradients;
        [xx, yy, xy + yx].map(|gradient| gradient / self.frequency)
    }
}
