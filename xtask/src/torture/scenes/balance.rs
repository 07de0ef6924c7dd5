//! Balance of each body from written resultants, reactions and the scene's own loads, and what is said where it is poor.

use stickslip::output::sentence;
use stickslip::results::Finding;
use stickslip::scene::schema::{Hold, LoadKind};
use stickslip::scene::shape::{Curve, Role};

use super::quantity::{number, table};
use super::sample::{Sample, Verdict};

/// Sums of some hundred forces, relative to the largest of the history.
const ROUNDING: f64 = 1e-8;

/// Part of the force that a motion would take if it were strain which counts as none at all.
const REST: f64 = 1e-6;

/// Part of the force that thermal strain would take if it were held which counts as none at all.
const HELD: f64 = 1e-4;

/// A residual of balance above this is a finding.
const REPORTED: f64 = 1e-8;

/// Loads, contact resultants and reactions of every body sum to zero; without reactions along axes that nothing holds.
pub(super) fn bodies(sample: &Sample) -> Verdict {
    // A body that nothing touches carries the rounding of the others.
    let names = sample.results.bodies.iter().map(|body| &body.name);
    let scale = names
        .filter_map(|name| largest(sample, name))
        .fold(REST * stiffness(sample) * sample.motion(), f64::max)
        .max(HELD * heated(sample));
    let mut any = false;
    for (index, body) in sample.results.bodies.iter().enumerate() {
        for (step, results) in sample.results.steps.iter().enumerate() {
            let reaction = results.balance.get(index).copied().flatten();
            let reaction = reaction.map(|balance| balance.reaction);
            for (axis, rest) in rests(sample, &body.name, step, reaction) {
                any = true;
                if rest.abs() > ROUNDING * scale {
                    let (name, step, axis) = (&body.name, step + 1, ["x", "y"][axis]);
                    let found = format!("{rest:e} N are left of {scale:e} N");
                    return Verdict::Fails(format!("'{name}', step {step}, {axis}: {found}"));
                }
            }
        }
    }
    if any { Verdict::Holds } else { Verdict::Beside }
}

/// What is left of the forces on a body along the axes where all of them are known.
fn rests(
    sample: &Sample,
    body: &str,
    step: usize,
    reaction: Option<[f64; 2]>,
) -> impl Iterator<Item = (usize, f64)> {
    let own = load(sample, body, step).map(|mut sum| {
        for (edge, sign) in contacts_of(sample, body) {
            let resultant = sample.results.steps[step].edges[edge].resultant;
            (0..2).for_each(|axis| sum[axis] += sign * resultant[axis]);
        }
        sum
    });
    let (free, is_half) = (free_axes(sample, body), sample.is_half());
    (0..2).filter_map(move |axis| {
        let rest = match (free[axis], reaction) {
            (true, _) => own?[axis],
            (false, Some(reaction)) if !is_half => own?[axis] + reaction[axis],
            _ => return None,
        };
        Some((axis, rest))
    })
}

/// Edges of the contacts of a body, with the sign of their resultants on it.
fn contacts_of<'a>(sample: &'a Sample, body: &'a str) -> impl Iterator<Item = (usize, f64)> + 'a {
    let contacts = sample.scene.contacts.iter().enumerate();
    contacts.filter_map(move |(edge, contact)| {
        if contact.first.body == body {
            Some((edge, 1.0))
        } else {
            (contact.second.body == body).then_some((edge, -1.0))
        }
    })
}

/// Force `[N]` that a motion of 1 mm as strain would take: the largest modulus times the largest thickness.
fn stiffness(sample: &Sample) -> f64 {
    let names = sample.scene.bodies.keys();
    let thickness = names.filter_map(|body| sample.thickness(body));
    sample.moduli()[1] * thickness.fold(0.0, f64::max)
}

/// Force `[N]` that what is held against its thermal strain may take.
fn heated(sample: &Sample) -> f64 {
    let loads = sample.scene.loads.iter();
    let heats = loads.filter(|load| matches!(load.kind, LoadKind::Temperature { .. }));
    let warmest = heats
        .flat_map(|load| load.kind.steps())
        .copied()
        .map(f64::abs);
    let keys = [
        "/isotropic/expansion",
        "/orthotropic/expansion1",
        "/orthotropic/expansion2",
    ];
    let materials = table(&sample.value, "materials").map(|(_, material)| material);
    let expansions =
        materials.flat_map(|material| keys.map(|key| number(material, key).unwrap_or(0.0).abs()));
    // A ply's own is that of its resin.
    let largest = expansions.fold(2e-5, f64::max);
    stiffness(sample) * sample.size() * largest * warmest.fold(0.0, f64::max)
}

/// The largest force on the body in the history, of one contact or load.
fn largest(sample: &Sample, body: &str) -> Option<f64> {
    let mut most = 0.0_f64;
    for (step, results) in sample.results.steps.iter().enumerate() {
        let [x, y] = load(sample, body, step)?;
        most = most.max(x.hypot(y)).max(pressed(sample, body, step));
        let forces = contacts_of(sample, body).map(|(edge, _)| results.edges[edge].normal_force);
        most = forces.fold(most, f64::max);
    }
    // What two contacts hold against each other is more than what is applied: heat of a body that both sides hold.
    let steps = sample.results.steps.iter();
    let reactions = steps.flat_map(|step| step.balance.iter().flatten());
    let reactions = reactions.map(|balance| balance.reaction[0].hypot(balance.reaction[1]));
    Some(reactions.fold(most, f64::max))
}

/// The largest force `[N]` on one side of a body by the pressures on its edges, also of those that balance themselves around a circle.
fn pressed(sample: &Sample, body: &str, step: usize) -> f64 {
    let area = sample.thickness(body).unwrap_or(0.0) * sample.size();
    let forces = sample.scene.loads.iter().map(|load| match &load.kind {
        LoadKind::Pressure { on, steps } if on.body == body => steps[step].abs() * area,
        _ => 0.0,
    });
    forces.fold(0.0, f64::max)
}

/// Resultant of the loads on a body `[N]`; `None` where it is not known from the scene alone.
fn load(sample: &Sample, body: &str, step: usize) -> Option<[f64; 2]> {
    let mut sum = [0.0; 2];
    for load in &sample.scene.loads {
        let unit = match &load.kind {
            LoadKind::Force { on, direction, .. } | LoadKind::Bearing { on, direction, .. }
                if on.body == body =>
            {
                *direction
            }
            LoadKind::Pressure { on, .. } if on.body == body => pushed(sample, body, &on.set)?,
            LoadKind::PolarTraction { on, .. } if on.body == body => return None,
            _ => continue,
        };
        (0..2).for_each(|axis| sum[axis] += unit[axis] * load.kind.steps()[step]);
    }
    Some(sum)
}

/// Force on a body by a pressure of one on its edge.
fn pushed(sample: &Sample, body: &str, set: &str) -> Option<[f64; 2]> {
    let thickness = sample.thickness(body)?;
    let shape = &sample.scene.bodies.get(body)?.shape;
    // The resultant of a pressure on a cap depends on its arc, which this check leaves out, with what is under it.
    if shape.edge_with(Role::Cap).is_some() || shape.edge_with(Role::Surface).is_some() {
        return None;
    }
    match shape.edge(set)?.curve {
        Curve::Circle { .. } => Some([0.0; 2]),
        Curve::Segment { ends: [from, to] } => {
            Some([(from[1] - to[1]) * thickness, (to[0] - from[0]) * thickness])
        }
        Curve::Arc { .. } | Curve::Chain { .. } => None,
    }
}

/// Axes along which no support or platen holds the body.
fn free_axes(sample: &Sample, body: &str) -> [bool; 2] {
    let mut free = [true; 2];
    let supports = sample.scene.supports.iter();
    for support in supports.filter(|support| support.on.body == body) {
        match support.hold {
            Hold::Axes(axes) => {
                free[0] &= !axes.x;
                free[1] &= !axes.y;
            }
            Hold::Direction(_) => free = [false; 2],
        }
    }
    let platens = sample.scene.platens.iter();
    for platen in platens.filter(|platen| platen.on.body == body) {
        free[0] &= platen.free.x;
        free[1] &= platen.free.y;
    }
    if sample.is_half() {
        // The mirror holds the half across its line, and the resultants of both halves have nothing there.
        free[usize::from(sample.is_round())] = false;
    }
    free
}

/// A poor residual of balance is a finding.
pub(super) fn residual(sample: &Sample) -> Verdict {
    let residuals = sample
        .results
        .steps
        .iter()
        .map(|step| step.balance_residual);
    let worst = residuals.fold(0.0, f64::max);
    if worst <= REPORTED {
        return Verdict::Holds;
    }
    let results = &sample.results;
    let says = |finding: &&Finding| matches!(finding, Finding::Unbalanced { .. });
    match results.findings.iter().find(says) {
        Some(finding) => Verdict::Declared(sentence(finding, results.units)),
        None => Verdict::Fails(format!("balance_residual {worst:e} without a note")),
    }
}
