//! Plates with a circular hole.
//!
//! A fan of cells leads from the hole to a box around it; rectangles with the same grid lines continue the strip where it is
//! much longer than the box.
//!
//! ```text
//!   ┌────────────┬───────────┐
//!   │  far cells │ ╲ fan  ╱  │
//!   ├──┬──┬──┬───┤   ╭─╮     │       y ↑
//!   │  │  │  │   │   ╰─╯     │         └→ x = load axis, θ = 0
//!   ├──┼──┼──┼───┤ ╱     ╲   │
//!   └────────────┴───────────┘
//! ```
//!
//! The hole node nearest to each corner direction is joined to that corner; the other outline nodes follow the hole angles
//! between the corners.

mod outline;

use self::outline::{Frame, Join, check_rays, exceeds_hole, on_outline};
use super::count::{Count, within};
use super::fan::{Fan, Rim};
use super::spacing::{at_step, layer_fractions, positive};
use super::{Blocks, Extent, Generate, GenerateError, Growth, MeshEstimate, Side};
use crate::mesh::{Curve, ElementKind, Mesh};

/// What surrounds the hole. The hole's centre is the origin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Outline {
    /// The strip −left ≤ x ≤ right, |y| ≤ half_width, all `[length]`.
    Strip {
        /// Half the width of the strip `[length]`.
        half_width: f64,
        /// Distance from the hole's centre to the left end `[length]`.
        left: f64,
        /// Distance from the hole's centre to the right end `[length]`.
        right: f64,
    },
    /// A concentric circle.
    Ring {
        /// Its radius `[length]`.
        outer_radius: f64,
    },
}

/// A plate with a hole.
///
/// Edge and node sets: "hole"; of a strip "left", "right", "top" and, if whole, "bottom"; of a ring "outer"; of a half
/// "symmetry" (y = 0, both sides of the hole).
///
/// ```
/// use stickslip_fem_core::generate::{Extent, Generate, Growth, Outline, PlateWithHole, uniform_angles};
/// use stickslip_fem_core::mesh::ElementKind;
///
/// let plate = PlateWithHole {
///     hole_radius: 0.375,
///     outline: Outline::Strip { half_width: 1.495, left: 7.005, right: 1.5 },
///     extent: Extent::Half,
///     angles: uniform_angles(Extent::Half, 20),
///     layers: 8,
///     growth: Growth::Geometric { aspect: 1.0 },
///     far_cells: 6,
///     kind: ElementKind::Q8,
/// };
/// let mesh = plate.generate()?;
/// let hole = mesh.counter_clockwise(&mesh.edge_path("hole")?, [0.0, 0.0]);
/// assert_eq!(hole.nodes.len(), 41);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct PlateWithHole {
    /// Radius of the hole `[length]`.
    pub hole_radius: f64,
    /// What surrounds it.
    pub outline: Outline,
    /// y ≥ 0 only, or all.
    pub extent: Extent,
    /// Angles of the hole's corner nodes `[rad]`, strictly increasing: from 0 to π for half, from 0 to below 2π for whole.
    pub angles: Vec<f64>,
    /// Layers of cells between the hole and the box or ring.
    pub layers: usize,
    /// How the layers grow.
    pub growth: Growth,
    /// Cells along x in each part of a strip beyond the box; unused if there is none.
    pub far_cells: usize,
    /// Kind of the cells.
    pub kind: ElementKind,
}

/// The checked outline.
enum Surround {
    Circle { radius: f64 },
    Box(Frame),
}

impl PlateWithHole {
    fn rim(&self) -> Result<Rim, GenerateError> {
        positive("hole radius", self.hole_radius)?;
        self.growth.check(self.layers)?;
        Rim::new(self.extent, &self.angles)
    }

    /// Checks the outline and fits the rays to it.
    fn surround(&self, rim: &Rim) -> Result<Surround, GenerateError> {
        match self.outline {
            Outline::Ring {
                outer_radius: radius,
            } => {
                exceeds_hole("outer radius", radius, self.hole_radius)?;
                Ok(Surround::Circle { radius })
            }
            Outline::Strip {
                half_width,
                left,
                right,
            } => {
                let sizes = [half_width, left, right];
                let frame = Frame::new(rim, self.hole_radius, sizes, self.far_cells)?;
                Ok(Surround::Box(frame))
            }
        }
    }

    fn ring_mesh(&self, rim: &Rim, outer_radius: f64) -> Result<Mesh, GenerateError> {
        let outer = |step| rim.on_circle(outer_radius, step);
        let fan = Fan::new(rim, self.hole_radius, outer, self.layers, &self.growth);
        let (mut blocks, plate) = self.fan_block(rim, &fan);
        blocks.name("outer", plate, Side::North, 0..rim.intervals());
        blocks.curve(
            "outer",
            Curve::Arc {
                centre: [0.0; 2],
                radius: outer_radius,
            },
        );
        blocks.build()
    }

    fn strip_mesh(&self, rim: &Rim, frame: &Frame) -> Result<Mesh, GenerateError> {
        let far = frame.points(rim);
        check_rays(rim, &far, self.hole_radius)?;
        let fan = Fan::new(
            rim,
            self.hole_radius,
            |step| on_outline(&far, step),
            self.layers,
            &self.growth,
        );
        let (mut blocks, plate) = self.fan_block(rim, &fan);
        for join in frame.joins() {
            match join.end {
                Some(end) => self.far_rectangle(&mut blocks, frame, &fan, &join, end),
                None => frame.ranges(&join).for_each(|range| {
                    blocks.name(join.set, plate, Side::North, range);
                }),
            }
        }
        for (set, range) in frame.long_sides() {
            blocks.name(set, plate, Side::North, range);
        }
        for set in ["left", "right", "top", "bottom"] {
            blocks.curve(set, Curve::Line);
        }
        blocks.build()
    }

    /// Starts the mesh with the fan and names the hole and the cut.
    fn fan_block(&self, rim: &Rim, fan: &Fan<'_>) -> (Blocks, super::BlockId) {
        let mut blocks = Blocks::new("plate", self.kind);
        let plate = blocks.add([rim.intervals(), self.layers], |i, j| fan.at(i, j));
        blocks.name("hole", plate, Side::South, 0..rim.intervals());
        blocks.curve(
            "hole",
            Curve::Arc {
                centre: [0.0; 2],
                radius: self.hole_radius,
            },
        );
        if !rim.closed {
            blocks.name("symmetry", plate, Side::West, 0..self.layers);
            blocks.name("symmetry", plate, Side::East, 0..self.layers);
            blocks.curve("symmetry", Curve::Line);
        }
        (blocks, plate)
    }

    /// Continues the strip from the box to x = `end`.
    fn far_rectangle(
        &self,
        blocks: &mut Blocks,
        frame: &Frame,
        fan: &Fan<'_>,
        join: &Join,
        end: f64,
    ) {
        let cells = [self.far_cells, join.cells];
        let start = fan.far_at(join.start as f64)[0];
        let first = fan.last_thickness(join.axis) / (end - start).abs();
        let fractions = layer_fractions(self.far_cells, first);
        let block = blocks.add(cells, |i, j| {
            let s = at_step(&fractions, i);
            let y = fan.far_at(frame.wrapped_step(join.start as f64 + j))[1];
            [(1.0 - s) * start + s * end, y]
        });
        blocks.name(join.set, block, Side::East, 0..join.cells);
        for (set, side) in [(join.first_row, Side::South), (join.last_row, Side::North)] {
            blocks.name(set, block, side, 0..self.far_cells);
        }
    }
}

impl Generate for PlateWithHole {
    type Output = Mesh;

    fn estimate(&self) -> Result<MeshEstimate, GenerateError> {
        let rim = self.rim()?;
        let fan = Count::lattice([rim.intervals(), self.layers]);
        let fan = if rim.closed {
            fan.closed(self.layers)
        } else {
            fan
        };
        let frame = match self.surround(&rim)? {
            Surround::Box(frame) => frame,
            Surround::Circle { .. } => return Ok(fan.estimate(self.kind)),
        };
        let far = frame.joins().into_iter().filter(|join| join.end.is_some());
        let count = far.fold(fan, |sum, join| {
            sum.joined([self.far_cells, join.cells], join.cells + 1)
        });
        Ok(count.estimate(self.kind))
    }

    fn generate_within(&self, limit: usize) -> Result<Mesh, GenerateError> {
        within(self.estimate()?, self.kind, limit)?;
        let rim = self.rim()?;
        match self.surround(&rim)? {
            Surround::Box(frame) => self.strip_mesh(&rim, &frame),
            Surround::Circle { radius } => self.ring_mesh(&rim, radius),
        }
    }
}
