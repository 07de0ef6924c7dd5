//! try
use stickslip_tests::Draft;
#[test]
fn smoke() {
    for element in ["T3", "Q4", "Q8"] {
        let d = Draft::pin().set("mesh.element", element).forces(0, &[1000.0]);
        let half = d.clone().set("analysis.model", "half").solve();
        let whole = d.set("analysis.model", "whole").solve();
        for name in ["plate", "pin"] {
            let mesh = |s: &stickslip_tests::Solution| s.elastic(s.body(name)).unwrap().mesh().clone();
            let (h, w) = (mesh(&half), mesh(&whole));
            let key = |p: &[f64; 2]| ((p[0] * 1e7).round() as i64, (p[1].abs() * 1e7).round() as i64);
            let hs: std::collections::BTreeSet<_> = h.nodes().iter().map(key).collect();
            let ws: std::collections::BTreeSet<_> = w.nodes().iter().map(key).collect();
            println!("{element} {name} half {} whole {} onlyhalf {} onlywhole {}", hs.len(), ws.len(), hs.difference(&ws).count(), ws.difference(&hs).count());
        }
        let b = half.body("plate");
        let (rh, rw) = (&half.records()[0], &whole.records()[0]);
        let n = half.solved.problem.points().len();
        for k in 0..n {
            let j = n - 1 + k;
            if j < whole.solved.problem.points().len() {
            println!("{k} {:?} {:e} {:e}", half.solved.problem.points()[k].place.position, rh.state.forces[2*k] - rw.state.forces[2*j], rh.state.forces[2*k+1]-rw.state.forces[2*j+1]); }
        }
        let _ = b;
    }
}
