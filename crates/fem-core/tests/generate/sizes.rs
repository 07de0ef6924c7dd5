//! Sizes known before anything is made.

use stickslip_fem_core::generate::{
    CylinderOnBlock, Extent, Generate, GenerateError, MeshEstimate, Outline, Rectangle,
    uniform_angles,
};
use stickslip_fem_core::mesh::{ElementKind, Mesh};

use crate::bodies::{disk, plate};
use crate::{Outcome, fine_at_bearing};

const STRIP: Outline = Outline::Strip {
    half_width: 1.0,
    left: 4.0,
    right: 2.0,
};

fn check_size(estimate: MeshEstimate, meshes: &[&Mesh]) {
    let nodes = meshes.iter().map(|mesh| mesh.nodes().len()).sum();
    let elements = meshes.iter().map(|mesh| mesh.element_count()).sum();
    assert_eq!(estimate, MeshEstimate { nodes, elements });
}

#[test]
fn estimates_are_exact() -> Outcome {
    for kind in ElementKind::ALL {
        for extent in [Extent::Half, Extent::Whole] {
            for angles in [uniform_angles(extent, 14), fine_at_bearing(extent)] {
                for outline in [STRIP, Outline::Ring { outer_radius: 1.0 }] {
                    let body = plate(outline, extent, angles.clone(), kind);
                    check_size(body.estimate()?, &[&body.generate()?]);
                }
                let body = disk(extent, angles, 3, kind);
                check_size(body.estimate()?, &[&body.generate()?]);
            }
            let body = CylinderOnBlock {
                radius: 10.0,
                half_width: 6.0,
                height: 5.0,
                inner: 1.0,
                spacing: 0.21,
                growth: 1.17,
                columns: None,
                extent,
                kind,
            };
            let bodies = body.generate()?;
            check_size(body.estimate()?, &[&bodies.lower, &bodies.upper]);
        }
        let body = Rectangle::uniform([0.0, 1.0], [0.0, 1.0], [4, 7], kind)?;
        check_size(body.estimate()?, &[&body.generate()?]);
    }
    Ok(())
}

#[test]
fn meshes_beyond_the_limit_are_refused_before_they_are_made() -> Outcome {
    let mut body = plate(
        STRIP,
        Extent::Half,
        uniform_angles(Extent::Half, 12),
        ElementKind::Q4,
    );
    let nodes = body.estimate()?.nodes;
    assert!(body.generate_within(nodes).is_ok());
    let error = body
        .generate_within(nodes - 1)
        .expect_err("one node too many");
    assert!(matches!(error, GenerateError::TooLarge { limit, .. } if limit == nodes - 1));
    for layers in [10_000_000, usize::MAX] {
        body.layers = layers;
        assert!(matches!(
            body.generate(),
            Err(GenerateError::TooLarge {
                limit: 50_000_000,
                ..
            })
        ));
        let rings = disk(
            Extent::Whole,
            uniform_angles(Extent::Whole, 16),
            layers,
            ElementKind::T6,
        );
        assert!(matches!(
            rings.generate(),
            Err(GenerateError::TooLarge { .. })
        ));
    }
    Ok(())
}
