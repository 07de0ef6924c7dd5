//! Thermal strain: free bodies expand without stress, held ones are stressed without expanding.

use std::sync::Arc;

use stickslip_fem_core::material::{Isotropic, Material, Orthotropic, OutOfPlane, PlaneState};
use stickslip_fem_core::mesh::{ElementKind, Mesh};
use stickslip_fem_core::stress::ElasticField;
use stickslip_fem_core::{ElasticBody, HeldDirection, LoadCase, Support};

use crate::fields::{PLY, THICKNESS};
use crate::meshes::{Distortion, rectangle, scattered, side_nodes};
use crate::reference::{largest, rigid_motions, without};

/// Relative to the stress of a fully clamped body.
const ROUNDING: f64 = 1e-12;
const HEATING: f64 = 120.0;
const ALPHA: f64 = 23e-6;
const YOUNG: f64 = 70.0;

fn expanding() -> [Arc<dyn Material>; 4] {
    let isotropic = |state| {
        Isotropic::new(YOUNG, 0.33, state)
            .unwrap()
            .with_expansion(ALPHA)
            .unwrap()
    };
    let across = OutOfPlane {
        e3: 10.3,
        nu13: 0.28,
        nu23: 0.5,
        alpha3: 22.5e-6,
    };
    let ply = Orthotropic::new(PLY, 0.5).unwrap();
    let thick = Orthotropic::plane_strain(PLY, across, -1.1).unwrap();
    [
        Arc::new(isotropic(PlaneState::Stress)),
        Arc::new(isotropic(PlaneState::Strain)),
        Arc::new(ply.with_expansion(0.02e-6, 22.5e-6).unwrap()),
        Arc::new(thick.with_expansion(0.02e-6, 22.5e-6).unwrap()),
    ]
}

/// Displacements and Gauss-point stresses of a body that is heated.
fn heated(
    mesh: Mesh,
    material: &Arc<dyn Material>,
    held: &[(&str, HeldDirection)],
) -> (Vec<f64>, Vec<[f64; 3]>) {
    let strain = vec![material.thermal_strain(HEATING)];
    let case = LoadCase {
        initial_strain: strain.clone(),
        ..LoadCase::default()
    };
    let supports: Vec<Support> = held
        .iter()
        .map(|&(side, direction)| Support {
            nodes: side_nodes(&mesh, &[side]),
            direction,
            displacement: 0.0,
        })
        .collect();
    let body = ElasticBody::new(Arc::new(mesh), vec![Arc::clone(material)], THICKNESS).unwrap();
    let body = Arc::new(
        body.with_supports(supports)
            .with_load_cases(vec![case])
            .unwrap(),
    );
    let condensed = body.condense(&[]).unwrap();
    let motions = vec![0.0; if held.is_empty() { 3 } else { 0 }];
    let u = condensed.displacements(&[], &[1.0], &motions);
    assert_eq!(body.initial_strain(&[1.0]), strain);
    let materials = [material.as_ref()];
    let field = ElasticField::new(body.mesh(), &materials, &u, Some(&strain)).unwrap();
    let stress = field.gauss_stresses().values().to_vec();
    (u, stress)
}

#[test]
fn free_bodies_expand_without_stress() {
    for kind in ElementKind::COMMON {
        for material in expanding() {
            let mesh = scattered(kind, Distortion::Curved, 13);
            let nodes = mesh.nodes().to_vec();
            let (u, stress) = heated(mesh, &material, &[]);
            let [xx, yy, xy] = material.thermal_strain(HEATING);
            let expected = nodes
                .iter()
                .flat_map(|&[x, y]| [xx * x + xy * y / 2.0, yy * y + xy * x / 2.0]);
            let difference: Vec<f64> = u.iter().zip(expected).map(|(a, b)| a - b).collect();
            let strange = without(&rigid_motions(&nodes), &difference.into());
            let strain = largest(&[xx, yy, xy]);
            assert!(strange.amax() < ROUNDING * strain, "{kind:?}");
            let clamped = largest(material.stiffness().as_flattened()) * strain;
            assert!(
                largest(stress.as_flattened()) < 10.0 * ROUNDING * clamped,
                "{kind:?}"
            );
        }
    }
}

#[test]
fn a_bar_between_walls_is_compressed() {
    let material: Arc<dyn Material> = expanding()[0].clone();
    let held = [
        ("left", HeldDirection::X),
        ("right", HeldDirection::X),
        ("bottom", HeldDirection::Y),
    ];
    for kind in ElementKind::COMMON {
        let mesh = rectangle(kind, [0.0, 2.0], [0.0, 1.0], [4, 2]);
        let (_, stress) = heated(mesh, &material, &held);
        let expected = [-YOUNG * ALPHA * HEATING, 0.0, 0.0];
        for (found, expected) in stress.iter().flat_map(|s| s.iter().zip(expected)) {
            assert!((found - expected).abs() < 10.0 * ROUNDING * YOUNG * ALPHA * HEATING);
        }
    }
}

/// Clamped all around, every material carries −D ε₀; isotropic in plane strain that is −E α ΔT/(1 − 2ν).
#[test]
fn a_clamped_body_carries_all_of_it() {
    let sides = crate::meshes::SIDES;
    let held: Vec<_> = sides
        .iter()
        .flat_map(|&side| [(side, HeldDirection::X), (side, HeldDirection::Y)])
        .collect();
    for kind in ElementKind::COMMON {
        for (k, material) in expanding().iter().enumerate() {
            let mesh = scattered(kind, Distortion::Curved, 13);
            let (u, stress) = heated(mesh, material, &held);
            let strain = material.thermal_strain(HEATING);
            let expected =
                stickslip_fem_core::material::apply(&material.stiffness(), strain).map(|s| -s);
            let scale = largest(&expected);
            assert!(largest(&u) < ROUNDING * largest(&strain));
            for (found, expected) in stress.iter().flat_map(|s| s.iter().zip(expected)) {
                assert!(
                    (found - expected).abs() < 10.0 * ROUNDING * scale,
                    "{kind:?}"
                );
            }
            if k == 1 {
                let formula = -YOUNG * ALPHA * HEATING / (1.0 - 2.0 * 0.33);
                assert!((expected[0] - formula).abs() < ROUNDING * scale);
            }
        }
    }
}
