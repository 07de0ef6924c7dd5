//! A cylindrical cap on a block: the Hertz problem.
//!
//! ```text
//!   y = H  ┌───────────────┐
//!          │     upper     │         arc: y = R − √(R² − x²)
//!          └──╮         ╭──┘
//!   y = 0  ┌───╰───────╯───┐
//!          │     lower     │
//!  y = −H  └───────────────┘
//!        −L                L
//! ```
//!
//! Both bodies have the same grid lines x, so their contact nodes face each other.

use super::count::{Count, within};
use super::spacing::{at_least, at_step, geometric, geometric_cells, increasing, positive};
use super::{Blocks, Extent, Generate, GenerateError, MeshEstimate, Side};
use crate::mesh::{Curve, ElementKind, Mesh};

/// A cylindrical cap on a block. The contact point is the origin.
///
/// Sets of both: "contact", "right", and "left" (whole) or "symmetry" (half, x = 0); of the lower body also "bottom", of the
/// upper one "top".
///
/// ```
/// use stickslip_fem_core::generate::{CylinderOnBlock, Extent, Generate};
/// use stickslip_fem_core::mesh::ElementKind;
///
/// let bodies = CylinderOnBlock {
///     radius: 100.0,
///     half_width: 20.0,
///     height: 20.0,
///     inner: 2.0,
///     spacing: 0.25,
///     growth: 1.2,
///     columns: None,
///     extent: Extent::Half,
///     kind: ElementKind::Q4,
/// }
/// .generate()?;
/// assert_eq!(bodies.lower.node_set("contact")?.len(), bodies.upper.node_set("contact")?.len());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct CylinderOnBlock {
    /// Radius R of the cylinder `[length]`.
    pub radius: f64,
    /// Half width L of both bodies `[length]`, less than the radius.
    pub half_width: f64,
    /// Height H of both bodies `[length]`, more than the cap's rise at |x| = L.
    pub height: f64,
    /// Equal cells up to this |x| `[length]`, less than the half width.
    pub inner: f64,
    /// Largest width of those cells, and depth of the first row `[length]`.
    pub spacing: f64,
    /// Largest growth of cells from one to the next further out and further down, at least 1 `[1]`.
    pub growth: f64,
    /// Grid lines x `[length]` instead of those that `inner`, `spacing` and `growth` make: increasing, from −L or in a half from 0 to L.
    pub columns: Option<Vec<f64>>,
    /// x ≥ 0 only, or all.
    pub extent: Extent,
    /// Kind of the cells.
    pub kind: ElementKind,
}

/// The two bodies of [`CylinderOnBlock`].
#[derive(Clone, Debug, PartialEq)]
pub struct CylinderOnBlockMeshes {
    /// The block under y = 0.
    pub lower: Mesh,
    /// The cap over it.
    pub upper: Mesh,
}

impl CylinderOnBlock {
    fn check(&self) -> Result<(), GenerateError> {
        let sizes = [
            ("radius", self.radius),
            ("half width", self.half_width),
            ("height", self.height),
            ("inner width", self.inner),
            ("spacing", self.spacing),
        ];
        sizes
            .into_iter()
            .try_for_each(|(what, size)| positive(what, size))?;
        let smaller = |what, value, bound_name, bound| {
            let fits = value < bound;
            if fits {
                Ok(())
            } else {
                Err(GenerateError::TooBig {
                    what,
                    value,
                    bound_name,
                    bound,
                })
            }
        };
        smaller("half width", self.half_width, "radius", self.radius)?;
        if let Some(columns) = &self.columns {
            self.check_columns(columns)?;
        }
        smaller("inner width", self.inner, "half width", self.half_width)?;
        smaller(
            "rise of the cap",
            self.arc(self.half_width),
            "height",
            self.height,
        )
    }

    fn check_columns(&self, columns: &[f64]) -> Result<(), GenerateError> {
        at_least("grid lines", columns.len(), 2)?;
        increasing("grid lines", columns)?;
        let first = match self.extent {
            Extent::Half => 0.0,
            Extent::Whole => -self.half_width,
        };
        let ends = [
            (columns[0], first, "first grid line"),
            (
                columns[columns.len() - 1],
                self.half_width,
                "last grid line",
            ),
        ];
        for (value, expected, what) in ends {
            if (value - expected).abs() > 1e-9 * self.half_width {
                return Err(GenerateError::WrongEnd {
                    what,
                    expected: "an end of the body",
                    value,
                });
            }
        }
        Ok(())
    }

    /// Height of the cylinder's surface `[length]`, in the form that keeps its digits near x = 0.
    fn arc(&self, x: f64) -> f64 {
        let r = self.radius;
        x * x / (r + ((r - x) * (r + x)).max(0.0).sqrt())
    }

    /// Number of equal cells in 0 … inner, saturating.
    fn inner_cells(&self) -> usize {
        (self.inner / self.spacing - 1e-6).ceil().max(1.0) as usize
    }

    /// Width of the equal cells `[length]`.
    fn inner_spacing(&self) -> f64 {
        self.inner / self.inner_cells() as f64
    }

    /// Cells of one body along x and y.
    fn cells(&self) -> Result<[usize; 2], GenerateError> {
        self.check()?;
        let h = self.inner_spacing();
        let rows = geometric_cells(0.0, self.height, h, self.growth)?;
        if let Some(columns) = &self.columns {
            return Ok([columns.len() - 1, rows]);
        }
        let outer = geometric_cells(self.inner, self.half_width, h, self.growth)?;
        let half = outer.saturating_add(self.inner_cells());
        let columns = if self.extent == Extent::Whole {
            half.saturating_mul(2)
        } else {
            half
        };
        Ok([columns, rows])
    }

    fn columns(&self) -> Result<Vec<f64>, GenerateError> {
        if let Some(columns) = &self.columns {
            return Ok(columns.clone());
        }
        let cells = self.inner_cells();
        let equal = (0..cells).map(|k| self.inner * (k as f64 / cells as f64));
        let outer = geometric(
            self.inner,
            self.half_width,
            self.inner_spacing(),
            self.growth,
        )?;
        let half: Vec<f64> = equal.chain(outer).collect();
        Ok(match self.extent {
            Extent::Half => half,
            Extent::Whole => half
                .iter()
                .skip(1)
                .rev()
                .map(|x| -x)
                .chain(half.iter().copied())
                .collect(),
        })
    }

    /// Generates the block alone, if both bodies together have at most `limit` nodes.
    ///
    /// # Errors
    /// As [`Generate::generate_within`].
    pub fn lower_within(&self, limit: usize) -> Result<Mesh, GenerateError> {
        within(self.estimate()?, self.kind, limit)?;
        self.body("lower", "bottom", Curve::Line, |_, depth| {
            -self.height * depth
        })
    }

    /// Generates the cap alone, if both bodies together have at most `limit` nodes.
    ///
    /// # Errors
    /// As [`Generate::generate_within`].
    pub fn upper_within(&self, limit: usize) -> Result<Mesh, GenerateError> {
        within(self.estimate()?, self.kind, limit)?;
        let arc = Curve::Arc {
            centre: [0.0, self.radius],
            radius: self.radius,
        };
        self.body("upper", "top", arc, |x, depth| {
            (1.0 - depth) * self.arc(x) + depth * self.height
        })
    }

    /// Meshes one body; `y` gives the height at x and relative depth, 0 at the contact and 1 at the far side.
    fn body(
        &self,
        name: &str,
        far_side: &str,
        contact: Curve,
        y: impl Fn(f64, f64) -> f64,
    ) -> Result<Mesh, GenerateError> {
        let xs = self.columns()?;
        let rows = geometric(0.0, self.height, self.inner_spacing(), self.growth)?;
        let [ni, nj] = [xs.len() - 1, rows.len() - 1];
        let mut blocks = Blocks::new(name, self.kind);
        let block = blocks.add([ni, nj], |i, j| {
            let x = at_step(&xs, i);
            [x, y(x, at_step(&rows, j) / self.height)]
        });
        let west = if self.extent == Extent::Half {
            "symmetry"
        } else {
            "left"
        };
        for (set, side, cells, curve) in [
            ("contact", Side::South, ni, contact),
            ("right", Side::East, nj, Curve::Line),
            (far_side, Side::North, ni, Curve::Line),
            (west, Side::West, nj, Curve::Line),
        ] {
            blocks.name(set, block, side, 0..cells);
            blocks.curve(set, curve);
        }
        blocks.build()
    }
}

impl Generate for CylinderOnBlock {
    type Output = CylinderOnBlockMeshes;

    /// Both bodies together.
    fn estimate(&self) -> Result<MeshEstimate, GenerateError> {
        let one = Count::lattice(self.cells()?).estimate(self.kind);
        Ok(MeshEstimate {
            nodes: one.nodes.saturating_mul(2),
            elements: one.elements.saturating_mul(2),
        })
    }

    fn generate_within(&self, limit: usize) -> Result<CylinderOnBlockMeshes, GenerateError> {
        Ok(CylinderOnBlockMeshes {
            lower: self.lower_within(limit)?,
            upper: self.upper_within(limit)?,
        })
    }
}
