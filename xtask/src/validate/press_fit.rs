//! A pin in a ring in a ring, all of one material, with interferences δ_a at radius a and δ_b at b, free at c.
//!
//! Bodies of one material behave as one once they are pressed together, so the two fits superpose. Each is that of a solid disk in a
//! ring (Lamé 1852, plane stress):
//!
//! ```text
//! p_a = E δ_a/(2a) (1 − a²/c²),   p_b = E δ_b/(2b) (1 − b²/c²)
//! P_a = p_a + p_b,   P_b = p_b + p_a (c²/b² − 1)/(c²/a² − 1)
//! σ_θ(a) = p_a (c² + a²)/(c² − a²) − p_b,   σ_θ(b) = P_b (c² + b²)/(c² − b²)
//! ```

use stickslip::results::{EdgeResults, EdgeRow};

use super::check::Tolerance::Relative;
use super::check::{Check, Checks};
use super::laboratory::Laboratory;
use crate::publish::TaskError;

/// Allowed error.
const BOUND: f64 = 2e-3;
/// Young's modulus `[MPa]`.
const YOUNG: f64 = 70e3;
/// Radii a, b, c `[mm]`.
const RADII: [f64; 3] = [5.0, 8.0, 16.0];
/// Interferences δ_a, δ_b `[mm]`.
const INTERFERENCES: [f64; 2] = [0.0005, 0.0008];

pub(super) fn checks(laboratory: &Laboratory) -> Result<Vec<Check>, TaskError> {
    let mut checks = Checks::against("Lamé 1852, closed form");
    let results = laboratory.run("validation/lame-press-fit", &[])?;
    let [a, b, c] = RADII.map(|radius| radius * radius);
    let [pin, bushing] = [0, 1].map(|k| {
        let radius = RADII[k];
        YOUNG * INTERFERENCES[k] / (2.0 * radius) * (1.0 - radius * radius / c)
    });
    let outer = bushing + pin * (c / b - 1.0) / (c / a - 1.0);
    let expected = [
        ("ring in ring", outer, outer * (c + b) / (c - b)),
        (
            "pin in ring",
            pin + bushing,
            pin * (c + a) / (c - a) - bushing,
        ),
    ];
    let edges = &results.steps[0].edges;
    for ((name, pressure, hoop), edge) in expected.into_iter().zip(edges) {
        let pressures = extremes(edge, |row| row.pressure);
        let hoops = extremes(edge, |row| row.sigma_tangential);
        for (quantity, reference, found) in
            [("pressure", pressure, pressures), ("σ_θ", hoop, hoops)]
        {
            for (which, value) in ["smallest", "largest"].into_iter().zip(found) {
                checks.near(
                    format!("{name}: {quantity}, {which} around"),
                    [value, reference],
                    Relative(BOUND, " MPa"),
                );
            }
        }
    }
    Ok(checks.into_list())
}

/// The smallest and the largest of a quantity along an edge.
fn extremes(edge: &EdgeResults, of: impl Fn(&EdgeRow) -> f64) -> [f64; 2] {
    let values = || edge.rows.iter().map(&of);
    [
        values().fold(f64::INFINITY, f64::min),
        values().fold(f64::NEG_INFINITY, f64::max),
    ]
}
