//! What a reader must know of a scene's geometry and mesh before or after it is solved.

use std::collections::BTreeSet;

use stickslip_contact::zones::Zone;

use super::meshes::lines;
use super::placement::radii;
use crate::results::{EdgeGeometry, EdgeKind};
use crate::scene::Scene;
use crate::scene::schema::{
    Body, Contact, Division, Grading, Hold, LoadKind, Outline, SetRef, Shape, Substance, Support,
};

/// Clearance, as a part of the hole's radius, from which pairing points at equal angles is told.
const WIDE_CLEARANCE: f64 = 0.1;

/// Remarks on the scene as it stands.
pub(super) fn of_scene(scene: &Scene) -> Vec<String> {
    let round = scene.contacts.iter().filter_map(|contact| {
        let radii = radii(scene, contact)?;
        Some([wide(contact, radii), bears_behind(scene, contact, radii)])
    });
    round.flatten().flatten().collect()
}

/// Circles of very different radius touch along a part of each that is not equally long.
fn wide(contact: &Contact, [hole, inner]: [f64; 2]) -> Option<String> {
    let part = 1.0 - inner / hole;
    (part > WIDE_CLEARANCE).then(|| {
        format!(
            "Contact '{}': the clearance is {:.0} % of the hole's radius. Points are paired at equal angles on the two circles, so \
             away from θ = 0 their places along the contact differ by as much.",
            contact.name,
            100.0 * part
        )
    })
}

/// Says where the loads press the two circles together at θ = 180° in place of θ = 0.
fn bears_behind(scene: &Scene, contact: &Contact, [hole, inner]: [f64; 2]) -> Option<String> {
    let steps = (0..scene.steps()).filter(|&step| push(scene, contact, step) > 0.0);
    let steps: Vec<usize> = steps.map(|step| step + 1).collect();
    let first = steps.first()?;
    let when = if steps.len() == scene.steps() {
        "the loads press".to_owned()
    } else {
        format!(
            "the loads of {} load steps, first {first}, press",
            steps.len()
        )
    };
    let play = if inner < hole {
        let play = scene.display.length.show(2.0 * (hole - inner));
        format!(", where they are {play} apart at the start because they touch at θ = 0")
    } else {
        String::new()
    };
    Some(format!(
        "Contact '{}': {when} {} and {} together at θ = 180°{play}. The bearing point, the fine mesh and the zones around it are \
         counted from θ = 0: turn the load, so that {} bears there.",
        contact.name, contact.first, contact.second, contact.first.body
    ))
}

/// Sign of the motion along x of the first side of a contact against the second at the end of a load step: 1 presses at
/// θ = 180°, −1 at θ = 0, 0 says nothing. A side that is held along x follows its supports, and one that is not its loads.
fn push(scene: &Scene, contact: &Contact, step: usize) -> f64 {
    let sides = [
        side(scene, contact, &contact.first.body),
        side(scene, contact, &contact.second.body),
    ];
    if !sides[0].is_disjoint(&sides[1]) {
        return 0.0;
    }
    let [first, second] = sides.map(|bodies| {
        if is_held(scene, &bodies) {
            (true, displacement(scene, &bodies))
        } else {
            (false, force(scene, &bodies, step))
        }
    });
    match (first, second) {
        ((true, one), (true, other)) => sign(one - other),
        ((false, force), _) if force != 0.0 => sign(force),
        (_, (false, force)) => sign(-force),
        _ => 0.0,
    }
}

fn sign(value: f64) -> f64 {
    if value == 0.0 { 0.0 } else { value.signum() }
}

/// The bodies that hang together with `body` without this contact.
fn side<'a>(scene: &'a Scene, without: &Contact, body: &'a str) -> BTreeSet<&'a str> {
    let mut bodies = BTreeSet::from([body]);
    loop {
        let before = bodies.len();
        for contact in scene.contacts.iter().filter(|one| one.name != without.name) {
            let pair = [contact.first.body.as_str(), contact.second.body.as_str()];
            if pair.iter().any(|body| bodies.contains(body)) {
                bodies.extend(pair);
            }
        }
        if bodies.len() == before {
            return bodies;
        }
    }
}

/// Whether something holds the bodies along x.
fn is_held(scene: &Scene, bodies: &BTreeSet<&str>) -> bool {
    let held = |support: &&Support| holds_x(support.hold);
    let mut supports = scene.supports.iter().filter(held);
    let mut platens = scene.platens.iter().filter(|platen| !platen.free.x);
    supports.any(|support| bodies.contains(support.on.body.as_str()))
        || platens.any(|platen| bodies.contains(platen.on.body.as_str()))
}

fn holds_x(hold: Hold) -> bool {
    match hold {
        Hold::Axes(axes) => axes.x,
        Hold::Direction(angle) => angle.cos().abs() > 1e-9,
    }
}

/// Displacement along x `[mm]` that supports give the bodies.
fn displacement(scene: &Scene, bodies: &BTreeSet<&str>) -> f64 {
    let given = scene.supports.iter().filter_map(|support| {
        let own = bodies.contains(support.on.body.as_str());
        match support.hold {
            Hold::Axes(axes) if own && axes.x => Some(support.displacement),
            Hold::Direction(angle) if own => Some(support.displacement * angle.cos()),
            _ => None,
        }
    });
    given.sum()
}

/// Force along x on the bodies `[N]` at the end of a load step, as far as forces and pressures on straight edges give one.
fn force(scene: &Scene, bodies: &BTreeSet<&str>, step: usize) -> f64 {
    let on_bodies = |on: &SetRef| bodies.contains(on.body.as_str());
    let loads = scene.loads.iter().map(|load| {
        let value = load.kind.steps().get(step).copied().unwrap_or(0.0);
        match &load.kind {
            LoadKind::Force { on, direction, .. } if on_bodies(on) => {
                // A component of rounding is none.
                let along = if direction[0].abs() < 1e-12 {
                    0.0
                } else {
                    direction[0]
                };
                along * value
            }
            LoadKind::Pressure { on, .. } if on_bodies(on) => value * facing_area(scene, on),
            _ => 0.0,
        }
    });
    loads.sum()
}

/// Area that a pressure on an edge pushes along +x `[mm²]`: that of the ends of a strip.
fn facing_area(scene: &Scene, on: &SetRef) -> f64 {
    let Some(Body {
        shape:
            Shape::PlateWithHole {
                outline: Outline::Strip { half_width, .. },
                ..
            },
        substance: Substance::Elastic { thickness, .. },
    }) = scene.bodies.get(&on.body)
    else {
        return 0.0;
    };
    match on.set.as_str() {
        "left" => 2.0 * half_width * thickness,
        "right" => -2.0 * half_width * thickness,
        _ => 0.0,
    }
}

/// Says if an end of contact on `edge` lies beyond the mesh's fine zone in any load step, with the farthest one; `steps` holds
/// the contact's zones for each step. Contact all around has no end, and a mesh of equal spacing no limit.
pub fn beyond_fine_zone(scene: &Scene, edge: &EdgeGeometry, steps: &[&[Zone]]) -> Option<String> {
    let (Division::Angular(grading) | Division::Linear(grading)) = scene.mesh.division else {
        return None;
    };
    let limit = fine_to(scene, edge, grading)?;
    let farthest = |zones: &&[Zone]| {
        let ends = zones
            .windows(2)
            .filter(|pair| pair[0].status.touches() != pair[1].status.touches())
            .map(|pair| pair[0].end.abs());
        ends.fold(0.0, f64::max)
    };
    let (step, reach) = steps
        .iter()
        .map(farthest)
        .enumerate()
        .max_by(|a, b| a.1.total_cmp(&b.1).then(b.0.cmp(&a.0)))?;
    // An end on the limit to rounding is not beyond it.
    if reach <= limit * (1.0 + 1e-9) {
        return None;
    }
    let show = |value: f64| match edge.kind {
        EdgeKind::Circle { .. } => format!("{:.1}°", value.to_degrees()),
        EdgeKind::Line => scene.display.length.show(value),
    };
    Some(format!(
        "Contact '{}' ends at ±{} in load step {}, beyond the fine part of its mesh, which ends at ±{}: stresses near that end are as \
         accurate as the coarser mesh there. mesh.fine_to moves the limit.",
        edge.name,
        show(reach),
        step + 1,
        show(limit)
    ))
}

/// Where the equal spacing ends: an angle `[rad]` or a length `[mm]`; `None` if it holds everywhere.
fn fine_to(scene: &Scene, edge: &EdgeGeometry, grading: Grading) -> Option<f64> {
    match edge.kind {
        EdgeKind::Circle { .. } => grading.fine_to,
        EdgeKind::Line => {
            let (Shape::Cylinder { half_length, .. } | Shape::Block { half_length, .. }) =
                scene.bodies.get(&edge.body)?.shape
            else {
                return None;
            };
            Some(lines::fine_to(grading.fine_to, half_length))
        }
    }
}
