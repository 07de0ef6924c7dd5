//! What the scene asks for and the followed joint has less of.

use stickslip_fem_core::QuadraturePoints;
use stickslip_joint::JointRecord;

use super::subject::{Subject, crack_band};
use crate::model::Model;
use crate::results::{JointFinding, Quantity};
use crate::run::doubts::unverified;
use stickslip_scene::schema::Ramp;

/// Findings on the joint that is followed on `followed`, instead of the scene's own `model`.
pub(super) fn of(
    subject: &Subject<'_>,
    model: &Model,
    followed: &Model,
    records: &[JointRecord],
) -> Vec<JointFinding> {
    let mut findings = bands(subject, followed).unwrap_or_default();
    if let Some((solvers, residual)) = unverified(records.iter().map(|record| &record.contact)) {
        findings.push(JointFinding::Unverified { solvers, residual });
    }
    let contact = &model.request.analysis;
    if contact.substeps() != 1 || contact.ramp() != Ramp::Linear {
        findings.push(JointFinding::SubstepsIgnored);
    }
    let Some(failure) = &model.request.failure else {
        return findings;
    };
    if failure.settings.clear_of_supports.is_some() {
        findings.push(JointFinding::ClearOfSupportsIgnored);
    }
    let others = failure.bodies.iter().map(|own| own.body);
    let others = others.filter(|body| *body != subject.found.body);
    let bodies: Vec<String> = others.map(|body| model.bodies[body].name.clone()).collect();
    if !bodies.is_empty() {
        findings.push(JointFinding::OtherBodiesIntact { bodies });
    }
    findings
}

/// Which fracture energies lower a strength, and on which cells.
fn bands(subject: &Subject<'_>, model: &Model) -> Option<Vec<JointFinding>> {
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
    let size = |row: f64| Quantity::Length(row / band.width());
    let finding = |(energy, own): (&'static str, f64)| {
        let lowered_cells = widths.iter().filter(|width| **width > own).count();
        let cells = widths.len();
        if lowered_cells == cells {
            return None;
        }
        Some(if lowered_cells == 0 {
            JointFinding::CrackBandIdle {
                energy,
                row_width: Quantity::Length(own),
                cell_size: size(own),
                largest_cell: size(widest),
            }
        } else {
            JointFinding::CrackBandPartial {
                energy,
                lowered_cells,
                cells,
                cell_size: size(own),
            }
        })
    };
    Some(least.into_iter().filter_map(finding).collect())
}
