//! Bodies of a joint.

use std::sync::Arc;

use stickslip_fem_core::material::{PlaneStiffness, inverse};
use stickslip_fem_core::parallel;
use stickslip_fem_core::points::{internal_forces, strains};
use stickslip_fem_core::{
    BodyStructure, CondensedBody, ElasticBody, InterfaceOperator, QuadraturePoints, RigidBody,
};
use stickslip_laminate::progressive::{PointModel, PointState, ProgressiveError};

use crate::error::JointError;

/// A body of the joint.
#[derive(Clone, Debug)]
pub enum JointBody {
    /// Its points have a history.
    Progressive(Arc<ProgressiveBody>),
    /// Linear elastic.
    Elastic(Arc<CondensedBody>),
    /// Rigid.
    Rigid(RigidBody),
}

impl JointBody {
    /// The body with a history, if it is one.
    pub fn progressive(&self) -> Option<&ProgressiveBody> {
        match self {
            Self::Progressive(body) => Some(body),
            Self::Elastic(_) | Self::Rigid(_) => None,
        }
    }

    /// The finite elements, unless it is rigid.
    pub(crate) fn elements(&self) -> Option<(&Arc<ElasticBody>, &BodyStructure)> {
        match self {
            Self::Progressive(body) => Some((&body.body, &body.structure)),
            Self::Elastic(body) => Some((body.body(), body.structure())),
            Self::Rigid(_) => None,
        }
    }

    pub(crate) fn load_cases(&self) -> usize {
        match self {
            Self::Progressive(body) => body.body.load_cases().len(),
            Self::Elastic(body) => InterfaceOperator::load_cases(body.as_ref()),
            Self::Rigid(body) => body.load_cases(),
        }
    }

    /// Number of contact points.
    pub(crate) fn contact_points(&self) -> usize {
        match self {
            Self::Progressive(body) => body.interface.len(),
            Self::Elastic(body) => body.points().len(),
            Self::Rigid(body) => body.points().len(),
        }
    }

    /// Mesh nodes of the contact points; none of a rigid body.
    pub(crate) fn interface(&self) -> &[usize] {
        match self {
            Self::Progressive(body) => &body.interface,
            Self::Elastic(body) => body.interface_nodes(),
            Self::Rigid(_) => &[],
        }
    }

    /// Number of places whose displacement is known: mesh nodes, or contact points of a rigid body.
    pub(crate) fn node_count(&self) -> usize {
        self.elements().map_or_else(
            || self.contact_points(),
            |(body, _)| body.mesh().nodes().len(),
        )
    }
}

/// A finite-element body with a [`PointModel`] at every quadrature point.
#[derive(Clone, Debug)]
pub struct ProgressiveBody {
    body: Arc<ElasticBody>,
    structure: Arc<BodyStructure>,
    interface: Vec<usize>,
    points: QuadraturePoints,
    cell_of: Vec<u32>,
    /// One per cell.
    models: Vec<Arc<dyn PointModel>>,
    /// State of rest, one per cell.
    rest: Vec<PointState>,
    /// Size of the nodal forces that plies exert on each other at rest.
    rest_force: f64,
}

impl ProgressiveBody {
    /// `body` with the same `model` everywhere, in contact at the mesh nodes `interface`, in the order that pairs refer to. The
    /// materials of `body` are not used: stiffness and stress are the model's.
    ///
    /// # Errors
    /// As [`with_models`](Self::with_models).
    pub fn new(
        body: Arc<ElasticBody>,
        interface: &[usize],
        model: &Arc<dyn PointModel>,
    ) -> Result<Self, JointError> {
        let models = vec![Arc::clone(model); body.mesh().element_count()];
        Self::with_models(body, interface, models)
    }

    /// Makes a body with one model per cell of its mesh, as [`CrackBand`](crate::CrackBand) makes them. `interface`: indices of the mesh nodes
    /// in contact, in the order that pairs refer to.
    ///
    /// # Errors
    /// [`JointError::ModelCount`]; [`JointError::Mesh`] for supports, an interface or parts that [`ElasticBody::analyse`] refuses.
    pub fn with_models(
        body: Arc<ElasticBody>,
        interface: &[usize],
        models: Vec<Arc<dyn PointModel>>,
    ) -> Result<Self, JointError> {
        let cells = body.mesh().element_count();
        if models.len() != cells {
            return Err(JointError::ModelCount {
                models: models.len(),
                cells,
            });
        }
        let structure = body.analyse(interface)?;
        let points = QuadraturePoints::of(body.mesh());
        let cell_of = (0..cells).flat_map(|cell| points.of_cell(cell).map(move |_| cell as u32));
        Ok(Self {
            cell_of: cell_of.collect(),
            structure,
            interface: interface.to_vec(),
            points,
            rest: models.iter().map(|model| model.initial_state()).collect(),
            models,
            body,
            rest_force: 0.0,
        })
    }

    /// The same body at the temperature rise `temperature` `[temperature]` since its plies were free of stress: they carry the residual
    /// stresses of a plate that is free to shrink, whose mean is zero, and its geometry is that of the mesh at this temperature.
    ///
    /// # Errors
    /// [`JointError::Material`] if a model refuses, [`JointError::Cure`] if no such state is found.
    pub fn at_temperature(mut self, temperature: f64) -> Result<Self, JointError> {
        let rest = parallel::map_range(0..self.models.len(), |cell| {
            cured(cell, self.models[cell].as_ref(), temperature)
        });
        self.rest = rest.into_iter().collect::<Result<_, _>>()?;
        let layers = self.rest.iter().flat_map(|state| &state.layers);
        let stress = (layers.flat_map(|layer| layer.stress)).fold(0.0, |m: f64, s| m.max(s.abs()));
        let area: f64 = self.points.areas().iter().sum();
        let cell = (area / self.points.cell_count() as f64).sqrt();
        self.rest_force = stress * cell * self.body.thickness();
        Ok(self)
    }

    /// The finite elements.
    pub fn body(&self) -> &Arc<ElasticBody> {
        &self.body
    }

    /// Numbering of its equations.
    pub fn structure(&self) -> &Arc<BodyStructure> {
        &self.structure
    }

    /// Mesh nodes of its contact points.
    pub fn interface(&self) -> &[usize] {
        &self.interface
    }

    /// Its quadrature points.
    pub fn points(&self) -> &QuadraturePoints {
        &self.points
    }

    /// The model at quadrature point `point`, which is less than their number.
    pub fn model(&self, point: usize) -> &Arc<dyn PointModel> {
        &self.models[self.cell_of[point] as usize]
    }

    /// Cell of quadrature point `point`.
    pub fn cell(&self, point: usize) -> usize {
        self.cell_of[point] as usize
    }

    /// State of rest of quadrature point `point`.
    pub fn rest(&self, point: usize) -> &PointState {
        &self.rest[self.cell_of[point] as usize]
    }

    /// Volume `[length³]` of quadrature point `point`.
    pub fn volume(&self, point: usize) -> f64 {
        self.points.areas()[point] * self.body.thickness()
    }

    /// Size of the nodal forces `[force]` that plies exert on each other at rest.
    pub(crate) fn rest_force(&self) -> f64 {
        self.rest_force
    }

    /// Nodal forces `[force]` beside which those that rounding makes of the displacements `u` are small, as of a body that travels
    /// before it touches anything; far less than those of strains that would make such displacements.
    pub(crate) fn force_of_rounding(&self, tangents: &[PlaneStiffness], u: &[f64]) -> f64 {
        const PART: f64 = 1e-5;
        let largest = |most: f64, value: f64| most.max(value.abs());
        let stiffest = tangents.iter().flat_map(|d| [d[0][0], d[1][1]]);
        let travel = u.iter().copied().fold(0.0, largest);
        PART * stiffest.fold(0.0, largest) * self.body.thickness() * travel
    }

    /// The response of all points to the nodal displacements `u`, coming from the states `base`.
    pub(crate) fn respond(
        &self,
        base: &[PointState],
        u: &[f64],
    ) -> Result<Response, (usize, ProgressiveError)> {
        let strain = strains(self.body.mesh(), u);
        let all = parallel::map_range(0..base.len().min(strain.len()), |point| {
            let rest = self.rest(point);
            let total = [0, 1, 2].map(|i| rest.strain[i] + strain[point][i]);
            self.model(point)
                .respond(&base[point], total, rest.temperature)
        });
        let mut response = Response {
            strain,
            stress: Vec::with_capacity(all.len()),
            tangents: Vec::with_capacity(all.len()),
            trial: Vec::with_capacity(all.len()),
        };
        for (point, result) in all.into_iter().enumerate() {
            let own = result.map_err(|cause| (point, cause))?;
            response.stress.push(own.stress);
            response.tangents.push(own.tangent);
            response.trial.push(own.trial);
        }
        Ok(response)
    }

    /// Energy `[force·length]` that the points store, and that they have dissipated, since they were at rest.
    pub(crate) fn energies(&self, points: &[PointState]) -> [f64; 2] {
        let mut sums = [0.0; 2];
        for (point, state) in points.iter().enumerate() {
            let (rest, volume) = (self.rest(point), self.volume(point));
            sums[0] += volume * (state.stored - rest.stored);
            sums[1] += volume * (state.dissipated - rest.dissipated);
        }
        sums
    }

    /// Nodal forces `[force]` of one stress per point.
    pub(crate) fn internal_forces(&self, stress: &[[f64; 3]]) -> Vec<f64> {
        internal_forces(self.body.mesh(), self.body.thickness(), stress)
    }
}

/// What the points of a body do at one displacement.
#[derive(Clone, Debug, Default)]
pub(crate) struct Response {
    /// B u.
    pub(crate) strain: Vec<[f64; 3]>,
    /// Mean stress over the thickness.
    pub(crate) stress: Vec<[f64; 3]>,
    pub(crate) tangents: Vec<PlaneStiffness>,
    pub(crate) trial: Vec<PointState>,
}

/// The state at `temperature` whose mean stress is zero, by Newton's iteration from no strain.
fn cured(cell: usize, model: &dyn PointModel, temperature: f64) -> Result<PointState, JointError> {
    const ITERATIONS: usize = 30;
    const ROUNDING: f64 = 1e-13;
    let committed = model.initial_state();
    let mut strain = [0.0; 3];
    let mut scale = 0.0;
    for _ in 0..ITERATIONS {
        let response = model
            .respond(&committed, strain, temperature)
            .map_err(|cause| JointError::Material { cell, cause })?;
        let size = response.stress.iter().fold(0.0, |m: f64, s| m.max(s.abs()));
        scale = size.max(scale);
        if size <= ROUNDING * scale {
            return Ok(response.trial);
        }
        let compliance = inverse(&response.tangent);
        for (i, row) in compliance.iter().enumerate() {
            strain[i] -= (0..3).map(|j| row[j] * response.stress[j]).sum::<f64>();
        }
    }
    Err(JointError::Cure { cell, temperature })
}

/// Refuses load cases that bodies do not share, or that the joint cannot follow.
pub(crate) fn check(bodies: &[JointBody]) -> Result<(), JointError> {
    let expected = bodies.first().map_or(0, JointBody::load_cases);
    for (index, body) in bodies.iter().enumerate() {
        let found = body.load_cases();
        if found != expected {
            return Err(JointError::LoadCases {
                body: index,
                expected,
                found,
            });
        }
        let cases = body
            .elements()
            .map_or(&[][..], |(body, _)| body.load_cases());
        if let Some(case) = cases
            .iter()
            .position(|case| !case.initial_strain.is_empty())
        {
            return Err(JointError::InitialStrain { body: index, case });
        }
    }
    Ok(())
}
