//! The numbers of an edge that are stated with an error.

/// What must be known of a number to estimate its error.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Nature {
    /// It is that of a node, and so known to half of their spacing at best.
    OfNodes,
    /// A fit between nodes gives it, where there is one.
    Fitted,
    /// It is zero where the bodies do not touch, or do not where they bear.
    Vanishes,
}

/// The numbers, each with what it is for a reader and its nature.
macro_rules! stated {
    ($($(#[$doc:meta])* $name:ident: $text:literal, $nature:expr;)*) => {
        /// A number of an edge at the end of a load step.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        pub enum Stated {
            $($(#[$doc])* $name,)*
        }

        impl Stated {
            /// All of them.
            pub const ALL: [Self; [$($text),*].len()] = [$(Self::$name),*];

            /// What it is, for a reader.
            pub fn describe(self) -> &'static str {
                match self {
                    $(Self::$name => $text,)*
                }
            }

            fn nature(self) -> &'static [Nature] {
                match self {
                    $(Self::$name => &$nature,)*
                }
            }
        }
    };
}

stated! {
    /// Half of the extent of contact `[rad or mm]`.
    ContactExtent: "extent of contact", [Nature::Fitted, Nature::Vanishes];
    /// Half of the extent of the stick zone around the bearing point `[rad or mm]`.
    StickExtent: "extent of stick", [Nature::OfNodes, Nature::Vanishes];
    /// Place of the bearing point `[rad or mm]`.
    Bearing: "bearing point", [];
    /// Largest pressure `[MPa]`.
    PeakPressure: "peak pressure", [Nature::Vanishes];
    /// Its place `[rad or mm]`.
    PeakPressurePlace: "place of the peak pressure", [Nature::OfNodes];
    /// Largest tangential stress `[MPa]`.
    PeakHoop: "peak tangential stress", [Nature::Fitted];
    /// Its place `[rad or mm]`.
    PeakHoopPlace: "place of the peak tangential stress", [Nature::OfNodes];
    /// Tangential stress at the bearing point `[MPa]`.
    HoopAtBearing: "tangential stress at the bearing point", [];
    /// Friction force `[N]`.
    FrictionForce: "friction force", [];
    /// Normal force `[N]`.
    NormalForce: "normal force", [];
    /// Component x of the resultant `[N]`.
    ResultantX: "resultant in x", [];
    /// Component y of the resultant `[N]`.
    ResultantY: "resultant in y", [];
    /// Length of the zones that slip away from the bearing point `[rad or mm]`.
    SlipAway: "extent of slip away from the bearing point", [Nature::OfNodes, Nature::Vanishes];
    /// Length of the zones that slip towards it `[rad or mm]`.
    SlipTowards: "extent of slip towards the bearing point", [Nature::OfNodes, Nature::Vanishes];
    /// Work of friction in the step `[N·mm]`.
    FrictionWork: "work of friction", [];
}

impl Stated {
    /// Those whose relative error an accuracy bounds that names none.
    pub const ASKED: [Self; 4] = [
        Self::PeakPressure,
        Self::PeakHoop,
        Self::ContactExtent,
        Self::FrictionForce,
    ];

    /// Whether it is that of a node, and so known to half of their spacing at best.
    pub fn is_of_nodes(self) -> bool {
        self.nature().contains(&Nature::OfNodes)
    }

    /// Whether a fit between nodes gives it, where there is one.
    pub fn is_fitted(self) -> bool {
        self.nature().contains(&Nature::Fitted)
    }

    /// Whether it is zero where the bodies do not touch, or do not where they bear.
    pub fn vanishes(self) -> bool {
        self.nature().contains(&Nature::Vanishes)
    }
}

/// Estimated errors of the stated numbers of an edge in a step, in base units; empty where none were estimated.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Errors(Vec<Option<f64>>);

impl Errors {
    /// The errors `error` of all stated numbers, in base units.
    pub fn of(error: impl FnMut(Stated) -> Option<f64>) -> Self {
        Self(Stated::ALL.into_iter().map(error).collect())
    }

    /// The error of `stated`, in its base unit; `None` where the number has none or none was estimated.
    pub fn get(&self, stated: Stated) -> Option<f64> {
        let at = Stated::ALL.iter().position(|own| *own == stated)?;
        self.0.get(at).copied().flatten()
    }

    /// Whether none were estimated.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }
}

/// Estimated errors of the values of a node of an edge `[MPa]`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct RowErrors {
    /// Of the pressure, and of σ_r or σ_yy.
    pub pressure: f64,
    /// Of the tangential traction, and of τ.
    pub shear: f64,
    /// Of σ_θ or σ_xx.
    pub sigma_tangential: f64,
}
