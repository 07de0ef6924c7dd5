//! Half or whole: no more than the scene needs.

use std::f64::consts::FRAC_PI_2;

use stickslip_fem_core::material::Material as _;
use stickslip_friction::Mirror;

use super::{ModelError, contacts};
use crate::results::Choice;
use stickslip_scene::Scene;
use stickslip_scene::schema::{Contact, Hold, LoadKind, Material, ModelChoice, SetRef, Substance};

/// Whether half of the scene is modelled: y ≥ 0 for round shapes, x ≥ 0 for line contacts.
pub(super) fn choose(scene: &Scene, choices: &mut Vec<Choice>) -> Result<bool, ModelError> {
    let obstacle = obstacle(scene);
    let (half, reason) = match (scene.analysis.model, obstacle) {
        (ModelChoice::Whole, _) => (false, "the scene says so".to_owned()),
        (ModelChoice::Half, None) => (true, "the scene says so".to_owned()),
        (ModelChoice::Half, Some(why)) => return Err(ModelError::NotSymmetric(why)),
        (ModelChoice::Auto, None) => (
            true,
            "geometry, materials, friction laws, supports and loads are symmetric".to_owned(),
        ),
        (ModelChoice::Auto, Some(why)) => (false, why),
    };
    let value = if half { "half" } else { "whole" }.to_owned();
    choices.push(Choice {
        what: "model".into(),
        value,
        reason,
    });
    Ok(half)
}

/// Direction across the line of symmetry of the scene's shapes: y for round ones, x for line contacts.
fn across(scene: &Scene) -> Option<usize> {
    let mut axes = scene.bodies.values().map(|body| body.shape.mirror());
    let first = axes.next()??;
    axes.all(|other| other == Some(first)).then_some(first)
}

/// The line about which a half model of `scene` mirrors the first body of `contact`; `None` where the shapes have no such line.
pub fn mirror(scene: &Scene, contact: &Contact) -> Option<Mirror> {
    let (_, material_angle) = contacts::substance(scene, &contact.first.body);
    let line = if across(scene)? == 1 { 0.0 } else { FRAC_PI_2 };
    Some(Mirror {
        line,
        material_angle,
    })
}

/// What breaks the symmetry, if anything does.
pub fn obstacle(scene: &Scene) -> Option<String> {
    let Some(across) = across(scene) else {
        return Some("the shapes have no common line of symmetry".into());
    };
    for (name, body) in &scene.bodies {
        if let Substance::Elastic { material, .. } = &body.substance
            && scene
                .materials
                .get(material)
                .is_some_and(|material| !mirrors(material))
        {
            return Some(format!(
                "the material axes of body '{name}' are skew to the load axis"
            ));
        }
    }
    for support in &scene.supports {
        if matches!(support.hold, Hold::Direction(_)) {
            return Some(format!("the support on {} is skew", support.on));
        }
        let moves_across = match support.hold {
            Hold::Axes(axes) => [axes.x, axes.y][across],
            Hold::Direction(_) => false,
        };
        if support.displacement != 0.0 && moves_across {
            return Some(format!(
                "the support on {} moves across the line of symmetry",
                support.on
            ));
        }
        if lateral(scene, &support.on, across).is_some() {
            return Some(format!("the support on {} has no mirror image", support.on));
        }
    }
    for platen in &scene.platens {
        if lateral(scene, &platen.on, across).is_some() {
            return Some(format!("the platen on {} has no mirror image", platen.on));
        }
    }
    for edge in &scene.edges {
        if lateral(scene, edge, across).is_some_and(|at| at < 0.0) {
            let half = if across == 1 { "y ≥ 0" } else { "x ≥ 0" };
            return Some(format!(
                "{edge} is to be reported, and the half {half} does not have it"
            ));
        }
    }
    let of_loads = scene.loads.iter().find_map(|load| {
        let why = |what: &str| Some(format!("load '{}' {what}", load.name));
        match &load.kind {
            LoadKind::Force { direction, .. } | LoadKind::Bearing { direction, .. }
                if direction[across].abs() > 1e-12 =>
            {
                why("acts across the line of symmetry")
            }
            LoadKind::Force { on, .. } | LoadKind::Pressure { on, .. } => {
                if lateral(scene, on, across).is_some() {
                    why("acts on one side only")
                } else {
                    None
                }
            }
            LoadKind::PolarTraction { table, .. } if !table.is_half() => why("is not symmetric"),
            LoadKind::Bearing { .. }
            | LoadKind::PolarTraction { .. }
            | LoadKind::Temperature { .. } => None,
        }
    });
    of_loads.or_else(|| scene.contacts.iter().find_map(|own| of_law(scene, own)))
}

/// A law that does not claim to mirror breaks the symmetry.
fn of_law(scene: &Scene, contact: &Contact) -> Option<String> {
    let mirror = mirror(scene, contact)?;
    let axis = if mirror.line == 0.0 { "x" } else { "y" };
    let why = || {
        format!(
            "the friction law '{}' of contact '{}' claims no symmetry about the {axis} axis",
            contact.law.name(),
            contact.name
        )
    };
    (!contact.law.is_symmetric(&mirror)).then(why)
}

/// Where a straight edge that lies wholly on one side of the line of symmetry does so; a half model leaves out the negative side.
fn lateral(scene: &Scene, edge: &SetRef, across: usize) -> Option<f64> {
    scene
        .bodies
        .get(&edge.body)?
        .shape
        .edge(&edge.set)?
        .level(across)
}

fn mirrors(material: &Material) -> bool {
    if let Material::Laminate(sheet) = material {
        let [x, y, shear] = sheet.membrane.thermal_strain(1.0);
        return sheet.membrane.symmetric_about_x() && shear.abs() <= 1e-12 * x.abs().max(y.abs());
    }
    let quarter_turns = material.angle() / std::f64::consts::FRAC_PI_2;
    matches!(material, Material::Isotropic { .. })
        || (quarter_turns - quarter_turns.round()).abs() < 1e-12
}
