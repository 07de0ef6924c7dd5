//! Laminated joints followed to their end: each mode of failure governs its scene, and lies where the report found it.

use stickslip::results::ProgressiveFailure;

use super::check::{Check, Checks};
use super::laboratory::{Laboratory, Trouble};

const SOURCE: &str = "Post & Reddy 1988, part II, 4.4 and Figs. 17–19";

/// A scene, the mode that its geometry is chosen for and its index in the shares, and the drive under which flowing plies part from
/// linear ones.
struct Joint {
    scene: &'static str,
    mode: &'static str,
    index: usize,
    place: &'static str,
    flowing: &'static str,
    /// Where strains of flowing plies may part from linear ones [degree].
    range: [f64; 2],
}

const JOINTS: [Joint; 3] = [
    Joint {
        scene: "joint-bearing",
        mode: "bearing",
        index: 0,
        place: "most broken fibres at 0–35°",
        flowing: "-0.24 mm",
        range: [0.0, 90.0],
    },
    Joint {
        scene: "joint-shear-out",
        mode: "shear-out",
        index: 1,
        place: "most broken fibres on the sides of the plug, from 60–80°",
        flowing: "-0.15 mm",
        range: [45.0, 85.0],
    },
    Joint {
        scene: "joint-net-tension",
        mode: "net tension",
        index: 2,
        place: "most broken fibres at the net section",
        flowing: "-0.1 mm",
        range: [75.0, 105.0],
    },
];

/// The report's Tsai–Hill plasticity; its hardening is not given.
const FLOWING: &str = "failure.progressive.model={plasticity={hardening=\"100 MPa\"}}";

pub(crate) fn checks(lab: &Laboratory) -> Result<Vec<Check>, Trouble> {
    let mut checks = Checks::against(SOURCE);
    for joint in &JOINTS {
        let broken = followed(lab, joint.scene, &[])?;
        if let Some(call) = broken.mode.as_ref() {
            let found = call.mode.name();
            let what = format!("{}: mode", joint.scene);
            checks.holds(what, joint.mode, found, found == joint.mode);
            let share = call.shares[joint.index];
            let what = format!("{}: where fibres break last", joint.scene);
            let found = format!("{:.0} %", 100.0 * share);
            checks.holds(what, joint.place, found, share > 0.5);
        } else {
            checks.holds(joint.scene, joint.mode, "no ply failed", false);
        }
        let end = format!(
            "failure.progressive.control.displacement.end=\"{}\"",
            joint.flowing
        );
        let flows = followed(lab, joint.scene, &[FLOWING.to_owned(), end])?;
        let ranges: Vec<[f64; 2]> = (flows.departures(0.1).into_iter())
            .map(|range| range.map(f64::to_degrees))
            .collect();
        let [low, high] = joint.range;
        let met = !ranges.is_empty() && (ranges.iter().flatten()).all(|a| (low..high).contains(a));
        let told: Vec<String> = (ranges.iter())
            .map(|[from, to]| format!("{from:.0}–{to:.0}°"))
            .collect();
        checks.holds(
            format!(
                "{}: strains of flowing plies leave the linear ones",
                joint.scene
            ),
            format!("within {low:.0}–{high:.0}°"),
            told.join(", "),
            met,
        );
    }
    Ok(checks.into_list())
}

fn followed(
    lab: &Laboratory,
    scene: &str,
    overrides: &[String],
) -> Result<ProgressiveFailure, Trouble> {
    let results = lab.run(scene, overrides)?;
    let mut found = results.failure.into_iter();
    (found.find_map(|failure| failure.progressive))
        .ok_or_else(|| Trouble::Missing(format!("{scene}: no progressive failure")))
}
