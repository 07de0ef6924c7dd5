//! A strip of fibres along x with a crack along x in its middle, pulled along y; one quarter of it.

use std::f64::consts::PI;
use std::sync::Arc;

use stickslip_contact::Chain;
use stickslip_fem_core::HeldDirection;
use stickslip_fem_core::generate::{Generate, Rectangle};
use stickslip_fem_core::mesh::{ElementKind, Mesh};
use stickslip_joint::{Gauge, Joint, JointBody, Mark, Options, Pull};

use super::plies::{Breaking, CONSTANTS, held, laminate};
use crate::study::TaskError;

/// Half the crack, and half of width and height `[mm]`.
const CRACK: f64 = 4.0;
const SIDE: f64 = 12.0;
const BREAKING: Breaking = Breaking {
    kept: [1e-3; 2],
    own: 1.0,
};

/// Size of the cells `[mm]`, and mean stress `[MPa]` at which the strip breaks; driven at its top, ahead of the crack its lower edge is
/// held.
pub(super) fn strength(
    kind: ElementKind,
    cells: usize,
    has_bands: bool,
) -> Result<(f64, f64), TaskError> {
    let rectangle = Rectangle::uniform([0.0, SIDE], [0.0, SIDE], [cells, cells], kind)?;
    let mesh: Arc<Mesh> = Arc::new(rectangle.generate()?);
    let whole = laminate("[0_4]")?;
    let lower = mesh.node_set("bottom")?.iter().copied();
    let ahead: Vec<usize> = lower
        .filter(|&node| mesh.nodes()[node][0] > CRACK - 1e-9)
        .collect();
    let top = mesh.node_set("top")?;
    let supports = [
        held(mesh.node_set("left")?, HeldDirection::X, 0.0),
        held(&ahead, HeldDirection::Y, 0.0),
        held(top, HeldDirection::Y, 1.0),
    ];
    let body = BREAKING.driven(&mesh, kind, &whole, supports, (&[], has_bands))?;
    let gauge = Gauge {
        pull: Pull::Supports { body: 0 },
        multiple: 1.0 / (SIDE * whole.thickness()),
        direction: [0.0, 1.0],
        first: Mark::Node {
            body: 0,
            node: top[0],
        },
        second: Mark::Fixed,
        free_travel: 0.0,
    };
    let options = Options {
        increments: 40,
        burst: 2,
        ..Options::default()
    };
    let joint = Joint::new(vec![JointBody::Progressive(body)], vec![], gauge)?;
    let joint = joint.with_options(options)?;
    let history = joint.follow(&[vec![0.1]], &Chain::newton_first(), |_, _| {})?;
    let strength = history.strength().ok_or("the strip carries no load")?;
    Ok((SIDE / cells as f64, strength))
}

/// Mean stress `[MPa]` at which the crack runs by linear fracture mechanics: G = K² c (Sih, Paris & Irwin 1965) for a crack along
/// the fibres, K of a strip of finite width (Feddersen 1966).
pub(super) fn fracture_mechanics() -> Result<f64, TaskError> {
    let [a11, a22, a66] = [CONSTANTS.e1, CONSTANTS.e2, CONSTANTS.g12].map(f64::recip);
    let a12 = -CONSTANTS.nu12 * a11;
    let ratio = (a22 / a11).sqrt() + (2.0 * a12 + a66) / (2.0 * a11);
    let compliance = (0.5 * a11 * a22).sqrt() * ratio.sqrt();
    let energy = BREAKING
        .energies()
        .matrix_tension
        .ok_or("no fracture energy")?;
    let width = (0.5 * PI * CRACK / SIDE).cos().sqrt();
    Ok((energy / compliance).sqrt() * width / (PI * CRACK).sqrt())
}
