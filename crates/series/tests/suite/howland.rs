//! A free hole in a long strip under tension (Howland 1930).

use std::f64::consts::FRAC_PI_2;

use stickslip_fem_core::body::BodyLoad;
use stickslip_fem_core::material::{Isotropic, PlaneState};
use stickslip_series::{Accuracy, Circle, EdgeLoad, Nodes, Outline, Plate};

/// d/W and K_t from the gross stress: table R5, a Fourier integral with a strip correction and a periodic row agree to 1e-7.
const FACTORS: [[f64; 2]; 5] = [
    [0.1, 3.036129],
    [0.2, 3.152567],
    [0.3, 3.374382],
    [0.4, 3.747154],
    [0.5, 4.347599],
];

#[test]
fn stress_concentrations_are_those_of_the_strip() {
    let material = Isotropic::new(1.0, 0.3, PlaneState::Stress).unwrap();
    // Six digits are given; the widest hole leaves 3e-4 on the outer edge, of which a hundredth part reaches the hole.
    for [ratio, expected] in FACTORS {
        let circle = Circle {
            centre: [0.0, 0.0],
            radius: 0.5 * ratio,
            thickness: 1.0,
        };
        // Ends two widths away, from where e^{−4.2 · 2} of what the hole disturbs comes back.
        let strip = Outline::strip(2.0, 2.0, 0.5);
        let pull = vec![
            EdgeLoad {
                edge: 1,
                force: [1.0, 0.0],
            },
            EdgeLoad {
                edge: 3,
                force: [-1.0, 0.0],
            },
        ];
        let nodes = Nodes::uniform_half(9).unwrap();
        let accuracy = Accuracy {
            tolerance: 1e-9,
            degree: 110,
        };
        let plate = Plate::new(nodes, &material, circle, &strip, &[pull], accuracy).unwrap();
        let state = BodyLoad {
            forces: &[0.0; 18],
            multipliers: &[1.0],
            motions: &[0.0],
        };
        let field = plate.field(&state).unwrap();
        let found = field.edge(FRAC_PI_2).hoop;
        assert!((found / expected - 1.0).abs() < 2e-6, "{ratio}: {found}");
    }
}
