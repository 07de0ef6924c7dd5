//! What the scene asks for and the followed joint has less of.

use stickslip_fem_core::QuadraturePoints;

use super::{Subject, crack_band};
use crate::model::Model;
use stickslip_scene::Scene;
use stickslip_scene::schema::Ramp;

/// One sentence each.
pub(super) fn of(subject: &Subject<'_>, scene: &Scene, model: &Model) -> Vec<String> {
    let mut notes = bands(subject, scene, model).unwrap_or_default();
    let contact = &scene.analysis;
    if contact.substeps != 1 || contact.ramp != Ramp::Linear {
        notes.push(
            "analysis.substeps and analysis.ramp divide the load steps of the contact analysis; the joint is followed in the increments of \
             failure.progressive.control."
                .to_owned(),
        );
    }
    let Some(failure) = &scene.failure else {
        return notes;
    };
    if failure.clear_of_supports.is_some() {
        notes.push(
            "failure.clear_of_supports has no effect on the joint that is followed: plies beside the ends of supports fail too."
                .to_owned(),
        );
    }
    let others = failure
        .bodies
        .iter()
        .filter(|name| **name != subject.asked.body);
    let others: Vec<String> = others.map(|name| format!("'{name}'")).collect();
    if !others.is_empty() {
        notes.push(format!(
            "Plies of {} do not fail here: one body is followed.",
            others.join(", ")
        ));
    }
    notes
}

/// Which fracture energies lower a strength, and on which cells.
fn bands(subject: &Subject<'_>, scene: &Scene, model: &Model) -> Option<Vec<String>> {
    let degradation = subject.asked.model.parameters.degradation()?;
    let mesh = subject.mesh(model)?;
    let band = crack_band(subject.asked.crack_band?, degradation, mesh).ok()?;
    // By energy, the least of all plies: from there on a strength is lowered.
    let mut least: Vec<(&'static str, f64)> = Vec::new();
    for layer in subject.sheet.laminate.layers() {
        for (name, length) in band.own_lengths(layer.ply()) {
            match least.iter_mut().find(|(known, _)| *known == name) {
                Some((_, known)) => *known = known.min(length),
                None => least.push((name, length)),
            }
        }
    }
    let points = QuadraturePoints::of(mesh);
    let widths: Vec<f64> = (0..points.cell_count())
        .map(|cell| band.width() * points.cell_area(cell).sqrt())
        .collect();
    let widest = widths.iter().copied().fold(0.0, f64::max);
    let show = |length: f64| scene.display.length.show(length);
    let sentence = |(name, own): (&'static str, f64)| {
        let cells = show(own / band.width());
        let lowered = widths.iter().filter(|width| **width > own).count();
        if lowered == widths.len() {
            return None;
        }
        Some(if lowered == 0 {
            format!(
                "crack_band.{name} has no effect on this mesh: it lowers strengths in rows of points wider than {}, that is in cells larger than {cells}; the \
                 largest cell has {}.",
                show(own),
                show(widest / band.width())
            )
        } else {
            format!(
                "crack_band.{name} lowers strengths in {lowered} of {} cells, those larger than {cells}; in the others the ply's own strength \
                 stays, and a crack takes less energy.",
                widths.len()
            )
        })
    };
    Some(least.into_iter().filter_map(sentence).collect())
}
