//! Fasteners: how the slices of one are coupled.
//!
//! Each slice has three motions, the mean displacement of its section and its turn times its radius. Layer i lies between the heights a_i and b_i, its
//! middle at z_i. A slice that takes the force 1, spread evenly along its thickness, makes in a beam held at z = 0
//!
//! ```text
//! v_i(z) = 1 below a_i, (b_i − z)/t_i within the layer, 0 above       shear force; torque of a unit moment
//! m_i(z) = ∫_z v_i ds                                                 bending moment
//! F_ij   = ∫ (v_i v_j / κGA + m_i m_j / EI) dz,   κ = 9/10            mean displacement of slice i
//! T_ij   = ∫ v_i v_j / GJ dz                                          mean turn
//! ```
//!
//! | ends | motions without resistance | F |
//! | --- | --- | --- |
//! | head and nut free | as one, and tilting: z_i | F |
//! | head clamped | as one | F |
//! | nut clamped | as one | F counted from the nut |
//! | both clamped | as one | F_ij − f_i f_j EI/L, f_i = ∫ m_i / EI dz |
//!
//! Given springs have F_ij = Σ c_l over the springs below both slices. Forces in F are those that balance; what else it holds is a motion as one.
//!
//! Sources: Timoshenko, *Strength of Materials* I (1940), §§ 39, 66; κ of a circular section from the energy of its parabolic shear stress.

use std::f64::consts::PI;

use nalgebra::{DMatrix, DVector};
use stickslip_contact::{ContactError, Interface, Link};
use stickslip_fem_core::InterfaceOperator;
use stickslip_scene::schema::{Material, Springs};

use super::Model;
use super::plan::{BodyPlan, FastenerPlan, Plan};

/// Shear coefficient κ of a circular section.
const SHEAR: f64 = 0.9;
/// Motions of a slice.
const MOTIONS: usize = 3;

/// A fastener of a model.
#[derive(Clone, Debug)]
pub struct ModelFastener {
    /// Name in the scene.
    pub name: String,
    /// Heights of the middles of its layers above the first face `[mm]`.
    pub heights: Vec<f64>,
    /// Radii of its slices `[mm]`.
    pub radii: Vec<f64>,
    /// What couples its slices.
    pub link: Link,
}

impl ModelFastener {
    /// Indices of its slices, in the order of the layers.
    pub fn slices(&self) -> &[usize] {
        &self.link.bodies
    }
}

impl Model {
    /// The springs between slices of fasteners.
    pub fn links(&self) -> Vec<Link> {
        let links = self.fasteners.iter().map(|fastener| fastener.link.clone());
        links.collect()
    }

    /// All contacts between its condensed bodies `operators`.
    ///
    /// # Errors
    /// As [`Interface::linked`].
    pub fn interface(
        &self,
        operators: &[&dyn InterfaceOperator],
    ) -> Result<Interface, ContactError> {
        Interface::linked(operators, self.pairs.clone(), &self.links())
    }

    /// The fastener of which body `body` is a slice.
    pub fn fastener_of(&self, body: usize) -> Option<&ModelFastener> {
        let mut fasteners = self.fasteners.iter();
        fasteners.find(|fastener| fastener.slices().contains(&body))
    }

    /// Radius `[mm]` of the slice of a fastener with the index `body`; 1 of other bodies.
    pub(crate) fn radius_of(&self, body: usize) -> f64 {
        let fasteners = self.fasteners.iter();
        let mut slices = fasteners.flat_map(|own| own.slices().iter().zip(&own.radii));
        slices
            .find(|(slice, _)| **slice == body)
            .map_or(1.0, |(_, radius)| *radius)
    }
}

/// The fasteners of `plan`.
pub(super) fn build(plan: &Plan<'_>) -> Vec<ModelFastener> {
    let fastener = |own: &FastenerPlan<'_>| {
        let slices = || own.slices.iter().map(|&body| &plan.bodies[body]);
        let thicknesses: Vec<f64> = slices().map(BodyPlan::thickness).collect();
        let radii: Vec<f64> = slices().map(|body| body.radius().unwrap_or(1.0)).collect();
        let material = slices()
            .find_map(|body| body.elastic)
            .map(|own| own.material);
        let stack = Stack { thicknesses };
        let couplings = match (&own.of.springs, material) {
            (Springs::Beam { clamped }, Some(Material::Isotropic { young, poisson, .. })) => {
                stack.beam(*clamped, [*young, *poisson, radii[0]])
            }
            (Springs::Given { compliance }, _) => stack.given(compliance),
            // A beam of another material is refused where the scene is read.
            (Springs::Rigid | Springs::Beam { .. }, _) => stack.rigid(),
        };
        ModelFastener {
            name: own.of.name.clone(),
            heights: stack.middles(),
            link: couplings.link(own.slices.clone(), &radii),
            radii,
        }
    };
    plan.fasteners.iter().map(fastener).collect()
}

/// The layers of a fastener.
struct Stack {
    /// `[mm]`.
    thicknesses: Vec<f64>,
}

/// Flexibilities of the slices, k × k.
struct Couplings {
    /// Of mean displacements along one axis `[mm/N]`.
    shift: DMatrix<f64>,
    /// Of turns `[1/(N mm)]`.
    turn: DMatrix<f64>,
    /// Displacements by tilting, where nothing resists it.
    tilt: Option<DVector<f64>>,
}

impl Stack {
    fn count(&self) -> usize {
        self.thicknesses.len()
    }

    /// Heights of the lower face of each layer, and of the upper face of the last `[mm]`.
    fn faces(&self) -> Vec<f64> {
        let mut faces = vec![0.0];
        for thickness in &self.thicknesses {
            faces.push(faces[faces.len() - 1] + thickness);
        }
        faces
    }

    fn middles(&self) -> Vec<f64> {
        let faces = self.faces();
        faces
            .windows(2)
            .map(|own| f64::midpoint(own[0], own[1]))
            .collect()
    }

    fn rigid(&self) -> Couplings {
        let none = DMatrix::zeros(self.count(), self.count());
        Couplings {
            shift: none.clone(),
            turn: none,
            tilt: None,
        }
    }

    fn given(&self, compliance: &[f64]) -> Couplings {
        let below = |slice: usize| compliance[..slice].iter().sum::<f64>();
        let count = self.count();
        Couplings {
            shift: DMatrix::from_fn(count, count, |i, j| below(i.min(j))),
            ..self.rigid()
        }
    }

    /// A shank of Young's modulus `young` `[MPa]`, Poisson's ratio `poisson` and radius `radius` `[mm]`.
    fn beam(&self, clamped: [bool; 2], [young, poisson, radius]: [f64; 3]) -> Couplings {
        let shear = young / (2.0 * (1.0 + poisson));
        let area = PI * radius * radius;
        let inertia = 0.25 * area * radius * radius;
        let [along, bending] = self.energies();
        let shift = |own: &Self| {
            let [along, bending] = own.energies();
            along / (SHEAR * shear * area) + bending / (young * inertia)
        };
        let shift = match clamped {
            [false, true] => {
                let turned = Self {
                    thicknesses: self.thicknesses.iter().rev().copied().collect(),
                };
                let last = self.count() - 1;
                let found = shift(&turned);
                DMatrix::from_fn(last + 1, last + 1, |i, j| found[(last - i, last - j)])
            }
            [true, true] => {
                let tilts = self.tilts();
                let whole: f64 = self.thicknesses.iter().sum();
                let stiffened = bending - &tilts * tilts.transpose() / whole;
                &along / (SHEAR * shear * area) + stiffened / (young * inertia)
            }
            [_, false] => shift(self),
        };
        let middles = DVector::from_vec(self.middles());
        Couplings {
            shift,
            turn: along / (2.0 * shear * inertia),
            tilt: (clamped == [false; 2]).then(|| middles.add_scalar(-middles.mean())),
        }
    }

    /// ∫ v_i v_j dz `[mm]` and ∫ m_i m_j dz `[mm³]`.
    fn energies(&self) -> [DMatrix<f64>; 2] {
        let count = self.count();
        let mut energies = [DMatrix::zeros(count, count), DMatrix::zeros(count, count)];
        self.integrate(|weight, forces, moments| {
            energies[0].ger(weight, forces, forces, 1.0);
            energies[1].ger(weight, moments, moments, 1.0);
        });
        energies
    }

    /// ∫ m_i dz `[mm²]`.
    fn tilts(&self) -> DVector<f64> {
        let mut tilts = DVector::zeros(self.count());
        self.integrate(|weight, _, moments| tilts.axpy(weight, moments, 1.0));
        tilts
    }

    /// Calls `add` with weight, v and m at points whose weighted sums are integrals along the shank of polynomials up to the fifth degree.
    fn integrate(&self, mut add: impl FnMut(f64, &DVector<f64>, &DVector<f64>)) {
        const POINTS: [(f64, f64); 3] = [
            (-0.774_596_669_241_483_4, 5.0 / 18.0),
            (0.0, 4.0 / 9.0),
            (0.774_596_669_241_483_4, 5.0 / 18.0),
        ];
        let (faces, middles) = (self.faces(), self.middles());
        for (layer, thickness) in self.thicknesses.iter().enumerate() {
            for (at, weight) in POINTS {
                let z = middles[layer] + 0.5 * at * thickness;
                let above = |slice: usize| (faces[slice + 1] - z) / self.thicknesses[slice];
                let force = |slice: usize, _| above(slice).clamp(0.0, 1.0);
                let moment = |slice: usize, _| match slice.cmp(&layer) {
                    std::cmp::Ordering::Less => 0.0,
                    std::cmp::Ordering::Equal => 0.5 * above(slice).powi(2) * thickness,
                    std::cmp::Ordering::Greater => middles[slice] - z,
                };
                let forces = DVector::from_fn(self.count(), force);
                add(
                    weight * thickness,
                    &forces,
                    &DVector::from_fn(self.count(), moment),
                );
            }
        }
    }
}

impl Couplings {
    /// As a link of the motions of `slices` with the radii `radii` `[mm]`.
    fn link(&self, slices: Vec<usize>, radii: &[f64]) -> Link {
        let count = slices.len();
        let flexibility = |row: usize, column: usize| {
            let (i, j) = (row / MOTIONS, column / MOTIONS);
            match (row % MOTIONS, column % MOTIONS) {
                (2, 2) => radii[i] * self.turn[(i, j)] * radii[j],
                (one, other) if one == other => self.shift[(i, j)],
                _ => 0.0,
            }
        };
        let tilts = if self.tilt.is_some() { 2 } else { 0 };
        let free = |row: usize, column: usize| {
            let (slice, motion) = (row / MOTIONS, row % MOTIONS);
            match &self.tilt {
                _ if column == 2 && motion == 2 => radii[slice] / radii[0],
                Some(tilt) if column == MOTIONS + motion => tilt[slice],
                _ if column == motion => 1.0,
                _ => 0.0,
            }
        };
        Link {
            bodies: slices,
            flexibility: DMatrix::from_fn(MOTIONS * count, MOTIONS * count, flexibility),
            free: DMatrix::from_fn(MOTIONS * count, MOTIONS + tilts, free),
        }
    }
}
