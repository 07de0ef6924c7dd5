//! The contract of an element: one function that every kind passes.

use nalgebra::{DMatrix, DVector, SymmetricEigen};
use proptest::prelude::*;
use stickslip_fem_core::element::{
    Element, KindVisitor, edge_nodes, edge_shape, jacobian, physical_gradients, stiffness,
    thermal_load, with_element,
};
use stickslip_fem_core::material::{
    Material, Orthotropic, OrthotropicConstants, PlaneStiffness, apply,
};
use stickslip_fem_core::mesh::{ElementKind, Point};

/// Points inside both reference cells.
const INSIDE: [Point; 4] = [[0.1, 0.2], [0.31, 0.47], [0.05, 0.9], [0.62, 0.13]];

/// An off-axis ply: every entry of D differs from zero.
fn off_axis() -> PlaneStiffness {
    let ply = OrthotropicConstants {
        e1: 18.1,
        e2: 1.03,
        g12: 0.717,
        nu12: 0.28,
    };
    Orthotropic::new(ply, 0.5).unwrap().stiffness()
}

fn affine([x, y]: Point) -> Point {
    [1.0 + 2.0 * x + 0.3 * y, -0.4 * x + 1.5 * y]
}

/// A map that bends straight lines.
fn bend([x, y]: Point) -> Point {
    let [x, y] = affine([x, y]);
    [x + 0.06 * y * y, y - 0.04 * x * y + 0.03 * x * x]
}

#[test]
fn every_kind_keeps_the_contract() {
    struct Contract(ElementKind);
    impl KindVisitor for Contract {
        type Output = ();
        fn visit<const N: usize, E: Element<N>>(self) {
            assert_eq!(E::KIND, self.0, "the element of another kind");
            nodal_values_interpolate::<N, E>();
            linear_fields_are_reproduced::<N, E>();
            gradients_match_differences::<N, E>();
            quadrature_has_its_degree::<N, E>();
            stiffness_is_b_d_b::<N, E>();
            for map in [affine, bend] {
                let x = E::NODES.map(map);
                stiffness_has_three_rigid_modes::<N, E>(&x);
                constant_strain_passes::<N, E>(&x);
            }
        }
    }
    for kind in ElementKind::ALL {
        with_element(kind, Contract(kind));
    }
}

fn nodal_values_interpolate<const N: usize, E: Element<N>>() {
    assert_eq!(E::KIND.nodes(), N);
    for (a, xi) in E::NODES.into_iter().enumerate() {
        for (b, value) in E::shape(xi).into_iter().enumerate() {
            assert_eq!(
                value,
                if a == b { 1.0 } else { 0.0 },
                "{:?}: N{b} at node {a}",
                E::KIND
            );
        }
    }
    // Inner nodes lie at the Gauss–Lobatto points between the corners that the mesh says they join, and the shape functions on an
    // edge are those of its nodes.
    let line = edge_nodes(E::KIND.order()).unwrap();
    for edge in 0..E::KIND.edges() {
        let local = E::KIND.edge_nodes(edge);
        let [p, q] = local.ends.map(|k| E::NODES[k]);
        let between = |t: f64| [0, 1].map(|i| 0.5 * (1.0 - t) * p[i] + 0.5 * (1.0 + t) * q[i]);
        assert_eq!(local.inner.len() + 2, line.len());
        for (node, &(t, _)) in local.inner.clone().zip(&line[1..]) {
            let expected = between(t);
            (0..2).for_each(|i| assert!((E::NODES[node][i] - expected[i]).abs() < 1e-15));
        }
        let nodes = [local.ends[0]]
            .into_iter()
            .chain(local.inner.clone())
            .chain([local.ends[1]]);
        let (cell, side) = (E::shape(between(0.37)), edge_shape(E::KIND.order(), 0.37));
        for (node, value) in nodes.zip(side) {
            assert!((cell[node] - value).abs() < 1e-14, "{:?}", E::KIND);
        }
    }
}

fn linear_fields_are_reproduced<const N: usize, E: Element<N>>() {
    // Sums of N terms of magnitude at most one: a rounding each, and those of the products in each term; slopes reach p².
    let order = E::KIND.order() as f64;
    let rounding = if order > 2.0 {
        N as f64 * order * f64::EPSILON
    } else {
        9.0 * f64::EPSILON
    };
    for xi in INSIDE {
        let (shape, slope) = (E::shape(xi), E::gradients(xi));
        let sum = |f: &dyn Fn(usize) -> f64| (0..N).map(f).sum::<f64>();
        assert!((sum(&|a| shape[a]) - 1.0).abs() <= rounding);
        for i in 0..2 {
            assert!((sum(&|a| shape[a] * E::NODES[a][i]) - xi[i]).abs() <= rounding);
            for j in 0..2 {
                let expected = if i == j { 1.0 } else { 0.0 };
                assert!(
                    (sum(&|a| slope[a][j] * E::NODES[a][i]) - expected).abs() <= 4.0 * rounding
                );
            }
        }
    }
}

fn gradients_match_differences<const N: usize, E: Element<N>>() {
    // Central differences of polynomials with third derivatives at most 3: truncation h²/2, rounding ε/h. Between Gauss–Lobatto
    // nodes |ℓ| ≤ 1, and a polynomial of degree p bounded so has a third derivative of at most p²(p² − 1)(p² − 4)/15 (V. Markov).
    let h = 1e-5;
    let square = E::KIND.order().pow(2) as f64;
    let third = (square * (square - 1.0) * (square - 4.0) / 15.0).max(6.0);
    for xi in INSIDE {
        let slope = E::gradients(xi);
        for j in 0..2 {
            let [mut after, mut before] = [xi, xi];
            after[j] += h;
            before[j] -= h;
            let (after, before) = (E::shape(after), E::shape(before));
            for a in 0..N {
                let difference = (after[a] - before[a]) / (2.0 * h);
                assert!(
                    (difference - slope[a][j]).abs()
                        < third / 6.0 * h * h + 10.0 * f64::EPSILON / h
                );
            }
        }
    }
}

fn quadrature_has_its_degree<const N: usize, E: Element<N>>() {
    let triangle = E::KIND.corners() == 3;
    let degree: u8 = match E::KIND {
        ElementKind::T3 => 1,
        ElementKind::T6 => 2,
        ElementKind::Q4 => 3,
        ElementKind::Q8 | ElementKind::Q9 => 5,
        lobatto => 2 * lobatto.order() as u8 + 1,
    };
    let factorial = |n: u8| (1..=n).map(f64::from).product::<f64>();
    let even = |n: u8| {
        if n.is_multiple_of(2) {
            2.0 / f64::from(n + 1)
        } else {
            0.0
        }
    };
    for p in 0..=degree {
        for q in 0..=degree {
            if triangle && p + q > degree {
                continue;
            }
            // ∫ ξ^p η^q: p! q!/(p + q + 2)! on the triangle, a product of one-dimensional integrals on the square.
            let exact = if triangle {
                factorial(p) * factorial(q) / factorial(p + q + 2)
            } else {
                even(p) * even(q)
            };
            let terms = E::QUADRATURE.iter().map(|point| {
                point.weight * point.at[0].powi(p.into()) * point.at[1].powi(q.into())
            });
            assert!(
                (terms.sum::<f64>() - exact).abs() < 20.0 * f64::EPSILON,
                "ξ^{p} η^{q}"
            );
        }
    }
}

fn matrix<const N: usize, E: Element<N>>(x: &[Point; N], d: &PlaneStiffness) -> DMatrix<f64> {
    let mut k = vec![f64::NAN; 4 * N * N];
    stiffness::<N, E>(x, d, 0.7, &mut k);
    DMatrix::from_row_slice(2 * N, 2 * N, &k)
}

fn stiffness_is_b_d_b<const N: usize, E: Element<N>>() {
    let (x, d) = (E::NODES.map(bend), off_axis());
    let material = DMatrix::from_fn(3, 3, |i, j| d[i][j]);
    let mut product = DMatrix::zeros(2 * N, 2 * N);
    for point in E::QUADRATURE {
        let here = physical_gradients::<N, E>(&x, point.at);
        let mut b = DMatrix::zeros(3, 2 * N);
        for (a, [gx, gy]) in here.gradients.into_iter().enumerate() {
            b[(0, 2 * a)] = gx;
            b[(1, 2 * a + 1)] = gy;
            b[(2, 2 * a)] = gy;
            b[(2, 2 * a + 1)] = gx;
        }
        product += b.transpose() * &material * b * (0.7 * point.weight * here.det);
    }
    let k = matrix::<N, E>(&x, &d);
    assert!((&k - product).amax() < 1e-13 * k.amax());
}

fn stiffness_has_three_rigid_modes<const N: usize, E: Element<N>>(x: &[Point; N]) {
    let k = matrix::<N, E>(x, &off_axis());
    assert_eq!(k, k.transpose(), "symmetric to the last bit");
    let rigid = |motion: &dyn Fn(Point) -> Point| {
        DVector::from_iterator(2 * N, x.iter().flat_map(|&p| motion(p)))
    };
    for motion in [
        rigid(&|_| [1.0, 0.0]),
        rigid(&|_| [0.0, 1.0]),
        rigid(&|[x, y]| [-y, x]),
    ] {
        assert!((&k * &motion).amax() < 1e-13 * k.amax() * motion.amax());
    }
    let mut eigenvalues: Vec<f64> = SymmetricEigen::new(k).eigenvalues.iter().copied().collect();
    eigenvalues.sort_by(f64::total_cmp);
    let largest = eigenvalues[2 * N - 1];
    assert!(eigenvalues[2].abs() < 1e-13 * largest && eigenvalues[0] > -1e-13 * largest);
    // The condition of a Gauss–Lobatto cell grows with about the cube of its order.
    let least = 1e-4 / E::KIND.order().saturating_sub(1).max(1).pow(2) as f64;
    assert!(
        eigenvalues[3] > least * largest,
        "{:?} has a mechanism: {eigenvalues:?}",
        E::KIND
    );
}

/// With u = ε x exactly representable, K u is the load by which the same initial strain acts, and uᵀ K u = t A ε·σ.
fn constant_strain_passes<const N: usize, E: Element<N>>(x: &[Point; N]) {
    let (d, strain) = (off_axis(), [0.3, -0.2, 0.5]);
    let k = matrix::<N, E>(x, &d);
    let u: [[f64; 2]; N] = x.map(|[x, y]| {
        [
            strain[0] * x + 0.1 * y,
            strain[1] * y + (strain[2] - 0.1) * x,
        ]
    });
    let displacement = DVector::from_iterator(2 * N, u.into_iter().flatten());
    let mut load = vec![f64::NAN; 2 * N];
    thermal_load::<N, E>(x, &d, strain, 0.7, &mut load);
    let force = &k * &displacement;
    assert!((&force - DVector::from_vec(load)).amax() < 1e-13 * k.amax());

    let stress = apply(&d, strain);
    let density: f64 = strain.iter().zip(stress).map(|(e, s)| e * s).sum();
    let area: f64 = E::QUADRATURE
        .iter()
        .map(|p| p.weight * jacobian::<N, E>(x, p.at).det)
        .sum::<f64>();
    let energy = displacement.dot(&force);
    assert!((energy - 0.7 * area * density).abs() < 1e-13 * k.amax());
    for point in INSIDE {
        let recovered = physical_gradients::<N, E>(x, point).strain(&u);
        recovered
            .iter()
            .zip(strain)
            .for_each(|(a, b)| assert!((a - b).abs() < 1e-13));
    }
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    /// Stiffness in the plane does not depend on the size of the cell, and turns with the cell for an isotropic material.
    #[test]
    fn q8_energy_is_invariant_under_similarity(
        angle in 0.0..6.3_f64, size in 0.01..100.0_f64, u in prop::array::uniform8(-1.0..1.0_f64),
    ) {
        let d = [[2.0, 0.6, 0.0], [0.6, 2.0, 0.0], [0.0, 0.0, 0.7]];
        let (s, c) = angle.sin_cos();
        let turn = |[x, y]: Point| [c * x - s * y, s * x + c * y];
        let energy = |x: &[Point; 8], u: [Point; 8]| {
            let u = DVector::from_iterator(16, u.into_iter().flatten());
            (u.transpose() * matrix::<8, stickslip_fem_core::element::Q8>(x, &d) * &u)[0]
        };
        let x = stickslip_fem_core::element::Q8::NODES.map(bend);
        let moved = u.map(|v| [v, 0.5 - v * v]);
        let turned = x.map(|p| turn(p).map(|v| size * v));
        let (here, there) = (energy(&x, moved), energy(&turned, moved.map(turn)));
        prop_assert!((here - there).abs() < 1e-11 * (1.0 + here.abs()));
    }
}
