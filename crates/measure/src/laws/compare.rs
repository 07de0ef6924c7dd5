//! Several laws fitted to the same data, and what the data say of them.

use std::sync::Arc;

use stickslip_hybrid::calibrate::{
    Block, Calibration, Correlation, Data, Least, Residual, Settings, calibrate, least,
};
use stickslip_hybrid::identify::Bounds;

use super::mesh_error::{Coarser, MeshError};
use super::resolved::Resolved;
use super::verdict::{Verdict, judge};
use super::{Candidate, ContactModel, LawsError, Observation, View};
use stickslip_engine::run::Progress;

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
    /// AICc above that of the best law; negative where the mesh does not resolve what makes it less, infinite where there are too few
    /// data for it.
    pub distance: f64,
    /// BIC above that of the law with the least.
    pub bic_distance: f64,
    /// What that says.
    pub verdict: Verdict,
    /// What the model's mesh may move each parameter by: a third of what a mesh twice as coarse does, in the units of the parameter; empty
    /// where that is not known.
    pub by_mesh: Vec<f64>,
    /// Wall time `[s]`.
    pub seconds: f64,
}

impl Fit {
    /// Whether χ² is as large as the standard deviations of the data make it.
    pub fn explains(&self) -> bool {
        self.calibration.excess() <= UNEXPLAINED
    }

    /// The interval of parameter `index`; `None` where χ² rejects the model, whose errors no interval of the data's noise holds.
    pub fn bounds(&self, index: usize) -> Option<Bounds> {
        let own = self.calibration.estimates.get(index)?;
        let by = self.by_mesh.get(index).copied().unwrap_or(0.0);
        let [least, _] = self.law.parameters[index].range;
        self.explains()
            .then(|| own.bounds.widened(own.value, by, least))
    }

    /// What the data say of each parameter and of the law, in a sentence or two.
    pub fn words(&self) -> String {
        let mut words = vec![self.verdict.words().to_owned()];
        if !self.explains() {
            words.push("does not explain the data".to_owned());
        }
        for (index, own) in self.calibration.estimates.iter().enumerate() {
            let name = &own.name;
            match self.bounds(index).unwrap_or(own.bounds) {
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
    /// Index of the one with the least AICc, of those whose advantage the mesh resolves.
    pub best: usize,
    /// Number of data.
    pub data: usize,
    /// Wall time of one evaluation at the best law, a history of contact solves with what is seen of it, nothing else being done `[s]`.
    pub evaluation_seconds: f64,
    /// The error of the model's mesh that intervals hold; `None` where they hold the errors of the data alone.
    pub mesh_error: Option<MeshError>,
}

impl Comparison {
    /// The law with the least AICc, of those whose advantage the mesh resolves.
    pub fn best(&self) -> &Fit {
        // `fit` sets an index of a list that is not empty.
        &self.fits[self.best]
    }
}

/// Fits each of `laws` to all of `observations`. Intervals hold the errors of the data alone, and the correlation of what the law with the
/// least χ² leaves of them; no coarser mesh says which differences of laws the mesh resolves.
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
    let firsts = first_fits(&seen, laws, &data, settings, &mut |_| ())?;
    let settings = correlated(&seen, laws, &firsts, (observations, &data), settings)?;
    compared(&seen, laws, (observations, &data), &settings, &mut |_| ())
}

/// The same with intervals that hold the error of the model's mesh as well, so far as it has the shape of the difference to `coarser`, a
/// model of the same scene.
///
/// The laws are fitted twice. The best law of the first time gives the shapes, one for each state, which are then errors of the data for
/// all laws: their criteria compare the same data with the same covariance. That of a law which does not hold would be the error of
/// displacements that are not there. A law with more parameters than another is not preferred to it for what the coarser mesh does not
/// show as well.
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
    fit_with_progress(models, laws, observations, settings, &mut |_| ())
}

/// As [`fit_on_two_meshes`] on `[model, coarser]`; `progress` hears of every fit.
pub(super) fn fit_with_progress(
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
    let mut first = |done: usize| progress(Progress::Step { done, total });
    let firsts = first_fits(&seen, laws, &data, settings, &mut first)?;
    let order = |&a: &usize, &b: &usize| {
        let [a, b] = [a, b].map(|k| &firsts[k].0);
        (a.aicc.total_cmp(&b.aicc)).then(a.chi_squared.total_cmp(&b.chi_squared))
    };
    // `prepared` refuses an empty list of laws.
    let first = (0..laws.len()).min_by(order).unwrap_or(0);
    let (law, values) = (&laws[first], &firsts[first].0.values);
    let own = seen.predicted(law, values)?;
    let coarser = Coarser::new(coarser, observations)?;
    let by_mesh = by_mesh(&seen, &coarser, laws, &firsts, &data, settings)?;
    let shapes = coarser.shapes(law.law(values)?, &own)?;
    let data = data.with_shapes(&shapes).map_err(LawsError::Data)?;
    let settings = correlated(&seen, laws, &firsts, (observations, &data), settings)?;
    let mut second = |done: usize| {
        let done = laws.len() + done;
        progress(Progress::Step { done, total });
    };
    let mut found = compared(&seen, laws, (observations, &data), &settings, &mut second)?;
    for ((fit, (first, seconds)), by_mesh) in found.fits.iter_mut().zip(&firsts).zip(by_mesh) {
        fit.by_mesh = by_mesh;
        fit.calibration.evaluations += first.evaluations;
        fit.seconds += seconds;
    }
    let resolved = resolved(&seen, &coarser, &found.fits, &data)?;
    found.best = judge(&mut found.fits, |complex, simple| {
        resolved.prefers(complex, simple)
    });
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

/// The best fit of each law without intervals, and how long it took `[s]`.
fn first_fits(
    seen: &Seen<'_>,
    laws: &[Candidate],
    data: &Data,
    settings: &Settings,
    fitted: &mut dyn FnMut(usize),
) -> Result<Vec<(Least, f64)>, LawsError> {
    let mut firsts = Vec::new();
    for law in laws {
        let start = seen.model.seconds();
        let predict = |values: &[f64]| seen.predicted(law, values);
        let found = least(&predict, &law.parameters, data, settings).map_err(failed(law))?;
        firsts.push((found, seen.model.seconds() - start));
        fitted(firsts.len());
    }
    Ok(firsts)
}

/// What the mesh of the model may move the parameters of each law by: displacements that converge with the square of the spacing leave a third
/// of what a mesh twice as coarse moves them by (Richardson 1911), whatever the shape of their error.
fn by_mesh(
    seen: &Seen<'_>,
    coarser: &Coarser<'_>,
    laws: &[Candidate],
    firsts: &[(Least, f64)],
    data: &Data,
    settings: &Settings,
) -> Result<Vec<Vec<f64>>, LawsError> {
    const PART: f64 = 1.0 / 3.0;
    let mut all = Vec::new();
    for (law, (first, _)) in laws.iter().zip(firsts) {
        let fine = seen.predicted(law, &first.values)?;
        let predict = |values: &[f64]| -> Result<Vec<f64>, LawsError> {
            let coarse = coarser.seen(law.law(values)?)?;
            let both = coarse.into_iter().zip(&fine);
            Ok(both.map(|(own, fine)| own.unwrap_or(*fine)).collect())
        };
        // A law that the coarser mesh does not determine moves by nothing that is known.
        let found = least(&predict, &law.parameters, data, settings);
        let moved = found.map_or_else(
            |_| Vec::new(),
            |own| {
                let both = own.values.iter().zip(&first.values);
                both.map(|(a, b)| PART * (a - b).abs()).collect()
            },
        );
        all.push(moved);
    }
    Ok(all)
}

/// `settings` with the correlation of what the law with the least χ² leaves of the data: the least that any law calls an error.
fn correlated(
    seen: &Seen<'_>,
    laws: &[Candidate],
    firsts: &[(Least, f64)],
    (observations, data): (&[Observation], &Data),
    settings: &Settings,
) -> Result<Settings, LawsError> {
    let fits = laws.iter().zip(firsts);
    let Some((law, (first, _))) =
        fits.min_by(|(_, (a, _)), (_, (b, _))| a.chi_squared.total_cmp(&b.chi_squared))
    else {
        return Ok(*settings);
    };
    let left = data.residual(&seen.predicted(law, &first.values)?);
    let places = observations.iter().enumerate().flat_map(|(index, own)| {
        let datum = move |&(place, axis): &(usize, usize)| (own.places[place], 2 * index + axis);
        own.components.iter().map(datum)
    });
    let residuals: Vec<Residual> = (places.zip(left))
        .map(|((place, field), value)| Residual {
            place,
            field,
            value,
        })
        .collect();
    Ok(Settings {
        correlation: Correlation {
            inflation: Correlation::of(&residuals).inflation,
            ..settings.correlation
        },
        ..*settings
    })
}

/// What the fits predict on both meshes.
fn resolved<'a>(
    seen: &Seen<'_>,
    coarser: &Coarser<'_>,
    fits: &[Fit],
    data: &'a Data,
) -> Result<Resolved<'a>, LawsError> {
    let mut meshes = Vec::new();
    for fit in fits {
        let values = fit.calibration.values();
        let fine = seen.predicted(&fit.law, &values)?;
        meshes.push((fine, coarser.seen(fit.law.law(&values)?).ok()));
    }
    Ok(Resolved::new(data, fits, meshes))
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
        let start = seen.model.seconds();
        let calibration =
            calibrate(&predict, &law.parameters, data, settings).map_err(failed(law))?;
        fits.push(Fit {
            law: law.clone(),
            states: state_fits(observations, &calibration),
            calibration,
            distance: 0.0,
            bic_distance: 0.0,
            verdict: Verdict::AsGood,
            by_mesh: Vec::new(),
            seconds: seen.model.seconds() - start,
        });
        fitted(fits.len());
    }
    let best = judge(&mut fits, |_, _| true);
    let (law, values) = (&laws[best], fits[best].calibration.values());
    let start = seen.model.seconds();
    seen.predicted(law, &values)?;
    let evaluation_seconds = seen.model.seconds() - start;
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
