//! Rigid pin in an infinite orthotropic plate: stresses at the hole edge, every 5°, against tables.

use stickslip::results::Results;

use super::check::{Check, Checks};
use super::laboratory::{KSI, Laboratory, Trouble};

/// Average bearing stress P/(2Rt) at full load `[MPa]`: 81.9 ksi. All stresses are divided by it.
pub(super) const BEARING: f64 = 81.9 * KSI;
/// Allowed error of a stress over the bearing stress, where `MARGIN` times the table's own error is not larger.
const BOUND: f64 = 1e-2;
const MARGIN: f64 = 4.0;
/// Stations closer to the contact's end than this `[deg]` are left out.
const END: f64 = 3.0;

/// A table and the scene that should reproduce it.
struct Table {
    name: &'static str,
    text: &'static str,
    scene: &'static str,
    overrides: &'static [&'static str],
    /// End of contact `[deg]`.
    end: f64,
    /// Load step to compare.
    step: usize,
}

const QUASI_ISOTROPIC: &str = "materials.laminate.orthotropic={ e1 = \"7720 ksi\", e2 = \"7720 ksi\", \
                               g12 = \"2969.230769230769 ksi\", nu12 = 0.3 }";
const NO_FRICTION: &str = "contacts.0.friction.coulomb.mu=0";

const FRICTIONLESS: [Table; 3] = [
    Table {
        name: "orthotropic, μ = 0",
        text: include_str!("../../data/rigid-pin-orthotropic-mu-0.csv"),
        scene: "validation/rigid-pin-orthotropic",
        overrides: &[
            NO_FRICTION,
            "loads.0.polar_traction.file=\"../data/rigid-pin-orthotropic-mu-0-ring5R.csv\"",
        ],
        end: 81.6227,
        step: 0,
    },
    Table {
        name: "orthotropic, clearance R/100, μ = 0",
        text: include_str!("../../data/rigid-pin-orthotropic-clearance-mu-0.csv"),
        scene: "validation/rigid-pin-clearance",
        overrides: &[
            NO_FRICTION,
            "loads.0.polar_traction.file=\"../data/rigid-pin-orthotropic-clearance-mu-0-ring5R.csv\"",
        ],
        end: 60.0097,
        step: 0,
    },
    Table {
        name: "quasi-isotropic, μ = 0",
        text: include_str!("../../data/rigid-pin-quasi-isotropic-mu-0.csv"),
        scene: "validation/rigid-pin-orthotropic",
        overrides: &[
            QUASI_ISOTROPIC,
            NO_FRICTION,
            "loads.0.polar_traction.file=\"../data/rigid-pin-quasi-isotropic-mu-0-ring5R.csv\"",
        ],
        end: 82.3679,
        step: 0,
    },
];

const FRICTIONAL: [Table; 4] = [
    Table {
        name: "orthotropic, μ = 0.2",
        text: include_str!("../../data/rigid-pin-orthotropic-mu-0.2.csv"),
        scene: "validation/rigid-pin-orthotropic",
        overrides: &[],
        end: 84.56,
        step: 0,
    },
    Table {
        name: "orthotropic, clearance R/100, μ = 0.2",
        text: include_str!("../../data/rigid-pin-orthotropic-clearance-mu-0.2.csv"),
        scene: "validation/rigid-pin-clearance",
        overrides: &[],
        end: 61.56,
        step: 0,
    },
    Table {
        name: "quasi-isotropic, μ = 0.2",
        text: include_str!("../../data/rigid-pin-quasi-isotropic-mu-0.2.csv"),
        scene: "validation/rigid-pin-orthotropic",
        overrides: &[
            QUASI_ISOTROPIC,
            "loads.0.polar_traction.file=\"../data/rigid-pin-quasi-isotropic-mu-0.2-ring5R.csv\"",
        ],
        end: 85.19,
        step: 0,
    },
    Table {
        name: "orthotropic, μ = 0.2, unloaded to half",
        text: include_str!("../../data/rigid-pin-orthotropic-unloaded-mu-0.2.csv"),
        scene: "validation/rigid-pin-unloading",
        overrides: &[],
        end: 79.94,
        step: 1,
    },
];

pub(super) fn frictionless(laboratory: &Laboratory) -> Result<Vec<Check>, Trouble> {
    all(laboratory, &FRICTIONLESS)
}

pub(super) fn frictional(laboratory: &Laboratory) -> Result<Vec<Check>, Trouble> {
    all(laboratory, &FRICTIONAL)
}

fn all(laboratory: &Laboratory, tables: &[Table]) -> Result<Vec<Check>, Trouble> {
    let spacing = laboratory.sized(1.0, 0.5);
    let mut checks = Checks::against(
        "tables every 5°: Lekhnitskii potentials, nodal Signorini–Coulomb conditions",
    );
    for table in tables {
        let mut overrides = vec![format!("mesh.spacing=\"{spacing} deg\"")];
        overrides.extend(table.overrides.iter().map(ToString::to_string));
        let results = laboratory.run(table.scene, &overrides)?;
        compare(&mut checks, table, &results)?;
    }
    Ok(checks.into_list())
}

/// Angle `[deg]` and value of the largest −σ_r over P/(2Rt) among the stations of the orthotropic table with friction.
pub(super) fn table_peak() -> Result<(f64, f64), Trouble> {
    let lines = stations(FRICTIONAL[0].text)?;
    let highest = lines.iter().max_by(|a, b| b[1].total_cmp(&a[1]));
    highest
        .map(|line| (line[0], -line[1]))
        .ok_or_else(|| Trouble::Missing(format!("{} is empty", FRICTIONAL[0].name)))
}

/// An error and what is allowed at its station.
#[derive(Clone, Copy, Default)]
struct Station {
    angle: f64,
    error: f64,
    allowed: f64,
}

impl Station {
    fn usage(&self) -> f64 {
        self.error / self.allowed
    }
}

/// The station that uses most of what is allowed, for each stress.
fn compare(checks: &mut Checks, table: &Table, results: &Results) -> Result<(), Trouble> {
    let mut worst: [Option<Station>; 3] = [None; 3];
    let mut count = 0;
    for line in stations(table.text)? {
        let [angle, reference @ .., error_r, error_theta, error_tau] = line;
        if (angle - table.end).abs() < END {
            continue;
        }
        count += 1;
        let found = stresses(results, table.step, angle)?;
        for (k, own) in [error_r, error_theta, error_tau].into_iter().enumerate() {
            let station = Station {
                angle,
                error: (found[k] / BEARING - reference[k]).abs(),
                allowed: BOUND.max(MARGIN * own),
            };
            // A NaN counts as the worst.
            if worst[k].is_none_or(|last| last.usage().total_cmp(&station.usage()).is_lt()) {
                worst[k] = Some(station);
            }
        }
    }
    for (name, worst) in ["σ_r", "σ_θ", "τ_rθ"].into_iter().zip(worst) {
        let worst = worst.ok_or_else(|| Trouble::Missing(format!("{} is empty", table.name)))?;
        checks.error_below(
            format!("{}: {name}, of P/(2Rt)", table.name),
            format!("worst of {count} stations: {}°", worst.angle),
            worst.error,
            worst.allowed,
        );
    }
    Ok(())
}

/// Angle `[deg]`, σ_r, σ_θ, τ_rθ and their estimated errors, of each line of a table.
fn stations(text: &str) -> Result<Vec<[f64; 7]>, Trouble> {
    let lines = text.lines().filter(|line| !line.starts_with('#')).skip(1);
    lines
        .map(|line| {
            let fields: Vec<&str> = line.split(',').collect();
            let numbers: Option<Vec<f64>> = [0, 1, 2, 3, 5, 6, 7]
                .into_iter()
                .map(|k| fields.get(k)?.trim().parse().ok())
                .collect();
            numbers
                .and_then(|numbers| numbers.try_into().ok())
                .ok_or_else(|| Trouble::Missing(format!("a line of a table is broken: {line}")))
        })
        .collect()
}

/// σ_r, σ_θ, τ_rθ `[MPa]` at the node at `degrees` of the first edge.
pub(super) fn stresses(results: &Results, step: usize, degrees: f64) -> Result<[f64; 3], Trouble> {
    let theta = degrees.to_radians();
    let node = results.edges[0]
        .parameter
        .iter()
        .position(|at| (at - theta).abs() < 1e-9)
        .ok_or_else(|| Trouble::Missing(format!("no node at {degrees}°")))?;
    let row = &results.steps[step].edges[0].rows[node];
    Ok([row.sigma_normal, row.sigma_tangential, row.tau])
}
