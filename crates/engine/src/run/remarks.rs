//! What a reader must know of the solution: where an answer was not unique, where the history was cut back, where contact lies.

use stickslip_contact::Interface;
use stickslip_contact::freedom::{FreeBody, free_bodies};
use stickslip_contact::history::FailedAttempts;
use stickslip_contact::interface::Part;
use stickslip_contact::uniqueness::NEAR_BOUND;
use stickslip_contact::zones::Zone;

use crate::model::{Model, beyond_fine_zone};
use crate::results::{BearingSource, EdgeGeometry, EdgeKind, EdgeResults, StepResults, wrapped};
use stickslip_scene::Scene;

/// Angle `[rad]` by which the bearing point of a round contact may move in a history before it is reported.
const WANDERS: f64 = 5.0 * std::f64::consts::PI / 180.0;
/// The same on a line, as a part of the widest half of the contact.
const WANDERS_PART: f64 = 0.1;

/// Remarks on the load steps.
pub(super) fn of_steps(
    scene: &Scene,
    edges: &[EdgeGeometry],
    steps: &[StepResults],
) -> Vec<String> {
    let mut notes: Vec<String> = doubtful(steps)
        .into_iter()
        .chain(recovered(steps))
        .chain(several(steps))
        .chain(near_bound(steps))
        .collect();
    for (index, edge) in edges.iter().enumerate() {
        if edge.contact {
            let own: Vec<&EdgeResults> = steps.iter().map(|step| &step.edges[index]).collect();
            let zones: Vec<&[Zone]> = own.iter().map(|step| &*step.zones).collect();
            notes.extend(beyond_fine_zone(scene, edge, &zones));
            notes.extend(wanders(scene, edge, &own));
        }
    }
    notes
}

fn doubtful(steps: &[StepResults]) -> Option<String> {
    let which = steps_where(steps, |step| step.doubtful > 0)?;
    let most = steps.iter().map(|step| step.doubtful).max().unwrap_or(0);
    Some(format!(
        "The answer is not unique in load step {which}: up to {most} contact points stick with a traction between the dynamic and the \
         static bound, where slip at the dynamic traction would be admissible too. They were taken to stick because they had \
         not slipped before."
    ))
}

/// One line on the solvers that failed before a step was solved.
fn recovered(steps: &[StepResults]) -> Option<String> {
    let which = steps_where(steps, |step| !step.notes.recovery.is_empty())?;
    let mut failures: Vec<FailedAttempts> = Vec::new();
    for entry in steps.iter().flat_map(|step| &step.notes.recovery.failures) {
        let same =
            |other: &&mut FailedAttempts| (other.solver, other.kind) == (entry.solver, entry.kind);
        match failures.iter_mut().find(same) {
            Some(other) => other.count += entry.count,
            None => failures.push(*entry),
        }
    }
    let counted =
        |entry: &FailedAttempts| format!("{}: {} (×{})", entry.solver, entry.kind, entry.count);
    let list: Vec<String> = failures.iter().map(counted).collect();
    let cycle = steps
        .iter()
        .find_map(|step| step.notes.recovery.first_cycle.as_ref());
    let cycle = cycle.map_or_else(String::new, |cycle| {
        let (period, points) = (cycle.period, cycle.points.len());
        format!(
            " In the first cycle the statuses of {points} points repeated with period {period}."
        )
    });
    Some(format!(
        "More than the first solver was needed in load step {which}: {}.{cycle}",
        list.join(", ")
    ))
}

fn several(steps: &[StepResults]) -> Option<String> {
    let which = steps_where(steps, |step| step.notes.solutions > Some(1))?;
    let most = steps.iter().filter_map(|step| step.notes.solutions).max()?;
    Some(format!(
        "The answer is not unique in load step {which}: an increment has up to {most} solutions with the same loads. That was taken \
         whose statuses differ least from the last accepted ones, and of equal ones that which moves least."
    ))
}

/// Says where friction comes near the estimated bound of uniqueness.
fn near_bound(steps: &[StepResults]) -> Option<String> {
    // Independent contacts have each their own such step.
    let (index, estimate) = steps
        .iter()
        .enumerate()
        .filter_map(|(index, step)| Some((index, step.notes.uniqueness?)))
        .max_by(|&(a, bound), &(b, other)| {
            let nearness = |step: usize, bound: f64| steps[step].notes.friction / bound;
            nearness(a, bound).total_cmp(&nearness(b, other))
        })?;
    let notes = &steps[index].notes;
    if notes.friction <= NEAR_BOUND * estimate {
        return None;
    }
    let beyond = notes.friction > estimate;
    let relation = if beyond { "beyond" } else { "near" };
    let asked = notes.otherwise.other_solver.is_some();
    let counted = match notes.solutions {
        Some(1) => "enumeration found no other with the same points in contact".into(),
        Some(count) => format!("{count} were found by enumeration of the points in contact"),
        None if asked => "they were not enumerated, but another solver was asked".into(),
        None if beyond => "they were not enumerated, because too many points touch".into(),
        None => "none was looked for".into(),
    };
    Some(format!(
        "Friction of up to {:.3} is {relation} {estimate:.3}, the estimate of the coefficient of friction up to which load step {} \
         (where contact is largest) is unique. There may be further solutions; {counted}.",
        notes.friction,
        index + 1
    ))
}

/// Says where the bearing point of a contact moves along its edge in the history.
fn wanders(scene: &Scene, edge: &EdgeGeometry, steps: &[&EdgeResults]) -> Option<String> {
    let (from, BearingSource::Contact { step }) = (edge.frame.bearing?, edge.frame.found) else {
        return None;
    };
    let widest = steps.iter().filter_map(|step| step.contact_half_extent);
    let widest = widest.fold(0.0, f64::max);
    let (symbol, least) = match edge.kind {
        EdgeKind::Circle { .. } => ("θ", WANDERS),
        EdgeKind::Line => ("x", WANDERS_PART * widest),
    };
    let away = |at: f64| match edge.kind {
        EdgeKind::Circle { .. } => wrapped(at - from).abs(),
        EdgeKind::Line => (at - from).abs(),
    };
    let points = steps.iter().map(|step| step.bearing).enumerate();
    let points = points.filter_map(|(step, at)| Some((step, at?)));
    let (farthest, at) =
        points.max_by(|a, b| away(a.1).total_cmp(&away(b.1)).then(b.0.cmp(&a.0)))?;
    let show = |at: f64| match edge.kind {
        EdgeKind::Circle { .. } => {
            format!("{symbol} = {:.1}°", wrapped(at).to_degrees()).replace('-', "−")
        }
        EdgeKind::Line => format!("{symbol} = {}", scene.display.length.show(at)),
    };
    (away(at) > least).then(|| {
        let measured = match edge.kind {
            EdgeKind::Circle { .. } => "Angles φ are counted from the latter",
            EdgeKind::Line => "Places x are counted from x = 0",
        };
        format!(
            "The bearing point of contact '{}' wanders: it is at {} in load step {} and at {} in load step {}, where the contact force is \
             largest. {measured}; stick, slip and friction of a step refer to the step's own bearing point, which summary.json and \
             steps.csv give.",
            edge.name,
            show(at),
            farthest + 1,
            show(from),
            step + 1,
        )
    })
}

/// Says that reserve factors multiply interference too.
pub(super) fn of_reserve(scene: &Scene) -> Option<String> {
    let pressed = scene.contacts.iter().filter(|contact| contact.interference);
    let names = quoted(pressed.map(|contact| contact.name.as_str()));
    (scene.failure.is_some() && !names.is_empty()).then(|| {
        format!(
            "Reserve factors multiply the interference of {names} with the loads: a load of first failure beyond the last step is no prediction. \
             Raise the loads until a reserve factor falls to 1."
        )
    })
}

/// Says which bodies move as a whole without resistance, so that where they stand is not unique.
pub(super) fn of_freedom(model: &Model, interface: &Interface) -> Vec<String> {
    let of_part = |part: &Part| {
        let (bodies, pairs) = (&part.group().bodies, &part.group().pairs);
        let numbered = |free: FreeBody| FreeBody {
            body: bodies[free.body],
            slipping: free.slipping.iter().map(|&own| pairs[own]).collect(),
            ..free
        };
        let free = free_bodies(part.problem());
        moving_freely(model, &free.into_iter().map(numbered).collect::<Vec<_>>())
    };
    interface.parts().iter().flat_map(of_part).collect()
}

/// The same of bodies that are linked by contact.
fn moving_freely(model: &Model, free: &[FreeBody]) -> Vec<String> {
    let (slipping, together): (Vec<_>, Vec<_>) =
        free.iter().partition(|body| !body.slipping.is_empty());
    let mut notes: Vec<String> = slipping.iter().map(|body| freely(model, body)).collect();
    if !together.is_empty() {
        notes.push(format!(
            "Nothing holds {} against turning or sliding together, as one rigid body: displacements hold up to that motion, which changes no stress and no slip.",
            quoted(together.iter().map(|body| &*model.bodies[body.body].name))
        ));
    }
    notes
}

fn freely(model: &Model, free: &FreeBody) -> String {
    let (verb, motion) = if free.turns {
        ("turn", "rotation")
    } else {
        ("slide", "translation")
    };
    format!(
        "Body '{}' can {verb} freely: its {motion} and CSLIP1 on {} are not unique.",
        model.bodies[free.body].name,
        quoted(free.slipping.iter().map(|&pair| &*model.pairs[pair].name))
    )
}

/// "'a', 'b' and 'c'".
pub fn quoted<'a>(names: impl Iterator<Item = &'a str>) -> String {
    let mut names: Vec<String> = names.map(|name| format!("'{name}'")).collect();
    let last = names.pop().unwrap_or_default();
    if names.is_empty() {
        last
    } else {
        format!("{} and {last}", names.join(", "))
    }
}

/// The numbers of the steps that are so, counted from 1, runs shortened: "2–5, 9"; `None` if none is.
pub(super) fn steps_where<T>(steps: &[T], is_so: impl Fn(&T) -> bool) -> Option<String> {
    let which: Vec<usize> = (0..steps.len()).filter(|&k| is_so(&steps[k])).collect();
    let runs = which.chunk_by(|a, b| a + 1 == *b);
    let shown = runs.map(|run| match run {
        [] => String::new(),
        [only] => format!("{}", only + 1),
        [first, .., last] => format!("{}–{}", first + 1, last + 1),
    });
    (!which.is_empty()).then(|| shown.collect::<Vec<_>>().join(", "))
}
