//! A pinned joint: half of a strip whose end is driven, its hole on a rigid pin that is held.

use std::f64::consts::PI;
use std::sync::Arc;

use stickslip_contact::{Chain, ContactPair, ContactPoint, Stencil};
use stickslip_fem_core::generate::{
    Extent, Generate, Growth, Outline, PlateWithHole, uniform_angles,
};
use stickslip_fem_core::mesh::{ElementKind, Mesh};
use stickslip_fem_core::{HeldDirection, RigidBody};
use stickslip_friction::Coulomb;
use stickslip_joint::{Ending, Gauge, Joint, JointBody, Mark, Options, Pull};

use super::plies::{Breaking, held, laminate};
use crate::study::TaskError;

/// `[mm]`
const RADIUS: f64 = 3.0;
const OUTLINE: Outline = Outline::Strip {
    half_width: 6.0,
    left: 18.0,
    right: 12.0,
};
const FRICTION: f64 = 0.2;
/// Rows with the plies' own strengths are half a cell wide where 16 go along the half circle.
const BREAKING: Breaking = Breaking {
    kept: [0.01, 0.1],
    own: 0.5 * PI * RADIUS / 16.0,
};

/// Size of the cells on the hole `[mm]`, and largest load over D t `[MPa]`; on quadratic cells.
pub(super) fn strength(
    kind: ElementKind,
    cells: usize,
    has_bands: bool,
) -> Result<(f64, f64), TaskError> {
    let plate = PlateWithHole {
        hole_radius: RADIUS,
        outline: OUTLINE,
        extent: Extent::Half,
        angles: uniform_angles(Extent::Half, cells),
        layers: 3 * cells / 8,
        growth: Growth::Geometric { aspect: 1.0 },
        far_cells: (3 * cells).div_ceil(16),
        kind,
    };
    let mesh: Arc<Mesh> = Arc::new(plate.generate()?);
    let whole = laminate("[0/45/-45/90]s")?;
    let thickness = whole.thickness();
    let hole = mesh.edge_path("hole")?;
    let nodes = mesh.counter_clockwise(&hole, [0.0; 2]).nodes;
    let left = mesh.node_set("left")?;
    // A multiplier of one drives the left end by 1 mm.
    let supports = [
        held(mesh.node_set("symmetry")?, HeldDirection::Y, 0.0),
        held(left, HeldDirection::X, -1.0),
    ];
    let body = BREAKING.driven(&mesh, kind, &whole, supports, (&nodes, has_bands))?;
    let (pair, pin) = contact(&mesh, &nodes, thickness)?;
    let gauge = Gauge {
        pull: Pull::Contact {
            pair: 0,
            direction: [1.0, 0.0],
        },
        multiple: 2.0 / (2.0 * RADIUS * thickness),
        direction: [1.0, 0.0],
        first: Mark::Fixed,
        second: Mark::Node {
            body: 0,
            node: left[0],
        },
        free_travel: 0.0,
    };
    let options = Options {
        increments: 64,
        ..Options::default()
    };
    let bodies = vec![JointBody::Progressive(body), JointBody::Rigid(pin)];
    let joint = Joint::new(bodies, vec![pair], gauge)?.with_options(options)?;
    let history = joint.follow(&[vec![0.4]], &Chain::newton_first(), |_, _| {})?;
    if matches!(history.ending, Ending::Completed) {
        return Err("the joint bears more than its end is driven to".into());
    }
    let strength = history.strength().ok_or("the joint carries no load")?;
    Ok((PI * RADIUS / cells as f64, strength))
}

/// The pair of plate (body 0) and fitting pin (body 1) at the hole's nodes, of quadratic edges, and the pin.
fn contact(
    mesh: &Mesh,
    nodes: &[usize],
    thickness: f64,
) -> Result<(ContactPair, RigidBody), TaskError> {
    let positions: Vec<[f64; 2]> = nodes.iter().map(|&node| mesh.nodes()[node]).collect();
    let edge = 2.0 * PI * RADIUS / (nodes.len() - 1) as f64;
    let share = |k: usize| match (k % 2, k == 0 || k + 1 == nodes.len()) {
        (1, _) => 4.0 / 6.0,
        (_, true) => 1.0 / 6.0,
        _ => 2.0 / 6.0,
    };
    let points = positions.iter().enumerate().map(|(k, [x, y])| {
        let radius = x.hypot(*y);
        ContactPoint {
            first: Stencil::from(k),
            second: Stencil::from(k),
            normal: [x / radius, y / radius],
            gap: 0.0,
            area: thickness * edge * share(k),
            material_angle: 0.0,
        }
    });
    let pair = ContactPair {
        name: "pin".into(),
        origin: [0.0; 2],
        first: 0,
        second: 1,
        points: points.collect(),
        law: Arc::new(Coulomb::new(FRICTION)?),
    };
    Ok((pair, RigidBody::held(positions, 1)))
}
