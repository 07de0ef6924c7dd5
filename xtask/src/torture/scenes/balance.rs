//! Balance of each body from written resultants, reactions and the scene's own loads, and what is said where it is poor.

use stickslip::output::sentence;
use stickslip::results::Finding;
use stickslip::scene::schema::{Hold, LoadKind, Substance};
use stickslip::scene::shape::{Curve, Role};

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
    let mut any = false;
    // A body that nothing touches carries the rounding of the others.
    let names = sample.results.bodies.iter().map(|body| &body.name);
    let scale = names
        .filter_map(|name| largest(sample, name))
        .fold(REST * stiffness(sample) * sample.motion(), f64::max)
        .max(HELD * heated(sample));
    for (index, body) in sample.results.bodies.iter().enumerate() {
        for step in 0..sample.results.steps.len() {
            let Some(mut sum) = load(sample, &body.name, step) else {
                continue;
            };
            for (edge, contact) in sample.scene.contacts.iter().enumerate() {
                let sign = if contact.first.body == body.name {
                    1.0
                } else if contact.second.body == body.name {
                    -1.0
                } else {
                    continue;
                };
                let resultant = sample.results.steps[step].edges[edge].resultant;
                (0..2).for_each(|axis| sum[axis] += sign * resultant[axis]);
            }
            let free = free_axes(sample, &body.name);
            let reaction = sample.results.steps[step]
                .balance
                .get(index)
                .copied()
                .flatten();
            for axis in 0..2 {
                let rest = match (free[axis], reaction) {
                    (true, _) => sum[axis],
                    (false, Some(balance)) if !sample.is_half() => {
                        sum[axis] + balance.reaction[axis]
                    }
                    _ => continue,
                };
                any = true;
                if rest.abs() > ROUNDING * scale {
                    return Verdict::Fails(format!(
                        "'{}', step {}, {}: {rest:e} N are left of {scale:e} N",
                        body.name,
                        step + 1,
                        ["x", "y"][axis]
                    ));
                }
            }
        }
    }
    if any { Verdict::Holds } else { Verdict::Beside }
}

/// Force `[N]` that a motion of 1 mm as strain would take: the largest modulus times the largest thickness.
fn stiffness(sample: &Sample) -> f64 {
    let thickness = sample
        .scene
        .bodies
        .values()
        .filter_map(|body| match body.substance {
            Substance::Elastic { thickness, .. } => Some(thickness),
            Substance::Rigid => None,
        });
    sample.moduli()[1] * thickness.fold(0.0, f64::max)
}

/// Force `[N]` that what is held against its thermal strain may take.
fn heated(sample: &Sample) -> f64 {
    let warmest = sample.scene.loads.iter().map(|load| match &load.kind {
        LoadKind::Temperature { steps, .. } => steps
            .iter()
            .fold(0.0, |most: f64, step| most.max(step.abs())),
        _ => 0.0,
    });
    let expansions =
        super::quantity::table(&sample.value, "materials").flat_map(|(_, material)| {
            [
                "/isotropic/expansion",
                "/orthotropic/expansion1",
                "/orthotropic/expansion2",
            ]
            .map(|key| super::quantity::number(material, key).unwrap_or(0.0).abs())
        });
    // A ply's own is that of its resin.
    let largest = expansions.fold(2e-5, f64::max);
    stiffness(sample) * sample.size() * largest * warmest.fold(0.0, f64::max)
}

/// The largest force on the body in the history, of one contact or load.
fn largest(sample: &Sample, body: &str) -> Option<f64> {
    let mut most = 0.0_f64;
    for step in 0..sample.results.steps.len() {
        let [x, y] = load(sample, body, step)?;
        most = most.max(x.hypot(y)).max(pressed(sample, body, step));
        for (edge, contact) in sample.scene.contacts.iter().enumerate() {
            if contact.first.body == body || contact.second.body == body {
                most = most.max(sample.results.steps[step].edges[edge].normal_force);
            }
        }
    }
    // What two contacts hold against each other is more than what is applied: heat of a body that both sides hold.
    let reactions = sample
        .results
        .steps
        .iter()
        .flat_map(|step| step.balance.iter().flatten());
    let reaction = reactions.map(|balance| balance.reaction[0].hypot(balance.reaction[1]));
    Some(reaction.fold(most, f64::max))
}

/// The largest force `[N]` on one side of a body by the pressures on its edges, also of those that balance themselves around a circle.
fn pressed(sample: &Sample, body: &str, step: usize) -> f64 {
    let thickness = match sample.scene.bodies.get(body).map(|body| &body.substance) {
        Some(Substance::Elastic { thickness, .. }) => *thickness,
        _ => 0.0,
    };
    let forces = sample.scene.loads.iter().map(|load| match &load.kind {
        LoadKind::Pressure { on, steps } if on.body == body => {
            steps[step].abs() * thickness * sample.size()
        }
        _ => 0.0,
    });
    forces.fold(0.0, f64::max)
}

/// Resultant of the loads on a body `[N]`; `None` where it is not known from the scene alone.
fn load(sample: &Sample, body: &str, step: usize) -> Option<[f64; 2]> {
    let mut sum = [0.0; 2];
    for load in &sample.scene.loads {
        match &load.kind {
            LoadKind::Force {
                on,
                direction,
                steps,
            }
            | LoadKind::Bearing {
                on,
                direction,
                steps,
                ..
            } if on.body == body => {
                (0..2).for_each(|axis| sum[axis] += direction[axis] * steps[step]);
            }
            LoadKind::Pressure { on, steps } if on.body == body => {
                let [x, y] = pushed(sample, body, &on.set)?;
                sum[0] += x * steps[step];
                sum[1] += y * steps[step];
            }
            LoadKind::PolarTraction { on, .. } if on.body == body => return None,
            _ => {}
        }
    }
    Some(sum)
}

/// Force on a body by a pressure of one on its edge.
fn pushed(sample: &Sample, body: &str, set: &str) -> Option<[f64; 2]> {
    let body = sample.scene.bodies.get(body)?;
    let Substance::Elastic { thickness, .. } = &body.substance else {
        return None;
    };
    let shape = body.shape;
    // The resultant of a pressure on a cap depends on its arc, which this check leaves out, with what is under it.
    if shape.edge_with(Role::Cap).is_some() || shape.edge_with(Role::Surface).is_some() {
        return None;
    }
    match shape.edge(set)?.curve {
        Curve::Circle { .. } => Some([0.0; 2]),
        Curve::Segment { ends: [from, to] } => {
            Some([(from[1] - to[1]) * thickness, (to[0] - from[0]) * thickness])
        }
        Curve::Arc { .. } => None,
    }
}

/// Axes along which no support or platen holds the body.
fn free_axes(sample: &Sample, body: &str) -> [bool; 2] {
    let mut free = [true; 2];
    for support in sample
        .scene
        .supports
        .iter()
        .filter(|support| support.on.body == body)
    {
        match support.hold {
            Hold::Axes(axes) => {
                free[0] &= !axes.x;
                free[1] &= !axes.y;
            }
            Hold::Direction(_) => free = [false; 2],
        }
    }
    for platen in sample
        .scene
        .platens
        .iter()
        .filter(|platen| platen.on.body == body)
    {
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
    let worst = sample
        .results
        .steps
        .iter()
        .map(|step| step.balance_residual)
        .fold(0.0, f64::max);
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
