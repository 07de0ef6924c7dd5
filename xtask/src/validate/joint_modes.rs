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
    /// Where the report sees strains of flowing plies part from linear ones.
    parting: &'static str,
}

const JOINTS: [Joint; 3] = [
    Joint {
        scene: "joint-bearing",
        mode: "bearing",
        index: 0,
        place: "most broken fibres at 0–35°",
        flowing: "-0.24 mm",
        parting: "0–35°",
    },
    Joint {
        scene: "joint-shear-out",
        mode: "shear-out",
        index: 1,
        place: "most broken fibres on the sides of the plug, 45–80°",
        flowing: "-0.15 mm",
        parting: "60–80°",
    },
    Joint {
        scene: "joint-net-tension",
        mode: "net tension",
        index: 2,
        place: "most broken fibres at the net section",
        flowing: "-0.1 mm",
        parting: "the net section, 90°",
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
        let told: Vec<String> = (ranges.iter())
            .map(|[from, to]| format!("{from:.0}–{to:.0}°"))
            .collect();
        checks.show(
            format!(
                "{}: strains of flowing plies leave the linear ones",
                joint.scene
            ),
            joint.parting,
            told.join(", "),
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
