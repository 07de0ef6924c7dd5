//! Gauss–Lobatto cells of every order: patch test, convergence at the full order, and Lamé's ring near rounding.

use std::f64::consts::{FRAC_PI_2, PI};
use std::sync::Arc;

use stickslip_fem_core::generate::{
    Extent, Generate, Growth, Outline, PlateWithHole, uniform_angles,
};
use stickslip_fem_core::load::edge_load;
use stickslip_fem_core::material::{Isotropic, Material, PlaneState};
use stickslip_fem_core::mesh::{Curve, ElementKind, Mesh};
use stickslip_fem_core::stress::{EdgeData, PathEnd, PathEnds, edge_stresses};
use stickslip_fem_core::{ElasticBody, HeldDirection, LoadCase, Support};

use crate::fields::{Field, THICKNESS, both, driven, kolosov, lekhnitskii, linear, materials, ply};
use crate::manufactured::{solve, swayed};
use crate::meshes::{SIDES, side_nodes};

const ALL: [ElementKind; 8] = [
    ElementKind::P1,
    ElementKind::P2,
    ElementKind::P3,
    ElementKind::P4,
    ElementKind::P5,
    ElementKind::P6,
    ElementKind::P7,
    ElementKind::P8,
];

fn solved(body: &Arc<ElasticBody>) -> Vec<f64> {
    body.condense(&[]).unwrap().displacements(&[], &[1.0], &[])
}

fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |m, v| m.max(v.abs()))
}

#[test]
fn linear_fields_return_on_curved_cells() {
    let free = ["bottom", "right", "top"];
    for kind in ALL {
        let mesh = swayed(kind, 3);
        for (k, material) in materials().iter().enumerate() {
            let field = linear(&material.stiffness());
            let exact = field.at_nodes(&mesh);
            for (held, pulled) in [(&SIDES[..], &[][..]), (&["left"], &free)] {
                let held = both(&side_nodes(&mesh, held));
                let body = driven(mesh.clone(), Arc::clone(material), &field, &held, pulled);
                for (a, b) in solved(&body).iter().zip(&exact) {
                    // Rounding times the condition of a body of a few hundred nodes, below 1e5.
                    let error = (a - b).abs() / largest(&exact);
                    assert!(error < 1e-11, "{kind:?}, material {k}: {error:.1e}");
                }
            }
        }
    }
}

/// Errors fall with h^{p+1} in L² and h^p in energy, and are bounded by those of the interpolant as in `manufactured`.
fn study(kind: ElementKind, cells: [usize; 2], material: &Arc<dyn Material>, field: &Field) {
    let order = kind.order() as f64;
    let [coarse, fine] = cells.map(|cells| solve(swayed(kind, cells), material, field));
    let halvings = (cells[1] as f64 / cells[0] as f64).log2();
    let l2 = (coarse[0].l2 / fine[0].l2).log2() / halvings;
    let energy = (coarse[0].energy / fine[0].energy).log2() / halvings;
    assert!((l2 - order - 1.0).abs() < 0.3, "{kind:?}: L² order {l2:.3}");
    assert!(
        (energy - order).abs() < 0.3,
        "{kind:?}: energy order {energy:.3}"
    );
    let [found, interpolant] = fine;
    assert!(
        found.energy < 1.01 * interpolant.energy,
        "{kind:?}: {fine:?}"
    );
    assert!(found.l2 < 3.0 * interpolant.l2, "{kind:?}: {fine:?}");
}

/// Cells along a side that are small beside the wave of the map and leave errors above rounding. Few cells of high order catch the
/// wave better in even numbers than in odd ones, which is what the 0.3 of the rates is for.
const CELLS: [[usize; 2]; 8] = [
    [16, 32],
    [16, 32],
    [12, 24],
    [8, 16],
    [8, 12],
    [6, 10],
    [6, 8],
    [4, 8],
];

#[test]
fn isotropic_plane_strain_converges_at_the_full_order() {
    let (young, poisson, state) = (70.0, 0.33, PlaneState::Strain);
    let material: Arc<dyn Material> = Arc::new(Isotropic::new(young, poisson, state).unwrap());
    for (kind, cells) in ALL.into_iter().zip(CELLS) {
        study(kind, cells, &material, &kolosov(young, poisson, state));
    }
}

#[test]
fn a_ply_at_an_angle_converges_at_the_full_order() {
    let material = ply(0.5);
    for (kind, cells) in ALL.into_iter().zip(CELLS).skip(2).step_by(2) {
        study(kind, cells, &material, &lekhnitskii(material.as_ref()));
    }
}

const INNER: f64 = 1.0;
const OUTER: f64 = 2.0;

/// Lamé's ring under the pressure 1 inside: u_r = A r + B / r, σ_θθ = p a² (1 + b²/r²)/(b² − a²), in plane stress.
fn lame(young: f64, poisson: f64, r: f64) -> [f64; 2] {
    let scale = INNER * INNER / (OUTER * OUTER - INNER * INNER);
    let u = scale / young * ((1.0 - poisson) * r + (1.0 + poisson) * OUTER * OUTER / r);
    [u, scale * (1.0 + OUTER * OUTER / (r * r))]
}

/// Largest errors of the displacement and of the hoop stress at the hole, of the half ring with `cells` along the hole.
fn ring_errors(kind: ElementKind, cells: usize) -> [f64; 2] {
    let mesh = PlateWithHole {
        hole_radius: INNER,
        outline: Outline::Ring {
            outer_radius: OUTER,
        },
        extent: Extent::Half,
        angles: uniform_angles(Extent::Half, cells),
        layers: cells / 4,
        growth: Growth::Geometric { aspect: 1.0 },
        far_cells: 1,
        kind,
    };
    let mesh = mesh.generate().unwrap();
    let (young, poisson) = (70.0, 0.3);
    let material = Isotropic::new(young, poisson, PlaneState::Stress).unwrap();
    let symmetry = mesh.node_set("symmetry").unwrap().to_vec();
    let on_axis = |p: &[f64; 2]| p[0].abs() < 1e-12;
    let across: Vec<usize> = (0..mesh.nodes().len())
        .filter(|&node| on_axis(&mesh.nodes()[node]))
        .collect();
    let supports = [(symmetry, HeldDirection::Y), (across, HeldDirection::X)];
    let supports = supports.map(|(nodes, direction)| Support {
        nodes,
        direction,
        displacement: 0.0,
    });
    let hole = mesh.edge_set("hole").unwrap().edges.clone();
    let load = LoadCase {
        forces: edge_load(&mesh, &hole, THICKNESS, |at| at.normal.map(|n| -n)),
        ..LoadCase::default()
    };
    let shared: Arc<dyn Material> = Arc::new(material);
    let body = ElasticBody::new(Arc::new(mesh.clone()), vec![Arc::clone(&shared)], THICKNESS);
    let body = body
        .unwrap()
        .with_supports(supports)
        .with_load_cases(vec![load]);
    let u = solved(&Arc::new(body.unwrap()));
    let radial = mesh.nodes().iter().enumerate().map(|(node, &[x, y])| {
        let r = x.hypot(y);
        let [exact, _] = lame(young, poisson, r);
        let found = (u[2 * node] * x + u[2 * node + 1] * y) / r;
        (found - exact).abs() / exact
    });
    let displacement = radial.fold(0.0, f64::max);
    [
        displacement,
        hoop_error(&mesh, &u, shared.as_ref(), lame(young, poisson, INNER)[1]),
    ]
}

fn hoop_error(mesh: &Mesh, u: &[f64], material: &dyn Material, exact: f64) -> f64 {
    let walk = mesh.counter_clockwise(&mesh.edge_path("hole").unwrap(), [0.0; 2]);
    let angles = mesh.angles(&walk, [0.0; 2]);
    let count = walk.nodes.len();
    let displacement: Vec<[f64; 2]> = (walk.nodes.iter())
        .map(|&node| [u[2 * node], u[2 * node + 1]])
        .collect();
    let normals: Vec<[f64; 2]> = angles.iter().map(|a| [a.cos(), a.sin()]).collect();
    let edge = EdgeData {
        order: walk.order,
        ends: PathEnds::Open([PathEnd::Mirror { axis: [1.0, 0.0] }; 2]),
        parameter: &angles.iter().map(|angle| INNER * angle).collect::<Vec<_>>(),
        place: &normals,
        displacement: &displacement,
        normal: &normals,
        normal_stress: &vec![-1.0; count],
        shear_stress: &vec![0.0; count],
    };
    let stresses = edge_stresses(&edge, material, [0.0; 3]).unwrap();
    let errors = stresses
        .iter()
        .map(|s| (s.tangential - exact).abs() / exact);
    errors.fold(0.0, f64::max)
}

/// 24 cells of order 8 over half a ring: displacements to rounding, the hoop stress to what its derivative leaves of it.
#[test]
fn lames_ring_is_exact_nearly_to_rounding() {
    let [displacement, stress] = ring_errors(ElementKind::P8, 12);
    assert!(displacement < 1e-11, "{displacement:.1e}");
    assert!(stress < 1e-9, "{stress:.1e}");
    // Of as many nodes along the hole, Q8 is some 10⁶ times as far off.
    let [plain, _] = ring_errors(ElementKind::Q8, 48);
    assert!(plain > 1e4 * displacement, "{plain:.1e}");
}

/// Lobatto's weights share the arc exactly, and the isoparametric edges nearly so.
#[test]
fn weights_of_an_arc_are_those_of_lobatto() {
    for kind in ALL {
        let ring = PlateWithHole {
            hole_radius: INNER,
            outline: Outline::Ring {
                outer_radius: OUTER,
            },
            extent: Extent::Whole,
            angles: uniform_angles(Extent::Whole, 12),
            layers: 2,
            growth: Growth::Geometric { aspect: 1.0 },
            far_cells: 1,
            kind,
        };
        let mesh = ring.generate().unwrap();
        let path = mesh.edge_path("hole").unwrap();
        for &node in &path.nodes {
            let [x, y] = mesh.nodes()[node];
            assert!((x.hypot(y) - INNER).abs() < 1e-15);
        }
        let curve = Some(Curve::Arc {
            centre: [0.0; 2],
            radius: INNER,
        });
        let exact = mesh.edge_weights(&path, curve);
        assert!((exact.iter().sum::<f64>() - 2.0 * PI).abs() < 1e-13);
        assert!(exact.iter().all(|&weight| weight > 0.0));
        // The length of a chord lacks (Δθ)²/24 of the arc's; each order takes two powers more.
        let lacking = (FRAC_PI_2 / 3.0_f64).powi(2 * kind.order() as i32) / 24.0;
        let found = mesh.edge_weights(&path, None);
        assert!(
            (found.iter().sum::<f64>() / (2.0 * PI) - 1.0).abs() < lacking + 1e-14,
            "{kind:?}"
        );
    }
}
