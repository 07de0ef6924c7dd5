//! Quantities along the reported edges: contact forces become tractions, edge strains become stresses.

use nalgebra::DVector;
use stickslip_contact::zones::{
    Zone, carries_friction, ends_of_contact, half_extent, mirrored, zones,
};
use stickslip_contact::{ContactState, InterfaceProblem, Status, StepRecord};
use stickslip_fem_core::stress::{EdgeData, PathEnd, PathEnds, StressError, edge_stresses};

use super::Solved;
use super::fields::Recovered;
use super::reported::{Reported, clear_stresses, clear_sums, reported};
use crate::model::{Model, ModelBodyKind, ModelEdge};
use crate::results::{EdgeGeometry, EdgeKind, EdgeResults, EdgeRow};

/// All edges in every load step: one list of edges per step.
pub(super) fn all(
    model: &Model,
    solved: &Solved,
    recovered: &[Recovered],
) -> Result<Vec<Vec<EdgeResults>>, StressError> {
    let reported = reported(&solved.problem, &solved.records);
    let mut steps: Vec<Vec<EdgeResults>> = vec![Vec::new(); reported.len()];
    for edge in &model.edges {
        let mut rows = (0..reported.len())
            .map(|step| rows(model, solved, &reported[step], &recovered[step], step, edge))
            .collect::<Result<Vec<_>, _>>()?;
        clear_stresses(&mut rows);
        let mut results: Vec<EdgeResults> = rows
            .into_iter()
            .zip(&reported)
            .map(|(rows, reported)| summarise(model, solved, edge, rows, reported))
            .collect();
        clear_sums(&mut results);
        for (step, result) in steps.iter_mut().zip(results) {
            step.push(result);
        }
    }
    Ok(steps)
}

/// One row per node of `edge` in load step `step`.
fn rows(
    model: &Model,
    solved: &Solved,
    reported: &Reported,
    recovered: &Recovered,
    step: usize,
    edge: &ModelEdge,
) -> Result<Vec<EdgeRow>, StressError> {
    let displacement = match edge.pair {
        Some(_) => interface_displacement(solved, &solved.records[step], edge),
        None => edge
            .nodes
            .iter()
            .map(|&node| {
                [
                    recovered.displacement[edge.body][2 * node],
                    recovered.displacement[edge.body][2 * node + 1],
                ]
            })
            .collect(),
    };
    let mut rows = contact_rows(solved, reported, edge);
    let initial = match &model.bodies[edge.body].kind {
        ModelBodyKind::Elastic(body) => body.initial_strain(&reported.state.multipliers),
        ModelBodyKind::Rigid(_) => Vec::new(),
    };
    add_stresses(
        model,
        edge,
        &displacement,
        initial.first().copied().unwrap_or_default(),
        &mut rows,
    )?;
    Ok(rows)
}

/// Displacements of a contact edge's nodes that strain its first body: u = C λ + Σ m_k u_k, no sparse solve.
fn interface_displacement(solved: &Solved, record: &StepRecord, edge: &ModelEdge) -> Vec<[f64; 2]> {
    let operator = solved.operators[edge.body].interface();
    let count = operator.points().len();
    let forces = DVector::from_vec(solved.problem.forces_on_body(
        edge.body,
        count,
        &record.state.forces,
    ));
    let mut u = operator.compliance().map_or_else(
        || DVector::zeros(2 * count),
        |compliance| compliance * &forces,
    );
    for (case, &factor) in record.state.multipliers.iter().enumerate() {
        if let Some(response) = operator.load_response(case) {
            u.axpy(factor, response, 1.0);
        }
    }
    edge.local
        .iter()
        .map(|&k| [u[2 * k], u[2 * k + 1]])
        .collect()
}

fn contact_rows(solved: &Solved, reported: &Reported, edge: &ModelEdge) -> Vec<EdgeRow> {
    let state = &reported.state;
    let free = EdgeRow {
        pressure: 0.0,
        shear: 0.0,
        gap: 0.0,
        slip: 0.0,
        status: Status::Open,
        sigma_normal: 0.0,
        sigma_tangential: 0.0,
        tau: 0.0,
    };
    let Some(pair) = edge.pair else {
        let multiplier = |case: usize| state.multipliers.get(case).copied().unwrap_or(0.0);
        let sum = |k: usize, part: usize| -> f64 {
            edge.tractions
                .iter()
                .map(|(case, values)| multiplier(*case) * values[k][part])
                .sum()
        };
        let row = |k| EdgeRow {
            pressure: -sum(k, 0),
            shear: -sum(k, 1),
            ..free
        };
        return (0..edge.nodes.len()).map(row).collect();
    };
    solved
        .problem
        .pair_points(pair)
        .map(|k| {
            let area = solved.problem.points()[k].area;
            EdgeRow {
                pressure: state.normal_force(k) / area,
                shear: state.tangential_force(k) / area,
                gap: if state.status[k].touches() {
                    0.0
                } else {
                    state.gap(k)
                },
                slip: reported.slip[k],
                status: state.status[k],
                ..free
            }
        })
        .collect()
}

fn add_stresses(
    model: &Model,
    edge: &ModelEdge,
    displacement: &[[f64; 2]],
    initial_strain: [f64; 3],
    rows: &mut [EdgeRow],
) -> Result<(), StressError> {
    let ModelBodyKind::Elastic(body) = &model.bodies[edge.body].kind else {
        return Ok(());
    };
    let geometry = &edge.geometry;
    let (parameter, ends): (Vec<f64>, PathEnds) = match geometry.kind {
        EdgeKind::Circle { radius, .. } => {
            let along = geometry
                .parameter
                .iter()
                .map(|theta| radius * theta)
                .collect();
            let mirror = PathEnd::Mirror { axis: [1.0, 0.0] };
            let closed = PathEnds::Closed {
                length: std::f64::consts::TAU * radius,
            };
            (
                along,
                if geometry.half {
                    PathEnds::Open([mirror; 2])
                } else {
                    closed
                },
            )
        }
        EdgeKind::Line => {
            // e_t = −e_x for a normal along +y.
            let along = geometry.parameter.iter().map(|x| -x).collect();
            let start = if geometry.half {
                PathEnd::Mirror { axis: [0.0, 1.0] }
            } else {
                PathEnd::Free
            };
            (along, PathEnds::Open([start, PathEnd::Free]))
        }
    };
    let normal_stress: Vec<f64> = rows.iter().map(|row| -row.pressure).collect();
    let shear_stress: Vec<f64> = rows.iter().map(|row| -row.shear).collect();
    let data = EdgeData {
        order: edge.order,
        ends,
        parameter: &parameter,
        displacement,
        normal: &edge.normals,
        normal_stress: &normal_stress,
        shear_stress: &shear_stress,
    };
    let Some(material) = body.materials().first() else {
        return Ok(());
    };
    let stresses = edge_stresses(&data, material.as_ref(), initial_strain)?;
    // (n, t) = (e_r, e_θ) on a circle; on a line (e_y, −e_x), which turns the sign of the shear.
    let sign = if matches!(geometry.kind, EdgeKind::Line) {
        -1.0
    } else {
        1.0
    };
    for (row, stress) in rows.iter_mut().zip(stresses) {
        row.sigma_normal = stress.normal;
        row.sigma_tangential = stress.tangential;
        row.tau = sign * stress.shear;
    }
    Ok(())
}

/// Friction force of the modelled part, with sign. On a circle ∫ q dA with q = −λ_t sgn θ, positive where friction pulls the first
/// body towards the bearing point; on a line the force on the first body along +x, which is against e_t.
fn friction_force(edge: &ModelEdge, rows: &[EdgeRow]) -> f64 {
    let friction = rows.iter().zip(&edge.areas).zip(&edge.geometry.parameter);
    let side = |at: f64| match edge.geometry.kind {
        EdgeKind::Line => 1.0,
        EdgeKind::Circle { .. } if at == 0.0 => 0.0,
        EdgeKind::Circle { .. } => at.signum(),
    };
    friction
        .map(|((row, area), &at)| -side(at) * row.shear * area)
        .sum()
}

/// Uncertainty of the largest tangential stress if it lies within four nodes of an end of contact.
fn cusp_uncertainty(rows: &[EdgeRow], ends: &[f64], parameter: &[f64]) -> Option<f64> {
    const REACH: usize = 4;
    let stress = |k: usize| rows[k].sigma_tangential;
    let peak = (0..rows.len()).max_by(|&a, &b| stress(a).total_cmp(&stress(b)))?;
    let (low, high) = (
        peak.saturating_sub(REACH),
        (peak + REACH).min(rows.len() - 1),
    );
    let near = parameter[low]..=parameter[high];
    if !ends.iter().any(|end| near.contains(end)) {
        return None;
    }
    let neighbours = [
        peak.checked_sub(1),
        Some(peak + 1).filter(|&k| k < rows.len()),
    ];
    neighbours
        .into_iter()
        .flatten()
        .map(|k| (stress(peak) - stress(k)).abs())
        .reduce(f64::max)
}

/// The largest of `values` and its place. Of values that are equal but for rounding, as on both sides of a symmetric edge, the one
/// nearest to the middle on the positive side has the place.
fn largest(values: &[f64], parameter: &[f64]) -> Option<(f64, f64)> {
    // Solvers promise 1e-10 of the largest force; the traction of a node may be less by its small area.
    const ROUNDING: f64 = 1e-7;
    let most = values.iter().copied().reduce(f64::max)?;
    let high = values.iter().zip(parameter);
    let places = high.filter(|(value, _)| **value >= most - ROUNDING * most.abs());
    let nearer = |a: &f64, b: &f64| {
        let apart = a.abs() - b.abs();
        if apart.abs() > ROUNDING {
            apart.total_cmp(&0.0)
        } else {
            b.total_cmp(a)
        }
    };
    let place = places.map(|(_, place)| *place).min_by(nearer)?;
    Some((most, place))
}

/// Zones of the whole edge, of which the model may be half.
fn whole_zones(
    problem: &InterfaceProblem,
    state: &ContactState,
    pair: usize,
    geometry: &EdgeGeometry,
) -> Vec<Zone> {
    let (parameter, closed) = (&geometry.parameter, geometry.closed());
    if geometry.half {
        mirrored(&zones(problem, state, pair, parameter, None), closed)
    } else {
        zones(problem, state, pair, parameter, closed)
    }
}

fn summarise(
    model: &Model,
    solved: &Solved,
    edge: &ModelEdge,
    rows: Vec<EdgeRow>,
    reported: &Reported,
) -> EdgeResults {
    let parameter = &edge.geometry.parameter;
    let (half, problem, state) = (model.half, &solved.problem, &reported.state);
    let zones = edge.pair.map_or_else(Vec::new, |pair| {
        whole_zones(problem, state, pair, &edge.geometry)
    });
    let closed = edge.geometry.closed();
    let rubs = edge
        .pair
        .is_some_and(|pair| carries_friction(problem, state, pair));
    // A closed walk starts at −π, which is π.
    let far = |place: f64| match closed {
        Some(length) if place < -0.5 * length * (1.0 - 1e-9) => place + length,
        _ => place,
    };
    let peak = |value: &dyn Fn(&EdgeRow) -> f64| {
        let values: Vec<f64> = rows.iter().map(value).collect();
        largest(&values, parameter).map(|(value, place)| (value, far(place)))
    };
    let extent = half_extent(&zones, closed);
    let around_middle = |zone: &&Zone| {
        let holds = |middle: f64| zone.start <= middle && middle <= zone.end;
        zone.status == Status::Stick && (holds(0.0) || closed.is_some_and(holds))
    };
    let middle = zones.iter().find(around_middle);
    let stick = extent
        .filter(|_| rubs)
        .map(|_| middle.map_or(0.0, |zone| 0.5 * zone.length()));
    let double = if half { 2.0 } else { 1.0 };
    // The friction forces of two symmetric halves of a line cancel; around a hole both pull the same way.
    let doubled_friction = match edge.geometry.kind {
        EdgeKind::Line if half => 0.0,
        EdgeKind::Line | EdgeKind::Circle { .. } => double,
    };
    let (resultant, sums) = edge.pair.map_or_else(Default::default, |pair| {
        let [x, y] = reported.sums[pair].resultant;
        let whole = match (half, edge.geometry.kind) {
            (false, _) => [x, y],
            (true, EdgeKind::Circle { .. }) => [2.0 * x, 0.0],
            (true, EdgeKind::Line) => [0.0, 2.0 * y],
        };
        (whole, reported.sums[pair])
    });
    let bearing =
        (0..rows.len()).min_by(|&a, &b| parameter[a].abs().total_cmp(&parameter[b].abs()));
    EdgeResults {
        contact_half_extent: extent,
        stick_half_extent: stick,
        peak_pressure: peak(&|row| row.pressure).filter(|_| extent.is_some()),
        peak_hoop: peak(&|row| row.sigma_tangential)
            .filter(|_| rows.iter().any(|row| row.sigma_tangential != 0.0)),
        peak_hoop_uncertainty: cusp_uncertainty(&rows, &ends_of_contact(&zones, closed), parameter),
        hoop_at_bearing_point: bearing.map(|k| rows[k].sigma_tangential),
        resultant,
        friction_force: doubled_friction * friction_force(edge, &rows),
        normal_force: double * sums.normal,
        rows,
        zones,
    }
}
