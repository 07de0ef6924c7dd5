//! Settings of the failure analysis of laminates.

use std::sync::Arc;

use stickslip_laminate::failure::{Hashin, Interaction, PlyLoading, TsaiWu, criterion_named};
use stickslip_laminate::{Degradation, FailureCriterion, FailureError};

use super::{Builder, Materials, Surroundings};
use crate::diagnostic::{LaminateProblem, SceneProblem};
use crate::document::{Part, child};
use crate::format::SceneFormat;
use crate::schema::failure::{EnvelopesFormat, default_interaction, default_shear_weight};
use crate::schema::{Body, Envelopes, Failure, FailureFormat, LaminateSheet, Substance};
use crate::shape::Role;

impl Builder<'_> {
    pub(super) fn failure(
        &mut self,
        format: &SceneFormat,
        materials: &Materials,
        surroundings: &Surroundings<'_>,
    ) -> Option<Failure> {
        let given = format.failure.as_ref()?;
        let criteria = self.criteria(given);
        self.parameters_act(given);
        let bodies = self.failing_bodies(given, materials);
        self.strengths(given, &criteria, &bodies, materials);
        if given.characteristic.is_some() {
            self.holes(given, &bodies);
        }
        let envelopes = given.envelopes.as_ref().map(|given| self.envelopes(given));
        let progressive = self.progressive(given, &bodies, materials, surroundings);
        Some(given.failure(criteria, bodies, envelopes, progressive))
    }

    /// Refuses parameters, other than their defaults, of criteria that nothing asks for.
    fn parameters_act(&mut self, given: &FailureFormat) {
        if given.progressive.is_some() {
            // Its point model may have a criterion of its own.
            return;
        }
        let parameters = [
            (
                "tsai_wu",
                "tsai_wu_interaction",
                given.tsai_wu_interaction != default_interaction(),
            ),
            (
                "hashin",
                "hashin_shear_weight",
                given.hashin_shear_weight != default_shear_weight(),
            ),
        ];
        for (criterion, key, is_given) in parameters {
            if is_given && !given.criteria.iter().any(|name| name == criterion) {
                let message =
                    format!("{key} changes nothing: '{criterion}' is not among the criteria");
                let remedy = format!("add \"{criterion}\" to failure.criteria, or remove {key}");
                self.conflict(&format!("failure.{key}"), message, remedy);
            }
        }
    }

    fn criteria(&mut self, given: &FailureFormat) -> Vec<Arc<dyn FailureCriterion>> {
        let mut criteria: Vec<Arc<dyn FailureCriterion>> = Vec::new();
        for (index, name) in given.criteria.iter().enumerate() {
            let key = format!("failure.criteria.{index}");
            match criterion(name, given) {
                Ok(criterion) if criteria.iter().any(|other| other.name() == name) => {
                    let message = format!("criterion '{}' is named twice", criterion.name());
                    self.conflict(&key, message, "name each criterion once");
                }
                Ok(criterion) => criteria.push(criterion),
                Err(cause) => {
                    let key = match cause {
                        FailureError::ShearWeight { .. } => "failure.hashin_shear_weight",
                        _ => &key,
                    };
                    self.report(key, Part::Value, no_criterion(cause));
                }
            }
        }
        criteria
    }

    /// The bodies named, or all that have plies.
    fn failing_bodies(&mut self, given: &FailureFormat, materials: &Materials) -> Vec<String> {
        let laminates: Vec<String> = self
            .bodies
            .keys()
            .filter(|name| self.sheet(name, materials).is_some())
            .cloned()
            .collect();
        let Some(named) = &given.bodies else {
            let all_known = self
                .bodies
                .keys()
                .all(|name| self.is_known(name, materials));
            if laminates.is_empty() && all_known {
                self.report("failure", Part::Key, LaminateProblem::NoLaminates.into());
            }
            return laminates;
        };
        let mut bodies = Vec::new();
        for (index, name) in named.iter().enumerate() {
            let key = format!("failure.bodies.{index}");
            if !self.bodies.contains_key(name) {
                let known = self.bodies.keys().cloned().collect();
                self.undefined(&key, "body", name, known);
            } else if laminates.contains(name) {
                bodies.push(name.clone());
            } else if self.is_known(name, materials) {
                let problem = LaminateProblem::NoPlies {
                    body: name.clone(),
                    laminates: laminates.clone(),
                };
                self.report(&key, Part::Value, problem.into());
            }
        }
        bodies.sort();
        bodies.dedup();
        bodies
    }

    pub(super) fn sheet<'m>(
        &self,
        body: &str,
        materials: &'m Materials,
    ) -> Option<&'m Arc<LaminateSheet>> {
        match &self.bodies.get(body)?.substance {
            Substance::Elastic { material, .. } => materials.get(material)?.laminate(),
            Substance::Rigid => None,
        }
    }

    /// Whether what the body is made of could be read; what is wrong with it has been reported.
    fn is_known(&self, body: &str, materials: &Materials) -> bool {
        let substance = self.bodies.get(body).map(|body| &body.substance);
        let read = match substance {
            Some(Substance::Elastic { material, .. }) => materials.contains_key(material),
            _ => true,
        };
        read && !self.is_refused_at(&child("bodies", body))
    }

    /// Every ply must have what every criterion asks for, and parameters must fit the strengths.
    fn strengths(
        &mut self,
        given: &FailureFormat,
        criteria: &[Arc<dyn FailureCriterion>],
        bodies: &[String],
        materials: &Materials,
    ) {
        let mut reported: Vec<FailureError> = Vec::new();
        for body in bodies {
            let Some(sheet) = self.sheet(body, materials).cloned() else {
                continue;
            };
            for criterion in criteria {
                for layer in sheet.laminate.layers() {
                    if self.is_refused(&child("plies", layer.ply().name())) {
                        continue;
                    }
                    let tried = criterion.check(layer.ply()).and_then(|()| {
                        let none = PlyLoading::default();
                        criterion.assess(layer.ply(), &none).map(|_| ())
                    });
                    if let Err(cause) = tried
                        && !reported.contains(&cause)
                    {
                        reported.push(cause.clone());
                        let named = |name: &String| name == criterion.name();
                        let index = given.criteria.iter().position(named);
                        let key = if matches!(cause, FailureError::OpenSurface { .. }) {
                            "failure.tsai_wu_interaction".to_owned()
                        } else {
                            format!("failure.criteria.{}", index.unwrap_or_default())
                        };
                        self.report(&key, Part::Value, LaminateProblem::Failure { cause }.into());
                    }
                }
            }
        }
    }

    fn holes(&mut self, given: &FailureFormat, bodies: &[String]) {
        for (index, name) in bodies.iter().enumerate() {
            let hole = |body: &Body| body.shape.only_hole().is_some();
            let own = self.bodies.get(name);
            if !own.is_some_and(hole) {
                let edges = own.map_or(Vec::new(), |body| body.shape.edges());
                let holes = edges.into_iter().filter(|edge| edge.role == Role::Hole);
                let holes = holes.map(|edge| format!("'{}'", edge.name)).collect();
                let key = match &given.bodies {
                    Some(_) => format!("failure.bodies.{index}"),
                    None => "failure.characteristic".to_owned(),
                };
                let body = name.clone();
                self.report(
                    &key,
                    Part::Value,
                    LaminateProblem::NoHole { body, holes }.into(),
                );
            }
        }
    }

    fn envelopes(&mut self, given: &EnvelopesFormat) -> Envelopes {
        let last_ply = given.last_ply.as_ref().and_then(|factors| {
            match Degradation::new(factors.fibre, factors.matrix) {
                Ok(degradation) => Some(degradation),
                Err(cause) => {
                    let key = child("failure.envelopes.last_ply", cause.name);
                    let problem = LaminateProblem::Degradation { cause };
                    self.report(&key, Part::Value, problem.into());
                    None
                }
            }
        });
        given.envelopes(last_ply)
    }
}

/// Why there is no criterion.
pub(super) fn no_criterion(cause: FailureError) -> SceneProblem {
    match cause {
        FailureError::UnknownCriterion { name, known } => {
            SceneProblem::unknown_name("a failure criterion", &name, known)
        }
        cause => LaminateProblem::Failure { cause }.into(),
    }
}

/// The criterion `name` with the scene's parameters.
pub(super) fn criterion(
    name: &str,
    given: &FailureFormat,
) -> Result<Arc<dyn FailureCriterion>, FailureError> {
    Ok(match name {
        "tsai_wu" => Arc::new(TsaiWu {
            interaction: Interaction::Normalised(given.tsai_wu_interaction),
        }),
        "hashin" => Arc::new(Hashin::with_shear_weight(given.hashin_shear_weight)?),
        other => Arc::from(criterion_named(other)?),
    })
}
