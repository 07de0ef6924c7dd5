//! What a followed joint has less of than the scene asks for, as sentences.

use super::quoted;
use stickslip_results::{JointFinding, Quantity};
use stickslip_scene::schema::DisplayUnits;

/// `finding` as a sentence or some, with lengths in `units`.
pub fn joint_sentence(finding: &JointFinding, units: DisplayUnits) -> String {
    let show = |length: &Quantity| units.length.show(length.value());
    match finding {
        JointFinding::CrackBandIdle {
            energy,
            row_width,
            cell_size,
            largest_cell,
        } => format!(
            "crack_band.{energy} has no effect on this mesh: it lowers strengths in rows of points wider than {}, that is in cells larger than {}; the \
             largest cell has {}.",
            show(row_width),
            show(cell_size),
            show(largest_cell)
        ),
        JointFinding::CrackBandPartial {
            energy,
            lowered_cells,
            cells,
            cell_size,
        } => format!(
            "crack_band.{energy} lowers strengths in {lowered_cells} of {cells} cells, those larger than {}; in the others the ply's own strength \
             stays, and a crack takes less energy.",
            show(cell_size)
        ),
        JointFinding::Unverified { solvers, residual } => format!(
            "The answers of the experimental solver {} are not verified: they leave a residual of up to {residual:.1e} in the conditions of contact \
             and friction, where others stop below 1e-10.",
            quoted(solvers)
        ),
        JointFinding::SubstepsIgnored => {
            "analysis.substeps and analysis.ramp divide the load steps of the contact analysis; the joint is followed in the increments of \
             failure.progressive.control."
                .to_owned()
        }
        JointFinding::ClearOfSupportsIgnored => {
            "failure.clear_of_supports has no effect on the joint that is followed: plies beside the ends of supports fail too."
                .to_owned()
        }
        JointFinding::OtherBodiesIntact { bodies } => {
            let bodies: Vec<String> = bodies.iter().map(|name| format!("'{name}'")).collect();
            format!(
                "Plies of {} do not fail here: one body is followed.",
                bodies.join(", ")
            )
        }
    }
}
