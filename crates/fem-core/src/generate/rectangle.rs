//! Rectangles on given coordinates.

use super::count::{Count, within};
use super::spacing::{at_least, at_step, graded, increasing};
use super::{Blocks, Generate, GenerateError, MeshEstimate, Side};
use crate::mesh::{Curve, ElementKind, Mesh};

/// A rectangle with grid lines at given coordinates. Sets: "left", "right", "bottom", "top".
///
/// ```
/// use stickslip_fem_core::generate::{Generate, Rectangle, graded};
/// use stickslip_fem_core::mesh::ElementKind;
///
/// let xs = graded(0.0, 10.0, 8, 4.0)?;
/// let mesh = Rectangle { xs, ys: vec![0.0, 1.0, 2.0], kind: ElementKind::Q8 }.generate()?;
/// assert_eq!(mesh.element_count(), 16);
/// # Ok::<(), stickslip_fem_core::generate::GenerateError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Rectangle {
    /// Strictly increasing x of the grid lines `[length]`.
    pub xs: Vec<f64>,
    /// Strictly increasing y of the grid lines `[length]`.
    pub ys: Vec<f64>,
    /// Kind of the cells.
    pub kind: ElementKind,
}

impl Rectangle {
    /// Equal cells, `cells` in each direction, between the ends `x` and `y` `[length]`.
    ///
    /// # Errors
    /// As [`graded`].
    pub fn uniform(
        x: [f64; 2],
        y: [f64; 2],
        cells: [usize; 2],
        kind: ElementKind,
    ) -> Result<Self, GenerateError> {
        let xs = graded(x[0], x[1], cells[0], 1.0)?;
        let ys = graded(y[0], y[1], cells[1], 1.0)?;
        Ok(Self { xs, ys, kind })
    }

    fn cells(&self) -> Result<[usize; 2], GenerateError> {
        for (what, list) in [("x coordinates", &self.xs), ("y coordinates", &self.ys)] {
            at_least(what, list.len(), 2)?;
            increasing(what, list)?;
        }
        Ok([self.xs.len() - 1, self.ys.len() - 1])
    }
}

impl Generate for Rectangle {
    type Output = Mesh;

    fn estimate(&self) -> Result<MeshEstimate, GenerateError> {
        Ok(Count::lattice(self.cells()?).estimate(self.kind))
    }

    fn generate_within(&self, limit: usize) -> Result<Mesh, GenerateError> {
        within(self.estimate()?, self.kind, limit)?;
        let [ni, nj] = self.cells()?;
        let mut blocks = Blocks::new("rectangle", self.kind);
        let block = blocks.add([ni, nj], |i, j| {
            [at_step(&self.xs, i), at_step(&self.ys, j)]
        });
        for (set, side, cells) in [
            ("bottom", Side::South, ni),
            ("right", Side::East, nj),
            ("top", Side::North, ni),
            ("left", Side::West, nj),
        ] {
            blocks.name(set, block, side, 0..cells);
            blocks.curve(set, Curve::Line);
        }
        blocks.build()
    }
}
