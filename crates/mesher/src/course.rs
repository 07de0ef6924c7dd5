//! How a piece of an outline runs from one end to the other.

use std::f64::consts::PI;

use stickslip_fem_core::mesh::Point;

/// The way of a piece between its ends.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum Course {
    /// Straight.
    #[default]
    Line,
    /// On the circle through a third point `[length]`, which it passes.
    Arc(Point),
    /// On a smooth curve through given points.
    Spline(Spline),
}

/// A cubic spline by the lengths of its chords, with continuous curvature.
///
/// Without a direction at an end the first two cubics there are one, so that the distance from a smooth curve falls with the fourth power of the chords up to the ends (de Boor 2001, ch. IV;
/// Floater 2006); one point between ends without directions is passed by a parabola.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Spline {
    /// Points between its ends in walk order `[length]`, one at least.
    pub points: Vec<Point>,
    /// Direction of the walk at its beginning, counter-clockwise from x `[rad]`.
    pub leaves: Option<f64>,
    /// Direction of the walk at its end, counter-clockwise from x `[rad]`.
    pub arrives: Option<f64>,
}

impl Course {
    /// The same way with its points where `place` puts them `[length]`, and its directions turned by `turn` `[rad]`.
    #[must_use]
    pub fn mapped(&self, place: impl Fn(Point) -> Point, turn: impl Fn(f64) -> f64) -> Self {
        match self {
            Self::Line => Self::Line,
            Self::Arc(through) => Self::Arc(place(*through)),
            Self::Spline(own) => Self::Spline(Spline {
                points: own.points.iter().map(|&at| place(at)).collect(),
                leaves: own.leaves.map(&turn),
                arrives: own.arrives.map(&turn),
            }),
        }
    }

    /// The same way walked from its end to its beginning.
    #[must_use]
    pub fn reversed(&self) -> Self {
        match self {
            Self::Line | Self::Arc(_) => self.clone(),
            Self::Spline(own) => Self::Spline(Spline {
                points: own.points.iter().rev().copied().collect(),
                leaves: own.arrives.map(|angle| angle + PI),
                arrives: own.leaves.map(|angle| angle + PI),
            }),
        }
    }

    /// Its points between the ends, with what messages call them.
    pub(crate) fn points(&self) -> (&'static str, &[Point]) {
        match self {
            Self::Line => ("", &[]),
            Self::Arc(through) => ("point on arc", std::slice::from_ref(through)),
            Self::Spline(own) => ("point on spline", &own.points),
        }
    }
}
