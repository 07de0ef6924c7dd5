//! A strip with a weak column of cells: what it bears beyond the failure of that column it bears by what failed plies keep.

use std::sync::Arc;

use stickslip_contact::Chain;
use stickslip_fem_core::generate::{Generate, Rectangle};
use stickslip_fem_core::load::edge_load;
use stickslip_fem_core::mesh::ElementKind;
use stickslip_fem_core::{ElasticBody, HeldDirection, LoadCase, Support};
use stickslip_joint::{
    Ending, Gauge, Halt, Joint, JointBody, JointHistory, Mark, Options, ProgressiveBody, Pull,
};
use stickslip_laminate::degradation::Degradation;
use stickslip_laminate::failure::MaximumStress;
use stickslip_laminate::progressive::{PlyDiscount, PointModel};
use stickslip_laminate::{Ply, Strengths};

use crate::models::{carbon, laminate, strengths};

/// Length and height of the strip `[mm]`, and strength of the weak fibres, in tension and in compression.
const SIZE: [f64; 2] = [12.0, 2.0];
const WEAK: f64 = 500.0;

#[derive(Clone, Copy, PartialEq)]
enum End {
    /// Pulled by this force of a newton.
    Loaded(f64),
    /// Moved by 1 mm.
    Driven,
}

/// Fibres along x; in the middle one of `columns` columns they are weak, and when broken they keep the part `kept`.
fn history(kind: ElementKind, columns: usize, kept: f64, end: End, most: f64) -> JointHistory {
    let cells = [columns, 2];
    let mesh = Rectangle::uniform([0.0, SIZE[0]], [0.0, SIZE[1]], cells, kind)
        .unwrap()
        .generate()
        .unwrap();
    let mesh = Arc::new(mesh);
    let strong = strengths(1e6);
    let weak = Strengths {
        xt: Some(WEAK),
        xc: Some(WEAK),
        ..strong
    };
    let model = |strengths| -> Arc<dyn PointModel> {
        let ply = Ply::new("ply", *carbon().constants(), strengths).unwrap();
        let degradation = Degradation::new(kept, kept).unwrap();
        Arc::new(
            PlyDiscount::new(
                laminate("[0_4]", &ply),
                Box::new(MaximumStress),
                degradation,
            )
            .unwrap(),
        )
    };
    let [strong, weak] = [model(strong), model(weak)];
    let width = SIZE[0] / columns as f64;
    let models = (0..mesh.element_count()).map(|cell| {
        let (_, nodes, _) = mesh.element(cell);
        let mean =
            nodes.iter().map(|&node| mesh.nodes()[node][0]).sum::<f64>() / nodes.len() as f64;
        let middle = (mean - 0.5 * SIZE[0]).abs() < 0.5 * width;
        Arc::clone(if middle { &weak } else { &strong })
    });
    let models: Vec<_> = models.collect();
    let whole = strong.laminate();
    let thickness = whole.thickness();
    let set = |name: &str| mesh.node_set(name).unwrap().to_vec();
    let hold = |name: &str, direction, displacement| Support {
        nodes: set(name),
        direction,
        displacement,
    };
    let mut supports = vec![
        hold("left", HeldDirection::X, 0.0),
        hold("bottom", HeldDirection::Y, 0.0),
    ];
    let case = match end {
        End::Loaded(force) => LoadCase {
            forces: edge_load(
                &mesh,
                &mesh.edge_set("right").unwrap().edges,
                thickness,
                |_| [force / (thickness * SIZE[1]), 0.0],
            ),
            ..LoadCase::default()
        },
        End::Driven => {
            supports.push(hold("right", HeldDirection::X, 1.0));
            LoadCase {
                moves_supports: true,
                ..LoadCase::default()
            }
        }
    };
    let material = Arc::new(whole.membrane_material().unwrap());
    let body = ElasticBody::new(Arc::clone(&mesh), vec![material], thickness)
        .unwrap()
        .with_supports(supports)
        .with_load_cases(vec![case])
        .unwrap();
    let body = ProgressiveBody::with_models(Arc::new(body), &[], models).unwrap();
    let gauge = Gauge {
        pull: Pull::Supports { body: 0 },
        multiple: 1.0,
        direction: [1.0, 0.0],
        first: Mark::Node {
            body: 0,
            node: set("right")[0],
        },
        second: Mark::Fixed,
        free_travel: 0.0,
    };
    let options = Options {
        increments: 10,
        ..Options::default()
    };
    Joint::new(vec![JointBody::Progressive(Arc::new(body))], vec![], gauge)
        .unwrap()
        .with_options(options)
        .unwrap()
        .follow(&[vec![most]], &Chain::newton_first(), |_, _| {})
        .unwrap()
}

/// Force `[N]` under which the weak fibres have their strength: they lie along the load, and the strip is free to contract.
fn exact() -> f64 {
    WEAK * SIZE[1] * laminate("[0_4]", &carbon()).thickness()
}

/// The strength is that of the section, whatever the size of its cells and the part that broken fibres keep.
#[test]
fn a_severed_strip_has_the_strength_of_its_section() {
    let meshes = [
        (ElementKind::Q4, 5),
        (ElementKind::Q8, 5),
        (ElementKind::Q8, 21),
    ];
    for (kind, columns) in meshes {
        for kept in [0.5, 0.1, 0.01, 1e-4] {
            let name = format!("{kind:?}, {columns} columns, {kept} kept");
            let loaded = history(kind, columns, kept, End::Loaded(1.0), 3.0 * exact());
            let Ending::NoEquilibrium {
                cause: Halt::Severed,
                ..
            } = loaded.ending
            else {
                panic!("{name}: {:?}", loaded.ending);
            };
            // A tenth of the load is an increment, cut to a 256th.
            let strength = loaded.records.last().unwrap().multipliers[0];
            assert!(
                (0.0..=3.0 / 2560.0).contains(&(1.0 - strength / exact())),
                "{name}: {strength} for {}",
                exact()
            );
            let driven = history(kind, columns, kept, End::Driven, 0.2);
            let strength = driven.strength().unwrap();
            assert!(
                (strength / exact() - 1.0).abs() < 1.001e-3,
                "{name}: {strength} for {}",
                exact()
            );
            assert!(
                matches!(
                    driven.ending,
                    Ending::Severed { .. } | Ending::LoadDropped { .. }
                ),
                "{name}: {:?}",
                driven.ending
            );
        }
    }
}

/// Crushed material is pressed together, and severs nothing.
#[test]
fn a_crushed_strip_holds() {
    let history = history(ElementKind::Q8, 5, 0.1, End::Loaded(-1.0), 3.0 * exact());
    assert!(history.first_failure().is_some());
    assert!(
        matches!(history.ending, Ending::Completed),
        "{:?}",
        history.ending
    );
}
