//! dev
use std::time::Instant;
use stickslip::model::{Model, ModelBodyKind};
use stickslip::scene::Scene;
use stickslip_fem_core::linalg::{LowerMatrix, reference_factorisation};
fn main() {
    let args: Vec<String> = std::env::args().collect();
    let scene = Scene::from_file(std::path::Path::new(&args[1]), &args[2..]).unwrap();
    let model = Model::build(&scene).unwrap();
    let mut all = LowerMatrix {
        column_start: vec![0],
        ..Default::default()
    };
    for b in &model.bodies {
        if let ModelBodyKind::Elastic(e) = &b.kind {
            let t = Instant::now();
            let st = e.analyse(&b.interface).unwrap();
            let t1 = t.elapsed().as_secs_f64();
            let t = Instant::now();
            let m = st.stiffness(e);
            let t2 = t.elapsed().as_secs_f64();
            let t = Instant::now();
            let c = stickslip_fem_core::CondensedBody::new(e.clone(), st.clone()).unwrap();
            let t3 = t.elapsed().as_secs_f64();
            println!(
                "{} n {} analyse {t1:.3} assemble {t2:.3} condense(all numeric) {t3:.3} L {} MB",
                b.name,
                m.order(),
                c.factor_bytes() / 1_000_000
            );
            let off = all.order();
            let base = *all.column_start.last().unwrap();
            all.column_start
                .extend(m.column_start[1..].iter().map(|s| s + base));
            all.rows.extend(m.rows.iter().map(|r| r + off));
            all.values.extend(&m.values);
        }
    }
    for threads in [1, 2] {
        for _ in 0..2 {
            let t = Instant::now();
            let l = reference_factorisation(&all, threads).unwrap();
            println!(
                "reference {} n {} threads {threads}: {:.3} L {l}",
                all.order(),
                all.order(),
                t.elapsed().as_secs_f64()
            );
        }
    }
    for _ in 0..2 {
        let t = Instant::now();
        let s = stickslip::run::run(&scene, &mut |_| {}).unwrap();
        println!("run {:.3} {:?}", t.elapsed().as_secs_f64(), s.phases);
    }
}
