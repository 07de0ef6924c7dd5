//! Tests of the laws and of the contract, from outside the crate.

mod contract;
mod fibre_coverage;
mod files;
mod laws;
mod properties;
mod registry;

use stickslip_friction::{
    Coulomb, FibreCoverage, FrictionLaw, Kernel, Place, PlyFraction, PressurePower, SlipPath,
    SlipPower, StaticDynamic, Transition,
};

/// A point of a hole's edge, θ in degrees from the load axis.
fn on_hole(theta: f64) -> Place {
    let (sine, cosine) = theta.to_radians().sin_cos();
    Place {
        position: [cosine, sine],
        tangent: [-sine, cosine],
        material_angle: 0.0,
    }
}

/// Equal plies at these angles, in degrees.
fn equal_plies(angles: &[f64]) -> Vec<PlyFraction> {
    let fraction = 1.0 / angles.len() as f64;
    let ply = |angle: &f64| PlyFraction {
        angle: angle.to_radians(),
        fraction,
    };
    angles.iter().map(ply).collect()
}

fn coulomb(mu: f64) -> Box<dyn FrictionLaw> {
    Box::new(Coulomb::new(mu).unwrap())
}

/// The report's lay-up 0/60/−60 with V_f = 0.6 (Post & Reddy 1988, part I).
fn coverage(
    kernel: Kernel,
    fibre: Box<dyn FrictionLaw>,
    matrix: Box<dyn FrictionLaw>,
) -> FibreCoverage {
    FibreCoverage::new(equal_plies(&[0.0, 60.0, -60.0]), 0.6, kernel, fibre, matrix).unwrap()
}

/// Every law, in every variant. Stresses are of the order 100, slips of the order 0.001.
fn every_law() -> Vec<Box<dyn FrictionLaw>> {
    let swept = Kernel::Swept { kappa: 0.5 };
    let tangent = Kernel::Tangent { width: 0.1 };
    vec![
        coulomb(0.3),
        coulomb(0.0),
        Box::new(StaticDynamic::new(0.35, 0.3, Transition::Drop).unwrap()),
        Box::new(StaticDynamic::new(0.35, 0.3, Transition::Lagged).unwrap()),
        Box::new(StaticDynamic::new(0.3, 0.3, Transition::Drop).unwrap()),
        Box::new(StaticDynamic::allowing_strengthening(0.2, 0.3, Transition::Drop).unwrap()),
        Box::new(SlipPower::new(0.35, 0.25, 1e-3, 1.5, SlipPath::Committed).unwrap()),
        Box::new(SlipPower::new(0.35, 0.25, 1e-3, 1.5, SlipPath::Current).unwrap()),
        Box::new(
            SlipPower::allowing_strengthening(0.1, 0.4, 1e-3, 0.5, SlipPath::Current).unwrap(),
        ),
        Box::new(PressurePower::new(0.3, 100.0, 0.8).unwrap()),
        Box::new(PressurePower::new(0.3, 100.0, 1.0).unwrap()),
        Box::new(coverage(swept, coulomb(0.15), coulomb(0.35))),
        Box::new(coverage(
            tangent,
            Box::new(SlipPower::new(0.3, 0.2, 1e-3, 1.0, SlipPath::Current).unwrap()),
            Box::new(StaticDynamic::new(0.4, 0.3, Transition::Drop).unwrap()),
        )),
        Box::new(coverage(
            swept,
            Box::new(PressurePower::new(0.2, 50.0, 0.9).unwrap()),
            Box::new(coverage(tangent, coulomb(0.1), coulomb(0.2))),
        )),
    ]
}
