//! Strengths of a ply, each a positive magnitude that may be unknown.
//!
//! ```text
//! −X_c < σ₁ < X_t,   −Y_c < σ₂ < Y_t,   |τ₁₂| < S₁₂,   −Z_c < σ₃ < Z_t,   |τ₁₃| < S₁₃,   |τ₂₃| < S₂₃
//! −ε_1c < ε₁ < ε_1t,   −ε_2c < ε₂ < ε_2t,   |γ₁₂| < γ_12u
//! ```
//!
//! 1 is along the fibres, 2 across them in the ply's plane, 3 along its normal.

use std::fmt;

/// Names of the strengths, as an error and a file write them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Strength {
    /// X_t, tension along the fibres `[stress]`.
    Xt,
    /// X_c, compression along the fibres `[stress]`.
    Xc,
    /// Y_t, tension across the fibres `[stress]`.
    Yt,
    /// Y_c, compression across the fibres `[stress]`.
    Yc,
    /// S₁₂, shear in the plane of the ply `[stress]`.
    S12,
    /// Z_t, tension along the ply's normal `[stress]`.
    Zt,
    /// Z_c, compression along the ply's normal `[stress]`.
    Zc,
    /// S₁₃, shear in the 1–3 plane `[stress]`.
    S13,
    /// S₂₃, shear in the 2–3 plane `[stress]`.
    S23,
    /// ε_1t, strain in tension along the fibres, dimensionless.
    Strain1t,
    /// ε_1c, strain in compression along the fibres, dimensionless.
    Strain1c,
    /// ε_2t, strain in tension across the fibres, dimensionless.
    Strain2t,
    /// ε_2c, strain in compression across the fibres, dimensionless.
    Strain2c,
    /// γ_12u, engineering shear strain in the plane of the ply, dimensionless.
    Strain12,
}

impl Strength {
    /// Every strength, in the order of the fields of [`Strengths`].
    pub const ALL: [Self; 14] = [
        Self::Xt,
        Self::Xc,
        Self::Yt,
        Self::Yc,
        Self::S12,
        Self::Zt,
        Self::Zc,
        Self::S13,
        Self::S23,
        Self::Strain1t,
        Self::Strain1c,
        Self::Strain2t,
        Self::Strain2c,
        Self::Strain12,
    ];

    /// The name of the field of [`Strengths`].
    pub fn name(self) -> &'static str {
        match self {
            Self::Xt => "xt",
            Self::Xc => "xc",
            Self::Yt => "yt",
            Self::Yc => "yc",
            Self::S12 => "s12",
            Self::Zt => "zt",
            Self::Zc => "zc",
            Self::S13 => "s13",
            Self::S23 => "s23",
            Self::Strain1t => "strain_1t",
            Self::Strain1c => "strain_1c",
            Self::Strain2t => "strain_2t",
            Self::Strain2c => "strain_2c",
            Self::Strain12 => "strain_12",
        }
    }

    /// Describes the strength in a phrase.
    pub fn meaning(self) -> &'static str {
        match self {
            Self::Xt => "tensile strength along the fibres",
            Self::Xc => "compressive strength along the fibres",
            Self::Yt => "tensile strength across the fibres",
            Self::Yc => "compressive strength across the fibres",
            Self::S12 => "in-plane shear strength",
            Self::Zt => "tensile strength through the thickness",
            Self::Zc => "compressive strength through the thickness",
            Self::S13 => "shear strength in the 1-3 plane",
            Self::S23 => "shear strength in the 2-3 plane, often taken as yc/2",
            Self::Strain1t => "tensile strain limit along the fibres",
            Self::Strain1c => "compressive strain limit along the fibres",
            Self::Strain2t => "tensile strain limit across the fibres",
            Self::Strain2c => "compressive strain limit across the fibres",
            Self::Strain12 => "in-plane engineering shear strain limit",
        }
    }
}

impl fmt::Display for Strength {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// Strengths of a ply: positive magnitudes, `None` where unknown. A criterion asks for those that it needs.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Strengths {
    /// X_t, tension along the fibres `[stress]`.
    pub xt: Option<f64>,
    /// X_c, compression along the fibres `[stress]`.
    pub xc: Option<f64>,
    /// Y_t, tension across the fibres `[stress]`.
    pub yt: Option<f64>,
    /// Y_c, compression across the fibres `[stress]`.
    pub yc: Option<f64>,
    /// S₁₂, shear in the plane of the ply `[stress]`.
    pub s12: Option<f64>,
    /// Z_t, tension along the ply's normal `[stress]`.
    pub zt: Option<f64>,
    /// Z_c, compression along the ply's normal `[stress]`.
    pub zc: Option<f64>,
    /// S₁₃, shear in the 1–3 plane `[stress]`.
    pub s13: Option<f64>,
    /// S₂₃, shear in the 2–3 plane `[stress]`.
    pub s23: Option<f64>,
    /// ε_1t, strain in tension along the fibres, dimensionless.
    pub strain_1t: Option<f64>,
    /// ε_1c, strain in compression along the fibres, dimensionless.
    pub strain_1c: Option<f64>,
    /// ε_2t, strain in tension across the fibres, dimensionless.
    pub strain_2t: Option<f64>,
    /// ε_2c, strain in compression across the fibres, dimensionless.
    pub strain_2c: Option<f64>,
    /// γ_12u, engineering shear strain in the plane of the ply, dimensionless.
    pub strain_12: Option<f64>,
}

impl Strengths {
    /// Gives the five in-plane strengths X_t, X_c, Y_t, Y_c, S₁₂ `[stress]`, positive magnitudes, and nothing else.
    pub fn in_plane(xt: f64, xc: f64, yt: f64, yc: f64, s12: f64) -> Self {
        Self {
            xt: Some(xt),
            xc: Some(xc),
            yt: Some(yt),
            yc: Some(yc),
            s12: Some(s12),
            ..Self::default()
        }
    }

    /// Fills in strain limits that are not given, from a ply that stays linear up to its strength:
    /// X_t/E₁, X_c/E₁, Y_t/E₂, Y_c/E₂ and S₁₂/G₁₂, for the moduli `e1`, `e2`, `g12` `[stress]`.
    #[must_use]
    pub fn with_linear_strain_limits(self, e1: f64, e2: f64, g12: f64) -> Self {
        let limit = |given: Option<f64>, strength: Option<f64>, modulus: f64| {
            given.or_else(|| strength.map(|value| value / modulus))
        };
        Self {
            strain_1t: limit(self.strain_1t, self.xt, e1),
            strain_1c: limit(self.strain_1c, self.xc, e1),
            strain_2t: limit(self.strain_2t, self.yt, e2),
            strain_2c: limit(self.strain_2c, self.yc, e2),
            strain_12: limit(self.strain_12, self.s12, g12),
            ..self
        }
    }

    /// The strength of this name, `[stress]` or a strain limit, if known.
    pub fn get(&self, strength: Strength) -> Option<f64> {
        let mut copy = *self;
        *copy.entry(strength)
    }

    /// Leaves out `left_out`.
    #[must_use]
    pub fn without(self, left_out: Strength) -> Self {
        let mut rest = self;
        *rest.entry(left_out) = None;
        rest
    }

    /// Leaves out all strengths that are not among `kept`.
    #[must_use]
    pub fn only(self, kept: &[Strength]) -> Self {
        let others = Strength::ALL
            .into_iter()
            .filter(|name| !kept.contains(name));
        others.fold(self, Self::without)
    }

    fn entry(&mut self, strength: Strength) -> &mut Option<f64> {
        match strength {
            Strength::Xt => &mut self.xt,
            Strength::Xc => &mut self.xc,
            Strength::Yt => &mut self.yt,
            Strength::Yc => &mut self.yc,
            Strength::S12 => &mut self.s12,
            Strength::Zt => &mut self.zt,
            Strength::Zc => &mut self.zc,
            Strength::S13 => &mut self.s13,
            Strength::S23 => &mut self.s23,
            Strength::Strain1t => &mut self.strain_1t,
            Strength::Strain1c => &mut self.strain_1c,
            Strength::Strain2t => &mut self.strain_2t,
            Strength::Strain2c => &mut self.strain_2c,
            Strength::Strain12 => &mut self.strain_12,
        }
    }

    /// Checks whether no strength at all is known.
    pub fn is_empty(&self) -> bool {
        Strength::ALL.iter().all(|&name| self.get(name).is_none())
    }
}
