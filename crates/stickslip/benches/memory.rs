//! Peak memory of a whole run without files, in units of its Cholesky factors. The first line is a warm-up: the first use of
//! dense products allocates buffers that the process keeps.

use std::path::Path;

use peak_alloc::PeakAlloc;
use stickslip::host::HOST;
use stickslip::run::run;
use stickslip::scene::Scene;

#[global_allocator]
static ALLOCATOR: PeakAlloc = PeakAlloc;

fn main() {
    println!("unknowns   factors MB   peak MB   peak / factors");
    for (spacing, shown) in [(3.75, false), (3.75, true), (1.8, true), (0.9, true)] {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes/pin-benchmark.toml");
        let overrides = [
            format!("mesh.spacing={spacing} deg"),
            "mesh.element=Q8".into(),
            "output.fields=none".into(),
        ];
        let scene =
            Scene::from_file(&path, &overrides, HOST).expect("the scene is part of the repository");
        let before = ALLOCATOR.current_usage();
        ALLOCATOR.reset_peak_usage();
        let results = run(&scene, &mut |_| {}).expect("every step of the benchmark is solved");
        let peak = (ALLOCATOR.peak_usage() - before) as f64 / 1e6;
        let entries: usize = results.bodies.iter().map(|body| body.factor_entries).sum();
        let factors = (entries * size_of::<f64>()) as f64 / 1e6;
        let unknowns: usize = results.bodies.iter().map(|body| body.dofs).sum();
        // The first run of a process pays once for the working memory of the thread pool.
        if shown {
            println!(
                "{unknowns:>8}   {factors:>10.1}   {peak:>7.1}   {:.2}",
                peak / factors
            );
        }
    }
}
