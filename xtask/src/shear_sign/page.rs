//! The findings on shear in words, and the page.

use std::fmt::Write as _;

use super::case::{Phase, Plate, Row, Step};
use super::crack;
use super::curve::Reversal;
use super::plan::{COULOMB, DROPPING, FITS, LAYUPS, POWER, RELOADED, SWEPT, TANGENT};
use super::study::{SEEN, Study, of_report};
use super::tables::{changes, plate};
use crate::publish::Picture;

const FAMILIES: [&str; 7] = [COULOMB, DROPPING, POWER, SWEPT, TANGENT, LAYUPS, FITS];

/// "Coulomb, μ = 0.2 at 20 lb".
fn place(row: &Row, step: &Step) -> String {
    let plate = match row.case.plate {
        Plate::Smeared => ", smeared moduli",
        Plate::Plies | Plate::Layup(_) => "",
    };
    let family = if [COULOMB, DROPPING].contains(&row.case.family) {
        format!("{}, ", row.case.family)
    } else {
        String::new()
    };
    format!("{family}{}{plate}, at {} lb", row.case.name, step.load)
}

/// The largest reversed shear of loading, as part of the peak, among the rows that `wanted` takes.
fn largest<'a>(
    study: &'a Study,
    wanted: impl Fn(&Row) -> bool,
) -> Option<(&'a Row, &'a Step, Reversal)> {
    let rows = study.rows.iter().filter(|row| wanted(row));
    let reversed = rows.filter_map(|row| {
        let step = row.most_reversed()?;
        Some((row, step, step.reading.reversal?))
    });
    reversed.max_by(|a, b| a.2.of_peak.total_cmp(&b.2.of_peak))
}

/// What the study found about the sign of the shear, in sentences; the first is the answer.
pub(crate) fn findings(study: &Study) -> Vec<String> {
    let mut sentences = vec![answer(study)];
    sentences.extend(near_the_bearing_point(study));
    sentences.extend(other_joints(study));
    sentences.push(why(study));
    sentences.extend(unloading(study));
    sentences.extend(loading_again(study));
    sentences.extend(beneath(study));
    sentences.extend(refinement(study));
    sentences
}

fn answer(study: &Study) -> String {
    let own = |row: &&Row| row.is_of_the_report() && row.case.family != RELOADED;
    let seen = |row: &&Row| row.loading().any(Step::is_as_seen);
    let (all, reports) = (study.rows.len(), study.rows.iter().filter(own).count());
    let (seen_all, seen_reports) = (
        study.rows.iter().filter(seen).count(),
        study.rows.iter().filter(own).filter(seen).count(),
    );
    let head = if seen_all == 0 {
        "**No.** No friction law here reverses the shear where the report saw it".to_owned()
    } else {
        format!(
            "**In {seen_all} joints** (of them {seen_reports} with the report's plate, pin and clearance) it does"
        )
    };
    format!(
        "{head}: of {all} joints, {reports} of them with the report's plate, pin and clearance and any law, {seen_all} have shear on the \
         edge that changes its sign between {}° and {}° of the report while the load grows. Every law, fibre coverage with either \
         kernel included, leaves the whole slipping part of the edge pulled towards the bearing point.",
        SEEN[0], SEEN[1]
    )
}

fn near_the_bearing_point(study: &Study) -> Option<String> {
    let own = |row: &Row| row.is_of_the_report();
    let (far, far_step) = study.furthest(own)?;
    let (large, large_step, reversal) = largest(study, own)?;
    let loads = study.rows.iter().filter(|row| own(row));
    let loads = loads
        .flat_map(Row::loading)
        .filter(|step| step.is_reversed());
    let highest = loads.fold(0.0_f64, |most, step| step.load.max(most));
    let stick = if reversal.sticks { "sticks" } else { "slips" };
    Some(format!(
        "**What is reversed while the load grows**, with the report's joint: a part of the stick zone near the bearing point, at loads up \
         to {highest} lb and nowhere above. It ends at {:.0}° of the report or closer to the bearing point ({}); the reversed shear is at \
         most {:.0} % of the edge's peak and {:.0} % of what friction could carry there, so the edge {stick} ({}).",
        of_report(far_step.reading.reach()?),
        place(far, far_step),
        100.0 * reversal.of_peak,
        100.0 * reversal.of_limit,
        place(large, large_step),
    ))
}

fn other_joints(study: &Study) -> Option<String> {
    let extreme = |family: &'static str| {
        let (row, step) = study.furthest(|row| row.case.family == family)?;
        let (end, reach) = (
            of_report(step.reading.end),
            of_report(step.reading.reach()?),
        );
        Some(format!(
            "{reach:.0}° of the report ({}; contact ends at {end:.0}° there)",
            place(row, step)
        ))
    };
    let fits = |step: &&Step| step.is_reversed() && step.reading.end >= of_report(SEEN[1]);
    let wide = study.rows.iter().filter(|row| row.case.family == FITS);
    let wide: Vec<f64> = wide
        .flat_map(Row::loading)
        .filter(fits)
        .filter_map(|step| step.reading.reach())
        .collect();
    let closest = wide.iter().copied().fold(0.0, f64::max);
    Some(format!(
        "**Other joints.** A stiffer pin, more clearance and fibres across the load carry the reversed part further, because contact is \
         then narrow beside the hole for longer: in other lay-ups to {}, over clearance and pin to {}. Once contact itself reaches to 40° \
         of the report or beyond, the reversed part stays above {:.0}°. A pin softer than the plate has next to none.",
        extreme(LAYUPS)?,
        extreme(FITS)?,
        of_report(closest),
    ))
}

fn why(study: &Study) -> String {
    let (mut worst, mut unlike, mut pairs) = (0.0_f64, 0_usize, 0_usize);
    for smeared in study
        .rows
        .iter()
        .filter(|row| row.case.plate == Plate::Smeared)
    {
        let twin = |row: &&Row| {
            row.case.plate == Plate::Plies
                && row.case.family == smeared.case.family
                && row.case.name == smeared.case.name
        };
        let Some(own) = study.rows.iter().find(twin) else {
            continue;
        };
        pairs += 1;
        for (a, b) in own.steps.iter().zip(&smeared.steps) {
            unlike += usize::from(a.reading.pattern != b.reading.pattern);
            let both = a.reading.crossings.iter().zip(&b.reading.crossings);
            worst = both.fold(worst, |worst, (a, b)| worst.max((a - b).abs()));
        }
    }
    let moduli = if pairs == 0 {
        String::new()
    } else {
        format!(
            " Smeared moduli or those of the plies make no difference: in a membrane (0/60/−60) is isotropic. Over {pairs} laws and all \
             their load steps {unlike} signs differ, and places of change by at most {worst:.3}°."
        )
    };
    format!(
        "**Why.** Friction acts against slip, and on a hole that is loaded more and more the edge slips away from the bearing point on \
         either side from the first load on. Fibre coverage changes how large friction can become at an angle; it is a positive factor \
         and cannot turn it round.{moduli}"
    )
}

fn unloading(study: &Study) -> Option<String> {
    let mut rows = study.rows.iter();
    let row = rows.find(|row| row.case.family == COULOMB && row.case.name == "μ = 0.2")?;
    let steps = row
        .steps
        .iter()
        .filter(|step| step.phase == Phase::Unloading);
    let texts: Vec<String> = steps
        .map(|step| format!("{}° at {} lb", changes(step), step.load))
        .collect();
    Some(format!(
        "**Unloading** reverses every law's shear, from the end of contact inwards: the opposite of what the report saw, where the outer \
         part kept the sign of loading. With μ = 0.2 and from 1500 lb the change is at {}.",
        texts.join(", ")
    ))
}

fn loading_again(study: &Study) -> Option<String> {
    let mut texts = Vec::new();
    for row in study.rows.iter().filter(|row| row.case.family == RELOADED) {
        let again = row
            .steps
            .iter()
            .filter(|step| step.phase == Phase::Reloading && step.is_reversed());
        let found: Vec<String> = again
            .take(3)
            .map(|step| format!("{} lb: {}°", step.load, changes(step)))
            .collect();
        texts.push(format!("{} ({})", row.case.name, found.join(", ")));
    }
    if texts.is_empty() {
        return None;
    }
    Some(format!(
        "**What does give the report's pattern: loading again.** After 1500 lb, 300 lb and then more, the outer part of the edge has the \
         sign of loading and the part inside is still reversed, until the load nears the old one: changes of sign at {}. The report's loads \
         were found by iteration (its Fig. 8); whether any was approached from above it does not say.",
        texts.join("; ")
    ))
}

fn beneath(study: &Study) -> Option<String> {
    let deep = |depth: f64, load: f64| {
        let arcs = study
            .arcs
            .iter()
            .filter(move |arc| arc.depth == depth && arc.load == load);
        let texts: Vec<String> = arcs
            .map(|arc| {
                let (_, places) = arc.signs();
                let places: Vec<String> = places
                    .iter()
                    .rev()
                    .map(|&angle| format!("{:.0}°", of_report(angle)))
                    .collect();
                format!(
                    "{} (μ = {}, clearance {} in)",
                    places.join(" and "),
                    arc.joint.friction,
                    arc.joint.clearance
                )
            })
            .collect();
        texts.join(", ")
    };
    if study.arcs.is_empty() {
        return None;
    }
    Some(format!(
        "**And: distance from the edge.** Friction's shear decays within a thickness; beneath it lies the shear of the hole's own stress \
         field, of the opposite sign inside contact and of the same sign outside. So a little beneath the edge the report's pattern appears \
         while loading and with any law: forward at small angles, reversed from near the end of contact up to the bearing point. At 400 lb \
         the signs change, half a thickness beneath, at {}; 1.55 thicknesses beneath, the report's arc, at {}. Little friction and more \
         clearance bring the change near 30°. The report's surface stresses are extrapolated from points up to 0.2 thicknesses away.",
        deep(0.5, 400.0),
        deep(1.55, 400.0),
    ))
}

fn refinement(study: &Study) -> Option<String> {
    let reach = |row: &Row| {
        let furthest = row
            .furthest()
            .and_then(|step| Some((step.load, of_report(step.reading.reach()?))));
        furthest.map_or_else(
            || "none".to_owned(),
            |(load, angle)| format!("{angle:.1}° at {load} lb"),
        )
    };
    let texts: Vec<String> = study
        .refined
        .iter()
        .map(|own| {
            let seen = if own.fine.loading().any(Step::is_as_seen) {
                ", now as the report saw it"
            } else {
                ""
            };
            let (name, what) = (&own.coarse.case.name, own.what);
            format!(
                "{what}, {name}: {} becomes {}{seen}",
                reach(&own.coarse),
                reach(&own.fine)
            )
        })
        .collect();
    (!texts.is_empty()).then(|| {
        format!(
            "**Mesh and load steps.** Furthest extent while loading: {}. Shear that sticks keeps the marks of long steps.",
            texts.join("; ")
        )
    })
}

/// The page of the study.
pub(crate) fn page(study: &Study, pictures: &[Picture]) -> String {
    let mut text = format!(
        "<!-- Generated by `cargo xtask shear-sign`; do not edit. -->\n\n# The sign of the shear on a pin-loaded hole\n\n\
         Post and Reddy (*Friction Phenomenon in Contact Stress Problems*, 1988, part I, 6.3) measured a (0/60/−60) graphite-epoxy plate \
         loaded by an aluminium pin and found that the shear on the hole's edge changes its sign at about 30°, which it does not in an \
         aluminium plate. They suggested that friction varies with the fibres that the edge exposes. Here [their joint](../../scenes/pin-quasi-isotropic.toml) \
         is solved with every friction law of this program, {} joints in all, and asked whether any reverses the shear; and where matrix \
         cracks are to be expected (6.4).\n\n\
         **Angles and sign.** The report counts θ from the net section, its bearing point is 90°: θ = 90° − |θ here|. All angles below are \
         the report's unless said otherwise. The shear is τ = τ_rθ sgn θ (θ from the bearing point): positive, *forward*, where friction \
         pulls the plate's edge towards the bearing point; negative, *reversed*, where it pushes it away. In the report's drawing both \
         plates have negative shear from 0° to 30° on loading; that is *forward* here, because its aluminium plate keeps that sign up to \
         the bearing point. Shear below 0.1 % of its peak has no sign. Corner nodes stand every {}°.\n\n## Does a friction law reverse it?\n\n",
        study.rows.len(),
        study.plan.spacing,
    );
    for sentence in findings(study) {
        // Writing into a string does not fail.
        let _ = writeln!(text, "- {sentence}");
    }
    text.push_str("\n### While the load grows\n\nAngles of the report; part of the peak shear on the edge, and of friction's limit at the place.\n\n");
    text.push_str(&families(study));
    picture(
        &mut text,
        pictures,
        &["shear", "map", "reach", "again", "beneath"],
    );
    text.push_str("\n## Where are matrix cracks to be expected?\n\n");
    for sentence in crack::findings(study) {
        let _ = writeln!(text, "- {sentence}");
    }
    let _ = write!(text, "\n{}", crack::table(study));
    picture(&mut text, pictures, &["plies"]);
    text.push_str(
        "\nAll cases: [shear-sign.csv](shear-sign.csv), [beneath.csv](beneath.csv), [plies.csv](plies.csv). To repeat: `cargo xtask \
         shear-sign`, or `cargo xtask shear-sign --quick` for a few cases.\n",
    );
    text
}

fn picture(text: &mut String, pictures: &[Picture], names: &[&str]) {
    for picture in pictures
        .iter()
        .filter(|picture| names.contains(&picture.name))
    {
        // Writing into a string does not fail.
        let _ = write!(text, "\n![{}]({}.png)\n", picture.alternative, picture.name);
    }
}

fn families(study: &Study) -> String {
    let mut text = String::from(
        "| family | plate | joints | as the report saw it | with some reversed shear | up to | furthest from the bearing point | largest reversed shear |\n\
         | --- | --- | --- | --- | --- | --- | --- | --- |\n",
    );
    for family in FAMILIES {
        for plates in [Plate::Plies, Plate::Smeared, Plate::Layup("others")] {
            let alike = std::mem::discriminant(&plates);
            let own = |row: &Row| {
                row.case.family == family && std::mem::discriminant(&row.case.plate) == alike
            };
            let rows: Vec<&Row> = study.rows.iter().filter(|row| own(row)).collect();
            if rows.is_empty() {
                continue;
            }
            let count = |wanted: fn(&Step) -> bool| {
                rows.iter().filter(|row| row.loading().any(wanted)).count()
            };
            let reversed = rows
                .iter()
                .flat_map(|row| row.loading())
                .filter(|step| step.is_reversed());
            let highest = reversed.fold(0.0_f64, |most, step| step.load.max(most));
            let far = study.furthest(own).map_or_else(
                || "–".to_owned(),
                |(row, step)| {
                    let reach = step.reading.reach().map_or(90.0, of_report);
                    format!("{reach:.0}°: {} at {} lb", row.case.name, step.load)
                },
            );
            let large = largest(study, own).map_or_else(
                || "–".to_owned(),
                |(row, step, reversal)| {
                    let (peak, limit) = (100.0 * reversal.of_peak, 100.0 * reversal.of_limit);
                    format!(
                        "{peak:.0} % of the peak, {limit:.0} % of the limit: {} at {} lb",
                        row.case.name, step.load
                    )
                },
            );
            let shown = if alike == std::mem::discriminant(&Plate::Layup("")) {
                "see the law"
            } else {
                plate(plates)
            };
            // Writing into a string does not fail.
            let _ = writeln!(
                text,
                "| {family} | {shown} | {} | {} | {} | {highest} lb | {} | {} |",
                rows.len(),
                count(Step::is_as_seen),
                count(Step::is_reversed),
                far.replace('|', "/"),
                large.replace('|', "/"),
            );
        }
    }
    text
}
