//! Figures before and after they are drawn.

use stickslip_report::svg::Svg;

use crate::results::attempt::Attempt;

/// A finished figure.
#[derive(Debug)]
pub(in crate::results) struct Drawing {
    /// File name without ending, and anchor on the page.
    pub(in crate::results) name: String,
    pub(in crate::results) picture: Svg,
    pub(in crate::results) png: Vec<u8>,
    pub(in crate::results) caption: String,
    pub(in crate::results) group: Group,
}

/// Which part of the page a figure belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::results) enum Group {
    /// The scene itself.
    Problem,
    /// A joint followed to its end.
    Joint,
    Edge,
    History,
    Failure,
    Field,
}

/// A figure that can be drawn beside others.
pub(super) struct Plan<'a> {
    pub(super) group: Group,
    /// File name before it is made safe and different from others.
    pub(super) stem: String,
    pub(super) draw: Box<dyn Fn() -> Attempt + Sync + 'a>,
}

impl<'a> Plan<'a> {
    pub(super) fn new(group: Group, stem: String, draw: impl Fn() -> Attempt + Sync + 'a) -> Self {
        Self {
            group,
            stem,
            draw: Box::new(draw),
        }
    }
}
