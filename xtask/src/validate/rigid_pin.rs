//! Rigid pin in an infinite orthotropic plate: stresses at the hole edge, every 5°, against tables.

use serde::Deserialize;
use stickslip::results::Results;
use stickslip_laboratory::references::rigid_pin;

use super::check::{Check, Checks};
use super::laboratory::Laboratory;
use crate::publish::{TaskError, listed, root};

pub(super) use rigid_pin::BEARING;

/// Allowed error of a stress over the bearing stress, where `MARGIN` times the table's own error is not larger.
const BOUND: f64 = 1e-2;
const MARGIN: f64 = 4.0;
/// Points closer to the contact's end than this `[deg]` are left out.
const END: f64 = 3.0;

/// A table and the scene that should reproduce it.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Table {
    name: String,
    /// Name of its file.
    data: String,
    scene: String,
    #[serde(default)]
    overrides: Vec<String>,
    /// End of contact `[deg]`.
    end: f64,
    /// Load step to compare.
    #[serde(default)]
    step: usize,
}

/// The tables with or without friction.
fn tables(which: &str) -> Result<Vec<Table>, TaskError> {
    listed(include_str!("rigid_pin.toml"), which)
}

impl Table {
    fn points(&self) -> Result<Vec<rigid_pin::EdgePoint>, TaskError> {
        let folder = root().join("crates/laboratory/data");
        let text = std::fs::read_to_string(folder.join(format!("{}.csv", self.data)))?;
        Ok(rigid_pin::points(&text)?)
    }
}

pub(super) fn frictionless(laboratory: &Laboratory) -> Result<Vec<Check>, TaskError> {
    all(laboratory, &tables("frictionless")?)
}

pub(super) fn frictional(laboratory: &Laboratory) -> Result<Vec<Check>, TaskError> {
    all(laboratory, &tables("frictional")?)
}

fn all(laboratory: &Laboratory, tables: &[Table]) -> Result<Vec<Check>, TaskError> {
    let spacing = laboratory.sized(1.0, 0.5);
    let mut checks = Checks::against(
        "tables every 5°: Lekhnitskii potentials, nodal Signorini–Coulomb conditions",
    );
    for table in tables {
        let mut overrides = vec![format!("mesh.spacing=\"{spacing} deg\"")];
        overrides.extend_from_slice(&table.overrides);
        let results = laboratory.run(&table.scene, &overrides)?;
        compare(&mut checks, table, &results)?;
    }
    Ok(checks.into_list())
}

/// Angle `[deg]` and value of the largest −σ_r over P/(2Rt) among the points of the orthotropic table with friction.
pub(super) fn table_peak() -> Result<(f64, f64), TaskError> {
    let points = tables("frictional")?[0].points()?;
    let radial = |point: &&rigid_pin::EdgePoint| point.stresses[0];
    let highest = points.iter().min_by(|a, b| radial(a).total_cmp(&radial(b)));
    let highest = highest.ok_or("the table is empty")?;
    Ok((highest.angle, -radial(&highest)))
}

/// The point that uses most of what is allowed, for each stress.
fn compare(checks: &mut Checks, table: &Table, results: &Results) -> Result<(), TaskError> {
    let mut points = table.points()?;
    points.retain(|point| (point.angle - table.end).abs() >= END);
    for (k, name) in ["σ_r", "σ_θ", "τ_rθ"].into_iter().enumerate() {
        // Angle, error and what is allowed.
        let mut worst: Option<[f64; 3]> = None;
        for point in &points {
            let found = stresses(results, table.step, point.angle)?[k] / BEARING;
            let error = (found - point.stresses[k]).abs();
            let own = [point.angle, error, BOUND.max(MARGIN * point.errors[k])];
            // A NaN counts as the worst.
            let usage = |own: [f64; 3]| own[1] / own[2];
            if worst.is_none_or(|last| usage(last).total_cmp(&usage(own)).is_lt()) {
                worst = Some(own);
            }
        }
        let [angle, error, allowed] = worst.ok_or_else(|| format!("{} is empty", table.name))?;
        checks.error_below(
            format!("{}: {name}, of P/(2Rt)", table.name),
            (
                format!("worst of {} stations: {angle}°", points.len()),
                error,
            ),
            allowed,
        );
    }
    Ok(())
}

/// σ_r, σ_θ, τ_rθ `[MPa]` at the node at `degrees` of the first edge.
pub(super) fn stresses(
    results: &Results,
    step: usize,
    degrees: f64,
) -> Result<[f64; 3], TaskError> {
    let theta = degrees.to_radians();
    let node = results.edges[0]
        .parameter
        .iter()
        .position(|at| (at - theta).abs() < 1e-9)
        .ok_or_else(|| format!("no node at {degrees}°"))?;
    let row = &results.steps[step].edges[0].rows[node];
    Ok([row.sigma_normal, row.sigma_tangential, row.tau])
}
