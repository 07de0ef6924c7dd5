//! Carrier fringes and how their phase is taken.

use stickslip_fem_core::mesh::Point;

use super::FringeError;
use super::check::parameter;

/// The carrier's gradient (k_x, k_y) `[fringes/length]`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Carrier {
    /// Known `[fringes/length]`.
    Given([f64; 2]),
    /// The centre of the strongest peak of the spectrum. A picture does not distinguish rising from falling orders: the carrier is taken
    /// to rise towards the direction given.
    Found {
        /// A direction in which orders rise `[1]`.
        towards: Point,
    },
}

/// How [`fourier`](fn@super::fourier) works.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FourierOptions {
    /// The carrier.
    pub carrier: Carrier,
    /// Radius β of the band around the carrier k, as a part of the way |k| to the background (or to the Nyquist frequency, where
    /// that is nearer), between 0 and 1 `[1]`: greater follows steeper displacements, smaller passes less noise.
    pub band: f64,
    /// Least part of the fringes' power that has to lie in the band `[1]`, between 0 and 1.
    pub least_share: f64,
    /// Greatest number of passes that fill missing pixels.
    pub passes: usize,
    /// Filling ends when a pass changes missing pixels by less than this part `[1]` of the fringes' amplitude (root mean square).
    pub settled: f64,
}

impl FourierOptions {
    /// Band 0.75, least share 0.5, at most 60 passes, settled at 1e-3.
    pub fn new(carrier: Carrier) -> Self {
        Self {
            carrier,
            band: 0.75,
            least_share: 0.5,
            passes: 60,
            settled: 1e-3,
        }
    }

    pub(super) fn check(&self) -> Result<(), FringeError> {
        let (Carrier::Given(direction) | Carrier::Found { towards: direction }) = self.carrier;
        let size = direction[0].hypot(direction[1]);
        let fits = size > 0.0 && size.is_finite();
        parameter("carrier", size, fits, "finite and not zero")?;
        let fits = self.band > 0.0 && self.band < 1.0;
        parameter("band", self.band, fits, "between 0 and 1")?;
        let fits = (0.0..=1.0).contains(&self.least_share);
        parameter("least share", self.least_share, fits, "from 0 to 1")?;
        parameter("settled", self.settled, self.settled > 0.0, "positive")
    }
}
