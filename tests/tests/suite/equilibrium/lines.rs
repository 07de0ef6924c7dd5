//! Cylinders pressed on blocks and pushed along them.

use proptest::prelude::*;
use stickslip::results::{EdgeGeometry, StepResults};
use stickslip_contact::StepRecord;
use stickslip_tests::{Draft, Solution};

use super::{NODAL, residual_and_reaction};

/// Radius of the cylinder and thickness `[mm]`.
const RADIUS: f64 = 50.0;
const THICKNESS: f64 = 1.0;
/// Sums of tractions, as for joints.
const SUMS: f64 = 1e-9;

/// A scene with its presses and pushes `[N]`.
#[derive(Clone, Debug)]
struct Line {
    draft: Draft,
    forces: Vec<(f64, f64)>,
    mu: f64,
}

fn lines() -> impl Strategy<Value = Line> {
    let element = prop::sample::select(vec!["T3", "T6", "Q4", "Q8", "Q9"]);
    let law = prop::sample::select(vec![
        "coulomb = { mu = MU }",
        "static_dynamic = { static = MU, dynamic = MU }",
        "slip_power = { static = MU, dynamic = MU, slip_scale = \"1 um\", exponent = 2.0 }",
    ]);
    let young = prop::sample::select(vec!["70 GPa", "210 GPa"]);
    // Below the slip of the whole contact at the smallest press, so that every step has a solution.
    let forces = prop::collection::vec((100.0..800.0_f64, -0.9..0.9_f64), 1..5);
    let kind = (any::<bool>(), 1..=3_usize);
    (element, 0.15..0.4_f64, 0.1..0.8_f64, law, young, forces, kind).prop_map(
        |(element, spacing, mu, law, young, shares, (pushed, substeps))| {
            let least = shares
                .iter()
                .fold(f64::INFINITY, |least, (press, _)| least.min(*press));
            let forces: Vec<(f64, f64)> = shares
                .iter()
                .map(|(press, share)| (*press, if pushed { share * mu * least } else { 0.0 }))
                .collect();
            let (presses, pushes): (Vec<f64>, Vec<f64>) = forces.iter().copied().unzip();
            let mut draft = Draft::cylinder()
                .set("mesh.element", element)
                .set("mesh.spacing", format!("{spacing} mm"))
                .set("materials.upper.isotropic.young", young)
                .set("analysis.substeps", substeps)
                .friction(&law.replace("MU", &mu.to_string()))
                .forces(0, &presses);
            draft = if pushed {
                draft.forces(1, &pushes)
            } else {
                // No push at all leaves a symmetric scene, of which half is modelled.
                let press = stickslip_tests::draft::quantities(&presses, "N");
                draft.set(
                    "loads",
                    format!("[{{ on = \"upper.top\", force = {{ direction = [0, -1], steps = {press} }} }}]"),
                )
            };
            Line { draft, forces, mu }
        },
    )
}

/// Contact area `[mm²]` of each node: the edge's consistent weights on the arc of the cylinder.
fn areas(edge: &EdgeGeometry) -> Vec<f64> {
    let along: Vec<f64> = edge
        .parameter
        .iter()
        .map(|x| RADIUS * (x / RADIUS).asin())
        .collect();
    let corners: Vec<usize> = (0..along.len()).filter(|&k| edge.corner[k]).collect();
    let mut areas = vec![0.0; along.len()];
    for ends in corners.windows(2) {
        let length = THICKNESS * (along[ends[1]] - along[ends[0]]);
        let quadratic = ends[1] - ends[0] == 2;
        let end = if quadratic { 1.0 / 6.0 } else { 0.5 };
        areas[ends[0]] += end * length;
        areas[ends[1]] += end * length;
        if quadratic {
            areas[ends[0] + 1] += length * 4.0 / 6.0;
        }
    }
    areas
}

/// Tractions and table against press and push.
fn check_tractions(
    line: &Line,
    edge: &EdgeGeometry,
    step: &StepResults,
    (press, push): (f64, f64),
) {
    let double = if edge.half { 2.0 } else { 1.0 };
    let rows = &step.edges[0].rows;
    let (mut normal, mut along) = (0.0, 0.0);
    for (row, area) in rows.iter().zip(areas(edge)) {
        normal += double * row.pressure * area;
        // e_t is e_y turned by +90°, −e_x.
        along -= row.shear * area;
        let slack = 1e-8 * press;
        assert!(
            row.shear.abs() <= line.mu * row.pressure * (1.0 + 1e-8) + slack,
            "{row:?} {line:?}"
        );
        assert!(
            row.gap >= -1e-9 * RADIUS && row.pressure >= -slack,
            "{row:?} {line:?}"
        );
    }
    let [x, y] = step.edges[0].resultant;
    for (found, expected) in [(normal, press), (along, -push), (x, -push), (y, press)] {
        // On a half model the shears of both halves cancel, whatever they are.
        if edge.half && expected == 0.0 {
            continue;
        }
        assert!(
            (found - expected).abs() <= SUMS * press,
            "{found} {expected} {line:?}"
        );
    }
    assert!(
        (step.edges[0].friction_force + push).abs() <= SUMS * press || edge.half,
        "{line:?}"
    );
    assert!(
        step.residuals.largest() < 1e-9 && step.balance_residual < 1e-9,
        "{step:?}"
    );
    assert!(step.dissipation >= -1e-9 * press, "{line:?}");
}

/// Nodes without support are in balance, the ground carries all, and nothing holds the platen where it is free.
fn check_bodies(line: &Line, solution: &Solution, record: &StepRecord, (press, push): (f64, f64)) {
    let half = solution.model.half;
    let double = if half { 2.0 } else { 1.0 };
    for (name, set, reaction) in [
        ("lower", "bottom", [-push, press]),
        ("upper", "top", [0.0, 0.0]),
    ] {
        let mut held = vec![(set, [true, true])];
        if half {
            held.push(("symmetry", [true, false]));
        }
        let body = solution.body(name);
        let (left, [x, y]) = residual_and_reaction(solution, body, record, &held);
        assert!(left <= NODAL * press, "{name}: {left} {line:?}");
        assert!(
            (double * y - reaction[1]).abs() <= SUMS * press,
            "{name}: {y} {line:?}"
        );
        assert!(
            half || (x - reaction[0]).abs() <= SUMS * press,
            "{name}: {x} {line:?}"
        );
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 30, max_global_rejects: 2, ..ProptestConfig::default() })]

    #[test]
    fn every_line_contact_is_in_equilibrium(line in lines()) {
        let results = line.draft.run_if_solvable();
        prop_assume!(results.is_some(), "the solvers say that they did not solve it");
        if let Some(results) = results {
            let solution = line.draft.solve();
            for (index, forces) in line.forces.iter().enumerate() {
                check_tractions(&line, &results.edges[0], &results.steps[index], *forces);
                check_bodies(&line, &solution, &solution.records()[index], *forces);
            }
        }
    }
}
