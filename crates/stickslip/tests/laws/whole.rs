//! The whole plate under its remote load against the truth and the localized analysis.

use std::sync::Arc;

use stickslip::experiment::whole::WholePlate;
use stickslip_hybrid::region::fit::{Amount, Smoothing};

use crate::common::{aluminium, measured_fields, scene, window};

#[test]
fn explore_whole() {
    let truth = aluminium(1.125);
    let own = scene(
        "pin-loaded-aluminium",
        &["mesh.spacing=\"4.5 deg\"", "mesh.coarse_spacing=\"9 deg\""],
    );
    let start = std::time::Instant::now();
    let plate = WholePlate::new(&own).unwrap();
    println!("{} nodes, {:?}", plate.nodes(), start.elapsed());
    let places = window(20.0, 0.5, 0.1);
    let data = measured_fields(
        &truth,
        Arc::clone(truth.own_law()),
        &[6, 9],
        &places,
        0.25,
        1,
    );
    for (step, data) in [6, 9].into_iter().zip(&data) {
        for share in [1.0, 0.4] {
            let smoothing = Smoothing {
                order: 3,
                amount: Amount::CrossValidated { share },
            };
            let found = plate.analyse(data, step, None, smoothing).unwrap();
            println!(
                "step {step} share {share}: {:?} {:?} force {:?} load {:?}",
                start.elapsed(),
                found.fit,
                found.force,
                found.load
            );
            for (angle, ratio, spread) in found.ratios().iter().step_by(2) {
                print!("{:.0}: {ratio:.3}±{spread:.3}; ", angle.to_degrees());
            }
            println!();
            for k in (0..found.angle.len()).step_by(4) {
                let n = found.angle.len();
                let d = |row: usize| found.tractions.covariance[row * 2 * n + row].sqrt();
                print!(
                    "{:.0}: {:.1}±{:.1} {:.2}±{:.2} b{:.2}; ",
                    found.angle[k].to_degrees(),
                    found.tractions.pressure[k],
                    d(k),
                    found.tractions.shear[k],
                    d(n + k),
                    found.shear_bias[k]
                );
            }
            println!();
        }
    }
}
