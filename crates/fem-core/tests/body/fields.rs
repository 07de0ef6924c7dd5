//! Exact fields of plane elasticity without body force, materials to have them in, and bodies that they drive.

use std::f64::consts::PI;
use std::sync::Arc;

use nalgebra::Complex;
use stickslip_fem_core::load::edge_load;
use stickslip_fem_core::material::{
    Isotropic, Material, Orthotropic, OrthotropicConstants, OutOfPlane, PlaneState, PlaneStiffness,
    apply,
};
use stickslip_fem_core::mesh::{Mesh, Point};
use stickslip_fem_core::{ElasticBody, HeldDirection, LoadCase, Support};

use super::meshes::edges;

/// Thickness of the bodies here.
pub(crate) const THICKNESS: f64 = 0.7;

/// Carbon–epoxy T300/5208 in GPa (Tsai & Hahn, *Introduction to Composite Materials*, 1980, table 1.7).
pub(crate) const PLY: OrthotropicConstants = OrthotropicConstants {
    e1: 181.0,
    e2: 10.3,
    g12: 7.17,
    nu12: 0.28,
};

/// Isotropic in both plane states, and plies at an angle in both: one of each that can go wrong alone.
pub(crate) fn materials() -> Vec<Arc<dyn Material>> {
    let across = OutOfPlane {
        e3: 10.3,
        nu13: 0.28,
        nu23: 0.5,
        alpha3: 0.0,
    };
    vec![
        Arc::new(Isotropic::new(70.0, 0.33, PlaneState::Stress).unwrap()),
        Arc::new(Isotropic::new(70.0, 0.33, PlaneState::Strain).unwrap()),
        ply(0.5),
        Arc::new(Orthotropic::plane_strain(PLY, across, -1.1).unwrap()),
    ]
}

/// The ply at `angle` in plane stress.
pub(crate) fn ply(angle: f64) -> Arc<dyn Material> {
    Arc::new(Orthotropic::new(PLY, angle).unwrap())
}

/// A displacement `[length]` and its stress `[stress]`, in equilibrium without body force.
pub(crate) struct Field {
    pub(crate) displacement: Box<dyn Fn(Point) -> [f64; 2]>,
    pub(crate) stress: Box<dyn Fn(Point) -> [f64; 3]>,
}

impl Field {
    /// Traction σ·n.
    pub(crate) fn traction(&self, at: Point, [nx, ny]: [f64; 2]) -> [f64; 2] {
        let [xx, yy, xy] = (self.stress)(at);
        [xx * nx + xy * ny, xy * nx + yy * ny]
    }

    /// The displacement at all nodes, interleaved.
    pub(crate) fn at_nodes(&self, mesh: &Mesh) -> Vec<f64> {
        let nodes = mesh.nodes().iter();
        nodes.flat_map(|&p| (self.displacement)(p)).collect()
    }
}

/// A linear displacement: any strain is in equilibrium.
pub(crate) fn linear(d: &PlaneStiffness) -> Field {
    let stress = apply(d, [0.3e-2, -0.2e-2, 0.4e-2]);
    Field {
        displacement: Box::new(|[x, y]| {
            [
                0.1e-2 + 0.3e-2 * x + 0.1e-2 * y,
                -0.2e-2 - 0.2e-2 * y + 0.3e-2 * x,
            ]
        }),
        stress: Box::new(move |_| stress),
    }
}

/// The quadratic displacement of a cubic Airy function a x³ + b x²y + c xy² + d y³: linear stresses, and linear strains,
/// which are compatible for any coefficients.
pub(crate) fn quadratic(material: &dyn Material) -> Field {
    let s = material.compliance();
    let [a, b, c, d] = [0.11, -0.07, 0.05, 0.13];
    // Stress and strain of x and of y.
    let stress_x = [2.0 * c, 6.0 * a, -2.0 * b];
    let stress_y = [6.0 * d, 2.0 * b, -2.0 * c];
    let (p, q) = (apply(&s, stress_x), apply(&s, stress_y));
    let alpha = (q[2] - p[1]) / 2.0;
    let beta = (p[2] - q[0]) / 2.0;
    Field {
        displacement: Box::new(move |[x, y]| {
            [
                p[0] * x * x / 2.0 + q[0] * x * y + alpha * y * y,
                p[1] * x * y + q[1] * y * y / 2.0 + beta * x * x,
            ]
        }),
        stress: Box::new(move |[x, y]| [0, 1, 2].map(|i| stress_x[i] * x + stress_y[i] * y)),
    }
}

/// Kolosov's formulae with exponential potentials φ = A e^{kz}, ψ = B e^{−kz}, for an isotropic material
/// (Muskhelishvili 1953, §§ 32–33): 2G (u + iv) = κ φ − z φ̄′ − ψ̄.
pub(crate) fn kolosov(young: f64, poisson: f64, state: PlaneState) -> Field {
    type C = Complex<f64>;
    let shear = young / (2.0 * (1.0 + poisson));
    let kappa = match state {
        PlaneState::Stress => (3.0 - poisson) / (1.0 + poisson),
        PlaneState::Strain => 3.0 - 4.0 * poisson,
    };
    let (amplitude, other, k) = (C::new(1.0, 0.4), C::new(-0.6, 0.8), C::new(0.8, 1.1));
    let potentials = move |[x, y]: Point| {
        let z = C::new(x, y);
        let (grow, fall) = (amplitude * (k * z).exp(), other * (-k * z).exp());
        (z, grow, fall)
    };
    Field {
        displacement: Box::new(move |p| {
            let (z, phi, psi) = potentials(p);
            let w = (phi * kappa - z * (k * phi).conj() - psi.conj()) / (2.0 * shear);
            [w.re, w.im]
        }),
        stress: Box::new(move |p| {
            let (z, phi, psi) = potentials(p);
            let sum = 4.0 * (k * phi).re;
            let rest = (z.conj() * k * k * phi - k * psi) * 2.0;
            [
                f64::midpoint(sum, -rest.re),
                f64::midpoint(sum, rest.re),
                rest.im / 2.0,
            ]
        }),
    }
}

/// Lekhnitskii's potentials Φⱼ = Aⱼ e^{kⱼ zⱼ}, zⱼ = x + pⱼ y, for a generally anisotropic plane (Lekhnitskii 1968, § 13):
/// σ = 2 Re Σ (pⱼ², 1, −pⱼ) Φⱼ′ and u = 2 Re Σ (s₁₁pⱼ² + s₁₂ − s₁₆pⱼ, s₁₂pⱼ + s₂₂/pⱼ − s₂₆) Φⱼ.
pub(crate) fn lekhnitskii(material: &dyn Material) -> Field {
    type C = Complex<f64>;
    let s = material.compliance();
    let roots = characteristic_roots(&s);
    let amplitude = [C::new(0.8, 0.3), C::new(-0.4, 0.9)];
    // e^{kz} is a wave along y with the wavelength 2π/(|k| Im p): scaled to be alike for both roots.
    let k = roots.map(|p| C::new(0.0, PI / 2.0) / (1.0 + p.im));
    let potential = move |j: usize, [x, y]: Point| {
        let z = C::new(x, 0.0) + roots[j] * y;
        amplitude[j] * (k[j] * z).exp()
    };
    Field {
        displacement: Box::new(move |at| {
            let mut u = [0.0; 2];
            for (j, &p) in roots.iter().enumerate() {
                let phi = potential(j, at);
                u[0] += 2.0 * ((p * p * s[0][0] + s[0][1] - p * s[0][2]) * phi).re;
                u[1] += 2.0 * ((p * s[0][1] + p.inv() * s[1][1] - s[1][2]) * phi).re;
            }
            u
        }),
        stress: Box::new(move |at| {
            let mut stress = [0.0; 3];
            for (j, &p) in roots.iter().enumerate() {
                let slope = k[j] * potential(j, at);
                stress[0] += 2.0 * (p * p * slope).re;
                stress[1] += 2.0 * slope.re;
                stress[2] -= 2.0 * (p * slope).re;
            }
            stress
        }),
    }
}

/// The two roots in the upper half plane of s₁₁p⁴ − 2s₁₆p³ + (2s₁₂ + s₆₆)p² − 2s₂₆p + s₂₂ = 0, by the eigenvalues of the
/// companion matrix.
fn characteristic_roots(s: &PlaneStiffness) -> [Complex<f64>; 2] {
    let lead = s[0][0];
    let lower = [
        s[1][1],
        -2.0 * s[1][2],
        2.0 * s[0][1] + s[2][2],
        -2.0 * s[0][2],
    ];
    let mut companion = nalgebra::Matrix4::zeros();
    for i in 0..4 {
        companion[(i, 3)] = -lower[i] / lead;
        if i > 0 {
            companion[(i, i - 1)] = 1.0;
        }
    }
    let roots = companion.complex_eigenvalues();
    let mut upper = roots.iter().filter(|p| p.im > 0.0);
    [*upper.next().unwrap(), *upper.next().unwrap()]
}

/// A body with one load case: the displacement of `field` at the nodes `held`, its tractions on the sides `pulled`.
pub(crate) fn driven(
    mesh: Mesh,
    material: Arc<dyn Material>,
    field: &Field,
    held: &[(usize, HeldDirection)],
    pulled: &[&str],
) -> Arc<ElasticBody> {
    let supports = held.iter().map(|&(node, direction)| {
        let (u, along) = ((field.displacement)(mesh.nodes()[node]), direction.unit());
        Support {
            nodes: vec![node],
            direction,
            displacement: u[0] * along[0] + u[1] * along[1],
        }
    });
    let supports: Vec<Support> = supports.collect();
    let load = LoadCase {
        forces: edge_load(&mesh, &edges(&mesh, pulled), THICKNESS, |at| {
            field.traction(at.position, at.normal)
        }),
        moves_supports: true,
        ..LoadCase::default()
    };
    let body = ElasticBody::new(Arc::new(mesh), vec![material], THICKNESS).unwrap();
    Arc::new(
        body.with_supports(supports)
            .with_load_cases(vec![load])
            .unwrap(),
    )
}

/// Both components of every node held.
pub(crate) fn both(nodes: &[usize]) -> Vec<(usize, HeldDirection)> {
    let axes = [HeldDirection::X, HeldDirection::Y];
    nodes
        .iter()
        .flat_map(|&node| axes.map(|axis| (node, axis)))
        .collect()
}
