//! Tables for the terminal.

use stickslip::output::{OutputError, signs_table};
use stickslip::results::Results;

use super::fixture::{open_hole, results};

/// Enough for all columns.
const WIDE: usize = 120;

fn table(results: &Results, width: usize) -> String {
    stickslip::output::summary_table(results, width).unwrap()
}

#[test]
fn load_steps_fit_in_120_columns_below_a_row_of_units() {
    let text = table(&results(), WIDE);
    assert!(
        text.lines().all(|line| line.chars().count() <= 120),
        "{text}"
    );
    let lines: Vec<Vec<&str>> = text
        .lines()
        .map(|line| line.split_whitespace().collect())
        .collect();
    assert_eq!(lines[0], ["Contact", "'pin'"]);
    assert_eq!(
        lines[1].join(" "),
        "step load contact ± stick ± slip away slip towards max p at φ max σ_θ at φ solves balance time"
    );
    assert_eq!(
        lines[2],
        [
            "lbf", "deg", "deg", "deg", "deg", "psi", "deg", "psi", "deg", "–", "ms"
        ]
    );
    // 4000 N = 899.24 lbf; 100 MPa = 14504 psi; 130 MPa = 18855 psi. The change to the next node is no error.
    let peak = "3 899.24 80.0 40.0 70.0 0.0 14504 0.0 18855 90.0 5 4.0e-13 1.0";
    assert_eq!(lines[6].join(" "), peak);
    assert!(text.contains("Contact 'roller'"));
    assert!(
        !text.contains("plate.left"),
        "an edge without contact has no row beside contacts"
    );
}

#[test]
fn a_narrow_terminal_has_fewer_columns_and_whole_numbers() {
    let wide = table(&results(), WIDE);
    assert!(!wide.contains("No width left"), "{wide}");
    for width in [100, 80] {
        let text = table(&results(), width);
        assert!(
            text.lines().all(|line| line.chars().count() <= width),
            "{text}"
        );
        // One line of names and one of units: no heading is broken, and the numbers stand as in the wide table.
        let lines: Vec<&str> = text.lines().collect();
        assert!(lines[3].starts_with('─'), "{text}");
        assert_eq!(
            lines[6].split_whitespace().take(4).collect::<Vec<_>>(),
            ["3", "899.24", "80.0", "40.0"]
        );
        assert!(text.contains("No width left for time"), "{text}");
    }
}

#[test]
fn without_contact_the_hoop_stress_is_shown() {
    let text = table(&open_hole(), WIDE);
    assert!(text.starts_with("Edge 'plate.hole'\n"), "{text}");
    assert!(
        text.contains("max σ_θ") && !text.contains("contact"),
        "{text}"
    );
}

/// The header, the units and the first row of the first table.
fn head(results: &Results) -> Vec<Vec<String>> {
    let words = |line: &str| line.split_whitespace().map(str::to_owned).collect();
    table(results, WIDE).lines().map(words).collect()
}

#[test]
fn loads_that_take_turns_are_counted_by_the_contact_force() {
    let mut results = results();
    for (index, step) in results.steps.iter_mut().enumerate() {
        step.loads[0].value = if index == 0 { 10.0 } else { 0.0 };
        step.loads[1].value = if index == 0 { 0.0 } else { 5.0 };
    }
    let lines = head(&results);
    assert_eq!(lines[2][0], "lbf");
    // 1000 N.
    assert_eq!(lines[4][1], "224.81");
}

#[test]
fn a_constant_first_load_gives_way_to_one_that_changes() {
    let mut results = results();
    for (index, step) in results.steps.iter_mut().enumerate() {
        step.loads[0].value = 500.0;
        step.loads[1].value = [0.0, 100.0, -100.0, 100.0][index];
    }
    let lines = head(&results);
    assert_eq!(lines[2][0], "K");
    assert_eq!(lines[6][1], "−100");
}

#[test]
fn without_loads_the_steps_have_only_their_numbers() {
    let mut results = results();
    for step in &mut results.steps {
        step.loads.clear();
    }
    let lines = head(&results);
    assert_eq!(lines[1][..2], ["step", "contact"]);
    assert_eq!(lines[2][0], "deg");
}

#[test]
fn inconsistent_results_are_an_error() {
    let mut results = results();
    results.steps[0].edges.clear();
    let refused = stickslip::output::summary_table(&results, WIDE);
    assert!(
        matches!(
            refused,
            Err(OutputError::Inconsistent {
                found: 0,
                expected: 3,
                ..
            })
        ),
        "{refused:?}"
    );
}

#[test]
fn every_sign_has_a_row() {
    let text = signs_table();
    assert!(
        text.lines().all(|line| line.chars().count() <= 120),
        "{text}"
    );
    for name in [
        "CPRESS", "CSHEAR1", "COPEN", "CSLIP1", "CSTATUS", "σ_r", "τ_rθ", "e_t", "σ_b",
    ] {
        assert!(text.contains(name), "{name}\n{text}");
    }
}
