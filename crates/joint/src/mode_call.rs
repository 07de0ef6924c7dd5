//! How a pinned joint fails: in bearing, by shear-out, in net tension, or mixed; with the reasons.
//!
//! ```text
//!                 net tension  90°
//!          ·  ·  ┌─────┐            paths that the load takes and can lose
//!        ·     ╱ shear-out 45…80°   net tension  across the ligament, from the hole to the side
//!       ·  ◯  │ ─────────────►      shear-out    two lines ahead of the hole's sides, to the end
//!        ·     ╲ bearing 0…35°      bearing      ahead of the pin, into the hole's edge
//!          ·  ·  └─────
//! ```
//!
//! Angles count from the bearing point, on either side. Near the hole a site of damage belongs to a mode by its angle, with linear
//! transitions between the ranges; farther away by the path on which it lies. Of all damage, that which grows as the load path is lost
//! decides: what fails from 95 % of the peak load on, and of this the broken fibres, if there are any. An end that is split ahead of
//! the pin, which some authors call cleavage, counts as shear-out: the load path to the end is lost.
//!
//! Source of the ranges: Post & Reddy (1988), part II, 4.4, who found damage at 0–35° in bearing, at 60–80° in shear-out, and at the
//! net section in net tension.

mod evidence;
mod zones;

use std::fmt;

use stickslip_fem_core::mesh::Point;

use crate::damage::PlyEvent;
use crate::record::{Ending, JointHistory, JointRecord};
pub use evidence::Basis;
use evidence::{Evidence, reach};

/// A mode of failure of a pinned joint.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum JointMode {
    /// The pin crushes the hole's edge ahead of it.
    Bearing,
    /// The pin pushes a plug out of the plate's end.
    ShearOut,
    /// The plate tears across the net section.
    NetTension,
    /// No single one.
    Mixed,
}

impl JointMode {
    /// The pure modes, in the order of [`ModeCall::shares`].
    pub const PURE: [Self; 3] = [Self::Bearing, Self::ShearOut, Self::NetTension];

    /// All modes.
    const ALL: [Self; 4] = [Self::Bearing, Self::ShearOut, Self::NetTension, Self::Mixed];

    /// In words.
    pub fn name(self) -> &'static str {
        match self {
            Self::Bearing => "bearing",
            Self::ShearOut => "shear-out",
            Self::NetTension => "net tension",
            Self::Mixed => "mixed",
        }
    }
}

impl fmt::Display for JointMode {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// The hole and what is left of the plate around it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hole {
    /// Centre `[length]`.
    pub centre: Point,
    /// Radius `[length]`.
    pub radius: f64,
    /// Unit vector `[1]` from the centre to the bearing point, where the pin presses.
    pub bearing: [f64; 2],
    /// Distance from the centre to the nearer side of the plate `[length]`, at right angles to `bearing`.
    pub side_distance: f64,
    /// Distance from the centre to the end of the plate that the pin pushes at `[length]`.
    pub end_distance: f64,
}

/// Damage of one ply at one point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DamageSite {
    /// Where `[length]`.
    pub position: Point,
    /// Volume that it stands for `[length³]`.
    pub volume: f64,
    /// Whether fibres broke.
    pub fibre: bool,
    /// Whether it happened as the load path was lost: from 95 % of the peak load on.
    pub late: bool,
    /// Whether it happened in the collapse at the end: in the increment beyond the last equilibrium, which found none.
    pub collapse: bool,
}

/// The mode of a joint, and why.
#[derive(Clone, Debug, PartialEq)]
pub struct ModeCall {
    /// The mode.
    pub mode: JointMode,
    /// Which damage decides.
    pub basis: Basis,
    /// The rule that decided.
    pub rule: ModeRule,
    /// Shares `[1]` of the deciding damage in [`JointMode::PURE`], by volume; they sum to 1 or less, the rest lying elsewhere.
    pub shares: [f64; 3],
    /// How much of each mode's path, from the hole to the side or end, damage of the deciding kind covers, as a part of it in steps of a fifth `[1]`.
    pub reach: [f64; 3],
    /// The same of the damage at the last equilibrium, without that of the collapse `[1]`.
    pub followed_reach: [f64; 3],
    /// Part of the deciding damage that happened in the collapse `[1]`.
    pub collapse: f64,
    /// Other modes that the rules would call if a tenth of the deciding damage lay elsewhere and damage covered a fifth of
    /// one path more or less, or if the collapse did not count; of mixed damage also those with a fifth of it or more, and where most of
    /// it happened in the collapse those with a tenth.
    pub others: Vec<JointMode>,
    /// How `others` were found.
    pub reserve: Reserve,
    /// Part `[1]` of the peak load that the joint still bore at the end of its history, if that went beyond the peak.
    pub retained: Option<f64>,
}

/// Which rule decided a mode.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ModeRule {
    /// The path of shear-out or net tension is severed.
    Severed,
    /// The end is split ahead of the pin.
    Split,
    /// One mode has [`ModeCall::GOVERNS`] of the deciding damage.
    Share,
    /// The damage stays at the hole's edge, most of it ahead of the pin.
    Confined,
    /// No mode has that share.
    NoShare,
}

/// How near the damage is to that of other modes.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Reserve {
    /// Other modes that the rules would call if the damage differed slightly.
    pub near: Vec<JointMode>,
    /// Where the share alone counts: that part of the damage `[1]`, and the other modes that hold it or more.
    pub part: Option<(f64, Vec<JointMode>)>,
    /// Whether `near` includes what is called without all that failed in the collapse.
    pub without_collapse: bool,
    /// Whether `near` includes what is called without what the collapse covers of the paths.
    pub without_its_paths: bool,
}

impl ModeCall {
    /// Part of the peak load from which on damage is late `[1]`.
    pub const LATE: f64 = 0.95;
    /// Share that makes a mode the governing one `[1]`.
    pub const GOVERNS: f64 = 0.6;
    /// Part of its path at which a net section or a shear-out plug has come apart `[1]`.
    pub const SEVERED: f64 = 0.8;
    /// Parts of a path that are looked at one by one.
    pub const PARTS: usize = 5;
    /// Part `[1]` of the deciding damage that may lie elsewhere on another mesh or under another control.
    pub const MAY_SHIFT: f64 = 0.1;
}

/// Share from which on a mode takes part.
const TAKES_PART: f64 = 0.2;
/// Part of the paths to side and end within which damage is confined to the hole's edge.
const CONFINED: f64 = 0.25;
/// Share ahead of the pin that makes confined damage bearing.
const CRUSHED: f64 = 0.45;
/// Part of the deciding damage in the collapse from which on the collapse, which follows no equilibrium, is what decides.
const MOSTLY: f64 = 0.5;

/// Calls the mode of a joint by its damage; `None` without damage. `retained` is the part `[1]` of the peak load that the joint still bore
/// at the end of its history, if that went beyond the peak.
pub fn call_mode(hole: &Hole, sites: &[DamageSite], retained: Option<f64>) -> Option<ModeCall> {
    let evidence = Evidence::of(hole, sites)?;
    let Evidence {
        basis,
        shares,
        reach: covered,
        ..
    } = evidence;
    let followed: Vec<DamageSite> = sites
        .iter()
        .filter(|site| !site.collapse)
        .copied()
        .collect();
    let counted = followed.iter().filter(|site| basis.kind(site));
    let followed_reach = reach(hole, counted);
    let (mode, rule) = decide(shares, covered);
    let mut near = evidence.neighbours();
    let mut reserve = Reserve::default();
    if let Some(before) = Evidence::of(hole, &followed)
        && before.basis.fibre == basis.fibre
    {
        near.push(decide(before.shares, before.reach).0);
        reserve.without_collapse = evidence.collapse > 0.0;
    }
    let mostly = evidence.collapse > MOSTLY;
    if mostly {
        near.push(decide(shares, followed_reach).0);
        reserve.without_its_paths = true;
    }
    let least = match mode {
        _ if mostly => Some(ModeCall::MAY_SHIFT),
        JointMode::Mixed => Some(TAKES_PART),
        _ => None,
    };
    let part = least.map_or_else(Vec::new, |least| evidence.with_share(least));
    let others = |found: &[JointMode]| -> Vec<JointMode> {
        let all = JointMode::ALL.into_iter();
        all.filter(|other| *other != mode && found.contains(other))
            .collect()
    };
    reserve.near = others(&near);
    reserve.part = least.map(|least| (least, others(&part)));
    Some(ModeCall {
        mode,
        basis,
        rule,
        shares,
        reach: covered,
        followed_reach,
        collapse: evidence.collapse,
        others: others(&[near, part].concat()),
        reserve,
        retained,
    })
}

/// A severed path first, then the share, then whether the damage stays at the hole's edge.
fn decide(shares: [f64; 3], reach: [f64; 3]) -> (JointMode, ModeRule) {
    let severed = |mode: usize| reach[mode] >= ModeCall::SEVERED && shares[mode] >= TAKES_PART;
    // What is crushed ahead of the pin is not parted; what is split ahead of it to the end is.
    match [severed(0) || severed(1), severed(2)] {
        [true, false] if severed(1) => return (JointMode::ShearOut, ModeRule::Severed),
        [true, false] => return (JointMode::ShearOut, ModeRule::Split),
        [false, true] => return (JointMode::NetTension, ModeRule::Severed),
        _ => {}
    }
    let largest = (0..3).fold(0, |best, mode| {
        if shares[mode] > shares[best] {
            mode
        } else {
            best
        }
    });
    let confined = reach[1] < CONFINED && reach[2] < CONFINED;
    if shares[largest] >= ModeCall::GOVERNS {
        (JointMode::PURE[largest], ModeRule::Share)
    } else if largest == 0 && shares[0] >= CRUSHED && confined {
        (JointMode::Bearing, ModeRule::Confined)
    } else {
        (JointMode::Mixed, ModeRule::NoShare)
    }
}

impl JointHistory {
    /// The failures of body `body`, as [`call_mode`] takes them, those of the collapse at the end included.
    pub fn damage_sites(&self, body: usize) -> Vec<DamageSite> {
        let peak = self.peak();
        let enough = ModeCall::LATE * self.records[peak].load;
        let late = |(index, record): (usize, &JointRecord)| index > peak || record.load >= enough;
        let followed = (self.records.iter().enumerate()).flat_map(|(index, record)| {
            record
                .events
                .iter()
                .map(move |event| (event, late((index, record)), false))
        });
        let collapse: &[PlyEvent] = match &self.ending {
            Ending::NoEquilibrium { collapse, .. } => collapse,
            Ending::Completed | Ending::Severed { .. } | Ending::LoadDropped { .. } => &[],
        };
        let all = followed.chain(collapse.iter().map(|event| (event, true, true)));
        all.filter(|(event, _, _)| event.body == body && event.is_failure())
            .map(|(event, late, collapse)| DamageSite {
                position: event.position,
                volume: event.volume,
                fibre: event.breaks_fibres(),
                late,
                collapse,
            })
            .collect()
    }

    /// The mode in which body `body` fails around `hole`; `None` without damage.
    pub fn mode(&self, body: usize, hole: &Hole) -> Option<ModeCall> {
        let peak = self.peak();
        let last = &self.records[self.records.len() - 1];
        let beyond = last.displacement > self.records[peak].displacement;
        let retained =
            (beyond && self.records[peak].load > 0.0).then(|| last.load / self.records[peak].load);
        call_mode(hole, &self.damage_sites(body), retained)
    }
}
