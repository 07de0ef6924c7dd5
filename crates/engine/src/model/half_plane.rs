//! Bodies of a line contact as the half-planes that they stand for.

use stickslip_fem_core::material::Isotropic;
use stickslip_scene::schema::{Hold, LoadKind};
use stickslip_scene::shape::{Curve, Edge, Role};
use stickslip_series::{Ground, HalfPlane, Lies, LineNodes};

use super::plan::{ContactPlan, Plan};

/// Whether the shape of the body with the index `index` stands for a half-plane.
pub(super) fn stands_for_one(plan: &Plan<'_>, index: usize) -> bool {
    face(plan, index).is_some()
}

/// The edge along which it touches.
pub(super) fn face(plan: &Plan<'_>, index: usize) -> Option<Edge> {
    let shape = plan.bodies[index].shape;
    shape
        .edge_with(Role::Cap)
        .or_else(|| shape.edge_with(Role::Surface))
}

/// The body with the index `index` as a half-plane; otherwise why it is none, as the end of a sentence about it.
pub(super) fn body(
    plan: &Plan<'_>,
    index: usize,
    (nodes, material): (LineNodes, &Isotropic),
    half: bool,
) -> Result<HalfPlane, String> {
    let own = &plan.bodies[index];
    let face = face(plan, index).ok_or("is neither a block nor a cylinder")?;
    let mut contacts = plan
        .contacts
        .iter()
        .filter(|contact| side(contact, index).is_some());
    let (Some(contact), None) = (contacts.next(), contacts.next()) else {
        return Err("does not touch along exactly one edge".into());
    };
    let free = freedom(plan, index, half)?;
    let [first, second] = &contact.sides;
    let partner = if first.body == index {
        second.body
    } else {
        first.body
    };
    let beside = if plan.is_rigid(partner) {
        plan.free_axes(partner)
    } else {
        let why = |why: String| format!("touches '{}', which {why}", plan.bodies[partner].name);
        freedom(plan, partner, half).map_err(why)?
    };
    let moves = |axis: usize| free[axis] || beside[axis];
    let held = |along: &str| {
        format!(
            "is held along {along}, and so is its partner: how far a half-plane gives has no limit, so that a force, and no motion, must press and push it; \
             free the platen along {along}"
        )
    };
    if !moves(1) {
        return Err(held("y"));
    }
    if !moves(0) && !half && contact.rubs() {
        return Err(held("x"));
    }
    let [low, high] = own.shape.bounds();
    let ground = Ground {
        lies: if face.role == Role::Surface {
            Lies::Below
        } else {
            Lies::Above
        },
        thickness: own.thickness(),
        // Not shorter than the edge, so that the compliance is positive definite.
        reference: (high[0] - low[0]).max(high[1] - low[1]),
        free: [free[0] && !half, free[1]],
    };
    HalfPlane::new(nodes, material, ground, &loads(plan, index)?)
        .map_err(|cause| format!("is no half-plane: {cause}"))
}

fn side(contact: &ContactPlan<'_>, index: usize) -> Option<usize> {
    contact.sides.iter().position(|side| side.body == index)
}

/// The straight edge that faces the contact, which stands for what is far away.
fn far_edge(plan: &Plan<'_>, index: usize) -> Option<Edge> {
    let edges = plan.bodies[index].shape.edges();
    let mut level = edges.into_iter().filter(|edge| edge.role == Role::Free);
    level.find(|edge| edge.level(1).is_some())
}

/// Along which axes the body moves freely. It must not turn.
fn freedom(plan: &Plan<'_>, index: usize, half: bool) -> Result<[bool; 2], String> {
    let far = far_edge(plan, index).ok_or("has no edge that faces the contact")?;
    let aside = |name: &str| {
        Err(format!(
            "is held on its edge '{name}', and what holds a half-plane is far away, on '{}'",
            far.name
        ))
    };
    if plan.is_sprung(index) {
        return Err("stands on springs".into());
    }
    let mut free = [true; 2];
    for support in plan.supports_of(index) {
        let Hold::Axes(axes) = support.hold else {
            return Err("has a skew support".into());
        };
        if support.on.set != far.name {
            return aside(&support.on.set);
        }
        if support.displacement != 0.0 {
            return Err("is moved by its support, and how far a half-plane gives has no limit: press it by a force".into());
        }
        free = [free[0] && !axes.x, free[1] && !axes.y];
    }
    let mut turns = free[1] && !half;
    for platen in plan.platens_of(index) {
        if platen.on.set != far.name {
            return aside(&platen.on.set);
        }
        free = [free[0] && platen.free.x, free[1] && platen.free.y];
        turns = false;
    }
    if turns {
        return Err(format!(
            "is free to turn, which a half-plane does not resist: put a platen on its edge '{}'",
            far.name
        ));
    }
    Ok(free)
}

/// The force of a unit of every load on the whole body, and of the displacements of supports.
fn loads(plan: &Plan<'_>, index: usize) -> Result<Vec<[f64; 2]>, String> {
    let far = far_edge(plan, index).ok_or("has no edge that faces the contact")?;
    let force = |load: &super::plan::Placed<'_, stickslip_scene::schema::Load>| {
        if load.body != index {
            return Ok([0.0; 2]);
        }
        let name = &load.of.name;
        if !matches!(
            load.of.kind,
            LoadKind::Force { .. } | LoadKind::Pressure { .. }
        ) {
            return Err(format!("has the load '{name}', neither force nor pressure"));
        }
        if load.edge.as_ref() != Some(&far) {
            return Err(format!(
                "has the load '{name}', and forces on a half-plane act far away, on '{}'",
                far.name
            ));
        }
        match (&load.of.kind, &far.curve) {
            (LoadKind::Force { direction, .. }, _) => Ok(*direction),
            (LoadKind::Pressure { .. }, Curve::Segment { ends: [from, to] }) => {
                // The body is on the left of the way from the first end to the second.
                let [x, y] = [0, 1].map(|axis| to[axis] - from[axis]);
                Ok([-y, x].map(|part| part * plan.bodies[index].thickness()))
            }
            _ => Err(format!("has the load '{name}', neither force nor pressure")),
        }
    };
    let forces = plan.loads.iter().map(force);
    forces.chain(std::iter::once(Ok([0.0; 2]))).collect()
}
