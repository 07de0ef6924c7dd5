//! The whole plate without its pin: measured displacements around the hole, and the remote load.
//!
//! ```text
//! u = u_P + T d,    u_P: the plate under the remote load with its hole held,    T d: its answer to the hole's displacements d,
//! min (m − N u)ᵀ W (m − N u) + smoothing of d,         traction on the hole: what holds it in place
//! ```
//!
//! All of the plate's edges but the hole are free or carry a known load, so that only the hole's displacements are unknown, and the
//! tractions on the hole balance the remote load for any data. The localized analysis has less information: every side of its
//! region is measured.
//!
//! Source: Post & Reddy, *Friction Phenomenon in Contact Stress Problems* (1988), part II, 4.3, Figs 10–13.

mod ratios;
mod stage;

use std::f64::consts::PI;
use std::sync::Arc;

use stickslip_fem_core::ElasticBody;
use stickslip_fem_core::mesh::ElementKind;
use stickslip_hybrid::data::{Measurement, NodalDisplacements};
use stickslip_hybrid::identify::Tractions;
use stickslip_hybrid::region::Region;
use stickslip_hybrid::region::fit::Smoothing;
use stickslip_hybrid::region::locate::Locator;
use stickslip_hybrid::region::outputs::EdgeRows;

use super::analysed::scale::{least_scale, residuals, scale};
use super::analysed::smoothing_reach;
use super::measured::Measured;
use stickslip_engine::model::{Model, ModelBodyKind};
use stickslip_experiment::SpecimenScene;
use stickslip_scene::schema::ModelChoice;

pub use super::error::WholeError;
pub use stage::{WholeState, stage};

/// A plate under its remote load, its hole displaced as measured.
#[derive(Debug)]
pub struct WholePlate {
    region: Region,
    /// Nodal forces `[N]` of each load case for a multiplier of one.
    cases: Vec<Vec<f64>>,
    /// Multipliers of each load step.
    steps: Vec<Vec<f64>>,
    edge: EdgeRows,
}

/// What follows for one state.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct WholeSolution {
    /// Angle of each node of the hole `[rad]`, in −π … π, ascending.
    pub angle: Vec<f64>,
    /// Angle that is resolved along the hole's edge where its cells are finest `[rad]`, as of a region: features closer together
    /// cannot be distinguished.
    pub resolution: f64,
    /// Pressure and shear τ_rθ on the hole `[MPa]` with their covariance; the estimated bias by smoothing is in it as a standard deviation
    /// of its own at each place.
    pub tractions: Tractions,
    /// Hoop stress `[MPa]` and its standard deviation.
    pub hoop: Vec<[f64; 2]>,
    /// Force `[N]` on the plate by the tractions on the hole: minus the remote load.
    pub force: [f64; 2],
    /// Remote load `[N]`.
    pub load: [f64; 2],
    /// χ² of the fit with the stated standard deviations `[1]`, number of data, and effective number of parameters `[1]`.
    pub fit: (f64, usize, f64),
    /// The variance of the data was multiplied by this: χ² of the means of blocks of neighbouring residuals over its degrees of freedom,
    /// or what a stated standard deviation asks for, if that is more.
    pub scale: f64,
    /// Bias of pressure, shear and hoop stress that the smoothing makes, estimated, per place `[MPa]`.
    pub bias: Vec<[f64; 3]>,
}

impl WholePlate {
    /// The body of `own` without what touches it. One factorisation.
    ///
    /// # Errors
    /// [`WholeError`]: a plate that a support or a platen holds, that is rigid or heated, a scene that cannot be modelled, an edge that the
    /// plate does not have.
    pub fn new(own: &SpecimenScene) -> Result<Self, WholeError> {
        let name = || own.body.clone();
        let held = |on: &stickslip_scene::schema::SetRef| on.body == own.body;
        if own.scene.supports.iter().any(|support| held(&support.on))
            || own.scene.springs.iter().any(|springs| held(&springs.on))
            || own.scene.platens.iter().any(|platen| held(&platen.on))
        {
            return Err(WholeError::Held { body: name() });
        }
        let mut scene = (*own.scene).clone();
        scene.analysis.model = ModelChoice::Whole;
        let model = Model::build(&scene)?;
        let found = own.index().map(|index| &model.bodies[index]);
        let Some(ModelBodyKind::Elastic(body)) = found.map(|body| &body.kind) else {
            return Err(WholeError::Rigid { body: name() });
        };
        if (body.load_cases().iter()).any(|case| !case.initial_strain.is_empty()) {
            return Err(WholeError::Heated { body: name() });
        }
        let free = ElasticBody::new(
            model.placed(&own.body, body.mesh())?,
            body.materials().to_vec(),
            body.thickness(),
        )?;
        let free = Arc::new(free);
        let edge = EdgeRows::new(&free, &own.edge)?;
        let dofs: Vec<usize> = (edge.nodes.iter())
            .flat_map(|node| [2 * node, 2 * node + 1])
            .collect();
        let size = 2 * free.mesh().nodes().len();
        let forces = |case: &stickslip_fem_core::body::LoadCase| {
            if case.forces.is_empty() {
                vec![0.0; size]
            } else {
                case.forces.clone()
            }
        };
        Ok(Self {
            region: Region::with_dofs(&free, &dofs)?,
            cases: body.load_cases().iter().map(forces).collect(),
            steps: model.history.steps().to_vec(),
            edge,
        })
    }

    /// Number of nodes of the hole.
    pub fn nodes(&self) -> usize {
        self.edge.nodes.len()
    }

    /// Nodal forces `[N]` at load step `step`, less those at `null`.
    fn forces(&self, step: usize, null: Option<usize>) -> Vec<f64> {
        let mut sum = vec![0.0; 2 * self.region.mesh().nodes().len()];
        for (at, sign) in [(Some(step), 1.0), (null, -1.0)] {
            let multipliers = at
                .and_then(|step| self.steps.get(step))
                .into_iter()
                .flatten();
            for (case, factor) in self.cases.iter().zip(multipliers) {
                for (sum, force) in sum.iter_mut().zip(case) {
                    *sum += sign * factor * force;
                }
            }
        }
        sum
    }

    /// Fits the hole's displacements to the field `of` a state under the remote load of step `step`, less that of step `null`, and takes
    /// the tractions.
    ///
    /// # Errors
    /// [`WholeError::Region`]: invalid data, data that do not cover the surroundings of the hole, or an invalid smoothing.
    pub fn analyse(
        &self,
        of: &Measured,
        step: usize,
        null: Option<usize>,
        smoothing: Smoothing,
    ) -> Result<WholeSolution, WholeError> {
        let measured = &of.measurement;
        let forces = self.forces(step, null);
        let held = NodalDisplacements {
            nodes: self.edge.nodes.clone(),
            values: vec![0.0; 2 * self.edge.nodes.len()],
            covariance: Vec::new(),
        };
        let loaded = self.region.solve_loaded(&held, &forces)?;
        let data = self.without_load(measured, &loaded.displacements);
        let mut fit = self.region.fit(&data, smoothing)?;
        let solution = self.region.solve_loaded(&fit.displacements, &forces)?;
        let residuals = residuals(self.region.mesh(), measured, &solution.displacements);
        let scale =
            scale(&residuals, fit.parameters).max(least_scale(measured.deviation, of.floor));
        for entry in &mut fit.displacements.covariance {
            *entry *= scale;
        }
        let found = self.region.propagate(&self.edge.rows, &fit.displacements)?;
        let by_load = loaded.outputs(&self.edge.rows);
        let bias = self.region.transfer(&self.edge.rows)?.apply(&fit.bias)?;
        let sum = |values: &[f64], axis: usize| values.iter().skip(axis).step_by(2).sum::<f64>();
        let mut force = [0.0; 2];
        for (dof, reaction) in self.region.prescribed().iter().zip(&solution.reactions) {
            force[dof % 2] += reaction;
        }
        Ok(WholeSolution {
            force,
            load: [sum(&forces, 0), sum(&forces, 1)],
            fit: (fit.residual, fit.data, fit.parameters),
            scale,
            resolution: self.resolution(&fit.kept),
            ..self.tractions(&found.values, &by_load, &found.covariance, &bias)
        })
    }

    /// The data less what the remote load alone makes of them.
    fn without_load(&self, measured: &Measurement, loaded: &[f64]) -> Measurement {
        let locator = Locator::new(self.region.mesh());
        let mut data = measured.clone();
        for (k, &place) in measured.places.iter().enumerate() {
            // Places outside are left to the fit, which passes over them.
            let Some(located) = locator.locate(place) else {
                continue;
            };
            for (axis, values) in data.displacements.iter_mut().enumerate() {
                values[k] -= located.displacement(axis, loaded);
            }
        }
        data
    }

    /// Tractions and hoop stresses of the nodes in the order of their angles.
    fn tractions(
        &self,
        values: &[f64],
        by_load: &[f64],
        spread: &[f64],
        bias: &[f64],
    ) -> WholeSolution {
        let count = self.edge.nodes.len();
        let angles: Vec<f64> = (self.edge.normal.iter())
            .map(|[x, y]| y.atan2(*x))
            .collect();
        let mut order: Vec<usize> = (0..count).collect();
        order.sort_by(|&a, &b| angles[a].total_cmp(&angles[b]));
        let stress = |node: usize, part: usize| values[3 * node + part] + by_load[3 * node + part];
        // σ_r turns its sign to become the pressure; τ_rθ keeps it.
        let rows: Vec<(usize, f64)> = [(0, -1.0), (2, 1.0)]
            .into_iter()
            .flat_map(|(part, sign)| order.iter().map(move |node| (3 * node + part, sign)))
            .collect();
        let mut covariance = Vec::with_capacity(rows.len() * rows.len());
        for &(i, a) in &rows {
            for &(j, b) in &rows {
                let own = if i == j { bias[i].powi(2) } else { 0.0 };
                covariance.push(a * b * spread[i * 3 * count + j] + own);
            }
        }
        let hoop = |node: usize| {
            let row = 3 * node + 1;
            let variance = spread[row * 3 * count + row] + bias[row].powi(2);
            [stress(node, 1), variance.max(0.0).sqrt()]
        };
        WholeSolution {
            angle: order.iter().map(|&node| angles[node]).collect(),
            tractions: Tractions {
                pressure: order.iter().map(|&node| -stress(node, 0)).collect(),
                shear: order.iter().map(|&node| stress(node, 2)).collect(),
                covariance,
            },
            hoop: order.iter().map(|&node| hoop(node)).collect(),
            bias: (order.iter())
                .map(|&node| [-bias[3 * node], bias[3 * node + 2], bias[3 * node + 1]])
                .collect(),
            ..WholeSolution::default()
        }
    }

    /// The smallest angle that the edge resolves: between two corners, or more where of the displacements' `kept` part the smoothing
    /// leaves less.
    fn resolution(&self, kept: &[f64]) -> f64 {
        let kind = self.region.mesh().blocks().first().map(|block| block.kind);
        let step = kind.map_or(2, ElementKind::order);
        let mut part = vec![0.0; self.region.mesh().nodes().len()];
        for (dof, kept) in self.region.prescribed().iter().zip(kept) {
            part[dof / 2] += 0.5 * kept;
        }
        let angle = |k: usize| {
            let [x, y] = self.edge.normal[k];
            y.atan2(x)
        };
        (step..self.edge.normal.len())
            .map(|k| {
                let cell = (angle(k) - angle(k - step)).abs();
                cell.max(0.5 * smoothing_reach(cell / step as f64, part[self.edge.nodes[k]]))
            })
            .fold(PI, f64::min)
    }
}
