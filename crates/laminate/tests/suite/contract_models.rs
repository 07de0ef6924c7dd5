//! Every registered point model keeps the contract, and a broken one fails the check that it breaks.

use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

use serde::{Deserialize, Serialize};
use serde_json::json;
use stickslip_laminate::contract::{
    ParametersBreach, PointBreach, PointSample, check_parameters, check_point_model,
};
use stickslip_laminate::failure::{criteria, criterion_named};
use stickslip_laminate::laminate::Laminate;
use stickslip_laminate::progressive::{
    ParameterInfo, PlyDiscount, PointModelInfo, PointModelParameters, PointResponse,
    ProgressiveError, TsaiHillPlasticity, point_models,
};
use stickslip_laminate::{Degradation, FailureCriterion, PointModel, PointState};

use crate::laminate;

fn sample() -> PointSample {
    PointSample::default_for(0.02, -250.0)
}

fn criterion(name: &str) -> Arc<dyn FailureCriterion> {
    Arc::from(criterion_named(name).unwrap())
}

fn flowing(hardening: f64) -> TsaiHillPlasticity {
    TsaiHillPlasticity::with_shear_modulus(laminate("[0/±45/90]s"), hardening).unwrap()
}

fn read(value: serde_json::Value) -> Box<dyn PointModelParameters> {
    serde_json::from_value(value).unwrap()
}

#[test]
fn shipped_models_keep_the_contract_with_every_criterion() {
    let plasticity =
        [0.0, 50.0, 5_000.0].map(|hardening| json!({ "plasticity": { "hardening": hardening } }));
    let discount = [
        json!({ "ply_discount": { "fibre": 0.01, "matrix": 0.1 } }),
        json!({ "ply_discount": { "criterion": "hashin", "fibre": 1e-9, "matrix": 1.0 } }),
    ];
    for layup in ["[0/±45/90]s", "[0/30_2/-45/90]"] {
        for parameters in plasticity.iter().chain(&discount) {
            let parameters = read(parameters.clone());
            let criterion = criterion(parameters.criterion().unwrap_or("tsai_hill"));
            check_parameters(parameters.as_ref(), &laminate(layup), &criterion, &sample()).unwrap();
        }
    }
    let mut names: Vec<_> = point_models().map(|info| info.name).collect();
    names.sort_unstable();
    // The last one is made below, to break the contract.
    let known = ["plasticity", "ply_discount", "sloppy"];
    assert_eq!(names, known, "a model is not checked");
    for info in criteria() {
        let degradation = Degradation::new(0.02, 0.1).unwrap();
        let laminate = laminate("[0/±45/90]s");
        let model = PlyDiscount::new(laminate, (info.make)(), degradation).unwrap();
        check_point_model(&model, &sample()).unwrap();
    }
}

/// The hardening is kept as it is given: divided by S₁₂² and multiplied again, 115 of these 999 numbers change their last bit.
#[test]
fn the_hardening_is_kept_to_the_bit() {
    for k in 1..1000 {
        let modulus = 0.1 * f64::from(k);
        let parameters = read(json!({ "plasticity": { "hardening": modulus } }));
        let written = serde_json::to_value(parameters.as_ref()).unwrap();
        let kept = written["plasticity"]["hardening"].as_f64().unwrap();
        assert_eq!(kept.to_bits(), modulus.to_bits());
        let described = parameters.describe("tsai_hill", &|stress| format!("{stress:?} ksi"));
        assert!(
            described.ends_with(&format!("modulus {modulus:?} ksi")),
            "{described}"
        );
    }
}

#[test]
fn parameters_out_of_range_are_refused_by_name() {
    let refused = |value: serde_json::Value| {
        let found: Result<Box<dyn PointModelParameters>, _> = serde_json::from_value(value);
        found.unwrap_err().to_string()
    };
    let negative = refused(json!({ "plasticity": { "hardening": -1.0 } }));
    assert!(negative.contains("hardening = -1"), "{negative}");
    let factor = refused(json!({ "ply_discount": { "fibre": 0.1, "matrix": 2.0 } }));
    assert!(factor.contains("matrix = 2"), "{factor}");
    let unknown = refused(json!({ "creep": {} }));
    assert!(unknown.contains("creep"), "{unknown}");
}

/// What a broken model makes of a step: the state before, the strain, the sound response.
type Wrong = fn(&PointState, [f64; 3], PointResponse) -> PointResponse;

/// Plasticity with one thing wrong.
#[derive(Debug)]
struct Broken {
    sound: TsaiHillPlasticity,
    wrong: Wrong,
}

impl PointModel for Broken {
    fn laminate(&self) -> &Laminate {
        self.sound.laminate()
    }

    fn respond(
        &self,
        committed: &PointState,
        strain: [f64; 3],
        temperature: f64,
    ) -> Result<PointResponse, ProgressiveError> {
        let response = self.sound.respond(committed, strain, temperature)?;
        Ok((self.wrong)(committed, strain, response))
    }
}

fn breach(wrong: Wrong) -> PointBreach {
    let sound = flowing(50.0);
    *check_point_model(&Broken { sound, wrong }, &sample())
        .unwrap_err()
        .breach
}

/// `response` with `change` made to it.
fn changed(mut response: PointResponse, change: impl FnOnce(&mut PointResponse)) -> PointResponse {
    change(&mut response);
    response
}

#[test]
fn the_unbroken_one_passes() {
    let sound = flowing(50.0);
    let wrong: Wrong = |_, _, response| response;
    check_point_model(&Broken { sound, wrong }, &sample()).unwrap();
}

#[test]
fn a_tangent_that_is_not_the_derivative() {
    // The elastic stiffness in place of the consistent tangent.
    let found = breach(|_, strain, response| {
        changed(response, |response| {
            if strain != [0.0; 3] {
                response.tangent[0][0] *= 1.01;
            }
        })
    });
    assert!(
        matches!(
            found,
            PointBreach::WrongTangent {
                row: 0,
                column: 0,
                ..
            }
        ),
        "{found}"
    );
    let found =
        breach(|_, _, response| changed(response, |response| response.tangent[0][2] += 1.0));
    assert!(matches!(found, PointBreach::NotSymmetric { .. }), "{found}");
}

#[test]
fn numbers_that_are_not_finite() {
    let found =
        breach(|_, _, response| changed(response, |response| response.trial.stored = f64::NAN));
    assert!(
        matches!(
            found,
            PointBreach::NotFinite {
                quantity: "an energy",
                ..
            }
        ),
        "{found}"
    );
}

#[test]
fn a_trial_of_another_step() {
    let found = breach(|state, _, response| {
        changed(response, |response| response.trial.strain = state.strain)
    });
    assert!(
        matches!(
            found,
            PointBreach::OtherState {
                quantity: "strain",
                ..
            }
        ),
        "{found}"
    );
}

#[test]
fn a_step_without_change_that_changes_something() {
    // Creep: the stress relaxes at every step, whether the strain changes or not.
    let found = breach(|_, _, response| {
        changed(response, |response| {
            response.trial.layers[0].hardening += 1.0;
        })
    });
    assert!(matches!(found, PointBreach::ZeroStep { .. }), "{found}");
    let found = breach(|_, _, response| changed(response, |response| response.stress[1] += 1.0));
    assert!(
        matches!(
            found,
            PointBreach::ZeroStep {
                quantity: "a stress",
                ..
            }
        ),
        "{found}"
    );
    let found = breach(|state, strain, response| {
        changed(response, |response| {
            if state.strain == strain && strain != [0.0; 3] {
                response.stress[1] *= 0.99;
            }
        })
    });
    assert!(
        matches!(
            found,
            PointBreach::ZeroStep {
                quantity: "a stress",
                ..
            }
        ),
        "{found}"
    );
}

#[test]
fn energy_that_comes_back() {
    let found = breach(|state, strain, response| {
        changed(response, |response| {
            let free = state.strain != strain && strain == [0.0; 3];
            response.trial.dissipated = if free { 0.0 } else { response.trial.dissipated };
        })
    });
    assert!(
        matches!(found, PointBreach::NegativeDissipation { .. }),
        "{found}"
    );
    let found = breach(|_, strain, response| {
        changed(response, |response| {
            if strain != [0.0; 3] {
                response.trial.stored *= -1.0;
            }
        })
    });
    assert!(
        matches!(found, PointBreach::NegativeStored { .. }),
        "{found}"
    );
}

#[test]
fn a_trial_that_leaves_a_trace() {
    static ASKED: AtomicUsize = AtomicUsize::new(0);
    let found = breach(|_, _, response| {
        let asked = ASKED.fetch_add(1, Ordering::Relaxed);
        changed(response, |response| {
            response.stress[0] *= 1.0 + 1e-15 * asked as f64;
        })
    });
    assert!(matches!(found, PointBreach::NotPure { .. }), "{found}");
}

#[test]
fn damage_that_heals() {
    // Layer 0 is damaged as long as it is stretched.
    let found = breach(|_, strain, response| {
        changed(response, |response| {
            response.trial.layers[0].damage.matrix = strain[0] > 0.0;
        })
    });
    assert!(
        matches!(found, PointBreach::Healed { layer: 0, .. }),
        "{found}"
    );
}

/// Answers to any step and any state.
#[derive(Debug)]
struct Credulous(TsaiHillPlasticity);

impl PointModel for Credulous {
    fn laminate(&self) -> &Laminate {
        self.0.laminate()
    }

    fn respond(
        &self,
        committed: &PointState,
        strain: [f64; 3],
        temperature: f64,
    ) -> Result<PointResponse, ProgressiveError> {
        let finite = strain.iter().all(|component| component.is_finite());
        let strain = if finite { strain } else { [0.0; 3] };
        self.0.respond(committed, strain, temperature)
    }
}

#[test]
fn nonsense_that_gets_an_answer() {
    let found = check_point_model(&Credulous(flowing(0.0)), &sample()).unwrap_err();
    assert!(
        matches!(*found.breach, PointBreach::NonsenseAccepted { .. }),
        "{found}"
    );
    let empty = PointSample {
        paths: Vec::new(),
        strain_scale: 0.01,
    };
    let found = check_point_model(&flowing(0.0), &empty).unwrap_err();
    assert!(
        matches!(*found.breach, PointBreach::UselessSample { .. }),
        "{found}"
    );
}

/// Parameters whose `loss` is not described where it is registered.
#[derive(Debug, Serialize, Deserialize)]
struct Sloppy {
    hardening: f64,
    #[serde(skip_serializing_if = "Option::is_none")]
    loss: Option<f64>,
}

#[typetag::serde(name = "sloppy")]
impl PointModelParameters for Sloppy {
    fn model(
        &self,
        laminate: Laminate,
        _criterion: &Arc<dyn FailureCriterion>,
    ) -> Result<Arc<dyn PointModel>, ProgressiveError> {
        let model = TsaiHillPlasticity::with_shear_modulus(laminate, self.hardening)?;
        Ok(Arc::new(model))
    }
}

stickslip_laminate::inventory::submit! {
    PointModelInfo {
        name: "sloppy",
        summary: "a model of this test",
        parameters: &[ParameterInfo::stress("hardening", "plastic shear modulus")],
    }
}

/// A unit struct with a name that no entry has.
#[derive(Debug, Serialize, Deserialize)]
struct Nameless {}

#[typetag::serde(name = "nameless")]
impl PointModelParameters for Nameless {
    fn model(
        &self,
        laminate: Laminate,
        _criterion: &Arc<dyn FailureCriterion>,
    ) -> Result<Arc<dyn PointModel>, ProgressiveError> {
        Ok(Arc::new(TsaiHillPlasticity::new(laminate, 0.0)?))
    }
}

#[test]
fn parameters_that_a_file_cannot_trust() {
    let breach = |parameters: &dyn PointModelParameters| {
        let found = check_parameters(
            parameters,
            &laminate("[0]"),
            &criterion("hashin"),
            &sample(),
        );
        match *found.unwrap_err().breach {
            PointBreach::Parameters(breach) => breach,
            other => panic!("{other}"),
        }
    };
    let name = "nameless";
    assert_eq!(
        breach(&Nameless {}),
        ParametersBreach::NotRegistered { name }
    );
    let sloppy = |hardening, loss| breach(&Sloppy { hardening, loss });
    let found = sloppy(1.0, Some(0.5));
    let parameter = "loss".to_owned();
    assert_eq!(found, ParametersBreach::NotDescribed { parameter });
    let found = sloppy(1.0, None);
    assert!(
        matches!(found, ParametersBreach::UnknownParameterAccepted { .. }),
        "{found}"
    );
    let found = sloppy(f64::NAN, None);
    assert!(
        matches!(found, ParametersBreach::NotSerialisable { .. }),
        "{found}"
    );
}
