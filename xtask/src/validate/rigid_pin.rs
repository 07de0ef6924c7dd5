//! Rigid pin in an infinite orthotropic plate: stresses at the hole edge, every 5°, against tables.

use serde::Deserialize;
use stickslip::results::Results;
use stickslip_laboratory::references::rigid_pin;

use super::check::{Check, Checks};
use super::laboratory::Laboratory;
use crate::publish::{Trouble, listed, root};

pub(super) use rigid_pin::BEARING;

/// Allowed error of a stress over the bearing stress, where `MARGIN` times the table's own error is not larger.
const BOUND: f64 = 1e-2;
const MARGIN: f64 = 4.0;
/// Stations closer to the contact's end than this `[deg]` are left out.
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
fn tables(which: &str) -> Result<Vec<Table>, Trouble> {
    listed(include_str!("rigid_pin.toml"), which)
}

impl Table {
    fn stations(&self) -> Result<Vec<rigid_pin::Station>, Trouble> {
        let folder = root().join("crates/laboratory/data");
        let text = std::fs::read_to_string(folder.join(format!("{}.csv", self.data)))?;
        Ok(rigid_pin::stations(&text)?)
    }
}

pub(super) fn frictionless(laboratory: &Laboratory) -> Result<Vec<Check>, Trouble> {
    all(laboratory, &tables("frictionless")?)
}

pub(super) fn frictional(laboratory: &Laboratory) -> Result<Vec<Check>, Trouble> {
    all(laboratory, &tables("frictional")?)
}

fn all(laboratory: &Laboratory, tables: &[Table]) -> Result<Vec<Check>, Trouble> {
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

/// Angle `[deg]` and value of the largest −σ_r over P/(2Rt) among the stations of the orthotropic table with friction.
pub(super) fn table_peak() -> Result<(f64, f64), Trouble> {
    let stations = tables("frictional")?[0].stations()?;
    let radial = |station: &&rigid_pin::Station| station.stresses[0];
    let highest = stations
        .iter()
        .min_by(|a, b| radial(a).total_cmp(&radial(b)));
    let highest = highest.ok_or("the table is empty")?;
    Ok((highest.angle, -radial(&highest)))
}

/// The station that uses most of what is allowed, for each stress.
fn compare(checks: &mut Checks, table: &Table, results: &Results) -> Result<(), Trouble> {
    let mut stations = table.stations()?;
    stations.retain(|station| (station.angle - table.end).abs() >= END);
    for (k, name) in ["σ_r", "σ_θ", "τ_rθ"].into_iter().enumerate() {
        // Angle, error and what is allowed.
        let mut worst: Option<[f64; 3]> = None;
        for station in &stations {
            let found = stresses(results, table.step, station.angle)?[k] / BEARING;
            let error = (found - station.stresses[k]).abs();
            let own = [station.angle, error, BOUND.max(MARGIN * station.errors[k])];
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
                format!("worst of {} stations: {angle}°", stations.len()),
                error,
            ),
            allowed,
        );
    }
    Ok(())
}

/// σ_r, σ_θ, τ_rθ `[MPa]` at the node at `degrees` of the first edge.
pub(super) fn stresses(results: &Results, step: usize, degrees: f64) -> Result<[f64; 3], Trouble> {
    let theta = degrees.to_radians();
    let node = results.edges[0]
        .parameter
        .iter()
        .position(|at| (at - theta).abs() < 1e-9)
        .ok_or_else(|| format!("no node at {degrees}°"))?;
    let row = &results.steps[step].edges[0].rows[node];
    Ok([row.sigma_normal, row.sigma_tangential, row.tau])
}
