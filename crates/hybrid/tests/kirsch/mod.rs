//! Kirsch's displacements around a hole as fringe orders.
//!
//! Aluminium under 60 MPa along x, hole of radius 2, window 12 × 12 (lengths in mm), grating of 2400 lines per mm, 512 × 512 pixels,
//! carrier of 0.16 fringes per pixel.

use stickslip_fem_core::mesh::Point;
use stickslip_hybrid::fringe::{Frame, PixelMap, Plane, orders};

pub(crate) const FREQUENCY: f64 = 2400.0;
pub(crate) const RADIUS: f64 = 2.0;
pub(crate) const PIXEL: f64 = 12.0 / 512.0;
pub(crate) const CARRIER: Plane = Plane {
    gradient: [6.0, 3.4],
    constant: 0.3,
};

/// Displacement `[mm]` of an infinite plate in plane stress with a hole, stretched along x (Kirsch 1898).
pub(crate) fn displacement(place: Point, component: usize) -> Option<f64> {
    let (stress, modulus, ratio) = (60.0, 71_700.0, 0.33);
    let (r, theta) = (place[0].hypot(place[1]), place[1].atan2(place[0]));
    let kappa = (3.0 - ratio) / (1.0 + ratio);
    let shear_modulus = modulus / (2.0 * (1.0 + ratio));
    let (q, cube) = (RADIUS / r, (RADIUS / r).powi(3));
    let shape = if component == 0 {
        (kappa + 1.0) * theta.cos() / q
            + 2.0 * q * ((1.0 + kappa) * theta.cos() + (3.0 * theta).cos())
            - 2.0 * cube * (3.0 * theta).cos()
    } else {
        (kappa - 3.0) * theta.sin() / q
            + 2.0 * q * ((1.0 - kappa) * theta.sin() + (3.0 * theta).sin())
            - 2.0 * cube * (3.0 * theta).sin()
    };
    (r > RADIUS).then_some(stress * RADIUS / (8.0 * shear_modulus) * shape)
}

pub(crate) fn frame() -> Frame {
    Frame::over([[-6.0, -6.0], [6.0, 6.0]], PIXEL).unwrap()
}

pub(crate) fn truth(component: usize) -> PixelMap {
    orders(frame(), FREQUENCY, &CARRIER, |place| {
        displacement(place, component)
    })
    .unwrap()
}
