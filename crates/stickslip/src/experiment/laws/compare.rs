//! Several laws fitted to the same data, and what the data say of them.

use std::sync::Arc;

use stickslip_hybrid::calibrate::{Block, Calibration, Data, Settings, calibrate, least};
use stickslip_hybrid::identify::Bounds;

use super::mesh_error::{MeshError, shapes};
use super::{Candidate, ContactModel, LawsError, Observation, View};
use crate::run::Progress;

/// Criteria that differ by less do not decide (Burnham & Anderson 2002).
const DECIDES: f64 = 2.0;
/// A law whose criterion is worse by as much has next to no support.
const RULED_OUT: f64 = 10.0;
/// χ² this many standard deviations above what it should be is unexplained.
const UNEXPLAINED: f64 = 3.0;

/// Measured and predicted displacements of a state.
#[derive(Clone, Debug, PartialEq)]
pub struct StateFit {
    /// Name of the state.
    pub state: String,
    /// Index of the place among those of the observation, and axis, of each datum.
    pub components: Vec<(usize, usize)>,
    /// Predicted, with the fitted rigid motion, `[mm]`.
    pub predicted: Vec<f64>,
    /// Measured less predicted `[mm]`.
    pub residual: Vec<f64>,
}

/// A law fitted to the data.
#[derive(Clone, Debug)]
pub struct Fit {
    /// The law and its free parameters.
    pub law: Candidate,
    /// Parameters, intervals, χ², criteria.
    pub calibration: Calibration,
    /// One per observation.
    pub states: Vec<StateFit>,
    /// AICc above that of the best law; infinite where there are too few data for it.
    pub distance: f64,
    /// BIC above that of the law with the least.
    pub bic_distance: f64,
    /// What that says.
    pub verdict: Verdict,
    /// Wall time `[s]`.
    pub seconds: f64,
}

/// What the data say of a law beside the others.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// There is no other law to compare it with.
    Only,
    /// The least AICc, and the next law is clearly worse.
    Preferred,
    /// Not clearly worse than the best.
    AsGood,
    /// Worse, yet not ruled out.
    Weaker,
    /// Next to no support.
    RuledOut,
    /// Too few data for the criterion, which is not finite.
    Undecided,
}

impl Verdict {
    /// In words.
    pub const fn words(self) -> &'static str {
        match self {
            Self::Only => "the only law",
            Self::Preferred => "preferred",
            Self::AsGood => "as good as the best",
            Self::Weaker => "weaker",
            Self::RuledOut => "ruled out",
            Self::Undecided => "too few data to compare it",
        }
    }
}

impl Fit {
    /// Whether χ² is as large as the deviations of the data make it.
    pub fn explains(&self) -> bool {
        self.calibration.excess() <= UNEXPLAINED
    }

    /// What the data say of each parameter and of the law, in a sentence or two.
    pub fn words(&self) -> String {
        let mut words = vec![self.verdict.words().to_owned()];
        if !self.explains() {
            words.push("does not explain the data".to_owned());
        }
        for own in &self.calibration.estimates {
            let name = &own.name;
            match own.bounds {
                Bounds::Nothing => words.push(format!("{name} is not identifiable")),
                Bounds::AtMost(_) | Bounds::AtLeast(_) => {
                    words.push(format!("{name} is bounded on one side"));
                }
                Bounds::Between(..) if own.deviation.is_none() => words.push(format!(
                    "{name} shows by single contact points alone, so that its interval depends on the mesh"
                )),
                Bounds::Between(..) => {}
            }
        }
        words.join("; ")
    }
}

/// Laws fitted to the same data.
#[derive(Clone, Debug)]
pub struct Comparison {
    /// In the order of the file.
    pub fits: Vec<Fit>,
    /// Index of the one with the least AICc.
    pub best: usize,
    /// Number of data.
    pub data: usize,
    /// Wall time of one evaluation at the best law, a history of contact solves with what is seen of it, nothing else being done `[s]`.
    pub evaluation_seconds: f64,
    /// The error of the model's mesh that intervals hold; `None` where they hold the errors of the data alone.
    pub mesh_error: Option<MeshError>,
}

impl Comparison {
    /// The law with the least AICc.
    pub fn best(&self) -> &Fit {
        // `fit` sets an index of a list that is not empty.
        &self.fits[self.best]
    }
}

/// Fits each of `laws` to all of `observations`. Intervals hold the errors of the data alone.
///
/// # Errors
/// [`LawsError::NoLaw`], [`LawsError::Step`], [`LawsError::Outside`], and [`LawsError::Calibrate`] for data that cannot be fitted.
pub fn fit(
    model: &ContactModel,
    laws: &[Candidate],
    observations: &[Observation],
    settings: &Settings,
) -> Result<Comparison, LawsError> {
    let (views, count, data) = prepared(model, laws, observations)?;
    let seen = Seen {
        model,
        views: &views,
        count,
    };
    compared(&seen, laws, (observations, &data), settings, &mut |_| ())
}

/// The same with intervals that hold the error of the model's mesh as well, so far as it has the shape of the difference to `coarser`, a
/// model of the same scene.
///
/// The laws are fitted twice. The best law of the first time gives the shapes, one for each state, which are then errors of the data for
/// all laws: their criteria compare the same data with the same covariance. That of a law which does not hold would be the error of
/// displacements that are not there.
///
/// # Errors
/// Those of [`fit`], and of the history on the coarser mesh.
pub fn fit_on_two_meshes(
    model: &ContactModel,
    coarser: &ContactModel,
    laws: &[Candidate],
    observations: &[Observation],
    settings: &Settings,
) -> Result<Comparison, LawsError> {
    let models = [model, coarser];
    told_on_two_meshes(models, laws, observations, settings, &mut |_| ())
}

/// As [`fit_on_two_meshes`] on `[model, coarser]`; `progress` hears of every fit.
pub(super) fn told_on_two_meshes(
    [model, coarser]: [&ContactModel; 2],
    laws: &[Candidate],
    observations: &[Observation],
    settings: &Settings,
    progress: &mut dyn FnMut(Progress),
) -> Result<Comparison, LawsError> {
    let (views, count, data) = prepared(model, laws, observations)?;
    let seen = Seen {
        model,
        views: &views,
        count,
    };
    let total = 2 * laws.len();
    let mut firsts = Vec::new();
    for law in laws {
        let start = std::time::Instant::now();
        let predict = |values: &[f64]| seen.predicted(law, values);
        let found = least(&predict, &law.parameters, &data, settings).map_err(failed(law))?;
        firsts.push((found, start.elapsed().as_secs_f64()));
        progress(Progress::Step {
            done: firsts.len(),
            total,
        });
    }
    let order = |&a: &usize, &b: &usize| {
        let [a, b] = [a, b].map(|k| &firsts[k].0);
        (a.aicc.total_cmp(&b.aicc)).then(a.chi_squared.total_cmp(&b.chi_squared))
    };
    // `prepared` refuses an empty list of laws.
    let first = (0..laws.len()).min_by(order).unwrap_or(0);
    let (law, values) = (&laws[first], &firsts[first].0.values);
    let own = seen.predicted(law, values)?;
    let shapes = shapes(coarser, law.law(values)?, observations, &own)?;
    let data = data.with_shapes(&shapes).map_err(LawsError::Data)?;
    let mut second = |done: usize| {
        let done = laws.len() + done;
        progress(Progress::Step { done, total });
    };
    let mut found = compared(&seen, laws, (observations, &data), settings, &mut second)?;
    for (fit, (first, seconds)) in found.fits.iter_mut().zip(&firsts) {
        fit.calibration.evaluations += first.evaluations;
        fit.seconds += seconds;
    }
    let best = found.best();
    let predicted = seen.predicted(&best.law, &best.calibration.values())?;
    found.mesh_error = Some(MeshError::of(
        law.name.clone(),
        observations,
        &shapes,
        &data.amounts(&predicted),
    )?);
    Ok(found)
}

fn failed(
    law: &Candidate,
) -> impl FnOnce(stickslip_hybrid::calibrate::CalibrateError) -> LawsError {
    let law = law.name.clone();
    |cause| LawsError::Calibrate { law, cause }
}

/// What can be seen of the model at each observation, up to which load step, and the data.
type Prepared<'a> = (Vec<(&'a Observation, View<'a>)>, usize, Data);

fn prepared<'a>(
    model: &'a ContactModel,
    laws: &[Candidate],
    observations: &'a [Observation],
) -> Result<Prepared<'a>, LawsError> {
    if laws.is_empty() {
        return Err(LawsError::NoLaw);
    }
    let mut views: Vec<(&Observation, View<'_>)> = Vec::new();
    let mut count = 0;
    for own in observations {
        let last = own.step.max(own.null.unwrap_or(0));
        if last >= model.steps() {
            return Err(LawsError::Step {
                step: last + 1,
                steps: model.steps(),
            });
        }
        count = count.max(last + 1);
        views.push((own, model.view(&own.places)?));
    }
    let blocks: Vec<Block> = observations.iter().map(Observation::block).collect();
    Ok((views, count, Data::new(blocks).map_err(LawsError::Data)?))
}

fn compared(
    seen: &Seen<'_>,
    laws: &[Candidate],
    (observations, data): (&[Observation], &Data),
    settings: &Settings,
    fitted: &mut dyn FnMut(usize),
) -> Result<Comparison, LawsError> {
    let mut fits = Vec::new();
    for law in laws {
        let predict = |values: &[f64]| seen.predicted(law, values);
        let start = std::time::Instant::now();
        let calibration =
            calibrate(&predict, &law.parameters, data, settings).map_err(failed(law))?;
        fits.push(Fit {
            law: law.clone(),
            states: state_fits(observations, &calibration),
            calibration,
            distance: 0.0,
            bic_distance: 0.0,
            verdict: Verdict::AsGood,
            seconds: start.elapsed().as_secs_f64(),
        });
        fitted(fits.len());
    }
    let best = judge(&mut fits);
    let (law, values) = (&laws[best], fits[best].calibration.values());
    let start = std::time::Instant::now();
    seen.predicted(law, &values)?;
    let evaluation_seconds = start.elapsed().as_secs_f64();
    Ok(Comparison {
        data: fits[best].calibration.data,
        fits,
        best,
        evaluation_seconds,
        mesh_error: None,
    })
}

/// A model as it is seen at the data.
struct Seen<'a> {
    model: &'a ContactModel,
    views: &'a [(&'a Observation, View<'a>)],
    count: usize,
}

impl Seen<'_> {
    /// Displacements at the data of all observations.
    fn predicted(&self, law: &Candidate, values: &[f64]) -> Result<Vec<f64>, LawsError> {
        let states = (self.model).states(Arc::from(law.law(values)?), self.count)?;
        let mut all = Vec::new();
        for (own, view) in self.views {
            let mut seen = view.displacements(&states[own.step]);
            if let Some(null) = own.null {
                seen -= view.displacements(&states[null]);
            }
            let components = own.components.iter();
            all.extend(components.map(|&(place, axis)| seen[2 * place + axis]));
        }
        Ok(all)
    }
}

fn state_fits(observations: &[Observation], calibration: &Calibration) -> Vec<StateFit> {
    let mut rest = calibration.fitted.as_slice();
    let mut fits = Vec::new();
    for own in observations {
        let (predicted, next) = rest.split_at(own.values.len().min(rest.len()));
        rest = next;
        fits.push(StateFit {
            state: own.state.clone(),
            components: own.components.clone(),
            predicted: predicted.to_vec(),
            residual: own
                .values
                .iter()
                .zip(predicted)
                .map(|(m, h)| m - h)
                .collect(),
        });
    }
    fits
}

/// Distances and verdicts; the index of the law with the least AICc, or the least χ² where no law has a finite one.
fn judge(fits: &mut [Fit]) -> usize {
    let aicc: Vec<f64> = fits.iter().map(|fit| fit.calibration.aicc()).collect();
    let bic = fits.iter().map(|fit| fit.calibration.bic());
    let least_bic = bic.fold(f64::INFINITY, f64::min);
    let order = |&a: &usize, &b: &usize| {
        let chi_squared = |k: usize| fits[k].calibration.chi_squared;
        (aicc[a].total_cmp(&aicc[b])).then(chi_squared(a).total_cmp(&chi_squared(b)))
    };
    let best = (0..fits.len()).min_by(order).unwrap_or(0);
    let verdicts = verdicts(&aicc, best);
    for ((fit, aicc_of), verdict) in fits.iter_mut().zip(&aicc).zip(verdicts) {
        fit.distance = distance(*aicc_of, aicc[best]);
        fit.bic_distance = fit.calibration.bic() - least_bic;
        fit.verdict = verdict;
    }
    best
}

/// How far a criterion lies above the least; infinite where it is not finite itself.
fn distance(own: f64, least: f64) -> f64 {
    if own.is_finite() {
        own - least
    } else {
        f64::INFINITY
    }
}

/// What the criteria say, that of `best` being the least.
fn verdicts(aicc: &[f64], best: usize) -> Vec<Verdict> {
    let near = |k: usize| distance(aicc[k], aicc[best]) < DECIDES;
    let alone = (0..aicc.len()).all(|k| k == best || !near(k));
    let verdict = |k: usize| match distance(aicc[k], aicc[best]) {
        _ if aicc.len() == 1 => Verdict::Only,
        _ if !aicc[k].is_finite() => Verdict::Undecided,
        _ if k == best && alone => Verdict::Preferred,
        far if far < DECIDES => Verdict::AsGood,
        far if far < RULED_OUT => Verdict::Weaker,
        _ => Verdict::RuledOut,
    };
    (0..aicc.len()).map(verdict).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_lone_law_is_compared_with_nothing() {
        assert_eq!(verdicts(&[12.0], 0), [Verdict::Only]);
        assert_eq!(verdicts(&[f64::INFINITY], 0), [Verdict::Only]);
    }

    #[test]
    fn criteria_decide_by_their_distance_from_the_least() {
        let found = verdicts(&[15.0, 10.0, 30.0, f64::INFINITY], 1);
        let expected = [
            Verdict::Weaker,
            Verdict::Preferred,
            Verdict::RuledOut,
            Verdict::Undecided,
        ];
        assert_eq!(found, expected);
        assert_eq!(verdicts(&[1.0, 2.5], 0), [Verdict::AsGood; 2]);
    }

    #[test]
    fn criteria_that_are_not_finite_decide_nothing() {
        let none = [f64::INFINITY; 2];
        assert_eq!(verdicts(&none, 0), [Verdict::Undecided; 2]);
        assert!(distance(none[1], none[0]).is_infinite());
    }
}
