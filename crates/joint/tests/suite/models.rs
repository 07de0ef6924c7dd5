//! Plies, laminates and point models that the tests share. Units: mm, N, MPa.

use std::sync::Arc;

use stickslip_laminate::degradation::Degradation;
use stickslip_laminate::failure::MaximumStress;
use stickslip_laminate::progressive::{PlyDiscount, PointModel, TsaiHillPlasticity};
use stickslip_laminate::{Laminate, Layup, Ply, PlyConstants, Strengths};

/// T300/5208 (Tsai & Hahn 1980), its strengths in MPa.
pub(crate) fn carbon() -> Ply {
    let constants = PlyConstants {
        e1: 181_000.0,
        e2: 10_300.0,
        g12: 7_170.0,
        nu12: 0.28,
        alpha1: 0.02e-6,
        alpha2: 22.5e-6,
        thickness: 0.125,
    };
    Ply::new("T300/5208", constants, strengths(1.0)).unwrap()
}

/// The strengths, times `factor`.
pub(crate) fn strengths(factor: f64) -> Strengths {
    Strengths {
        xt: Some(1500.0 * factor),
        xc: Some(1500.0 * factor),
        yt: Some(40.0 * factor),
        yc: Some(246.0 * factor),
        s12: Some(68.0 * factor),
        ..Strengths::default()
    }
}

pub(crate) fn laminate(layup: &str, ply: &Ply) -> Laminate {
    let layup: Layup = layup.parse().unwrap();
    Laminate::new(&layup, ply).unwrap()
}

/// Ply discount by maximum stress; broken fibres keep a hundredth, broken matrix a tenth.
pub(crate) fn discount(layup: &str) -> Arc<dyn PointModel> {
    let degradation = Degradation::new(0.01, 0.1).unwrap();
    let laminate = laminate(layup, &carbon());
    Arc::new(PlyDiscount::new(laminate, Box::new(MaximumStress), degradation).unwrap())
}

/// Plies too strong to fail.
pub(crate) fn unbreakable(layup: &str) -> Arc<dyn PointModel> {
    let ply = Ply::new("strong", *carbon().constants(), strengths(1e6)).unwrap();
    let degradation = Degradation::new(0.1, 0.1).unwrap();
    let laminate = laminate(layup, &ply);
    Arc::new(PlyDiscount::new(laminate, Box::new(MaximumStress), degradation).unwrap())
}

/// Elastic–plastic plies.
pub(crate) fn plastic(layup: &str, hardening: f64) -> Arc<dyn PointModel> {
    let laminate = laminate(layup, &carbon());
    Arc::new(TsaiHillPlasticity::new(laminate, hardening).unwrap())
}
