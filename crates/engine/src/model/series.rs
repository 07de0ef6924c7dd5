//! Which bodies are modelled by series, and their operators.

mod round;

use std::f64::consts::PI;
use std::sync::Arc;

use stickslip_fem_core::mesh::ElementKind;
use stickslip_scene::Scene;
use stickslip_scene::schema::{BodyModel, Division, GapKind, Grading, MeshSettings, SetRef};
use stickslip_scene::shape::Role;
use stickslip_series::LineNodes;

use self::round::{Membrane, body, membrane, nodes};
use super::half_plane;
use super::meshes::on_line;
use super::plan::{Placed, Plan};
use super::{Model, ModelError};
use crate::results::Choice;
use crate::series::{SeriesBody, SeriesNodes};

/// Decides which bodies of `plan` are modelled by series, and puts their operators there, those of `known` where it has them.
pub(super) fn choose(
    plan: &mut Plan<'_>,
    scene: &Scene,
    known: Option<&Model>,
    half: bool,
    choices: &mut Vec<Choice>,
) -> Result<(), ModelError> {
    let mut asked: Vec<BodyModel> = scene.bodies.values().map(|body| body.model).collect();
    let explicit = asked.iter().any(|model| model.is_closed_form());
    let auto = !explicit && !plan.is_divided && !plan.contacts.is_empty();
    if asked.contains(&BodyModel::HalfPlane) {
        partners_too(plan, &mut asked)?;
        only_half_planes(plan, &asked)?;
    }
    let mut made = Vec::new();
    for (index, asked) in asked.iter().enumerate() {
        let wanted = match asked {
            BodyModel::Series | BodyModel::HalfPlane => true,
            BodyModel::Elements => false,
            BodyModel::Auto => auto || (explicit && !plan.is_divided),
        };
        if !wanted || plan.is_rigid(index) {
            continue;
        }
        let division = division(plan, scene, index);
        let is_line = half_plane::stands_for_one(plan, index);
        let ready = known.and_then(|model| model.bodies[index].series.clone());
        let ready = ready.filter(|ready| has_nodes(plan, index, &division, half, ready));
        let failure = scene.failure.as_ref();
        let is_followed = failure.is_some_and(|failure| failure.progressive.is_some());
        let made_of = match ready {
            _ if is_followed => {
                Err("is in a joint whose failure is followed, which elements do".into())
            }
            _ if is_projected(plan, index) => {
                Err("has a contact with a mortar projection, which elements do".into())
            }
            Some(ready) => Ok(ready),
            None if *asked == BodyModel::Series && is_line => Err(format!(
                "is a {}, which model = \"half-plane\" can be",
                plan.bodies[index].shape.name()
            )),
            None if explicit && is_line => line(plan, index, &division, half).map(Arc::new),
            None => body(plan, index, &division, half).map(Arc::new),
        };
        match made_of {
            Ok(body) => made.push((index, division, body)),
            Err(why) if asked.is_closed_form() => {
                let is_half_plane = is_line && *asked == BodyModel::HalfPlane;
                return Err(ModelError::NotSeries {
                    body: plan.bodies[index].name.to_owned(),
                    model: if is_half_plane {
                        "as a half-plane"
                    } else {
                        "by series"
                    },
                    why,
                });
            }
            // Without a mesh either all elastic bodies are series or none is, so that nodes of a pair fit.
            Err(_) if !explicit && is_line => {
                let (name, shape) = (plan.bodies[index].name, plan.bodies[index].shape.name());
                let why = format!(
                    "body '{name}' is a {shape}, whose outline model = \"half-plane\" would leave out"
                );
                return elements(plan, &why, choices);
            }
            Err(why) if !explicit => {
                let why = format!("body '{}' {why}", plan.bodies[index].name);
                return elements(plan, &why, choices);
            }
            Err(_) => {}
        }
    }
    if made.is_empty() {
        return elements(plan, "", choices);
    }
    put(plan, made, explicit, choices);
    Ok(())
}

/// Whether a contact of the body with the index `index` asks for a mortar projection. Bodies by series share their nodes, which are graded for pairs: a projection over
/// cells of such unequal widths makes pressures waver.
fn is_projected(plan: &Plan<'_>, index: usize) -> bool {
    plan.contacts.iter().any(|contact| {
        let touches = contact.sides.iter().any(|side| side.body == index);
        touches && contact.of.projection.is_mortar()
    })
}

/// Whether `ready` has the nodes that the body with the index `index` wants.
fn has_nodes(
    plan: &Plan<'_>,
    index: usize,
    division: &MeshSettings,
    half: bool,
    ready: &SeriesBody,
) -> bool {
    match ready.nodes() {
        SeriesNodes::Circle(known) => {
            nodes(plan, index, division, half).is_ok_and(|nodes| nodes == *known)
        }
        SeriesNodes::Line(known) => {
            line_nodes(plan, index, division, half).is_ok_and(|nodes| nodes == *known)
        }
    }
}

/// Puts the operators `made`, with the divisions of their bodies, into `plan`.
fn put(
    plan: &mut Plan<'_>,
    made: Vec<(usize, MeshSettings, Arc<SeriesBody>)>,
    explicit: bool,
    choices: &mut Vec<Choice>,
) {
    let names: Vec<&str> = made
        .iter()
        .map(|(index, ..)| plan.bodies[*index].name)
        .collect();
    let of_lines = made.iter().all(|(.., body)| body.line_nodes().is_some());
    choices.push(Choice {
        what: if of_lines { "half-planes" } else { "bodies by series" }.into(),
        value: names.join(", "),
        reason: if explicit {
            "the scene says so".into()
        } else {
            "circles without a mesh of the scene have a closed form and a fitted outer edge: no factorisation".into()
        },
    });
    for (index, mut division, body) in made {
        if let Some(nodes) = body.line_nodes() {
            // The same places, and few rows to show fields on.
            division.division = Division::Places(nodes.places().to_vec());
        }
        plan.bodies[index].mesh = division;
        plan.bodies[index].series = Some(body);
    }
}

/// Makes the elastic partners of half-planes half-planes as well, whose nodes have the same means, and refuses others.
fn partners_too(plan: &Plan<'_>, asked: &mut [BodyModel]) -> Result<(), ModelError> {
    for [first, second] in plan.pairs() {
        for (own, partner) in [(first, second), (second, first)] {
            if asked[own] != BodyModel::HalfPlane || plan.is_rigid(partner) {
                continue;
            }
            if asked[partner] == BodyModel::Auto {
                asked[partner] = BodyModel::HalfPlane;
            } else if asked[partner] == BodyModel::Elements {
                return Err(ModelError::NotSeries {
                    body: plan.bodies[own].name.to_owned(),
                    model: "as a half-plane",
                    why: format!(
                        "touches '{}', which is to be of elements, and a half-plane touches half-planes and rigid bodies",
                        plan.bodies[partner].name
                    ),
                });
            }
        }
    }
    Ok(())
}

/// Refuses around half-planes what they do not have: nodes of circles, other contact edges without a mesh, ties other than by nodes, facets, and further edges.
fn only_half_planes(plan: &Plan<'_>, asked: &[BodyModel]) -> Result<(), ModelError> {
    let refuse = |key: String, what: String| Err(ModelError::Unsupported { key, what });
    let is_asked = |index: usize| asked[index] == BodyModel::HalfPlane;
    if plan.analysis.contact_nodes.is_some() {
        let what = "contact_nodes are those of half circles, and half-planes touch along a line; give mesh.spacing instead, or leave it out";
        return refuse("analysis.contact_nodes".into(), what.into());
    }
    let mut lines = 0;
    for (number, contact) in plan.contacts.iter().enumerate() {
        let sides = [&contact.sides[0], &contact.sides[1]].map(|side| side.body);
        if !sides.into_iter().any(is_asked) {
            continue;
        }
        lines += 1;
        let name = &contact.of.name;
        if contact.of.projection.is_mortar() {
            let what = format!(
                "contact '{name}' is between half-planes, which are tied by pairs of nodes; leave projection out"
            );
            return refuse(format!("contacts.{number}.projection"), what);
        }
        if contact.of.gap == GapKind::Faceted {
            let what = format!(
                "contact '{name}' is between half-planes, which have no facets; say gap = \"exact\" or \"linearised\""
            );
            return refuse(format!("contacts.{number}.gap"), what);
        }
    }
    if lines > 1 && !plan.is_divided {
        let what = "several line contacts of half-planes need a mesh, because the program divides one of them by itself; give mesh.spacing and mesh.fine_to";
        return refuse("mesh".into(), what.into());
    }
    let far = |edge: &Placed<'_, SetRef>| {
        is_asked(edge.body)
            && edge
                .edge
                .as_ref()
                .is_none_or(|edge| edge.role == Role::Free)
    };
    match plan.edges.iter().position(far) {
        Some(number) => {
            let edge = plan.edges[number].of;
            let what = format!(
                "{edge} is an edge that a half-plane does not have, whose stresses no outline bounds; leave it out, or say model = \"elements\""
            );
            refuse(format!("edges.{number}.on"), what)
        }
        None => Ok(()),
    }
}

/// No body is a series, because of `why`.
fn elements(plan: &Plan<'_>, why: &str, choices: &mut Vec<Choice>) -> Result<(), ModelError> {
    if plan.analysis.contact_nodes.is_some() {
        return Err(ModelError::Unsupported {
            key: "analysis.contact_nodes".into(),
            what: "contact_nodes are those of bodies by series, and the scene has none; remove it, or the mesh".into(),
        });
    }
    if !why.is_empty() {
        choices.push(Choice {
            what: "bodies by series".into(),
            value: "none".into(),
            reason: format!("{why}: finite elements"),
        });
    }
    Ok(())
}

/// Where the contact nodes of a body by series lie: cells along its edge are linear, so that corners are all nodes.
fn division(plan: &Plan<'_>, scene: &Scene, index: usize) -> MeshSettings {
    let own = &plan.bodies[index].mesh;
    let nodes = plan.analysis.contact_nodes;
    let given = match nodes {
        Some(count) => MeshSettings {
            division: Division::Angular(Grading {
                spacing: PI / (count - 1) as f64,
                fine_to: None,
                coarse_spacing: None,
            }),
            ..own.clone()
        },
        None if scene.is_divided && own.element.order() > 1 => own.finer(),
        None => own.clone(),
    };
    MeshSettings {
        element: ElementKind::Q4,
        layers: None,
        fineness: own.fineness,
        ..given
    }
}

/// Contact nodes of the body with the index `index` as a half-plane; otherwise why there are none.
fn line_nodes(
    plan: &Plan<'_>,
    index: usize,
    division: &MeshSettings,
    half: bool,
) -> Result<LineNodes, String> {
    let face = half_plane::face(plan, index).ok_or("is neither a block nor a cylinder")?;
    let places = on_line(plan, index, division.clone(), &face.name, half);
    let places = places.map_err(|cause| cause.to_string())?;
    let nodes = if half {
        LineNodes::mirrored(places)
    } else {
        LineNodes::whole(places)
    };
    nodes.map_err(|cause| cause.to_string())
}

/// The body of a line contact with the index `index` as a half-plane; otherwise why it cannot be one.
fn line(
    plan: &Plan<'_>,
    index: usize,
    division: &MeshSettings,
    half: bool,
) -> Result<SeriesBody, String> {
    let Membrane::Isotropic(material) = membrane(plan, &plan.bodies[index])? else {
        return Err("is not isotropic".into());
    };
    let nodes = line_nodes(plan, index, division, half)?;
    let body = half_plane::body(plan, index, (nodes, &material), half)?;
    let [low, high] = plan.bodies[index].shape.bounds();
    Ok(SeriesBody::HalfPlane {
        body: Box::new(body),
        size: high[0].min(high[1] - low[1]),
    })
}
