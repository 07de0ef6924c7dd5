//! A circular disk, loaded and held at its centre or over its area.
//!
//! With 2G u/R = Σ U_K e^{iKθ} and tractions q = Σ q_K e^{iKθ} on the rim,
//!
//! ```text
//! U_K = κ q_K/K (K ≥ 3),   U_−K = q_−K/K (K ≥ 1),   U_1 = (κ − 1)/2 Re q_1,
//! U_2 = κ q_2/2 − μ conj q_0,   U_0 = d q_0 − μ conj q_2
//! ```
//!
//! The net force q_0 is balanced by an opposite one at the centre (μ = 1) or spread evenly over the area (μ = ½); the moment Im q_1 by one
//! there, which only turns the rim. Displacements are counted from that of the support, the one on which its force works, which makes C symmetric:
//!
//! | support | counted from | d |
//! | --- | --- | --- |
//! | area | mean displacement of the area | ½ |
//! | centre | displacement of the centre; that by a force there, which is infinite, is its mean on a circle of radius sR about it | (2 − 2s² − 2κ ln s)/(1 + κ) |
//!
//! So s only says how far a net force moves the disk as a whole, a rigid motion. Stresses do not depend on it.
//!
//! Source: Muskhelishvili, *Some Basic Problems* (1953), §§ 54, 56; the even body force from 2G u = −(κ − 1)/(2κ) b |z|².

use nalgebra::{DMatrix, DVector};
use stickslip_fem_core::InterfaceOperator;
use stickslip_fem_core::body::BodyLoad;
use stickslip_fem_core::material::Isotropic;
use stickslip_fem_core::mesh::Point;

use crate::channel::{Unit, channels, hat_means, sides};
use crate::circle::{Circle, Kolosov, Side, Surface, check_load, compliance};
use crate::error::SeriesError;
use crate::expansion::Expansions;
use crate::field::{Body, Edge, EdgeOf, Field, Ingredients, Inside, PolarStress, check, forces};
use crate::nodes::Nodes;

/// Largest s: beyond it the work of a force could become negative.
const LARGEST_CIRCLE: f64 = 0.25;

/// Where forces on a disk other than those on its rim act.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Anchor {
    /// At the centre. Its displacement by a force there is the mean on a circle about it with `circle` times the disk's radius, at most a quarter.
    Centre {
        /// The factor s `[1]`.
        circle: f64,
    },
    /// Evenly over the area.
    Area,
}

impl Default for Anchor {
    /// The centre, s = 0.01.
    fn default() -> Self {
        Self::Centre { circle: 0.01 }
    }
}

/// What acts on a disk besides contact. In a half model it is that on the whole disk, and has no force along y or moment.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct DiskLoad {
    /// Force `[force]` at the anchor of a floating disk.
    pub force: [f64; 2],
    /// Moment `[force·length]` at the anchor.
    pub moment: f64,
    /// Displacement `[length]` of the anchor of a held disk.
    pub displacement: [f64; 2],
}

/// A circular isotropic disk, in closed form.
///
/// ```
/// use stickslip_fem_core::InterfaceOperator;
/// use stickslip_fem_core::material::{Isotropic, PlaneState};
/// use stickslip_series::{Anchor, Circle, Disk, DiskLoad, Nodes};
///
/// let steel = Isotropic::new(210_000.0, 0.3, PlaneState::Strain)?;
/// let circle = Circle { centre: [0.0, 0.0], radius: 5.0, thickness: 2.0 };
/// let push = DiskLoad { force: [1000.0, 0.0], ..DiskLoad::default() };
/// let pin = Disk::floating(Nodes::uniform_circle(90)?, &steel, circle, Anchor::default(), &[push])?;
/// assert_eq!(pin.modes().ncols(), 3);
/// assert_eq!(pin.mode_load(0)[0], 1000.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Disk {
    nodes: Nodes,
    circle: Circle,
    material: Kolosov,
    anchor: Anchor,
    loads: Vec<DiskLoad>,
    expansions: Expansions,
    points: Vec<Point>,
    compliance: DMatrix<f64>,
    modes: DMatrix<f64>,
    responses: Vec<Option<DVector<f64>>>,
    mode_loads: Vec<DVector<f64>>,
}

impl Disk {
    /// A disk whose anchor is held or moved, with `loads[k]` load case k. It may turn about its centre; in a half model it has no rigid motion.
    ///
    /// # Errors
    /// [`SeriesError::Length`] for a length that is not positive, [`SeriesError::CentreCircle`] for s outside of 0 to ¼;
    /// [`SeriesError::LoadNotFinite`], [`SeriesError::NotSymmetric`] for a load that does not fit; [`SeriesError::LoadOnSupport`] for a force,
    /// which the support takes up.
    pub fn held(
        nodes: Nodes,
        material: &Isotropic,
        circle: Circle,
        anchor: Anchor,
        loads: &[DiskLoad],
    ) -> Result<Self, SeriesError> {
        let what = "the force";
        if let Some(case) = loads.iter().position(|load| load.force != [0.0; 2]) {
            return Err(SeriesError::LoadOnSupport { case, what });
        }
        let mut disk = Self::of(nodes, material, circle, anchor, loads)?;
        let held = if disk.nodes.is_mirrored() { 1 } else { 2 };
        let left = disk.modes.ncols() - held;
        disk.modes = disk.modes.columns(held, left).into_owned();
        for load in &mut disk.mode_loads {
            *load = load.rows(held, left).into_owned();
        }
        Ok(disk)
    }

    /// A disk that floats: translations along x and y and the turn about its centre divided by its radius are its rigid motions, in a half model
    /// the translation along x. `loads[k]` is load case k.
    ///
    /// # Errors
    /// As [`Disk::held`], with [`SeriesError::NoSupport`] for a displacement.
    pub fn floating(
        nodes: Nodes,
        material: &Isotropic,
        circle: Circle,
        anchor: Anchor,
        loads: &[DiskLoad],
    ) -> Result<Self, SeriesError> {
        let what = "the displacement";
        if let Some(case) = loads.iter().position(|load| load.displacement != [0.0; 2]) {
            return Err(SeriesError::NoSupport { case, what });
        }
        Self::of(nodes, material, circle, anchor, loads)
    }

    fn of(
        nodes: Nodes,
        material: &Isotropic,
        circle: Circle,
        anchor: Anchor,
        loads: &[DiskLoad],
    ) -> Result<Self, SeriesError> {
        let circle = circle.checked()?;
        if let Anchor::Centre { circle: ratio } = anchor
            && !(ratio > 0.0 && ratio <= LARGEST_CIRCLE)
        {
            let largest = LARGEST_CIRCLE;
            return Err(SeriesError::CentreCircle { ratio, largest });
        }
        for (case, load) in loads.iter().enumerate() {
            let values = [
                ("the force along x", load.force[0], false),
                ("the force along y", load.force[1], true),
                ("the moment", load.moment, true),
                ("the displacement along x", load.displacement[0], false),
                ("the displacement along y", load.displacement[1], true),
            ];
            check_load(case, nodes.is_mirrored(), &values)?;
        }
        let material = Kolosov::from(material);
        let mut compliance = compliance(
            &nodes,
            Surface::new(material, Side::Inside),
            circle.thickness,
        );
        add_low_modes(&mut compliance, &nodes, material, anchor, circle.thickness);
        let points = circle.places(&nodes);
        let modes = circle.motions(&nodes, &points);
        let resultants = |load: &DiskLoad| circle.resultants(&nodes, load.force, load.moment);
        Ok(Self {
            compliance,
            modes,
            responses: loads
                .iter()
                .map(|load| translation(load, points.len()))
                .collect(),
            mode_loads: loads.iter().map(resultants).collect(),
            points,
            loads: loads.to_vec(),
            expansions: Expansions::default(),
            nodes,
            circle,
            material,
            anchor,
        })
    }

    /// The field under nodal forces, load cases and rigid motions: 2n forces `[force]`, one multiplier of each load case, one amount of each rigid motion.
    ///
    /// # Errors
    /// [`SeriesError::State`] for numbers that are too few or too many.
    pub fn field(&self, state: &BodyLoad<'_>) -> Result<Field, SeriesError> {
        check(
            state,
            [2 * self.points.len(), self.loads.len(), self.modes.ncols()],
        )?;
        let of = Ingredients {
            nodes: &self.nodes,
            circle: self.circle,
            unit: self.circle.radius / (2.0 * self.material.shear),
            forces: state.forces,
            inside: true,
        };
        let hats = of.hats();
        let kappa = self.material.kappa;
        let inside = Inside::new(&hats, self.nodes.is_mirrored(), self.is_centred());
        let (translation, turn) = inside.rigid(kappa, support(self.anchor, kappa));
        let unit = self.circle.radius / (2.0 * self.material.shear);
        // What a held disk does not have are translations.
        let all = if self.nodes.is_mirrored() { 1 } else { 3 };
        let mut rigid = [0.0; 3];
        let held = all - self.modes.ncols();
        rigid[held..all].copy_from_slice(state.motions);
        rigid[0] += unit * translation.re;
        rigid[1] += unit * translation.im;
        rigid[2] += unit * turn;
        for (load, factor) in self.loads.iter().zip(state.multipliers) {
            for (sum, part) in rigid.iter_mut().zip(load.displacement) {
                *sum += factor * part;
            }
        }
        let field = Field::new(&of, hats, Body::Inside(inside, kappa), rigid);
        Ok(field.expanded(self.expansions.of(state.multipliers)))
    }

    /// The same body with the uniform strains `strains[k]` (ε_xx, ε_yy, γ_xy) `[1]` in load case k, as by a change of temperature. Nothing hinders them: they move the
    /// body about its circle's centre and make no stress.
    ///
    /// # Errors
    /// [`SeriesError::State`] for another number of strains than of load cases, [`SeriesError::LoadNotFinite`], [`SeriesError::NotSymmetric`] for a shear strain of a half
    /// model.
    pub fn with_expansions(mut self, strains: &[[f64; 3]]) -> Result<Self, SeriesError> {
        let places = (self.points.as_slice(), self.circle.centre);
        let mirrored = self.nodes.is_mirrored();
        self.expansions = Expansions::added_to(&mut self.responses, strains, places, mirrored)?;
        Ok(self)
    }

    fn is_centred(&self) -> bool {
        matches!(self.anchor, Anchor::Centre { .. })
    }

    /// Stresses `[stress]` at the angles `angles` `[rad]` of the rim under each of `states`, as [`Field::edge`] of each field, by state and angle.
    ///
    /// # Errors
    /// [`SeriesError::State`] for numbers that are too few or too many.
    pub fn edge_stresses(
        &self,
        states: &[BodyLoad<'_>],
        angles: &[f64],
    ) -> Result<Vec<Vec<PolarStress>>, SeriesError> {
        let size = 2 * self.points.len();
        let forces = forces(states, [size, self.loads.len(), self.modes.ncols()])?;
        let edge = Edge {
            nodes: &self.nodes,
            circle: self.circle,
            of: EdgeOf::Disk,
            angles,
        };
        let loads = edge.loads(&forces);
        let directions = edge.directions();
        let mut further = DMatrix::zeros(angles.len(), states.len());
        for (load, mut column) in loads.iter().zip(further.column_iter_mut()) {
            let inside = load.inside(self.nodes.is_mirrored(), self.is_centred());
            for (sum, direction) in column.iter_mut().zip(&directions) {
                *sum = inside.low_sum_on_edge(*direction, self.material.kappa);
            }
        }
        Ok(edge.stresses(&loads, &further))
    }

    /// The nodes.
    pub fn nodes(&self) -> &Nodes {
        &self.nodes
    }

    /// The disk's circle.
    pub fn circle(&self) -> Circle {
        self.circle
    }

    /// Where its support and its loads act.
    pub fn anchor(&self) -> Anchor {
        self.anchor
    }
}

fn translation(load: &DiskLoad, count: usize) -> Option<DVector<f64>> {
    let moves = load.displacement != [0.0; 2];
    moves.then(|| DVector::from_fn(2 * count, |row, _| load.displacement[row % 2]))
}

/// μ and d of the module's equation.
pub(crate) fn support(anchor: Anchor, kappa: f64) -> [f64; 2] {
    match anchor {
        Anchor::Area => [0.5, 0.5],
        Anchor::Centre { circle } => {
            let mean = 2.0 - 2.0 * circle * circle - 2.0 * kappa * circle.ln();
            [1.0, mean / (1.0 + kappa)]
        }
    }
}

/// Adds what modes 0, 1 and 2 have beyond κ/K.
fn add_low_modes(
    compliance: &mut DMatrix<f64>,
    nodes: &Nodes,
    material: Kolosov,
    anchor: Anchor,
    thickness: f64,
) {
    let kappa = material.kappa;
    let [coupling, mean] = support(anchor, kappa);
    let channels = channels(nodes, [0, 1, 2]);
    let means = hat_means(nodes, &channels);
    let entry = |row: usize, column: usize| {
        let [to, from] = [channels[row], channels[column]];
        if to.unit != from.unit {
            return 0.0;
        }
        let conjugate = if to.unit == Unit::Real { 1.0 } else { -1.0 };
        match (to.order, from.order, to.unit) {
            (0, 0, _) => mean,
            (0, 2, _) | (2, 0, _) => -coupling * conjugate,
            (1, 1, Unit::Real) => -0.5 * (kappa + 1.0),
            (1, 1, Unit::Imaginary) => -kappa,
            _ => 0.0,
        }
    };
    let small = DMatrix::from_fn(channels.len(), channels.len(), entry);
    let unit = sides(nodes) / (4.0 * std::f64::consts::PI * material.shear * thickness);
    let weighted = &means * small * unit;
    compliance.gemm(1.0, &weighted, &means.transpose(), 1.0);
}

impl InterfaceOperator for Disk {
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
        self.loads.len()
    }

    fn load_response(&self, case: usize) -> Option<&DVector<f64>> {
        self.responses[case].as_ref()
    }

    fn mode_load(&self, case: usize) -> &DVector<f64> {
        &self.mode_loads[case]
    }
}
