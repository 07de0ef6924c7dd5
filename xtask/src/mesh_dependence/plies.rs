//! Plies of both specimens, with their own strengths or with those of crack bands.

use std::sync::Arc;

use stickslip_fem_core::QuadraturePoints;
use stickslip_fem_core::mesh::{ElementKind, Mesh};
use stickslip_joint::{CrackBand, CrackBandError, FractureEnergies};
use stickslip_laminate::failure::MaximumStress;
use stickslip_laminate::progressive::{PlyDiscount, PointModel};
use stickslip_laminate::{Degradation, Laminate, Ply, PlyConstants, Strengths};

use super::{Strengths as Chosen, Trouble};

/// T300/5208 (Tsai & Hahn 1980), MPa.
pub(super) const CONSTANTS: PlyConstants = PlyConstants {
    e1: 181_000.0,
    e2: 10_300.0,
    g12: 7_170.0,
    nu12: 0.28,
    alpha1: 0.02e-6,
    alpha2: 22.5e-6,
    thickness: 0.125,
};
const XT: f64 = 1500.0;
const XC: f64 = 1500.0;
const YT: f64 = 40.0;
const YC: f64 = 246.0;
const S12: f64 = 68.0;

/// What broken plies keep.
#[derive(Clone, Copy, Debug)]
pub(super) struct Kept {
    pub(super) fibre: f64,
    pub(super) matrix: f64,
}

pub(super) fn laminate(layup: &str) -> Result<Laminate, Trouble> {
    let strengths = Strengths::in_plane(XT, XC, YT, YC, S12);
    let ply = Ply::new("T300/5208", CONSTANTS, strengths)?;
    Ok(Laminate::new(&layup.parse()?, &ply)?)
}

/// Fracture energies for which rows of the width `length` have the plies' own strengths: l₀ of all modes.
pub(super) fn energies(kept: Kept, length: f64) -> FractureEnergies {
    let energy = |strength: f64, modulus: f64, kept: f64| {
        Some(0.5 * strength * strength * (1.0 - kept) / modulus * length)
    };
    FractureEnergies {
        fibre_tension: energy(XT, CONSTANTS.e1, kept.fibre),
        fibre_compression: energy(XC, CONSTANTS.e1, kept.fibre),
        matrix_tension: energy(YT, CONSTANTS.e2, kept.matrix),
        matrix_compression: energy(YC, CONSTANTS.e2, kept.matrix),
        shear: energy(S12, CONSTANTS.g12, kept.matrix),
    }
}

/// One model per cell of `mesh`: ply discount by maximum stress; those of crack bands are the plies' own on rows of the width `own`.
pub(super) fn models(
    mesh: &Mesh,
    kind: ElementKind,
    laminate: &Laminate,
    kept: Kept,
    (chosen, own): (Chosen, f64),
) -> Result<Vec<Arc<dyn PointModel>>, Trouble> {
    let degradation = Degradation::new(kept.fibre, kept.matrix)?;
    let build = |laminate: Laminate| -> Result<Arc<dyn PointModel>, CrackBandOrModel> {
        let discount = PlyDiscount::new(laminate, Box::new(MaximumStress), degradation)
            .map_err(|cause| CrackBandOrModel(cause.into()))?;
        Ok(Arc::new(discount))
    };
    if chosen == Chosen::Own {
        let model = build(laminate.clone()).map_err(|cause| cause.0)?;
        return Ok(vec![model; mesh.element_count()]);
    }
    // Rows of points of quadratic quadrilaterals are half a cell wide.
    let width = 1.0 / f64::from(u32::try_from(kind.order())?);
    let band = (CrackBand::new(energies(kept, own), degradation)?)
        .with_width(width)?
        .raising();
    let points = QuadraturePoints::of(mesh);
    band.models(&points, laminate, build)
        .map_err(|cause| cause.0)
}

/// Whatever stops a model from being made.
struct CrackBandOrModel(Trouble);

impl From<CrackBandError> for CrackBandOrModel {
    fn from(cause: CrackBandError) -> Self {
        Self(cause.into())
    }
}
