//! A scene's contact problem with its bodies condensed once, and its visible displacements.
//!
//! ```text
//! u(x) = N(x) (K⁺ Bᵀ λ + Σ m_k u_k + R α) = P (λ; m; α)
//! ```
//!
//! The map from contact forces to displacements is linear and independent of friction. So P is made once, column by column,
//! and another friction law costs one history of small contact problems and one small product.

use std::sync::Arc;

use nalgebra::{DMatrix, DVector};
use stickslip_contact::{ContactState, InterfaceProblem, InterfaceSolver, LoadHistory};
use stickslip_fem_core::body::BodyLoad;
use stickslip_fem_core::mesh::Point;
use stickslip_fem_core::{CondensedBody, InterfaceOperator};
use stickslip_friction::{FrictionLaw, Mirror};
use stickslip_hybrid::region::locate::Locator;

use super::{Candidate, LawsError, Observation};
use stickslip_engine::model::{Model, ModelError};
use stickslip_engine::run::{Operator, RunError, condense, solver};
use stickslip_experiment::SpecimenScene;
use stickslip_scene::host::Host;
use stickslip_scene::schema::{KinematicsChoice, ModelChoice};

/// A scene whose bodies are condensed, for any number of friction laws in one of its contacts.
#[derive(Debug)]
pub struct ContactModel {
    /// Clock of its timings.
    host: Host,
    problem: InterfaceProblem,
    solver: Box<dyn InterfaceSolver>,
    history: LoadHistory,
    /// Index of the contact pair whose law is exchanged.
    pair: usize,
    /// Index of the specimen among the bodies.
    body: usize,
    specimen: Arc<CondensedBody>,
    /// What the law must mirror about; `None` where the whole is modelled.
    mirror: Option<Mirror>,
    edge: Vec<(f64, Point)>,
}

impl ContactModel {
    /// Meshes and condenses the scene of `own`; the law of the contact at its edge is the one that can be exchanged.
    ///
    /// # Errors
    /// [`LawsError::Run`] where the scene cannot be modelled, [`LawsError::NoContact`] where nothing touches the edge,
    /// [`LawsError::Rigid`] where the specimen does not deform.
    pub fn new(own: &SpecimenScene) -> Result<Self, LawsError> {
        let scene = own.scene.as_ref();
        let pair = own.contact().ok_or_else(|| LawsError::NoContact {
            edge: format!("{}.{}", own.body, own.edge),
        })?;
        if scene.kinematics() != KinematicsChoice::Small {
            return Err(RunError::from(ModelError::Unsupported {
                key: "analysis.kinematics".into(),
                what: "friction laws are fitted with gaps on the undeformed geometry: say analysis.kinematics = \"small\" in the scene"
                    .into(),
            })
            .into());
        }
        let model = Model::build(scene).map_err(RunError::from)?;
        let operators = condense(&model)?;
        let faces: Vec<&dyn InterfaceOperator> =
            operators.iter().map(Operator::interface).collect();
        let problem = InterfaceProblem::linked(&faces, model.pairs.clone(), &model.links())
            .map_err(RunError::from)?;
        let rigid = || LawsError::Rigid {
            body: own.body.clone(),
        };
        let body = own.index().ok_or_else(rigid)?;
        let Operator::Elastic(specimen) = &operators[body] else {
            return Err(rigid());
        };
        let edge =
            (model.edges.iter()).find(|edge| edge.pair == Some(pair) && edge.geometry.body == body);
        let nodes = specimen.body().mesh().nodes();
        let place = |edge: &stickslip_engine::model::ModelEdge| {
            let along = edge.geometry.parameter.iter().zip(&edge.nodes);
            let at = |node: usize| [0, 1].map(|axis| nodes[node][axis] + model.origin[axis]);
            along.map(|(theta, &node)| (*theta, at(node))).collect()
        };
        Ok(Self {
            edge: edge.map(place).unwrap_or_default(),
            specimen: Arc::clone(specimen),
            problem,
            solver: solver(scene.analysis.solver),
            host: scene.host(),
            pair,
            body,
            mirror: model.contacts[pair].mirror,
            history: model.history,
        })
    }

    /// Time since any moment that stays `[s]`.
    pub(super) fn seconds(&self) -> f64 {
        self.host.seconds()
    }

    /// As [`ContactModel::new`], for fits of `laws`: where one of them claims no symmetry, the whole is modelled.
    ///
    /// # Errors
    /// As [`ContactModel::new`]; [`LawsError::NotSymmetric`] where the scene asks for a half model.
    pub fn for_laws(own: &SpecimenScene, laws: &[Candidate]) -> Result<Self, LawsError> {
        let model = Self::new(own)?;
        let symmetric = |law: &&Candidate| model.mirror.is_none_or(|own| law.is_symmetric(&own));
        let Some(law) = laws.iter().find(|law| !symmetric(law)) else {
            return Ok(model);
        };
        let mut scene = own.scene.as_ref().clone();
        if scene.analysis.model == ModelChoice::Half {
            return Err(LawsError::NotSymmetric {
                law: law.name.clone(),
            });
        }
        scene.analysis.model = ModelChoice::Whole;
        Self::new(&SpecimenScene {
            scene: Arc::new(scene),
            ..own.clone()
        })
    }

    /// Load steps of the scene.
    pub fn steps(&self) -> usize {
        self.history.steps().len()
    }

    /// Whether only the half y ≥ 0 is modelled.
    pub fn is_half(&self) -> bool {
        self.mirror.is_some()
    }

    /// Angle `[rad]` and place `[mm]` of the nodes of the specimen's edge in contact.
    pub fn edge(&self) -> &[(f64, Point)] {
        &self.edge
    }

    /// The law that the scene itself has there.
    pub fn own_law(&self) -> &Arc<dyn FrictionLaw> {
        &self.problem.pairs()[self.pair].law
    }

    /// Contact at the end of each of the first `count` load steps with `law` in the contact at the specimen's edge.
    ///
    /// # Errors
    /// [`LawsError::Run`] where a step has no solution that can be found; [`LawsError::NotSymmetric`] where half is modelled and `law`
    /// claims no symmetry.
    pub fn states(
        &self,
        law: Arc<dyn FrictionLaw>,
        count: usize,
    ) -> Result<Vec<ContactState>, LawsError> {
        if self.mirror.is_some_and(|own| !law.is_symmetric(&own)) {
            return Err(LawsError::NotSymmetric {
                law: law.name().to_owned(),
            });
        }
        let problem = self.problem.clone().with_law(self.pair, law);
        let problem = problem.map_err(RunError::from)?;
        let records = (self.history.first(count))
            .follow(&problem, self.solver.as_ref(), |_| {})
            .map_err(RunError::from)?;
        Ok(records.into_iter().map(|record| record.state).collect())
    }

    /// Whether each of `places` `[mm]` lies in the specimen.
    pub fn inside(&self, places: &[Point]) -> Vec<bool> {
        let locator = Locator::new(self.specimen.body().mesh());
        let found = |&place: &Point| locator.locate(self.modelled(place).0).is_some();
        places.iter().map(found).collect()
    }

    /// Where a place is modelled, and the sign of its displacement along y there.
    fn modelled(&self, [x, y]: Point) -> (Point, f64) {
        if self.is_half() && y < 0.0 {
            ([x, -y], -1.0)
        } else {
            ([x, y], 1.0)
        }
    }

    /// Prepares to see the displacements at `places` `[mm]`. Where half is modelled, the other half moves as its mirror image.
    ///
    /// # Errors
    /// [`LawsError::Outside`] for a place that is not in the specimen.
    pub fn view(&self, places: &[Point]) -> Result<View<'_>, LawsError> {
        /// Columns that are solved for together.
        const BATCH: usize = 32;
        let locator = Locator::new(self.specimen.body().mesh());
        let mut weights = Vec::with_capacity(places.len());
        for &place in places {
            let (own, sign) = self.modelled(place);
            let found = locator.locate(own).ok_or(LawsError::Outside { place })?;
            weights.push((found.shape, sign));
        }
        let forces = 2 * self.specimen.interface_nodes().len();
        let (cases, motions) = (self.problem.load_cases(), self.specimen.modes().ncols());
        let columns = forces + cases + motions;
        let mut rows = DMatrix::zeros(2 * places.len(), columns);
        for first in (0..columns).step_by(BATCH) {
            let units: Vec<Vec<f64>> = (first..columns.min(first + BATCH))
                .map(|column| {
                    let mut unit = vec![0.0; columns];
                    unit[column] = 1.0;
                    unit
                })
                .collect();
            let loads: Vec<BodyLoad<'_>> = units
                .iter()
                .map(|unit| BodyLoad {
                    forces: &unit[..forces],
                    multipliers: &unit[forces..forces + cases],
                    motions: &unit[forces + cases..],
                })
                .collect();
            for (k, moved) in self.specimen.displacements_of(&loads).iter().enumerate() {
                for (place, (shape, sign)) in weights.iter().enumerate() {
                    for &(node, weight) in shape {
                        rows[(2 * place, first + k)] += weight * moved[2 * node];
                        rows[(2 * place + 1, first + k)] += sign * weight * moved[2 * node + 1];
                    }
                }
            }
        }
        Ok(View { model: self, rows })
    }
}

/// What can be seen of a [`ContactModel`] at some places.
#[derive(Debug)]
pub struct View<'a> {
    model: &'a ContactModel,
    /// P, two rows per place.
    rows: DMatrix<f64>,
}

impl View<'_> {
    /// Computes the displacements P (λ; m; α) `[mm]` in a contact state, x and y of each place in turn.
    pub fn displacements(&self, state: &ContactState) -> DVector<f64> {
        let (model, problem) = (self.model, &self.model.problem);
        let count = model.specimen.interface_nodes().len();
        let mut action = problem.forces_on_body(model.body, count, &state.forces);
        action.extend(&state.multipliers);
        action.extend(problem.motions_of_body(
            model.body,
            &state.rigid,
            &state.forces,
            &state.multipliers,
        ));
        &self.rows * DVector::from_vec(action)
    }

    /// Displacements `[mm]` as `own` measures them: at its load step of the history `states`, less those of its null field.
    ///
    /// # Errors
    /// [`LawsError::Step`] for a load step beyond the last of `states`.
    pub(super) fn observed(
        &self,
        own: &Observation,
        states: &[ContactState],
    ) -> Result<DVector<f64>, LawsError> {
        let at = |step: usize| {
            let state = states.get(step).map(|state| self.displacements(state));
            state.ok_or(LawsError::Step {
                step: step + 1,
                steps: states.len(),
            })
        };
        let seen = at(own.step)?;
        Ok(match own.null {
            Some(null) => seen - at(null)?,
            None => seen,
        })
    }
}
