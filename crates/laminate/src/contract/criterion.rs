//! The contract of failure criteria; its equations stand at [`contract`](crate::contract).

mod breach;

pub use breach::{CriterionBreach, CriterionViolation};

use crate::failure::{Assessment, FailureCriterion, FailureError, PlyLoading};
use crate::ply::Ply;
use crate::strengths::Strengths;

/// Rounding between two ways to the same number, relative: some hundred operations.
const ROUNDING: f64 = 1e-11;

/// How near to the reserve factor the index is looked at, relative.
const NEAR: f64 = 1e-9;

/// How far from 1 the index may be at that distance: its logarithmic slope is 2 for a quadratic form, and up to some hundred where
/// terms cancel.
const NEAR_INDEX: f64 = 1e-6;

/// Parts of the way to failure at which the index must be less than 1.
const BEFORE: [f64; 5] = [0.0, 0.25, 0.5, 0.9, 0.999];

/// Multiples at which a load that never fails the ply is looked at.
const NEVER: [f64; 4] = [0.0, 1.0, 30.0, 1000.0];

type Checked<T = ()> = Result<T, Box<CriterionBreach>>;

/// A ply and the loadings at which a criterion is tested.
#[derive(Clone, Debug, PartialEq)]
pub struct CriterionSample {
    /// The ply, with all strengths that the criterion needs.
    pub ply: Ply,
    /// Residual stresses (σ₁, σ₂, τ₁₂) `[stress]`, each combined with all of `applied`; zero among them.
    pub held: Vec<[f64; 3]>,
    /// Stresses (σ₁, σ₂, τ₁₂) of the load `[stress]`.
    pub applied: Vec<[f64; 3]>,
    /// Multiples by which loads are scaled, > 0, dimensionless.
    pub factors: Vec<f64>,
}

impl CriterionSample {
    /// Makes a sample of `ply` around the stresses `scale` = (σ₁, σ₂, τ₁₂) > 0 `[stress]`, such as its strengths: every combination of
    /// signs and sizes, alone and after two small residual stresses.
    pub fn default_for(ply: Ply, scale: [f64; 3]) -> Self {
        const SIZES: [f64; 5] = [-1.0, -0.4, 0.0, 0.3, 1.0];
        let of = |parts: [f64; 3]| [0, 1, 2].map(|i| parts[i] * scale[i]);
        let all = SIZES.into_iter().flat_map(|first| {
            SIZES
                .into_iter()
                .flat_map(move |second| SIZES.map(|shear| [first, second, shear]))
        });
        Self {
            ply,
            held: [[0.0; 3], [0.1, -0.15, 0.2], [-0.2, 0.25, -0.1]]
                .map(of)
                .to_vec(),
            applied: all.filter(|parts| *parts != [0.0; 3]).map(of).collect(),
            factors: vec![1e-3, 0.3, 1.7, 1e3],
        }
    }

    fn loadings(&self) -> impl Iterator<Item = PlyLoading> + '_ {
        self.held.iter().flat_map(|&held| {
            let applied = self.applied.iter();
            applied.map(move |&applied| PlyLoading { held, applied })
        })
    }
}

/// Tests `criterion` at `sample`.
///
/// # Errors
/// The first property that the criterion breaks, with the numbers.
pub fn check_criterion(
    criterion: &dyn FailureCriterion,
    sample: &CriterionSample,
) -> Result<(), CriterionViolation> {
    run(criterion, sample).map_err(|breach| CriterionViolation {
        criterion: criterion.name(),
        breach,
    })
}

fn run(criterion: &dyn FailureCriterion, sample: &CriterionSample) -> Checked {
    for (missing, empty) in [
        ("residual stress", sample.held.is_empty()),
        ("stress", sample.applied.is_empty()),
        ("factor", sample.factors.is_empty()),
    ] {
        if empty {
            return Err(Box::new(CriterionBreach::UselessSample { missing }));
        }
    }
    let asked = Asked {
        criterion,
        ply: &sample.ply,
    };
    asked.strengths()?;
    asked.unloaded()?;
    asked.not_finite()?;
    let mut answers = Vec::new();
    for loading in sample.loadings() {
        let found = asked.assess(loading)?;
        asked.shear_sign(loading, found)?;
        asked.first_failure(loading, found)?;
        answers.push((loading, found));
    }
    for &stress in &sample.applied {
        asked.homogeneous(stress, &sample.factors)?;
    }
    // Once more, after all other questions and in the reverse order.
    for (loading, first) in answers.into_iter().rev() {
        let second = asked.assess(loading)?;
        if first != second {
            return Err(Box::new(CriterionBreach::NotPure {
                first,
                second,
                loading,
            }));
        }
    }
    Ok(())
}

/// A criterion, evaluated for one ply.
struct Asked<'a> {
    criterion: &'a dyn FailureCriterion,
    ply: &'a Ply,
}

impl Asked<'_> {
    fn assess(&self, loading: PlyLoading) -> Checked<Assessment> {
        let found = self
            .criterion
            .assess(self.ply, &loading)
            .map_err(|cause| CriterionBreach::Refused { loading, cause })?;
        if found.criterion != self.criterion.name() {
            let name = found.criterion;
            return Err(Box::new(CriterionBreach::Name { name }));
        }
        // A NaN is not at least 0.
        if !(found.index.is_finite() && found.reserve_factor >= 0.0) {
            return Err(Box::new(CriterionBreach::NoAnswer { found, loading }));
        }
        Ok(found)
    }

    /// The index at `factor` times the load.
    fn index(&self, loading: &PlyLoading, factor: f64) -> Checked<f64> {
        let there = PlyLoading::mechanical(loading.at(factor));
        Ok(self.assess(there)?.index)
    }

    fn unloaded(&self) -> Checked {
        let Assessment {
            index,
            reserve_factor,
            ..
        } = self.assess(PlyLoading::default())?;
        if index < 1.0 && reserve_factor == f64::INFINITY {
            Ok(())
        } else {
            Err(Box::new(CriterionBreach::FailsUnloaded {
                index,
                reserve_factor,
            }))
        }
    }

    fn not_finite(&self) -> Checked {
        for component in 0..3 {
            for value in [f64::NAN, f64::INFINITY] {
                let mut stress = [0.0; 3];
                stress[component] = value;
                let held = PlyLoading {
                    held: stress,
                    applied: [0.0; 3],
                };
                for loading in [held, PlyLoading::mechanical(stress)] {
                    if let Ok(found) = self.criterion.assess(self.ply, &loading) {
                        return Err(Box::new(CriterionBreach::NotFiniteAccepted { found }));
                    }
                }
            }
        }
        Ok(())
    }

    fn shear_sign(&self, loading: PlyLoading, own: Assessment) -> Checked {
        let turned = |[along, across, shear]: [f64; 3]| [along, across, -shear];
        let mirrored = self.assess(PlyLoading {
            held: turned(loading.held),
            applied: turned(loading.applied),
        })?;
        if mirrored.mode == own.mode
            && close(mirrored.index, own.index)
            && close(mirrored.reserve_factor, own.reserve_factor)
        {
            Ok(())
        } else {
            Err(Box::new(CriterionBreach::ShearSign {
                own,
                mirrored,
                loading,
            }))
        }
    }

    /// No failure before the reserve factor, and failure beyond it.
    fn first_failure(&self, loading: PlyLoading, found: Assessment) -> Checked {
        let reserve_factor = found.reserve_factor;
        let never = reserve_factor == f64::INFINITY;
        let before = if never {
            NEVER.to_vec()
        } else {
            BEFORE.map(|part| part * reserve_factor).to_vec()
        };
        // Where the residual stress alone fails the ply there is nothing before.
        for factor in before.into_iter().filter(|_| reserve_factor > 0.0) {
            let index = self.index(&loading, factor)?;
            if index >= 1.0 {
                return Err(Box::new(CriterionBreach::FailsBefore {
                    index,
                    factor,
                    reserve_factor,
                    loading,
                }));
            }
        }
        if never {
            return Ok(());
        }
        let index = self.index(&loading, reserve_factor * (1.0 + NEAR))?;
        if index < 1.0 - NEAR_INDEX {
            return Err(Box::new(CriterionBreach::HoldsBeyond {
                index,
                reserve_factor,
                loading,
            }));
        }
        Ok(())
    }

    fn homogeneous(&self, stress: [f64; 3], factors: &[f64]) -> Checked {
        let single = self.assess(PlyLoading::mechanical(stress))?.reserve_factor;
        for &factor in factors {
            let scaled = stress.map(|component| factor * component);
            let found = self.assess(PlyLoading::mechanical(scaled))?.reserve_factor;
            if !close(factor * found, single) {
                return Err(Box::new(CriterionBreach::NotHomogeneous {
                    factor,
                    stress,
                    found,
                    single,
                }));
            }
        }
        Ok(())
    }

    /// Each required strength is needed, and no other.
    fn strengths(&self) -> Checked {
        let given = self.ply.strengths();
        let required = self.criterion.required();
        for &strength in required {
            let found = self.of_strengths(given.without(strength));
            let missing = matches!(
                found,
                Err(FailureError::MissingStrength { strength: missing, .. }) if missing == strength
            );
            if !missing {
                return Err(Box::new(CriterionBreach::NotRequired { strength, found }));
            }
        }
        self.of_strengths(given.only(required))
            .map(|_| ())
            .map_err(|cause| Box::new(CriterionBreach::RequiresMore { cause }))
    }

    /// The ply without load, had it these strengths.
    fn of_strengths(&self, strengths: Strengths) -> Result<Assessment, FailureError> {
        let ply = self.ply.with_strengths(strengths);
        self.criterion.assess(&ply, &PlyLoading::default())
    }
}

/// Equal to rounding, or both infinite.
fn close(a: f64, b: f64) -> bool {
    a == b || (a - b).abs() <= ROUNDING * a.abs().max(b.abs())
}
