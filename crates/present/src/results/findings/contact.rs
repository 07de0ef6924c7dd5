//! Findings about one contact as sentences.

use stickslip_results::{ContactFinding, Quantity};
use stickslip_scene::schema::DisplayUnits;

use super::{load_steps, quoted};
use stickslip_text::short;

/// Part of its size to which a contact may reach in a half-plane.
const FAR: f64 = 0.25;

/// `finding` about the contact `name` as a sentence or some, with lengths in `units`.
pub(super) fn sentence(name: &str, finding: &ContactFinding, units: DisplayUnits) -> String {
    match finding {
        ContactFinding::UnequalThickness { bodies, thickness } => {
            unequal_thickness(name, bodies, *thickness, units)
        }
        ContactFinding::WideClearance { clearance } => format!(
            "Contact '{name}': the clearance is {:.0} % of the hole's radius. Points are paired at equal angles on the two circles, so \
             away from θ = 0 their places along the contact differ by as much.",
            100.0 * clearance
        ),
        ContactFinding::FittedRadius {
            edge,
            off,
            clearance,
        } => fitted_radius(name, edge, [*off, *clearance], units),
        ContactFinding::OtherRadius {
            edge,
            given,
            fitted,
            off,
        } => other_radius(name, edge, [*given, *fitted, *off], units),
        ContactFinding::BeyondFineMesh {
            step,
            end,
            both_ends,
            limit,
        } => beyond_fine_mesh(name, *step, [*end, *limit], *both_ends, units),
        ContactFinding::BeyondFacing { step, at } => format!(
            "Contact '{name}' reaches {} = {} in load step {step}, where its edges cease to face each other before the first one ends: contact beyond is not found. \
             Let the second edge go on there, or make it the first.",
            symbol(*at),
            shown(*at, units)
        ),
        ContactFinding::BearingPointWanders {
            step,
            at,
            largest_step,
            largest_at,
        } => wanders(name, [*step, *largest_step], [*at, *largest_at], units),
        ContactFinding::Unresolved { steps, nodes } => format!(
            "The mesh does not resolve contact '{name}' in {}: it touches along less than two element edges, at fewest at {nodes} \
             {}. Its peak pressure, half-width and stresses nearby depend on the mesh; its resultant holds. Reduce mesh.spacing.",
            load_steps(steps),
            if *nodes == 1 { "node" } else { "nodes" }
        ),
        ContactFinding::PeakUnresolved { steps, nodes } => format!(
            "The mesh does not resolve the largest pressure of contact '{name}' in {}: it is more than half as large at {nodes} {} only. \
             That pressure and stresses nearby depend on the mesh, and no error of it is known. Give the edge there more `refine`, or reduce mesh.spacing.",
            load_steps(steps),
            if *nodes == 1 { "node" } else { "nodes" }
        ),
        ContactFinding::NoLimit { steps, numbers: of } => format!(
            "No error is stated for the {} of contact '{name}' in {}: friction jumps from one direction or one value to another at a point, \
             stress there grows without limit, like the logarithm of the spacing, and the value is that of this division.",
            of.join(" and the "),
            load_steps(steps)
        ),
        ContactFinding::NoLimitAtCorner { steps, at } => {
            let places: Vec<String> = at
                .iter()
                .map(|&at| format!("s = {}", shown(at, units)))
                .collect();
            format!(
                "A corner presses at {} of contact '{name}' in {}: in the linear model pressure and stress grow without limit towards it, and the largest of \
                 them are those of this mesh, without an error. Resultants hold. Round the corner to get a limit.",
                places.join(" and "),
                load_steps(steps)
            )
        }
        ContactFinding::PairsApart {
            steps,
            apart,
            spacing,
        } => format!(
            "On the deformed geometry nodes of contact '{name}' are paired in {} with nodes up to {} from the place that they face, where nodes are \
             {} apart. Pressure and stress are smeared over that distance at the ends of contact, and the peak of the stress may be some percent too low. Leave \
             out the mesh, ask for an accuracy of half a model (analysis.accuracy), or widen mesh.spacing.",
            load_steps(steps),
            shown(*apart, units),
            shown(*spacing, units)
        ),
        ContactFinding::OutlineLeftOut {
            step,
            reach,
            size,
            radius,
        } => outline(name, *step, [*reach, *size], *radius, units),
        ContactFinding::RipplingPressures {
            bodies,
            nodes,
            stiffness_ratio,
        } => ripples(name, bodies, *nodes, *stiffness_ratio),
        ContactFinding::GapsUndetermined { steps, .. } => gaps(&[name], steps),
        ContactFinding::SlipUndetermined { bodies, steps } => slip(name, bodies, steps),
    }
}

/// A contact ends in `step` at `end`, beyond the `limit` of its fine mesh.
fn beyond_fine_mesh(
    name: &str,
    step: usize,
    [end, limit]: [Quantity; 2],
    both_ends: bool,
    units: DisplayUnits,
) -> String {
    let at = if both_ends {
        format!("±{}", shown(end.abs(), units))
    } else {
        format!("{} = {}", symbol(end), shown(end, units))
    };
    format!(
        "Contact '{name}' ends at {at} in load step {step}, beyond the fine part of its mesh, which ends at ±{}: stresses near that end are as \
         accurate as the coarser mesh there. mesh.fine_to moves the limit.",
        shown(limit, units)
    )
}

/// The radius of `edge` is fitted to nodes that are `off` it.
fn fitted_radius(
    name: &str,
    edge: &str,
    [off, clearance]: [Quantity; 2],
    units: DisplayUnits,
) -> String {
    let kind = if clearance.value() < 0.0 {
        "an interference"
    } else {
        "a clearance"
    };
    format!(
        "Contact '{name}' has {kind} of {}, and the radius of '{edge}' is that of the best circle through corner nodes up to {} off it: where \
         and how hard it presses depends on what the true radius is. Give it in `radii` of the mesh.",
        shown(clearance.abs(), units),
        shown(off, units)
    )
}

/// The radius of `edge` is `given` as another one than that `fitted` to its nodes.
fn other_radius(
    name: &str,
    edge: &str,
    [given, fitted, off]: [Quantity; 3],
    units: DisplayUnits,
) -> String {
    let off = match off {
        Quantity::Length(off) if off > 0.0 => format!("within {} of", units.length.show(off)),
        _ => "on".to_owned(),
    };
    format!(
        "Contact '{name}': the radius {} that is given for '{edge}' is not that of its nodes, which lie {off} a circle of radius {}. The mesh was moved onto the \
         given one. Correct `radii`, or make the mesh again with it.",
        shown(given, units),
        shown(fitted, units)
    )
}

fn unequal_thickness(
    name: &str,
    [first, second]: &[String; 2],
    thickness: [Quantity; 2],
    units: DisplayUnits,
) -> String {
    let [one, other] = thickness.map(|thickness| shown(thickness, units));
    format!(
        "Contact '{name}': '{first}' is {one} thick and '{second}' {other}. CPRESS and CSHEAR1 are forces over the first one's thickness, and each body \
         carries them evenly over its own."
    )
}

/// Blocks of several proportions have a peak pressure of 1 + 0.14 to 0.40 (a/d)² times that of half-planes, and 0.29 to 0.47 P/td more stress along the edge, which is 0.45 to 0.74 p₀ a/d
/// (`xtask/src/validate/half_planes.rs`).
fn outline(
    name: &str,
    step: usize,
    [reach, size]: [Quantity; 2],
    radius: Option<Quantity>,
    units: DisplayUnits,
) -> String {
    let part = reach.value() / size.value();
    let [pressure, stress] =
        [40.0 * part * part, 75.0 * part].map(|change| format!("{} %", short(change)));
    let change = if part > FAR {
        "The outline matters here: say model = \"elements\" of both bodies.".to_owned()
    } else {
        format!(
            "The peak pressure of pressed blocks of that size is up to {pressure} higher, their contact as much narrower, and the stress along the edge up to \
             {stress} of the peak pressure higher."
        )
    };
    let curved = radius.map_or_else(String::new, |radius| {
        let part = short(100.0 * reach.value() / radius.value());
        format!(
            " Edges with a radius of {} against each other change the shear that pressing leaves by up to about {part} % of the peak pressure, and stick \
             with it, and the stress along the edge by up to twice that.",
            shown(radius, units)
        )
    });
    format!(
        "Contact '{name}' is one of half-planes. Errors contain neither what outlines nor what curved edges change: it reaches to {} in load step {step}, and half \
         length or depth of its bodies is {}. {change}{curved}",
        shown(reach, units),
        shown(size, units),
    )
}

fn wanders(
    name: &str,
    [step, largest_step]: [usize; 2],
    places: [Quantity; 2],
    units: DisplayUnits,
) -> String {
    let measured = match places[1] {
        Quantity::Angle(_) => "Angles φ are counted from the latter",
        Quantity::Length(_) | Quantity::Stress(_) => "Places x are counted from x = 0",
        Quantity::Along(_) => "Places s are counted from the middle of the edge",
    };
    let [at, largest_at] = places.map(|place| {
        let text = format!("{} = {}", symbol(place), shown(place, units));
        match place {
            Quantity::Angle(_) => text.replace('-', "−"),
            Quantity::Length(_) | Quantity::Along(_) | Quantity::Stress(_) => text,
        }
    });
    format!(
        "The bearing point of contact '{name}' moves: it is at {at} in load step {step} and at {largest_at} in load step {largest_step}, where the contact force is \
         largest. {measured}; stick, slip and friction of a step refer to the step's own bearing point, which summary.json and \
         steps.csv give."
    )
}

fn ripples(
    name: &str,
    [first, second]: &[String; 2],
    [finer, coarser]: [usize; 2],
    ratio: f64,
) -> String {
    format!(
        "Contact '{name}' has {finer} nodes of '{first}' on {coarser} of '{second}', which gives {ratio:.0} times as much and \
         cannot follow so many: pressures node by node are not unique and may open every other one. Their means over cells of \
         '{second}' and the resultant hold. Give '{first}' a mesh no finer than that of '{second}' along the contact."
    )
}

/// `contacts` leave their bodies loose in `steps`.
pub(super) fn gaps(contacts: &[&str], steps: &[usize]) -> String {
    let (who, press, whose) = match contacts {
        [one] => (format!("Contact '{one}'"), "presses", "its"),
        _ => (format!("Contacts {}", quoted(contacts)), "press", "their"),
    };
    format!(
        "{who} {press} at too few points, or at none, to hold {whose} bodies in an increment of {}: a rigid motion changes no force. \
         Where nothing presses them, they are shown where the surfaces have moved least against each other; COPEN, displacements and what \
         closes next follow from the place.",
        load_steps(steps)
    )
}

fn slip(name: &str, bodies: &[String; 2], steps: &[usize]) -> String {
    format!(
        "In an increment of {} no point of contact '{name}' sticks that would hold {} against a rigid motion along it, and \
         slip in a range has the same friction: CSLIP1 on '{name}' and displacements are one of many answers of equal right, and so is what follows \
         from them.",
        load_steps(steps),
        quoted(bodies)
    )
}

/// A length in display units, an angle in degrees.
fn shown(quantity: Quantity, units: DisplayUnits) -> String {
    match quantity {
        Quantity::Angle(angle) => format!("{:.1}°", angle.to_degrees()),
        Quantity::Length(length) | Quantity::Along(length) => units.length.show(length),
        Quantity::Stress(stress) => units.stress.show(stress),
    }
}

/// What a place along an edge is called.
fn symbol(place: Quantity) -> &'static str {
    match place {
        Quantity::Angle(_) => "θ",
        Quantity::Length(_) | Quantity::Stress(_) => "x",
        Quantity::Along(_) => "s",
    }
}
