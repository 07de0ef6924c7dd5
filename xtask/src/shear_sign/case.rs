//! One joint under one history: its scene with changes, and the sign of the shear in every load step.

use std::path::Path;
use std::sync::Arc;

use stickslip::model::Model;
use stickslip::results::{EdgeGeometry, EdgeKind, EdgeResults, Results};
use stickslip::run::{self, Operator};
use stickslip::scene::Scene;
use stickslip_contact::{InterfaceProblem, Status};
use stickslip_fem_core::{CondensedBody, InterfaceOperator};
use stickslip_friction::{FrictionLaw, History, Place};

use super::curve::{Point, Reading, read};
use crate::publish::Trouble;

/// Scene of the joint.
const SCENE: &str = "pin-quasi-isotropic";
/// Radial clearance of the scene, and hole radius `[in]`.
pub(crate) const CLEARANCE: f64 = 0.0005;
const RADIUS: f64 = 0.375;
/// Young's modulus of the aluminium pin `[ksi]`.
pub(crate) const ALUMINIUM: f64 = 10_400.0;

/// Stiffness of the plate.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Plate {
    /// Of the lay-up `[0_2/60_2/-60_2]s`, by lamination theory.
    Plies,
    /// Isotropic, of the moduli that the report gives for the laminate.
    Smeared,
    /// Of another lay-up of twelve layers, which is as thick.
    Layup(&'static str),
}

/// What is solved.
#[derive(Clone, Debug)]
pub(crate) struct Case {
    /// Group of cases that belong together.
    pub(crate) family: &'static str,
    /// The law, as tables show it.
    pub(crate) name: String,
    /// The law, as a scene says it.
    pub(crate) law: String,
    pub(crate) plate: Plate,
    /// Radial clearance `[in]`.
    pub(crate) clearance: f64,
    /// Young's modulus of the pin `[ksi]`.
    pub(crate) pin: f64,
    /// Load at the end of each step `[lbf]`.
    pub(crate) loads: Vec<f64>,
}

/// Where a step lies in its history.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Phase {
    /// No load was larger.
    Loading,
    Unloading,
    /// Growing again below a larger load of the past.
    Reloading,
}

/// The edge at the end of a load step.
#[derive(Clone, Debug)]
pub(crate) struct Step {
    /// `[lbf]`
    pub(crate) load: f64,
    pub(crate) phase: Phase,
    pub(crate) reading: Reading,
    /// |θ| `[degree]` and τ over P/(D t) of the nodes in contact on one half.
    pub(crate) profile: Vec<[f64; 2]>,
}

/// A case and what came of it.
#[derive(Clone, Debug)]
pub(crate) struct Row {
    pub(crate) case: Case,
    pub(crate) steps: Vec<Step>,
}

impl Case {
    /// The report's joint with `law`.
    pub(crate) fn new(family: &'static str, name: &str, law: &str, loads: &[f64]) -> Self {
        Self {
            family,
            name: name.to_owned(),
            law: law.to_owned(),
            plate: Plate::Plies,
            clearance: CLEARANCE,
            pin: ALUMINIUM,
            loads: loads.to_vec(),
        }
    }

    /// Whether plate and pin are those of `other`.
    pub(crate) fn has_the_bodies_of(&self, other: &Self) -> bool {
        self.plate == other.plate && self.pin == other.pin && self.clearance == other.clearance
    }

    /// Keys of the scene that differ.
    pub(crate) fn changes(&self, spacing: f64) -> Vec<String> {
        let steps: Vec<String> = self
            .loads
            .iter()
            .map(|load| format!("\"{load} lbf\""))
            .collect();
        let radius = RADIUS - self.clearance;
        let mut changes = vec![
            format!("contacts.0.friction={{ {} }}", self.law),
            format!("loads.0.force.steps=[{}]", steps.join(", ")),
            // The second joint is taken away, but only once the scene has been checked.
            format!("loads.1.force.steps=[{}]", steps.join(", ")),
            format!("bodies.pin.shape.disk.radius=\"{radius:.12} in\""),
            format!("materials.aluminium.isotropic.young=\"{} ksi\"", self.pin),
            format!("mesh.spacing=\"{spacing} deg\""),
        ];
        match self.plate {
            Plate::Plies => {}
            Plate::Smeared => changes.extend([
                "materials.smeared.isotropic={ young = \"7720 ksi\", poisson = 0.3 }".to_owned(),
                "bodies.plate.material=smeared".to_owned(),
                "bodies.plate.thickness=\"0.06 in\"".to_owned(),
            ]),
            Plate::Layup(layup) => {
                changes.push(format!("materials.laminate.laminate.layup={layup}"));
            }
        }
        changes
    }

    /// The scene, of which only the first of the two joints is kept.
    pub(crate) fn scene(&self, spacing: f64, more: &[&str]) -> Result<Scene, Trouble> {
        let mut changes = self.changes(spacing);
        changes.extend(more.iter().map(|&change| change.to_owned()));
        let scenes = Path::new(env!("CARGO_MANIFEST_DIR")).join("../scenes");
        let mut scene = Scene::from_file(&scenes.join(SCENE).with_extension("toml"), &changes)?;
        let kept = |body: &str| body == "plate" || body == "pin";
        scene.contacts.truncate(1);
        scene.loads.truncate(1);
        scene.supports.retain(|support| kept(&support.on.body));
        scene.bodies.retain(|name, _| kept(name));
        if let Some(failure) = &mut scene.failure {
            failure.bodies.retain(|name| kept(name));
        }
        Ok(scene)
    }
}

/// Solves cases with the same bodies, which are condensed once, on a mesh with corner nodes every `spacing` degrees.
pub(crate) fn solve_alike(cases: &[Case], spacing: f64) -> Result<Vec<Row>, Trouble> {
    let mut bodies = None;
    let solved = cases.iter().map(|case| {
        let steps = followed(case, spacing, &mut bodies);
        let named = |trouble: Trouble| format!("{}, {}: {trouble}", case.family, case.name);
        Ok(Row {
            case: case.clone(),
            steps: steps.map_err(named)?,
        })
    });
    solved.collect()
}

/// Solves one case.
pub(crate) fn solve(case: &Case, spacing: f64) -> Result<Row, Trouble> {
    let rows = solve_alike(std::slice::from_ref(case), spacing)?;
    Ok(rows.into_iter().next().ok_or("no case")?)
}

/// The history of a case; condenses its `bodies` where that has not been done.
fn followed(
    case: &Case,
    spacing: f64,
    bodies: &mut Option<Vec<Arc<CondensedBody>>>,
) -> Result<Vec<Step>, Trouble> {
    let mut scene = case.scene(spacing, &["output.fields=\"none\""])?;
    scene.failure = None;
    let model = Model::build(&scene)?;
    let condensed = match bodies {
        Some(condensed) => condensed,
        None => bodies.insert(elastic(&model)?),
    };
    let operators: Vec<Operator> = condensed
        .iter()
        .map(|body| Operator::Elastic(Arc::clone(body)))
        .collect();
    let faces: Vec<&dyn InterfaceOperator> = operators.iter().map(Operator::interface).collect();
    let problem = InterfaceProblem::new(&faces, model.pairs.clone())?;
    drop(faces);
    let solver = run::solver(scene.analysis.solver);
    let solved = run::follow(
        &model,
        operators,
        problem.into(),
        solver.as_ref(),
        &mut |_| {},
    )?;
    let results = run::results(&scene, &model, solver.as_ref(), solved)?;
    steps(case, &results, scene.contacts[0].law.as_ref())
}

fn elastic(model: &Model) -> Result<Vec<Arc<CondensedBody>>, Trouble> {
    let operators = run::condense(model)?.into_iter();
    operators
        .map(|operator| match operator {
            Operator::Elastic(body) => Ok(body),
            Operator::Rigid(_) => Err("a body is rigid".into()),
        })
        .collect()
}

fn steps(case: &Case, results: &Results, law: &dyn FrictionLaw) -> Result<Vec<Step>, Trouble> {
    let geometry = results.edges.first().ok_or("no edge")?;
    let EdgeKind::Circle { radius, .. } = geometry.kind else {
        return Err("the edge is no circle".into());
    };
    let mut steps = Vec::with_capacity(results.steps.len());
    let histories = case.loads.iter().zip(phases(&case.loads));
    for (step, (&load, phase)) in results.steps.iter().zip(histories) {
        let edge = &step.edges[0];
        let mean = edge.bearing_stress(geometry).ok_or("no bearing stress")?;
        let points = points(geometry, edge, |pressure, theta| {
            limit(law, pressure, theta, radius)
        });
        steps.push(Step {
            load,
            phase,
            reading: read(&points),
            profile: points
                .iter()
                .map(|point| [point.angle, point.shear / mean])
                .collect(),
        });
    }
    Ok(steps)
}

/// The nodes in contact on one half, with friction's `limit` by pressure and θ.
pub(crate) fn points(
    geometry: &EdgeGeometry,
    edge: &EdgeResults,
    limit: impl Fn(f64, f64) -> f64,
) -> Vec<Point> {
    let nodes = geometry.parameter.iter().zip(&edge.rows);
    nodes
        .filter(|(theta, row)| **theta >= 0.0 && row.status != Status::Open)
        .map(|(&theta, row)| Point {
            angle: theta.to_degrees(),
            shear: row.tau,
            limit: limit(row.pressure, theta),
            sticks: row.status == Status::Stick,
        })
        .collect()
}

/// Largest shear at a point that has not slipped; the fibres of all these plates are counted from x.
fn limit(law: &dyn FrictionLaw, pressure: f64, theta: f64, radius: f64) -> f64 {
    let (sine, cosine) = theta.sin_cos();
    let place = Place {
        position: [radius * cosine, radius * sine],
        tangent: [-sine, cosine],
        material_angle: 0.0,
    };
    law.bound(pressure, 0.0, &place, &History::default()).stick
}

/// The phase of every step of a history.
pub(crate) fn phases(loads: &[f64]) -> Vec<Phase> {
    let (mut last, mut largest) = (0.0, 0.0);
    let phase = |&load: &f64| {
        let phase = if load < last {
            Phase::Unloading
        } else if load < largest {
            Phase::Reloading
        } else {
            Phase::Loading
        };
        last = load;
        largest = load.max(largest);
        phase
    };
    loads.iter().map(phase).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shear_sign::curve::Pattern;

    #[test]
    fn phases_follow_the_largest_load_so_far() {
        use Phase::{Loading, Reloading, Unloading};
        let phases = phases(&[20.0, 100.0, 50.0, 60.0, 100.0, 120.0]);
        assert_eq!(
            phases,
            [Loading, Loading, Unloading, Reloading, Loading, Loading]
        );
    }

    /// Coulomb friction on the report's joint: forward at 400 lb and 900 lb, reversed outside while unloading, and at 20 lb reversed
    /// near the bearing point.
    #[test]
    fn coulomb_friction_reverses_the_outside_and_that_only_while_unloading() {
        use Pattern::{Forward, ReversedInside, ReversedOutside};
        let case = Case::new(
            "test",
            "Coulomb",
            "coulomb = { mu = 0.2 }",
            &[20.0, 400.0, 900.0, 400.0],
        );
        let row = solve(&case, 4.5).expect("it is solved");
        let patterns: Vec<Pattern> = row.steps.iter().map(|step| step.reading.pattern).collect();
        assert_eq!(
            patterns,
            [ReversedInside, Forward, Forward, ReversedOutside]
        );
        // Half of 26°, to which contact reaches at that load.
        let reach = row.steps[0].reading.reach().expect("it is inside");
        assert!(reach < 18.0, "{reach}");
        for step in &row.steps {
            let carried = step
                .reading
                .reversal
                .map_or(0.0, |reversal| reversal.of_limit);
            assert!(carried < 1.0 + 1e-9, "{carried}");
        }
    }
}
