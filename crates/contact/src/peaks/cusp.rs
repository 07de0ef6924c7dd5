//! Peaks at located ends, by the expansion of the stress around them.

use super::fit::{Equations, median, range};
use super::{Located, Peak};

/// Nodes on one side of an end, from the end outwards; all arrays have the same length.
#[derive(Clone, Copy, Debug)]
pub struct Side<'a> {
    /// Places `[length]`.
    pub places: &'a [f64],
    /// Stress σ_t along the edge `[stress]`, tension positive.
    pub stress: &'a [f64],
    /// Pressure p `[stress]` on the edge.
    pub pressure: &'a [f64],
}

impl Side<'_> {
    /// Whether all arrays have one entry per node.
    fn is_complete(&self) -> bool {
        let count = self.places.len();
        self.stress.len() == count && self.pressure.len() == count
    }
}

/// The held side, and the shear traction on it.
#[derive(Clone, Copy, Debug)]
pub struct HeldSide<'a> {
    /// Its nodes.
    pub side: Side<'a>,
    /// q − q_s `[stress]` at its nodes: the shear traction on the body along growing places, less that of the slip on the free side, ±μp.
    pub excess: &'a [f64],
}

/// What is known around a located end.
#[derive(Clone, Copy, Debug)]
pub struct Cusp<'a> {
    /// The end.
    pub end: Located,
    /// Nodes of the free side: open beyond contact, slipping beyond stick. Up to eight are used, without a held side up to eleven; none may lie beyond another end.
    pub free: Side<'a>,
    /// Nodes of the held side, up to six, as far as the shear traction has one law: slipping one way, or sticking. `None` where the body is not isotropic, or its
    /// stress along the edge follows from more than tractions near the end.
    pub held: Option<HeldSide<'a>>,
    /// Whether the free side is open, so that its pressure is zero.
    pub open: bool,
}

/// Estimated error over the spread of fits and over the rise above the nodes, so that about 19 in 20 hold the truth: at a resolved end of contact, of stick, and elsewhere.
const CALIBRATION: [[f64; 2]; 3] = [[0.8, 0.03], [0.8, 0.15], [1.0, 0.5]];
/// Line of [`CALIBRATION`] of an end that is not resolved.
const UNRESOLVED: usize = 2;
/// Nodes of an end that is resolved: that slip beside an opening, and that slip beside stick.
const RESOLVED: usize = 3;
/// Most nodes of the free side.
const FREE: usize = 8;
/// Most nodes of the held side, where it slips and where it sticks.
const HELD: [usize; 2] = [6, 4];

/// Nodes and terms of a fit.
#[derive(Clone, Copy, Debug)]
struct Choice {
    /// Nodes of the free side, first and count.
    free: [usize; 2],
    /// Nodes of the held side, first and count.
    held: [usize; 2],
    /// Terms of the smooth part.
    smooth: usize,
    /// Terms of the root.
    roots: usize,
}

/// Estimates the height A − p of the cusp at a located end by the expansion of the [module](super).
///
/// With a held side five fits are made, with and without the nodes next to the end, with fewer nodes and with fewer terms; the value is their median. Without it the first free node, which
/// the discretisation smears, is skipped, and A + B√x + Cx + Dx^{3/2} fitted to different sets of the next ones. The error is estimated from the spread of these fits, from what the error of the
/// end's place does, and from the rise above the nodal values beside the end. Where fewer than three nodes slip beside an opening, or fewer than four beside stick, the last counts most.
///
/// `None` with fewer than two free nodes or one held node, without a held side with fewer than five free nodes, with arrays of different length or values that are not finite.
pub fn cusp_peak(cusp: &Cusp<'_>) -> Option<Peak> {
    let held = cusp.held.iter();
    let complete = held
        .clone()
        .all(|held| held.excess.len() == held.side.places.len());
    let sides = held.map(|held| held.side).chain([cusp.free]);
    if !complete || !sides.into_iter().all(|side| side.is_complete()) {
        return None;
    }
    let place = cusp.end.place;
    let choices = match &cusp.held {
        Some(held) => joint(cusp, held),
        None => one_sided(cusp),
    };
    let fit = |choice: &Choice, place: f64| height(cusp, *choice, place);
    let values: Vec<f64> = (choices.iter())
        .filter_map(|choice| fit(choice, place))
        .collect();
    let first = choices.first()?;
    let error = cusp.end.error;
    let moved = range(&[fit(first, place - error)?, fit(first, place + error)?]);
    let spread = range(&values).hypot(moved);
    let value = median(values)?;
    let [by_spread, by_rise] = CALIBRATION[class(cusp)];
    Some(Peak {
        error: by_spread * spread + by_rise * rise(cusp, value),
        value,
        place,
    })
}

/// How far `value` is above the nodes beside the end; where the end is not resolved, the range of them all.
fn rise(cusp: &Cusp<'_>, value: f64) -> f64 {
    let held = cusp.held.iter().flat_map(|held| held.side.stress.iter());
    let mut near: Vec<f64> = (cusp.free.stress.iter().take(2).chain(held.take(2)))
        .copied()
        .collect();
    if class(cusp) == UNRESOLVED {
        near.push(value);
        return range(&near);
    }
    (value - near.into_iter().fold(f64::NEG_INFINITY, f64::max)).abs()
}

/// Line of [`CALIBRATION`].
fn class(cusp: &Cusp<'_>) -> usize {
    match &cusp.held {
        Some(held) if cusp.open && held.side.places.len() >= RESOLVED => 0,
        Some(_) if !cusp.open && cusp.free.places.len() > RESOLVED => 1,
        _ => UNRESOLVED,
    }
}

/// Sets of nodes and terms on both sides.
fn joint(cusp: &Cusp<'_>, held: &HeldSide<'_>) -> Vec<Choice> {
    let most = HELD[usize::from(!cusp.open)];
    let [free, held] = [
        cusp.free.places.len().min(FREE),
        held.side.places.len().min(most),
    ];
    if free < 2 || held < 1 {
        return Vec::new();
    }
    let smooth = if cusp.open && free >= 6 && held >= 5 {
        3
    } else {
        2
    };
    let roots = if free >= 4 { 2 } else { 1 };
    let choice = |from: [usize; 2], most: [usize; 2], smooth: usize| {
        let from = [from[0].min(free - 2), from[1].min(held - 1)];
        Choice {
            free: [from[0], (free - from[0]).min(most[0])],
            held: [from[1], (held - from[1]).min(most[1])],
            smooth,
            roots,
        }
    };
    vec![
        choice([0, 0], [8, 6], smooth),
        choice([1, 1], [8, 6], smooth),
        choice([0, 0], [6, 4], 2),
        choice([0, 1], [6, 6], smooth),
        choice([1, 0], [6, 6], smooth),
    ]
}

/// Sets of nodes and terms on the free side.
fn one_sided(cusp: &Cusp<'_>) -> Vec<Choice> {
    let count = cusp.free.places.len();
    let choice = |[first, most]: [usize; 2]| Choice {
        free: [first, most.min(count.saturating_sub(first))],
        held: [0, 0],
        smooth: 2,
        roots: 2,
    };
    let enough = |choice: &Choice| choice.free[1] >= 4;
    let sets = [[1, 8], [1, 6], [1, 10], [2, 8], [2, 6]];
    sets.map(choice).into_iter().filter(enough).collect()
}

/// A − p of one fit, with the end at `place`.
fn height(cusp: &Cusp<'_>, choice: Choice, place: f64) -> Option<f64> {
    let free = &cusp.free;
    let nodes = |[first, count]: [usize; 2]| first..first + count;
    let outermost = free
        .places
        .get((choice.free[0] + choice.free[1]).checked_sub(1)?)?;
    let size = outermost - place;
    // Of a body that is not isotropic σ_t itself, on the free side only.
    let both = cusp.held.is_some();
    let mut sum = Equations::new(choice.smooth + choice.roots);
    let mut pressure = Equations::new(4);
    let smooth = |x: f64| (0..choice.smooth).map(move |k| (k, x.powi(k as i32)));
    let roots = |x: f64, factor: f64| {
        let root = factor * x.abs().sqrt();
        (0..choice.roots).map(move |k| (choice.smooth + k, root * x.powi(k as i32)))
    };
    // Shear is counted along growing places, x away from the end.
    let direction = size.signum();
    for k in nodes(choice.free) {
        let x = ((free.places[k] - place) / size).max(0.0);
        let p = if both { free.pressure[k] } else { 0.0 };
        sum.add(
            smooth(x).chain(roots(x, 2.0 * direction)),
            free.stress[k] + p,
        );
        pressure.add([(0, 1.0), (1, x.sqrt()), (2, x)], p);
    }
    if let Some(HeldSide { side, excess }) = &cusp.held {
        for k in nodes(choice.held) {
            let x = ((side.places[k] - place) / size).min(0.0);
            sum.add(smooth(x), side.stress[k] + side.pressure[k]);
            sum.add(roots(x, 2.0), 2.0 * excess[k]);
            pressure.add([(0, 1.0), (3, x)], side.pressure[k]);
        }
    }
    let there = if cusp.open || !both {
        Some(0.0)
    } else {
        pressure.first()
    };
    Some(sum.first()? - there?)
}
