//! Laminated joints followed to their end: each mode of failure governs its scene, and lies where the report found it.

use serde::Deserialize;
use stickslip::results::ProgressiveFailure;

use super::check::{Check, Checks};
use super::laboratory::Laboratory;
use crate::publish::{TaskError, listed};

const SOURCE: &str = "Post & Reddy 1988, part II, 4.4 and Figs. 17–19";

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Joint {
    scene: String,
    mode: String,
    index: usize,
    place: String,
    flowing: String,
    parting: String,
}

/// The report's Tsai–Hill plasticity; its hardening is not given.
const FLOWING: &str = "failure.progressive.model={plasticity={hardening=\"100 MPa\"}}";

pub(crate) fn checks(lab: &Laboratory) -> Result<Vec<Check>, TaskError> {
    let mut checks = Checks::against(SOURCE);
    for joint in listed::<Joint>(include_str!("joint_modes.toml"), "joints")? {
        let broken = followed(lab, &joint.scene, &[])?;
        if let Some(call) = broken.mode.as_ref() {
            let found = call.mode.name();
            let what = format!("{}: mode", joint.scene);
            checks.holds(what, &joint.mode, found, found == joint.mode);
            let share = call.shares[joint.index];
            let what = format!("{}: where fibres break last", joint.scene);
            let found = format!("{:.0} %", 100.0 * share);
            checks.holds(what, &joint.place, found, share > 0.5);
        } else {
            checks.holds(&joint.scene, &joint.mode, "no ply failed", false);
        }
        let end = format!(
            "failure.progressive.control.displacement.end=\"{}\"",
            joint.flowing
        );
        let flows = followed(lab, &joint.scene, &[FLOWING.to_owned(), end])?;
        let ranges: Vec<[f64; 2]> = (flows.departures(0.1).into_iter())
            .map(|range| range.map(f64::to_degrees))
            .collect();
        let described: Vec<String> = (ranges.iter())
            .map(|[from, to]| format!("{from:.0}–{to:.0}°"))
            .collect();
        checks.show(
            format!(
                "{}: strains of flowing plies leave the linear ones",
                joint.scene
            ),
            &joint.parting,
            described.join(", "),
        );
    }
    Ok(checks.into_list())
}

fn followed(
    lab: &Laboratory,
    scene: &str,
    overrides: &[String],
) -> Result<ProgressiveFailure, TaskError> {
    let results = lab.run(scene, overrides)?;
    let mut found = results.failure.into_iter();
    let found = found.find_map(|failure| failure.progressive);
    Ok(found.ok_or_else(|| format!("{scene}: no progressive failure"))?)
}
