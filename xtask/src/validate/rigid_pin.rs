//! Rigid pin in an infinite orthotropic plate: stresses at the hole edge, every 5°, against tables.

use stickslip::results::Results;
use stickslip_laboratory::references::rigid_pin;

use super::check::{Check, Checks};
use super::laboratory::{Laboratory, Trouble};

pub(super) use rigid_pin::BEARING;

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
        text: rigid_pin::ORTHOTROPIC_FRICTIONLESS,
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
        text: rigid_pin::ORTHOTROPIC_CLEARANCE_FRICTIONLESS,
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
        text: rigid_pin::QUASI_ISOTROPIC_FRICTIONLESS,
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
        text: rigid_pin::ORTHOTROPIC,
        scene: "validation/rigid-pin-orthotropic",
        overrides: &[],
        end: rigid_pin::ORTHOTROPIC_END,
        step: 0,
    },
    Table {
        name: "orthotropic, clearance R/100, μ = 0.2",
        text: rigid_pin::ORTHOTROPIC_CLEARANCE,
        scene: "validation/rigid-pin-clearance",
        overrides: &[],
        end: 61.56,
        step: 0,
    },
    Table {
        name: "quasi-isotropic, μ = 0.2",
        text: rigid_pin::QUASI_ISOTROPIC,
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
        text: rigid_pin::ORTHOTROPIC_UNLOADED,
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
    let stations = rigid_pin::stations(FRICTIONAL[0].text)?;
    let radial = |station: &rigid_pin::Station| station.stresses[0];
    let highest = stations
        .iter()
        .min_by(|a, b| radial(a).total_cmp(&radial(b)));
    highest
        .map(|station| (station.angle, -radial(station)))
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
    for rigid_pin::Station {
        angle,
        stresses: reference,
        errors,
    } in rigid_pin::stations(table.text)?
    {
        if (angle - table.end).abs() < END {
            continue;
        }
        count += 1;
        let found = stresses(results, table.step, angle)?;
        for (k, own) in errors.into_iter().enumerate() {
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
