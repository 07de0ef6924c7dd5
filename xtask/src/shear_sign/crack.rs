//! The findings on matrix cracks in words.

use std::fmt::Write as _;

use super::case::CLEARANCE;
use super::plies::{Curve, LOADS, STRENGTH};
use super::study::Study;

/// Radial clearances of the questions `[in]`.
const CLEARANCES: [f64; 4] = [CLEARANCE, 0.001, 0.0015, 0.002];

/// The curve of a question at a load, of the ply at 60°; that at −60° is its mirror image about 90°.
fn curve<'a>(
    study: &'a Study,
    name: &str,
    cure: f64,
    clearance: f64,
    load: f64,
) -> Option<&'a Curve> {
    study.curves.iter().find(|curve| {
        curve.name == name
            && curve.cure == cure
            && curve.clearance == clearance
            && curve.load == load
            && (curve.ply - 60.0).abs() < 1e-9
    })
}

fn peak(curve: &Curve) -> String {
    let [angle, stress] = curve.peak();
    format!("{stress:.1} ksi at {angle:.0}°")
}

/// A whole angle, with a true minus sign and no minus zero.
fn degrees(angle: f64) -> String {
    format!("{}°", angle.round() + 0.0).replace('-', "−")
}

fn cracks(curve: &Curve) -> String {
    curve.cracked().map_or_else(
        || "nowhere".to_owned(),
        |[from, to]| format!("{} to {}", degrees(from), degrees(to)),
    )
}

/// What was found, in sentences; the first is the answer.
pub(crate) fn findings(study: &Study) -> Vec<String> {
    let mut sentences = Vec::new();
    sentences.extend(answer(study));
    sentences.extend(clearances(study));
    sentences.extend(residual(study));
    sentences.extend(laws(study));
    sentences
}

fn answer(study: &Study) -> Option<String> {
    let at = |load| curve(study, "Coulomb", 0.0, CLEARANCE, load);
    let (low, middle, high) = (at(400.0)?, at(900.0)?, at(1500.0)?);
    let straight = study
        .curves
        .iter()
        .filter(|curve| curve.ply == 0.0 && curve.cure == 0.0);
    let straight = straight.fold(0.0_f64, |most, curve| curve.peak()[1].max(most));
    Some(format!(
        "**Partly reproduced.** The largest tension across fibres is in the 60° plies on the side on which the report found their cracks, \
         and in the −60° plies at its mirror image on the side of 150°; the 0° plies have {straight:.1} ksi at most. It is where contact \
         ends: {} at 400 lb, {} at 900 lb, {} at 1500 lb, against the report's 20° at 900 lb. **Not reproduced:** in the report the peak moves \
         to larger angles with the load; here contact grows, and the peak moves with its end to smaller ones. In the model the plies stay \
         whole; in the experiment they were damaged from low loads on. That −60° plies cracked first, which the report lays to their four \
         layers at mid-plane, is not in a strength that does not know how thick a ply is.",
        peak(low),
        peak(middle),
        peak(high),
    ))
}

fn clearances(study: &Study) -> Option<String> {
    let mut texts = Vec::new();
    for clearance in CLEARANCES {
        let [angle, _] = curve(study, "Coulomb", 0.0, clearance, 900.0)?.peak();
        texts.push(format!("{angle:.0}° with {clearance} in"));
    }
    Some(format!(
        "**Clearance decides the angle**, since it decides where contact ends: at 900 lb the peak is at {}. The report does not give the \
         clearance of its composite plate; 0.0005 in is that of the aluminium plate of its second part.",
        texts.join(", ")
    ))
}

fn residual(study: &Study) -> Option<String> {
    let cold = curve(study, "Coulomb", -150.0, CLEARANCE, 900.0)?;
    let found = |cure: f64, clearances: &[f64]| {
        let mut texts = Vec::new();
        for &clearance in clearances {
            let at = |load: &f64| {
                let own = curve(study, "Coulomb", cure, clearance, *load)?;
                own.cracked()?;
                Some(format!("{} at {load} lb", cracks(own)))
            };
            let own: Vec<String> = LOADS.iter().filter_map(at).collect();
            if !own.is_empty() {
                texts.push(format!("{} ({clearance} in)", own.join(", ")));
            }
        }
        if texts.is_empty() {
            "nowhere".to_owned()
        } else {
            texts.join("; ")
        }
    };
    Some(format!(
        "**Residual stress decides whether they crack.** Cooling by 150 K puts {:.1} ksi across the fibres of every ply, {:.0} % of the \
         strength of {STRENGTH} ksi (of the carbon-epoxy ply in the report's second part), and moves no peak. At 400, 900, 1200 and 1500 lb \
         the 60° plies reach the strength, without it: {}; with it: {}. So the cracks of the report at about 30° and 150° lie at the inner \
         border of what is predicted at the loads of the experiment, not in its middle, and take residual stress or a weaker ply.",
        cold.residual,
        100.0 * cold.residual / STRENGTH,
        found(0.0, &CLEARANCES),
        found(-150.0, &[CLEARANCE, 0.0015]),
    ))
}

fn laws(study: &Study) -> Option<String> {
    let coulomb = curve(study, "Coulomb", 0.0, CLEARANCE, 900.0)?;
    let coverage = curve(study, "fibre coverage", 0.0, CLEARANCE, 900.0)?;
    Some(format!(
        "**The friction law hardly matters**: {} with Coulomb's law, {} with fibre coverage at 900 lb.",
        peak(coulomb),
        peak(coverage)
    ))
}

/// All questions: the 60° plies.
pub(crate) fn table(study: &Study) -> String {
    let mut text = String::from(
        "One half of the joint is modelled: the laminate is balanced, so its mean stresses are symmetric, and on the other half the ply of the \
         opposite direction takes the place of each. σ₂ of the 60° plies, angles of the report; the −60° plies have the same at 180° minus \
         the angle.\n\n\
         | law | clearance [in] | cure [K] | load [lb] | largest σ₂ [ksi] | at | σ₂ at 20° | σ₂ at 30° | σ₂ at 150° | at the strength |\n\
         | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n",
    );
    let shown = study
        .curves
        .iter()
        .filter(|curve| curve.ply > 0.0 && [900.0, 1500.0].contains(&curve.load));
    for curve in shown {
        let [angle, stress] = curve.peak();
        // Writing into a string does not fail.
        let _ = writeln!(
            text,
            "| {} | {} | {} | {} | {stress:.2} | {angle:.1}° | {:.2} | {:.2} | {:.2} | {} |",
            curve.name,
            curve.clearance,
            curve.cure.to_string().replace('-', "−"),
            curve.load,
            curve.at(20.0),
            curve.at(30.0),
            curve.at(150.0),
            cracks(curve),
        );
    }
    text
}
