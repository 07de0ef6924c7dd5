//! A plate with straight outer edges around a circular hole.
//!
//! ```text
//! u = C λ + Σ_k m_k u_k + R α,     C = P (C_∞ + V E X Vᵀ) Pᵀ,     P = 1 − R Sᵀ,   Rᵀ S = 1
//! ```
//!
//! C_∞ is that of the hole in the infinite plate. X Vᵀ λ are the amounts of polynomials that keep the outer edge free, by a least-squares fit, and V E the
//! motion of the hole that they make. Modes of the hole reach the outer edge as (R/d)^K, so the second part has low rank. The plate floats: even tractions S on the
//! hole balance every load before it is fitted, and displacements are counted from the mean motion of the hole. The traction that the fit leaves on the outer
//! edge is known, [`Fit::residual`]; by Saint-Venant's principle it does much less on the hole.
//!
//! Corners of any angle take any even tractions. Fits converge fastest where corners have 90°, more slowly where they are wider; a strip much longer than wide
//! needs a high degree.
//!
//! Source: Muskhelishvili, *Some Basic Problems* (1953), §§ 56–59; Brubeck, Nakatsukasa & Trefethen, SIAM Rev. 63 (2021) 405–415.

mod degree;
mod fit;
mod hold;
mod least_squares;
mod loads;

use std::f64::consts::PI;

use nalgebra::{DMatrix, DVector};
use stickslip_fem_core::InterfaceOperator;
use stickslip_fem_core::body::BodyLoad;
use stickslip_fem_core::material::{Isotropic, Material};
use stickslip_fem_core::mesh::Point;

use crate::channel::{Unit, hat_means, sides};
use crate::circle::{Circle, Kolosov, compliance};
use crate::elasticity::Elasticity;
use crate::error::SeriesError;
use crate::expansion::Expansions;
use crate::field::{
    Body, Edge, EdgeOf, Field, Ingredients, Outside, PolarStress, check, combined, forces,
};
use crate::lekhnitskii::Planes;
use crate::nodes::Nodes;
use crate::outline::{Outline, Surrounding};
pub use degree::Accuracy;
use degree::{fitted, orders};
use fit::{OuterFit, Task, channels};
use hold::Hold;
pub use loads::EdgeLoad;
use loads::actions;

/// What the fit of an outer edge took and what it left.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fit {
    /// Real unknowns.
    pub columns: usize,
    /// Points at which tractions are fitted.
    pub points: usize,
    /// Largest order |K| of the hole's modes at the outer edge.
    pub orders: usize,
    /// Largest traction left on the outer edge, at points between those of the fit, relative to the mean one `[1]`: of load cases over the loaded edges, of
    /// tractions on the hole over the outline under a net force on the hole.
    pub residual: f64,
}

/// A plate with straight outer edges around a circular hole, free but for loads on its edges. It floats: translations along x and y and the turn about
/// the hole divided by its radius are its rigid motions, in a half model the translation along x.
///
/// ```
/// use stickslip_fem_core::InterfaceOperator;
/// use stickslip_fem_core::material::{Isotropic, PlaneState};
/// use stickslip_series::{Accuracy, Circle, EdgeLoad, Nodes, Outline, Plate};
///
/// let aluminium = Isotropic::new(10.4e6, 0.33, PlaneState::Stress)?;
/// let circle = Circle { centre: [0.0, 0.0], radius: 0.375, thickness: 0.06 };
/// let strip = Outline::strip(5.5, 1.5, 1.5);
/// let pull = vec![EdgeLoad { edge: 3, force: [-1240.0, 0.0] }];
/// let nodes = Nodes::uniform_half(61)?;
/// let plate = Plate::new(nodes, &aluminium, circle, &strip, &[pull], Accuracy::default())?;
/// assert_eq!(plate.mode_load(0)[0], -620.0);
/// assert!(plate.fit().residual < 2e-3);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Plate {
    nodes: Nodes,
    circle: Circle,
    elasticity: Elasticity,
    surrounding: Surrounding,
    fits: Vec<Part>,
    /// Even tractions on the hole that balance forces.
    hold: Hold,
    /// Nodal forces that balance each load case.
    balance: Vec<DVector<f64>>,
    /// Rigid motions that were taken off the displacements by balanced nodal forces, f × 2n, and by load cases, f × cases.
    taken: [DMatrix<f64>; 2],
    points: Vec<Point>,
    compliance: DMatrix<f64>,
    responses: Vec<Option<DVector<f64>>>,
    expansions: Expansions,
    mode_loads: Vec<DVector<f64>>,
}

/// The fit for some of the units of coefficients.
#[derive(Clone, Debug)]
struct Part {
    fit: OuterFit,
    /// V of its channels.
    means: DMatrix<f64>,
}

impl Plate {
    /// The plate with `outline` around `circle`, with the forces `loads[k]` in load case k.
    ///
    /// # Errors
    /// [`SeriesError::Length`] for a length that is not positive; [`SeriesError::Outline`], [`SeriesError::HoleOutside`] for an outline that does not go
    /// around the hole, [`SeriesError::Ligament`] where it comes so close that the modes of the hole do not decay; [`SeriesError::NotMirrored`] for a half model
    /// in an outline that is not symmetric about the x axis through the hole; [`SeriesError::UnknownEdge`], [`SeriesError::LoadNotFinite`],
    /// [`SeriesError::NotSymmetric`] for a load that does not fit; [`SeriesError::NotFitted`] where a tenth of the load is left on the outer edge.
    pub fn new(
        nodes: Nodes,
        material: &Isotropic,
        circle: Circle,
        outline: &Outline,
        loads: &[Vec<EdgeLoad>],
        accuracy: Accuracy,
    ) -> Result<Self, SeriesError> {
        let elasticity = Elasticity::Isotropic(Kolosov::from(material));
        Self::of(nodes, elasticity, circle, outline, loads, accuracy)
    }

    /// The same of any linear material, for example a laminate; of an isotropic one [`new`](Self::new) makes it.
    ///
    /// # Errors
    /// As [`new`](Self::new), and [`SeriesError::Material`] for a material that is not stable, that is isotropic, or that does not mirror itself in the axis
    /// of a half model.
    pub fn anisotropic(
        nodes: Nodes,
        material: &dyn Material,
        circle: Circle,
        outline: &Outline,
        loads: &[Vec<EdgeLoad>],
        accuracy: Accuracy,
    ) -> Result<Self, SeriesError> {
        if nodes.is_mirrored() && !material.symmetric_about_x() {
            let what = "does not mirror itself in the axis of the half model";
            return Err(SeriesError::Material { what });
        }
        let what = "has no positive definite stiffness, or is isotropic";
        let planes = Planes::new(&material.compliance()).ok_or(SeriesError::Material { what })?;
        let elasticity = Elasticity::Anisotropic(planes);
        Self::of(nodes, elasticity, circle, outline, loads, accuracy)
    }

    fn of(
        nodes: Nodes,
        elasticity: Elasticity,
        circle: Circle,
        outline: &Outline,
        loads: &[Vec<EdgeLoad>],
        accuracy: Accuracy,
    ) -> Result<Self, SeriesError> {
        let circle = circle.checked()?;
        let mut surrounding = Surrounding::new(outline, circle)?.fitting(&nodes)?;
        if let Elasticity::Anisotropic(planes) = &elasticity
            && !planes.is_symmetric()
        {
            surrounding.images = None;
        }
        let actions = actions(&nodes, circle, outline, &surrounding, loads)?;
        let points = circle.places(&nodes);
        let modes = circle.motions(&nodes, &points);
        let hold = Hold::new(&nodes, modes);
        let mode_loads: Vec<DVector<f64>> = (actions.resultants.iter())
            .map(|[x, y, moment]| circle.resultants(&nodes, [*x, *y], *moment))
            .collect();
        let balance = hold.balance(&mode_loads);
        let distance = fit::distance(&elasticity, &surrounding);
        let orders = orders(distance, circle, accuracy.tolerance)?;
        let to_traction = sides(&nodes) / (2.0 * PI * circle.radius * circle.thickness);
        let part = |units| {
            let channels = channels(units, orders);
            let means = hat_means(&nodes, &channels);
            let task = Task {
                surrounding: &surrounding,
                units,
                orders,
                channels: &channels,
                elasticity: &elasticity,
                tractions: &actions.tractions,
                reactions: &(means.tr_mul(&balance) * -to_traction),
            };
            let fit = fitted(&task, accuracy)?;
            Ok(Part { fit, means })
        };
        let fits = unit_sets(&nodes, &surrounding)
            .into_iter()
            .map(part)
            .collect::<Result<Vec<Part>, SeriesError>>()?;
        let surface = elasticity.outside();
        let mut compliance = compliance(&nodes, surface, circle.thickness);
        let mut responses = &compliance * &balance;
        let unit = elasticity.unit(circle.radius);
        for part in &fits {
            part.add_motion([unit, to_traction], &mut compliance, &mut responses);
        }
        let by_loads = hold.measure(&mut responses);
        let by_forces = hold.measure(&mut compliance);
        Ok(Self {
            compliance: hold.symmetric(compliance),
            taken: [by_forces, by_loads],
            balance: columns(&balance),
            responses: columns(&responses).into_iter().map(Some).collect(),
            expansions: Expansions::default(),
            mode_loads,
            points,
            fits,
            hold,
            surrounding,
            nodes,
            circle,
            elasticity,
        })
    }

    /// What the fit of the outer edge took and left; of an outline that is symmetric while the nodes are whole, the sums and the largest of both parts.
    pub fn fit(&self) -> Fit {
        let fits = || self.fits.iter().map(|part| &part.fit);
        let orders = |fit: &OuterFit| fit.channels.iter().map(|channel| channel.order).max();
        Fit {
            columns: fits().map(OuterFit::columns).sum(),
            points: fits().map(|fit| fit.points).sum(),
            orders: fits().filter_map(orders).max().unwrap_or(0) as usize,
            residual: fits().map(|fit| fit.residual).fold(0.0, f64::max),
        }
    }

    /// The field under nodal forces, load cases and rigid motions: 2n forces `[force]`, one multiplier of each load case, one amount of each rigid motion. A resultant of
    /// the forces that the load cases do not balance is left out, as an even traction on the hole.
    ///
    /// # Errors
    /// [`SeriesError::State`] for numbers that are too few or too many.
    pub fn field(&self, state: &BodyLoad<'_>) -> Result<Field, SeriesError> {
        let hold = &self.hold;
        let size = 2 * self.points.len();
        check(state, [size, self.responses.len(), hold.motions.ncols()])?;
        let given = DVector::from_column_slice(state.forces);
        let balanced = &given - &hold.forces * hold.motions.tr_mul(&given);
        let multipliers = DVector::from_column_slice(state.multipliers);
        let taken = &self.taken[0] * &balanced + &self.taken[1] * &multipliers;
        let forces = &balanced + combined(state.multipliers, &self.balance, size);
        let mut rigid = [0.0; 3];
        for (k, (amount, taken)) in state.motions.iter().zip(taken.iter()).enumerate() {
            rigid[k] = amount - taken;
        }
        let of = Ingredients {
            nodes: &self.nodes,
            circle: self.circle,
            unit: self.elasticity.unit(self.circle.radius),
            forces: forces.as_slice(),
            inside: false,
        };
        let mut outside = Outside {
            outline: Some(self.surrounding.clone()),
            ..Outside::default()
        };
        for part in &self.fits {
            let tractions = part.means.tr_mul(&balanced) * -self.to_traction();
            let amounts = &part.fit.by_channels * tractions + &part.fit.by_loads * &multipliers;
            part.fit.add_to(&mut outside, &amounts);
        }
        let body = match self.elasticity {
            Elasticity::Isotropic(material) => Body::Outside(outside, material.kappa),
            Elasticity::Anisotropic(planes) => Body::Planes(outside, Box::new(planes)),
        };
        let field = Field::new(&of, of.hats(), body, rigid);
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

    /// Stresses `[stress]` at the angles `angles` `[rad]` of the hole's edge under each of `states`, as [`Field::edge`] of each [`field`](Self::field), by
    /// state and angle. For many states and angles this is much faster than fields.
    ///
    /// # Errors
    /// [`SeriesError::State`] for numbers that are too few or too many.
    pub fn edge_stresses(
        &self,
        states: &[BodyLoad<'_>],
        angles: &[f64],
    ) -> Result<Vec<Vec<PolarStress>>, SeriesError> {
        let (hold, cases) = (&self.hold, self.responses.len());
        let size = 2 * self.points.len();
        let mut balanced = forces(states, [size, cases, hold.motions.ncols()])?;
        let resultants = hold.motions.tr_mul(&balanced);
        balanced.gemm(-1.0, &hold.forces, &resultants, 1.0);
        let multipliers = DMatrix::from_fn(cases, states.len(), |case, state| {
            states[state].multipliers[case]
        });
        let mut all = balanced.clone();
        for (case, balance) in self.balance.iter().enumerate() {
            all.ger(1.0, balance, &multipliers.row(case).transpose(), 1.0);
        }
        let edge = Edge {
            nodes: &self.nodes,
            circle: self.circle,
            of: match &self.elasticity {
                Elasticity::Isotropic(_) => EdgeOf::Plate,
                Elasticity::Anisotropic(planes) => EdgeOf::Planes(planes),
            },
            angles,
        };
        let loads = edge.loads(&all);
        let directions = edge.directions();
        let mut further = DMatrix::from_fn(angles.len(), states.len(), |place, state| {
            let (mean, direction) = (loads[state].mean, directions[place]);
            match &self.elasticity {
                Elasticity::Isotropic(material) => {
                    4.0 * (mean / (1.0 + material.kappa) * direction.conj()).re
                }
                Elasticity::Anisotropic(planes) => planes.mean_on_edge(mean, direction),
            }
        });
        for part in &self.fits {
            let tractions = part.means.tr_mul(&balanced) * -self.to_traction();
            let amounts = &part.fit.by_channels * tractions + &part.fit.by_loads * &multipliers;
            further += part.fit.sums_on_edge(&directions, &amounts);
        }
        Ok(edge.stresses(&loads, &further))
    }

    /// Traction in a channel by nodal forces, the factor s/2πRt.
    fn to_traction(&self) -> f64 {
        sides(&self.nodes) / (2.0 * PI * self.circle.radius * self.circle.thickness)
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

fn columns(matrix: &DMatrix<f64>) -> Vec<DVector<f64>> {
    let columns = 0..matrix.ncols();
    columns.map(|k| matrix.column(k).into_owned()).collect()
}

impl Part {
    /// Adds to compliance and load cases the motion of the nodes that the outer edge causes. The two units are R/2G and the factor from nodal forces to
    /// tractions.
    fn add_motion(
        &self,
        [unit, to_traction]: [f64; 2],
        compliance: &mut DMatrix<f64>,
        responses: &mut DMatrix<f64>,
    ) {
        let Self { fit, means } = self;
        let by_channels = &fit.displacements * &fit.by_channels;
        let motions = means * by_channels;
        compliance.gemm(-unit * to_traction, &motions, &means.transpose(), 1.0);
        let by_loads = &fit.displacements * &fit.by_loads;
        responses.gemm(unit, means, &by_loads, 1.0);
    }
}

/// The units of coefficients that are fitted together.
fn unit_sets(nodes: &Nodes, surrounding: &Surrounding) -> Vec<&'static [Unit]> {
    if nodes.is_mirrored() {
        vec![&[Unit::Real]]
    } else if surrounding.images.is_some() {
        vec![&[Unit::Real], &[Unit::Imaginary]]
    } else {
        vec![&[Unit::Real, Unit::Imaginary]]
    }
}

impl InterfaceOperator for Plate {
    fn points(&self) -> &[Point] {
        &self.points
    }

    fn compliance(&self) -> Option<&DMatrix<f64>> {
        Some(&self.compliance)
    }

    fn modes(&self) -> &DMatrix<f64> {
        &self.hold.motions
    }

    fn load_cases(&self) -> usize {
        self.responses.len()
    }

    fn load_response(&self, case: usize) -> Option<&DVector<f64>> {
        self.responses[case].as_ref()
    }

    fn mode_load(&self, case: usize) -> &DVector<f64> {
        &self.mode_loads[case]
    }
}
