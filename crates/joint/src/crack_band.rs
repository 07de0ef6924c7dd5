//! Ply discount that dissipates the same energy per crack area on any mesh.
//!
//! ```text
//! ½ X_eq² (1 − d)/E · h = G      →      X_eq = √(2 E G / ((1 − d) h)),      X_eq = X at  h = l₀ = 2 E G / ((1 − d) X²)
//! ```
//!
//! A ply that loses its stiffness at once, down to the factor d, dissipates ½ X² (1 − d)/E per volume. Damage gathers in one row of
//! points, so the energy per crack area is that times the row's width and vanishes with the mesh: the load at which a crack runs falls
//! with √h. The equivalent strength X_eq (Bažant & Cedolin 1979; Bažant & Oh 1983) makes it the same on every mesh.
//!
//! How much that is depends on how a row fails: by the stress at its points, not by the energy that the crack's advance releases, and
//! what is set free beyond G goes into waves. A crack in a strip of fibres then runs at 2.1 times the load of linear fracture
//! mechanics on any mesh; with rows taken as 4.3 times as wide ([`CrackBand::with_width`]) it runs at that load. On quadratic
//! quadrilaterals rows of points are half a cell wide and fail one by one: their width is half of that.
//!
//! On cells smaller than l₀ the equivalent strength exceeds the ply's own, and with it the load of first failure on an edge without a
//! notch: what becomes independent of the mesh is the running of a crack, not its start. So the own strength is the limit, unless
//! [`CrackBand::raising`] asks for more, and a crack on such cells takes less than its energy. Cells of the size l₀ serve both. The factor d
//! must be small beside the ratio of h to the size of the plate, or the failed rows go on bearing the load.
//!
//! The width of the row is taken as the size √A of the cell times a factor, 1 unless said otherwise.

use std::collections::BTreeMap;
use std::sync::Arc;

use stickslip_fem_core::QuadraturePoints;
use stickslip_laminate::progressive::PointModel;
use stickslip_laminate::{Degradation, Laminate, LaminateError, Ply, PlyError, Strengths};
use thiserror::Error;

/// Fracture energies of a ply that make no sense, or a ply or laminate that cannot be remade with them.
#[derive(Clone, Debug, Error)]
#[non_exhaustive]
pub enum CrackBandError {
    /// An energy or length that is not a positive finite number.
    #[error("{name} = {value} must be positive and finite")]
    NotPositive {
        /// Which number.
        name: &'static str,
        /// The value given: an energy `[force/length]`, a length `[length]` or a width in cells `[1]`.
        value: f64,
    },
    /// A factor of degradation of 1: failure that loses no stiffness dissipates nothing.
    #[error("{name} failure keeps all stiffness, so no strength dissipates an energy")]
    NoLoss {
        /// `fibre` or `matrix`.
        name: &'static str,
    },
    /// The ply refused the equivalent strengths.
    #[error(transparent)]
    Ply(#[from] PlyError),
    /// The laminate refused the plies.
    #[error(transparent)]
    Laminate(#[from] LaminateError),
}

/// Energies `[force/length]` that a crack of unit area takes, by what it breaks; without one the strength stays the ply's own (Bažant & Oh 1983).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct FractureEnergies {
    /// Fibres in tension.
    pub fibre_tension: Option<f64>,
    /// Fibres in compression.
    pub fibre_compression: Option<f64>,
    /// Matrix in tension across the fibres.
    pub matrix_tension: Option<f64>,
    /// Matrix in compression across the fibres.
    pub matrix_compression: Option<f64>,
    /// Matrix in shear.
    pub shear: Option<f64>,
}

/// Equivalent strengths by fracture energies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CrackBand {
    energies: FractureEnergies,
    degradation: Degradation,
    width: f64,
    raises: bool,
}

impl CrackBand {
    /// Scaling by `energies` for plies that keep what `degradation` leaves them.
    ///
    /// # Errors
    /// [`CrackBandError::NotPositive`] for an energy, [`CrackBandError::NoLoss`] if what it is for loses nothing.
    pub fn new(
        energies: FractureEnergies,
        degradation: Degradation,
    ) -> Result<Self, CrackBandError> {
        let fibre = [energies.fibre_tension, energies.fibre_compression];
        let matrix = [
            energies.matrix_tension,
            energies.matrix_compression,
            energies.shear,
        ];
        for value in fibre.iter().chain(&matrix).flatten() {
            positive("fracture energy", *value)?;
        }
        if fibre.iter().any(Option::is_some) && degradation.fibre() == 1.0 {
            return Err(CrackBandError::NoLoss { name: "fibre" });
        }
        if matrix.iter().any(Option::is_some) && degradation.matrix() == 1.0 {
            return Err(CrackBandError::NoLoss { name: "matrix" });
        }
        Ok(Self {
            energies,
            degradation,
            width: 1.0,
            raises: false,
        })
    }

    /// The same with rows of failing points as wide as `width` cells `[1]`.
    ///
    /// # Errors
    /// [`CrackBandError::NotPositive`].
    pub fn with_width(self, width: f64) -> Result<Self, CrackBandError> {
        positive("width", width)?;
        Ok(Self { width, ..self })
    }

    /// Width of a row, in cells `[1]`.
    pub fn width(&self) -> f64 {
        self.width
    }

    /// The same, with strengths above the plies' own on cells that are small enough. A crack then takes its energy on any mesh, but
    /// material without a crack bears more than it can.
    #[must_use]
    pub fn raising(self) -> Self {
        Self {
            raises: true,
            ..self
        }
    }

    /// For every energy given, and every strength of `ply` that it scales: the name of the energy, as in [`FractureEnergies`], and the
    /// width l₀ of a row `[length]` whose equivalent strength is the ply's own. Rows that are wider get less, narrower ones keep their own and take less than
    /// the energy, unless strengths are [raised](Self::raising).
    pub fn own_lengths(&self, ply: &Ply) -> impl Iterator<Item = (&'static str, f64)> {
        let terms = self.terms(ply).into_iter();
        terms.filter_map(|term| Some((term.name, term.times_square()? / term.own?.powi(2))))
    }

    /// The strengths that energies scale.
    fn terms(&self, ply: &Ply) -> [Term; 5] {
        let (constants, own, energies) = (ply.constants(), ply.strengths(), &self.energies);
        let [fibre, matrix] = [self.degradation.fibre(), self.degradation.matrix()];
        let term = |name, own, energy, modulus, kept| Term {
            name,
            own,
            energy,
            modulus,
            kept,
        };
        let FractureEnergies {
            fibre_tension,
            fibre_compression,
            matrix_tension,
            matrix_compression,
            shear,
        } = *energies;
        [
            term("fibre_tension", own.xt, fibre_tension, constants.e1, fibre),
            term(
                "fibre_compression",
                own.xc,
                fibre_compression,
                constants.e1,
                fibre,
            ),
            term(
                "matrix_tension",
                own.yt,
                matrix_tension,
                constants.e2,
                matrix,
            ),
            term(
                "matrix_compression",
                own.yc,
                matrix_compression,
                constants.e2,
                matrix,
            ),
            term("shear", own.s12, shear, constants.g12, matrix),
        ]
    }

    /// `ply` with equivalent strengths for a row of the width `length` `[length]`.
    ///
    /// # Errors
    /// [`CrackBandError::NotPositive`], [`CrackBandError::Ply`].
    pub fn ply(&self, ply: &Ply, length: f64) -> Result<Ply, CrackBandError> {
        positive("length", length)?;
        let limit = if self.raises { f64::INFINITY } else { 1.0 };
        let [xt, xc, yt, yc, s12] = self.terms(ply).map(|term| {
            let scaled = term.times_square().map(|square| (square / length).sqrt());
            (term.own).map(|own| scaled.map_or(own, |scaled| scaled.min(limit * own)))
        });
        let strengths = Strengths {
            xt,
            xc,
            yt,
            yc,
            s12,
            ..*ply.strengths()
        };
        Ok(Ply::new(ply.name(), *ply.constants(), strengths)?)
    }

    /// `laminate` with equivalent strengths of all plies, for a row of the width `length` `[length]`.
    ///
    /// # Errors
    /// As [`ply`](Self::ply), and [`CrackBandError::Laminate`].
    pub fn laminate(&self, laminate: &Laminate, length: f64) -> Result<Laminate, CrackBandError> {
        let plies: Vec<(Arc<Ply>, f64)> = (laminate.layers().iter())
            .map(|layer| Ok((Arc::new(self.ply(layer.ply(), length)?), layer.angle())))
            .collect::<Result<_, CrackBandError>>()?;
        Ok(Laminate::from_layers(plies)?)
    }

    /// One model per cell for [`ProgressiveBody::with_models`](crate::ProgressiveBody::with_models): `build` makes it of the laminate
    /// with the cell's equivalent strengths. Cells whose sizes agree to a thousandth share a model.
    ///
    /// # Errors
    /// As [`laminate`](Self::laminate), or what `build` returns.
    pub fn models<E: From<CrackBandError>>(
        &self,
        points: &QuadraturePoints,
        laminate: &Laminate,
        mut build: impl FnMut(Laminate) -> Result<Arc<dyn PointModel>, E>,
    ) -> Result<Vec<Arc<dyn PointModel>>, E> {
        const SHARED: f64 = 1e-3;
        let mut known: BTreeMap<i64, Arc<dyn PointModel>> = BTreeMap::new();
        let mut models = Vec::with_capacity(points.cell_count());
        for cell in 0..points.cell_count() {
            let class = (0.5 * points.cell_area(cell).ln() / SHARED).round();
            let model = if let Some(model) = known.get(&(class as i64)) {
                Arc::clone(model)
            } else {
                let length = self.width * (class * SHARED).exp();
                let model = build(self.laminate(laminate, length)?)?;
                known.insert(class as i64, Arc::clone(&model));
                model
            };
            models.push(model);
        }
        Ok(models)
    }
}

/// A strength and the energy that scales it.
struct Term {
    name: &'static str,
    own: Option<f64>,
    energy: Option<f64>,
    modulus: f64,
    kept: f64,
}

impl Term {
    /// Row width times square of the equivalent strength, 2 E G/(1 − d).
    fn times_square(&self) -> Option<f64> {
        Some(2.0 * self.modulus * self.energy? / (1.0 - self.kept))
    }
}

fn positive(name: &'static str, value: f64) -> Result<(), CrackBandError> {
    if value > 0.0 && value.is_finite() {
        Ok(())
    } else {
        Err(CrackBandError::NotPositive { name, value })
    }
}
