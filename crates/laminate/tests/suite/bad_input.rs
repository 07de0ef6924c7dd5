//! Input that means nothing is refused by name and value.

use std::sync::Arc;

use stickslip_laminate::failure::{
    EnvelopeEvent, EnvelopePlane, Hashin, Hoffman, Interaction, MaximumStress, TsaiHill,
    TsaiHillSolid, TsaiWu, criterion_named, failure_envelope, first_ply_failure,
};
use stickslip_laminate::progressive::{PlyDiscount, ProgressiveError, TsaiHillPlasticity};
use stickslip_laminate::{
    Degradation, FailureCriterion, FailureError, Laminate, LaminateError, LaminateLoad, Ply,
    PlyConstants, PlyLoading, PointModel, Strength, Strengths,
};

use crate::{constants, laminate, ply, ply_with, strengths};

fn refused(change: impl Fn(&mut PlyConstants)) -> String {
    let mut given = constants();
    change(&mut given);
    Ply::new("T300", given, strengths())
        .unwrap_err()
        .to_string()
}

#[test]
fn plies_name_themselves_and_the_value() {
    let cases = [
        (refused(|c| c.e1 = -1.0), "E1 = -1"),
        (refused(|c| c.e2 = 0.0), "E2 = 0"),
        (refused(|c| c.g12 = f64::NAN), "G12 = NaN"),
        (refused(|c| c.nu12 = 3.2), "nu12 = 3.2"),
        (refused(|c| c.alpha2 = f64::INFINITY), "alpha2 = inf"),
        (refused(|c| c.thickness = -0.005), "thickness = -0.005"),
    ];
    for (message, value) in cases {
        assert!(
            message.contains("ply 'T300'") && message.contains(value),
            "{message}"
        );
    }
    let negative = Strengths {
        xc: Some(-252.1),
        ..strengths()
    };
    let message = Ply::new("T300", constants(), negative)
        .unwrap_err()
        .to_string();
    assert!(
        message.contains("xc = -252.1") && message.contains("magnitudes"),
        "{message}"
    );
}

#[test]
fn laminates_name_layer_and_ply() {
    assert_eq!(Laminate::from_layers([]), Err(LaminateError::Empty));
    let angle =
        Laminate::from_layers([(Arc::new(ply()), 0.0), (Arc::new(ply()), f64::NAN)]).unwrap_err();
    assert!(
        angle
            .to_string()
            .contains("layer 2 (ply 'carbon'): angle = NaN"),
        "{angle}"
    );
    let unknown = Laminate::new(&"[0/90:glass]".parse().unwrap(), &ply()).unwrap_err();
    let known = vec!["carbon".to_owned()];
    assert_eq!(
        unknown,
        LaminateError::UnknownPly {
            layer: 1,
            ply: "glass".to_owned(),
            known
        }
    );
    let text = unknown.to_string();
    assert!(text.contains("layer 2 names ply 'glass'"), "{text}");
    let huge = PlyConstants {
        e1: 1e308,
        e2: 1e308,
        ..constants()
    };
    let huge = Ply::new(
        "huge",
        PlyConstants {
            thickness: 1e10,
            ..huge
        },
        strengths(),
    )
    .unwrap();
    assert_eq!(
        Laminate::new(&"[0_4]".parse().unwrap(), &huge),
        Err(LaminateError::NotInvertible)
    );
    let damage = laminate("[0/90]").damaged(&[], &Degradation::new(0.1, 0.1).unwrap());
    assert_eq!(
        damage,
        Err(LaminateError::LayerCount {
            layers: 2,
            given: 0
        })
    );
}

#[test]
fn an_unsymmetric_membrane_is_refused_with_the_size() {
    let message = laminate("[0_2/90]")
        .membrane_material()
        .unwrap_err()
        .to_string();
    assert!(
        message.contains("not symmetric") && message.contains("coupling of 0."),
        "{message}"
    );
}

#[test]
fn named_plies_are_found() {
    let glass = Ply::new(
        "glass",
        PlyConstants {
            e1: 6_000.0,
            ..constants()
        },
        strengths(),
    )
    .unwrap();
    let hybrid =
        Laminate::of_plies(&"[0/90:glass/45:carbon]".parse().unwrap(), &ply(), &[glass]).unwrap();
    let names: Vec<_> = hybrid
        .layers()
        .iter()
        .map(|layer| layer.ply().name())
        .collect();
    assert_eq!(names, ["carbon", "glass", "carbon"]);
}

#[test]
fn missing_strengths_name_criterion_and_strength() {
    let loading = PlyLoading::mechanical([1.0; 3]);
    let without = ply_with(Strengths {
        s23: None,
        ..strengths()
    });
    let error = Hashin::default().assess(&without, &loading).unwrap_err();
    assert_eq!(Hashin::default().check(&without), Err(error.clone()));
    let expected = FailureError::MissingStrength {
        criterion: "hashin",
        strength: Strength::S23,
        ply: "carbon".into(),
    };
    assert_eq!(error, expected);
    assert!(error.to_string().contains("'hashin' needs s23"), "{error}");
    let none = ply_with(Strengths::default());
    assert!(matches!(
        TsaiHill.check(&none),
        Err(FailureError::NoStrengths {
            criterion: "tsai_hill",
            ..
        })
    ));
    assert!(MaximumStress.assess(&none, &loading).is_err());
    assert!(TsaiHill.check(&without).is_ok());
    let unknown = criterion_named("puck").unwrap_err().to_string();
    assert!(
        unknown.contains("'puck'") && unknown.contains("tsai_wu"),
        "{unknown}"
    );
}

#[test]
fn criteria_refuse_what_has_no_answer() {
    let nan = PlyLoading::mechanical([f64::NAN, 0.0, 0.0]);
    assert!(matches!(
        TsaiHill.assess(&ply(), &nan),
        Err(FailureError::NotFinite { .. })
    ));
    for factor in [1.0, -1.0, f64::NAN] {
        let open = TsaiWu {
            interaction: Interaction::Normalised(factor),
        };
        let result = open.assess(&ply(), &PlyLoading::mechanical([1.0; 3]));
        assert!(matches!(result, Err(FailureError::OpenSurface { .. })));
    }
    // Y = 2X; Y_t Y_c = 4 X_t X_c; a normal much weaker than both other directions.
    let thick = ply_with(Strengths::in_plane(10.0, 10.0, 20.0, 20.0, 5.0));
    let weak = ply_with(Strengths {
        zt: Some(3.0),
        ..strengths()
    });
    let open: [(&dyn FailureCriterion, &Ply); 3] = [
        (&TsaiHill, &thick),
        (&Hoffman, &thick),
        (&TsaiHillSolid, &weak),
    ];
    for (criterion, ply) in open {
        let error = criterion
            .assess(ply, &PlyLoading::mechanical([1.0; 3]))
            .unwrap_err();
        assert!(matches!(error, FailureError::OpenSurface { .. }));
        assert!(
            error
                .to_string()
                .contains(&format!("'{}', ply 'carbon'", criterion.name())),
            "{error}"
        );
    }
    assert!(Hashin::with_shear_weight(1.5).is_err());
    let load = LaminateLoad::membrane([f64::INFINITY, 0.0, 0.0]);
    assert!(first_ply_failure(&laminate("[0]"), &load, &TsaiHill).is_err());
    let few = failure_envelope(
        &laminate("[0]"),
        EnvelopePlane::NormalNormal,
        2,
        0.0,
        &TsaiHill,
        EnvelopeEvent::First,
    );
    assert_eq!(few, Err(FailureError::Directions { directions: 2 }));
}

#[test]
fn stresses_beyond_all_measure_fail_at_once() {
    // Their squares overflow.
    for stress in [[1e200, 0.0, 0.0], [1e308, -1e308, 1e308]] {
        let assessment = TsaiHill
            .assess(&ply(), &PlyLoading::mechanical(stress))
            .unwrap();
        assert!(assessment.index > 1.0 && assessment.reserve_factor < 1e-100);
    }
}

#[test]
fn progressive_models_refuse_at_the_door() {
    for value in [0.0, -0.1, 1.1, f64::NAN] {
        assert!(Degradation::new(value, 0.5).is_err() && Degradation::new(0.5, value).is_err());
    }
    let half = Degradation::new(0.5, 0.5).unwrap();
    let none = Laminate::new(&"[0]".parse().unwrap(), &ply_with(Strengths::default())).unwrap();
    assert!(PlyDiscount::new(none.clone(), Box::new(TsaiHill), half).is_err());
    assert!(matches!(
        TsaiHillPlasticity::new(none, 0.0),
        Err(ProgressiveError::Failure(_))
    ));
    assert!(TsaiHillPlasticity::new(laminate("[0]"), -1.0).is_err());
    let flat = ply_with(Strengths::in_plane(10.0, 10.0, 25.0, 25.0, 5.0));
    let flat = Laminate::new(&"[0]".parse().unwrap(), &flat).unwrap();
    assert!(matches!(
        TsaiHillPlasticity::new(flat, 0.0),
        Err(ProgressiveError::OpenYieldSurface { .. })
    ));
    let model = TsaiHillPlasticity::new(laminate("[0]"), 0.0).unwrap();
    let state = model.initial_state();
    assert!(model.respond(&state, [f64::NAN, 0.0, 0.0], 0.0).is_err());
    let other = TsaiHillPlasticity::new(laminate("[0/90]"), 0.0)
        .unwrap()
        .initial_state();
    assert_eq!(
        model.respond(&other, [0.0; 3], 0.0),
        Err(ProgressiveError::LayerCount {
            layers: 1,
            given: 2
        })
    );
}
