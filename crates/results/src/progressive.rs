//! A joint followed beyond the failure of its plies.

use std::f64::consts::TAU;

use stickslip_joint::ModeCall;
use stickslip_laminate::FailureMode;

use super::{ContactFrame, JointFinding};

/// Progressive failure of a body.
#[derive(Clone, Debug)]
pub struct ProgressiveFailure {
    /// How plies lose stiffness, as text.
    pub model: String,
    /// What was raised, as text.
    pub control: String,
    /// The load–displacement curve, from the first increment on; never empty.
    pub curve: Vec<CurvePoint>,
    /// Index of its largest load.
    pub peak: usize,
    /// The largest load `[N]`, if the history shows that the joint cannot bear more.
    pub strength: Option<f64>,
    /// Why the history ended.
    pub end: ProgressiveEnd,
    /// All that failed or began to flow, in order.
    pub losses: Vec<PlyLoss>,
    /// The mode of failure and its reasons; `None` where no ply failed.
    pub mode: Option<ModeCall>,
    /// The same joint without failure, up to the largest load; `None` if it did not get so far.
    pub linear: Option<LinearJoint>,
    /// Strains at the hole's edge under the largest load, by angle; empty without `linear`.
    pub edge: Vec<EdgeStrain>,
    /// Number of cells of its mesh.
    pub cells: usize,
    /// Whether half of a symmetric joint was followed.
    pub half: bool,
    /// What the pin moves before it can bear there, which displacements leave out `[mm]`: it starts where it touches in the direction of the loads.
    pub free_travel: f64,
    /// Where the pin bears: the load is read along this direction, and angles are counted from it.
    pub frame: ContactFrame,
    /// What the scene asks for and the followed joint has less of.
    pub findings: Vec<JointFinding>,
}

/// A joint whose plies never fail.
#[derive(Clone, Debug, PartialEq)]
pub struct LinearJoint {
    /// Displacement `[mm]` and load `[N]`, from rest, where the displacement is minus [`ProgressiveFailure::free_travel`].
    pub curve: Vec<[f64; 2]>,
}

/// Strains next to the hole's edge.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EdgeStrain {
    /// Angle about the hole's centre from +x `[rad]`.
    pub angle: f64,
    /// Radial and circumferential strain of the joint that was followed `[-]`.
    pub followed: [f64; 2],
    /// Those of the joint without failure under the same load `[-]`.
    pub linear: [f64; 2],
}

/// The joint at the end of an increment.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CurvePoint {
    /// Load step, from 0.
    pub step: usize,
    /// Part of it that was reached `[1]`.
    pub reached: f64,
    /// Displacement of the pin against the far end of the plate, along the direction in which the pin bears, without
    /// [`ProgressiveFailure::free_travel`] `[mm]`: negative before the pin can bear.
    pub displacement: f64,
    /// Force of the pin on the plate along that direction `[N]`.
    pub load: f64,
    /// Work of the loads since the start `[N mm]`.
    pub work: f64,
    /// Energy dissipated by the plies and set free by their failure, since the start `[N mm]`.
    pub dissipated: f64,
}

/// A ply that fails or begins to flow at a quadrature point.
#[derive(Clone, Debug, PartialEq)]
pub struct PlyLoss {
    /// Index of the increment in [`ProgressiveFailure::curve`].
    pub increment: usize,
    /// Index in [`BodyFailure::plies`](super::BodyFailure::plies).
    pub ply: usize,
    /// Layer, from the bottom, from 0.
    pub layer: usize,
    /// How it failed; `None` where it began to flow.
    pub mode: Option<FailureMode>,
    /// Place `[mm]`.
    pub position: [f64; 2],
    /// Cell of the mesh.
    pub cell: usize,
    /// Load `[N]` at which it failed, before stress was redistributed.
    pub load: f64,
    /// Displacement `[mm]` then.
    pub displacement: f64,
}

/// Why a history ended.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ProgressiveEnd {
    /// Everything asked for was followed.
    Completed,
    /// The load fell as far as the scene asks.
    Dropped,
    /// The joint came apart: what it still bears is borne by what failed plies are left with.
    Severed,
    /// No equilibrium near was found beyond; the reason.
    NoEquilibrium(String),
}

impl ProgressiveFailure {
    /// The first ply that failed, or began to flow where none failed.
    pub fn first(&self) -> Option<&PlyLoss> {
        let failed = self.losses.iter().find(|loss| loss.mode.is_some());
        failed.or(self.losses.first())
    }

    /// The first failure of fibres.
    pub fn first_fibre(&self) -> Option<&PlyLoss> {
        let fibre = |loss: &&PlyLoss| loss.mode.is_some_and(FailureMode::is_fibre);
        self.losses.iter().find(fibre)
    }

    /// Where strains at the edge differ from the linear ones by more than `part` `[1]` of the largest linear strain: ranges of the angle from
    /// the bearing point `[rad]`, from the first to the last point that does; equal ends where it is one. Of a half those of its side,
    /// positive; of a whole in (−π, π], one across ±π ending beyond π.
    pub fn departures(&self, part: f64) -> Vec<[f64; 2]> {
        let strains = || self.edge.iter();
        let largest = strains().flat_map(|edge| edge.linear).map(f64::abs);
        let limit = part * largest.fold(0.0, f64::max);
        let departs =
            |edge: &EdgeStrain| (0..2).any(|i| (edge.followed[i] - edge.linear[i]).abs() > limit);
        let mut by_angle: Vec<(f64, bool)> = strains()
            .map(|edge| {
                let angle = self.frame.angle(edge.angle);
                (if self.half { angle.abs() } else { angle }, departs(edge))
            })
            .collect();
        by_angle.sort_by(|a, b| a.0.total_cmp(&b.0));
        let ends = |run: &[(f64, bool)]| [run[0].0, run[run.len() - 1].0];
        let runs = by_angle.chunk_by(|a, b| a.1 == b.1);
        let mut ranges: Vec<[f64; 2]> = runs.filter(|run| run[0].1).map(ends).collect();
        let both = |a: &(f64, bool), b: &(f64, bool)| a.1 && b.1;
        let closes = (by_angle.first().zip(by_angle.last())).is_some_and(|(a, b)| both(a, b));
        if closes && !self.half && ranges.len() > 1 {
            let [_, end] = ranges.remove(0);
            if let Some(last) = ranges.last_mut() {
                last[1] = end + TAU;
            }
        }
        ranges
    }

    /// The largest load `[N]` on the curve.
    pub fn peak_load(&self) -> f64 {
        self.curve.get(self.peak).map_or(0.0, |point| point.load)
    }
}
