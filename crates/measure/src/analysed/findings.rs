//! What makes the stresses of a state, their bands and their forces doubtful.

use stickslip_hybrid::region::fit::Amount;

use super::load::LoadCheck;
use super::{Analysed, BearingCheck, FitFacts};
use crate::finding::{
    BearingFails, Check, Finding, FitFinding, ForceFinding, LoadFails, Located, Part,
};
use stickslip_experiment::{Experiment, FreeMotion, Source};

/// Standard deviations above its mean at which a χ² is reported as too large.
const LARGE: f64 = 4.0;
/// Part of the data that the parameters of a fit may be before it is reported.
const MANY: f64 = 0.5;
/// Noise factors beyond which the stated standard deviation is reported as wrong.
const FACTORS: [f64; 2] = [0.1, 10.0];
/// Part of the noise factor that single residuals show of errors which are not correlated.
const CORRELATED: f64 = 0.5;
/// The axes of forces.
const AXES: [&str; 2] = ["x", "y"];

/// Reports that `reduce.free` holds in the region alone, although the whole plate or fitted laws take displacements of the pictures too; `None`
/// where nothing is declared free, or the region alone takes displacements.
pub fn free_in_region_only(experiment: &Experiment) -> Option<Located> {
    let whole = experiment
        .region
        .as_ref()
        .is_some_and(|plan| plan.whole_plate);
    let is_used = whole || !experiment.laws.is_empty();
    (!experiment.reduce.free.is_empty() && is_used)
        .then(|| Located::of_all(Finding::Fit(FitFinding::FreeInRegionOnly)))
}

impl Analysed {
    /// What a reader must know of the stresses and forces, each with the name of the state in `experiment`.
    pub fn findings(&self, experiment: &Experiment) -> Vec<Located> {
        let direct = self.without_direct.iter();
        let direct = direct.map(|cause| FitFinding::NoDirectStresses {
            cause: cause.clone(),
        });
        let fit = (self.failed_checks().into_iter())
            .chain(direct)
            .chain(self.scale_finding())
            .chain(self.fit_findings(experiment));
        let forces = (0..2)
            .filter_map(|axis| self.force_finding(axis))
            .chain(self.load_finding(experiment))
            .chain(self.pull_finding(experiment));
        let all = (fit.map(Finding::Fit))
            .chain(forces.map(Finding::Force))
            .chain(self.open_motions(experiment).map(Finding::Fit));
        let name = &experiment.states[self.state].name;
        all.map(|finding| Located::of_state(name, Part::State, finding))
            .collect()
    }

    /// The bearing point, where the force on the edge contradicts it: slip zones are counted from there.
    pub fn bearing_finding(&self, experiment: &Experiment) -> Option<Located> {
        let stated = experiment.identify.bearing;
        let check = (self.bearing_check(stated)).filter(BearingCheck::fails)?;
        let fails = BearingFails {
            direction_degrees: check.direction.to_degrees(),
            deviation_degrees: check.deviation.to_degrees(),
            beyond_degrees: check.beyond.to_degrees(),
            bearing_degrees: check.bearing.to_degrees(),
            stated: stated.is_some(),
            is_whole: check.is_whole,
        };
        let name = &experiment.states[self.state].name;
        let finding = Finding::Force(ForceFinding::BearingFails(fails));
        Some(Located::of_state(name, Part::State, finding))
    }

    fn failed_checks(&self) -> Vec<FitFinding> {
        let checks = [
            (Check::UnusedPlaces, &self.checks.unused),
            (Check::FreeEdge, &self.checks.free_edge),
            (Check::NodesInside, &self.checks.interior),
        ];
        let failed = checks.into_iter().filter_map(|(check, found)| {
            let found = found.as_ref().filter(|own| own.excess() > LARGE)?;
            Some(FitFinding::CheckFails {
                check,
                chi_squared: found.value,
                count: found.count,
                deviation: found.deviation,
                dilation: self.dilation_left(),
            })
        });
        failed.collect()
    }

    /// A dilation of the picture that would explain tractions on the free edge, and its standard deviation.
    fn dilation_left(&self) -> Option<[f64; 2]> {
        let own = (self.picture.iter())
            .find(|own| own.motion == FreeMotion::Dilation && !own.taken_off)?;
        own.amount
    }

    fn scale_finding(&self) -> Option<FitFinding> {
        let cause = self.scale_assumed.clone()?;
        Some(FitFinding::NoiseFactorAssumed {
            factor: self.scale,
            cause,
        })
    }

    fn fit_findings(&self, experiment: &Experiment) -> impl Iterator<Item = FitFinding> {
        let many = |fit: FitFacts| {
            let is_many = fit.parameters > MANY * fit.data as f64;
            is_many.then_some(FitFinding::ManyParameters {
                data: fit.data,
                parameters: fit.parameters,
            })
        };
        let residuals = |fit: FitFacts| self.residual_finding(experiment, &fit);
        let many = self.fit.and_then(many);
        many.into_iter().chain(self.fit.and_then(residuals))
    }

    /// What the residuals say of the standard deviation of the data.
    fn residual_finding(&self, experiment: &Experiment, fit: &FitFacts) -> Option<FitFinding> {
        let single = fit.residual / (fit.data as f64 - fit.parameters).max(1.0);
        let least = fit.of_residuals.min(single);
        let source = &experiment.states[self.state].source;
        let pictured = matches!(source, Source::Step(_) | Source::Pictures(_));
        if !pictured && least < FACTORS[0] {
            Some(FitFinding::SmallResiduals {
                variance_ratio: least,
                stated: states_deviation(experiment, self.state),
            })
        } else if fit.of_residuals > FACTORS[1] && single < CORRELATED * fit.of_residuals {
            let amount = experiment.region.as_ref().map(|plan| plan.smoothing.amount);
            Some(FitFinding::CorrelatedResiduals {
                of_means: fit.of_residuals,
                of_singles: single,
                amount_stated: matches!(amount, Some(Amount::Given(_))),
            })
        } else if !(FACTORS[0]..=FACTORS[1]).contains(&fit.of_residuals) {
            Some(FitFinding::WrongDeviation {
                variance_ratio: fit.of_residuals,
            })
        } else {
            None
        }
    }

    /// A known force that the stresses on the edge are not in balance with, or that they cannot be compared with.
    fn force_finding(&self, axis: usize) -> Option<ForceFinding> {
        let own = self.checks.force[axis]?;
        let axis = AXES[axis];
        if own.fails() {
            return Some(ForceFinding::EdgeForceFails {
                axis,
                excess: own.excess,
                explained: own.explained,
            });
        }
        (!own.is_evidence()).then_some(ForceFinding::EdgeForceIsNoEvidence {
            axis,
            explained: own.explained,
            of_force: own.explained / own.size,
        })
    }

    /// A load that the force on the edge contradicts, or why neither it nor a known force checks the size of that force.
    fn load_finding(&self, experiment: &Experiment) -> Option<ForceFinding> {
        let check = match self.load_check(experiment) {
            Ok(check) => Some(check).filter(LoadCheck::fails)?,
            Err(_) if self.checks.force.iter().any(Option::is_some) => return None,
            Err(reason) => return Some(ForceFinding::LoadNotChecked { reason }),
        };
        Some(ForceFinding::LoadFails(LoadFails {
            force: check.force,
            deviation: check.deviation,
            load: check.load,
            above_null: check.above_null,
            bearing_degrees: (!check.is_whole).then(|| check.bearing.to_degrees()),
            thickness: experiment.specimen.thickness,
        }))
    }

    fn pull_finding(&self, experiment: &Experiment) -> Option<ForceFinding> {
        // Beside a field under more load contact is relieved.
        if experiment.states[self.state].null.is_some() {
            return None;
        }
        let place = self.pull()?;
        Some(ForceFinding::Pulled {
            tension: -self.tractions.pressure[place],
            theta_degrees: self.angle[place].to_degrees(),
        })
    }

    /// Motions of the picture that are declared free and cannot be separated from the load.
    fn open_motions(&self, experiment: &Experiment) -> impl Iterator<Item = FitFinding> {
        let asked = !experiment.reduce.free.is_empty();
        let open = self.picture.iter();
        let open = open.filter(move |own| asked && own.amount.is_none());
        open.map(|own| FitFinding::NotSeparable {
            motion: own.motion.name(),
            pressure_per_unit: own.pressure,
        })
    }
}

/// Whether the standard deviation of a state and of its null field was stated, and not estimated.
fn states_deviation(experiment: &Experiment, state: usize) -> bool {
    let is_stated = |source: &Source| match source {
        Source::Table(table) => table.deviation.is_some(),
        Source::Lines(_) => true,
        Source::Step(_) | Source::Pictures(_) => false,
    };
    let plan = &experiment.states[state];
    let mut sources = plan.null.iter().chain([&plan.source]);
    sources.all(is_stated)
}
