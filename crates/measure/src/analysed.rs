//! Edge stresses of measured states by localized hybrid analysis, with their covariance and the checks of the data.
//!
//! ```text
//! Δ¹ from the data,   y = T Δ¹,   Σ_y = s² T Σ Tᵀ + diag(b²)
//! ```
//!
//! Errors of neighbouring data may be correlated (a phase from a band of the spectrum, speckles of several pixels), and the fit, which is
//! smoother than their spacing, sees only their mean. s² is therefore the χ² of the means of blocks of neighbouring residuals over its
//! degrees of freedom, but at least the value that corresponds to the stated standard deviation, or to the rounding of the digits:
//! residuals of smoothed data are small whatever their errors, and those of calculated data vanish. b is the estimated bias by smoothing.
//! It is declared as a systematic error; nothing is corrected by it.

mod bearing;
mod boundary;
mod edge;
mod findings;
mod held_out;
mod known_force;
mod load;
mod picture;
mod region;
pub(super) mod scale;
mod truth;
mod workbench;

use stickslip_fem_core::mesh::Point;
use stickslip_hybrid::identify::Tractions;
use stickslip_hybrid::region::checks::ChiSquared;
use stickslip_hybrid::region::transfer::Propagated;

pub use bearing::BearingCheck;
pub(super) use edge::smoothing_reach;
pub use findings::free_in_region_only;
pub use known_force::ForceCheck;
pub use load::LoadCheck;
pub use picture::PictureMotion;
pub use region::all;
pub use truth::{TruePlace, true_edge};
pub use workbench::Workbench;

/// One of so many places is kept out of a fit, to check it; evenly over the plane.
pub const UNUSED: usize = 16;

/// Edge stresses of one state.
#[derive(Clone, Debug, Default)]
pub struct Analysed {
    /// Index of the state in the experiment.
    pub state: usize,
    /// Angle of each place along the edge `[rad]`, ascending.
    pub angle: Vec<f64>,
    /// Angle that is resolved along the edge `[rad]`: that between two corners of its cells, or more where smoothing reaches
    /// farther. Features closer together cannot be distinguished.
    pub resolution: f64,
    /// Pressure and shear τ_rθ `[MPa]` with their covariance, systematic part included.
    pub tractions: Tractions,
    /// Hoop stress σ_θ `[MPa]`.
    pub hoop: Vec<f64>,
    /// Its standard deviation `[MPa]`.
    pub hoop_deviation: Vec<f64>,
    /// Estimated bias of pressure, shear and hoop stress by smoothing, per place `[MPa]`.
    pub bias: Vec<[f64; 3]>,
    /// Pressure, shear and hoop stress of the same displacements by the elements alone, without equilibrium, per place `[MPa]`.
    pub direct: Option<Vec<[f64; 3]>>,
    /// Why they are not known, as text, where the data do not give them.
    pub without_direct: Option<String>,
    /// What the fit did, where displacements were fitted.
    pub fit: Option<FitFacts>,
    /// The variance of the data was multiplied by this, s² `[1]`.
    pub scale: f64,
    /// The reason, as a sentence, where s² is the least that the standard deviation allows because residuals give none.
    pub scale_assumed: Option<String>,
    /// What the picture may have added to the displacements of loads.
    pub picture: Vec<PictureMotion>,
    /// Residuals of the fit that the noise factor is measured by, over the stated standard deviations.
    pub(super) residuals: Vec<scale::Residual>,
    /// What the checks of the data say.
    pub checks: Checked,
    /// Forces along x and y `[N]`, with their covariance: what the region exerts through the edge by its stresses, then what acts on the
    /// region at the edge's nodes. In balance their sums vanish.
    pub forces: Propagated,
    /// Forces that hold the region, at the nodes that move as measured.
    pub nodal_forces: Vec<NodalForce>,
}

/// Checks of the data of one state.
#[derive(Clone, Debug, Default)]
pub struct Checked {
    /// Misfits at places that were not used.
    pub misfit: Vec<MisfitAt>,
    /// χ² of these misfits.
    pub unused: Option<ChiSquared>,
    /// χ² of the tractions on the edge beyond contact, where the region has such a part.
    pub free_edge: Option<ChiSquared>,
    /// χ² of the forces that hold nodes inside of the region, where nothing acts, if any are held.
    pub interior: Option<ChiSquared>,
    /// Force along x and y on the region by the stresses on its edge against the known one, where it is known.
    pub force: [Option<ForceCheck>; 2],
}

/// Force on a region at a node that moves as measured.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NodalForce {
    /// Where the node is `[mm]`.
    pub place: Point,
    /// Force along x and y `[N]`.
    pub force: [f64; 2],
    /// Its standard deviations `[N]`.
    pub deviation: [f64; 2],
    /// Whether the node lies inside, where nothing should act.
    pub inside: bool,
}

/// What a fit did.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FitFacts {
    /// Order of the differences that were smoothed.
    pub order: usize,
    /// Amount of smoothing `[1]`.
    pub amount: f64,
    /// Effective number of parameters `[1]`.
    pub parameters: f64,
    /// Mean over the edge of the part `[1]` of a displacement that the data at its own place decide, and not the smoothing.
    pub kept: f64,
    /// Number of data.
    pub data: usize,
    /// χ² of the residuals with the stated standard deviations `[1]`.
    pub residual: f64,
    /// s² as residuals alone say `[1]`; [`Analysed::scale`] is larger where a standard deviation was stated, or digits are coarse.
    pub of_residuals: f64,
}

/// Measured less calculated displacement at a place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MisfitAt {
    /// The place `[mm]`.
    pub place: Point,
    /// 0 for U, 1 for V.
    pub axis: usize,
    /// The misfit over its standard deviation `[1]`.
    pub relative: f64,
}

impl Analysed {
    /// Standard deviations of the pressures, then of the shears `[MPa]`.
    pub fn deviations(&self) -> [Vec<f64>; 2] {
        let places = 0..self.angle.len();
        let of = |part: usize| {
            places
                .clone()
                .map(move |k| self.tractions.deviation(part, k))
        };
        [0, 1].map(|part| of(part).collect())
    }

    /// Places that are at least twice the [resolution](Self::resolution) from the region's ends, where displacements of two edges meet and
    /// nothing is known well.
    pub fn inner(&self) -> std::ops::Range<usize> {
        let (Some(first), Some(last)) = (self.angle.first(), self.angle.last()) else {
            return 0..0;
        };
        let reach = 2.0 * self.resolution * (1.0 - 1e-6);
        let start = self.angle.partition_point(|angle| *angle < first + reach);
        let end = self.angle.partition_point(|angle| *angle <= last - reach);
        start..end.max(start)
    }
}
