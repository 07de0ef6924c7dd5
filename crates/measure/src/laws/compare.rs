//! Several laws fitted to the same data, and what the data say of them.

use std::sync::Arc;

use stickslip_hybrid::calibrate::{
    Block, CalibrateError, Calibration, Correlation, Data, Least, Residual, Settings, calibrate,
    least,
};

use super::comparison::{Comparison, Fit, StateFit};
use super::mesh_error::{Coarser, MeshError};
use super::resolved::Resolved;
use super::verdict::{Verdict, judge};
use super::{Candidate, ContactModel, LawsError, Observation, View};
use stickslip_engine::run::Progress;

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
    let (seen, data) = Seen::new(model, laws, observations)?;
    let firsts = first_fits(&seen, laws, &data, settings, &mut |_| ())?;
    let settings = correlated(&seen, laws, &firsts, &data, settings)?;
    compared(&seen, laws, &data, &settings, &mut |_| ())
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
    let (seen, data) = Seen::new(model, laws, observations)?;
    let total = 2 * laws.len();
    let mut first = |done: usize| progress(Progress::Step { done, total });
    let firsts = first_fits(&seen, laws, &data, settings, &mut first)?;
    let order = |&a: &usize, &b: &usize| {
        let [a, b] = [a, b].map(|k| &firsts[k].0);
        (a.aicc.total_cmp(&b.aicc)).then(a.chi_squared.total_cmp(&b.chi_squared))
    };
    // `Seen::new` refuses an empty list of laws.
    let first = (0..laws.len()).min_by(order).unwrap_or(0);
    let (law, values) = (&laws[first], &firsts[first].0.values);
    let own = seen.predicted(law, values)?;
    let coarser = Coarser::new(coarser, observations)?;
    let by_mesh = by_mesh(&seen, &coarser, laws, &firsts, &data, settings)?;
    let shapes = coarser.shapes(law.law(values)?, &own)?;
    let data = data.with_shapes(&shapes).map_err(LawsError::Data)?;
    let settings = correlated(&seen, laws, &firsts, &data, settings)?;
    let mut second = |done: usize| {
        let done = laws.len() + done;
        progress(Progress::Step { done, total });
    };
    let mut found = compared(&seen, laws, &data, &settings, &mut second)?;
    for ((fit, (first, seconds)), by_mesh) in found.fits.iter_mut().zip(&firsts).zip(by_mesh) {
        fit.by_mesh = by_mesh;
        fit.calibration.evaluations += first.evaluations;
        fit.seconds += seconds;
    }
    let resolved = resolved(&seen, &coarser, &found.fits, &data)?;
    found.best = judged(&mut found.fits, |complex, simple| {
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
    data: &Data,
    settings: &Settings,
) -> Result<Settings, LawsError> {
    let fits = laws.iter().zip(firsts);
    let Some((law, (first, _))) =
        fits.min_by(|(_, (a, _)), (_, (b, _))| a.chi_squared.total_cmp(&b.chi_squared))
    else {
        return Ok(*settings);
    };
    let left = data.residual(&seen.predicted(law, &first.values)?);
    let places = seen.views.iter().enumerate().flat_map(|(index, (own, _))| {
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

fn failed(law: &Candidate) -> impl FnOnce(CalibrateError) -> LawsError {
    let law = law.name.clone();
    |cause| LawsError::Calibrate { law, cause }
}

fn compared(
    seen: &Seen<'_>,
    laws: &[Candidate],
    data: &Data,
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
            states: state_fits(seen, &calibration),
            calibration,
            distance: 0.0,
            bic_distance: 0.0,
            verdict: Verdict::AsGood,
            by_mesh: Vec::new(),
            seconds: seen.model.seconds() - start,
        });
        fitted(fits.len());
    }
    let best = judged(&mut fits, |_, _| true);
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

/// Distances and verdicts of `fits`; the index of the best, see [`judge`].
fn judged(fits: &mut [Fit], prefers: impl Fn(usize, usize) -> bool) -> usize {
    let calibrations: Vec<&Calibration> = fits.iter().map(|fit| &fit.calibration).collect();
    let (best, judgements) = judge(&calibrations, prefers);
    for (fit, own) in fits.iter_mut().zip(judgements) {
        fit.distance = own.distance;
        fit.bic_distance = own.bic_distance;
        fit.verdict = own.verdict;
    }
    best
}

/// A model as it is seen at the data.
struct Seen<'a> {
    model: &'a ContactModel,
    views: Vec<(&'a Observation, View<'a>)>,
    /// Load steps up to the last one that is observed.
    count: usize,
}

impl<'a> Seen<'a> {
    /// What can be seen of `model` at `observations`, and these as data.
    fn new(
        model: &'a ContactModel,
        laws: &[Candidate],
        observations: &'a [Observation],
    ) -> Result<(Self, Data), LawsError> {
        if laws.is_empty() {
            return Err(LawsError::NoLaw);
        }
        let mut views = Vec::new();
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
        let data = Data::new(blocks).map_err(LawsError::Data)?;
        let seen = Self {
            model,
            views,
            count,
        };
        Ok((seen, data))
    }

    /// Displacements at the data of all observations.
    fn predicted(&self, law: &Candidate, values: &[f64]) -> Result<Vec<f64>, LawsError> {
        let states = (self.model).states(Arc::from(law.law(values)?), self.count)?;
        let mut all = Vec::new();
        for (own, view) in &self.views {
            let seen = view.observed(own, &states)?;
            let components = own.components.iter();
            all.extend(components.map(|&(place, axis)| seen[2 * place + axis]));
        }
        Ok(all)
    }
}

fn state_fits(seen: &Seen<'_>, calibration: &Calibration) -> Vec<StateFit> {
    let mut rest = calibration.fitted.as_slice();
    let mut fits = Vec::new();
    for (own, _) in &seen.views {
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
