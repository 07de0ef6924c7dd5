//! What a mode is called by: which damage decides, how it is shared out, and how far it covers each path.

use super::zones::zone_weights;
use super::{DamageSite, Hole, JointMode, ModeCall, decide};

const PARTS: usize = ModeCall::PARTS;

/// Which damage decides a mode: broken fibres before cracks, late damage before early.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Basis {
    /// Broken fibres alone, and not matrix damage.
    pub fibre: bool,
    /// Damage from [`ModeCall::LATE`] of the peak load on alone.
    pub late: bool,
}

impl Basis {
    fn of(sites: &[DamageSite]) -> Option<Self> {
        let candidates = [(true, true), (false, true), (true, false), (false, false)];
        let bases = candidates.map(|(fibre, late)| Self { fibre, late });
        bases
            .into_iter()
            .find(|basis| sites.iter().any(|site| basis.takes(site)))
    }

    fn takes(self, site: &DamageSite) -> bool {
        self.kind(site) && (site.late || !self.late)
    }

    /// Whether damage is of the deciding kind, at any time.
    pub(super) fn kind(self, site: &DamageSite) -> bool {
        site.fibre || !self.fibre
    }
}

/// What a mode is called by.
pub(super) struct Evidence {
    pub(super) basis: Basis,
    pub(super) shares: [f64; 3],
    pub(super) reach: [f64; 3],
    /// Part of the deciding damage that happened in the collapse.
    pub(super) collapse: f64,
}

impl Evidence {
    /// That of `sites`; `None` without any.
    pub(super) fn of(hole: &Hole, sites: &[DamageSite]) -> Option<Self> {
        let basis = Basis::of(sites)?;
        let mut sums = [0.0; 3];
        let (mut total, mut collapse) = (0.0, 0.0);
        for site in sites.iter().filter(|site| basis.takes(site)) {
            total += site.volume;
            collapse += if site.collapse { site.volume } else { 0.0 };
            let weights = zone_weights(hole.local(site.position)).into_iter();
            for (sum, weight) in sums.iter_mut().zip(weights) {
                *sum += weight * site.volume;
            }
        }
        let part = |sum: f64| if total > 0.0 { sum / total } else { 0.0 };
        Some(Self {
            basis,
            shares: sums.map(part),
            reach: reach(hole, sites.iter().filter(|site| basis.kind(site))),
            collapse: part(collapse),
        })
    }

    /// The modes that slightly different damage would be called: a part of it in another zone, out of all zones or into one from there, and
    /// one path a part longer or shorter.
    pub(super) fn neighbours(&self) -> Vec<JointMode> {
        let [bearing, shear, tension] = self.shares;
        let elsewhere = (1.0 - bearing - shear - tension).max(0.0);
        let mut shares = vec![self.shares];
        for from in 0..4 {
            for to in (0..4).filter(|to| *to != from) {
                let mut moved = [bearing, shear, tension, elsewhere];
                let part = ModeCall::MAY_SHIFT.min(moved[from]);
                moved[from] -= part;
                moved[to] += part;
                shares.push([moved[0], moved[1], moved[2]]);
            }
        }
        let mut reaches = vec![self.reach];
        for from in 0..3 {
            for step in [-1.0, 1.0] {
                let parts = (self.reach[from] * PARTS as f64).round() + step;
                let mut moved = self.reach;
                moved[from] = parts.clamp(0.0, PARTS as f64) / PARTS as f64;
                reaches.push(moved);
            }
        }
        let all = shares.iter().flat_map(|shares| {
            let call = |reach: &[f64; 3]| decide(*shares, *reach).0;
            reaches.iter().map(call)
        });
        all.collect()
    }

    /// The modes with the part `least` of the deciding damage or more.
    pub(super) fn with_share(&self, least: f64) -> Vec<JointMode> {
        let pure = JointMode::PURE.into_iter().zip(self.shares);
        let large = pure.filter(|(_, share)| *share >= least);
        large.map(|(mode, _)| mode).collect()
    }
}

/// How much of each mode's path `sites` cover: parts of the path in which there is one.
pub(super) fn reach<'s>(hole: &Hole, sites: impl Iterator<Item = &'s DamageSite>) -> [f64; 3] {
    let mut covered = [[false; PARTS]; 3];
    for site in sites {
        let local = hole.local(site.position);
        for (mode, weight) in zone_weights(local).into_iter().enumerate() {
            if weight >= 0.5 {
                let part = hole.reach(mode, local) * PARTS as f64;
                covered[mode][(part as usize).min(PARTS - 1)] = true;
            }
        }
    }
    covered.map(|path| path.iter().filter(|part| **part).count() as f64 / PARTS as f64)
}
