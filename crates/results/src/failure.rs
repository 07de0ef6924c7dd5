//! Ply stresses and failure of the laminated bodies of a run.

use std::fmt;

use stickslip_laminate::FailureMode;

use super::{ContactFrame, LoadValue, ProgressiveFailure};
use stickslip_scene::schema::EnvelopePlane;

/// Failure of one laminated body.
#[derive(Clone, Debug)]
pub struct BodyFailure {
    /// Index of the body in [`Results::bodies`](super::Results::bodies).
    pub body: usize,
    /// Its lay-up, as written.
    pub layup: String,
    /// Temperature since its plies were free of stress `[K]`.
    pub cure: f64,
    /// Its plies; those of one material and angle, which carry the same stresses, together.
    pub plies: Vec<PlyGroup>,
    /// Names of the criteria. Maps and curves show the first.
    pub criteria: Vec<&'static str>,
    /// Centre of its hole, about which angles and radii of places are measured `[mm]`.
    pub centre: Option<[f64; 2]>,
    /// From where these angles are measured: the bearing point of what loads the hole, or +x.
    pub frame: ContactFrame,
    /// For every load step the weakest point by each criterion.
    pub steps: Vec<Vec<FailurePoint>>,
    /// First-ply failure by each criterion; `None` where no load of any step fails a ply.
    pub first_ply: Vec<Option<FirstPly>>,
    /// What its supports' ends, beside which no ply is checked for [`steps`](Self::steps) and [`first_ply`](Self::first_ply), hide; `None`
    /// where it has no such ends.
    pub beside_supports: Option<BesideSupports>,
    /// Ply stresses along its reported edges.
    pub edges: Vec<EdgePlies>,
    /// Indices over the whole body for the steps with fields.
    pub maps: Vec<PlyMap>,
    /// What the hypotheses of a characteristic distance say.
    pub characteristic: Option<CharacteristicFailure>,
    /// Failure envelopes of the laminate.
    pub envelopes: Vec<Envelope>,
    /// Its failure followed until the load path is lost.
    pub progressive: Option<ProgressiveFailure>,
}

/// Plies of one material and angle.
#[derive(Clone, Debug, PartialEq)]
pub struct PlyGroup {
    /// Name of the ply.
    pub ply: String,
    /// Direction of its fibres from +x `[degree]`, in (−90, 90].
    pub angle: f64,
    /// Its layers, from the bottom, from 0.
    pub layers: Vec<usize>,
    /// Residual stress of the cure (σ₁, σ₂, τ₁₂) in material axes `[MPa]`.
    pub residual: [f64; 3],
}

/// A ply at a place under a load.
#[derive(Clone, Debug, PartialEq)]
pub struct FailurePoint {
    /// Name of the criterion.
    pub criterion: &'static str,
    /// Index in [`BodyFailure::plies`].
    pub ply: usize,
    /// Place `[mm]`.
    pub position: [f64; 2],
    /// Stress (σ₁, σ₂, τ₁₂) in material axes, that of the cure included `[MPa]`.
    pub stress: [f64; 3],
    /// Failure index `[1]`: 1 or more where the ply has failed.
    pub index: f64,
    /// Multiple of the step's loads at which the ply fails, the cure held `[1]`; infinite if none does it.
    pub reserve_factor: f64,
    /// How it fails.
    pub mode: FailureMode,
    /// Estimated errors; `None` where none were estimated.
    pub errors: Option<PointErrors>,
}

/// Estimated errors of a [`FailurePoint`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointErrors {
    /// Of the failure index `[1]`; `None` without a finite one.
    pub index: Option<f64>,
    /// Of the reserve factor `[1]`; `None` without a finite one.
    pub reserve_factor: Option<f64>,
    /// How far away the place may be `[mm]`.
    pub place: f64,
}

/// The load at which the first ply fails.
#[derive(Clone, Debug, PartialEq)]
pub struct FirstPly {
    /// The load step on whose way it fails, or the weakest step, from 0.
    pub step: usize,
    /// Whether the history reaches the failure; otherwise the step's loads are multiplied until they do.
    pub reached: bool,
    /// Reached: the part of the way from the step before, in [0, 1]. Otherwise the multiple of the step's loads, at least 1. Either `[1]`.
    pub factor: f64,
    /// The load there, in terms of what distinguishes the steps; `None` where only their number does.
    pub load: Option<LoadValue>,
    /// Estimated error of that load, in its unit; `None` where none was estimated.
    pub load_error: Option<f64>,
    /// The ply and its place, with the stress at that load.
    pub at: FailurePoint,
}

impl FirstPly {
    /// Whether the history comes to this failure first; of failures beyond the history, whether the smaller multiple of loads does.
    pub fn is_before(&self, other: &Self) -> bool {
        match (self.reached, other.reached) {
            (true, true) => (self.step, self.factor) < (other.step, other.factor),
            (false, false) => self.factor < other.factor,
            (reached, _) => reached,
        }
    }
}

/// Plies beside the ends of supported edges and beside points that are held, where stresses grow without bound as the mesh is
/// refined.
#[derive(Clone, Debug, PartialEq)]
pub struct BesideSupports {
    /// Within this distance of them no ply is checked `[mm]`.
    pub distance: f64,
    /// First-ply failure there by each criterion, where it comes before that elsewhere.
    pub sooner: Vec<Option<FirstPly>>,
}

impl BesideSupports {
    /// Leaves the failures that come before those `elsewhere`, by criterion.
    pub fn keep_sooner_than(&mut self, elsewhere: &[Option<FirstPly>]) {
        for (there, elsewhere) in self.sooner.iter_mut().zip(elsewhere) {
            if let (Some(own), Some(other)) = (&*there, elsewhere)
                && !own.is_before(other)
            {
                *there = None;
            }
        }
    }
}

/// Ply stresses along an edge.
#[derive(Clone, Debug)]
pub struct EdgePlies {
    /// Index of the edge in [`Results::edges`](super::Results::edges).
    pub edge: usize,
    /// Place of each point, as [`EdgeGeometry::parameter`](super::EdgeGeometry::parameter), `[rad or mm]`, also where that has one half only:
    /// ascending over the whole edge.
    pub parameter: Vec<f64>,
    /// By load step, ply group and point.
    pub steps: Vec<Vec<Vec<EdgePly>>>,
}

/// A ply at a point of an edge.
#[derive(Clone, Debug, PartialEq)]
pub struct EdgePly {
    /// Stress (σ₁, σ₂, τ₁₂) in material axes, that of the cure included `[MPa]`.
    pub stress: [f64; 3],
    /// Failure index by each criterion `[1]`.
    pub index: Vec<f64>,
}

/// Failure index of the first criterion over a body.
#[derive(Clone, Debug)]
pub struct PlyMap {
    /// Load step, from 0.
    pub step: usize,
    /// By ply group: one failure index `[1]` per node of the mesh and, of a half model, one more per node for its mirror image.
    pub index: Vec<Vec<f64>>,
}

/// Failure by the hypotheses of a characteristic distance.
#[derive(Clone, Debug)]
pub struct CharacteristicFailure {
    /// R_t, at the net section `[mm]`.
    pub tension: f64,
    /// R_c, at the bearing point `[mm]`.
    pub compression: f64,
    /// On the curve, by criterion; `None` where no load fails a ply there.
    pub curve: Vec<Option<JointFailure>>,
    /// At the net section alone, by criterion.
    pub net_section: Vec<Option<FirstPly>>,
    /// At the bearing point alone, by criterion.
    pub bearing_point: Vec<Option<FirstPly>>,
    /// Angle from the bearing point `[rad]` of each place of the curve, ascending from −90° to 90°.
    pub angles: Vec<f64>,
    /// Places of the curve `[mm]`.
    pub places: Vec<[f64; 2]>,
    /// For every load step, the largest index of the first criterion over the plies at each place `[1]`.
    pub index: Vec<Vec<f64>>,
}

/// Failure of a joint on its characteristic curve.
#[derive(Clone, Debug, PartialEq)]
pub struct JointFailure {
    /// Load, ply and place.
    pub first: FirstPly,
    /// Angle of the place from the bearing point `[rad]`.
    pub angle: f64,
    /// The mode that the angle stands for.
    pub mode: JointMode,
}

/// How a pinned joint fails.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum JointMode {
    /// The material before the pin is crushed.
    Bearing,
    /// Between bearing and shear-out.
    BearingAndShearOut,
    /// The pin pushes a strip out of the end.
    ShearOut,
    /// Between shear-out and net tension.
    ShearOutAndNetTension,
    /// The section beside the hole tears.
    NetTension,
}

impl JointMode {
    /// In words.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Bearing => "bearing",
            Self::BearingAndShearOut => "bearing and shear-out",
            Self::ShearOut => "shear-out",
            Self::ShearOutAndNetTension => "shear-out and net tension",
            Self::NetTension => "net tension",
        }
    }
}

impl fmt::Display for JointMode {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(self.name())
    }
}

/// A failure envelope of a laminate under mean stresses.
#[derive(Clone, Debug)]
pub struct Envelope {
    /// Its plane.
    pub plane: EnvelopePlane,
    /// Name of the criterion.
    pub criterion: &'static str,
    /// Whether the last ply's failure bounds it, by ply discount; otherwise the first's.
    pub last_ply: bool,
    /// Its points in order of their directions.
    pub points: Vec<EnvelopePoint>,
}

/// A point of an envelope.
#[derive(Clone, Debug, PartialEq)]
pub struct EnvelopePoint {
    /// Mean stress (xx, yy, xy) `[MPa]`.
    pub stress: [f64; 3],
    /// Index in [`BodyFailure::plies`] of the ply that fails.
    pub ply: usize,
    /// How it fails.
    pub mode: FailureMode,
}

impl PlyGroup {
    /// "60°".
    pub fn direction(&self) -> String {
        let rounded = (self.angle * 1e3).round() / 1e3 + 0.0;
        if rounded < 0.0 {
            format!("−{}°", -rounded)
        } else {
            format!("{rounded}°")
        }
    }
}

impl BodyFailure {
    /// Name of a ply group for a reader: its direction, with the ply's name where there are several.
    pub fn ply_name(&self, group: usize) -> String {
        let Some(own) = self.plies.get(group) else {
            return String::new();
        };
        let several = self.plies.iter().any(|other| other.ply != own.ply);
        if several {
            format!("{} {}", own.direction(), own.ply)
        } else {
            own.direction()
        }
    }

    /// Angle from the bearing point `[rad]` and radius `[mm]` of a place about the hole's centre.
    pub fn polar(&self, position: [f64; 2]) -> Option<(f64, f64)> {
        let (theta, radius) = self.polar_from_x(position)?;
        Some((self.frame.turned(theta), radius))
    }

    /// Angle from +x `[rad]` and radius `[mm]` of a place about the hole's centre.
    pub fn polar_from_x(&self, position: [f64; 2]) -> Option<(f64, f64)> {
        let centre = self.centre?;
        let [x, y] = [position[0] - centre[0], position[1] - centre[1]];
        Some((y.atan2(x), x.hypot(y)))
    }
}
