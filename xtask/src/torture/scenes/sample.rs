//! A scene and its answer, and what a check says of them.

use std::path::PathBuf;

use serde_json::Value;
use stickslip::host::HOST;
use stickslip::output::sentence;
use stickslip::results::{ContactFinding, CutBackEffect, EdgeGeometry, Finding, Results};
use stickslip::scene::schema::Substance;
use stickslip::scene::shape::Edge;
use stickslip::scene::{Format, Scene};
use stickslip_contact::ContactError;

use super::quantity;

/// Why there is no answer.
#[derive(Clone, Debug)]
pub(super) enum NoAnswer {
    /// The scene, or the model of it, is refused.
    Refused(String),
    /// A load step has no balance, which is proved.
    Impossible(String),
    /// A load step is not solved.
    Unsolved(String),
}

impl NoAnswer {
    /// What became of the trial.
    pub(super) fn outcome(&self) -> &'static str {
        match self {
            Self::Refused(_) => "refused",
            Self::Impossible(_) => "proved impossible",
            Self::Unsolved(_) => "not solved",
        }
    }

    /// As messages say it.
    pub(super) fn describe(&self) -> String {
        let (Self::Refused(why) | Self::Impossible(why) | Self::Unsolved(why)) = self;
        format!("{}: {why}", self.outcome())
    }
}

/// A scene and its answer.
pub(super) struct Sample {
    pub(super) value: Value,
    pub(super) scene: Scene,
    pub(super) results: Results,
}

/// What a check says.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Verdict {
    /// The check does not concern the scene.
    Beside,
    /// It holds.
    Holds,
    /// It does not hold, and the results say why it need not.
    Declared(String),
    /// The answer to compare with is missing, and may be.
    Unanswered(String),
    /// It does not hold.
    Fails(String),
}

/// Where tables that scenes name lie.
pub(super) fn data_folder() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../crates/scene/src/templates")
}

/// Reads a scene from `text`.
pub(super) fn read(text: &str, format: Format) -> Result<Scene, NoAnswer> {
    Scene::from_text_on(
        text,
        format,
        "torture",
        &data_folder(),
        &[] as &[&str],
        HOST,
    )
    .map_err(|error| NoAnswer::Refused(error.to_string()))
}

/// Reads and runs a scene.
pub(super) fn solve(value: &Value) -> Result<Sample, NoAnswer> {
    let scene = read(&value.to_string(), Format::Json)?;
    let results = run(&scene)?;
    Ok(Sample {
        value: value.clone(),
        scene,
        results,
    })
}

/// Runs a scene.
pub(super) fn run(scene: &Scene) -> Result<Results, NoAnswer> {
    stickslip::run::run(scene, &mut |_| {}).map_err(|error| match error.contact() {
        Some(ContactError::StepFailed { cause, .. }) if cause.is_proved_impossible() => {
            NoAnswer::Impossible(error.to_string())
        }
        Some(ContactError::StepFailed { .. }) => NoAnswer::Unsolved(error.to_string()),
        _ => NoAnswer::Refused(error.to_string()),
    })
}

impl Sample {
    /// What the results say of an answer that need not be the only one, or that depends on the path of the solution.
    pub(super) fn declared(&self) -> Option<String> {
        declared(&self.results)
    }

    /// The length `[mm]` by which a pressure of 1 MPa shortens the softest body: its largest circle or edge over its smallest modulus.
    pub(super) fn give(&self) -> f64 {
        self.size() / self.moduli()[0]
    }

    /// The smallest and the largest modulus `[MPa]`.
    pub(super) fn moduli(&self) -> [f64; 2] {
        let keys = ["/isotropic/young", "/orthotropic/e2", "/orthotropic/e1"];
        let materials = quantity::table(&self.value, "materials").map(|(_, material)| material);
        let all = materials.flat_map(|material| {
            // Those of the only ply.
            let plies = material
                .get("laminate")
                .map_or([None; 2], |_| [Some(9e3), Some(14e4)]);
            let given = keys.map(|key| quantity::number(material, key));
            given.into_iter().chain(plies).flatten()
        });
        all.fold([f64::INFINITY, 0.0], |[least, most]: [f64; 2], modulus| {
            [least.min(modulus), most.max(modulus)]
        })
    }

    /// The largest gap, slip or given displacement of the history `[mm]`.
    pub(super) fn motion(&self) -> f64 {
        let edges = self.results.steps.iter().flat_map(|step| &step.edges);
        let rows = edges
            .flat_map(|edge| &edge.rows)
            .map(|row| row.gap.abs().max(row.slip.abs()));
        let supports = self.scene.supports.iter();
        let given = supports.map(|support| support.displacement.abs());
        rows.chain(given).fold(0.0, f64::max)
    }

    /// The size of what touches `[mm]`: the largest hole, rim or half length.
    pub(super) fn size(&self) -> f64 {
        let sizes = self.scene.bodies.values().map(|body| {
            let shape = &body.shape;
            let round = shape.edges().first().and_then(Edge::circle);
            let [low, high] = shape.bounds();
            let half = shape.mirror().is_some();
            round.unwrap_or(if half { high[0] } else { high[0] - low[0] })
        });
        sizes.fold(0.0, f64::max)
    }

    /// Thickness of a body `[mm]`; none of a rigid one.
    pub(super) fn thickness(&self, body: &str) -> Option<f64> {
        match &self.scene.bodies.get(body)?.substance {
            Substance::Elastic { thickness, .. } => Some(*thickness),
            Substance::Rigid => None,
        }
    }

    /// Geometry of the contact edges with their indices among all edges.
    pub(super) fn contacts(&self) -> impl Iterator<Item = (usize, &EdgeGeometry)> {
        let edges = self.results.edges.iter().enumerate();
        edges.filter(|(_, geometry)| geometry.contact)
    }

    /// Whether a half is modelled.
    pub(super) fn is_half(&self) -> bool {
        let mut choices = self.results.choices.iter();
        choices.any(|choice| choice.what == "model" && choice.value == "half")
    }

    /// Whether all bodies are round, or all belong to a line contact.
    pub(super) fn is_round(&self) -> bool {
        self.scene.bodies.values().all(|body| body.shape.is_round())
    }

    /// Whether all bodies are rings and disks.
    pub(super) fn is_circular(&self) -> bool {
        let mut bodies = self.scene.bodies.values();
        bodies.all(|body| (body.shape.edges().iter()).all(|edge| edge.circle().is_some()))
    }
}

/// What `results` say of an answer that need not be the only one, or that depends on the path of the solution.
pub(super) fn declared(results: &Results) -> Option<String> {
    let declares = |finding: &&Finding| match finding {
        Finding::PointsInDoubt { .. }
        | Finding::SeveralSolutions { .. }
        | Finding::NearUniquenessBound(_)
        | Finding::SolverDependent(_)
        | Finding::NoOtherSolver { .. } => true,
        // A cut-back that changed nothing explains nothing.
        Finding::CutBack { effect, .. } => *effect != CutBackEffect::Nothing,
        Finding::Contact { finding, .. } => {
            matches!(finding, ContactFinding::RipplingPressures { .. })
        }
        _ => false,
    };
    let found = results.findings.iter().find(declares)?;
    Some(sentence(found, results.units))
}
