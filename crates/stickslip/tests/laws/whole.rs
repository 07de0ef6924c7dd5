//! The whole plate under its remote load against the truth and the localized analysis.

use std::f64::consts::PI;
use std::sync::Arc;

use stickslip::experiment::whole::{WholeError, WholePlate, WholeSolution};
use stickslip_fem_core::ElasticBody;
use stickslip_fem_core::material::{Isotropic, Material, PlaneState};
use stickslip_fem_core::mesh::ElementKind;
use stickslip_hybrid::identify::Tractions;
use stickslip_hybrid::region::Region;
use stickslip_hybrid::region::fit::{Amount, Smoothing};
use stickslip_hybrid::region::outputs::EdgeRows;
use stickslip_hybrid::region::sector::ArcSector;

use crate::common::{RADIUS, aluminium, measured_fields, scene, window};

const SMOOTHING: Smoothing = Smoothing {
    order: 3,
    amount: Amount::CrossValidated { share: 0.4 },
};
/// Where the plate slips at 1980 lbf on one side of the hole `[deg]`.
const SLIP: [f64; 2] = [32.0, 78.0];

/// The coefficient in the slip zone; friction pulls against e_θ where θ > 0.
fn slip(angle: &[f64], tractions: &Tractions) -> stickslip_hybrid::identify::SlipFit {
    let within = |&k: &usize| (SLIP[0]..SLIP[1]).contains(&angle[k].to_degrees());
    let places: Vec<usize> = (0..angle.len()).filter(within).collect();
    tractions
        .slip(places[0]..places[places.len() - 1] + 1, false)
        .unwrap()
}

#[test]
fn the_whole_plate_balances_its_load_and_tells_the_friction_of_the_truth() {
    let truth = aluminium(1.125);
    let overrides = ["mesh.spacing=\"4.5 deg\"", "mesh.coarse_spacing=\"9 deg\""];
    let plate = WholePlate::new(&scene("pin-loaded-aluminium", &overrides)).unwrap();
    let places = window(20.0, 0.7, 0.1);
    let law = Arc::clone(truth.own_law());
    let data = measured_fields(&truth, law, &[6], &places, 0.25, 1).remove(0);
    let found: WholeSolution = plate.analyse(&data, 6, None, SMOOTHING).unwrap();
    // 1980 lbf; the reactions of a solved plate balance the load to rounding.
    let load = 1980.0 * 4.448_221_615_260_5;
    assert!((found.load[0] + load).abs() < 1e-6 * load);
    for axis in 0..2 {
        assert!((found.force[axis] + found.load[axis]).abs() < 1e-9 * load);
    }
    let (residual, count, parameters) = found.fit;
    let reduced = residual / (count as f64 - parameters);
    assert!((reduced - 1.0).abs() < 0.06, "{reduced}");
    let whole = slip(&found.angle, &found.tractions);

    // The localized analysis of the same data: a half ring whose every side is measured.
    let sector = ArcSector {
        centre: [0.0, 0.0],
        hole: RADIUS,
        stand_off: 0.0,
        outer: 17.0,
        angles: [0.0, 0.5 * PI],
        cells: [20, 6],
        growth: 1.5,
        kind: ElementKind::Q8,
    };
    let stiffness: Arc<dyn Material> =
        Arc::new(Isotropic::new(71_705.5, 0.33, PlaneState::Stress).unwrap());
    let mesh = Arc::new(sector.mesh().unwrap());
    let body = Arc::new(ElasticBody::new(mesh, vec![stiffness], 1.524).unwrap());
    let region = Region::new(&body, &[]).unwrap();
    let fit = region.fit(&data, SMOOTHING).unwrap();
    let edge = EdgeRows::new(&body, "inner").unwrap();
    let rows: Vec<_> = [0, 2]
        .into_iter()
        .flat_map(|part| edge.component(part))
        .collect();
    let stresses = region.propagate(&rows, &fit.displacements).unwrap();
    let half = edge.nodes.len();
    let localized = Tractions {
        pressure: stresses.values[..half].iter().map(|s| -s).collect(),
        shear: stresses.values[half..].iter().map(|s| -s).collect(),
        covariance: stresses.covariance,
    };
    let angle: Vec<f64> = edge.parameter.iter().map(|s| s / RADIUS).collect();
    let local = slip(&angle, &localized);
    println!(
        "whole {:?} χ² {} of {}; localized {:?} χ² {} of {}",
        (whole.mu, whole.bounds),
        whole.chi_squared,
        whole.degrees,
        (local.mu, local.bounds),
        local.chi_squared,
        local.degrees
    );
    assert!((whole.mu - 0.25).abs() < 0.01);
    assert!((local.mu - 0.25).abs() < 0.015);
    assert!((whole.mu - local.mu).abs() < 0.015);
}

#[test]
fn a_plate_that_a_support_holds_is_refused() {
    let mut own = scene("pin-loaded-aluminium", &[]);
    own.body = "pin".to_owned();
    own.edge = "rim".to_owned();
    let refused = WholePlate::new(&own).unwrap_err();
    assert!(matches!(&refused, WholeError::Held { body } if body == "pin"));
}
