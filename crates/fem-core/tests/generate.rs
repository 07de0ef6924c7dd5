//! Generated meshes: exact areas, complete boundaries, sizes, refusals, and validity for any reasonable list of angles.

#[path = "generate/bodies.rs"]
mod bodies;
#[path = "generate/measure.rs"]
mod measure;
#[path = "generate/mirrored.rs"]
mod mirrored;
#[path = "generate/refusals.rs"]
mod refusals;
#[path = "generate/shapes.rs"]
mod shapes;
#[path = "generate/sizes.rs"]
mod sizes;
#[path = "generate/validity.rs"]
mod validity;

use std::error::Error;

type Outcome = Result<(), Box<dyn Error>>;

/// Hole angles of the report's pin-loaded plate: fine around the bearing point, 9° from 45° on [degrees].
const FINE_AT_BEARING: [f64; 30] = [
    0.0, 1.0, 2.0, 4.0, 6.0, 8.0, 10.0, 12.5, 15.0, 20.0, 25.0, 30.0, 35.0, 40.0, 45.0, 54.0, 63.0,
    72.0, 81.0, 90.0, 99.0, 108.0, 117.0, 126.0, 135.0, 144.0, 153.0, 162.0, 171.0, 180.0,
];

/// The angles above in radians, mirrored below the load axis for a whole circle.
fn fine_at_bearing(extent: stickslip_fem_core::generate::Extent) -> Vec<f64> {
    let half = FINE_AT_BEARING.map(f64::to_radians);
    let mirrored = half[1..29]
        .iter()
        .rev()
        .map(|angle| std::f64::consts::TAU - angle);
    match extent {
        stickslip_fem_core::generate::Extent::Half => half.to_vec(),
        stickslip_fem_core::generate::Extent::Whole => {
            half.iter().copied().chain(mirrored).collect()
        }
    }
}
