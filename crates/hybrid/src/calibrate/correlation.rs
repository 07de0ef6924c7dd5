//! Correlation of the errors of neighbouring data, estimated from the residuals of a fit.
//!
//! ```text
//! c(d) = mean of r_i r_j over pairs of one field at the distance d,     ρ = c/c(0)
//! inflation = c(0) + Σ over rings of N c(d),     squares = 1 + Σ over rings of N ρ(d)²,     N: neighbours of a datum in the ring
//! ```
//!
//! n correlated data hold as much information on a smooth signal as n/inflation independent ones: the variance of a sum of n of them is n
//! times the inflation, which is the spectrum of the errors at wave number zero. It affects signals that change over the correlation length
//! less, so that the coverage of intervals by this number is at least the stated one. χ² of n correlated data scatters as that of n/squares
//! independent ones. Rings end where c is no longer above its own scatter. Sources: Bartlett (1946); Bayley & Hammersley (1946).

use std::collections::{BTreeMap, HashMap};

use crate::order_statistics::median;

/// A residual over its stated standard deviation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Residual {
    /// Where its datum is, of any unit.
    pub place: [f64; 2],
    /// Residuals of one field are compared with each other: one component of one state.
    pub field: usize,
    /// Measured less predicted over the standard deviation `[1]`.
    pub value: f64,
}

/// Correlation of the errors of neighbouring data.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Correlation {
    /// Variance of a sum of data over that of independent data with their stated standard deviations `[1]`, at least 1.
    pub inflation: f64,
    /// Mean sum of the squares of a datum's correlations with all data, itself included `[1]`; at least 1.
    pub squares: f64,
}

impl Default for Correlation {
    fn default() -> Self {
        Self::NONE
    }
}

impl Correlation {
    /// That of independent data.
    pub const NONE: Self = Self {
        inflation: 1.0,
        squares: 1.0,
    };

    /// That of `residuals`, whatever their order.
    pub fn of(residuals: &[Residual]) -> Self {
        let mut fields: BTreeMap<usize, Vec<&Residual>> = BTreeMap::new();
        for own in residuals {
            fields.entry(own.field).or_default().push(own);
        }
        let fields: Vec<Vec<&Residual>> = fields.into_values().collect();
        let count = residuals.len().max(1) as f64;
        let variance = residuals.iter().map(|own| own.value.powi(2)).sum::<f64>() / count;
        let mut found = Self {
            inflation: variance,
            squares: 1.0,
        };
        if let Some(width) = ring_width(&fields).filter(|_| variance > 0.0) {
            let grids: Vec<Grid<'_>> = fields.iter().map(|own| Grid::new(own, width)).collect();
            for index in 0.. {
                let own = grids.iter().map(|grid| grid.ring(index));
                let ring = own.fold(Ring::default(), Ring::with);
                let mean = ring.sum / ring.pairs;
                if ring.pairs == 0.0 || mean <= variance / ring.pairs.sqrt() {
                    break;
                }
                let neighbours = 2.0 * ring.pairs / count;
                found.inflation += neighbours * mean;
                found.squares += neighbours * (mean / variance).powi(2);
            }
        }
        found.inflation = found.inflation.max(1.0);
        found
    }
}

/// Products of residuals at about one distance.
#[derive(Clone, Copy, Default)]
struct Ring {
    pairs: f64,
    sum: f64,
}

impl Ring {
    fn with(self, other: Self) -> Self {
        Self {
            pairs: self.pairs + other.pairs,
            sum: self.sum + other.sum,
        }
    }
}

/// One and a half times the median distance of a datum to the next one, of evenly chosen data: the first ring of a square grid holds eight
/// neighbours.
fn ring_width(fields: &[Vec<&Residual>]) -> Option<f64> {
    const RINGS: f64 = 1.5;
    const ASKED: usize = 500;
    let count: usize = fields.iter().map(Vec::len).sum();
    let stride = count.div_ceil(ASKED).max(1);
    let mut nearest: Vec<f64> = Vec::new();
    for field in fields {
        for (i, own) in field.iter().enumerate().step_by(stride) {
            let others = field.iter().enumerate().filter(|(j, _)| *j != i);
            let next = others.map(|(_, other)| distance(own, other));
            nearest.push(next.fold(f64::INFINITY, f64::min));
        }
    }
    let middle = median(nearest)?;
    (middle > 0.0 && middle.is_finite()).then_some(RINGS * middle)
}

/// Residuals of a field in square cells as wide as a ring.
struct Grid<'a> {
    field: &'a [&'a Residual],
    width: f64,
    /// The farthest pairs that are compared: half of what the field extends.
    farthest: f64,
    cells: HashMap<[i64; 2], Vec<usize>>,
}

impl<'a> Grid<'a> {
    fn new(field: &'a [&'a Residual], width: f64) -> Self {
        let mut grid = Self {
            field,
            width,
            farthest: (0.5 * extent(field)).max(width),
            cells: HashMap::new(),
        };
        for (index, own) in field.iter().enumerate() {
            let cell = grid.cell(own);
            grid.cells.entry(cell).or_default().push(index);
        }
        grid
    }

    fn cell(&self, own: &Residual) -> [i64; 2] {
        own.place.map(|x| (x / self.width).floor() as i64)
    }

    /// Products of all pairs whose distance in widths rounds down to `index`.
    fn ring(&self, index: usize) -> Ring {
        let reach = index as i64 + 1;
        let mut ring = Ring::default();
        if index as f64 * self.width > self.farthest {
            return ring;
        }
        for (i, own) in self.field.iter().enumerate() {
            let [column, row] = self.cell(own);
            for x in column - reach..=column + reach {
                for y in row - reach..=row + reach {
                    let others = self.cells.get(&[x, y]).into_iter().flatten();
                    for &j in others.filter(|&&j| j > i) {
                        let other = self.field[j];
                        let apart = distance(own, other);
                        if apart <= self.farthest && (apart / self.width) as usize == index {
                            ring.pairs += 1.0;
                            ring.sum += own.value * other.value;
                        }
                    }
                }
            }
        }
        ring
    }
}

fn distance(a: &Residual, b: &Residual) -> f64 {
    (a.place[0] - b.place[0]).hypot(a.place[1] - b.place[1])
}

/// The longer side of the rectangle around a field.
fn extent(field: &[&Residual]) -> f64 {
    let side = |axis: usize| {
        let places = || field.iter().map(|own| own.place[axis]);
        places().fold(f64::NEG_INFINITY, f64::max) - places().fold(f64::INFINITY, f64::min)
    };
    side(0).max(side(1))
}

#[cfg(test)]
mod tests {
    use rand::SeedableRng;
    use rand::rngs::StdRng;

    use super::*;
    use crate::random::normal;

    /// Two fields on a grid of `side` squared, each value the mean of `reach` squared independent ones, of standard deviation 1; without
    /// the mean of a field, which a fit takes as a translation.
    fn fields(side: usize, reach: usize, seed: u64) -> Vec<Residual> {
        let mut random = StdRng::seed_from_u64(seed);
        let wide = side + reach - 1;
        let mut all = Vec::new();
        for field in 0..2 {
            let noise: Vec<f64> = (0..wide * wide).map(|_| normal(&mut random)).collect();
            let value = |(i, j): (usize, usize)| {
                let own = (0..reach * reach).map(|k| noise[(i + k / reach) * wide + j + k % reach]);
                own.sum::<f64>() / reach as f64
            };
            let places: Vec<(usize, usize)> =
                (0..side * side).map(|k| (k / side, k % side)).collect();
            let values: Vec<f64> = places.iter().map(|&place| value(place)).collect();
            let mean = values.iter().sum::<f64>() / values.len() as f64;
            all.extend(places.iter().zip(values).map(|(&(i, j), value)| Residual {
                place: [i as f64, j as f64],
                field,
                value: value - mean,
            }));
        }
        all
    }

    #[test]
    fn independent_residuals_count_in_full() {
        let mean = (1..=20)
            .map(|seed| Correlation::of(&fields(30, 1, seed)).inflation / 20.0)
            .sum::<f64>();
        // What the scatter of c lets through where there is no correlation.
        assert!((1.0..1.15).contains(&mean), "{mean}");
    }

    #[test]
    fn means_of_overlapping_squares_count_by_the_square() {
        for reach in [2_usize, 3, 5] {
            let all: Vec<Correlation> = (1..=10)
                .map(|seed| Correlation::of(&fields(40, reach, seed)))
                .collect();
            let mean = |of: &dyn Fn(&Correlation) -> f64| all.iter().map(of).sum::<f64>() / 10.0;
            let found = Correlation {
                inflation: mean(&|own| own.inflation),
                squares: mean(&|own| own.squares),
            };
            let each: Vec<f64> = all.iter().map(|own| own.inflation).collect();
            println!("{each:.1?}");
            // Σ ρ = (Σ (1 − |k|/m))² = m² and Σ ρ² = ((2m² + 1)/(3m))², of triangles of half width m.
            let m = reach as f64;
            let exact = [m * m, ((2.0 * m * m + 1.0) / (3.0 * m)).powi(2)];
            println!("{reach}: {found:?} of {exact:?}");
            // The longest correlation rests on some sixty independent squares of each field.
            assert!((found.inflation / exact[0] - 1.0).abs() < 0.35, "{found:?}");
            assert!((found.squares / exact[1] - 1.0).abs() < 0.35, "{found:?}");
        }
    }

    #[test]
    fn few_residuals_and_none_are_independent() {
        assert_eq!(Correlation::of(&[]), Correlation::NONE);
        let one = Residual {
            place: [0.0; 2],
            field: 0,
            value: 0.5,
        };
        assert_eq!(Correlation::of(&[one]), Correlation::NONE);
        // All at one place: no distance to compare.
        assert_eq!(Correlation::of(&[one; 3]), Correlation::NONE);
    }
}
