//! A circular hole in an infinite anisotropic plate.

use nalgebra::{Complex, DMatrix, DVector};
use stickslip_fem_core::InterfaceOperator;
use stickslip_fem_core::body::BodyLoad;
use stickslip_fem_core::material::{Material, PlaneStiffness};
use stickslip_fem_core::mesh::Point;

use crate::circle::{Circle, compliance};
use crate::error::SeriesError;
use crate::field::{Hats, PolarStress, check, hats};
use crate::hole::FarLoad;
use crate::lekhnitskii::Lekhnitskii;
use crate::nodes::Nodes;

type C64 = Complex<f64>;

/// A circular hole in an infinite plate of any linear material, for example a laminate, in closed form; displacements are counted as those of a
/// [`Hole`](crate::Hole). Stresses are known on its edge.
///
/// ```
/// use stickslip_fem_core::body::BodyLoad;
/// use stickslip_fem_core::material::{Orthotropic, OrthotropicConstants};
/// use stickslip_series::{AnisotropicHole, Circle, FarLoad, Nodes};
///
/// let constants = OrthotropicConstants { e1: 12_400.0, e2: 3730.0, g12: 3210.0, nu12: 0.66 };
/// let plate = Orthotropic::new(constants, 0.0)?;
/// let circle = Circle { centre: [0.0, 0.0], radius: 1.0, thickness: 1.0 };
/// let pull = FarLoad { stress: [1.0, 0.0, 0.0], ..FarLoad::default() };
/// let hole = AnisotropicHole::held(Nodes::uniform_circle(12)?, &plate, circle, &[pull])?;
/// let state = BodyLoad { forces: &[0.0; 24], multipliers: &[1.0], motions: &[] };
/// let edge = hole.edge(&state)?;
/// // 1 + √(2 (√(E₁/E₂) − ν₁₂) + E₁/G₁₂) (Lekhnitskii 1968, § 37)
/// assert!((edge.at(std::f64::consts::FRAC_PI_2).hoop - 3.487_873_4).abs() < 1e-7);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct AnisotropicHole {
    nodes: Nodes,
    circle: Circle,
    loads: Vec<FarLoad>,
    material: PlaneStiffness,
    matrix: Lekhnitskii,
    points: Vec<Point>,
    compliance: DMatrix<f64>,
    modes: DMatrix<f64>,
    responses: Vec<Option<DVector<f64>>>,
    mode_loads: Vec<DVector<f64>>,
}

impl AnisotropicHole {
    /// A hole in a plate that is held far away, with `loads[k]` load case k, as [`Hole::held`](crate::Hole::held).
    ///
    /// # Errors
    /// As [`Hole::held`](crate::Hole::held), and [`SeriesError::Material`] for a material that is not stable, or does not mirror itself in the axis of a
    /// half model.
    pub fn held(
        nodes: Nodes,
        plate: &dyn Material,
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

    /// A hole in a plate that floats, as [`Hole::floating`](crate::Hole::floating).
    ///
    /// # Errors
    /// As [`Hole::floating`](crate::Hole::floating), and [`SeriesError::Material`].
    pub fn floating(
        nodes: Nodes,
        plate: &dyn Material,
        circle: Circle,
        loads: &[FarLoad],
    ) -> Result<Self, SeriesError> {
        let circle = circle.checked()?;
        for (case, load) in loads.iter().enumerate() {
            load.check(case, nodes.is_mirrored())?;
        }
        if nodes.is_mirrored() && !plate.symmetric_about_x() {
            let what = "does not mirror itself in the axis of the half model";
            return Err(SeriesError::Material { what });
        }
        let material = plate.compliance();
        let what = "has no positive definite stiffness";
        let matrix = Lekhnitskii::new(&material).ok_or(SeriesError::Material { what })?;
        let points = circle.places(&nodes);
        let response = |load: &FarLoad| {
            (load.stress != [0.0; 3])
                .then(|| far_response(&nodes, circle, &material, &matrix, load.stress))
        };
        let resultants = |load: &FarLoad| circle.resultants(&nodes, load.force, load.moment);
        Ok(Self {
            compliance: compliance(&nodes, matrix.surface(), circle.thickness),
            modes: circle.motions(&nodes, &points),
            responses: loads.iter().map(response).collect(),
            mode_loads: loads.iter().map(resultants).collect(),
            points,
            loads: loads.to_vec(),
            nodes,
            circle,
            material,
            matrix,
        })
    }

    /// The stresses on the edge under nodal forces, load cases and rigid motions: 2n forces `[force]`, one multiplier of each load case, one amount
    /// of each rigid motion.
    ///
    /// # Errors
    /// [`SeriesError::State`] for numbers that are too few or too many.
    pub fn edge(&self, state: &BodyLoad<'_>) -> Result<EdgeStress, SeriesError> {
        check(
            state,
            [2 * self.points.len(), self.loads.len(), self.modes.ncols()],
        )?;
        let mut far = [0.0; 3];
        for (load, factor) in self.loads.iter().zip(state.multipliers) {
            for (sum, part) in far.iter_mut().zip(load.stress) {
                *sum += factor * part;
            }
        }
        Ok(EdgeStress {
            hats: hats(&self.nodes, self.circle, state.forces, -1.0),
            material: self.material,
            matrix: self.matrix,
            far,
        })
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

/// Stresses on the edge of a hole in an anisotropic plate.
///
/// ```text
/// du/dθ = R (2 Re M T + d(ε_∞ e_r)/dθ − 2 Re M q_−1 e^{−iθ}),   T: modes e^{−inθ}, n ≥ 1, of the stresses on the circle,   q_−1 = σ_∞ (½, i/2)
/// ε_θθ = e_θ · du/dθ / R,     σ_θθ from ε_θθ, σ_rr and σ_rθ by Hooke's law
/// ```
#[derive(Clone, Debug)]
pub struct EdgeStress {
    hats: Hats,
    material: PlaneStiffness,
    matrix: Lekhnitskii,
    far: [f64; 3],
}

impl EdgeStress {
    /// Stress `[stress]` at the angle `theta` `[rad]`: σ_rr and σ_rθ interpolated between nodes, σ_θθ exact for these, with a kink of infinite slope at nodes.
    pub fn at(&self, theta: f64) -> PolarStress {
        let (sin, cos) = theta.sin_cos();
        let direction = C64::new(cos, sin);
        let traction = self.hats.at(theta) * direction.conj();
        let [xx, yy, xy] = self.strain();
        let [mx, my] = self.matrix.apply(self.moving(theta, direction));
        let slope = [
            2.0 * mx.re - xx * sin + 0.5 * xy * cos,
            2.0 * my.re - 0.5 * xy * sin + yy * cos,
        ];
        let strain = slope[1] * cos - slope[0] * sin;
        // ε_θθ of a stress, and the stresses σ_rr = 1, σ_θθ = 1, σ_rθ = 1, in Voigt order.
        let hoop = [sin * sin, cos * cos, -sin * cos];
        let radial = [cos * cos, sin * sin, sin * cos];
        let shear = [-2.0 * sin * cos, 2.0 * sin * cos, cos * cos - sin * sin];
        let by = |stress: [f64; 3]| -> f64 {
            let rows = self.material.iter().zip(hoop);
            rows.map(|(row, part)| part * (0..3).map(|k| row[k] * stress[k]).sum::<f64>())
                .sum()
        };
        let rest = traction.re * by(radial) + traction.im * by(shear);
        PolarStress {
            radial: traction.re,
            hoop: (strain - rest) / by(hoop),
            shear: traction.im,
        }
    }

    /// Far strain (xx, yy, engineering xy).
    fn strain(&self) -> [f64; 3] {
        self.material
            .map(|row| (0..3).map(|k| row[k] * self.far[k]).sum())
    }

    /// The modes e^{−inθ} of the stresses on the circle along x and y, less those that the far stress would have there.
    fn moving(&self, theta: f64, direction: C64) -> [C64; 2] {
        let [positive, negative] = self.hats.on_edge(theta, C64::new(1.0, 0.0));
        let [xx, yy, xy] = self.far;
        let far = [(xx, xy), (xy, yy)].map(|(x, y)| C64::new(0.5 * x, 0.5 * y) * direction.conj());
        let x = 0.5 * (negative + positive.conj());
        let y = (negative - positive.conj()) * C64::new(0.0, -0.5);
        [x - far[0], y - far[1]]
    }
}

/// Motion of the nodes of a free hole by a far stress: ε_∞ x + 2 Re(−iMR q_−1 e^{−iθ}).
fn far_response(
    nodes: &Nodes,
    circle: Circle,
    material: &PlaneStiffness,
    matrix: &Lekhnitskii,
    [xx, yy, xy]: [f64; 3],
) -> DVector<f64> {
    let stress = [xx, yy, xy];
    let [exx, eyy, exy] = material.map(|row| (0..3).map(|k| row[k] * stress[k]).sum::<f64>());
    let q = [(xx, xy), (xy, yy)].map(|(x, y)| C64::new(0.5 * x, 0.5 * y));
    let [mx, my] = matrix.apply(q);
    let means = nodes.mode_means(1);
    let radius = circle.radius;
    let mut response = DVector::zeros(2 * nodes.len());
    for (node, mean) in means.iter().enumerate() {
        let turn = C64::new(0.0, -2.0) * mean.conj();
        response[2 * node] = radius * ((mx * turn).re + exx * mean.re + 0.5 * exy * mean.im);
        if !nodes.on_axis(node) {
            response[2 * node + 1] =
                radius * ((my * turn).re + 0.5 * exy * mean.re + eyy * mean.im);
        }
    }
    response
}

impl InterfaceOperator for AnisotropicHole {
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
