//! One joint: its scene with changes, and what is read from its results.

use std::path::Path;

use stickslip::results::{BodyFailure, FirstPly, Results};
use stickslip::run::run;
use stickslip::scene::Scene;
use stickslip_laminate::{FailureMode, Layup};

use super::Trouble;

/// Hole radius of both scenes `[mm]`.
const RADIUS: f64 = 3.0;
/// Ply thickness of both scenes `[mm]`.
const PLY: f64 = 0.125;
/// Bearing stresses P/(D t) of the load steps `[MPa]`; small steps, because contact is not linear in the load.
const MEANS: [f64; 12] = [
    50.0, 100.0, 150.0, 200.0, 250.0, 300.0, 350.0, 400.0, 450.0, 500.0, 550.0, 600.0,
];
/// The step whose stresses are compared: 300 MPa.
const COMPARED: usize = 5;
/// P/(D t) of that step `[MPa]`.
pub(super) const MEAN: f64 = MEANS[COMPARED];

/// What loads the hole.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Load {
    /// The assumed pressure.
    Cosine,
    /// A bolt in contact.
    Contact {
        /// Clearance of the radii over the hole's.
        clearance: f64,
        /// Coefficient of friction.
        friction: f64,
    },
}

/// Stresses over P/(D t), and first-ply failure.
#[derive(Clone, Debug)]
pub(super) struct Row {
    pub(super) layup: &'static str,
    pub(super) load: Load,
    /// Largest σ_θ and its angle `[degree]`.
    pub(super) peak_hoop: [f64; 2],
    /// σ_θ at 90°.
    pub(super) net_hoop: f64,
    /// Largest −σ_r and its angle `[degree]`.
    pub(super) peak_pressure: [f64; 2],
    /// Largest |τ_rθ|.
    pub(super) peak_shear: f64,
    /// Where contact or the assumed pressure ends `[degree]`.
    pub(super) end: f64,
    /// By criterion.
    pub(super) failures: Vec<Failure>,
    /// θ `[degree]`, −σ_r, σ_θ, τ_rθ over half of the edge.
    pub(super) profile: Vec<[f64; 4]>,
}

/// First-ply failure by one criterion.
#[derive(Clone, Debug)]
pub(super) struct Failure {
    pub(super) criterion: &'static str,
    /// P/(D t) `[MPa]`.
    pub(super) bearing: f64,
    /// Whether the load steps reach it.
    pub(super) reached: bool,
    /// Direction of the ply's fibres, as written.
    pub(super) ply: String,
    pub(super) mode: FailureMode,
    /// Angle of the place `[degree]`, and radius over that of the hole.
    pub(super) place: [f64; 2],
}

impl Load {
    fn scene(self) -> &'static str {
        match self {
            Self::Cosine => "joint-assumed-cosine",
            Self::Contact { .. } => "joint-computed-contact",
        }
    }
}

/// Solves one joint on a mesh with corner nodes every `spacing` degrees.
pub(super) fn solve(layup: &'static str, load: Load, spacing: f64) -> Result<Row, Trouble> {
    let thickness = PLY * layup.parse::<Layup>()?.stack().len() as f64;
    let steps: Vec<String> = MEANS
        .iter()
        .map(|mean| format!("\"{} N\"", mean * 2.0 * RADIUS * thickness))
        .collect();
    let kind = match load {
        Load::Cosine => "bearing",
        Load::Contact { .. } => "force",
    };
    let mut changes = vec![
        format!("materials.laminate.laminate.layup={layup}"),
        format!("mesh.spacing=\"{spacing} deg\""),
        format!("loads.0.{kind}.steps=[{}]", steps.join(", ")),
        "output.fields=\"none\"".to_owned(),
    ];
    if let Load::Contact {
        clearance,
        friction,
    } = load
    {
        let pin = RADIUS * (1.0 - clearance);
        changes.push(format!("bodies.pin.thickness=\"{thickness} mm\""));
        changes.push(format!("bodies.pin.shape.disk.radius=\"{pin:.12} mm\""));
        changes.push(format!("contacts.0.friction.coulomb.mu={friction}"));
    }
    let scenes = Path::new(env!("CARGO_MANIFEST_DIR")).join("../scenes");
    let path = scenes.join(load.scene()).with_extension("toml");
    let scene = Scene::from_file(&path, &changes)?;
    let results = run(&scene, &mut |_| {})?;
    read(layup, load, &results)
}

fn read(layup: &'static str, load: Load, results: &Results) -> Result<Row, Trouble> {
    let (Some(geometry), Some(step)) = (results.edges.first(), results.steps.get(COMPARED)) else {
        return Err(format!("{layup}: no edge in step {COMPARED}").into());
    };
    let edge = &step.edges[0];
    let profile: Vec<[f64; 4]> = edge
        .rows
        .iter()
        .zip(&geometry.parameter)
        .map(|(row, theta)| {
            let [pressure, hoop, shear] =
                [-row.sigma_normal, row.sigma_tangential, row.tau].map(|stress| stress / MEAN);
            [theta.to_degrees(), pressure, hoop, shear]
        })
        .filter(|row| row[0] >= 0.0)
        .collect();
    let net = profile.iter().find(|row| (row[0] - 90.0).abs() < 1e-6);
    let Some(net) = net else {
        return Err("no node at 90°".into());
    };
    let peak = |column: usize| {
        let largest = profile
            .iter()
            .max_by(|a, b| a[column].total_cmp(&b[column]));
        largest.map_or([f64::NAN; 2], |row| [row[column], row[0]])
    };
    let failure = results.failure.first();
    let failure = failure.ok_or_else(|| format!("{layup}: nothing is asked of the plies"))?;
    Ok(Row {
        layup,
        load,
        peak_hoop: peak(2),
        net_hoop: net[2],
        peak_pressure: peak(1),
        peak_shear: profile.iter().fold(0.0, |most, row| row[3].abs().max(most)),
        end: match load {
            Load::Cosine => 90.0,
            Load::Contact { .. } => edge.contact_half_extent.map_or(f64::NAN, f64::to_degrees),
        },
        failures: failure
            .first_ply
            .iter()
            .flatten()
            .map(|first| first_ply(failure, first))
            .collect(),
        profile,
    })
}

fn first_ply(failure: &BodyFailure, first: &FirstPly) -> Failure {
    let end = MEANS[first.step];
    let bearing = if first.reached {
        let start = first.step.checked_sub(1).map_or(0.0, |step| MEANS[step]);
        start + first.factor * (end - start)
    } else {
        end * first.factor
    };
    let (theta, r) = failure
        .polar(first.at.position)
        .unwrap_or((f64::NAN, f64::NAN));
    Failure {
        criterion: first.at.criterion,
        bearing,
        reached: first.reached,
        ply: failure.ply_name(first.at.ply),
        mode: first.at.mode,
        place: [theta.to_degrees(), r / RADIUS],
    }
}
