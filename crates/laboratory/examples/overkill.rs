//! Prints the profiles that stand for the answer of the aluminium history:
//!
//! ```text
//! cargo run --release -p stickslip-laboratory --example overkill -- frictional 0.28125 Q8
//! ```

use std::error::Error;

use stickslip_contact::Chain;
use stickslip_fem_core::mesh::ElementKind;
use stickslip_laboratory::references::aluminium::STEPS;
use stickslip_laboratory::{Pairing, Path, Problem, run};

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [case, spacing, element] = arguments.as_slice() else {
        return Err(
            "three arguments: frictionless or frictional, the spacing in degrees, the element"
                .into(),
        );
    };
    let problem = match case.as_str() {
        "frictionless" => Problem::AluminiumFrictionless,
        "frictional" => Problem::AluminiumFrictional,
        other => return Err(format!("'{other}' is neither frictionless nor frictional").into()),
    };
    let kind = ElementKind::ALL
        .into_iter()
        .find(|kind| format!("{kind:?}") == *element)
        .ok_or("no such element")?;
    let scene = problem.build(spacing.parse()?, kind, Pairing::NodePairs)?;
    let run = run(&scene, Path::Condensed(&Chain::default()))?;
    println!("# {}: {} unknowns.", problem.title(), run.unknowns);
    println!(
        "# cargo run --release -p stickslip-laboratory --example overkill -- {case} {spacing} {element}"
    );
    println!(
        "# step: peak pressure [MPa], contact half-angle [deg], hoop stress at 90 deg [MPa]; node: angle [deg], pressure [MPa], shear [MPa]"
    );
    println!("kind,step,first,second,third");
    for step in STEPS {
        let (geometry, edge) = (&run.results.edges[0], &run.results.steps[step].edges[0]);
        let (peak, _) = edge.peak_pressure.ok_or("no contact")?;
        let extent = edge.contact_half_extent.ok_or("no contact")?.to_degrees();
        let places = geometry.parameter.iter().map(|angle| angle.to_degrees());
        let net = places
            .clone()
            .position(|angle| (angle - 90.0).abs() < 1e-6)
            .ok_or("no node at 90 deg")?;
        let hoop = edge.rows[net].sigma_tangential;
        println!("step,{},{peak:.9},{extent:.6},{hoop:.9}", step + 1);
        for (row, angle) in edge.rows.iter().zip(places) {
            if angle < extent + 5.0 && angle >= 0.0 {
                println!(
                    "node,{},{angle:.6},{:.9},{:.9}",
                    step + 1,
                    row.pressure,
                    row.shear
                );
            }
        }
    }
    Ok(())
}
