//! Peak memory of a whole load history, in units of its Cholesky factors.

use std::path::Path;

use peak_alloc::PeakAlloc;
use stickslip::model::Model;
use stickslip::run::{Operator, solve, solver};
use stickslip::scene::Scene;
use stickslip::scene::schema::SolverChoice;

#[global_allocator]
static ALLOCATOR: PeakAlloc = PeakAlloc;

fn main() {
    println!("unknowns   factors MB   peak MB   peak / factors");
    for spacing in [3.75, 3.75, 1.8, 0.9] {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes/pin-benchmark.toml");
        let overrides = [
            format!("mesh.spacing={spacing} deg"),
            "mesh.element=Q8".into(),
        ];
        let scene =
            Scene::from_file(&path, &overrides).expect("the scene is part of the repository");
        let before = ALLOCATOR.current_usage();
        ALLOCATOR.reset_peak_usage();
        let model = Model::build(&scene).expect("the scene can be modelled");
        let solved = solve(&model, solver(SolverChoice::Auto).as_ref(), &mut |_| {})
            .expect("every step of the benchmark is solved");
        let peak = (ALLOCATOR.peak_usage() - before) as f64 / 1e6;
        let bodies: Vec<_> = solved
            .operators
            .iter()
            .filter_map(Operator::elastic)
            .collect();
        let factors = bodies.iter().map(|body| body.factor_bytes()).sum::<usize>() as f64 / 1e6;
        let unknowns: usize = bodies.iter().map(|body| body.structure().unknowns()).sum();
        println!(
            "{unknowns:>8}   {factors:>10.1}   {peak:>7.1}   {:.2}",
            peak / factors
        );
    }
}
