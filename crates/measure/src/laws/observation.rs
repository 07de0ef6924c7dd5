//! The displacements of a state, as a fit of laws takes them.

use std::collections::BTreeMap;

use stickslip_fem_core::mesh::Point;
use stickslip_hybrid::calibrate::{Block, Data, Noise};
use stickslip_hybrid::data::Measurement;

use super::LawsError;
use crate::ends::ends;

/// What may be added to the displacements of a state without anybody's asking.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Nuisance {
    /// Nothing.
    None,
    /// A rigid motion: two translations, which hold whole fringe orders as well, and a turn.
    #[default]
    Rigid,
    /// What is left of the carriers of both fields: a plane for each component. It takes homogeneous strains with it.
    Carriers,
}

impl Nuisance {
    /// Amounts that are free in a state.
    pub const fn count(self) -> usize {
        match self {
            Self::None => 0,
            Self::Rigid => 3,
            Self::Carriers => 6,
        }
    }

    /// "rigid motion" and so on.
    pub const fn name(self) -> &'static str {
        match self {
            Self::None => "nothing",
            Self::Rigid => "a rigid motion",
            Self::Carriers => "a plane for each component",
        }
    }

    /// Displacements at the data `components`, indices of one of `places` and of an axis, by a unit of each amount; one list per amount.
    pub(super) fn columns(self, places: &[Point], components: &[(usize, usize)]) -> Vec<Vec<f64>> {
        let distances = places.iter().map(|place| place[0].hypot(place[1]));
        let length = distances.fold(f64::MIN_POSITIVE, f64::max);
        let shapes: Vec<Vec<f64>> = (components.iter())
            .map(|&(place, axis)| self.shapes(axis, places[place], length))
            .collect();
        let column = |k: usize| shapes.iter().map(|shape| shape[k]).collect();
        (0..self.count()).map(column).collect()
    }

    /// Displacements along `axis` at `place` by a unit of each amount; lengths are measured in `length`.
    fn shapes(self, axis: usize, [x, y]: Point, length: f64) -> Vec<f64> {
        let (x, y) = (x / length, y / length);
        let [first, second] = if axis == 0 { [1.0, 0.0] } else { [0.0, 1.0] };
        match self {
            Self::None => Vec::new(),
            Self::Rigid => vec![first, second, second * x - first * y],
            Self::Carriers => vec![first, second, first * x, first * y, second * x, second * y],
        }
    }
}

/// Displacements measured in a state of the experiment.
#[derive(Clone, Debug, PartialEq)]
pub struct Observation {
    /// Name of the state.
    pub state: String,
    /// Load step of the scene at which it was measured, from 0.
    pub step: usize,
    /// Load step whose displacements were taken off, if any.
    pub null: Option<usize>,
    /// Where `[mm]`.
    pub places: Vec<Point>,
    /// Index of the place and axis of each datum.
    pub components: Vec<(usize, usize)>,
    /// The data `[mm]`.
    pub values: Vec<f64>,
    /// Their errors `[mm]` or `[mm²]`.
    pub noise: Noise,
    /// What is not asked of them.
    pub nuisance: Nuisance,
}

impl Observation {
    /// All valid components of a measurement, independent with its standard deviations: for each valid place x before y. `state` names the
    /// measurement in messages; `step` is the load step, from 0, in which it was made.
    pub fn of_measurement(state: &str, step: usize, measured: &Measurement) -> Self {
        let mut own = Self {
            state: state.to_owned(),
            step,
            null: None,
            places: Vec::new(),
            components: Vec::new(),
            values: Vec::new(),
            noise: Noise::Independent(Vec::new()),
            nuisance: Nuisance::default(),
        };
        let mut deviations = Vec::new();
        for (index, &place) in measured.places.iter().enumerate() {
            for axis in 0..2 {
                if measured.valid[axis][index] {
                    if own.places.last() != Some(&place) {
                        own.places.push(place);
                    }
                    own.components.push((own.places.len() - 1, axis));
                    own.values.push(measured.displacements[axis][index]);
                    deviations.push(measured.deviation[axis]);
                }
            }
        }
        own.noise = Noise::Independent(deviations);
        own
    }

    /// The data as a block of a fit.
    pub fn block(&self) -> Block {
        Block {
            values: self.values.clone(),
            noise: self.noise.clone(),
            nuisance: self.nuisance.columns(&self.places, &self.components),
        }
    }

    /// What the free motion of the state leaves of `values`, one for each datum, if all count alike; in their unit.
    ///
    /// # Errors
    /// [`LawsError::Data`] for values that are not finite.
    pub(super) fn left_of(&self, values: Vec<f64>) -> Result<Vec<f64>, LawsError> {
        left(
            self.nuisance.columns(&self.places, &self.components),
            values,
        )
    }
}

/// What `nuisance` leaves of `values`, if all count alike.
pub(super) fn left(nuisance: Vec<Vec<f64>>, values: Vec<f64>) -> Result<Vec<f64>, LawsError> {
    let none = vec![0.0; values.len()];
    let block = Block {
        noise: Noise::Independent(vec![1.0; values.len()]),
        values,
        nuisance,
    };
    let data = Data::new(vec![block]).map_err(LawsError::Data)?;
    Ok(data.residual(&none))
}

/// Root of the mean square of `values`; 0 of none.
pub(super) fn root_mean_square(values: &[f64]) -> f64 {
    let squares: f64 = values.iter().map(|own| own * own).sum();
    (squares / values.len().max(1) as f64).sqrt()
}

/// At most `most` valid places of a measurement, one of each box of a square grid.
///
/// Places in rows, taken every so many, would stand in a few columns. The one nearest to its box's middle is kept, so that they lie
/// evenly in both directions whatever their order.
pub fn decimated(measured: &Measurement, most: usize) -> Measurement {
    let valid = |index: &usize| measured.valid.iter().any(|valid| valid[*index]);
    let all: Vec<usize> = (0..measured.places.len()).filter(valid).collect();
    let kept = if all.len() <= most.max(1) {
        all
    } else {
        thinned(&measured.places, &all, most.max(1))
    };
    let take = |values: &Vec<f64>| kept.iter().map(|&k| values[k]).collect();
    let flags = |values: &Vec<bool>| kept.iter().map(|&k| values[k]).collect();
    Measurement {
        places: kept.iter().map(|&k| measured.places[k]).collect(),
        displacements: measured.displacements.each_ref().map(take),
        valid: measured.valid.each_ref().map(flags),
        deviation: measured.deviation,
    }
}

/// At most `most` of the places `all`, in their order; boxes grow until no more are left.
fn thinned(places: &[Point], all: &[usize], most: usize) -> Vec<usize> {
    const GROWTH: f64 = 1.03;
    let [[left, right], [bottom, top]] =
        [0, 1].map(|axis| ends(all.iter().map(|&k| places[k][axis])));
    let (width, height) = (right - left, top - bottom);
    let longest = width.max(height);
    if longest <= 0.0 || !longest.is_finite() {
        return all.iter().copied().take(most).collect();
    }
    // As many boxes as would be filled if the places filled their rectangle; places on a line fill a row of boxes.
    let mut size = (width * height / most as f64)
        .sqrt()
        .max(longest / most as f64);
    loop {
        let mut boxes: BTreeMap<[i64; 2], (f64, usize)> = BTreeMap::new();
        for &k in all {
            let at = [places[k][0] - left, places[k][1] - bottom].map(|x| x / size);
            let key = at.map(|x| x.floor() as i64);
            let middle = |axis: usize| at[axis] - at[axis].floor() - 0.5;
            let own = (middle(0).hypot(middle(1)), k);
            let kept = boxes.entry(key).or_insert(own);
            if own.0 < kept.0 {
                *kept = own;
            }
        }
        if boxes.len() <= most {
            let mut kept: Vec<usize> = boxes.into_values().map(|(_, k)| k).collect();
            kept.sort_unstable();
            return kept;
        }
        size *= GROWTH;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn raster(columns: usize, rows: usize) -> Measurement {
        let places: Vec<Point> = (0..columns * rows)
            .map(|k| [(k % columns) as f64, (k / columns) as f64])
            .collect();
        let count = places.len();
        Measurement {
            places,
            displacements: [vec![0.0; count], vec![0.0; count]],
            valid: [vec![true; count], vec![true; count]],
            deviation: [1.0; 2],
        }
    }

    #[test]
    fn places_that_are_kept_lie_evenly_in_both_directions() {
        // Every hundredth place in the order of rows would be a single column.
        let kept = decimated(&raster(100, 100), 100);
        assert!(
            (60..=100).contains(&kept.places.len()),
            "{}",
            kept.places.len()
        );
        for axis in 0..2 {
            for quarter in 0..4 {
                let from = 25.0 * f64::from(quarter);
                let inside = |place: &&Point| (from..from + 25.0).contains(&place[axis]);
                let share = kept.places.iter().filter(inside).count() as f64;
                let share = share / kept.places.len() as f64;
                assert!((0.15..0.35).contains(&share), "{axis} {quarter} {share}");
            }
        }
    }

    #[test]
    fn places_on_a_line_and_few_places_are_kept() {
        let kept = decimated(&raster(1000, 1), 50).places.len();
        assert!((40..=50).contains(&kept), "{kept}");
        let few = raster(5, 4);
        assert_eq!(decimated(&few, 50), few);
    }
}
