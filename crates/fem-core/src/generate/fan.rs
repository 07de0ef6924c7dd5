//! Layers of cells between a contact circle and something around or inside it.
//!
//! ```text
//! x(i, j) = (1 − s) Cᵢ + s Fᵢ,   s = s(i, j) from 0 on the circle to 1 on the far side
//! ```
//!
//! Cᵢ lies on the circle at the i-th angle, Fᵢ on the far side; fractions of steps in i divide the angle, so that the inner nodes of
//! edges on the circle are on it. All cells between two rays that do not cross are convex, whatever the two lists of s.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use super::spacing::{at_least, at_step, between, increasing, layer_fractions, positive};
use super::{Extent, GenerateError, Growth};
use crate::mesh::Point;

/// Angles this close to the ends 0, π or 2π are meant to be there `[rad]`.
pub(super) const ANGLE_ROUNDING: f64 = 1e-9;

/// Largest change of the first layer's thickness per length along the circle, so that a jump in the angles' spacing does not
/// become a step in the layers.
const THICKNESS_SLOPE: f64 = 0.2;

/// Equally spaced angles `[rad]` for the contact circle: `intervals + 1` from 0 to π for half, `intervals` from 0 to below 2π
/// for whole. Empty for zero intervals.
pub fn uniform_angles(extent: Extent, intervals: usize) -> Vec<f64> {
    let (count, end) = match extent {
        _ if intervals == 0 => (0, 0.0),
        Extent::Half => (intervals + 1, PI),
        Extent::Whole => (intervals, TAU),
    };
    (0..count)
        .map(|k| end * (k as f64 / intervals as f64))
        .collect()
}

/// The angles `[rad]` with every interval halved; for whole also the one from the last angle to 2π.
pub fn bisected_angles(extent: Extent, angles: &[f64]) -> Vec<f64> {
    let end = if extent == Extent::Whole {
        Some(TAU)
    } else {
        None
    };
    let next = angles.iter().skip(1).copied().map(Some).chain([end]);
    let halves = angles.iter().zip(next);
    halves
        .flat_map(|(&a, b)| [Some(a), b.map(|b| f64::midpoint(a, b))])
        .flatten()
        .collect()
}

/// Computes (cos, sin) `[1]` of `angle` `[rad]`, exact at multiples of a right angle, so that symmetry lines are straight to the last bit.
pub fn unit_vector(angle: f64) -> Point {
    let quarters = angle / FRAC_PI_2;
    let nearest = quarters.round();
    if (quarters - nearest).abs() > 1e-14 * nearest.abs().max(1.0) {
        return [angle.cos(), angle.sin()];
    }
    match nearest.rem_euclid(4.0) as u8 {
        0 => [1.0, 0.0],
        1 => [0.0, 1.0],
        2 => [-1.0, 0.0],
        _ => [0.0, -1.0],
    }
}

/// Checked angles of a contact circle; for a whole circle closed by 2π.
#[derive(Debug)]
pub(super) struct Rim {
    pub(super) angles: Vec<f64>,
    pub(super) closed: bool,
}

impl Rim {
    pub(super) fn new(extent: Extent, given: &[f64]) -> Result<Self, GenerateError> {
        at_least("angles", given.len(), 3)?;
        increasing("angles", given)?;
        let closed = extent == Extent::Whole;
        let (first, last) = (given[0], given[given.len() - 1]);
        if first.abs() > ANGLE_ROUNDING {
            return Err(GenerateError::WrongEnd {
                what: "first angle",
                expected: "0",
                value: first,
            });
        }
        if !closed && (last - PI).abs() > ANGLE_ROUNDING {
            return Err(GenerateError::WrongEnd {
                what: "last angle of a half",
                expected: "π",
                value: last,
            });
        }
        if closed && last > TAU - ANGLE_ROUNDING {
            let what = "last angle of a whole circle";
            return Err(GenerateError::WrongEnd {
                what,
                expected: "below 2π",
                value: last,
            });
        }
        let mut angles = given.to_vec();
        angles[0] = 0.0;
        if closed {
            angles.push(TAU);
        } else {
            angles[given.len() - 1] = PI;
        }
        increasing("angles", &angles)?;
        Ok(Self { angles, closed })
    }

    /// Number of cells along the circle.
    pub(super) fn intervals(&self) -> usize {
        self.angles.len() - 1
    }

    /// The upper half of a closed rim whose angles are mirrored about the x axis.
    pub(super) fn mirrored_half(&self) -> Option<Self> {
        let n = self.intervals();
        let mirrored =
            |k: usize| (self.angles[k] + self.angles[n - k] - TAU).abs() <= ANGLE_ROUNDING;
        (self.closed && n.is_multiple_of(2) && (0..=n / 2).all(mirrored)).then(|| Self {
            angles: self.angles[..=n / 2].to_vec(),
            closed: false,
        })
    }

    /// Point on a circle about the origin at `step`.
    pub(super) fn on_circle(&self, radius: f64, step: f64) -> Point {
        unit_vector(at_step(&self.angles, step)).map(|c| radius * c)
    }

    /// Width of the neighbouring intervals `[rad]` at every angle, smoothed to [`THICKNESS_SLOPE`].
    fn local_spacing(&self) -> Vec<f64> {
        let n = self.intervals();
        let width: Vec<f64> = self
            .angles
            .windows(2)
            .map(|pair| pair[1] - pair[0])
            .collect();
        let mut spacing = vec![0.0; n + 1];
        for k in 0..=n {
            let wrap = if self.closed { [n - 1, 0] } else { [0, n - 1] };
            let before = width[if k == 0 { wrap[0] } else { k - 1 }];
            let after = width[if k == n { wrap[1] } else { k }];
            spacing[k] = f64::midpoint(before, after);
        }
        for _ in 0..=usize::from(self.closed) {
            for k in 0..n {
                spacing[k + 1] = spacing[k + 1].min(spacing[k] + THICKNESS_SLOPE * width[k]);
            }
            if self.closed {
                spacing[0] = spacing[0].min(spacing[n]);
                spacing[n] = spacing[0];
            }
            for k in (0..n).rev() {
                spacing[k] = spacing[k].min(spacing[k + 1] + THICKNESS_SLOPE * width[k]);
            }
            if self.closed {
                spacing[n] = spacing[n].min(spacing[0]);
            }
        }
        spacing
    }
}

impl Growth {
    /// Refuses what does not describe `layers` layers.
    pub(super) fn check(&self, layers: usize) -> Result<(), GenerateError> {
        at_least("layers", layers, 1)?;
        match self {
            Self::Geometric { aspect } => positive("aspect of the first layer", *aspect),
            Self::Fractions(list) => {
                if list.len() != layers {
                    return Err(GenerateError::FractionCount {
                        fractions: list.len(),
                        layers,
                    });
                }
                positive("first layer fraction", list[0])?;
                increasing("layer fractions", list)?;
                let last = list[layers - 1];
                if last == 1.0 {
                    return Ok(());
                }
                Err(GenerateError::WrongEnd {
                    what: "last layer fraction",
                    expected: "1",
                    value: last,
                })
            }
        }
    }
}

/// A far side: its point at every step along the circle.
type FarSide<'a> = Box<dyn Fn(f64) -> Point + 'a>;

/// The lattice between the circle and the far side.
pub(super) struct Fan<'a> {
    rim: &'a Rim,
    radius: f64,
    far_side: FarSide<'a>,
    /// Circle and far side at whole steps.
    near: Vec<Point>,
    far: Vec<Point>,
    /// s at the layers' boundaries along every whole ray.
    fractions: Vec<Vec<f64>>,
}

impl<'a> Fan<'a> {
    /// `far_side` gives the point for every step along the circle of `radius`; `growth` has been checked for `layers`.
    pub(super) fn new(
        rim: &'a Rim,
        radius: f64,
        far_side: impl Fn(f64) -> Point + 'a,
        layers: usize,
        growth: &Growth,
    ) -> Self {
        let rays = 0..=rim.intervals();
        let near: Vec<Point> = (rays.clone())
            .map(|ray| rim.on_circle(radius, ray as f64))
            .collect();
        let far: Vec<Point> = rays.clone().map(|ray| far_side(ray as f64)).collect();
        let spacing = rim.local_spacing();
        let along_ray = |k: usize| match growth {
            Growth::Fractions(list) => [0.0].iter().chain(list).copied().collect(),
            Growth::Geometric { aspect } => {
                let (c, f) = (near[k], far[k]);
                let length = (f[0] - c[0]).hypot(f[1] - c[1]);
                layer_fractions(layers, aspect * radius * spacing[k] / length)
            }
        };
        let fractions = rays.map(along_ray).collect();
        Self {
            rim,
            radius,
            far_side: Box::new(far_side),
            near,
            far,
            fractions,
        }
    }

    /// Point at lattice position (i, j). Between two rays it is on the chord, moved by the share of the bulges of both sides.
    pub(super) fn at(&self, i: f64, j: f64) -> Point {
        let (before, part) = (i as usize, i.fract());
        if part == 0.0 {
            return self.on_ray(before, j);
        }
        let between = |a, b| between(a, b, part);
        let (a, b) = (self.on_ray(before, j), self.on_ray(before + 1, j));
        let s = between(
            at_step(&self.fractions[before], j),
            at_step(&self.fractions[before + 1], j),
        );
        let on_circle = self.rim.on_circle(self.radius, i);
        // How far a point lies beside its neighbours' chord.
        let bulge = |point: Point, ends: &[Point], axis: usize| {
            point[axis] - between(ends[before][axis], ends[before + 1][axis])
        };
        let far = (self.far_side)(i);
        [0, 1].map(|axis| {
            between(a[axis], b[axis])
                + (1.0 - s) * bulge(on_circle, &self.near, axis)
                + s * bulge(far, &self.far, axis)
        })
    }

    fn on_ray(&self, ray: usize, j: f64) -> Point {
        let s = at_step(&self.fractions[ray], j);
        let (c, f) = (self.near[ray], self.far[ray]);
        [0, 1].map(|axis| (1.0 - s) * c[axis] + s * f[axis])
    }

    /// Far side at lattice position `i`.
    pub(super) fn far_at(&self, i: f64) -> Point {
        (self.far_side)(i)
    }

    /// Thickness of the layer at the far side along ray `i` `[length]`.
    pub(super) fn last_thickness(&self, i: usize) -> f64 {
        let list = &self.fractions[i];
        let (c, f) = (self.near[i], self.far[i]);
        (f[0] - c[0]).hypot(f[1] - c[1]) * (1.0 - list[list.len() - 2])
    }
}
