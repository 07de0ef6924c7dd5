//! Stresses at the nodes of bodies, and where they are largest.

use stickslip_fem_core::material::Material;
use stickslip_fem_core::mesh::{Mesh, Point};
use stickslip_fem_core::stress::{ElasticField, StressError, cartesian};

use super::fields::Recovered;
use crate::model::{Model, Singular};
use crate::results::{
    BodyStresses, EdgeGeometry, EdgeKind, EdgeResults, Finding, Quantity, StepResults, StressPeak,
    Yield, principal, von_mises,
};

/// How far from a held point, and from an end of a supported edge, stresses are left out, as parts of the smaller side of the body. The force F of a point makes
/// stresses of F/(π r t) at the distance r, at two fifths of the diameter of a pin less than those that a contact makes on its rim.
const FROM_POINT: f64 = 0.4;
const FROM_END: f64 = 0.05;
/// Part of a yield stress by which rounding may exceed it.
const ROUNDING: f64 = 1e-9;
/// Part of the largest stress of all bodies in the history up to which stresses are rounding.
const REST: f64 = 1e-12;
/// Strain beyond which neither small displacements nor linear elasticity describe any solid.
const LARGE_STRAIN: f64 = 0.1;

/// Stresses (xx, yy, xy) `[MPa]` at every node of the body `index`: of a series, or recovered from patches, and on reported edges from the edge's own strain.
pub(super) fn at_nodes(
    model: &Model,
    index: usize,
    recovered: &Recovered,
    edges: &[EdgeResults],
) -> Result<Vec<[f64; 3]>, StressError> {
    let known = &recovered.stress[index];
    let mut stress = if known.is_empty() {
        patches(model, index, recovered)?
    } else {
        known.clone()
    };
    put_edges(model, index, edges, &mut stress);
    Ok(stress)
}

/// Stresses at every node, recovered from patches of elements.
fn patches(
    model: &Model,
    index: usize,
    recovered: &Recovered,
) -> Result<Vec<[f64; 3]>, StressError> {
    let Some(elastic) = model.bodies[index].elastic() else {
        return Ok(Vec::new());
    };
    let materials: Vec<&dyn Material> = elastic.materials().iter().map(AsRef::as_ref).collect();
    let strain = elastic.initial_strain(&recovered.multipliers);
    let initial = (!strain.is_empty()).then_some(strain.as_slice());
    let displacement = &recovered.displacement[index];
    let field = ElasticField::new(elastic.mesh(), &materials, displacement, initial)?;
    Ok(field.patch_recovery().averaged())
}

/// Puts the stresses of the reported edges of the body `index` into those of its nodes.
fn put_edges(model: &Model, index: usize, edges: &[EdgeResults], stress: &mut [[f64; 3]]) {
    for (edge, results) in model.edges.iter().zip(edges) {
        if edge.geometry.body != index {
            continue;
        }
        let places = edge.nodes.iter().zip(&edge.geometry.parameter);
        let places = places.zip(&edge.normals);
        for (((&node, &at), normal), row) in places.zip(&results.rows) {
            let [across, along, shear] = [row.sigma_normal, row.sigma_tangential, row.tau];
            stress[node] = match edge.geometry.kind {
                EdgeKind::Circle { .. } => cartesian([across, along, shear], at),
                EdgeKind::Line if *normal == [0.0, 1.0] => [along, across, shear],
                // Shear is counted against e_t.
                EdgeKind::Line | EdgeKind::Path => {
                    cartesian([across, along, -shear], normal[1].atan2(normal[0]))
                }
            };
        }
    }
}

/// The largest stresses in every step: of bodies whose yield is asked about in all, of others in those with fields.
pub(super) fn put(
    model: &Model,
    recovered: &[Recovered],
    steps: &mut [StepResults],
) -> Result<(), StressError> {
    for (step, recovered) in steps.iter_mut().zip(recovered) {
        for index in 0..model.bodies.len() {
            let fields = step.fields.iter().find(|own| own.body == index);
            let yields = model.bodies[index].yield_stress.is_some();
            let stress = match fields {
                Some(fields) => {
                    let mut stress = fields.stress.clone();
                    put_edges(model, index, &step.edges, &mut stress);
                    stress
                }
                None if yields && recovered.has_stresses(index) => {
                    at_nodes(model, index, recovered, &step.edges)?
                }
                None => continue,
            };
            step.stresses
                .extend(largest(model, index, recovered, &stress));
        }
    }
    clear(steps);
    Ok(())
}

/// Sets to zero what is rounding beside the largest stress of all bodies in the history.
fn clear(steps: &mut [StepResults]) {
    let all = || steps.iter().flat_map(|step| &step.stresses);
    let rounding = REST * all().fold(0.0, |most: f64, own| most.max(own.von_mises.stress));
    for own in steps.iter_mut().flat_map(|step| &mut step.stresses) {
        for peak in [
            &mut own.von_mises,
            &mut own.largest_principal,
            &mut own.least_principal,
        ] {
            if peak.stress.abs() <= rounding {
                peak.stress = 0.0;
            }
        }
    }
}

/// The largest of the nodal stresses `stress` of the body `index`.
fn largest(
    model: &Model,
    index: usize,
    recovered: &Recovered,
    stress: &[[f64; 3]],
) -> Option<BodyStresses> {
    let body = &model.bodies[index];
    let elastic = body.elastic()?;
    let material = elastic.materials().first()?;
    let heating = (model.request.loads).heating(index, &recovered.multipliers);
    let mesh = elastic.mesh();
    let (kept, beside) = kept(mesh, &left_out(model, index, mesh));
    let places = mesh.nodes();
    let peak = |size: &dyn Fn([f64; 3]) -> f64| {
        let largest = |nodes: &[usize]| {
            let sized = nodes.iter().map(|&node| (node, size(stress[node])));
            sized.max_by(|one, other| one.1.total_cmp(&other.1))
        };
        let (node, own) = largest(&kept)?;
        let beyond = largest(&beside).map_or(0.0, |(_, stress)| stress - own);
        Some(StressPeak {
            stress: own,
            at: places[node],
            beyond: beyond.max(0.0),
            error: None,
        })
    };
    let least = peak(&|stress| -principal(stress)[1])?;
    Some(BodyStresses {
        body: index,
        von_mises: peak(&|stress| von_mises(stress, material.thickness_stress(stress, heating)))?,
        largest_principal: peak(&|stress| principal(stress)[0])?,
        least_principal: StressPeak {
            stress: -least.stress,
            ..least
        },
    })
}

/// The nodes outside of the circles `left_out`, and those inside whose cells are cut by one.
fn kept(mesh: &Mesh, left_out: &[(Point, f64)]) -> (Vec<usize>, Vec<usize>) {
    let outside = |at: &Point| {
        let mut places = left_out.iter();
        places.all(|(place, reach)| (at[0] - place[0]).hypot(at[1] - place[1]) > *reach)
    };
    let is_kept: Vec<bool> = mesh.nodes().iter().map(outside).collect();
    let mut is_beside = vec![false; is_kept.len()];
    if !left_out.is_empty() {
        let cells = mesh.blocks().iter();
        for cell in cells.flat_map(|block| block.connectivity.chunks(block.kind.nodes())) {
            if cell.iter().any(|&node| is_kept[node]) {
                for &node in cell {
                    is_beside[node] = !is_kept[node];
                }
            }
        }
    }
    let those = |is_so: &[bool]| (0..is_so.len()).filter(|&node| is_so[node]).collect();
    (those(&is_kept), those(&is_beside))
}

/// The smaller side of the body with the index `index` `[mm]`, of half a model that of the whole.
fn smaller_side(model: &Model, index: usize, mesh: &Mesh) -> f64 {
    let [low, high] = mesh.bounding_box();
    let side = |axis: usize| {
        let own = high[axis] - low[axis];
        if model.bodies[index].across == Some(axis) {
            2.0 * own
        } else {
            own
        }
    };
    side(0).min(side(1))
}

/// Places where stresses have no bound `[mm]`, and how far around them they are left out.
fn left_out(model: &Model, index: usize, mesh: &Mesh) -> Vec<(Point, f64)> {
    let body = &model.bodies[index];
    let smaller = smaller_side(model, index, mesh);
    let places = body.singular.iter();
    let place = |place: &Singular| {
        let part = match place {
            Singular::Point(_) => FROM_POINT,
            Singular::End(_) => FROM_END,
        };
        (mesh.nodes()[place.node()], part * smaller)
    };
    places.map(place).collect()
}

/// Whether stress at the place `at` `[mm]` of the body with the index `index` has no limit, or none that finer cells approach: beside a re-entrant corner, and where a traction of a load case
/// that `acts`, or of springs, ends along an edge.
pub fn is_unlimited(model: &Model, index: usize, at: Point, acts: impl Fn(usize) -> bool) -> bool {
    let body = &model.bodies[index];
    let corners = body.corners.iter().map(|corner| corner.node);
    let nodes: Vec<usize> = corners.chain(body.traction_ends(acts)).collect();
    is_near(model, index, at, (index, &nodes))
}

/// Whether the place `at` `[mm]` of the body with the index `index` is beside the edge with the index `edge`, its own or one that it touches.
pub fn is_beside(model: &Model, index: usize, at: Point, edge: usize) -> bool {
    let edge = &model.edges[edge];
    is_near(model, index, at, (edge.geometry.body, &edge.nodes))
}

/// Whether one of `nodes` of a body is within a twentieth of the smaller side of the body with the index `index` from `at`.
fn is_near(model: &Model, index: usize, at: Point, (of, nodes): (usize, &[usize])) -> bool {
    let [Some(own), Some(other)] = [index, of].map(|body| model.bodies[body].elastic()) else {
        return false;
    };
    if nodes.is_empty() {
        return false;
    }
    let reach = FROM_END * smaller_side(model, index, own.mesh());
    nodes.iter().any(|&node| {
        let [x, y] = other.mesh().nodes()[node];
        (at[0] - x).hypot(at[1] - y) <= reach
    })
}

/// Bodies whose von Mises stress exceeds their yield stress in a step of `steps`.
pub(super) fn yields(model: &Model, steps: &[StepResults]) -> Vec<Finding> {
    let of_body = |index: usize| {
        let limit = model.bodies[index].yield_stress?;
        let own = |(step, record): (usize, &StepResults)| {
            let stresses = record.stresses.iter().find(|own| own.body == index)?;
            Some((step + 1, stresses.von_mises))
        };
        let beyond = steps.iter().enumerate().filter_map(own);
        let beyond: Vec<_> = beyond
            .filter(|(_, peak)| peak.stress > limit * (1.0 + ROUNDING))
            .collect();
        let largest = |one: &&(usize, StressPeak), other: &&(usize, StressPeak)| {
            one.1.stress.total_cmp(&other.1.stress)
        };
        let &(step, peak) = beyond.iter().max_by(largest)?;
        Some(Finding::Yields(Yield {
            body: model.bodies[index].name.clone(),
            steps: beyond.iter().map(|(step, _)| *step).collect(),
            step,
            von_mises: Quantity::Stress(peak.stress),
            yield_stress: Quantity::Stress(limit),
            at: peak.at.map(Quantity::Length),
        }))
    };
    (0..model.bodies.len()).filter_map(of_body).collect()
}

/// Bodies that stresses on the edges `edges` in contact strain far beyond what linear elasticity describes: more often a slip of units than a joint.
pub(super) fn large_strains(
    model: &Model,
    edges: &[EdgeGeometry],
    steps: &[StepResults],
) -> Vec<Finding> {
    let of_body = |index: usize| {
        let materials = model.bodies[index].elastic()?.materials().iter();
        let compliances = materials.map(|material| material.compliance());
        let softest = compliances.fold(0.0, |most: f64, own| most.max(own[0][0]).max(own[1][1]));
        let strain = |(step, record): (usize, &StepResults)| {
            let own = edges
                .iter()
                .zip(&record.edges)
                .filter(|(edge, _)| edge.contact);
            let stresses = own.map(|(edge, results)| {
                let second = edge.second.as_ref().map(|second| second.body);
                let rows = results.rows.iter();
                // The pressure acts on both bodies, and the stress along the edge is that of the first.
                match (edge.body == index, second == Some(index)) {
                    (true, _) => rows.fold(0.0, |most: f64, row| {
                        most.max(row.pressure.abs()).max(row.sigma_tangential.abs())
                    }),
                    (false, true) => rows.fold(0.0, |most: f64, row| most.max(row.pressure.abs())),
                    (false, false) => 0.0,
                }
            });
            (step + 1, softest * stresses.fold(0.0, f64::max))
        };
        let all = steps.iter().enumerate().map(strain);
        let (step, strain) = all.max_by(|one, other| one.1.total_cmp(&other.1))?;
        (strain > LARGE_STRAIN).then(|| Finding::LargeStrains {
            body: model.bodies[index].name.clone(),
            step,
            strain,
        })
    };
    (0..model.bodies.len()).filter_map(of_body).collect()
}
