//! The failure criteria that are linked into the program, by the name that a file gives them.

use super::criterion::FailureCriterion;
use super::error::FailureError;

/// Describes a criterion that a file can name.
///
/// A criterion of another crate registers with `inventory::submit!` and is then found like those of this one:
///
/// ```
/// use stickslip_laminate::failure::{CriterionInfo, criterion_named, needed_strength};
/// use stickslip_laminate::{
///     Assessment, FailureCriterion, FailureError, FailureMode, Ply, PlyLoading, Strength, inventory,
/// };
///
/// /// Fibre tension alone: σ₁/X_t.
/// #[derive(Debug)]
/// struct FibreTension;
///
/// impl FailureCriterion for FibreTension {
///     fn name(&self) -> &'static str {
///         "fibre_tension"
///     }
///
///     fn required(&self) -> &'static [Strength] {
///         &[Strength::Xt]
///     }
///
///     fn assess(&self, ply: &Ply, loading: &PlyLoading) -> Result<Assessment, FailureError> {
///         loading.check_finite()?;
///         let limit = needed_strength(self.name(), ply, Strength::Xt)?;
///         let (held, applied) = (loading.held[0], loading.applied[0]);
///         let reserve_factor = match limit - held {
///             room if room <= 0.0 => 0.0,
///             room if applied > 0.0 => room / applied,
///             _ => f64::INFINITY,
///         };
///         Ok(Assessment {
///             criterion: self.name(),
///             index: ((held + applied) / limit).max(0.0),
///             reserve_factor,
///             mode: FailureMode::FibreTension,
///         })
///     }
/// }
///
/// inventory::submit! {
///     CriterionInfo {
///         name: "fibre_tension",
///         summary: "the stress along the fibres against its tensile strength",
///         make: || Box::new(FibreTension),
///     }
/// }
///
/// assert_eq!(criterion_named("fibre_tension")?.required(), [Strength::Xt]);
/// # Ok::<(), FailureError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct CriterionInfo {
    /// Name of the criterion in files, the same as [`FailureCriterion::name`].
    pub name: &'static str,
    /// The criterion in one line, with its source.
    pub summary: &'static str,
    /// Makes the criterion with its usual parameters; it says which strengths it needs.
    pub make: fn() -> Box<dyn FailureCriterion>,
}

inventory::collect!(CriterionInfo);

/// Lists all registered criteria by name, those of other crates included.
pub fn criteria() -> impl Iterator<Item = &'static CriterionInfo> {
    let mut sorted: Vec<_> = inventory::iter::<CriterionInfo>.into_iter().collect();
    // The order of registration is the linker's.
    sorted.sort_by_key(|info| info.name);
    sorted.into_iter()
}

/// Makes the registered criterion of this name with its usual parameters.
///
/// # Errors
/// [`FailureError::UnknownCriterion`] with all registered names.
pub fn criterion_named(name: &str) -> Result<Box<dyn FailureCriterion>, FailureError> {
    let found = inventory::iter::<CriterionInfo>
        .into_iter()
        .find(|info| info.name == name);
    let found = found.ok_or_else(|| FailureError::UnknownCriterion {
        name: name.to_owned(),
        known: criteria().map(|info| info.name).collect(),
    })?;
    Ok((found.make)())
}
