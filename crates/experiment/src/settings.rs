//! What `[reduce]`, `[region]`, `[identify]` and `[[laws]]` say.

use std::path::PathBuf;

use serde_json::Value;
use stickslip_fem_core::mesh::{ElementKind, Point};
use stickslip_friction::FrictionLaw;
use stickslip_hybrid::region::fit::Smoothing;
use stickslip_hybrid::region::sector::ArcSector;

use super::{Area, Hole};

/// How displacements of nodes are made from measured ones.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Method {
    /// Linear on triangles.
    Linear,
    /// A local polynomial of `order` over `neighbours` places.
    Polynomial {
        /// Its order.
        order: usize,
        /// Places it is fitted to.
        neighbours: usize,
    },
    /// Linear between fringe centres of the nearest line within `reach` `[mm]`.
    Lines {
        /// Farthest node from a line `[mm]`.
        reach: f64,
    },
    /// Fit of the region's boundary to all data, with equilibrium.
    Fit,
}

/// How measured fields are made.
#[derive(Clone, Debug, PartialEq)]
pub struct Reduce {
    /// From data to nodes.
    pub method: Method,
    /// Every how many pixels a displacement is taken from a picture; as many as the phase is correlated over where not stated.
    pub stride: Option<usize>,
    /// Radius of the band around the carrier, part of the way to the background `[1]`.
    pub band: f64,
    /// Least amplitude of a fringe, a part of the median amplitude `[1]`.
    pub least_modulation: f64,
    /// Filling of missing pixels ends when a pass changes them by less than this part `[1]` of the fringes' amplitude.
    pub settled: f64,
    /// Data nearer than this to the hole's edge are masked `[mm]`. Where not stated: of pictures with a carrier what their phase
    /// resolves, which mixes both sides of an edge; of other data nothing.
    pub margin: Option<f64>,
    /// Longest side of a triangle that is no gap, for what is interpolated on triangles `[mm]`.
    pub longest_side: Option<f64>,
    /// Parts of the plane that are masked.
    pub mask: Vec<Area>,
    /// How far places of the null field may be off and still be the same `[mm]`; interpolated where not stated.
    pub common_places: Option<f64>,
    /// Displacements of tables that are off their neighbours by more than so many times `[1]` what is usual are masked; none where they are
    /// not looked for.
    pub outliers: Option<f64>,
    /// Line along which front and back are compared.
    pub symmetry: Option<SymmetryPlan>,
    /// What pictures add to displacements by amounts that are free in each state.
    pub free: Vec<FreeMotion>,
}

/// What a picture may add to the displacements of a state.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FreeMotion {
    /// A uniform dilation, as of a specimen that comes nearer to the camera.
    Dilation,
    /// A dilation that grows along x, as of a specimen that tilts towards the camera.
    TiltX,
    /// A dilation that grows along y.
    TiltY,
}

impl FreeMotion {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Dilation, Self::TiltX, Self::TiltY];

    /// Displacement `[mm]` at a place by a unit of it.
    pub fn displacement(self, place: Point, hole: &Hole) -> [f64; 2] {
        let from = [0, 1].map(|axis| place[axis] - hole.centre[axis]);
        let factor = match self {
            Self::Dilation => 1.0,
            Self::TiltX => from[0] / hole.radius,
            Self::TiltY => from[1] / hole.radius,
        };
        from.map(|x| factor * x)
    }

    /// Its name in results.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Dilation => "dilation",
            Self::TiltX => "tilt along x",
            Self::TiltY => "tilt along y",
        }
    }
}

/// A line along which front and back are compared.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SymmetryPlan {
    /// Its ends `[mm]`.
    pub ends: [Point; 2],
    /// Largest difference `[fringes]`.
    pub tolerance: f64,
    /// Places compared.
    pub places: usize,
}

/// The region of the hybrid analysis.
#[derive(Clone, Debug, PartialEq)]
pub struct RegionPlan {
    /// What it covers.
    pub shape: RegionShape,
    /// Nodes inside of the region that lie in one of these areas move as measured too.
    pub interior: Vec<Area>,
    /// Whether the whole plate is analysed too, with the measured displacements on the hole and the remote load.
    pub whole_plate: bool,
    /// Smoothing along its boundary, for fitted displacements.
    pub smoothing: Smoothing,
}

/// What a region covers.
#[derive(Clone, Debug, PartialEq)]
pub enum RegionShape {
    /// A sector of arcs around the hole.
    Sector(SectorPlan),
    /// A mesh from a file.
    Mesh(MeshPlan),
}

/// A mesh of Gmsh, in its format 4.1.
#[derive(Clone, Debug, PartialEq)]
pub struct MeshPlan {
    /// The file.
    pub file: PathBuf,
    /// Length of one unit of its coordinates `[mm]`.
    pub scale: f64,
}

/// A sector of arcs around the hole.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SectorPlan {
    /// First and last angle `[rad]`.
    pub angles: [f64; 2],
    /// Outer radius `[mm]`.
    pub outer: f64,
    /// Cells around and outwards.
    pub cells: [usize; 2],
    /// Distance of its inner arc from the hole `[mm]`.
    pub stand_off: f64,
    /// Thickness of the outermost layer over that of the innermost `[1]`.
    pub growth: f64,
    /// Kind of the cells.
    pub element: ElementKind,
}

impl SectorPlan {
    /// The sector around `hole`.
    pub fn around(&self, hole: &Hole) -> ArcSector {
        ArcSector {
            centre: hole.centre,
            hole: hole.radius,
            stand_off: self.stand_off,
            outer: self.outer,
            angles: self.angles,
            cells: self.cells,
            growth: self.growth,
            kind: self.element,
        }
    }
}

/// How friction is identified.
#[derive(Clone, Debug, PartialEq)]
pub struct Identify {
    /// Confidence of the intervals `[1]`.
    pub confidence: f64,
    /// Samples of the Monte Carlo simulation.
    pub samples: usize,
    /// Its seed.
    pub seed: u64,
    /// Where the contact bears `[rad]`; without it θ = 0, or what a contact that is wholly in sight shows.
    pub bearing: Option<f64>,
    /// Slip zones given by hand; recognised where there are none for a state.
    pub zones: Vec<ZonePlan>,
}

/// A slip zone given by hand.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ZonePlan {
    /// Index of the state.
    pub state: usize,
    /// First and last angle `[rad]`.
    pub angles: [f64; 2],
}

/// A friction law to fit.
#[derive(Clone, Debug)]
pub struct LawPlan {
    /// Its name in results.
    pub name: String,
    /// Key of the law's table in the file.
    pub key: String,
    /// The law's table as the file spells it, with starting values.
    pub friction: Value,
    /// The law at its starting values.
    pub law: Box<dyn FrictionLaw>,
    /// Parameters to fit.
    pub free: Vec<FreeParameter>,
}

/// A parameter to fit.
#[derive(Clone, Debug, PartialEq)]
pub struct FreeParameter {
    /// Its name in the law's table; a dot leads into a table in it.
    pub name: String,
    /// Least and greatest value in base units.
    pub bounds: [f64; 2],
}
