//! Gauss values, nodal extrapolation, patch recovery.

use stickslip_fem_core::material::{Material, Orthotropic, OrthotropicConstants, apply};
use stickslip_fem_core::mesh::{ElementKind, Mesh, Point};
use stickslip_fem_core::stress::{ElasticField, StressError};

use crate::meshes::{mapped, sampled};
use crate::{kirsch, rates};

fn ply() -> Orthotropic {
    let ply = OrthotropicConstants {
        e1: 18.1,
        e2: 1.03,
        g12: 0.717,
        nu12: 0.28,
    };
    Orthotropic::new(ply, 0.5)
        .unwrap()
        .with_expansion(1e-3, 2e-2)
        .unwrap()
}

fn skewed([x, y]: Point) -> Point {
    [2.0 * x + 0.3 * y + 0.2 * x * y, y - 0.4 * x + 0.1 * x * y]
}

fn stretched([x, y]: Point) -> Point {
    [2.0 * x, 0.05 * y]
}

fn linear([x, y]: Point) -> [f64; 2] {
    [0.1 + 0.3 * x - 0.2 * y, 0.4 * x + 0.5 * y]
}

/// Displacement of degree two and its strain.
fn quadratic([x, y]: Point) -> [f64; 2] {
    [
        0.3 * x * x - 0.2 * x * y + 0.1 * y * y,
        0.2 * x * x + 0.4 * x * y - 0.5 * y * y,
    ]
}

fn quadratic_strain([x, y]: Point) -> [f64; 3] {
    [
        0.6 * x - 0.2 * y,
        0.4 * x - y,
        -0.2 * x + 0.2 * y + 0.4 * x + 0.4 * y,
    ]
}

/// Displacement of degree three and its strain.
fn cubic([x, y]: Point) -> [f64; 2] {
    [
        x.powi(3) - x * y * y,
        y.powi(3) + 0.5 * x * x * y - x.powi(3),
    ]
}

fn cubic_strain([x, y]: Point) -> [f64; 3] {
    [
        3.0 * x * x - y * y,
        3.0 * y * y + 0.5 * x * x,
        -2.0 * x * y + x * y - 3.0 * x * x,
    ]
}

fn largest_error(values: &[[f64; 3]], exact: impl Fn(usize) -> [f64; 3]) -> f64 {
    let differences = values.iter().enumerate().flat_map(|(k, value)| {
        let exact = exact(k);
        (0..3).map(move |i| (value[i] - exact[i]).abs())
    });
    differences.fold(0.0, f64::max)
}

#[test]
fn linear_displacements_give_their_stress_everywhere() {
    let material = ply();
    let expected = apply(&material.stiffness(), [0.3, 0.5, 0.2]);
    for kind in ElementKind::COMMON {
        let mesh = mapped(kind, [4, 3], skewed);
        let u = sampled(&mesh, linear);
        let materials: [&dyn Material; 1] = [&material];
        let field = ElasticField::new(&mesh, &materials, &u, None).unwrap();
        let gauss = field.gauss_stresses();
        assert_eq!(gauss.element_count(), mesh.element_count());
        for values in [
            gauss.values(),
            &field.nodal_stresses().averaged(),
            &field.patch_recovery().averaged(),
        ] {
            assert!(largest_error(values, |_| expected) < 1e-12, "{kind:?}");
        }
    }
}

#[test]
fn quadratic_displacements_are_recovered_at_every_node_of_quadratic_cells() {
    let material = ply();
    for kind in [ElementKind::T6, ElementKind::Q8, ElementKind::Q9] {
        let map = |[x, y]: Point| [2.0 * x + 0.3 * y, y - 0.4 * x];
        let mesh = mapped(kind, [4, 3], map);
        let u = sampled(&mesh, quadratic);
        let materials: [&dyn Material; 1] = [&material];
        let field = ElasticField::new(&mesh, &materials, &u, None).unwrap();
        let exact = |k: usize| apply(&material.stiffness(), quadratic_strain(mesh.nodes()[k]));
        assert!(
            largest_error(&field.nodal_stresses().averaged(), exact) < 1e-11,
            "{kind:?}"
        );
        assert!(
            largest_error(&field.patch_recovery().averaged(), exact) < 1e-11,
            "{kind:?}"
        );
    }
}

/// On rectangles the interpolant of a cubic has the exact stress at the 2×2 points, a quadratic, which the patches fit.
/// Cells of aspect ratio 53 do not disturb the fit.
#[test]
fn cubic_displacements_are_recovered_exactly_on_rectangular_q8_and_q9() {
    let material = ply();
    for kind in [ElementKind::Q8, ElementKind::Q9] {
        let mesh = mapped(kind, [3, 4], stretched);
        let u = sampled(&mesh, cubic);
        let materials: [&dyn Material; 1] = [&material];
        let field = ElasticField::new(&mesh, &materials, &u, None).unwrap();
        let exact = |k: usize| apply(&material.stiffness(), cubic_strain(mesh.nodes()[k]));
        assert!(
            largest_error(&field.patch_recovery().averaged(), exact) < 1e-9,
            "{kind:?}"
        );
    }
}

#[test]
fn initial_strain_is_not_stress() {
    let material = ply();
    let initial = [material.thermal_strain(40.0)];
    let [xx, yy, xy] = initial[0];
    let mesh = mapped(ElementKind::Q8, [2, 2], skewed);
    let u = sampled(&mesh, |[x, y]| [xx * x, yy * y + xy * x]);
    let materials: [&dyn Material; 1] = [&material];
    let field = ElasticField::new(&mesh, &materials, &u, Some(&initial)).unwrap();
    assert!(largest_error(field.gauss_stresses().values(), |_| [0.0; 3]) < 1e-13);
}

/// Largest error of nodal and of patch stresses away from the boundary, and of patch stresses everywhere, as shares of the
/// remote tension.
fn solved_errors(kind: ElementKind, cells: usize) -> [f64; 3] {
    let (mesh, u) = kirsch::solved_quarter(kind, cells);
    let material = kirsch::material();
    let materials: [&dyn Material; 1] = [&material];
    let field = ElasticField::new(&mesh, &materials, &u, None).unwrap();
    let inside = |p: &Point| {
        let r = p[0].hypot(p[1]) / kirsch::RADIUS;
        (1.5..3.0).contains(&r) && p[0].min(p[1]) > 0.5 * kirsch::RADIUS
    };
    let error = |stresses: &[[f64; 3]], chosen: &dyn Fn(&Point) -> bool| {
        let nodes = mesh.nodes().iter().zip(stresses).filter(|(p, _)| chosen(p));
        let errors = nodes.map(|(p, s)| largest_error(&[*s], |_| kirsch::stress(*p)));
        errors.fold(0.0, f64::max) / kirsch::TENSION
    };
    let (nodal, patch) = (
        field.nodal_stresses().averaged(),
        field.patch_recovery().averaged(),
    );
    [
        error(&nodal, &inside),
        error(&patch, &inside),
        error(&patch, &|_| true),
    ]
}

/// Rates from 16 to 32 and 64 cells over a quarter. Inside, extrapolation gives h² on all kinds; the patches give h⁴ on Q8
/// and Q9 and a smaller constant on T6. At the boundary they extrapolate and give h² (Q4) and h³ (quadratic kinds).
#[test]
fn patch_recovery_of_a_solution_around_a_hole_converges() {
    let cases = [
        (ElementKind::T3, 1.9, 1.3),
        (ElementKind::Q4, 1.9, 1.8),
        (ElementKind::T6, 1.9, 2.6),
        (ElementKind::Q8, 3.8, 2.9),
        (ElementKind::Q9, 3.8, 2.9),
    ];
    for (kind, inside, everywhere) in cases {
        let errors = [16, 32, 64].map(|cells| solved_errors(kind, cells));
        let last_rate = |k: usize| rates(&errors.map(|e| e[k]))[1];
        assert!(last_rate(0) > 1.8, "{kind:?}: {errors:?}");
        assert!(last_rate(1) > inside, "{kind:?}: {errors:?}");
        assert!(last_rate(2) > everywhere, "{kind:?}: {errors:?}");
        let [nodal, patch, _] = errors[2];
        let gain = if kind.order() == 1 { 0.8 } else { 15.0 };
        assert!(nodal > gain * patch, "{kind:?}: {errors:?}");
    }
}

#[test]
fn a_strip_one_cell_wide_falls_back_to_extrapolation() {
    let mesh = mapped(ElementKind::Q4, [5, 1], skewed);
    let u = sampled(&mesh, quadratic);
    let material = ply();
    let materials: [&dyn Material; 1] = [&material];
    let field = ElasticField::new(&mesh, &materials, &u, None).unwrap();
    assert_eq!(field.patch_recovery(), field.nodal_stresses());
}

#[test]
fn stress_jumps_between_blocks_are_kept() {
    let mut parts = mapped(ElementKind::Q4, [2, 2], |p| p).into_parts();
    let mut right = parts.blocks[0].clone();
    let cells: Vec<Vec<usize>> = parts.blocks[0]
        .connectivity
        .chunks(4)
        .map(<[usize]>::to_vec)
        .collect();
    parts.blocks[0].connectivity = [&cells[0][..], &cells[2]].concat();
    right.connectivity = [&cells[1][..], &cells[3]].concat();
    parts.blocks.push(right);
    let mesh = Mesh::new(parts).unwrap();
    let (soft, stiff) = (kirsch::material(), ply());
    let materials: [&dyn Material; 2] = [&soft, &stiff];
    let u = sampled(&mesh, linear);
    let stresses = ElasticField::new(&mesh, &materials, &u, None)
        .unwrap()
        .patch_recovery();
    let shared = mesh.nodes().iter().position(|p| *p == [0.5, 0.5]).unwrap();
    let strain = [0.3, 0.5, 0.2];
    let mut mean = [0.0; 3];
    for (block, material) in stresses.blocks().iter().zip(materials) {
        let expected = apply(&material.stiffness(), strain);
        let found = block.at(shared).unwrap();
        for i in 0..3 {
            assert!((found[i] - expected[i]).abs() <= 1e-13 * expected[0].abs());
            mean[i] += 0.5 * found[i];
        }
    }
    assert_eq!(stresses.averaged()[shared], mean);
    // Of the blocks' own values: (1 · σ_xx of the first + 2 · σ_xx of the second) / 2.
    let weighted = stresses.averaged_of(|block, stress| (block + 1) as f64 * stress[0]);
    let [first, second] = [0, 1].map(|k| stresses.blocks()[k].at(shared).unwrap()[0]);
    assert_eq!(weighted[shared], f64::midpoint(first, 2.0 * second));
    let outside = mesh.nodes().iter().position(|p| *p == [0.0, 0.0]).unwrap();
    assert_eq!(stresses.blocks()[1].at(outside), None);
}

#[test]
fn arrays_that_do_not_fit_are_refused() {
    let mesh = mapped(ElementKind::T3, [1, 1], |p| p);
    let material = ply();
    let materials: [&dyn Material; 1] = [&material];
    let u = vec![0.0; 2 * mesh.nodes().len()];
    let refused = |field: Result<ElasticField<'_>, StressError>| field.unwrap_err().to_string();
    assert_eq!(
        refused(ElasticField::new(&mesh, &materials, &u[1..], None)),
        "displacement has 7 entries, expected 8"
    );
    assert_eq!(
        refused(ElasticField::new(&mesh, &[], &u, None)),
        "materials has 0 entries, expected 1"
    );
    assert_eq!(
        refused(ElasticField::new(&mesh, &materials, &u, Some(&[]))),
        "initial_strain has 0 entries, expected 1"
    );
}
