//! What an answer says of itself where it is one of several, or where the mesh or rounding leaves less of it than it shows.

use stickslip::results::{ContactFinding, Finding, Results};
use stickslip_tests::Draft;

use crate::files::solved;

/// What `kind` takes of the findings of `results`.
fn found<'a, T>(results: &'a Results, kind: impl FnMut(&'a Finding) -> Option<T>) -> Vec<T> {
    results.findings.iter().filter_map(kind).collect()
}

/// The residuals of balance that findings report.
fn residuals(results: &Results) -> Vec<f64> {
    found(results, |finding| match finding {
        Finding::Unbalanced { residual, .. } => Some(*residual),
        _ => None,
    })
}

/// The load reverses across the gap, where the plate hangs on one node: that it moves least makes the answers of pivoting and Newton one.
#[test]
fn a_loose_body_makes_no_answer_depend_on_the_solver() {
    let [newton, pivoting] = ["auto", "pivoting"].map(|solver| {
        solved(
            "load-across-the-gap",
            &[&format!("analysis.solver={solver}")],
        )
    });
    for results in [&newton, &pivoting] {
        let dependent = |finding: &&Finding| matches!(finding, Finding::SolverDependent(_));
        assert!(!results.findings.iter().any(|finding| dependent(&finding)));
    }
    let scale = newton.steps[6].edges[0].resultant[0].abs();
    for (own, other) in newton.steps.iter().zip(&pivoting.steps) {
        for (own, other) in own.edges[0].rows.iter().zip(&other.edges[0].rows) {
            assert!((own.pressure - other.pressure).abs() < 1e-9 * scale);
            assert!((own.gap - other.gap).abs() < 1e-9, "{own:?} {other:?}");
        }
    }
}

/// A law that drops from static to dynamic friction: pivoting and Newton find two answers from the same state, both exact.
#[test]
fn an_answer_that_depends_on_the_solver_is_reported() {
    for solver in ["auto", "pivoting"] {
        let results = solved(
            "load-across-the-gap",
            &[
                &format!("analysis.solver={solver}"),
                "contacts.0.friction={ static_dynamic = { static = 0.6, dynamic = 0.2 } }",
            ],
        );
        let dependent = found(&results, |finding| match finding {
            Finding::SolverDependent(other) => Some(other),
            _ => None,
        });
        let [other] = dependent[..] else {
            panic!("{solver}: {:?}", results.findings);
        };
        assert!(other.traction_change > 1e-6 && other.steps.contains(&other.step));
        let differing = results.steps.iter().enumerate().filter(|(_, step)| {
            let other = step.notes.otherwise.other_solver;
            other.is_some_and(|other| other.is_distinct())
        });
        let (numbers, steps): (Vec<usize>, Vec<_>) =
            differing.map(|(index, step)| (index + 1, step)).unzip();
        assert_eq!(other.steps, numbers);
        for step in steps {
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
    let unresolved = Finding::about(
        "pin",
        ContactFinding::Unresolved {
            steps: vec![1, 2, 3],
            nodes: 1,
        },
    );
    assert!(
        coarse.findings.contains(&unresolved),
        "{:?}",
        coarse.findings
    );
    let fine = Draft::pin().forces(0, &[2000.0]).run();
    assert_eq!(
        fine.steps[0].edges[0].is_resolved(&fine.edges[0]),
        Some(true)
    );
    let of_contact = |own: &&Finding| matches!(own, Finding::Contact { .. });
    assert_eq!(fine.findings.iter().find(of_contact), None);
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
        let worst = results.steps.iter().map(|step| step.balance_residual);
        assert_eq!(residuals(&results), [worst.fold(0.0, f64::max)]);
    }
    assert!(residuals(&Draft::pin().run()).is_empty());
}

/// A plate that hangs on one node of its bush may swing about it: no force changes, but gaps do.
#[test]
fn gaps_that_contact_leaves_undetermined_are_reported() {
    let [newton, pivoting] = ["newton", "pivoting"]
        .map(|solver| solved("loose-on-one-node", &[&format!("analysis.solver={solver}")]));
    for results in [&newton, &pivoting] {
        let loose = found(results, |finding| match finding {
            Finding::Contact {
                contact,
                finding: ContactFinding::GapsUndetermined { bodies, steps },
            } => Some((
                contact.as_str(),
                bodies.each_ref().map(String::as_str),
                &steps[..],
            )),
            _ => None,
        });
        assert_eq!(loose, [("bush", ["plate", "bush"], &[1, 2, 3, 4][..])]);
    }
}
