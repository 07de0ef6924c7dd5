//! Settings of the progressive failure analysis of a joint.

use std::sync::Arc;

use stickslip_joint::FractureEnergies;
use stickslip_laminate::FailureCriterion;
use stickslip_laminate::laminate::Layer;
use stickslip_laminate::progressive::{PointModelParameters, ProgressiveError};

use super::failure::{criterion, no_criterion};
use super::{Builder, Fits, Materials, Surroundings};
use crate::diagnostic::{LaminateProblem, SceneProblem};
use crate::document::{Part, child};
use crate::point_model;
use crate::schema::progressive::{
    ControlFormat, CrackBandFormat, DisplacementFormat, ProgressiveFormat,
};
use crate::schema::{
    Axis, Contact, Control, FailureFormat, Hold, LaminateSheet, Load, LoadKind, Platen,
    Progressive, ProgressiveModel, SetRef, Substance, Support,
};
use crate::shape::{Edge, Role};
use crate::units::Quantity;

const TABLE: &str = "failure.progressive";

impl Builder<'_> {
    pub(super) fn progressive(
        &mut self,
        failure: &FailureFormat,
        bodies: &[String],
        materials: &Materials,
        around: &Surroundings<'_>,
    ) -> Option<Progressive> {
        let ProgressiveFormat {
            body,
            model,
            crack_band,
            control,
        } = failure.progressive.as_ref()?;
        let body = self.progressive_body(body.as_ref(), bodies);
        if let Some(body) = &body {
            self.one_pin(body, around);
        }
        self.no_heating(around);
        let parameters = match point_model::read(self.document, &child(TABLE, "model"), model) {
            Ok(parameters) => Some(parameters),
            Err(finding) => {
                self.findings.push(*finding);
                None
            }
        };
        let sheet = body.as_ref().and_then(|body| self.sheet(body, materials));
        let model = match (parameters.clone(), sheet.cloned()) {
            (Some(parameters), Some(sheet)) => self.progressive_model(parameters, failure, &sheet),
            _ => None,
        };
        let crack_band = crack_band.as_ref();
        let crack_band = crack_band.and_then(|own| self.crack_band(own, parameters.as_deref()));
        let control = self.control(control, around);
        Some(Progressive {
            body: body?,
            model: model?,
            crack_band,
            control: control?,
        })
    }

    fn progressive_body(&mut self, given: Option<&String>, bodies: &[String]) -> Option<String> {
        let key = child(TABLE, "body");
        match (given, bodies) {
            (Some(name), _) if bodies.contains(name) => Some(name.clone()),
            (Some(name), _) => {
                self.undefined(&key, "body of [failure]", name, bodies.to_vec());
                None
            }
            (None, [only]) => Some(only.clone()),
            (None, []) => None,
            (None, several) => {
                self.missing_name(TABLE, "body", several);
                None
            }
        }
    }

    /// Load and place of failure are read at a pin.
    fn one_pin(&mut self, body: &str, around: &Surroundings<'_>) {
        let has_role = |edge: Edge| edge.role == Role::Hole;
        let hole = |set: &SetRef| set.body == body && self.edge_of(set).is_some_and(has_role);
        let contacts = around.contacts.iter();
        let touched = contacts.filter(|pair| hole(&pair.first) || hole(&pair.second));
        let touched: Vec<&str> = touched.map(|pair| pair.name.as_str()).collect();
        if touched.len() > 1 {
            let message = format!(
                "a joint of one pin is followed, and '{body}' has the pins {}",
                touched.join(", ")
            );
            let remedy = "remove failure.progressive, or all but one of these contacts";
            self.conflict(TABLE, message, remedy);
        }
        let is_area = |set: &SetRef| {
            let own = self.bodies.get(&set.body);
            own.is_some_and(|own| own.shape.is_area(&set.set))
        };
        let mut supports = around.supports.iter().map(|support| &support.on);
        if let Some(on) = supports.find(|on| on.body == body && is_area(on)) {
            let message = format!("the mean of {on} is not held while plies of '{body}' fail");
            let remedy = "hold an edge of the body, or remove failure.progressive";
            self.conflict(TABLE, message, remedy);
        }
        // A contact that could not be read may be the pin's, and several at one hole are refused as such.
        if touched.is_empty() && self.written("contacts") == around.contacts.len() {
            let body = body.to_owned();
            let problem = LaminateProblem::NoPin { body };
            self.report(TABLE, Part::Key, problem.into());
        }
    }

    fn no_heating(&mut self, around: &Surroundings<'_>) {
        let heats = |load: &&Load| matches!(load.kind, LoadKind::Temperature { .. });
        if let Some(load) = around.loads.iter().find(heats) {
            let message = format!(
                "load '{}' changes the temperature, which a progressive history holds",
                load.name
            );
            let remedy = "give the laminate its cure: materials.NAME.laminate.cure = \"-150 K\"";
            self.conflict(TABLE, message, remedy);
        }
    }

    fn progressive_model(
        &mut self,
        parameters: Arc<dyn PointModelParameters>,
        failure: &FailureFormat,
        sheet: &LaminateSheet,
    ) -> Option<ProgressiveModel> {
        let key = child(TABLE, "model");
        let own = child(&key, parameters.name());
        let criterion = self.model_criterion(&own, parameters.as_ref(), failure)?;
        let kept = parameters.degradation();
        if kept.is_some_and(|kept| kept.fibre() == 1.0 && kept.matrix() == 1.0) {
            self.conflict(
                &own,
                "fibre = 1 and matrix = 1: failed plies keep all stiffness, so nothing is lost"
                    .to_owned(),
                "0.01 to 0.1 are usual for what failed plies keep",
            );
            return None;
        }
        let model = ProgressiveModel {
            parameters,
            criterion,
        };
        match model.point(sheet.laminate.clone()) {
            Err(cause) if !self.is_reported(&cause, sheet) => {
                let problem = LaminateProblem::Progressive { cause };
                self.report(&key, Part::Value, problem.into());
                None
            }
            _ => Some(model),
        }
    }

    /// Whether a ply of `sheet` has been refused, or the criteria of [failure] lack the same.
    fn is_reported(&self, cause: &ProgressiveError, sheet: &LaminateSheet) -> bool {
        let refused = |layer: &Layer| self.is_refused(&child("plies", layer.ply().name()));
        if sheet.laminate.layers().iter().any(refused) {
            return true;
        }
        self.findings.iter().any(|finding| match &finding.problem {
            SceneProblem::Laminate(LaminateProblem::Failure { cause: reported }) => {
                matches!(cause, ProgressiveError::Failure(own) if own == reported)
            }
            _ => false,
        })
    }

    /// The criterion that the model's table at `own` names, or the first of `failure`.
    fn model_criterion(
        &mut self,
        own: &str,
        parameters: &dyn PointModelParameters,
        failure: &FailureFormat,
    ) -> Option<Arc<dyn FailureCriterion>> {
        let Some(name) = parameters.criterion() else {
            // What is wrong with the first criterion has been reported.
            return criterion(failure.criteria.first()?, failure).ok();
        };
        match criterion(name, failure) {
            Ok(criterion) => Some(criterion),
            Err(cause) => {
                let key = child(own, "criterion");
                self.report(&key, Part::Value, no_criterion(cause));
                None
            }
        }
    }

    /// The fracture energies, which the model with `parameters` can use if they are known.
    fn crack_band(
        &mut self,
        energies: &CrackBandFormat,
        parameters: Option<&dyn PointModelParameters>,
    ) -> Option<FractureEnergies> {
        let table = child(TABLE, "crack_band");
        let kept = parameters.and_then(PointModelParameters::degradation);
        if let (Some(parameters), None) = (parameters, kept) {
            let message = format!(
                "fracture energies scale the strengths of ply discount, but the model is {}",
                parameters.name()
            );
            let remedy = "remove crack_band, or choose model.ply_discount";
            self.conflict(&table, message, remedy);
            return None;
        }
        let CrackBandFormat {
            fibre_tension,
            fibre_compression,
            matrix_tension,
            matrix_compression,
            shear,
        } = energies;
        let mut energy = |name: &str, quantity: &Option<Quantity<_>>, kept: f64| {
            let quantity = quantity.as_ref()?;
            if kept >= 1.0 {
                let message = format!("{name} takes energy, but its failure keeps all stiffness");
                let remedy = "0.01 to 0.1 are usual for what failed plies keep";
                self.conflict(&child(&table, name), message, remedy);
            }
            Some(quantity.value())
        };
        let (fibre, matrix) = kept.map_or((0.0, 0.0), |kept| (kept.fibre(), kept.matrix()));
        Some(FractureEnergies {
            fibre_tension: energy("fibre_tension", fibre_tension, fibre),
            fibre_compression: energy("fibre_compression", fibre_compression, fibre),
            matrix_tension: energy("matrix_tension", matrix_tension, matrix),
            matrix_compression: energy("matrix_compression", matrix_compression, matrix),
            shear: energy("shear", shear, matrix),
        })
    }

    fn control(&mut self, given: &ControlFormat, around: &Surroundings<'_>) -> Option<Control> {
        if let Some(spring) = around.springs.first() {
            let message = format!(
                "{} is on springs, and joints whose plies fail have none",
                spring.on
            );
            let remedy = "hold it without a stiffness, or remove failure.progressive";
            self.conflict(&format!("supports.{}", spring.index), message, remedy);
        }
        let table = child(TABLE, "control");
        match given {
            ControlFormat::Loads(loads) => Some(loads.control()),
            ControlFormat::Displacement(displacement) => {
                self.driven(&child(&table, "displacement"), displacement, around)
            }
        }
    }

    fn driven(
        &mut self,
        table: &str,
        given: &DisplacementFormat,
        around: &Surroundings<'_>,
    ) -> Option<Control> {
        let key = child(table, "on");
        let on = self.set(&key, &given.on, Fits::EdgesAndPoints)?;
        self.can_be_driven(&key, &on, given.axis, around);
        self.nothing_else_loads(&key, &on, given.axis, around);
        Some(given.control(on))
    }

    /// A drive takes the place of what loads the driven set along its axis, and leaves no room for other loads.
    fn nothing_else_loads(
        &mut self,
        key: &str,
        on: &SetRef,
        axis: Axis,
        around: &Surroundings<'_>,
    ) {
        let mut numbered = around.numbers.iter().zip(around.loads);
        let beside = numbered.find(|(_, load)| !is_replaced(load, on, axis));
        if let Some((index, load)) = beside {
            let along = axis.name();
            let message = format!(
                "load '{}' does not act on {on} along {along} alone: a drive replaces the load on the driven set along its axis, and applies no other",
                load.name
            );
            let turned = match axis {
                Axis::X => Axis::Y,
                Axis::Y => Axis::X,
            };
            let remedy = if around
                .loads
                .iter()
                .all(|load| is_replaced(load, on, turned))
            {
                format!(
                    "drive it along the other axis: axis = \"{}\"",
                    turned.name()
                )
            } else {
                format!(
                    "delete loads.{index}, or raise all loads in their proportion: failure.progressive.control.loads = {{}}"
                )
            };
            self.conflict(key, message, remedy);
        }
        let own = |support: &&Support| support.displacement != 0.0 && support.on == *on;
        if around.supports.iter().any(|support| own(&support)) {
            let message = format!(
                "a support on {on} has a displacement of its own, which a drive does not apply"
            );
            self.conflict(key, message, "delete the displacement of that support");
        }
    }

    fn can_be_driven(&mut self, key: &str, on: &SetRef, axis: Axis, around: &Surroundings<'_>) {
        let substance = self.bodies.get(&on.body).map(|body| &body.substance);
        if matches!(substance, Some(Substance::Rigid)) {
            let message = format!("'{}' is rigid, and rigid bodies are not driven", on.body);
            let remedy = "drive an edge of the other body, as plate.left";
            self.conflict(key, message, remedy);
        }
        let touches = |contact: &&Contact| contact.first == *on || contact.second == *on;
        if let Some(contact) = around.contacts.iter().find(touches) {
            let message = format!("{on} is an edge of the contact '{}'", contact.name);
            self.conflict(key, message, "drive an edge that does not touch anything");
        }
        let platen = around.platens.iter().find(|platen| platen.on == *on);
        let across = |platen: &Platen| match axis {
            Axis::X => platen.free.y,
            Axis::Y => platen.free.x,
        };
        if platen.is_some_and(across) {
            let message = format!("the platen on {on} would be free across the drive");
            self.conflict(key, message, "free it along the driven axis alone");
        }
        let body = self.bodies.get(&on.body);
        let is_area = body.is_some_and(|body| body.shape.is_area(&on.set));
        let holds = |support: &&Support| {
            let directions = support.hold.directions();
            let along = |[x, y]: &[f64; 2]| match axis {
                Axis::X => *x != 0.0,
                Axis::Y => *y != 0.0,
            };
            let is_other = support.on.body == on.body && support.on != *on;
            is_area && is_other && directions.iter().any(along)
        };
        if let Some(support) = around.supports.iter().find(holds) {
            let message = format!(
                "a drive of {on} moves all of '{}', which the support on {} holds",
                on.body, support.on
            );
            self.conflict(key, message, "remove that support, or drive an edge");
        }
        let skew =
            |support: &&Support| support.on == *on && matches!(support.hold, Hold::Direction(_));
        if around.supports.iter().any(|support| skew(&support)) {
            let message = format!("a skew support holds {on}");
            self.conflict(key, message, "hold it along axes: fix = [\"y\"]");
        }
        let moved = |support: &&Support| support.displacement != 0.0 && support.on != *on;
        if let Some(support) = around.supports.iter().find(moved) {
            let message = format!("the support on {} moves too", support.on);
            self.conflict(key, message, "drive one edge, and hold the others in place");
        }
    }
}

/// Whether driving `on` along `axis` takes the place of `load`.
fn is_replaced(load: &Load, on: &SetRef, axis: Axis) -> bool {
    /// Rounding of a unit vector.
    const ACROSS: f64 = 1e-12;
    let LoadKind::Force {
        on: loaded,
        direction: [x, y],
        ..
    } = &load.kind
    else {
        return false;
    };
    let across = match axis {
        Axis::X => y,
        Axis::Y => x,
    };
    loaded == on && across.abs() <= ACROSS
}
