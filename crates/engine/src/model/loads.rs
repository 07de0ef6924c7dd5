//! Supports, platens and loads of each body; the load history.

use std::collections::BTreeMap;
use std::sync::Arc;

use stickslip_contact::{LoadHistory, Ramp};
use stickslip_fem_core::load::{area_load, edge_load};
use stickslip_fem_core::material::Material;
use stickslip_fem_core::mesh::{EdgeSet, Mesh, MeshError, Point};
use stickslip_fem_core::{
    ElasticBody, HeldDirection, LoadCase, Platen, RigidBody, SectionHold, Support,
};

use super::bearing::unit_forces;
use super::plan::{Placed, Plan};
use super::polar_table::PolarField;
use super::resultant::{centre_of, matched};
use super::springs;
use super::{Meshes, ModelBodyKind, ModelError};
use crate::results::{BearingSource, ContactFrame};
use stickslip_scene::schema::{self, Hold, Load, LoadKind, SetRef};
use stickslip_scene::shape::Edge;

/// Sine of the angle up to which two directions are one.
const PARALLEL: f64 = 1e-9;
/// Part of a displacement up to which another one is the same.
const EQUAL: f64 = 1e-9;
/// Part of the body's modulus times its thickness that springs on it are at least as stiff as.
const SOFTEST: f64 = 1e-9;

/// Multipliers of all load cases per step: one case per load, and one that holds the displacements of supports.
pub(super) fn history(plan: &Plan<'_>) -> Result<LoadHistory, ModelError> {
    let histories = || plan.loads.iter().map(|load| load.of.kind.steps());
    let count = histories().map(<[f64]>::len).max().unwrap_or(1);
    let at = |step: usize| histories().map(move |own| own.get(step).copied().unwrap_or(0.0));
    let steps = (0..count).map(|step| at(step).chain(std::iter::once(1.0)).collect());
    let ramp = match plan.analysis.ramp() {
        schema::Ramp::Linear => Ramp::Linear,
        schema::Ramp::Quadratic => Ramp::Quadratic,
        schema::Ramp::Contact => Ramp::Contact,
    };
    let substeps = plan.analysis.substeps();
    Ok(LoadHistory::new(steps.collect(), substeps, ramp)?)
}

/// The body with the index `index`, with its supports and unit loads.
pub(super) fn body(
    plan: &Plan<'_>,
    index: usize,
    meshes: &Meshes,
    materials: &BTreeMap<String, Arc<dyn Material>>,
    half: bool,
    rigid_points: &[Point],
) -> Result<ModelBodyKind, ModelError> {
    let Some(substance) = plan.bodies[index].elastic else {
        return Ok(ModelBodyKind::Rigid(rigid(plan, index, half, rigid_points)));
    };
    let loaded = Loaded {
        plan,
        index,
        mesh: &meshes[&index],
        material: &materials[substance.name],
        thickness: substance.thickness,
        half,
    };
    Ok(ModelBodyKind::Elastic(Arc::new(loaded.build()?)))
}

/// An elastic body whose supports and loads are to be put on its mesh.
struct Loaded<'a> {
    plan: &'a Plan<'a>,
    index: usize,
    mesh: &'a Arc<Mesh>,
    material: &'a Arc<dyn Material>,
    thickness: f64,
    half: bool,
}

impl Loaded<'_> {
    fn build(&self) -> Result<ElasticBody, ModelError> {
        let name = self.plan.bodies[self.index].name;
        let body_error = |cause| ModelError::Body {
            body: name.to_owned(),
            cause,
        };
        let mesh_error = |cause| ModelError::Mesh {
            body: name.to_owned(),
            cause,
        };
        let blocks = vec![Arc::clone(self.material); self.mesh.blocks().len()];
        self.supports_agree()?;
        let supports = self.supports().map_err(mesh_error)?;
        let springs = springs::of_body(self.plan, self.index, self.mesh, self.thickness);
        let springs = springs.map_err(mesh_error)?;
        self.springs_are_stiff_enough()?;
        let mut body = ElasticBody::new(Arc::clone(self.mesh), blocks, self.thickness)
            .map_err(body_error)?
            .with_supports(supports)
            .with_springs(springs);
        if let Some(platen) = self.platen().map_err(mesh_error)? {
            body = body.with_platen(platen);
        }
        if let Some(hold) = self.section() {
            body = body.with_section_hold(hold);
        }
        if self.plan.fastener_of(self.index).is_some()
            && let Some(radius) = self.plan.bodies[self.index].radius()
        {
            body = body.with_carried_section(radius);
        }
        let cases = self.load_cases().map_err(mesh_error)?;
        body.with_load_cases(cases).map_err(body_error)
    }

    /// Coordinate that is held on the line of symmetry of a half.
    fn across(&self) -> Option<usize> {
        let across = self.plan.bodies[self.index].shape.mirror();
        across.filter(|_| self.half)
    }

    /// The supports of edges and points.
    fn supports_of_nodes(&self) -> impl Iterator<Item = &schema::Support> {
        let all = self.plan.supports_of(self.index);
        all.filter(|support| !self.is_area(&support.on))
    }

    /// Refuses two supports that move a node which their sets share by different displacements along the same direction.
    fn supports_agree(&self) -> Result<(), ModelError> {
        let all: Vec<&schema::Support> = self.supports_of_nodes().collect();
        for (count, own) in all.iter().enumerate() {
            for other in &all[..count] {
                let directions = other.hold.directions();
                let differs = |one: [f64; 2]| {
                    let mut others = directions.iter();
                    others.any(|two| {
                        let is_along = (one[0] * two[1] - one[1] * two[0]).abs() < PARALLEL;
                        let there = (one[0] * two[0] + one[1] * two[1]) * other.displacement;
                        let size = own.displacement.abs().max(there.abs());
                        is_along && (own.displacement - there).abs() > EQUAL * size
                    })
                };
                if own.hold.directions().into_iter().any(differs) && self.share(own, other) {
                    return Err(ModelError::Contradiction {
                        on: [other, own].map(|support| support.on.to_string()),
                        other: other.index,
                        index: own.index,
                    });
                }
            }
        }
        Ok(())
    }

    /// Whether the sets of two supports have a node in common.
    fn share(&self, one: &schema::Support, other: &schema::Support) -> bool {
        let nodes = |support: &schema::Support| self.mesh.node_set(&support.on.set);
        let (Ok(one), Ok(other)) = (nodes(one), nodes(other)) else {
            return false;
        };
        one.iter().any(|node| other.contains(node))
    }

    fn supports(&self) -> Result<Vec<Support>, MeshError> {
        let mut supports = Vec::new();
        for support in self.supports_of_nodes() {
            let nodes = self.mesh.node_set(&support.on.set)?;
            let directions: Vec<HeldDirection> = match support.hold {
                Hold::Direction(angle) => vec![HeldDirection::Angle(angle)],
                Hold::Axes(axes) => [(axes.x, HeldDirection::X), (axes.y, HeldDirection::Y)]
                    .into_iter()
                    .filter_map(|(held, direction)| held.then_some(direction))
                    .collect(),
            };
            supports.extend(directions.into_iter().map(|direction| Support {
                nodes: nodes.to_vec(),
                direction,
                displacement: support.displacement,
            }));
        }
        if let Some(across) = self.across() {
            supports.push(Support {
                nodes: self.mesh.node_set("symmetry")?.to_vec(),
                direction: [HeldDirection::X, HeldDirection::Y][across],
                displacement: 0.0,
            });
        }
        Ok(supports)
    }

    /// Whether a set is the body's area.
    fn is_area(&self, on: &SetRef) -> bool {
        self.plan.bodies[self.index].shape.is_area(&on.set)
    }

    /// What holds the mean displacement of the body's area; across the line of symmetry of a half nothing has to.
    fn section(&self) -> Option<SectionHold> {
        let supports = self.plan.supports_of(self.index);
        let mut hold = SectionHold {
            held: [false; 2],
            displacement: [0.0; 2],
        };
        for support in supports.filter(|support| self.is_area(&support.on)) {
            let Hold::Axes(axes) = support.hold else {
                continue;
            };
            let own = [axes.x, axes.y];
            for axis in (0..2).filter(|&axis| own[axis] && self.across() != Some(axis)) {
                hold.held[axis] = true;
                hold.displacement[axis] = support.displacement;
            }
        }
        hold.held.contains(&true).then_some(hold)
    }

    fn platen(&self) -> Result<Option<Platen>, MeshError> {
        let Some(platen) = self.plan.platens_of(self.index).next() else {
            return Ok(None);
        };
        let nodes = self.mesh.node_set(&platen.on.set)?.to_vec();
        let mut free = [platen.free.x, platen.free.y];
        if let Some(across) = self.across() {
            free[across] = false;
        }
        Ok(Some(Platen { nodes, free }))
    }

    /// One case per load of the scene for a multiplier of one, and the displacements of supports.
    fn load_cases(&self) -> Result<Vec<LoadCase>, MeshError> {
        let loads = self.plan.loads.iter();
        let unit = |load: &Placed<'_, Load>| match &load.of.kind {
            _ if load.body != self.index => Ok(LoadCase::default()),
            LoadKind::Temperature { .. } => Ok(LoadCase {
                initial_strain: vec![self.material.thermal_strain(1.0); self.mesh.blocks().len()],
                ..LoadCase::default()
            }),
            kind => Ok(LoadCase {
                forces: self.forces(load, kind)?,
                ..LoadCase::default()
            }),
        };
        let moved = LoadCase {
            moves_supports: true,
            ..LoadCase::default()
        };
        loads.map(unit).chain(std::iter::once(Ok(moved))).collect()
    }

    /// Nodal forces of a load on an edge of the body.
    fn forces(&self, load: &Placed<'_, Load>, kind: &LoadKind) -> Result<Vec<f64>, MeshError> {
        let edge = |on: &SetRef| self.mesh.edge_set(&on.set);
        Ok(match kind {
            LoadKind::Force { on, direction, .. } if self.is_area(on) => self.spread(*direction),
            LoadKind::Force { on, direction, .. } if load.edge.is_none() => {
                self.at_point(on, *direction)?
            }
            LoadKind::Force { on, direction, .. } => {
                self.force(edge(on)?, *direction, load.circle().is_some())
            }
            LoadKind::Bearing {
                on, direction, law, ..
            } => unit_forces(self.mesh, edge(on)?, *law, *direction, self.half),
            LoadKind::Pressure { on, .. } => {
                edge_load(self.mesh, &edge(on)?.edges, self.thickness, |at| {
                    at.normal.map(|component| -component)
                })
            }
            LoadKind::PolarTraction { on, table, .. } => {
                self.polar_traction(edge(on)?, load, &PolarField::new(table))
            }
            LoadKind::Temperature { .. } => Vec::new(),
        })
    }

    /// Refuses springs so soft that rounding leaves no digits of the body beside their motion.
    fn springs_are_stiff_enough(&self) -> Result<(), ModelError> {
        let own = self
            .plan
            .springs
            .iter()
            .filter(|own| own.body == self.index);
        for springs in own.map(|own| own.of) {
            let mesh_error = |cause| ModelError::Mesh {
                body: springs.on.body.clone(),
                cause,
            };
            let stiffness =
                springs::whole(self.mesh, springs, self.thickness).map_err(mesh_error)?;
            let least = SOFTEST * self.material.stiffness()[0][0] * self.thickness;
            if stiffness < least {
                return Err(ModelError::Unsupported {
                    key: format!("supports.{}.on", springs.index),
                    what: format!(
                        "springs on {} of {stiffness:.1e} N/mm in all are softer than {least:.1e} N/mm, a part of {SOFTEST:.0e} of the body's modulus times its thickness: rounding of \
                         their motion would leave no digits of the body; make them stiffer",
                        springs.on
                    ),
                });
            }
        }
        Ok(())
    }

    /// A unit force along `direction`, spread evenly over the body's area.
    fn spread(&self, direction: [f64; 2]) -> Vec<f64> {
        let areas = area_load(self.mesh);
        let whole = areas.iter().sum::<f64>() * if self.half { 2.0 } else { 1.0 };
        let forces = areas.iter();
        forces
            .flat_map(|area| direction.map(|component| component * area / whole))
            .collect()
    }

    /// A unit force along `direction` at a point.
    fn at_point(&self, on: &SetRef, direction: [f64; 2]) -> Result<Vec<f64>, MeshError> {
        let mut forces = vec![0.0; 2 * self.mesh.nodes().len()];
        let share = if self.half { 0.5 } else { 1.0 };
        for &node in self.mesh.node_set(&on.set)? {
            forces[2 * node..2 * node + 2].copy_from_slice(&direction.map(|part| share * part));
        }
        Ok(forces)
    }

    /// A unit force along `direction`, spread evenly.
    fn force(&self, edge: &EdgeSet, direction: [f64; 2], on_circle: bool) -> Vec<f64> {
        let spread =
            |traction: [f64; 2]| edge_load(self.mesh, &edge.edges, self.thickness, |_| traction);
        // Force of a unit traction on the whole edge; a half model has half of an edge that crosses the symmetry line.
        let whole = spread([1.0, 0.0]).iter().sum::<f64>() * if self.half { 2.0 } else { 1.0 };
        let forces = spread(direction.map(|component| component / whole));
        // Spread evenly over a circle it acts through its centre.
        if !self.half && on_circle {
            let [x, y] = direction;
            matched(self.mesh, edge, forces, [x, y, 0.0], self.half)
        } else {
            forces
        }
    }

    fn polar_traction(
        &self,
        edge: &EdgeSet,
        load: &Placed<'_, Load>,
        field: &PolarField,
    ) -> Vec<f64> {
        // On the hole's side the outward normal is −e_r, and so are the tractions of the same stresses.
        let sign = sign(load);
        let centre = centre_of(edge);
        let forces = edge_load(self.mesh, &edge.edges, self.thickness, |at| {
            let theta = (at.position[1] - centre[1]).atan2(at.position[0] - centre[0]);
            let [radial, shear] = field.at(theta);
            let (s, c) = theta.sin_cos();
            [
                sign * (radial * c - shear * s),
                sign * (radial * s + shear * c),
            ]
        });
        match load.circle() {
            Some(radius) => {
                let [x, y, turn] = field.resultant();
                let scale = sign * self.thickness * radius;
                let wanted = [scale * x, scale * y, scale * radius * turn];
                matched(self.mesh, edge, forces, wanted, self.half)
            }
            None => forces,
        }
    }
}

/// The frame of an edge under an assumed bearing load, of several under the first; +x without one.
pub(super) fn frame(plan: &Plan<'_>, on: &SetRef, half: bool) -> ContactFrame {
    let direction = plan.loads.iter().find_map(|load| match &load.of.kind {
        LoadKind::Bearing {
            on: loaded,
            direction,
            ..
        } if loaded == on => Some(*direction),
        _ => None,
    });
    direction.map_or(ContactFrame::NONE, |[x, y]| ContactFrame {
        bearing: Some(y.atan2(x)),
        found: BearingSource::Load,
        clockwise: half && x < 0.0,
    })
}

/// −1 where the normal of results on the edge points into the body, otherwise 1.
pub(super) fn sign<T>(on: &Placed<'_, T>) -> f64 {
    if on.edge.as_ref().is_some_and(Edge::has_inward_normal) {
        -1.0
    } else {
        1.0
    }
}

/// A rigid body slides along the axes in which nothing holds it, and never turns.
fn rigid(plan: &Plan<'_>, index: usize, half: bool, points: &[Point]) -> RigidBody {
    let mut free = plan.free_axes(index);
    let share = if half { 0.5 } else { 1.0 };
    if let Some(across) = plan.bodies[index].shape.mirror().filter(|_| half) {
        free[across] = false;
    }
    let force = |load: &Placed<'_, Load>| match &load.of.kind {
        LoadKind::Force { direction, .. } if load.body == index => {
            direction.map(|component| share * component)
        }
        _ => [0.0; 2],
    };
    let mut forces: Vec<[f64; 2]> = plan.loads.iter().map(force).collect();
    forces.push([0.0; 2]);
    if free == [false; 2] {
        RigidBody::held(points.to_vec(), forces.len())
    } else {
        RigidBody::sliding(points.to_vec(), free, &forces)
    }
}
