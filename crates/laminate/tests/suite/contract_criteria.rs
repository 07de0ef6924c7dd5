//! Every registered criterion keeps the contract, and a broken one fails the check that it breaks.

use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

use stickslip_laminate::contract::{
    CriterionBreach, CriterionSample, CriterionViolation, check_criterion,
};
use stickslip_laminate::failure::{TsaiHill, criteria};
use stickslip_laminate::{Assessment, FailureCriterion, FailureError, Ply, PlyLoading, Strength};

use crate::{STRENGTHS, ply};

fn sample() -> CriterionSample {
    let [xt, _, yt, _, s12] = STRENGTHS;
    CriterionSample::default_for(ply(), [xt, yt, s12])
}

#[test]
fn every_registered_criterion_keeps_the_contract() {
    let names: Vec<_> = criteria().map(|info| info.name).collect();
    assert!(names.windows(2).all(|pair| pair[0] < pair[1]), "{names:?}");
    for info in criteria() {
        let criterion = (info.make)();
        assert_eq!(criterion.name(), info.name);
        assert!(!info.summary.is_empty());
        let shared: Arc<dyn FailureCriterion> = Arc::from((info.make)());
        assert_eq!(shared.title(), criterion.title());
        assert_eq!(shared.is_ultimate(), info.name == "yamada_sun");
        check_criterion(criterion.as_ref(), &sample()).unwrap();
        // Stresses far from the strengths, and a surface met after a change of sign.
        for scale in [[1e-3, 1e-3, 1e-3], [300.0, 300.0, 300.0], [20.0, 90.0, 1.0]] {
            let sample = CriterionSample::default_for(ply(), scale);
            let small = CriterionSample {
                held: vec![[0.0; 3], [-100.0, 3.0, 5.0]],
                ..sample
            };
            check_criterion(criterion.as_ref(), &small).unwrap();
        }
    }
}

/// Tsai–Hill with one thing wrong.
#[derive(Debug)]
struct Broken {
    required: &'static [Strength],
    wrong: fn(&Ply, &PlyLoading) -> Result<Assessment, FailureError>,
}

impl FailureCriterion for Broken {
    fn name(&self) -> &'static str {
        "tsai_hill"
    }

    fn required(&self) -> &'static [Strength] {
        self.required
    }

    fn assess(&self, ply: &Ply, loading: &PlyLoading) -> Result<Assessment, FailureError> {
        (self.wrong)(ply, loading)
    }
}

fn breach(wrong: fn(&Ply, &PlyLoading) -> Result<Assessment, FailureError>) -> CriterionBreach {
    requiring(TsaiHill.required(), wrong)
}

fn requiring(
    required: &'static [Strength],
    wrong: fn(&Ply, &PlyLoading) -> Result<Assessment, FailureError>,
) -> CriterionBreach {
    let CriterionViolation { breach, .. } =
        check_criterion(&Broken { required, wrong }, &sample()).unwrap_err();
    *breach
}

/// What Tsai–Hill says, with `change` made to it.
fn changed(
    ply: &Ply,
    loading: &PlyLoading,
    change: impl FnOnce(&mut Assessment),
) -> Result<Assessment, FailureError> {
    let mut found = TsaiHill.assess(ply, loading)?;
    change(&mut found);
    Ok(found)
}

#[test]
fn the_unbroken_one_passes() {
    let wrong = |ply: &Ply, loading: &PlyLoading| TsaiHill.assess(ply, loading);
    let required = TsaiHill.required();
    check_criterion(&Broken { required, wrong }, &sample()).unwrap();
}

#[test]
fn a_ply_without_stress_that_fails() {
    let found = breach(|ply, loading| {
        changed(ply, loading, |found| {
            if *loading == PlyLoading::default() {
                found.reserve_factor = 1e12;
            }
        })
    });
    assert!(
        matches!(found, CriterionBreach::FailsUnloaded { .. }),
        "{found}"
    );
}

#[test]
fn answers_that_are_none() {
    for value in [f64::NAN, -1.0] {
        let found = if value < 0.0 {
            breach(|ply, loading| changed(ply, loading, |found| found.reserve_factor = -1.0))
        } else {
            breach(|ply, loading| changed(ply, loading, |found| found.index = f64::NAN))
        };
        assert!(matches!(found, CriterionBreach::NoAnswer { .. }), "{found}");
    }
    let found = breach(|ply, loading| changed(ply, loading, |found| found.criterion = "hill"));
    assert!(
        matches!(found, CriterionBreach::Name { name: "hill" }),
        "{found}"
    );
    let found = breach(|ply, loading| {
        if loading.applied[0] > 0.0 {
            let values = loading.applied.to_vec();
            return Err(FailureError::NotFinite {
                quantity: "stress",
                values,
            });
        }
        TsaiHill.assess(ply, loading)
    });
    assert!(matches!(found, CriterionBreach::Refused { .. }), "{found}");
}

#[test]
fn a_memory() {
    static ASKED: AtomicUsize = AtomicUsize::new(0);
    let found = breach(|ply, loading| {
        changed(ply, loading, |found| {
            let asked = ASKED.fetch_add(1, Ordering::Relaxed);
            found.index *= 1.0 + 1e-14 * asked as f64;
        })
    });
    assert!(matches!(found, CriterionBreach::NotPure { .. }), "{found}");
}

#[test]
fn a_sign_of_shear() {
    let found = breach(|ply, loading| {
        let one_sided = |mut stress: [f64; 3]| {
            if stress[2] < 0.0 {
                stress[2] = 0.0;
            }
            stress
        };
        let loading = PlyLoading {
            held: one_sided(loading.held),
            applied: one_sided(loading.applied),
        };
        TsaiHill.assess(ply, &loading)
    });
    assert!(
        matches!(found, CriterionBreach::ShearSign { .. }),
        "{found}"
    );
}

#[test]
fn a_reserve_factor_that_is_not_where_the_index_is_one() {
    let late = breach(|ply, loading| changed(ply, loading, |found| found.reserve_factor *= 1.01));
    assert!(
        matches!(late, CriterionBreach::FailsBefore { .. }),
        "{late}"
    );
    let early = breach(|ply, loading| changed(ply, loading, |found| found.reserve_factor *= 0.99));
    assert!(
        matches!(early, CriterionBreach::HoldsBeyond { .. }),
        "{early}"
    );
    // A square root forgotten: the reserve factor is that of the index.
    let square = breach(|ply, loading| {
        changed(ply, loading, |found| {
            if loading.held == [0.0; 3] && found.reserve_factor.is_finite() {
                found.reserve_factor *= found.reserve_factor;
            }
        })
    });
    let wrong = [
        matches!(square, CriterionBreach::FailsBefore { .. }),
        matches!(square, CriterionBreach::HoldsBeyond { .. }),
    ];
    assert!(wrong.contains(&true), "{square}");
}

/// Surfaces that shrink with the load keep index and reserve factor together, but not from one load to another.
#[test]
fn a_surface_that_moves_with_the_load() {
    let found = breach(|ply, loading| {
        changed(ply, loading, |found| {
            if loading.applied.iter().all(|stress| stress.abs() < 1.0) {
                found.reserve_factor *= 1.0 - 1e-10;
            }
        })
    });
    assert!(
        matches!(found, CriterionBreach::NotHomogeneous { .. }),
        "{found}"
    );
}

#[test]
fn stresses_that_are_not_finite() {
    let found = breach(|ply, loading| {
        let finite = loading
            .held
            .iter()
            .chain(&loading.applied)
            .all(|s| s.is_finite());
        if finite {
            TsaiHill.assess(ply, loading)
        } else {
            TsaiHill.assess(ply, &PlyLoading::default())
        }
    });
    assert!(
        matches!(found, CriterionBreach::NotFiniteAccepted { .. }),
        "{found}"
    );
}

#[test]
fn strengths_that_it_does_not_say_or_need() {
    let sound = |ply: &Ply, loading: &PlyLoading| TsaiHill.assess(ply, loading);
    let more = requiring(&[Strength::Xt, Strength::Xc], sound);
    assert!(
        matches!(more, CriterionBreach::RequiresMore { .. }),
        "{more}"
    );
    let fewer = requiring(
        &[
            Strength::Xt,
            Strength::Xc,
            Strength::Yt,
            Strength::Yc,
            Strength::S12,
            Strength::S23,
        ],
        sound,
    );
    let strength = Strength::S23;
    assert!(
        matches!(fewer, CriterionBreach::NotRequired { strength: found, .. } if found == strength),
        "{fewer}"
    );
}

#[test]
fn a_sample_of_nothing_is_distinguished_from_a_broken_criterion() {
    let empty = CriterionSample {
        applied: Vec::new(),
        ..sample()
    };
    let CriterionViolation { breach, .. } = check_criterion(&TsaiHill, &empty).unwrap_err();
    assert_eq!(
        *breach,
        CriterionBreach::UselessSample { missing: "stress" }
    );
}
