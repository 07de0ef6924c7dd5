//! Front against back: both as they were measured, before the null field is taken off, for the back has none.

use stickslip_fem_core::mesh::Point;
use stickslip_hybrid::data::{DataError, Field, FringeLine, FringeLines, Symmetry};

use super::{Measured, Reading, Scope};
use crate::error::ExperimentError;
use crate::finding::{BackFinding, Finding};
use stickslip_experiment::SymmetryPlan;

/// What a comparison found.
#[derive(Default)]
pub(super) struct Comparison {
    pub(super) found: Vec<(Field, Symmetry)>,
    /// What was left out.
    pub(super) findings: Vec<Finding>,
}

/// Compares along the chosen line, or along all common fringe lines.
pub(super) fn compared(
    scope: &Scope<'_>,
    plan: &SymmetryPlan,
    front: &Measured,
    back: &Measured,
) -> Result<Comparison, ExperimentError> {
    let mut comparison = Comparison::default();
    for field in Field::BOTH {
        if let (Some(own), Some(other)) = (&front.lines, &back.lines) {
            let c = field.component();
            common_lines(scope, plan, [&own[c], &other[c]], &mut comparison)?;
            continue;
        }
        let name = field.name();
        match [front, back].map(|side| side.measurement.count(field) > 0) {
            [true, true] => {
                let found = along_line(scope, plan, field, [front, back])?;
                comparison.found.push((field, found));
            }
            [true, false] => {
                return Err(not_compared(
                    scope,
                    &format!("the back has no {name}, which the front has"),
                    format!("give the {name} of the back too, or leave {name} out of the front"),
                ));
            }
            [false, true] => {
                let lacks = BackFinding::FrontLacks { field: name };
                comparison.findings.push(Finding::Back(lacks));
            }
            [false, false] => {}
        }
    }
    if comparison.found.is_empty() {
        return Err(not_compared(
            scope,
            "front and back have no field in common, so nothing of them was compared",
            "give the same field of both, or remove back".to_owned(),
        ));
    }
    Ok(comparison)
}

/// What is not seen where front and back are pictures that differ from the nulled ones, whose carriers were found.
pub(super) fn of_carriers(front: &Reading) -> Option<Finding> {
    let Reading::Pictures(fields) = front else {
        return None;
    };
    (fields.iter().flatten())
        .any(|field| !field.known)
        .then_some(Finding::Back(BackFinding::MeanStrainsNotSeen))
}

fn not_compared(scope: &Scope<'_>, what: &str, remedy: String) -> ExperimentError {
    ExperimentError::Missing {
        key: format!("{}.back", scope.key),
        what: format!("state '{}': {what}", scope.name()),
        remedy,
    }
}

fn failed(scope: &Scope<'_>, cause: DataError) -> ExperimentError {
    ExperimentError::Data {
        state: scope.name(),
        key: "reduce.symmetry".to_owned(),
        cause: Box::new(cause),
    }
}

/// Fringe lines of one field that both sides have.
fn common_lines(
    scope: &Scope<'_>,
    plan: &SymmetryPlan,
    [front, back]: [&FringeLines; 2],
    comparison: &mut Comparison,
) -> Result<(), ExperimentError> {
    let name = front.field.name();
    let names = |lines: &FringeLines| -> String {
        let all: Vec<&str> = lines.lines.iter().map(FringeLine::name).collect();
        all.join(", ")
    };
    let mut alone = Vec::new();
    for line in &front.lines {
        let Some(counterpart) = back.line(line.name()) else {
            alone.push(line.name());
            continue;
        };
        let found = line.symmetry(counterpart, plan.tolerance, true);
        let found = found.map_err(|cause| failed(scope, cause))?;
        comparison.found.push((front.field, found));
    }
    if alone.len() == front.lines.len() {
        return Err(not_compared(
            scope,
            &format!(
                "no line of the {name} field is on the front and on the back; the front has {}, the back {}",
                names(front),
                names(back)
            ),
            "give the line of the back the name of that on the front".to_owned(),
        ));
    }
    if !alone.is_empty() {
        let lines = alone.into_iter().map(str::to_owned).collect();
        let alone = BackFinding::LinesOfFrontAlone { field: name, lines };
        comparison.findings.push(Finding::Back(alone));
    }
    Ok(())
}

/// Displacements of one field along the chosen line.
fn along_line(
    scope: &Scope<'_>,
    plan: &SymmetryPlan,
    field: Field,
    [front, back]: [&Measured; 2],
) -> Result<Symmetry, ExperimentError> {
    let grating = scope.grating()?;
    let places: Vec<Point> = (0..plan.places)
        .map(|k| {
            let t = k as f64 / (plan.places - 1) as f64;
            [0, 1].map(|axis| (1.0 - t) * plan.ends[0][axis] + t * plan.ends[1][axis])
        })
        .collect();
    let side = scope.longest_side();
    let along = |measured: &Measured, name: &str| {
        measured
            .measurement
            .along(name, field, &places, side, &grating)
    };
    along(front, "front")
        .and_then(|front| front.symmetry(&along(back, "back")?, plan.tolerance, true))
        .map_err(|cause| failed(scope, cause))
}
