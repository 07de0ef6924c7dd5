//! Which bodies are modelled by series, and their operators.

use std::f64::consts::PI;
use std::sync::Arc;

use stickslip_fem_core::material::{Isotropic, Material, PlaneState, PlaneStiffness};
use stickslip_fem_core::mesh::{ElementKind, Point};
use stickslip_scene::Scene;
use stickslip_scene::schema::{
    BodyModel, Division, GapKind, Grading, Hold, LoadKind, MeshSettings, ProjectionChoice, SetRef,
};
use stickslip_scene::shape::{Curve, Role};
use stickslip_series::{
    Accuracy, Anchor, Circle, Disk, DiskLoad, EdgeLoad, LineNodes, Nodes, Outline, Plate,
};

use super::half_plane;
use super::meshes::{on_circles, on_line};
use super::plan::{BodyPlan, Placed, Plan};
use super::{Model, ModelError};
use crate::results::Choice;
use crate::series::{SeriesBody, SeriesNodes, is_isotropic};

/// Fit of the outer edge of an anisotropic plate. Near its corners stresses are less smooth than in an isotropic one, which matters little on the hole.
const ANISOTROPIC: Accuracy = Accuracy {
    tolerance: 5e-3,
    degree: 150,
};
/// Part of the mean traction that may be left on an outer edge; about a hundredth of it, 2e-4, shows on the hole.
const LARGEST_RESIDUAL: f64 = 2e-2;

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
        let ready = known.and_then(|model| model.bodies[index].series.clone());
        let fits = |ready: &Arc<SeriesBody>| match ready.nodes() {
            SeriesNodes::Circle(known) => {
                nodes(plan, index, &division, half).is_ok_and(|nodes| nodes == *known)
            }
            SeriesNodes::Line(known) => {
                line_nodes(plan, index, &division, half).is_ok_and(|nodes| nodes == *known)
            }
        };
        let ready = ready.filter(fits);
        let is_line = half_plane::stands_for_one(plan, index);
        let failure = scene.failure.as_ref();
        let is_followed = failure.is_some_and(|failure| failure.progressive.is_some());
        let made_of = match ready {
            _ if is_followed => {
                Err("is in a joint whose failure is followed, which elements do".into())
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
                return Err(ModelError::NotSeries {
                    body: plan.bodies[index].name.to_owned(),
                    model: if is_line && *asked == BodyModel::HalfPlane {
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
    Ok(())
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
        if !matches!(
            contact.of.projection,
            ProjectionChoice::Auto | ProjectionChoice::Nodes
        ) {
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

/// The body with the index `index` as a series; otherwise why it cannot be one, as the end of a sentence about it.
fn body(
    plan: &Plan<'_>,
    index: usize,
    division: &MeshSettings,
    half: bool,
) -> Result<SeriesBody, String> {
    let own = &plan.bodies[index];
    let given = Given {
        plan,
        index,
        half,
        material: membrane(plan, own)?,
        nodes: nodes(plan, index, division, half)?,
        circle: circle(plan, index)?,
    };
    given.free_of_others()?;
    let edges = own.shape.edges();
    let straight = edges
        .iter()
        .filter_map(|edge| match edge.curve {
            Curve::Segment { ends } => Some((edge.name.as_ref(), ends)),
            _ => None,
        })
        .collect::<Vec<_>>();
    match edges.len() - straight.len() {
        1 if straight.is_empty() => given.disk(),
        1 => given.plate(&straight),
        _ => Err(format!(
            "is a {} with several curved edges",
            own.shape.name()
        )),
    }
}

/// What a body by series is made of.
struct Given<'a> {
    plan: &'a Plan<'a>,
    index: usize,
    half: bool,
    material: Membrane,
    nodes: Nodes,
    circle: Circle,
}

/// What a body is made of in its plane.
enum Membrane {
    Isotropic(Isotropic),
    Anisotropic(Box<dyn Material>),
}

impl Given<'_> {
    /// Nothing is on the body that series do not hold.
    fn free_of_others(&self) -> Result<(), String> {
        if self.plan.platens_of(self.index).next().is_some() {
            return Err("has a platen".into());
        }
        let mut loads = self.plan.loads.iter();
        let other = loads.find(|load| {
            load.body == self.index
                && matches!(
                    load.of.kind,
                    LoadKind::Bearing { .. }
                        | LoadKind::PolarTraction { .. }
                        | LoadKind::Temperature { .. }
                )
        });
        match other {
            Some(load) => Err(format!(
                "has the load '{}', neither force nor pressure",
                load.of.name
            )),
            None => Ok(()),
        }
    }

    fn disk(self) -> Result<SeriesBody, String> {
        let Membrane::Isotropic(material) = &self.material else {
            return Err("is not isotropic".into());
        };
        let mut displacement = [0.0; 2];
        let mut held = [false; 2];
        let mut anchor = None;
        let shape = self.plan.bodies[self.index].shape;
        let supports = self.plan.supports.iter();
        for support in supports.filter(|support| support.body == self.index) {
            let Hold::Axes(axes) = support.of.hold else {
                return Err("has a skew support".into());
            };
            if support.edge.is_some() {
                return Err("is held along its rim".into());
            }
            let own = if shape.is_area(&support.of.on.set) {
                Anchor::Area
            } else {
                Anchor::default()
            };
            if *anchor.get_or_insert(own) != own {
                return Err("is held at its centre and over its section".into());
            }
            for (axis, own) in [axes.x, axes.y].into_iter().enumerate() {
                if own {
                    held[axis] = true;
                    displacement[axis] = support.of.displacement;
                }
            }
        }
        if self.half {
            held[1] = held[0];
            displacement[1] = 0.0;
        }
        if held[0] != held[1] {
            return Err("is held along one axis only".into());
        }
        let mut loads = Vec::new();
        for load in &self.plan.loads {
            let mut own = DiskLoad::default();
            if load.body == self.index {
                match &load.of.kind {
                    LoadKind::Force { on, direction, .. } if shape.is_area(&on.set) => {
                        if *anchor.get_or_insert(Anchor::Area) != Anchor::Area {
                            return Err("is held at its centre and loaded over its section".into());
                        }
                        own.force = *direction;
                    }
                    _ => return Err(format!("has the load '{}' on its rim", load.of.name)),
                }
            }
            loads.push(own);
        }
        loads.push(DiskLoad {
            displacement,
            ..DiskLoad::default()
        });
        let make = if held[0] { Disk::held } else { Disk::floating };
        let anchor = anchor.unwrap_or_default();
        let disk = make(self.nodes, material, self.circle, anchor, &loads);
        let disk = disk.map_err(|cause| cause.to_string())?;
        Ok(SeriesBody::Disk(Box::new(disk)))
    }

    fn plate(self, straight: &[(&str, [Point; 2])]) -> Result<SeriesBody, String> {
        if self.plan.supports_of(self.index).next().is_some() {
            return Err("is held along an outer edge".into());
        }
        let order = cycle(straight).ok_or("has an outline that is not closed")?;
        let centre = self.plan.bodies[self.index].centre;
        let moved = |point: Point| [point[0] + centre[0], point[1] + centre[1]];
        let vertices = order
            .iter()
            .map(|&edge| moved(straight[edge].1[0]))
            .collect();
        let mut loads = Vec::new();
        for load in &self.plan.loads {
            let name = load
                .edge
                .as_ref()
                .filter(|_| load.body == self.index)
                .map(|edge| edge.name.as_ref());
            let Some(name) = name else {
                loads.push(Vec::new());
                continue;
            };
            let on = order.iter().position(|&edge| straight[edge].0 == name);
            let edge = on.ok_or_else(|| format!("has the load '{}' on its hole", load.of.name))?;
            let ends = straight[order[edge]].1;
            loads.push(vec![EdgeLoad {
                edge,
                force: self.force(&load.of.kind, ends),
            }]);
        }
        loads.push(Vec::new());
        let outline = Outline::new(vertices);
        let (nodes, circle) = (self.nodes, self.circle);
        let plate = match &self.material {
            Membrane::Isotropic(material) => Plate::new(
                nodes,
                material,
                circle,
                &outline,
                &loads,
                Accuracy::default(),
            ),
            Membrane::Anisotropic(material) => Plate::anisotropic(
                nodes,
                material.as_ref(),
                circle,
                &outline,
                &loads,
                ANISOTROPIC,
            ),
        };
        let plate = plate.map_err(|cause| format!("has no series: {cause}"))?;
        let residual = plate.fit().residual;
        if residual > LARGEST_RESIDUAL {
            return Err(format!(
                "has an outer edge on which polynomials leave {residual:.1e} of the mean traction"
            ));
        }
        Ok(SeriesBody::Plate(Box::new(plate)))
    }

    /// The force of a unit load on an edge between `ends`, of the whole body.
    fn force(&self, kind: &LoadKind, ends: [Point; 2]) -> [f64; 2] {
        match kind {
            LoadKind::Force { direction, .. } => *direction,
            LoadKind::Pressure { .. } => {
                // The body is on the left of the way from the first end to the second.
                let [x, y] = [0, 1].map(|axis| ends[1][axis] - ends[0][axis]);
                [-y, x].map(|part| part * self.circle.thickness)
            }
            _ => [0.0; 2],
        }
    }
}

/// The order in which the edges follow each other with the body on the left, beginning with the first.
fn cycle(edges: &[(&str, [Point; 2])]) -> Option<Vec<usize>> {
    let mut order = vec![0];
    while order.len() < edges.len() {
        let end = edges[*order.last()?].1[1];
        let next = edges.iter().position(|(_, [start, _])| *start == end)?;
        if order.contains(&next) {
            return None;
        }
        order.push(next);
    }
    Some(order)
}

/// The circle of the body's only contact.
fn circle(plan: &Plan<'_>, index: usize) -> Result<Circle, String> {
    let own = &plan.bodies[index];
    let sides = plan.contacts.iter().flat_map(|contact| &contact.sides);
    let mut touching = sides.filter(|side| side.body == index);
    let (Some(side), None) = (touching.next(), touching.next()) else {
        return Err("does not touch along exactly one edge".into());
    };
    let round = (side.edge.as_ref()).filter(|edge| matches!(edge.role, Role::Hole | Role::Rim));
    let Some(Curve::Circle { centre, radius }) = round.map(|edge| edge.curve) else {
        return Err("touches along an edge that is not a closed circle".into());
    };
    Ok(Circle {
        centre: [0, 1].map(|axis| own.centre[axis] + centre[axis]),
        radius,
        thickness: own.thickness(),
    })
}

/// Contact nodes, in the order in which results stand along a circle.
fn nodes(
    plan: &Plan<'_>,
    index: usize,
    division: &MeshSettings,
    half: bool,
) -> Result<Nodes, String> {
    let own = BodyPlan {
        mesh: division.clone(),
        series: None,
        ..plan.bodies[index].clone()
    };
    if !own.shape.is_round() {
        return Err(format!("is a {}", own.shape.name()));
    }
    let angles = on_circles(&own, half).map_err(|cause| cause.to_string())?;
    let seated = |angles: Vec<f64>| match &own.seat {
        Some(seat) => angles.into_iter().map(|angle| seat.facing(angle)).collect(),
        None => angles,
    };
    let made = if half {
        Nodes::mirrored(seated(angles))
    } else {
        let back = |angle: f64| {
            if angle > PI - 1e-9 {
                angle - 2.0 * PI
            } else {
                angle
            }
        };
        let mut angles: Vec<f64> = angles.into_iter().map(back).collect();
        angles.sort_by(f64::total_cmp);
        Nodes::circle(seated(angles))
    };
    made.map_err(|cause| format!("has no series: {cause}"))
}

/// The material of the body in its plane, of a laminate that of its membrane.
fn membrane(plan: &Plan<'_>, own: &BodyPlan<'_>) -> Result<Membrane, String> {
    let material = own.elastic.ok_or("is rigid")?.material;
    let material = material
        .in_plane(plan.analysis.plane)
        .map_err(|cause| cause.to_string())?;
    if is_isotropic(&material.stiffness()) {
        isotropic(&material.stiffness()).map(Membrane::Isotropic)
    } else {
        Ok(Membrane::Anisotropic(material))
    }
}

/// The isotropic material with the plane stiffness `d`, in plane stress.
fn isotropic(d: &PlaneStiffness) -> Result<Isotropic, String> {
    let (along, cross) = (d[0][0], d[0][1]);
    let poisson = cross / along;
    let young = along * (1.0 - poisson * poisson);
    // In plane strain of a nearly incompressible material the equivalent ratio exceeds ½, and no plane-stress material has it.
    let state = if poisson <= 0.5 {
        PlaneState::Stress
    } else {
        PlaneState::Strain
    };
    let [young, poisson] = match state {
        PlaneState::Stress => [young, poisson],
        PlaneState::Strain => {
            let own = poisson / (1.0 + poisson);
            [young * (1.0 - own * own), own]
        }
    };
    Isotropic::new(young, poisson, state).map_err(|cause| cause.to_string())
}
