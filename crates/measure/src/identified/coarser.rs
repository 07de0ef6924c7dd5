//! How much of the coefficient is an error of the mesh.
//!
//! Bands hold noise and the bias of smoothing, but not the error of the region's cells. The same data on half of the cells show its size:
//! the error of the finer mesh is smaller still.

use stickslip_hybrid::identify::{Bounds, SlipFit};

use super::identify;
use crate::analysed::Workbench;
use crate::error::ExperimentError;
use crate::finding::FrictionFinding;
use crate::measured::Measured;
use stickslip_experiment::{Experiment, RegionShape};

/// Fewest cells along and across a region.
const FEWEST: usize = 2;

/// The coefficient on half of the region's cells.
#[derive(Clone, Debug)]
pub struct Coarser {
    /// Cells along and across.
    pub cells: [usize; 2],
    /// What they give; `None` where no zone is recognised on them.
    pub dynamic: Option<SlipFit>,
}

/// Identifies the coefficient once more on half of the cells; `None` for a region without cells of its own, or with too few.
///
/// # Errors
/// [`ExperimentError`] for data that do not determine the coarser region.
pub fn on_half_the_cells(
    experiment: &Experiment,
    fields: &[Measured],
) -> Result<Option<Coarser>, ExperimentError> {
    let mut experiment = experiment.clone();
    let Some(RegionShape::Sector(sector)) = experiment.region.as_mut().map(|plan| &mut plan.shape)
    else {
        return Ok(None);
    };
    let cells = sector.cells.map(|cells| cells / 2);
    if cells.iter().any(|&cells| cells < FEWEST) {
        return Ok(None);
    }
    sector.cells = cells;
    // Areas that held nodes of the finer cells may hold none of these.
    experiment
        .region
        .iter_mut()
        .for_each(|plan| plan.interior.clear());
    experiment.identify.samples = 0;
    let bench = Workbench::new(&experiment)?;
    let analysed = fields.iter().map(|field| bench.stresses(field));
    let identified = identify(&experiment, &analysed.collect::<Result<Vec<_>, _>>()?)?;
    Ok(Some(Coarser {
        cells,
        dynamic: identified.dynamic,
    }))
}

impl Coarser {
    /// The coefficient of these cells, if they move it by more than `fit` and this leave to the noise.
    pub(super) fn doubt(&self, fit: &SlipFit) -> Option<FrictionFinding> {
        let half_width = |bounds| match bounds {
            Bounds::Between(low, high) => 0.5 * (high - low),
            _ => f64::INFINITY,
        };
        let coarse = self.dynamic.as_ref()?;
        let noise = half_width(fit.bounds).max(half_width(coarse.bounds));
        ((fit.mu - coarse.mu).abs() > noise).then_some(FrictionFinding::MeshMoves {
            mu: fit.mu,
            half_the_cells: self.cells,
            mu_on_half: coarse.mu,
            bounds_on_half: coarse.bounds,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn fit(mu: f64, bounds: Bounds) -> SlipFit {
        SlipFit {
            mu,
            bounds,
            chi_squared: 10.0,
            degrees: 10,
        }
    }

    #[test]
    fn a_mesh_that_moves_the_coefficient_beyond_both_intervals_is_doubted() {
        let fine = fit(0.25, Bounds::Between(0.24, 0.26));
        let doubted = |dynamic| {
            let cells = [20, 5];
            Coarser { cells, dynamic }.doubt(&fine)
        };
        let apart = Bounds::Between(0.265, 0.275);
        let found = FrictionFinding::MeshMoves {
            mu: 0.25,
            half_the_cells: [20, 5],
            mu_on_half: 0.27,
            bounds_on_half: apart,
        };
        assert_eq!(doubted(Some(fit(0.27, apart))), Some(found));
        assert_eq!(doubted(Some(fit(0.255, Bounds::Between(0.25, 0.26)))), None);
        assert_eq!(
            doubted(Some(fit(0.27, Bounds::Between(0.245, 0.295)))),
            None
        );
        assert_eq!(doubted(Some(fit(0.1, Bounds::AtMost(0.3)))), None);
        assert_eq!(doubted(None), None);
    }
}
