//! Other units, other sizes, other moduli: the same answer in these units.

use stickslip::results::Results;
use stickslip_tests::compare::relative_difference;

use crate::files::{scaled, solved};

/// Scenes whose contacts stick, slip, open and close, some with mortar and heat.
const SCENES: [&str; 4] = [
    "bush-high-friction",
    "load-across-the-gap",
    "one-node",
    "soft-pin-one-node",
];

fn statuses(results: &Results) -> Vec<String> {
    let edges = results.steps.iter().flat_map(|step| &step.edges);
    edges
        .flat_map(|edge| edge.rows.iter().map(|row| row.status.to_string()))
        .collect()
}

fn tractions(results: &Results) -> Vec<f64> {
    let edges = results.steps.iter().flat_map(|step| &step.edges);
    let rows = edges.flat_map(|edge| &edge.rows);
    rows.flat_map(|row| [row.pressure, row.shear]).collect()
}

fn lengths(results: &Results) -> Vec<f64> {
    let edges = results.steps.iter().flat_map(|step| &step.edges);
    let rows = edges.flat_map(|edge| &edge.rows);
    rows.flat_map(|row| [row.gap, row.slip]).collect()
}

/// Twelve decades of length and of modulus: equal statuses, and results equal to rounding.
#[test]
fn size_and_stiffness_change_no_answer() {
    for name in SCENES {
        let reference = solved(name, &[]);
        for (length, modulus) in [
            (7.3, 3.1),
            (1.0, 1e3),
            (1e-6, 1.0),
            (1e6, 1.0),
            (1.0, 1e-6),
            (1.0, 1e6),
        ] {
            let other = scaled(name, length, modulus);
            let case = format!("{name} × {length:e}, {modulus:e}");
            assert_eq!(statuses(&reference), statuses(&other), "{case}");
            let scaled =
                |values: Vec<f64>, factor: f64| values.into_iter().map(move |value| factor * value);
            let stress =
                relative_difference(scaled(tractions(&reference), modulus), tractions(&other));
            let motion = relative_difference(scaled(lengths(&reference), length), lengths(&other));
            assert!(
                stress < 1e-9 && motion < 1e-9,
                "{case}: {stress:e} {motion:e}"
            );
        }
    }
}

/// Factors that are powers of four change no digit; those of two only those that roots in the factorisation round.
#[test]
fn powers_of_four_change_no_bit() {
    for name in SCENES {
        let reference = solved(name, &[]);
        for (length, modulus) in [(10, 0), (-10, 0), (0, 20), (0, -20), (8, -6)] {
            let [length, modulus] = [length, modulus].map(|power| 2.0_f64.powi(power));
            let other = scaled(name, length, modulus);
            let of = |values: Vec<f64>, factor: f64| -> Vec<u64> {
                values
                    .into_iter()
                    .map(|value| (factor * value).to_bits())
                    .collect()
            };
            let case = format!("{name} × {length:e}, {modulus:e}");
            assert!(
                of(tractions(&reference), modulus) == of(tractions(&other), 1.0),
                "{case}"
            );
            assert!(
                of(lengths(&reference), length) == of(lengths(&other), 1.0),
                "{case}"
            );
        }
    }
}
