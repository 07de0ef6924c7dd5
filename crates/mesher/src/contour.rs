//! Outlines of straight lines, arcs and splines, with cut-outs of the same and circular holes.

mod check;
mod inside;

use stickslip_fem_core::mesh::Point;

use crate::course::Course;
use crate::curve::{NoTrack, Track};
use crate::vector::{NOWHERE, grown};

pub(crate) use check::{TOLERANCE, checked};

/// One piece of an outline, from the end of the one before to `to`.
#[derive(Clone, Debug, PartialEq)]
pub struct Piece {
    /// Name of its edge set, which neighbouring pieces may share.
    pub name: String,
    /// Its end `[length]`.
    pub to: Point,
    /// Its way there.
    pub course: Course,
}

/// A circular hole.
#[derive(Clone, Debug, PartialEq)]
pub struct Hole {
    /// Name of its edge set.
    pub name: String,
    /// Centre `[length]`.
    pub centre: Point,
    /// Radius `[length]`.
    pub radius: f64,
    /// Angles of the corner nodes `[rad]`, at least 8, ascending in [0, 2π), counter-clockwise from x, at most π/3 apart.
    pub angles: Vec<f64>,
    /// Layers of the ring of structured cells around the hole, fewer where neighbours are near; `None` is up to 3.
    pub layers: Option<usize>,
}

/// A closed loop of lines, arcs and splines inside the outline, with the body around it.
#[derive(Clone, Debug, PartialEq)]
pub struct Cutout {
    /// Its name in errors.
    pub name: String,
    /// Where the first piece begins `[length]`.
    pub start: Point,
    /// The pieces counter-clockwise; the last ends at `start`.
    pub pieces: Vec<Piece>,
}

/// A plane body: a closed outline, cut-outs and holes.
#[derive(Clone, Debug, PartialEq)]
pub struct Contour {
    /// Where the first piece begins `[length]`.
    pub start: Point,
    /// The pieces counter-clockwise; the last ends at `start`.
    pub pieces: Vec<Piece>,
    /// Cut-outs inside the outline.
    pub cutouts: Vec<Cutout>,
    /// Holes inside the outline.
    pub holes: Vec<Hole>,
}

impl Contour {
    /// Smallest and largest corner of the box around the outline `[length]`; arcs and splines that their points do not define count as lines.
    pub fn bounds(&self) -> [Point; 2] {
        let box_of = |all: [Point; 2], track: &Track| {
            let [low, high] = track.bounds();
            grown(grown(all, low), high)
        };
        let tracks = self.outline().tracks();
        let lines = tracks.map(|(_, line, track)| track.unwrap_or(line));
        lines.fold(grown(NOWHERE, self.start), |all, track| box_of(all, &track))
    }

    fn outline(&self) -> Loop<'_> {
        Loop {
            cutout: None,
            start: self.start,
            pieces: &self.pieces,
        }
    }

    /// The outline, then each cut-out.
    fn loops(&self) -> impl Iterator<Item = Loop<'_>> {
        let cutouts = self.cutouts.iter().map(|own| Loop {
            cutout: Some(&own.name),
            start: own.start,
            pieces: &own.pieces,
        });
        std::iter::once(self.outline()).chain(cutouts)
    }
}

/// A closed loop as it is listed.
#[derive(Clone, Copy)]
struct Loop<'a> {
    /// Name of a cut-out; `None` of the outline.
    cutout: Option<&'a str>,
    start: Point,
    pieces: &'a [Piece],
}

impl<'a> Loop<'a> {
    /// Name of a cut-out; `None` of the outline.
    fn name(&self) -> Option<String> {
        self.cutout.map(str::to_owned)
    }

    /// Each piece with the line between its ends and its track.
    fn tracks(self) -> impl Iterator<Item = (&'a Piece, Track, Result<Track, NoTrack>)> {
        let begins = std::iter::once(self.start).chain(self.pieces.iter().map(|piece| piece.to));
        self.pieces.iter().zip(begins).map(|(piece, from)| {
            let track = Track::new(from, &piece.course, piece.to);
            (piece, Track::line(from, piece.to), track)
        })
    }
}
