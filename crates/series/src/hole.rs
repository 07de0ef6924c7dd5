//! A circular hole in an infinite plate.

use nalgebra::{Complex, DMatrix, DVector};
use stickslip_fem_core::InterfaceOperator;
use stickslip_fem_core::body::BodyLoad;
use stickslip_fem_core::material::Isotropic;
use stickslip_fem_core::mesh::Point;

use crate::channel::{Channel, Unit, channels, hat_means};
use crate::circle::{Circle, Kolosov, Side, Surface, check_load, compliance};
use crate::error::SeriesError;
use crate::field::{
    Body, Edge, EdgeOf, Field, Ingredients, Outside, PolarStress, check, forces, motions,
};
use crate::nodes::Nodes;

/// What acts on the plate far from the hole. In a half model it is that on the whole plate, and has no force along y, moment or shear.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct FarLoad {
    /// Force `[force]`, uniform around a circle of any size about the hole; it balances forces on the hole.
    pub force: [f64; 2],
    /// Moment about the hole's centre `[force·length]`.
    pub moment: f64,
    /// Stress (xx, yy, xy) `[stress]`.
    pub stress: [f64; 3],
}

impl FarLoad {
    /// Checks a load of a plate that is held far away.
    pub(crate) fn check_held(&self, case: usize, mirrored: bool) -> Result<(), SeriesError> {
        self.check(case, mirrored)?;
        if self.force != [0.0; 2] || self.moment != 0.0 {
            let what = "the force or moment far away";
            return Err(SeriesError::LoadOnSupport { case, what });
        }
        Ok(())
    }

    pub(crate) fn check(&self, case: usize, mirrored: bool) -> Result<(), SeriesError> {
        let [xx, yy, xy] = self.stress;
        let [x, y] = self.force;
        let values = [
            ("the force along x", x, false),
            ("the force along y", y, true),
            ("the moment", self.moment, true),
            ("the stress xx", xx, false),
            ("the stress yy", yy, false),
            ("the stress xy", xy, true),
        ];
        check_load(case, mirrored, &values)
    }
}

/// A circular hole in an infinite isotropic plate, in closed form.
///
/// ```text
/// u = C λ + Σ_k m_k u_k + R α
/// ```
///
/// Displacements are counted from the mean one of the hole's edge: a force on the hole moves it infinitely far from infinity (ln r). C is
/// that of balanced forces; a net force is balanced by a [`FarLoad`] or, of a plate that is held, far away. The rotation is that against infinity.
///
/// Source: Muskhelishvili, *Some Basic Problems* (1953), § 56.
///
/// ```
/// use stickslip_fem_core::InterfaceOperator;
/// use stickslip_fem_core::material::{Isotropic, PlaneState};
/// use stickslip_series::{Circle, FarLoad, Hole, Nodes};
///
/// let plate = Isotropic::new(70_000.0, 0.3, PlaneState::Stress)?;
/// let circle = Circle { centre: [0.0, 0.0], radius: 5.0, thickness: 2.0 };
/// let pull = FarLoad { stress: [100.0, 0.0, 0.0], ..FarLoad::default() };
/// let hole = Hole::held(Nodes::uniform_half(61)?, &plate, circle, &[pull])?;
/// // Kirsch (1898): the hole's edge moves by 3 σ R/E along the pull.
/// let u = hole.load_response(0).ok_or("the pull moves the edge")?;
/// assert!((u[0] / (3.0 * 100.0 * 5.0 / 70_000.0) - 1.0).abs() < 1e-3);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Hole {
    nodes: Nodes,
    circle: Circle,
    material: Kolosov,
    loads: Vec<FarLoad>,
    points: Vec<Point>,
    compliance: DMatrix<f64>,
    modes: DMatrix<f64>,
    responses: Vec<Option<DVector<f64>>>,
    mode_loads: Vec<DVector<f64>>,
}

impl Hole {
    /// A hole in a plate that is held far away, with `loads[k]` load case k. It has no rigid motion. The mean displacement of the edge by a net force,
    /// infinite against a hold infinitely far away, is left out.
    ///
    /// # Errors
    /// [`SeriesError::Length`] for a length that is not positive; [`SeriesError::LoadNotFinite`], [`SeriesError::NotSymmetric`] for a load that
    /// does not fit; [`SeriesError::LoadOnSupport`] for a far force or moment, which the far hold takes up.
    pub fn held(
        nodes: Nodes,
        plate: &Isotropic,
        circle: Circle,
        loads: &[FarLoad],
    ) -> Result<Self, SeriesError> {
        for (case, load) in loads.iter().enumerate() {
            load.check_held(case, nodes.is_mirrored())?;
        }
        let mut hole = Self::floating(nodes, plate, circle, loads)?;
        hole.modes = hole.modes.columns(0, 0).into_owned();
        hole.mode_loads = vec![DVector::zeros(0); loads.len()];
        Ok(hole)
    }

    /// A hole in a plate that floats: translations along x and y and the turn about the hole divided by its radius are its rigid motions, in
    /// a half model the translation along x. `loads[k]` is load case k.
    ///
    /// # Errors
    /// As [`Hole::held`], save that all loads have an effect.
    pub fn floating(
        nodes: Nodes,
        plate: &Isotropic,
        circle: Circle,
        loads: &[FarLoad],
    ) -> Result<Self, SeriesError> {
        let circle = circle.checked()?;
        for (case, load) in loads.iter().enumerate() {
            load.check(case, nodes.is_mirrored())?;
        }
        let material = Kolosov::from(plate);
        let points = circle.places(&nodes);
        let modes = circle.motions(&nodes, &points);
        let responses = responses(&nodes, material, circle.radius, loads);
        let resultants = |load: &FarLoad| circle.resultants(&nodes, load.force, load.moment);
        Ok(Self {
            compliance: compliance(
                &nodes,
                Surface::new(material, Side::Outside),
                circle.thickness,
            ),
            mode_loads: loads.iter().map(resultants).collect(),
            responses,
            points,
            modes,
            loads: loads.to_vec(),
            nodes,
            circle,
            material,
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
            inside: false,
        };
        let [phi, psi] = self.far(state);
        let mut outside = Outside {
            even: [phi, psi],
            ..Outside::default()
        };
        outside.add_mode(1, -2.0 * phi);
        outside.add_mode(-1, psi.conj());
        Ok(Field::new(
            &of,
            of.hats(),
            Body::Outside(outside, self.material.kappa),
            motions(state.motions),
        ))
    }

    /// φ′ and ψ′ of the stress far away.
    fn far(&self, state: &BodyLoad<'_>) -> [Complex<f64>; 2] {
        let mut stress = [0.0; 3];
        for (load, factor) in self.loads.iter().zip(state.multipliers) {
            for (sum, part) in stress.iter_mut().zip(load.stress) {
                *sum += factor * part;
            }
        }
        let [xx, yy, xy] = stress;
        [
            Complex::new(0.25 * (xx + yy), 0.0),
            Complex::new(0.5 * (yy - xx), xy),
        ]
    }

    /// Stresses `[stress]` at the angles `angles` `[rad]` of the edge under each of `states`, as [`Field::edge`] of each field, by state and angle.
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
            of: EdgeOf::Plate,
            angles,
        };
        let loads = edge.loads(&forces);
        let directions = edge.directions();
        let further = DMatrix::from_fn(angles.len(), states.len(), |place, state| {
            let [phi, psi] = self.far(&states[state]);
            let inverse = directions[place].conj();
            let a = loads[state].mean / (1.0 + self.material.kappa);
            4.0 * (phi + (a + psi.conj() * inverse) * inverse).re
        });
        Ok(edge.stresses(&loads, &further))
    }

    /// The nodes.
    pub fn nodes(&self) -> &Nodes {
        &self.nodes
    }

    /// The hole's circle.
    pub fn circle(&self) -> Circle {
        self.circle
    }
}

/// Motion of the edge of a free hole under far stresses (Kirsch 1898):
/// 2G u/R = (1 + κ) [(σ_xx + σ_yy)/4 e^{iθ} + ((σ_xx − σ_yy)/2 + iσ_xy) e^{−iθ}].
fn responses(
    nodes: &Nodes,
    material: Kolosov,
    radius: f64,
    loads: &[FarLoad],
) -> Vec<Option<DVector<f64>>> {
    let channels = channels(nodes, [1, -1]);
    let means = hat_means(nodes, &channels);
    let unit = radius * (1.0 + material.kappa) / (2.0 * material.shear);
    let response = |load: &FarLoad| {
        let [xx, yy, xy] = load.stress;
        if load.stress == [0.0; 3] {
            return None;
        }
        let amounts = channels.iter().map(|channel| match channel {
            Channel {
                order: 1,
                unit: Unit::Real,
            } => 0.25 * (xx + yy) * unit,
            Channel {
                order: -1,
                unit: Unit::Real,
            } => 0.5 * (xx - yy) * unit,
            Channel {
                order: -1,
                unit: Unit::Imaginary,
            } => xy * unit,
            _ => 0.0,
        });
        Some(&means * DVector::from_iterator(channels.len(), amounts))
    };
    loads.iter().map(response).collect()
}

impl InterfaceOperator for Hole {
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
