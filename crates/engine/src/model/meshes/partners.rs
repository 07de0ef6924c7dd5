//! Bodies that are divided together: a cap and the surface that it touches.

use std::collections::BTreeMap;

use crate::model::ModelError;
use crate::model::plan::Plan;
use stickslip_scene::shape::Role;

/// The partner of every body with a cap or a surface, by index: those in contact, or the only cap with the only surface.
pub(super) fn of(plan: &Plan<'_>) -> Result<BTreeMap<usize, usize>, ModelError> {
    let with = |role: Role| -> Vec<usize> {
        let bodies = plan.bodies.iter().enumerate();
        let fit = bodies.filter(|(_, body)| body.shape.edge_with(role).is_some());
        fit.map(|(index, _)| index).collect()
    };
    let (mut caps, mut surfaces) = (with(Role::Cap), with(Role::Surface));
    let mut partners = BTreeMap::new();
    let mut join = |[cap, surface]: [_; 2]| partners.extend([(cap, surface), (surface, cap)]);
    for pair in plan.pairs() {
        if caps.contains(&pair[0]) && surfaces.contains(&pair[1]) {
            caps.retain(|body| *body != pair[0]);
            surfaces.retain(|body| *body != pair[1]);
            join(pair);
        }
    }
    let alone = |body: usize, kind: &str, needs: &str| {
        let body = plan.bodies[body].name;
        Err(ModelError::MeshSettings {
            body: body.to_owned(),
            what: format!("the {kind} '{body}' needs a {needs}"),
        })
    };
    match (caps.as_slice(), surfaces.as_slice()) {
        ([], []) => Ok(partners),
        (&[cap], &[surface]) => {
            join([cap, surface]);
            Ok(partners)
        }
        (&[cap, ..], _) => alone(cap, "cylinder", "block that it touches"),
        ([], &[surface, ..]) => alone(surface, "block", "cylinder to touch it"),
    }
}
