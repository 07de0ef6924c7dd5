//! try
use stickslip_tests::Draft;
#[test]
fn smoke() {
    for element in ["Q4", "Q8", "Q9"] {
        for (hw, l, r) in [(20, 60, 20), (20, 60, 70), (20, 25, 22)] {
        let d = Draft::pin().set("mesh.element", element).forces(0, &[1000.0,2000.,500.]).set("bodies.plate.shape.plate_with_hole.outline.strip", format!("{{half_width=\"{hw} mm\",left=\"{l} mm\",right=\"{r} mm\"}}"));
        let half = d.clone().set("analysis.model", "half").solve();
        let whole = d.set("analysis.model", "whole").solve();
        let n = half.solved.problem.points().len();
        for s in 0..3 {
        let (rh, rw) = (&half.records()[s], &whole.records()[s]);
        let mut worst = 0.0_f64;
        for k in 1..n-1 {
            let j = n - 1 + k;
            for i in 0..2 { worst = worst.max((rh.state.forces[2*k+i] - rw.state.forces[2*j+i]).abs()); }
        }
        println!("{element} {hw} {l} {r} {worst:e}");
        }
        }
    }
}
