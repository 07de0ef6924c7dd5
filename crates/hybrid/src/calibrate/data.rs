//! Data with their noise, whitened, and what is projected out of them.

use stickslip_fem_core::linalg::{DenseCholesky, Matrix};

use super::CalibrateError;
use crate::least_squares::{dot, orthogonalise};

/// Errors of a block of data.
#[derive(Clone, Debug, PartialEq)]
pub enum Noise {
    /// Independent, with these standard deviations, positive, in the unit of the data.
    Independent(Vec<f64>),
    /// With this covariance, square, row by row, positive definite, in products of the units of the data.
    Correlated(Vec<f64>),
}

/// Data whose errors are independent of those of all other blocks.
#[derive(Clone, Debug, PartialEq)]
pub struct Block {
    /// What was measured, in any unit.
    pub values: Vec<f64>,
    /// Its errors.
    pub noise: Noise,
    /// What may be added to the values in any amount without anybody's asking, one list per unknown amount, in the unit of the values; lists that depend on others
    /// count once.
    pub nuisance: Vec<Vec<f64>>,
}

/// Blocks of data ready to be compared with predictions.
#[derive(Clone, Debug)]
pub struct Data {
    blocks: Vec<Whitened>,
}

#[derive(Clone, Debug)]
struct Whitened {
    values: Vec<f64>,
    scale: Scale,
    /// Orthonormal columns that span the whitened nuisances.
    nuisance: Vec<Vec<f64>>,
    shape: Option<Shape>,
}

/// The shape of a further error, whitened, without what nuisances take: a unit vector, and its size in standard deviations.
#[derive(Clone, Debug)]
struct Shape {
    unit: Vec<f64>,
    size: f64,
}

/// How much of the shape of an error a prediction leaves in a block of data.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Amount {
    /// The most likely amount, in standard deviations `[1]`.
    pub value: f64,
    /// Its standard deviation `[1]` by the data and by what was known before, which is 1.
    pub deviation: f64,
}

#[derive(Clone, Debug)]
enum Scale {
    Deviations(Vec<f64>),
    Factor(DenseCholesky),
}

impl Scale {
    /// L⁻¹ x.
    fn whitened(&self, mut values: Vec<f64>) -> Vec<f64> {
        match self {
            Self::Deviations(own) => {
                values.iter_mut().zip(own).for_each(|(x, own)| *x /= own);
                values
            }
            Self::Factor(factor) => factor.whiten(&values),
        }
    }

    /// L x.
    fn coloured(&self, values: &[f64]) -> Vec<f64> {
        match self {
            Self::Deviations(own) => values.iter().zip(own).map(|(x, own)| x * own).collect(),
            Self::Factor(factor) => {
                let product = factor.lower().multiply(&Matrix::column(values));
                product.to_row_major()
            }
        }
    }
}

impl Data {
    /// Checks and whitens `blocks`.
    ///
    /// # Errors
    /// [`CalibrateError::Length`], [`CalibrateError::Value`] and [`CalibrateError::Covariance`] where a block is invalid.
    pub fn new(blocks: Vec<Block>) -> Result<Self, CalibrateError> {
        let whitened = blocks.into_iter().enumerate();
        let blocks = whitened
            .map(|(index, block)| block.whitened(index))
            .collect::<Result<_, _>>()?;
        Ok(Self { blocks })
    }

    /// The same data with one more error in each block: its shape times an unknown amplitude, normal about zero with standard deviation 1.
    /// `shapes[b]` has one entry for each datum of block b, in its unit.
    ///
    /// It adds d dᵀ to the covariance of a block with shape d. A shape that is small beside the errors changes nothing, and one that is
    /// large takes away all that the data say along it, as a nuisance does.
    ///
    /// # Errors
    /// [`CalibrateError::Length`] and [`CalibrateError::Value`] where a shape is invalid; blocks beyond `shapes` keep their errors.
    pub fn with_shapes(mut self, shapes: &[Vec<f64>]) -> Result<Self, CalibrateError> {
        for (index, (block, shape)) in self.blocks.iter_mut().zip(shapes).enumerate() {
            length("shape", index, block.values.len(), shape)?;
            let mut unit = block.scale.whitened(shape.clone());
            orthogonalise(&mut unit, &block.nuisance);
            let size = dot(&unit, &unit).sqrt();
            block.shape = (size > 0.0).then(|| {
                let unit = unit.into_iter().map(|x| x / size).collect();
                Shape { unit, size }
            });
        }
        Ok(self)
    }

    /// The amount of its [shape](Self::with_shapes) that each block shows beside a prediction in the units of the data; `None` for blocks without.
    pub fn amounts(&self, predicted: &[f64]) -> Vec<Option<Amount>> {
        let mut rest = predicted;
        let each = self.blocks.iter().map(|block| {
            let (own, next) = rest.split_at(block.values.len().min(rest.len()));
            rest = next;
            let shape = block.shape.as_ref()?;
            let left = dot(&shape.unit, &block.left(own));
            let variance = 1.0 / (1.0 + shape.size * shape.size);
            Some(Amount {
                value: left * shape.size * variance,
                deviation: variance.sqrt(),
            })
        });
        each.collect()
    }

    /// Number of data.
    pub fn count(&self) -> usize {
        self.blocks.iter().map(|block| block.values.len()).sum()
    }

    /// Number of independent nuisances.
    pub fn nuisances(&self) -> usize {
        self.blocks.iter().map(|block| block.nuisance.len()).sum()
    }

    /// What is left of data less prediction when the nuisances have taken what they can, in standard deviations `[1]`. `predicted` has as many
    /// entries as there are [data](Self::count).
    pub fn residual(&self, predicted: &[f64]) -> Vec<f64> {
        self.each(predicted, Whitened::residual)
    }

    /// Computes χ² `[1]` of a prediction, which has as many entries as there are [data](Self::count).
    pub fn chi_squared(&self, predicted: &[f64]) -> f64 {
        self.residual(predicted).iter().map(|r| r * r).sum()
    }

    /// The prediction with the amounts of nuisances and shapes that fit best, in the units of the data.
    pub fn fitted(&self, predicted: &[f64]) -> Vec<f64> {
        self.each(predicted, |block, predicted| {
            let mut left = block.left(predicted);
            if let Some(shape) = &block.shape {
                shape.shrink(&mut left, 1.0 / (1.0 + shape.size * shape.size));
            }
            let left = block.scale.coloured(&left);
            block.values.iter().zip(left).map(|(m, r)| m - r).collect()
        })
    }

    fn each(&self, predicted: &[f64], of: impl Fn(&Whitened, &[f64]) -> Vec<f64>) -> Vec<f64> {
        let mut all = Vec::with_capacity(predicted.len());
        let mut rest = predicted;
        for block in &self.blocks {
            let (own, next) = rest.split_at(block.values.len().min(rest.len()));
            all.extend(of(block, own));
            rest = next;
        }
        all
    }
}

impl Shape {
    /// Leaves the part `part` of what `vector` has along the shape.
    fn shrink(&self, vector: &mut [f64], part: f64) {
        let amount = (1.0 - part) * dot(&self.unit, vector);
        vector
            .iter_mut()
            .zip(&self.unit)
            .for_each(|(x, unit)| *x -= amount * unit);
    }
}

impl Whitened {
    /// What the nuisances leave.
    fn left(&self, predicted: &[f64]) -> Vec<f64> {
        let differences = self.values.iter().zip(predicted).map(|(m, h)| m - h);
        let mut left = self.scale.whitened(differences.collect());
        orthogonalise(&mut left, &self.nuisance);
        left
    }

    /// (I + d dᵀ)^(−1/2) of that.
    fn residual(&self, predicted: &[f64]) -> Vec<f64> {
        let mut residual = self.left(predicted);
        if let Some(shape) = &self.shape {
            shape.shrink(&mut residual, 1.0 / 1.0_f64.hypot(shape.size));
        }
        residual
    }
}

impl Block {
    fn whitened(self, block: usize) -> Result<Whitened, CalibrateError> {
        let count = self.values.len();
        let length = |what, expected, values: &[f64]| length(what, block, expected, values);
        finite("value", block, &self.values)?;
        let scale = match self.noise {
            Noise::Independent(deviations) => {
                length("deviation", count, &deviations)?;
                all("deviation", block, &deviations, |own| own > 0.0)?;
                Scale::Deviations(deviations)
            }
            Noise::Correlated(covariance) => {
                length("covariance", count * count, &covariance)?;
                let square = Matrix::from_fn(count, count, |i, j| covariance[i * count + j]);
                let factor = DenseCholesky::new(square).map_err(|cause| {
                    let row = cause.row;
                    CalibrateError::Covariance { block, row }
                })?;
                Scale::Factor(factor)
            }
        };
        let mut nuisance: Vec<Vec<f64>> = Vec::new();
        for column in self.nuisance {
            length("nuisance", count, &column)?;
            nuisance.extend(independent(&nuisance, scale.whitened(column)));
        }
        let values = self.values;
        Ok(Whitened {
            values,
            scale,
            nuisance,
            shape: None,
        })
    }
}

/// Whether `values` are `expected` finite numbers.
fn length(
    what: &'static str,
    block: usize,
    expected: usize,
    values: &[f64],
) -> Result<(), CalibrateError> {
    if values.len() == expected {
        return finite(what, block, values);
    }
    let found = values.len();
    Err(CalibrateError::Length {
        what,
        block,
        expected,
        found,
    })
}

fn finite(what: &'static str, block: usize, values: &[f64]) -> Result<(), CalibrateError> {
    all(what, block, values, f64::is_finite)
}

/// Whether all `values` fit.
fn all(
    what: &'static str,
    block: usize,
    values: &[f64],
    fits: impl Fn(f64) -> bool,
) -> Result<(), CalibrateError> {
    match values.iter().position(|&value| !fits(value)) {
        Some(index) => Err(CalibrateError::Value {
            what,
            block,
            index,
            value: values[index],
        }),
        None => Ok(()),
    }
}

/// The unit vector along what `column` adds to the span of `columns`; `None` where that is rounding.
fn independent(columns: &[Vec<f64>], mut column: Vec<f64>) -> Option<Vec<f64>> {
    const ROUNDING: f64 = 1e-10;
    let before = dot(&column, &column).sqrt();
    orthogonalise(&mut column, columns);
    let left = dot(&column, &column).sqrt();
    if left <= ROUNDING * before {
        return None;
    }
    Some(column.into_iter().map(|x| x / left).collect())
}
