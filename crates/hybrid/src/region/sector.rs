//! Meshes of arc sectors around a hole, at a distance from bad data.
//!
//! ```text
//! x(i, j) = c + r_j (cos θᵢ, sin θᵢ),   r₀ = R + d,   r_n = R_o,   θ₀ … θ_m
//! ```
//!
//! with R the radius of the hole and d the stand-off, inside which the data are not trusted.

use std::f64::consts::TAU;

use stickslip_fem_core::generate::{Blocks, Side, graded};
use stickslip_fem_core::mesh::{Curve, ElementKind, Mesh, Point};

use super::RegionError;

/// Turns this close to a whole one are meant to be whole `[rad]`.
const ANGLE_ROUNDING: f64 = 1e-9;

/// A sector between two circles. Sets: "inner", "outer", and unless it is a whole ring "start" and "end".
#[derive(Clone, Debug, PartialEq)]
pub struct ArcSector {
    /// Centre of the hole `[length]`.
    pub centre: Point,
    /// Radius of the hole `[length]`.
    pub hole: f64,
    /// Distance of the inner circle from the hole's edge `[length]`.
    pub stand_off: f64,
    /// Radius of the outer circle `[length]`.
    pub outer: f64,
    /// First and last angle `[rad]`, counter-clockwise from x; a whole turn makes a ring.
    pub angles: [f64; 2],
    /// Cells around and outwards.
    pub cells: [usize; 2],
    /// Thickness of the outermost layer over that of the innermost `[1]`.
    pub growth: f64,
    /// Kind of the cells.
    pub kind: ElementKind,
}

impl ArcSector {
    /// Radius of the inner circle `[length]`.
    pub fn inner(&self) -> f64 {
        self.hole + self.stand_off
    }

    /// The mesh.
    ///
    /// # Errors
    /// [`RegionError::Generate`] where radii or angles do not increase, there are no cells, or more than a whole turn makes them
    /// overlap.
    pub fn mesh(&self) -> Result<Mesh, RegionError> {
        let radii = graded(self.inner(), self.outer, self.cells[1], self.growth)?;
        let angles = graded(self.angles[0], self.angles[1], self.cells[0], 1.0)?;
        let at = |list: &[f64], step: f64| {
            let whole = (step as usize).min(list.len() - 1);
            let next = (whole + 1).min(list.len() - 1);
            list[whole] + (step - whole as f64) * (list[next] - list[whole])
        };
        let mut blocks = Blocks::new("sector", self.kind);
        let block = blocks.add(self.cells, |i, j| {
            let (r, (sin, cos)) = (at(&radii, j), at(&angles, i).sin_cos());
            [self.centre[0] + r * cos, self.centre[1] + r * sin]
        });
        let arcs = [
            ("inner", Side::South, self.inner()),
            ("outer", Side::North, self.outer),
        ];
        for (set, side, radius) in arcs {
            blocks.name(set, block, side, 0..self.cells[0]);
            let centre = self.centre;
            blocks.curve(set, Curve::Arc { centre, radius });
        }
        if (self.angles[1] - self.angles[0] - TAU).abs() > ANGLE_ROUNDING {
            for (set, side) in [("start", Side::West), ("end", Side::East)] {
                blocks.name(set, block, side, 0..self.cells[1]);
                blocks.curve(set, Curve::Line);
            }
        }
        Ok(blocks.build()?)
    }
}
