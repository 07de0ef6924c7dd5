//! Plies of both specimens, with their own strengths or with those of crack bands, and bodies of them that are driven.

use std::sync::Arc;

use stickslip_fem_core::material::Material;
use stickslip_fem_core::mesh::{ElementKind, Mesh};
use stickslip_fem_core::{ElasticBody, HeldDirection, LoadCase, QuadraturePoints, Support};
use stickslip_joint::{CrackBand, FractureEnergies, ProgressiveBody};
use stickslip_laminate::failure::MaximumStress;
use stickslip_laminate::progressive::{PlyDiscount, PointModel};
use stickslip_laminate::{Degradation, Laminate, Ply, PlyConstants, Strengths};

use crate::study::TaskError;

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

/// How plies break.
#[derive(Clone, Copy, Debug)]
pub(super) struct Breaking {
    /// Parts that broken fibres and broken matrix keep.
    pub(super) kept: [f64; 2],
    /// Width of a row for which crack bands have the plies' own strengths `[mm]`.
    pub(super) own: f64,
}

impl Breaking {
    /// Fracture energies for which rows of the width `own` have the plies' own strengths.
    pub(super) fn energies(self) -> FractureEnergies {
        let energy = |strength: f64, modulus: f64, kept: f64| {
            Some(0.5 * strength * strength * (1.0 - kept) / modulus * self.own)
        };
        let [fibre, matrix] = self.kept;
        FractureEnergies {
            fibre_tension: energy(XT, CONSTANTS.e1, fibre),
            fibre_compression: energy(XC, CONSTANTS.e1, fibre),
            matrix_tension: energy(YT, CONSTANTS.e2, matrix),
            matrix_compression: energy(YC, CONSTANTS.e2, matrix),
            shear: energy(S12, CONSTANTS.g12, matrix),
        }
    }

    /// One model per cell of `mesh`: ply discount by maximum stress, with the strengths of crack bands if it `has_bands`.
    fn models(
        self,
        mesh: &Mesh,
        kind: ElementKind,
        laminate: &Laminate,
        has_bands: bool,
    ) -> Result<Vec<Arc<dyn PointModel>>, TaskError> {
        let degradation = Degradation::new(self.kept[0], self.kept[1])?;
        let build = |laminate: Laminate| -> Result<Arc<dyn PointModel>, TaskError> {
            let discount = PlyDiscount::new(laminate, Box::new(MaximumStress), degradation)?;
            Ok(Arc::new(discount))
        };
        if !has_bands {
            return Ok(vec![build(laminate.clone())?; mesh.element_count()]);
        }
        // Rows of points of quadratic quadrilaterals are half a cell wide.
        let width = 1.0 / f64::from(u32::try_from(kind.order())?);
        let band = CrackBand::new(self.energies(), degradation)?.with_width(width)?;
        band.raising()
            .models(&QuadraturePoints::of(mesh), laminate, build)
    }

    /// The body of a laminate whose supports move by their displacements for a multiplier of one.
    pub(super) fn driven(
        self,
        mesh: &Arc<Mesh>,
        kind: ElementKind,
        laminate: &Laminate,
        supports: impl IntoIterator<Item = Support>,
        (contact, has_bands): (&[usize], bool),
    ) -> Result<Arc<ProgressiveBody>, TaskError> {
        let case = LoadCase {
            moves_supports: true,
            ..LoadCase::default()
        };
        let material: Arc<dyn Material> = Arc::new(laminate.membrane_material()?);
        let materials = vec![material; mesh.blocks().len()];
        let body = ElasticBody::new(Arc::clone(mesh), materials, laminate.thickness())?;
        let body = body.with_supports(supports).with_load_cases(vec![case])?;
        let models = self.models(mesh, kind, laminate, has_bands)?;
        Ok(Arc::new(ProgressiveBody::with_models(
            Arc::new(body),
            contact,
            models,
        )?))
    }
}

pub(super) fn laminate(layup: &str) -> Result<Laminate, TaskError> {
    let strengths = Strengths::in_plane(XT, XC, YT, YC, S12);
    let ply = Ply::new("T300/5208", CONSTANTS, strengths)?;
    Ok(Laminate::new(&layup.parse()?, &ply)?)
}

/// Nodes held in a direction.
pub(super) fn held(nodes: &[usize], direction: HeldDirection, displacement: f64) -> Support {
    Support {
        nodes: nodes.to_vec(),
        direction,
        displacement,
    }
}
