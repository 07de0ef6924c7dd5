//! Supports, platens and loads of each body; the load history.

use std::collections::BTreeMap;
use std::sync::Arc;

use stickslip_contact::{LoadHistory, Ramp};
use stickslip_fem_core::load::edge_load;
use stickslip_fem_core::material::Material;
use stickslip_fem_core::mesh::{Mesh, Point};
use stickslip_fem_core::{ElasticBody, HeldDirection, LoadCase, Platen, RigidBody, Support};

use super::bearing::unit_forces;
use super::polar_table::PolarField;
use super::resultant::{centre_of, matched};
use super::{Meshes, ModelBodyKind, ModelEdge, ModelError};
use crate::results::{BearingSource, ContactFrame};
use stickslip_scene::Scene;
use stickslip_scene::schema::{self, Hold, LoadKind, SetRef, Shape, Substance};

/// Multipliers of all load cases per step: one case per load, and one that holds the displacements of supports.
pub(super) fn history(scene: &Scene) -> Result<LoadHistory, ModelError> {
    let count = scene
        .loads
        .iter()
        .map(|load| load.kind.steps().len())
        .max()
        .unwrap_or(1);
    let steps = (0..count)
        .map(|step| {
            let loads = scene
                .loads
                .iter()
                .map(|load| load.kind.steps().get(step).copied().unwrap_or(0.0));
            loads.chain(std::iter::once(1.0)).collect()
        })
        .collect();
    let ramp = match scene.analysis.ramp {
        schema::Ramp::Linear => Ramp::Linear,
        schema::Ramp::Quadratic => Ramp::Quadratic,
    };
    Ok(LoadHistory::new(steps, scene.analysis.substeps, ramp)?)
}

/// The body `name` with its supports and unit loads.
pub(super) fn body(
    scene: &Scene,
    name: &str,
    meshes: &Meshes,
    materials: &BTreeMap<String, Arc<dyn Material>>,
    half: bool,
    rigid_points: &[Point],
) -> Result<ModelBodyKind, ModelError> {
    // The scene was checked: every name in it refers to something.
    let description = &scene.bodies[name];
    let Substance::Elastic {
        material,
        thickness,
    } = &description.substance
    else {
        return Ok(ModelBodyKind::Rigid(rigid(scene, name, half, rigid_points)));
    };
    let mesh = &meshes[name];
    let material = &materials[material];
    let body_error = |cause| ModelError::Body {
        body: name.to_owned(),
        cause,
    };
    let mesh_error = |cause| ModelError::Mesh {
        body: name.to_owned(),
        cause,
    };

    let mut supports = Vec::new();
    for support in scene
        .supports
        .iter()
        .filter(|support| support.on.body == name)
    {
        let nodes = mesh.node_set(&support.on.set).map_err(mesh_error)?;
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
    let across = description.shape.mirror().filter(|_| half);
    if let Some(across) = across {
        let direction = [HeldDirection::X, HeldDirection::Y][across];
        let nodes = mesh.node_set("symmetry").map_err(mesh_error)?.to_vec();
        supports.push(Support {
            nodes,
            direction,
            displacement: 0.0,
        });
    }
    let blocks = vec![Arc::clone(material); mesh.blocks().len()];
    let mut body = ElasticBody::new(Arc::clone(mesh), blocks, *thickness)
        .map_err(body_error)?
        .with_supports(supports);
    if let Some(platen) = scene.platens.iter().find(|platen| platen.on.body == name) {
        let nodes = mesh.node_set(&platen.on.set).map_err(mesh_error)?.to_vec();
        let mut free = [platen.free.x, platen.free.y];
        if let Some(across) = across {
            free[across] = false;
        }
        body = body.with_platen(Platen { nodes, free });
    }
    let mut cases = Vec::with_capacity(scene.loads.len() + 1);
    for load in &scene.loads {
        cases.push(
            unit_load(
                &load.kind,
                name,
                mesh,
                material,
                *thickness,
                &description.shape,
                half,
            )
            .map_err(mesh_error)?,
        );
    }
    cases.push(LoadCase {
        moves_supports: true,
        ..LoadCase::default()
    });
    Ok(ModelBodyKind::Elastic(Arc::new(
        body.with_load_cases(cases).map_err(body_error)?,
    )))
}

/// Load `kind` for a multiplier of one, as far as it acts on body `name`.
fn unit_load(
    kind: &LoadKind,
    name: &str,
    mesh: &Mesh,
    material: &Arc<dyn Material>,
    thickness: f64,
    shape: &Shape,
    half: bool,
) -> Result<LoadCase, stickslip_fem_core::mesh::MeshError> {
    let forces = match kind {
        LoadKind::Force { on, direction, .. } if on.body == name => {
            let edge = mesh.edge_set(&on.set)?;
            let edges = &edge.edges;
            let unit = edge_load(mesh, edges, thickness, |_| [1.0, 0.0]);
            // Force of a unit traction on the whole edge; a half model has half of an edge that crosses the symmetry line.
            let whole = unit.iter().sum::<f64>() * if half { 2.0 } else { 1.0 };
            let forces = edge_load(mesh, edges, thickness, |_| {
                direction.map(|component| component / whole)
            });
            // Spread evenly over a circle it acts through its centre.
            if !half && shape.circle(&on.set).is_some() {
                let [x, y] = *direction;
                matched(mesh, edge, forces, [x, y, 0.0], half)
            } else {
                forces
            }
        }
        LoadKind::Bearing {
            on, direction, law, ..
        } if on.body == name => unit_forces(mesh, mesh.edge_set(&on.set)?, *law, *direction, half),
        LoadKind::Pressure { on, .. } if on.body == name => {
            edge_load(mesh, &mesh.edge_set(&on.set)?.edges, thickness, |at| {
                at.normal.map(|component| -component)
            })
        }
        LoadKind::PolarTraction { on, table, .. } if on.body == name => {
            let field = PolarField::new(table);
            // On the hole's side the outward normal is −e_r, and so are the tractions of the same stresses.
            let sign = sign(shape, on);
            let edge = mesh.edge_set(&on.set)?;
            let centre = centre_of(edge);
            let forces = edge_load(mesh, &edge.edges, thickness, |at| {
                let theta = (at.position[1] - centre[1]).atan2(at.position[0] - centre[0]);
                let [radial, shear] = field.at(theta);
                let (s, c) = theta.sin_cos();
                [
                    sign * (radial * c - shear * s),
                    sign * (radial * s + shear * c),
                ]
            });
            match shape.circle(&on.set) {
                Some(radius) => {
                    let [x, y, turn] = field.resultant();
                    let scale = sign * thickness * radius;
                    let wanted = [scale * x, scale * y, scale * radius * turn];
                    matched(mesh, edge, forces, wanted, half)
                }
                None => forces,
            }
        }
        LoadKind::Temperature { body, .. } if body == name => {
            let strain = material.thermal_strain(1.0);
            return Ok(LoadCase {
                initial_strain: vec![strain; mesh.blocks().len()],
                ..LoadCase::default()
            });
        }
        _ => Vec::new(),
    };
    Ok(LoadCase {
        forces,
        ..LoadCase::default()
    })
}

/// The frame of an edge under an assumed bearing load, of several under the first; +x without one.
pub(crate) fn frame(scene: &Scene, on: &SetRef, half: bool) -> ContactFrame {
    let direction = scene.loads.iter().find_map(|load| match &load.kind {
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
fn sign(shape: &Shape, on: &SetRef) -> f64 {
    let edge = shape.edge(&on.set);
    if edge.is_some_and(|edge| edge.has_inward_normal()) {
        -1.0
    } else {
        1.0
    }
}

/// Tractions (σ_nn, τ_nt) of unit loads on a reported edge, in the edge's frame (n, t), t being n turned by +90°.
pub(super) fn edge_tractions(
    scene: &Scene,
    on: &SetRef,
    edge: &ModelEdge,
) -> Vec<(usize, Vec<[f64; 2]>)> {
    // n is e_r or +y, which points into a hole's body and out of the body above a lower side.
    let outward = sign(&scene.bodies[&on.body].shape, on);
    let area: f64 = edge.areas.iter().sum::<f64>() * if edge.geometry.half { 2.0 } else { 1.0 };
    let mut all = Vec::new();
    for (case, load) in scene.loads.iter().enumerate() {
        let at_node: Box<dyn Fn(usize) -> [f64; 2]> = match &load.kind {
            LoadKind::Pressure { on: loaded, .. } if loaded == on => Box::new(|_| [-1.0, 0.0]),
            LoadKind::Bearing {
                on: loaded,
                direction: [x, y],
                law,
                ..
            } if loaded == on => {
                let middle = y.atan2(*x);
                let mean = 1.0 / edge.geometry.bearing_area.unwrap_or(area);
                Box::new(move |k| {
                    [
                        -mean * law.pressure(edge.geometry.parameter[k] - middle),
                        0.0,
                    ]
                })
            }
            LoadKind::PolarTraction {
                on: loaded, table, ..
            } if loaded == on => {
                let field = PolarField::new(table);
                Box::new(move |k| field.at(edge.geometry.parameter[k]))
            }
            LoadKind::Force {
                on: loaded,
                direction,
                ..
            } if loaded == on => Box::new(move |k| {
                let [nx, ny] = edge.normals[k];
                let along = |x: f64, y: f64| outward * (direction[0] * x + direction[1] * y) / area;
                [along(nx, ny), along(-ny, nx)]
            }),
            _ => continue,
        };
        all.push((case, (0..edge.nodes.len()).map(at_node).collect()));
    }
    all
}

/// A rigid body slides along the axes in which nothing holds it, and never turns.
fn rigid(scene: &Scene, name: &str, half: bool, points: &[Point]) -> RigidBody {
    let mut free = [true; 2];
    for support in scene
        .supports
        .iter()
        .filter(|support| support.on.body == name)
    {
        match support.hold {
            Hold::Axes(axes) => free = [free[0] && !axes.x, free[1] && !axes.y],
            Hold::Direction(_) => free = [false; 2],
        }
    }
    let share = if half { 0.5 } else { 1.0 };
    if let Some(across) = scene.bodies[name].shape.mirror().filter(|_| half) {
        free[across] = false;
    }
    let mut forces: Vec<[f64; 2]> = scene
        .loads
        .iter()
        .map(|load| match &load.kind {
            LoadKind::Force { on, direction, .. } if on.body == name => {
                direction.map(|component| share * component)
            }
            _ => [0.0; 2],
        })
        .collect();
    forces.push([0.0; 2]);
    if free == [false; 2] {
        RigidBody::held(points.to_vec(), forces.len())
    } else {
        RigidBody::sliding(points.to_vec(), free, &forces)
    }
}
