//! The findings on matrix cracks in words.

use std::fmt::Write as _;

use super::case::CLEARANCE;
use super::plies::{Curve, LOADS, STRENGTH};
use super::study::Study;

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

fn cracks(curve: &Curve) -> String {
    curve.cracked().map_or_else(
        || "no crack".to_owned(),
        |[from, to]| format!("cracks from {from:.0}° to {to:.0}°"),
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
    Some(format!(
        "**Partly reproduced.** The largest tension across fibres is in the 60° plies on the side where the report found their cracks, and in \
         the −60° plies at the mirror image, on the side of 150°; the 0° plies have next to none. It is at the end of contact: {} at 400 lb, \
         {} at 900 lb, {} at 1500 lb, against the report's 20° at 900 lb. **Not reproduced:** the report's peak moves to larger angles with the \
         load; the end of contact here, and the peak with it, moves to smaller ones. In the model the plies stay whole and contact grows; in \
         the experiment plies were damaged from low loads on.",
        peak(low),
        peak(middle),
        peak(high),
    ))
}

fn clearances(study: &Study) -> Option<String> {
    let mut texts = Vec::new();
    for clearance in [CLEARANCE, 0.001, 0.0015, 0.002] {
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
    let mut texts = Vec::new();
    for clearance in [CLEARANCE, 0.0015] {
        for load in [900.0, 1500.0] {
            let without = curve(study, "Coulomb", 0.0, clearance, load)?;
            let with = curve(study, "Coulomb", -150.0, clearance, load)?;
            texts.push(format!(
                "{load} lb and {clearance} in: {} without, {} with",
                cracks(without),
                cracks(with)
            ));
        }
    }
    let with = curve(study, "Coulomb", -150.0, CLEARANCE, 900.0)?;
    let lowest = |cure: f64| {
        let mut loads = LOADS.iter().copied();
        let first = loads.find(|&load| {
            curve(study, "Coulomb", cure, CLEARANCE, load)
                .is_some_and(|own| own.cracked().is_some())
        });
        first.map_or_else(
            || "none of the loads looked at".to_owned(),
            |load| format!("{load} lb"),
        )
    };
    Some(format!(
        "**Residual stress decides the load.** Cooling by 150 K puts {:.1} ksi across the fibres of every ply, {:.0} % of the strength of \
         {STRENGTH} ksi, moves no peak, and brings the first crack by maximum stress down from {} to {} ({LOADS:?} lb were looked at). {}. \
         With residual stress the cracked part of the 60° plies reaches up to 30° of the report at the loads of the experiment, without \
         it they stay whole.",
        with.residual,
        100.0 * with.residual / STRENGTH,
        lowest(0.0),
        lowest(-150.0),
        texts.join("; "),
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
        "σ₂ of the 60° plies, angles of the report; the −60° plies have the same at 180° minus the angle.\n\n\
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
