//! try
use stickslip_tests::Draft;
#[test]
fn smoke() {
    for element in ["T3", "T6", "Q4", "Q8", "Q9"] {
        for spacing in [9, 15] {
            for model in ["half", "whole"] {
                let t = std::time::Instant::now();
                let d = Draft::pin().set("mesh.element", element).set("mesh.spacing", format!("{spacing} deg")).set("analysis.model", model).forces(0, &[1000.0, 2000.0, 0.0, 1500.0]);
                let r = d.run();
                println!("{element} {spacing} {model} {:?} nodes {:?} {:?}", t.elapsed(), r.bodies.iter().map(|b| b.dofs).collect::<Vec<_>>(), r.steps.iter().map(|s| (s.edges[0].resultant[0], s.balance_residual, s.edges[0].contact_half_extent.map(|x| x.to_degrees()))).collect::<Vec<_>>());
            }
        }
    }
    let r = Draft::cylinder().run();
    println!("{:?} {:?}", r.steps[0].edges[0].resultant, r.bodies.iter().map(|b| b.dofs).collect::<Vec<_>>());
}
