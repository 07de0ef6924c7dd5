//! Tractions on a circle from a table, made continuous.
//!
//! A table from 0 to π stands for a load symmetric about the x axis, σ_r(−θ) = σ_r(θ) and τ_rθ(−θ) = −τ_rθ(θ). In equal steps it
//! is interpolated by its finite Fourier series,
//!
//! ```text
//! σ_r = Σ_k a_k cos kθ,   τ_rθ = Σ_k b_k sin kθ,
//! ```
//!
//! which is exact to rounding for a smooth field, in unequal ones linearly. A table beyond π is interpolated linearly and
//! periodically.

use std::f64::consts::{PI, TAU};

use stickslip_scene::schema::PolarTable;

/// Interpolates a [`PolarTable`].
#[derive(Debug)]
pub(super) enum PolarField {
    Fourier {
        cosine: Vec<f64>,
        sine: Vec<f64>,
    },
    Linear {
        theta: Vec<f64>,
        radial: Vec<f64>,
        shear: Vec<f64>,
        /// Whether the table is one of half the circle.
        mirrored: bool,
    },
}

impl PolarField {
    pub(super) fn new(table: &PolarTable) -> Self {
        let intervals = table.theta.len().saturating_sub(1);
        let regular = intervals > 1
            && table
                .theta
                .iter()
                .enumerate()
                .all(|(k, theta)| (theta - PI * k as f64 / intervals as f64).abs() < 1e-9);
        if !regular {
            let PolarTable {
                theta,
                radial,
                shear,
                ..
            } = table;
            return Self::Linear {
                theta: theta.clone(),
                radial: radial.clone(),
                shear: shear.clone(),
                mirrored: table.is_half(),
            };
        }
        let end = |k: usize| if k == 0 || k == intervals { 0.5 } else { 1.0 };
        let sum = |values: &[f64], k: usize, wave: fn(f64) -> f64| -> f64 {
            values
                .iter()
                .enumerate()
                .map(|(j, value)| end(j) * value * wave(PI * (j * k) as f64 / intervals as f64))
                .sum()
        };
        let scale = 2.0 / intervals as f64;
        Self::Fourier {
            cosine: (0..=intervals)
                .map(|k| end(k) * scale * sum(&table.radial, k, f64::cos))
                .collect(),
            sine: (0..intervals)
                .map(|k| scale * sum(&table.shear, k, f64::sin))
                .collect(),
        }
    }

    /// (σ_r, τ_rθ) at `theta` `[rad]`.
    pub(super) fn at(&self, theta: f64) -> [f64; 2] {
        match self {
            Self::Fourier { cosine, sine } => {
                let radial = cosine
                    .iter()
                    .enumerate()
                    .map(|(k, a)| a * (k as f64 * theta).cos())
                    .sum();
                let shear = sine
                    .iter()
                    .enumerate()
                    .map(|(k, b)| b * (k as f64 * theta).sin())
                    .sum();
                [radial, shear]
            }
            Self::Linear {
                theta: knots,
                radial,
                shear,
                mirrored,
            } => {
                let turned = theta.rem_euclid(TAU);
                // The image of the lower half, without a step at π.
                let (angle, sign) = if *mirrored && turned > PI {
                    (TAU - turned, -1.0)
                } else {
                    (turned, 1.0)
                };
                if *mirrored && angle >= PI {
                    return [radial, shear].map(|values| values.last().copied().unwrap_or(0.0));
                }
                let next = knots.partition_point(|&knot| knot <= angle);
                let count = knots.len();
                let (left, right) = ((next + count - 1) % count, next % count);
                let width = (knots[right] - knots[left]).rem_euclid(TAU);
                let part = if width > 0.0 {
                    (angle - knots[left]).rem_euclid(TAU) / width
                } else {
                    0.0
                };
                let [radial, shear] = [radial, shear]
                    .map(|values| values[left] + part * (values[right] - values[left]));
                [radial, sign * shear]
            }
        }
    }
}

impl PolarField {
    /// ∫ (σ_r e_r + τ_rθ e_θ) dθ, components x and y, and ∫ τ_rθ dθ once around: force per radius and thickness, and moment about the
    /// centre per squared radius and thickness.
    pub(super) fn resultant(&self) -> [f64; 3] {
        match self {
            // Of all waves only the first has a force.
            Self::Fourier { cosine, sine } => [PI * (cosine[1] - sine[1]), 0.0, 0.0],
            Self::Linear {
                theta,
                radial,
                shear,
                mirrored,
            } => {
                let rows = theta.iter().zip(radial).zip(shear);
                let mut rows: Vec<[f64; 3]> = rows.map(|((&t, &r), &s)| [t, r, s]).collect();
                if *mirrored {
                    let image = rows.iter().rev().map(|[t, r, s]| [TAU - t, *r, -s]);
                    rows.extend(image.collect::<Vec<_>>());
                }
                rows.extend(rows.first().map(|[t, r, s]| [TAU + t, *r, *s]));
                rows.windows(2).fold([0.0; 3], |[x, y, turn], pair| {
                    let [radial_x, radial_y, _] = waves(pair, 1);
                    let [shear_x, shear_y, shear] = waves(pair, 2);
                    [x + radial_x - shear_y, y + radial_y + shear_x, turn + shear]
                })
            }
        }
    }
}

/// ∫ v cos θ dθ, ∫ v sin θ dθ and ∫ v dθ between two rows, with v linear in θ, in `column` of each.
fn waves(rows: &[[f64; 3]], column: usize) -> [f64; 3] {
    let [(a, start), (b, end)] = [0, 1].map(|k| (rows[k][0], rows[k][column]));
    if b <= a {
        return [0.0; 3];
    }
    let slope = (end - start) / (b - a);
    [
        end * b.sin() - start * a.sin() + slope * (b.cos() - a.cos()),
        start * a.cos() - end * b.cos() + slope * (b.sin() - a.sin()),
        0.5 * (start + end) * (b - a),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn table(theta: Vec<f64>) -> PolarTable {
        let radial = theta
            .iter()
            .map(|t| 1.0 - 2.0 * t.cos() + 0.3 * (3.0 * t).cos())
            .collect();
        let shear = theta
            .iter()
            .map(|t| t.sin() - 0.7 * (4.0 * t).sin())
            .collect();
        PolarTable {
            file: "test".into(),
            theta,
            radial,
            shear,
        }
    }

    #[test]
    fn a_regular_half_table_is_interpolated_exactly() {
        let field = PolarField::new(&table((0..=36).map(|k| PI * f64::from(k) / 36.0).collect()));
        for angle in [0.0_f64, 0.01, 1.234, 3.0, -2.2] {
            let [radial, shear] = field.at(angle);
            assert!((radial - (1.0 - 2.0 * angle.cos() + 0.3 * (3.0 * angle).cos())).abs() < 1e-13);
            assert!((shear - (angle.sin() - 0.7 * (4.0 * angle).sin())).abs() < 1e-13);
        }
    }

    #[test]
    fn any_other_table_is_periodic_and_exact_at_its_knots() {
        let knots = vec![0.3, 1.0, 2.5, 4.0, 6.0];
        let table = table(knots.clone());
        let field = PolarField::new(&table);
        for (k, knot) in knots.iter().enumerate() {
            assert!((field.at(*knot)[0] - table.radial[k]).abs() < 1e-14);
            assert!((field.at(*knot - TAU)[1] - table.shear[k]).abs() < 1e-12);
        }
    }

    #[test]
    fn a_table_of_half_the_circle_is_mirrored_whatever_its_steps() {
        let field = PolarField::new(&table(vec![0.0, 0.4, 1.0, 2.5, PI]));
        for angle in [1e-9_f64, 0.2, 0.7, 1.0, 2.0, 3.0, PI] {
            let ([above, forward], [below, backward]) = (field.at(angle), field.at(-angle));
            assert!((above - below).abs() < 1e-14, "{angle}: {above} {below}");
            // At 0 and π the shear itself vanishes.
            assert!(
                (forward + backward).abs() < 1e-8,
                "{angle}: {forward} {backward}"
            );
        }
        // Half-way between the last two knots, not on the way back to the first.
        let middle = f64::midpoint(2.5, PI);
        let expected = f64::midpoint(field.at(2.5)[0], field.at(PI)[0]);
        assert!((field.at(-middle)[0] - expected).abs() < 1e-14);
    }

    /// Values of order 1 with a jump or two, by the midpoint rule in 10⁶ parts: within the width of a part.
    #[test]
    fn the_resultant_is_the_integral() {
        let half: Vec<f64> = (0..=36).map(|k| PI * f64::from(k) / 36.0).collect();
        let uneven = vec![0.0, 0.4, 1.0, 2.5, PI];
        let around = vec![0.3, 1.0, 2.5, 4.0, 6.0];
        for knots in [half, uneven, around] {
            let field = PolarField::new(&table(knots));
            let parts = 1_000_000;
            let width = TAU / f64::from(parts);
            let mut sums = [0.0; 3];
            for part in 0..parts {
                let angle = width * (f64::from(part) + 0.5);
                let (sine, cosine) = angle.sin_cos();
                let [radial, shear] = field.at(angle);
                sums[0] += width * (radial * cosine - shear * sine);
                sums[1] += width * (radial * sine + shear * cosine);
                sums[2] += width * shear;
            }
            for (found, expected) in field.resultant().iter().zip(sums) {
                assert!((found - expected).abs() < 1e-5, "{found} {expected}");
            }
        }
    }
}
