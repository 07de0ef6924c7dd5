//! Findings of edge stresses.

use serde::Serialize;

/// A check of the data by χ².
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Check {
    /// The misfit at places that were not used.
    UnusedPlaces,
    /// The traction on the edge that nothing touches.
    FreeEdge,
    /// The force on nodes inside that move as measured.
    NodesInside,
}

/// What the bands and checks of a region hold.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum FitFinding {
    /// What is declared free is taken off the region, but neither off the whole plate nor off the data of laws.
    FreeInRegionOnly,
    /// χ² of a check is too large.
    CheckFails {
        /// Which check.
        check: Check,
        /// χ² `[1]`.
        chi_squared: f64,
        /// What is expected.
        count: usize,
        /// The standard deviation of that `[1]`.
        deviation: f64,
        /// A dilation of the picture that would explain it, and its standard deviation `[1]`.
        dilation: Option<[f64; 2]>,
    },
    /// Stresses by direct interpolation are not known.
    NoDirectStresses {
        /// Why.
        cause: String,
    },
    /// The noise factor is assumed, because the fit that would show it fails.
    NoiseFactorAssumed {
        /// The noise factor `[1]`.
        factor: f64,
        /// Why the fit fails.
        cause: String,
    },
    /// The fit has too many parameters for its data.
    ManyParameters {
        /// Number of data.
        data: usize,
        /// Effective number of parameters `[1]`.
        parameters: f64,
    },
    /// Residuals are far below the standard deviation of the data.
    SmallResiduals {
        /// Their variance over that of the standard deviation `[1]`.
        variance_ratio: f64,
        /// Whether the standard deviation was stated, and not estimated.
        stated: bool,
    },
    /// Errors of neighbours are correlated.
    CorrelatedResiduals {
        /// Variance of means of neighbouring residuals over that of independent errors `[1]`.
        of_means: f64,
        /// The same of single residuals `[1]`.
        of_singles: f64,
        /// Whether the amount of smoothing is stated.
        amount_stated: bool,
    },
    /// The variance of the residuals is far from that of the standard deviation.
    WrongDeviation {
        /// The former over the latter `[1]`.
        variance_ratio: f64,
    },
    /// A motion of the picture that is declared free and cannot be separated from the load.
    NotSeparable {
        /// Its name.
        motion: &'static str,
        /// Change of the pressure by a unit of it, at most `[MPa]`.
        pressure_per_unit: f64,
    },
}

impl FitFinding {
    pub(super) const fn warns(&self) -> bool {
        !matches!(self, Self::NoDirectStresses { .. })
    }
}

/// Why the force on an edge and the load of its state are not compared.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum NotCompared {
    /// The state has no load.
    NoLoad,
    /// The load is that of the null field.
    ZeroLoad,
    /// The scene has other loads or contacts.
    OtherLoads,
    /// No pressure exceeds its uncertainty.
    NoContact,
    /// Noise hides where the contact ends.
    Noise,
    /// Neither end of the contact is in sight.
    NoEnd,
    /// The direction of the force contradicts the bearing point.
    DoubtfulBearing,
    /// The bearing point is out of sight.
    HiddenBearing,
}

/// A load that the force on the edge contradicts.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct LoadFails {
    /// Force of the contact along its bearing point `[N]`.
    pub force: f64,
    /// Its standard deviation `[N]`.
    pub deviation: f64,
    /// The stated load `[N]`.
    pub load: f64,
    /// Whether the force counts from a null field whose load is not known.
    pub above_null: bool,
    /// The bearing point `[degree]`, where the region cuts the contact.
    pub bearing_degrees: Option<f64>,
    /// Thickness of the specimen `[mm]`.
    pub thickness: f64,
}

/// A bearing point that the force on the edge contradicts.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct BearingFails {
    /// Direction of the force `[degree]`.
    pub direction_degrees: f64,
    /// Its standard deviation `[degree]`.
    pub deviation_degrees: f64,
    /// Angle beyond what the bearing point explains `[degree]`.
    pub beyond_degrees: f64,
    /// The bearing point `[degree]`.
    pub bearing_degrees: f64,
    /// Whether that is stated, and not assumed.
    pub stated: bool,
    /// Whether all of the contact is in sight.
    pub is_whole: bool,
}

/// What the forces on the edge of a region show.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum ForceFinding {
    /// A known force that the region contradicts.
    EdgeForceFails {
        /// x or y.
        axis: &'static str,
        /// Force by the nodes of the edge less the known one `[N]`.
        excess: f64,
        /// What of it is explained `[N]`.
        explained: f64,
    },
    /// A known force that shows nothing.
    EdgeForceIsNoEvidence {
        /// x or y.
        axis: &'static str,
        /// Excess that would be explained `[N]`.
        explained: f64,
        /// The same over the size of the known force `[1]`.
        of_force: f64,
    },
    /// A load that the force on the edge contradicts.
    LoadFails(LoadFails),
    /// The size of the force is checked by nothing.
    LoadNotChecked {
        /// Why.
        reason: NotCompared,
    },
    /// An edge that is pulled, as no contact does.
    Pulled {
        /// Its largest tension `[MPa]`.
        tension: f64,
        /// Where that is `[degree]`.
        theta_degrees: f64,
    },
    /// A bearing point that the force on the edge contradicts.
    BearingFails(BearingFails),
}

impl ForceFinding {
    pub(super) const fn warns(&self) -> bool {
        !matches!(self, Self::LoadNotChecked { .. })
    }
}
