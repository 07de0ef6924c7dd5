//! A flat punch: an elastic block on rigid ground, its top moved down and sideways.
//!
//! The top is bonded to a rigid plate whose displacement is given, so the block is supported, and the plate's motion alone
//! would carry all its points along. With the top held,
//!
//! ```text
//! u = C λ + m₁ (0, −h) + m₂ (h, 0)
//! ```
//!
//! Under the whole base the pressure has singular corners, where slip begins: a problem in which every point touches and many
//! statuses are nearly equally good.

use std::sync::Arc;

use nalgebra::DVector;
use stickslip_contact::ContactState;
use stickslip_fem_core::generate::{Generate, Rectangle};
use stickslip_fem_core::material::{Isotropic, PlaneState};
use stickslip_fem_core::mesh::ElementKind;
use stickslip_fem_core::{ElasticBody, GivenBody, HeldDirection, InterfaceOperator, Support};
use stickslip_friction::{Coulomb, FrictionLaw};

use super::{Discrete, GroundPoint, on_ground};
use crate::error::LaboratoryError;

/// Width and height of the block `[length]`, its thickness being 1.
const WIDTH: f64 = 1.0;
const HEIGHT: f64 = 0.5;
/// Motion of the top `[length]` for a multiplier of 1.
const UNIT: f64 = 1e-3;
/// Multiplier of the push beside a press of 1: the corners slip, and for μ < 0.2 or so all but a few points.
const PUSH: f64 = 0.5;
const POISSON: f64 = 0.3;

/// A block with `nodes` ≥ 2 contact nodes, Young's modulus 1 and coefficient of friction `mu` `[1]`, in plane strain. Load cases:
/// the top moves down, and along x.
///
/// # Errors
/// [`LaboratoryError::Missing`] with the reason if there are too few nodes or `mu` is negative.
pub fn flat_punch(nodes: usize, mu: f64) -> Result<Discrete, LaboratoryError> {
    let name = format!("flat punch of {nodes} nodes, μ = {mu}");
    let law =
        Coulomb::new(mu).map_err(|cause| LaboratoryError::Missing(format!("{name}: {cause}")))?;
    let mut punch = flat_punch_under(nodes, Arc::new(law))?;
    punch.name = name;
    Ok(punch)
}

/// The same under any friction law.
///
/// # Errors
/// [`LaboratoryError::Missing`] with the reason if there are too few nodes.
pub fn flat_punch_under(
    nodes: usize,
    law: Arc<dyn FrictionLaw>,
) -> Result<Discrete, LaboratoryError> {
    let name = format!("flat punch of {nodes} nodes, {}", law.name());
    let refuse =
        |cause: &dyn std::fmt::Display| LaboratoryError::Missing(format!("{name}: {cause}"));
    let cells = nodes.saturating_sub(1);
    let mesh = Rectangle::uniform(
        [0.0, WIDTH],
        [0.0, HEIGHT],
        [cells, cells.div_ceil(2)],
        ElementKind::Q4,
    )
    .and_then(|rectangle| rectangle.generate())
    .map_err(|cause| refuse(&cause))?;
    let along = |y: f64| -> Vec<usize> {
        let mut found: Vec<usize> = (0..mesh.nodes().len())
            .filter(|&node| (mesh.nodes()[node][1] - y).abs() < 1e-9)
            .collect();
        found.sort_by(|&a, &b| mesh.nodes()[a][0].total_cmp(&mesh.nodes()[b][0]));
        found
    };
    let (base, top) = (along(0.0), along(HEIGHT));
    let held = [HeldDirection::X, HeldDirection::Y].map(|direction| Support {
        nodes: top.clone(),
        direction,
        displacement: 0.0,
    });
    let material =
        Isotropic::new(1.0, POISSON, PlaneState::Strain).map_err(|cause| refuse(&cause))?;
    let block = ElasticBody::new(Arc::new(mesh), vec![Arc::new(material)], 1.0)
        .and_then(|body| Arc::new(body.with_supports(held)).condense(&base))
        .map_err(|cause| refuse(&cause))?;
    // A condensed body has a compliance.
    let compliance = block.compliance().cloned().unwrap_or_default();
    let moved = |motion: [f64; 2]| DVector::from_fn(2 * base.len(), |i, _| UNIT * motion[i % 2]);
    let body = GivenBody::held(compliance, vec![moved([0.0, -1.0]), moved([1.0, 0.0])])?;
    let length = WIDTH / cells as f64;
    let points: Vec<GroundPoint> = (0..base.len())
        .map(|k| GroundPoint {
            normal: [0.0, 1.0],
            gap: 0.0,
            area: if k == 0 || k + 1 == base.len() {
                0.5 * length
            } else {
                length
            },
        })
        .collect();
    let problem = on_ground(&body, &points, law)?;
    Ok(Discrete {
        name,
        committed: ContactState::unloaded(&problem),
        problem,
        multipliers: vec![1.0, PUSH],
        coercive: true,
        solutions: None,
    })
}
