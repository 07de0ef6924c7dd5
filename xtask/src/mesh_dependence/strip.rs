//! A strip of fibres along x with a crack along x in its middle, pulled along y; one quarter of it.

use std::f64::consts::PI;
use std::sync::Arc;

use stickslip_contact::Chain;
use stickslip_fem_core::generate::{Generate, Rectangle};
use stickslip_fem_core::mesh::{ElementKind, Mesh};
use stickslip_fem_core::{ElasticBody, HeldDirection, LoadCase, Support};
use stickslip_joint::{Gauge, Joint, JointBody, Mark, Options, ProgressiveBody, Pull};

use super::plies::{CONSTANTS, Kept, energies, laminate, models};
use super::{Strengths, Trouble};

/// Half the crack, and half of width and height `[mm]`.
pub(super) const CRACK: f64 = 4.0;
const SIDE: f64 = 12.0;
const KEPT: Kept = Kept {
    fibre: 1e-3,
    matrix: 1e-3,
};
/// Width of a row whose strengths are the plies' own `[mm]`.
pub(super) const OWN: f64 = 1.0;

/// Size of the cells `[mm]`, and mean stress `[MPa]` at which the strip breaks.
pub(super) fn strength(
    kind: ElementKind,
    cells: usize,
    strengths: Strengths,
) -> Result<(f64, f64), Trouble> {
    let rectangle = Rectangle::uniform([0.0, SIDE], [0.0, SIDE], [cells, cells], kind)?;
    let mesh: Arc<Mesh> = Arc::new(rectangle.generate()?);
    let whole = laminate("[0_4]")?;
    let models = models(&mesh, kind, &whole, KEPT, (strengths, OWN))?;
    let body = ProgressiveBody::with_models(Arc::new(quarter(&mesh)?), &[], models)?;
    let top = mesh.node_set("top")?[0];
    let gauge = Gauge {
        pull: Pull::Supports { body: 0 },
        multiple: 1.0 / (SIDE * whole.thickness()),
        direction: [0.0, 1.0],
        first: Mark::Node { body: 0, node: top },
        second: Mark::Fixed,
        free_travel: 0.0,
    };
    let options = Options {
        increments: 40,
        burst: 2,
        ..Options::default()
    };
    let joint = Joint::new(vec![JointBody::Progressive(Arc::new(body))], vec![], gauge)?;
    let joint = joint.with_options(options)?;
    let history = joint.follow(&[vec![0.1]], &Chain::newton_first(), |_, _| {})?;
    let strength = history.strength().ok_or("the strip carries no load")?;
    Ok((SIDE / cells as f64, strength))
}

/// The quarter, driven at its top; ahead of the crack its lower edge is held.
fn quarter(mesh: &Arc<Mesh>) -> Result<ElasticBody, Trouble> {
    let hold = |nodes: Vec<usize>, direction, displacement| Support {
        nodes,
        direction,
        displacement,
    };
    let ahead = |&node: &usize| mesh.nodes()[node][0] > CRACK - 1e-9;
    let lower = mesh.node_set("bottom")?.iter().copied();
    let supports = [
        hold(mesh.node_set("left")?.to_vec(), HeldDirection::X, 0.0),
        hold(lower.filter(ahead).collect(), HeldDirection::Y, 0.0),
        hold(mesh.node_set("top")?.to_vec(), HeldDirection::Y, 1.0),
    ];
    let case = LoadCase {
        moves_supports: true,
        ..LoadCase::default()
    };
    let whole = laminate("[0_4]")?;
    let material = Arc::new(whole.membrane_material()?);
    let body = ElasticBody::new(Arc::clone(mesh), vec![material], whole.thickness())?;
    Ok(body.with_supports(supports).with_load_cases(vec![case])?)
}

/// Mean stress `[MPa]` at which the crack runs by linear fracture mechanics: G = K² c (Sih, Paris & Irwin 1965) for a crack along
/// the fibres, K of a strip of finite width (Feddersen 1966).
pub(super) fn fracture_mechanics() -> Option<f64> {
    let [a11, a22, a66] = [CONSTANTS.e1, CONSTANTS.e2, CONSTANTS.g12].map(f64::recip);
    let a12 = -CONSTANTS.nu12 * a11;
    let ratio = (a22 / a11).sqrt() + (2.0 * a12 + a66) / (2.0 * a11);
    let compliance = (0.5 * a11 * a22).sqrt() * ratio.sqrt();
    let toughness = (energies(KEPT, OWN).matrix_tension? / compliance).sqrt();
    let width = (0.5 * PI * CRACK / SIDE).cos().sqrt();
    Some(toughness * width / (PI * CRACK).sqrt())
}
