//! Bodies that are divided together: a cap and the surface that it touches.

use std::collections::BTreeMap;

use crate::model::ModelError;
use stickslip_scene::Scene;
use stickslip_scene::shape::Role;

/// The partner of every body with a cap or a surface, by name: those in contact, or the only cap with the only surface.
pub(super) fn of(scene: &Scene) -> Result<BTreeMap<&str, &str>, ModelError> {
    let with = |role: Role| -> Vec<&str> {
        let bodies = scene.bodies.iter();
        let fit = bodies.filter(|(_, body)| body.shape.edge_with(role).is_some());
        fit.map(|(name, _)| name.as_str()).collect()
    };
    let (mut caps, mut surfaces) = (with(Role::Cap), with(Role::Surface));
    let mut partners = BTreeMap::new();
    let mut join = |[cap, surface]: [_; 2]| partners.extend([(cap, surface), (surface, cap)]);
    for contact in &scene.contacts {
        let pair = [contact.first.body.as_str(), contact.second.body.as_str()];
        if caps.contains(&pair[0]) && surfaces.contains(&pair[1]) {
            caps.retain(|name| *name != pair[0]);
            surfaces.retain(|name| *name != pair[1]);
            join(pair);
        }
    }
    let alone = |body: &str, what: String| {
        Err(ModelError::MeshSettings {
            body: body.to_owned(),
            what,
        })
    };
    match (caps.as_slice(), surfaces.as_slice()) {
        ([], []) => {}
        (&[cap], &[surface]) => join([cap, surface]),
        (&[cap, ..], _) => {
            let what = format!("the cylinder '{cap}' needs a block that it touches");
            return alone(cap, what);
        }
        ([], &[surface, ..]) => {
            let what = format!("the block '{surface}' needs a cylinder to touch it");
            return alone(surface, what);
        }
    }
    Ok(partners)
}
