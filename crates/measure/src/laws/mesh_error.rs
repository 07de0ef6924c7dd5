//! The error of the model's mesh, as intervals include it.
//!
//! ```text
//! δ_k = u_h(x_k) − u_2h(x_k),     Σ + δ δᵀ for each state:     an error c δ,  c normal about zero with deviation 1
//! ```
//!
//! u_h is the history of a law on the model's mesh and u_2h that on a mesh twice as coarse. Where displacements converge with order p, c is
//! 1/(2^p − 1), a third for p = 2 (Richardson 1911; Roache 1994). Contact converges less evenly: its zones end between nodes, so that c may
//! have either sign and differs from state to state. A standard deviation of 1 is therefore wide. Errors of a shape unlike δ are not
//! included.

use std::sync::Arc;

use stickslip_fem_core::mesh::Point;
use stickslip_friction::FrictionLaw;
use stickslip_hybrid::calibrate::Amount;

use super::observation::root_mean_square;
use super::{ContactModel, LawsError, Observation, View};
use stickslip_experiment::SpecimenScene;
use stickslip_scene::schema::MeshSettings;

/// The error of the model's mesh in all states.
#[derive(Clone, Debug, PartialEq)]
pub struct MeshError {
    /// Name of the law with which both meshes were solved.
    pub law: String,
    /// One per observation.
    pub states: Vec<StateMeshError>,
}

/// The error of the model's mesh in a state.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StateMeshError {
    /// Root of the mean square of δ, less what is free of the state `[mm]`.
    pub rms: f64,
    /// c by the data beside the best law.
    pub amount: Amount,
}

impl MeshError {
    /// That of `shapes` with `amounts`, one per observation.
    pub(super) fn of(
        law: String,
        observations: &[Observation],
        shapes: &[Vec<f64>],
        amounts: &[Option<Amount>],
    ) -> Result<Self, LawsError> {
        // The data say nothing of an error that both meshes have in common.
        let unknown = Amount {
            value: 0.0,
            deviation: 1.0,
        };
        let each = observations.iter().zip(shapes).zip(amounts);
        let states = each.map(|((own, shape), amount)| {
            Ok(StateMeshError {
                rms: root_mean_square(&own.left_of(shape.clone())?),
                amount: amount.unwrap_or(unknown),
            })
        });
        Ok(Self {
            law,
            states: states.collect::<Result<_, LawsError>>()?,
        })
    }
}

/// The scene with corner nodes twice as far apart in every body.
pub fn coarser(own: &SpecimenScene) -> SpecimenScene {
    let mut scene = own.scene.as_ref().clone();
    scene.mesh = scene.mesh.coarser();
    scene.mesh_by_lengths = scene.mesh_by_lengths.as_ref().map(MeshSettings::coarser);
    for body in scene.bodies.values_mut() {
        body.mesh = body.mesh.as_ref().map(MeshSettings::coarser);
    }
    SpecimenScene {
        scene: Arc::new(scene),
        ..own.clone()
    }
}

/// A coarser model as it is seen at the data.
pub(super) struct Coarser<'a> {
    model: &'a ContactModel,
    /// The row of each place of an observation in its view; none where the coarser polygon does not hold the place.
    views: Vec<(&'a Observation, Vec<Option<usize>>, View<'a>)>,
}

impl<'a> Coarser<'a> {
    pub(super) fn new(
        model: &'a ContactModel,
        observations: &'a [Observation],
    ) -> Result<Self, LawsError> {
        let view = |own: &'a Observation| {
            let mut row = 0;
            let rows: Vec<Option<usize>> = (model.inside(&own.places).into_iter())
                .map(|inside| {
                    row += usize::from(inside);
                    inside.then(|| row - 1)
                })
                .collect();
            let both = own.places.iter().zip(&rows);
            let places: Vec<Point> = both
                .filter_map(|(&place, row)| row.map(|_| place))
                .collect();
            Ok((own, rows, model.view(&places)?))
        };
        let views = observations.iter().map(view);
        Ok(Self {
            model,
            views: views.collect::<Result<_, LawsError>>()?,
        })
    }

    /// Displacements at the data of all observations under `law`, one after the other; none where there is no place.
    pub(super) fn seen(&self, law: Box<dyn FrictionLaw>) -> Result<Vec<Option<f64>>, LawsError> {
        let states = self.model.states(Arc::from(law), self.model.steps())?;
        let mut all = Vec::new();
        for (own, rows, view) in &self.views {
            let seen = view.observed(own, &states)?;
            let data = own.components.iter();
            all.extend(data.map(|&(place, axis)| rows[place].map(|row| seen[2 * row + axis])));
        }
        Ok(all)
    }

    /// δ at the data of each observation. `fine`: displacements of the model at all data under the same law. A place that the coarser
    /// polygon does not hold has no δ.
    pub(super) fn shapes(
        &self,
        law: Box<dyn FrictionLaw>,
        fine: &[f64],
    ) -> Result<Vec<Vec<f64>>, LawsError> {
        let both = fine.iter().zip(self.seen(law)?);
        let mut difference = both.map(|(fine, coarse)| coarse.map_or(0.0, |coarse| fine - coarse));
        let own = self.views.iter();
        Ok(own
            .map(|(own, ..)| difference.by_ref().take(own.values.len()).collect())
            .collect())
    }
}
