//! Estimates and limits of size.

use std::collections::BTreeMap;

use stickslip_fem_core::generate::{Extent, Generate, GenerateError, uniform_angles};
use stickslip_fem_core::mesh::ElementKind;
use stickslip_mesher::{ContourError, ContourMesh, Division};

use crate::shapes::{all, of_kind, strip};

/// Estimates are near what comes out, and rather above it.
#[test]
fn estimates_are_near() {
    for (name, contour) in all() {
        for kind in [ElementKind::T3, ElementKind::T6] {
            let description = of_kind(contour.clone(), kind);
            let estimate = description.estimate().expect("an estimate");
            let mesh = description.generate().expect("a mesh");
            let ratios = [
                estimate.nodes as f64 / mesh.nodes().len() as f64,
                estimate.elements as f64 / mesh.element_count() as f64,
            ];
            // A body of few cells has an uncertain number of them.
            let least = if mesh.element_count() < 500 { 0.8 } else { 1.0 };
            assert!(
                ratios.iter().all(|r| (least..1.5).contains(r)),
                "{name} {kind:?}: {ratios:?}"
            );
        }
    }
}

#[test]
fn the_limit_is_exact() {
    for kind in [ElementKind::T3, ElementKind::T6] {
        let description = of_kind(strip(), kind);
        let nodes = description.generate().expect("a mesh").nodes().len();
        let within = description.generate_within(nodes).expect("a mesh");
        assert_eq!(within.nodes().len(), nodes);
        let error = description.generate_within(nodes - 1);
        let too_large =
            matches!(error, Err(GenerateError::TooLarge { limit, .. }) if limit == nodes - 1);
        assert!(too_large, "{kind:?}: {error:?}");
    }
}

/// A limit passed during refinement is reported as the limit of all nodes.
#[test]
fn the_limit_reported_is_the_one_given() {
    let description = of_kind(strip(), ElementKind::T6);
    let estimate = description.estimate().expect("an estimate").nodes;
    for limit in [estimate / 3, 100, 0] {
        let error = description.mesh(limit).expect_err("a refusal");
        let ContourError::TooLarge {
            nodes,
            limit: given,
        } = error
        else {
            panic!("{error}");
        };
        assert!(given == limit && nodes > limit, "{nodes} {given}");
    }
}

/// Twice as many nodes on holes and twice the fineness give four times as many cells.
#[test]
fn twice_the_fineness_halves_every_cell() {
    for (name, contour) in all() {
        let count = |times: usize| {
            let mut contour = contour.clone();
            for hole in &mut contour.holes {
                hole.angles = uniform_angles(Extent::Whole, times * hole.angles.len());
            }
            let division = Division {
                fineness: times as f64,
                ..Division::default()
            };
            let mesh = ContourMesh { contour, division }.generate();
            mesh.expect("a mesh").element_count() as f64
        };
        let ratio = count(4) / count(2);
        assert!((3.2..4.5).contains(&ratio), "{name}: {ratio}");
    }
}

#[test]
fn fineness_is_positive_and_keeps_the_growth() {
    for fineness in [0.0, -1.0, f64::NAN, f64::INFINITY, 0.2] {
        let division = Division {
            fineness,
            ..Division::default()
        };
        let contour = strip();
        let refusal = ContourMesh { contour, division }.estimate().err();
        assert!(refusal.is_some(), "{fineness}");
    }
}

/// What is far too fine is refused before it is begun.
#[test]
fn hopeless_spacings_are_refused() {
    let coarse = Division::default();
    let fine = BTreeMap::from([(3, 1e12)]);
    for division in [
        Division {
            spacing: Some(1e-9),
            ..coarse.clone()
        },
        Division {
            refined: fine,
            ..coarse
        },
    ] {
        let mesh = ContourMesh {
            contour: strip(),
            division,
        };
        assert!(matches!(
            mesh.mesh(50_000_000),
            Err(ContourError::TooLarge { .. })
        ));
        assert!(mesh.estimate().expect("an estimate").nodes > 50_000_000);
    }
}
