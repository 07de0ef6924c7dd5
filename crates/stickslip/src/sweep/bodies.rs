//! What a condensed body depends on, as a text: equal texts are equal bodies.

use std::fmt::Write as _;

use stickslip_engine::model::obstacle_to_half;
use stickslip_scene::Scene;
use stickslip_scene::digest::sha256;
use stickslip_scene::placement::middle;
use stickslip_scene::schema::{Analysis, Body, LoadKind, Shape, SolverChoice, Substance};
use stickslip_scene::shape::Disk;

/// The key of the elastic body `name`; `None` for a rigid one, and for one whose material cannot be modelled.
pub(super) fn key(scene: &Scene, name: &str) -> Option<String> {
    let body = scene.bodies.get(name)?;
    let Body {
        substance,
        shape,
        position,
        ..
    } = body;
    let Substance::Elastic {
        material,
        thickness,
    } = substance
    else {
        return None;
    };
    let constants = scene.materials.get(material)?;
    let elastic = constants.in_plane(scene.analysis.plane).ok()?;
    // The mesh is that of the scene where the body has none of its own.
    let mut text = format!(
        "{name} {thickness} {:?} {:?} {:?} {:?} {:?} {:?}",
        elastic.stiffness(),
        elastic.thermal_strain(1.0),
        scene.mesh_of(name),
        middle(scene),
        of_bodies(scene.analysis),
        other_keys(body)
    );
    // Writing into a string does not fail.
    let _ = if shape.is_similar() && size_does_not_matter(scene, name) {
        write!(text, " {}", shape.name())
    } else {
        write!(text, " {shape:?} {position:?} {:?}", holders(scene, name))
    };
    for support in scene
        .supports
        .iter()
        .filter(|support| support.on.body == name)
    {
        let _ = write!(text, " {support:?}");
    }
    for springs in scene.springs.iter().filter(|own| own.on.body == name) {
        let _ = write!(text, " {springs:?}");
    }
    for platen in scene.platens.iter().filter(|platen| platen.on.body == name) {
        let _ = write!(text, " {platen:?}");
    }
    let mut slices = scene.fasteners.iter().flat_map(|own| &own.slices);
    let _ = write!(text, " {}", slices.any(|slice| slice == name));
    // The number of load cases counts, and which of them act here.
    for load in &scene.loads {
        let _ = write!(text, " {}", acting(&load.kind, name));
    }
    for contact in &scene.contacts {
        for side in [&contact.first, &contact.second] {
            if side.body == name {
                let _ = write!(text, " {side}");
            }
        }
    }
    Some(sha256(&text))
}

/// What of `analysis` a body depends on. A key that is not named here counts, so that a new one is not forgotten; below likewise.
fn of_bodies(analysis: Analysis) -> Analysis {
    Analysis {
        kinematics: None,
        compliance: None,
        solver: SolverChoice::Auto,
        experimental: false,
        substeps: None,
        ramp: None,
        accuracy: None,
        budget: None,
        memory: None,
        contact_nodes: None,
        ..analysis
    }
}

/// `body` without what is compared apart.
fn other_keys(body: &Body) -> Body {
    Body {
        substance: Substance::Rigid,
        shape: Shape::Disk(Disk { radius: 1.0 }),
        position: [0.0; 2],
        mesh: None,
        ..body.clone()
    }
}

/// What a model depends on beside friction laws and the sizes of loads; of the laws, whether they mirror.
pub(super) fn model_key(scene: &Scene) -> String {
    let mut text = format!(
        "{:?} {:?} {:?} {:?} {:?} {:?}",
        scene.analysis, scene.supports, scene.springs, scene.platens, scene.edges, scene.fasteners
    );
    // A law that does not mirror needs a whole model where another law needs half of it. Writing into a string does not fail.
    let _ = write!(text, "{:?}", obstacle_to_half(scene));
    for (name, body) in &scene.bodies {
        let other = match &body.substance {
            Substance::Elastic { material, .. } => {
                let own = scene.materials.get(material);
                own.map(|own| (own.angle(), own.yield_stress()))
            }
            Substance::Rigid => None,
        };
        let _ = write!(text, "\n{name} {body:?} {other:?} {:?}", key(scene, name));
        for load in &scene.loads {
            let _ = write!(text, " {}", acting(&load.kind, name));
        }
    }
    for contact in &scene.contacts {
        let _ = write!(text, "\n{}", contact.geometry());
    }
    sha256(&text)
}

/// Nothing but contact forces acts on the body, and nothing moves its supports: then its compliance is that of any size.
fn size_does_not_matter(scene: &Scene, name: &str) -> bool {
    let free_of_loads = scene
        .loads
        .iter()
        .all(|load| acting(&load.kind, name) == "-");
    let mut supports = scene
        .supports
        .iter()
        .filter(|support| support.on.body == name);
    free_of_loads && supports.all(|support| support.displacement == 0.0)
}

/// Shapes of the bodies that hold `name`, on which its place depends.
fn holders<'a>(scene: &'a Scene, name: &str) -> Vec<Option<&'a Body>> {
    let held = scene
        .contacts
        .iter()
        .filter(|contact| contact.second.body == name);
    held.map(|contact| scene.bodies.get(&contact.first.body))
        .collect()
}

/// A load without its history; "-" where it acts on another body.
fn acting(kind: &LoadKind, name: &str) -> String {
    let (body, text) = match kind {
        LoadKind::Force {
            on,
            direction,
            steps: _,
        } => (&on.body, format!("force {on} {direction:?}")),
        LoadKind::Bearing {
            on,
            direction,
            law,
            steps: _,
        } => (&on.body, format!("bearing {on} {direction:?} {law:?}")),
        LoadKind::Pressure { on, steps: _ } => (&on.body, format!("pressure {on}")),
        LoadKind::PolarTraction {
            on,
            table,
            steps: _,
        } => (&on.body, format!("traction {on} {table:?}")),
        LoadKind::Temperature { body, steps: _ } => (body, "temperature".to_owned()),
    };
    if body == name { text } else { "-".to_owned() }
}
