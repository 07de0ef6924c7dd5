//! Findings as sentences for a reader, and as entries of `summary.json`.

mod contact;
mod free;
mod joint;
mod lists;
mod points;

use lists::listed;
pub(super) use lists::load_steps;
pub use lists::quoted;
use std::collections::BTreeMap;

use serde::Serialize;
use serde_json::{Map, Value, json};
use stickslip_results::{
    CoarseLoadPath, ContactFinding, CutBackEffect, FailedSolver, Finding, FurtherSolvers,
    LadderEnd, Quantity, Results, SolverDependence, StatusCycle, UniquenessBound, Yield,
};
use stickslip_scene::schema::DisplayUnits;
use stickslip_scene::shape::FileNote;
use stickslip_scene::units::Unit;
use stickslip_text::{short, tidy};

pub use joint::joint_sentence;

/// `finding` as a sentence or some, with lengths in `units`.
pub fn sentence(finding: &Finding, units: DisplayUnits) -> String {
    match finding {
        Finding::PointsInDoubt { steps, points } => format!(
            "The answer is not unique in {}: up to {points} contact points stick with a traction between the dynamic and the \
             static bound, where slip at the dynamic traction would be admissible too. They were taken to stick because they had \
             not slipped before.",
            load_steps(steps)
        ),
        Finding::Unverified {
            steps,
            solvers,
            residual,
        } => format!(
            "The answer is not verified in {}: {} left a residual of up to {residual:.1e} in the conditions of contact and friction, where \
             verified answers have less than 1e-10.",
            load_steps(steps),
            quoted(solvers)
        ),
        Finding::FurtherSolvers(found) => further_solvers(found),
        Finding::SeveralSolutions { steps, solutions } => format!(
            "The answer is not unique in {}: an increment has up to {solutions} solutions with the same loads. That was taken \
             whose statuses differ least from the last accepted ones, and of equal ones that which moves least.",
            load_steps(steps)
        ),
        Finding::NearUniquenessBound(bound) => near_bound(bound),
        Finding::CutBack { steps, effect } => cut_back(steps, *effect),
        Finding::CoarseLoadPath(coarse) => coarse_load_path(coarse),
        Finding::LoadPathUnchecked { steps } => format!(
            "Whether friction depends on the number of increments was not checked in {}: that takes too much work or was not solved. \
             Set analysis.substeps to more and compare.",
            load_steps(steps)
        ),
        Finding::SolverDependent(other) => solver_dependent(other),
        Finding::NoOtherSolver {
            too_dear,
            limit,
            unsolved,
        } => no_other_solver(too_dear, *limit, unsolved),
        Finding::Unbalanced {
            steps,
            residual,
            usual,
        } => unbalanced(steps, *residual, *usual),
        Finding::MeshFile { body, notes } => mesh_file(body, notes, units.length),
        Finding::MovedIntoHole {
            body,
            hole,
            distance,
        } => format!(
            "'{body}' was moved by {} into {hole}, which holds it: its file puts it somewhere else.",
            units.length.show(distance.value())
        ),
        Finding::PointSupports { bodies } => points::supports(&quoted(bodies), bodies),
        Finding::PointDisplacements { bodies, loads } => {
            points::displacements([&quoted(loads), &quoted(bodies)], bodies)
        }
        Finding::SetsWithoutErrors { bodies } => points::without_errors(&quoted(bodies)),
        Finding::PointLoads { loads } => points::loads(&quoted(loads)),
        Finding::NoLimitAtSupport { edge, steps } => points::support_end(edge, &load_steps(steps)),
        Finding::NoValueAtLoadEnd { edge, steps } => points::load_end(edge, &load_steps(steps)),
        Finding::NoLimitAtReentrantCorner {
            edge,
            steps,
            angle,
            exponent,
        } => points::reentrant(edge, &load_steps(steps), *angle, *exponent),
        Finding::EccentricLayers { fasteners } => format!(
            "Plates pull at {} at different heights: the moment of these forces would bend plates and fasteners out of the plane, as in every single \
             lap. It is stated as tilting moment and resisted by nothing here, so pressure is even across each plate and no plate gives by bending.",
            quoted(fasteners)
        ),
        Finding::GeometryLeftOut { why } => {
            format!("Stated errors leave out what the displacements change in the gaps: {why}.")
        }
        Finding::GeometryUnchecked { why } => geometry_unchecked(why),
        Finding::AccuracyUnstated { numbers } => accuracy_unstated(numbers),
        Finding::AccuracyMissed { number, error, end } => accuracy_missed(number, *error, *end),
        Finding::ContactParts { steps } => format!(
            "In an increment of {} contact parts and bears elsewhere: what the bodies travel in between counts as slip, and friction has \
             the direction of that way. Where the load turns around, give a step without load in between (steps = [\"1 kN\", \"0 N\", \"-1 kN\"]), from \
             which only the way under force counts.",
            load_steps(steps)
        ),
        Finding::FreeBody(own) => free::body(own, &quoted(&own.contacts)),
        Finding::FreeTogether { bodies, motions } => free::together(&quoted(bodies), motions),
        Finding::ReserveWithInterference { contacts } => format!(
            "Reserve factors multiply the interference of {} with the loads: a load of first failure beyond the last step is no prediction. \
             Raise the loads until a reserve factor falls to 1.",
            quoted(contacts)
        ),
        Finding::Yields(found) => yields(found, units),
        Finding::LargeStrains { body, step, strain } => format!(
            "Stresses on the contact edge of '{body}' in load step {step} are {:.0} % of its modulus, and strains of that size are neither small nor \
             elastic: check the units of loads, moduli and lengths.",
            100.0 * strain
        ),
        Finding::Contact { contact, finding } => contact::sentence(contact, finding, units),
    }
}

/// The sentences of all findings of `results`; contacts that leave their bodies loose in the same load steps share one.
pub fn sentences(results: &Results) -> Vec<String> {
    let mut loose: BTreeMap<&[usize], Vec<&str>> = BTreeMap::new();
    for finding in &results.findings {
        if let Some((contact, steps)) = as_loose(finding) {
            loose.entry(steps).or_default().push(contact);
        }
    }
    let sentence = |finding| match as_loose(finding) {
        Some((_, steps)) => Some(contact::gaps(&loose.remove(steps)?, steps)),
        None => Some(sentence(finding, results.units)),
    };
    results.findings.iter().filter_map(sentence).collect()
}

/// The contact and the load steps of a finding that bodies are loose.
fn as_loose(finding: &Finding) -> Option<(&str, &[usize])> {
    match finding {
        Finding::Contact {
            contact,
            finding: ContactFinding::GapsUndetermined { steps, .. },
        } => Some((contact, steps)),
        _ => None,
    }
}

fn unbalanced(steps: &[usize], residual: f64, usual: f64) -> String {
    format!(
        "Forces balance to {residual:.1e} of the load only in {}, where {usual:.0e} is usual: rounding errors have grown, and results may be off by \
         thirty times that part. Cells many times longer than wide, bodies many times longer than their contact, and thermal strains far above \
         those of the load cause it.",
        load_steps(steps)
    )
}

fn geometry_unchecked(why: &str) -> String {
    format!(
        "What the displacements change in the gaps is not known: the model on the deformed geometry gave no answer ({why}). No errors are \
         stated; the loads may be too large for small displacements. With analysis.kinematics = \"small\" the undeformed geometry is asked \
         about, and has errors."
    )
}

fn accuracy_unstated(numbers: &[&str]) -> String {
    format!(
        "The accuracy asked for is not known to be reached: no error can be stated of {}. Other notes say why, or the scene has no such number; \
         bound other numbers (analysis.accuracy = {{ peak_pressure = … }}), or compare with a finer mesh.",
        listed(numbers.iter().map(|own| format!("the {own}")).collect())
    )
}

fn accuracy_missed(number: &str, error: f64, end: LadderEnd) -> String {
    let why = match end {
        LadderEnd::Budget => {
            "a finer model does not fit in the budget: raise analysis.budget, beside analysis.accuracy"
        }
        LadderEnd::Memory => {
            "a finer model does not fit in the memory that it may take: raise analysis.memory (4 GB where it is not given), or ask for less"
        }
        LadderEnd::Pinned => {
            "the scene prescribes its model: leave out its mesh or contact_nodes, or divide it more finely"
        }
        LadderEnd::LoadPath => {
            "what the increments of load steps leave is nearly all of it, so that no finer nodes are tried: ask for less, or for the numbers that matter \
             (analysis.accuracy = { peak_pressure = … }), or prescribe more increments (analysis.substeps, with analysis.ramp = \"contact\")"
        }
        LadderEnd::Reached | LadderEnd::Finest | LadderEnd::Unchecked | LadderEnd::Unstated => {
            "no finer model is tried: ask for less, or for the numbers that matter (analysis.accuracy = { peak_pressure = … })"
        }
    };
    format!(
        "The accuracy asked for is not reached: the error of the {number} is {:.2} %, and {why}. Stated errors are those of this model.",
        100.0 * error
    )
}

fn yields(found: &Yield, units: DisplayUnits) -> String {
    let stress = |quantity: Quantity| {
        let unit = units.stress;
        format!("{} {}", short(unit.from_base(quantity.value())), unit.name)
    };
    let [x, y] = found.at.map(|at| {
        let unit = units.length;
        format!("{} {}", short(unit.from_base(at.value())), unit.name)
    });
    format!(
        "Body '{}' yields: in load step {} its von Mises stress of {} exceeds the yield stress of {} at x = {x}, y = {y}; it does so in {}. All \
         results are those of an elastic body.",
        found.body,
        found.step,
        stress(found.von_mises),
        stress(found.yield_stress),
        load_steps(&found.steps)
    )
}

fn further_solvers(found: &FurtherSolvers) -> String {
    let counted = |entry: &FailedSolver| {
        let FailedSolver {
            solver,
            reason,
            count,
        } = entry;
        format!("{solver}: {reason} (×{count})")
    };
    let failed: Vec<String> = found.failed.iter().map(counted).collect();
    let cycle = found.cycle.map_or_else(String::new, |cycle| {
        let StatusCycle { period, points } = cycle;
        format!(
            " In the first cycle the statuses of {points} points repeated with period {period}."
        )
    });
    format!(
        "More than the first solver was needed in {}: {}.{cycle}",
        load_steps(&found.steps),
        failed.join(", ")
    )
}

fn near_bound(bound: &UniquenessBound) -> String {
    let &UniquenessBound {
        step,
        friction,
        estimate,
        ..
    } = bound;
    let beyond = friction > estimate;
    let relation = if beyond { "beyond" } else { "near" };
    let counted = match bound.solutions {
        Some(1) => "enumeration found no other with the same points in contact".into(),
        Some(count) => format!("{count} were found by enumeration of the points in contact"),
        None if bound.other_solver_asked => {
            "they were not enumerated, but another solver was tried".into()
        }
        None if beyond => "they were not enumerated, because too many points touch".into(),
        None => "none was looked for".into(),
    };
    format!(
        "Friction of up to {friction:.3} is {relation} {estimate:.3}, the estimate of the coefficient of friction up to which load step {step} \
         (where contact is largest) is unique. There may be further solutions; {counted}."
    )
}

fn cut_back(steps: &[usize], effect: CutBackEffect) -> String {
    let effect = match effect {
        CutBackEffect::Frictionless => String::new(),
        CutBackEffect::Unknown => {
            " Whether that changed the answer is not known: smaller increments were not solved."
                .to_owned()
        }
        CutBackEffect::Nothing => {
            " That changed nothing: smaller increments give the same answer.".to_owned()
        }
        CutBackEffect::Slip {
            step,
            increments,
            slip_change,
            dissipation_change,
        } => format!(
            " Smaller increments give the same tractions. Slip counts from the increment in which a point closes: in {increments} increments CSLIP1 of \
             load step {step} changes by up to {} of its largest, the work of friction by {}.",
            percent(slip_change),
            percent(dissipation_change)
        ),
        CutBackEffect::Tractions {
            step,
            increments,
            peak_pressure_change,
            traction_change,
        } => format!(
            " The answer depends on the path: in {increments} increments the largest pressure of load step {step} changes by {}, \
             tractions by up to {} of it.",
            percent(peak_pressure_change),
            percent(traction_change)
        ),
    };
    format!(
        "The increment was cut back in {}.{effect}",
        load_steps(steps)
    )
}

fn coarse_load_path(coarse: &CoarseLoadPath) -> String {
    /// Part of the largest pressure below which a change is rounding.
    const ROUNDING: f64 = 1e-6;
    let work = percent(coarse.dissipation_change);
    let changes = if coarse.traction_change > ROUNDING {
        format!(
            "tractions of load step {} change by up to {} of the largest pressure, the work of friction by {work}, and stick and slip with them",
            coarse.step,
            percent(coarse.traction_change)
        )
    } else {
        format!(
            "tractions of load step {} stay, but the work of friction changes by {work}, and slip with it",
            coarse.step
        )
    };
    format!(
        "The answer depends on the number of increments in {}: with four times as many where the load path begins or turns, {changes}. Set analysis.substeps to more, or leave it out and ask for an \
         analysis.accuracy.",
        load_steps(&coarse.steps),
    )
}

fn solver_dependent(other: &SolverDependence) -> String {
    format!(
        "The answer depends on the solver in {}: from the same state before the step, {} finds another one that meets \
         all contact conditions. In load step {} its largest pressure differs by {}, tractions by up to {} of it.",
        load_steps(&other.steps),
        other.solver,
        other.step,
        percent(other.peak_pressure_change),
        percent(other.traction_change)
    )
}

fn no_other_solver(too_dear: &[usize], limit: f64, unsolved: &[usize]) -> String {
    let mut reasons = Vec::new();
    if !too_dear.is_empty() {
        reasons.push(format!(
            "{} would take more work than comparisons of a history may, {limit:.0e} operations",
            load_steps(too_dear)
        ));
    }
    if !unsolved.is_empty() {
        reasons.push(format!(
            "the other solver did not solve {}",
            load_steps(unsolved)
        ));
    }
    format!(
        "Whether another solver finds another answer is not known where friction, cut-back or loose contact allow one: {}.",
        reasons.join("; ")
    )
}

fn mesh_file(body: &str, notes: &[FileNote], unit: &Unit) -> String {
    let notes: Vec<String> = notes.iter().map(|note| note.text(unit)).collect();
    format!("The mesh of '{body}': {}.", notes.join("; "))
}

/// A part in percent with two digits.
fn percent(part: f64) -> String {
    let value = 100.0 * part;
    let size = value.abs();
    let digits = if size > 0.0 && size < 10.0 {
        (1.0 - size.log10().floor()).clamp(0.0, 8.0) as usize
    } else {
        0
    };
    format!("{value:.digits$} %").replace('-', "−")
}

/// A finding in `summary.json`: its kind first, then its numbers, quantities in display units.
#[derive(Debug, Serialize)]
pub(super) struct Entry {
    kind: Option<Value>,
    #[serde(flatten)]
    fields: Map<String, Value>,
}

/// `findings` as entries of `summary.json`, with quantities in `units`.
pub(super) fn entries<T: Serialize>(findings: &[T], units: DisplayUnits) -> Vec<Entry> {
    let entry = |finding: &T| {
        let mut fields = match serde_json::to_value(finding) {
            Ok(value) => match displayed(value, units) {
                Value::Object(fields) => fields,
                _ => Map::new(),
            },
            Err(_) => Map::new(),
        };
        Entry {
            kind: fields.remove("kind"),
            fields,
        }
    };
    findings.iter().map(entry).collect()
}

/// `findings` as the entry `findings` of `summary.json`, with quantities in `units`.
pub fn findings_json(findings: &[Finding], units: DisplayUnits) -> Value {
    json!(entries(findings, units))
}

/// `value` with at most twelve digits, its lengths in `units` and its angles in degrees.
fn displayed(value: Value, units: DisplayUnits) -> Value {
    match value {
        Value::Number(number) if number.is_f64() => json!(number.as_f64().and_then(tidy)),
        Value::Array(values) => {
            let values = values.into_iter().map(|value| displayed(value, units));
            values.collect()
        }
        Value::Object(fields) => {
            let number = fields.get("value").and_then(Value::as_f64);
            let (value, unit) = match fields.get("unit").and_then(Value::as_str) {
                Some("mm") => (
                    number.map(|mm| units.length.from_base(mm)),
                    units.length.name,
                ),
                Some("rad") => (number.map(f64::to_degrees), "deg"),
                Some("MPa") => (
                    number.map(|stress| units.stress.from_base(stress)),
                    units.stress.name,
                ),
                _ => {
                    let fields = fields.into_iter();
                    let fields = fields.map(|(key, value)| (key, displayed(value, units)));
                    return Value::Object(fields.collect());
                }
            };
            json!({ "unit": unit, "value": value.and_then(tidy) })
        }
        other => other,
    }
}
