//! The same scene gives the same bits, on any number of threads and every time.

use rayon::ThreadPoolBuilder;
use stickslip::results::Results;
use stickslip_tests::Draft;

/// Every number of the answer as its bits, and every status.
fn bits(results: &Results) -> (Vec<u64>, Vec<String>) {
    let (mut numbers, mut names) = (Vec::new(), Vec::new());
    for geometry in &results.edges {
        numbers.extend(geometry.parameter.iter().map(|value| value.to_bits()));
    }
    for step in &results.steps {
        for edge in &step.edges {
            for row in &edge.rows {
                let values = [
                    row.pressure,
                    row.shear,
                    row.gap,
                    row.slip,
                    row.sigma_normal,
                    row.sigma_tangential,
                    row.tau,
                ];
                numbers.extend(values.map(f64::to_bits));
                names.push(row.status.to_string());
            }
            let zones = edge.zones.iter().flat_map(|zone| [zone.start, zone.end]);
            let sums = [
                edge.resultant[0],
                edge.resultant[1],
                edge.friction_force,
                edge.normal_force,
            ];
            numbers.extend(zones.chain(sums).map(f64::to_bits));
        }
        for field in &step.fields {
            numbers.extend(field.displacement.iter().map(|value| value.to_bits()));
            numbers.extend(field.stress.iter().flatten().map(|value| value.to_bits()));
        }
        numbers.extend([step.dissipation, step.balance_residual].map(f64::to_bits));
        names.extend(step.solvers.iter().map(|&name| name.to_owned()));
        names.push(format!(
            "{:?} {} {}",
            step.work, step.increments, step.cutbacks
        ));
    }
    (numbers, names)
}

#[test]
fn threads_do_not_change_a_bit() {
    let drafts = [
        Draft::pin()
            .friction("static_dynamic = { static = 0.35, dynamic = 0.25 }")
            .set("mesh.spacing", "5 deg")
            .set("output.fields", "all")
            .forces(0, &[500.0, 2000.0, 3000.0, 800.0]),
        Draft::pin()
            .set("analysis.model", "whole")
            .set("analysis.solver", "pivoting")
            .set("mesh.element", "T6")
            .set("output.fields", "last")
            .forces(0, &[2000.0, 500.0]),
        Draft::cylinder().set("output.fields", "last"),
    ];
    for draft in drafts {
        let scene = draft.scene();
        let run = |threads: usize| {
            let pool = ThreadPoolBuilder::new()
                .num_threads(threads)
                .build()
                .expect("a pool of threads");
            pool.install(|| stickslip::run::run(&scene, &mut |_| {}))
                .expect("the draft is solvable")
        };
        let one = bits(&run(1));
        assert!(one.0.len() > 1000);
        for threads in [1, 2, 3, 8] {
            assert!(one == bits(&run(threads)), "{threads} threads:\n{draft:?}");
        }
    }
}
