//! Quantities along the reported edges: contact forces become tractions, edge strains become stresses.

use nalgebra::DVector;
use stickslip_contact::{Status, StepRecord};
use stickslip_fem_core::body::BodyLoad;
use stickslip_fem_core::stress::{EdgeData, PathEnd, PathEnds, StressError, edge_stresses};

use super::bearing;
use super::fields::Recovered;
use super::reported::{Reported, clear_friction, clear_stresses, clear_sums, reported};
use super::solved::Solved;
use super::summary::summarise;
use crate::model::{Model, ModelBodyKind, ModelEdge};
use crate::results::{EdgeGeometry, EdgeKind, EdgeResults, EdgeRow};
use crate::series::{SeriesBody, SeriesError, stress_at};

/// All edges, with their frames, and their results in every load step: one list of edges per step.
pub(super) fn all(
    model: &Model,
    solved: &Solved,
    recovered: &[Recovered],
) -> Result<(Vec<EdgeGeometry>, Vec<Vec<EdgeResults>>), StressError> {
    let mut geometries = Vec::with_capacity(model.edges.len());
    let reported = reported(&solved.interface, &solved.records);
    let mut steps: Vec<Vec<EdgeResults>> = vec![Vec::new(); reported.len()];
    for (index, edge) in model.edges.iter().enumerate() {
        let mut rows = match solved.operators[edge.geometry.body].series() {
            Some(body) => series_rows(model, solved, &reported, edge, body),
            None => (0..reported.len())
                .map(|step| {
                    let moved = &recovered[step].free_edges[index];
                    let reactions = &recovered[step].reactions[index];
                    rows(
                        model,
                        solved,
                        &reported[step],
                        (moved, reactions),
                        step,
                        edge,
                    )
                })
                .collect::<Result<Vec<_>, _>>()?,
        };
        clear_stresses(&mut rows);
        let mut results: Vec<EdgeResults> = rows
            .into_iter()
            .zip(&reported)
            .map(|(rows, reported)| summarise(model, solved, edge, rows, reported))
            .collect();
        clear_sums(&mut results);
        let frame = bearing::find(edge, -model.origin[0], &mut results);
        clear_friction(&mut results);
        geometries.push(EdgeGeometry {
            frame,
            ..edge.geometry.clone()
        });
        for (step, result) in steps.iter_mut().zip(results) {
            step.push(result);
        }
    }
    Ok((geometries, steps))
}

/// One row per node of `edge` in load step `step`; `moved` are the displacements of an edge without contact, `reactions` the tractions
/// of its supports.
fn rows(
    model: &Model,
    solved: &Solved,
    reported: &Reported,
    (moved, reactions): (&[[f64; 2]], &[[f64; 2]]),
    step: usize,
    edge: &ModelEdge,
) -> Result<Vec<EdgeRow>, StressError> {
    let displacement = match edge.pair {
        Some(_) => interface_displacement(solved, &solved.records[step], edge),
        None => moved.to_vec(),
    };
    let further = further_tractions(edge, &reported.state.multipliers, reactions);
    let mut rows = bare_rows(solved, reported, edge, &further);
    let initial = match &model.bodies[edge.geometry.body].kind {
        ModelBodyKind::Elastic(body) => body.initial_strain(&reported.state.multipliers),
        ModelBodyKind::Rigid(_) => Vec::new(),
    };
    add_stresses(
        model,
        edge,
        &displacement,
        edge.pair.map(|_| further.as_slice()),
        initial.first().copied().unwrap_or_default(),
        &mut rows,
    )?;
    Ok(rows)
}

/// One row per node of an edge of a body by series in each load step: stresses are those of its potentials.
fn series_rows(
    model: &Model,
    solved: &Solved,
    reported: &[Reported],
    edge: &ModelEdge,
    body: &SeriesBody,
) -> Vec<Vec<EdgeRow>> {
    let further = |reported: &Reported| further_tractions(edge, &reported.state.multipliers, &[]);
    let mut all: Vec<Vec<EdgeRow>> = reported
        .iter()
        .map(|reported| bare_rows(solved, reported, edge, &further(reported)))
        .collect();
    let records = &solved.records[..all.len()];
    let forces: Vec<Vec<f64>> = records
        .iter()
        .map(|record| solved.forces_on_body(record, edge.geometry.body))
        .collect();
    let still = vec![0.0; body.interface().modes().ncols()];
    let pairs = records.iter().zip(&forces);
    let states: Vec<BodyLoad<'_>> = pairs
        .map(|(record, forces)| BodyLoad {
            forces,
            multipliers: &record.state.multipliers,
            motions: &still,
        })
        .collect();
    // The numbers are those of the body's own operator.
    let stresses = series_stresses(model, edge, body, &states).unwrap_or_default();
    for (rows, stresses) in all.iter_mut().zip(stresses) {
        for (row, [normal, tangential, shear]) in rows.iter_mut().zip(stresses) {
            row.sigma_normal = normal;
            row.sigma_tangential = tangential;
            row.tau = shear;
        }
    }
    all
}

/// Stresses normal to the edge, along it and shear, by state and node.
fn series_stresses(
    model: &Model,
    edge: &ModelEdge,
    body: &SeriesBody,
    states: &[BodyLoad<'_>],
) -> Result<Vec<Vec<[f64; 3]>>, SeriesError> {
    let own = model.bodies[edge.geometry.body].elastic();
    if let (EdgeKind::Line | EdgeKind::Path, None, Some(own)) = (edge.geometry.kind, edge.pair, own)
    {
        let nodes = own.mesh().nodes();
        let of_state = |state| {
            let field = body.field(state)?;
            let at = |(&node, &normal): (&usize, &[f64; 2])| {
                along_edge(stress_at(&field, body, nodes[node]), normal)
            };
            Ok(edge.nodes.iter().zip(&edge.normals).map(at).collect())
        };
        return states.iter().map(of_state).collect();
    }
    body.edge_stresses(states, &edge.geometry.parameter)
}

/// Stress normal to an edge with the unit normal n, stress along it, and shear, counted against t, which is n turned by +90°.
fn along_edge([xx, yy, xy]: [f64; 3], [nx, ny]: [f64; 2]) -> [f64; 3] {
    let twice = 2.0 * nx * ny * xy;
    [
        nx * nx * xx + ny * ny * yy + twice,
        ny * ny * xx + nx * nx * yy - twice,
        nx * ny * (xx - yy) + (ny * ny - nx * nx) * xy,
    ]
}

/// Displacements of a contact edge's nodes that strain its first body: u = C λ + Σ m_k u_k, no sparse solve.
fn interface_displacement(solved: &Solved, record: &StepRecord, edge: &ModelEdge) -> Vec<[f64; 2]> {
    let operator = solved.operators[edge.geometry.body].interface();
    let forces = DVector::from_vec(solved.forces_on_body(record, edge.geometry.body));
    let mut u = operator.give(&forces);
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

/// Tractions (σ_nn, τ_nt) per node of `edge` beside those of its contact: of its loads, and its reactions.
fn further_tractions(
    edge: &ModelEdge,
    multipliers: &[f64],
    reactions: &[[f64; 2]],
) -> Vec<[f64; 2]> {
    let mut all = vec![[0.0; 2]; edge.nodes.len()];
    let mut add = |factor: f64, values: &[[f64; 2]]| {
        for (sum, value) in all.iter_mut().zip(values) {
            *sum = [0, 1].map(|part| sum[part] + factor * value[part]);
        }
    };
    for (case, values) in &edge.tractions {
        add(multipliers.get(*case).copied().unwrap_or(0.0), values);
    }
    add(1.0, reactions);
    all
}

/// The rows without stresses: those of the contact, or where there is none all tractions as pressure and shear.
fn bare_rows(
    solved: &Solved,
    reported: &Reported,
    edge: &ModelEdge,
    further: &[[f64; 2]],
) -> Vec<EdgeRow> {
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
        let row = |&[normal, shear]: &[f64; 2]| EdgeRow {
            pressure: -normal,
            shear: -shear,
            ..free
        };
        return further.iter().map(row).collect();
    };
    let contacts = solved.interface.contacts();
    contacts
        .pair_points(pair)
        .map(|k| {
            let area = contacts.points()[k].area;
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

/// Adds the stresses that follow from the tractions of `rows`, with the tractions (σ_nn, τ_nt) `further` that these do not hold, and from
/// the strain along the edge.
fn add_stresses(
    model: &Model,
    edge: &ModelEdge,
    displacement: &[[f64; 2]],
    further: Option<&[[f64; 2]]>,
    initial_strain: [f64; 3],
    rows: &mut [EdgeRow],
) -> Result<(), StressError> {
    let ModelBodyKind::Elastic(body) = &model.bodies[edge.geometry.body].kind else {
        return Ok(());
    };
    let of_rows = rows.iter().map(|row| [-row.pressure, -row.shear]);
    let mut tractions: Vec<[f64; 2]> = of_rows.collect();
    for (sum, more) in tractions.iter_mut().zip(further.unwrap_or_default()) {
        *sum = [sum[0] + more[0], sum[1] + more[1]];
    }
    let (normal_stress, shear_stress): (Vec<f64>, Vec<f64>) = tractions
        .into_iter()
        .map(|[normal, shear]| (normal, shear))
        .unzip();
    let nodes = body.mesh().nodes();
    let places: Vec<[f64; 2]> = match edge.geometry.kind {
        EdgeKind::Path => edge.nodes.iter().map(|&node| nodes[node]).collect(),
        EdgeKind::Circle { .. } | EdgeKind::Line => edge.normals.clone(),
    };
    let data = EdgeData {
        order: edge.order,
        ends: ends(&edge.geometry),
        parameter: &edge.along,
        place: &places,
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
    let sign = if matches!(edge.geometry.kind, EdgeKind::Line | EdgeKind::Path) {
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

/// How the edge continues at its ends.
fn ends(geometry: &EdgeGeometry) -> PathEnds {
    let mirror = |axis| PathEnd::Mirror { axis };
    match (geometry.kind, geometry.half) {
        (EdgeKind::Circle { radius, .. }, false) => PathEnds::Closed {
            length: std::f64::consts::TAU * radius,
        },
        (EdgeKind::Circle { .. }, true) => PathEnds::Open([mirror([1.0, 0.0]); 2]),
        (EdgeKind::Line | EdgeKind::Path, false) => PathEnds::Open([PathEnd::Free; 2]),
        (EdgeKind::Line | EdgeKind::Path, true) => {
            PathEnds::Open([mirror([0.0, 1.0]), PathEnd::Free])
        }
    }
}
