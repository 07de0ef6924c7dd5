//! Half or whole: no more than the scene needs.

use std::f64::consts::FRAC_PI_2;

use stickslip_fem_core::material::Material as _;
use stickslip_friction::Mirror;

use super::ModelError;
use super::plan::{ContactPlan, Placed, Plan};
use crate::results::Choice;
use stickslip_scene::schema::{Hold, Load, LoadKind, Material, ModelChoice};

/// Whether half of the scene is modelled: y ≥ 0 for round shapes, x ≥ 0 for line contacts.
pub(super) fn choose(plan: &Plan<'_>, choices: &mut Vec<Choice>) -> Result<bool, ModelError> {
    let (half, reason) = match (plan.analysis.model, obstacle(plan)) {
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
fn across(plan: &Plan<'_>) -> Option<usize> {
    let mut axes = plan.bodies.iter().map(|body| body.shape.mirror());
    let first = axes.next()??;
    axes.all(|other| other == Some(first)).then_some(first)
}

/// The line about which a half model mirrors the first body of `contact`; `None` where the shapes have no such line.
pub(super) fn mirror(plan: &Plan<'_>, contact: &ContactPlan<'_>) -> Option<Mirror> {
    let line = if across(plan)? == 1 { 0.0 } else { FRAC_PI_2 };
    let [first, _] = &contact.sides;
    Some(Mirror {
        line,
        material_angle: plan.bodies[first.body].material_angle(),
    })
}

/// What breaks the symmetry, if anything does.
pub(super) fn obstacle(plan: &Plan<'_>) -> Option<String> {
    let Some(across) = across(plan) else {
        let whole = plan.bodies.iter().find(|body| body.shape.is_placed());
        return Some(match whole {
            Some(body) => format!(
                "outlines and meshes of files are always modelled whole, and '{}' is one",
                body.name
            ),
            None => "the shapes have no common line of symmetry".into(),
        });
    };
    of_fasteners(plan)
        .or_else(|| of_materials(plan))
        .or_else(|| of_supports(plan, across))
        .or_else(|| of_edges(plan, across))
        .or_else(|| plan.loads.iter().find_map(|load| of_load(load, across)))
        .or_else(|| plan.contacts.iter().find_map(|own| of_law(plan, own)))
}

fn of_fasteners(plan: &Plan<'_>) -> Option<String> {
    let first = plan.fasteners.first()?;
    let name = &first.of.name;
    Some(format!("fastener '{name}' couples whole slices"))
}

fn of_materials(plan: &Plan<'_>) -> Option<String> {
    let mut bodies = plan.bodies.iter();
    let skew = bodies.find(|body| body.elastic.is_some_and(|own| !mirrors(own.material)))?;
    Some(format!(
        "the material axes of body '{}' are skew to the load axis",
        skew.name
    ))
}

fn of_supports(plan: &Plan<'_>, across: usize) -> Option<String> {
    if let Some(placed) = plan.springs.first() {
        return Some(format!("springs on {} are modelled whole", placed.of.on));
    }
    for placed in &plan.supports {
        let support = placed.of;
        let Hold::Axes(axes) = support.hold else {
            return Some(format!("the support on {} is skew", support.on));
        };
        if support.displacement != 0.0 && [axes.x, axes.y][across] {
            return Some(format!(
                "the support on {} moves across the line of symmetry",
                support.on
            ));
        }
        if lateral(placed, across).is_some() {
            return Some(format!("the support on {} has no mirror image", support.on));
        }
    }
    let mut platens = plan.platens.iter();
    let aside = platens.find(|platen| lateral(platen, across).is_some())?;
    Some(format!("the platen on {} has no mirror image", aside.of.on))
}

fn of_edges(plan: &Plan<'_>, across: usize) -> Option<String> {
    let mut edges = plan.edges.iter();
    let below = edges.find(|edge| lateral(edge, across) == Some(-1.0))?;
    let half = if across == 1 { "y ≥ 0" } else { "x ≥ 0" };
    Some(format!(
        "{} is to be reported, and the half {half} does not have it",
        below.of
    ))
}

fn of_load(load: &Placed<'_, Load>, across: usize) -> Option<String> {
    let is_aside = || lateral(load, across).is_some();
    let what = match &load.of.kind {
        LoadKind::Force { direction, .. } | LoadKind::Bearing { direction, .. }
            if direction[across].abs() > 1e-12 =>
        {
            "acts across the line of symmetry"
        }
        LoadKind::Force { .. } | LoadKind::Pressure { .. } if is_aside() => "acts on one side only",
        LoadKind::PolarTraction { table, .. } if !table.is_half() => "is not symmetric",
        _ => return None,
    };
    Some(format!("load '{}' {what}", load.of.name))
}

/// A law that does not claim to mirror breaks the symmetry.
fn of_law(plan: &Plan<'_>, contact: &ContactPlan<'_>) -> Option<String> {
    let mirror = mirror(plan, contact)?;
    let law = &contact.of.law;
    let axis = if mirror.line == 0.0 { "x" } else { "y" };
    (!law.is_symmetric(&mirror)).then(|| {
        format!(
            "the friction law '{}' of contact '{}' claims no symmetry about the {axis} axis",
            law.name(),
            contact.of.name
        )
    })
}

/// The side of the line of symmetry on which all of an edge lies; a half model leaves out the negative side.
fn lateral<T>(placed: &Placed<'_, T>, across: usize) -> Option<f64> {
    placed.edge.as_ref()?.side(across)
}

fn mirrors(material: &Material) -> bool {
    if let Material::Laminate(sheet) = material {
        let [x, y, shear] = sheet.membrane.thermal_strain(1.0);
        return sheet.membrane.symmetric_about_x() && shear.abs() <= 1e-12 * x.abs().max(y.abs());
    }
    let quarter_turns = material.angle() / FRAC_PI_2;
    matches!(material, Material::Isotropic { .. })
        || (quarter_turns - quarter_turns.round()).abs() < 1e-12
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;
    use crate::model::limits;
    use stickslip_fem_core::mesh::Point;
    use stickslip_scene::shape::Curve;
    use stickslip_scene::templates::TEMPLATES;
    use stickslip_scene::{Format, Scene};

    /// Ends of a slanted side above the line of symmetry y = 0.
    const ABOVE: [Point; 2] = [[0.0, 10.0], [-90.0, 20.0]];

    /// A pin-loaded plate whose left side is supported, and whose right side is glued to a platen.
    fn scene() -> Scene {
        let changes = [
            "supports=[{ on = \"plate.left\", fix = [\"y\"] }, { on = \"pin.centre\", fix = [\"x\", \"y\"] }]",
            "platens=[{ on = \"plate.right\", free = [\"x\"] }]",
            "edges=[{ on = \"plate.top\" }]",
        ];
        let text = TEMPLATES[0].text;
        Scene::from_text(text, Format::Toml, "pin.toml", Path::new(""), &changes).unwrap()
    }

    /// Moves the edge of `placed`.
    fn put<T>(placed: &mut Placed<'_, T>, ends: [Point; 2]) {
        placed.edge.as_mut().unwrap().curve = Curve::Segment { ends };
    }

    /// What `change` breaks of the symmetry.
    fn broken(change: impl Fn(&mut Plan<'_>)) -> String {
        let scene = scene();
        let mut plan = Plan::of(&scene);
        assert_eq!(obstacle(&plan), None);
        change(&mut plan);
        obstacle(&plan).unwrap()
    }

    #[test]
    fn what_is_on_a_slanted_side_has_no_mirror_image() {
        for (what, found) in [
            ("load", broken(|plan| put(&mut plan.loads[0], ABOVE))),
            ("support", broken(|plan| put(&mut plan.supports[0], ABOVE))),
            ("platen", broken(|plan| put(&mut plan.platens[0], ABOVE))),
        ] {
            assert!(found.contains(what), "{found}");
        }
    }

    #[test]
    fn a_slanted_side_below_the_line_is_left_out_of_a_half() {
        let below = ABOVE.map(|[x, y]| [x, -y]);
        let found = broken(|plan| put(&mut plan.edges[0], below));
        assert!(found.contains("does not have it"), "{found}");
    }

    #[test]
    fn a_slanted_side_is_not_reported() {
        let scene = scene();
        let mut plan = Plan::of(&scene);
        assert!(limits::check(&plan).is_ok());
        put(&mut plan.edges[0], ABOVE);
        assert!(limits::check(&plan).is_err());
    }
}
