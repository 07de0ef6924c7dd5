//! First-ply failure: the layer, place and multiple of the load at which a laminate first fails somewhere.
//!
//! ```text
//! σ_k(z; r) = Q (T_k (ε^T + z κ^T) − α ΔT) + r Q T_k (ε^M + z κ^M),   reserve factor = min over k, z
//! ```
//!
//! (ε^T, κ^T) is the deformation by ΔT alone, (ε^M, κ^M) that by (N, M) alone; only the latter grows with the load. Along the
//! thickness of a layer the stress is linear, so with a convex criterion the faces govern; the middle is named where nothing
//! varies through the thickness.

use super::criterion::{Assessment, FailureCriterion, PlyLoading};
use super::error::{FailureError, finite};
use crate::laminate::{Deformation, Laminate, LaminateLoad, Layer, Position};

/// Reserve factors closer than this, relatively, are equal: plies alike by symmetry differ by rounding.
const TIE: f64 = 1e-12;

/// What a criterion says of a layer of a loaded laminate, at the place in its thickness that governs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlyAssessment {
    /// Index of the layer, from the bottom, from 0.
    pub layer: usize,
    /// Angle of its fibres `[degree]`.
    pub angle: f64,
    /// Where in its thickness.
    pub position: Position,
    /// Index, reserve factor and mode there.
    pub assessment: Assessment,
}

/// Assesses every layer of `laminate` under `load`, from the bottom up, at the place in its thickness that governs.
///
/// # Errors
/// [`FailureError::NotFinite`] if the load is not finite, else the first error of [`FailureCriterion::assess`].
pub fn assess_plies(
    laminate: &Laminate,
    load: &LaminateLoad,
    criterion: &dyn FailureCriterion,
) -> Result<Vec<PlyAssessment>, FailureError> {
    let loaded = Loaded::new(laminate, load)?;
    let layers = laminate.layers().iter().enumerate();
    layers
        .map(|(index, layer)| {
            loaded.govern(index, layer, |loading| {
                criterion.assess(layer.ply(), loading)
            })
        })
        .collect()
}

/// Finds the layer of `laminate` that fails first when (N, M) of `load` grow in proportion, its temperature held. Of layers alike by
/// symmetry it is the lowest.
///
/// # Errors
/// As [`assess_plies`].
pub fn first_ply_failure(
    laminate: &Laminate,
    load: &LaminateLoad,
    criterion: &dyn FailureCriterion,
) -> Result<PlyAssessment, FailureError> {
    let assessments = assess_plies(laminate, load, criterion)?;
    // A laminate has at least one layer.
    Ok(assessments[1..]
        .iter()
        .fold(assessments[0], |first, next| earlier(first, *next)))
}

fn earlier(first: PlyAssessment, next: PlyAssessment) -> PlyAssessment {
    let [known, new] = [first, next].map(|ply| ply.assessment.reserve_factor);
    if new < known * (1.0 - TIE) {
        next
    } else {
        first
    }
}

/// A laminate's deformations by its temperature and by its load.
pub(super) struct Loaded {
    held: Deformation,
    applied: Deformation,
    temperature: f64,
}

impl Loaded {
    pub(super) fn new(laminate: &Laminate, load: &LaminateLoad) -> Result<Self, FailureError> {
        finite("load", &[load.force, load.moment].concat())?;
        finite("temperature", &[load.temperature])?;
        let thermal = LaminateLoad {
            temperature: load.temperature,
            ..LaminateLoad::default()
        };
        let mechanical = LaminateLoad {
            temperature: 0.0,
            ..*load
        };
        Ok(Self {
            held: laminate.deformation(&thermal),
            applied: laminate.deformation(&mechanical),
            temperature: load.temperature,
        })
    }

    /// The place in the layer with the smallest reserve factor.
    pub(super) fn govern(
        &self,
        index: usize,
        layer: &Layer,
        assess: impl Fn(&PlyLoading) -> Result<Assessment, FailureError>,
    ) -> Result<PlyAssessment, FailureError> {
        let at = |position: Position| -> Result<PlyAssessment, FailureError> {
            let height = position.height(layer);
            let loading = PlyLoading {
                held: layer.stress(self.held.strain_at(height), self.temperature),
                applied: layer.stress(self.applied.strain_at(height), 0.0),
            };
            Ok(PlyAssessment {
                layer: index,
                angle: layer.angle(),
                position,
                assessment: assess(&loading)?,
            })
        };
        let bottom_or_middle = earlier(at(Position::Middle)?, at(Position::Bottom)?);
        Ok(earlier(bottom_or_middle, at(Position::Top)?))
    }
}
