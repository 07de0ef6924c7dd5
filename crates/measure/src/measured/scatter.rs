//! The standard deviation of measured displacements from their scatter among neighbours.
//!
//! ```text
//! r = u₀ − Σ wᵢ uᵢ,   Σ wᵢ = 1,  Σ wᵢ xᵢ = x₀,    σ² (1 + Σ wᵢ²) = E r²
//! ```
//!
//! The weights are those of a plane of least squares through the nearest neighbours; the median of |r| is 0.6745 of its standard
//! deviation for normal errors, and single bad points do not move it.

use stickslip_fem_core::mesh::Point;
use stickslip_hybrid::data::{Field, Measurement};
use stickslip_hybrid::reduce::{LocalPolynomial, ReduceError, Reduction};

/// Median of |x| over the standard deviation of a normal distribution.
const NORMAL_MEDIAN: f64 = 0.674_489_750_196_082;
/// Most places that are looked at.
const PLACES: usize = 2000;
/// Neighbours of each.
const NEIGHBOURS: usize = 12;

/// Standard deviation of normal numbers by their magnitudes; 0 of none.
pub(super) fn deviation_of_magnitudes(mut magnitudes: Vec<f64>) -> f64 {
    if magnitudes.is_empty() {
        return 0.0;
    }
    let middle = magnitudes.len() / 2;
    let (_, median, _) = magnitudes.select_nth_unstable_by(middle, f64::total_cmp);
    *median / NORMAL_MEDIAN
}

/// Standard deviation of a field `[mm]`.
///
/// # Errors
/// [`ReduceError`] for fewer valid places than neighbours.
pub(super) fn deviation(measurement: &Measurement, field: Field) -> Result<f64, ReduceError> {
    let c = field.component();
    let valid: Vec<usize> = (0..measurement.places.len())
        .filter(|&k| measurement.valid[c][k])
        .collect();
    let stride = valid.len().div_ceil(PLACES).max(1);
    let fit = LocalPolynomial {
        order: 2,
        neighbours: NEIGHBOURS,
        largest_radius: f64::INFINITY,
        extrapolate: true,
    };
    let mut magnitudes = Vec::new();
    // Two halves predict each other, so that no value takes part in its own prediction.
    for half in 0..2 {
        let mut others = measurement.clone();
        others.valid = std::array::from_fn(|_| {
            let mut marks = vec![false; measurement.places.len()];
            (valid.iter().enumerate())
                .filter(|(k, _)| k % 2 != half)
                .for_each(|(_, &index)| marks[index] = true);
            marks
        });
        others.displacements = std::array::from_fn(|_| measurement.displacements[c].clone());
        let asked = valid.iter().enumerate().filter(|(k, _)| k % 2 == half);
        let asked: Vec<usize> = asked.map(|(_, &index)| index).step_by(stride).collect();
        let places: Vec<Point> = asked
            .iter()
            .map(|&index| measurement.places[index])
            .collect();
        let nodes: Vec<usize> = (0..places.len()).collect();
        let reduction = Reduction::polynomial(&others, &places, &nodes, &fit)?;
        for (k, &node) in reduction.nodes().iter().enumerate() {
            let Some(stencil) = reduction.stencil(k, Field::U) else {
                continue;
            };
            let (mut predicted, mut squares) = (0.0, 1.0);
            for &(index, weight) in stencil {
                predicted += weight * others.displacements[0][index];
                squares += weight * weight;
            }
            let own = measurement.displacements[c][asked[node]];
            magnitudes.push((own - predicted).abs() / squares.sqrt());
        }
    }
    Ok(deviation_of_magnitudes(magnitudes))
}
