//! The findings on the sign of the shear in words.

use super::case::{Phase, Plate, Row, Step};
use super::curve::{Pattern, Reversal};
use super::plan::{COULOMB, DROPPING, FITS, LAYUPS, RELOADED};
use super::study::{SEEN, Study, of_report};
use super::tables::changes;

/// "Coulomb, μ = 0.2, at 20 lb".
fn place(row: &Row, step: &Step) -> String {
    let family = if [COULOMB, DROPPING].contains(&row.case.family) {
        format!("{}, ", row.case.family)
    } else {
        String::new()
    };
    format!("{family}{}, at {} lb", row.case.name, step.load)
}

/// The largest reversed shear of loading, as part of the peak, among the rows that `wanted` takes.
pub(crate) fn largest(
    study: &Study,
    wanted: impl Fn(&Row) -> bool,
) -> Option<(&Row, &Step, Reversal)> {
    let rows = study.rows.iter().filter(|row| wanted(row));
    let reversed = rows.filter_map(|row| {
        let step = row.most_reversed()?;
        Some((row, step, step.reading.reversal?))
    });
    reversed.max_by(|a, b| a.2.of_peak.total_cmp(&b.2.of_peak))
}

/// All findings, in sentences; the first is the answer.
pub(crate) fn all(study: &Study) -> Vec<String> {
    let mut sentences = vec![answer(study)];
    sentences.extend(near_the_bearing_point(study));
    sentences.extend(other_joints(study));
    sentences.extend(everywhere(study));
    sentences.push(why(study));
    sentences.extend(unloading(study));
    sentences.extend(loading_again(study));
    sentences.extend(beneath(study));
    sentences.extend(refinement(study));
    sentences
}

fn answer(study: &Study) -> String {
    let own = |row: &&Row| row.is_of_the_report();
    let seen = |row: &&Row| row.loading().any(Step::is_as_seen);
    let (all, reports) = (study.rows.len(), study.rows.iter().filter(own).count());
    let (among_all, among_reports) = (
        study.rows.iter().filter(seen).count(),
        study.rows.iter().filter(own).filter(seen).count(),
    );
    let head = if among_all == 0 {
        "**No.** No friction law of this program reverses the shear where the report saw it"
            .to_owned()
    } else {
        format!(
            "**In {among_all} joints**, {among_reports} of them with the report's plate, pin and clearance, it is reversed where the report saw it"
        )
    };
    let count = if among_all == 0 {
        "none".to_owned()
    } else {
        among_all.to_string()
    };
    format!(
        "{head}. Of {all} joints, {reports} with the report's plate, pin and clearance under all laws and the others with other lay-ups, \
         clearances and pins, {count} has shear on the edge that changes its sign between {}° and {}° of the report while the load grows. \
         Reversed shear beyond 30° there is, but only near the bearing point, as the next items say.",
        SEEN[0], SEEN[1]
    )
}

fn near_the_bearing_point(study: &Study) -> Option<String> {
    let own = |row: &Row| row.is_of_the_report();
    let plies = |row: &Row| own(row) && row.case.plate == Plate::Plies;
    let (far, far_step) = study.furthest(plies)?;
    let (large, large_step, reversal) = largest(study, plies)?;
    let rows = study.rows.iter().filter(|row| own(row));
    let steps: Vec<&Step> = rows
        .flat_map(Row::loading)
        .filter(|step| step.is_reversed())
        .collect();
    let highest = steps.iter().fold(0.0_f64, |most, step| step.load.max(most));
    let slipping = steps
        .iter()
        .filter(|step| step.reading.reversal.is_some_and(|own| !own.sticks))
        .count();
    let stick = match slipping {
        0 => "the points with the largest of it stick in every case".to_owned(),
        count => format!(
            "the point with the largest of it slips in {count} of {} load steps and sticks in the others",
            steps.len()
        ),
    };
    Some(format!(
        "**What is reversed while the load grows**, with the report's joint: a part of the edge near the bearing point, at loads up to \
         {highest} lb and nowhere above. Going from the bearing point at 90° it ends at {:.0}° or before ({}). The reversed shear is at \
         most {:.0} % of the edge's peak, and then {:.0} % of what friction could carry there ({}); {stick}.",
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
            "{reach:.0}° ({}; contact itself ends at {end:.0}° there)",
            place(row, step)
        ))
    };
    let wide = study
        .rows
        .iter()
        .flat_map(Row::loading)
        .filter(|step| step.reading.end >= of_report(SEEN[1]));
    let closest = wide
        .filter_map(|step| step.reading.reach())
        .fold(0.0, f64::max);
    let softest = study
        .plan
        .pins
        .iter()
        .copied()
        .fold(f64::INFINITY, f64::min);
    let mut soft = study
        .rows
        .iter()
        .filter(|row| row.case.family == FITS && row.case.pin == softest);
    let soft = if soft.any(|row| row.loading().any(Step::is_reversed)) {
        "some"
    } else {
        "none"
    };
    Some(format!(
        "**Other joints.** A stiffer pin, more clearance and fibres across the load carry the reversed part further from the bearing point: \
         in other lay-ups to {}, over clearance and pin to {}. But that is while contact is narrow. At loads at which contact has reached \
         {}° or beyond, in any joint, the reversed part ends at {:.0}° or before. Under the softest pin, of {softest} ksi, there is {soft}.",
        extreme(LAYUPS)?,
        extreme(FITS)?,
        SEEN[1],
        of_report(closest),
    ))
}

/// Joints whose shear is reversed up to the end of contact while the load grows.
fn everywhere(study: &Study) -> Option<String> {
    let outside = |step: &&Step| {
        matches!(
            step.reading.pattern,
            Pattern::Reversed | Pattern::ReversedOutside
        )
    };
    let mut steps = 0_usize;
    let (mut pin, mut end) = (f64::INFINITY, 0.0_f64);
    for row in &study.rows {
        for step in row.loading().filter(outside) {
            steps += 1;
            pin = pin.min(row.case.pin);
            end = end.max(step.reading.end);
        }
    }
    (steps > 0).then(|| {
        format!(
            "**Reversed up to the end of contact** while the load grows: {steps} load steps, all with pins of {pin} ksi or stiffer and with \
             contact that ends at {:.0}° or before. It is what a rigid punch does: it draws the surface beneath it inwards (Spence, \
             Proc. R. Soc. A 305, 1968, 55–80), until the stretch of the hole outweighs that.",
            of_report(end)
        )
    })
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
            " Smeared moduli or those of the plies make no difference: in a membrane (0/60/−60) is isotropic. Over {pairs} laws \
             {unlike} load steps have another pattern of signs, and places of change differ by at most {worst:.3}°."
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
        "**Unloading** reverses the shear under every law with friction, from the end of contact inwards. That is the other way round: the \
         report's outer part kept the sign of loading. With μ = 0.2 and from 1500 lb the change is at {}.",
        texts.join(", ")
    ))
}

fn loading_again(study: &Study) -> Option<String> {
    let mut texts = Vec::new();
    for row in study.rows.iter().filter(|row| row.case.family == RELOADED) {
        let again = row
            .steps
            .iter()
            .filter(|step| step.phase == Phase::Reloading);
        let reversed: Vec<&Step> = again
            .filter(|step| step.reading.reach().is_some())
            .collect();
        let found: Vec<String> = reversed
            .iter()
            .take(3)
            .map(|step| format!("{}° at {} lb", changes(step), step.load))
            .collect();
        let last = reversed.last().map_or(0.0, |step| step.load);
        texts.push(format!(
            "{}: {}, until {last} lb",
            row.case.name,
            found.join(", ")
        ));
    }
    (!texts.is_empty()).then(|| {
        format!(
            "**What does give the report's pattern on the edge: loading again.** After 1500 lb and 300 lb, with the load growing, the outer \
             part has the sign of loading, and from the first of the following angles to the second the shear is still reversed; beyond it \
             is as the first loading left it (the report has values up to 60° only). {}. The report's loads were set by iteration (its \
             Fig. 8); whether any was approached after a larger one it does not say.",
            texts.join(". ")
        )
    })
}

fn beneath(study: &Study) -> Option<String> {
    let at = |depth: f64| {
        let arcs = study
            .arcs
            .iter()
            .filter(move |arc| arc.depth == depth && arc.load == 400.0);
        let texts: Vec<String> = arcs
            .map(|arc| {
                let (_, places) = arc.signs();
                let places: Vec<String> = places
                    .iter()
                    .rev()
                    .map(|&angle| format!("{:.0}°", of_report(angle)))
                    .collect();
                format!(
                    "{} (μ = {}, {} in)",
                    places.join(" to "),
                    arc.joint.friction,
                    arc.joint.clearance
                )
            })
            .collect();
        texts.join(", ")
    };
    (!study.arcs.is_empty()).then(|| {
        format!(
            "**And so does distance from the edge**, on first loading and with any law. Friction's shear decays within a thickness t; beneath \
             it is the shear of the hole's own stress field, which inside contact has the opposite sign and outside the same. At 400 lb the \
             shear is forward at small angles and reversed from the following angle to the second, or where there is but one to the bearing \
             point: t/4 beneath the edge {}; t/2 beneath {}; 1.55 t beneath, the report's arc, {}. The first angle lies below that at which contact ends and moves with it, so that clearance brings it \
             towards 30°. The report extrapolated the stresses on the edge from points up to 0.2 t away and found them to vary widely near the bearing point. Of \
             what this model can do on a first loading it is the only thing that looks like the report's curve.",
            at(0.25),
            at(0.5),
            at(1.55),
        )
    })
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
