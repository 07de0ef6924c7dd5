//! The box around the hole: which ray goes to which corner, and where the strip goes on.

use std::f64::consts::{PI, TAU};
use std::ops::Range;

use super::super::GenerateError;
use super::super::fan::{ANGLE_ROUNDING, Rim, unit_vector};
use super::super::spacing::{at_least, between, positive};
use crate::mesh::Point;

/// A side up to this many half widths from the hole is reached by the fan itself.
const BOX_STRETCH: f64 = 1.25;

/// Refuses an outline that touches the hole.
pub(super) fn exceeds_hole(
    what: &'static str,
    size: f64,
    hole_radius: f64,
) -> Result<(), GenerateError> {
    positive(what, size)?;
    if hole_radius < size {
        return Ok(());
    }
    Err(GenerateError::TooBig {
        what: "hole radius",
        value: hole_radius,
        bound_name: what,
        bound: size,
    })
}

/// One of the two ends of the box, where the strip ends or goes on.
#[derive(Debug)]
pub(super) struct Join {
    /// "left" or "right".
    pub(super) set: &'static str,
    /// First ray of the end, and number of cells along it.
    pub(super) start: usize,
    pub(super) cells: usize,
    /// The ray along y = 0, the same line in a half and in the whole, so that a half is the whole cut in two.
    pub(super) axis: usize,
    /// x where the strip ends, if beyond the box `[length]`.
    pub(super) end: Option<f64>,
    /// Names of the long sides at the first and the last ray.
    pub(super) first_row: &'static str,
    pub(super) last_row: &'static str,
}

/// The box and the rays to its corners.
#[derive(Debug)]
pub(super) struct Frame {
    half_width: f64,
    /// x of the box `[length]`.
    left: f64,
    right: f64,
    /// x of the strip's ends beyond the box `[length]`.
    far_left: Option<f64>,
    far_right: Option<f64>,
    /// Ray to each corner: top right, top left and, if whole, bottom left, bottom right.
    corners: Vec<usize>,
    intervals: usize,
    closed: bool,
}

impl Frame {
    /// `sizes` are the half width and the distances to the left and the right end `[length]`.
    pub(super) fn new(
        rim: &Rim,
        hole_radius: f64,
        sizes: [f64; 3],
        far_cells: usize,
    ) -> Result<Self, GenerateError> {
        for (what, size) in ["half width", "left end", "right end"]
            .into_iter()
            .zip(sizes)
        {
            exceeds_hole(what, size, hole_radius)?;
        }
        let [half_width, left, right] = sizes;
        let stop = |end: f64| {
            let beyond = end > BOX_STRETCH * half_width;
            if beyond {
                (half_width, Some(end))
            } else {
                (end, None)
            }
        };
        let ((left, far_left), (right, far_right)) = (stop(left), stop(right));
        if far_left.is_some() || far_right.is_some() {
            at_least("far cells", far_cells, 1)?;
        }
        let mut frame = Self {
            half_width,
            left: -left,
            right,
            far_left: far_left.map(|end| -end),
            far_right,
            corners: Vec::new(),
            intervals: rim.intervals(),
            closed: rim.closed,
        };
        frame.corners = frame.corner_rays(rim)?;
        Ok(frame)
    }

    fn corner_points(&self) -> Vec<Point> {
        let (left, right, top) = (self.left, self.right, self.half_width);
        let all = [[right, top], [left, top], [left, -top], [right, -top]];
        all[..if self.closed { 4 } else { 2 }].to_vec()
    }

    /// For every corner the nearest ray that leaves one for each of the other corners. A whole rim that is mirrored about y = 0 has the
    /// rays of its half and their mirror images, so that both have the same cells.
    fn corner_rays(&self, rim: &Rim) -> Result<Vec<usize>, GenerateError> {
        if let Some(half) = rim.mirrored_half() {
            let above = nearest_rays(&half, &self.corner_points()[..2])?;
            let below = above.iter().rev().map(|ray| rim.intervals() - ray);
            return Ok(above.iter().copied().chain(below).collect());
        }
        nearest_rays(rim, &self.corner_points())
    }

    /// Outline points of the rays: between two corners the hole angles are stretched to the corners' directions.
    pub(super) fn points(&self, rim: &Rim) -> Vec<Point> {
        (0..=self.intervals)
            .map(|ray| self.point(rim, ray))
            .collect()
    }

    fn point(&self, rim: &Rim, ray: usize) -> Point {
        let corners = self.corner_points();
        if let Some(k) = self.corners.iter().position(|&corner| corner == ray) {
            return corners[k];
        }
        let (left, right, top) = (self.left, self.right, self.half_width);
        let [x, y] = unit_vector(self.outline_angle(rim, ray));
        match self.corners.iter().filter(|&&corner| corner < ray).count() {
            1 => [top * x / y, top],
            2 => [left, left * y / x],
            3 => [-top * x / y, -top],
            _ => [right, right * y / x],
        }
    }

    /// Direction of the outline's node on `ray` `[rad]`.
    fn outline_angle(&self, rim: &Rim, ray: usize) -> f64 {
        let ends = [
            (0, 0.0),
            (self.intervals, if self.closed { TAU } else { PI }),
        ];
        let directions = self.corner_points().into_iter().map(direction);
        let corners = self.corners.iter().copied().zip(directions);
        let anchors: Vec<(usize, f64)> = [ends[0]]
            .into_iter()
            .chain(corners)
            .chain([ends[1]])
            .collect();
        let next = anchors
            .partition_point(|&(anchor, _)| anchor < ray)
            .clamp(1, anchors.len() - 1);
        let ((a, from), (b, to)) = (anchors[next - 1], anchors[next]);
        let share = (rim.angles[ray] - rim.angles[a]) / (rim.angles[b] - rim.angles[a]);
        (1.0 - share) * from + share * to
    }

    /// The two ends of the box.
    pub(super) fn joins(&self) -> [Join; 2] {
        let corner = |k: usize| self.corners[k];
        let (right_start, right_cells, left_end, left_axis) = if self.closed {
            let middle = usize::midpoint(corner(1), corner(2));
            (
                corner(3),
                self.intervals - corner(3) + corner(0),
                corner(2),
                middle,
            )
        } else {
            (0, corner(0), self.intervals, self.intervals)
        };
        let below = if self.closed { "bottom" } else { "symmetry" };
        [
            Join {
                set: "right",
                start: right_start,
                cells: right_cells,
                axis: 0,
                end: self.far_right,
                first_row: below,
                last_row: "top",
            },
            Join {
                set: "left",
                start: corner(1),
                cells: left_end - corner(1),
                axis: left_axis,
                end: self.far_left,
                first_row: "top",
                last_row: below,
            },
        ]
    }

    /// Cells of the fan along the top and, if whole, the bottom.
    pub(super) fn long_sides(&self) -> Vec<(&'static str, Range<usize>)> {
        let mut sides = vec![("top", self.corners[0]..self.corners[1])];
        if self.closed {
            sides.push(("bottom", self.corners[2]..self.corners[3]));
        }
        sides
    }

    /// Cells of the fan along an end of the box; two ranges if it contains θ = 0 of a whole circle.
    pub(super) fn ranges(&self, join: &Join) -> impl Iterator<Item = Range<usize>> + use<> {
        let end = join.start + join.cells;
        let split = end.min(self.intervals);
        [join.start..split, 0..end - split].into_iter()
    }

    /// A lattice position counted past the full turn.
    pub(super) fn wrapped_step(&self, step: f64) -> f64 {
        let turn = self.intervals as f64;
        if step > turn { step - turn } else { step }
    }
}

/// Point of the outline with `points` at the rays, at `step` along the hole: on the straight line between two rays.
pub(super) fn on_outline(points: &[Point], step: f64) -> Point {
    let (ray, part) = (step as usize, step.fract());
    if part == 0.0 {
        return points[ray];
    }
    let (a, b) = (points[ray], points[ray + 1]);
    [0, 1].map(|axis| between(a[axis], b[axis], part))
}

/// Every ray must leave the hole outwards; `far` are the outline's points at the rays.
pub(super) fn check_rays(rim: &Rim, far: &[Point], hole_radius: f64) -> Result<(), GenerateError> {
    for (ray, &angle) in rim.angles.iter().enumerate() {
        let ([x, y], [cos, sin]) = (far[ray], unit_vector(angle));
        if x * cos + y * sin <= hole_radius {
            let outline = direction(far[ray]);
            return Err(GenerateError::RayThroughHole { angle, outline });
        }
    }
    Ok(())
}

/// For every one of `corners` the nearest ray; of two equally far ones that closer to the x axis, at both ends of the box.
fn nearest_rays(rim: &Rim, corners: &[Point]) -> Result<Vec<usize>, GenerateError> {
    let mut rays = Vec::with_capacity(corners.len());
    let mut first = 1;
    for (k, corner) in corners.iter().map(|&corner| direction(corner)).enumerate() {
        let end = (rim.intervals() + 1).saturating_sub(corners.len() - k);
        let away = |ray: usize| (rim.angles[ray] - corner).abs();
        let closer = |best: usize, ray: usize| {
            let gain = away(best) - away(ray);
            let axis = rim.angles[best].sin().abs() - rim.angles[ray].sin().abs();
            let equal = gain.abs() <= ANGLE_ROUNDING;
            let better = if equal { axis > 0.0 } else { gain > 0.0 };
            if better { ray } else { best }
        };
        let Some(ray) = (first..end).reduce(closer) else {
            let nearest = rim.angles[first.min(rim.intervals())];
            return Err(GenerateError::CornerUnresolved { corner, nearest });
        };
        rays.push(ray);
        first = ray + 1;
    }
    Ok(rays)
}

/// Direction of a point seen from the origin `[rad]`, in [0, 2π).
fn direction(point: Point) -> f64 {
    let angle = point[1].atan2(point[0]);
    if angle < 0.0 { angle + TAU } else { angle }
}
