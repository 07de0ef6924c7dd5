//! What an answer says of itself where it is one of several, or where the mesh or rounding leaves less of it than it shows.

use stickslip::results::Results;
use stickslip_tests::Draft;

use crate::files::solved;

fn told(results: &Results, part: &str) -> Vec<String> {
    let notes = results.notes.iter();
    notes.filter(|note| note.contains(part)).cloned().collect()
}

/// The load reverses across the gap: pivoting and Newton find two answers from the same state, both exact.
#[test]
fn an_answer_that_depends_on_the_solver_is_reported() {
    for solver in ["auto", "pivoting"] {
        let results = solved(
            "load-across-the-gap",
            &[&format!("analysis.solver={solver}")],
        );
        let notes = told(&results, "depends on the solver");
        assert_eq!(notes.len(), 1, "{solver}: {:?}", results.notes);
        let differing = results.steps.iter().filter(|step| {
            let other = step.notes.otherwise.other_solver;
            other.is_some_and(|other| other.is_distinct())
        });
        for step in differing {
            assert!(step.notes.solutions_known() >= Some(2), "{solver}");
            assert!(step.residuals.largest() < 1e-10, "{solver}");
        }
    }
}

/// One node of a pin's contact, whose pressure doubles where the mesh is halved, is no contact that the mesh resolves.
#[test]
fn contact_on_one_node_is_reported_as_unresolved() {
    let coarse = solved("one-node", &[]);
    let edge = &coarse.steps[0].edges[0];
    assert_eq!(edge.fewest_contact_nodes(&coarse.edges[0]), Some(1));
    assert_eq!(edge.is_resolved(&coarse.edges[0]), Some(false));
    assert_eq!(
        told(&coarse, "The mesh does not resolve contact 'pin'").len(),
        1
    );
    let fine = Draft::pin().forces(0, &[2000.0]).run();
    assert_eq!(
        fine.steps[0].edges[0].is_resolved(&fine.edges[0]),
        Some(true)
    );
    assert_eq!(fine.notes, Vec::<String>::new());
}

/// Rigid motions of half a millimetre beside strains of 1e-9 take no digits from the balance.
#[test]
fn large_rigid_motions_leave_the_balance_alone() {
    for step in solved("soft-pin-wide-clearance", &[]).steps {
        let balance = step.balance_residual;
        assert!(balance < 1e-12, "{balance:e}");
    }
}

/// Cells a million times longer than wide, and thermal strains 1e6 times those of the load, do take digits, which is said.
#[test]
fn a_balance_that_rounding_spoils_is_reported() {
    let outline = r#"{ half_width = "20 mm", left = "1e7 mm", right = "20 mm" }"#;
    let strip = Draft::pin().set("bodies.plate.shape.plate_with_hole.outline.strip", outline);
    for results in [strip.run(), solved("soft-pin-one-node", &[])] {
        let balance = results.steps[0].balance_residual;
        assert!(balance > 1e-8, "{balance:e}");
        assert_eq!(told(&results, "Forces balance to").len(), 1);
    }
    assert_eq!(told(&Draft::pin().run(), "Forces balance to").len(), 0);
}

/// A plate that hangs on one node of its bush may swing about it: no force changes, but gaps do.
#[test]
fn gaps_that_contact_leaves_undetermined_are_reported() {
    let [newton, pivoting] = ["newton", "pivoting"]
        .map(|solver| solved("loose-on-one-node", &[&format!("analysis.solver={solver}")]));
    for results in [&newton, &pivoting] {
        let notes = told(results, "COPEN, displacements and what closes next");
        assert_eq!(notes.len(), 1, "{:?}", results.notes);
        assert!(
            notes[0].starts_with("In an increment of load step 1–4 contact 'bush' touches"),
            "{notes:?}"
        );
    }
}
