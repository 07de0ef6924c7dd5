//! A, B and D of a cross-ply and the load at which its first ply fails.
//!
//! ```text
//! cargo run --release -p stickslip-laminate --example first_ply
//! ```

use stickslip_laminate::failure::{criteria, first_ply_failure};
use stickslip_laminate::{
    Laminate, LaminateLoad, Layup, PlaneStiffness, Ply, PlyConstants, Strengths,
};

fn show(name: &str, unit: &str, matrix: &PlaneStiffness) {
    println!("{name} [{unit}]");
    for row in matrix {
        println!("  {:12.1} {:12.1} {:12.1}", row[0], row[1], row[2]);
    }
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    // T300/5208 (Tsai & Hahn 1980) in N, mm and K.
    let constants = PlyConstants {
        e1: 181_000.0,
        e2: 10_300.0,
        g12: 7_170.0,
        nu12: 0.28,
        alpha1: 0.02e-6,
        alpha2: 22.5e-6,
        thickness: 0.125,
    };
    let strengths = Strengths {
        s23: Some(123.0),
        zt: Some(40.0),
        zc: Some(246.0),
        ..Strengths::in_plane(1500.0, 1500.0, 40.0, 246.0, 68.0)
    };
    let PlyConstants { e1, e2, g12, .. } = constants;
    let ply = Ply::new(
        "T300/5208",
        constants,
        strengths.with_linear_strain_limits(e1, e2, g12),
    )?;
    let layup: Layup = "[0_2/90]s".parse()?;
    let laminate = Laminate::new(&layup, &ply)?;
    let stiffness = laminate.stiffness();
    show("A", "N/mm", &stiffness.membrane);
    show("B", "N", &stiffness.coupling);
    show("D", "N mm", &stiffness.bending);

    // Pulled along x with N_x = 1 N/mm, 150 K below the temperature of its cure.
    let load = LaminateLoad {
        temperature: -150.0,
        ..LaminateLoad::membrane([1.0, 0.0, 0.0])
    };
    println!("first-ply failure under N_x");
    for info in criteria() {
        let first = first_ply_failure(&laminate, &load, (info.make)().as_ref())?;
        let found = first.assessment;
        println!(
            "  {:13} {:7.2} N/mm, ply at {:2.0}°, {}",
            info.name, found.reserve_factor, first.angle, found.mode
        );
    }
    Ok(())
}
