//! Disks and plates about one hole as series.

use std::f64::consts::PI;

use stickslip_fem_core::material::{Isotropic, Material, PlaneState, PlaneStiffness};
use stickslip_fem_core::mesh::Point;
use stickslip_scene::schema::{Hold, Load, LoadKind, MeshSettings};
use stickslip_scene::shape::{Curve, Role};
use stickslip_series::{Accuracy, Anchor, Circle, Disk, DiskLoad, EdgeLoad, Nodes, Outline, Plate};

use crate::model::meshes::on_circles;
use crate::model::plan::{BodyPlan, Placed, Plan};
use crate::series::{SeriesBody, is_isotropic};

/// Fit of the outer edge of an anisotropic plate. Near its corners stresses are less smooth than in an isotropic one, which matters little on the hole.
const ANISOTROPIC: Accuracy = Accuracy {
    tolerance: 5e-3,
    degree: 150,
};
/// Part of the mean traction that may be left on an outer edge; about a hundredth of it, 2e-4, shows on the hole.
const LARGEST_RESIDUAL: f64 = 2e-2;

/// The body with the index `index` as a series; otherwise why it cannot be one, as the end of a sentence about it.
pub(super) fn body(
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
pub(super) enum Membrane {
    Isotropic(Isotropic),
    Anisotropic(Box<dyn Material>),
}

impl Given<'_> {
    /// Nothing is on the body that series do not hold.
    fn free_of_others(&self) -> Result<(), String> {
        if self.plan.platens_of(self.index).next().is_some() {
            return Err("has a platen".into());
        }
        if self.plan.is_sprung(self.index) {
            return Err("stands on springs".into());
        }
        let mut loads = self.plan.loads.iter();
        let other = loads.find(|load| {
            load.body == self.index
                && matches!(
                    load.of.kind,
                    LoadKind::Bearing { .. } | LoadKind::PolarTraction { .. }
                )
        });
        match other {
            Some(load) => Err(format!(
                "has the load '{}', neither force nor pressure nor temperature",
                load.of.name
            )),
            None => Ok(()),
        }
    }

    fn disk(self) -> Result<SeriesBody, String> {
        let Membrane::Isotropic(material) = &self.material else {
            return Err("is not isotropic".into());
        };
        let strains = self.expansions()?;
        let mut displacement = [0.0; 2];
        let mut held = [false; 2];
        // The springs of a fastener act evenly over the area of its slices.
        let is_slice = self.plan.fastener_of(self.index).is_some();
        let mut anchor = is_slice.then_some(Anchor::Area);
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
                    LoadKind::Temperature { .. } => {}
                    _ => {
                        return Err(format!(
                            "has the load '{}' elsewhere than on its section",
                            load.of.name
                        ));
                    }
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
        let disk = disk.and_then(|disk| disk.with_expansions(&strains));
        let disk = disk.map_err(|cause| cause.to_string())?;
        Ok(SeriesBody::Disk(Box::new(disk)))
    }

    fn plate(self, straight: &[(&str, [Point; 2])]) -> Result<SeriesBody, String> {
        if self.plan.supports_of(self.index).next().is_some() {
            return Err("is held along an outer edge".into());
        }
        let strains = self.expansions()?;
        let order = cycle(straight).ok_or("has an outline that is not closed")?;
        let centre = self.plan.bodies[self.index].centre;
        let moved = |point: Point| [point[0] + centre[0], point[1] + centre[1]];
        let vertices = order
            .iter()
            .map(|&edge| moved(straight[edge].1[0]))
            .collect();
        let mut loads = Vec::new();
        for load in &self.plan.loads {
            let heats = matches!(load.of.kind, LoadKind::Temperature { .. });
            if load.body != self.index || heats {
                loads.push(Vec::new());
                continue;
            }
            let name = load.edge.as_ref().map(|edge| edge.name.as_ref());
            let name = name.ok_or_else(|| {
                format!("has the load '{}' on its section or a point", load.of.name)
            })?;
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
        let plate = plate.and_then(|plate| plate.with_expansions(&strains));
        let plate = plate.map_err(|cause| format!("has no series: {cause}"))?;
        let residual = plate.fit().residual;
        if residual > LARGEST_RESIDUAL {
            return Err(format!(
                "has an outer edge on which polynomials leave {residual:.1e} of the mean traction"
            ));
        }
        Ok(SeriesBody::Plate(Box::new(plate)))
    }

    /// The strains of a unit of each load case: of a temperature the thermal one, which nothing hinders.
    fn expansions(&self) -> Result<Vec<[f64; 3]>, String> {
        let material = plane_material(self.plan, &self.plan.bodies[self.index])?;
        let strain = |load: &Placed<'_, Load>| match load.of.kind {
            LoadKind::Temperature { .. } if load.body == self.index => {
                let [x, y, shear] = material.thermal_strain(1.0);
                // Rounding of a symmetric material.
                [x, y, if self.half { 0.0 } else { shear }]
            }
            _ => [0.0; 3],
        };
        let loads = self.plan.loads.iter().map(strain);
        Ok(loads.chain(std::iter::once([0.0; 3])).collect())
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
    let Some(&Curve::Circle { centre, radius }) = round.map(|edge| &edge.curve) else {
        return Err("touches along an edge that is not a closed circle".into());
    };
    Ok(Circle {
        centre: [0, 1].map(|axis| own.centre[axis] + centre[axis]),
        radius,
        thickness: own.thickness(),
    })
}

/// Contact nodes, in the order in which results stand along a circle.
pub(super) fn nodes(
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

fn plane_material(plan: &Plan<'_>, own: &BodyPlan<'_>) -> Result<Box<dyn Material>, String> {
    let material = own.elastic.ok_or("is rigid")?.material;
    material
        .in_plane(plan.analysis.plane)
        .map_err(|cause| cause.to_string())
}

/// The material of the body in its plane, of a laminate that of its membrane.
pub(super) fn membrane(plan: &Plan<'_>, own: &BodyPlan<'_>) -> Result<Membrane, String> {
    let material = plane_material(plan, own)?;
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
