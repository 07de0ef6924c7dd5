//! A half-plane below or above the x axis.
//!
//! ```text
//! u(x) = (1/2πG) ∫ [(1 + κ)/2 L(x − ξ) q + i(±)(1 − κ)/2 S(x − ξ) q] dξ,    L = −ln|x/ℓ|,  S = (π/2) sign x     (+: below)
//! Φ(z) = (1/2π) ∫ q/(ξ − z) dξ,   σ_xx + σ_yy = 4 Re Φ,   σ_yy − iσ_xy = Φ(z) − Φ(z̄) + (z − z̄) conj Φ′(z)
//! 2G u = κ φ(z) + φ(z̄) − (z − z̄) conj Φ(z),   φ′ = Φ;     on the edge σ_xx = σ_yy + (2/π) PV∫ q_x/(ξ − x) dξ
//! ```
//!
//! with the tractions q = q_x + iq_y on the body. A net force moves a half-plane without limit: displacements are counted so that they vanish, beside the part
//! of S, at the distance ℓ.
//!
//! Source: Muskhelishvili, *Some Basic Problems of the Mathematical Theory of Elasticity* (1953), §§ 93, 94; Johnson, *Contact Mechanics* (1985), 2.2 to 2.4.

mod potential;

use std::f64::consts::PI;

use nalgebra::{DMatrix, DVector};
use stickslip_fem_core::InterfaceOperator;
use stickslip_fem_core::body::BodyLoad;
use stickslip_fem_core::material::Isotropic;
use stickslip_fem_core::mesh::Point;

use crate::circle::{Kolosov, Side, Surface, Symmetry, check_load, positive};
use crate::error::SeriesError;
use crate::field::check;
use crate::line::LineNodes;
pub use potential::HalfPlaneField;
use potential::{Constants, edge_kernel};

/// On which side of the x axis a half-plane lies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Lies {
    /// y ≤ 0.
    Below,
    /// y ≥ 0.
    Above,
}

/// What a [`HalfPlane`] is made of besides its nodes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ground {
    /// Its side.
    pub lies: Lies,
    /// Thickness t `[length]`.
    pub thickness: f64,
    /// ℓ `[length]`.
    pub reference: f64,
    /// Axes along which it moves freely; it never turns.
    pub free: [bool; 2],
}

/// An isotropic half-plane, in closed form. What acts on it far away is balanced by contact; along an axis that is not free by a support there.
///
/// ```
/// use stickslip_fem_core::InterfaceOperator;
/// use stickslip_fem_core::material::{Isotropic, PlaneState};
/// use stickslip_series::{Ground, HalfPlane, Lies, LineNodes};
///
/// let steel = Isotropic::new(210_000.0, 0.3, PlaneState::Strain)?;
/// let nodes = LineNodes::whole((-20..=20).map(|k| 0.05 * f64::from(k)).collect())?;
/// let ground = Ground { lies: Lies::Below, thickness: 1.0, reference: 1.0, free: [false; 2] };
/// let body = HalfPlane::new(nodes, &steel, ground, &[])?;
/// // Flamant: the difference of the displacements at 0.25 and at 0.5 by a force in the middle.
/// let compliance = body.compliance().ok_or("it deforms")?;
/// let fall = compliance[(51, 41)] - compliance[(61, 41)];
/// let exact = 2.0 * (1.0 - 0.09) / (std::f64::consts::PI * 210_000.0) * 2.0_f64.ln();
/// assert!((fall / exact - 1.0).abs() < 1e-2);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct HalfPlane {
    nodes: LineNodes,
    ground: Ground,
    material: Kolosov,
    points: Vec<Point>,
    compliance: DMatrix<f64>,
    modes: DMatrix<f64>,
    mode_loads: Vec<DVector<f64>>,
}

impl HalfPlane {
    /// A half-plane with `loads[k]` the force `[force]` of load case k far away; of a half model the force on the whole.
    ///
    /// # Errors
    /// [`SeriesError::Length`] for a length that is not positive; [`SeriesError::LoadNotFinite`], [`SeriesError::NotSymmetric`] for a load that does
    /// not fit; [`SeriesError::MovesAcross`] for a half model that is free along x.
    pub fn new(
        nodes: LineNodes,
        material: &Isotropic,
        ground: Ground,
        loads: &[[f64; 2]],
    ) -> Result<Self, SeriesError> {
        positive("thickness", ground.thickness)?;
        positive("reference length", ground.reference)?;
        let mirrored = nodes.is_mirrored();
        if mirrored && ground.free[0] {
            return Err(SeriesError::MovesAcross);
        }
        for (case, [x, y]) in loads.iter().enumerate() {
            let values = [
                ("the force along x", *x, true),
                ("the force along y", *y, false),
            ];
            check_load(case, mirrored, &values)?;
        }
        let free: Vec<usize> = (0..2).filter(|&axis| ground.free[axis]).collect();
        let moves = |row: usize, column: usize| {
            let held = row.is_multiple_of(2) && nodes.on_axis(row / 2);
            f64::from(u8::from(row % 2 == free[column] && !held))
        };
        let modes = DMatrix::from_fn(2 * nodes.len(), free.len(), moves);
        let part = if mirrored { 0.5 } else { 1.0 };
        let resultants = |force: &[f64; 2]| {
            DVector::from_iterator(free.len(), free.iter().map(|&axis| part * force[axis]))
        };
        let material = Kolosov::from(material);
        let places = nodes.mean(|x| x);
        Ok(Self {
            compliance: compliance(&nodes, material, ground),
            modes,
            mode_loads: loads.iter().map(resultants).collect(),
            points: places.into_iter().map(|x| [x, 0.0]).collect(),
            nodes,
            ground,
            material,
        })
    }

    /// The nodes.
    pub fn nodes(&self) -> &LineNodes {
        &self.nodes
    }

    /// Its side, thickness and freedom.
    pub fn ground(&self) -> Ground {
        self.ground
    }

    /// The field under nodal forces, load cases and rigid motions: 2n forces `[force]`, one multiplier of each load case, one amount of each rigid motion.
    ///
    /// # Errors
    /// [`SeriesError::State`] for numbers that are too few or too many.
    pub fn field(&self, state: &BodyLoad<'_>) -> Result<HalfPlaneField, SeriesError> {
        self.check(state)?;
        let mut motion = [0.0; 2];
        let free = (0..2).filter(|&axis| self.ground.free[axis]);
        for (axis, amount) in free.zip(state.motions) {
            motion[axis] = *amount;
        }
        let constants = Constants {
            outward: self.outward(),
            kappa: self.material.kappa,
            unit: 0.5 / self.material.shear,
            reference: self.ground.reference,
            motion,
        };
        let tractions = self.tractions(state.forces);
        Ok(HalfPlaneField::new(
            self.nodes.knots(),
            &tractions,
            constants,
        ))
    }

    /// Stresses (xx, yy, xy) `[stress]` at the places `places` x `[length]` of the edge under each of `states`, by state and place. They are exact for tractions that are
    /// linear between nodes; at an end where such a traction along x jumps to zero the stress has no limit, and what is returned has no meaning.
    ///
    /// # Errors
    /// [`SeriesError::State`] for numbers that are too few or too many.
    pub fn edge_stresses(
        &self,
        states: &[BodyLoad<'_>],
        places: &[f64],
    ) -> Result<Vec<Vec<[f64; 3]>>, SeriesError> {
        states.iter().try_for_each(|state| self.check(state))?;
        let kernel = edge_kernel(self.nodes.knots(), places);
        let outward = self.outward();
        let of_state = |state: &BodyLoad<'_>| {
            let tractions = self.tractions(state.forces);
            let along = DVector::from_iterator(tractions.len(), tractions.iter().map(|q| q[0]));
            let integrals = &kernel * along;
            let at = |(&place, integral): (&f64, &f64)| {
                let [shear, normal] =
                    potential::between(self.nodes.knots(), &tractions, place).map(|q| outward * q);
                [normal + 2.0 / PI * integral, normal, shear]
            };
            places.iter().zip(&integrals).map(at).collect()
        };
        Ok(states.iter().map(of_state).collect())
    }

    fn check(&self, state: &BodyLoad<'_>) -> Result<(), SeriesError> {
        let sizes = [
            2 * self.nodes.len(),
            self.mode_loads.len(),
            self.modes.ncols(),
        ];
        check(state, sizes)
    }

    /// The part along y of the outward normal.
    fn outward(&self) -> f64 {
        match self.ground.lies {
            Lies::Below => 1.0,
            Lies::Above => -1.0,
        }
    }

    /// Tractions along x and y at the places of the whole edge by nodal forces.
    fn tractions(&self, forces: &[f64]) -> Vec<[f64; 2]> {
        let (nodes, thickness) = (&self.nodes, self.ground.thickness);
        let mut tractions = vec![[0.0; 2]; nodes.knots().len()];
        for (node, (force, weight)) in forces.chunks_exact(2).zip(nodes.weights()).enumerate() {
            let [x, y] = [0, 1].map(|axis| force[axis] / (thickness * weight));
            // What is along x on the axis is taken up by symmetry.
            let x = if nodes.on_axis(node) { 0.0 } else { x };
            tractions[nodes.image(node)] = [-x, y];
            tractions[nodes.knot(node)] = [x, y];
        }
        tractions
    }
}

/// The compliance `[length/force]`, 2n × 2n.
fn compliance(nodes: &LineNodes, material: Kolosov, ground: Ground) -> DMatrix<f64> {
    let side = match ground.lies {
        Lies::Below => Side::Outside,
        Lies::Above => Side::Inside,
    };
    let surface = Surface::new(material, side);
    let [log, odd] = nodes.means();
    let scale = ground.reference.ln();
    let symmetry = Symmetry {
        mirrored: nodes.is_mirrored(),
        across: 0,
    };
    symmetry.assembled(
        nodes.len(),
        1.0 / (PI * ground.thickness),
        |node| nodes.on_axis(node),
        |row, column, of_image| {
            let knot = if of_image {
                nodes.image(column)
            } else {
                nodes.knot(column)
            };
            let at = (nodes.knot(row), knot);
            surface.at([log[at] + scale, odd[at]])
        },
    )
}

impl InterfaceOperator for HalfPlane {
    fn points(&self) -> &[Point] {
        &self.points
    }

    fn compliance(&self) -> Option<&DMatrix<f64>> {
        Some(&self.compliance)
    }

    fn modes(&self) -> &DMatrix<f64> {
        &self.modes
    }

    fn load_cases(&self) -> usize {
        self.mode_loads.len()
    }

    fn load_response(&self, _: usize) -> Option<&DVector<f64>> {
        None
    }

    fn mode_load(&self, case: usize) -> &DVector<f64> {
        &self.mode_loads[case]
    }
}
