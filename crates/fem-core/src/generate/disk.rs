//! Disks.
//!
//! Rings of cells lead from the rim to an octagonal core, which is filled by one mapped block per quadrant. The core block of
//! a quadrant has as many cells along each half-axis as along the side opposite to it, so with V₁ cells from the x axis to
//! the first core corner and so on
//!
//! ```text
//! V₁ = U₂,   V₂ = U₃,   V₃ = U₄,   V₄ = U₁,   N = Σ (V + U):
//! ```
//!
//! a whole disk needs an even number N of rim cells, a half disk any N ≥ 4, and the centre is always a node.

mod core;

use self::core::Core;
use super::count::{Count, within};
use super::fan::{Fan, Rim};
use super::spacing::{at_least, positive};
use super::{Blocks, Extent, Generate, GenerateError, Growth, MeshEstimate, Side};
use crate::mesh::{Curve, ElementKind, Mesh, Point};

/// A disk, for a pin.
///
/// Edge and node sets: "rim"; of a half "symmetry" (the diameter); the node set "centre" holds the node at the centre.
///
/// ```
/// use stickslip_fem_core::generate::{Disk, Extent, Generate, Growth, uniform_angles};
/// use stickslip_fem_core::mesh::ElementKind;
///
/// let disk = Disk {
///     radius: 0.375,
///     centre: [0.0, 0.0],
///     extent: Extent::Whole,
///     angles: uniform_angles(Extent::Whole, 32),
///     core: Disk::CORE,
///     layers: 5,
///     growth: Growth::Geometric { aspect: 1.0 },
///     kind: ElementKind::Q9,
/// };
/// let mesh = disk.generate()?;
/// let centre = mesh.node_set("centre")?[0];
/// assert_eq!(mesh.nodes()[centre], [0.0, 0.0]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Disk {
    /// Radius `[length]`.
    pub radius: f64,
    /// Centre `[length]`.
    pub centre: Point,
    /// The half above the centre, or all.
    pub extent: Extent,
    /// Angles of the rim's corner nodes `[rad]`, as for [`super::PlateWithHole`].
    pub angles: Vec<f64>,
    /// Radius of the core's corners over the radius of the disk `[1]`, between 0 and 1.
    pub core: f64,
    /// Rings of cells between the rim and the core.
    pub layers: usize,
    /// How the rings grow inwards.
    pub growth: Growth,
    /// Kind of the cells.
    pub kind: ElementKind,
}

impl Disk {
    /// A core size `[1]` that gives well-shaped cells.
    pub const CORE: f64 = 0.45;

    /// Checks the input and lays out the core.
    fn layout(&self) -> Result<(Rim, Core), GenerateError> {
        positive("radius", self.radius)?;
        positive("core fraction", self.core)?;
        if self.core >= 1.0 {
            let (what, bound_name) = ("core fraction", "the whole radius");
            return Err(GenerateError::TooBig {
                what,
                value: self.core,
                bound_name,
                bound: 1.0,
            });
        }
        if let Some(&value) = self.centre.iter().find(|c| !c.is_finite()) {
            return Err(GenerateError::NotFinite {
                what: "centre",
                value,
            });
        }
        self.growth.check(self.layers)?;
        let rim = Rim::new(self.extent, &self.angles)?;
        let count = rim.intervals();
        if rim.closed && count % 2 == 1 {
            return Err(GenerateError::OddRim { count });
        }
        at_least("cells along the rim", count, if rim.closed { 8 } else { 4 })?;
        let core = Core::new(&rim, self.core * self.radius);
        Ok((rim, core))
    }

    fn placed(&self, at: Point) -> Point {
        [at[0] + self.centre[0], at[1] + self.centre[1]]
    }
}

impl Generate for Disk {
    type Output = Mesh;

    fn estimate(&self) -> Result<MeshEstimate, GenerateError> {
        let (rim, core) = self.layout()?;
        let rings = Count::lattice([rim.intervals(), self.layers]);
        let count = if rim.closed {
            // Rings and core together have no hole.
            Count {
                ring: false,
                ..rings.closed(self.layers)
            }
            .joined(core.cells(), rim.intervals())
        } else {
            rings.joined(core.cells(), rim.intervals() + 1)
        };
        Ok(count.estimate(self.kind))
    }

    fn generate_within(&self, limit: usize) -> Result<Mesh, GenerateError> {
        within(self.estimate()?, self.kind, limit)?;
        let (rim, core) = self.layout()?;
        let fan = Fan::new(
            &rim,
            self.radius,
            |step| core.outline(step),
            self.layers,
            &self.growth,
        );
        let mut blocks = Blocks::new("disk", self.kind);
        blocks.about(self.centre);
        let rings = blocks.add([rim.intervals(), self.layers], |i, j| {
            self.placed(fan.at(i, j))
        });
        blocks.name("rim", rings, Side::South, 0..rim.intervals());
        blocks.curve(
            "rim",
            Curve::Arc {
                centre: self.centre,
                radius: self.radius,
            },
        );
        let quadrants: Vec<_> = core
            .quadrants()
            .iter()
            .map(|q| blocks.add(q.cells(), |i, j| self.placed(q.at(i, j))))
            .collect();
        blocks.name_node("centre", quadrants[0], [0, 0]);
        if !rim.closed {
            let [first, second] = [0, 1].map(|k| (quadrants[k], core.quadrants()[k].cells()));
            blocks.name("symmetry", rings, Side::West, 0..self.layers);
            blocks.name("symmetry", rings, Side::East, 0..self.layers);
            blocks.name("symmetry", first.0, Side::South, 0..first.1[0]);
            blocks.name("symmetry", second.0, Side::West, 0..second.1[1]);
            blocks.curve("symmetry", Curve::Line);
        }
        blocks.build()
    }
}
