//! dev
use stickslip::scene::Scene;
fn main() {
    let args: Vec<String> = std::env::args().collect();
    let scene = match Scene::from_file(std::path::Path::new(&args[1]), &args[2..]) {
        Ok(s) => s,
        Err(e) => {
            eprintln!("{e:?}");
            std::process::exit(1)
        }
    };
    let r = match stickslip::run::run(&scene, &mut |_| {}) {
        Ok(r) => r,
        Err(e) => {
            eprintln!("{e}");
            std::process::exit(1)
        }
    };
    for c in &r.choices {
        println!("{}: {} ({})", c.what, c.value, c.reason);
    }
    for n in &r.notes {
        println!("note {n}");
    }
    for b in &r.bodies {
        println!(
            "{} dofs {} L {} modes {}",
            b.name, b.dofs, b.factor_entries, b.free_motions
        );
    }
    println!("{:?}", r.phases);
    let psi = 0.006894757293168361;
    let mut tot = 0;
    for (k, s) in r.steps.iter().enumerate() {
        let e = &s.edges[0];
        let g = &r.edges[0];
        tot += s.work.solves;
        let deg = |x: f64| {
            if matches!(g.kind, stickslip::results::EdgeKind::Circle { .. }) {
                x.to_degrees()
            } else {
                x
            }
        };
        println!(
            "{k:2} {:9.2} ext {:8.4} pk {:10.2} @ {:7.3} hoop {:10.2} @ {:6.2} h0 {:10.2} stick {:7.3} T/N {:.5} it {} piv {} inc {} cut {} doubt {} bal {:.1e} comp {:.1e} cone {:.1e} {:?} {:.4}s diss {:.6e}",
            s.loads[0].value,
            deg(e.contact_half_extent.unwrap_or(0.)),
            e.peak_pressure.map_or(0., |p| p.0) / psi,
            deg(e.peak_pressure.map_or(0., |p| p.1)),
            e.peak_hoop.map_or(0., |p| p.0) / psi,
            deg(e.peak_hoop.map_or(0., |p| p.1)),
            e.hoop_at_bearing_point.unwrap_or(0.) / psi,
            deg(e.stick_half_extent.unwrap_or(0.)),
            e.friction_force / e.normal_force,
            s.work.solves,
            s.work.pivots,
            s.increments,
            s.cutbacks,
            s.doubtful,
            s.balance_residual,
            s.residuals.complementarity,
            s.residuals.cone,
            s.solvers,
            s.seconds,
            s.dissipation
        );
        if std::env::var("ROWS").is_ok_and(|v| v == k.to_string()) {
            for (row, at) in e.rows.iter().zip(&g.parameter) {
                println!(
                    "   {:8.4} p {:10.3} q {:10.3} gap {:.4e} slip {:.4e} {} hoop {:10.3}",
                    deg(*at),
                    row.pressure / psi,
                    row.shear / psi,
                    row.gap,
                    row.slip,
                    row.status,
                    row.sigma_tangential / psi
                );
            }
        }
    }
    println!("total {tot}");
}
