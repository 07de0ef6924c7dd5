//! What fits of several laws to the same data say.

use stickslip_hybrid::calibrate::Calibration;
use stickslip_hybrid::identify::Bounds;

use super::Candidate;
use super::mesh_error::MeshError;
use super::verdict::Verdict;

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
    /// AICc above that of the best law `[1]`; negative where the mesh does not resolve what makes it less, infinite where there are too few
    /// data for it.
    pub distance: f64,
    /// BIC above that of the law with the least `[1]`.
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
    pub fn describe(&self) -> String {
        let mut parts = vec![self.verdict.describe().to_owned()];
        if !self.explains() {
            parts.push("does not explain the data".to_owned());
        }
        for (index, own) in self.calibration.estimates.iter().enumerate() {
            let name = &own.name;
            match self.bounds(index).unwrap_or(own.bounds) {
                Bounds::Nothing => parts.push(format!("{name} is not identifiable")),
                Bounds::AtMost(_) | Bounds::AtLeast(_) => {
                    parts.push(format!("{name} is bounded on one side"));
                }
                Bounds::Between(..) if own.deviation.is_none() => parts.push(format!(
                    "{name} shows by single contact points alone, so that its interval depends on the mesh"
                )),
                Bounds::Between(..) => {}
            }
        }
        parts.join("; ")
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
